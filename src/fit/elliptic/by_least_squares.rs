//! Elliptic series by least squares: the given points need not be exact.

use std::f64::consts::TAU;

use rustfft::num_complex::Complex;

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::fit::distance::{DistanceSearch, Frame, Step};
use crate::fit::exactly;
use crate::fit::least_squares::{Estimate, LeastSquares, Observations};
use crate::fit::{FitOptions, FitSize};
use crate::limits::Limits;
use crate::shape::{Contour, EllipticSeries};

/// The vertices of an outline, in its frame, each at its arc length from the first one, which goes from 0 to 2π.
pub(super) struct Points<'a> {
    observations: Observations<2>,
    frame: &'a Frame,
}

impl<'a> Points<'a> {
    pub(super) fn new(contour: &Contour, points: &[[f64; 2]], frame: &'a Frame) -> Result<Self> {
        let inside: Vec<[f64; 2]> = points.iter().map(|p| frame.inside(*p)).collect();
        let next = inside.iter().cycle().skip(1);
        let edges = inside.iter().zip(next);
        let mut length = 0.0;
        let ends = edges.map(|(p, q)| {
            length += f64::hypot(q[0] - p[0], q[1] - p[1]);
            length
        });
        let ends: Vec<f64> = ends.collect();
        let starts = std::iter::once(0.0).chain(ends);
        let placed = inside.iter().zip(starts);
        let placed = placed.map(|(p, start)| (TAU * (start / length), *p));
        Ok(Self {
            observations: Observations::new(placed.collect(), &contour.given_weights())?,
            frame,
        })
    }

    /// The series of this size, and what is said of its coefficients; `powers` are the sums of the powers of a series.
    ///
    /// # Errors
    /// Those of the estimate; [`Error::Limit`] if no number of harmonics is enough.
    pub(super) fn fit(
        &self,
        contour: &Contour,
        size: FitSize,
        options: &FitOptions,
        powers: impl Fn(&EllipticSeries) -> Vec<f64>,
        limits: &Limits,
    ) -> Result<(EllipticSeries, LeastSquares)> {
        let estimate = |n: usize| self.estimate(n, options, limits);
        let most = self.observations.most_harmonics();
        let harmonics = match size {
            FitSize::Harmonics(n) => n,
            FitSize::Tolerance(e) | FitSize::Distance(e) => {
                let curve = |n: usize| {
                    Ok(self
                        .estimate_if_determined(n, options, limits)?
                        .map(|found| found.0))
                };
                let mut search = DistanceSearch::new(contour, e)?;
                let found = search.fewest(0..=most, curve, &Step::Unknown, limits)?;
                found.ok_or_else(|| search.missed("an elliptic series", "", curve, limits))?
            }
            FitSize::Power(share) => {
                let mut n = 0;
                while powers(&estimate(n)?.0)
                    .last()
                    .is_none_or(|&sum| sum < share)
                {
                    n += 1;
                    if n > most {
                        return Err(Error::limit(format!(
                            "no number of harmonics up to {most} has that share of the power"
                        )));
                    }
                }
                n
            }
        };
        estimate(harmonics)
    }

    fn estimate(
        &self,
        harmonics: usize,
        options: &FitOptions,
        limits: &Limits,
    ) -> Result<(EllipticSeries, LeastSquares)> {
        let found = self
            .observations
            .estimate(harmonics, options.robust, limits)?;
        self.series(found, options)
    }

    fn estimate_if_determined(
        &self,
        harmonics: usize,
        options: &FitOptions,
        limits: &Limits,
    ) -> Result<Option<(EllipticSeries, LeastSquares)>> {
        let found = self
            .observations
            .estimate_if_determined(harmonics, options.robust, limits)?;
        found.map(|found| self.series(found, options)).transpose()
    }

    /// The series in the coordinates of the outline.
    fn series(
        &self,
        found: Estimate<2>,
        options: &FitOptions,
    ) -> Result<(EllipticSeries, LeastSquares)> {
        let scale = self.frame.scale();
        let list = |i: usize, part: fn(&Complex<f64>) -> f64| -> Result<Vec<Rational>> {
            let values: Vec<f64> = found.series.iter().map(|c| scale * part(&c[i])).collect();
            exactly(&values, options.decimals)
        };
        let mut lists = [
            list(0, |c| c.re)?,
            list(0, |c| c.im)?,
            list(1, |c| c.re)?,
            list(1, |c| c.im)?,
        ];
        for (i, middle) in self.frame.middle.iter().enumerate() {
            let value = middle + scale * found.series[0][i].re;
            lists[2 * i][0] = exactly(&[value], options.decimals)?.remove(0);
        }
        Ok((EllipticSeries::new(lists), found.report.scaled(scale)))
    }
}
