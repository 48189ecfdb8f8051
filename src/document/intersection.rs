//! Space curves as intersections of surfaces.

use std::io::{self, Write};

use serde_json::{Map, Value, json};

use super::implicit::polynomial_text;
use super::node::Node;
use super::{Annotations, Format, SCHEMA, write_surface};
use crate::error::Result;
use crate::shape::{Form, ImplicitSurface};

/// Writes the surfaces of an intersection: equations one to a line, or a document of kind `intersection`.
///
/// # Errors
/// Those of `out`; `Unsupported` for CSV, which has no room for two tables.
pub fn write_intersection(
    surfaces: &[ImplicitSurface],
    annotations: &Annotations,
    format: Format,
    out: &mut dyn Write,
) -> io::Result<()> {
    match format {
        Format::Json => write_json(surfaces, annotations, out),
        Format::Csv => Err(io::Error::new(
            io::ErrorKind::Unsupported,
            "an intersection is written as text, json, latex, sympy, maple or singular",
        )),
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
            surfaces.iter().try_for_each(|surface| {
                write_surface(surface, &Annotations::default(), format, out)
            })
        }
    }
}

fn write_json(
    surfaces: &[ImplicitSurface],
    annotations: &Annotations,
    out: &mut dyn Write,
) -> io::Result<()> {
    write!(
        out,
        "{{\"schema\":\"{SCHEMA}\",\"kind\":\"intersection\",\"notes\":"
    )?;
    serde_json::to_writer(&mut *out, &json!(annotations.notes))?;
    for (name, value) in &annotations.fields {
        write!(out, ",\"{name}\":")?;
        serde_json::to_writer(&mut *out, value)?;
    }
    write!(out, ",\"surfaces\":[")?;
    for (n, surface) in surfaces.iter().enumerate() {
        if n > 0 {
            write!(out, ",")?;
        }
        write_surface(surface, &Annotations::default(), Format::Json, out)?;
    }
    writeln!(out, "]}}")
}

/// Reads the surfaces of a document of kind `intersection`, with `read` for each.
pub(super) fn read_intersection(
    root: &Node<'_>,
    object: &Map<String, Value>,
    read: impl Fn(&Node<'_>) -> Result<Form>,
) -> Result<Form> {
    let list = root.field(object, "surfaces")?;
    let entries = list.array()?;
    if entries.len() < 2 {
        return Err(list.wrong("expected at least two surfaces"));
    }
    let mut surfaces = Vec::new();
    for n in 0..entries.len() {
        let node = list.item(entries, n)?;
        match read(&node)? {
            Form::Surface(surface) => surfaces.push(surface),
            _ => return Err(node.wrong("expected a surface, with the variables x, y and z")),
        }
    }
    Ok(Form::Intersection(surfaces))
}
