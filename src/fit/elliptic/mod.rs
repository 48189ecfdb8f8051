//! Elliptic Fourier series of outlines (Kuhl & Giardina, *Elliptic Fourier features of a closed contour*, 1982).

mod coefficients;
#[cfg(test)]
mod laws;

use malachite::Integer;

use super::distance::DistanceSearch;
use super::{FitOptions, FitSize};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::shape::{Contour, EllipticSeries};
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
/// For a [`FitSize::Tolerance`] or [`FitSize::Distance`] the number of harmonics is the smallest for which the upper bound of the
/// Hausdorff distance (see [`super::distances`]) is within that. For a [`FitSize::Power`] it is the smallest for which
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
    let (middle, scale) = contour.frame();
    let series = |harmonics: usize| -> Result<EllipticSeries> {
        coefficients(&points, middle, harmonics, options.decimals, limits).map(EllipticSeries::new)
    };
    // Powers are compared in a unit in which the outline has about the size 1: the square of a size may be no double.
    let unit = (scale.to_bits().cast_signed() >> 52) - 1023;
    let total = total_power(
        &points,
        middle,
        f64::from_bits((1023 - unit).unsigned_abs() << 52),
    );
    let squared_unit = Rational::from_dyadic(Integer::from(1), -2 * unit);
    let powers = |series: &EllipticSeries| -> Vec<f64> {
        let each = (1..=series.harmonics()).map(|n| (series.power(n) * &squared_unit).to_f64());
        let sums = each.scan(0.0, |sum, power| {
            *sum += power;
            Some(*sum / total)
        });
        std::iter::once(0.0).chain(sums).collect()
    };
    let fitted = |series: EllipticSeries| EllipticFit {
        power: powers(&series).last().copied().unwrap_or(0.0).min(1.0),
        series,
    };
    let mut search = match size {
        FitSize::Harmonics(n) => return series(n).map(fitted),
        FitSize::Tolerance(e) | FitSize::Distance(e) => Some(DistanceSearch::new(contour, e)),
        FitSize::Power(_) => None,
    };
    let (mut first, mut last) = (0, FIRST_HARMONICS);
    loop {
        let all = series(last)?;
        let found = match (&mut search, size) {
            (Some(search), _) => search.fewest(first..=last, |n| all.truncated(n), limits)?,
            (None, FitSize::Power(share)) => powers(&all).iter().position(|&sum| sum >= share),
            (None, _) => None,
        };
        if let Some(n) = found {
            return Ok(fitted(all.truncated(n)));
        }
        if last == MAX_ELLIPTIC_HARMONICS {
            return Err(match &search {
                Some(search) => search.missed("an elliptic series", last),
                None => Error::limit(format!(
                    "no number of harmonics up to {last} has that share of the power"
                )),
            });
        }
        (first, last) = (last + 1, 2 * last);
    }
}

/// The power of all harmonics together, for coordinates times a factor: the mean square of the distance from the mean point, by arc
/// length (Parseval).
fn total_power(points: &[[f64; 2]], middle: [f64; 2], factor: f64) -> f64 {
    let n = points.len();
    let (mut length, mut sums, mut squares) = (0.0, [0.0; 2], 0.0);
    for k in 0..n {
        let [p, q] =
            [points[k], points[(k + 1) % n]].map(|p| [0, 1].map(|i| (p[i] - middle[i]) * factor));
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
