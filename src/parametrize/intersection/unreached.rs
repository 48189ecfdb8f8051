//! The real points of parametrized components that no real parameter value reaches.

use super::search::reaches;
use super::{CommonPoint, IntersectionParametrization, UnreachedPoint};
use crate::error::{Error, Result};
use crate::implicitize::{Coverage, IsolatedPoint, real_image, tracing_index};
use crate::limits::Limits;

/// Adds the isolated points of the curves and the points that they approach, unless a curve reaches them. Surfaces that contain
/// a curve contain these points as well.
///
/// # Errors
/// Those of `limits`.
pub(super) fn add_unreached(
    found: &mut IntersectionParametrization,
    limits: &Limits,
) -> Result<()> {
    for (index, curve) in found.curves.iter().enumerate() {
        let tracing_index = tracing_index(curve.coordinates(), limits)?;
        let image = real_image(curve, tracing_index, limits)?;
        let approached = image
            .approached
            .map(|point| (CommonPoint::Exact(point), false));
        let mut points: Vec<_> = approached.into_iter().collect();
        for isolated in image.isolated.points {
            points.push((in_space(isolated)?, true));
        }
        for (point, is_isolated) in points {
            let is_reached = match &point {
                CommonPoint::Exact(exact) => found.curves.iter().any(|c| reaches(c, exact)),
                CommonPoint::Near(_) => false,
            };
            let mut known = found.unreached.iter().map(|known| &known.point);
            if !is_reached && !known.any(|known| *known == point) {
                found.unreached.push(UnreachedPoint {
                    curve: index,
                    point,
                    is_isolated,
                });
            }
        }
        if !image.isolated.complete || image.coverage != Coverage::Whole {
            found.notes.push(format!(
                "it is not decided whether real parameter values reach all other real points of the component of curve {index}"
            ));
        }
    }
    Ok(())
}

fn in_space(point: IsolatedPoint) -> Result<CommonPoint> {
    let wrong = || Error::internal("isolated points", "a point in space has three coordinates");
    match point {
        IsolatedPoint::Exact(point) => {
            Ok(CommonPoint::Exact(point.try_into().map_err(|_| wrong())?))
        }
        IsolatedPoint::Near(point) => Ok(CommonPoint::Near(point.try_into().map_err(|_| wrong())?)),
    }
}
