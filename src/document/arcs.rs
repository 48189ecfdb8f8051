//! Certified arcs of the curve in which two surfaces meet, as CSV rows, as JSON and as lines of text.

use std::io::Write;

use serde::Serialize;

use super::json::write_value;
use super::{Format, Kind, SCHEMA};
use crate::arcs::{ArcEnd, CurveArc, IntersectionArcs};
use crate::error::Result;
use crate::exact::Rational;

/// The arcs as they stand in a JSON document: `window` is the box that was searched, `unresolved` lists the boxes in which
/// the curve was not found out, and `touching` exact points in them where the surfaces touch.
#[derive(Serialize)]
pub(super) struct Arcs {
    window: [[f64; 2]; 3],
    arcs: Vec<Arc>,
    unresolved: Vec<[[f64; 2]; 3]>,
    touching: Vec<[String; 3]>,
}

#[derive(Serialize)]
struct Arc {
    closed: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    ends: Option<[&'static str; 2]>,
    points: Vec<Point>,
}

#[derive(Serialize)]
struct Point {
    x: f64,
    y: f64,
    z: f64,
    bound: f64,
    residuals: [String; 2],
}

#[derive(Serialize)]
struct ArcsDocument {
    schema: &'static str,
    kind: &'static str,
    #[serde(flatten)]
    arcs: Arcs,
}

impl From<&IntersectionArcs> for Arcs {
    fn from(found: &IntersectionArcs) -> Self {
        let arc = |arc: &CurveArc| Arc {
            closed: arc.ends.is_none(),
            ends: arc.ends.map(|ends| ends.map(name)),
            points: arc
                .points
                .iter()
                .map(|p| {
                    let [x, y, z] = p.position;
                    let residuals = p.residuals.each_ref().map(ToString::to_string);
                    Point {
                        x,
                        y,
                        z,
                        bound: p.radius,
                        residuals,
                    }
                })
                .collect(),
        };
        Self {
            window: found.bounds,
            arcs: found.arcs.iter().map(arc).collect(),
            unresolved: found.unresolved.clone(),
            touching: found
                .touching
                .iter()
                .map(|point| point.each_ref().map(Rational::to_string))
                .collect(),
        }
    }
}

fn name(end: ArcEnd) -> &'static str {
    match end {
        ArcEnd::Window => "window",
        ArcEnd::Unresolved => "unresolved",
    }
}

/// Writes the points of arcs, as CSV or as JSON.
///
/// The CSV columns are `arc,point,x,y,z,bound,residual1,residual2`. The curve is within `bound` of the point; the residuals are the
/// values of the two polynomials at the point, as the doubles nearest to the exact values. The JSON document is of kind `arcs`; it
/// has the fields `window`, `arcs` (each with `closed`, `ends` and `points` with exact `residuals`) and `unresolved`.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(crate) fn write_arcs(
    found: &IntersectionArcs,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    match format {
        Format::Csv => {
            writeln!(out, "arc,point,x,y,z,bound,residual1,residual2")?;
            for (n, arc) in found.arcs.iter().enumerate() {
                for (k, p) in arc.points.iter().enumerate() {
                    let [x, y, z] = p.position;
                    let [f, g] = p.residuals.each_ref().map(|r| r.to_f64());
                    writeln!(out, "{n},{k},{x:?},{y:?},{z:?},{:?},{f:?},{g:?}", p.radius)?;
                }
            }
            Ok(())
        }
        Format::Json => {
            let document = ArcsDocument {
                schema: SCHEMA,
                kind: "arcs",
                arcs: Arcs::from(found),
            };
            write_value(&document, out)?;
            Ok(writeln!(out)?)
        }
        _ => Err(Kind::Arcs.refused(format)),
    }
}

/// Lines of text: one about the box, one for each arc, and one about the boxes that are not resolved.
#[must_use]
pub(crate) fn arcs_text(found: &IntersectionArcs) -> Vec<String> {
    let mut lines = vec![match found.arcs.len() {
        0 => format!("no arcs in the box {}", box_text(&found.bounds)),
        _ => format!(
            "arcs in the box {}: neighbouring points are proved to lie on one smooth arc",
            box_text(&found.bounds)
        ),
    }];
    for (n, arc) in found.arcs.iter().enumerate() {
        let ends = match arc.ends {
            None => "closed".to_owned(),
            Some([a, b]) if a == b => format!("both ends {}", end_text(a)),
            Some([a, b]) => format!("from {} to {}", end_text(a), end_text(b)),
        };
        let bound = arc.points.iter().map(|p| p.radius).fold(0.0, f64::max);
        let [x, y, z] = arc.points.first().map_or([0.0; 3], |p| p.position);
        lines.push(format!(
            "arc {n}: {ends}, {} points, each within {bound:.1e} of the curve, the first \u{2248} ({x:.6}, {y:.6}, {z:.6})",
            arc.points.len()
        ));
    }
    let all = match found.unresolved.len() {
        0 => "every common point in the box lies on these arcs".to_owned(),
        1 => format!(
            "every other common point in the box lies in {}, which is not resolved: a singular point, or the surfaces touch",
            box_text(&found.unresolved[0])
        ),
        n => format!(
            "every other common point in the box lies in one of {n} boxes that are not resolved (singular points, or the surfaces touch), the first {}",
            box_text(&found.unresolved[0])
        ),
    };
    lines.push(all);
    for point in &found.touching {
        let [x, y, z] = point.each_ref().map(Rational::to_string);
        lines.push(format!(
            "among them the common point (x, y, z) = ({x}, {y}, {z}), where the surfaces touch or one of them is singular"
        ));
    }
    lines
}

fn end_text(end: ArcEnd) -> &'static str {
    match end {
        ArcEnd::Window => "at the side of the box",
        ArcEnd::Unresolved => "at a place that is not resolved",
    }
}

fn box_text(bounds: &[[f64; 2]; 3]) -> String {
    let sides = bounds.map(|[a, b]| format!("[{a:.5}, {b:.5}]"));
    sides.join(" \u{d7} ")
}
