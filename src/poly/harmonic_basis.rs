//! The change between forms on the unit circle and their harmonics, which are two bases of one space.
//!
//! With `x = cos θ, y = sin θ` a form of degree d is a trigonometric polynomial with harmonics n ≡ d (mod 2), n ≤ d, and every
//! such polynomial comes from exactly one form. With z = x + iy and w = x − iy the harmonics are the coefficients in the basis
//! `z^j w^(d−j)`. The change to the basis `x^(d−k) y^k` is the Möbius substitution (1+T)/(1−T), T = i y/x.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;

use super::BinaryForm;
use crate::bigint::{FlatPolynomial, change_of_basis, negate};
use crate::error::Invariant;
use crate::exact::Rational;

/// `2 Σ_m (a_m Re (x+iy)^m + b_m Im (x+iy)^m) (x²+y²)^((d−m)/2)`, a form of degree d = `degree`.
///
/// `harmonics` lists `(m, a_m, b_m)` with m ≡ d (mod 2) and m ≤ d (the K_m of Definition 1, doubled so that all coefficients
/// are integers). Cost: about four products of forms of degree d/2, which is quasi-linear in the size of the answer, or fewer
/// products modulo primes; for low degrees, d² additions.
///
/// # Panics
/// If an m is larger than d or of the other parity.
#[must_use]
pub fn doubled_form_from_harmonics<'a>(
    degree: usize,
    harmonics: impl IntoIterator<Item = (usize, &'a Integer, &'a Integer)>,
) -> BinaryForm {
    let harmonics: Vec<_> = harmonics.into_iter().collect();
    let bits = harmonic_bits(harmonics.iter().map(|&(_, a, b)| [a, b]));
    let g = doubled_harmonics(degree, harmonics.into_iter(), bits);
    BinaryForm::from_dehomogenized(degree, from_harmonic_basis(&g, bits).to_polynomial())
}

/// An e with Σ |a_m + b_m| + |a_m − b_m| < 2^e, over the harmonics [a_m, b_m]. It is at most 2 more than the least such e.
pub(crate) fn harmonic_bits<'a>(pairs: impl Iterator<Item = [&'a Integer; 2]> + Clone) -> u64 {
    // Each summand is twice the larger of |a| and |b|, which is below 2^size. The sums of 2^size are computed in units of
    // 2^(largest − UNITS), and each summand is rounded up.
    const UNITS: u64 = 32;
    let sizes = pairs.map(|[a, b]| a.significant_bits().max(b.significant_bits()));
    let largest = sizes.clone().max().unwrap_or(0);
    let units = sizes.map(|size| 1_u64 << UNITS.saturating_sub(largest - size));
    let sum: u64 = units.sum();
    largest + 1 + sum.significant_bits().saturating_sub(UNITS)
}

/// The form of [`doubled_form_from_harmonics`] in the basis z^j w^(d−j). `bits` must be at least [`harmonic_bits`].
///
/// # Panics
/// If an m is larger than d or of the other parity.
pub(crate) fn doubled_harmonics<'a>(
    degree: usize,
    harmonics: impl Iterator<Item = (usize, &'a Integer, &'a Integer)>,
    bits: u64,
) -> FlatPolynomial {
    // 2 Σ = Σ_j g_j z^j w^(d−j) with g = a − ib at (d+m)/2 and its conjugate at (d−m)/2. Its
    // symmetric and antisymmetric halves give only even and only odd powers of y, so the one real
    // sequence P + Q carries both.
    let mut g = FlatPolynomial::zero(degree + 1, bits);
    for (m, a, b) in harmonics {
        assert!(
            m <= degree && (degree - m).is_multiple_of(2),
            "harmonic {m} in degree {degree}"
        );
        let (high, low) = (usize::midpoint(degree, m), (degree - m) / 2);
        for (k, negated) in [(high, false), (low, true)] {
            g.add_at(k, a, false);
            g.add_at(k, b, negated);
        }
    }
    g
}

/// Changes from the basis z^j w^(d−j) to f(1, t), with room for integers below 2^[`form_bits`](crate::bigint::form_bits).
pub(crate) fn from_harmonic_basis(g: &FlatPolynomial, bits: u64) -> FlatPolynomial {
    let mut h = change_of_basis(g, bits);
    // The factors i^k have the signs + + − −.
    for (k, c) in h.coefficients_mut().enumerate() {
        if k % 4 >= 2 {
            negate(c);
        }
    }
    h
}

/// The harmonics `(n, a_n, b_n)` of a form on the unit circle, ascending in n; `b_0 = 0`.
///
/// This is the inverse of [`doubled_form_from_harmonics`], without its factor 2 and at the same cost.
#[must_use]
pub(crate) fn harmonics_of_form(form: &BinaryForm) -> Vec<(usize, Rational, Rational)> {
    let exponent = -i64::try_from(form.degree()).invariant("degrees are below 2^63");
    let over = |c| Rational::from_dyadic(c, exponent);
    let harmonics = scaled_harmonics(form).into_iter();
    harmonics.map(|(m, a, b)| (m, over(a), over(b))).collect()
}

