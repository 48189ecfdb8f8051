//! The circumstances of a piece of work: its limits, who watches it, and what is to be said of it.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use super::{Part, Remark};
use crate::error::{Error, Result};
use crate::limits::Limits;

/// Polynomials of a higher degree are refused if nothing else is said.
pub const DEFAULT_MAX_DEGREE: usize = 20_002;

/// How often work beside is asked whether the limits still allow it.
const PATIENCE: Duration = Duration::from_millis(20);

/// Who is told how the work goes on. By default nothing is done with what is told.
pub trait Watcher: Send + Sync {
    /// A stage is over, after this time; a stage may come several times.
    fn stage_finished(&self, name: &'static str, time: Duration) {
        let _ = (name, time);
    }

    /// So many of `total` pieces are done; all of them at the end, also where the work failed.
    fn progress(&self, what: &'static str, done: u64, total: u64) {
        let _ = (what, done, total);
    }

    /// Something that the person who waits should know, as soon as it is known.
    fn remark(&self, remark: &Remark) {
        let _ = remark;
    }

    /// From here on, or from here on no longer, the work ends by itself soon after its deadline, and must not be ended from
    /// outside.
    fn ends_by_itself(&self, is_so: bool) {
        let _ = is_so;
    }

    /// A limit is reached, and what is finished is about to be handed over.
    fn limit_reached(&self) {}
}

/// What a limit has cost.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Missing {
    /// The limit, in words.
    pub limit: String,
    /// The parts of the answer that are missing.
    pub parts: Vec<Part>,
}

/// The circumstances of one piece of work: every verb takes them.
///
/// ```
/// use std::time::Duration;
/// use stellate::limits::Limits;
/// use stellate::verb::Work;
/// let work = Work::default().max_degree(80).limits(Limits::none().with_time_limit(Duration::from_secs(60)));
/// assert!(work.check().is_ok());
/// ```
#[derive(Default)]
pub struct Work {
    limits: Limits,
    max_degree: Option<usize>,
    watcher: Option<Arc<dyn Watcher>>,
    remarks: Mutex<Vec<Remark>>,
    missing: Mutex<Option<Missing>>,
}

impl fmt::Debug for Work {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Work")
            .field("limits", &self.limits)
            .field("max_degree", &self.max_degree)
            .field("remarks", &self.remarks)
            .field("missing", &self.missing)
            .finish_non_exhaustive()
    }
}

impl Work {
    /// Stops when these limits say so.
    #[must_use]
    pub fn limits(mut self, limits: Limits) -> Self {
        self.limits = limits;
        self
    }

    /// Refuses polynomials above this degree; without it above [`DEFAULT_MAX_DEGREE`].
    #[must_use]
    pub fn max_degree(mut self, degree: usize) -> Self {
        self.max_degree = Some(degree);
        self
    }

    /// Tells this one how the work goes on.
    #[must_use]
    pub fn watched_by(mut self, watcher: Arc<dyn Watcher>) -> Self {
        self.watcher = Some(watcher);
        self
    }

    /// What the person should know of the work so far.
    #[must_use]
    pub fn remarks(&self) -> Vec<Remark> {
        locked(&self.remarks).clone()
    }

    /// What a limit has cost so far, while the rest of the answer is finished.
    #[must_use]
    pub fn missing(&self) -> Option<Missing> {
        locked(&self.missing).clone()
    }

    /// A checkpoint: once a limit has cost a part of the answer, only an interruption keeps the rest from being handed over.
    ///
    /// # Errors
    /// As [`Limits::check`].
    pub fn check(&self) -> Result<()> {
        match *locked(&self.missing) {
            Some(_) => self.limits.without_deadline().check(),
            None => self.limits.check(),
        }
    }

    /// Refuses a degree above the largest one that is allowed.
    ///
    /// # Errors
    /// [`Error::Limit`].
    pub fn check_degree(&self, degree: usize) -> Result<()> {
        let most = self.max_degree.unwrap_or(DEFAULT_MAX_DEGREE);
        if degree <= most {
            return Ok(());
        }
        Err(Error::limit(format!(
            "the degree {degree} is above --max-degree {most}"
        )))
    }

    /// The limits, for the engine.
    pub(super) fn bounds(&self) -> &Limits {
        &self.limits
    }

    /// Runs one stage under the clock.
    ///
    /// # Errors
    /// Those of [`Work::check`] before the stage begins, and those of the stage.
    pub fn stage<T>(&self, name: &'static str, work: impl FnOnce() -> Result<T>) -> Result<T> {
        self.check()?;
        let start = Instant::now();
        let result = work();
        if let Some(watcher) = &self.watcher {
            watcher.stage_finished(name, start.elapsed());
        }
        result
    }

    /// Something that the person who waits should know.
    pub(super) fn remark(&self, remark: Remark) {
        if let Some(watcher) = &self.watcher {
            watcher.remark(&remark);
        }
        locked(&self.remarks).push(remark);
    }

    /// Counts the pieces of a long work.
    pub(super) fn progress(&self, what: &'static str, total: u64) -> Progress<'_> {
        Progress {
            watcher: self.watcher.as_deref(),
            what,
            total,
            done: AtomicU64::new(0),
        }
    }

    /// Work on a part of the answer that the rest can do without: `None` if it reaches a limit, in however deep a
    /// computation. What is missing then is said by [`Work::missing`].
    pub(super) fn unless_limited<T: Send + 'static>(
        &self,
        part: Part,
        work: impl FnOnce(&Limits) -> Result<T> + Send + 'static,
    ) -> Result<Option<T>> {
        let found = match self.limits.time_left() {
            None => work(&self.limits),
            // The deadline is waited for here.
            Some(_) => {
                let ends_by_itself = |is_so| {
                    if let Some(watcher) = &self.watcher {
                        watcher.ends_by_itself(is_so);
                    }
                };
                ends_by_itself(true);
                let found = self.within_limits(work);
                ends_by_itself(false);
                found
            }
        };
        match found {
            Err(Error::Limit { limit, .. }) => {
                if let Some(watcher) = &self.watcher {
                    watcher.limit_reached();
                }
                let mut missing = locked(&self.missing);
                let missing = missing.get_or_insert_with(|| Missing {
                    limit,
                    parts: Vec::new(),
                });
                missing.parts.push(part);
                Ok(None)
            }
            found => found.map(Some),
        }
    }

