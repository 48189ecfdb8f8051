//! Verdicts of an inspection, point by point, as CSV, JSON and text, and as a cloud of coloured points.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::Write;

use serde::Serialize;

use super::angles::{Range, ranges, ranges_text};
use super::feet::{FootEntry, FootParts, foot_names, foot_text};
use super::json::{Number, text_of, write_value};
use super::remark::counted;
use super::{Format, Kind, SCHEMA};
use crate::error::{Error, Invariant, Result};
use crate::inspect::{
    CLASSES, Histogram, InspectedPoint, InspectionSummary, RowDistance, Section, ToleranceZone,
    Verdict,
};
use crate::verb::{DIGITS, KeptPoint, PointWriter};

/// A summary in one line of text. `number` is the name of a point's number, such as its row.
#[must_use]
pub fn summary_text(summary: &InspectionSummary, number: &str) -> String {
    let mut line = format!(
        "{}: {} inside, {} outside, ",
        counted(summary.points(), "point", "points"),
        summary.inside,
        summary.outside,
    );
    if let Some(uncertain) = summary.uncertain {
        let _ = write!(line, "{uncertain} uncertain, ");
    }
    let _ = write!(line, "{} undecided", summary.undecided);
    if summary.enclosed > 0 {
        let _ = write!(
            line,
            "; {} inside whose sphere misses the surface: a whole piece of it is in the ball",
            summary.enclosed
        );
    }
    let counts = [
        (
            summary.few_digits,
            "the distance of ",
            " is known to fewer digits than --digits says",
        ),
        (summary.not_found, "of ", " no nearest point was found"),
        (
            summary.without_foot,
            "of ",
            " no foot was found that passes the check",
        ),
    ];
    for (count, before, behind) in counts.into_iter().filter(|(count, ..)| *count > 0) {
        let points = counted(count, "point", "points");
        let _ = write!(line, "; {before}{points}{behind}");
    }
    if summary.bad > 0 {
        let _ = write!(line, "; {} rows were no points", summary.bad);
    }
    if let (Some(near), Some(far)) = (&summary.nearest, &summary.farthest) {
        let [low, high] = [near.distance.low, summary.largest];
        let _ = match summary.points() {
            1 => write!(line, "; its distance is from {low:?} to {high:?}"),
            _ if high.is_infinite() => write!(
                line,
                "; the nearest is {number} {}, at a distance of at most {:?}, and {number} {} is at a distance of at least {:?}; points of which no nearest point was found may be farther",
                near.row, near.distance.high, far.row, far.distance.low
            ),
            _ => write!(
                line,
                "; the nearest is {number} {}, at a distance of at most {:?}, and the farthest {number} {}, at a distance of at least {:?}",
                near.row, near.distance.high, far.row, far.distance.low
            ),
        };
    }
    if let Some([mean, rms, signed]) = summary.means().filter(|_| summary.points() > 1) {
        let _ = write!(
            line,
            "; ≈ {mean:.3e} on average (≈ {signed:.3e} with signs), ≈ {rms:.3e} rms"
        );
    }
    line
}

/// The words for a zone: its tolerance or limits, and the uncertainty of the points if they have one.
pub(super) fn zone_text(zone: &ToleranceZone) -> String {
    match zone.is_uncertain() {
        false => format!("tolerance {zone}"),
        true => format!("tolerance {zone}, uncertainty {}", zone.uncertainty()),
    }
}

/// Writes the inspected points one after the other.
#[derive(Clone, Debug)]
pub struct InspectionWriter {
    format: Format,
    dimension: usize,
    digits: u32,
    /// The names of the columns that are carried along.
    kept: Option<Vec<String>>,
    /// Whether the feet are written.
    with_feet: bool,
}

#[derive(Serialize)]
struct Head<'a> {
    schema: &'static str,
    kind: &'static str,
    tolerance: Limits,
    #[serde(skip_serializing_if = "Option::is_none")]
    uncertainty: Option<&'a str>,
}

/// A tolerance, or two limits.
#[derive(Serialize)]
#[serde(untagged)]
enum Limits {
    One(String),
    Two([String; 2]),
}