/// The harmonics times 2^d, which are integers.
pub(crate) fn scaled_harmonics(form: &BinaryForm) -> Vec<(usize, Integer, Integer)> {
    let degree = form.degree();
    let largest = form.terms().map(|(_, c)| c.significant_bits()).max();
    let bits = largest.unwrap_or(0) + (degree as u64 + 1).significant_bits();
    // With h(T) = (1−T)^d g((1+T)/(1−T)) and S = (1+T)/(1−T): 2^d g(S) = Σ h_k (S−1)^k (S+1)^(d−k).
    let mut h = FlatPolynomial::zero(degree + 1, bits);
    for (k, c) in form.terms() {
        // The signs are those of i^k, + + − −, times (−1)^k.
        h.add_at(degree - k, c, k % 4 == 1 || k % 4 == 2);
    }
    let g: Vec<Integer> = change_of_basis(&h, bits).to_integers(0).collect();
    // For half of the form, g is 2^d (a + b) at (d+m)/2 and 2^d (a − b) at (d−m)/2.
    let indices = (0..=degree).filter(|m| (degree - m).is_multiple_of(2));
    let harmonics = indices.map(|m| {
        let (high, low) = (&g[usize::midpoint(degree, m)], &g[(degree - m) / 2]);
        if m == 0 {
            (m, high.clone(), Integer::ZERO)
        } else {
            (m, high + low, high - low)
        }
    });
    harmonics.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::Ring;
    use malachite::base::num::arithmetic::traits::Abs;
    use proptest::prelude::*;

    #[test]
    fn a_square_is_half_of_one_and_of_the_second_harmonic() {
        let half = || Rational::from_dyadic(1.into(), -1);
        let found = harmonics_of_form(&BinaryForm::new([1, 0, 0]));
        let zero = Rational::zero;
        assert_eq!(found, [(0, half(), zero()), (2, half(), zero())]);
    }

    /// The real and the imaginary part of (x+iy)^n, by the recurrence of Appendix A.
    fn re_im(n: usize) -> (BinaryForm, BinaryForm) {
        let x = BinaryForm::from_coefficients(vec![1.into(), 0.into()]);
        let y = BinaryForm::from_coefficients(vec![0.into(), 1.into()]);
        let mut pair = (
            BinaryForm::from_coefficients(vec![1.into()]),
            BinaryForm::zero(0),
        );
        for _ in 0..n {
            let (re, im) = &pair;
            pair = (
                re.times(&x).minus(&im.times(&y)),
                re.times(&y).plus(&im.times(&x)),
            );
        }
        pair
    }

    #[test]
    fn appendix_a() {
        // cos 4θ = c⁴ − 6c²s² + s⁴, sin 4θ = 4c³s − 4cs³, and so on: Re and Im of (c + is)^n.
        for n in 0..=9 {
            let (re, im) = re_im(n);
            let (one, zero) = (Integer::from(1), Integer::ZERO);
            let cos = doubled_form_from_harmonics(n, [(n, &one, &zero)]);
            assert_eq!(cos.div_exact(&2.into()), re);
            let sin = doubled_form_from_harmonics(n, [(n, &zero, &one)]);
            if n > 0 {
                assert_eq!(sin.div_exact(&2.into()), im);
            }
        }
        let cos4 = re_im(4).0;
        assert_eq!(
            cos4,
            BinaryForm::from_coefficients([1, 0, -6, 0, 1].map(Integer::from).to_vec())
        );
    }

    proptest! {
        #[test]
        fn harmonics_add_up_to_less_than_is_said(pairs in prop::collection::vec((any::<i64>(), any::<i64>(), 0u64..90), 0..60)) {
            let pairs: Vec<[Integer; 2]> = pairs
                .iter()
                .map(|(a, b, by)| [Integer::from(*a) >> *by, Integer::from(*b) << (90 - *by)])
                .collect();
            let sums = pairs.iter().flat_map(|[a, b]| [a + b, a - b]);
            let sum = sums.fold(Integer::ZERO, |sum, c| sum + c.abs());
            let said = harmonic_bits(pairs.iter().map(|[a, b]| [a, b]));
            prop_assert!(sum < Integer::from(1) << said);
        }

        #[test]
        fn harmonics_and_forms_are_inverse(c in prop::collection::vec((any::<i32>(), any::<i32>()), 1..40), odd in any::<bool>()) {
            let degree = 2 * (c.len() - 1) + usize::from(odd);
            let list: Vec<(usize, Integer, Integer)> = c
                .iter()
                .enumerate()
                .map(|(k, (a, b))| {
                    let m = 2 * k + usize::from(odd);
                    (m, Integer::from(*a), Integer::from(if m == 0 { 0 } else { *b }))
                })
                .collect();
            let form = doubled_form_from_harmonics(degree, list.iter().map(|(m, a, b)| (*m, a, b)));
            for ((m, a, b), (n, p, q)) in list.iter().zip(harmonics_of_form(&form)) {
                prop_assert_eq!(*m, n);
                prop_assert_eq!(Rational::whole(a) * Rational::from(2), p);
                prop_assert_eq!(Rational::whole(b) * Rational::from(2), q);
            }
        }
    }
}
