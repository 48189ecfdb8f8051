//! Certified points as CSV and JSON.

use std::io::{self, Write};

use serde::Serialize;

use super::{Format, SCHEMA, center_comment};
use crate::exact::Rational;
use crate::sample::{Direction, Ray, Sample};

/// A direction and what the curve has in it.
#[derive(Clone, Debug)]
pub struct SampledRay {
    /// The direction.
    pub direction: Direction,
    /// The points, or the whole line.
    pub ray: Ray,
}

#[derive(Serialize)]
struct Point {
    branch: usize,
    theta: f64,
    u: String,
    v: String,
    r: f64,
    x: f64,
    y: f64,
    multiplicity: usize,
}

#[derive(Serialize)]
struct Line {
    theta: f64,
    u: String,
    v: String,
}

#[derive(Serialize)]
struct Document {
    schema: &'static str,
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    center: Option<[String; 2]>,
    points: Vec<Point>,
    lines: Vec<Line>,
}

/// Writes points as CSV `branch,theta,u,v,r,x,y,multiplicity` or as a JSON document of kind
/// `samples`. Coordinates are relative to `center`.
///
/// # Errors
/// Those of `out`; `Unsupported` for other formats.
pub fn write_samples(
    rays: &[SampledRay],
    center: &[Rational; 2],
    format: Format,
    out: &mut dyn Write,
) -> io::Result<()> {
    match format {
        Format::Csv | Format::Text => {
            if let Some(comment) = center_comment(center) {
                writeln!(out, "# {comment}")?;
            }
            writeln!(out, "branch,theta,u,v,r,x,y,multiplicity")?;
            for (ray, p) in points(rays) {
                let d = &ray.direction;
                writeln!(
                    out,
                    "{},{:?},{},{},{:?},{:?},{:?},{}",
                    p.branch,
                    d.theta(),
                    d.u(),
                    d.v(),
                    p.r,
                    p.x,
                    p.y,
                    p.multiplicity
                )?;
            }
            Ok(())
        }
        Format::Json => {
            let document = Document {
                schema: SCHEMA,
                kind: "samples",
                center: center_comment(center).map(|_| center.each_ref().map(ToString::to_string)),
                points: points(rays).map(point).collect(),
                lines: rays
                    .iter()
                    .filter(|r| r.ray == Ray::Line)
                    .map(line)
                    .collect(),
            };
            serde_json::to_writer(&mut *out, &document)?;
            writeln!(out)
        }
        _ => Err(io::Error::new(
            io::ErrorKind::Unsupported,
            "points are written as csv or json",
        )),
    }
}

fn points(rays: &[SampledRay]) -> impl Iterator<Item = (&SampledRay, &Sample)> {
    rays.iter().flat_map(|ray| {
        let points: &[Sample] = match &ray.ray {
            Ray::Points(points) => points,
            Ray::Line => &[],
        };
        points.iter().map(move |p| (ray, p))
    })
}

fn point((ray, p): (&SampledRay, &Sample)) -> Point {
    Point {
        branch: p.branch,
        theta: ray.direction.theta(),
        u: ray.direction.u().to_string(),
        v: ray.direction.v().to_string(),
        r: p.r,
        x: p.x,
        y: p.y,
        multiplicity: p.multiplicity,
    }
}

fn line(ray: &SampledRay) -> Line {
    Line {
        theta: ray.direction.theta(),
        u: ray.direction.u().to_string(),
        v: ray.direction.v().to_string(),
    }
}
