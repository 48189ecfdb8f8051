//! Coordinates of points and ends of components: exact, or within proved bounds.

use crate::exact::Rational;
use crate::roots::RealRoot;

/// How narrow the bounds of an irrational coordinate are, relative to its size, as a power of two.
const RELATIVE_BITS: i64 = 120;

/// A real algebraic number: as a fraction if it is rational, and within bounds otherwise.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinate {
    low: Rational,
    high: Rational,
}

impl Coordinate {
    /// A number between these bounds.
    pub(super) fn between(low: Rational, high: Rational) -> Self {
        Self { low, high }
    }

    /// The number, if it is known exactly.
    #[must_use]
    pub fn exact(&self) -> Option<&Rational> {
        (self.low == self.high).then_some(&self.low)
    }

    /// Rational bounds, less than 2^−64 of the size of the number apart.
    #[must_use]
    pub fn bounds(&self) -> [&Rational; 2] {
        [&self.low, &self.high]
    }

    /// About the number, as a double.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.low.to_f64()
    }

    /// The number moved by an exact distance.
    #[must_use]
    pub fn moved(&self, by: &Rational) -> Self {
        Self {
            low: &self.low + by,
            high: &self.high + by,
        }
    }
}

impl From<RealRoot> for Coordinate {
    fn from(mut root: RealRoot) -> Self {
        match root.as_rational() {
            Some(exact) => Self {
                low: exact.clone(),
                high: exact,
            },
            None => {
                root.refine(RELATIVE_BITS);
                let (low, high) = root.bounds();
                Self { low, high }
            }
        }
    }
}
