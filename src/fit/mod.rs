//! Fits: the Fourier radius (Lemma 1) of an outline, by Definition 1.
//!
//! The steps of a fit can be used separately. [`read_contour`] reads an outline from a table, an array, a map, a drawing or a
//! picture; [`Center::choose`] chooses the center; [`ContourRadius`] is the radius of the outline about the center;
//! [`fourier_coefficients`] is Definition 1; [`fit`] does all of this and measures the error.
//!
//! An outline that is not star-shaped has no radius that follows it. [`fit_elliptic`] fits the coordinates themselves, by arc
//! length (Kuhl & Giardina). [`Distances`] says how far either fit is from the outline, with certified bounds.
//!
//! Points that were measured, and are not exact, are fitted by [`Estimator::LeastSquares`], with weights and a robust loss if they
//! need them; [`fit_cloud`] fits points in no order.
//!
//! The coefficients of a radius are exactly the doubles that Definition 1 gives, or these doubles rounded to a number of decimals. All
//! later computations with them are exact.

mod best_center;
mod center;
mod definition1;
mod distance;
mod elliptic;
mod kernel;
mod least_squares;
mod measured;
mod mesh;
mod normal_form;
mod options;
mod radius;
mod reading;
mod residual;
mod series;
mod sweep;
mod tolerance;
mod turns;

#[cfg(test)]
mod laws;

pub use center::{Center, CenterChoice, CenterOrigin};
pub use definition1::fourier_coefficients;
pub use distance::{Distances, HausdorffBounds, distances};
pub(crate) use distance::{NearPolygon, is_positive_by_values};
pub use elliptic::{EllipticFit, MAX_ELLIPTIC_HARMONICS, fit_elliptic};
pub use least_squares::{LeastSquares, MAX_LEAST_SQUARES_HARMONICS, Robust, StandardErrors};
pub use measured::fit_cloud;
#[cfg(test)]
pub(crate) use mesh::laws::{cube as cube_of_test, solid_of as solid_of_test};
#[cfg(feature = "meshes")]
pub(crate) use mesh::turns_of_mesh;
pub use mesh::{MAX_FIT_DEGREE, MeshFit, MeshFitOptions, MeshFitSize, fit_mesh};
pub use normal_form::{NormalForm, normal_form};
pub use options::{
    Estimator, FitModel, FitOptions, FitSize, MAX_DECIMALS, MAX_HARMONICS, MAX_SAMPLES,
};
pub use radius::ContourRadius;
pub use reading::{
    Column, Columns, ContourKind, LeftOut, OutlineOptions, cloud_from_reader, contour_from_reader,
    outline_from_reader, outlines_from_reader, read_contour,
};
pub(crate) use reading::{is_geojson, rows_of_array};

// Only the tests and benches of this project use these; they are no part of the public interface.
#[doc(hidden)]
pub use radius::star_shaped_about;

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::shape::{Contour, EllipticSeries, FourierRadius};
use definition1::enough_samples;
use distance::{DistanceSearch, Step};
use residual::{Assessment, CheckAngles};
use tolerance::HarmonicsSearch;

/// The largest default number of samples for a fit to a tolerance.
const MAX_DEFAULT_SAMPLES: usize = 1 << 17;
/// The number of check angles for each sample.
const CHECKS_PER_SAMPLE: usize = 4;

/// What helps if no number of harmonics that the samples determine is enough.
const MORE_SAMPLES: &str = "; more samples, --samples, allow more harmonics";

/// A Fourier radius that was fitted to an outline, and its deviations from it.
#[non_exhaustive]
#[derive(Clone, Debug)]
pub struct Fit {
    /// The radius with its center, in exact numbers.
    pub radius: FourierRadius,
    /// The center and its origin.
    pub center: Center,
    /// The largest |fit − outline| along a ray from the center, computed in doubles with the final coefficients. It is taken over
    /// the directions of all visible vertices (from both sides, where r jumps) and over at least four times as many uniform angles
    /// as there are samples.
    pub max_radial_error: f64,
    /// The root of the mean square of |fit − outline| over the uniform angles.
    pub rms_radial_error: f64,
    /// The number of samples Ns, or of points for least squares.
    pub samples: usize,
    /// How the outline is seen from the center; `None` for a cloud.
    pub outline: Option<Visibility>,
    /// What a fit by least squares says of the coefficients.
    pub least_squares: Option<LeastSquares>,
}

