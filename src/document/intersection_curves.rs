//! Documents of Theorem 7: parametric space curves for intersections of surfaces.

use std::collections::BTreeMap;
use std::io::Write;

use serde::Serialize;
use serde_json::Value;

use super::arcs::{Arcs, arcs_text};
use super::json::{parsed, write_value};
use super::source::write_source;
use super::{Coordinates, Format, SCHEMA, write_coordinates, write_surface};
use crate::arcs::IntersectionArcs;
use crate::error::Result;
use crate::exact::Rational;
use crate::notation::polynomial_text;
use crate::parametrize::{CommonPoint, IntersectionParametrization, UnreachedPoint};
use crate::shape::Form;

/// If one curve is the whole intersection, it has the fields of any parametric document, from which it is read back; else the
/// surfaces are read back. Then the document lists all curves.
#[derive(Serialize)]
struct IntersectionCurvesDocument {
    schema: &'static str,
    kind: &'static str,
    parameters: Vec<String>,
    coordinates: BTreeMap<&'static str, String>,
    surfaces: Vec<Value>,
    method: &'static str,
    projected_along: &'static str,
    curves: Vec<Curve>,
    others: Vec<Other>,
    points: Vec<[String; 3]>,
    beyond: Vec<Beyond>,
    #[serde(flatten)]
    arcs: Option<Arcs>,
    notes: Vec<String>,
}

#[derive(Serialize)]
struct Curve {
    parameters: Vec<String>,
    coordinates: BTreeMap<&'static str, String>,
}

/// A real point that no parameter value of its curve reaches.
#[derive(Serialize)]
struct Beyond {
    kind: &'static str,
    curve: usize,
    point: [String; 3],
}

#[derive(Serialize)]
struct Other {
    projection: String,
    reason: String,
}

/// Writes the curves, and the findings about components without a parametrization. There must be a curve, or arcs of a component
/// without a parametrization. Only text and JSON can hold arcs. The surfaces are in a comment, from which they are
/// read back, unless one curve is the whole intersection.
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
    // One curve that is the whole intersection is read back itself.
    let source = match found.as_one_curve() {
        Some(_) => None,
        None => Some(Form::Intersection(found.surfaces.clone())),
    };
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
            let surfaces = found.surfaces.iter().map(|surface| {
                let mut text = Vec::new();
                write_surface(surface, &[], Format::Json, &mut text)?;
                Ok(parsed(&text))
            });
            let surfaces = surfaces.collect::<Result<_>>()?;
            let first = curves.first().map(curve);
            let document = IntersectionCurvesDocument {
                schema: SCHEMA,
                kind: "parametric",
                parameters: first
                    .as_ref()
                    .map(|c| c.parameters.clone())
                    .unwrap_or_default(),
                coordinates: first.map(|c| c.coordinates).unwrap_or_default(),
                surfaces,
                method: "theorem-7",
                projected_along: axis,
                curves: all,
                others: others.collect(),
                points: found.points.iter().map(coordinates_of).collect(),
                beyond: found.unreached.iter().map(Beyond::from).collect(),
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
            write_source(source.as_ref(), format, out)?;
            for other in others {
                writeln!(
                    out,
                    "# component over {} = 0: {}",
                    other.projection, other.reason
                )?;
            }
            for point in &found.points {
                writeln!(out, "# {}", common_point(point))?;
            }
            for beyond in &found.unreached {
                let point = common_point(&beyond.point);
                let t = found.curves[beyond.curve].parameter().name();
                let k = beyond.curve;
                if beyond.is_isolated {
                    writeln!(
                        out,
                        "# {point}, an isolated real point of curve {k}, of conjugate complex {t}"
                    )?;
                } else {
                    writeln!(
                        out,
                        "# {point}, which curve {k} only approaches, as {t} goes to infinity"
                    )?;
                }
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
        Format::Sympy if curves.len() != 1 => {
            let tuple = |c: &Coordinates| format!("({})", c.formulas(format).join(", "));
            let all: Vec<String> = curves.iter().map(tuple).collect();
            writeln!(out, "[{}]", all.join(", "))?;
            write_source(source.as_ref(), format, out)
        }
        // Statements for each curve would overwrite those of the one before.
        Format::Maple if curves.len() != 1 => {
            let list = |c: &Coordinates| format!("[{}]", c.formulas(format).join(", "));
            let all: Vec<String> = curves.iter().map(list).collect();
            writeln!(out, "curves := [{}];", all.join(", "))?;
            write_source(source.as_ref(), format, out)
        }
        _ => {
            for curve in &curves {
                write_coordinates(curve, format, out)?;
            }
            write_source(source.as_ref(), format, out)
        }
    }
}

impl From<&UnreachedPoint> for Beyond {
    fn from(unreached: &UnreachedPoint) -> Self {
        Self {
            kind: if unreached.is_isolated {
                "isolated"
            } else {
                "approached"
            },
            curve: unreached.curve,
            point: coordinates_of(&unreached.point),
        }
    }
}

fn common_point(point: &CommonPoint) -> String {
    let [x, y, z] = coordinates_of(point);
    let sign = match point {
        CommonPoint::Exact(_) => "=",
        CommonPoint::Near(_) => "≈",
    };
    format!("common point (x, y, z) {sign} ({x}, {y}, {z})")
}

/// The coordinates of a point: fractions if they are exact, else decimals.
fn coordinates_of(point: &CommonPoint) -> [String; 3] {
    match point {
        CommonPoint::Exact(point) => point.each_ref().map(Rational::to_string),
        CommonPoint::Near(near) => near.map(|x| format!("{x:?}")),
    }
}
