//! Directions with what a form has in them.

use super::{Direction, Ray, SpaceDirection, UnitVector};

/// A direction and what the curve or surface has in it.
#[derive(Clone, Debug)]
pub struct SampledRay<D = Direction, const V: usize = 2> {
    /// The direction.
    pub direction: D,
    /// The points, or the whole line.
    pub ray: Ray<V>,
}

/// A direction with its nominal angles, as it is written.
pub(crate) trait NominalAngles<const V: usize>: UnitVector<V> {
    /// θ, and φ in space.
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
