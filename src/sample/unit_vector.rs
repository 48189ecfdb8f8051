//! Exact unit vectors: the directions in which forms are sampled.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Lcm};
use malachite::base::num::basic::traits::One;

use crate::error::Invariant;
use crate::exact::Rational;

/// A line with a rational direction of length 1: the points c + r·v/w, where |v| = w.
#[derive(Clone, Copy, Debug)]
pub(super) struct RationalLine<'a, const V: usize> {
    /// The vector v.
    pub(super) vector: &'a [Integer; V],
    /// The length w of v.
    pub(super) w: &'a Integer,
    /// The center c, if it is not the origin.
    pub(super) center: Option<&'a [Rational; V]>,
}

/// An exact unit vector: V rational numbers whose squares add up to 1. The trait is sealed; only the directions of this module
/// implement it.
pub trait UnitVector<const V: usize>: IntegerVector<V> {
    /// The components.
    fn components(&self) -> [Rational; V] {
        let (vector, w) = self.over_common_denominator();
        vector.map(|u| Rational::from_integers(u, w.clone()).invariant("a length is not 0"))
    }
}

impl<T: IntegerVector<V>, const V: usize> UnitVector<V> for T {}

/// The operation behind [`UnitVector`]. The trait is sealed: it cannot be named outside of the crate.
pub trait IntegerVector<const V: usize> {
    /// The components times a common denominator W > 0, and W.
    fn over_common_denominator(&self) -> ([Integer; V], Integer);
}

/// A unit vector that is given by its components.
///
/// ```
/// use stellate::sample::{RationalDirection, UnitVector};
/// let components = ["3/5".parse()?, "4/5".parse()?];
/// let direction = RationalDirection::new(&components).unwrap();
/// assert_eq!(direction.components(), components);
/// assert!(RationalDirection::new(&[1.into(), 1.into()]).is_none());
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RationalDirection<const V: usize> {
    vector: [Integer; V],
    denominator: Integer,
}

impl<const V: usize> RationalDirection<V> {
    /// The direction with these components; `None` if their squares do not add up to 1.
    #[must_use]
    pub fn new(components: &[Rational; V]) -> Option<Self> {
        let square = components.iter().map(|c| c * c).sum::<Rational>();
        let denominator = components.iter().fold(Integer::ONE, |d, c| {
            Integer::from(d.unsigned_abs_ref().lcm(c.denominator_ref()))
        });
        let scaled = |c: &Rational| c.numerator() * (&denominator).div_exact(c.denominator());
        let vector = components.each_ref().map(scaled);
        (square == Rational::one()).then_some(Self {
            vector,
            denominator,
        })
    }
}

impl<const V: usize> IntegerVector<V> for RationalDirection<V> {
    fn over_common_denominator(&self) -> ([Integer; V], Integer) {
        (self.vector.clone(), self.denominator.clone())
    }
}
