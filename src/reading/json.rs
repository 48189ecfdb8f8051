//! The text of a JSON document is read into a value, with errors that point into the text.

use std::collections::HashSet;

use serde_json::Value;

use crate::error::{Error, Invariant, Result};

/// The value of a JSON text.
///
/// # Errors
/// [`Error::Syntax`] if the text is not JSON, or if an object has two fields of the same name: JSON leaves open which of them counts.
pub(super) fn read_json(text: &str, source_name: &str) -> Result<Value> {
    let body = text.trim_start_matches('\u{feff}');
    let skipped = text.len() - body.len();
    let value =
        serde_json::from_str(body).map_err(|error| not_json(&error, text, source_name, skipped))?;
    match repeated_name(body) {
        None => Ok(value),
        Some((name, at)) => Err(Error::Syntax {
            message: format!("the field \"{name}\" is given twice"),
            source_name: source_name.into(),
            text: text.into(),
            at: skipped + at,
        }),
    }
}

fn not_json(error: &serde_json::Error, text: &str, source_name: &str, skipped: usize) -> Error {
    let before: usize = text[skipped..]
        .split_inclusive('\n')
        .take(error.line().saturating_sub(1))
        .map(str::len)
        .sum();
    let message = error.to_string();
    let reason = message.split(" at line ").next().unwrap_or(&message);
    Error::Syntax {
        message: match error.is_eof() {
            true => "not a JSON document: it ends here, in the middle, so it was cut off".into(),
            false => format!("not a JSON document: {reason}"),
        },
        source_name: source_name.into(),
        text: text.into(),
        at: skipped + before + error.column().saturating_sub(1),
    }
}

/// The first name that an object has a second time, and the place of the second one, in a text that is JSON.
fn repeated_name(json: &str) -> Option<(String, usize)> {
    // The names in each object that is open here; a list has none.
    let mut open: Vec<Option<HashSet<String>>> = Vec::new();
    let mut is_name_next = false;
    let mut at = 0;
    while let Some(byte) = json.as_bytes().get(at) {
        let start = at;
        at += 1;
        match byte {
            b'{' | b'[' => {
                is_name_next = *byte == b'{';
                open.push(is_name_next.then(HashSet::new));
            }
            b'}' | b']' => {
                open.pop();
            }
            b',' => is_name_next = matches!(open.last(), Some(Some(_))),
            b'"' => {
                at = end_of_string(json, at);
                let names = open.last_mut().and_then(Option::as_mut);
                if let Some(names) = names.filter(|_| is_name_next) {
                    let name: String = serde_json::from_str(&json[start..at])
                        .invariant("the text was read as JSON before");
                    if !names.insert(name.clone()) {
                        return Some((name, start));
                    }
                    is_name_next = false;
                }
            }
            _ => {}
        }
    }
    None
}

/// The place after the quote that ends the string with its first character at `at`.
fn end_of_string(json: &str, mut at: usize) -> usize {
    loop {
        let byte = json.as_bytes().get(at);
        match byte.invariant("a string in JSON has an end") {
            b'"' => return at + 1,
            b'\\' => at += 2,
            _ => at += 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::repeated_name;

    #[test]
    fn only_names_of_one_object_are_compared() {
        for (json, found) in [
            (
                r#"{"a": "a", "b": ["a", "a", {"a": 1}], "c": {"a": {"b": 2}}}"#,
                None,
            ),
            (r#"{"a": 1, "b": {}, "a": 2}"#, Some(("a", 18))),
            (r#"{"a": 1, "\u0061": 2}"#, Some(("a", 9))),
            (r#"{"x": "\"", "y": "\\", "y": 0}"#, Some(("y", 23))),
            (r#"[{"a": [0, {"b": 1, "b": 1}]}]"#, Some(("b", 20))),
            ("[1, 1]", None),
        ] {
            let found = found.map(|(name, at)| (String::from(name), at));
            assert_eq!(repeated_name(json), found, "{json}");
        }
    }
}
