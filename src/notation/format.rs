//! The formats that results are written in.

use std::fmt;
use std::str::FromStr;

use crate::error::{Error, Result};

/// A format of results.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Format {
    /// Text: a formula in the input language.
    #[default]
    Text,
    /// JSON: a document with every exact number as a string.
    Json,
    /// CSV: a table of coefficients.
    Csv,
    /// LaTeX: a formula to be typeset.
    Latex,
    /// SymPy: an expression, which is also Python with x, y and Rational in scope.
    Sympy,
    /// Maple: a statement.
    Maple,
    /// Singular: statements.
    Singular,
}

use Format::{Csv, Json, Latex, Maple, Singular, Sympy, Text};

impl Format {
    /// All formats.
    pub const ALL: [Self; 7] = [Text, Json, Csv, Latex, Sympy, Maple, Singular];

    /// The name that the command line uses.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Text => "text",
            Json => "json",
            Csv => "csv",
            Latex => "latex",
            Sympy => "sympy",
            Maple => "maple",
            Singular => "singular",
        }
    }

    /// The format of the files with this extension, in capitals or not.
    ///
    /// ```
    /// use stellate::document::Format;
    /// assert_eq!(Format::of_extension("tex"), Some(Format::Latex));
    /// assert_eq!(Format::of_extension("svg"), None);
    /// ```
    #[must_use]
    pub fn of_extension(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            "txt" => Some(Text),
            "json" => Some(Json),
            "csv" => Some(Csv),
            "tex" => Some(Latex),
            _ => None,
        }
    }

    /// The text that starts a comment; it is empty for JSON, which has no comments.
    pub(crate) fn comment(self) -> &'static str {
        match self {
            Latex => "%",
            Singular => "//",
            _ => "#",
        }
    }

    /// A description for people.
    #[must_use]
    pub fn about(self) -> &'static str {
        match self {
            Text => "A formula in the input language",
            Json => "A document with every exact number as a string",
            Csv => "A table of coefficients",
            Latex => "A formula to be typeset",
            Sympy => "An expression for SymPy, or for Python with x, y and Rational in scope",
            Maple => "A statement for Maple",
            Singular => "Statements for Singular",
        }
    }
}

impl fmt::Display for Format {
    /// The name that the command line uses.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Format {
    type Err = Error;

    /// The format with this name on the command line, in capitals or not; `tex` is LaTeX, too.
    ///
    /// ```
    /// use stellate::document::Format;
    /// assert_eq!("LaTeX".parse::<Format>()?, Format::Latex);
    /// assert_eq!("tex".parse::<Format>()?, Format::Latex);
    /// assert!("pdf".parse::<Format>().is_err());
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    fn from_str(name: &str) -> Result<Self> {
        let is_meant = |format: &Self| {
            let names = [Some(format.name()), (*format == Latex).then_some("tex")];
            names
                .into_iter()
                .flatten()
                .any(|n| n.eq_ignore_ascii_case(name))
        };
        let found = Self::ALL.into_iter().find(is_meant);
        found.ok_or_else(|| Error::Usage(format!("there is no format {name}")))
    }
}
