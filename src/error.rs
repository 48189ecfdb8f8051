//! The one public error: what was wrong, where, and what would be right.

use std::path::PathBuf;

/// Everything that can go wrong, sorted by whose turn it is to act.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The text of a form or a number is malformed; the message shows the line with a caret.
    #[error("{}", caret(.message, .source_name, .text, *.at))]
    Syntax {
        /// What is wrong and what would be right.
        message: String,
        /// Where the text came from: a file name, or `<form>` for the command line.
        source_name: String,
        /// The whole text.
        text: String,
        /// Byte offset of the first offending character.
        at: usize,
    },
    /// A data file or value is malformed: a row of a CSV file, a field of a document, an image.
    #[error("{place}: {message}")]
    Data {
        /// Where: `outline.csv, row 17`.
        place: String,
        /// What is wrong and what would be right.
        message: String,
    },
    /// An argument has a value that cannot be right.
    #[error("{0}")]
    Usage(String),
    /// The input is well formed but a theorem's hypothesis fails for it.
    #[error("{statement} does not apply: {witness}")]
    Hypothesis {
        /// Which theorem or lemma.
        statement: &'static str,
        /// Why not, with the evidence.
        witness: String,
    },
    /// A stated limit was reached.
    #[error("limit reached: {limit}{}", finished_clause(.finished))]
    Limit {
        /// Which limit and its value.
        limit: String,
        /// What was finished before, empty if nothing.
        finished: String,
    },
    /// The user interrupted the work.
    #[error("interrupted; nothing was written")]
    Interrupted,
    /// The program contradicted itself: a defect of stellate, not of the input. A wrong answer is never preferred to this.
    #[error(
        "internal contradiction in {place}: {broken}; nothing was written; please report the input"
    )]
    Internal {
        /// Where: a file and line of the source, or the name of an algorithm.
        place: String,
        /// Which invariant does not hold.
        broken: String,
    },
    /// Reading or writing failed.
    #[error("{}: {}", .path.display(), reason(.source))]
    Io {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
}

impl From<std::io::Error> for Error {
    /// An error of a writer that has no name here.
    fn from(source: std::io::Error) -> Self {
        Error::Io {
            path: OUTPUT.into(),
            source,
        }
    }
}

/// What a writer is called in messages until whoever opened it says its name.
pub const OUTPUT: &str = "output";

/// The result of every fallible function of this crate.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// A [`Error::Data`] from its two parts.
    pub(crate) fn data(place: impl Into<String>, message: impl Into<String>) -> Self {
        Error::Data {
            place: place.into(),
            message: message.into(),
        }
    }

    /// A [`Error::Internal`] for an answer that does not pass its own check in the algorithm `place`.
    pub(crate) fn internal(place: impl Into<String>, broken: impl Into<String>) -> Self {
        Error::Internal {
            place: place.into(),
            broken: broken.into(),
        }
    }

    /// The [`Error::Internal`] for a panic that was caught at the boundary of the program, given what it carried and the
    /// place in the source where it arose.
    #[must_use]
    pub fn from_panic(payload: &(dyn std::any::Any + Send), place: Option<String>) -> Self {
        let text = payload.downcast_ref::<&str>().copied();
        let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
        Error::Internal {
            place: place.unwrap_or_else(|| "an unknown place".into()),
            broken: text.unwrap_or("a panic without a message").into(),
        }
    }

    /// A [`Error::Limit`] with nothing finished.
    pub(crate) fn limit(limit: impl Into<String>) -> Self {
        Error::Limit {
            limit: limit.into(),
            finished: String::new(),
        }
    }
}

/// What cannot happen stops the program loudly: `value.invariant("a part has a degree")` is the value, or a panic with that
/// statement. The command line catches it once and reports it as [`Error::Internal`] (exit code 4).
///
/// Only for what the code around it guarantees, never for what depends on the input alone.
pub(crate) trait Invariant {
    /// What is there if the invariant holds.
    type Value;

    /// The value, which is there because of what `statement` says.
    #[track_caller]
    fn invariant(self, statement: &str) -> Self::Value;
}

impl<T> Invariant for Option<T> {
    type Value = T;

    #[inline]
    fn invariant(self, statement: &str) -> T {
        match self {
            Some(value) => value,
            None => broken(statement),
        }
    }
}

impl<T, E> Invariant for std::result::Result<T, E> {
    type Value = T;

    #[inline]
    fn invariant(self, statement: &str) -> T {
        match self {
            Ok(value) => value,
            Err(_) => broken(statement),
        }
    }
}

/// Stops the program because `statement` does not hold.
#[cold]
#[inline(never)]
#[track_caller]
pub(crate) fn broken(statement: &str) -> ! {
    panic!("it does not hold that {statement}")
}

/// What the system says, without its number for it.
fn reason(source: &std::io::Error) -> String {
    let text = source.to_string();
    match text.split_once(" (os error") {
        Some((reason, _)) => reason.to_owned(),
        None => text,
    }
}

fn finished_clause(finished: &str) -> String {
    if finished.is_empty() {
        String::new()
    } else {
        format!(" ({finished})")
    }
}

/// The longest stretch of a source line that an error message repeats.
const LINE_SHOWN: usize = 100;

/// `message`, then the offending line and a caret under the offending character.
fn caret(message: &str, source_name: &str, text: &str, at: usize) -> String {
    let at = (0..=at.min(text.len()))
        .rev()
        .find(|&i| text.is_char_boundary(i))
        .unwrap_or(0);
    let start = text[..at].rfind('\n').map_or(0, |i| i + 1);
    let end = text[at..].find('\n').map_or(text.len(), |i| at + i);
    let number = text[..start].matches('\n').count() + 1;
    let before: Vec<char> = text[start..at].chars().collect();
    let after: Vec<char> = text[at..end].chars().collect();
    let skipped = before.len().saturating_sub(LINE_SHOWN / 2);
    let shown: String = before[skipped..]
        .iter()
        .chain(after.iter().take(LINE_SHOWN / 2))
        .collect();
    let dots = if skipped > 0 { "…" } else { "" };
    let pad = " ".repeat(before.len() - skipped + dots.chars().count());
    let column = before.len() + 1;
    format!("{source_name}:{number}:{column}: {message}\n  | {dots}{shown}\n  | {pad}^")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_broken_invariant_is_an_internal_error() {
        assert_eq!(Some(3).invariant("three is there"), 3);
        assert_eq!(Ok::<_, ()>(3).invariant("three is there"), 3);
        for broken in [
            std::panic::catch_unwind(|| None::<u8>.invariant("a part has a degree")),
            std::panic::catch_unwind(|| Err(()).invariant("a part has a degree")),
        ] {
            let payload = broken.expect_err("nothing is there");
            let error = Error::from_panic(payload.as_ref(), Some("src/poly/form.rs:7".into()));
            assert_eq!(
                error.to_string(),
                "internal contradiction in src/poly/form.rs:7: it does not hold that a part has a degree; nothing was \
                 written; please report the input"
            );
        }
    }

    #[test]
    fn a_syntax_error_points_at_the_character() {
        let error = Error::Syntax {
            message: "unknown name `q`".into(),
            source_name: "<form>".into(),
            text: "x = 1\ny = −2q".into(),
            at: "x = 1\ny = −2".len(),
        };
        assert_eq!(
            error.to_string(),
            "<form>:2:7: unknown name `q`\n  | y = −2q\n  |       ^"
        );
    }
}
