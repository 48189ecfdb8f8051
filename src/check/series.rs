//! Values of a Fourier radius at angles that are rational numbers, such as doubles. Such a value is in general transcendental,
//! so it is enclosed between rational bounds.

use std::cmp::Ordering;
use std::convert::Infallible;

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;

use crate::error::Invariant;
use crate::exact::{Rational, cosine_and_sine, nearest_double};
use crate::shape::FourierRadius;

/// The number of bits in the first enclosure.
const FIRST_BITS: u32 = 128;

/// The coefficients of a radius over their common denominator D, ready for values r(θ).
#[derive(Clone, Debug)]
pub struct SeriesValues {
    denominator: Integer,
    cos: Vec<Integer>,
    sin: Vec<Integer>,
    /// D Σ (|a_n| + |b_n|)
    size: Integer,
}

impl SeriesValues {
    /// Prepares the values of this radius.
    #[must_use]
    pub fn new(radius: &FourierRadius) -> Self {
        let (denominator, cos, sin) = radius.over_common_denominator();
        let sizes = cos.iter().chain(&sin);
        let size = sizes
            .map(|c| Integer::from(c.unsigned_abs_ref().clone()))
            .sum();
        Self {
            denominator,
            cos,
            sin,
            size,
        }
    }

    /// Bounds low ≤ r(θ) ≤ high for the angle θ that is exactly `theta`. They are at most 2^−bits Σ (|a_n| + |b_n|) apart, and
    /// equal for a circle and for θ = 0.
    ///
    /// The points (cos nθ, sin nθ) follow from each other by rotations in fixed-point arithmetic with p bits after the point.
    ///
    /// Lemma. After n < 2^(p−5) rotations the error of either coordinate is less than 6n units of 2^−p.
    /// Proof. The cosine and the sine of θ have errors below 5/4: one quarter from their bounds and one from rounding down. So
    /// a rotation adds less than √2·5/4 for them, √2 for rounding two coordinates down, and, since the error so far is less
    /// than 6·2^(p−5), less than √2·5/4·6/32 for the product of both errors. The sum is below 4.
    /// Law: `the_bounds_hold_the_sum_of_the_series`.
    ///
    /// So r(θ) has an error of less than 6(N + 1) Σ (|a_n| + |b_n|) units, and p is chosen so that twice this is at most
    /// 2^−bits Σ (|a_n| + |b_n|).
    ///
    /// Cost: a cosine and a sine, and for each harmonic four products of numbers of about `bits` + log₂ N bits and two with
    /// coefficients.
    ///
    /// ```
    /// use stellate::check::SeriesValues;
    /// use stellate::exact::Rational;
    /// use stellate::shape::FourierRadius;
    /// let radius = FourierRadius::new(vec![2.into(), 1.into()], vec![]);
    /// let [low, high] = SeriesValues::new(&radius).bounds(&Rational::from(1), 100);
    /// assert_eq!(low.to_decimal(20), "2.54030230586813971740");
    /// assert_eq!(high.to_decimal(20), "2.54030230586813971740");
    /// ```
    #[must_use]
    pub fn bounds(&self, theta: &Rational, bits: u32) -> [Rational; 2] {
        let count = Integer::from(self.cos.len());
        let more = u32::try_from(count.significant_bits());
        let more = more.invariant("a number of harmonics is short");
        let precision = bits.saturating_add(more).saturating_add(5);
        let [sum, _] = self.sums(theta, precision);
        let below = &self.denominator << precision;
        let over = |v: Integer| {
            Rational::from_integers(v, below.clone()).invariant("a denominator is not 0")
        };
        if theta.is_zero() || self.cos.len() == 1 {
            return [over(sum.clone()), over(sum)];
        }
        let error = &self.size * Integer::from(6) * count;
        [over(&sum - &error), over(sum + error)]
    }

