//! Huber's loss: points far from the series have less than their full weight.

use super::{Observations, Solution};
use crate::error::{Error, Result};
use crate::fit::as_f64;
use crate::limits::Limits;

/// The constant of the loss for errors of one coordinate: of normal errors 82.1 % are below it, and the estimate has 95 % of the
/// efficiency of least squares. For two coordinates, the constant below which the same share is.
const CONSTANT: [f64; 2] = [1.345, 1.856];
/// The median size of normal errors whose coordinates have the standard deviation 1: of one coordinate, and of two.
const MEDIAN: [f64; 2] = [0.674_489_750_196_081_7, 1.177_410_022_515_474_7];
/// The deviation is at least this, relative to the largest value: a series that more than half of the points meet exactly has no
/// other.
const LEAST_DEVIATION: f64 = 1e-12;
/// The weights are settled when no coefficient changes by more than this, relative to the largest value.
const SETTLED: f64 = 1e-10;
/// The largest number of rounds.
const MOST_ROUNDS: usize = 500;

/// What a robust fit says.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Robust {
    /// The constant k of Huber's loss: errors of more than k deviations have less than their full weight.
    pub constant: f64,
    /// The number of points with larger errors.
    pub reduced: usize,
}

/// A robust fit with settled weights.
pub(super) struct Settled<const D: usize> {
    pub(super) solution: Solution<D>,
    /// For each coordinate: the deviation of the points, and the number that takes its place in the standard errors.
    pub(super) deviation: [[f64; D]; 2],
    pub(super) robust: Robust,
}

impl<const D: usize> Observations<D> {
    /// The robust series, from the one of least squares.
    ///
    /// # Errors
    /// [`Error::Limit`] if it does not settle; those of `limits`.
    pub(super) fn settle(
        &self,
        mut solution: Solution<D>,
        harmonics: usize,
        limits: &Limits,
    ) -> Result<Settled<D>> {
        let constant = CONSTANT[D - 1];
        let values = self.values.iter().flatten();
        let size = values.map(|v| v.abs()).fold(0.0, f64::max);
        for _ in 0..MOST_ROUNDS {
            limits.check()?;
            let sizes = self.sizes(&solution.errors);
            let deviation = (median(&sizes) / MEDIAN[D - 1]).max(LEAST_DEVIATION * size);
            let factor = |error: &f64| (constant * deviation / error).min(1.0);
            let factors: Vec<f64> = sizes.iter().map(factor).collect();
            let weights: Vec<f64> = self
                .weights
                .iter()
                .zip(&factors)
                .map(|(w, f)| w * f)
                .collect();
            let next = self.solve(&weights, harmonics);
            let next = next.ok_or_else(|| self.undetermined(harmonics))?;
            let pairs = next.series.iter().zip(&solution.series);
            let change = pairs
                .flat_map(|(a, b)| (0..D).map(move |d| (a[d] - b[d]).norm()))
                .fold(0.0, f64::max);
            solution = next;
            if change <= SETTLED * size {
                let in_errors = self.effective_deviation(&solution.errors, &factors, harmonics);
                return Ok(Settled {
                    solution,
                    deviation: [[deviation; D], in_errors],
                    robust: Robust {
                        constant,
                        reduced: factors.iter().filter(|&&f| f < 1.0).count(),
                    },
                });
            }
        }
        Err(Error::limit(format!(
            "the weights of the robust fit do not settle in {MOST_ROUNDS} rounds"
        )))
    }

    /// The sizes of errors, in units of the standard deviation of a point of weight 1.
    fn sizes(&self, errors: &[[f64; D]]) -> Vec<f64> {
        let size = |(weight, error): (&f64, &[f64; D])| {
            let square: f64 = error.iter().map(|e| e * e).sum();
            (weight * square).sqrt()
        };
        self.weights.iter().zip(errors).map(size).collect()
    }

    /// What takes the place of the standard deviation in the standard errors of a robust fit, for each coordinate: with ψ the
    /// derivative of the loss, K √(Σ ψ²/(m − p)) / mean ψ′ for m points and p coefficients, K = 1 + p/m var ψ′/(mean ψ′)²
    /// (Huber, *Robust Statistics*, 1981, section 7.6).
    fn effective_deviation(
        &self,
        errors: &[[f64; D]],
        factors: &[f64],
        harmonics: usize,
    ) -> [f64; D] {
        let count = as_f64(errors.len());
        let coefficients = as_f64(2 * harmonics + 1);
        std::array::from_fn(|d| {
            let (mut squares, mut slopes, mut squared_slopes) = (0.0, 0.0, 0.0);
            for ((error, factor), weight) in errors.iter().zip(factors).zip(&self.weights) {
                let square: f64 = error.iter().map(|e| e * e).sum();
                let psi = factor * error[d];
                squares += weight * psi * psi;
                // Outside, ψ is the error divided by its size, which does not change along the error.
                let slope = if *factor < 1.0 {
                    factor * (1.0 - error[d] * error[d] / square)
                } else {
                    1.0
                };
                slopes += slope;
                squared_slopes += slope * slope;
            }
            let mean = slopes / count;
            let variance = squared_slopes / count - mean * mean;
            let correction = 1.0 + coefficients / count * variance / (mean * mean);
            correction * (squares / (count - coefficients)).sqrt() / mean
        })
    }
}

/// The median: of an even number of values, the middle of the two in the middle.
fn median(values: &[f64]) -> f64 {
    let mut values = values.to_vec();
    let half = values.len() / 2;
    let is_even = values.len().is_multiple_of(2);
    let (below, &mut middle, _) = values.select_nth_unstable_by(half, f64::total_cmp);
    match below.iter().copied().max_by(f64::total_cmp) {
        Some(before) if is_even => f64::midpoint(before, middle),
        _ => middle,
    }
}
