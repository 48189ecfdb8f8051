//! The verb `plot`: several forms in one picture.

use super::equation::{Taken, check_curve};
use super::fit::{OutlineSeries, fit_cloud_series, fit_series, refuse_fit_options};
use super::plot_options::{
    PlotOptions, check_options, check_ranges, plane_window, range_of, range_text, width,
};
use super::plot_space::{is_in_space, scene};
use super::zero_set::ZeroSet;
use super::{Content, Given, Remark, Work};
use crate::error::{Error, Result};
use crate::implicitize::{SquaredForm, implicitize_plane};
use crate::picture::{Figure, Layer, Window};
use crate::shape::{
    Contour, Form, FourierRadius, ImplicitCurve, PlaneCurve, PointCloud, Superquadric,
};

/// The number of points that are drawn of a Fourier radius for each harmonic: 100 oscillations still look smooth.
const POINTS_PER_HARMONIC: usize = 40;
const MIN_POINTS: usize = 1440;

/// The number of cells along the larger side of the window.
pub(super) const CELLS: u32 = 240;

/// The number of points that are drawn of a parametric curve.
const CURVE_POINTS: u32 = 2880;

/// The largest number of points of a cloud that are drawn.
const MOST_DOTS: usize = 20_000;

/// The number of points per quadrant of a superquadric, for each of its two kinds of points.
const POINTS_PER_QUADRANT: usize = 90;

const PLOT: Taken = Taken {
    verb: "plot",
    these: "plane curves here",
};

