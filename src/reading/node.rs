//! Values of a JSON document with their places, so that every error names a place.

use std::fmt;

use serde_json::{Map, Value};

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::language::{Numbers, WrittenCenter, number_at};

/// The path from the root of a document to a value. It is only written out for a message.
#[derive(Clone, Copy)]
pub(super) enum NodePath<'a> {
    Root(&'a str),
    Field(&'a NodePath<'a>, &'a str),
    Item(&'a NodePath<'a>, usize),
}

impl fmt::Display for NodePath<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NodePath::Root(name) => f.write_str(name),
            NodePath::Field(parent @ NodePath::Root(_), name) => write!(f, "{parent}: {name}"),
            NodePath::Field(parent, name) => write!(f, "{parent}.{name}"),
            NodePath::Item(parent, n) => write!(f, "{parent}[{n}]"),
        }
    }
}

/// A value of a document with its place.
pub(super) struct Node<'a> {
    pub(super) value: &'a Value,
    pub(super) place: NodePath<'a>,
    pub(super) numbers: Numbers,
}

impl Node<'_> {
    /// The place of the value, as text.
    pub(super) fn place(&self) -> String {
        self.place.to_string()
    }

    pub(super) fn wrong(&self, message: impl Into<String>) -> Error {
        Error::data(self.place.to_string(), message)
    }

    pub(super) fn object(&self) -> Result<&Map<String, Value>> {
        let object = self.value.as_object();
        object.ok_or_else(|| self.wrong("expected an object { … }"))
    }

    pub(super) fn array(&self) -> Result<&Vec<Value>> {
        let array = self.value.as_array();
        array.ok_or_else(|| self.wrong("expected a list [ … ]"))
    }

    pub(super) fn string(&self) -> Result<&str> {
        let string = self.value.as_str();
        string.ok_or_else(|| self.wrong("expected a string"))
    }

    pub(super) fn field<'b>(
        &'b self,
        object: &'b Map<String, Value>,
        name: &'b str,
    ) -> Result<Node<'b>> {
        match object.get(name) {
            Some(value) => Ok(Node {
                value,
                place: NodePath::Field(&self.place, name),
                numbers: self.numbers,
            }),
            None => Err(self.wrong(format!("the field \"{name}\" is missing"))),
        }
    }

    pub(super) fn item<'b>(&'b self, array: &'b [Value], n: usize) -> Result<Node<'b>> {
        match array.get(n) {
            Some(value) => Ok(Node {
                value,
                place: NodePath::Item(&self.place, n),
                numbers: self.numbers,
            }),
            None => Err(self.wrong(format!("entry {n} is missing"))),
        }
    }

    /// The number that is written as a JSON number or as a string.
    pub(super) fn number(&self) -> Result<Rational> {
        let owned;
        let text = match self.value {
            Value::String(text) => text.as_str(),
            Value::Number(number) => {
                owned = number.to_string();
                &owned
            }
            _ => return Err(self.wrong("expected a number or a string such as \"1/3\"")),
        };
        match number_at("", text, self.numbers) {
            Err(Error::Data { message, .. }) => Err(self.wrong(message)),
            result => result,
        }
    }

    pub(super) fn natural(&self) -> Result<u32> {
        let value = match self.value {
            Value::Number(number) => number.as_u64(),
            _ => None,
        };
        match value {
            Some(value) => Ok(u32::try_from(value).unwrap_or(u32::MAX)),
            None => Err(self.wrong("expected a non-negative integer")),
        }
    }

    /// The field `center` with its node, if the object has one.
    pub(super) fn center<'b>(
        &'b self,
        object: &'b Map<String, Value>,
    ) -> Result<Option<(Node<'b>, WrittenCenter)>> {
        if object.get("center").is_none_or(Value::is_null) {
            return Ok(None);
        }
        let node = self.field(object, "center")?;
        let list = node.array()?;
        let at = |n: usize| node.item(list, n)?.number();
        let center = match list.len() {
            2 => WrittenCenter::Plane([at(0)?, at(1)?]),
            3 => WrittenCenter::Space([at(0)?, at(1)?, at(2)?]),
            _ => return Err(node.wrong("expected two numbers [x, y], or three [x, y, z] in space")),
        };
        Ok(Some((node, center)))
    }

    /// The center of a surface, if there is one.
    pub(super) fn space_center(
        &self,
        object: &Map<String, Value>,
    ) -> Result<Option<[Rational; 3]>> {
        let center = self.center(object)?;
        let center = center.map(|(node, center)| center.in_space().map_err(|m| node.wrong(m)));
        center.transpose()
    }

    /// The center of a form in the plane, if there is one.
    pub(super) fn plane_center(
        &self,
        object: &Map<String, Value>,
    ) -> Result<Option<[Rational; 2]>> {
        let center = self.center(object)?;
        let center = center.map(|(node, center)| center.in_plane().map_err(|m| node.wrong(m)));
        center.transpose()
    }
}
