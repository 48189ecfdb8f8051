//! How large the coefficients of a form can be, whose coefficients in another basis are known to be small.
//!
//! Lemma 1. Every coefficient of `Σ_j g_j (1+T)^j (1−T)^(d−j)` with Σ |g_j| < 2^b is below 2 to the power b + d − ⌊⌊log₂ d⌋/2⌋, d ≥ 1.
//! Proof. The k-th coefficient of (1+T)^j (1−T)^(d−j) is at most C(d, k) ≤ C(d, ⌊d/2⌋), as absolute values are those of (1+T)^d at most. And
//! C(2m, m) ≤ 4^m/√(2m), C(2m + 1, m) = C(2m + 2, m + 1)/2 ≤ 2^(2m + 1)/√(2m + 2): at most 2^d/√d ≤ 2^(d − ⌊log₂ d⌋/2).
//! Law: `binomials_have_the_bits_that_are_said`, where the bound is reached within two bits.
//!
//! Lemma 2. The k-th coefficient of a polynomial f with coefficients that are not negative is at most f(t)/t^k for every t > 0, and
//! log f(t)/t^k is a linear function of k, so that the larger one of its values at the ends of a range bounds all between.
//! Proof. All terms of f(t) are non-negative, and c_k t^k is one of them.
//! Law: `no_coefficient_is_larger_than_is_said`, with the coefficients that are as large as they can be.

use crate::error::Invariant;
use std::ops::Range;

/// Every coefficient of `Σ_j g_j (1+T)^j (1−T)^(d−j)` is below 2 to this power, if Σ |g_j| < 2^`bits`. Lemma 1.
pub(crate) fn form_bits(degree: usize, bits: u64) -> u64 {
    let degree = degree as u64;
    bits + degree - u64::from(degree.max(1).ilog2()) / 2
}

/// The coefficients of `(1 + t²)^power f(1, t)`, f a form with coefficients in z^j w^(d−j) that add up to less than
/// 2^`bits`: below those of `2^bits (1 + t²)^power (1 + t)^degree`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FormSize {
    pub(crate) power: usize,
    pub(crate) degree: usize,
    pub(crate) bits: u64,
}

impl FormSize {
    /// How many they are.
    pub(crate) fn len(self) -> usize {
        2 * self.power + self.degree + 1
    }

    /// All are below 2 to this power.
    pub(crate) fn largest(self) -> u64 {
        form_bits(self.degree, self.bits) + self.power as u64
    }

    /// Those in this range are below 2 to this power. Lemma 2, with absolute values of coefficients for the coefficients.
    pub(crate) fn largest_of(self, range: Range<usize>) -> u64 {
        // Degrees are small.
        let float = |n: usize| f64::from(u32::try_from(n).invariant("degrees are below 2^32"));
        let middle = float(range.start + range.end) / 2.0;
        // Where the k-th term of (1 + t)^(len − 1) is the largest.
        let t = middle / (float(self.len()) - middle);
        let value = float(self.power) * (t * t).ln_1p() + float(self.degree) * t.ln_1p();
        let bits = |k: usize| (value - float(k) * t.ln()) / std::f64::consts::LN_2;
        let bits = bits(range.start).max(bits(range.end - 1));
        // One more is far more than the errors of the logarithms: some 2^-50 of numbers that are below 2^33.
        (whole(bits) + 1 + self.bits).min(self.largest())
    }
}

/// The least integer that is not below a number, which is small, and not negative but for rounding.
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
