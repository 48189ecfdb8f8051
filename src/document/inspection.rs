//! Verdicts of an inspection, point by point, as CSV, JSON and text, and as a cloud of coloured points.

use std::fmt::Write as _;
use std::io::Write;

use serde::Serialize;

use super::angles::{Range, ranges, ranges_text};
use super::json::{Number, text_of, write_value};
use super::{Format, Kind, SCHEMA};
use crate::error::Result;
use crate::exact::Rational;
use crate::inspect::{InspectedPoint, Inspection, InspectionSummary, Section, Verdict};
use crate::verb::PointWriter;

/// A summary in one line of text. `number` is the name of a point's number, such as its row.
#[must_use]
pub fn summary_text(summary: &InspectionSummary, number: &str) -> String {
    let count = summary.points();
    let mut line = format!(
        "{count} {}: {} inside, {} outside, {} undecided",
        if count == 1 { "point" } else { "points" },
        summary.inside,
        summary.outside,
        summary.undecided
    );
    if summary.enclosed > 0 {
        let _ = write!(
            line,
            "; {} inside whose sphere misses the surface: a whole piece of it is in the ball",
            summary.enclosed
        );
    }
    if summary.bad > 0 {
        let _ = write!(line, "; {} rows were no points", summary.bad);
    }
    if let Some((row, low)) = summary.worst {
        let _ = write!(
            line,
            "; the farthest is {number} {row}, at a distance of at least {low:?}"
        );
    }
    line
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
    /// A writer for points with two or three coordinates; angles have `digits` decimals.
    ///
    /// # Errors
    /// Those of [`Kind::check`].
    pub fn new(format: Format, dimension: usize, digits: u32) -> Result<Self> {
        Kind::Verdicts.check(format)?;
        Ok(Self {
            format,
            dimension,
            digits,
        })
    }
}

impl PointWriter for InspectionWriter {
    fn begin(&self, tolerance: &Rational, out: &mut dyn Write) -> Result<()> {
        match self.format {
            Format::Json => {
                let head = Head {
                    schema: SCHEMA,
                    kind: "inspection",
                    tolerance: &tolerance.to_string(),
                };
                let head = text_of(&head);
                Ok(write!(out, "{},\"points\":[", head.trim_end_matches('}'))?)
            }
            Format::Text => Ok(()),
            _ => {
                let axes = if self.dimension == 2 { "x,y" } else { "x,y,z" };
                Ok(writeln!(
                    out,
                    "{axes},verdict,curve,distance_low,distance_high"
                )?)
            }
        }
    }

    fn between(&self) -> &[u8] {
        match self.format {
            Format::Json => b",",
            _ => b"",
        }
    }

    fn point(&self, point: &InspectedPoint<'_>, out: &mut dyn Write) -> Result<()> {
        let found = &point.inspection;
        let verdict = found.verdict.name();
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
                    ranges: match &point.section {
                        Section::At(list) => Some(ranges(list, self.digits)),
                        Section::NotAsked | Section::TooLong => None,
                    },
                };
                out.write_all(b"\n")?;
                write_value(&entry, out)?;
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
                match &point.section {
                    Section::At(list) if !list.is_empty() => {
                        let list = ranges(list, self.digits);
                        Ok(writeln!(out, "  at {}", ranges_text(&list))?)
                    }
                    Section::TooLong if found.curve == Some(true) => {
                        Ok(writeln!(out, "  (the angles would take too long)")?)
                    }
                    _ => Ok(()),
                }
            }
            _ => {
                for coordinate in point.written {
                    out.write_all(coordinate.as_bytes())?;
                    out.write_all(b",")?;
                }
                Ok(writeln!(out, "{verdict},{curve},{low:?},{high:?}")?)
            }
        }
    }

    fn end(&self, summary: &InspectionSummary, out: &mut dyn Write) -> Result<()> {
        if self.format == Format::Json {
            let tail = Tail {
                inside: summary.inside,
                outside: summary.outside,
                undecided: summary.undecided,
                enclosed: summary.enclosed,
                bad: summary.bad,
            };
            writeln!(out, "\n],\"summary\":{}}}", text_of(&tail))?;
        }
        Ok(())
    }
}

/// Writes points as a binary PLY cloud with the properties `distance_low` and `distance_high` and with the colour of the
/// verdict: green for inside, red for outside, grey for undecided.
///
/// # Errors
/// Those of `out`.
pub fn write_inspection_cloud(
    points: &[([f64; 3], Inspection)],
    comment: &str,
    out: &mut dyn Write,
) -> Result<()> {
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
