//! Certified cosines and sines of rational angles.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{ModPowerOf2, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;

use super::{Rational, pi};
use crate::error::Invariant;

/// The number of bits that are carried beyond those of the result. The error of a few hundred roundings and eight doublings is
/// far below 2⁴⁰ units.
const GUARD_BITS: u32 = 48;

/// How often the angle is halved before the series are summed.
const HALVINGS: u32 = 8;

/// Rational numbers within 2^−`bits` of cos θ and of sin θ, for the angle of exactly `angle` radians. For θ = 0 they are exact.
/// For any other rational angle both are transcendental (Lindemann 1882), so they can only be enclosed.
///
/// Fixed-point arithmetic: the nearest multiple of π/2 is subtracted from θ, the rest is halved eight times, the two power
/// series are summed, and their sums are doubled eight times. Cost: about `bits`/8 products of `bits` + log₂ |θ| bits.
///
/// ```
/// use stellate::exact::{Rational, cosine_and_sine};
/// let [c, s] = cosine_and_sine(&Rational::from(1), 100);
/// assert_eq!(c.to_decimal(25), "0.5403023058681397174009366");
/// assert_eq!(s.to_decimal(25), "0.8414709848078965066525023");
/// ```
#[must_use]
pub fn cosine_and_sine(angle: &Rational, bits: u32) -> [Rational; 2] {
    if angle.is_zero() {
        return [Rational::one(), Rational::zero()];
    }
    let precision = bits + GUARD_BITS;
    let whole = u32::try_from(angle.floor_integer().significant_bits())
        .invariant("an angle has fewer than 2^32 bits");
    let (low, _) = pi(precision.saturating_add(whole));
    let right_angle = low / Rational::from(2);
    let half = Rational::from_dyadic(Integer::ONE, -1);
    let quarters = (angle / &right_angle + half).floor_integer();
    let rest = angle - Rational::whole(&quarters) * right_angle;
    let scaled = rest * Rational::from_dyadic(Integer::ONE, i64::from(precision));
    let [c, s] = fixed_series(&(scaled.floor_integer() >> HALVINGS), precision);
    let [c, s] = match u8::try_from(&quarters.mod_power_of_2(2)) {
        Ok(0) => [c, s],
        Ok(1) => [-s, c],
        Ok(2) => [-c, -s],
        _ => [s, -c],
    };
    [c, s].map(|v| Rational::from_dyadic(v, -i64::from(precision)))
}

/// cos and sin of 2^HALVINGS times the small angle x, all in units of 2^−precision.
fn fixed_series(x: &Integer, precision: u32) -> [Integer; 2] {
    let mut term = Integer::ONE << precision;
    let (mut c, mut s) = (term.clone(), Integer::ZERO);
    let mut k = 0u64;
    // The terms are 1, x, −x²/2, −x³/6, x⁴/24, ….
    loop {
        k += 1;
        term = ((term * x) >> precision) / Integer::from(k);
        if term == 0 || term == -1 {
            break;
        }
        match k % 4 {
            0 => c += &term,
            1 => s += &term,
            2 => c -= &term,
            _ => s -= &term,
        }
    }
    for _ in 0..HALVINGS {
        let double = (&c * &s) >> (precision - 1);
        c = (c.square() - s.square()) >> precision;
        s = double;
    }
    [c, s]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::arctangent;
    use proptest::prelude::*;

    #[test]
    fn the_angle_0_is_exact() {
        let [c, s] = cosine_and_sine(&Rational::zero(), 10);
        assert_eq!((c, s), (Rational::one(), Rational::zero()));
    }

    #[test]
    fn a_large_double_is_reduced_exactly() {
        // The cosine and sine of 10²² (Ng 1992).
        let [c, s] = cosine_and_sine(&Rational::try_from(1e22).unwrap(), 80);
        assert_eq!(c.to_decimal(16), "0.5232147853951389");
        assert_eq!(s.to_decimal(16), "-0.8522008497671888");
    }

    proptest! {
        #[test]
        fn they_are_near_the_circle_and_the_doubles(theta in -1e4f64..1e4, bits in 64u32..400) {
            let [c, s] = cosine_and_sine(&Rational::try_from(theta).unwrap(), bits);
            let defect = (&c * &c + &s * &s - Rational::one()).abs();
            prop_assert!(defect < Rational::from_dyadic(4.into(), -i64::from(bits)));
            prop_assert!((c.to_f64() - theta.cos()).abs() < 1e-15);
            prop_assert!((s.to_f64() - theta.sin()).abs() < 1e-15);
        }

        /// The arctangent is an independent oracle.
        #[test]
        fn the_arctangent_takes_them_back(p in -700i64..700, bits in 60u32..300) {
            let theta = Rational::from(p) / Rational::from(1000);
            let [c, s] = cosine_and_sine(&theta, bits);
            let (low, high) = arctangent(&(s / c), bits);
            let slack = Rational::from_dyadic(8.into(), -i64::from(bits));
            prop_assert!(low - &slack <= theta && theta <= high + slack);
        }
    }
}
