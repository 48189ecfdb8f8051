//! The extent of a curve, by which a window is chosen.

use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::parallel;
use crate::sample::{Direction, Ray, RaySolver};
use crate::shape::ImplicitCurve;

/// The number of directions that are sampled.
const DIRECTIONS: usize = 120;

/// A branch that goes to infinity is shown up to this many times the median distance.
const LARGEST_OVER_MEDIAN: f64 = 4.0;

/// Certified points of the curve in many directions, in the contour's own coordinates, without the points that are much farther
/// away than most.
///
/// # Errors
/// [`crate::error::Error::Limit`] or `Interrupted` when the limits say so.
pub(crate) fn extent(curve: &ImplicitCurve, limits: &Limits) -> Result<Vec<[f64; 2]>> {
    let solver = RaySolver::new(curve.polynomial());
    let directions = Direction::around(DIRECTIONS);
    let rays = parallel::try_map(&directions, limits, |direction| Ok(solver.solve(direction)))?;
    let mut samples: Vec<_> = rays
        .into_iter()
        .flat_map(|ray| match ray {
            Ray::Points(points) => points,
            Ray::Line => Vec::new(),
        })
        .collect();
    samples.sort_unstable_by(|a, b| a.r.abs().total_cmp(&b.r.abs()));
    let Some(median) = samples.get(samples.len() / 2).map(|s| s.r.abs()) else {
        return Ok(Vec::new());
    };
    let [a, b] = curve.center().each_ref().map(Rational::to_f64);
    let near = samples
        .iter()
        .filter(|s| s.r.abs() <= LARGEST_OVER_MEDIAN * median);
    Ok(near
        .map(|s| [s.position[0] + a, s.position[1] + b])
        .collect())
}
