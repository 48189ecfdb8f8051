//! Certified decimals of angles: arctangents of rational numbers to any number of bits.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{FloorSqrt, Square};
use malachite::base::num::basic::traits::{One, Zero};

use super::Rational;
use crate::error::Invariant;

/// The number of bits that are carried beyond those of the result. The bounds hold for any number, because the error is
/// counted. They are as narrow as promised if the error is below 2^48 units, and this is so for fewer than 2^37 terms of the
/// series. Law: `the_bounds_are_as_narrow_as_promised`.
const GUARD_BITS: u32 = 48;

/// How often the argument is halved before the series is summed.
const HALVINGS: u32 = 8;

/// Certified bounds `low ≤ atan(q) ≤ high` with `high − low ≤ 2^(1−bits)`.
///
/// Fixed-point arithmetic: atan q = 2⁸ atan q' after eight half-angle steps q' = q / (1 + √(1 + q²)); then the alternating
/// series gives atan q'. Cost: about `bits`/16 products of `bits` bits.
///
/// ```
/// use stellate::exact::{Rational, arctangent};
/// let (low, high) = arctangent(&Rational::one(), 200);
/// assert_eq!((low * Rational::from(4)).to_decimal(50), (high * Rational::from(4)).to_decimal(50));
/// ```
#[must_use]
pub fn arctangent(q: &Rational, bits: u32) -> (Rational, Rational) {
    let precision = bits + GUARD_BITS;
    let Approximation { value, error } = fixed_arctangent(q, precision);
    let bound = |v: Integer| Rational::from_dyadic(v, -i64::from(precision));
    (bound(&value - &error), bound(value + error))
}

/// Certified bounds of π, as [`arctangent`].
#[must_use]
pub fn pi(bits: u32) -> (Rational, Rational) {
    let (low, high) = arctangent(&Rational::one(), bits + 2);
    let four = Rational::from(4);
    (low * &four, high * four)
}

/// An integer near an exact number, and a bound of the distance between the two.
struct Approximation {
    value: Integer,
    error: Integer,
}

/// The number atan(q)·2^precision, with an error that is counted in every step.
///
/// Lemma. In units of 2^−precision, for 0 ≤ q ≤ 1:
/// - Rounding q down to an integer makes an error below 1.
/// - A half-angle step makes an error of at most ⌈e/2⌉ + 2 from an error e. The derivative of the step is at most 1/2. Rounding
///   the root down makes the denominator, which is at least 2·2^precision, smaller by less than 1, so the quotient, which is at
///   most 2^precision/2, becomes larger by less than 1. Rounding the quotient down makes an error below 1.
/// - For x < 2^−7, every computed power x^k is at most 2 too small. Proof by induction: an error of 2 is multiplied by x² <
///   2^−14, the error of the square, which is below 1, is multiplied by x^(k−2) < 2^−7, and the product is rounded down, so the
///   new error is below 2·2^−14 + 2^−7 + 1 < 2. So every term after the first has an error below 2/k + 1 < 2. The first power
///   that is rounded to 0 is below 3, and so is the sum of all terms from there on.
/// - The derivative of atan is at most 1, so the error of x counts once; the doublings at the end multiply the whole error.
///
/// For q > 1 the number is π/2 − atan(1/q), and the errors are added.
///
/// Law: `the_error_is_counted`.
fn fixed_arctangent(q: &Rational, precision: u32) -> Approximation {
    if q.signum() < 0 {
        let Approximation { value, error } = fixed_arctangent(&-q.clone(), precision);
        return Approximation {
            value: -value,
            error,
        };
    }
    if *q > Rational::one() {
        let inverse = q.recip().invariant("a number above 1 is not 0");
        let rest = fixed_arctangent(&inverse, precision);
        let quarter = fixed_arctangent(&Rational::one(), precision);
        return Approximation {
            value: (quarter.value << 1u64) - rest.value,
            error: (quarter.error << 1u64) + rest.error,
        };
    }
    let one = Integer::ONE << precision;
    let mut x = (q * &Rational::whole(&one)).floor_integer();
    let mut error = 1u64;
    for _ in 0..HALVINGS {
        let hypotenuse = ((&one).square() + (&x).square()).floor_sqrt();
        x = (x << precision) / (&one + hypotenuse);
        error = error.div_ceil(2) + 2;
    }
    // x − x³/3 + x⁵/5 − …, x < 2⁻⁷
    let square = (&x).square() >> precision;
    let mut power = x;
    let mut sum = Integer::ZERO;
    let mut k = 1u64;
    while power != 0 {
        let term = &power / Integer::from(k);
        if k % 4 == 1 {
            sum += term;
        } else {
            sum -= term;
        }
        if k > 1 {
            error += 2;
        }
        power = (power * &square) >> precision;
        k += 2;
    }
    // The terms that are left out.
    error += 3;
    Approximation {
        value: sum << HALVINGS,
        error: Integer::from(error) << HALVINGS,
    }
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

    /// Checks that the value at this precision is as near to the value with 300 more bits as its error says, and returns the
    /// part of the error that is used.
    fn share_of_error(q: &Rational, precision: u32) -> f64 {
        let [short, long] = [precision, precision + 300].map(|p| fixed_arctangent(q, p));
        let distance = Rational::whole((short.value << 300u64) - long.value).abs();
        let allowed = short.error << 300u64;
        // The longer value has an error as well.
        assert!(distance <= Rational::whole(&allowed + long.error));
        (distance / Rational::whole(allowed)).to_f64()
    }

    #[test]
    fn the_error_is_counted() {
        let mut largest = 0.0f64;
        for precision in [9, 10, 16, 17, 31, 32, 33, 49, 64, 65, 200, 1000] {
            let ends = [0i64, 1, 2, 3].map(Rational::from);
            let unit = Rational::from_dyadic(Integer::ONE, -i64::from(precision));
            let near = ends.iter().flat_map(|q| {
                let below = &unit * &Rational::from_dyadic(Integer::ONE, -3);
                [q.clone(), q + &below, q - &below, q + &unit, q - &unit]
            });
            let inner = (1..40).map(|k| Rational::from(k) / Rational::from(41));
            for q in near.chain(inner) {
                largest = largest.max(share_of_error(&q, precision));
            }
        }
        assert!(largest > 0.125, "{largest}");
    }

    #[test]
    fn the_bounds_are_as_narrow_as_promised() {
        for bits in [1, 10, 100, 1000, 20_000] {
            for q in [
                Rational::one(),
                Rational::from(7),
                Rational::from(1) / Rational::from(3),
            ] {
                let (low, high) = arctangent(&q, bits);
                let promised = Rational::from_dyadic(Integer::ONE, 1 - i64::from(bits));
                assert!(high - low <= promised, "{bits} bits");
            }
        }
    }

    proptest! {
        #[test]
        fn the_bounds_hold_the_tangent_of_doubles(p in -1_000_000i64..1_000_000, q in 1i64..1_000_000) {
            let x = Rational::from(p) / Rational::from(q);
            let (low, high) = arctangent(&x, 100);
            prop_assert!((low.to_f64() - x.to_f64().atan()).abs() < 1e-15);
            prop_assert!(low < high);
            // atan x + atan 1/x = ±π/2.
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