    /// The double nearest to r(θ), with proof.
    ///
    /// ```
    /// use stellate::check::SeriesValues;
    /// use stellate::exact::Rational;
    /// use stellate::shape::FourierRadius;
    /// let radius = FourierRadius::new(vec![2.into(), 1.into()], vec![]);
    /// let r = SeriesValues::new(&radius).nearest_double(&Rational::from(1));
    /// assert_eq!(r, 2.540_302_305_868_139_7);
    /// ```
    #[must_use]
    pub fn nearest_double(&self, theta: &Rational) -> f64 {
        let [guess, _] = self.bounds(theta, FIRST_BITS);
        let compare = |bound: &Rational| {
            let mut bits = FIRST_BITS;
            loop {
                let [low, high] = self.bounds(theta, bits);
                if low > *bound {
                    return Ok::<_, Infallible>(Ordering::Greater);
                }
                if high < *bound {
                    return Ok(Ordering::Less);
                }
                // If r(θ) equals the rational bound, the enclosure is a single point: r(θ) is rational only for a circle and
                // for θ = 0, because e^(iθ) is transcendental for every other rational θ (Lindemann).
                if low == high {
                    return Ok(Ordering::Equal);
                }
                bits *= 2;
            }
        };
        let Ok(double) = nearest_double(guess.to_f64(), compare);
        double
    }

    /// The condition of r(θ) with respect to independent relative errors of the coefficients: (Σ |a_n cos nθ| + |b_n sin
    /// nθ|)/|r(θ)|, approximated with 128 bits; infinite where this gives r(θ) = 0.
    #[must_use]
    pub fn condition(&self, theta: &Rational) -> f64 {
        let [sum, sizes] = self.sums(theta, FIRST_BITS);
        let sum = Integer::from(sum.unsigned_abs_ref().clone());
        Rational::from_integers(sizes, sum).map_or(f64::INFINITY, |q| q.to_f64())
    }

    /// D 2^precision Σ (a_n cos nθ + b_n sin nθ), and the same sum with the sizes of all terms. Both are approximate;
    /// `SeriesValues::bounds` bounds the error of the first.
    fn sums(&self, theta: &Rational, precision: u32) -> [Integer; 2] {
        let unit = Integer::ONE << precision;
        let fixed = |v: Rational| (v * Rational::whole(&unit)).floor_integer();
        let [c, s] = cosine_and_sine(theta, precision + 2).map(fixed);
        let (mut re, mut im) = (unit.clone(), Integer::ZERO);
        let [mut sum, mut sizes] = [Integer::ZERO, Integer::ZERO];
        for (a, b) in self.cos.iter().zip(&self.sin) {
            for term in [a * &re, b * &im] {
                sizes += Integer::from(term.unsigned_abs_ref().clone());
                sum += term;
            }
            let next = (&re * &c - &im * &s) >> precision;
            im = (re * &s + im * &c) >> precision;
            re = next;
        }
        [sum, sizes]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn radius(c: &[(i32, i32)]) -> FourierRadius {
        let tenth = |v: i32| Rational::from(v) / Rational::from(10);
        let (cos, sin) = c.iter().map(|&(a, b)| (tenth(a), tenth(b))).unzip();
        FourierRadius::new(cos, sin)
    }

    proptest! {
        /// The oracle computes every cos nθ and sin nθ separately, and sums the series term by term.
        #[test]
        fn the_bounds_hold_the_sum_of_the_series(
            c in prop::collection::vec((-50i32..50, -50i32..50), 1..30), theta in -50f64..50.0, bits in 60u32..200
        ) {
            let r = radius(&c);
            let theta = Rational::try_from(theta).unwrap();
            let [low, high] = SeriesValues::new(&r).bounds(&theta, bits);
            let mut sum = Rational::zero();
            let mut size = Rational::zero();
            for n in 0..=r.harmonics() {
                let angle = &theta * &Rational::whole(Integer::from(n));
                let [c, s] = cosine_and_sine(&angle, bits + 60);
                sum = sum + r.cos(n) * &c + r.sin(n) * &s;
                size = size + r.cos(n).abs() + r.sin(n).abs();
            }
            let slack = &size * &Rational::from_dyadic(Integer::ONE, -i64::from(bits) - 60);
            prop_assert!(&low - &slack <= sum && sum <= &high + &slack);
            prop_assert!(high - low <= size * Rational::from_dyadic(Integer::ONE, -i64::from(bits)));
        }

        /// Bounds with many bits lie within bounds with few bits.
        #[test]
        fn bounds_shrink(c in prop::collection::vec((-50i32..50, -50i32..50), 1..20), theta in -9f64..9.0) {
            let values = SeriesValues::new(&radius(&c));
            let theta = Rational::try_from(theta).unwrap();
            let [a, d] = values.bounds(&theta, 20);
            let [b, c] = values.bounds(&theta, 300);
            prop_assert!(a <= b && b <= c && c <= d);
        }
    }
}
