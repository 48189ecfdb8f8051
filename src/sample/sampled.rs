//! Sampled directions.

use super::{Direction, Ray, SpaceDirection, UnitVector};

/// A direction and the points of a curve or surface in it.
#[derive(Clone, Debug)]
pub struct SampledRay<D = Direction, const V: usize = 2> {
    /// The direction.
    pub direction: D,
    /// The points, or the whole line.
    pub ray: Ray<V>,
}

/// A direction that has nominal angles, which are written with its points.
pub(crate) trait NominalAngles<const V: usize>: UnitVector<V> {
    /// The angle θ and, in space, φ.
    fn angles(&self) -> (f64, Option<f64>);
}

impl NominalAngles<2> for Direction {
    fn angles(&self) -> (f64, Option<f64>) {
        (self.theta(), None)
    }
}

impl NominalAngles<3> for SpaceDirection {
    fn angles(&self) -> (f64, Option<f64>) {
        (self.theta().theta(), Some(self.phi().theta()))
    }
}
