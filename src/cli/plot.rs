//! `stellate plot`: forms over each other.

use std::ffi::OsStr;
use std::path::Path;

use stellate::error::{Error, Result};
use stellate::implicitize::SquaredForm;
use stellate::picture::{Figure, Layer, Window, isolated_origin, png_from_svg, trace_zero_set};
use stellate::shape::{Contour, Form, FourierRadius, ImplicitCurve, PlaneCurve, Superquadric};

use super::arguments::{FitFlags, Plot};
use super::input::{self, Content, Input};
use super::numbers::numbers_of;
use super::output::{check_destination, write_result};
use super::plot_space;
use super::session::Session;

/// Points drawn of a Fourier radius: enough for 100 oscillations to look smooth.
const POINTS_PER_HARMONIC: usize = 40;
const MIN_POINTS: usize = 1440;

/// Along the larger side of the window.
pub(super) const CELLS: u32 = 240;

/// Points drawn of a parametric curve.
const CURVE_POINTS: u32 = 2880;

/// Of each of the two kinds of points of a superquadric.
const POINTS_PER_QUADRANT: usize = 90;

/// PNG pixels per SVG unit.
const PNG_SCALE: f32 = 2.0;

/// The format of a figure.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    Svg,
    Png,
}

pub(crate) fn run(verb: &Plot, session: &mut Session) -> Result<()> {
    if session.common.format.is_some() {
        return Err(Error::Usage(
            "plot has no --format: the name after -o says .svg or .png".into(),
        ));
    }
    let kind = kind(session)?;
    check_destination(session)?;
    let svg = svg(verb, session)?;
    let bytes = session.stage("draw", |_| kind.bytes(svg))?;
    write_result(session, |out| out.write_all(&bytes))
}

/// The figure as SVG.
pub(super) fn svg(verb: &Plot, session: &mut Session) -> Result<String> {
    let mut inputs = Vec::new();
    for form in &verb.forms {
        inputs.push(input::read(form, session)?);
    }
    if inputs.iter().any(plot_space::is_in_space) {
        input::refuse_fit_flags(&verb.fit)?;
        plot_space::scene(verb, inputs, session)
    } else {
        plane(verb, inputs, session)
    }
}

/// The figure of forms in the plane, as SVG.
fn plane(verb: &Plot, inputs: Vec<Input>, session: &mut Session) -> Result<String> {
    let window = verb.window.as_deref().map(window).transpose()?;
    let ranges = plot_space::ranges(verb)?;
    let cells = verb.cells.unwrap_or(CELLS);
    if !verb.point.is_empty() {
        return Err(Error::Usage(
            "--point X,Y,Z marks a point in space; these forms are in the plane".into(),
        ));
    }
    let has_contour = inputs
        .iter()
        .any(|i| matches!(i.content, Content::Contour(_)));
    if !has_contour {
        input::refuse_fit_flags(&verb.fit)?;
    }
    let mut layers: Vec<Layer> = Vec::new();
    let mut curves = Vec::new();
    // What the window must show.
    let mut seen: Vec<[f64; 2]> = Vec::new();
    for input in inputs {
        if let Content::Exact(Form::PlaneCurve(curve)) = &input.content {
            let range = plot_space::range_of(curve.parameter(), &ranges);
            layers.push(parametric(curve, &input.short_name(), range));
            if let Some([x, y]) = curve.extent(range) {
                seen.extend([[x[0], y[0]], [x[1], y[1]]]);
            }
            continue;
        }
        let before = layers.len();
        add(input, &verb.fit, &mut layers, &mut curves, session)?;
        let added = layers[before..].iter().flat_map(|layer| &layer.lines);
        seen.extend(added.flatten());
    }
    let mut figure = Figure {
        title: verb.title.clone(),
        window: match window {
            Some(window) => window,
            None => fitting_window(seen, &curves, session)?,
        },
        layers,
    };
    let shown = figure.shown_window()?;
    for (index, curve) in curves {
        let bar = session.progress(1, "tracing");
        session.stage("trace", |session| {
            let layer = &mut figure.layers[index];
            trace(&curve, &shown, cells, layer, session)
        })?;
        bar.finish_and_clear();
    }
    session.stage("draw", |_| figure.to_svg())
}

fn kind(session: &Session) -> Result<Kind> {
    let path = session.common.output.as_ref().ok_or_else(|| {
        Error::Usage("plot writes a file: give -o FIGURE.svg or -o FIGURE.png".into())
    })?;
    Kind::of("-o", path)
}

impl Kind {
    /// What the extension of a file, given by an option, says.
    pub(super) fn of(option: &str, path: &Path) -> Result<Self> {
        match path
            .extension()
            .and_then(OsStr::to_str)
            .map(str::to_ascii_lowercase)
            .as_deref()
        {
            Some("svg") => Ok(Kind::Svg),
            Some("png") => Ok(Kind::Png),
            _ => Err(Error::Usage(format!(
                "{option} {}: a figure is a .svg or a .png file",
                path.display()
            ))),
        }
    }

