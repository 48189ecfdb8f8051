//! The text that is read, and errors that point into it.

use crate::error::{Error, Invariant};

/// The largest number of characters of the input that a message repeats.
pub(super) const MAX_SHOWN: usize = 30;

/// A text, and the name of its source in messages.
#[derive(Clone, Copy, Debug)]
pub(super) struct Source<'a> {
    pub(super) name: &'a str,
    pub(super) text: &'a str,
}

/// A stretch of the text, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Span {
    pub(super) start: u32,
    pub(super) end: u32,
}

impl Span {
    /// From the start of `self` to the end of `other`.
    pub(super) fn to(self, other: Span) -> Span {
        Span {
            start: self.start,
            end: other.end,
        }
    }
}

impl<'a> Source<'a> {
    pub(super) fn slice(&self, span: Span) -> &'a str {
        self.text
            .get(span.start as usize..span.end as usize)
            .invariant("a span lies within its text")
    }

    /// The text of `span` between backquotes, shortened if it is long.
    pub(super) fn quoted(&self, span: Span) -> String {
        let text = self.slice(span);
        let mut shown: String = text.chars().take(MAX_SHOWN).collect();
        if shown.len() < text.len() {
            shown.push('…');
        }
        format!("`{shown}`")
    }

    /// An error that points at the start of `span`.
    pub(super) fn error(&self, span: Span, message: impl Into<String>) -> Error {
        Error::Syntax {
            message: message.into(),
            source_name: self.name.into(),
            text: self.text.into(),
            at: span.start as usize,
        }
    }

    /// A limit that was reached at `span`.
    pub(super) fn limit(&self, span: Span, limit: impl std::fmt::Display) -> Error {
        let before = self.text.get(..span.start as usize);
        let before = before.invariant("a span lies within its text");
        let line = before.matches('\n').count() + 1;
        let last_line = before.rfind('\n').map_or(0, |newline| newline + 1);
        let column = before[last_line..].chars().count() + 1;
        Error::limit(format!("{}:{line}:{column}: {limit}", self.name))
    }
}
