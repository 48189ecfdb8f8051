//! Superquadrics are read from JSON documents.

use serde_json::{Map, Value};

use super::node::Node;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::language::{check_exponent, superquadric_of};
use crate::shape::Form;

/// Reads the fields of a document of kind `superquadric`.
pub(super) fn read_superquadric(root: &Node<'_>, object: &Map<String, Value>) -> Result<Form> {
    let dimension = root.field(object, "dimension")?;
    let count = match dimension.natural()? {
        2 => 2,
        3 => 3,
        _ => return Err(dimension.wrong("expected 2 or 3")),
    };
    let (a, e) = (root.field(object, "a")?, root.field(object, "e")?);
    let axes = positive_list(&a, count)?;
    let epsilon = positive_list(&e, count - 1)?;
    for value in &epsilon {
        check_exponent(value).map_err(|limit| Error::limit(format!("{}: {limit}", e.place())))?;
    }
    let level = match object.get("level") {
        None => Rational::one(),
        Some(_) => positive(&root.field(object, "level")?)?,
    };
    superquadric_of(axes, epsilon, level).ok_or_else(|| root.wrong("expected positive numbers"))
}

fn positive_list(node: &Node<'_>, count: usize) -> Result<Vec<Rational>> {
    let list = node.array()?;
    if list.len() != count {
        return Err(node.wrong(format!("expected a list of {count}, found {}", list.len())));
    }
    (0..count).map(|n| positive(&node.item(list, n)?)).collect()
}

fn positive(node: &Node<'_>) -> Result<Rational> {
    let value = node.number()?;
    if value.signum() > 0 {
        return Ok(value);
    }
    Err(node.wrong("it must be positive"))
}
