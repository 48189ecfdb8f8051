//! Harmonic surfaces: sums of spherical harmonics in every format that can name them, and as documents of kind `spherical`.

use std::io::Write;

use serde_json::{Map, Value, json};

use super::facts::Annotations;
use super::fourier::with_comments;
use super::json::write_value;
use super::remark::rounding_note;
use super::{Format, Kind, SCHEMA, center_line, write_lines};
use crate::describe::HarmonicDescription;
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::notation::Notation;
use crate::reading::PARAMETRIZES;
use crate::shape::HarmonicSurface;
use crate::sphere::Positivity;
use crate::verb::Fact;
#[cfg(feature = "meshes")]
use crate::verb::FittedMesh;

/// Writes `R = Σ c Y(l, m)`, with the center if it is not the origin, and with the bound of the radius if the coefficients were
/// rounded.
///
/// ```
/// use stellate::document::{Format, write_harmonic};
/// use stellate::language::{Numbers, parse_form};
/// use stellate::shape::Form;
///
/// let form = parse_form("R = 1 + cos(phi)^2 - 0.1*Y(3,-2)", "<form>", Numbers::Exact)?;
/// let Form::Harmonic(surface) = form else { panic!("a harmonic surface") };
/// let mut out = Vec::new();
/// write_harmonic(&surface, Format::Text, &mut out)?;
/// assert_eq!(out, b"R = 4/3 + 2/3*Y(2,0) - 1/10*Y(3,-2)\n");
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub fn write_harmonic(
    surface: &HarmonicSurface,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    Kind::Harmonics.check(format)?;
    if format == Format::Json {
        write_value(&document(surface), out)?;
        return Ok(writeln!(out)?);
    }
    let mut comments = comments(surface);
    if format == Format::Sympy {
        // The functions of SymPy cannot be read back.
        let text = expression(surface, Format::Text);
        comments.push(format!("{PARAMETRIZES} R = {text}"));
    }
    with_comments(&comments, format, out, |out| {
        if format == Format::Csv {
            writeln!(out, "l,m,value")?;
            for (l, m, c) in surface.terms() {
                writeln!(out, "{l},{m},{c}")?;
            }
            return Ok(());
        }
        let text = expression(surface, format);
        match format {
            Format::Sympy => Ok(writeln!(out, "{text}")?),
            _ => Ok(writeln!(out, "R = {text}")?),
        }
    })
}

/// Writes the surface of a fit to a mesh; as JSON with its errors, and with the center even if it is the origin.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
#[cfg(feature = "meshes")]
pub fn write_mesh_fit(found: &FittedMesh, format: Format, out: &mut dyn Write) -> Result<()> {
    let FittedMesh { fit, distance } = found;
    if format != Format::Json {
        return write_harmonic(&fit.surface, format, out);
    }
    let mut value = document(&fit.surface);
    if let Value::Object(fields) = &mut value {
        let center = fit.surface.center().each_ref().map(ToString::to_string);
        fields.insert("center".into(), json!(center));
        fields.insert("max_radial_error".into(), json!(fit.max_radial_error));
        fields.insert("rms_radial_error".into(), json!(fit.rms_radial_error));
        fields.insert("outline_star_shaped".into(), json!(fit.is_star_shaped));
        fields.insert("samples".into(), json!(fit.samples));
        if let Some(found) = distance {
            fields.insert(
                "distance".into(),
                json!({"low": found.low, "high": found.high}),
            );
        }
    }
    write_value(&value, out)?;
    Ok(writeln!(out)?)
}

/// The comments of a text: the center, and the bound of what was rounded.
fn comments(surface: &HarmonicSurface) -> Vec<String> {
    let [x, y, z] = surface.center();
    let center = (!surface.is_centered()).then(|| format!("center: {x}, {y}, {z}"));
    let bound = surface.rounding();
    let rounded = (!bound.is_zero()).then(|| rounding_note(bound));
    center.into_iter().chain(rounded).collect()
}

