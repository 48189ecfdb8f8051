//! Descriptions of forms, as text and as JSON.

use std::io::Write;

use serde::Serialize;
use serde_json::Value;

use super::angles::{Range, ranges_text};
use super::facts::Annotations;
use super::json::{parsed, value_of, write_value};
use super::topology::{
    NO_GENUS, genus_text, notes as topology_notes, topology_json, write_topology,
};
use super::{Format, Kind, SCHEMA, center_comment, center_line, write_form};
use crate::describe::{DescribedFactor, Description, FourierDescription, Method};
use crate::error::Result;
use crate::notation::polynomial_text;
use crate::shape::{Form, ImplicitSurface};
use crate::verb::{CurveTopology, Fact};

/// A factor with a longer text is not printed in the text format.
const LONGEST_FACTOR: usize = 300;

#[derive(Serialize)]
struct DescriptionDocument<'a> {
    schema: &'static str,
    kind: &'static str,
    degree: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    center: Option<Vec<String>>,
    #[serde(skip)]
    center_line: Option<String>,
    homogeneous_degrees: &'a [usize],
    terms: usize,
    coefficient_bits: u64,
    method: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    step: Option<usize>,
    factors: Option<Vec<FactorEntry>>,
    origin_multiplicity: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    harmonics: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    star_shaped: Option<bool>,
    irreducible: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    perfect_square: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    positive: Option<Vec<Range>>,
    notes: Vec<String>,
}

#[derive(Serialize)]
struct FactorEntry {
    multiplicity: usize,
    polynomial: Value,
    proof: String,
    /// The genus, if the topology was asked for; `Some(None)` if it was not found.
    #[serde(skip_serializing_if = "Option::is_none")]
    genus: Option<Option<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    conjugate_components: Option<usize>,
    #[serde(skip)]
    text: String,
}

impl FactorEntry {
    fn new(factor: &DescribedFactor) -> Result<Self> {
        Ok(Self {
            multiplicity: factor.multiplicity,
            polynomial: parsed(&written(&factor.shape, Format::Json)?),
            proof: factor.proof.clone(),
            genus: None,
            conjugate_components: None,
            text: String::from_utf8_lossy(&written(&factor.shape, Format::Text)?).into_owned(),
        })
    }

    /// The polynomial on one line, unless it is very long.
    fn short_text(&self) -> String {
        let line = self
            .text
            .lines()
            .rfind(|line| !line.starts_with('#'))
            .unwrap_or("");
        let polynomial = line.trim_end_matches(" = 0");
        if polynomial.len() <= LONGEST_FACTOR {
            return polynomial.into();
        }
        let terms = self.polynomial["terms"].as_array().map_or(0, Vec::len);
        format!(
            "a polynomial of degree {} with {terms} terms",
            self.polynomial["degree"]
        )
    }
}

impl DescriptionDocument<'_> {
    /// Adds the genus of each factor, and what the topology leaves open.
    fn add_genera(&mut self, found: &CurveTopology, digits: u32) {
        let factors = self.factors.iter_mut().flatten();
        for (entry, genus) in factors.zip(&found.genera) {
            entry.genus = Some(genus.map(|g| g.genus));
            let components = genus.map(|g| g.components);
            entry.conjugate_components = components.filter(|&n| n > 1);
        }
        if found.genera.contains(&None) {
            self.notes.push(NO_GENUS.into());
        }
        let topology = found.topology.iter();
        self.notes
            .extend(topology.flat_map(|t| topology_notes(t, digits)));
    }
}

fn written(shape: &Form, format: Format) -> Result<Vec<u8>> {
    let mut text = Vec::new();
    write_form(shape, &[], format, &mut text)?;
    Ok(text)
}

/// Writes a description as `key: value` lines, or as the JSON document of kind `description`.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(crate) fn write_description(
    description: &Description,
    facts: &[Fact],
    topology: Option<&CurveTopology>,
    digits: u32,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let annotations = Annotations::from(facts);
    let mut document = document(description, &annotations.notes, digits)?;
    if let Some(topology) = topology {
        document.add_genera(topology, digits);
    }
    match format {
        Format::Json => {
            let mut value = value_of(&document);
            for (name, field) in &annotations.fields {
                value[*name] = field.clone();
            }
            if let Some(found) = topology.and_then(|found| found.topology.as_ref()) {
                value["topology"] = topology_json(found, digits);
            }
            write_value(&value, out)?;
            Ok(writeln!(out)?)
        }
        Format::Text => write_text(&document, topology, digits, out),
        _ => Err(Kind::Description.refused(format)),
    }
}

