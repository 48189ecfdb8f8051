//! Stanford PLY: vertices and faces, as text or binary; all other elements and properties are left out.

use super::Faces;
use crate::error::{Error, Result};

/// A type of a number.
#[derive(Clone, Copy, Debug)]
enum Number {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Encoding {
    Text,
    Little,
    Big,
}

/// A property of an element, with the type of its length if it is a list.
#[derive(Debug)]
struct Property {
    name: String,
    length: Option<Number>,
    number: Number,
}

#[derive(Debug)]
struct Element {
    name: String,
    count: usize,
    properties: Vec<Property>,
}

impl Number {
    fn of(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }
}

/// The numbers of the body, one after the other.
struct Body<'a> {
    rest: &'a [u8],
    encoding: Encoding,
    place: &'a str,
}

impl<'a> Body<'a> {
    fn cut(&self) -> Error {
        Error::data(
            self.place,
            "the file is cut: there are fewer numbers than its header says",
        )
    }

    fn bytes<const N: usize>(&mut self) -> Result<[u8; N]> {
        let (mut bytes, rest) = match self.rest.split_first_chunk::<N>() {
            Some((bytes, rest)) => (*bytes, rest),
            None => return Err(self.cut()),
        };
        self.rest = rest;
        if self.encoding == Encoding::Big {
            bytes.reverse();
        }
        Ok(bytes)
    }

    fn word(&mut self) -> Result<&'a str> {
        let rest = self.rest.trim_ascii_start();
        let end = rest
            .iter()
            .position(u8::is_ascii_whitespace)
            .unwrap_or(rest.len());
        let (word, rest) = rest.split_at(end);
        if word.is_empty() {
            return Err(self.cut());
        }
        self.rest = rest;
        std::str::from_utf8(word).map_err(|_| Error::data(self.place, "this is no text in UTF-8"))
    }

    fn number(&mut self, number: Number) -> Result<f64> {
        if self.encoding == Encoding::Text {
            let word = self.word()?;
            let message = || Error::data(self.place, format!("`{word}` is no number"));
            return word.parse().map_err(|_| message());
        }
        Ok(match number {
            Number::I8 => f64::from(i8::from_le_bytes(self.bytes()?)),
            Number::U8 => f64::from(u8::from_le_bytes(self.bytes()?)),
            Number::I16 => f64::from(i16::from_le_bytes(self.bytes()?)),
            Number::U16 => f64::from(u16::from_le_bytes(self.bytes()?)),
            Number::I32 => f64::from(i32::from_le_bytes(self.bytes()?)),
            Number::U32 => f64::from(u32::from_le_bytes(self.bytes()?)),
            Number::F32 => f64::from(f32::from_le_bytes(self.bytes()?)),
            Number::F64 => f64::from_le_bytes(self.bytes()?),
        })
    }

    /// The number of a property; `None` for a list, which is passed over.
    fn single(&mut self, property: &Property) -> Result<Option<f64>> {
        let Some(length) = property.length else {
            return self.number(property.number).map(Some);
        };
        for _ in 0..self.whole(length)? {
            self.number(property.number)?;
        }
        Ok(None)
    }

    /// A count or an index.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::float_cmp,
        reason = "the number was seen to be a whole one in the range"
    )]
    fn whole(&mut self, number: Number) -> Result<u32> {
        let value = self.number(number)?;
        let is_whole = value >= 0.0 && value < f64::from(u32::MAX) && value.trunc() == value;
        if !is_whole {
            return Err(Error::data(
                self.place,
                format!("{value} is no index of a vertex"),
            ));
        }
        Ok(value as u32)
    }
}

pub(super) fn read(bytes: &[u8], place: &str) -> Result<Faces> {
    let (encoding, elements, rest) = header(bytes, place)?;
    let mut body = Body {
        rest,
        encoding,
        place,
    };
    let mut found = Faces::default();
    let mut corners = Vec::new();
    for element in &elements {
        for _ in 0..element.count {
            let mut vertex = [f64::NAN; 3];
            corners.clear();
            for property in &element.properties {
                let Some(length) = property.length else {
                    let value = body.number(property.number)?;
                    if let Some(axis) = ["x", "y", "z"].iter().position(|n| *n == property.name) {
                        vertex[axis] = value;
                    }
                    continue;
                };
                let is_corners = property.name.starts_with("vertex_ind");
                for _ in 0..body.whole(length)? {
                    if is_corners {
                        corners.push(body.whole(property.number)?);
                    } else {
                        body.number(property.number)?;
                    }
                }
            }
            match element.name.as_str() {
                "vertex" => found.vertices.push(vertex),
                "face" if corners.len() < 3 => {
                    let message = format!(
                        "face {}: fewer than three corners",
                        found.triangles.len() + 1
                    );
                    return Err(Error::data(place, message));
                }
                "face" => found.add(&corners),
                _ => {}
            }
        }
    }
    Ok(found)
}

