//! Parametric documents: the branches r(θ) of an implicit curve.

use std::io::{self, Write};

use serde::Serialize;

use super::fourier::expression;
use super::{Format, SCHEMA, center_comment};
use crate::parametrize::{AngleRange, FourierBranches, positive_ranges};
use crate::shape::FourierRadius;

#[derive(Serialize)]
struct Document {
    schema: &'static str,
    kind: &'static str,
    parameters: [&'static str; 1],
    method: String,
    step: usize,
    lines: [String; 0],
    #[serde(skip_serializing_if = "Option::is_none")]
    center: Option<[String; 2]>,
    branches: Vec<Branch>,
}

#[derive(Serialize)]
struct Branch {
    factor: usize,
    radius: String,
    latex: String,
    sympy: String,
    coordinates: Coordinates,
    fourier: Fourier,
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
    #[serde(skip_serializing_if = "Option::is_none")]
    exact_from: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    exact_to: Option<String>,
}

impl Range {
    pub(super) fn new(range: &AngleRange, digits: u32) -> Self {
        Self {
            from: range.from.to_decimal(digits),
            to: range.to.to_decimal(digits),
            closed: range.closed,
            exact_from: range.from.describe(),
            exact_to: range.to.describe(),
        }
    }

    /// `[0, pi/2)`, exact where the end is a multiple of π.
    pub(super) fn text(&self) -> String {
        let [from, to] = self.closed;
        let end = |exact: &Option<String>, decimal: &String| {
            exact.clone().unwrap_or_else(|| decimal.clone())
        };
        format!(
            "{}{}, {}{}",
            if from { '[' } else { '(' },
            end(&self.exact_from, &self.from),
            end(&self.exact_to, &self.to),
            if to { ']' } else { ')' }
        )
    }
}

/// Ranges as one phrase: `[0, pi/2) and (3*pi/2, 2*pi]`, or `nowhere`.
pub(super) fn ranges_text(ranges: &[Range]) -> String {
    if ranges.is_empty() {
        return "nowhere".into();
    }
    ranges
        .iter()
        .map(Range::text)
        .collect::<Vec<_>>()
        .join(" and ")
}

/// Writes the branches of a curve that is born of a Fourier radius: expressions for r, x and y, the
/// exact coefficients, and where r is real (everywhere) and positive, to `digits` decimals.
///
/// Text is a formula that can be read back: the first branch, with the others in comments.
///
/// # Errors
/// Those of `out`; `Unsupported` for a format that [`Format::check_fourier`] refuses.
pub fn write_branches(
    branches: &FourierBranches,
    digits: u32,
    format: Format,
    out: &mut dyn Write,
) -> io::Result<()> {
    match (format, &branches.radii[..]) {
        (Format::Json, radii) => {
            let center = radii.first().map(FourierRadius::center);
            let document = Document {
                schema: SCHEMA,
                kind: "parametric",
                parameters: ["theta"],
                method: format!("lemma-{}", branches.lemma),
                step: branches.step,
                lines: [],
                center: center
                    .filter(|c| center_comment(c).is_some())
                    .map(|[x, y]| [x.to_string(), y.to_string()]),
                branches: radii.iter().map(|r| branch(r, digits)).collect(),
            };
            serde_json::to_writer(&mut *out, &document)?;
            writeln!(out)
        }
        (Format::Text, [first, others @ ..]) => {
            writeln!(
                out,
                "# lemma-{}: the radius is exactly a Fourier series",
                branches.lemma
            )?;
            let positive = |r| {
                let ranges: Vec<Range> = positive_ranges(r)
                    .iter()
                    .map(|r| Range::new(r, digits))
                    .collect();
                ranges_text(&ranges)
            };
            writeln!(out, "# branch 0, r > 0 for t in {}", positive(first))?;
            super::write_fourier(first, None, format, out)?;
            for (index, radius) in others.iter().enumerate() {
                writeln!(
                    out,
                    "# branch {}, r > 0 for t in {}",
                    index + 1,
                    positive(radius)
                )?;
                writeln!(out, "# r = {}", expression(radius, format))?;
            }
            Ok(())
        }
        (_, radii) => {
            // Other systems get the first branch: the second, -r(theta + pi), has the same points.
            radii
                .first()
                .map_or(Ok(()), |r| super::write_fourier(r, None, format, out))
        }
    }
}

fn branch(radius: &FourierRadius, digits: u32) -> Branch {
    let sympy = expression(radius, Format::Sympy);
    let [cx, cy] = radius.center().each_ref().map(|c| {
        if c.is_zero() {
            String::new()
        } else {
            format!("Rational({}, {}) + ", c.numerator(), c.denominator())
        }
    });
    let strings = |v: &[crate::exact::Rational]| v.iter().map(ToString::to_string).collect();
    Branch {
        factor: 0,
        radius: expression(radius, Format::Text)
            .replace("(t)", "(theta)")
            .replace("*t)", "*theta)"),
        latex: expression(radius, Format::Latex),
        coordinates: Coordinates {
            x: format!("{cx}({sympy})*cos(theta)"),
            y: format!("{cy}({sympy})*sin(theta)"),
        },
        sympy,
        fourier: Fourier {
            cos: strings(radius.cosines()),
            sin: strings(radius.sines()),
        },
        ranges: vec![Range::new(&AngleRange::full_circle(), digits)],
        positive: positive_ranges(radius)
            .iter()
            .map(|r| Range::new(r, digits))
            .collect(),
    }
}
