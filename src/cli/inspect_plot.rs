//! The picture of an inspection: the surface or curve, and the points by verdict.

use std::path::Path;

use stellate::arcs::{ArcOptions, CurveArc, trace_intersection};
use stellate::error::Result;
use stellate::exact::Rational;
use stellate::inspect::{Verdict, sphere_about};
use stellate::mesh::mesh_bounds;
use stellate::picture::{Figure, Layer, Scene, SpaceLayer, Window};
use stellate::shape::{ImplicitCurve, ImplicitSurface};

use super::inspect::{Subject, Task};
use super::inspect_rows::Kept;
use super::mesh;
use super::numbers::space_window;
use super::plot::{self, Kind};
use super::plot_space::{self, SURFACE_ANGLE, SURFACE_CELLS, VIEW};
use super::session::Session;

/// Of so few points the section by the sphere is drawn, too.
const FEW: usize = 16;
/// More points of one verdict than this are thinned out evenly.
const MAX_DOTS: usize = 4000;
/// Steps along the section, over the diameter of the sphere.
const SECTION_STEPS: u32 = 24;
/// Segments of a drawn circle.
const CIRCLE: u32 = 120;

/// Whether the picture is SVG or PNG.
pub(super) fn kind(path: &Path) -> Result<Kind> {
    Kind::of("--plot", path)
}

/// The picture.
pub(super) fn picture(
    task: &Task,
    points: &[Kept],
    kind: Kind,
    window: Option<&str>,
    session: &mut Session,
) -> Result<Vec<u8>> {
    let svg = match &task.subject {
        Subject::Surface(surface) => in_space(task, surface, points, window, session)?,
        Subject::Curve(curve) => in_plane(task, curve, points, window, session)?,
    };
    session.stage("draw", |_| kind.bytes(svg))
}

/// The points of one verdict, at most [`MAX_DOTS`] of them, and what the legend says.
fn dots(
    points: &[Kept],
    verdict: Verdict,
    tolerance: &Rational,
) -> Option<(String, Vec<[f64; 3]>)> {
    let all = || points.iter().filter(|(_, found)| found.verdict == verdict);
    let count = all().count();
    let step = count.div_ceil(MAX_DOTS).max(1);
    let shown: Vec<[f64; 3]> = all().step_by(step).map(|(p, _)| *p).collect();
    let what = match verdict {
        Verdict::Inside => format!("inside: within {tolerance}"),
        Verdict::Outside => format!("outside: farther than {tolerance}"),
        Verdict::Undecided => "undecided".into(),
    };
    let part = if shown.len() < count {
        format!(", {} of them shown", shown.len())
    } else {
        String::new()
    };
    let points = if count == 1 { "point" } else { "points" };
    (count > 0).then(|| (format!("{count} {points} {what}{part}"), shown))
}

/// In the order of their colours: red for what is outside.
const VERDICTS: [Verdict; 3] = [Verdict::Outside, Verdict::Inside, Verdict::Undecided];

