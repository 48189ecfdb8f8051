//! Outlines in NumPy arrays (`.npy`, format versions 1 to 3). The header, a literal of Python, is read strictly, and the length of
//! the file must be what it says.
//!
//! The crates that read such files bring a parser generator for all literals of Python; a header has only a few.

use winnow::ascii::digit1;
use winnow::combinator::{alt, delimited, opt, preceded, separated, separated_pair, terminated};
use winnow::prelude::*;
use winnow::token::{take_till, take_while};

use super::columns::places_beside;
use super::rows::MAX_ROWS;
use super::{Columns, OutlineOptions};
use crate::error::{Error, Result};
use crate::shape::GivenPoints;

/// The first bytes of every such file.
pub(super) const MAGIC: &[u8] = b"\x93NUMPY";
/// The longest header that is read, in bytes.
const MAX_HEADER: usize = 1 << 16;
/// What an outline looks like as an array.
const RIGHT: &str = "an outline is an array of numbers of shape (n, 2), (n, 1, 2) as from OpenCV, or complex of shape (n,)";

/// The header of an array.
#[derive(Debug)]
struct Header {
    kind: Kind,
    is_fortran: bool,
    shape: Vec<usize>,
}

/// A value in a header.
#[derive(Clone, Debug)]
enum Literal {
    Text(String),
    Truth(bool),
    Shape(Vec<usize>),
    /// A list of fields, and anything else.
    Other,
}

/// How an element is stored.
#[derive(Clone, Copy, Debug)]
struct Kind {
    number: Number,
    is_big_endian: bool,
}

#[derive(Clone, Copy, Debug)]
enum Number {
    Float32,
    Float64,
    Signed(usize),
    Unsigned(usize),
    Complex32,
    Complex64,
}

impl Number {
    /// The number of bytes of an element.
    fn size(self) -> usize {
        match self {
            Self::Float32 => 4,
            Self::Float64 | Self::Complex32 => 8,
            Self::Complex64 => 16,
            Self::Signed(size) | Self::Unsigned(size) => size,
        }
    }
}

impl Kind {
    /// The kind that a description such as `<f8` means.
    fn of(description: &str) -> std::result::Result<Self, String> {
        let order = description.chars().next();
        let code = description.get(1..).unwrap_or_default();
        let number = match code {
            "f4" => Number::Float32,
            "f8" => Number::Float64,
            "i1" => Number::Signed(1),
            "i2" => Number::Signed(2),
            "i4" => Number::Signed(4),
            "i8" => Number::Signed(8),
            "u1" => Number::Unsigned(1),
            "u2" => Number::Unsigned(2),
            "u4" => Number::Unsigned(4),
            "u8" => Number::Unsigned(8),
            "c8" => Number::Complex32,
            "c16" => Number::Complex64,
            _ => return Err(named(description, code)),
        };
        let is_big_endian = match order {
            Some('<' | '|') => false,
            Some('>') => true,
            _ => return Err(named(description, code)),
        };
        Ok(Self {
            number,
            is_big_endian,
        })
    }

    /// The number in these bytes, as the nearest double, or a part of it.
    fn value(self, bytes: &[u8]) -> f64 {
        let mut wide = [0_u8; 8];
        let little = |wide: &mut [u8; 8]| {
            for (slot, byte) in wide.iter_mut().zip(bytes) {
                *slot = *byte;
            }
            if self.is_big_endian {
                wide[..bytes.len()].reverse();
            }
        };
        little(&mut wide);
        match self.number {
            Number::Float32 | Number::Complex32 => {
                let [a, b, c, d, ..] = wide;
                f64::from(f32::from_le_bytes([a, b, c, d]))
            }
            Number::Float64 | Number::Complex64 => f64::from_le_bytes(wide),
            Number::Unsigned(_) => nearest(i128::from(u64::from_le_bytes(wide))),
            Number::Signed(size) => {
                // The sign of the last byte goes on to the left.
                let unused = 64 - 8 * size;
                nearest(i128::from((i64::from_le_bytes(wide) << unused) >> unused))
            }
        }
    }
}

/// The double that is nearest to an integer of at most 64 bits.
#[expect(
    clippy::cast_precision_loss,
    reason = "the conversion rounds to the nearest double"
)]
fn nearest(integer: i128) -> f64 {
    integer as f64
}

/// The message for elements that are no numbers, or numbers that are not read.
fn named(description: &str, code: &str) -> String {
    let what = match code.chars().next() {
        Some('O') => "objects of Python",
        Some('b') => "truth values; the outline of a mask is read from a picture of it",
        Some('U' | 'S' | 'a') => "texts",
        Some('M' | 'm') => "times",
        Some('f' | 'c') => "floating-point numbers of another size; astype(\"f8\") makes doubles",
        _ => "of a kind that is not read",
    };
    format!("the elements ({description}) are {what}; {RIGHT}")
}

