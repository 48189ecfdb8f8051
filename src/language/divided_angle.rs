//! Polar curves by a power of the radius with parts of the angle: `r^2 = cos(t/2)`.
//!
//! Let r^k = f(t), and τ = tan(t/2). Both are rational functions of s, the tangent of a part of the angle, so that there is a
//! polynomial relation H(r^k, τ) = 0 between them. With τ = y/(r + x) it becomes U + rV = 0 with polynomials U and V in x and y, and
//! U² = (x² + y²) V². The root r may have either sign; the point is r (cos t, sin t).

use malachite::base::polynomial::Polynomial as _;

use super::coordinates;
use super::evaluate::Context;
use super::name::Name;
use super::polar_equation::{PolarEquation, divided_by_rho, rho};
use super::syntax::{Equation, Expr, ExprKind};
use crate::error::Result;
use crate::exact::Rational;
use crate::factor::squarefree_plane;
use crate::limits::Limits;
use crate::poly::{
    IntegerPolynomial, PlanePolynomial, RationalFunction, SparsePolynomial, integer_sign, resultant,
};
use crate::roots::real_roots;
use crate::shape::Form;

/// The largest degree in x and y before repeated and superfluous factors are divided out.
const MAX_DEGREE: usize = 100;

/// The equation of `r^k = formula`.
///
/// # Errors
/// Those of the formula; [`crate::error::Error::Limit`] if the equation would be too large.
pub(super) fn equation(
    cx: &mut Context<'_>,
    equations: &[Equation],
    formula: &Expr,
    k: u32,
    angle: Name,
) -> Result<PolarEquation> {
    let at = formula.span;
    let expr = |kind| Expr { kind, span: at };
    let half = ExprKind::Product(vec![
        (false, expr(ExprKind::Name(angle))),
        (true, expr(ExprKind::Integer(2))),
    ]);
    let tangent = expr(ExprKind::Call(Name::Tan, vec![expr(half)]));
    let both = [Some(formula), Some(&tangent), None];
    let Form::PlaneCurve(curve) = coordinates::of_formulas(cx, equations, both)? else {
        unreachable!("two coordinates are those of a plane curve");
    };
    let [power, tangent] = curve.coordinates();
    let relation = [(power, 1), (tangent, 2)].map(|(f, v)| difference(f, v));
    let relation = resultant(&relation[0], &relation[1], 0, &Limits::none())?;
    let [of_power, of_tangent] = [1, 2].map(|v| relation.degree_in(v) as usize);
    if k as usize * of_power + of_tangent > MAX_DEGREE {
        let limit = format!("a degree beyond {} beside a power of r", 2 * MAX_DEGREE);
        return Err(cx.source.limit(at, limit));
    }
    let [even, odd] = over_radius(&relation, k, of_tangent);
    let product = &(&even * &even) - &(&rho() * &(&odd * &odd));
    // τ brings in the factor y, and r the factor x² + y².
    let mut polynomial = squarefree_plane(&product, &Limits::none())?;
    if let Some(quotient) = divided_by_rho(&polynomial) {
        polynomial = quotient;
    }
    if polynomial.terms().all(|((_, j), _)| j > 0) {
        let lower = polynomial.terms().map(|((i, j), c)| ((i, j - 1), c));
        polynomial = PlanePolynomial::from_terms(lower);
    }
    let (above, below) = (power.numerator(), power.denominator());
    let [of_above, of_below] = [above, below].map(|f| f.coefficients_asc().len());
    let first = |f: &IntegerPolynomial| integer_sign(f.leading_coefficient());
    Ok(PolarEquation {
        polynomial,
        has_zero: of_above < of_below || !real_roots(above).is_empty(),
        has_pole: of_above > of_below || !real_roots(below).is_empty(),
        sign: first(above) * first(below),
    })
}

/// The numerator of f(s) − v, where s is the first variable of the result, and v the one with this number.
fn difference(f: &RationalFunction, v: usize) -> SparsePolynomial<3> {
    let terms = |f: &IntegerPolynomial, power: u32, sign: i64| {
        let coefficients = f.coefficients_asc().iter().zip(0..);
        let terms = coefficients.map(move |(c, n)| {
            let mut exponents = [n, 0, 0];
            exponents[v] = power;
            (exponents, Rational::whole(c) * Rational::from(sign))
        });
        terms.collect::<Vec<_>>()
    };
    let numerator = terms(f.numerator(), 0, 1);
    SparsePolynomial::from_terms(numerator.into_iter().chain(terms(f.denominator(), 1, -1)))
}

/// The polynomials [U, V] with U + rV = (r + x)^d H(r^k, y/(r + x)), where d is the degree of H(R, τ) in τ.
fn over_radius(relation: &SparsePolynomial<3>, k: u32, d: usize) -> [PlanePolynomial; 2] {
    let monomial = |i, j, c| PlanePolynomial::from_terms([((i, j), c)]);
    // (r + x) (u + rv) = (xu + ρv) + r (u + xv)
    let mut powers = vec![[
        monomial(0, 0, Rational::one()),
        PlanePolynomial::from_terms([]),
    ]];
    for n in 0..d {
        let [u, v] = &powers[n];
        let x = monomial(1, 0, Rational::one());
        powers.push([&(&x * u) + &(&rho() * v), u + &(&x * v)]);
    }
    let mut sum = [0, 1].map(|_| PlanePolynomial::from_terms([]));
    for ([_, a, b], c) in relation.terms() {
        let factor = (0..k * a / 2).fold(monomial(0, *b as usize, c.clone()), |f, _| &f * &rho());
        let [u, v] = &powers[d - *b as usize];
        let [u, v] = match (k * a) % 2 {
            0 => [u.clone(), v.clone()],
            _ => [&rho() * v, u.clone()],
        };
        sum = [&sum[0] + &(&factor * &u), &sum[1] + &(&factor * &v)];
    }
    sum
}