/// The document of kind `spherical`.
pub(super) fn document(surface: &HarmonicSurface) -> Value {
    let terms = surface.terms();
    let coefficients: Vec<Value> = terms
        .map(|(l, m, c)| json!({"l": l, "m": m, "value": c.to_string()}))
        .collect();
    let mut fields = Map::new();
    fields.insert("schema".into(), json!(SCHEMA));
    fields.insert("kind".into(), json!("spherical"));
    fields.insert("degree".into(), json!(surface.degree()));
    fields.insert("coefficients".into(), Value::Array(coefficients));
    if !surface.is_centered() {
        let center = surface.center().each_ref().map(ToString::to_string);
        fields.insert("center".into(), json!(center));
    }
    if !surface.rounding().is_zero() {
        let bound = surface.rounding().to_string();
        fields.insert("radius_rounding".into(), json!(bound));
    }
    Value::Object(fields)
}

/// Writes the exact properties of a harmonic surface.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(super) fn write_harmonic_description(
    d: &HarmonicDescription,
    facts: &[Fact],
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    Kind::Description.check(format)?;
    let mut notes = Annotations::from(facts).notes;
    notes.extend(description_notes(d));
    let positive = match d.positivity {
        Positivity::Positive { .. } => Some(true),
        Positivity::NotPositive { .. } => Some(false),
        Positivity::Unknown => None,
    };
    if format == Format::Json {
        let value = json!({
            "schema": SCHEMA,
            "kind": "description",
            "spherical": document(&d.surface),
            "degree": d.degree,
            "homogeneous_degrees": d.homogeneous_degrees,
            "terms": d.terms,
            "coefficient_bits": d.coefficient_bits,
            "method": "harmonics",
            "irreducible": true,
            "perfect_square": d.perfect_square,
            "star_shaped": positive,
            "notes": notes,
        });
        write_value(&value, out)?;
        return Ok(writeln!(out)?);
    }
    let degrees = d.homogeneous_degrees.iter().map(ToString::to_string);
    let degrees: Vec<String> = degrees.collect();
    let star_shaped = match positive {
        Some(true) => "yes",
        Some(false) => "no",
        None => "unknown",
    };
    if let Some(center) = center_line(d.surface.center()) {
        writeln!(out, "{center}")?;
    }
    writeln!(out, "harmonic degree: {}", d.surface.degree())?;
    writeln!(out, "degree: {}", d.degree)?;
    writeln!(out, "homogeneous degrees: {}", degrees.join(", "))?;
    writeln!(out, "terms: {}", d.terms)?;
    writeln!(out, "coefficient bits: {}", d.coefficient_bits)?;
    writeln!(out, "irreducible: yes")?;
    writeln!(out, "star-shaped: {star_shaped}")?;
    write_lines(notes.iter().map(|note| format!("note: {note}")), out)
}

fn description_notes(d: &HarmonicDescription) -> Vec<String> {
    let l = d.surface.degree();
    let mut notes = Vec::new();
    if d.perfect_square {
        notes.push(format!(
            "F has degree {} and is a perfect square, because all even harmonics are 0; this is its reduced equation, of degree {}",
            2 * l + 2,
            d.degree
        ));
    }
    notes.push(match &d.positivity {
        Positivity::Positive { low, high } if *low <= 0.0 || high.is_infinite() => {
            "R > 0 in every direction: certified; doubles do not hold the least radius".into()
        }
        Positivity::Positive { low, high } => {
            format!("R > 0 in every direction: certified, the least radius is between {low} and {high}")
        }
        Positivity::NotPositive { direction, value } => {
            let [u, v, w] = direction.each_ref().map(Rational::to_f64);
            let value = match value.to_f64() {
                _ if value.is_zero() => "0".to_owned(),
                value if value.is_infinite() => "below every double".to_owned(),
                value if value == 0.0 || (1e-4..1e15).contains(&value.abs()) => {
                    format!("{value:.6}")
                }
                value => format!("{value:e}"),
            };
            format!(
                "R is not positive everywhere: in an exact direction near ({u:.6}, {v:.6}, {w:.6}) it is {value}; where R < 0 the point is on the opposite side"
            )
        }
        Positivity::Unknown => {
            "whether R > 0 in every direction was not decided: its least value is too near 0".into()
        }
    });
    let star_shaped = matches!(d.positivity, Positivity::Positive { .. });
    if l > 0 && !d.perfect_square {
        notes.push(match star_shaped {
            true => format!(
                "besides the surface, F = 0 holds at the origin alone, an isolated real point of multiplicity {}",
                2 * l
            ),
            false => format!("the origin belongs to F = 0, with multiplicity {}", 2 * l),
        });
    }
    let bound = d.surface.rounding();
    notes.extend((!bound.is_zero()).then(|| rounding_note(bound)));
    notes
}

