//! The circumstances of a piece of work: its limits, its watcher, and the remarks about it.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use super::{Part, Remark};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::witness::Proof;

/// The largest degree of a polynomial if no other limit is set.
pub const DEFAULT_MAX_DEGREE: usize = 20_002;

/// The time between two checks of the limits while other threads work.
const PATIENCE: Duration = Duration::from_millis(20);

/// A watcher learns how the work goes on. By default it does nothing with what it learns.
pub trait Watcher: Send + Sync {
    /// A stage has ended after this time. A stage of one name may come several times.
    fn stage_finished(&self, name: &'static str, time: Duration) {
        let _ = (name, time);
    }

    /// `done` of `total` pieces are done. At the end all pieces count as done, even if the work failed.
    fn progress(&self, what: &'static str, done: u64, total: u64) {
        let _ = (what, done, total);
    }

    /// A remark for the person who waits, as soon as it is known.
    fn remark(&self, remark: &Remark) {
        let _ = remark;
    }

    /// If `is_so`, the work will from now on end by itself soon after its deadline and must not be ended from outside;
    /// otherwise this is no longer so.
    fn ends_by_itself(&self, is_so: bool) {
        let _ = is_so;
    }

    /// A limit has been reached, and the finished parts of the answer are about to be returned.
    fn limit_reached(&self) {}
}

/// The parts of an answer that are missing, and the limit that was reached.
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
    proof: Option<Mutex<Proof>>,
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
    /// Sets the limits of the work.
    #[must_use]
    pub fn limits(mut self, limits: Limits) -> Self {
        self.limits = limits;
        self
    }

    /// Sets the largest degree of polynomials; it is [`DEFAULT_MAX_DEGREE`] by default.
    #[must_use]
    pub fn max_degree(mut self, degree: usize) -> Self {
        self.max_degree = Some(degree);
        self
    }

    /// Sets the watcher that learns how the work goes on.
    #[must_use]
    pub fn watched_by(mut self, watcher: Arc<dyn Watcher>) -> Self {
        self.watcher = Some(watcher);
        self
    }

    /// From now on, everything that the verbs claim is written down with a witness, if there is one.
    #[must_use]
    pub fn with_proof(mut self) -> Self {
        self.proof = Some(Mutex::default());
        self
    }

    /// The claims so far; `None` without [`Work::with_proof`].
    #[must_use]
    pub fn proof(&self) -> Option<Proof> {
        self.proof.as_ref().map(|proof| locked(proof).clone())
    }

    /// The number of claims so far.
    #[must_use]
    pub fn claims(&self) -> usize {
        self.proof
            .as_ref()
            .map_or(0, |proof| locked(proof).claims())
    }

    /// Whether claims are written down.
    pub(super) fn proves(&self) -> bool {
        self.proof.is_some()
    }

    /// Makes claims, if claims are written down.
    pub(super) fn claim(&self, make: impl FnOnce(&mut Proof) -> Result<()>) -> Result<()> {
        match &self.proof {
            Some(proof) => self.stage("proof", || make(&mut locked(proof))),
            None => Ok(()),
        }
    }

    /// The remarks about the work so far.
    #[must_use]
    pub fn remarks(&self) -> Vec<Remark> {
        locked(&self.remarks).clone()
    }

    /// The parts that are missing so far because a limit was reached, while the rest of the answer is finished.
    #[must_use]
    pub fn missing(&self) -> Option<Missing> {
        locked(&self.missing).clone()
    }

    /// A checkpoint of the limits. After a limit has made a part of the answer missing, only an interruption is an error, so
    /// that the rest of the answer can be finished.
    ///
    /// # Errors
    /// As [`Limits::check`].
    pub fn check(&self) -> Result<()> {
        match *locked(&self.missing) {
            Some(_) => self.limits.without_deadline().check(),
            None => self.limits.check(),
        }
    }

    /// Refuses a degree above the largest degree.
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

    /// The limits, for the modules that compute.
    pub(crate) fn bounds(&self) -> &Limits {
        &self.limits
    }

    /// Runs one stage and measures its time.
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

    /// Makes a remark to the person who waits.
    pub(super) fn remark(&self, remark: Remark) {
        if let Some(watcher) = &self.watcher {
            watcher.remark(&remark);
        }
        locked(&self.remarks).push(remark);
    }

    /// Remarks that coordinates are relative to a center, unless it is the origin.
    pub(super) fn remark_center(&self, center: &[Rational]) {
        if !center.iter().all(Rational::is_zero) {
            self.remark(Remark::RelativeTo(center.to_vec()));
        }
    }

    /// Counts the finished pieces of a long work.
    pub(super) fn progress(&self, what: &'static str, total: u64) -> Progress<'_> {
        Progress {
            watcher: self.watcher.as_deref(),
            what,
            total,
            done: AtomicU64::new(0),
        }
    }

    /// Runs the work on a part of the answer that the rest does not need. The result is `None` if this work reaches a limit,
    /// however deep the computation; then [`Work::missing`] names the part.
    pub(super) fn unless_limited<T: Send + 'static>(
        &self,
        part: Part,
        work: impl FnOnce(&Limits) -> Result<T> + Send + 'static,
    ) -> Result<Option<T>> {
        let found = match self.limits.time_left() {
            None => work(&self.limits),
            // The deadline is watched from this thread.
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

    /// The answer of the work, if it comes in time. If it does not, the work continues in its own thread until the process
    /// ends, and its answer is lost.
    fn within_limits<T: Send + 'static>(
        &self,
        work: impl FnOnce(&Limits) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        let limits = self.limits.clone();
        let (working, finished) = sync_channel::<()>(0);
        let thread = std::thread::spawn(move || {
            // Dropped when the work ends, which is all that this thread waits for.
            let _working = working;
            work(&limits)
        });
        while finished.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
            self.limits.check()?;
        }
        thread
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The progress of a long work. When it is dropped, all pieces count as done.
pub(super) struct Progress<'a> {
    watcher: Option<&'a dyn Watcher>,
    what: &'static str,
    total: u64,
    done: AtomicU64,
}

impl Progress<'_> {
    /// Counts `count` more pieces as done.
    pub(super) fn add(&self, count: u64) {
        let before = self.done.fetch_add(count, Ordering::Relaxed);
        self.tell(before + count);
    }

    /// Sets the number of pieces that are done.
    pub(super) fn set(&self, done: u64) {
        self.tell(done);
    }

    fn tell(&self, done: u64) {
        if let Some(watcher) = self.watcher {
            // The end is reported once.
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
        // One work never checks its limits, the other does.
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
        // The deadline is over, and the finished parts can still be returned.
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

    /// A watcher that writes down everything it learns.
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
