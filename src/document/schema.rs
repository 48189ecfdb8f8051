//! The JSON Schema of every kind of document, kept beside the writers as text.

use std::collections::BTreeSet;

use serde_json::{Map, Value, json};

use super::SCHEMA;
use super::json::parsed;
use crate::error::{Error, Invariant, Result};

/// The kinds of documents, and the text with the definitions that each adds.
const KINDS: [(&str, &str); 15] = [
    ("arcs", include_str!("schema/arcs.json")),
    ("check", include_str!("schema/check.json")),
    ("description", include_str!("schema/description.json")),
    ("error", include_str!("schema/error.json")),
    ("fourier", include_str!("schema/fourier.json")),
    ("implicit", include_str!("schema/implicit.json")),
    ("inspection", include_str!("schema/inspection.json")),
    ("intersection", include_str!("schema/intersection.json")),
    ("paper", include_str!("schema/paper.json")),
    ("parametric", include_str!("schema/parametric.json")),
    ("proof", include_str!("schema/proof.json")),
    ("samples", include_str!("schema/samples.json")),
    ("spherical", include_str!("schema/spherical.json")),
    ("superquadric", include_str!("schema/superquadric.json")),
    ("vectors", include_str!("schema/vectors.json")),
];

/// The kinds of documents that have a schema.
pub fn schema_kinds() -> impl Iterator<Item = &'static str> {
    KINDS.iter().map(|(kind, _)| *kind)
}

/// The JSON Schema (draft 2020-12) of one kind of document, or of any document if no kind is named.
///
/// The schema is that of this version: it names all fields that this version writes, and allows no others.
///
/// ```
/// let schema = stellate::document::json_schema(Some("fourier"))?;
/// assert!(schema.contains("\"$ref\": \"#/$defs/fourier\""));
/// assert!(stellate::document::json_schema(Some("circle")).is_err());
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Usage`] with the kinds that there are.
pub fn json_schema(kind: Option<&str>) -> Result<String> {
    let all = definitions();
    let reference = |kind: &str| json!({ "$ref": format!("#/$defs/{kind}") });
    let root = match kind {
        None => json!({ "anyOf": schema_kinds().map(reference).collect::<Vec<_>>() }),
        Some(kind) if schema_kinds().any(|known| known == kind) => reference(kind),
        Some(other) => {
            let known: Vec<&str> = schema_kinds().collect();
            let message = format!(
                "schema {other}: the kinds of documents are {}",
                known.join(", ")
            );
            return Err(Error::Usage(message));
        }
    };
    let mut needed = BTreeSet::new();
    collect(&root, &all, &mut needed);
    let used: Map<String, Value> = all
        .into_iter()
        .filter(|(name, _)| needed.contains(name))
        .collect();
    let mut schema = Map::new();
    schema.insert(
        "$schema".into(),
        json!("https://json-schema.org/draft/2020-12/schema"),
    );
    schema.insert(
        "title".into(),
        json!(format!("{SCHEMA} {}", kind.unwrap_or("document"))),
    );
    schema.extend(root.as_object().cloned().invariant("the root is an object"));
    schema.insert("$defs".into(), Value::Object(used));
    let text = serde_json::to_string_pretty(&schema);
    Ok(text.invariant("a schema is JSON") + "\n")
}

/// All definitions, by name.
fn definitions() -> Map<String, Value> {
    let common = include_str!("schema/common.json");
    let texts = KINDS.iter().map(|(_, text)| *text).chain([common]);
    let mut all = Map::new();
    for text in texts {
        let added = parsed(text.as_bytes());
        for (name, definition) in added
            .as_object()
            .invariant("a file of definitions is an object")
        {
            let before = all.insert(name.clone(), definition.clone());
            before
                .is_none()
                .then_some(())
                .invariant("a definition has one place");
        }
    }
    all
}

/// The names of all definitions that the value refers to, directly or through others.
fn collect(value: &Value, all: &Map<String, Value>, needed: &mut BTreeSet<String>) {
    match value {
        Value::Object(fields) => {
            if let Some(Value::String(reference)) = fields.get("$ref") {
                let name = reference.strip_prefix("#/$defs/");
                let name = name.invariant("references are to definitions");
                if needed.insert(name.to_owned()) {
                    collect(
                        all.get(name).invariant("a reference has a definition"),
                        all,
                        needed,
                    );
                }
            }
            fields
                .values()
                .for_each(|field| collect(field, all, needed));
        }
        Value::Array(items) => items.iter().for_each(|item| collect(item, all, needed)),
        _ => {}
    }
}
