//! Fourier radii in every format that has trigonometric functions.

use std::io::Write;

use super::json::Number;
use super::{Format, Kind, SCHEMA, center_comment};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::fit::FitReport;
use crate::notation::Notation;
use crate::shape::FourierRadius;

/// The fields of a document about the fit, as JSON.
fn fields(report: &FitReport) -> [(&'static str, String); 5] {
    let number = |value: f64| {
        let text = serde_json::to_string(&Number(value));
        text.invariant("a number is written as JSON")
    };
    [
        ("max_radial_error", number(report.max_radial_error)),
        ("rms_radial_error", number(report.rms_radial_error)),
        ("star_shaped", report.star_shaped.to_string()),
        ("samples", report.samples.to_string()),
        ("hidden_share", number(report.hidden_share)),
    ]
}

/// Writes `r = a0 + Σ (a_n cos nθ + b_n sin nθ)`, with the center if it is not the origin, and with the deviations of the fit
/// if the radius was fitted.
///
/// ```
/// use stellate::document::{Format, write_fourier};
/// use stellate::language::{Numbers, parse_form};
/// use stellate::shape::Form;
///
/// let form = parse_form("r = 1 + 0.2cos(3t) - sin(5t)/10", "<form>", Numbers::Exact)?;
/// let Form::Fourier(radius) = form else { panic!("a radius") };
/// let mut out = Vec::new();
/// write_fourier(&radius, None, Format::Text, &mut out).unwrap();
/// assert_eq!(out, b"r = 1 + 1/5*cos(3*t) - 1/10*sin(5*t)\n");
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub fn write_fourier(
    radius: &FourierRadius,
    fit: Option<&FitReport>,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    Kind::Radius.check(format)?;
    if format == Format::Json {
        return write_json(radius, fit, out);
    }
    let fit = fit.map(fields).into_iter().flatten();
    let fit = fit.map(|(name, value)| format!("{name}: {value}"));
    let comments: Vec<String> = center_comment(radius.center())
        .into_iter()
        .chain(fit)
        .map(|comment| format!("{} {comment}", format.comment()))
        .collect();
    if format == Format::Sympy {
        // SymPy joins all lines, so its comments come last.
        write!(out, "{}", expression(radius, format, "theta"))?;
        for (i, comment) in comments.iter().enumerate() {
            let separator = if i == 0 { "  " } else { "\n" };
            write!(out, "{separator}{comment}")?;
        }
        return Ok(writeln!(out)?);
    }
    for comment in &comments {
        writeln!(out, "{comment}")?;
    }
    match format {
        Format::Csv => {
            writeln!(out, "n,cos,sin")?;
            for (n, (a, b)) in radius.cosines().iter().zip(radius.sines()).enumerate() {
                writeln!(out, "{n},{a},{b}")?;
            }
            Ok(())
        }
        Format::Maple => Ok(writeln!(
            out,
            "r = {};",
            expression(radius, format, "theta")
        )?),
        _ => Ok(writeln!(out, "r = {}", expression(radius, format, "t"))?),
    }
}

/// The right side of `r = …` in the given format, where `angle` is the name of the angle.
pub(super) fn expression(radius: &FourierRadius, format: Format, angle: &str) -> String {
    let mut text = Vec::new();
    let written = match format {
        Format::Sympy => {
            Notation::Python.write_sum(harmonics(radius, |f, n| call(f, n, angle)), &mut text)
        }
        Format::Latex => Notation::LatexInline.write_sum(harmonics(radius, latex_call), &mut text),
        Format::Maple => {
            Notation::Explicit.write_sum(harmonics(radius, |f, n| call(f, n, angle)), &mut text)
        }
        _ => Notation::Explicit.write_sum(harmonics(radius, |f, n| call(f, n, angle)), &mut text),
    };
    debug_assert!(written.is_ok(), "writing into memory succeeds");
    String::from_utf8_lossy(&text).into_owned()
}

/// The non-zero terms; `call(name, n)` writes the function of a term.
fn harmonics<'a>(
    radius: &'a FourierRadius,
    call: impl Fn(&str, usize) -> String + 'a,
) -> impl Iterator<Item = (Rational, String)> + 'a {
    let pairs = radius.cosines().iter().zip(radius.sines()).enumerate();
    pairs
        .flat_map(move |(n, (a, b))| {
            let cos = if n == 0 {
                String::new()
            } else {
                call("cos", n)
            };
            [(a.clone(), cos), (b.clone(), call("sin", n))]
        })
        .filter(|(c, _)| !c.is_zero())
}

fn call(function: &str, n: usize, angle: &str) -> String {
    if n == 1 {
        format!("{function}({angle})")
    } else {
        format!("{function}({n}*{angle})")
    }
}

fn latex_call(function: &str, n: usize) -> String {
    if n == 1 {
        format!("\\{function} \\theta")
    } else {
        format!("\\{function} {n}\\theta")
    }
}

fn write_json(radius: &FourierRadius, fit: Option<&FitReport>, out: &mut dyn Write) -> Result<()> {
    write!(out, "{{\"schema\":\"{SCHEMA}\",\"kind\":\"fourier\"")?;
    for (name, values) in [("cos", radius.cosines()), ("sin", radius.sines())] {
        write!(out, ",\"{name}\":[")?;
        for (n, value) in values.iter().enumerate() {
            let separator = if n > 0 { "," } else { "" };
            write!(out, "{separator}\"{value}\"")?;
        }
        write!(out, "]")?;
    }
    let [x, y] = radius.center();
    if fit.is_some() || center_comment(radius.center()).is_some() {
        write!(out, ",\"center\":[\"{x}\",\"{y}\"]")?;
    }
    for (name, value) in fit.map(fields).into_iter().flatten() {
        write!(out, ",\"{name}\":{value}")?;
    }
    Ok(writeln!(out, "}}")?)
}
