//! Forms on the unit circle and their harmonics: two bases of one space.
//!
//! On `x = cos θ, y = sin θ` a form of degree d is a trigonometric polynomial with harmonics
//! n ≡ d (mod 2), n ≤ d, and every such polynomial is one form. With z = x + iy, w = x − iy the
//! harmonics are the coefficients in the basis `z^j w^(d−j)`; the change to the basis
//! `x^(d−k) y^k` is the Möbius substitution (1+T)/(1−T), T = i y/x.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial;

use super::flat::FlatPolynomial;
use super::limbs::negate;
use super::mobius::change_of_basis;
use super::shift::negate_odd;
use super::{BinaryForm, IntegerPolynomial, shift_by_one};
use crate::exact::Rational;

/// `2 Σ_m (a_m Re (x+iy)^m + b_m Im (x+iy)^m) (x²+y²)^((d−m)/2)`, a form of degree d = `degree`.
///
/// `harmonics` lists `(m, a_m, b_m)` with m ≡ d (mod 2) and m ≤ d (Definition 1's K_m, doubled so
/// that everything stays an integer). Cost: about four products of forms of degree d/2, quasi-linear in the size of
/// the answer; below degree 96, d² additions.
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
    let form = doubled_flat_form(degree, harmonics.into_iter(), bits);
    BinaryForm::from_dehomogenized(degree, form.to_polynomial())
}

/// An e with Σ |a_m + b_m| + |a_m − b_m| < 2^e, over the harmonics [a_m, b_m]; at most 2 more than the least one.
pub(crate) fn harmonic_bits<'a>(pairs: impl Iterator<Item = [&'a Integer; 2]> + Clone) -> u64 {
    // Such a sum is twice the larger of |a| and |b|, which is below 2^size. Sums of 2^size are kept in units of
    // 2^(largest − UNITS), each rounded up.
    const UNITS: u64 = 32;
    let sizes = pairs.map(|[a, b]| a.significant_bits().max(b.significant_bits()));
    let largest = sizes.clone().max().unwrap_or(0);
    let units = sizes.map(|size| 1_u64 << UNITS.saturating_sub(largest - size));
    let sum: u64 = units.sum();
    largest + 1 + sum.significant_bits().saturating_sub(UNITS)
}

/// The same form f(1, t) with coefficients of one width, which has room for integers below
/// 2^[`form_bits`](super::form_bits). `bits` is [`harmonic_bits`] or more.
///
/// # Panics
/// If an m is larger than d or of the other parity.
pub(crate) fn doubled_flat_form<'a>(
    degree: usize,
    harmonics: impl Iterator<Item = (usize, &'a Integer, &'a Integer)>,
    bits: u64,
) -> FlatPolynomial {
    flat_form(&doubled_harmonics(degree, harmonics, bits), bits)
}

/// The same in the basis z^j w^(d−j).
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

/// From the basis z^j w^(d−j) to f(1, t).
pub(crate) fn flat_form(g: &FlatPolynomial, bits: u64) -> FlatPolynomial {
    let mut h = change_of_basis(g, bits);
    // i^k: signs + + − −
    for (k, c) in h.coefficients_mut().enumerate() {
        if k % 4 >= 2 {
            negate(c);
        }
    }
    h
}

/// The harmonics `(n, a_n, b_n)` of a form on the unit circle, ascending in n; `b_0 = 0`.
///
/// The inverse of [`doubled_form_from_harmonics`], up to its factor 2, at the same cost.
///
/// ```
/// use stellate::poly::{BinaryForm, harmonics_of_form};
/// // x² = 1/2 + 1/2 cos 2θ
/// let form = BinaryForm::from_coefficients(vec![1.into(), 0.into(), 0.into()]);
/// let text = format!("{:?}", harmonics_of_form(&form));
/// assert_eq!(text, "[(0, 1/2, 0), (2, 1/2, 0)]");
/// ```
#[must_use]
pub fn harmonics_of_form(form: &BinaryForm) -> Vec<(usize, Rational, Rational)> {
    let degree = form.degree();
    let mut h = form.dehomogenized().coefficients_asc().to_vec();
    h.resize(degree + 1, Integer::ZERO);
    twist(&mut h);
    let mut c = shift_by_one(IntegerPolynomial::from_coefficients_asc(h)).into_coefficients_asc();
    c.resize(degree + 1, Integer::ZERO);
    negate_odd(&mut c);
    for (k, value) in c.iter_mut().enumerate() {
        *value <<= k as u64;
    }
    c.reverse();
    let g = shift_by_one(IntegerPolynomial::from_coefficients_asc(c)).into_coefficients_asc();
    let at = |j: usize| g.get(j).cloned().unwrap_or(Integer::ZERO);
    // g is 2^d (a + b) at (d+m)/2 and 2^d (a − b) at (d−m)/2 of half the form.
    let shift = -i64::try_from(degree).unwrap_or(i64::MAX);
    (0..=degree)
        .filter(|m| (degree - m).is_multiple_of(2))
        .map(|m| {
            let (high, low) = (at(usize::midpoint(degree, m)), at((degree - m) / 2));
            if m == 0 {
                (m, Rational::from_parts(high, shift), Rational::zero())
            } else {
                (
                    m,
                    Rational::from_parts(&high + &low, shift),
                    Rational::from_parts(high - low, shift),
                )
            }
        })
        .collect()
}

/// Signs + + − − by k mod 4: what is left of the powers of i.
fn twist(coefficients: &mut [Integer]) {
    for (k, value) in coefficients.iter_mut().enumerate() {
        if k % 4 >= 2 {
            *value = -std::mem::take(value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::Ring;
    use malachite::base::num::arithmetic::traits::Abs;
    use proptest::prelude::*;

    /// Re and Im of (x+iy)^n, by the recurrence of Appendix A.
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
                prop_assert_eq!(Rational::from(a) * Rational::from(2), p);
                prop_assert_eq!(Rational::from(b) * Rational::from(2), q);
            }
        }
    }
}