fn in_space(
    task: &Task,
    surface: &ImplicitSurface,
    points: &[Kept],
    window: Option<&str>,
    session: &mut Session,
) -> Result<String> {
    let window = window.map(space_window).transpose()?;
    let d = task.tolerance.to_f64();
    let near = points.iter().map(|(p, _)| p);
    let around =
        plot_space::box_around(near).map(|b| b.map(|[low, high]| [low - 2.0 * d, high + 2.0 * d]));
    let shown = match window {
        Some(window) => Some(window),
        None => {
            let found = session.stage("bounds", |session| mesh_bounds(surface, &session.limits))?;
            plot_space::joined(around, found.map(|(bounds, _)| bounds))
        }
    };
    let mesh = mesh::of_surface(surface, shown, SURFACE_CELLS, SURFACE_ANGLE, session)?;
    let mut body = plot_space::mesh_layer(&mesh);
    body.label = format!(
        "surface of degree {}",
        surface.polynomial().degree().unwrap_or(0)
    );
    let mut layers = vec![body];
    let mut section = SpaceLayer {
        label: format!(
            "the surface at the distance {} from a point",
            task.tolerance
        ),
        ..SpaceLayer::default()
    };
    if points.len() <= FEW {
        for (p, _) in points {
            section
                .lines
                .extend(section_lines(surface, *p, &task.tolerance, session)?);
        }
    }
    for verdict in VERDICTS {
        let (label, points) = dots(points, verdict, &task.tolerance).unwrap_or_default();
        layers.push(SpaceLayer {
            label,
            points,
            ..SpaceLayer::default()
        });
    }
    if !section.lines.is_empty() {
        layers.push(section);
    }
    let scene = Scene {
        title: String::new(),
        bounds: shown,
        azimuth: VIEW[0],
        elevation: VIEW[1],
        layers,
    };
    session.stage("draw", |_| scene.to_svg())
}

/// Where the sphere about a point meets the surface; nothing where that cannot be followed.
fn section_lines(
    surface: &ImplicitSurface,
    p: [f64; 3],
    tolerance: &Rational,
    session: &Session,
) -> Result<Vec<Vec<[f64; 3]>>> {
    let d = tolerance.to_f64();
    let centre = p.map(|x| Rational::try_from(x).unwrap_or_default());
    let sphere = ImplicitSurface::new(sphere_about(&centre, tolerance));
    let options = ArcOptions {
        bounds: p.map(|x| [x - 1.01 * d, x + 1.01 * d]),
        resolution: SECTION_STEPS,
    };
    match trace_intersection([surface, &sphere], &options, &session.limits, &|_| {}) {
        Ok(found) => Ok(found.arcs.iter().map(CurveArc::polyline).collect()),
        Err(stellate::error::Error::Interrupted) => Err(stellate::error::Error::Interrupted),
        Err(_) => Ok(Vec::new()),
    }
}

fn in_plane(
    task: &Task,
    curve: &ImplicitCurve,
    points: &[Kept],
    window: Option<&str>,
    session: &mut Session,
) -> Result<String> {
    let d = task.tolerance.to_f64();
    let flat = |p: &[f64; 3]| [p[0], p[1]];
    let mut layers = vec![Layer {
        label: format!(
            "curve of degree {}",
            curve.polynomial().degree().unwrap_or(0)
        ),
        ..Layer::default()
    }];
    for verdict in VERDICTS {
        let (label, points) = dots(points, verdict, &task.tolerance).unwrap_or_default();
        layers.push(Layer {
            label,
            points: points.iter().map(flat).collect(),
            ..Layer::default()
        });
    }
    if points.len() <= FEW {
        let circle = |(p, _): &Kept| -> Vec<[f64; 2]> {
            let angles =
                (0..=CIRCLE).map(|k| std::f64::consts::TAU * f64::from(k) / f64::from(CIRCLE));
            angles
                .map(|t| [p[0] + d * t.cos(), p[1] + d * t.sin()])
                .collect()
        };
        layers.push(Layer {
            label: format!("the distance {} from a point", task.tolerance),
            lines: points.iter().map(circle).collect(),
            ..Layer::default()
        });
    }
    let window = match window {
        Some(text) => plot::window(text)?,
        None => {
            let seen = points
                .iter()
                .flat_map(|(p, _)| [[p[0] - d, p[1] - d], [p[0] + d, p[1] + d]]);
            plot::fitting_window(seen.collect(), &[(0, curve.clone())], session)?
        }
    };
    let mut figure = Figure {
        title: String::new(),
        window,
        layers,
    };
    let shown: Window = figure.shown_window()?;
    session.stage("trace", |session| {
        plot::trace(curve, &shown, plot::CELLS, &mut figure.layers[0], session)
    })?;
    session.stage("draw", |_| figure.to_svg())
}
