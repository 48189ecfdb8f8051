//! One statement of the paper: its tests, and the verdict that follows from them.

use std::fmt;
use std::time::{Duration, Instant};

use super::formula::Formula;
use super::identity::{Comparison, Meanings};
use super::question::Question;
use crate::error::Result;
use crate::limits::Limits;

/// A statement of the paper.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Entry<'a> {
    /// `T2`, `L4`, `E9`, `Eq63`, `F12`, `AppB`, …
    pub id: &'a str,
    /// What it is.
    pub title: &'a str,
    /// The section of the paper.
    pub section: &'a str,
    /// What is printed.
    pub printed: &'a str,
    /// What is true.
    pub correct: &'a str,
    /// What symbols of its formulas stand for.
    pub(super) definitions: &'a str,
    /// Known squares of symbols.
    pub(super) squares: &'a str,
    /// The tests.
    pub tests: Vec<Test<'a>>,
    /// The verdict that is recorded.
    pub expected: EntryVerdict,
}

/// What a test is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TestPart {
    /// What is printed.
    Printed,
    /// What is true instead.
    Corrected,
    /// What holds in any case.
    Always,
}

/// One exact test.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Test<'a> {
    /// What it is about.
    pub part: TestPart,
    pub(super) kind: TestKind<'a>,
}

#[derive(Clone, Debug)]
pub(super) enum TestKind<'a> {
    /// An equation; where it is known to fail, by what its sides differ.
    Identity {
        text: &'a str,
        sides: [Formula; 2],
        difference: Option<(&'a str, Formula)>,
    },
    /// A question to the engine and the claimed answer.
    Question(Question<'a>, &'a str),
}

/// What follows from the tests of an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EntryVerdict {
    /// All tests hold, those of the printed part among them.
    Holds,
    /// Nothing that is printed passes its test, and what is corrected does.
    HoldsOnceCorrected,
    /// What is printed holds in some cases and fails in others.
    ClaimTooStrong,
    /// A test that must hold does not, or a printed formula fails in another way than stated.
    Fails,
}

impl EntryVerdict {
    /// Those that an entry may expect.
    pub(super) const EXPECTED: [Self; 3] =
        [Self::Holds, Self::HoldsOnceCorrected, Self::ClaimTooStrong];

    /// As in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::HoldsOnceCorrected => "holds once corrected",
            Self::ClaimTooStrong => "claim too strong",
            Self::Fails => "fails",
        }
    }
}

impl fmt::Display for EntryVerdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// What came of one test.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Finding {
    /// What it is about.
    pub part: TestPart,
    /// Whether it holds.
    pub holds: bool,
    /// Whether it fails in another way than stated.
    pub surprising: bool,
    /// What was asked, what was claimed and what was found.
    pub evidence: String,
}

/// What came of an entry.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Outcome {
    /// Test by test.
    pub findings: Vec<Finding>,
    /// What follows.
    pub verdict: EntryVerdict,
    /// Whether that is what is recorded.
    pub expected: bool,
    /// How long it took.
    pub time: Duration,
}

impl Entry<'_> {
    /// Evaluates all tests.
    ///
    /// # Errors
    /// Those of the engine and of `limits`.
    pub fn evaluate(&self, limits: &Limits) -> Result<Outcome> {
        let start = Instant::now();
        let mut findings = Vec::new();
        for test in &self.tests {
            limits.check()?;
            findings.push(self.finding(test, limits)?);
        }
        let verdict = verdict(&findings);
        Ok(Outcome {
            findings,
            verdict,
            expected: verdict == self.expected,
            time: start.elapsed(),
        })
    }

    /// The definitions and the known squares, as equations.
    pub(super) fn meanings(&self) -> Vec<[Formula; 2]> {
        let texts = [self.definitions, self.squares];
        let equations = texts.into_iter().flat_map(|text| text.split(';'));
        equations
            .filter_map(|text| Formula::parse_equation(text).ok())
            .collect()
    }

    fn finding(&self, test: &Test<'_>, limits: &Limits) -> Result<Finding> {
        match &test.kind {
            TestKind::Identity {
                text,
                sides: [left, right],
                difference,
            } => {
                let mut meanings = Meanings::new(self.definitions, self.squares)?;
                let found = meanings.compare(left, right)?;
                let mut surprising = false;
                let evidence = match (&found, difference) {
                    (Comparison::Equal, _) => match meanings.symbols() {
                        none if none.is_empty() => format!("{text}: exactly"),
                        symbols => format!("{text}: identically in {symbols}"),
                    },
                    (Comparison::Different(place), None) => format!("{text}: false, {place}"),
                    (Comparison::Different(place), Some((stated, formula))) => {
                        let sum =
                            Formula::Sum(vec![(false, right.clone()), (false, formula.clone())]);
                        surprising = meanings.compare(left, &sum)? != Comparison::Equal;
                        let not = if surprising { "not " } else { "" };
                        format!("{text}: false, {place}; the sides differ {not}by {stated}")
                    }
                };
                Ok(Finding {
                    part: test.part,
                    holds: found == Comparison::Equal,
                    surprising,
                    evidence,
                })
            }
            TestKind::Question(question, claimed) => {
                let answer = question.ask(claimed, limits)?;
                let evidence = if answer.agrees {
                    format!("{question}: {}", answer.found)
                } else {
                    format!("{question}: {}, not {claimed}", answer.found)
                };
                Ok(Finding {
                    part: test.part,
                    holds: answer.agrees,
                    surprising: false,
                    evidence,
                })
            }
        }
    }
}

fn verdict(findings: &[Finding]) -> EntryVerdict {
    let of = |part| findings.iter().filter(move |f| f.part == part);
    let must_hold = of(TestPart::Always).chain(of(TestPart::Corrected));
    if findings.is_empty()
        || findings.iter().any(|f| f.surprising)
        || !must_hold.into_iter().all(|f| f.holds)
    {
        return EntryVerdict::Fails;
    }
    let printed = of(TestPart::Printed).count();
    let held = of(TestPart::Printed).filter(|f| f.holds).count();
    if held == printed {
        EntryVerdict::Holds
    } else if held > 0 {
        EntryVerdict::ClaimTooStrong
    } else if of(TestPart::Corrected).count() > 0 {
        EntryVerdict::HoldsOnceCorrected
    } else {
        EntryVerdict::Fails
    }
}
