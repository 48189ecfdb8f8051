//! Documents against their schemas.

use boon::{Compiler, Schemas};
use serde_json::Value;
use stellate::document::json_schema;

/// Fails with the place if the document does not fulfil the schema of its kind.
pub(crate) fn check(document: &Value) {
    let kind = document["kind"].as_str().unwrap();
    let text = json_schema(Some(kind)).unwrap();
    let schema: Value = serde_json::from_str(&text).unwrap();
    let name = format!("{kind}.json");
    let mut compiler = Compiler::new();
    compiler.add_resource(&name, schema).unwrap();
    let mut schemas = Schemas::new();
    let index = compiler.compile(&name, &mut schemas).unwrap();
    if let Err(error) = schemas.validate(document, index) {
        panic!("{kind}: {error:#}");
    }
}
