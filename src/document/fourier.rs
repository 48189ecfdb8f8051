//! Fourier radii in every format that has trigonometric functions.

use std::io::Write;

use super::fit_report::{report_comments, report_fields};
use super::{Format, Kind, SCHEMA, center_comment};
use crate::error::Result;
use crate::exact::Rational;
use crate::notation::Notation;
use crate::reading::PARAMETRIZES;
use crate::shape::FourierRadius;
use crate::verb::FitReport;

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
    let center = center_comment(radius.center()).into_iter();
    let report = fit.map(report_comments).into_iter().flatten();
    let mut comments: Vec<String> = center.chain(report).collect();
    if format == Format::Sympy && radius.harmonics() == 0 {
        // A number alone is no radius.
        comments.push(format!("{PARAMETRIZES} r = {}", radius.cos(0)));
    }
    with_comments(&comments, format, out, |out| {
        write_formula(radius, format, out)
    })
}

/// Writes comments and what `write` writes: SymPy joins all lines, so its comments come last.
pub(super) fn with_comments(
    comments: &[String],
    format: Format,
    out: &mut dyn Write,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<()> {
    let marked = comments
        .iter()
        .map(|comment| format!("{} {comment}", format.comment()));
    if format != Format::Sympy {
        for comment in marked {
            writeln!(out, "{comment}")?;
        }
        return write(out);
    }
    let mut text = Vec::new();
    write(&mut text)?;
    out.write_all(text.trim_ascii_end())?;
    for (i, comment) in marked.enumerate() {
        let separator = if i == 0 { "  " } else { "\n" };
        write!(out, "{separator}{comment}")?;
    }
    Ok(writeln!(out)?)
}

fn write_formula(radius: &FourierRadius, format: Format, out: &mut dyn Write) -> Result<()> {
    match format {
        Format::Sympy => Ok(writeln!(out, "{}", expression(radius, format, "theta"))?),
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
        write!(out, ",\"{name}\":")?;
        write_numbers(values, out)?;
    }
    let [x, y] = radius.center();
    if fit.is_some() || center_comment(radius.center()).is_some() {
        write!(out, ",\"center\":[\"{x}\",\"{y}\"]")?;
    }
    for (name, value) in fit.map(report_fields).into_iter().flatten() {
        write!(out, ",\"{name}\":{value}")?;
    }
    Ok(writeln!(out, "}}")?)
}

/// Writes exact numbers as an array of JSON strings.
pub(super) fn write_numbers(values: &[Rational], out: &mut dyn Write) -> Result<()> {
    write!(out, "[")?;
    for (n, value) in values.iter().enumerate() {
        let separator = if n > 0 { "," } else { "" };
        write!(out, "{separator}\"{value}\"")?;
    }
    Ok(write!(out, "]")?)
}
