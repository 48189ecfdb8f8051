//! Documents of Theorem 7: parametric space curves for intersections of surfaces.

use std::collections::BTreeMap;
use std::io::Write;

use serde::Serialize;

use super::arcs::{Arcs, arcs_text};
use super::json::write_value;
use super::{Coordinates, Format, SCHEMA, write_coordinates};
use crate::arcs::IntersectionArcs;
use crate::error::Result;
use crate::exact::Rational;
use crate::notation::polynomial_text;
use crate::parametrize::{CommonPoint, IntersectionParametrization};

/// The first curve has the fields of any parametric document, from which it is read back; then the document lists all curves.
#[derive(Serialize)]
struct IntersectionCurvesDocument {
    schema: &'static str,
    kind: &'static str,
    parameters: Vec<String>,
    coordinates: BTreeMap<&'static str, String>,
    method: &'static str,
    projected_along: &'static str,
    curves: Vec<Curve>,
    others: Vec<Other>,
    points: Vec<[String; 3]>,
    #[serde(flatten)]
    arcs: Option<Arcs>,
    notes: Vec<String>,
}

#[derive(Serialize)]
struct Curve {
    parameters: Vec<String>,
    coordinates: BTreeMap<&'static str, String>,
}

#[derive(Serialize)]
struct Other {
    projection: String,
    reason: String,
}

/// Writes the curves, the first one so that it can be read back, and the findings about components without a parametrization.
/// There must be a curve, or arcs of a component without a parametrization. Only text and JSON can hold arcs.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`](super::Kind::check).
pub(crate) fn write_intersection_curves(
    found: &IntersectionParametrization,
    arcs: Option<&IntersectionArcs>,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let curves: Vec<Coordinates> = found.curves.iter().map(Coordinates::from).collect();
    let axis = ["x", "y", "z"][found.axis];
    let others = found.others.iter().map(|other| Other {
        projection: polynomial_text(&other.projection),
        reason: other.reason.clone(),
    });
    let finite = found.finite.iter().map(|component| {
        let many = match component.points {
            0 => "no real point".to_owned(),
            1 => "one real point".to_owned(),
            n => format!("{n} real points"),
        };
        let over = polynomial_text(&component.projection);
        format!("a component over {over} = 0 has {many}")
    });
    let notes: Vec<String> = finite.chain(found.notes.iter().cloned()).collect();
    match format {
        Format::Json => {
            let curve = |c: &Coordinates| Curve {
                parameters: c.parameters().into_iter().map(Into::into).collect(),
                coordinates: c.fields(),
            };
            let all: Vec<Curve> = curves.iter().map(curve).collect();
            let first = curves.first().map(curve);
            let document = IntersectionCurvesDocument {
                schema: SCHEMA,
                kind: "parametric",
                parameters: first
                    .as_ref()
                    .map(|c| c.parameters.clone())
                    .unwrap_or_default(),
                coordinates: first.map(|c| c.coordinates).unwrap_or_default(),
                method: "theorem-7",
                projected_along: axis,
                curves: all,
                others: others.collect(),
                points: found.points.iter().map(coordinates_of).collect(),
                arcs: arcs.map(Arcs::from),
                notes,
            };
            write_value(&document, out)?;
            Ok(writeln!(out)?)
        }
        Format::Text => {
            writeln!(
                out,
                "# theorem-7: projected along {axis}; {}",
                if !curves.is_empty() {
                    "every curve satisfies all the equations, by exact substitution"
                } else if found.others.is_empty() {
                    "the surfaces do not meet in a real curve"
                } else {
                    "no rational or trigonometric parametrization was found"
                }
            )?;
            for other in others {
                writeln!(
                    out,
                    "# component over {} = 0: {}",
                    other.projection, other.reason
                )?;
            }
            for point in &found.points {
                let [x, y, z] = coordinates_of(point);
                let sign = match point {
                    CommonPoint::Exact(_) => "=",
                    _ => "≈",
                };
                writeln!(out, "# common point (x, y, z) {sign} ({x}, {y}, {z})")?;
            }
            for note in &notes {
                writeln!(out, "# note: {note}")?;
            }
            for line in arcs.map(arcs_text).unwrap_or_default() {
                writeln!(out, "# {line}")?;
            }
            for (index, curve) in curves.iter().enumerate() {
                let hidden = if index > 0 { "# " } else { "" };
                if curves.len() > 1 {
                    writeln!(out, "# curve {index}")?;
                }
                let mut text = Vec::new();
                write_coordinates(curve, Format::Text, &mut text)?;
                for line in String::from_utf8_lossy(&text).lines() {
                    writeln!(out, "{hidden}{line}")?;
                }
            }
            Ok(())
        }
        _ => curves
            .iter()
            .try_for_each(|curve| write_coordinates(curve, format, out)),
    }
}

/// The coordinates of a point: fractions if they are exact, else decimals.
fn coordinates_of(point: &CommonPoint) -> [String; 3] {
    match point {
        CommonPoint::Exact(point) => point.each_ref().map(Rational::to_string),
        CommonPoint::Near(near) => near.map(|x| format!("{x:?}")),
    }
}
