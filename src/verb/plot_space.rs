//! Pictures in space: curves, patches and implicit surfaces in perspective.

use super::arcs::{ArcSearch, arcs_of_others};
use super::equation::cylinder;
use super::mesh::{of_harmonics, of_superquadric, of_surface};
use super::plot_options::{PlotOptions, VIEW, range_of, range_text, space_window, width};
use super::{BoxSides, Content, Given, MeshingOptions, Remark, Work};
use crate::arcs::CurveArc;
use crate::error::{Error, Result};
use crate::mesh::{Held, Mesh, mesh_bounds};
use crate::notation::{Coordinates, Format};
use crate::parametrize::{CommonPoint, parametrize_intersection};
use crate::picture::{Scene, SpaceLayer};
use crate::shape::{DRAWN_NUMBERS, Form, ImplicitSurface, SpaceCurve};

/// The default number of points along a curve.
const CURVE_POINTS: u32 = 720;

/// The default number of cells along the longest side of the box of an implicit surface, and the angle in degrees by which edges
/// may bend.
const SURFACE_CELLS: u32 = 36;
const SURFACE_ANGLE: f64 = 30.0;

/// Vertices are moved to a singular curve within this many sides of a cell.
const SNAPPED: f64 = 0.5;

/// Whether a form is drawn in space.
pub(super) fn is_in_space(given: &Given) -> bool {
    matches!(
        given.content(),
        Content::Exact(
            Form::SpaceCurve(_)
                | Form::Patch(_)
                | Form::Surface(_)
                | Form::SpaceSuperquadric(_)
                | Form::Harmonic(_)
                | Form::Intersection(_)
        )
    )
}

/// How surfaces are meshed for a picture.
pub(super) fn for_pictures(window: Option<BoxSides>, cells: Option<u32>) -> MeshingOptions {
    MeshingOptions::default()
        .window(window)
        .resolution(cells.unwrap_or(SURFACE_CELLS))
        .angle(SURFACE_ANGLE)
        .fine(true)
}

/// The scene of several forms, as SVG.
pub(super) fn scene(forms: Vec<Given>, options: &PlotOptions, work: &Work) -> Result<String> {
    let window = space_window(options.window)?;
    let mut drawn: Vec<Drawn> = Vec::new();
    let mut around = box_around(options.points.iter());
    for given in forms {
        for next in drawn_of(given, options, window, work)? {
            if let Drawn::Layer(_, extent) = &next {
                around = joined(around, *extent);
            }
            drawn.push(next);
        }
    }
    let mut shown = window;
    if shown.is_none() {
        shown = box_of_all(&drawn, around, work)?;
    }
    let mut layers = Vec::new();
    for next in drawn {
        match next {
            Drawn::Layer(layer, _) => layers.push(layer),
            Drawn::Surface(label, surface) => {
                let mesh = of_surface(&surface, &for_pictures(shown, options.cells), work)?;
                let [all, open] = mesh.cells;
                let cell = mesh.cell;
                if mesh.may_be_singular {
                    work.remark(Remark::MayBeSingular);
                } else if open > 0 {
                    work.remark(Remark::SmallPartsMayBeMissing { open, all, cell });
                }
                if mesh.triangles.is_empty() && mesh.curves.is_empty() && mesh.points.is_empty() {
                    work.remark(Remark::SurfaceNotSeen(label.clone()));
                }
                if mesh.has_crossings {
                    work.remark(Remark::SheetsNearCurves(SNAPPED * mesh.cell));
                }
                let all = mesh.vertices.iter().chain(mesh.curves.iter().flatten());
                shown = shown.or_else(|| box_around(all.chain(&mesh.points)));
                layers.push(SpaceLayer {
                    label,
                    ..mesh_layer(&mesh)
                });
            }
        }
    }
    if !options.points.is_empty() {
        layers.push(SpaceLayer {
            label: "points".into(),
            points: options.points.clone(),
            ..SpaceLayer::default()
        });
    }
    let view = options.view.unwrap_or(VIEW);
    let scene = Scene {
        title: options.title.clone(),
        width: width(options.width)?,
        bounds: shown,
        azimuth: view[0],
        elevation: view[1],
        layers,
    };
    work.stage("draw", || scene.to_svg())
}

/// A form on its way into the scene.
enum Drawn {
    /// A finished layer, and the box that shows it.
    Layer(SpaceLayer, Option<BoxSides>),
    /// A label, and a surface that will be meshed in the box of the whole scene.
    Surface(String, ImplicitSurface),
}

