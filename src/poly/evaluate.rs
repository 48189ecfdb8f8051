//! Exact values and signs of univariate polynomials at rational points.

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;

use super::IntegerPolynomial;
use crate::exact::{Dyadic, Rational};

/// The integer `q^d f(p/q)` for a dyadic point p/q, where q is a power of two. It has the sign of f(p/q).
///
/// Cost: d products by p of a number that becomes longer and longer.
#[must_use]
pub(crate) fn numerator_at(f: &IntegerPolynomial, point: &Dyadic) -> Integer {
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
    integer_sign(&leading_value(f, point, 1).0)
}

/// A pair (m, e) with |f(point) − m · 2^e| ≤ 2^−`bits` |m · 2^e|. It is exact if that costs hardly more.
///
/// Proof. By Lemma 1 of [`fixed_point_value`] the error is less than d < 2^error_bits units, and m is at least 2^(error_bits +
/// bits). Law: `values_smaller_than_their_error_are_not_believed`.
///
/// Cost: the exact value at a point of b bits takes d²b/2 steps. If the value is not tiny, fixed-point numbers give its leading
/// bits by d products of their length, which is 128 bits at first and four times as many in each further attempt.
pub(crate) fn leading_value(f: &IntegerPolynomial, point: &Dyadic, bits: u64) -> (Integer, i64) {
    let degree = f.coefficients_asc().len().saturating_sub(1) as u64;
    let exact_bits = point.exponent().min(0).unsigned_abs() * degree;
    if point.log2().is_some_and(|size| size < 0) {
        let mut fraction = 128.max(2 * bits);
        while 4 * fraction < exact_bits {
            let value = fixed_point_value(f, point, fraction);
            // The value is less than d units too small, and d < 2^error_bits.
            let error_bits = u64::from(degree.checked_ilog2().unwrap_or(0)) + 1;
            if value.significant_bits() > error_bits + bits {
                let exponent = -fraction.cast_signed();
                return (value, exponent);
            }
            fraction *= 4;
        }
    }
    let exponent = -exact_bits.cast_signed();
    (numerator_at(f, point), exponent)
}

/// 2^`fraction` f(point), rounded down at every step of Horner's rule.
///
/// Lemma 1. For |point| < 1 the result differs by less than d units from the exact value, where d ≥ 1 is the degree.
/// Proof. Each of the d products with the point is rounded down by less than 1. Earlier errors are multiplied by the point,
/// which makes them smaller.
/// Law: `fixed_point_values_are_less_than_the_degree_away`.
fn fixed_point_value(f: &IntegerPolynomial, point: &Dyadic, fraction: u64) -> Integer {
    let mut value = Integer::ZERO;
    for c in f.coefficients_asc().iter().rev() {
        value *= point.mantissa();
        if point.exponent() < 0 {
            value >>= point.exponent().unsigned_abs();
        } else {
            value <<= point.exponent().unsigned_abs();
        }
        if *c != 0 {
            value += c << fraction;
        }
    }
    value
}

/// The exact sign (−1, 0, 1) of f at a rational point.
#[must_use]
pub(crate) fn sign_at_rational(f: &IntegerPolynomial, point: &Rational) -> i8 {
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

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::base::num::arithmetic::traits::Abs;
    use malachite::base::polynomial::Polynomial;
    use proptest::prelude::*;

    proptest! {
        /// Near ±1 the rounding errors are hardly diminished; the coefficients are such that every step is rounded.
        #[test]
        fn fixed_point_values_are_less_than_the_degree_away(
            c in prop::collection::vec(1_i64 << 40..i64::MAX, 2..60), bits in 2_u64..200, negative in any::<bool>(), fraction in 1_u64..80,
        ) {
            let f = IntegerPolynomial::from_coefficients_asc(c.into_iter().map(Integer::from).collect());
            let size = (Integer::ONE << bits) - Integer::ONE;
            let point = Dyadic::new(if negative { -size } else { size }, -bits.cast_signed());
            let degree = f.coefficients_asc().len().saturating_sub(1) as u64;
            prop_assume!(degree > 0);
            let exact = numerator_at(&f, &point) << fraction;
            let scale = bits * degree;
            let error = (exact - (fixed_point_value(&f, &point, fraction) << scale)).abs();
            prop_assert!(error < Integer::from(degree) << scale);
            // The error is not much smaller than the bound, because all rounding errors add up. (If fewer bits are dropped than
            // follow the point, the first errors are 0.)
            if !negative && bits > fraction.max(20) {
                prop_assert!(error << 3_u64 >= Integer::from(degree - 1) << scale || degree < 20);
            }
        }

        /// (1 − x) g at 1 − 2^-k, where g is small at 1: the value is some units of the fixed-point numbers, and the rounding
        /// error is as large.
        #[test]
        fn values_smaller_than_their_error_are_not_believed(
            g in prop::collection::vec(-1_i64..2, 5..60), k in prop_oneof![118_u64..130, 500_u64..514], bits in 1_u64..4, negative in any::<bool>(),
        ) {
            let polynomial = |c: Vec<i64>| IntegerPolynomial::from_coefficients_asc(c.into_iter().map(Integer::from).collect());
            let size = (Integer::ONE << k) - Integer::ONE;
            let (f, point) = if negative {
                // The same polynomial at −x.
                let g = g.iter().enumerate().map(|(i, c)| if i % 2 == 1 { -c } else { *c });
                (polynomial(vec![1, 1]) * polynomial(g.collect()), Dyadic::new(-size, -k.cast_signed()))
            } else {
                (polynomial(vec![1, -1]) * polynomial(g), Dyadic::new(size, -k.cast_signed()))
            };
            let exact = numerator_at(&f, &point);
            prop_assert_eq!(sign_at(&f, &point), integer_sign(&exact));
            let degree = f.coefficients_asc().len().saturating_sub(1) as i64;
            let exact = Dyadic::new(exact, point.exponent() * degree);
            let (m, e) = leading_value(&f, &point, bits);
            let error = Dyadic::new(m.clone(), e).minus(&exact);
            // The precision `bits` of the result.
            let size = Dyadic::new(m.abs(), e - bits.cast_signed());
            prop_assert!(Dyadic::new(error.mantissa().abs(), error.exponent()) <= size);
        }

        /// Signs and leading bits are those of the exact value, also near roots.
        #[test]
        fn leading_bits_are_right(
            c in prop::collection::vec(any::<i64>(), 1..30),
            m in any::<i64>(),
            exponent in -900i64..3,
            bits in 1u64..100,
            is_near in any::<bool>(),
        ) {
            let point = Dyadic::new(Integer::from(m), exponent);
            let mut f = IntegerPolynomial::from_coefficients_asc(c.into_iter().map(Integer::from).collect());
            if is_near {
                // This factor vanishes near the point.
                let q = point.plus(&Dyadic::new(Integer::ONE, 3 * exponent.min(0))).to_rational();
                f *= IntegerPolynomial::from_coefficients_asc(vec![-q.numerator(), q.denominator()]);
            }
            let exact = numerator_at(&f, &point);
            prop_assert_eq!(sign_at(&f, &point), integer_sign(&exact));
            let degree = f.coefficients_asc().len().saturating_sub(1) as i64;
            let exact = Dyadic::new(exact, point.exponent().min(0) * degree);
            let (m, e) = leading_value(&f, &point, bits);
            let error = Dyadic::new(m, e).minus(&exact);
            let size = Dyadic::new(exact.mantissa().abs(), exact.exponent() - bits as i64);
            prop_assert!(Dyadic::new(error.mantissa().abs(), error.exponent()) <= size);
        }
    }
}
