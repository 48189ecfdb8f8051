//! Elliptic Fourier series of outlines (Kuhl & Giardina, *Elliptic Fourier features of a closed contour*, 1982).

mod by_least_squares;
mod coefficients;
#[cfg(test)]
mod laws;

use std::ops::RangeInclusive;

use malachite::Integer;

use super::distance::{DistanceSearch, Frame, Step};
use super::least_squares::LeastSquares;
use super::{Estimator, FitOptions, FitSize};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::shape::{Contour, EllipticSeries};
use by_least_squares::Points;
use coefficients::coefficients;

/// The largest number of harmonics of an elliptic series that is fitted.
pub const MAX_ELLIPTIC_HARMONICS: usize = 4096;

/// The number of harmonics with which a search begins; it is doubled as long as it is not enough.
const FIRST_HARMONICS: usize = 32;

/// An elliptic series that was fitted to an outline.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct EllipticFit {
    /// The series, in the coordinates of the outline.
    pub series: EllipticSeries,
    /// The share (0 to 1) of the power of all harmonics that the harmonics of the series have; approximate.
    pub power: f64,
    /// What a fit by least squares says of the coefficients.
    pub least_squares: Option<LeastSquares>,
}

/// Fits an elliptic series to `contour`: the Fourier series of x and y as functions of the arc length, which goes from 0 to 2π,
/// from the first vertex on and in the given sense.
///
/// x(t) = a_0 + Σ (a_n cos nt + b_n sin nt), and y(t) likewise, with a_n = T/(2π²n²) Σ_p Δx_p/Δt_p (cos(2πn t_p/T) −
/// cos(2πn t_(p−1)/T)) over the edges p, where t_p is the arc length at the end of the p-th edge and T = t_K (Kuhl & Giardina,
/// Eq. (7)); a_0 is the mean of x by arc length.
///
/// Every coefficient is correctly rounded: it is the double nearest to the exact one, or the nearest decimal of so many digits.
/// What 320 bits do not tell from 0 is 0, and what they do not tell from a number half-way between two rounded ones is taken
/// for it; the error of that is at most 2^(−200) of the size of the outline.
///
/// By [`Estimator::LeastSquares`] the coefficients are those of least squares at the vertices, each at its arc length; they are
/// not correctly rounded.
///
/// For a [`FitSize::Tolerance`] or [`FitSize::Distance`] the number of harmonics is the smallest for which the upper bound of the
/// Hausdorff distance (see [`distances`](super::distances)) is within that. For a [`FitSize::Power`] it is the smallest for which
/// [`EllipticFit::power`] is at least that share.
///
/// Cost: O(n N) products of numbers of 192 bits for n vertices and N harmonics.
///
/// ```
/// use stellate::fit::{FitOptions, FitSize, fit_elliptic};
/// use stellate::limits::Limits;
/// use stellate::shape::Contour;
///
/// let square = vec![[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
/// let square = Contour::new(square, "square")?;
/// let fit = fit_elliptic(&square, &FitOptions::new(FitSize::Harmonics(3)), &Limits::none())?;
/// // x is 8/π² (cos t − cos 3t/9 …) moved by an eighth of a turn; the even harmonics are exactly 0.
/// let eight = 8.0 / std::f64::consts::PI.powi(2);
/// assert!((fit.series.x_cos()[1].to_f64() - eight).abs() < 1e-15);
/// assert!(fit.series.x_cos()[2].is_zero());
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Usage`] for an option that an elliptic series does not have, or if a tolerance is not positive; [`Error::Limit`]
/// beyond [`MAX_ELLIPTIC_HARMONICS`], also of a search; those of `limits`.
pub fn fit_elliptic(
    contour: &Contour,
    options: &FitOptions,
    limits: &Limits,
) -> Result<EllipticFit> {
    let size = options.given_size()?;
    options.check(size, MAX_ELLIPTIC_HARMONICS)?;
    options.is_for_an_elliptic_series()?;
    let points = contour.given_points();
    let frame = Frame::of(contour);
    let rounded_to = |harmonics: usize, decimals: Option<u32>| -> Result<EllipticSeries> {
        coefficients(&points, frame.middle, harmonics, decimals, limits).map(EllipticSeries::new)
    };
    let series = |harmonics: usize| rounded_to(harmonics, options.decimals);
    // Rounding changes the powers, so the shares are those of the coefficients before it.
    let unrounded = |harmonics: usize| rounded_to(harmonics, None);
    // Powers are compared in the unit of the frame: the square of a size may be no double.
    let total = total_power(&points, &frame);
    let squared_unit = Rational::from_dyadic(Integer::from(1), -2 * frame.exponent());
    let powers = |series: &EllipticSeries| -> Vec<f64> {
        let each = (1..=series.harmonics()).map(|n| (series.power(n) * &squared_unit).to_f64());
        let sums = each.scan(0.0, |sum, power| {
            *sum += power;
            Some(*sum / total)
        });
        std::iter::once(0.0).chain(sums).collect()
    };
    if options.chosen_estimator(!contour.weights().is_empty())? == Estimator::LeastSquares {
        let points = Points::new(contour, &points, &frame)?;
        let (series, least_squares) = points.fit(contour, size, options, powers, limits)?;
        return Ok(EllipticFit {
            power: all_power(&powers(&series)),
            series,
            least_squares: Some(least_squares),
        });
    }
    let series = match size {
        FitSize::Harmonics(n) => series(n)?,
        FitSize::Tolerance(e) | FitSize::Distance(e) => {
            let mut search = DistanceSearch::new(contour, e)?;
            let found = fewest(series, |all, tried| {
                let sizes = sizes(all);
                let curve = |n| Ok(Some(all.truncated(n)));
                search.fewest(tried, curve, &Step::Sizes(&sizes), limits)
            })?;
            found.ok_or_else(|| {
                search.missed("an elliptic series", "", |n| series(n).map(Some), limits)
            })?
        }
        FitSize::Power(share) => {
            let found = fewest(unrounded, |all, _| {
                Ok(powers(all).iter().position(|&sum| sum >= share))
            })?;
            let found = found.ok_or_else(|| {
                Error::limit(format!(
                    "no number of harmonics up to {MAX_ELLIPTIC_HARMONICS} has that share of the power"
                ))
            })?;
            let rounded = series(found.harmonics())?;
            let left = all_power(&powers(&unrounded(rounded.harmonics())?));
            if options.decimals.is_some() && left < share {
                return Err(Error::limit(format!(
                    "with this many decimals the harmonics from {} on are 0, and those before have {left} of the power",
                    rounded.harmonics() + 1
                )));
            }
            rounded
        }
    };
    let power = match options.decimals {
        Some(_) => all_power(&powers(&unrounded(series.harmonics())?)),
        None => all_power(&powers(&series)),
    };
    Ok(EllipticFit {
        power,
        series,
        least_squares: None,
    })
}

/// For each harmonic, a bound of the distance of its points from the origin.
pub(super) fn sizes(series: &EllipticSeries) -> Vec<f64> {
    let [a, b, c, d] = series.lists();
    let size = |n: usize| {
        let [a, b, c, d] = [a, b, c, d].map(|list| list[n].to_f64());
        f64::hypot(a.hypot(b), c.hypot(d))
    };
    (0..=series.harmonics()).map(size).collect()
}

/// The power of all harmonics together, from the sums of the first ones.
fn all_power(sums: &[f64]) -> f64 {
    sums.iter().copied().fold(0.0, f64::max).min(1.0)
}

/// The series with the fewest harmonics, as `find` finds them: it is handed series with more and more harmonics, and the numbers
/// of harmonics that were not tried before.
fn fewest(
    series: impl Fn(usize) -> Result<EllipticSeries>,
    mut find: impl FnMut(&EllipticSeries, RangeInclusive<usize>) -> Result<Option<usize>>,
) -> Result<Option<EllipticSeries>> {
    let (mut first, mut last) = (0, FIRST_HARMONICS);
    while last <= MAX_ELLIPTIC_HARMONICS {
        let all = series(last)?;
        if let Some(n) = find(&all, first..=last)? {
            return Ok(Some(all.truncated(n)));
        }
        (first, last) = (last + 1, 2 * last);
    }
    Ok(None)
}

/// The power of all harmonics together, in the unit of a frame: the mean square of the distance from the mean point, by arc length
/// (Parseval).
fn total_power(points: &[[f64; 2]], frame: &Frame) -> f64 {
    let n = points.len();
    let (mut length, mut sums, mut squares) = (0.0, [0.0; 2], 0.0);
    for k in 0..n {
        let [p, q] = [points[k], points[(k + 1) % n]].map(|p| frame.inside(p));
        let edge = f64::hypot(q[0] - p[0], q[1] - p[1]);
        length += edge;
        for i in 0..2 {
            sums[i] += edge * f64::midpoint(p[i], q[i]);
            squares += edge * (p[i] * p[i] + p[i] * q[i] + q[i] * q[i]) / 3.0;
        }
    }
    let mean = sums.map(|sum| sum / length);
    squares / length - mean[0] * mean[0] - mean[1] * mean[1]
}
