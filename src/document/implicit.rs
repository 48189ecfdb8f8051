//! Implicit curves and surfaces in every format.

use std::io::Write;

use super::facts::Annotations;
use super::json::write_value;
use super::{Format, SCHEMA, center_comment};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::notation::{Notation, Number, append_word, write_in_order};
use crate::shape::{ImplicitCurve, ImplicitSurface};
use crate::verb::Fact;

/// Writes `f(x, y) = 0` with its terms in canonical order, and the center if it is not the origin.
///
/// Cost: linear in the size of the output, except for the conversion of the coefficients to decimal, which is done in parallel.
/// Some megabytes of text are in memory at a time.
///
/// ```
/// use stellate::document::{Format, write_implicit};
/// use stellate::language::{Numbers, parse_form};
/// use stellate::shape::Form;
///
/// let form = parse_form("y^2 = x^2/3 - x^4", "<form>", Numbers::Exact)?;
/// let Form::Curve(curve) = form else { panic!("a polynomial in x and y") };
/// let write = |format| {
///     let mut out = Vec::new();
///     write_implicit(&curve, &[], format, &mut out).unwrap();
///     String::from_utf8(out).unwrap()
/// };
/// assert_eq!(write(Format::Text), "x^4 - 1/3x^2 + y^2 = 0\n");
/// assert_eq!(write(Format::Sympy), "x**4 - Rational(1, 3)*x**2 + y**2\n");
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of `out`.
pub fn write_implicit(
    curve: &ImplicitCurve,
    facts: &[Fact],
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let f = curve.polynomial();
    let exponent = |e: usize| u32::try_from(e).invariant("a degree is below 2^32");
    let terms = f.integer_terms().map(|((i, j), c)| {
        let coefficient = match f.denominator() {
            d if *d == 1 => Number::from(c),
            d => Number::from(Rational::whole(c) / Rational::whole(d)),
        };
        ([exponent(i), exponent(j), 0], coefficient)
    });
    let degrees: Vec<u64> = f.homogeneous_degrees().iter().map(|&d| d as u64).collect();
    Implicit {
        variables: &["x", "y"],
        terms,
        center: &curve.center()[..],
        z_is_missing: false,
        annotations: &facts.into(),
    }
    .write(&degrees, format, out)
}

/// Writes `f(x, y, z) = 0` with its terms in canonical order, and the center if it is not the origin.
///
/// If z does not occur in f, formulas end with the term 0z, which shows that the form is a surface.
///
/// # Errors
/// Those of `out`.
pub(crate) fn write_surface(
    surface: &ImplicitSurface,
    facts: &[Fact],
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let f = surface.polynomial();
    let degree = |e: &[u32; 3]| e.iter().map(|&k| u64::from(k)).sum::<u64>();
    let mut degrees: Vec<u64> = f.terms().map(|(e, _)| degree(e)).collect();
    degrees.dedup();
    Implicit {
        variables: &["x", "y", "z"],
        terms: f.terms().map(|(e, c)| (*e, Number::from(c))),
        center: &surface.center()[..],
        z_is_missing: f.terms().all(|(e, _)| e[2] == 0),
        annotations: &facts.into(),
    }
    .write(&degrees, format, out)
}

/// The common parts of curves and surfaces.
struct Implicit<'a, T> {
    variables: &'a [&'a str],
    terms: T,
    /// The point that coordinates are relative to; if all are 0, it is not written.
    center: &'a [Rational],
    z_is_missing: bool,
    annotations: &'a Annotations,
}

