//! One run of the program: its limits, its notes and the times of its stages.

use std::path::PathBuf;
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use stellate::document::{Format, missing_text};
use stellate::error::{Error, Result};
use stellate::language::Numbers;
use stellate::limits::Limits;
use stellate::reading::{HarmonicConvention, Normalization};
use stellate::verb::{Missing, Work};

use super::arguments::{Common, NormalizationFlag, NumberReading, YesNo};
use super::watch::{Watch, end, report};

/// The time after the deadline in which a checkpoint can still end the work in good order.
const GRACE: Duration = Duration::from_millis(200);

/// The number of decimals of algebraic numbers without `--digits`.
const DEFAULT_DECIMALS: u32 = 16;

/// The largest number of threads. More threads than cores only take memory, and tens of thousands take minutes to start.
const MAX_THREADS: usize = 1024;

/// What all verbs share while they run.
pub(crate) struct Session {
    pub(crate) common: Common,
    pub(crate) limits: Limits,
    /// The circumstances of the work, watched by this session.
    pub(crate) work: Work,
    /// The file for the claims of the output.
    pub(crate) proof: Option<PathBuf>,
    /// Whether the work is done and its answer is "no".
    pub(crate) answer_is_no: bool,
    watch: Arc<Watch>,
    /// Further facts for `--stats`.
    facts: Mutex<Vec<(&'static str, serde_json::Value)>>,
}

impl Session {
    /// Sets up threads, the time limit and Ctrl-C.
    pub(crate) fn new(mut common: Common, proof: Option<PathBuf>) -> Result<Self> {
        // `-o -` means the same as no `-o`.
        common.output = common.output.filter(|path| path.as_os_str() != "-");
        let mut limits = Limits::none();
        if let Some(time) = common.time_limit {
            limits = limits.with_time_limit(time);
        }
        if let Some(threads) = common.threads {
            start_threads(threads)?;
        }
        let watch = Arc::new(Watch::new(common.quiet));
        watch_interruption(&limits, &watch);
        if let Some(time) = common.time_limit {
            watch_deadline(time, &watch);
        }
        let work = Work::default()
            .limits(limits.clone())
            .max_degree(common.max_degree)
            .watched_by(Arc::<Watch>::clone(&watch));
        Ok(Self {
            work: match proof {
                Some(_) => work.with_proof(),
                None => work,
            },
            proof,
            common,
            limits,
            answer_is_no: false,
            watch,
            facts: Mutex::new(Vec::new()),
        })
    }

    /// Records that the answer of the work is "no".
    pub(crate) fn answer_no(&mut self) {
        self.answer_is_no = true;
    }

    /// The number of decimals of algebraic numbers.
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

    /// The convention of a file of spherical harmonics.
    pub(crate) fn harmonics(&self) -> HarmonicConvention {
        let normalization = self.common.normalization.map(|flag| match flag {
            NormalizationFlag::Unnormalized => Normalization::Unnormalized,
            NormalizationFlag::FourPi => Normalization::FourPi,
            NormalizationFlag::Orthonormal => Normalization::Orthonormal,
            NormalizationFlag::Schmidt => Normalization::Schmidt,
        });
        HarmonicConvention::default()
            .normalization(normalization)
            .condon_shortley(self.common.condon_shortley.map(|flag| flag == YesNo::Yes))
    }

    /// The format of the result: that of `--format`, else that of the extension of `-o`, else the usual one of the verb.
    pub(crate) fn format_or(&self, usual: Format) -> Format {
        let chosen = self.common.format.or_else(|| {
            let extension = self.common.output.as_ref()?.extension()?;
            Format::of_extension(extension.to_str()?)
        });
        chosen.unwrap_or(usual)
    }

    /// Adds to the error for a wrong format that the name of the output chose the format.
    pub(crate) fn explained(&self, error: Error) -> Error {
        match (&error, &self.common.output) {
            (Error::Format { .. }, Some(path)) if self.common.format.is_none() => {
                Error::Usage(format!("-o {} means {error}", path.display()))
            }
            _ => error,
        }
    }

    /// Writes a note for the person at the terminal.
    pub(crate) fn note(&self, text: &str) {
        self.watch.note(text);
    }

    /// Records a fact for `--stats`.
    pub(crate) fn record(&self, name: &'static str, value: serde_json::Value) {
        self.facts().push((name, value));
    }

    /// Records that the output begins: from here on the process is not ended from outside.
    pub(crate) fn begin_writing(&self) {
        self.watch.begin_writing();
    }

    /// Runs work that must not be ended from outside between its checkpoints, because other processes work for it.
    pub(crate) fn ended_at_checkpoints<T>(&self, work: impl FnOnce() -> Result<T>) -> Result<T> {
        self.watch.ended_at_checkpoints(work)
    }

    /// Reports the progress of a long work.
    pub(crate) fn progress(&self, what: &'static str, done: u64, total: u64) {
        use stellate::verb::Watcher;
        self.watch.progress(what, done, total);
    }

    /// Returns the error for the parts of the answer that are missing because of a limit. It is reported after the rest is
    /// written.
    pub(crate) fn report_missing(&self) -> Result<()> {
        match self.work.missing() {
            None => Ok(()),
            Some(missing) => Err(limit_error(&missing)),
        }
    }

    fn facts(&self) -> MutexGuard<'_, Vec<(&'static str, serde_json::Value)>> {
        self.facts.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Prints the statistics if `--stats` is given.
    pub(crate) fn finish(&self) {
        if self.common.stats {
            let mut stats = serde_json::Map::new();
            for (name, time) in self.watch.stages() {
                stats.insert(name.into(), time.as_secs_f64().into());
            }
            for (name, value) in &*self.facts() {
                stats.insert((*name).into(), value.clone());
            }
            stats.insert("peak_rss_bytes".into(), peak_memory().into());
            report(&serde_json::json!({ "stats": stats }).to_string());
        }
    }
}

fn limit_error(missing: &Missing) -> Error {
    Error::Limit {
        limit: missing.limit.clone(),
        finished: missing_text(missing),
    }
}

fn start_threads(threads: usize) -> Result<()> {
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
        .map_err(|e| Error::Usage(format!("--threads {threads}: {e}")))
}

/// Handles Ctrl-C. Before anything is written, the process ends at once, even in the middle of a computation; afterwards it
/// ends at the next checkpoint.
fn watch_interruption(limits: &Limits, watch: &Arc<Watch>) {
    let (flag, watch) = (limits.cancellation(), Arc::clone(watch));
    // If the handler cannot be set, Ctrl-C ends the process at once. That also leaves no unfinished file as long as nothing is
    // being written.
    let _ = ctrlc::set_handler(move || {
        flag.store(true, Ordering::SeqCst);
        if watch.may_end() {
            end(
                &format!("stellate: {}", Error::Interrupted),
                super::WRONG_INPUT,
            );
        }
    });
}

/// Ends the process after the time limit if a computation reaches no checkpoint in time.
fn watch_deadline(time: Duration, watch: &Arc<Watch>) {
    let watch = Arc::clone(watch);
    std::thread::spawn(move || {
        std::thread::sleep(time.saturating_add(GRACE));
        if watch.may_end() {
            let limit = format!("--time-limit {} s", time.as_secs_f64());
            let error = Error::Limit {
                limit,
                finished: String::new(),
            };
            end(&format!("stellate: {error}"), super::LIMIT_REACHED);
        }
    });
}

/// The peak resident memory of this process in bytes; `None` on systems that do not report it as Linux does.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    let kilobytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kilobytes * 1024)
}
