//! The form whose radii a document lists. The document contains the form, because a radius with roots cannot be read back.

use std::collections::BTreeMap;
use std::io::Write;

use serde_json::Value;

use super::json::parsed;
use super::{Format, write_form};
use crate::error::{Invariant, Result};
use crate::reading::PARAMETRIZES;
use crate::shape::Form;

/// The field `implicit` or `superquadric` of a parametric document, if there is one.
pub(super) type SourceField = BTreeMap<&'static str, Value>;

/// The form as a field of a parametric document.
pub(super) fn source_field(of: Option<&Form>) -> Result<SourceField> {
    let Some(form) = of else {
        return Ok(SourceField::new());
    };
    let name = match form {
        Form::Superquadric(_) | Form::SpaceSuperquadric(_) => "superquadric",
        _ => "implicit",
    };
    let mut text = Vec::new();
    write_form(form, &[], Format::Json, &mut text)?;
    Ok(SourceField::from([(name, parsed(&text))]))
}

/// Writes the form as the comment from which [`crate::reading::read_text`] reads it back. LaTeX cannot be read back, so it has
/// no such comment.
pub(super) fn write_source(of: Option<&Form>, format: Format, out: &mut dyn Write) -> Result<()> {
    let Some(form) = of.filter(|_| format != Format::Latex) else {
        return Ok(());
    };
    let mut text = Vec::new();
    write_form(form, &[], Format::Text, &mut text)?;
    let text = String::from_utf8(text).invariant("formulas are written as UTF-8");
    // Another comment states the center.
    let mut equations = Vec::new();
    for line in text.lines() {
        match line.strip_prefix("# ") {
            Some(_) if format == Format::Text => {}
            Some(comment) => writeln!(out, "{} {comment}", format.comment())?,
            None => equations.push(line),
        }
    }
    let equations = equations.join("; ");
    Ok(writeln!(
        out,
        "{} {PARAMETRIZES} {equations}",
        format.comment()
    )?)
}

/// Writes radii as equations `name = …`, one on each line. In SymPy a single radius is an expression, and several radii are a
/// list.
pub(super) fn write_radii(
    name: &str,
    radii: &[String],
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    match (format, radii) {
        (Format::Sympy, [only]) => writeln!(out, "{only}")?,
        (Format::Sympy, _) => writeln!(out, "[{}]", radii.join(", "))?,
        _ => {
            let end = if format == Format::Maple { ";" } else { "" };
            for radius in radii {
                writeln!(out, "{name} = {radius}{end}")?;
            }
        }
    }
    Ok(())
}
