//! `stellate plot` in space: curves, patches and implicit surfaces in perspective.

use stellate::arcs::CurveArc;
use stellate::document::{Coordinates, Format};
use stellate::error::{Error, Result};
use stellate::mesh::Mesh;
use stellate::parametrize::parametrize_intersection;
use stellate::picture::{Scene, SpaceLayer};
use stellate::shape::{DRAWN_NUMBERS, Form, ImplicitSurface, Parameter};

use super::arcs;
use super::arguments::Plot;
use super::input::{self, Content, Input};
use super::mesh;
use super::numbers::{Bounds, numbers_of, space_window};
use super::session::Session;

/// Points along a curve, and cells along each parameter of a patch without `--cells`.
const CURVE_POINTS: u32 = 720;
const PATCH_CELLS: u32 = 54;

/// Cells along the longest side of the box of an implicit surface, and the angle by which edges may bend.
pub(super) const SURFACE_CELLS: u32 = 36;
pub(super) const SURFACE_ANGLE: f64 = 30.0;

/// Where the eye is without `--view`, in degrees.
pub(super) const VIEW: [f64; 2] = [30.0, 25.0];

/// Whether a form is drawn in space.
pub(crate) fn is_in_space(input: &Input) -> bool {
    matches!(
        input.content,
        Content::Exact(
            Form::SpaceCurve(_)
                | Form::Patch(_)
                | Form::Surface(_)
                | Form::SpaceSuperquadric(_)
                | Form::Intersection(_)
        )
    )
}

/// The scene of several forms, as SVG.
pub(crate) fn scene(verb: &Plot, inputs: Vec<Input>, session: &mut Session) -> Result<String> {
    let ranges = ranges(verb)?;
    let [azimuth, elevation] = view(&verb.view)?;
    let window = verb.window.as_deref().map(space_window).transpose()?;
    let points = verb.point.iter().map(|text| point(text));
    let points = points.collect::<Result<Vec<_>>>()?;
    let mut drawn: Vec<Drawn> = Vec::new();
    let mut around = box_around(points.iter());
    for input in inputs {
        for next in drawn_of(input, verb, &ranges, window, session)? {
            if let Drawn::Layer(_, extent) = &next {
                around = joined(around, *extent);
            }
            drawn.push(next);
        }
    }
    // Surfaces that are bounded have a box of their own; the others are drawn in that of the rest.
    let cells = verb.cells.unwrap_or(SURFACE_CELLS);
    let mut shown = window;
    if shown.is_none() {
        for next in &drawn {
            if let Drawn::Surface(_, surface) = next {
                around = joined(around, mesh::closed_bounds(surface, session)?);
            }
        }
        shown = around;
    }
    let mut layers = Vec::new();
    for next in drawn {
        match next {
            Drawn::Layer(layer, _) => layers.push(layer),
            Drawn::Surface(label, surface) => {
                let mesh = mesh::of_surface(&surface, shown, cells, SURFACE_ANGLE, session)?;
                shown = shown.or_else(|| box_around(mesh.vertices.iter()));
                let mut layer = mesh_layer(&mesh);
                layer.label = label;
                layers.push(layer);
            }
        }
    }
    if !points.is_empty() {
        layers.push(SpaceLayer {
            label: "points".into(),
            points,
            ..SpaceLayer::default()
        });
    }
    let scene = Scene {
        title: verb.title.clone(),
        bounds: shown,
        azimuth,
        elevation,
        layers,
    };
    session.stage("draw", |_| scene.to_svg())
}

/// What a form becomes.
enum Drawn {
    /// What is drawn already, and the box that shows it.
    Layer(SpaceLayer, Option<Bounds>),
    /// A label, and a surface that is to be meshed in the box of everything.
    Surface(String, ImplicitSurface),
}

pub(super) fn mesh_layer(mesh: &Mesh) -> SpaceLayer {
    let mut layer = SpaceLayer {
        closed: mesh.topology().is_watertight(),
        ..SpaceLayer::default()
    };
    for triangle in &mesh.triangles {
        let corners = triangle.map(|v| mesh.vertices[v as usize]);
        let normals = triangle.map(|v| mesh.normals[v as usize]);
        layer.facets.push(corners.to_vec());
        layer
            .normals
            .push([0, 1, 2].map(|i| normals.iter().map(|n| n[i]).sum()));
    }
    layer
}

pub(super) fn joined(a: Option<Bounds>, b: Option<Bounds>) -> Option<Bounds> {
    match (a, b) {
        (Some(a), Some(b)) => Some([0, 1, 2].map(|k| [a[k][0].min(b[k][0]), a[k][1].max(b[k][1])])),
        (a, b) => a.or(b),
    }
}

fn point(text: &str) -> Result<[f64; 3]> {
    numbers_of::<3>(text)
        .ok_or_else(|| Error::Usage(format!("--point {text}: expected X,Y,Z, such as 0.8,0.6,0")))
}

/// A parameter's name and the part of it that is drawn.
pub(crate) type Range = (String, [f64; 2]);

/// `--range NAME=A,B`
pub(crate) fn ranges(verb: &Plot) -> Result<Vec<Range>> {
    let read = |text: &String| {
        let (name, numbers) = text.split_once('=')?;
        let [a, b] = numbers_of::<2>(numbers)?;
        (a < b).then(|| (name.trim().to_owned(), [a, b]))
    };
    verb.range
        .iter()
        .map(|text| {
            read(text).ok_or_else(|| {
                Error::Usage(format!(
                    "--range {text}: expected NAME=A,B with A < B, such as t=-2,2"
                ))
            })
        })
        .collect()
}

