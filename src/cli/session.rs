//! One run of the program: limits, notes, progress, stage times.

use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use stellate::document::Format;
use stellate::error::{Error, Result};
use stellate::language::Numbers;
use stellate::limits::Limits;

use super::arguments::{Common, NumberReading};

/// A checkpoint gets this long after the deadline to end the work in good order.
const GRACE: Duration = Duration::from_millis(200);

/// Decimals shown for algebraic numbers without `--digits`.
const DEFAULT_DECIMALS: u32 = 16;

/// How often work beside is asked whether the limits still allow it.
const PATIENCE: Duration = Duration::from_millis(20);

/// A progress bar waits this long before it shows itself.
const PROGRESS_AFTER: Duration = Duration::from_secs(1);

/// Far more threads than cores only take memory, and tens of thousands take minutes to start.
const MAX_THREADS: usize = 1024;

/// The limit that was reached, and what is missing because of it.
struct Missing {
    limit: String,
    parts: Vec<&'static str>,
}

/// What all verbs share while they run.
pub(crate) struct Session {
    pub(crate) common: Common,
    pub(crate) limits: Limits,
    /// Whether the work is done and its answer is "no".
    pub(crate) answer_is_no: bool,
    stages: Vec<(&'static str, Duration)>,
    /// What else `--stats` says.
    facts: Vec<(&'static str, serde_json::Value)>,
    /// What a limit has cost, while the rest is finished and written.
    missing: Mutex<Option<Missing>>,
    /// Set once output may have begun, and while other processes work for us: then work ends at checkpoints only.
    writing: Arc<AtomicBool>,
}

impl Session {
    /// Sets up threads, the time limit and Ctrl-C.
    pub(crate) fn new(common: Common) -> Result<Self> {
        let mut limits = Limits::none();
        if let Some(seconds) = common.time_limit {
            let time = Duration::try_from_secs_f64(seconds).map_err(|_| {
                Error::Usage(format!(
                    "--time-limit {seconds}: expected a number of seconds, such as 60"
                ))
            })?;
            limits = limits.with_time_limit(time);
        }
        if let Some(threads) = common.threads {
            if threads == 0 {
                return Err(Error::Usage(
                    "--threads 0: at least one thread is needed".into(),
                ));
            }
            if threads > MAX_THREADS {
                return Err(Error::Limit {
                    limit: format!("--threads {threads}: at most {MAX_THREADS} threads"),
                    finished: String::new(),
                });
            }
            rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build_global()
                .map_err(|e| Error::Usage(format!("--threads {threads}: {e}")))?;
        }
        let writing = Arc::new(AtomicBool::new(false));
        watch_interruption(&limits, &writing);
        if let Some(seconds) = common.time_limit {
            watch_deadline(Duration::from_secs_f64(seconds), seconds, &writing);
        }
        Ok(Self {
            common,
            limits,
            answer_is_no: false,
            stages: Vec::new(),
            facts: Vec::new(),
            missing: Mutex::new(None),
            writing,
        })
    }

    /// Done, and the answer is "no".
    pub(crate) fn answer_no(&mut self) {
        self.answer_is_no = true;
    }

    /// Decimals shown for algebraic numbers.
    pub(crate) fn decimals(&self) -> u32 {
        self.common.digits.unwrap_or(DEFAULT_DECIMALS)
    }

    /// How numbers are read.
    pub(crate) fn numbers(&self) -> Numbers {
        match self.common.numbers {
            NumberReading::Exact => Numbers::Exact,
            NumberReading::F64 => Numbers::F64,
        }
    }

    /// The chosen format, or the verb's own default.
    pub(crate) fn format_or(&self, default: Format) -> Format {
        self.common.format.unwrap_or(default)
    }

    /// Runs one stage under the clock.
    pub(crate) fn stage<T>(
        &mut self,
        name: &'static str,
        work: impl FnOnce(&Self) -> Result<T>,
    ) -> Result<T> {
        self.check()?;
        let start = Instant::now();
        let result = work(self);
        let spent = start.elapsed();
        match self.stages.iter_mut().find(|(n, _)| *n == name) {
            Some((_, total)) => *total += spent,
            None => self.stages.push((name, spent)),
        }
        result
    }

    /// A checkpoint: once a limit has cost a part of the answer, only an interruption keeps the rest from being written.
    pub(crate) fn check(&self) -> Result<()> {
        match *self.missing() {
            Some(_) => self.limits.without_deadline().check(),
            None => self.limits.check(),
        }
    }

    /// Work on a part of the answer that the rest can do without: `None` if it reaches a limit, in however deep a
    /// computation. What is missing then is said at the end ([`Session::report_missing`]).
    pub(crate) fn unless_limited<T: Send + 'static>(
        &self,
        part: &'static str,
        work: impl FnOnce(&Limits) -> Result<T> + Send + 'static,
    ) -> Result<Option<T>> {
        let found = match self.limits.time_left() {
            None => work(&self.limits),
            // The deadline is waited for here, and does not end the process.
            Some(_) => self.ended_at_checkpoints(|| self.within_limits(work)),
        };
        match found {
            Err(Error::Limit { limit, .. }) => {
                // What is finished is written now, also after the deadline.
                self.begin_writing();
                let mut missing = self.missing();
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
            Ok(()) => Err(Error::Internal {
                place: "work beside".into(),
                broken: "it answers before it ends".into(),
            }),
        }
    }

    /// What a limit has cost, after the rest is written: as a note in the answer, too, see [`missing_note`].
    pub(crate) fn report_missing(&self) -> Result<()> {
        match &*self.missing() {
            None => Ok(()),
            Some(Missing { limit, parts }) => Err(Error::Limit {
                limit: limit.clone(),
                finished: format!("what is written lacks {}", parts.join(", and ")),
            }),
        }
    }

    fn missing(&self) -> MutexGuard<'_, Option<Missing>> {
        self.missing.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A fact for `--stats`.
    pub(crate) fn record(&mut self, name: &'static str, value: serde_json::Value) {
        self.facts.push((name, value));
    }

    /// From here on the process is not ended from outside: a file is being written beside its place.
    pub(crate) fn begin_writing(&self) {
        self.writing.store(true, Ordering::SeqCst);
    }

    /// Runs work that must not be ended from outside between its checkpoints, because other processes work for it.
    pub(crate) fn ended_at_checkpoints<T>(&self, work: impl FnOnce() -> Result<T>) -> Result<T> {
        let before = self.writing.swap(true, Ordering::SeqCst);
        let result = work();
        self.writing.store(before, Ordering::SeqCst);
        result
    }

    /// A remark for the person at the terminal.
    pub(crate) fn note(&self, text: &str) {
        if !self.common.quiet {
            report(&format!("note: {text}"));
        }
    }

    /// A bar that shows itself only on a terminal and only if the work takes longer than a second.
    pub(crate) fn progress(&self, total: usize, what: &'static str) -> ProgressBar {
        if self.common.quiet || !std::io::stderr().is_terminal() {
            return ProgressBar::hidden();
        }
        let bar = ProgressBar::with_draw_target(
            Some(total as u64),
            ProgressDrawTarget::stderr_with_hz(10),
        );
        if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} {eta}") {
            bar.set_style(style);
        }
        bar.set_message(what);
        bar.set_draw_target(ProgressDrawTarget::hidden());
        let shown = bar.clone();
        std::thread::spawn(move || {
            std::thread::sleep(PROGRESS_AFTER);
            if !shown.is_finished() {
                shown.set_draw_target(ProgressDrawTarget::stderr_with_hz(10));
            }
        });
        bar
    }

