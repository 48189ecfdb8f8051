//! The parts of the entries of parametric documents: angles, ranges, coordinates and coefficients.

use serde::Serialize;

use crate::exact::Rational;
use crate::parametrize::{AngleRange, ExactAngle};
use crate::shape::FourierRadius;

#[derive(Serialize)]
pub(super) struct Angle {
    pub(super) theta: String,
    pub(super) exact: String,
}

#[derive(Serialize)]
pub(super) struct PlaneFormulas {
    pub(super) x: String,
    pub(super) y: String,
}

#[derive(Serialize)]
pub(super) struct Fourier {
    pub(super) cos: Vec<String>,
    pub(super) sin: Vec<String>,
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

    /// The range as text, such as `[0, pi/2)`; an end is exact if it has a closed form.
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

/// Ranges as one phrase, such as `theta in [0, pi/2) and (3*pi/2, 2*pi]`, or `no angle`.
pub(super) fn ranges_text(ranges: &[Range]) -> String {
    ranges_text_of("theta", ranges)
}

/// As [`ranges_text`], for the angle of the given name.
pub(super) fn ranges_text_of(angle: &str, ranges: &[Range]) -> String {
    if ranges.is_empty() {
        return "no angle".into();
    }
    let parts: Vec<String> = ranges.iter().map(Range::text).collect();
    format!("{angle} in {}", parts.join(" and "))
}

pub(super) fn angle(angle: &ExactAngle, digits: u32) -> Angle {
    Angle {
        theta: angle.to_decimal(digits),
        exact: angle.describe(),
    }
}

pub(super) fn ranges(list: &[AngleRange], digits: u32) -> Vec<Range> {
    list.iter().map(|range| Range::new(range, digits)).collect()
}

pub(super) fn fourier(radius: &FourierRadius) -> Fourier {
    let strings = |v: &[Rational]| v.iter().map(ToString::to_string).collect();
    Fourier {
        cos: strings(radius.cosines()),
        sin: strings(radius.sines()),
    }
}

/// The coordinate of a center before what is added to it, in SymPy.
pub(super) fn sympy_start(c: &Rational) -> String {
    if c.is_zero() {
        return String::new();
    }
    format!("Rational({}, {}) + ", c.numerator(), c.denominator())
}

pub(super) fn coordinates(sympy: &str, center: &[Rational; 2]) -> PlaneFormulas {
    let [cx, cy] = center.each_ref().map(sympy_start);
    PlaneFormulas {
        x: format!("{cx}({sympy})*cos(theta)"),
        y: format!("{cy}({sympy})*sin(theta)"),
    }
}
