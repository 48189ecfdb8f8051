//! Exact values and signs of univariate polynomials at rational points.

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};

use super::IntegerPolynomial;
use crate::exact::{Dyadic, Rational};

/// `q^d f(p/q)` for a dyadic point p/q, with q a power of two: an integer with the sign of f.
///
/// Cost: d products of a growing number with p.
#[must_use]
pub fn numerator_at(f: &IntegerPolynomial, point: &Dyadic) -> Integer {
    let coefficients = f.coefficients_asc();
    let mut value = Integer::ZERO;
    if point.exponent() >= 0 {
        let x = point.mantissa() << point.exponent().unsigned_abs();
        for c in coefficients.iter().rev() {
            value = value * &x + c;
        }
    } else {
        let shift = point.exponent().unsigned_abs();
        let mut lowered = 0;
        for c in coefficients.iter().rev() {
            value *= point.mantissa();
            if *c != 0 {
                value += c << lowered;
            }
            lowered += shift;
        }
    }
    value
}

/// The exact sign (−1, 0, 1) of f at a dyadic point.
#[must_use]
pub fn sign_at(f: &IntegerPolynomial, point: &Dyadic) -> i8 {
    integer_sign(&numerator_at(f, point))
}

/// The exact sign (−1, 0, 1) of f at a rational point.
#[must_use]
pub fn sign_at_rational(f: &IntegerPolynomial, point: &Rational) -> i8 {
    let (p, q) = (point.numerator(), point.denominator());
    let mut value = Integer::ZERO;
    let mut q_power = Integer::ONE;
    for c in f.coefficients_asc().iter().rev() {
        value *= &p;
        if *c != 0 {
            value += c * &q_power;
        }
        q_power *= &q;
    }
    integer_sign(&value)
}

/// The sign of an integer: −1, 0 or 1.
pub(crate) fn integer_sign(value: &Integer) -> i8 {
    i8::from(*value > 0) - i8::from(*value < 0)
}
