//! Parametric documents: the branches r(θ) of an implicit curve.

use std::io::{self, Write};

use serde::Serialize;

use super::expression::{equation_text, expression_text};
use super::fourier::expression;
use super::{Format, SCHEMA, center_comment};
use crate::exact::Rational;
use crate::parametrize::{
    AngleRange, Branch, BranchFit, ExactAngle, Parametrization, PolarMethod, Radius, RootBranch,
    rounded_up,
};
use crate::poly::real_roots;
use crate::shape::FourierRadius;

#[derive(Serialize)]
struct Document {
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
    notes: Vec<String>,
}

/// The equation of the roots of a factor that has no closed form.
#[derive(Serialize)]
struct EquationEntry {
    factor: usize,
    text: String,
    latex: String,
    sympy: String,
    discriminant: DiscriminantEntry,
}

#[derive(Serialize)]
struct DiscriminantEntry {
    degree: usize,
    real_roots: Vec<String>,
}

/// On a range, which root a branch is: 1 for the largest.
#[derive(Serialize)]
struct RootEntry {
    root: usize,
    of: usize,
    from: String,
    to: String,
}

/// A Fourier radius near a branch without a closed form.
#[derive(Serialize)]
struct FitEntry {
    /// The index of the branch, or null for the outermost positive radius.
    branch: Option<usize>,
    radius: String,
    latex: String,
    sympy: String,
    coordinates: Coordinates,
    fourier: Fourier,
    harmonics: usize,
    samples: usize,
    max_error_at_samples: String,
    max_error_between_estimate: String,
    checks: usize,
    jumps: Vec<Angle>,
}

#[derive(Serialize)]
struct Angle {
    theta: String,
    exact: String,
}

#[derive(Serialize)]
struct BranchEntry {
    factor: usize,
    radius: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    latex: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sympy: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    coordinates: Option<Coordinates>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fourier: Option<Fourier>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    roots: Vec<RootEntry>,
    ranges: Vec<Range>,
    positive: Vec<Range>,
}

#[derive(Serialize)]
struct Coordinates {
    x: String,
    y: String,
}

#[derive(Serialize)]
struct Fourier {
    cos: Vec<String>,
    sin: Vec<String>,
}

#[derive(Serialize)]
pub(super) struct Range {
    from: String,
    to: String,
    closed: [bool; 2],
    exact_from: String,
    exact_to: String,
    #[serde(skip)]
    nice: [Option<String>; 2],
}

impl Range {
    pub(super) fn new(range: &AngleRange, digits: u32) -> Self {
        Self {
            from: range.from.to_decimal(digits),
            to: range.to.to_decimal(digits),
            closed: range.closed,
            exact_from: range.from.describe(),
            exact_to: range.to.describe(),
            nice: [range.from.closed_form(), range.to.closed_form()],
        }
    }

    /// `[0, pi/2)`, exact where the end has a closed form.
    pub(super) fn text(&self) -> String {
        let [from, to] = self.closed;
        let end = |nice: &Option<String>, decimal: &String| {
            nice.clone().unwrap_or_else(|| decimal.clone())
        };
        format!(
            "{}{}, {}{}",
            if from { '[' } else { '(' },
            end(&self.nice[0], &self.from),
            end(&self.nice[1], &self.to),
            if to { ']' } else { ')' }
        )
    }
}

/// Ranges as one phrase: `theta in [0, pi/2) and (3*pi/2, 2*pi]`, or `no angle`.
pub(super) fn ranges_text(ranges: &[Range]) -> String {
    if ranges.is_empty() {
        return "no angle".into();
    }
    let parts: Vec<String> = ranges.iter().map(Range::text).collect();
    format!("theta in {}", parts.join(" and "))
}