/// The vertices as rows of text: the names of their properties, and then a row for each vertex. Each number is the exact value of the
/// stored one, written as the shortest decimal that is its double. Lists have no column.
pub(super) fn points(bytes: &[u8], place: &str) -> Result<String> {
    let (encoding, elements, rest) = header(bytes, place)?;
    let mut body = Body {
        rest,
        encoding,
        place,
    };
    let position = elements.iter().position(|e| e.name == "vertex");
    let Some(position) = position else {
        return Err(Error::data(
            place,
            "the file has no element `vertex`, whose properties x, y and z are points",
        ));
    };
    for element in &elements[..position] {
        for _ in 0..element.count {
            for property in &element.properties {
                body.single(property)?;
            }
        }
    }
    let vertex = &elements[position];
    let columns = vertex.properties.iter().filter(|p| p.length.is_none());
    let names: Vec<&str> = columns.map(|p| p.name.as_str()).collect();
    let mut text = names.join(",");
    text.push('\n');
    for _ in 0..vertex.count {
        let mut is_first = true;
        for property in &vertex.properties {
            if let Some(value) = body.single(property)? {
                if !std::mem::take(&mut is_first) {
                    text.push(',');
                }
                text.push_str(&format!("{value:?}"));
            }
        }
        text.push('\n');
    }
    Ok(text)
}

/// The encoding, the elements, and what comes after the header.
fn header<'a>(bytes: &'a [u8], place: &str) -> Result<(Encoding, Vec<Element>, &'a [u8])> {
    let mut rest = bytes;
    let mut encoding = None;
    let mut elements: Vec<Element> = Vec::new();
    let bad = |line: usize, what: &str| Error::data(place, format!("line {line}: {what}"));
    for number in 1.. {
        let Some(end) = rest.iter().position(|b| *b == b'\n') else {
            return Err(bad(number, "the header of PLY has no line `end_header`"));
        };
        let line = String::from_utf8_lossy(&rest[..end]).into_owned();
        rest = &rest[end + 1..];
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.as_slice() {
            ["ply"] if number == 1 => {}
            _ if number == 1 => return Err(bad(1, "a PLY file begins with `ply`")),
            ["format", name, _] => {
                encoding = match *name {
                    "ascii" => Some(Encoding::Text),
                    "binary_little_endian" => Some(Encoding::Little),
                    "binary_big_endian" => Some(Encoding::Big),
                    _ => {
                        return Err(bad(
                            number,
                            "the format is ascii or binary_little_endian or binary_big_endian",
                        ));
                    }
                };
            }
            ["element", name, count] => {
                let count = count
                    .parse()
                    .map_err(|_| bad(number, "the count is no number"))?;
                elements.push(Element {
                    name: (*name).to_owned(),
                    count,
                    properties: Vec::new(),
                });
            }
            ["property", rest @ ..] => {
                let property = property(rest)
                    .ok_or_else(|| bad(number, "a property has a type and a name"))?;
                let last = elements.last_mut();
                let last = last.ok_or_else(|| bad(number, "a property belongs to an element"))?;
                last.properties.push(property);
            }
            ["end_header"] => break,
            _ => {}
        }
    }
    let encoding = encoding.ok_or_else(|| bad(1, "the header of PLY has no line `format`"))?;
    Ok((encoding, elements, rest))
}

fn property(words: &[&str]) -> Option<Property> {
    match words {
        ["list", length, number, name] => Some(Property {
            name: (*name).to_owned(),
            length: Some(Number::of(length)?),
            number: Number::of(number)?,
        }),
        [number, name] => Some(Property {
            name: (*name).to_owned(),
            length: None,
            number: Number::of(number)?,
        }),
        _ => None,
    }
}
