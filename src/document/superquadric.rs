//! Superquadrics and their exact properties, as text and as JSON.

use std::io::Write;

use serde::Serialize;
use serde_json::json;

use super::json::write_value;
use super::{Format, Kind, SCHEMA};
use crate::error::Result;
use crate::exact::Rational;
use crate::poly::SparsePolynomial;
use crate::shape::{SpaceSuperquadric, Superquadric};

/// The document of kind `superquadric`.
#[derive(Serialize)]
pub(super) struct SuperquadricDocument {
    schema: &'static str,
    kind: &'static str,
    dimension: usize,
    a: Vec<String>,
    e: Vec<String>,
    level: String,
}

impl SuperquadricDocument {
    pub(super) fn new(shape: &Superquadric) -> Self {
        Self::of(shape.semi_axes(), &[shape.epsilon().clone()], shape.level())
    }

    pub(super) fn in_space(shape: &SpaceSuperquadric) -> Self {
        Self::of(shape.semi_axes(), shape.epsilon(), shape.level())
    }

    fn of(axes: &[Rational], epsilon: &[Rational], level: &Rational) -> Self {
        let strings = |list: &[Rational]| list.iter().map(ToString::to_string).collect();
        Self {
            schema: SCHEMA,
            kind: "superquadric",
            dimension: axes.len(),
            a: strings(axes),
            e: strings(epsilon),
            level: level.to_string(),
        }
    }

    /// Writes the superquadric as a row of the input language or as JSON.
    fn write(&self, format: Format, out: &mut dyn Write) -> Result<()> {
        match format {
            Format::Text => {
                let (a, e) = (self.a.join(","), self.e.join(","));
                write!(out, "superquadric {}d a={a} e={e}", self.dimension)?;
                if self.level != "1" {
                    write!(out, " level={}", self.level)?;
                }
                Ok(writeln!(out)?)
            }
            Format::Json => {
                write_value(self, out)?;
                Ok(writeln!(out)?)
            }
            _ => Err(Kind::Superquadric.refused(format)),
        }
    }
}

/// Writes a superquadric as a row of the input language or as a JSON document; both can be read back.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(crate) fn write_superquadric(
    shape: &Superquadric,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    SuperquadricDocument::new(shape).write(format, out)
}

/// Writes a superquadric in space; see [`write_superquadric`].
///
/// # Errors
/// As [`write_superquadric`].
pub(crate) fn write_space_superquadric(
    shape: &SpaceSuperquadric,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    SuperquadricDocument::in_space(shape).write(format, out)
}

#[derive(Serialize)]
struct Description {
    schema: &'static str,
    kind: &'static str,
    superquadric: SuperquadricDocument,
    method: &'static str,
    exponent: String,
    degree: Option<usize>,
    star_shaped: bool,
    convex: bool,
    notes: Vec<String>,
}

/// Writes the exact properties of a superquadric, as `key: value` lines or as a JSON document of kind `description`.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(crate) fn write_superquadric_description(
    shape: &Superquadric,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let notes = vec![smoothness(shape).to_owned()];
    let description = Description {
        schema: SCHEMA,
        kind: "description",
        superquadric: SuperquadricDocument::new(shape),
        method: "lemma-2",
        exponent: shape.exponent().to_string(),
        degree: shape.even_exponent(),
        star_shaped: true,
        convex: shape.is_convex(),
        notes,
    };
    match format {
        Format::Json => {
            write_value(&description, out)?;
            Ok(writeln!(out)?)
        }
        Format::Text => write_text(&description, out),
        _ => Err(Kind::Description.refused(format)),
    }
}

fn write_text(d: &Description, out: &mut dyn Write) -> Result<()> {
    let n = &d.exponent;
    let [a1, a2] = &d.superquadric.a[..] else {
        return Ok(());
    };
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

/// Writes the exact properties of a superquadric in space; see [`write_superquadric_description`].
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(crate) fn write_space_superquadric_description(
    shape: &SpaceSuperquadric,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let [of_xy, of_sum, of_z] = shape.exponents().map(|q| q.to_string());
    let polynomial = shape.polynomial();
    let degree = polynomial.as_ref().ok().and_then(SparsePolynomial::degree);
    let notes = polynomial.err().map(|why| why.to_string());
    match format {
        Format::Json => {
            let mut description = json!({
                "schema": SCHEMA,
                "kind": "description",
                "superquadric": SuperquadricDocument::in_space(shape),
                "method": "lemma-7",
                "exponents": [of_xy, of_sum, of_z],
                "degree": degree,
                "star_shaped": true,
                "convex": shape.is_convex(),
            });
            description["notes"] = notes.into_iter().collect();
            write_value(&description, out)?;
            Ok(writeln!(out)?)
        }
        Format::Text => {
            let [a1, a2, a3] = shape.semi_axes().each_ref().map(ToString::to_string);
            let [x, y, z] = [("x", &a1), ("y", &a2), ("z", &a3)].map(|(v, a)| divided(v, a));
            let [m, k, n] = [&of_xy, &of_sum, &of_z].map(|q| grouped(q));
            let sum = format!("|{x}|^{m} + |{y}|^{m}");
            let sum = if of_sum == "1" {
                sum
            } else {
                format!("[{sum}]^{k}")
            };
            writeln!(out, "superquadric: {sum} + |{z}|^{n} = {}", shape.level())?;
            writeln!(
                out,
                "exponents 2/e2, e2/e1, 2/e1: {of_xy}, {of_sum}, {of_z}"
            )?;
            match degree {
                Some(degree) => writeln!(out, "degree: {degree}")?,
                None => writeln!(out, "degree: none (no polynomial)")?,
            }
            writeln!(out, "method: lemma-7")?;
            writeln!(out, "star-shaped (R > 0 everywhere, certified): yes")?;
            let convex = if shape.is_convex() {
                "yes (2/e1 >= 1 and 2/e2 >= 1)"
            } else {
                "no (2/e1 < 1 or 2/e2 < 1)"
            };
            writeln!(out, "convex: {convex}")?;
            if let Some(note) = notes {
                writeln!(out, "note: {note}")?;
            }
            Ok(())
        }
        _ => Err(Kind::Description.refused(format)),
    }
}

fn divided(name: &str, by: &str) -> String {
    if by == "1" {
        name.into()
    } else {
        format!("{name}/{}", grouped(by))
    }
}

/// A fraction in parentheses; other numbers need none.
fn grouped(number: &str) -> String {
    if number.contains('/') {
        format!("({number})")
    } else {
        number.into()
    }
}

/// The shape of the curve on the axes, in words.
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
