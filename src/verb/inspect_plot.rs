//! The picture of an inspection: the form, and the points coloured by verdict.

use super::inspect::{InspectionTask, Subject};
use super::mesh::{of_harmonics, of_superquadric, of_surface};
use super::plot::{CELLS, fitting_window};
use super::plot_options::{Frame, VIEW, plane_window, space_window};
use super::plot_space::{box_around, for_pictures, joined, mesh_layer};
use super::zero_set::ZeroSet;
use super::{BoxSides, KeptPoint, Work};
use crate::arcs::{ArcOptions, CurveArc, trace_intersection};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::inspect::{ToleranceZone, Verdict, sphere_about};
use crate::mesh::mesh_bounds;
use crate::picture::{Figure, Layer, Scene, SpaceLayer, WIDTH, Window};
use crate::shape::{ImplicitCurve, ImplicitSurface};

/// The sphere sections are drawn for at most this many points.
const FEW: usize = 16;
/// More points of one verdict than this are thinned out evenly.
const MAX_DOTS: usize = 4000;
/// The number of steps along a section, for the diameter of the sphere.
const SECTION_STEPS: u32 = 24;
/// The number of segments of a drawn circle.
const CIRCLE: u32 = 120;

/// The number of points that are drawn of a parametric curve.
const CURVE_POINTS: usize = 1440;
const CURVE_STEPS: u32 = 1440;
/// The rows of a harmonic surface from pole to pole.
const SPHERE_ROWS: u32 = 48;

/// The verdicts in the order of their colours; the first colour, red, is for points outside.
const VERDICTS: [Verdict; 3] = [Verdict::Outside, Verdict::Inside, Verdict::Undecided];

/// The verdicts of a zone; points without an uncertainty are never uncertain.
fn verdicts(zone: &ToleranceZone) -> impl Iterator<Item = Verdict> {
    let more = zone.is_uncertain().then_some(Verdict::Uncertain);
    VERDICTS.into_iter().chain(more)
}

impl InspectionTask {
    /// Draws the form and the points by their verdicts as SVG, in the given window or in a window around all points.
    ///
    /// # Errors
    /// [`Error::Usage`] for a window that does not fit; those of the mesh and of the tracing.
    pub fn picture(
        &self,
        points: &[KeptPoint],
        window: Option<Frame>,
        work: &Work,
    ) -> Result<String> {
        let in_space = self.dimension() == 3;
        let lines_or_walls = |lines: Vec<Vec<[f64; 2]>>| match in_space {
            true => in_space_lines(self, walls(&lines, points), points, window, work),
            false => in_plane(self, &Drawn::Lines(lines), points, window, work),
        };
        match self.subject() {
            Subject::Surface(surface) => in_space_surface(self, surface, points, window, work),
            Subject::Curve(curve) => in_plane(self, &Drawn::Traced(curve), points, window, work),
            Subject::Radius(radius) => lines_or_walls(vec![radius.polyline(CURVE_POINTS)]),
            Subject::PlaneCurve(curve) => lines_or_walls(curve.polylines(None, CURVE_STEPS)),
            Subject::Superquadric(shape) => lines_or_walls(vec![shape.polyline(CURVE_POINTS / 4)]),
            Subject::Patch(patch, _) => {
                let layer = SpaceLayer {
                    facets: patch.facets([None; 2], None).facets,
                    ..SpaceLayer::default()
                };
                in_space_lines(self, layer, points, window, work)
            }
            Subject::Harmonic(surface) => {
                let mesh = of_harmonics(surface, SPHERE_ROWS, work)?;
                in_space_lines(self, mesh_layer(&mesh), points, window, work)
            }
            Subject::SpaceSuperquadric(shape) => {
                let mesh = of_superquadric(shape, SPHERE_ROWS, work)?;
                in_space_lines(self, mesh_layer(&mesh), points, window, work)
            }
            Subject::SpaceCurve(curve) => {
                let layer = SpaceLayer {
                    lines: curve.polylines(None, CURVE_STEPS),
                    ..SpaceLayer::default()
                };
                in_space_lines(self, layer, points, window, work)
            }
        }
    }
}

/// A plane curve in a picture.
enum Drawn<'a> {
    /// A curve that will be traced in the window.
    Traced(&'a ImplicitCurve),
    /// Lines that are drawn unchanged.
    Lines(Vec<Vec<[f64; 2]>>),
}