    /// The bytes of the file.
    pub(super) fn bytes(self, svg: String) -> Result<Vec<u8>> {
        match self {
            Kind::Svg => Ok(svg.into_bytes()),
            Kind::Png => png_from_svg(&svg, PNG_SCALE),
        }
    }
}

pub(super) fn window(text: &str) -> Result<Window> {
    match numbers_of::<4>(text) {
        Some([x0, x1, y0, y1]) if x0 < x1 && y0 < y1 => Ok(Window {
            x: [x0, x1],
            y: [y0, y1],
        }),
        _ => Err(Error::Usage(format!(
            "--window {text}: expected X0,X1,Y0,Y1 with X0 < X1 and Y0 < Y1, such as -1,1,-1,1"
        ))),
    }
}

/// Adds the layers of a form; implicit curves are traced later, when the window is known.
fn add(
    input: Input,
    flags: &FitFlags,
    layers: &mut Vec<Layer>,
    curves: &mut Vec<(usize, ImplicitCurve)>,
    session: &mut Session,
) -> Result<()> {
    let name = input.short_name();
    match input.content {
        Content::Contour(contour) => {
            layers.push(outline(&contour, format!("outline, {name}")));
            if flags.harmonics.is_some() || flags.tolerance.is_some() {
                let fit = input::fit_contour(&contour, flags, session)?;
                layers.push(series(&fit.radius, &name));
                let form = SquaredForm::new(&fit.radius)?;
                let curve = session.stage("implicitize", |_| Ok(form.expand()))?;
                zero_set(curve, &name, layers, curves);
            }
        }
        Content::Exact(Form::Fourier(radius)) => layers.push(series(&radius, &name)),
        Content::Exact(Form::Curve(curve)) => {
            let degree = curve.polynomial().degree().unwrap_or(0);
            session.check_degree(degree)?;
            zero_set(curve, &name, layers, curves);
        }
        Content::Exact(Form::Superquadric(shape)) => layers.push(superquadric(&shape)),
        Content::Exact(_) => return Err(input::not_taken("plot", "plane curves here")),
    }
    Ok(())
}

/// A layer to be traced, with its place among the others.
fn zero_set(
    curve: ImplicitCurve,
    name: &str,
    layers: &mut Vec<Layer>,
    curves: &mut Vec<(usize, ImplicitCurve)>,
) {
    let degree = curve.polynomial().degree().unwrap_or(0);
    layers.push(Layer {
        label: format!("zero set, degree {degree}, {name}"),
        ..Layer::default()
    });
    curves.push((layers.len() - 1, curve));
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

fn series(radius: &FourierRadius, name: &str) -> Layer {
    let n = radius.harmonics();
    let points = radius.polyline((n * POINTS_PER_HARMONIC).max(MIN_POINTS));
    Layer {
        label: format!("Fourier radius, N = {n}, {name}"),
        lines: vec![points],
        ..Layer::default()
    }
}

fn parametric(curve: &PlaneCurve, name: &str, range: Option<[f64; 2]>) -> Layer {
    let said = plot_space::range_text(curve.parameter(), range);
    let said = said.map(|text| format!(", {text}")).unwrap_or_default();
    Layer {
        label: format!("parametric curve, {name}{said}"),
        lines: curve.polylines(range, CURVE_POINTS),
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

/// Around everything that has an extent of its own; else around certified points of the curves.
pub(super) fn fitting_window(
    seen: Vec<[f64; 2]>,
    curves: &[(usize, ImplicitCurve)],
    session: &Session,
) -> Result<Window> {
    let window = match Window::around(seen) {
        Some(window) => Some(window),
        None => {
            let mut points = Vec::new();
            for (_, curve) in curves {
                points.extend(stellate::picture::extent(curve, &session.limits)?);
            }
            Window::around(points)
        }
    };
    if let Some(window) = window.filter(|w| w.size() > 0.0) {
        return Ok(window.padded(0.06));
    }
    session.note("no points were found to fit the picture to: it shows -1,1,-1,1; --window chooses another part");
    Ok(Window {
        x: [-1.0, 1.0],
        y: [-1.0, 1.0],
    })
}

pub(super) fn trace(
    curve: &ImplicitCurve,
    window: &Window,
    cells: u32,
    layer: &mut Layer,
    session: &Session,
) -> Result<()> {
    let [a, b] = curve
        .center()
        .each_ref()
        .map(stellate::exact::Rational::to_f64);
    let local = Window {
        x: window.x.map(|v| v - a),
        y: window.y.map(|v| v - b),
    };
    let lines = trace_zero_set(curve.polynomial(), &local, cells, &session.limits)?;
    layer.lines = lines
        .into_iter()
        .map(|line| line.into_iter().map(|[x, y]| [x + a, y + b]).collect())
        .collect();
    if isolated_origin(curve.polynomial()) {
        layer.points.push([a, b]);
    }
    Ok(())
}
