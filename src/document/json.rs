//! The JSON of documents: values, and doubles including the infinite ones.

use std::io::{self, Write};

use serde::{Serialize, Serializer};
use serde_json::Value;

use crate::error::{Invariant, Result};

/// A value as JSON.
pub(super) fn value_of(value: &impl Serialize) -> Value {
    serde_json::to_value(value).invariant("what a document holds has a form in JSON")
}

/// A value as JSON on one line.
pub(super) fn text_of(value: &impl Serialize) -> String {
    serde_json::to_string(value).invariant("what a document holds has a form in JSON")
}

/// The value of a JSON text that stellate has just written.
pub(super) fn parsed(text: &[u8]) -> Value {
    serde_json::from_slice(text).invariant("a document that was just written is JSON")
}

/// Writes a value as JSON.
pub(super) fn write_value(value: &(impl Serialize + ?Sized), out: &mut dyn Write) -> Result<()> {
    Ok(serde_json::to_writer(out, value).map_err(io::Error::from)?)
}

/// A double in a document. A finite double is a number; infinite doubles are the strings `"inf"` and `"-inf"`, because JSON has no
/// infinite numbers; NaN is null.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Number(pub(crate) f64);

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        match self.0 {
            f64::INFINITY => serializer.serialize_str("inf"),
            f64::NEG_INFINITY => serializer.serialize_str("-inf"),
            finite => serializer.serialize_f64(finite),
        }
    }
}
