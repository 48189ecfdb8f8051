//! [`Radial`]: forms that every ray from the origin meets once.

use std::cmp::Ordering;

use crate::error::Result;
use crate::exact::Rational;

/// A closed form that every ray from the origin meets in exactly one point, and that is symmetric about the origin. Exact
/// comparisons decide where a point is; sampling and meshing need nothing else.
pub trait Radial<const V: usize>: Sync {
    /// The position of a rational point: `Less` inside, `Equal` on the form, `Greater` outside.
    ///
    /// # Errors
    /// [`crate::error::Error::Limit`] if the comparison would need too long numbers.
    fn compare(&self, point: &[Rational; V]) -> Result<Ordering>;

    /// The radius in the direction of a unit vector, in doubles without a bound of the error.
    fn approximate_along(&self, unit: [f64; V]) -> f64;
}