    /// Refuses a degree above `--max-degree`.
    pub(crate) fn check_degree(&self, degree: usize) -> Result<()> {
        if degree <= self.common.max_degree {
            return Ok(());
        }
        Err(Error::Limit {
            limit: format!(
                "the degree {degree} is above --max-degree {}",
                self.common.max_degree
            ),
            finished: String::new(),
        })
    }

    /// Prints the statistics, if asked.
    pub(crate) fn finish(&self) -> Result<()> {
        if self.common.stats {
            let mut stats = serde_json::Map::new();
            for (name, time) in &self.stages {
                stats.insert((*name).into(), time.as_secs_f64().into());
            }
            for (name, value) in &self.facts {
                stats.insert((*name).into(), value.clone());
            }
            stats.insert("peak_rss_bytes".into(), peak_memory().into());
            report(&serde_json::json!({ "stats": stats }).to_string());
        }
        Ok(())
    }
}

/// The note of an answer from which a limit has kept a part.
pub(crate) fn missing_note(part: &str) -> String {
    format!("not finished within the limits: {part}")
}

/// Ctrl-C: before anything is written the process ends at once, however deep in one computation it is;
/// afterwards at the next checkpoint.
fn watch_interruption(limits: &Limits, writing: &Arc<AtomicBool>) {
    let (flag, writing) = (limits.cancellation(), Arc::clone(writing));
    // Without a handler Ctrl-C ends the process at once, which leaves no half file either, as long
    // as nothing is being written.
    let _ = ctrlc::set_handler(move || {
        flag.store(true, Ordering::SeqCst);
        if !writing.load(Ordering::SeqCst) {
            report(&format!("stellate: {}", Error::Interrupted));
            std::process::exit(i32::from(super::WRONG_INPUT));
        }
    });
}