/// Writes the polar form of a curve: expressions for r, x and y of every branch, where r is real and
/// where it is positive to `digits` decimals, the lines through the origin, and exact Fourier coefficients
/// where a radius is a series.
///
/// Text starts with comments; the first branch is a formula `r = …`, which can be read back if it is a
/// series.
///
/// # Errors
/// Those of `out`; `Unsupported` for Singular, and for CSV unless the first radius is a series.
pub fn write_parametrization(
    curve: &Parametrization,
    fit: Option<&BranchFit>,
    digits: u32,
    format: Format,
    out: &mut dyn Write,
) -> io::Result<()> {
    let series = curve
        .branches
        .first()
        .and_then(|branch| match &branch.radius {
            Radius::Fourier(radius) => Some(radius),
            Radius::Closed(_) | Radius::Root(_) => None,
        });
    match (format, series) {
        (Format::Json, _) => {
            serde_json::to_writer(&mut *out, &document(curve, fit, digits))?;
            writeln!(out)
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
            for radius in &all {
                match format {
                    Format::Sympy => writeln!(out, "{radius}")?,
                    Format::Maple => writeln!(out, "r = {radius};")?,
                    _ => writeln!(out, "r = {radius}")?,
                }
            }
            if all.is_empty() {
                return Err(io::Error::new(
                    io::ErrorKind::Unsupported,
                    "there is no formula for r; --format text or json describes the branches",
                ));
            }
            Ok(())
        }
        (Format::Csv, None) if curve.method == PolarMethod::Numeric && fit.is_some() => fit
            .map_or(Ok(()), |fit| {
                super::write_fourier(&fit.radius, None, format, out)
            }),
        (Format::Csv | Format::Singular, None) => Err(io::Error::new(
            io::ErrorKind::Unsupported,
            "only a radius that is a Fourier series is written as csv",
        )),
    }
}