/// The cylinder over a plane curve, as high as the points reach.
fn walls(lines: &[Vec<[f64; 2]>], points: &[KeptPoint]) -> SpaceLayer {
    let heights = points.iter().map(|kept| kept.point[2]);
    let [low, high] = heights.fold([-1.0f64, 1.0f64], |[low, high], z| {
        [low.min(z), high.max(z)]
    });
    let sides = lines.iter().flat_map(|line| line.windows(2));
    let facets = sides.map(|side| {
        let corners = [(0, low), (0, high), (1, high), (1, low)];
        corners.map(|(k, z)| [side[k][0], side[k][1], z]).to_vec()
    });
    SpaceLayer {
        facets: facets.collect(),
        ..SpaceLayer::default()
    }
}

/// The points of one verdict, at most [`MAX_DOTS`] of them, and the text of the legend.
fn dots(
    points: &[KeptPoint],
    verdict: Verdict,
    zone: &ToleranceZone,
) -> Option<(String, Vec<[f64; 3]>)> {
    let all = || {
        points
            .iter()
            .filter(|kept| kept.inspection.verdict == verdict)
    };
    let count = all().count();
    let step = count.div_ceil(MAX_DOTS).max(1);
    let shown: Vec<[f64; 3]> = all().step_by(step).map(|kept| kept.point).collect();
    let what = match verdict {
        Verdict::Inside => match zone.tolerance() {
            Some(tolerance) => format!("inside: within {tolerance}"),
            None => format!("inside: signed distance {zone}"),
        },
        Verdict::Outside => match zone.tolerance() {
            Some(tolerance) => format!("outside: farther than {tolerance}"),
            None => format!("outside: signed distance not {zone}"),
        },
        Verdict::Uncertain => format!("uncertain: known within {}", zone.uncertainty()),
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

fn in_space_surface(
    task: &InspectionTask,
    surface: &ImplicitSurface,
    points: &[KeptPoint],
    window: Option<Frame>,
    work: &Work,
) -> Result<String> {
    let surface = &*surface.in_original_coordinates(work.bounds())?;
    let shown = match space_window(window)? {
        Some(window) => Some(window),
        None => {
            let found = work.stage("bounds", || mesh_bounds(surface, work.bounds()))?;
            joined(around(task, points), found.map(|found| found.bounds))
        }
    };
    let mesh = of_surface(surface, &for_pictures(shown, None), work)?;
    let degree = surface.polynomial().degree().unwrap_or(0);
    let body = SpaceLayer {
        label: format!("surface of degree {degree}"),
        ..mesh_layer(&mesh)
    };
    let mut section = SpaceLayer {
        label: match task.zone().tolerance() {
            Some(tolerance) => format!("the surface at the distance {tolerance} from a point"),
            None => "the surface at the tolerance of its side from a point".into(),
        },
        ..SpaceLayer::default()
    };
    if points.len() <= FEW {
        for kept in points {
            let tolerance = task.zone().tolerance_of_side(kept.inspection.sign);
            if tolerance.is_zero() {
                continue;
            }
            let lines = section_lines(surface, kept.point, &tolerance, work)?;
            section.lines.extend(lines);
        }
    }
    scene(task, body, points, section, shown, work)
}

/// The layer of a curve in space, or of the cylinder over a plane curve.
fn in_space_lines(
    task: &InspectionTask,
    drawn: SpaceLayer,
    points: &[KeptPoint],
    window: Option<Frame>,
    work: &Work,
) -> Result<String> {
    let shown = match space_window(window)? {
        Some(window) => Some(window),
        None => {
            let corners = drawn.lines.iter().chain(&drawn.facets).flatten();
            joined(around(task, points), box_around(corners))
        }
    };
    let body = SpaceLayer {
        label: "form".into(),
        ..drawn
    };
    scene(task, body, points, SpaceLayer::default(), shown, work)
}

/// The larger one of the tolerances of the sides.
fn largest_tolerance(task: &InspectionTask) -> f64 {
    let [low, high] = task.zone().limits().map(Rational::to_f64);
    high.max(-low)
}

/// A box around the points, with room for the tolerance.
fn around(task: &InspectionTask, points: &[KeptPoint]) -> Option<BoxSides> {
    let d = largest_tolerance(task);
    box_around(points.iter().map(|kept| &kept.point))
        .map(|b| b.map(|[low, high]| [low - 2.0 * d, high + 2.0 * d]))
}

/// The scene of the form, the points by their verdicts, and the sections over them.
fn scene(
    task: &InspectionTask,
    body: SpaceLayer,
    points: &[KeptPoint],
    over: SpaceLayer,
    shown: Option<BoxSides>,
    work: &Work,
) -> Result<String> {
    let mut layers = vec![body];
    for verdict in verdicts(task.zone()) {
        let (label, points) = dots(points, verdict, task.zone()).unwrap_or_default();
        layers.push(SpaceLayer {
            label,
            points,
            ..SpaceLayer::default()
        });
    }
    if !over.lines.is_empty() {
        layers.push(over);
    }
    let scene = Scene {
        title: String::new(),
        width: WIDTH,
        bounds: shown,
        azimuth: VIEW[0],
        elevation: VIEW[1],
        layers,
    };
    work.stage("draw", || scene.to_svg())
}

/// The lines in which the sphere about a point meets the surface; none if they cannot be followed.
fn section_lines(
    surface: &ImplicitSurface,
    p: [f64; 3],
    tolerance: &Rational,
    work: &Work,
) -> Result<Vec<Vec<[f64; 3]>>> {
    let d = tolerance.to_f64();
    let center = p.map(Rational::try_from);
    let [Ok(x), Ok(y), Ok(z)] = center else {
        // An infinite point has no section.
        return Ok(Vec::new());
    };
    let sphere = ImplicitSurface::new(sphere_about(&[x, y, z], tolerance));
    let bounds = p.map(|x| [x - 1.01 * d, x + 1.01 * d]);
    let options = ArcOptions::new(bounds).resolution(SECTION_STEPS);
    match trace_intersection([surface, &sphere], &options, work.bounds(), &|_| {}) {
        Ok(found) => Ok(found.arcs.iter().map(CurveArc::polyline).collect()),
        Err(Error::Interrupted) => Err(Error::Interrupted),
        Err(_) => Ok(Vec::new()),
    }
}

fn in_plane(
    task: &InspectionTask,
    drawn: &Drawn<'_>,
    points: &[KeptPoint],
    window: Option<Frame>,
    work: &Work,
) -> Result<String> {
    let zone = task.zone();
    let d = largest_tolerance(task);
    let flat = |p: &[f64; 3]| [p[0], p[1]];
    let mut layers = vec![match drawn {
        Drawn::Traced(curve) => Layer {
            label: format!(
                "curve of degree {}",
                curve.polynomial().degree().unwrap_or(0)
            ),
            ..Layer::default()
        },
        Drawn::Lines(lines) => Layer {
            label: "curve".into(),
            lines: lines.clone(),
            ..Layer::default()
        },
    }];
    for verdict in verdicts(zone) {
        let (label, points) = dots(points, verdict, zone).unwrap_or_default();
        layers.push(Layer {
            label,
            points: points.iter().map(flat).collect(),
            ..Layer::default()
        });
    }
    if points.len() <= FEW {
        let circle = |kept: &KeptPoint| -> Vec<[f64; 2]> {
            let p = kept.point;
            let d = zone.tolerance_of_side(kept.inspection.sign).to_f64();
            let angles =
                (0..=CIRCLE).map(|k| std::f64::consts::TAU * f64::from(k) / f64::from(CIRCLE));
            angles
                .map(|t| [p[0] + d * t.cos(), p[1] + d * t.sin()])
                .collect()
        };
        layers.push(Layer {
            label: match zone.tolerance() {
                Some(tolerance) => format!("the distance {tolerance} from a point"),
                None => "the tolerance of its side from a point".into(),
            },
            lines: points
                .iter()
                .filter(|kept| !zone.tolerance_of_side(kept.inspection.sign).is_zero())
                .map(circle)
                .collect(),
            ..Layer::default()
        });
    }
    let zero_set = match drawn {
        Drawn::Traced(curve) => Some(ZeroSet::new(0, (*curve).clone(), work)?),
        Drawn::Lines(_) => None,
    };
    let window = match plane_window(window)? {
        Some(window) => window,
        None => {
            let seen = points
                .iter()
                .map(|kept| kept.point)
                .flat_map(|p| [[p[0] - d, p[1] - d], [p[0] + d, p[1] + d]]);
            let mut seen: Vec<[f64; 2]> = seen.collect();
            if let Drawn::Lines(lines) = drawn {
                seen.extend(lines.iter().flatten());
            }
            // The points come first; the curve decides where there are none.
            let curves = zero_set.as_ref().filter(|_| seen.is_empty());
            fitting_window(seen, curves, work)?
        }
    };
    let mut figure = Figure {
        title: String::new(),
        width: WIDTH,
        window,
        layers,
    };
    let shown: Window = figure.shown_window()?;
    if let Some(curve) = zero_set {
        work.stage("trace", || {
            curve.trace(&shown, CELLS, &mut figure.layers[0], work)
        })?;
    }
    work.stage("draw", || figure.to_svg())
}
