//! Coefficients of univariate polynomials, ascending.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Lcm};
use malachite::base::num::basic::traits::One;
use malachite::base::polynomial::Polynomial;

use super::IntegerPolynomial;
use crate::exact::Rational;

/// (D·f, D) with the least D > 0 for which the coefficients of D·f are integers.
pub(crate) fn with_integers(f: &[Rational]) -> (IntegerPolynomial, Integer) {
    let common = f.iter().fold(Integer::ONE, |d, c| {
        Integer::from(d.unsigned_abs_ref().lcm(c.denominator_ref()))
    });
    let scaled = |c: &Rational| c.numerator() * (&common).div_exact(c.denominator());
    let integers = IntegerPolynomial::from_coefficients_asc(f.iter().map(scaled).collect());
    (integers, common)
}

/// The coefficients, ascending.
pub(crate) fn coefficients(f: &IntegerPolynomial) -> Vec<Rational> {
    f.coefficients_asc().iter().map(Rational::whole).collect()
}

/// f times a number.
pub(crate) fn scaled(f: &IntegerPolynomial, by: &Integer) -> IntegerPolynomial {
    let coefficients = f.coefficients_asc().iter().map(|c| c * by);
    IntegerPolynomial::from_coefficients_asc(coefficients.collect())
}