/// The points of an outline in an array, with weights if the options give their column.
///
/// # Errors
/// [`Error::Data`] for another header, another shape, or another length than the shape says; [`Error::Limit`] beyond
/// [`MAX_ROWS`] points.
pub(super) fn read_array(
    bytes: &[u8],
    options: &OutlineOptions,
    place: &str,
) -> Result<GivenPoints> {
    let wrong = |message: String| Error::data(place, message);
    let (header, data) = checked(bytes, place)?;
    let (rows, places, weights) = header.layout(options).map_err(wrong)?;
    if rows > MAX_ROWS {
        let limit = format!("{place} has more than {MAX_ROWS} rows");
        return Err(Error::limit(limit));
    }
    let element = |row: usize, column: usize| header.element(data, rows, row, column);
    let column = |column: usize| (0..rows).map(move |row| element(row, column));
    Ok(GivenPoints {
        points: (0..rows)
            .map(|row| places.map(|c| element(row, c)))
            .collect(),
        weights: weights.into_iter().flat_map(column).collect(),
        rows: Vec::new(),
    })
}

/// The points of an array of the shape (n, 2) or (n, 3) as rows of text. Each number is written as the shortest decimal that is its double.
///
/// # Errors
/// [`Error::Data`] for another header, another shape, or another length than the shape says.
pub(crate) fn rows_of_array(bytes: &[u8], place: &str) -> Result<String> {
    let (header, data) = checked(bytes, place)?;
    let ([rows, width @ (2 | 3)], false) = (&header.shape[..], header.is_complex()) else {
        let shape = shape_text(&header.shape);
        return Err(Error::data(
            place,
            format!(
                "the array has the shape {shape}; points are an array of numbers of shape (n, 2) in the plane or (n, 3)"
            ),
        ));
    };
    let mut text = String::new();
    for row in 0..*rows {
        for column in 0..*width {
            let end = if column + 1 == *width { '\n' } else { ',' };
            let value = header.element(data, *rows, row, column);
            text.push_str(&format!("{value:?}{end}"));
        }
    }
    Ok(text)
}

/// The header, and as many elements as its shape says.
fn checked<'a>(bytes: &'a [u8], place: &str) -> Result<(Header, &'a [u8])> {
    let wrong = |message: String| Error::data(place, message);
    let (header, data) = split(bytes).map_err(wrong)?;
    let header = Header::read(header).map_err(wrong)?;
    let Header { kind, shape, .. } = &header;
    let size = kind.number.size();
    let count = shape.iter().try_fold(size, |all, &n| all.checked_mul(n));
    if count != Some(data.len()) {
        let needed = count.map_or("too many".into(), |count| count.to_string());
        let (shape, found) = (shape_text(shape), data.len());
        return Err(wrong(format!(
            "an array of shape {shape} has {needed} bytes of elements; the file has {found}"
        )));
    }
    Ok((header, data))
}

impl Header {
    /// The number in a row and a column; a complex number is a row of two.
    fn element(&self, data: &[u8], rows: usize, row: usize, column: usize) -> f64 {
        let part = self.kind.number.size() / if self.is_complex() { 2 } else { 1 };
        let width = data.len() / part / rows.max(1);
        let index = match self.is_fortran && !self.is_complex() {
            true => column * rows + row,
            false => row * width + column,
        };
        self.kind.value(&data[index * part..(index + 1) * part])
    }

    fn read(text: &str) -> std::result::Result<Self, String> {
        let unreadable = || "the header of the NumPy array is damaged".to_owned();
        let entries = entries.parse(text).map_err(|_| unreadable())?;
        let find = |name: &str| {
            let mut named = entries.iter().filter(|(key, _)| key == name);
            let found = named.next().map(|(_, value)| value.clone());
            found.filter(|_| named.next().is_none())
        };
        let description = find("descr").ok_or_else(unreadable)?;
        let (Some(Literal::Truth(is_fortran)), Some(Literal::Shape(shape))) =
            (find("fortran_order"), find("shape"))
        else {
            return Err(unreadable());
        };
        let Literal::Text(description) = description else {
            return Err(format!(
                "the elements are structures with named fields; {RIGHT}: numpy.column_stack((a[\"x\"], a[\"y\"])) makes one"
            ));
        };
        Ok(Self {
            kind: Kind::of(&description)?,
            is_fortran,
            shape,
        })
    }

    fn is_complex(&self) -> bool {
        matches!(self.kind.number, Number::Complex32 | Number::Complex64)
    }

    /// The number of points, the columns of x and y, and that of the weights.
    fn layout(
        &self,
        options: &OutlineOptions,
    ) -> std::result::Result<(usize, [usize; 2], Option<usize>), String> {
        if let ([rows, width] | [rows, 1, width], Some(weights)) =
            (&self.shape[..], &options.weights)
            && !self.is_complex()
        {
            let weight = weights.place(&[], *width, "--weights")?;
            let places = match &options.columns {
                Some(columns) => columns.places(&[], *width)?,
                None => places_beside(weight)?,
            };
            return Ok((*rows, places, Some(weight)));
        }
        if options.weights.is_some() {
            return Err("--weights: this array has no columns".into());
        }
        let columns = options.columns.as_ref();
        let (rows, places) = self.points(columns)?;
        Ok((rows, places, None))
    }

