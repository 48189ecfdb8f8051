//! The reason why a claim or a document is not accepted, with the place of the fault.

use std::fmt;

/// Why something is not accepted. The place is a path of fields and indices such as `statement.roots[2].nearest`; it may be empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The steps of the path, the innermost one first.
    steps: Vec<Step>,
    reason: String,
    /// Whether the check was given up at a limit of the format.
    is_limit: bool,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Step {
    Field(String),
    Element(usize),
}

pub(super) type Checked<T> = Result<T, Refusal>;

impl Refusal {
    pub(super) fn new(reason: impl Into<String>) -> Self {
        Self {
            steps: Vec::new(),
            reason: reason.into(),
            is_limit: false,
        }
    }

    /// Whether the check was given up at a limit of work or time: what is claimed may be true.
    #[must_use]
    pub fn is_limit(&self) -> bool {
        self.is_limit
    }

    /// The same fault, seen from the object around the field.
    pub(super) fn within(mut self, field: &str) -> Self {
        self.steps.push(Step::Field(field.to_owned()));
        self
    }

    /// The same fault, seen from the list around the element.
    pub(super) fn at(mut self, index: usize) -> Self {
        self.steps.push(Step::Element(index));
        self
    }

    /// What is wrong, without the place.
    #[must_use]
    pub fn reason(&self) -> &str {
        &self.reason
    }

    /// The path of fields and indices to the fault.
    #[must_use]
    pub fn place(&self) -> String {
        let mut path = String::new();
        for step in self.steps.iter().rev() {
            match step {
                Step::Field(name) if path.is_empty() => path.push_str(name),
                Step::Field(name) => path.extend([".", name]),
                Step::Element(index) => path.extend(["[", &index.to_string(), "]"]),
            }
        }
        path
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.steps.is_empty() {
            write!(out, "{}", self.reason)
        } else {
            write!(out, "{}: {}", self.place(), self.reason)
        }
    }
}

impl std::error::Error for Refusal {}

/// Refuses for the given reason unless the condition holds.
pub(super) fn need(condition: bool, reason: &str) -> Checked<()> {
    if condition {
        Ok(())
    } else {
        Err(Refusal::new(reason))
    }
}

/// Refuses for the given reason, which is a limit of work or time, unless the condition holds.
pub(super) fn need_within_limit(condition: bool, reason: &str) -> Checked<()> {
    need(condition, reason).map_err(|refusal| Refusal {
        is_limit: true,
        ..refusal
    })
}
