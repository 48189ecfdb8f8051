//! Values of a sum of spherical harmonics at angles that are rational numbers, such as doubles, between rational bounds.

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial;

use crate::error::Invariant;
use crate::exact::{Rational, cosine_and_sine};
use crate::poly::with_integers;
use crate::shape::{HarmonicPair, HarmonicSurface, wave_coefficients};

/// A radius as a sum of products of a wave of θ and one of φ, over a common denominator D.
#[derive(Clone, Debug)]
pub(super) struct SphericalValues {
    degree: usize,
    denominator: Integer,
    /// For cos mθ and sin mθ, at 2m and 2m + 1: the coefficients D c by n, of cos nφ for even m and of sin nφ for odd m.
    rows: Vec<Vec<Integer>>,
    /// D times the sum of the sizes of all coefficients.
    size: Integer,
}

impl SphericalValues {
    pub(super) fn new(surface: &HarmonicSurface) -> Self {
        let degree = surface.degree();
        let terms = wave_coefficients(&HarmonicPair::new(surface), [0, 1, 2]);
        let numbers: Vec<Rational> = terms.iter().map(|(.., c)| c.clone()).collect();
        let (scaled, denominator) = with_integers(&numbers);
        let mut rows = vec![vec![Integer::ZERO; degree + 1]; 2 * degree + 2];
        let mut size = Integer::ZERO;
        for ((m, is_sine, n, _), c) in terms.iter().zip(scaled.into_coefficients_asc()) {
            size += Integer::from(c.unsigned_abs_ref().clone());
            rows[2 * m + usize::from(*is_sine)][*n] = c;
        }
        Self {
            degree,
            denominator,
            rows,
            size,
        }
    }

    /// The sum of the sizes of all coefficients, which bounds |R|.
    pub(super) fn size(&self) -> Rational {
        Rational::from_integers(self.size.clone(), self.denominator.clone())
            .invariant("a denominator is not 0")
    }

    /// Bounds low ≤ R(θ, φ) ≤ high, at most 2^−bits times [`Self::size`] apart, and equal for a sphere.
    ///
    /// Lemma. With p bits after the point, the powers of `(cos θ, sin θ)` and `(cos φ, sin φ)` are wrong by less than 6m and 6n units of 2^−p
    /// (the lemma of `SeriesValues::bounds`). So with coefficients c the sum over n is wrong by at most 6L Σ|c| units, and its product with
    /// a wave of θ, rounded down, by at most (12L + 1) Σ|c| + 1 units, for 2L + 1 products.
    ///
    /// Law: `bounds_hold_the_exact_value`.
    pub(super) fn bounds(&self, theta: &Rational, phi: &Rational, bits: u32) -> [Rational; 2] {
        let count = Integer::from(12 * self.degree + 2);
        let more = u32::try_from(count.significant_bits()).invariant("a degree is short");
        let precision = bits.saturating_add(more).saturating_add(4);
        let [of_theta, of_phi] = [theta, phi].map(|angle| powers(angle, self.degree, precision));
        let mut sum = Integer::ZERO;
        for (k, row) in self.rows.iter().enumerate() {
            let (m, is_sine) = (k / 2, k % 2);
            if row.iter().all(|c| *c == 0) {
                continue;
            }
            let parity = m % 2;
            let inner = row.iter().zip(&of_phi).map(|(c, wave)| c * &wave[parity]);
            let inner = inner.fold(Integer::ZERO, |sum, x| sum + x);
            sum += (inner * &of_theta[m][is_sine]) >> precision;
        }
        let below = &self.denominator << precision;
        let over = |v: Integer| {
            Rational::from_integers(v, below.clone()).invariant("a denominator is not 0")
        };
        if self.degree == 0 {
            return [over(sum.clone()), over(sum)];
        }
        let error = &self.size * count + Integer::from(2 * self.degree + 1);
        [over(&sum - &error), over(sum + error)]
    }
}

/// cos nα and sin nα for n ≤ `last`, in units of 2^−precision.
fn powers(angle: &Rational, last: usize, precision: u32) -> Vec<[Integer; 2]> {
    let unit = Integer::ONE << precision;
    let fixed = |v: Rational| (v * Rational::whole(&unit)).floor_integer();
    let [c, s] = cosine_and_sine(angle, precision + 2).map(fixed);
    let mut found = vec![[unit, Integer::ZERO]];
    for _ in 0..last {
        let [re, im] = &found[found.len() - 1];
        let next = [
            (re * &c - im * &s) >> precision,
            (re * &s + im * &c) >> precision,
        ];
        found.push(next);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        /// At rational points of the sphere the exact value is known; their angles are only near.
        #[test]
        fn bounds_hold_the_exact_value(
            list in prop::collection::vec((0usize..8, 0usize..15, -9i64..10), 1..7),
            theta in -3.0f64..3.0, phi in 0.0f64..3.0,
        ) {
            let terms = list.into_iter().map(|(l, m, c)| {
                ((l, (m % (2 * l + 1)) as isize - l as isize), Rational::from(c))
            });
            let surface = HarmonicSurface::new(terms).unwrap();
            let values = SphericalValues::new(&surface);
            let [theta, phi] = [theta, phi].map(|x| Rational::try_from(x).unwrap());
            let [low, high] = values.bounds(&theta, &phi, 60);
            let [below, above] = values.bounds(&theta, &phi, 200);
            prop_assert!(low <= below && below <= above && above <= high);
            prop_assert!(&high - &low <= values.size() * Rational::from_dyadic(1.into(), -60) + Rational::from_dyadic(1.into(), -60));
            // A rational direction near these angles, by half angles.
            let tangent = |x: &Rational| {
                let near = (x.to_f64() / 2.0).tan();
                Rational::simplest_between(
                    &Rational::try_from(near - 1e-9).unwrap(),
                    &Rational::try_from(near + 1e-9).unwrap(),
                )
            };
            let [s, t] = [tangent(&theta), tangent(&phi)];
            let circle = |s: &Rational| {
                let square = s * s;
                let below = Rational::one() + &square;
                [(Rational::one() - square) / &below, s * Rational::from(2) / below]
            };
            let ([ct, st], [cp, sp]) = (circle(&s), circle(&t));
            let exact = HarmonicPair::new(&surface).value(&[&sp * ct, sp * st, cp]);
            prop_assert!((exact - low).abs().to_f64() <= 1e-6 * values.size().to_f64().max(1.0));
        }
    }
}
