//! Space curves that are given as intersections of surfaces.

use std::io::Write;

use serde_json::json;

use super::facts::Annotations;
use super::json::write_value;
use super::{Format, Kind, SCHEMA, write_surface};
use crate::error::Result;
use crate::limits::Limits;
use crate::notation::polynomial_text;
use crate::shape::ImplicitSurface;
use crate::verb::Fact;

/// Writes the surfaces of an intersection: an equation on each line, or a document of kind `intersection`.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(crate) fn write_intersection(
    surfaces: &[ImplicitSurface],
    facts: &[Fact],
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let annotations = &Annotations::from(facts);
    // A text has one center.
    let surfaces = &ImplicitSurface::all_in_original_coordinates(surfaces, &Limits::none())?[..];
    match format {
        Format::Json => write_json(surfaces, annotations, out),
        Format::Csv => Err(Kind::Equations.refused(format)),
        Format::Text => {
            for note in &annotations.notes {
                writeln!(out, "# note: {note}")?;
            }
            let has_z = |s: &ImplicitSurface| s.polynomial().terms().any(|(e, _)| e[2] > 0);
            let any_z = surfaces.iter().any(has_z);
            for (n, surface) in surfaces.iter().enumerate() {
                let zero = if n == 0 && !any_z { " + 0z" } else { "" };
                writeln!(out, "{}{zero} = 0", polynomial_text(surface.polynomial()))?;
            }
            Ok(())
        }
        _ => {
            for note in &annotations.notes {
                writeln!(out, "{} note: {note}", format.comment())?;
            }
            surfaces
                .iter()
                .try_for_each(|surface| write_surface(surface, &[], format, out))
        }
    }
}

fn write_json(
    surfaces: &[ImplicitSurface],
    annotations: &Annotations,
    out: &mut dyn Write,
) -> Result<()> {
    write!(
        out,
        "{{\"schema\":\"{SCHEMA}\",\"kind\":\"intersection\",\"notes\":"
    )?;
    write_value(&json!(annotations.notes), out)?;
    for (name, value) in &annotations.fields {
        write!(out, ",\"{name}\":")?;
        write_value(value, out)?;
    }
    write!(out, ",\"surfaces\":[")?;
    for (n, surface) in surfaces.iter().enumerate() {
        if n > 0 {
            write!(out, ",")?;
        }
        write_surface(surface, &[], Format::Json, out)?;
    }
    Ok(writeln!(out, "]}}")?)
}
