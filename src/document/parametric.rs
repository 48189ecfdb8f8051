//! Parametric documents: the branches r(θ) of an implicit curve.

use std::io::Write;

use serde::Serialize;

use super::angles::{
    Angle, Fourier, PlaneFormulas, Range, angle, coordinates, fourier, ranges, ranges_text,
};
use super::expression::expression_text;
use super::fourier::expression;
use super::json::write_value;
use super::numeric::{
    EquationEntry, FitEntry, RootEntry, equation_entry, equations, fit_comments, fit_entry,
    root_entries, roots_text,
};
use super::rational::{self, Entry};
use super::source::{SourceField, source_field, write_radii, write_source};
use super::{Format, Kind, SCHEMA, center_comment};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::parametrize::{
    Branch, BranchFit, BranchRadius, Parametrization, PolarMethod, is_full_circle,
};
use crate::shape::{Form, FourierRadius};

#[derive(Serialize)]
struct ParametrizationDocument {
    schema: &'static str,
    kind: &'static str,
    parameters: [&'static str; 1],
    method: String,
    step: usize,
    lines: Vec<Angle>,
    #[serde(skip_serializing_if = "Option::is_none")]
    center: Option<[String; 2]>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    equations: Vec<EquationEntry>,
    branches: Vec<BranchEntry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fit: Option<FitEntry>,
    rational: Vec<Entry>,
    notes: Vec<String>,
    #[serde(flatten)]
    of: SourceField,
}

#[derive(Serialize)]
struct BranchEntry {
    factor: usize,
    radius: String,
    /// Whether the formulas are those of a fit; the fit has its error.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    approximate: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    latex: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sympy: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    coordinates: Option<PlaneFormulas>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fourier: Option<Fourier>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    roots: Vec<RootEntry>,
    ranges: Vec<Range>,
    positive: Vec<Range>,
    /// `everywhere` if the formula is real only in the ranges; `ranges` if it may be real elsewhere, where it is the root of
    /// another branch or no root.
    valid: &'static str,
}

/// Writes the polar form of a curve: expressions for r, x and y of every branch, the ranges in which r is real and in which it
/// is positive, to `digits` decimals, the lines through the origin, and the exact Fourier coefficients if a radius is a series.
///
/// In LaTeX, SymPy and Maple comments after the formulas say where they hold, unless that is everywhere.
///
/// Text begins with comments. The first branch is a formula `r = …`, which can be read back if it is a series.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(crate) fn write_parametrization(
    curve: &Parametrization,
    fit: Option<&BranchFit>,
    digits: u32,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    let source = source(curve, fit);
    match (format, series(curve).filter(|_| source.is_none())) {
        (Format::Json, _) => {
            write_value(&document(curve, fit, digits)?, out)?;
            Ok(writeln!(out)?)
        }
        (Format::Text, _) => write_text(curve, fit, digits, out),
        // The other branch of a series, −r(θ + π), has the same points.
        (_, Some(radius)) => super::write_fourier(radius, None, format, out),
        (Format::Latex | Format::Sympy | Format::Maple, None) => {
            let closed = curve
                .branches
                .iter()
                .filter_map(|b| radius_text(&b.radius, format));
            let fitted = fit.map(|fit| expression(&fit.radius, format, "theta"));
            let all: Vec<String> = closed.chain(fitted).collect();
            if all.is_empty() {
                return Err(Error::Usage(
                    "there is no formula for r; --format text or json describes the branches"
                        .into(),
                ));
            }
            write_radii("r", &all, format, out)?;
            let has_formula = |(_, b): &(usize, &Branch)| radius_text(&b.radius, format).is_some();
            let branches = || curve.branches.iter().enumerate().filter(has_formula);
            let mut comments = Vec::new();
            if !branches().all(|(_, branch)| is_full_circle(&branch.real)) {
                let all = branches().map(|(index, branch)| branch_comment(index, branch, digits));
                comments.extend(all);
            }
            comments.extend(
                fit.map(|fit| fit_comments(fit, digits))
                    .into_iter()
                    .flatten(),
            );
            // A formula in LaTeX cannot be read back, but its reader wants to know where r begins.
            comments.extend(center_comment(&curve.center).filter(|_| format == Format::Latex));
            for comment in comments {
                writeln!(out, "{} {comment}", format.comment())?;
            }
            write_source(source, format, out)?;
            write_rational(curve, format, out)
        }
        (Format::Csv, None) if curve.method == PolarMethod::Numeric && fit.is_some() => fit
            .map_or(Ok(()), |fit| {
                super::write_fourier(&fit.radius, None, format, out)
            }),
        (Format::Csv | Format::Singular, None) => Err(Kind::ClosedForms.refused(format)),
    }
}