/// How much of an outline is seen from a center.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Visibility {
    /// Whether the outline is exactly star-shaped about the center.
    pub star_shaped: bool,
    /// The share (0 to 1) of the outline's length that a radius cannot see; 0 if it is star-shaped.
    pub hidden_share: f64,
}

/// Fits a Fourier radius to `contour`: Definition 1 applied to samples of its outermost radius, or by
/// [`Estimator::LeastSquares`] the radius with the least sum of weighted squares of ρ − r(θ) over the vertices, whose distances ρ
/// and directions θ are taken from the center.
///
/// For a [`FitSize::Tolerance`] the number of harmonics is the smallest for which [`Fit::max_radial_error`] is within the
/// tolerance, with the given samples: each smaller number was tried and its error is larger. For a [`FitSize::Distance`] it is
/// likewise the smallest for which the upper bound of the Hausdorff distance is within that; a smaller one is measured, or it is
/// excluded because the curve with fewer harmonics is too far away, and no point of it has moved so far.
/// Cost: O(n log n) for the outline, O(Ns log Ns) for the coefficients; a tolerance adds O(N) for
/// about two thousand angles.
///
/// ```
/// use stellate::fit::{FitOptions, FitSize, fit};
/// use stellate::shape::Contour;
///
/// let square = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
/// let square = Contour::new(square, "square").unwrap();
/// let fit = fit(&square, &FitOptions::new(FitSize::Tolerance(0.05))).unwrap();
/// assert_eq!(fit.radius.center(), &[1.into(), 1.into()]);
/// assert!(fit.outline.unwrap().star_shaped && fit.max_radial_error <= 0.05);
/// assert_eq!(fit.radius.harmonics() % 4, 0);
/// ```
///
/// # Errors
/// [`Error::Usage`] if the center is not inside the outline, if there are fewer than 2N + 1 samples or
/// if the tolerance is not positive; [`Error::Limit`] beyond [`MAX_HARMONICS`], [`MAX_SAMPLES`] or
/// [`MAX_DECIMALS`], if no number of harmonics that the samples determine meets the tolerance or distance, and for a
/// distance that is smaller than [`distances`] measures.
pub fn fit(contour: &Contour, options: &FitOptions) -> Result<Fit> {
    fit_within(contour, options, &Limits::none())
}

/// As [`fit`], but ended by `limits`.
///
/// ```
/// use stellate::fit::{FitOptions, FitSize, fit_within};
/// use stellate::limits::Limits;
/// use stellate::shape::Contour;
///
/// let triangle = Contour::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], "triangle").unwrap();
/// let options = FitOptions::new(FitSize::Tolerance(0.01));
/// let over = Limits::none().with_time_limit(std::time::Duration::ZERO);
/// assert!(fit_within(&triangle, &options, &over).is_err());
/// assert!(fit_within(&triangle, &options, &Limits::none()).is_ok());
/// ```
///
/// # Errors
/// As [`fit`], and those of [`Limits::check`].
pub fn fit_within(contour: &Contour, options: &FitOptions, limits: &Limits) -> Result<Fit> {
    let size = options.given_size()?;
    options.check(size, MAX_HARMONICS)?;
    options.is_for_a_radius(size)?;
    if options.chosen_estimator(!contour.weights().is_empty())? == Estimator::LeastSquares {
        return measured::fit_vertices(contour, size, options, limits);
    }
    let samples = options
        .samples
        .unwrap_or_else(|| default_samples(size, contour.len()));
    let most = match size {
        FitSize::Harmonics(n) => n,
        _ => (samples.saturating_sub(1) / 2).min(MAX_HARMONICS),
    };
    enough_samples(samples, most)?;
    let center = Center::choose(contour, &options.center, options.decimals)?;
    limits.check()?;
    let outline = ContourRadius::new(contour, center.point)?;
    limits.check()?;
    let (cos, sin) = fourier_coefficients(&outline.samples(samples), most)?;
    let exact_cos = exactly(&cos, options.decimals)?;
    let exact_sin = exactly(&sin, options.decimals)?;
    // The final coefficients are used from here on.
    let (cos, sin) = (nearest(&exact_cos), nearest(&exact_sin));
    limits.check()?;
    let check = CheckAngles::new(&outline, CHECKS_PER_SAMPLE * samples);
    let cut = |n: usize| {
        FourierRadius::new(exact_cos[..=n].to_vec(), exact_sin[..=n].to_vec())
            .with_center(center.exact.clone())
    };
    let assess = |n: usize| check.assess(&cos[..=n], &sin[..=n]);
    let (harmonics, assessment) = match size {
        FitSize::Tolerance(tolerance) => {
            refuse_jump(tolerance, &outline)?;
            fewest(tolerance, &check, &cos, &sin, limits)?
        }
        FitSize::Distance(distance) => {
            let curve = |n: usize| Ok(Some(EllipticSeries::from_radius(&cut(n))));
            let sizes: Vec<f64> = cos.iter().zip(&sin).map(|(a, b)| a.hypot(*b)).collect();
            let mut search = DistanceSearch::new(contour, distance)?;
            let found = search.fewest(0..=most, curve, &Step::Sizes(&sizes), limits)?;
            let n = found
                .ok_or_else(|| search.missed("a Fourier radius", MORE_SAMPLES, curve, limits))?;
            (n, assess(n))
        }
        FitSize::Harmonics(n) => (n, assess(n)),
        FitSize::Power(_) => {
            return Err(Error::internal(
                "the size of a fit",
                "a share of the power belongs to elliptic series, and was refused",
            ));
        }
    };
    Ok(Fit {
        radius: cut(harmonics),
        max_radial_error: assessment.max,
        rms_radial_error: assessment.rms,
        samples,
        outline: Some(outline.visibility()),
        least_squares: None,
        center,
    })
}

