//! The one public error type. Its messages say what is wrong, where, and what would be right.

use std::path::PathBuf;

/// All errors, sorted by who must act.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The text of a form or a number is malformed; the message shows the line with a caret.
    #[error("{}", caret(.message, .source_name, .text, *.at))]
    Syntax {
        /// The fault, and what would be right.
        message: String,
        /// The source of the text: a file name, or `<form>` for the command line.
        source_name: String,
        /// The whole text.
        text: String,
        /// The byte offset of the first wrong character.
        at: usize,
    },
    /// A data file or value is malformed: a row of a CSV file, a field of a document, an image.
    #[error("{place}: {message}")]
    Data {
        /// The place, such as `outline.csv, row 17`.
        place: String,
        /// The fault, and what would be right.
        message: String,
    },
    /// An argument has a value that cannot be right.
    #[error("{0}")]
    Usage(String),
    /// A result of its kind is not written in this format.
    #[error("--format {format}: {written_as}")]
    Format {
        /// The name of the format.
        format: &'static str,
        /// What is written, and the formats that there are.
        written_as: String,
    },
    /// The input is well formed but a theorem's hypothesis fails for it.
    #[error("{statement} does not apply: {witness}")]
    Hypothesis {
        /// The theorem or lemma.
        statement: &'static str,
        /// The reason why the hypothesis fails, with the evidence.
        witness: String,
    },
    /// A stated limit was reached.
    #[error("limit reached: {limit}{}", finished_clause(.finished))]
    Limit {
        /// The limit and its value.
        limit: String,
        /// The part of the work that was finished before; empty if nothing was.
        finished: String,
    },
    /// The user interrupted the work.
    #[error("interrupted; nothing was written")]
    Interrupted,
    /// The program contradicted itself. This is a defect of stellate, not of the input; it is reported instead of a wrong
    /// answer.
    #[error(
        "internal contradiction in {place}: {broken}; nothing was written; please report the input"
    )]
    Internal {
        /// The place: a file and line of the source, or the name of an algorithm.
        place: String,
        /// The invariant that does not hold.
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
    /// The error of a writer whose name is not known here.
    fn from(source: std::io::Error) -> Self {
        Error::Io {
            path: OUTPUT.into(),
            source,
        }
    }
}

/// The name of a writer in messages, until the code that opened it gives the real name.
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

    /// An [`Error::Data`] with the message of a decoder, which is put on one line.
    pub(crate) fn decoding(place: &str, what: &str, error: &dyn std::fmt::Display) -> Self {
        let error = error.to_string();
        let words: Vec<&str> = error.split_whitespace().collect();
        Self::data(place, format!("{what}: {}", words.join(" ")))
    }

    /// An [`Error::Internal`] for an answer that fails its own check in the algorithm `place`.
    pub(crate) fn internal(place: impl Into<String>, broken: impl Into<String>) -> Self {
        Error::Internal {
            place: place.into(),
            broken: broken.into(),
        }
    }

    /// The [`Error::Internal`] for a panic that reached the boundary of the program; it has the payload of the panic and the place
    /// in the source.
    #[must_use]
    pub fn from_panic(payload: &(dyn std::any::Any + Send), place: Option<String>) -> Self {
        let text = payload.downcast_ref::<&str>().copied();
        let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
        Error::Internal {
            place: place.unwrap_or_else(|| "an unknown place".into()),
            broken: text.unwrap_or("a panic without a message").into(),
        }
    }

    /// The reason of the system, for an error of reading or writing, else the whole message.
    #[cfg(feature = "python")]
    pub(crate) fn reason(&self) -> String {
        match self {
            Error::Io { source, .. } => reason(source),
            _ => self.to_string(),
        }
    }

    /// An [`Error::Limit`] without finished parts.
    pub(crate) fn limit(limit: impl Into<String>) -> Self {
        Error::Limit {
            limit: limit.into(),
            finished: String::new(),
        }
    }
}

/// Invariants: `value.invariant("a part has a degree")` is the value, or a panic with this statement if there is no value. The
/// command line ends with the panic and reports it as [`Error::Internal`] (exit code 4).
///
/// Only code that guarantees the invariant may use it. A failure that depends on the input alone must be another error.
pub trait Invariant {
    /// The type of the value that exists if the invariant holds.
    type Value;

    /// The value, which exists because `statement` is true.
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

/// The message of the system, without the number of the error.
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

/// The largest part of a line of the text that an error message repeats, in characters.
const LINE_SHOWN: usize = 100;

/// The message, then the line with the wrong character, and a caret under that character.
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
