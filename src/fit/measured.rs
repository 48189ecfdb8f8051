//! The radius by least squares: of the vertices of an outline, or of a cloud of points.

use std::f64::consts::TAU;

use super::center::Center;
use super::distance::{DistanceSearch, Frame, Step, before};
use super::least_squares::{LeastSquares, Observations};
use super::radius::ContourRadius;
use super::residual::CheckAngles;
use super::series::at_angles;
use super::{
    CHECKS_PER_SAMPLE, Fit, FitOptions, FitSize, MAX_HARMONICS, default_samples, exactly, nearest,
};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::shape::{Contour, EllipticSeries, FourierRadius, PointCloud};

/// Fits a Fourier radius to a cloud of points: the one with the least sum of weighted squares of ρ − r(θ) over the points, whose
/// distances ρ and directions θ are taken from the center.
///
/// The center is by default a middle of the points: the centroid of the polygon through all points in the order of their
/// directions from their median. [`Fit::max_radial_error`] and [`Fit::rms_radial_error`] are those of the points. For a
/// [`FitSize::Tolerance`] the number of harmonics is the smallest for which the largest error is within the tolerance.
///
/// Cost: O(m N + N³) for m points and N harmonics.
///
/// ```
/// use stellate::fit::{FitOptions, FitSize, fit_cloud};
/// use stellate::limits::Limits;
/// use stellate::shape::PointCloud;
///
/// // The points of an ellipse, in steps of 73°.
/// let points = (0..360).map(|k| {
///     let t = f64::from(73 * k).to_radians();
///     [2.0 * t.cos() + 5.0, t.sin()]
/// });
/// let cloud = PointCloud::new(points.collect::<Vec<_>>().into(), "ellipse")?;
/// let fit = fit_cloud(&cloud, &FitOptions::new(FitSize::Harmonics(20)), &Limits::none())?;
/// assert!((fit.center.point[0] - 5.0).abs() < 1e-6);
/// assert!(fit.max_radial_error < 1e-3);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Usage`] if the points do not determine so many harmonics, if most directions have no point, or for an option that
/// a cloud does not have; [`Error::Limit`] beyond
/// [`MAX_LEAST_SQUARES_HARMONICS`](super::MAX_LEAST_SQUARES_HARMONICS), and if no number of harmonics is enough; those of `limits`.
pub fn fit_cloud(cloud: &PointCloud, options: &FitOptions, limits: &Limits) -> Result<Fit> {
    let size = options.given_size()?;
    options.check(size, MAX_HARMONICS)?;
    options.is_for_a_radius(size)?;
    options.is_for_a_cloud(size)?;
    let center = Center::of_cloud(cloud, &options.center, options.decimals)?;
    let points = RadiusPoints::new(cloud.points(), cloud.weights(), center.point)?;
    let candidate = |n: usize| {
        let Some((radius, least_squares)) = points.estimate(n, options, limits)? else {
            return Ok(None);
        };
        let [max, rms] = points.errors(&radius);
        Ok(Some(Fit {
            radius: radius.with_center(center.exact.clone()),
            center: center.clone(),
            max_radial_error: max,
            rms_radial_error: rms,
            samples: least_squares.points,
            outline: None,
            least_squares: Some(least_squares),
        }))
    };
    points.fewest(size, None, candidate)
}

/// Fits a Fourier radius to the vertices of an outline by least squares. All vertices count, those that are hidden from the center,
/// too.
pub(super) fn fit_vertices(
    contour: &Contour,
    size: FitSize,
    options: &FitOptions,
    limits: &Limits,
) -> Result<Fit> {
    let center = Center::choose(contour, &options.center, options.decimals)?;
    limits.check()?;
    let outline = ContourRadius::new(contour, center.point)?;
    limits.check()?;
    let points = RadiusPoints::new(contour.points(), contour.weights(), center.point)?;
    let checks = CHECKS_PER_SAMPLE * default_samples(size, contour.len());
    let check = CheckAngles::new(&outline, checks);
    let candidate = |n: usize| {
        let Some((radius, least_squares)) = points.estimate(n, options, limits)? else {
            return Ok(None);
        };
        let assessment = check.assess(&nearest(radius.cosines()), &nearest(radius.sines()));
        Ok(Some(Fit {
            radius: radius.with_center(center.exact.clone()),
            center: center.clone(),
            max_radial_error: assessment.max,
            rms_radial_error: assessment.rms,
            samples: least_squares.points,
            outline: Some(outline.visibility()),
            least_squares: Some(least_squares),
        }))
    };
    points.fewest(size, Some((contour, limits)), candidate)
}

