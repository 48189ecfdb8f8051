//! Work that Python waits for: other Python threads run meanwhile, Ctrl-C ends it, and a callback is told of its progress.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use pyo3::prelude::*;
use rayon::ThreadPool;

use super::exceptions::exception;
use super::options::Options;
use crate::document::remark_text;
use crate::error::{Error, Result};
use crate::limits::Limits;
use crate::verb::{Remark, Watcher, Work};

/// The time between two looks at signals and progress.
const PATIENCE: Duration = Duration::from_millis(50);
/// The time after an interruption or a deadline in which a checkpoint can still end the work in good order.
const GRACE: Duration = Duration::from_millis(250);
/// The largest number of threads; more only take memory.
const MAX_THREADS: usize = 1024;
/// The stack of a thread, as large as that of a program usually is.
const STACK: usize = 8 << 20;

/// What is seen of a piece of work.
#[derive(Debug, Default)]
pub(super) struct Watch {
    progress: Mutex<Option<(&'static str, u64, u64)>>,
    notes: Mutex<Vec<String>>,
    /// Whether the work ends at its deadline by itself, with what is finished.
    ends_by_itself: AtomicBool,
}

impl Watch {
    /// The remarks so far, as sentences.
    pub(super) fn notes(&self) -> Vec<String> {
        locked(&self.notes).clone()
    }
}

impl Watcher for Watch {
    fn progress(&self, what: &'static str, done: u64, total: u64) {
        *locked(&self.progress) = Some((what, done, total));
    }

    fn remark(&self, remark: &Remark) {
        locked(&self.notes).push(remark_text(remark));
    }

    fn ends_by_itself(&self, is_so: bool) {
        self.ends_by_itself.store(is_so, Ordering::SeqCst);
    }

    fn limit_reached(&self) {
        self.ends_by_itself.store(true, Ordering::SeqCst);
    }
}

/// One wait of Python for a piece of work.
pub(super) struct Wait<'a, 'py> {
    pub(super) python: Python<'py>,
    /// A function of what is done, the number of pieces that are done, and that of all pieces.
    pub(super) progress: Option<&'a Bound<'py, PyAny>>,
    pub(super) limits: &'a Limits,
    pub(super) watch: &'a Watch,
}

impl Wait<'_, '_> {
    /// The result of work that owns everything it needs. If it reaches no checkpoint after Ctrl-C or the deadline, it goes on in
    /// its thread, and its result is lost.
    pub(super) fn for_owned<T: Send + 'static>(
        &self,
        pool: &ThreadPool,
        work: impl FnOnce() -> Result<T> + Send + 'static,
    ) -> PyResult<T> {
        let (sender, receiver) = sync_channel(1);
        pool.spawn(move || {
            // Nobody receives the result of work that was left.
            let _ = sender.send(guarded(work));
        });
        self.result(&Mutex::new(receiver))
    }

    /// The result of work that borrows from this thread, and has a checkpoint after every short piece.
    pub(super) fn for_borrowed<T: Send>(
        &self,
        pool: &ThreadPool,
        work: impl FnOnce() -> Result<T> + Send,
    ) -> PyResult<T> {
        let (sender, receiver) = sync_channel(1);
        pool.in_place_scope(|scope| {
            scope.spawn(move |_| {
                let _ = sender.send(guarded(work));
            });
            self.result(&Mutex::new(receiver))
        })
    }

    fn result<T: Send>(&self, receiver: &Mutex<Receiver<Result<T>>>) -> PyResult<T> {
        let mut told = None;
        loop {
            if let Some(found) = self.receive(receiver, PATIENCE)? {
                self.tell(&mut told)?;
                return found.map_err(|error| exception(&error));
            }
            let signals = self.python.check_signals();
            if let Err(error) = signals.and_then(|()| self.tell(&mut told)) {
                self.limits.cancellation().store(true, Ordering::SeqCst);
                if self.receive(receiver, GRACE)?.is_none() {
                    leave_threads();
                }
                return Err(error);
            }
            let is_late = self.limits.time_left() == Some(Duration::ZERO);
            if is_late && !self.watch.ends_by_itself.load(Ordering::SeqCst) {
                return match self.receive(receiver, GRACE)? {
                    Some(found) => found.map_err(|error| exception(&error)),
                    None => {
                        let late = self.limits.check();
                        self.limits.cancellation().store(true, Ordering::SeqCst);
                        leave_threads();
                        Err(exception(&late.err().unwrap_or(Error::Interrupted)))
                    }
                };
            }
        }
    }

