//! Parametric curves and patches in every format that has their functions.

use std::collections::BTreeMap;
use std::io::Write;

use serde::Serialize;

use super::json::write_value;
use super::{Format, Kind, SCHEMA, write_lines};
use crate::error::Result;
use crate::notation::{Coordinates, NAMES};

/// A document of kind `parametric` that gives coordinates.
#[derive(Debug, Serialize)]
struct ParametricFormDocument {
    schema: &'static str,
    kind: &'static str,
    parameters: Vec<String>,
    coordinates: BTreeMap<&'static str, String>,
}

impl ParametricFormDocument {
    fn of(coordinates: &Coordinates) -> Self {
        let parameters = coordinates.parameters().into_iter();
        Self {
            schema: SCHEMA,
            kind: "parametric",
            parameters: parameters.map(Into::into).collect(),
            coordinates: coordinates.fields(),
        }
    }
}

/// Writes the form as text `x = …; y = …`, as statements for SymPy or Maple, or as a JSON document of kind `parametric`. Text
/// and JSON can be read back.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(crate) fn write_coordinates(
    coordinates: &Coordinates,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let formulas = coordinates.formulas(format);
    let rows = NAMES.iter().zip(&formulas);
    match format {
        Format::Json => {
            write_value(&ParametricFormDocument::of(coordinates), out)?;
            Ok(writeln!(out)?)
        }
        Format::Text => write_lines(rows.map(|(n, f)| format!("{n} = {f}")), out),
        Format::Latex => write_lines(rows.map(|(n, f)| format!("{n} = {f} \\\\")), out),
        Format::Maple => write_lines(rows.map(|(n, f)| format!("{n} := {f};")), out),
        Format::Sympy => Ok(writeln!(out, "({})", formulas.join(", "))?),
        Format::Csv | Format::Singular => Err(Kind::ParametricForm.refused(format)),
    }
}
