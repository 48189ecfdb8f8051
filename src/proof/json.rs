//! Strict reading of JSON: no field twice, no field that is not expected, no number but small integers.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::RangeInclusive;

use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};

use super::refusal::{Checked, Refusal, need};

/// The largest absolute value of an integer in a document.
pub(super) const LARGEST_INTEGER: i64 = 1 << 31;
/// The largest length of a list.
pub(super) const LONGEST_LIST: usize = 100_000;

/// With its feature `arbitrary_precision`, serde_json presents a number that is no integer of 64 bits as an object with this key.
const NUMBER_KEY: &str = "$serde_json::private::Number";
const NOT_SMALL: &str = "a number is no integer up to 2^31";
/// How much of a name is repeated in a message.
const QUOTED_CHARACTERS: usize = 40;

/// A JSON value. Two values are equal if they are equal as JSON values: the order of the fields does not matter.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) enum Value {
    Null,
    Truth(bool),
    Integer(i64),
    Text(String),
    List(Vec<Value>),
    Object(BTreeMap<String, Value>),
}

/// The fields of an object whose names have been checked.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fields<'a> {
    map: &'a BTreeMap<String, Value>,
    /// The part of the claim that the object is, for messages.
    part: Option<&'static str>,
}

/// The statement and the witness of a claim.
#[derive(Debug, Clone, Copy)]
pub(super) struct Claim<'a> {
    pub(super) statement: &'a Value,
    pub(super) witness: &'a Value,
}

/// Reads one JSON value and nothing after it. serde_json refuses more than 127 brackets inside one another.
pub(super) fn parse(text: &str) -> Checked<Value> {
    serde_json::from_str(text).map_err(|error| Refusal::new(error.to_string()))
}

/// The beginning of a text, for messages.
pub(super) fn beginning(text: &str) -> String {
    text.chars()
        .take(QUOTED_CHARACTERS)
        .collect::<String>()
        .escape_default()
        .to_string()
}

impl Value {
    /// The object with exactly the required fields and any of the optional ones, which are not null.
    pub(super) fn fields(&self, required: &[&str], optional: &[&str]) -> Checked<Fields<'_>> {
        let Self::Object(map) = self else {
            return Err(Refusal::new(format!(
                "an object is expected, with {}",
                required.join(", ")
            )));
        };
        if let Some(name) = required.iter().find(|name| !map.contains_key(**name)) {
            return Err(Refusal::new(format!("the field {name} is missing")));
        }
        for (name, value) in map {
            let known = required.contains(&name.as_str())
                || optional.contains(&name.as_str()) && *value != Self::Null;
            if !known {
                return Err(Refusal::new(format!(
                    "the field {} is unknown, or null",
                    beginning(name)
                )));
            }
        }
        Ok(Fields { map, part: None })
    }

    /// A list, with as many elements as the range permits; each one is read by the function.
    pub(super) fn list<'a, T>(
        &'a self,
        lengths: RangeInclusive<usize>,
        mut read: impl FnMut(&'a Self) -> Checked<T>,
    ) -> Checked<Vec<T>> {
        match self {
            Self::List(elements) if lengths.contains(&elements.len()) => elements
                .iter()
                .enumerate()
                .map(|(index, element)| read(element).map_err(|refusal| refusal.at(index)))
                .collect(),
            _ => Err(Refusal::new(format!(
                "a list of {} to {} elements is expected",
                lengths.start(),
                lengths.end()
            ))),
        }
    }

    /// An integer of the range.
    pub(super) fn integer(&self, range: RangeInclusive<i64>) -> Checked<i64> {
        match self {
            Self::Integer(value) if range.contains(value) => Ok(*value),
            _ => Err(Refusal::new(format!(
                "an integer from {} to {} is expected",
                range.start(),
                range.end()
            ))),
        }
    }

    /// An integer from 0 to the limit.
    pub(super) fn count(&self, limit: u32) -> Checked<u32> {
        let value = self.integer(0..=i64::from(limit))?;
        u32::try_from(value).map_err(|_| Refusal::new("an integer is out of range"))
    }

    pub(super) fn text(&self) -> Checked<&str> {
        match self {
            Self::Text(text) => Ok(text),
            _ => Err(Refusal::new("a string is expected")),
        }
    }
}