/// Writes the description of a space curve: its equations and the facts about it.
///
/// # Errors
/// As [`write_description`].
pub(crate) fn write_space_curve_description(
    surfaces: &[ImplicitSurface],
    facts: &[Fact],
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let annotations = Annotations::from(facts);
    let surfaces = surfaces.iter();
    let surfaces: Vec<ImplicitSurface> = surfaces
        .map(|s| ImplicitSurface::new(s.polynomial().primitive()))
        .collect();
    match format {
        Format::Json => {
            let forms = surfaces.into_iter().map(Form::Surface);
            let entries: Vec<Value> = forms
                .map(|form| Ok(parsed(&written(&form, Format::Json)?)))
                .collect::<Result<_>>()?;
            let mut value = serde_json::json!({
                "schema": SCHEMA,
                "kind": "description",
                "surfaces": entries,
                "notes": annotations.notes,
            });
            for (name, field) in &annotations.fields {
                value[*name] = field.clone();
            }
            write_value(&value, out)?;
            Ok(writeln!(out)?)
        }
        Format::Text => {
            writeln!(out, "surfaces: {}", surfaces.len())?;
            for surface in &surfaces {
                let f = surface.polynomial();
                let degree = f.degree().unwrap_or(0);
                writeln!(
                    out,
                    "equation of degree {degree}: {} = 0",
                    polynomial_text(f)
                )?;
            }
            for note in &annotations.notes {
                writeln!(out, "note: {note}")?;
            }
            Ok(())
        }
        _ => Err(Kind::Description.refused(format)),
    }
}

fn document<'a>(
    d: &'a Description,
    extra_notes: &[String],
    digits: u32,
) -> Result<DescriptionDocument<'a>> {
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
    Ok(DescriptionDocument {
        schema: SCHEMA,
        kind: "description",
        degree: d.degree,
        center: center_comment(&d.center)
            .map(|_| d.center.iter().map(ToString::to_string).collect()),
        center_line: center_line(&d.center),
        homogeneous_degrees: &d.homogeneous_degrees,
        terms: d.terms,
        coefficient_bits: d.coefficient_bits,
        method: d.method.name(),
        step,
        origin_multiplicity: d.origin_multiplicity,
        harmonics: fourier.map(|f| f.radius.harmonics()),
        star_shaped: fourier.map(FourierDescription::star_shaped),
        irreducible: d
            .factors
            .as_ref()
            .map(|factors| matches!(&factors[..], [only] if only.multiplicity == 1)),
        factors: d
            .factors
            .as_ref()
            .map(|factors| factors.iter().map(FactorEntry::new).collect::<Result<_>>())
            .transpose()?,
        perfect_square: fourier.map(|f| f.perfect_square),
        positive,
        notes,
    })
}

fn fourier_notes(d: &Description, f: &FourierDescription, positive: &[Range]) -> Vec<String> {
    let n = f.radius.harmonics();
    let mut notes = Vec::new();
    if f.perfect_square {
        notes.push(format!(
            "F of Theorem 2 has degree {} and is a perfect square, because a0 and all even harmonics are 0; this is its reduced equation, of degree {}",
            2 * n + 2,
            d.degree
        ));
    }
    if f.star_shaped() {
        notes.push(
            "r > 0 for every angle: certified, (1+s^2)^N r(2 atan s) has no real root s".into(),
        );
    } else {
        notes.push(format!("r > 0 for {}", ranges_text(positive)));
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
    if !f.star_shaped() && !f.perfect_square && f.has_negative_radius() {
        notes.push("where r(t) < 0 the reflected arc belongs to F = 0: the points at distance |r(t)| in the direction t + pi".into());
    }
    notes
}

fn write_text(
    d: &DescriptionDocument,
    topology: Option<&CurveTopology>,
    digits: u32,
    out: &mut dyn Write,
) -> Result<()> {
    let yes_no = |b: bool| if b { "yes" } else { "no" };
    let degrees: Vec<String> = d
        .homogeneous_degrees
        .iter()
        .map(ToString::to_string)
        .collect();
    if let Some(center) = &d.center_line {
        writeln!(out, "{center}")?;
    }
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
    let irreducible = d.irreducible.map_or("not decided", yes_no);
    writeln!(out, "irreducible over Q: {irreducible}")?;
    let genera = topology.map_or(&[][..], |found| &found.genera);
    for (index, factor) in d.factors.iter().flatten().enumerate() {
        if d.irreducible == Some(true) {
            writeln!(out, "proof: {}", factor.proof)?;
        } else {
            let text = factor.short_text();
            let genus = genera.get(index);
            let genus = genus.map_or_else(String::new, |g| format!(", genus {}", genus_text(*g)));
            writeln!(
                out,
                "factor: {text}, multiplicity {}{genus} ({})",
                factor.multiplicity, factor.proof
            )?;
        }
    }
    if let Some(found) = topology {
        let only = if d.irreducible == Some(true) {
            genera
        } else {
            &[]
        };
        write_topology(found.topology.as_ref(), only, digits, out)?;
    }
    for note in &d.notes {
        writeln!(out, "note: {note}")?;
    }
    Ok(())
}
