//! How many digits the terms of a polynomial lose in coordinates that are not its own.

use std::collections::BTreeMap;

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{SparsePolynomial, total_degree};

/// About how many decimal digits cancel in the terms of a polynomial near its zeros, if it is moved from a center to the origin.
///
/// With M_d as the size of the part of degree d about the center, and M_top of the highest one, the zeros are at a distance of
/// about s = max (M_d/M_top)^(1/(top − d)) from the center. There the terms about the center are of the size max M_d s^d, and
/// those about the origin of the size max |c_e| (|center| + s)^e. A cone has no such distance; that of the center is taken.
pub(super) fn cancelled_digits(
    about: &SparsePolynomial<3>,
    moved: &SparsePolynomial<3>,
    center: &[Rational],
) -> u32 {
    let mut sizes: BTreeMap<u64, f64> = BTreeMap::new();
    for (e, c) in about.terms() {
        let size = sizes.entry(total_degree(e)).or_insert(f64::NEG_INFINITY);
        *size = size.max(log2(c));
    }
    let Some((&top, &highest)) = sizes.last_key_value() else {
        return 0;
    };
    let real = |d: u64| f64::from(u32::try_from(d).invariant("degrees have 32 bits"));
    let lower = sizes.range(..top);
    let distances = lower.map(|(d, size)| (size - highest) / real(top - d));
    let logs: Vec<f64> = center.iter().map(log2).collect();
    let farthest = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let s = distances.reduce(f64::max).unwrap_or(farthest);
    let parts = sizes.iter().map(|(d, size)| size + real(*d) * s);
    let near = parts.fold(f64::NEG_INFINITY, f64::max);
    // log2 (2^a + 2^b)
    let joined = |a: f64, b: f64| a.max(b) + (1.0 + (-(a - b).abs()).exp2()).log2();
    let at: Vec<f64> = logs.iter().map(|&c| joined(c, s)).collect();
    let terms = moved.terms().map(|(e, c)| {
        let powers = e.iter().zip(&at).filter(|(e, _)| **e > 0);
        powers.fold(log2(c), |sum, (e, at)| sum + f64::from(*e) * at)
    });
    let far = terms.fold(f64::NEG_INFINITY, f64::max);
    let digits = ((far - near) * std::f64::consts::LOG10_2).clamp(0.0, 1e6);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the number is clamped"
    )]
    let digits = digits as u32;
    digits
}

/// The binary logarithm of the size of a number, up to 1 beyond the doubles; −∞ for 0.
fn log2(q: &Rational) -> f64 {
    if q.is_zero() {
        return f64::NEG_INFINITY;
    }
    let near = q.to_f64().abs();
    if near.is_normal() {
        return near.log2();
    }
    let bits = |n: &Integer| {
        let bits = u32::try_from(n.significant_bits());
        f64::from(bits.invariant("a number has fewer than 2^32 bits"))
    };
    bits(&q.numerator()) - bits(&q.denominator())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::limits::Limits;

    /// The digits of a form about a center.
    fn digits(text: &str, center: [i64; 3]) -> u32 {
        let about: SparsePolynomial<3> = text.parse().unwrap();
        let center = center.map(Rational::from);
        let back = center.each_ref().map(|c| -c);
        let moved = about.about(&back, &Limits::none()).unwrap();
        cancelled_digits(&about, &moved, &center)
    }

    #[test]
    fn digits_cancel_with_the_degree_and_the_distance() {
        assert_eq!(digits("x - 2z", [1, 0, 3]), 0);
        assert_eq!(digits("x^2 + y^2 + z^2 - 4", [1, 2, 3]), 0);
        // (10⁶)² against 1
        assert_eq!(digits("x^2 + y^2 + z^2 - 1", [1_000_000, 0, 0]), 12);
        let high = digits("x^20 + y^20 - 1 + z^2", [10, 0, 0]);
        assert!((20..30).contains(&high), "{high}");
        assert_eq!(digits("x^20 + y^20 - 1 + z^2", [0, 0, 0]), 0);
    }
}