    /// The number of points, and the columns of x and y.
    fn points(
        &self,
        columns: Option<&Columns>,
    ) -> std::result::Result<(usize, [usize; 2]), String> {
        let wrong = |hint: &str| {
            let shape = shape_text(&self.shape);
            Err(format!("the array has the shape {shape}; {RIGHT}{hint}"))
        };
        match (self.shape[..].as_ref(), self.is_complex(), columns) {
            ([rows], true, None) => Ok((*rows, [0, 1])),
            (_, true, Some(_)) => {
                Err("--columns: an array of complex numbers has no columns".into())
            }
            ([rows, width] | [rows, 1, width], false, Some(columns)) => {
                Ok((*rows, columns.places(&[], *width)?))
            }
            ([rows, 2] | [rows, 1, 2], false, None) => Ok((*rows, [0, 1])),
            ([2, columns], false, _) if *columns > 2 => wrong("; transposed, a.T, it is one"),
            ([_, 3..=9], false, _) => wrong("; --columns 1,2 says which columns are x and y"),
            ([_, _] | [_, _, 3 | 4], false, _) => wrong("; if it is a picture, save it as .png"),
            _ => wrong(""),
        }
    }
}

/// The header and the elements.
fn split(bytes: &[u8]) -> std::result::Result<(&str, &[u8]), String> {
    let body = bytes
        .strip_prefix(MAGIC)
        .ok_or("this is no NumPy array: numpy.save writes one")?;
    let cut = || "the file ends in the header of the NumPy array".to_owned();
    let (length, body) = match body {
        [1, _, a, b, body @ ..] => (usize::from(u16::from_le_bytes([*a, *b])), body),
        [2 | 3, _, a, b, c, d, body @ ..] => {
            let length = u32::from_le_bytes([*a, *b, *c, *d]);
            (usize::try_from(length).unwrap_or(usize::MAX), body)
        }
        [1..=3, ..] | [] => return Err(cut()),
        [version, ..] => {
            return Err(format!(
                "version {version} of NumPy's format; versions 1 to 3 are read"
            ));
        }
    };
    if length > MAX_HEADER {
        return Err(format!(
            "the header of the NumPy array is longer than {MAX_HEADER} bytes"
        ));
    }
    let (header, data) = body.split_at_checked(length).ok_or_else(cut)?;
    let header = std::str::from_utf8(header)
        .map_err(|_| "the header of the NumPy array is no text".to_owned())?;
    Ok((header, data))
}

/// A shape as Python writes it.
fn shape_text(shape: &[usize]) -> String {
    match shape {
        [one] => format!("({one},)"),
        all => {
            let all: Vec<String> = all.iter().map(ToString::to_string).collect();
            format!("({})", all.join(", "))
        }
    }
}

/// A dictionary of Python with the values that a header has.
fn entries(input: &mut &str) -> winnow::Result<Vec<(String, Literal)>> {
    let entry = separated_pair(word(text), word(':'), value);
    let list = terminated(separated(1.., entry, word(',')), opt(word(',')));
    terminated(delimited(word('{'), list, word('}')), blanks).parse_next(input)
}

fn value(input: &mut &str) -> winnow::Result<Literal> {
    let fields = (word('['), take_till(0.., ']'), ']');
    alt((
        word(text).map(Literal::Text),
        word("True").value(Literal::Truth(true)),
        word("False").value(Literal::Truth(false)),
        word(shape).map(Literal::Shape),
        fields.value(Literal::Other),
    ))
    .parse_next(input)
}

fn shape(input: &mut &str) -> winnow::Result<Vec<usize>> {
    // Python 2 wrote long integers with an L.
    let side = terminated(word(digit1.parse_to::<usize>()), opt('L'));
    let list = terminated(separated(0.., side, word(',')), opt(word(',')));
    delimited('(', list, word(')')).parse_next(input)
}

fn text(input: &mut &str) -> winnow::Result<String> {
    let single = delimited('\'', take_till(0.., ['\'', '\\']), '\'');
    let double = delimited('"', take_till(0.., ['"', '\\']), '"');
    alt((single, double)).map(str::to_owned).parse_next(input)
}

fn blanks<'a>(input: &mut &'a str) -> winnow::Result<&'a str> {
    take_while(0.., [' ', '\t', '\n']).parse_next(input)
}

/// What stands behind blanks.
fn word<'a, O>(
    parser: impl Parser<&'a str, O, winnow::error::ContextError>,
) -> impl Parser<&'a str, O, winnow::error::ContextError> {
    preceded(blanks, parser)
}

#[cfg(test)]
#[path = "numpy_laws.rs"]
mod laws;