impl<'a, T: Iterator<Item = ([u32; 3], Number<'a>)>> Implicit<'a, T> {
    fn write(self, degrees: &[u64], format: Format, out: &mut dyn Write) -> Result<()> {
        match format {
            Format::Json => return self.write_json(degrees, out),
            // SymPy joins all lines, so its comments come last.
            Format::Sympy => {}
            _ => self.write_comments("\n", format, out)?,
        }
        match format {
            Format::Csv => self.write_csv(out),
            Format::Text => self.write_formula(Notation::Text, ["", " = 0\n"], out),
            Format::Latex => self.write_formula(Notation::Latex, ["", " = 0\n"], out),
            Format::Maple => self.write_formula(Notation::Explicit, ["", " = 0;\n"], out),
            Format::Singular => {
                let ring = format!(
                    "ring R = 0, ({}), dp;\npoly F = ",
                    self.variables.join(", ")
                );
                self.write_formula(Notation::Explicit, [&ring, ";\n"], out)
            }
            Format::Sympy | Format::Json => {
                let mut comments = Vec::new();
                self.write_comments("", format, &mut comments)?;
                self.write_formula(Notation::Python, ["", ""], out)?;
                if !comments.is_empty() {
                    out.write_all(b"  ")?;
                    out.write_all(&comments)?;
                }
                Ok(out.write_all(b"\n")?)
            }
        }
    }

    /// The center and the notes; every line begins as a comment.
    fn write_comments(&self, end: &str, format: Format, out: &mut dyn Write) -> Result<()> {
        let notes = self.annotations.notes.iter().flat_map(|note| note.lines());
        let notes = notes.map(|line| format!("note: {line}"));
        for (i, comment) in center_comment(self.center)
            .into_iter()
            .chain(notes)
            .enumerate()
        {
            if i > 0 && end.is_empty() {
                out.write_all(b"\n")?;
            }
            write!(out, "{} {comment}{end}", format.comment())?;
        }
        Ok(())
    }

    fn write_formula(
        self,
        notation: Notation,
        [before, after]: [&str; 2],
        out: &mut dyn Write,
    ) -> Result<()> {
        out.write_all(before.as_bytes())?;
        notation.write_sum(self.terms.map(|(e, c)| (c, e)), out)?;
        if self.z_is_missing {
            out.write_all(match notation {
                Notation::Text => b" + 0z",
                Notation::Explicit | Notation::Python => b" + 0*z",
                Notation::Latex | Notation::LatexInline => b" + 0 z",
            })?;
        }
        Ok(out.write_all(after.as_bytes())?)
    }

    fn write_csv(self, out: &mut dyn Write) -> Result<()> {
        let in_space = self.variables.len() == 3;
        let header = if in_space {
            "i,j,k,coefficient"
        } else {
            "i,j,coefficient"
        };
        writeln!(out, "{header}")?;
        let append = |(exponents, c): &([u32; 3], Number<'a>), text: &mut Vec<u8>| {
            for exponent in &exponents[..self.variables.len()] {
                append_word(*exponent, text);
                text.push(b',');
            }
            c.append(text);
            text.push(b'\n');
        };
        Ok(write_in_order(self.terms, |(_, c)| c.size(), append, out)?)
    }

    fn write_json(self, degrees: &[u64], out: &mut dyn Write) -> Result<()> {
        write!(
            out,
            "{{\"schema\":\"{SCHEMA}\",\"kind\":\"implicit\",\"variables\":"
        )?;
        write_value(self.variables, out)?;
        write!(out, ",\"degree\":")?;
        write_value(&degrees.first(), out)?;
        write!(out, ",\"homogeneous_degrees\":")?;
        write_value(degrees, out)?;
        if center_comment(self.center).is_some() {
            let center: Vec<String> = self.center.iter().map(Rational::to_string).collect();
            write!(out, ",\"center\":")?;
            write_value(&center, out)?;
        }
        if !self.annotations.notes.is_empty() {
            write!(out, ",\"notes\":")?;
            write_value(&self.annotations.notes, out)?;
        }
        for (name, value) in &self.annotations.fields {
            write!(out, ",\"{name}\":")?;
            write_value(value, out)?;
        }
        write!(out, ",\"terms\":[")?;
        type Term<'a> = (usize, ([u32; 3], Number<'a>));
        let append = |(n, (exponents, c)): &Term<'a>, text: &mut Vec<u8>| {
            let before: &[u8] = if *n > 0 { b"," } else { b"" };
            text.extend_from_slice(before);
            text.extend_from_slice(b"\n{\"exponents\":");
            for (exponent, before) in exponents[..self.variables.len()].iter().zip(b"[,,") {
                text.push(*before);
                append_word(*exponent, text);
            }
            text.extend_from_slice(b"],\"coefficient\":\"");
            c.append(text);
            text.extend_from_slice(b"\"}");
        };
        write_in_order(self.terms.enumerate(), |(_, (_, c))| c.size(), append, out)?;
        Ok(writeln!(out, "\n]}}")?)
    }
}
