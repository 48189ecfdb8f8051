//! The options of pictures.

use std::ffi::OsStr;
use std::path::Path;

use super::allowed::{PICTURE_CELLS, check_sides};
use super::{BoxSides, Content, Given};
use crate::error::{Error, Result};
use crate::fit::FitOptions;
use crate::options::options;
use crate::picture::{WIDTH, Window, png_from_svg};
use crate::shape::{Form, Parameter};

/// The default direction of the eye, in degrees.
pub(super) const VIEW: [f64; 2] = [30.0, 25.0];

/// The number of PNG pixels for each SVG unit.
const PNG_SCALE: f32 = 2.0;

/// The format of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FigureFormat {
    /// SVG: lines and text.
    Svg,
    /// PNG: pixels, two for each unit of the SVG.
    Png,
}

/// The part of the plane or of space that is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Frame {
    /// A part of the plane.
    Plane(Window),
    /// A part of space.
    Space(BoxSides),
}

options! {
    /// How forms are drawn.
    PlotOptions {
        /// How contours are fitted. A contour is not fitted if the size of the fit is not given; then only its outline is
        /// drawn.
        fit: FitOptions = FitOptions::default(),
        /// The part that is shown; by default everything that is drawn, and of a curve without end some points of each
        /// component, and what is at most four times as far from the center as its points in 120 directions are in the median.
        window: Option<Frame> = None,
        /// The ranges of the parameters that are drawn, by the names of the parameters.
        ranges: Vec<(String, [f64; 2])> = Vec::new(),
        /// For pictures in space: the direction of the eye, in degrees from +x towards +y and in degrees above the plane of x
        /// and y; 30 and 25 by default.
        view: Option<[f64; 2]> = None,
        /// The heading of the figure.
        title: String = String::new(),
        /// The width of the picture in units of the SVG (900), from 300 to 4000. Letters keep their size, so they are large in
        /// a narrow picture.
        width: Option<u32> = None,
        /// The number of cells along the larger side of the window for implicit curves (240), along the longest side of the box
        /// for surfaces (36), and along each parameter of a patch (54).
        cells: Option<u32> = None,
        /// For pictures in space: points that are marked.
        points: Vec<[f64; 3]> = Vec::new(),
    }
}

/// Refuses options that no picture has.
pub(super) fn check_options(options: &PlotOptions) -> Result<()> {
    if let Some(cells) = options.cells {
        PICTURE_CELLS.check(cells)?;
    }
    match &options.window {
        None => {}
        Some(Frame::Plane(window)) => check_sides(&[window.x, window.y])?,
        Some(Frame::Space(sides)) => check_sides(sides)?,
    }
    for (name, [a, b]) in &options.ranges {
        if !(a < b && a.is_finite() && b.is_finite()) {
            return Err(Error::Usage(format!(
                "--range {name}={a},{b}: expected NAME=A,B with A < B, such as t=-2,2 or t=0,2pi"
            )));
        }
    }
    match options.view {
        Some([azimuth, elevation]) if !(azimuth.is_finite() && elevation.abs() < 90.0) => {
            Err(Error::Usage(format!(
                "--view {azimuth},{elevation}: expected AZIMUTH,ELEVATION in degrees, such as 30,25, with the elevation between -90 and 90"
            )))
        }
        _ => Ok(()),
    }
}

/// The width of a figure.
pub(super) fn width(given: Option<u32>) -> Result<u32> {
    match given.unwrap_or(WIDTH) {
        width @ 300..=4000 => Ok(width),
        width => Err(Error::Usage(format!(
            "--width {width}: a picture is from 300 to 4000 units wide"
        ))),
    }
}

/// The window of a figure in the plane.
pub(super) fn plane_window(frame: Option<Frame>) -> Result<Option<Window>> {
    match frame {
        None => Ok(None),
        Some(Frame::Plane(window)) => Ok(Some(window)),
        Some(Frame::Space(_)) => Err(Error::Usage(
            "--window: these forms are in the plane; expected X0,X1,Y0,Y1, such as -1,1,-1,1"
                .into(),
        )),
    }
}

impl FigureFormat {
    /// The format that the extension of a file means; `option` names the option in messages.
    ///
    /// # Errors
    /// [`Error::Usage`] for an extension other than svg and png.
    pub fn of(option: &str, path: &Path) -> Result<Self> {
        let extension = path.extension().and_then(OsStr::to_str);
        match extension.map(str::to_ascii_lowercase).as_deref() {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            _ => Err(Error::Usage(format!(
                "{option} {}: a figure is a .svg or a .png file",
                path.display()
            ))),
        }
    }

    /// The bytes of a file with this picture.
    ///
    /// # Errors
    /// [`crate::error::Error::Limit`] if the picture is too large to be held in memory; [`crate::error::Error::Data`] if the SVG
    /// is malformed.
    pub fn bytes(self, svg: String) -> Result<Vec<u8>> {
        match self {
            Self::Svg => Ok(svg.into_bytes()),
            Self::Png => png_from_svg(&svg, PNG_SCALE),
        }
    }
}

/// The box of a figure in space.
pub(super) fn space_window(frame: Option<Frame>) -> Result<Option<BoxSides>> {
    match frame {
        None => Ok(None),
        Some(Frame::Space(bounds)) => Ok(Some(bounds)),
        Some(Frame::Plane(_)) => Err(Error::Usage(
            "--window: these forms are in space; expected X0,X1,Y0,Y1,Z0,Z1, such as -1,1,-1,1,0,2"
                .into(),
        )),
    }
}

/// Refuses the range of a parameter that no form has.
pub(super) fn check_ranges(forms: &[Given], ranges: &[(String, [f64; 2])]) -> Result<()> {
    let parameters = forms.iter().flat_map(parameters_of);
    let mut known: Vec<&str> = parameters.map(Parameter::name).collect();
    known.sort_unstable();
    known.dedup();
    let is_known = |name: &String| known.contains(&name.as_str());
    let Some((name, [a, b])) = ranges.iter().find(|(name, _)| !is_known(name)) else {
        return Ok(());
    };
    let there_are = match known[..] {
        [] => "has a parameter; equations and radii are drawn whole".into(),
        _ => format!("has the parameter {name}; there is {}", known.join(" and ")),
    };
    Err(Error::Usage(format!(
        "--range {name}={a},{b}: no form here {there_are}"
    )))
}

/// The parameters of a form that is drawn by them.
fn parameters_of(given: &Given) -> &[Parameter] {
    match given.content() {
        Content::Exact(Form::PlaneCurve(curve)) => std::slice::from_ref(curve.parameter()),
        Content::Exact(Form::SpaceCurve(curve)) => std::slice::from_ref(curve.parameter()),
        Content::Exact(Form::Patch(patch)) => patch.parameters(),
        _ => &[],
    }
}

/// The range that was given for a parameter; if there are several, the last one.
pub(super) fn range_of(parameter: &Parameter, ranges: &[(String, [f64; 2])]) -> Option<[f64; 2]> {
    let given = ranges.iter().rfind(|(name, _)| name == parameter.name());
    given.map(|(_, range)| *range)
}

/// The text of the legend for the range of a parameter.
pub(super) fn range_text(parameter: &Parameter, range: Option<[f64; 2]>) -> Option<String> {
    range.map(|[a, b]| format!("{} from {a} to {b}", parameter.name()))
}
