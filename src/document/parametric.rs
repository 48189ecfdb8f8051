//! Parametric documents: the branches r(θ) of an implicit curve.

use std::io::{self, Write};

use serde::Serialize;

use super::expression::expression_text;
use super::fourier::expression;
use super::rational::{self, Entry};
use super::{Format, SCHEMA, center_comment};
use crate::exact::Rational;
use crate::parametrize::{AngleRange, Branch, ExactAngle, Parametrization, PolarMethod, Radius};

#[derive(Serialize)]
struct Document {
    schema: &'static str,
    kind: &'static str,
    parameters: [&'static str; 1],
    method: String,
    step: usize,
    lines: Vec<Angle>,
    #[serde(skip_serializing_if = "Option::is_none")]
    center: Option<[String; 2]>,
    branches: Vec<BranchEntry>,
    rational: Vec<Entry>,
    notes: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    superquadric: Option<super::superquadric::Document>,
}

#[derive(Serialize)]
struct Angle {
    theta: String,
    exact: String,
}

#[derive(Serialize)]
struct BranchEntry {
    factor: usize,
    radius: String,
    latex: String,
    sympy: String,
    coordinates: Coordinates,
    #[serde(skip_serializing_if = "Option::is_none")]
    fourier: Option<Fourier>,
    ranges: Vec<Range>,
    positive: Vec<Range>,
}

#[derive(Serialize)]
struct Coordinates {
    x: String,
    y: String,
}

#[derive(Serialize)]
struct Fourier {
    cos: Vec<String>,
    sin: Vec<String>,
}

#[derive(Serialize)]
pub(super) struct Range {
    from: String,
    to: String,
    closed: [bool; 2],
    exact_from: String,
    exact_to: String,
    #[serde(skip)]
    nice: [Option<String>; 2],
}

impl Range {
    pub(super) fn new(range: &AngleRange, digits: u32) -> Self {
        Self {
            from: range.from.to_decimal(digits),
            to: range.to.to_decimal(digits),
            closed: range.closed,
            exact_from: range.from.describe(),
            exact_to: range.to.describe(),
            nice: [range.from.closed_form(), range.to.closed_form()],
        }
    }