/// The time limit, for computations that reach no checkpoint in time.
fn watch_deadline(time: Duration, seconds: f64, writing: &Arc<AtomicBool>) {
    let writing = Arc::clone(writing);
    std::thread::spawn(move || {
        std::thread::sleep(time.saturating_add(GRACE));
        if !writing.load(Ordering::SeqCst) {
            let limit = format!("--time-limit {seconds} s");
            let error = Error::Limit {
                limit,
                finished: String::new(),
            };
            report(&format!("stellate: {error}"));
            std::process::exit(i32::from(super::LIMIT_REACHED));
        }
    });
}

/// One line on standard error; if that is closed there is nobody to tell.
pub(crate) fn report(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{text}");
}

/// The peak resident memory of this process in bytes where the system tells (Linux), else null.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    let kilobytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kilobytes * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::arguments::Arguments;
    use clap::Parser;

    fn session(seconds: &str) -> Session {
        let arguments = [
            "stellate",
            "describe",
            "x",
            "--time-limit",
            seconds,
            "--quiet",
        ];
        let arguments = Arguments::try_parse_from(arguments).expect("arguments");
        let session = Session::new(arguments.common).expect("a session");
        // The deadline must not end the process of the tests.
        session.begin_writing();
        session
    }

    #[test]
    fn a_part_that_reaches_a_limit_is_missing_and_the_rest_goes_on() {
        let session = session("0.3");
        let found = session.unless_limited("a part in time", |_| Ok(7));
        assert_eq!(found.expect("in time"), Some(7));
        assert!(session.report_missing().is_ok());
        // Work that asks nobody, and work that does.
        let deaf = |_: &Limits| {
            std::thread::sleep(Duration::from_secs(3));
            Ok(1)
        };
        let start = Instant::now();
        assert_eq!(
            session
                .unless_limited("a long part", deaf)
                .expect("the rest"),
            None
        );
        assert!(start.elapsed() < Duration::from_secs(2));
        let polite = |limits: &Limits| limits.check();
        assert_eq!(
            session
                .unless_limited("another part", polite)
                .expect("the rest"),
            None
        );
        // The deadline is over, and what is finished can still be written.
        assert!(session.limits.check().is_err());
        assert!(session.check().is_ok());
        let error = session.report_missing().expect_err("parts are missing");
        assert_eq!(
            error.to_string(),
            "limit reached: --time-limit 0.3 s (what is written lacks a long part, and another part)"
        );
    }

    #[test]
    fn a_broken_invariant_beside_is_passed_on() {
        let session = session("60");
        let broken = || session.unless_limited("a part", |_| -> Result<u8> { panic!("broken") });
        let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(broken));
        let payload = outcome.expect_err("a panic");
        assert_eq!(payload.downcast_ref::<&str>(), Some(&"broken"));
        let found =
            session.unless_limited("a part", |_| Err::<u8, _>(Error::Usage("wrong".into())));
        assert!(matches!(found, Err(Error::Usage(_))));
    }
}
