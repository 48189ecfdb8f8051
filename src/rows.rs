//! Rows of numbers are read one by one, so that tables of any length need bounded memory.
//!
//! The `csv` crate cannot do this, because messages name rows: its positions do not count the blank lines and comments that it
//! skips before a record.

use std::borrow::Cow;
use std::io::{BufRead, Read};

use crate::error::{Error, Result};
use crate::exact::{Rational, double_literal};

/// The largest length of a row, in bytes.
const MAX_ROW_BYTES: u64 = 1 << 16;

/// Reads rows of numbers that are separated by commas. The first row may be a header; blank rows and rows that begin with `#`
/// are skipped.
#[derive(Debug)]
pub(crate) struct RowReader<'a, R> {
    reader: R,
    place: &'a str,
    expected: &'a str,
    row: usize,
    may_be_header: bool,
    header: Option<String>,
    /// The center that a comment before the first row of numbers states, and the number of the comment's row.
    center: Option<(usize, Vec<Rational>)>,
    has_begun: bool,
    line: Vec<u8>,
}

impl<'a, R: BufRead> RowReader<'a, R> {
    /// A reader of rows. In messages `place` names the source and `expected` names the columns.
    pub(crate) fn new(reader: R, place: &'a str, expected: &'a str) -> Self {
        Self {
            reader,
            place,
            expected,
            row: 0,
            may_be_header: true,
            header: None,
            center: None,
            has_begun: false,
            line: Vec::new(),
        }
    }

    /// The next row, trimmed, with its number (counted from 1; every line counts); `None` at the end.
    ///
    /// # Errors
    /// [`Error::Data`] for a row that is not text or is longer than 64 KiB; [`Error::Io`] if reading fails.
    pub(crate) fn next_row(&mut self) -> Result<Option<(usize, &str)>> {
        loop {
            self.line.clear();
            self.row += 1;
            let length = (&mut self.reader)
                .take(MAX_ROW_BYTES)
                .read_until(b'\n', &mut self.line)
                .map_err(|source| Error::Io {
                    path: self.place.into(),
                    source,
                })?;
            if length == 0 {
                return Ok(None);
            }
            let row = self.text()?;
            // Coordinates relative to the origin are original ones.
            let is_origin = |center: &Vec<Rational>| center.iter().all(Rational::is_zero);
            let center = stated_center(row).filter(|c| !self.has_begun && !is_origin(c));
            let is_content = !(row.is_empty() || row.starts_with('#'));
            let is_header = is_content && self.may_be_header && is_header(row);
            let header = is_header.then(|| row.to_owned());
            if let Some(center) = center {
                self.center = Some((self.row, center));
            }
            if is_content {
                self.may_be_header = false;
                if !is_header {
                    break;
                }
                self.header = header;
            }
        }
        self.has_begun = true;
        Ok(Some((self.row, self.text()?)))
    }

    /// The first row, if it was a header; known with the first row of numbers.
    pub(crate) fn header(&self) -> Option<&str> {
        self.header.as_deref()
    }

    /// Refuses points whose coordinates are relative to a center, as those that `sample` writes by default; known with the first
    /// row of numbers.
    ///
    /// # Errors
    /// [`Error::Data`] if a comment before the first row of numbers states a center that is not the origin.
    pub(crate) fn refuse_center(&self) -> Result<()> {
        match &self.center {
            Some((row, center)) => Err(self.error(
                *row,
                format!(
                    "these points are relative to the center ({center}); expected points in original coordinates, as sample --coordinates original writes them",
                    center = listed(center)
                ),
            )),
            None => Ok(()),
        }
    }

    fn text(&self) -> Result<&str> {
        let text = std::str::from_utf8(&self.line).map_err(|_| {
            self.error(
                self.row,
                format!("not UTF-8 text; each row must be {}", self.expected),
            )
        })?;
        if !text.ends_with('\n') && self.line.len() as u64 >= MAX_ROW_BYTES {
            return Err(self.error(
                self.row,
                format!(
                    "longer than {MAX_ROW_BYTES} bytes; each row must be {}",
                    self.expected
                ),
            ));
        }
        Ok(text.trim_start_matches('\u{feff}').trim())
    }