fn document(
    curve: &Parametrization,
    fit: Option<&BranchFit>,
    digits: u32,
) -> Result<ParametrizationDocument> {
    Ok(ParametrizationDocument {
        schema: SCHEMA,
        kind: "parametric",
        parameters: ["theta"],
        method: method(curve),
        step: curve.step,
        lines: curve.lines.iter().map(|line| angle(line, digits)).collect(),
        center: center_comment(&curve.center)
            .map(|_| curve.center.each_ref().map(ToString::to_string)),
        equations: equations(curve)
            .map(|(factor, root)| equation_entry(factor, root, digits))
            .collect(),
        fit: fit.map(|fit| fit_entry(fit, digits)),
        branches: curve
            .branches
            .iter()
            .enumerate()
            .map(|(index, b)| {
                let fit = fit.filter(|fit| fit.branch == Some(index));
                entry(b, fit, &curve.center, digits)
            })
            .collect(),
        rational: curve
            .rational
            .iter()
            .map(|r| Entry::new(r, &curve.center))
            .collect(),
        notes: curve.notes.clone(),
        of: source_field(source(curve, fit))?,
    })
}

/// The form of which the document is the polar form. It is `None` if the document can be read back without it: from a Fourier
/// series that is the whole curve, or from the fit of the only factor without a closed form (Lemma 6).
fn source<'a>(curve: &'a Parametrization, fit: Option<&BranchFit>) -> Option<&'a Form> {
    let one_factor = curve.method != PolarMethod::Factors && curve.lines.is_empty();
    let is_said = one_factor && (series(curve).is_some() || fit.is_some());
    (!is_said).then_some(&curve.of)
}

/// The radius of the first branch, if it is a Fourier series.
fn series(curve: &Parametrization) -> Option<&FourierRadius> {
    match &curve.branches.first()?.radius {
        BranchRadius::Fourier(radius) => Some(radius),
        BranchRadius::Closed(_) | BranchRadius::Root(_) => None,
    }
}

fn method(curve: &Parametrization) -> String {
    match curve.method {
        PolarMethod::Lines => "lines".into(),
        PolarMethod::Lemma(n) => format!("lemma-{n}"),
        PolarMethod::Factors => "factors".into(),
        PolarMethod::Numeric => "lemma-6".into(),
    }
}

