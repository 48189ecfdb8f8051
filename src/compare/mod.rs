//! The time comparison that the paper says was not carried out: Theorem 2 beside elimination.
//!
//! One radius for all, with more and more harmonics ([`ladder_radius`], [`RUNGS`]). A method climbs until one of its runs
//! takes longer than the limit, fails or is wrong. Every answer is compared with that of Theorem 2 exactly, up to a constant
//! factor, before its time counts.
//!
//! Beside the two methods of this crate stand those of other systems, where they are installed: each is asked through a
//! script on its standard input, and its answer is read by [`crate::language`]. A time is that of the computation alone, as
//! the program itself measures it: its start and the reading of the script are left out.

mod answer;
mod climb;
mod document;
mod growth;
mod ours;
mod page;
mod process;
mod program;
mod radius;

pub use climb::compare;

// For the tests and benches of this project; no part of what the library promises.
#[doc(hidden)]
pub use radius::{RUNGS, ladder_radius};

use std::io::Write;
use std::time::Duration;

use crate::error::{Invariant, Result};
use crate::paper::Appendix;

/// What came of a comparison.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TimeComparison {
    /// What one run may take.
    pub limit: Duration,
    /// Cores of the machine.
    pub cores: usize,
    /// The first one is Theorem 2.
    pub methods: Vec<MethodTimes>,
    /// Programs that could not take part.
    pub absent: Vec<AbsentProgram>,
}

/// The runs of one method.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct MethodTimes {
    /// What does it, and its version: `PARI/GP 2.15.2`.
    pub program: String,
    /// What is done.
    pub what: &'static str,
    /// Rung by rung, as far as it climbed.
    pub runs: Vec<Run>,
}

/// One run.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Run {
    /// N.
    pub harmonics: usize,
    /// What came of it.
    pub outcome: RunOutcome,
}

/// What came of a run.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum RunOutcome {
    /// The equation of Theorem 2, in so many seconds.
    Right(f64),
    /// Another polynomial.
    Wrong,
    /// It took longer than the limit.
    OverLimit,
    /// No answer, and why.
    Failed(String),
}

/// A program that could not take part.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct AbsentProgram {
    /// What it is called.
    pub name: &'static str,
    /// The command that was looked for.
    pub command: &'static str,
    /// Why it is not used if there is such a command.
    pub reason: Option<String>,
}

impl MethodTimes {
    /// The seconds with N harmonics, if the answer was right.
    #[must_use]
    pub fn seconds(&self, harmonics: usize) -> Option<f64> {
        let run = self.runs.iter().find(|run| run.harmonics == harmonics)?;
        match run.outcome {
            RunOutcome::Right(seconds) => Some(seconds),
            _ => None,
        }
    }

    /// The last rung if it was no success.
    #[must_use]
    pub fn failure(&self) -> Option<&Run> {
        let last = self.runs.last()?;
        (!matches!(last.outcome, RunOutcome::Right(_))).then_some(last)
    }
}

impl TimeComparison {
    /// The rungs that some method tried.
    #[must_use]
    pub fn rungs(&self) -> Vec<usize> {
        let tried = |n: &usize| {
            let mut runs = self.methods.iter().flat_map(|method| &method.runs);
            runs.any(|run| run.harmonics == *n)
        };
        RUNGS.into_iter().filter(tried).collect()
    }

    /// Whether a method gave another polynomial than Theorem 2.
    #[must_use]
    pub fn has_wrong_answer(&self) -> bool {
        let mut runs = self.methods.iter().flat_map(|method| &method.runs);
        runs.any(|run| run.outcome == RunOutcome::Wrong)
    }
}

impl Appendix for TimeComparison {
    fn json(&self) -> String {
        let document = serde_json::to_string(&document::ComparisonDocument::new(self));
        document.invariant("what a document holds has a form in JSON")
    }

    fn write_text(&self, out: &mut dyn Write) -> Result<()> {
        Ok(document::write_text(self, out)?)
    }

    fn write_section(&self, out: &mut dyn Write) -> Result<()> {
        page::write_section(self, out)
    }
}
