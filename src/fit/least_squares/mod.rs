//! Trigonometric series by least squares, with weights, a robust loss and standard errors.

mod normal;
mod robust;
mod sums;

#[cfg(test)]
mod laws;

use std::f64::consts::TAU;

use rustfft::num_complex::Complex;

use super::as_f64;
use crate::error::{Error, Result};
use crate::limits::Limits;
use normal::NormalEquations;
pub use robust::Robust;
use sums::{values_at, wave_sums};

/// The largest number of harmonics of a fit by least squares.
pub const MAX_LEAST_SQUARES_HARMONICS: usize = 1000;

/// Normal equations with a larger condition number are refused; the coefficients would have few correct digits.
const MOST_CONDITION: f64 = 1e12;
/// So often the solution is corrected with the errors that it leaves.
const CORRECTIONS: usize = 2;

/// What a fit by least squares says about its coefficients.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LeastSquares {
    /// The number of points with a weight greater than 0.
    pub points: usize,
    /// Whether the points have weights of their own.
    pub is_weighted: bool,
    /// Of a robust fit: its constant, and how many points have less than their full weight.
    pub robust: Option<Robust>,
    /// The standard deviation of the errors of a point of weight 1, and the standard errors of the coefficients; `None` if there are
    /// no more points than coefficients.
    pub errors: Option<StandardErrors>,
}

/// Standard errors, on the assumption that the errors of the points are independent. Each list has an entry for each coordinate:
/// one for a radius, x and y for an elliptic series.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StandardErrors {
    /// The standard deviation of the error of a point of weight 1; of a robust fit, the one that the median error has.
    pub deviation: Vec<f64>,
    /// The standard errors of the coefficients of the cosines.
    pub cos: Vec<Vec<f64>>,
    /// The standard errors of the coefficients of the sines; that of sin 0, which has none, is 0.
    pub sin: Vec<Vec<f64>>,
}

impl LeastSquares {
    /// The same for points that were divided by a scale.
    pub(super) fn scaled(mut self, scale: f64) -> Self {
        if let Some(errors) = &mut self.errors {
            let lists = errors.cos.iter_mut().chain(&mut errors.sin).flatten();
            for number in lists.chain(&mut errors.deviation) {
                *number *= scale;
            }
        }
        self
    }
}

/// Points at angles, with D coordinates each.
#[derive(Debug)]
pub(super) struct Observations<const D: usize> {
    /// The angles, or the parameters of a closed curve, from 0 to 2π.
    angles: Vec<f64>,
    values: Vec<[f64; D]>,
    /// The weights, of which the largest one is 1.
    weights: Vec<f64>,
    /// What the weights were divided by, if there are weights.
    heaviest: Option<f64>,
}

/// A series that was estimated.
#[derive(Debug)]
pub(super) struct Estimate<const D: usize> {
    /// The numbers a_n + i b_n of each coordinate.
    pub(super) series: Vec<[Complex<f64>; D]>,
    pub(super) report: LeastSquares,
}

impl<const D: usize> Observations<D> {
    /// Points whose weights are not empty, or else 1. Points of weight 0 are left out.
    ///
    /// # Errors
    /// [`Error::Usage`] if no weight is greater than 0.
    pub(super) fn new(points: Vec<(f64, [f64; D])>, weights: &[f64]) -> Result<Self> {
        if weights.is_empty() {
            let (angles, values): (Vec<f64>, _) = points.into_iter().unzip();
            return Ok(Self {
                weights: vec![1.0; angles.len()],
                heaviest: None,
                angles,
                values,
            });
        }
        let heaviest = weights.iter().copied().fold(0.0, f64::max);
        if heaviest <= 0.0 {
            return Err(Error::Usage("all weights are 0".into()));
        }
        let mut found = Self {
            angles: Vec::new(),
            values: Vec::new(),
            weights: Vec::new(),
            heaviest: Some(heaviest),
        };
        for ((angle, value), weight) in points.into_iter().zip(weights) {
            let weight = weight / heaviest;
            if weight > 0.0 {
                found.angles.push(angle);
                found.values.push(value);
                found.weights.push(weight);
            }
        }
        Ok(found)
    }

    /// The largest number of harmonics that so many points can determine.
    pub(super) fn most_harmonics(&self) -> usize {
        (self.angles.len().saturating_sub(1) / 2).min(MAX_LEAST_SQUARES_HARMONICS)
    }

    /// The angles, the values and the weights relative to the largest one.
    pub(super) fn points(&self) -> (&[f64], &[[f64; D]], &[f64]) {
        (&self.angles, &self.values, &self.weights)
    }

