//! Rows of points.
//!
//! Rows are split here and not by the `csv` crate because messages name rows: its positions do not
//! count the blank lines and comments that it skips before a record.

use std::io::{BufRead, Read};

use crate::error::{Error, Result};
use crate::exact::double_literal;

/// The most rows with points in one file.
pub(super) const MAX_ROWS: usize = 10_000_000;
/// The longest row, in bytes.
const MAX_ROW_BYTES: u64 = 1 << 16;

/// The points and, for each, its row in the file (counted from 1, every line counts).
pub(super) fn read_rows(
    reader: &mut impl BufRead,
    place: &str,
) -> Result<(Vec<[f64; 2]>, Vec<usize>)> {
    let mut points = Vec::new();
    let mut rows = Vec::new();
    let mut may_be_header = true;
    let mut line = Vec::new();
    for row in 1.. {
        line.clear();
        let at_row = || format!("{place}, row {row}");
        let length = reader
            .take(MAX_ROW_BYTES)
            .read_until(b'\n', &mut line)
            .map_err(|source| Error::Io {
                path: place.into(),
                source,
            })?;
        if length == 0 {
            break;
        }
        let text = std::str::from_utf8(&line)
            .map_err(|_| Error::data(at_row(), "not text; each row must be x,y"))?;
        if !text.ends_with('\n') && line.len() >= 1 << 16 {
            return Err(Error::data(
                at_row(),
                format!("longer than {MAX_ROW_BYTES} bytes; each row must be x,y"),
            ));
        }
        let text = text.trim_start_matches('\u{feff}').trim();
        if text.is_empty() || text.starts_with('#') {
            continue;
        }
        let fields: Vec<&str> = text.split(',').map(unquoted).collect();
        let header = may_be_header && fields.iter().all(|field| is_word(field));
        may_be_header = false;
        if header {
            continue;
        }
        let [x, y] = fields.as_slice() else {
            let columns = match fields.len() {
                1 => "1 column".into(),
                n => format!("{n} columns"),
            };
            return Err(Error::data(
                at_row(),
                format!("found {columns}; each row must be x,y"),
            ));
        };
        let value = |field: &str| number(field).map_err(|message| Error::data(at_row(), message));
        points.push([value(x)?, value(y)?]);
        rows.push(row);
        if points.len() > MAX_ROWS {
            return Err(Error::limit(format!(
                "{place} has more than {MAX_ROWS} rows"
            )));
        }
    }
    Ok((points, rows))
}

/// The field without white space and one pair of double quotes around it.
fn unquoted(field: &str) -> &str {
    let field = field.trim();
    field
        .strip_prefix('"')
        .and_then(|rest| rest.strip_suffix('"'))
        .map_or(field, str::trim)
}

/// Whether a field of the first row belongs to a header. Infinity, NaN and numbers too large are
/// mistakes, not words.
fn is_word(field: &str) -> bool {
    number(field).is_err() && field.parse::<f64>().is_err()
}

/// The double nearest to the number written, or what is wrong with it.
fn number(field: &str) -> std::result::Result<f64, String> {
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
        None => Err(format!(
            "{:?} is not a number; each row must be x,y",
            shortened(field)
        )),
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

    fn read(text: &str) -> Result<(Vec<[f64; 2]>, Vec<usize>)> {
        read_rows(&mut text.as_bytes(), "outline.csv")
    }

    fn message(text: &str) -> String {
        read(text).unwrap_err().to_string()
    }

    #[test]
    fn rows_are_counted_as_an_editor_counts_them() {
        let text = "\u{feff}# outline\n\nx,y\n0,1\r\n\r\n  # more\n \"2.5\" , -0x1.8p1\n1e3,−4";
        let (points, rows) = read(text).unwrap();
        assert_eq!(points, [[0.0, 1.0], [2.5, -3.0], [1000.0, -4.0]]);
        assert_eq!(rows, [4, 7, 8]);
    }

    #[test]
    fn a_header_is_optional() {
        assert_eq!(read("0,1\n2,3").unwrap().0.len(), 2);
        assert_eq!(read("easting,northing\n2,3").unwrap().0.len(), 1);
        assert_eq!(read("").unwrap().0.len(), 0);
        // Only the first row can be one, and only if none of its fields is a number.
        assert!(message("x,y\nx,y\n").contains("row 2: \"x\" is not a number"));
        assert!(message("1,y\n").contains("row 1: \"y\" is not a number"));
    }

    #[test]
    fn errors_name_the_row() {
        let mut text: String = (1..17).map(|k| format!("{k},{}\n", k * k)).collect();
        text.push_str("17,abc\n");
        assert_eq!(
            message(&text),
            "outline.csv, row 17: \"abc\" is not a number; each row must be x,y"
        );
        assert!(message("1,2\n3\n").contains("row 2: found 1 column; each row must be x,y"));
        assert!(message("1,2\n3,4,5\n").contains("row 2: found 3 columns"));
        assert!(message("1,2\n3,\n").contains("\"\" is not a number"));
        assert!(message("1,2\n3,inf\n").contains("\"inf\" is not a number"));
        assert!(message("1,2\n3,NaN\n").contains("\"NaN\" is not a number"));
        assert!(message("1,2\n3,1e999\n").contains("too large for a double"));
        assert!(message("inf,nan\n").contains("row 1: \"inf\" is not a number"));
        assert!(message("1,2\n3,0x1p99999\n").contains("not a number"));
    }

    #[test]
    fn what_is_not_text_is_refused() {
        let bytes = [b'1', b',', 0xff, b'\n'];
        let error = read_rows(&mut bytes.as_slice(), "a.csv").unwrap_err();
        assert!(error.to_string().contains("row 1: not text"), "{error}");
        let long = "1".repeat(1 << 17);
        assert!(message(&long).contains("longer than 65536 bytes"));
    }
}