/// Draws forms over each other with equal axes, the first one lowest, as SVG. Curves and surfaces in space are drawn in
/// perspective. This needs the feature `pictures`.
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::verb::{self, Given, PlotOptions, Work};
/// let given = Given::read("x^4 - x^2 + y^2 = 0", Numbers::Exact)?;
/// let svg = verb::plot(vec![given], &PlotOptions::default(), &Work::default())?;
/// assert!(svg.starts_with("<svg"));
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Usage`] if forms of the plane and of space are mixed, if an option does not belong to the forms, or if its value is out of
/// range.
pub fn plot(forms: Vec<Given>, options: &PlotOptions, work: &Work) -> Result<String> {
    check_options(options)?;
    check_ranges(&forms, &options.ranges)?;
    if forms.iter().any(is_in_space) {
        refuse_fit_options(&options.fit)?;
        scene(forms, options, work)
    } else {
        plane(forms, options, work)
    }
}

/// The figure of forms in the plane.
fn plane(forms: Vec<Given>, options: &PlotOptions, work: &Work) -> Result<String> {
    let window = plane_window(options.window)?;
    if !options.points.is_empty() {
        return Err(Error::Usage(
            "--point X,Y,Z marks a point in space; these forms are in the plane".into(),
        ));
    }
    if options.view.is_some() {
        return Err(Error::Usage(
            "--view turns a picture of space; these forms are in the plane".into(),
        ));
    }
    let is_exact = |given: &Given| matches!(given.content(), Content::Exact(_));
    if forms.iter().all(is_exact) {
        refuse_fit_options(&options.fit)?;
    }
    let mut drawing = Drawing::default();
    for given in forms {
        drawing.add(given, options, work)?;
    }
    let Drawing {
        layers,
        curves,
        seen,
    } = drawing;
    let mut figure = Figure {
        title: options.title.clone(),
        width: width(options.width)?,
        window: match window {
            Some(window) => window,
            None => fitting_window(seen, &curves, work)?,
        },
        layers,
    };
    let shown = figure.shown_window()?;
    let cells = options.cells.unwrap_or(CELLS);
    for curve in curves {
        work.stage("trace", || {
            let _progress = work.progress("tracing", 1);
            curve.trace(&shown, cells, &mut figure.layers[curve.layer], work)
        })?;
    }
    work.stage("draw", || figure.to_svg())
}

/// The layers of a figure in the plane.
#[derive(Default)]
struct Drawing {
    layers: Vec<Layer>,
    /// Implicit curves, which are traced once the window is known.
    curves: Vec<ZeroSet>,
    /// The points that the window must show.
    seen: Vec<[f64; 2]>,
}

impl Drawing {
    /// Adds the layers of a form.
    fn add(&mut self, given: Given, options: &PlotOptions, work: &Work) -> Result<()> {
        let name = given.whole_name();
        let before = self.layers.len();
        let removed = given.left_out().removed.ways.clone();
        match given.into_content() {
            Content::Contour(contour) => {
                self.layers
                    .push(outline(&contour, format!("outline, {name}")));
                if options.fit.size.is_some() {
                    let fit = fit_series(&contour, &options.fit, work)?;
                    self.fit(&fit, &name, work)?;
                }
                if !removed.is_empty() {
                    self.layers.push(Layer {
                        label: format!("cut off by --repair, {name}"),
                        lines: removed,
                        ..Layer::default()
                    });
                }
            }
            Content::Cloud(cloud) => {
                self.layers.push(dots(&cloud, &name, work));
                if options.fit.size.is_some() {
                    let fit = fit_cloud_series(&cloud, &options.fit, work)?;
                    self.fit(&fit, &name, work)?;
                }
            }
            Content::Exact(Form::PlaneCurve(curve)) => {
                let range = range_of(curve.parameter(), &options.ranges);
                let window = plane_window(options.window)?;
                self.layers.push(parametric(&curve, &name, range, window));
                if let Some([x, y]) = curve.extent(range) {
                    self.seen.extend([[x[0], y[0]], [x[1], y[1]]]);
                }
                return Ok(());
            }
            Content::Exact(Form::Fourier(radius)) => self.layers.push(series(&radius, &name)),
            Content::Exact(Form::Curve(curve)) => {
                check_curve(&curve, work)?;
                self.zero_set(curve, &name, work)?;
            }
            Content::Exact(Form::Superquadric(shape)) => self.layers.push(superquadric(&shape)),
            Content::Exact(_) => return Err(PLOT.not_this()),
        }
        for layer in &self.layers[before..] {
            self.seen.extend(layer.lines.iter().flatten());
            self.seen.extend(&layer.cloud);
        }
        Ok(())
    }

    /// Adds a series that was fitted, and its zero set.
    fn fit(&mut self, fit: &OutlineSeries, name: &str, work: &Work) -> Result<()> {
        self.layers.push(fitted(fit, name));
        let curve = work.stage("implicitize", || match fit {
            OutlineSeries::Radius(fit) => Ok(SquaredForm::new(&fit.radius)?.expand()),
            OutlineSeries::Elliptic(fit) => {
                let curve = fit.series.to_plane_curve();
                Ok(implicitize_plane(&curve, work.bounds())?.curve)
            }
        })?;
        self.zero_set(curve, name, work)
    }

    /// Adds a layer into which the zero set will be traced.
    fn zero_set(&mut self, curve: ImplicitCurve, name: &str, work: &Work) -> Result<()> {
        let degree = curve.polynomial().degree().unwrap_or(0);
        self.layers.push(Layer {
            label: format!("zero set, degree {degree}, {name}"),
            ..Layer::default()
        });
        let layer = self.layers.len() - 1;
        self.curves.push(ZeroSet::new(layer, curve, work)?);
        Ok(())
    }
}

fn outline(contour: &Contour, label: String) -> Layer {
    let mut line = contour.points().to_vec();
    line.extend(contour.points().first());
    Layer {
        label,
        lines: vec![line],
        filled: true,
        ..Layer::default()
    }
}

/// The points of a cloud; of a large one, some that are evenly chosen.
fn dots(cloud: &PointCloud, name: &str, work: &Work) -> Layer {
    let total = cloud.points().len();
    let points = cloud.points().iter().step_by(total.div_ceil(MOST_DOTS));
    let points: Vec<[f64; 2]> = points.copied().collect();
    let drawn = points.len();
    if drawn < total {
        work.remark(Remark::PointsNotDrawn { drawn, total });
    }
    Layer {
        label: format!("points, {name}"),
        cloud: points,
        ..Layer::default()
    }
}

fn series(radius: &FourierRadius, name: &str) -> Layer {
    let n = radius.harmonics();
    let points = radius.polyline((n * POINTS_PER_HARMONIC).max(MIN_POINTS));
    Layer {
        label: format!("Fourier radius, N = {n}, {name}"),
        lines: vec![points],
        ..Layer::default()
    }
}

fn fitted(fit: &OutlineSeries, name: &str) -> Layer {
    match fit {
        OutlineSeries::Radius(fit) => series(&fit.radius, name),
        OutlineSeries::Elliptic(fit) => {
            let n = fit.series.harmonics();
            let points = fit
                .series
                .polyline((n * POINTS_PER_HARMONIC).max(MIN_POINTS));
            Layer {
                label: format!("elliptic series, N = {n}, {name}"),
                lines: vec![points],
                ..Layer::default()
            }
        }
    }
}

fn parametric(
    curve: &PlaneCurve,
    name: &str,
    range: Option<[f64; 2]>,
    window: Option<Window>,
) -> Layer {
    let area = window.map(|window| [window.x, window.y]);
    let said = range_text(curve.parameter(), range);
    let said = said.map(|text| format!(", {text}")).unwrap_or_default();
    Layer {
        label: format!("parametric curve, {name}{said}"),
        lines: curve.polylines_in(area, range, CURVE_POINTS),
        ..Layer::default()
    }
}

fn superquadric(shape: &Superquadric) -> Layer {
    Layer {
        label: format!("superquadric, 2/e = {}", shape.exponent()),
        lines: vec![shape.polyline(POINTS_PER_QUADRANT)],
        ..Layer::default()
    }
}

/// A window around everything that is drawn.
pub(super) fn fitting_window<'a>(
    mut seen: Vec<[f64; 2]>,
    curves: impl IntoIterator<Item = &'a ZeroSet>,
    work: &Work,
) -> Result<Window> {
    for curve in curves {
        seen.extend(curve.seen(work)?);
    }
    let found = Window::around(seen);
    if let Some(window) = found.filter(|w| w.size() > 0.0) {
        return Ok(window.padded(0.06));
    }
    let point = found.map(|Window { x, y }| [x[0], y[0]]);
    let [x, y] = point.unwrap_or_default().map(|c| [c - 1.0, c + 1.0]);
    work.remark(Remark::NothingToFitTo {
        point,
        shown: [x, y],
    });
    Ok(Window { x, y })
}
