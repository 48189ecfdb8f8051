//! Certified points as CSV and JSON.

use std::io::Write;

use serde::Serialize;

use super::json::{Number, write_value};
use super::{Format, Kind, SCHEMA};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::sample::{NominalAngles, Ray, Sample, SampledRay};

#[derive(Serialize)]
struct Point {
    branch: usize,
    #[serde(flatten)]
    direction: Line,
    r: Number,
    x: Number,
    y: Number,
    #[serde(skip_serializing_if = "Option::is_none")]
    z: Option<Number>,
    multiplicity: usize,
}

#[derive(Serialize)]
struct Line {
    theta: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    phi: Option<f64>,
    u: String,
    v: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    w: Option<String>,
}

#[derive(Serialize)]
struct SamplesDocument {
    schema: &'static str,
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    center: Option<Vec<String>>,
    points: Vec<Point>,
    lines: Vec<Line>,
}

/// Writes points, as CSV `branch,theta,u,v,r,x,y,multiplicity` (in space `branch,theta,phi,u,v,w,r,x,y,z,multiplicity`) or as a
/// JSON document of kind `samples`. Coordinates are relative to `center`. If the center is not the origin, the table begins
/// with the comment `# center X Y`, and the document has the center, too.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(crate) fn write_samples<D: NominalAngles<V>, const V: usize>(
    rays: &[SampledRay<D, V>],
    center: &[Rational],
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let is_centered = center.iter().all(Rational::is_zero);
    let center_texts = (!is_centered).then(|| center.iter().map(ToString::to_string).collect());
    let center_texts: Option<Vec<String>> = center_texts;
    match format {
        Format::Csv => {
            if let Some(center) = &center_texts {
                writeln!(out, "# center {}", center.join(" "))?;
            }
            writeln!(
                out,
                "{}",
                match V {
                    2 => "branch,theta,u,v,r,x,y,multiplicity",
                    _ => "branch,theta,phi,u,v,w,r,x,y,z,multiplicity",
                }
            )?;
            for (ray, p) in points(rays) {
                let (theta, phi) = ray.direction.angles();
                let angles = [Some(theta), phi];
                let doubles = |values: &[f64]| {
                    let written = values.iter().map(|v| format!("{v:?}"));
                    written.collect::<Vec<_>>().join(",")
                };
                let angles: Vec<f64> = angles.into_iter().flatten().collect();
                let unit = ray.direction.components().map(|u| u.to_string()).join(",");
                writeln!(
                    out,
                    "{},{},{unit},{:?},{},{}",
                    p.branch,
                    doubles(&angles),
                    p.r,
                    doubles(&p.position),
                    p.multiplicity
                )?;
            }
            Ok(())
        }
        Format::Json => {
            let document = SamplesDocument {
                schema: SCHEMA,
                kind: "samples",
                center: center_texts,
                points: points(rays).map(point).collect(),
                lines: rays
                    .iter()
                    .filter(|r| r.ray == Ray::Line)
                    .map(|ray| line(&ray.direction))
                    .collect(),
            };
            write_value(&document, out)?;
            Ok(writeln!(out)?)
        }
        _ => Err(Kind::Points.refused(format)),
    }
}

fn points<D, const V: usize>(
    rays: &[SampledRay<D, V>],
) -> impl Iterator<Item = (&SampledRay<D, V>, &Sample<V>)> {
    rays.iter().flat_map(|ray| {
        let points: &[Sample<V>] = match &ray.ray {
            Ray::Points(points) => points,
            Ray::Line => &[],
        };
        points.iter().map(move |p| (ray, p))
    })
}

fn point<D: NominalAngles<V>, const V: usize>((ray, p): (&SampledRay<D, V>, &Sample<V>)) -> Point {
    let coordinate = |i: usize| p.position.get(i).copied().map(Number);
    let needed = |i: usize| coordinate(i).invariant("a point has at least two coordinates");
    Point {
        branch: p.branch,
        direction: line(&ray.direction),
        r: Number(p.r),
        x: needed(0),
        y: needed(1),
        z: coordinate(2),
        multiplicity: p.multiplicity,
    }
}

fn line<D: NominalAngles<V>, const V: usize>(direction: &D) -> Line {
    let (theta, phi) = direction.angles();
    let mut unit = direction.components().into_iter().map(|u| u.to_string());
    let mut next = || {
        unit.next()
            .invariant("a direction has a component for every coordinate")
    };
    Line {
        theta,
        phi,
        u: next(),
        v: next(),
        w: (V > 2).then(next),
    }
}
