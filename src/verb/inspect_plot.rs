//! The picture of an inspection: the surface or curve, and the points by verdict.

use super::inspect::{InspectionTask, Subject};
use super::mesh::of_surface;
use super::plot::{CELLS, fitting_window, trace};
use super::plot_options::{Frame, VIEW, plane_window, space_window};
use super::plot_space::{box_around, for_pictures, joined, mesh_layer};
use super::{KeptPoint, Work};
use crate::arcs::{ArcOptions, CurveArc, trace_intersection};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::inspect::{Verdict, sphere_about};
use crate::mesh::mesh_bounds;
use crate::picture::{Figure, Layer, Scene, SpaceLayer, Window};
use crate::shape::{ImplicitCurve, ImplicitSurface};

/// Of so few points the section by the sphere is drawn, too.
const FEW: usize = 16;
/// More points of one verdict than this are thinned out evenly.
const MAX_DOTS: usize = 4000;
/// Steps along the section, over the diameter of the sphere.
const SECTION_STEPS: u32 = 24;
/// Segments of a drawn circle.
const CIRCLE: u32 = 120;

/// In the order of their colours: red for what is outside.
const VERDICTS: [Verdict; 3] = [Verdict::Outside, Verdict::Inside, Verdict::Undecided];

impl InspectionTask {
    /// The surface or curve with points by their verdicts, as SVG, in the given window or in one around all points.
    ///
    /// # Errors
    /// [`Error::Usage`] for a window that does not fit; those of the mesh and of the tracing.
    pub fn picture(
        &self,
        points: &[KeptPoint],
        window: Option<Frame>,
        work: &Work,
    ) -> Result<String> {
        match self.subject() {
            Subject::Surface(surface) => in_space(self, surface, points, window, work),
            Subject::Curve(curve) => in_plane(self, curve, points, window, work),
        }
    }
}

/// The points of one verdict, at most [`MAX_DOTS`] of them, and what the legend says.
fn dots(
    points: &[KeptPoint],
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

fn in_space(
    task: &InspectionTask,
    surface: &ImplicitSurface,
    points: &[KeptPoint],
    window: Option<Frame>,
    work: &Work,
) -> Result<String> {
    let tolerance = task.tolerance();
    let d = tolerance.to_f64();
    let around = box_around(points.iter().map(|(p, _)| p))
        .map(|b| b.map(|[low, high]| [low - 2.0 * d, high + 2.0 * d]));
    let shown = match space_window(window)? {
        Some(window) => Some(window),
        None => {
            let found = work.stage("bounds", || mesh_bounds(surface, work.bounds()))?;
            joined(around, found.map(|(bounds, _)| bounds))
        }
    };
    let mesh = of_surface(surface, &for_pictures(shown, None), work)?;
    let degree = surface.polynomial().degree().unwrap_or(0);
    let mut layers = vec![SpaceLayer {
        label: format!("surface of degree {degree}"),
        ..mesh_layer(&mesh)
    }];
    let mut section = SpaceLayer {
        label: format!("the surface at the distance {tolerance} from a point"),
        ..SpaceLayer::default()
    };
    if points.len() <= FEW {
        for (p, _) in points {
            let lines = section_lines(surface, *p, tolerance, work)?;
            section.lines.extend(lines);
        }
    }
    for verdict in VERDICTS {
        let (label, points) = dots(points, verdict, tolerance).unwrap_or_default();
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
    work.stage("draw", || scene.to_svg())
}

/// Where the sphere about a point meets the surface; nothing where that cannot be followed.
fn section_lines(
    surface: &ImplicitSurface,
    p: [f64; 3],
    tolerance: &Rational,
    work: &Work,
) -> Result<Vec<Vec<[f64; 3]>>> {
    let d = tolerance.to_f64();
    let center = p.map(Rational::try_from);
    let [Ok(x), Ok(y), Ok(z)] = center else {
        // An infinite point is at no distance from the surface.
        return Ok(Vec::new());
    };
    let sphere = ImplicitSurface::new(sphere_about(&[x, y, z], tolerance));
    let options = ArcOptions {
        bounds: p.map(|x| [x - 1.01 * d, x + 1.01 * d]),
        resolution: SECTION_STEPS,
    };
    match trace_intersection([surface, &sphere], &options, work.bounds(), &|_| {}) {
        Ok(found) => Ok(found.arcs.iter().map(CurveArc::polyline).collect()),
        Err(Error::Interrupted) => Err(Error::Interrupted),
        Err(_) => Ok(Vec::new()),
    }
}

fn in_plane(
    task: &InspectionTask,
    curve: &ImplicitCurve,
    points: &[KeptPoint],
    window: Option<Frame>,
    work: &Work,
) -> Result<String> {
    let tolerance = task.tolerance();
    let d = tolerance.to_f64();
    let flat = |p: &[f64; 3]| [p[0], p[1]];
    let degree = curve.polynomial().degree().unwrap_or(0);
    let mut layers = vec![Layer {
        label: format!("curve of degree {degree}"),
        ..Layer::default()
    }];
    for verdict in VERDICTS {
        let (label, points) = dots(points, verdict, tolerance).unwrap_or_default();
        layers.push(Layer {
            label,
            points: points.iter().map(flat).collect(),
            ..Layer::default()
        });
    }
    if points.len() <= FEW {
        let circle = |(p, _): &KeptPoint| -> Vec<[f64; 2]> {
            let angles =
                (0..=CIRCLE).map(|k| std::f64::consts::TAU * f64::from(k) / f64::from(CIRCLE));
            angles
                .map(|t| [p[0] + d * t.cos(), p[1] + d * t.sin()])
                .collect()
        };
        layers.push(Layer {
            label: format!("the distance {tolerance} from a point"),
            lines: points.iter().map(circle).collect(),
            ..Layer::default()
        });
    }
    let window = match plane_window(window)? {
        Some(window) => window,
        None => {
            let seen = points
                .iter()
                .flat_map(|(p, _)| [[p[0] - d, p[1] - d], [p[0] + d, p[1] + d]]);
            fitting_window(seen.collect(), &[(0, curve.clone())], work)?
        }
    };
    let mut figure = Figure {
        title: String::new(),
        window,
        layers,
    };
    let shown: Window = figure.shown_window()?;
    work.stage("trace", || {
        trace(curve, &shown, CELLS, &mut figure.layers[0], work)
    })?;
    work.stage("draw", || figure.to_svg())
}