    /// The error for a wrong row.
    pub(crate) fn error(&self, row: usize, message: impl Into<String>) -> Error {
        row_error(self.place, row, message)
    }
}

/// The center that a table of points states in a comment before its first row.
pub(crate) fn center_of_table(text: &str) -> Option<Vec<Rational>> {
    let lines = text.trim_start_matches('\u{feff}').lines().map(str::trim);
    let mut before = lines.take_while(|l| l.is_empty() || l.starts_with('#') || is_header(l));
    before.find_map(stated_center)
}

/// The point of a comment such as `# center 1 2 1/3`, which tables of points have if their coordinates are relative to it.
fn stated_center(comment: &str) -> Option<Vec<Rational>> {
    let rest = comment
        .strip_prefix('#')?
        .trim_start()
        .strip_prefix("center")?;
    let numbers = rest.split([':', ',', ' ', '\t']);
    let exact = numbers
        .filter(|word| !word.is_empty())
        .map(|number| number.parse().ok());
    let exact: Vec<Rational> = exact.collect::<Option<_>>()?;
    matches!(exact.len(), 2 | 3).then_some(exact)
}

/// The coordinates of a point, as in `1, 2, 1/3`.
pub(crate) fn listed(point: &[Rational]) -> String {
    let all: Vec<String> = point.iter().map(Rational::to_string).collect();
    all.join(", ")
}

/// The error for a wrong row of the source `place`.
#[must_use]
pub(crate) fn row_error(place: &str, row: usize, message: impl Into<String>) -> Error {
    Error::data(format!("{place}, row {row}"), message)
}

/// `1 column`, `2 columns`
pub(crate) fn columns_text(count: usize) -> String {
    match count {
        1 => "1 column".into(),
        n => format!("{n} columns"),
    }
}

/// The fields of a row that commas separate: see [`fields_between`].
pub(crate) fn fields(row: &str) -> impl Iterator<Item = &str> {
    fields_between(row, ',')
}

/// The fields of a row between separators, without white space around them and without one pair of double quotes around each.
/// A field in quotes may have the separator in it.
pub(crate) fn fields_between(row: &str, separator: char) -> impl Iterator<Item = &str> {
    let mut rest = Some(row);
    let split = std::iter::from_fn(move || {
        let text = rest?;
        let quoted = text.trim_start().strip_prefix('"');
        let closed = quoted.and_then(|inner| Some(behind_quote(inner)?.len()));
        let from = closed.map_or(0, |behind| text.len() - behind);
        let end = text[from..].find(separator).map(|at| from + at);
        rest = end.map(|end| &text[end + separator.len_utf8()..]);
        Some(&text[..end.unwrap_or(text.len())])
    });
    split.map(|field| {
        let field = field.trim();
        field
            .strip_prefix('"')
            .and_then(|rest| rest.strip_suffix('"'))
            .map_or(field, str::trim)
    })
}

/// A row in which each field that is in quotes is one letter.
fn without_quoted(row: &str) -> Cow<'_, str> {
    if !row.contains('"') {
        return Cow::Borrowed(row);
    }
    let mut result = String::new();
    let mut rest = row;
    while let Some(at) = rest.find('"') {
        let (before, quoted) = rest.split_at(at);
        result.push_str(before);
        let begins_field = result
            .trim_end_matches(' ')
            .chars()
            .next_back()
            .is_none_or(|c| matches!(c, ',' | ';' | '\t'));
        let closed = begins_field.then(|| behind_quote(&quoted[1..])).flatten();
        result.push('q');
        rest = closed.unwrap_or(&quoted[1..]);
    }
    result.push_str(rest);
    Cow::Owned(result)
}

/// What is behind the quotation mark that closes a field; within the field, the mark is doubled.
fn behind_quote(mut inner: &str) -> Option<&str> {
    loop {
        let behind = &inner[inner.find('"')? + 1..];
        match behind.strip_prefix('"') {
            Some(rest) => inner = rest,
            None => return Some(behind),
        }
    }
}

/// How the fields of a row are separated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Separator {
    Comma,
    Semicolon,
    Tab,
    Blanks,
}

