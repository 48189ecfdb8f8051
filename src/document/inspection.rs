//! Verdicts of an inspection as CSV, JSON and text, point by point; and as a cloud of coloured points.

use std::fmt::Write as _;
use std::io::{self, Write};

use serde::Serialize;

use super::angles::{Range, ranges, ranges_text};
use super::json::Number;
use super::{Format, SCHEMA};
use crate::exact::Rational;
use crate::inspect::{Inspection, Verdict};
use crate::parametrize::AngleRange;

/// A point as it was given, and what is certain of it.
#[derive(Clone, Debug)]
pub struct InspectedPoint<'a> {
    /// Its coordinates as written, two or three.
    pub written: &'a [&'a str],
    /// The verdict and the distance.
    pub inspection: Inspection,
    /// Where the section of Theorem 8 is real, if that was asked.
    pub ranges: Option<Vec<AngleRange>>,
}

/// How many points have which verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InspectionSummary {
    /// Within the tolerance.
    pub inside: usize,
    /// Farther away.
    pub outside: usize,
    /// Neither could be proved.
    pub undecided: usize,
    /// Inside, but the sphere about the point misses the surface: a whole piece of it is inside the ball.
    pub enclosed: usize,
    /// Rows that are no points, and were passed over.
    pub bad: usize,
    /// The row, from 1, and the distance of the farthest point: at least so much.
    pub worst: Option<(usize, f64)>,
}

impl InspectionSummary {
    /// Counts one more point.
    pub fn add(&mut self, row: usize, found: &Inspection) {
        match found.verdict {
            Verdict::Inside => self.inside += 1,
            Verdict::Outside => self.outside += 1,
            Verdict::Undecided => self.undecided += 1,
        }
        if found.verdict == Verdict::Inside && found.curve == Some(false) {
            self.enclosed += 1;
        }
        if self.worst.is_none_or(|(_, low)| found.distance.low > low) {
            self.worst = Some((row, found.distance.low));
        }
    }

    /// Counts what comes after.
    pub fn join(&mut self, later: &Self) {
        self.inside += later.inside;
        self.outside += later.outside;
        self.undecided += later.undecided;
        self.enclosed += later.enclosed;
        self.bad += later.bad;
        if let Some((row, low)) = later.worst
            && self.worst.is_none_or(|(_, known)| low > known)
        {
            self.worst = Some((row, low));
        }
    }

    /// All points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.inside + self.outside + self.undecided
    }

    /// One line for people; points are numbered by `number`: their row, or which point of those given.
    #[must_use]
    pub fn text(&self, number: &str) -> String {
        let count = self.points();
        let mut line = format!(
            "{count} {}: {} inside, {} outside, {} undecided",
            if count == 1 { "point" } else { "points" },
            self.inside,
            self.outside,
            self.undecided
        );
        if self.enclosed > 0 {
            let _ = write!(
                line,
                "; {} inside whose sphere misses the surface: a whole piece of it is in the ball",
                self.enclosed
            );
        }
        if self.bad > 0 {
            let _ = write!(line, "; {} rows were no points", self.bad);
        }
        if let Some((row, low)) = self.worst {
            let _ = write!(
                line,
                "; the farthest is {number} {row}, at a distance of at least {low:?}"
            );
        }
        line
    }
}

/// Writes the inspected points one after the other.
#[derive(Clone, Debug)]
pub struct InspectionWriter {
    format: Format,
    dimension: usize,
    digits: u32,
}

#[derive(Serialize)]
struct Head<'a> {
    schema: &'static str,
    kind: &'static str,
    tolerance: &'a str,
}

#[derive(Serialize)]
struct Entry<'a> {
    x: &'a str,
    y: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    z: Option<&'a str>,
    verdict: &'static str,
    curve: Option<bool>,
    distance_low: Number,
    distance_high: Number,
    #[serde(skip_serializing_if = "Option::is_none")]
    ranges: Option<Vec<Range>>,
}

#[derive(Serialize)]
struct Tail {
    inside: usize,
    outside: usize,
    undecided: usize,
    enclosed: usize,
    bad: usize,
}

impl InspectionWriter {
    /// For points with two or three coordinates; `digits` decimals of the angles.
    ///
    /// # Errors
    /// [`crate::error::Error::Usage`] for a format other than csv, json and text.
    pub fn new(format: Format, dimension: usize, digits: u32) -> crate::error::Result<Self> {
        match format {
            Format::Csv | Format::Json | Format::Text => Ok(Self {
                format,
                dimension,
                digits,
            }),
            _ => Err(crate::error::Error::Usage(format!(
                "--format {format}: verdicts are written as csv, json or text"
            ))),
        }
    }

