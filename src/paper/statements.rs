//! Reads the statements. Their files consist of `key: value` lines, one block of lines for each entry.

use super::entry::{Entry, EntryVerdict, Test, TestKind, TestPart};
use super::formula::Formula;
use super::question::Question;
use super::text::Text;
use crate::error::{Error, Result};

/// The files, in the order of the paper.
const FILES: [(&str, &str); 6] = [
    ("implicit.txt", include_str!("statements/implicit.txt")),
    ("polar.txt", include_str!("statements/polar.txt")),
    ("space.txt", include_str!("statements/space.txt")),
    ("inspection.txt", include_str!("statements/inspection.txt")),
    ("figures.txt", include_str!("statements/figures.txt")),
    ("appendices.txt", include_str!("statements/appendices.txt")),
];

/// All statements of the paper, in its order.
///
/// ```
/// use stellate::limits::Limits;
/// use stellate::paper::{EntryVerdict, entries};
///
/// let entries = entries()?;
/// assert!(entries.len() >= 60);
/// let definition = entries.iter().find(|e| e.id == "D1").expect("Definition 1");
/// let outcome = definition.evaluate(&Limits::none())?;
/// assert_eq!(outcome.verdict, EntryVerdict::HoldsOnceCorrected);
/// assert!(outcome.expected);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// As [`read_entries`].
pub fn entries() -> Result<Vec<Entry<'static>>> {
    let mut entries = Vec::new();
    for (name, text) in FILES {
        entries.extend(read_entries(text, name)?);
    }
    Ok(entries)
}

/// Reads statements.
///
/// `# …` is a comment, `== …` begins a section, and `[ID] title` begins an entry. The lines of an entry are:
///
/// - `printed:`, `correct:` and `note:`, which are texts with formulas between dollars; `correct:` is omitted if it is the same
///   as `printed:`;
/// - `where:`, definitions `p = …; q = …` of symbols, and `squares:`, known squares such as `w^2 = -3`;
/// - `expected:`, the recorded verdict;
/// - `test:`, `test printed:` and `test corrected:`, the tests.
///
/// A test is `identity: left = right`, followed by ` => difference` if the left side is known to be the right side plus this
/// difference, or a question `kind: subject => answer`.
///
/// # Errors
/// [`Error::Data`] with the number of a line that is none of these or that has a malformed test.
pub fn read_entries<'a>(text: &'a str, name: &str) -> Result<Vec<Entry<'a>>> {
    let mut entries: Vec<Entry<'a>> = Vec::new();
    let mut section = "";
    for (number, line) in text.lines().enumerate() {
        let line = line.trim();
        let wrong = |message: String| Error::data(format!("{name}, line {}", number + 1), message);
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        if let Some(title) = line.strip_prefix("== ") {
            section = title;
            continue;
        }
        if let Some((id, title)) = line.strip_prefix('[').and_then(|l| l.split_once("] ")) {
            entries.push(Entry {
                id,
                title,
                section,
                printed: Text::default(),
                correct: Text::default(),
                note: Text::default(),
                definitions: "",
                squares: "",
                tests: Vec::new(),
                expected: EntryVerdict::Holds,
            });
            continue;
        }
        let (Some(entry), Some((key, value))) = (entries.last_mut(), line.split_once(':')) else {
            return Err(wrong("expected `[ID] title` or `key: value`".into()));
        };
        let value = value.trim();
        let part = match key {
            "printed" => {
                entry.printed = Text::marked(value);
                continue;
            }
            "correct" => {
                entry.correct = Text::marked(value);
                continue;
            }
            "note" => {
                entry.note = Text::marked(value);
                continue;
            }
            "where" => {
                entry.definitions = value;
                continue;
            }
            "squares" => {
                entry.squares = value;
                continue;
            }
            "expected" => {
                let verdict = EntryVerdict::EXPECTED
                    .into_iter()
                    .find(|v| v.name() == value);
                entry.expected = verdict.ok_or_else(|| wrong(format!("no verdict: {value}")))?;
                continue;
            }
            "test" => TestPart::Always,
            "test printed" => TestPart::Printed,
            "test corrected" => TestPart::Corrected,
            _ => return Err(wrong(format!("unknown key `{key}`"))),
        };
        let kind = test_kind(value).map_err(|error| wrong(error.to_string()))?;
        entry.tests.push(Test { part, kind });
    }
    for entry in &mut entries {
        if entry.correct.is_empty() {
            entry.correct = entry.printed.clone();
        }
    }
    Ok(entries)
}

fn test_kind(text: &str) -> Result<TestKind<'_>> {
    let (asked, claimed) = match text.split_once(" => ") {
        Some((asked, claimed)) => (asked.trim(), Some(claimed.trim())),
        None => (text, None),
    };
    if let Some(equation) = asked.strip_prefix("identity:") {
        let difference = match claimed {
            Some(text) => Some((text, Formula::parse(text)?)),
            None => None,
        };
        let text = equation.trim();
        return Ok(TestKind::Identity {
            text,
            sides: Formula::parse_equation(text)?,
            difference,
        });
    }
    let question = Question::new(asked)?;
    match claimed {
        Some(claimed) => Ok(TestKind::Question(question, claimed)),
        None => Err(Error::Usage(format!(
            "`{text}`: expected ` => ` and the answer"
        ))),
    }
}
