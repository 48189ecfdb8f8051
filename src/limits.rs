//! Stated limits of one piece of work: time, and the user's patience.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::error::{Error, Result};

/// A deadline and a cancellation flag, asked at checkpoints of long loops.
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

    /// Work is stopped `time` from now.
    #[must_use]
    pub fn with_time_limit(mut self, time: Duration) -> Self {
        self.deadline = Instant::now().checked_add(time).map(|end| (end, time));
        self
    }

    /// For one piece of the work, which has `time` from now at most.
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

    /// How much time is left; `None` without a deadline.
    #[must_use]
    pub fn time_left(&self) -> Option<Duration> {
        let (end, _) = self.deadline?;
        Some(end.saturating_duration_since(Instant::now()))
    }

    /// The same without a deadline, for what is to be finished after it.
    #[must_use]
    pub fn without_deadline(&self) -> Self {
        Self {
            deadline: None,
            cancelled: Arc::clone(&self.cancelled),
        }
    }

    /// The flag that stops the work when it becomes true.
    #[must_use]
    pub fn cancellation(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.cancelled)
    }

    /// To be asked between pieces of work.
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
