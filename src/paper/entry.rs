//! One statement of the paper: its tests, and the verdict that follows from them.

use std::fmt;
use std::time::{Duration, Instant};

use super::formula::Formula;
use super::identity::{Comparison, Meanings};
use super::mathml;
use super::question::Question;
use super::text::Text;
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
    pub printed: Text,
    /// What is true.
    pub correct: Text,
    /// What else there is to say of it, possibly nothing.
    pub note: Text,
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

    /// What it means, in a sentence.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Holds => "What the paper prints passes every test.",
            Self::HoldsOnceCorrected => {
                "What the paper prints fails its tests, and what stands beside it as correct passes them: a misprint or a slip."
            }
            Self::ClaimTooStrong => {
                "What the paper prints holds in some of the tested cases and fails in others: it needs a condition that the \
                 paper does not name, or it promises too much. What stands beside it as correct holds in all of them."
            }
            Self::Fails => {
                "A test that must hold fails, or what is printed fails in another way than is recorded: a fault of stellate."
            }
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
    /// What was asked and what was found, as a sentence; what was claimed, too, if it is something else.
    pub evidence: Text,
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
    /// How long it took by the clock.
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
                sides,
                difference,
            } => self.compared(test.part, text, sides, difference.as_ref()),
            TestKind::Question(question, claimed) => {
                let answer = question.ask(claimed, limits)?;
                Ok(Finding {
                    part: test.part,
                    holds: answer.agrees,
                    surprising: false,
                    evidence: question.sentence(&answer, claimed),
                })
            }
        }
    }

    /// What comes of an identity; where it is known to fail, its left side is to be the right one plus a difference.
    fn compared(
        &self,
        part: TestPart,
        text: &str,
        sides: &[Formula; 2],
        difference: Option<&(&str, Formula)>,
    ) -> Result<Finding> {
        let mut meanings = Meanings::new(self.definitions, self.squares)?;
        let [left, right] = sides;
        let found = meanings.compare(left, right)?;
        let quoted = |text: &str| format!("`{text}`");
        let mut evidence = Text::default()
            .words("the equation ")
            .formula(quoted(text), mathml::equation(left, right));
        let mut surprising = false;
        match (&found, difference) {
            (Comparison::Equal, _) => {
                evidence = evidence.words(" holds");
                for (index, name) in meanings.symbols().iter().enumerate() {
                    let before = if index == 0 { " identically in " } else { ", " };
                    evidence = evidence
                        .words(before)
                        .formula(name.clone(), mathml::named(name));
                }
                evidence = evidence.words(".");
            }
            (Comparison::Different(place), None) => {
                evidence = evidence.words(&format!(" is false, since {place}."));
            }
            (Comparison::Different(place), Some((stated, formula))) => {
                let sum = Formula::Sum(vec![(false, right.clone()), (false, formula.clone())]);
                surprising = meanings.compare(left, &sum)? != Comparison::Equal;
                let not = if surprising { "not " } else { "" };
                evidence = evidence
                    .words(&format!(
                        " is false, since {place}. Its left side is {not}its right side plus "
                    ))
                    .formula(quoted(stated), mathml::formula(formula))
                    .words(".");
            }
        }
        Ok(Finding {
            part,
            holds: found == Comparison::Equal,
            surprising,
            evidence,
        })
    }
}

impl Finding {
    /// In whole sentences: what it is about, whether it holds, and the evidence.
    pub(super) fn sentences(&self) -> Text {
        let evidence = self.evidence.clone();
        let beginning = match (self.part, self.holds) {
            (TestPart::Always, true) => return evidence.capitalized(),
            (TestPart::Printed, true) => "What is printed holds here: ",
            (TestPart::Printed, false) => "What is printed fails here: ",
            (TestPart::Corrected, true) => "What is correct holds here: ",
            (TestPart::Corrected, false) => "What was to be correct fails here: ",
            (TestPart::Always, false) => "What must hold fails here: ",
        };
        Text::default().words(beginning).followed_by(evidence)
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
