//! The time that one check may take.

use std::cell::Cell;
use std::time::{Duration, Instant};

use super::refusal::{Checked, need_within_limit};

/// A claim that is not decided after this time, counted from the beginning of the document, is refused.
const LONGEST: Duration = Duration::from_secs(600);

thread_local! {
    /// When the check of this thread began.
    static START: Cell<Option<Instant>> = const { Cell::new(None) };
}

/// Begins to count the time of a check in this thread.
pub(super) fn start() {
    START.set(Some(Instant::now()));
}

/// Refuses after [`LONGEST`].
pub(super) fn need_time() -> Checked<()> {
    let is_in_time = START.get().is_none_or(|start| start.elapsed() <= LONGEST);
    need_within_limit(is_in_time, "the check takes longer than ten minutes")
}