fn document(curve: &Parametrization, fit: Option<&BranchFit>, digits: u32) -> Document {
    Document {
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
            .map(|b| entry(b, &curve.center, digits))
            .collect(),
        notes: curve.notes.clone(),
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

fn angle(angle: &ExactAngle, digits: u32) -> Angle {
    Angle {
        theta: angle.to_decimal(digits),
        exact: angle.describe(),
    }
}

fn ranges(list: &[AngleRange], digits: u32) -> Vec<Range> {
    list.iter().map(|range| Range::new(range, digits)).collect()
}

fn write_text(
    curve: &Parametrization,
    fit: Option<&BranchFit>,
    digits: u32,
    out: &mut dyn Write,
) -> io::Result<()> {
    let step = if curve.step > 1 {
        format!(" in r^{}", curve.step)
    } else {
        String::new()
    };
    writeln!(out, "# {}{step}", method(curve))?;
    if let Some(comment) = center_comment(&curve.center) {
        writeln!(out, "# {comment}")?;
    }
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
        let entry = equation_entry(factor, root, digits);
        let zeros = match entry.discriminant.real_roots.len() {
            0 => "no real zero".into(),
            _ => format!("real zeros {}", entry.discriminant.real_roots.join(", ")),
        };
        writeln!(out, "# factor {factor}: {} = 0", entry.text)?;
        writeln!(
            out,
            "# its discriminant has degree {} in t = tan(theta), {zeros}",
            entry.discriminant.degree
        )?;
    }
    let mut formulas = 0;
    for (index, branch) in curve.branches.iter().enumerate() {
        let real = ranges_text(&ranges(&branch.real, digits));
        let positive = ranges_text(&ranges(&branch.positive, digits));
        writeln!(
            out,
            "# branch {index}: r real for {real}; r > 0 for {positive}"
        )?;
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
        let entry = fit_entry(fit, digits);
        let of = match fit.branch {
            Some(index) => format!("branch {index}"),
            None => "the outermost positive radius, of several branches".into(),
        };
        writeln!(
            out,
            "# Fourier fit of {of}: N = {}, {} samples; |error| <= {} at the samples (certified), ≈ {} between them (the largest at {} more directions)",
            entry.harmonics,
            entry.samples,
            entry.max_error_at_samples,
            entry.max_error_between_estimate,
            entry.checks
        )?;
        for jump in &entry.jumps {
            writeln!(
                out,
                "# at theta = {} it jumps from one branch to another",
                jump.theta
            )?;
        }
        let hidden = if formulas > 0 { "# " } else { "" };
        writeln!(out, "{hidden}r = {}", entry.radius)?;
    }
    Ok(())
}

/// The formula of a radius, if it has one.
fn radius_text(radius: &Radius, format: Format) -> Option<String> {
    match radius {
        Radius::Fourier(radius) => Some(expression(radius, format, "theta")),
        Radius::Closed(closed) => Some(expression_text(closed, format)),
        Radius::Root(_) => None,
    }
}

/// One root of each factor that has no closed form.
fn equations(curve: &Parametrization) -> impl Iterator<Item = (usize, &RootBranch)> {
    let mut last = None;
    curve
        .branches
        .iter()
        .filter_map(move |branch| match &branch.radius {
            Radius::Root(root) if last != Some(branch.factor) => {
                last = Some(branch.factor);
                Some((branch.factor, root))
            }
            _ => None,
        })
}

fn equation_entry(factor: usize, root: &RootBranch, digits: u32) -> EquationEntry {
    let (forms, step) = root.equation();
    let in_format = |format| equation_text(forms, step, format);
    let discriminant = root.discriminant();
    EquationEntry {
        factor,
        text: in_format(Format::Text),
        latex: in_format(Format::Latex),
        sympy: in_format(Format::Sympy),
        discriminant: DiscriminantEntry {
            degree: discriminant.coefficients_asc().len().saturating_sub(1),
            real_roots: real_roots(&discriminant)
                .iter()
                .map(|t| t.to_decimal(digits))
                .collect(),
        },
    }
}

fn root_entries(root: &RootBranch, digits: u32) -> Vec<RootEntry> {
    let arcs = root.arcs().into_iter();
    arcs.map(|arc| RootEntry {
        root: arc.rank + 1,
        of: arc.of,
        from: arc.range.from.to_decimal(digits),
        to: arc.range.to.to_decimal(digits),
    })
    .collect()
}

/// `root 1 of 3 for theta in (0, pi/2), …`
fn roots_text(radius: &Radius, digits: u32) -> String {
    let Radius::Root(root) = radius else {
        return String::new();
    };
    let arcs = root.arcs().into_iter().map(|arc| {
        let range = Range::new(&arc.range, digits).text();
        format!("root {} of {} for theta in {range}", arc.rank + 1, arc.of)
    });
    let text = arcs.collect::<Vec<_>>().join(", ");
    if text.is_empty() {
        "an isolated point".into()
    } else {
        format!("real r from the largest: {text}")
    }
}

fn fit_entry(fit: &BranchFit, digits: u32) -> FitEntry {
    let in_format = |format| expression(&fit.radius, format, "theta");
    let sympy = in_format(Format::Sympy);
    FitEntry {
        branch: fit.branch,
        radius: in_format(Format::Text),
        latex: in_format(Format::Latex),
        coordinates: coordinates(&sympy, fit.radius.center()),
        sympy,
        fourier: fourier(&fit.radius),
        harmonics: fit.radius.harmonics(),
        samples: fit.samples,
        max_error_at_samples: rounded_up(&fit.error_at_samples),
        max_error_between_estimate: rounded_up(&fit.error_between),
        checks: fit.checks,
        jumps: fit.jumps.iter().map(|jump| angle(jump, digits)).collect(),
    }
}

fn fourier(radius: &FourierRadius) -> Fourier {
    let strings = |v: &[Rational]| v.iter().map(ToString::to_string).collect();
    Fourier {
        cos: strings(radius.cosines()),
        sin: strings(radius.sines()),
    }
}

fn coordinates(sympy: &str, center: &[Rational; 2]) -> Coordinates {
    let [cx, cy] = center.each_ref().map(|c| {
        if c.is_zero() {
            String::new()
        } else {
            format!("Rational({}, {}) + ", c.numerator(), c.denominator())
        }
    });
    Coordinates {
        x: format!("{cx}({sympy})*cos(theta)"),
        y: format!("{cy}({sympy})*sin(theta)"),
    }
}

fn entry(branch: &Branch, center: &[Rational; 2], digits: u32) -> BranchEntry {
    let sympy = radius_text(&branch.radius, Format::Sympy);
    BranchEntry {
        factor: branch.factor,
        radius: radius_text(&branch.radius, Format::Text)
            .unwrap_or_else(|| roots_text(&branch.radius, digits)),
        latex: radius_text(&branch.radius, Format::Latex),
        coordinates: sympy.as_ref().map(|sympy| coordinates(sympy, center)),
        sympy,
        fourier: match &branch.radius {
            Radius::Fourier(radius) => Some(fourier(radius)),
            Radius::Closed(_) | Radius::Root(_) => None,
        },
        roots: match &branch.radius {
            Radius::Root(root) => root_entries(root, digits),
            _ => Vec::new(),
        },
        ranges: ranges(&branch.real, digits),
        positive: ranges(&branch.positive, digits),
    }
}
