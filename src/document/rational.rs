//! Rational parametrizations in parametric documents, or the reasons why there are none.

use serde::Serialize;

use super::Format;
use super::angles::PlaneFormulas;
use crate::exact::Rational;
use crate::notation::Notation;
use crate::parametrize::{Cover, FactorRationality, RationalCurve, Rationality};
use crate::poly::{BinaryForm, IntegerPolynomial, RationalFunction};

/// A longer equation of a cover is not printed in the text format.
const LONGEST_EQUATION: usize = 120;

#[derive(Serialize)]
pub(super) struct Entry {
    factor: usize,
    /// The genus; absent if the factor consists of several curves.
    #[serde(skip_serializing_if = "Option::is_none")]
    genus: Option<usize>,
    /// Whether there is a rational parametrization over Q; absent if this is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    rational: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    parameter: Option<&'static str>,
    #[serde(flatten)]
    curve: Option<PlaneFormulas>,
    #[serde(skip_serializing_if = "Option::is_none")]
    latex: Option<PlaneFormulas>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sympy: Option<PlaneFormulas>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

impl PlaneFormulas {
    /// The entry of a curve, in the coordinates of the plane, whose origin is not the center.
    fn of_curve(curve: &RationalCurve, [a, b]: &[Rational; 2], format: Format) -> Self {
        Self {
            x: function_text(&curve.x.plus_constant(a), format),
            y: function_text(&curve.y.plus_constant(b), format),
        }
    }
}

impl Entry {
    pub(super) fn new(of: &FactorRationality, center: &[Rational; 2]) -> Self {
        let curve = match &of.rationality {
            Rationality::Parametrized(curve) => Some(curve),
            _ => None,
        };
        let coordinates = |format| curve.map(|c| PlaneFormulas::of_curve(c, center, format));
        let (genus, rational) = match &of.rationality {
            Rationality::Parametrized(_) | Rationality::HalfAngle => (Some(0), Some(true)),
            Rationality::NoRationalPoint { .. } => (Some(0), Some(false)),
            Rationality::NotDecided { .. } => (Some(0), None),
            Rationality::PositiveGenus { genus, .. } => (Some(*genus), Some(false)),
            Rationality::Conjugates { .. } => (None, Some(false)),
        };
        Self {
            factor: of.factor,
            genus,
            rational,
            parameter: match &of.rationality {
                Rationality::Parametrized(_) => Some("t"),
                Rationality::HalfAngle => Some("tan(theta/2)"),
                _ => None,
            },
            curve: coordinates(Format::Text),
            latex: coordinates(Format::Latex),
            sympy: coordinates(Format::Sympy),
            reason: reason(&of.rationality, usize::MAX),
        }
    }
}

/// The comment about a factor; `None` for a radius that is a series, because r(θ) shows the parametrization.
pub(super) fn comment(
    of: &FactorRationality,
    center: &[Rational; 2],
    format: Format,
) -> Option<String> {
    let factor = of.factor;
    let claim = match &of.rationality {
        Rationality::HalfAngle => return None,
        Rationality::Parametrized(curve) => {
            let PlaneFormulas { x, y } = PlaneFormulas::of_curve(curve, center, format);
            let from = match super::center_comment(center) {
                Some(_) => ", in original coordinates",
                None => "",
            };
            return Some(format!(
                "factor {factor} is rational{from}: x = {x}, y = {y}"
            ));
        }
        Rationality::NoRationalPoint { .. } => {
            "has genus 0, but no rational parametrization over Q".into()
        }
        Rationality::NotDecided { .. } => {
            "has genus 0; whether it has a rational parametrization over Q is not decided".into()
        }
        Rationality::PositiveGenus { genus, .. } => {
            format!("has genus {genus}: no rational parametrization exists")
        }
        Rationality::Conjugates { .. } => "has no rational parametrization over Q".into(),
    };
    let reason = reason(&of.rationality, LONGEST_EQUATION).unwrap_or_default();
    Some(format!("factor {factor} {claim} ({reason})"))
}

/// The reason why there is no parametrization; `None` if there is one.
fn reason(rationality: &Rationality, longest: usize) -> Option<String> {
    let equation = |form: &BinaryForm| {
        let right = polynomial_text(form.dehomogenized(), Format::Text);
        if right.len() <= longest {
            format!("w^2 = {right}")
        } else {
            format!("w^2 = k(t) with {} digits in all", right.len())
        }
    };
    Some(match rationality {
        Rationality::Parametrized(_) | Rationality::HalfAngle => return None,
        Rationality::NoRationalPoint {
            conic,
            place,
            field,
        } => format!(
            "{} with y = t*x has no solution in the {place}; over Q(sqrt({field})) it has one",
            equation(conic)
        ),
        Rationality::NotDecided { conic, number } => format!(
            "{} with y = t*x: {number} was not factored, which is tried for primes below 2^14 and a rest below 2^64",
            equation(conic)
        ),
        Rationality::PositiveGenus {
            cover: Cover::Double(kernel),
            ..
        } => format!(
            "with y = t*x it is {}, squarefree of degree {}, infinity counted",
            equation(kernel),
            kernel.degree()
        ),
        Rationality::PositiveGenus {
            cover:
                Cover::Cyclic {
                    degree,
                    branch_points,
                },
            ..
        } => format!(
            "with y = t*x it is x^{degree} = g(t), branched over {branch_points} values of t: Riemann and Hurwitz"
        ),
        Rationality::Conjugates { count } => {
            format!("irreducible over Q, but {count} conjugate curves over a larger field")
        }
    })
}

/// The text of a function, such as `(t^2 - 1)/(t^2 + 1)`.
fn function_text(f: &RationalFunction, format: Format) -> String {
    let [above, below] = [f.numerator(), f.denominator()].map(|p| polynomial_text(p, format));
    if f.is_polynomial() {
        return above;
    }
    if format == Format::Latex {
        return format!("\\frac{{{above}}}{{{below}}}");
    }
    let terms = |p: &IntegerPolynomial| p.coefficients_asc().iter().filter(|c| **c != 0).count();
    // A number or a power of t needs no parentheses as a divisor; a longer text does.
    let single = below.bytes().all(|c| c.is_ascii_digit())
        || below.starts_with('t') && terms(f.denominator()) == 1;
    let above = if terms(f.numerator()) > 1 {
        format!("({above})")
    } else {
        above
    };
    let below = if single { below } else { format!("({below})") };
    format!("{above}/{below}")
}

fn polynomial_text(p: &IntegerPolynomial, format: Format) -> String {
    let notation = match format {
        Format::Sympy => Notation::Python,
        Format::Latex => Notation::Latex,
        _ => Notation::Explicit,
    };
    let terms = p.coefficients_asc().iter().enumerate().rev();
    let terms = terms.filter(|(_, c)| **c != 0).map(|(k, c)| {
        let monomial = match (k, notation) {
            (0, _) => String::new(),
            (1, _) => "t".into(),
            (_, Notation::Python) => format!("t**{k}"),
            (_, Notation::Latex) => format!("t^{{{k}}}"),
            _ => format!("t^{k}"),
        };
        (Rational::whole(c), monomial)
    });
    let mut text = Vec::new();
    let written = notation.write_sum(terms, &mut text);
    debug_assert!(written.is_ok(), "writing into memory succeeds");
    String::from_utf8_lossy(&text).into_owned()
}
