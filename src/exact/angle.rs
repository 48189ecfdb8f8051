//! Certified decimals of angles: arctangents of rational numbers to any number of bits.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{FloorSqrt, Square};
use malachite::base::num::basic::traits::{One, Zero};

use super::Rational;

/// Bits carried beyond those asked for; the error of a few hundred roundings is far below 2³².
const GUARD_BITS: u32 = 48;

/// How often the argument is halved before the series is summed.
const HALVINGS: u32 = 8;

/// Certified bounds `low ≤ atan(q) ≤ high` with `high − low = 2^(1−bits)`.
///
/// Fixed-point arithmetic: atan q = 2⁸ atan q' after eight half-angle steps
/// q' = q / (1 + √(1 + q²)), then the alternating series. Cost: about `bits`/16 products of `bits` bits.
///
/// ```
/// use stellate::exact::{Rational, arctangent};
/// let (low, high) = arctangent(&Rational::one(), 200);
/// assert_eq!((low * Rational::from(4)).to_decimal(50), (high * Rational::from(4)).to_decimal(50));
/// ```
#[must_use]
pub fn arctangent(q: &Rational, bits: u32) -> (Rational, Rational) {
    let precision = bits + GUARD_BITS;
    let value = fixed_arctangent(q, precision);
    let width = Integer::ONE << GUARD_BITS;
    let bound = |v: Integer| Rational::from_parts(v, -i64::from(precision));
    (bound(&value - &width), bound(value + width))
}

/// Certified bounds of π, as [`arctangent`].
#[must_use]
pub fn pi(bits: u32) -> (Rational, Rational) {
    let (low, high) = arctangent(&Rational::one(), bits + 2);
    let four = Rational::from(4);
    (low * &four, high * four)
}

/// atan(q)·2^precision, up to 2⁴⁰ or so units.
fn fixed_arctangent(q: &Rational, precision: u32) -> Integer {
    if q.signum() < 0 {
        return -fixed_arctangent(&-q.clone(), precision);
    }
    if *q > Rational::one() {
        // π/2 − atan(1/q)
        let rest = fixed_arctangent(&q.recip().unwrap_or_default(), precision);
        let quarter = fixed_arctangent(&Rational::one(), precision);
        return (quarter << 1u64) - rest;
    }
    let one = Integer::ONE << precision;
    let mut x = (q * &Rational::from(&one)).floor();
    for _ in 0..HALVINGS {
        let hypotenuse = ((&one).square() + (&x).square()).floor_sqrt();
        x = (x << precision) / (&one + hypotenuse);
    }
    // x − x³/3 + x⁵/5 − …, x < 2⁻⁸
    let square = (&x).square() >> precision;
    let mut power = x;
    let mut sum = Integer::ZERO;
    let mut k = 1u64;
    while power != 0 {
        let term = &power / Integer::from(k);
        if k % 4 == 1 {
            sum += term
        } else {
            sum -= term
        }
        power = (power * &square) >> precision;
        k += 2;
    }
    sum << HALVINGS
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn fifty_decimals_of_pi() {
        let (low, high) = pi(180);
        let digits = "3.14159265358979323846264338327950288419716939937511";
        assert_eq!(low.to_decimal(50), digits);
        assert_eq!(high.to_decimal(50), digits);
    }

    proptest! {
        #[test]
        fn the_bounds_hold_the_tangent_of_doubles(p in -1_000_000i64..1_000_000, q in 1i64..1_000_000) {
            let x = Rational::from(p) / Rational::from(q);
            let (low, high) = arctangent(&x, 100);
            prop_assert!((low.to_f64() - x.to_f64().atan()).abs() < 1e-15);
            prop_assert!(low < high);
            // atan x + atan 1/x = ±π/2
            if p != 0 {
                let (l2, h2) = arctangent(&x.recip().unwrap(), 100);
                let (pl, ph) = pi(100);
                let sign = Rational::from(i32::from(x.signum()) * 2);
                let (a, b) = ((low + l2) * &sign, (high + h2) * sign);
                let (a, b) = if a < b { (a, b) } else { (b, a) };
                prop_assert!(a <= ph && pl <= b);
            }
        }
    }
}