    /// What comes before the first point.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn begin(&self, tolerance: &Rational, out: &mut dyn Write) -> io::Result<()> {
        match self.format {
            Format::Json => {
                let head = Head {
                    schema: SCHEMA,
                    kind: "inspection",
                    tolerance: &tolerance.to_string(),
                };
                let head = serde_json::to_string(&head)?;
                write!(out, "{},\"points\":[", head.trim_end_matches('}'))
            }
            Format::Text => Ok(()),
            _ => {
                let axes = if self.dimension == 2 { "x,y" } else { "x,y,z" };
                writeln!(out, "{axes},verdict,curve,distance_low,distance_high")
            }
        }
    }

    /// One point; `is_first` of all.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn point(
        &self,
        point: &InspectedPoint,
        is_first: bool,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let found = &point.inspection;
        let verdict = verdict_name(found.verdict);
        let curve = match found.curve {
            Some(true) => "true",
            Some(false) => "false",
            None => "undecided",
        };
        let [low, high] = [found.distance.low, found.distance.high];
        match self.format {
            Format::Json => {
                let entry = Entry {
                    x: point.written[0],
                    y: point.written[1],
                    z: point.written.get(2).copied(),
                    verdict,
                    curve: found.curve,
                    distance_low: Number(low),
                    distance_high: Number(high),
                    ranges: point.ranges.as_ref().map(|list| ranges(list, self.digits)),
                };
                out.write_all(if is_first { b"\n" } else { b",\n" })?;
                serde_json::to_writer(out, &entry)?;
                Ok(())
            }
            Format::Text => {
                let at = point.written.join(", ");
                let distance = if high <= 0.0 {
                    "it lies on the form".into()
                } else if high.is_finite() {
                    format!("its distance is at least {low:?} and at most {high:?}")
                } else {
                    format!("its distance is at least {low:?}")
                };
                writeln!(out, "({at}): {verdict}; {distance}")?;
                let round = if self.dimension == 2 {
                    "circle"
                } else {
                    "sphere"
                };
                match found.curve {
                    Some(true) => writeln!(out, "  the {round} about it meets the form")?,
                    Some(false) => writeln!(out, "  the {round} about it does not meet the form")?,
                    None => writeln!(
                        out,
                        "  whether the {round} about it meets the form is undecided"
                    )?,
                }
                match &point.ranges {
                    Some(list) if !list.is_empty() => {
                        let list = ranges(list, self.digits);
                        writeln!(out, "  at {}", ranges_text(&list))
                    }
                    None if found.curve == Some(true) => {
                        writeln!(out, "  (the angles would take too long)")
                    }
                    _ => Ok(()),
                }
            }
            _ => {
                for coordinate in point.written {
                    out.write_all(coordinate.as_bytes())?;
                    out.write_all(b",")?;
                }
                writeln!(out, "{verdict},{curve},{low:?},{high:?}")
            }
        }
    }

    /// What comes after the last point.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn end(&self, summary: &InspectionSummary, out: &mut dyn Write) -> io::Result<()> {
        if self.format == Format::Json {
            let tail = Tail {
                inside: summary.inside,
                outside: summary.outside,
                undecided: summary.undecided,
                enclosed: summary.enclosed,
                bad: summary.bad,
            };
            writeln!(out, "\n],\"summary\":{}}}", serde_json::to_string(&tail)?)?;
        }
        Ok(())
    }
}

/// The name that documents use.
fn verdict_name(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Inside => "inside",
        Verdict::Outside => "outside",
        Verdict::Undecided => "undecided",
    }
}

/// Writes points as a binary PLY cloud, with `distance_low` and `distance_high` and the colour of the verdict: green inside,
/// red outside, grey undecided.
///
/// # Errors
/// Those of `out`.
pub fn write_inspection_cloud(
    points: &[([f64; 3], Inspection)],
    comment: &str,
    out: &mut dyn Write,
) -> io::Result<()> {
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment {comment}\nelement vertex {}\n",
        points.len()
    )?;
    for name in ["x", "y", "z", "distance_low", "distance_high"] {
        writeln!(out, "property double {name}")?;
    }
    for name in ["red", "green", "blue"] {
        writeln!(out, "property uchar {name}")?;
    }
    out.write_all(b"end_header\n")?;
    for (point, found) in points {
        let distances = [found.distance.low, found.distance.high];
        for value in point.iter().chain(&distances) {
            out.write_all(&value.to_le_bytes())?;
        }
        out.write_all(&match found.verdict {
            Verdict::Inside => [0, 120, 90],
            Verdict::Outside => [213, 94, 0],
            Verdict::Undecided => [120, 120, 120],
        })?;
    }
    Ok(())
}
