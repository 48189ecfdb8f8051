//! The limits of a piece of work: a deadline, and cancellation by the user.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::error::{Error, Result};

/// A deadline and a cancellation flag. Long loops check them at checkpoints.
///
/// ```
/// use stellate::limits::Limits;
/// assert!(Limits::none().check().is_ok());
/// let over = Limits::none().with_time_limit(std::time::Duration::ZERO);
/// assert!(over.check().is_err());
/// ```
#[derive(Clone, Debug, Default)]
pub struct Limits {
    deadline: Option<(Instant, Duration)>,
    cancelled: Arc<AtomicBool>,
}

impl Limits {
    /// No limit.
    #[must_use]
    pub fn none() -> Self {
        Self::default()
    }

    /// Sets a deadline `time` from now.
    #[must_use]
    pub fn with_time_limit(mut self, time: Duration) -> Self {
        self.deadline = Instant::now().checked_add(time).map(|end| (end, time));
        self
    }

    /// The limits for one part of the work, which ends at most `time` from now.
    ///
    /// ```
    /// use std::time::Duration;
    /// use stellate::limits::Limits;
    /// let limits = Limits::none().with_time_limit(Duration::from_secs(60));
    /// assert!(limits.for_at_most(Duration::ZERO).check().is_err());
    /// assert!(limits.for_at_most(Duration::from_secs(1)).check().is_ok());
    /// ```
    #[must_use]
    pub fn for_at_most(&self, time: Duration) -> Self {
        let shorter = self.clone().with_time_limit(time);
        match (self.deadline, shorter.deadline) {
            (Some((whole, _)), Some((piece, _))) if piece < whole => shorter,
            (None, _) => shorter,
            _ => self.clone(),
        }
    }

    /// The time until the deadline; `None` without a deadline.
    #[must_use]
    pub fn time_left(&self) -> Option<Duration> {
        let (end, _) = self.deadline?;
        Some(end.saturating_duration_since(Instant::now()))
    }

    /// The same limits without the deadline, for a part that must be finished after it.
    #[must_use]
    pub fn without_deadline(&self) -> Self {
        Self {
            deadline: None,
            cancelled: Arc::clone(&self.cancelled),
        }
    }

    /// The flag that cancels the work when it becomes true.
    #[must_use]
    pub fn cancellation(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.cancelled)
    }

    /// Checks the limits; long work calls this between its pieces.
    ///
    /// # Errors
    /// [`Error::Interrupted`] after a cancellation, [`Error::Limit`] after the deadline.
    pub fn check(&self) -> Result<()> {
        if self.cancelled.load(Ordering::Relaxed) {
            return Err(Error::Interrupted);
        }
        match self.deadline {
            Some((end, time)) if Instant::now() >= end => Err(Error::limit(format!(
                "--time-limit {} s",
                time.as_secs_f64()
            ))),
            _ => Ok(()),
        }
    }
}