/// The default number of samples Ns for an outline with this many vertices.
fn default_samples(size: FitSize, vertices: usize) -> usize {
    match size {
        FitSize::Harmonics(n) => n
            .saturating_mul(8)
            .max(vertices.saturating_mul(2).min(MAX_DEFAULT_SAMPLES))
            .clamp(1024, MAX_SAMPLES)
            .next_power_of_two(),
        _ => vertices
            .saturating_mul(2)
            .clamp(4096, MAX_DEFAULT_SAMPLES)
            .next_power_of_two(),
    }
}

/// An error if r has a jump so large that no series is within `tolerance` on both sides of it.
fn refuse_jump(tolerance: f64, outline: &ContourRadius) -> Result<()> {
    let (jump, theta) = outline.largest_jump();
    if jump / 2.0 <= tolerance {
        return Ok(());
    }
    Err(Error::limit(format!(
        "no number of harmonics has a radial error of at most {tolerance}: the outline is not \
         star-shaped about the center, r jumps by {jump:.3e} at θ = {:.4}°, and every series \
         leaves at least half of that",
        theta.to_degrees()
    )))
}

/// The smallest number of harmonics within `tolerance`, or an error that names the best number and its error.
fn fewest(
    tolerance: f64,
    check: &CheckAngles,
    cos: &[f64],
    sin: &[f64],
    limits: &Limits,
) -> Result<(usize, Assessment)> {
    match tolerance::smallest(check, cos, sin, tolerance, limits)? {
        HarmonicsSearch::Found(n, assessment) => Ok((n, assessment)),
        HarmonicsSearch::Missed(n, max) => Err(Error::Limit {
            limit: format!(
                "no number of harmonics up to {} has a radial error of at most {tolerance}",
                cos.len() - 1
            ),
            finished: format!("the best found is {max:.3e} with {n} harmonics{MORE_SAMPLES}"),
        }),
    }
}

/// The exact values of doubles, or the doubles rounded to `decimals` decimals.
fn exactly(values: &[f64], decimals: Option<u32>) -> Result<Vec<Rational>> {
    values
        .iter()
        .map(|&value| {
            let exact = Rational::try_from(value)
                .map_err(|_| Error::Usage(format!("a Fourier coefficient is {value}")))?;
            Ok(match decimals {
                None => exact,
                Some(digits) => exact.round_decimals(digits),
            })
        })
        .collect()
}

fn nearest(values: &[Rational]) -> Vec<f64> {
    values.iter().map(Rational::to_f64).collect()
}

/// The exponent e with 2^(e − 1) ≤ value < 2^e, for a normal value.
fn exponent_of(value: f64) -> i64 {
    (value.to_bits() >> 52) as i64 - 1022
}

/// A count as a double.
#[expect(
    clippy::cast_precision_loss,
    reason = "counts of points, samples and harmonics are far below 2^53"
)]
fn as_f64(count: usize) -> f64 {
    count as f64
}