    /// The series with the least sum of w_i |v_i − series(θ_i)|², or of Huber's loss of these errors if it is `robust`: then the
    /// weights are repeatedly divided by the sizes of the errors in units of the scale, if that is larger than the constant; the
    /// scale is the median size of the errors, divided by what it is for normal ones of standard deviation 1.
    ///
    /// The normal equations are solved, and the solution is corrected twice with the errors that it leaves. The standard errors are
    /// the usual ones, or those of Huber (*Robust Statistics*, 1981, section 7.6, the first of three).
    ///
    /// Cost: O(m N + N³) for m points and N harmonics, for each round of a robust fit.
    ///
    /// # Errors
    /// [`Error::Usage`] if the points do not determine the coefficients; [`Error::Limit`] if a robust fit does not settle; those of
    /// `limits`.
    pub(super) fn estimate(
        &self,
        harmonics: usize,
        robust: bool,
        limits: &Limits,
    ) -> Result<Estimate<D>> {
        let found = self.estimate_if_determined(harmonics, robust, limits)?;
        found.ok_or_else(|| self.undetermined(harmonics))
    }

    /// As [`Self::estimate`], but `None` if the angles of the points do not determine the coefficients.
    pub(super) fn estimate_if_determined(
        &self,
        harmonics: usize,
        robust: bool,
        limits: &Limits,
    ) -> Result<Option<Estimate<D>>> {
        let needed = 2 * harmonics + 1;
        let count = self.angles.len();
        if count < needed {
            return Err(Error::Usage(format!(
                "N = {harmonics} harmonics have {needed} coefficients; there are {count} points"
            )));
        }
        let Some(plain) = self.solve(&self.weights, harmonics) else {
            return Ok(None);
        };
        let (condition, variances) = plain.normal.condition();
        let is_determined = condition <= MOST_CONDITION;
        if !is_determined {
            return Ok(None);
        }
        let (solution, deviation, robust) = if robust {
            let found = self.settle(plain, harmonics, limits)?;
            (found.solution, found.deviation, Some(found.robust))
        } else {
            let deviation = self.deviation(&plain.errors, needed);
            (plain, [deviation; 2], None)
        };
        let errors = (count > needed).then(|| {
            let unit = self.heaviest.unwrap_or(1.0).sqrt();
            let [of_points, of_coefficients] = deviation;
            let list = |part: fn(&Complex<f64>) -> f64| {
                let one = |d: f64| variances.iter().map(|v| d * part(v).sqrt()).collect();
                of_coefficients.iter().map(|&d| one(d)).collect()
            };
            StandardErrors {
                deviation: of_points.iter().map(|d| d * unit).collect(),
                cos: list(|v| v.re),
                sin: list(|v| v.im),
            }
        });
        Ok(Some(Estimate {
            series: solution.series,
            report: LeastSquares {
                points: count,
                is_weighted: self.heaviest.is_some(),
                robust,
                errors,
            },
        }))
    }

    /// The standard deviation of the errors of each coordinate.
    fn deviation(&self, errors: &[[f64; D]], coefficients: usize) -> [f64; D] {
        let freedom = as_f64(self.angles.len() - coefficients);
        std::array::from_fn(|d| {
            let squares = self.weights.iter().zip(errors);
            let sum: f64 = squares.map(|(w, e)| w * e[d] * e[d]).sum();
            (sum / freedom).sqrt()
        })
    }

    /// The series with the least sum of squares for these weights; `None` if there are several.
    fn solve(&self, weights: &[f64], harmonics: usize) -> Option<Solution<D>> {
        let normal = NormalEquations::new(&self.angles, weights, harmonics)?;
        let mut series = vec![[Complex::default(); D]; harmonics + 1];
        let mut errors = self.values.clone();
        for _ in 0..=CORRECTIONS {
            let weighted = |i: usize| errors[i].map(|e| weights[i] * e);
            let right = wave_sums(&self.angles, weighted, harmonics);
            for (c, step) in series.iter_mut().zip(normal.solve(&right)) {
                for d in 0..D {
                    c[d] += step[d];
                }
            }
            errors = values_at(&self.angles, &series);
            for (e, v) in errors.iter_mut().zip(&self.values) {
                *e = std::array::from_fn(|d| v[d] - e[d]);
            }
        }
        Some(Solution {
            series,
            errors,
            normal,
        })
    }

    /// The error for angles that do not determine so many harmonics.
    pub(super) fn undetermined(&self, harmonics: usize) -> Error {
        let (from, to) = widest_gap(&self.angles);
        Error::Usage(format!(
            "the points do not determine N = {harmonics} harmonics: there is no point for {:.1} % of a turn, from {:.1}° to {:.1}°; \
             take fewer harmonics",
            100.0 * (to - from) / TAU,
            from.to_degrees(),
            to.to_degrees()
        ))
    }
}

/// A series with the errors that it leaves.
struct Solution<const D: usize> {
    series: Vec<[Complex<f64>; D]>,
    /// The points minus the series.
    errors: Vec<[f64; D]>,
    normal: NormalEquations,
}

/// The two ends of the widest range without an angle; the second may be more than a turn.
pub(super) fn widest_gap(angles: &[f64]) -> (f64, f64) {
    let mut sorted = angles.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let (Some(&first), Some(&last)) = (sorted.first(), sorted.last()) else {
        return (0.0, TAU);
    };
    let inner = sorted.windows(2).map(|pair| (pair[0], pair[1]));
    inner.fold((last, first + TAU), |widest, gap| {
        if gap.1 - gap.0 > widest.1 - widest.0 {
            gap
        } else {
            widest
        }
    })
}