/// Writes the radii of a surface that are sums of harmonics; the first one is the form.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(super) fn write_harmonic_radii(
    radii: &[HarmonicSurface],
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let [first, others @ ..] = radii else {
        return Err(Error::internal(
            "parametrize",
            "a harmonic surface has a radius",
        ));
    };
    if format != Format::Json {
        write_harmonic(first, format, out)?;
        if format == Format::Text {
            for other in others {
                let text = expression(other, format);
                writeln!(
                    out,
                    "# the points with -R in the opposite direction: R = {text}"
                )?;
            }
        }
        return Ok(());
    }
    let branches: Vec<Value> = radii
        .iter()
        .map(|radius| {
            let sympy = expression(radius, Format::Sympy);
            json!({
                "factor": 0,
                "radius": expression(radius, Format::Text),
                "latex": expression(radius, Format::Latex),
                "coordinates": {
                    "x": format!("({sympy})*sin(phi)*cos(theta)"),
                    "y": format!("({sympy})*sin(phi)*sin(theta)"),
                    "z": format!("({sympy})*cos(phi)"),
                },
                "sympy": sympy,
                "spherical": document(radius),
                "valid": "everywhere",
            })
        })
        .collect();
    let value = json!({
        "schema": SCHEMA,
        "kind": "parametric",
        "parameters": ["theta", "phi"],
        "method": "harmonics",
        "step": 1,
        "lines": [],
        "branches": branches,
        "notes": [],
    });
    write_value(&value, out)?;
    Ok(writeln!(out)?)
}

/// The right side of `R = …`.
pub(super) fn expression(surface: &HarmonicSurface, format: Format) -> String {
    let notation = match format {
        Format::Sympy => Notation::Python,
        Format::Latex => Notation::LatexInline,
        _ => Notation::Explicit,
    };
    let terms = surface.terms().map(|(l, m, c)| {
        // SymPy's associated Legendre functions have the Condon–Shortley phase.
        let negative = format == Format::Sympy && m % 2 != 0;
        let c = if negative { -c } else { c.clone() };
        (c, harmonic(l, m, format))
    });
    let mut text = Vec::new();
    let written = notation.write_sum(terms, &mut text);
    written.invariant("writing into memory succeeds");
    String::from_utf8_lossy(&text).into_owned()
}

fn harmonic(l: usize, m: isize, format: Format) -> String {
    let order = m.unsigned_abs();
    let function = if m < 0 { "sin" } else { "cos" };
    match (format, l, order) {
        (Format::Sympy | Format::Latex, 0, _) => String::new(),
        (Format::Sympy, _, 0) => format!("legendre({l}, cos(phi))"),
        (Format::Sympy, ..) => {
            format!("assoc_legendre({l}, {order}, cos(phi))*{function}({order}*theta)")
        }
        (Format::Latex, _, 0) => format!("P_{{{l}}}(\\cos \\varphi)"),
        (Format::Latex, ..) => {
            format!("P_{{{l}}}^{{{order}}}(\\cos \\varphi)\\{function} {order}\\theta")
        }
        (_, 0, _) => String::new(),
        _ => format!("Y({l},{m})"),
    }
}
