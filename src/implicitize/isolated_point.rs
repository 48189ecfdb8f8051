//! An isolated real point of a curve, and whether all were found.

use crate::exact::Rational;

/// A fraction of at most this length, in a narrow interval, is tested exactly.
pub(super) const SHORT_BITS: u64 = 100;

/// The isolated real points that were found.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Isolated {
    /// The points, exact if they are rational and else as doubles.
    pub points: Vec<IsolatedPoint>,
    /// Whether these are all isolated real points.
    pub complete: bool,
}

/// An isolated real point, with a coordinate for each axis.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum IsolatedPoint {
    /// A point with rational coordinates.
    Exact(Vec<Rational>),
    /// The doubles near its coordinates.
    Near(Vec<f64>),
}