impl From<&ToleranceZone> for Limits {
    fn from(zone: &ToleranceZone) -> Self {
        match zone.tolerance() {
            Some(tolerance) => Self::One(tolerance.to_string()),
            None => Self::Two(zone.limits().map(ToString::to_string)),
        }
    }
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
    sign: Option<i8>,
    #[serde(skip_serializing_if = "Option::is_none")]
    foot: Option<FootEntry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ranges: Option<Vec<Range>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    kept: Option<BTreeMap<&'a str, &'a str>>,
}

#[derive(Serialize)]
struct Tail {
    inside: usize,
    outside: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    uncertain: Option<usize>,
    undecided: usize,
    enclosed: usize,
    bad: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    nearest: Option<At>,
    #[serde(skip_serializing_if = "Option::is_none")]
    farthest: Option<At>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mean: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mean_signed: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rms: Option<Number>,
    histogram: Classes,
}

/// A point of a table and the bounds of its distance.
#[derive(Serialize)]
struct At {
    row: usize,
    distance_low: Number,
    distance_high: Number,
}

/// The signed distances in classes.
#[derive(Serialize)]
struct Classes {
    below: usize,
    within: [usize; CLASSES],
    above: usize,
}

impl From<RowDistance> for At {
    fn from(at: RowDistance) -> Self {
        Self {
            row: at.row,
            distance_low: Number(at.distance.low),
            distance_high: Number(at.distance.high),
        }
    }
}

impl From<&InspectionSummary> for Tail {
    fn from(summary: &InspectionSummary) -> Self {
        let mean = |i: usize| summary.means().map(|means| Number(means[i]));
        let Histogram {
            below,
            within,
            above,
        } = summary.histogram;
        Self {
            inside: summary.inside,
            outside: summary.outside,
            uncertain: summary.uncertain,
            undecided: summary.undecided,
            enclosed: summary.enclosed,
            bad: summary.bad,
            nearest: summary.nearest.map(At::from),
            farthest: summary.farthest.map(At::from),
            mean: mean(0),
            rms: mean(1),
            mean_signed: mean(2),
            histogram: Classes {
                below,
                within,
                above,
            },
        }
    }
}

impl InspectionWriter {
    /// A writer for points with two or three coordinates; angles have `digits` decimals.
    ///
    /// # Errors
    /// Those of [`Kind::check`].
    pub fn new(format: Format, dimension: usize, digits: u32) -> Result<Self> {
        Kind::Verdicts.check(format)?;
        DIGITS.check(digits)?;
        Ok(Self {
            format,
            dimension,
            digits,
            kept: None,
            with_feet: false,
        })
    }

    /// Carries the other columns of a table along, whose names these are: behind the others in CSV, in `kept` in JSON. The names in
    /// either must differ, or the first thing that is written is an error.
    #[must_use]
    pub fn keeping(self, names: impl IntoIterator<Item = String>) -> Self {
        Self {
            kept: Some(names.into_iter().collect()),
            ..self
        }
    }

    /// Writes the feet: the nearest point of the form, the normal there, and bounds of the signed distance, in columns behind the
    /// sign in CSV, in `foot` in JSON.
    #[must_use]
    pub fn with_feet(self) -> Self {
        Self {
            with_feet: true,
            ..self
        }
    }

    /// Writes fields of CSV, each behind a comma.
    fn write_fields<'f>(fields: impl Iterator<Item = &'f str>, out: &mut dyn Write) -> Result<()> {
        for field in fields {
            match field.contains([',', '"']) {
                true => write!(out, ",\"{}\"", field.replace('"', "\"\""))?,
                false => write!(out, ",{field}")?,
            }
        }
        Ok(())
    }

    /// The names of the columns of CSV.
    fn columns(&self) -> Vec<String> {
        let axes = &["x", "y", "z"][..self.dimension];
        let found = ["verdict", "curve", "distance_low", "distance_high", "sign"];
        let mut names: Vec<String> = axes.iter().chain(&found).map(|&name| name.into()).collect();
        if self.with_feet {
            names.extend(foot_names(self.dimension));
        }
        names.extend(self.kept.iter().flatten().cloned());
        names
    }

    /// Columns and fields of JSON are found by their names.
    ///
    /// # Errors
    /// [`Error::Usage`] if two of the names are the same.
    fn check_names<'n>(names: impl IntoIterator<Item = &'n String>) -> Result<()> {
        let mut known = BTreeSet::new();
        match names.into_iter().find(|name| !known.insert(*name)) {
            Some(twice) => Err(Error::Usage(format!(
                "two columns of the result would be called {twice:?}, because --keep carries columns along with their names; rename \
                 the one in the table"
            ))),
            None => Ok(()),
        }
    }

    /// The columns that are carried along, with the fields of a point.
    fn kept<'p>(&'p self, point: &'p InspectedPoint<'_>) -> Option<BTreeMap<&'p str, &'p str>> {
        let names = self.kept.as_ref()?.iter().map(String::as_str);
        Some(names.zip(point.others.iter().copied()).collect())
    }
}