impl Separator {
    /// A semicolon or a tab wherever there is one; blanks between numbers that have decimal commas, or no comma at all.
    pub(crate) fn of(row: &str) -> Self {
        let row = &*without_quoted(row);
        let mut words = row.split_whitespace();
        let has_several = words.clone().count() > 1;
        let mut has_decimal_commas =
            || words.all(|word| double(&word.replacen(',', ".", 1)).is_ok());
        if row.contains(';') {
            Self::Semicolon
        } else if row.contains('\t') {
            Self::Tab
        } else if has_several && (!row.contains(',') || has_decimal_commas()) {
            Self::Blanks
        } else {
            Self::Comma
        }
    }

    pub(crate) fn split(self, row: &str) -> Box<dyn Iterator<Item = &str> + '_> {
        match self {
            Self::Comma => Box::new(fields_between(row, ',')),
            Self::Semicolon => Box::new(fields_between(row, ';')),
            Self::Tab => Box::new(fields_between(row, '\t')),
            Self::Blanks => Box::new(row.split_whitespace()),
        }
    }
}

/// The number of fields without empty ones at the end.
pub(crate) fn filled(fields: &[&str]) -> usize {
    let last = fields.iter().rposition(|field| !field.is_empty());
    last.map_or(0, |last| last + 1)
}

/// The words of a row, whatever separates them.
pub(crate) fn words(row: &str) -> impl Iterator<Item = &str> {
    let parts = row.split(|c: char| matches!(c, ',' | ';') || c.is_whitespace());
    parts
        .map(|part| part.trim_matches('"'))
        .filter(|part| !part.is_empty())
}

/// Whether the first row has names, or a title such as `NACA 0012`: none of its fields begins with a number, and one of them is a word.
fn is_header(row: &str) -> bool {
    let fields = row
        .split([',', ';', '\t'])
        .filter_map(|field| words(field).next());
    let fields: Vec<&str> = fields.collect();
    fields.iter().any(|field| is_word(field)) && !fields.into_iter().any(is_number)
}

/// Whether a field is a word, and no number with something beside it, as in `9mm` and `$9`.
fn is_word(field: &str) -> bool {
    let letters = field.trim_start_matches(['_', '(', '[']);
    letters.starts_with(char::is_alphabetic) || !field.contains(|c: char| c.is_ascii_digit())
}

/// Whether a field is a number, if only a wrong one: infinity, NaN, a mark of a missing number, or a number that is too large.
fn is_number(field: &str) -> bool {
    double(field).is_ok() || field.parse::<f64>().is_ok() || is_missing(field)
}

/// Whether a field stands for a number that is missing.
pub(crate) fn is_missing(field: &str) -> bool {
    let small = field.to_ascii_lowercase();
    let marks = ["", "-", "na", "n/a", "#n/a", "<na>", "nan", "none", "null"];
    marks.contains(&small.as_str())
}

/// The double nearest to a number in a text.
///
/// # Errors
/// The message for a text that is not a finite number.
pub(crate) fn double(field: &str) -> std::result::Result<f64, String> {
    let is_plain = field
        .bytes()
        .all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'+' | b'-' | b'e' | b'E'));
    let value = if is_plain {
        field.parse().ok()
    } else {
        double_literal(field).ok().map(|exact| exact.to_f64())
    };
    match value {
        Some(value) if value.is_finite() => Ok(value),
        Some(_) => Err(format!("{field} is too large for a double")),
        None => Err(format!("{:?} is not a number", shortened(field))),
    }
}

/// At most 40 characters of a field, for messages.
fn shortened(field: &str) -> String {
    let mut short: String = field.chars().take(40).collect();
    if short.len() < field.len() {
        short.push('…');
    }
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_numbered_as_in_the_file() {
        let text = "x,y\n\n1,-0x1p-1\n".as_bytes();
        let mut rows = RowReader::new(text, "points.csv", "x,y");
        let (number, row) = rows.next_row().unwrap().unwrap();
        assert_eq!((number, row), (3, "1,-0x1p-1"));
        let numbers: Vec<_> = fields(row).map(double).collect();
        assert_eq!(numbers, [Ok(1.0), Ok(-0.5)]);
        assert!(rows.next_row().unwrap().is_none());
    }
}
