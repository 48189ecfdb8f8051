//! [`Radial`]: forms that every ray from the origin meets once.

use std::cmp::Ordering;

use crate::error::Result;
use crate::exact::Rational;

/// A closed form about the origin that every ray from there meets in exactly one point, decided by exact comparisons; with every
/// point it has the opposite one. What is sampled and meshed needs no more of it.
pub trait Radial<const V: usize>: Sync {
    /// Where a rational point is: `Less` inside, `Equal` on the form, `Greater` outside.
    ///
    /// # Errors
    /// [`crate::error::Error::Limit`] if the comparison is given up.
    fn compare(&self, point: &[Rational; V]) -> Result<Ordering>;

    /// The radius in the direction of a unit vector, in doubles, with no bound of its error.
    fn approximate_along(&self, unit: [f64; V]) -> f64;
}
