//! What the person at the terminal sees of the work: notes and progress bars. It also measures stages, and decides whether the
//! process may be ended.

use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use stellate::document::remark_text;
use stellate::verb::{Remark, Watcher};

/// The time after which a progress bar appears.
const PROGRESS_AFTER: Duration = Duration::from_secs(1);

/// The file of this process that is unfinished, and is removed if the process is ended.
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);

/// Sets the file that is removed if the process is ended.
pub(crate) fn remove_if_ended(path: Option<&Path>) {
    *locked(&UNFINISHED) = path.map(Path::to_path_buf);
}

/// Removes the unfinished file, writes the line to standard error, and ends the process with this code.
pub(crate) fn end(line: &str, code: u8) -> ! {
    if let Some(path) = locked(&UNFINISHED).take() {
        let _ = std::fs::remove_file(path);
    }
    report(line);
    std::process::exit(i32::from(code))
}

/// Watches the work of one run.
pub(crate) struct Watch {
    quiet: bool,
    stages: Mutex<Vec<(&'static str, Duration)>>,
    bar: Mutex<Option<ProgressBar>>,
    /// Whether the work ends only at its checkpoints. While it does, nothing else ends the process.
    ends_at_checkpoints: AtomicBool,
    /// Whether output may have begun. Once it may have, nothing ends the process from outside, because that would leave half of
    /// the output.
    writing: AtomicBool,
}

impl Watch {
    pub(crate) fn new(quiet: bool) -> Self {
        Self {
            quiet,
            stages: Mutex::default(),
            bar: Mutex::default(),
            ends_at_checkpoints: AtomicBool::new(false),
            writing: AtomicBool::new(false),
        }
    }

    /// Whether the process may be ended now, from outside of the work.
    pub(crate) fn may_end(&self) -> bool {
        !self.ends_at_checkpoints.load(Ordering::SeqCst) && !self.writing.load(Ordering::SeqCst)
    }

    /// Records that output may have begun: from here on the process may not be ended from outside.
    pub(crate) fn begin_writing(&self) {
        self.writing.store(true, Ordering::SeqCst);
    }

    /// Runs work during which the process may not be ended from outside, because the work ends at its own checkpoints.
    pub(crate) fn ended_at_checkpoints<T>(&self, work: impl FnOnce() -> T) -> T {
        self.ends_by_itself(true);
        let result = work();
        self.ends_by_itself(false);
        result
    }

    /// The stages so far, each with the sum of its times.
    pub(crate) fn stages(&self) -> Vec<(&'static str, Duration)> {
        locked(&self.stages).clone()
    }

    /// Writes a note for the person at the terminal, unless `--quiet` is given.
    pub(crate) fn note(&self, text: &str) {
        if !self.quiet {
            report(&format!("note: {text}"));
        }
    }

    /// A progress bar that appears only if the work takes longer than [`PROGRESS_AFTER`].
    fn new_bar(what: &'static str, total: u64) -> ProgressBar {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} {eta}") {
            bar.set_style(style);
        }
        bar.set_message(what);
        let shown = bar.clone();
        std::thread::spawn(move || {
            std::thread::sleep(PROGRESS_AFTER);
            if !shown.is_finished() {
                shown.set_draw_target(ProgressDrawTarget::stderr_with_hz(10));
            }
        });
        bar
    }
}

impl Watcher for Watch {
    fn stage_finished(&self, name: &'static str, time: Duration) {
        let mut stages = locked(&self.stages);
        match stages.iter_mut().find(|(known, _)| *known == name) {
            Some((_, total)) => *total += time,
            None => stages.push((name, time)),
        }
    }

    fn progress(&self, what: &'static str, done: u64, total: u64) {
        if self.quiet || !std::io::stderr().is_terminal() {
            return;
        }
        let mut bar = locked(&self.bar);
        if done >= total {
            if let Some(bar) = bar.take() {
                bar.finish_and_clear();
            }
            return;
        }
        let bar = bar.get_or_insert_with(|| Self::new_bar(what, total));
        bar.set_length(total);
        bar.set_position(done);
    }

    fn remark(&self, remark: &Remark) {
        self.note(&remark_text(remark));
    }

    fn ends_by_itself(&self, is_so: bool) {
        self.ends_at_checkpoints.store(is_so, Ordering::SeqCst);
    }

    fn limit_reached(&self) {
        self.begin_writing();
    }
}

/// Writes one line to standard error. If that is closed, nobody can be told, so the failure is ignored.
pub(crate) fn report(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{text}");
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