impl<'a> Fields<'a> {
    /// Reads a required field.
    pub(super) fn get<T>(
        &self,
        name: &str,
        read: impl FnOnce(&'a Value) -> Checked<T>,
    ) -> Checked<T> {
        self.optional(name, read)?
            .ok_or_else(|| Refusal::new(format!("the field {name} is missing")))
    }

    /// Reads an optional field, if it is there.
    pub(super) fn optional<T>(
        &self,
        name: &str,
        read: impl FnOnce(&'a Value) -> Checked<T>,
    ) -> Checked<Option<T>> {
        let read = |value| read(value).map_err(|refusal| self.refused(name, refusal));
        self.value(name).map(read).transpose()
    }

    fn value(&self, name: &str) -> Option<&'a Value> {
        self.map.get(name)
    }

    /// The refusal of a field, with its place.
    fn refused(&self, name: &str, refusal: Refusal) -> Refusal {
        self.part
            .into_iter()
            .fold(refusal.within(name), Refusal::within)
    }
}

impl<'a> Claim<'a> {
    /// The fields of the statement.
    pub(super) fn statement(&self, required: &[&str], optional: &[&str]) -> Checked<Fields<'a>> {
        part_fields("statement", self.statement, required, optional)
    }

    /// The fields of the witness.
    pub(super) fn witness(&self, required: &[&str], optional: &[&str]) -> Checked<Fields<'a>> {
        part_fields("witness", self.witness, required, optional)
    }

    /// Refuses unless the witness is `{"method": "expansion"}`, that of a claim that is checked by expanding it.
    pub(super) fn expansion(&self) -> Checked<()> {
        self.witness(&["method"], &[])?.get("method", |method| {
            need(
                method.text()? == "expansion",
                "the only method is expansion",
            )
        })
    }
}

fn part_fields<'a>(
    part: &'static str,
    value: &'a Value,
    required: &[&str],
    optional: &[&str],
) -> Checked<Fields<'a>> {
    let fields = value
        .fields(required, optional)
        .map_err(|refusal| refusal.within(part))?;
    Ok(Fields {
        part: Some(part),
        ..fields
    })
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ValueVisitor)
    }
}

struct ValueVisitor;

impl<'de> Visitor<'de> for ValueVisitor {
    type Value = Value;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("a JSON value")
    }

    fn visit_unit<E: Error>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<Value, E> {
        Ok(Value::Truth(value))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Value, E> {
        if value.unsigned_abs() <= LARGEST_INTEGER.unsigned_abs() {
            Ok(Value::Integer(value))
        } else {
            Err(E::custom(NOT_SMALL))
        }
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Value, E> {
        self.visit_i64(i64::try_from(value).map_err(|_| E::custom(NOT_SMALL))?)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Value, E> {
        Ok(Value::Text(text.to_owned()))
    }

    fn visit_string<E: Error>(self, text: String) -> Result<Value, E> {
        Ok(Value::Text(text))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Value, A::Error> {
        let mut elements = Vec::new();
        while let Some(element) = list.next_element()? {
            if elements.len() == LONGEST_LIST {
                return Err(A::Error::custom("a list has more than 100 000 elements"));
            }
            elements.push(element);
        }
        Ok(Value::List(elements))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Value, A::Error> {
        let mut map = BTreeMap::new();
        while let Some(name) = object.next_key::<String>()? {
            if name == NUMBER_KEY {
                return Err(A::Error::custom(NOT_SMALL));
            }
            if map.contains_key(&name) {
                return Err(A::Error::custom(format!(
                    "the field {} is given twice",
                    beginning(&name)
                )));
            }
            map.insert(name, object.next_value()?);
        }
        Ok(Value::Object(map))
    }
}
