//! The coefficients of a curve, scaled so that they can be summed without overflow.

use malachite::Integer;

use super::waves::BITS;
use crate::error::Invariant;
use crate::exact::Rational;

/// The largest exponent of the unit; the squares of all distances that occur are then normal doubles.
const LARGEST_EXPONENT: i64 = 900;

/// The coefficients of a Fourier series: those of the cosines and those of the sines, for n = 0, …, H.
pub(in crate::inspect) type Waveform = [Vec<Rational>; 2];

/// The coefficients of N Fourier series in units of a power of two, so that the sum of their sizes is at most 1.
#[derive(Debug)]
pub(super) struct Scaled<const N: usize> {
    /// The unit is 2^exponent.
    exponent: i32,
    /// The coefficients of the cosine and the sine, by coordinate and by n, rounded to multiples of 2^(−62).
    fixed: [Vec<[i64; 2]>; N],
    /// The nearest doubles.
    doubles: [Vec<[f64; 2]>; N],
}

impl<const N: usize> Scaled<N> {
    /// `None` if the sizes are not within the range of doubles. All lists of a coordinate are equally long.
    pub(super) fn new(series: &[Waveform; N]) -> Option<Self> {
        let all = series.iter().flatten().flatten();
        let size: f64 = all.map(|c| c.to_f64().abs()).sum();
        // The sum is wrong by far less than half of itself.
        let exponent = match size {
            0.0 => 0,
            _ => exponent_above(size)? + 1,
        };
        let unit = Rational::from_dyadic(Integer::from(1), -exponent);
        let count = series
            .iter()
            .flatten()
            .map(Vec::len)
            .max()
            .invariant("a series has lists");
        let list = |by_kind: &Waveform| -> Vec<[Rational; 2]> {
            let at = |list: &Vec<Rational>, n: usize| {
                list.get(n).map_or_else(Rational::zero, |c| c * &unit)
            };
            (0..count)
                .map(|n| by_kind.each_ref().map(|list| at(list, n)))
                .collect()
        };
        let lists = series.each_ref().map(list);
        let [scale, half] =
            [i64::from(BITS), -1].map(|bits| Rational::from_dyadic(Integer::from(1), bits));
        let fixed = |c: &Rational| {
            let units = (c * &scale + &half).floor_integer();
            i64::try_from(&units).invariant("a scaled coefficient is at most 1")
        };
        Some(Self {
            exponent: i32::try_from(exponent).invariant("the exponent is small"),
            fixed: lists
                .each_ref()
                .map(|list| list.iter().map(|pair| pair.each_ref().map(fixed)).collect()),
            doubles: lists.each_ref().map(|list| {
                list.iter()
                    .map(|pair| pair.each_ref().map(Rational::to_f64))
                    .collect()
            }),
        })
    }

    /// The exponent of the unit, a power of two.
    pub(super) fn exponent(&self) -> i32 {
        self.exponent
    }

    /// The number of harmonics H.
    pub(super) fn harmonics(&self) -> usize {
        self.fixed[0].len() - 1
    }

    /// The coefficients of cos nt and sin nt in a coordinate, in multiples of 2^(−62).
    pub(super) fn fixed(&self, coordinate: usize, n: usize) -> [i64; 2] {
        self.fixed[coordinate][n]
    }

    /// The doubles nearest to the coefficients.
    pub(super) fn doubles(&self, coordinate: usize, n: usize) -> [f64; 2] {
        self.doubles[coordinate][n]
    }

    /// The sum of the sizes of all coefficients of the n-th harmonic.
    pub(super) fn size(&self, n: usize) -> f64 {
        let pairs = self.doubles.iter().map(|list| list[n]);
        pairs.flatten().map(f64::abs).sum()
    }
}

/// The least e with `size` < 2^e; `None` if it is not within ±[`LARGEST_EXPONENT`].
fn exponent_above(size: f64) -> Option<i64> {
    let exponent = (size.to_bits() >> 52).cast_signed() - 1022;
    (size.is_normal() && exponent.abs() <= LARGEST_EXPONENT).then_some(exponent)
}