    /// The result, if it comes within this time; other Python threads run meanwhile.
    fn receive<T: Send>(
        &self,
        receiver: &Mutex<Receiver<Result<T>>>,
        time: Duration,
    ) -> PyResult<Option<Result<T>>> {
        let end = Instant::now() + time;
        let received = self.python.detach(|| {
            let left = end.saturating_duration_since(Instant::now());
            locked(receiver).recv_timeout(left)
        });
        match received {
            Ok(found) => Ok(Some(found)),
            Err(RecvTimeoutError::Timeout) => Ok(None),
            Err(RecvTimeoutError::Disconnected) => {
                let error = Error::internal("work beside", "it answers before it ends");
                Err(exception(&error))
            }
        }
    }

    /// Calls the callback if there is something new.
    fn tell(&self, told: &mut Option<(&'static str, u64, u64)>) -> PyResult<()> {
        let Some(callback) = self.progress else {
            return Ok(());
        };
        let now = *locked(&self.watch.progress);
        if let Some(progress) = now
            && now != *told
        {
            *told = now;
            callback.call1(progress)?;
        }
        Ok(())
    }
}

/// The result of a verb's work with these options, a JSON object, and the remarks about it.
pub(super) fn with_options<T: Send + 'static>(
    python: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    options: &str,
    run: impl FnOnce(Options, Work) -> Result<T> + Send + 'static,
) -> PyResult<(T, Vec<String>)> {
    let read = || {
        let options = Options::read(options)?;
        let limits = options.limits()?;
        let pool = pool(options.threads)?;
        Ok((options, limits, pool))
    };
    let (options, limits, pool) = read().map_err(|error| exception(&error))?;
    let watch = Arc::new(Watch::default());
    let wait = Wait {
        python,
        progress,
        limits: &limits,
        watch: &watch,
    };
    let mut work = Work::default()
        .limits(limits.clone())
        .watched_by(watch.clone());
    if let Some(degree) = options.max_degree {
        work = work.max_degree(degree);
    }
    let found = wait.for_owned(&pool, move || run(options, work))?;
    Ok((found, watch.notes()))
}

/// The result of work; a broken invariant is an error.
pub(super) fn guarded<T>(work: impl FnOnce() -> Result<T>) -> Result<T> {
    // This is safe, because nothing that the work was changing is used after a panic.
    let outcome = catch_unwind(AssertUnwindSafe(work));
    outcome.unwrap_or_else(|payload| Err(Error::from_panic(payload.as_ref(), None)))
}

/// Lets the next work start threads of its own, because work that was left still has those of now. They end after it.
fn leave_threads() {
    let process = std::process::id();
    locked(&POOLS).retain(|pool| pool.process != process);
}

/// The pools of threads of this process, and of those that it was forked from, whose threads it does not have.
static POOLS: Mutex<Vec<Pool>> = Mutex::new(Vec::new());

/// The threads of this process: as many as there are cores, or `threads`. A process that was forked does not have the threads of
/// its parent, and gets its own.
pub(super) fn pool(threads: Option<usize>) -> Result<Arc<ThreadPool>> {
    match threads {
        Some(0) => {
            let message = "threads: at least one thread is needed";
            return Err(Error::Usage(message.into()));
        }
        Some(count) if count > MAX_THREADS => {
            return Err(Error::limit(format!(
                "threads = {count}: at most {MAX_THREADS} threads"
            )));
        }
        _ => {}
    }
    let process = std::process::id();
    let mut pools = locked(&POOLS);
    let known = pools
        .iter()
        .find(|pool| pool.process == process && pool.asked == threads);
    if let Some(known) = known {
        return Ok(Arc::clone(&known.threads));
    }
    let built = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.unwrap_or(0))
        .stack_size(STACK)
        .build();
    let built = Arc::new(built.map_err(|error| Error::Usage(format!("threads: {error}")))?);
    pools.push(Pool {
        process,
        asked: threads,
        threads: Arc::clone(&built),
    });
    Ok(built)
}

/// The threads of a process; `asked` is the number that was asked for.
struct Pool {
    process: u32,
    asked: Option<usize>,
    threads: Arc<ThreadPool>,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