impl PointWriter for InspectionWriter {
    fn begin(&self, zone: &ToleranceZone, out: &mut dyn Write) -> Result<()> {
        match self.format {
            Format::Json => {
                Self::check_names(self.kept.iter().flatten())?;
                let uncertainty = zone.uncertainty().to_string();
                let head = Head {
                    schema: SCHEMA,
                    kind: "inspection",
                    tolerance: Limits::from(zone),
                    uncertainty: zone.is_uncertain().then_some(&uncertainty),
                };
                let head = text_of(&head);
                Ok(write!(out, "{},\"points\":[", head.trim_end_matches('}'))?)
            }
            Format::Text => Ok(()),
            _ => {
                let names = self.columns();
                Self::check_names(&names)?;
                let (first, rest) = names.split_first().invariant("points have coordinates");
                write!(out, "{first}")?;
                Self::write_fields(rest.iter().map(String::as_str), out)?;
                Ok(writeln!(out)?)
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
                    sign: found.sign,
                    foot: self
                        .with_feet
                        .then(|| FootParts::of(point, self.dimension).into()),
                    ranges: match &point.section {
                        Section::At(list) => Some(ranges(list, self.digits)),
                        Section::NotAsked | Section::TooLong => None,
                    },
                    kept: self.kept(point),
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
                let side = match found.sign {
                    Some(-1) => ", on the inner side",
                    Some(1) => ", on the outer side",
                    _ => "",
                };
                writeln!(out, "({at}): {verdict}; {distance}{side}")?;
                let round = if self.dimension == 2 {
                    "circle"
                } else {
                    "sphere"
                };
                if let Some(foot) = point.foot.filter(|_| self.with_feet) {
                    writeln!(out, "  {}", foot_text(&foot, self.dimension))?;
                }
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
                write!(out, "{verdict},{curve},{low:?},{high:?},")?;
                if let Some(sign) = found.sign {
                    write!(out, "{sign}")?;
                }
                if self.with_feet {
                    let fields = FootParts::of(point, self.dimension).fields(self.dimension);
                    Self::write_fields(fields.iter().map(String::as_str), out)?;
                }
                if self.kept.is_some() {
                    Self::write_fields(point.others.iter().copied(), out)?;
                }
                Ok(writeln!(out)?)
            }
        }
    }

    fn end(&self, summary: &InspectionSummary, out: &mut dyn Write) -> Result<()> {
        if self.format == Format::Json {
            let tail = Tail::from(summary);
            writeln!(out, "\n],\"summary\":{}}}", text_of(&tail))?;
        }
        Ok(())
    }
}

/// Writes points as a binary PLY cloud with the properties `distance_low` and `distance_high` and with the colour of the
/// verdict: green for inside, red for outside, blue for uncertain, grey for undecided.
///
/// # Errors
/// Those of `out`.
pub fn write_inspection_cloud(
    points: &[KeptPoint],
    zone: &ToleranceZone,
    out: &mut dyn Write,
) -> Result<()> {
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment stellate inspect, {}\nelement vertex {}\n",
        zone_text(zone),
        points.len()
    )?;
    for name in ["x", "y", "z", "distance_low", "distance_high"] {
        writeln!(out, "property double {name}")?;
    }
    for name in ["red", "green", "blue"] {
        writeln!(out, "property uchar {name}")?;
    }
    out.write_all(b"end_header\n")?;
    for kept in points {
        let (point, found) = (&kept.point, &kept.inspection);
        let distances = [found.distance.low, found.distance.high];
        for value in point.iter().chain(&distances) {
            out.write_all(&value.to_le_bytes())?;
        }
        out.write_all(&match found.verdict {
            Verdict::Inside => [0, 120, 90],
            Verdict::Outside => [213, 94, 0],
            Verdict::Uncertain => [0, 114, 178],
            Verdict::Undecided => [120, 120, 120],
        })?;
    }
    Ok(())
}