fn write_text(
    curve: &Parametrization,
    fit: Option<&BranchFit>,
    digits: u32,
    out: &mut dyn Write,
) -> Result<()> {
    let step = if curve.step > 1 {
        format!(" in r^{}", curve.step)
    } else {
        String::new()
    };
    writeln!(out, "# {}{step}", method(curve))?;
    if let Some(comment) = center_comment(&curve.center) {
        writeln!(out, "# {comment}")?;
    }
    write_source(source(curve, fit), Format::Text, out)?;
    for line in &curve.lines {
        let line = angle(line, digits);
        writeln!(
            out,
            "# the line at theta = {} = {} belongs to the curve",
            line.exact, line.theta
        )?;
    }
    for note in &curve.notes {
        writeln!(out, "# note: {note}")?;
    }
    for (factor, root) in equations(curve) {
        for comment in equation_entry(factor, root, digits).comments() {
            writeln!(out, "# {comment}")?;
        }
    }
    let mut formulas = 0;
    for (index, branch) in curve.branches.iter().enumerate() {
        writeln!(out, "# {}", branch_comment(index, branch, digits))?;
        match radius_text(&branch.radius, Format::Text) {
            Some(radius) => {
                let hidden = if formulas > 0 { "# " } else { "" };
                formulas += 1;
                writeln!(out, "{hidden}r = {radius}")?;
            }
            None => writeln!(out, "#   {}", roots_text(&branch.radius, digits))?,
        }
    }
    if let Some(fit) = fit {
        for comment in fit_comments(fit, digits) {
            writeln!(out, "# {comment}")?;
        }
        let hidden = if formulas > 0 { "# " } else { "" };
        writeln!(
            out,
            "{hidden}r = {}",
            expression(&fit.radius, Format::Text, "theta")
        )?;
    }
    write_rational(curve, Format::Text, out)
}

/// Where a branch is real and where r > 0, and whether its formula has other values elsewhere.
fn branch_comment(index: usize, branch: &Branch, digits: u32) -> String {
    let real = ranges_text(&ranges(&branch.real, digits));
    let positive = ranges_text(&ranges(&branch.positive, digits));
    let valid = match branch.radius {
        BranchRadius::Closed(_) if !branch.holds_where_real => "; the formula holds there only",
        _ => "",
    };
    format!("branch {index}: r real for {real}; r > 0 for {positive}{valid}")
}

/// The findings about rational parametrizations, as comments.
fn write_rational(curve: &Parametrization, format: Format, out: &mut dyn Write) -> Result<()> {
    let comments = curve
        .rational
        .iter()
        .filter_map(|r| rational::comment(r, &curve.center, format));
    for comment in comments {
        writeln!(out, "{} {comment}", format.comment())?;
    }
    Ok(())
}

/// The formula of a radius; `None` if it has none.
fn radius_text(radius: &BranchRadius, format: Format) -> Option<String> {
    match radius {
        BranchRadius::Fourier(radius) => Some(expression(radius, format, "theta")),
        BranchRadius::Closed(closed) => Some(expression_text(closed, format)),
        BranchRadius::Root(_) => None,
    }
}

/// The entry of a branch. If a Fourier series is fitted to it, the formulas are those of the fit.
fn entry(
    branch: &Branch,
    fit: Option<&BranchFit>,
    center: &[Rational; 2],
    digits: u32,
) -> BranchEntry {
    let formula = |format| {
        let fitted = || fit.map(|fit| expression(&fit.radius, format, "theta"));
        radius_text(&branch.radius, format).or_else(fitted)
    };
    let sympy = formula(Format::Sympy);
    BranchEntry {
        factor: branch.factor,
        radius: formula(Format::Text).unwrap_or_else(|| roots_text(&branch.radius, digits)),
        latex: formula(Format::Latex),
        approximate: fit.is_some(),
        coordinates: sympy.as_ref().map(|sympy| coordinates(sympy, center)),
        sympy,
        fourier: match &branch.radius {
            BranchRadius::Fourier(radius) => Some(fourier(radius)),
            BranchRadius::Closed(_) | BranchRadius::Root(_) => None,
        },
        roots: match &branch.radius {
            BranchRadius::Root(root) => root_entries(root, digits),
            _ => Vec::new(),
        },
        ranges: ranges(&branch.real, digits),
        positive: ranges(&branch.positive, digits),
        valid: validity(branch.holds_where_real),
    }
}

/// The field `valid` of a branch.
pub(super) fn validity(holds_where_real: bool) -> &'static str {
    if holds_where_real {
        "everywhere"
    } else {
        "ranges"
    }
}