/// The range given for a parameter, if there is one.
pub(crate) fn range_of(parameter: &Parameter, ranges: &[Range]) -> Option<[f64; 2]> {
    let given = ranges.iter().rfind(|(name, _)| name == parameter.name());
    given.map(|(_, range)| *range)
}

/// What the legend says of the range of a parameter.
pub(crate) fn range_text(parameter: &Parameter, range: Option<[f64; 2]>) -> Option<String> {
    range.map(|[a, b]| format!("{} from {a} to {b}", parameter.name()))
}

fn view(text: &str) -> Result<[f64; 2]> {
    let found = numbers_of::<2>(text).filter(|[_, elevation]| elevation.abs() < 90.0);
    found.ok_or_else(|| {
        Error::Usage(format!(
            "--view {text}: expected AZIMUTH,ELEVATION in degrees, such as 30,25, with the elevation between -90 and 90"
        ))
    })
}

fn drawn_of(
    input: Input,
    verb: &Plot,
    ranges: &[Range],
    window: Option<Bounds>,
    session: &mut Session,
) -> Result<Vec<Drawn>> {
    if let Content::Exact(Form::Intersection(surfaces)) = &input.content {
        return intersection(surfaces, window, session);
    }
    Ok(vec![drawn_one(input, verb, ranges, session)?])
}

/// The surfaces, each by itself, and the curve where they meet if Theorem 7 gives it.
fn intersection(
    surfaces: &[ImplicitSurface],
    window: Option<Bounds>,
    session: &mut Session,
) -> Result<Vec<Drawn>> {
    let degree = |surface: &ImplicitSurface| surface.polynomial().degree().unwrap_or(0);
    let all = surfaces.iter().map(|surface| {
        let label = format!("surface of degree {}", degree(surface));
        Drawn::Surface(label, surface.clone())
    });
    let mut all: Vec<Drawn> = all.collect();
    let found = session.stage("parametrize", |session| {
        parametrize_intersection(surfaces, &session.limits)
    })?;
    if !found.others.is_empty() && surfaces.len() == 2 {
        let traced = arcs::arcs_of_others(&found, surfaces, window, None, session)?;
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
            session.note(&format!(
                "a component of the curve is not drawn: {}",
                other.reason
            ));
        }
    }
    for curve in &found.curves {
        let formulas = Coordinates::from(curve).formulas(Format::Text).join(", ");
        let layer = SpaceLayer {
            label: format!("both: ({formulas})"),
            lines: curve.polylines(None, CURVE_POINTS),
            ..SpaceLayer::default()
        };
        all.push(Drawn::Layer(layer, curve.extent(None)));
    }
    Ok(all)
}

fn drawn_one(input: Input, verb: &Plot, ranges: &[Range], session: &mut Session) -> Result<Drawn> {
    let name = input.short_name();
    let label = |kind: &str, parts: Vec<String>| {
        let parts = parts.into_iter().map(|part| format!(", {part}"));
        format!("{kind}, {name}{}", parts.collect::<String>())
    };
    match input.content {
        Content::Exact(Form::SpaceCurve(curve)) => {
            let range = range_of(curve.parameter(), ranges);
            let said = range_text(curve.parameter(), range);
            let drawn = SpaceLayer {
                label: label("space curve", said.into_iter().collect()),
                lines: curve.polylines(range, CURVE_POINTS),
                ..SpaceLayer::default()
            };
            Ok(Drawn::Layer(drawn, curve.extent(range)))
        }
        Content::Exact(Form::Patch(patch)) => {
            let given = patch.parameters().each_ref().map(|p| range_of(p, ranges));
            let shown = patch.parameters().iter().zip(given).map(|(p, range)| {
                let numbers = (!p.is_angle()).then_some(DRAWN_NUMBERS);
                range_text(p, range.or(numbers))
            });
            let grid = patch.grid(given, [verb.cells.unwrap_or(PATCH_CELLS); 2]);
            let drawn = SpaceLayer {
                label: label("patch", shown.flatten().collect()),
                facets: SpaceLayer::grid_facets(&grid),
                ..SpaceLayer::default()
            };
            let extent = box_around(drawn.facets.iter().flatten());
            Ok(Drawn::Layer(drawn, extent))
        }
        Content::Exact(Form::Surface(surface)) => {
            let degree = surface.polynomial().degree().unwrap_or(0);
            let label = label("zero set", vec![format!("degree {degree}")]);
            Ok(Drawn::Surface(label, surface))
        }
        Content::Exact(Form::Curve(curve)) => {
            let label = label("cylinder", Vec::new());
            Ok(Drawn::Surface(label, input::cylinder(&curve)))
        }
        Content::Exact(Form::SpaceSuperquadric(shape)) => {
            let [of_xy, _, of_z] = shape.exponents();
            let cells = verb.cells.unwrap_or(SURFACE_CELLS);
            let mesh = mesh::of_superquadric(&shape, cells, session)?;
            let mut layer = mesh_layer(&mesh);
            layer.label = format!("superquadric, 2/e2 = {of_xy}, 2/e1 = {of_z}");
            Ok(Drawn::Layer(layer, box_around(mesh.vertices.iter())))
        }
        _ => Err(Error::Usage(format!(
            "{name}: this form is in the plane and cannot be drawn with one in space"
        ))),
    }
}

/// The box around finite points.
pub(super) fn box_around<'a>(points: impl Iterator<Item = &'a [f64; 3]>) -> Option<Bounds> {
    points
        .filter(|p| p.iter().all(|v| v.is_finite()))
        .fold(None, |bounds: Option<Bounds>, p| {
            let b = bounds.unwrap_or(p.map(|v| [v, v]));
            Some([0, 1, 2].map(|k| [b[k][0].min(p[k]), b[k][1].max(p[k])]))
        })
}
