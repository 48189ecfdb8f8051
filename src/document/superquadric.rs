//! Superquadrics as text and JSON, and what is certain about them.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::{Map, Value};

use super::node::Node;
use super::{Format, SCHEMA};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::language::check_exponent;
use crate::shape::Superquadric;

/// The document of kind `superquadric`.
#[derive(Serialize)]
pub(super) struct Document {
    schema: &'static str,
    kind: &'static str,
    dimension: usize,
    a: [String; 2],
    e: [String; 1],
    level: String,
}

impl Document {
    pub(super) fn new(shape: &Superquadric) -> Self {
        Self {
            schema: SCHEMA,
            kind: "superquadric",
            dimension: 2,
            a: shape.semi_axes().each_ref().map(ToString::to_string),
            e: [shape.epsilon().to_string()],
            level: shape.level().to_string(),
        }
    }
}

/// Writes a superquadric as the row of the input language, or as a JSON document; both are read back.
///
/// ```
/// use stellate::document::{Format, write_superquadric};
/// use stellate::language::{Numbers, parse_form};
/// use stellate::shape::Form;
///
/// let text = "superquadric 2d a=1,2 e=1/2 level=3";
/// let Form::Superquadric(shape) = parse_form(text, "<form>", Numbers::Exact)? else { unreachable!() };
/// let mut out = Vec::new();
/// write_superquadric(&shape, Format::Text, &mut out).unwrap();
/// assert_eq!(out, b"superquadric 2d a=1,2 e=1/2 level=3\n");
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of `out`; `Unsupported` for formats other than text and JSON.
pub fn write_superquadric(
    shape: &Superquadric,
    format: Format,
    out: &mut dyn Write,
) -> io::Result<()> {
    match format {
        Format::Text => {
            let [a1, a2] = shape.semi_axes();
            write!(out, "superquadric 2d a={a1},{a2} e={}", shape.epsilon())?;
            if *shape.level() != Rational::one() {
                write!(out, " level={}", shape.level())?;
            }
            writeln!(out)
        }
        Format::Json => {
            serde_json::to_writer(&mut *out, &Document::new(shape))?;
            writeln!(out)
        }
        _ => Err(io::Error::new(
            io::ErrorKind::Unsupported,
            "a superquadric is written as text or json",
        )),
    }
}

/// Reads the fields of a document of kind `superquadric`.
pub(super) fn read_superquadric(
    root: &Node<'_>,
    object: &Map<String, Value>,
) -> Result<Superquadric> {
    let dimension = root.field(object, "dimension")?;
    if dimension.natural()? != 2 {
        return Err(dimension.wrong("expected 2: only superquadrics in the plane are understood"));
    }
    let (a, e) = (root.field(object, "a")?, root.field(object, "e")?);
    let axes = positive_list(&a, 2)?;
    let epsilon = positive_list(&e, 1)?.swap_remove(0);
    check_exponent(&epsilon).map_err(|limit| Error::limit(format!("{}: {limit}", e.place())))?;
    let level = match object.get("level") {
        None => Rational::one(),
        Some(_) => positive(&root.field(object, "level")?)?,
    };
    let [a1, a2] = <[Rational; 2]>::try_from(axes).map_err(|_| a.wrong("expected 2 numbers"))?;
    Superquadric::new([a1, a2], epsilon, level)
        .ok_or_else(|| root.wrong("expected positive numbers"))
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

#[derive(Serialize)]
struct Description {
    schema: &'static str,
    kind: &'static str,
    superquadric: Document,
    method: &'static str,
    exponent: String,
    degree: Option<usize>,
    star_shaped: bool,
    convex: bool,
    notes: Vec<String>,
}

/// Writes what is certain about a superquadric, as `key: value` lines or as a JSON document of kind `description`.
///
/// # Errors
/// Those of `out`; `Unsupported` for formats other than text and JSON.
pub fn write_superquadric_description(
    shape: &Superquadric,
    format: Format,
    out: &mut dyn Write,
) -> io::Result<()> {
    let notes = vec![smoothness(shape).to_owned()];
    let description = Description {
        schema: SCHEMA,
        kind: "description",
        superquadric: Document::new(shape),
        method: "lemma-2",
        exponent: shape.exponent().to_string(),
        degree: shape.even_exponent(),
        star_shaped: true,
        convex: shape.is_convex(),
        notes,
    };
    match format {
        Format::Json => {
            serde_json::to_writer(&mut *out, &description)?;
            writeln!(out)
        }
        Format::Text => write_text(&description, out),
        _ => Err(io::Error::new(
            io::ErrorKind::Unsupported,
            "a description is written as text or json",
        )),
    }
}

fn write_text(d: &Description, out: &mut dyn Write) -> io::Result<()> {
    let n = &d.exponent;
    let [a1, a2] = &d.superquadric.a;
    let (level, power) = (&d.superquadric.level, grouped(n));
    let (x, y) = (divided("x", a1), divided("y", a2));
    writeln!(out, "superquadric: |{x}|^{power} + |{y}|^{power} = {level}")?;
    writeln!(out, "exponent 2/e: {n}")?;
    match d.degree {
        Some(degree) => writeln!(out, "degree: {degree} (2/e is an even integer)")?,
        None => writeln!(
            out,
            "degree: none (no polynomial as it stands: 2/e is not an even integer)"
        )?,
    }
    writeln!(out, "method: {}", d.method)?;
    writeln!(out, "star-shaped (r > 0 everywhere, certified): yes")?;
    let (convex, relation) = if d.convex {
        ("yes", "2/e >= 1")
    } else {
        ("no", "2/e < 1")
    };
    writeln!(out, "convex: {convex} ({relation})")?;
    for note in &d.notes {
        writeln!(out, "note: {note}")?;
    }
    Ok(())
}

fn divided(name: &str, by: &str) -> String {
    if by == "1" {
        name.into()
    } else {
        format!("{name}/{}", grouped(by))
    }
}

/// A fraction in parentheses.
fn grouped(number: &str) -> String {
    if number.contains('/') {
        format!("({number})")
    } else {
        number.into()
    }
}

/// What the curve looks like on the axes.
fn smoothness(shape: &Superquadric) -> &'static str {
    let exponent = shape.exponent();
    match exponent.cmp(&Rational::one()) {
        std::cmp::Ordering::Less => "four cusps, on the axes",
        std::cmp::Ordering::Equal => "four straight sides, with corners on the axes",
        std::cmp::Ordering::Greater if exponent == Rational::from(2) => "an ellipse",
        std::cmp::Ordering::Greater if exponent < Rational::from(2) => {
            "strictly convex, with infinite curvature on the axes"
        }
        std::cmp::Ordering::Greater => "strictly convex, with curvature 0 on the axes",
    }
}
