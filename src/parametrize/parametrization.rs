//! The whole of §3 for one curve: lines through the origin, and the branches r(θ) of the rest.

use malachite::base::num::basic::traits::Zero;

use super::angle::{AngleRange, ExactAngle};
use super::closed::{ClosedBranch, lemma_2, lemma_3, lemma_4, lemma_5};
use super::expression::Expression;
use super::fourier::fourier_branches;
use super::ranges::positive_ranges;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::poly::{
    BinaryForm, IntegerPolynomial, PlanePolynomial, divide_exactly, polynomial_gcd, real_roots,
};
use crate::shape::{FourierRadius, ImplicitCurve};

/// A curve in polar form: straight lines through the origin, and branches r(θ).
#[derive(Clone, Debug)]
pub struct Parametrization {
    /// The number of the lemma that gives the branches, 2 to 5; `None` if there are only lines.
    pub lemma: Option<usize>,
    /// The k of r^k.
    pub step: usize,
    /// The angles in [0, π) of straight lines through the origin that belong to the curve.
    pub lines: Vec<ExactAngle>,
    /// The branches, the one with r > 0 first where both signs occur.
    pub branches: Vec<Branch>,
    /// The point that r is measured from.
    pub center: [Rational; 2],
}

/// One branch.
#[derive(Clone, Debug)]
pub struct Branch {
    /// r(θ).
    pub radius: Radius,
    /// Where r is real and finite, of either sign.
    pub real: Vec<AngleRange>,
    /// Where r > 0.
    pub positive: Vec<AngleRange>,
}

/// r(θ), exactly.
#[derive(Clone, Debug)]
pub enum Radius {
    /// A trigonometric polynomial.
    Fourier(FourierRadius),
    /// Any other closed form.
    Closed(Expression),
}

/// The closed polar form of a plane curve (Lemmas 2 to 5), with exact ranges.
///
/// The largest form that divides the polynomial is split off: its real zeros are the lines. What is left
/// has two to five equally spaced homogeneous parts; if a radius is a trigonometric polynomial it comes
/// as one.
///
/// # Errors
/// [`Error::Hypothesis`] if the degree in r^k is more than four; [`Error::Usage`] for 0.
pub fn parametrize(curve: &ImplicitCurve) -> Result<Parametrization> {
    let (form, rest) = split_form(curve.polynomial())
        .ok_or_else(|| Error::Usage("the polynomial 0 has no curve".into()))?;
    let mut result = Parametrization {
        lemma: None,
        step: 1,
        lines: directions(&form),
        branches: Vec::new(),
        center: curve.center().clone(),
    };
    let degrees = rest.homogeneous_degrees();
    if degrees.len() < 2 {
        return Ok(result);
    }
    let rest = ImplicitCurve::new(rest.primitive()).with_center(curve.center().clone());
    if let Ok(found) = fourier_branches(&rest) {
        result.lemma = Some(found.lemma);
        result.step = found.step;
        result.branches = found.radii.into_iter().map(Branch::fourier).collect();
        return Ok(result);
    }
    let step = degrees.windows(2).fold(0, |g, w| gcd(g, w[0] - w[1]));
    let (top, low) = (degrees[0], degrees[degrees.len() - 1]);
    let k = u32::try_from(step).map_err(|_| Error::limit("the step of the degrees"))?;
    let f = rest.polynomial();
    let part = |d: usize| f.part(d).cloned().unwrap_or_else(|| BinaryForm::zero(d));
    let closed = match (top - low) / step {
        1 => lemma_2(&part(top), &part(low), k),
        2 => lemma_3(&part(top), &part(top - step), &part(low), k),
        3 => {
            let (second, third) = (part(top - step), part(low + step));
            lemma_4(&part(top), &second, &third, &part(low), k)
        }
        4 => {
            let all = [0, 1, 2, 3, 4].map(|j| part(top - j * step));
            lemma_5(all.each_ref(), k)
        }
        degree => {
            return Err(Error::Hypothesis {
                statement: "the closed form of r (Lemmas 2 to 5)",
                witness: format!(
                    "the homogeneous parts have degrees {degrees:?}: a polynomial of degree {degree} in r^{step}, and the lemmas need degree 1 to 4; sample and plot take any degree"
                ),
            });
        }
    };
    result.lemma = Some((top - low) / step + 1);
    result.step = step;
    result.branches = closed.into_iter().map(Branch::closed).collect();
    Ok(result)
}

impl Radius {
    /// r(θ) in doubles, with no bound of its error: for drawing and comparing.
    #[must_use]
    pub fn approximate(&self, theta: f64) -> f64 {
        match self {
            Self::Fourier(radius) => radius.approximate(theta),
            Self::Closed(expression) => expression.approximate(theta),
        }
    }
}

impl Branch {
    /// A branch that is a trigonometric polynomial: real everywhere.
    pub(crate) fn fourier(radius: FourierRadius) -> Self {
        Self {
            real: vec![AngleRange::full_circle()],
            positive: positive_ranges(&radius),
            radius: Radius::Fourier(radius),
        }
    }

    fn closed(branch: ClosedBranch) -> Self {
        Self {
            radius: Radius::Closed(branch.radius),
            real: branch.real,
            positive: branch.positive,
        }
    }
}

/// f = form · rest with the form of largest degree; `None` for 0.
fn split_form(f: &PlanePolynomial) -> Option<(BinaryForm, PlanePolynomial)> {
    let mut common: Option<(IntegerPolynomial, usize)> = None;
    for part in f.parts() {
        let in_t = part.dehomogenized();
        let x_power = part.degree() + 1 - in_t.coefficients_asc().len();
        common = Some(match common {
            None => (in_t.clone(), x_power),
            Some((g, e)) => (polynomial_gcd(&g, in_t), e.min(x_power)),
        });
    }
    let (g, x_power) = common?;
    let g = crate::poly::primitive_part(&g);
    let degree = g.coefficients_asc().len() - 1 + x_power;
    let parts = f.parts().filter_map(|part| {
        let quotient = divide_exactly(part.dehomogenized(), &g)?;
        Some(BinaryForm::from_dehomogenized(
            part.degree() - degree,
            quotient,
        ))
    });
    let rest = PlanePolynomial::from_parts(parts.collect::<Vec<_>>(), f.denominator().clone());
    Some((BinaryForm::from_dehomogenized(degree, g), rest))
}

/// The angles in [0, π) at which a form vanishes, ascending.
fn directions(form: &BinaryForm) -> Vec<ExactAngle> {
    let roots = real_roots(form.dehomogenized());
    let (negative, other): (Vec<_>, Vec<_>) = roots.into_iter().partition(|t| t.signum() < 0);
    let vertical = form.dehomogenized().coefficients_asc().len() <= form.degree()
        && *form.dehomogenized() != IntegerPolynomial::ZERO;
    let up = vertical.then(|| ExactAngle::Pi(Rational::one() / Rational::from(2)));
    let tangents = |list: Vec<_>| list.into_iter().map(ExactAngle::of_tangent);
    tangents(other)
        .chain(up)
        .chain(tangents(negative))
        .collect()
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}
