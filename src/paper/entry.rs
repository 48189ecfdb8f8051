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
    /// The identifier: `T2`, `L4`, `E9`, `Eq63`, `F12`, `AppB`, …
    pub id: &'a str,
    /// The title.
    pub title: &'a str,
    /// The section of the paper.
    pub section: &'a str,
    /// The statement as the paper prints it.
    pub printed: Text,
    /// The statement as it is true. It is the same text if the paper is right.
    pub correct: Text,
    /// A remark, which may be empty.
    pub note: Text,
    /// Definitions of symbols in the formulas: `p = …; q = …`.
    pub(super) definitions: &'a str,
    /// Known squares of symbols: `w^2 = -3; …`.
    pub(super) squares: &'a str,
    /// The tests.
    pub tests: Vec<Test<'a>>,
    /// The recorded verdict, with which the outcome is compared.
    pub expected: EntryVerdict,
}

/// The part of a statement that a test is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TestPart {
    /// The statement as printed.
    Printed,
    /// The corrected statement.
    Corrected,
    /// A fact that must hold whether the paper is right or wrong.
    Always,
}

/// One exact test.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Test<'a> {
    /// The part of the statement that the test is about.
    pub part: TestPart,
    pub(super) kind: TestKind<'a>,
}

#[derive(Clone, Debug)]
pub(super) enum TestKind<'a> {
    /// An equation. If it is known to fail, `difference` is its left side minus its right side.
    Identity {
        text: &'a str,
        sides: [Formula; 2],
        difference: Option<(&'a str, Formula)>,
    },
    /// A question that the library answers, and the claimed answer.
    Question(Question<'a>, &'a str),
}

/// The verdict that follows from the tests of an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EntryVerdict {
    /// All tests hold, those of the printed part among them.
    Holds,
    /// No test of the printed statement holds, and all tests of the corrected one do.
    HoldsOnceCorrected,
    /// Some tests of the printed statement hold and others fail.
    ClaimTooStrong,
    /// A test that must hold fails, a printed formula fails in another way than recorded, or there are too few tests for
    /// another verdict.
    Fails,
}

impl EntryVerdict {
    /// The verdicts that an entry may record.
    pub(super) const EXPECTED: [Self; 3] =
        [Self::Holds, Self::HoldsOnceCorrected, Self::ClaimTooStrong];

    /// The name in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::HoldsOnceCorrected => "holds once corrected",
            Self::ClaimTooStrong => "claim too strong",
            Self::Fails => "fails",
        }
    }

    /// The meaning, in whole sentences.
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

/// The result of one test.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Finding {
    /// The part of the statement that the test is about.
    pub part: TestPart,
    /// Whether it holds.
    pub holds: bool,
    /// Whether it fails in another way than recorded.
    pub surprising: bool,
    /// The question and the answer that was found, as a sentence; if another answer was claimed, it contains that one, too.
    pub evidence: Text,
}

/// The results of the tests of an entry.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Outcome {
    /// The findings, in the order of the tests.
    pub findings: Vec<Finding>,
    /// The verdict that follows from the findings.
    pub verdict: EntryVerdict,
    /// Whether this is the recorded verdict.
    pub expected: bool,
    /// The time that the tests took by the clock.
    pub time: Duration,
}

impl Entry<'_> {
    /// Evaluates all tests.
    ///
    /// # Errors
    /// Those of the tests and of `limits`.
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

    /// Tests an identity. If it is known to fail, its left side must be its right side plus `difference`.
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
    /// The finding in whole sentences: what it is about, whether it holds, and the evidence.
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
