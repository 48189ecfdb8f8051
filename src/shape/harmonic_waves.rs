//! The radius of a harmonic surface as a sum of products of a wave of θ and one of φ.
//!
//! It is `R(θ, φ) = Σ (a_mn cos mθ + b_mn sin mθ) w_mn(φ)` for m, n ≤ L, where w_mn(φ) is cos nφ for even m and sin nφ for odd m.

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};

use super::HarmonicPair;
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{BinaryForm, TernaryForm, scaled_harmonics};

/// The exact coefficients a_mn and b_mn, as (m, whether it is b, n, coefficient).
pub(crate) type WaveCoefficients = Vec<(usize, bool, usize, Rational)>;

/// The coefficients in the coordinates (x_i, x_j, x_k) for `axes` = [i, j, k]: there, θ is the angle from x_i towards x_j, and φ the angle
/// from x_k.
///
/// A form of degree d is a sum of binary forms in the first two coordinates, of degrees d − k, times the k-th power of the third. On
/// the sphere a harmonic m of such a form is `(cos φ)^k (sin φ)^(d−k)` times cos mθ or sin mθ.
pub(crate) fn wave_coefficients(pair: &HarmonicPair, axes: [usize; 3]) -> WaveCoefficients {
    let forms = pair.odd().into_iter().chain([pair.even()]);
    let mut found = Vec::new();
    for form in forms.filter(|form| !form.is_zero()) {
        let degree = form.degree();
        let terms = form
            .terms()
            .map(|(e, c)| (axes.map(|axis| e[axis]), c.clone()));
        let turned = TernaryForm::from_terms(degree, terms);
        let waves = power_products(degree);
        // By m: the sums for cosines and for sines, by n.
        let mut sums = vec![
            [
                vec![Integer::ZERO; degree + 1],
                vec![Integer::ZERO; degree + 1]
            ];
            degree + 1
        ];
        for (k, row) in turned
            .rows()
            .iter()
            .enumerate()
            .filter(|(_, row)| !BinaryForm::is_zero(row))
        {
            for (m, a, b) in scaled_harmonics(row) {
                for (sum, c) in sums[m].iter_mut().zip([a << k, b << k]) {
                    if c == 0 {
                        continue;
                    }
                    for (sum, wave) in sum.iter_mut().zip(&waves[k]) {
                        *sum += &c * wave;
                    }
                }
            }
        }
        let unit = pair.unit() << (2 * degree);
        for (m, pair) in sums.into_iter().enumerate() {
            for (sum, is_sine) in pair.into_iter().zip([false, true]) {
                let terms = sum.into_iter().enumerate().filter(|(_, c)| *c != 0);
                found.extend(terms.map(|(n, c)| {
                    let value = Rational::from_integers(c, unit.clone());
                    (m, is_sine, n, value.invariant("a denominator is not 0"))
                }));
            }
        }
    }
    found
}

/// For each k the coefficients w_n of `(2 cos φ)^k (2 sin φ)^(d−k) = Σ w_n cos nφ`, or of sines if d − k is odd.
///
/// With z = e^(iφ) and j = d − k this is `i^(−j) z^(−d) (z² + 1)^k (z² − 1)^j`.
fn power_products(degree: usize) -> Vec<Vec<Integer>> {
    // (w − 1)^d, and each next product is the one before times (w + 1)/(w − 1).
    let mut product = vec![Integer::ONE];
    for _ in 0..degree {
        product.push(Integer::ZERO);
        for at in (0..product.len()).rev() {
            let below = at
                .checked_sub(1)
                .map_or(Integer::ZERO, |at| product[at].clone());
            product[at] = below - &product[at];
        }
    }
    let zero = Integer::ZERO;
    let mut found = Vec::with_capacity(degree + 1);
    for k in 0..=degree {
        let j = degree - k;
        let sign = if j / 2 % 2 == 1 { -1 } else { 1 };
        let mut waves = vec![Integer::ZERO; degree + 1];
        for n in (0..=degree).filter(|n| n % 2 == degree % 2) {
            let twice = if n == 0 { 1 } else { 2 };
            waves[n] = &product[usize::midpoint(degree, n)] * Integer::from(sign * twice);
        }
        if j % 2 == 1 && degree.is_multiple_of(2) {
            waves[0] = Integer::ZERO;
        }
        found.push(waves);
        if j == 0 {
            break;
        }
        // Division by w − 1 from the top, then multiplication by w + 1.
        let mut quotient = vec![Integer::ZERO; degree];
        let mut carry = Integer::ZERO;
        for at in (0..degree).rev() {
            carry += &product[at + 1];
            quotient[at] = carry.clone();
        }
        for (at, value) in product.iter_mut().enumerate() {
            let below = at.checked_sub(1).map_or(&zero, |at| &quotient[at]);
            *value = below + quotient.get(at).unwrap_or(&zero);
        }
    }
    found
}
