//! The tolerance of an inspector.

use super::{DistanceBounds, Verdict, is_within};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::intervals::Interval;

/// A tolerance d > 0, exactly and between two doubles.
#[derive(Clone, Debug)]
pub(super) struct Tolerance {
    pub(super) exact: Rational,
    pub(super) around: Interval,
}

impl Tolerance {
    /// # Errors
    /// [`Error::Usage`] for a tolerance that is not positive.
    pub(super) fn new(tolerance: &Rational) -> Result<Self> {
        if tolerance.signum() <= 0 {
            return Err(Error::Usage(format!(
                "the tolerance {tolerance}: expected a positive number, such as 0.1"
            )));
        }
        Ok(Self {
            exact: tolerance.clone(),
            around: Interval::narrowest(tolerance),
        })
    }

    /// The square d².
    pub(super) fn squared(&self) -> Rational {
        &self.exact * &self.exact
    }

    /// The verdict on a distance between these bounds, if they decide it.
    pub(super) fn verdict(&self, bounds: &DistanceBounds) -> Option<Verdict> {
        is_within(bounds, self.around).map(|is_inside| match is_inside {
            true => Verdict::Inside,
            false => Verdict::Outside,
        })
    }
}