/// Points as they are seen from the center, in a unit that is a power of two.
struct RadiusPoints {
    observations: Observations<1>,
    unit: f64,
}

impl RadiusPoints {
    fn new(points: &[[f64; 2]], weights: &[f64], center: [f64; 2]) -> Result<Self> {
        let polar = points.iter().map(|p| {
            let [x, y] = [p[0] - center[0], p[1] - center[1]];
            (y.atan2(x).rem_euclid(TAU), x.hypot(y))
        });
        let polar: Vec<(f64, f64)> = polar.collect();
        if polar.iter().any(|&(_, rho)| rho <= 0.0) {
            return Err(Error::Usage(format!(
                "a point lies at the center ({}, {}) and has no direction from it; choose another one with --center X,Y",
                center[0], center[1]
            )));
        }
        let largest = polar.iter().map(|&(_, rho)| rho).fold(0.0, f64::max);
        let unit = Frame::about_origin(largest).scale();
        let inside = polar.iter().map(|&(theta, rho)| (theta, [rho / unit]));
        Ok(Self {
            observations: Observations::new(inside.collect(), weights)?,
            unit,
        })
    }

    /// The radius about the origin, and what is said of its coefficients; `None` if the points do not determine it.
    fn estimate(
        &self,
        harmonics: usize,
        options: &FitOptions,
        limits: &Limits,
    ) -> Result<Option<(FourierRadius, LeastSquares)>> {
        let found = self
            .observations
            .estimate_if_determined(harmonics, options.robust, limits)?;
        let Some(found) = found else {
            return Ok(None);
        };
        let list = |part: fn(&rustfft::num_complex::Complex<f64>) -> f64| -> Result<Vec<Rational>> {
            let values: Vec<f64> = found
                .series
                .iter()
                .map(|c| self.unit * part(&c[0]))
                .collect();
            exactly(&values, options.decimals)
        };
        let radius = FourierRadius::new(list(|c| c.re)?, list(|c| c.im)?);
        Ok(Some((radius, found.report.scaled(self.unit))))
    }

    /// The largest error of a point, and the root of the weighted mean of their squares.
    fn errors(&self, radius: &FourierRadius) -> [f64; 2] {
        let (angles, values, weights) = self.observations.points();
        let [cos, sin] = [radius.cosines(), radius.sines()].map(nearest);
        let series = at_angles(&cos, &sin, angles);
        let (mut max, mut squares, mut total) = (0.0_f64, 0.0, 0.0);
        for ((series, value), weight) in series.iter().zip(values).zip(weights) {
            let error = (series - self.unit * value[0]).abs();
            max = max.max(error);
            squares += weight * error * error;
            total += weight;
        }
        [max, (squares / total).sqrt()]
    }

    /// The candidate of this size; distances are measured from `outline`.
    fn fewest(
        &self,
        size: FitSize,
        outline: Option<(&Contour, &Limits)>,
        candidate: impl Fn(usize) -> Result<Option<Fit>>,
    ) -> Result<Fit> {
        let most = self.observations.most_harmonics();
        let chosen = |n: usize| candidate(n)?.ok_or_else(|| self.observations.undetermined(n));
        match (size, outline) {
            (FitSize::Harmonics(n), _) => chosen(n),
            (FitSize::Tolerance(e), _) => {
                let mut best = (f64::INFINITY, 0);
                let (mut last, mut why) = (most, "");
                for n in 0..=most {
                    let Some(fit) = candidate(n)? else {
                        (last, why) = (before(n), "; the points do not determine more");
                        break;
                    };
                    if fit.max_radial_error <= e {
                        return Ok(fit);
                    }
                    if fit.max_radial_error < best.0 {
                        best = (fit.max_radial_error, n);
                    }
                }
                Err(Error::Limit {
                    limit: format!(
                        "no number of harmonics up to {last} has a radial error of at most {e}{why}"
                    ),
                    finished: format!("the best found is {:.3e} with {} harmonics", best.0, best.1),
                })
            }
            (FitSize::Distance(e), Some((contour, limits))) => {
                let curve = |n: usize| {
                    let fit = candidate(n)?;
                    Ok(fit.map(|fit| EllipticSeries::from_radius(&fit.radius)))
                };
                let mut search = DistanceSearch::new(contour, e)?;
                let found = search.fewest(0..=most, curve, &Step::Unknown, limits)?;
                let missed = || search.missed("a Fourier radius", "", curve, limits);
                chosen(found.ok_or_else(missed)?)
            }
            (FitSize::Distance(_) | FitSize::Power(_), _) => Err(Error::internal(
                "the size of a fit",
                "this size does not belong to these points, and was refused",
            )),
        }
    }
}
