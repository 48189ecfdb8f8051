//! The time comparison that the paper says was not carried out: Theorem 2 in comparison with elimination.
//!
//! All methods convert the same radius, with more and more harmonics ([`ladder_radius`], [`RUNGS`]). A method stops after a run
//! that takes longer than the limit, fails or is wrong. Every answer is compared with that of Theorem 2 before its time counts;
//! the comparison is exact, up to a constant factor.
//!
//! Besides the two methods of this crate, other programs take part if they are installed. Each of them reads a script from its
//! standard input, and [`crate::language`] reads its answer. The time is that of the computation alone, which the program
//! measures itself; the start of the program and the reading of the script do not count.

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

// Only the tests and benches of this project use these; they are no part of the public interface.
#[doc(hidden)]
pub use radius::{RUNGS, ladder_radius};

use std::io::Write;
use std::time::Duration;

use crate::error::{Invariant, Result};
use crate::paper::Appendix;

/// The result of a comparison.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TimeComparison {
    /// The time limit of one run.
    pub limit: Duration,
    /// The number of cores of the machine.
    pub cores: usize,
    /// The methods; the first one is Theorem 2.
    pub methods: Vec<MethodTimes>,
    /// The programs that could not take part.
    pub absent: Vec<AbsentProgram>,
}

/// The runs of one method.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct MethodTimes {
    /// The program with its version, such as `PARI/GP 2.15.2`.
    pub program: String,
    /// The description of the method.
    pub what: &'static str,
    /// The runs, rung by rung, up to the one after which the method stopped.
    pub runs: Vec<Run>,
}

/// A run of a method.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Run {
    /// The number of harmonics N.
    pub harmonics: usize,
    /// The outcome of the run.
    pub outcome: RunOutcome,
}

/// The outcome of a run.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum RunOutcome {
    /// The equation is that of Theorem 2, and the run took this number of seconds.
    Right(f64),
    /// The equation is another polynomial.
    Wrong,
    /// The run took longer than the limit.
    OverLimit,
    /// There is no equation, for this reason.
    Failed(String),
}

/// A program that could not take part.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct AbsentProgram {
    /// The name of the program.
    pub name: &'static str,
    /// The command that was searched.
    pub command: &'static str,
    /// The reason why the program is not used, if the command exists.
    pub reason: Option<String>,
}

impl MethodTimes {
    /// The seconds for N harmonics; `None` unless the answer was right.
    #[must_use]
    pub fn seconds(&self, harmonics: usize) -> Option<f64> {
        let run = self.runs.iter().find(|run| run.harmonics == harmonics)?;
        match run.outcome {
            RunOutcome::Right(seconds) => Some(seconds),
            _ => None,
        }
    }

    /// The last run, if it failed.
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

    /// Whether some method gave another polynomial than Theorem 2.
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
