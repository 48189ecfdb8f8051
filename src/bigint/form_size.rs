//! Bounds of the coefficients of a form, from the sum of its coefficients in another basis.
//!
//! Lemma 1. Every coefficient of `Σ_j g_j (1+T)^j (1−T)^(d−j)` with Σ |g_j| < 2^b is below 2 to the power b + d − ⌊⌊log₂ d⌋/2⌋, d ≥ 1.
//! Proof. The k-th coefficient of (1+T)^j (1−T)^(d−j) is in absolute value at most that of (1+T)^d, which is C(d, k) ≤ C(d,
//! ⌊d/2⌋). And C(2m, m) ≤ 4^m/√(2m), C(2m + 1, m) = C(2m + 2, m + 1)/2 ≤ 2^(2m + 1)/√(2m + 2); so C(d, ⌊d/2⌋) is at most 2^d/√d
//! ≤ 2^(d − ⌊log₂ d⌋/2).
//! Law: `binomials_have_the_bits_that_are_said`, where the bound is reached within two bits.
//!
//! Lemma 2. If all coefficients of a polynomial f are non-negative, the k-th one is at most f(t)/t^k for every t > 0. The
//! logarithm of f(t)/t^k is a linear function of k, so the larger of its values at the ends of a range of k is a bound for the
//! whole range.
//! Proof. All terms of f(t) are non-negative, and c_k t^k is one of them.
//! Law: `no_coefficient_is_larger_than_is_said`, with the coefficients that are as large as they can be.

use crate::error::Invariant;
use std::ops::Range;

/// The exponent of a power of 2 that is above every coefficient of `Σ_j g_j (1+T)^j (1−T)^(d−j)`, if Σ |g_j| < 2^`bits`. Lemma
/// 1.
pub(crate) fn form_bits(degree: usize, bits: u64) -> u64 {
    let degree = degree as u64;
    bits + degree - u64::from(degree.max(1).ilog2()) / 2
}

/// The sizes of the coefficients of `(1 + t²)^power f(1, t)`, where f is a form whose coefficients in z^j w^(d−j) have absolute
/// values that add up to less than 2^`bits`. They are below those of `2^bits (1 + t²)^power (1 + t)^degree`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FormSize {
    pub(crate) power: usize,
    pub(crate) degree: usize,
    pub(crate) bits: u64,
}

impl FormSize {
    /// The number of coefficients.
    pub(crate) fn len(self) -> usize {
        2 * self.power + self.degree + 1
    }

    /// The exponent of a power of 2 that is above all coefficients.
    pub(crate) fn largest(self) -> u64 {
        form_bits(self.degree, self.bits) + self.power as u64
    }

    /// The exponent of a power of 2 that is above all coefficients in this range. Lemma 2 for the absolute values of the
    /// coefficients.
    pub(crate) fn largest_of(self, range: Range<usize>) -> u64 {
        // Degrees are small enough for doubles.
        let float = |n: usize| f64::from(u32::try_from(n).invariant("degrees are below 2^32"));
        let middle = float(range.start + range.end) / 2.0;
        // The t for which the term of `middle` in (1 + t)^(len − 1) is the largest.
        let t = middle / (float(self.len()) - middle);
        let value = float(self.power) * (t * t).ln_1p() + float(self.degree) * t.ln_1p();
        let bits = |k: usize| (value - float(k) * t.ln()) / std::f64::consts::LN_2;
        let bits = bits(range.start).max(bits(range.end - 1));
        // The logarithms are below 2^33 and have relative errors of about 2^-50, so adding 1 is more than enough.
        (whole(bits) + 1 + self.bits).min(self.largest())
    }
}

/// The smallest integer that is at least a number. The number is small, and it is negative only by rounding.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "it is small and not negative"
)]
fn whole(a: f64) -> u64 {
    a.ceil() as u64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bigint::binomials;
    use malachite::Integer;
    use malachite::base::num::arithmetic::traits::Pow;
    use malachite::base::polynomial::Polynomial;
    use malachite::integer_polynomial::IntegerPolynomial;
    use proptest::prelude::*;

    #[test]
    fn binomials_have_the_bits_that_are_said() {
        for n in 0..300 {
            let largest = &binomials(n)[n / 2];
            let bits = form_bits(n, 0);
            assert!(*largest <= Integer::from(1) << bits, "{n}");
            assert!(largest << 2u64 >= Integer::from(1) << bits, "{n}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        #[test]
        fn no_coefficient_is_larger_than_is_said(
            power in 0usize..60, degree in 0usize..200, bits in 0u64..9, start in 0usize..400, count in 1usize..70,
        ) {
            let polynomial = |c: &[i32]| IntegerPolynomial::from_coefficients_asc(c.iter().map(|c| Integer::from(*c)).collect());
            let largest = polynomial(&[1, 0, 1]).pow(power as u64) * polynomial(&[1, 1]).pow(degree as u64);
            let size = FormSize { power, degree, bits };
            let coefficients = largest.coefficients_asc();
            prop_assert_eq!(coefficients.len(), size.len());
            let start = start % size.len();
            let range = start..size.len().min(start + count);
            let said = size.largest_of(range.clone());
            prop_assert!(said <= size.largest());
            for c in &coefficients[range] {
                prop_assert!(c << bits <= Integer::from(1) << said);
            }
        }
    }
}
