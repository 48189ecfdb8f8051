//! Elliptic Fourier series in every format that has trigonometric functions, and as a table.

use std::io::Write;

use super::fit_report::{report_comments, report_fields};
use super::fourier::{expression, with_comments, write_fourier, write_numbers};
use super::{Format, Kind, SCHEMA};
use crate::error::Result;
use crate::shape::{EllipticSeries, FourierRadius};
use crate::verb::{FitReport, OutlineFit, OutlineSeries};

/// The names of the lists of coefficients, in the order of [`EllipticSeries::lists`].
const LISTS: [&str; 4] = ["x_cos", "x_sin", "y_cos", "y_sin"];

/// Writes the series that was fitted to an outline, with what is reported of the fit.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub fn write_fit(fit: &OutlineFit, format: Format, out: &mut dyn Write) -> Result<()> {
    match &fit.series {
        OutlineSeries::Radius(found) => {
            write_fourier(&found.radius, Some(&fit.report), format, out)
        }
        OutlineSeries::Elliptic(found) => {
            write_elliptic(&found.series, Some(&fit.report), format, out)
        }
    }
}

/// Writes `x = a0 + Σ (a_n cos nt + b_n sin nt); y = …`, with what is reported of the fit if the series was fitted. JSON is a document
/// of kind `parametric` with the lists of coefficients in `elliptic`; CSV is a table `n,x_cos,x_sin,y_cos,y_sin`. Text, JSON, CSV
/// and SymPy can be read back.
///
/// ```
/// use stellate::document::{Format, write_elliptic};
/// use stellate::exact::Rational;
/// use stellate::shape::EllipticSeries;
///
/// let q = |v: &[i64]| v.iter().map(|&c| Rational::from(c)).collect::<Vec<_>>();
/// let ellipse = EllipticSeries::new([q(&[5, 3]), q(&[]), q(&[]), q(&[0, 2])]);
/// let mut out = Vec::new();
/// write_elliptic(&ellipse, None, Format::Text, &mut out)?;
/// assert_eq!(out, b"x = 5 + 3*cos(t)\ny = 2*sin(t)\n");
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub fn write_elliptic(
    series: &EllipticSeries,
    fit: Option<&FitReport>,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    Kind::EllipticSeries.check(format)?;
    if format == Format::Json {
        return write_json(series, fit, out);
    }
    let comments: Vec<String> = fit.map(report_comments).into_iter().flatten().collect();
    with_comments(&comments, format, out, |out| {
        write_formulas(series, format, out)
    })
}

/// The right sides of x = … and y = ….
fn formulas(series: &EllipticSeries, format: Format) -> [String; 2] {
    let [a, b, c, d] = series.lists();
    [[a, b], [c, d]].map(|[cos, sin]| {
        // A coordinate is a series as a radius is.
        let coordinate = FourierRadius::new(cos.clone(), sin.clone());
        expression(&coordinate, format, "t")
    })
}

fn write_formulas(series: &EllipticSeries, format: Format, out: &mut dyn Write) -> Result<()> {
    if format == Format::Csv {
        writeln!(out, "n,{}", LISTS.join(","))?;
        for n in 0..=series.harmonics() {
            let row = series.lists().each_ref().map(|list| list[n].to_string());
            writeln!(out, "{n},{}", row.join(","))?;
        }
        return Ok(());
    }
    let [x, y] = formulas(series, format);
    match format {
        Format::Sympy => writeln!(out, "({x}, {y})")?,
        Format::Maple => writeln!(out, "x := {x};\ny := {y};")?,
        // The angle of formulas in LaTeX is θ.
        Format::Latex => writeln!(out, "x = {x} \\\\\ny = {y} \\\\")?,
        _ => writeln!(out, "x = {x}\ny = {y}")?,
    }
    Ok(())
}

fn write_json(series: &EllipticSeries, fit: Option<&FitReport>, out: &mut dyn Write) -> Result<()> {
    let [x, y] = formulas(series, Format::Text);
    write!(
        out,
        "{{\"schema\":\"{SCHEMA}\",\"kind\":\"parametric\",\"parameters\":[\"t\"],\"coordinates\":{{\"x\":\"{x}\",\"y\":\"{y}\"}},\"elliptic\":{{"
    )?;
    for (i, (name, list)) in LISTS.iter().zip(series.lists()).enumerate() {
        let separator = if i > 0 { "," } else { "" };
        write!(out, "{separator}\"{name}\":")?;
        write_numbers(list, out)?;
    }
    write!(out, "}}")?;
    for (name, value) in fit.map(report_fields).into_iter().flatten() {
        write!(out, ",\"{name}\":{value}")?;
    }
    Ok(writeln!(out, "}}")?)
}
