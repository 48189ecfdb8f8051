//! Descriptions as text and JSON.

use std::io::{self, Write};

use serde::Serialize;

use super::parametric::{Range, ranges_text};
use super::{Format, SCHEMA};
use crate::describe::{Description, FourierDescription, Method};

#[derive(Serialize)]
struct Document<'a> {
    schema: &'static str,
    kind: &'static str,
    degree: usize,
    homogeneous_degrees: &'a [usize],
    terms: usize,
    coefficient_bits: u64,
    method: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    step: Option<usize>,
    origin_multiplicity: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    harmonics: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    star_shaped: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    irreducible: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    perfect_square: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    positive: Option<Vec<Range>>,
    notes: Vec<String>,
}

/// Writes a description as `key: value` lines, or as the JSON document of kind `description`.
///
/// # Errors
/// Those of `out`; `Unsupported` for formats other than text and JSON.
pub fn write_description(
    description: &Description,
    extra_notes: &[String],
    digits: u32,
    format: Format,
    out: &mut dyn Write,
) -> io::Result<()> {
    let document = document(description, extra_notes, digits);
    match format {
        Format::Json => {
            serde_json::to_writer(&mut *out, &document)?;
            writeln!(out)
        }
        Format::Text => write_text(&document, out),
        _ => Err(io::Error::new(
            io::ErrorKind::Unsupported,
            "a description is written as text or json",
        )),
    }
}

fn document<'a>(d: &'a Description, extra_notes: &[String], digits: u32) -> Document<'a> {
    let fourier = d.fourier.as_ref();
    let positive: Option<Vec<Range>> =
        fourier.map(|f| f.positive.iter().map(|r| Range::new(r, digits)).collect());
    let mut notes = extra_notes.to_vec();
    if let (Some(f), Some(positive)) = (fourier, &positive) {
        notes.extend(fourier_notes(d, f, positive));
    }
    let step = match d.method {
        Method::Lemma { step, .. } => Some(step),
        Method::Lines | Method::Numeric => None,
    };
    Document {
        schema: SCHEMA,
        kind: "description",
        degree: d.degree,
        homogeneous_degrees: &d.homogeneous_degrees,
        terms: d.terms,
        coefficient_bits: d.coefficient_bits,
        method: d.method.name(),
        step,
        origin_multiplicity: d.origin_multiplicity,
        harmonics: fourier.map(|f| f.radius.harmonics()),
        star_shaped: fourier.map(FourierDescription::star_shaped),
        // By the theorem on SquaredForm::is_perfect_square; the reduced equation of a perfect square
        // is linear in r on the circle.
        irreducible: fourier.map(|_| true),
        perfect_square: fourier.map(|f| f.perfect_square),
        positive,
        notes,
    }
}

fn fourier_notes(d: &Description, f: &FourierDescription, positive: &[Range]) -> Vec<String> {
    let n = f.radius.harmonics();
    let mut notes = Vec::new();
    notes.push(if f.perfect_square {
        format!(
            "F of Theorem 2 has degree {} and is a perfect square, because a0 and all even harmonics are 0; this is its reduced equation, of degree {}, linear in r on the unit circle and so irreducible over Q",
            2 * n + 2,
            d.degree
        )
    } else {
        "irreducible over Q: in polar form F = r^(2N) (r - r(t)) (r + r(t+pi)), the two factors are exchanged by (r, t) -> (-r, t+pi) and differ, because an even harmonic (a0 among them) is not 0; and x^2 + y^2 does not divide F, because the N-th harmonic is not 0".into()
    });
    if f.star_shaped() {
        notes.push(
            "r > 0 for every angle: certified, (1+s^2)^N r(2 atan s) has no real root s".into(),
        );
    } else {
        notes.push(format!("r > 0 for t in {}", ranges_text(positive)));
    }
    if d.origin_multiplicity > 0 && f.star_shaped() {
        notes.push(format!(
            "besides the curve, F = 0 holds at the origin alone: an isolated real point of multiplicity {}",
            d.origin_multiplicity
        ));
    } else if d.origin_multiplicity > 0 {
        notes.push(format!(
            "the origin belongs to F = 0, with multiplicity {}",
            d.origin_multiplicity
        ));
    }
    if !f.star_shaped() && !positive.is_empty() && has_negative_radius(f) {
        notes.push("where r(t) < 0 the reflected arc, at distance |r(t)| in the direction t + pi, belongs to F = 0 as well".into());
    }
    notes
}

/// Whether r < 0 somewhere: −r is positive somewhere.
fn has_negative_radius(f: &FourierDescription) -> bool {
    let negated = |v: &[crate::exact::Rational]| v.iter().map(|c| -c).collect();
    let r =
        crate::shape::FourierRadius::new(negated(f.radius.cosines()), negated(f.radius.sines()));
    !crate::parametrize::positive_ranges(&r).is_empty()
}

fn write_text(d: &Document, out: &mut dyn Write) -> io::Result<()> {
    let yes_no = |b: bool| if b { "yes" } else { "no" };
    let degrees: Vec<String> = d
        .homogeneous_degrees
        .iter()
        .map(ToString::to_string)
        .collect();
    writeln!(out, "degree: {}", d.degree)?;
    writeln!(out, "homogeneous parts: {}", degrees.join(", "))?;
    writeln!(out, "terms: {}", d.terms)?;
    writeln!(out, "coefficient bits: {}", d.coefficient_bits)?;
    match d.step {
        Some(step) if step > 1 => writeln!(out, "method: {} in r^{step}", d.method)?,
        _ => writeln!(out, "method: {}", d.method)?,
    }
    writeln!(out, "multiplicity of the origin: {}", d.origin_multiplicity)?;
    if let Some(n) = d.harmonics {
        writeln!(out, "harmonics: {n}")?;
    }
    if let Some(star_shaped) = d.star_shaped {
        writeln!(
            out,
            "star-shaped (r > 0 everywhere, certified): {}",
            yes_no(star_shaped)
        )?;
    }
    if let Some(irreducible) = d.irreducible {
        writeln!(out, "irreducible over Q: {}", yes_no(irreducible))?;
    }
    for note in &d.notes {
        writeln!(out, "note: {note}")?;
    }
    Ok(())
}