    /// The answer of the work if it comes in time. Else the work goes on beside, as long as this process, and its answer is
    /// not waited for.
    fn within_limits<T: Send + 'static>(
        &self,
        work: impl FnOnce(&Limits) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        let limits = self.limits.clone();
        let (sender, receiver) = sync_channel(1);
        let thread = std::thread::spawn(move || {
            // After the deadline nobody listens.
            let _ = sender.send(work(&limits));
        });
        loop {
            match receiver.recv_timeout(PATIENCE) {
                Ok(found) => return found,
                Err(RecvTimeoutError::Timeout) => self.limits.check()?,
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
        match thread.join() {
            Err(panic) => std::panic::resume_unwind(panic),
            Ok(()) => Err(Error::internal("work beside", "it answers before it ends")),
        }
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// How far a long work is; all of it when this is dropped.
pub(super) struct Progress<'a> {
    watcher: Option<&'a dyn Watcher>,
    what: &'static str,
    total: u64,
    done: AtomicU64,
}

impl Progress<'_> {
    /// So many more pieces are done.
    pub(super) fn add(&self, count: u64) {
        let before = self.done.fetch_add(count, Ordering::Relaxed);
        self.tell(before + count);
    }

    /// So many pieces are done.
    pub(super) fn set(&self, done: u64) {
        self.tell(done);
    }

    fn tell(&self, done: u64) {
        if let Some(watcher) = self.watcher {
            // The end is told once.
            watcher.progress(
                self.what,
                done.min(self.total.saturating_sub(1)),
                self.total,
            );
        }
    }
}

impl Drop for Progress<'_> {
    fn drop(&mut self) {
        if let Some(watcher) = self.watcher {
            watcher.progress(self.what, self.total, self.total);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn work(seconds: f64) -> Work {
        let limits = Limits::none().with_time_limit(Duration::from_secs_f64(seconds));
        Work::default().limits(limits)
    }

    #[test]
    fn a_part_that_reaches_a_limit_is_missing_and_the_rest_goes_on() {
        let work = work(0.3);
        let found = work.unless_limited(Part::Factors, |_| Ok(7));
        assert_eq!(found.expect("in time"), Some(7));
        assert_eq!(work.missing(), None);
        // Work that asks nobody, and work that does.
        let deaf = |_: &Limits| {
            std::thread::sleep(Duration::from_secs(3));
            Ok(1)
        };
        let start = Instant::now();
        let found = work.unless_limited(Part::BeyondCurve, deaf);
        assert_eq!(found.expect("the rest"), None);
        assert!(start.elapsed() < Duration::from_secs(2));
        let polite = |limits: &Limits| limits.check();
        let found = work.unless_limited(Part::Factors, polite);
        assert_eq!(found.expect("the rest"), None);
        // The deadline is over, and what is finished can still be handed over.
        assert!(work.limits.check().is_err());
        assert!(work.check().is_ok());
        let missing = work.missing().expect("parts are missing");
        assert_eq!(missing.limit, "--time-limit 0.3 s");
        assert_eq!(missing.parts, [Part::BeyondCurve, Part::Factors]);
    }

    #[test]
    fn a_broken_invariant_beside_is_passed_on() {
        let work = work(60.0);
        let broken = || work.unless_limited(Part::Factors, |_| -> Result<u8> { panic!("broken") });
        let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(broken));
        let payload = outcome.expect_err("a panic");
        assert_eq!(payload.downcast_ref::<&str>(), Some(&"broken"));
        let found = work.unless_limited(Part::Factors, |_| {
            Err::<u8, _>(Error::Usage("wrong".into()))
        });
        assert!(matches!(found, Err(Error::Usage(_))));
    }

    /// Writes down what it is told.
    #[derive(Default)]
    struct Diary(Mutex<Vec<String>>);

    impl Watcher for Diary {
        fn stage_finished(&self, name: &'static str, _: Duration) {
            locked(&self.0).push(format!("stage {name}"));
        }

        fn progress(&self, what: &'static str, done: u64, total: u64) {
            locked(&self.0).push(format!("{what} {done}/{total}"));
        }

        fn limit_reached(&self) {
            locked(&self.0).push("limit".into());
        }
    }

    #[test]
    fn a_watcher_is_told_of_stages_progress_and_limits() {
        let diary = Arc::new(Diary::default());
        let work = work(0.0).watched_by(Arc::<Diary>::clone(&diary));
        assert!(work.stage("late", || Ok(())).is_err());
        let limited = work.unless_limited(Part::Factors, |limits: &Limits| limits.check());
        assert!(limited.expect("the rest").is_none());
        work.stage("count", || {
            let progress = work.progress("pieces", 3);
            progress.add(2);
            progress.set(3);
            Ok(())
        })
        .expect("the rest goes on");
        let told = locked(&diary.0).clone();
        let expected = [
            "limit",
            "pieces 2/3",
            "pieces 2/3",
            "pieces 3/3",
            "stage count",
        ];
        assert_eq!(told, expected);
    }
}