/// The triangles of a mesh, with the singular curves and points of the surface. Vertices near such a curve are moved to it: there
/// sheets meet at an angle that the cells are too coarse for.
pub(super) fn mesh_layer(mesh: &Mesh) -> SpaceLayer {
    let mut layer = SpaceLayer {
        closed: mesh.topology().is_watertight() && mesh.curves.is_empty(),
        lines: mesh.curves.clone(),
        points: mesh.points.clone(),
        ..SpaceLayer::default()
    };
    let vertices: Vec<[f64; 3]> = {
        let snapped = mesh.vertices.iter();
        let reach = SNAPPED * mesh.cell;
        snapped
            .map(|v| near_curve(*v, &mesh.curves, reach))
            .collect()
    };
    for triangle in &mesh.triangles {
        let corners = triangle.map(|v| vertices[v as usize]);
        let normals = triangle.map(|v| mesh.normals[v as usize]);
        layer.facets.push(corners.to_vec());
        layer
            .normals
            .push([0, 1, 2].map(|i| normals.iter().map(|n| n[i]).sum()));
    }
    layer
}

/// The nearest point of polylines, if it is within reach, or else the point itself.
fn near_curve(p: [f64; 3], curves: &[Vec<[f64; 3]>], reach: f64) -> [f64; 3] {
    let minus = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] - b[i]);
    let dot = |a: [f64; 3], b: [f64; 3]| -> f64 { (0..3).map(|i| a[i] * b[i]).sum() };
    let (mut best, mut least) = (p, reach * reach);
    for pair in curves.iter().flat_map(|line| line.windows(2)) {
        let (step, from) = (minus(pair[1], pair[0]), minus(p, pair[0]));
        let t = (dot(step, from) / dot(step, step)).clamp(0.0, 1.0);
        let foot = [0, 1, 2].map(|i| pair[0][i] + t * step[i]);
        let off = minus(p, foot);
        if dot(off, off) < least {
            (best, least) = (foot, dot(off, off));
        }
    }
    best
}

/// The box around both boxes.
pub(super) fn joined(a: Option<BoxSides>, b: Option<BoxSides>) -> Option<BoxSides> {
    match (a, b) {
        (Some(a), Some(b)) => Some([0, 1, 2].map(|k| [a[k][0].min(b[k][0]), a[k][1].max(b[k][1])])),
        (a, b) => a.or(b),
    }
}

/// The box around finite points.
pub(super) fn box_around<'a>(points: impl Iterator<Item = &'a [f64; 3]>) -> Option<BoxSides> {
    points
        .filter(|p| p.iter().all(|v| v.is_finite()))
        .fold(None, |bounds: Option<BoxSides>, p| {
            let b = bounds.unwrap_or(p.map(|v| [v, v]));
            Some([0, 1, 2].map(|k| [b[k][0].min(p[k]), b[k][1].max(p[k])]))
        })
}

fn drawn_of(
    given: Given,
    options: &PlotOptions,
    window: Option<BoxSides>,
    work: &Work,
) -> Result<Vec<Drawn>> {
    if let Content::Exact(Form::Intersection(surfaces)) = given.content() {
        return intersection(surfaces, window, work);
    }
    Ok(vec![drawn_one(given, options, work)?])
}

/// The layers of the surfaces, and of the curve in which they meet if Theorem 7 gives it.
fn intersection(
    surfaces: &[ImplicitSurface],
    window: Option<BoxSides>,
    work: &Work,
) -> Result<Vec<Drawn>> {
    let surfaces = &ImplicitSurface::all_in_original_coordinates(surfaces, work.bounds())?;
    let degree = |surface: &ImplicitSurface| surface.polynomial().degree().unwrap_or(0);
    let all = surfaces.iter().map(|surface| {
        let label = format!("surface of degree {}", degree(surface));
        Drawn::Surface(label, surface.clone())
    });
    let mut all: Vec<Drawn> = all.collect();
    let found = work.stage("parametrize", || {
        parametrize_intersection(surfaces, work.bounds())
    })?;
    if !found.others.is_empty() && surfaces.len() == 2 {
        let search = ArcSearch::default().window(window);
        let traced = arcs_of_others(&found, surfaces, &search, work)?;
        let lines: Vec<Vec<[f64; 3]>> = traced.arcs.iter().map(CurveArc::polyline).collect();
        let around = box_around(lines.iter().flatten());
        let layer = SpaceLayer {
            label: format!("both: certified arcs ({})", lines.len()),
            lines,
            ..SpaceLayer::default()
        };
        all.push(Drawn::Layer(layer, around));
    } else {
        for other in &found.others {
            work.remark(Remark::NotDrawn(other.reason.clone()));
        }
    }
    let of_curves = found.unreached.iter().filter(|point| point.is_isolated);
    let isolated = found
        .points
        .iter()
        .chain(of_curves.map(|point| &point.point));
    let points: Vec<[f64; 3]> = isolated.map(CommonPoint::near).collect();
    if !points.is_empty() {
        let around = box_around(points.iter());
        let layer = SpaceLayer {
            label: format!("both: isolated points ({})", points.len()),
            points,
            ..SpaceLayer::default()
        };
        all.push(Drawn::Layer(layer, around));
    }
    for curve in &found.curves {
        let layer = SpaceLayer {
            label: format!("both: ({})", formulas(curve)),
            lines: curve.polylines(None, CURVE_POINTS),
            ..SpaceLayer::default()
        };
        all.push(Drawn::Layer(layer, curve.extent(None)));
    }
    Ok(all)
}