    /// `[0, pi/2)`, exact where the end has a closed form.
    pub(super) fn text(&self) -> String {
        let [from, to] = self.closed;
        let end = |nice: &Option<String>, decimal: &String| {
            nice.clone().unwrap_or_else(|| decimal.clone())
        };
        format!(
            "{}{}, {}{}",
            if from { '[' } else { '(' },
            end(&self.nice[0], &self.from),
            end(&self.nice[1], &self.to),
            if to { ']' } else { ')' }
        )
    }
}

/// Ranges as one phrase: `theta in [0, pi/2) and (3*pi/2, 2*pi]`, or `no angle`.
pub(super) fn ranges_text(ranges: &[Range]) -> String {
    if ranges.is_empty() {
        return "no angle".into();
    }
    let parts: Vec<String> = ranges.iter().map(Range::text).collect();
    format!("theta in {}", parts.join(" and "))
}

/// Writes the polar form of a curve: expressions for r, x and y of every branch, where r is real and
/// where it is positive to `digits` decimals, the lines through the origin, and exact Fourier coefficients
/// where a radius is a series.
///
/// Text starts with comments; the first branch is a formula `r = …`, which can be read back if it is a
/// series.
///
/// # Errors
/// Those of `out`; `Unsupported` for Singular, and for CSV unless the first radius is a series.
pub fn write_parametrization(
    curve: &Parametrization,
    digits: u32,
    format: Format,
    out: &mut dyn Write,
) -> io::Result<()> {
    let series = curve
        .branches
        .first()
        .and_then(|branch| match &branch.radius {
            Radius::Fourier(radius) => Some(radius),
            Radius::Closed(_) | Radius::Root(_) => None,
        });
    match (format, series) {
        (Format::Json, _) => {
            serde_json::to_writer(&mut *out, &document(curve, digits))?;
            writeln!(out)
        }
        (Format::Text, _) => write_text(curve, digits, out),
        // The other branch of a series, −r(θ + π), has the same points.
        (_, Some(radius)) => super::write_fourier(radius, None, format, out),
        (Format::Latex | Format::Sympy | Format::Maple, None) => {
            for branch in &curve.branches {
                let radius = radius_text(&branch.radius, format);
                match format {
                    Format::Sympy => writeln!(out, "{radius}")?,
                    Format::Maple => writeln!(out, "r = {radius};")?,
                    _ => writeln!(out, "r = {radius}")?,
                }
            }
            write_rational(curve, format, out)
        }
        (Format::Csv | Format::Singular, None) => Err(io::Error::new(
            io::ErrorKind::Unsupported,
            "only a radius that is a Fourier series is written as csv",
        )),
    }
}

fn document(curve: &Parametrization, digits: u32) -> Document {
    Document {
        schema: SCHEMA,
        kind: "parametric",
        parameters: ["theta"],
        method: method(curve),
        step: curve.step,
        lines: curve.lines.iter().map(|line| angle(line, digits)).collect(),
        center: center_comment(&curve.center)
            .map(|_| curve.center.each_ref().map(ToString::to_string)),
        branches: curve
            .branches
            .iter()
            .map(|b| entry(b, &curve.center, digits))
            .collect(),
        rational: curve
            .rational
            .iter()
            .map(|r| Entry::new(r, &curve.center))
            .collect(),
        notes: curve.notes.clone(),
        superquadric: curve
            .superquadric
            .as_ref()
            .map(super::superquadric::Document::new),
    }
}

fn method(curve: &Parametrization) -> String {
    match curve.method {
        PolarMethod::Lines => "lines".into(),
        PolarMethod::Lemma(n) => format!("lemma-{n}"),
        PolarMethod::Factors => "factors".into(),
        PolarMethod::Numeric => "lemma-6".into(),
    }
}

fn angle(angle: &ExactAngle, digits: u32) -> Angle {
    Angle {
        theta: angle.to_decimal(digits),
        exact: angle.describe(),
    }
}

fn ranges(list: &[AngleRange], digits: u32) -> Vec<Range> {
    list.iter().map(|range| Range::new(range, digits)).collect()
}

fn write_text(curve: &Parametrization, digits: u32, out: &mut dyn Write) -> io::Result<()> {
    let step = if curve.step > 1 {
        format!(" in r^{}", curve.step)
    } else {
        String::new()
    };
    writeln!(out, "# {}{step}", method(curve))?;
    if let Some(comment) = center_comment(&curve.center) {
        writeln!(out, "# {comment}")?;
    }
    for line in &curve.lines {
        let line = angle(line, digits);
        writeln!(
            out,
            "# the line at theta = {} = {} belongs to the curve",
            line.exact, line.theta
        )?;
    }
    for note in &curve.notes {
        writeln!(out, "# note: {note}")?;
    }
    for (index, branch) in curve.branches.iter().enumerate() {
        let real = ranges_text(&ranges(&branch.real, digits));
        let positive = ranges_text(&ranges(&branch.positive, digits));
        writeln!(
            out,
            "# branch {index}: r real for {real}; r > 0 for {positive}"
        )?;
        let hidden = if index > 0 { "# " } else { "" };
        writeln!(
            out,
            "{hidden}r = {}",
            radius_text(&branch.radius, Format::Text)
        )?;
    }
    write_rational(curve, Format::Text, out)
}

/// What is known of rational parametrizations, as comments.
fn write_rational(curve: &Parametrization, format: Format, out: &mut dyn Write) -> io::Result<()> {
    let comments = curve
        .rational
        .iter()
        .filter_map(|r| rational::comment(r, &curve.center, format));
    for comment in comments {
        writeln!(out, "{} {comment}", format.comment())?;
    }
    Ok(())
}

fn radius_text(radius: &Radius, format: Format) -> String {
    match radius {
        Radius::Fourier(radius) => expression(radius, format, "theta"),
        Radius::Closed(closed) => expression_text(closed, format),
        Radius::Root(_) => "ROOT".into(),
    }
}

fn entry(branch: &Branch, center: &[Rational; 2], digits: u32) -> BranchEntry {
    let sympy = radius_text(&branch.radius, Format::Sympy);
    let [cx, cy] = center.each_ref().map(|c| {
        if c.is_zero() {
            String::new()
        } else {
            format!("Rational({}, {}) + ", c.numerator(), c.denominator())
        }
    });
    let strings = |v: &[Rational]| v.iter().map(ToString::to_string).collect();
    BranchEntry {
        factor: branch.factor,
        radius: radius_text(&branch.radius, Format::Text),
        latex: radius_text(&branch.radius, Format::Latex),
        coordinates: Coordinates {
            x: format!("{cx}({sympy})*cos(theta)"),
            y: format!("{cy}({sympy})*sin(theta)"),
        },
        sympy,
        fourier: match &branch.radius {
            Radius::Fourier(radius) => Some(Fourier {
                cos: strings(radius.cosines()),
                sin: strings(radius.sines()),
            }),
            Radius::Closed(_) | Radius::Root(_) => None,
        },
        ranges: ranges(&branch.real, digits),
        positive: ranges(&branch.positive, digits),
    }
}
