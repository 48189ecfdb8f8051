//! The values of a sum of spherical harmonics on a grid of directions, with a bound of their errors.

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;

use crate::error::Invariant;
use crate::exact::Rational;
use crate::intervals::interval::{Interval, relative_error};
use crate::poly::legendre_derivative;
use crate::shape::HarmonicSurface;

/// The number of bits after the point of cos φ at the latitudes.
const BITS: u64 = 40;

/// A sum of spherical harmonics, prepared for exact values on latitudes: for each m the polynomial p with the part `(sin φ)^m p(cos φ)
/// (cos mθ or sin mθ)`, over one denominator.
pub(super) struct Latitudes {
    unit: Rational,
    /// For each m the coefficients of the cosine's and of the sine's polynomial, descending from the power L − m.
    sums: Vec<[Vec<Integer>; 2]>,
}

/// The values on one latitude, in doubles.
pub(super) struct Latitude {
    /// The coefficients (a_m, b_m) of cos mθ and sin mθ.
    pairs: Vec<[f64; 2]>,
    /// Every coefficient is wrong by at most this, all of them together.
    error: f64,
    /// The sum of the absolute values of the coefficients.
    size: f64,
    pub(super) cosine: f64,
}

impl Latitudes {
    pub(super) fn new(surface: &HarmonicSurface) -> Self {
        let degree = surface.degree();
        let (denominator, coefficients) = surface.over_common_denominator();
        let short = |n: usize| u32::try_from(n).invariant("a degree is below 2^32");
        let sums = (0..=degree).map(|m| {
            let order = m.cast_signed();
            [order, -order].map(|signed| {
                let mut sum = vec![Integer::ZERO; degree - m + 1];
                for l in m..=degree {
                    let c = &coefficients[HarmonicSurface::index(l, signed)];
                    if *c == 0 || (m == 0 && signed != order) {
                        continue;
                    }
                    let c = c << (degree - l);
                    for (k, b) in legendre_derivative(short(l), short(m)).iter().enumerate() {
                        sum[degree - l + 2 * k] += b * &c;
                    }
                }
                sum
            })
        });
        let mut sums: Vec<[Vec<Integer>; 2]> = sums.collect();
        // m = 0 has no sine.
        sums[0][1].iter_mut().for_each(|c| *c = Integer::ZERO);
        Self {
            unit: Rational::whole(denominator << degree),
            sums,
        }
    }

    /// The latitude with the cosine nearest to `cosine`.
    #[expect(clippy::cast_possible_truncation, reason = "|cos φ| ≤ 1 has 41 bits")]
    pub(super) fn at(&self, cosine: f64) -> Latitude {
        let scale = 2f64.powi(BITS as i32);
        let numerator = (cosine.clamp(-1.0, 1.0) * scale).round();
        let t = Integer::from(numerator as i64);
        let cosine = numerator / scale;
        let exact = Interval::from(cosine);
        let sine = (Interval::from(1.0) - exact.squared()).or_zero().sqrt();
        let mut power = Interval::from(1.0);
        let (mut error, mut size) = (0.0, 0.0);
        // The unit and the numbers over it may be beyond the largest double, so both are scaled.
        let bits = self.unit.numerator().significant_bits().cast_signed();
        let unit = Interval::from(&(&self.unit * &Rational::from_dyadic(Integer::ONE, -bits)));
        let pairs = self.sums.iter().map(|pair| {
            let values = pair.each_ref().map(|sum| {
                // Horner's rule with t = T/2^BITS: the value is the number over 2^(BITS·degree).
                let mut value = Integer::ZERO;
                for (k, c) in sum.iter().enumerate() {
                    value *= &t;
                    if *c != 0 {
                        value += c << (BITS * k as u64);
                    }
                }
                let shift = BITS * (sum.len() as u64 - 1);
                let shift = i64::try_from(shift).invariant("a degree is small");
                let value = Rational::from_dyadic(value, -shift - bits);
                let value = Interval::from(&value) / unit * power;
                error += (value.high() - value.low()).max(0.0);
                size += value.magnitude();
                value.middle()
            });
            power = power * sine;
            values
        });
        let pairs = pairs.collect();
        Latitude {
            pairs,
            error: error * 1.01,
            size,
            cosine,
        }
    }
}

impl Latitude {
    /// The values at `count` longitudes 2πj/count, each wrong by at most [`Latitude::error`].
    ///
    /// `turns` are the doubles cos and sin of 2πj/count.
    pub(super) fn values<'a>(&'a self, turns: &'a [[f64; 2]]) -> impl Iterator<Item = f64> + 'a {
        let count = turns.len();
        (0..count).map(move |j| {
            let terms = self.pairs.iter().enumerate();
            let terms = terms.map(|(m, [a, b])| {
                let [c, s] = turns[(m * j) % count];
                a * c + b * s
            });
            terms.sum()
        })
    }

    /// A bound of the error of every value: the errors of the coefficients, and with L + 3 roundings for each product, of which the
    /// cosine is one, those of the sum (Lemma 2 of [`relative_error`]). The cosines and sines are those of the mathematical library,
    /// of angles that are wrong by a few units in the last place: 2^(−48) is allowed for each.
    pub(super) fn error(&self) -> f64 {
        let relative = relative_error(self.pairs.len() + 3) + 2f64.powi(-48);
        let bound = Interval::from(self.size) * relative + Interval::from(self.error);
        bound.high()
    }
}