fn drawn_one(given: Given, options: &PlotOptions, work: &Work) -> Result<Drawn> {
    let (name, short_name) = (given.whole_name(), given.short_name());
    let label = |kind: &str, parts: Vec<String>| {
        let parts = parts.into_iter().map(|part| format!(", {part}"));
        format!("{kind}, {name}{}", parts.collect::<String>())
    };
    match given.into_content() {
        Content::Exact(Form::SpaceCurve(curve)) => {
            let range = range_of(curve.parameter(), &options.ranges);
            let said = range_text(curve.parameter(), range);
            let drawn = SpaceLayer {
                label: label("space curve", said.into_iter().collect()),
                lines: curve.polylines(range, CURVE_POINTS),
                ..SpaceLayer::default()
            };
            Ok(Drawn::Layer(drawn, curve.extent(range)))
        }
        Content::Exact(Form::Patch(patch)) => {
            let ranges = &options.ranges;
            let ranges = patch.parameters().each_ref().map(|p| range_of(p, ranges));
            let shown = patch.parameters().iter().zip(ranges).map(|(p, range)| {
                let numbers = (!p.is_angle()).then_some(DRAWN_NUMBERS);
                range_text(p, range.or(numbers))
            });
            let found = patch.facets(ranges, options.cells);
            let drawn = SpaceLayer {
                label: label("patch", shown.flatten().collect()),
                facets: found.facets,
                ..SpaceLayer::default()
            };
            Ok(Drawn::Layer(drawn, found.extent))
        }
        Content::Exact(Form::Surface(surface)) => {
            let degree = surface.polynomial().degree().unwrap_or(0);
            let label = label("zero set", vec![format!("degree {degree}")]);
            let moved = surface.in_original_coordinates(work.bounds())?;
            Ok(Drawn::Surface(label, moved.into_owned()))
        }
        Content::Exact(Form::Curve(curve)) => {
            let label = label("cylinder", Vec::new());
            Ok(Drawn::Surface(label, cylinder(&curve)))
        }
        Content::Exact(Form::SpaceSuperquadric(shape)) => {
            let [of_xy, _, of_z] = shape.exponents();
            let cells = options.cells.unwrap_or(SURFACE_CELLS);
            let mesh = of_superquadric(&shape, cells, work)?;
            let layer = SpaceLayer {
                label: format!("superquadric, 2/e2 = {of_xy}, 2/e1 = {of_z}"),
                ..mesh_layer(&mesh)
            };
            Ok(Drawn::Layer(layer, box_around(mesh.vertices.iter())))
        }
        Content::Exact(Form::Harmonic(surface)) => {
            let cells = options.cells.unwrap_or(SURFACE_CELLS);
            let mesh = of_harmonics(&surface, cells, work)?;
            let layer = SpaceLayer {
                label: label("harmonics", vec![format!("degree {}", surface.degree())]),
                ..mesh_layer(&mesh)
            };
            Ok(Drawn::Layer(layer, box_around(mesh.vertices.iter())))
        }
        _ => Err(Error::Usage(format!(
            "{short_name}: this form is in the plane and cannot be drawn with one in space"
        ))),
    }
}

/// The coordinates as functions of the parameter.
fn formulas(curve: &SpaceCurve) -> String {
    Coordinates::from(curve).formulas(Format::Text).join(", ")
}

/// The box of a scene. Bounded surfaces have a box of their own. Unbounded ones are drawn in the box of all other forms, which
/// grows to hold their bounded pieces.
fn box_of_all(drawn: &[Drawn], around: Option<BoxSides>, work: &Work) -> Result<Option<BoxSides>> {
    let (mut around, mut pieces) = (around, None);
    let mut unbounded = Vec::new();
    for next in drawn {
        let Drawn::Surface(label, surface) = next else {
            continue;
        };
        let found = work.stage("bounds", || mesh_bounds(surface, work.bounds()))?;
        let Some(found) = found else {
            continue;
        };
        if found.held == Held::Unproved {
            work.remark(Remark::PiecesMayBeOutside);
        }
        if found.seems_bounded {
            around = joined(around, Some(found.bounds));
        } else {
            pieces = joined(pieces, found.pieces);
            unbounded.push((label, found.bounds));
        }
    }
    let all = around.and_then(|around| joined(Some(around), pieces));
    for (label, alone) in unbounded {
        if all.is_some_and(|all| joined(Some(all), Some(alone)) != Some(all)) {
            work.remark(Remark::DrawnInOthersBox(label.clone()));
        }
    }
    Ok(all)
}
