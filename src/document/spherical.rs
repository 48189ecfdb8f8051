//! Parametric documents of surfaces: the branches R(θ, φ), and the certified answers on meridians and in directions.

use std::io::Write;

use serde::Serialize;

use super::angles::{Range, ranges, ranges_text_of, sympy_start};
use super::expression::{condition_text, expression_text, form_text};
use super::json::{Number, write_value};
use super::parametric::validity;
use super::source::{SourceField, source_field, write_radii, write_source};
use super::{Format, Kind, SCHEMA, center_comment};
use crate::error::{Error, Result};
use crate::parametrize::{SurfaceBranch, SurfaceMethod, SurfaceParametrization};
use crate::poly::SpacePolynomial;
use crate::sample::{Ray, UnitVector};
use crate::verb::{InDirection, OnMeridian};
use malachite::Integer;

#[derive(Serialize)]
struct SurfaceParametrizationDocument {
    schema: &'static str,
    kind: &'static str,
    parameters: [&'static str; 2],
    method: String,
    step: usize,
    lines: [String; 0],
    #[serde(skip_serializing_if = "Option::is_none")]
    center: Option<[String; 3]>,
    cones: Vec<FormEntry>,
    discriminants: Vec<FormEntry>,
    branches: Vec<BranchEntry>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    meridians: Vec<MeridianEntry>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    directions: Vec<DirectionEntry>,
    notes: Vec<String>,
    #[serde(flatten)]
    of: SourceField,
}

/// A form in (α, β, γ) = (sin φ cos θ, sin φ sin θ, cos φ).
#[derive(Serialize)]
struct FormEntry {
    factor: usize,
    degree: usize,
    terms: Vec<Term>,
}

#[derive(Serialize)]
struct Term {
    exponents: [usize; 3],
    coefficient: String,
}

#[derive(Serialize)]
struct BranchEntry {
    factor: usize,
    radius: String,
    latex: String,
    sympy: String,
    coordinates: SpaceFormulas,
    /// The condition, in SymPy syntax, under which the formula is real and equal to the root that it stands for.
    condition: String,
    condition_in_words: String,
    valid: &'static str,
}

#[derive(Serialize)]
struct SpaceFormulas {
    x: String,
    y: String,
    z: String,
}

#[derive(Serialize)]
struct MeridianEntry {
    theta: f64,
    /// The rational numbers cos θ and sin θ for which the ranges are exact.
    direction: [String; 2],
    branches: Vec<MeridianBranchEntry>,
}

#[derive(Serialize)]
struct MeridianBranchEntry {
    factor: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    branch: Option<usize>,
    ranges: Vec<Range>,
    positive: Vec<Range>,
}

#[derive(Serialize)]
struct DirectionEntry {
    theta: f64,
    phi: f64,
    /// The rational unit vector for which the answers are exact.
    direction: [String; 3],
    /// The sign of every factor's discriminant.
    discriminants: Vec<Option<i8>>,
    /// The sign of R on every branch, null where it is not real.
    signs: Vec<Option<i8>>,
    /// The certified radii of every factor; null where the whole line belongs to it.
    radii: Vec<Option<Vec<Number>>>,
}

/// Writes the spherical form of a surface: expressions for R, x, y and z of every branch with the condition under
/// which it is real, the discriminants as exact forms, and the answers on the requested meridians and directions.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub(crate) fn write_surface_parametrization(
    surface: &SurfaceParametrization,
    meridians: &[OnMeridian],
    directions: &[InDirection],
    digits: u32,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    match format {
        Format::Text => write_text(surface, meridians, directions, digits, out),
        Format::Json => {
            let document = document(surface, meridians, directions, digits)?;
            write_value(&document, out)?;
            Ok(writeln!(out)?)
        }
        Format::Csv | Format::Singular => Err(Kind::SurfaceRadii.refused(format)),
        _ if surface.branches.is_empty() => Err(Error::Usage(
            "there is no formula for R; --format text or json describes the surface".into(),
        )),
        Format::Latex | Format::Sympy | Format::Maple => {
            let branches = surface.branches.iter();
            let radii = branches.map(|b| expression_text(&b.radius, format));
            write_radii("R", &radii.collect::<Vec<_>>(), format, out)?;
            let mut comments = Vec::new();
            if surface.branches.iter().any(|b| b.condition != "everywhere") {
                let branches = surface.branches.iter().enumerate();
                comments.extend(factor_comments(surface));
                comments.extend(branches.map(|(index, branch)| branch_comment(index, branch)));
            }
            let center = surface.center().and_then(|center| center_comment(center));
            for comment in comments
                .into_iter()
                .chain(center.filter(|_| format == Format::Latex))
            {
                writeln!(out, "{} {comment}", format.comment())?;
            }
            write_source(Some(&surface.of), format, out)
        }
    }
}

fn method(surface: &SurfaceParametrization) -> String {
    match surface.method {
        SurfaceMethod::Cones => "cones".into(),
        SurfaceMethod::Lemma(n) => format!("lemma-{n}"),
        SurfaceMethod::Factors => "factors".into(),
        SurfaceMethod::Numeric => "numeric".into(),
    }
}

fn write_text(
    surface: &SurfaceParametrization,
    meridians: &[OnMeridian],
    directions: &[InDirection],
    digits: u32,
    out: &mut dyn Write,
) -> Result<()> {
    let step = if surface.step > 1 {
        format!(" in R^{}", surface.step)
    } else {
        String::new()
    };
    writeln!(out, "# {}{step}", method(surface))?;
    writeln!(
        out,
        "# x = R*sin(phi)*cos(theta), y = R*sin(phi)*sin(theta), z = R*cos(phi)"
    )?;
    if let Some(comment) = surface.center().and_then(|center| center_comment(center)) {
        writeln!(out, "# {comment}")?;
    }
    write_source(Some(&surface.of), Format::Text, out)?;
    for comment in factor_comments(surface) {
        writeln!(out, "# {comment}")?;
    }
    for note in &surface.notes {
        writeln!(out, "# note: {note}")?;
    }
    for (index, branch) in surface.branches.iter().enumerate() {
        writeln!(out, "# {}", branch_comment(index, branch))?;
        let hidden = if index > 0 { "# " } else { "" };
        writeln!(
            out,
            "{hidden}R = {}",
            expression_text(&branch.radius, Format::Text)
        )?;
    }
    for meridian in meridians {
        write_meridian(meridian, digits, out)?;
    }
    for direction in directions {
        write_direction(direction, out)?;
    }
    Ok(())
}

/// Which factors are cones, and the discriminants of the others, to which the conditions of the branches refer.
fn factor_comments(surface: &SurfaceParametrization) -> Vec<String> {
    let mut comments = Vec::new();
    for (index, factor) in surface.factors.iter().enumerate() {
        if factor.is_cone() {
            let cone = forms_text(&factor.polynomial);
            comments.push(format!("factor {index} is a cone: {cone} = 0 for every R"));
        }
        if let Some(form) = &factor.discriminant {
            let (text, _) = form_text(form, Format::Text);
            comments.push(format!("factor {index}: discriminant D = {text}"));
        }
    }
    comments
}

/// Where a branch is real, and whether its formula has other values elsewhere.
fn branch_comment(index: usize, branch: &SurfaceBranch) -> String {
    let valid = match branch.holds_where_real {
        true => "",
        false => "; the formula holds there only",
    };
    format!("branch {index}: real {}{valid}", branch.condition)
}

fn forms_text(polynomial: &SpacePolynomial) -> String {
    let texts = polynomial
        .homogeneous_degrees()
        .into_iter()
        .map(|degree| form_text(&polynomial.part(degree), Format::Text).0);
    texts.collect::<Vec<_>>().join(" + ")
}

fn write_meridian(meridian: &OnMeridian, digits: u32, out: &mut dyn Write) -> Result<()> {
    let [cos, sin] = meridian.theta.components();
    writeln!(
        out,
        "# on the meridian theta = {}, that of the exact vector ({cos}, {sin}):",
        meridian.theta.theta()
    )?;
    let real = meridian.branches.iter().filter(|b| !b.real.is_empty());
    let mut shown = 0;
    for branch in real {
        let name = match branch.branch {
            Some(index) => format!("branch {index}"),
            None => format!("factor {}", branch.factor),
        };
        let [real, positive] =
            [&branch.real, &branch.positive].map(|r| ranges_text_of("phi", &ranges(r, digits)));
        writeln!(out, "#   {name}: R real for {real}; R > 0 for {positive}")?;
        shown += 1;
    }
    if shown == 0 {
        writeln!(out, "#   no branch is real")?;
    }
    Ok(())
}

fn write_direction(written: &InDirection, out: &mut dyn Write) -> Result<()> {
    let (theta, phi) = (&written.direction.theta(), written.direction.phi());
    let [u, v, w] = written.direction.components();
    writeln!(
        out,
        "# in the direction theta = {}, phi = {}, that of the exact vector ({u}, {v}, {w}):",
        theta.theta(),
        phi.theta()
    )?;
    for (factor, sign) in written.answer.discriminants.iter().enumerate() {
        let Some(sign) = sign else { continue };
        let relation = match sign {
            1 => "> 0",
            0 => "= 0",
            _ => "< 0",
        };
        writeln!(out, "#   factor {factor}: D {relation}")?;
    }
    let named = |sign: i8| match sign {
        1 => "R > 0",
        0 => "R = 0",
        _ => "R < 0",
    };
    for (branch, sign) in written.answer.branches.iter().enumerate() {
        if let Some(sign) = sign {
            writeln!(out, "#   branch {branch}: real, {}", named(*sign))?;
        }
    }
    for (factor, ray) in written.rays.iter().enumerate() {
        let roots = match ray {
            Ray::Line => "the whole line belongs to it".into(),
            Ray::Points(points) if points.is_empty() => "no real root R other than 0".into(),
            Ray::Points(points) => {
                let list: Vec<String> = points.iter().map(|p| format!("{:?}", p.r)).collect();
                format!("all real roots (nearest doubles) R = {}", list.join(", "))
            }
        };
        writeln!(out, "#   factor {factor}: {roots}")?;
    }
    Ok(())
}

fn document(
    surface: &SurfaceParametrization,
    meridians: &[OnMeridian],
    directions: &[InDirection],
    digits: u32,
) -> Result<SurfaceParametrizationDocument> {
    let numbered = || surface.factors.iter().enumerate();
    let cones = numbered().filter(|(_, f)| f.is_cone());
    let discriminants = numbered().filter_map(|(i, f)| Some((i, f.discriminant.as_ref()?)));
    let center = surface.center();
    let starts = center.map(|center| center.each_ref().map(sympy_start));
    let [x, y, z] = starts.unwrap_or_default();
    let branches = surface.branches.iter().map(|branch| {
        let sympy = expression_text(&branch.radius, Format::Sympy);
        BranchEntry {
            factor: branch.factor,
            radius: expression_text(&branch.radius, Format::Text),
            latex: expression_text(&branch.radius, Format::Latex),
            coordinates: SpaceFormulas {
                x: format!("{x}({sympy})*sin(phi)*cos(theta)"),
                y: format!("{y}({sympy})*sin(phi)*sin(theta)"),
                z: format!("{z}({sympy})*cos(phi)"),
            },
            sympy,
            condition: condition_text(&branch.real_where),
            condition_in_words: branch.condition.clone(),
            valid: validity(branch.holds_where_real),
        }
    });
    Ok(SurfaceParametrizationDocument {
        schema: SCHEMA,
        kind: "parametric",
        parameters: ["theta", "phi"],
        method: method(surface),
        step: surface.step,
        lines: [],
        center: center.map(|center| center.each_ref().map(ToString::to_string)),
        cones: cones
            .flat_map(|(i, f)| {
                let parts = f.polynomial.parts();
                parts.map(move |(degree, terms)| {
                    form_entry(i, degree, terms.iter().map(|(e, c)| (*e, c)))
                })
            })
            .collect(),
        discriminants: discriminants
            .map(|(i, form)| form_entry(i, form.degree(), form.terms()))
            .collect(),
        branches: branches.collect(),
        meridians: meridians
            .iter()
            .map(|meridian| meridian_entry(meridian, digits))
            .collect(),
        directions: directions.iter().map(direction_entry).collect(),
        notes: surface.notes.clone(),
        of: source_field(Some(&surface.of))?,
    })
}

fn form_entry<'a>(
    factor: usize,
    degree: usize,
    terms: impl Iterator<Item = ([usize; 3], &'a Integer)>,
) -> FormEntry {
    let terms = terms.map(|(exponents, c)| Term {
        exponents,
        coefficient: c.to_string(),
    });
    FormEntry {
        factor,
        degree,
        terms: terms.collect(),
    }
}

fn meridian_entry(meridian: &OnMeridian, digits: u32) -> MeridianEntry {
    let branches = meridian.branches.iter().map(|b| MeridianBranchEntry {
        factor: b.factor,
        branch: b.branch,
        ranges: ranges(&b.real, digits),
        positive: ranges(&b.positive, digits),
    });
    MeridianEntry {
        theta: meridian.theta.theta(),
        direction: meridian.theta.components().map(|u| u.to_string()),
        branches: branches.collect(),
    }
}

fn direction_entry(written: &InDirection) -> DirectionEntry {
    let radii = written.rays.iter().map(|ray| match ray {
        Ray::Line => None,
        Ray::Points(points) => Some(points.iter().map(|p| Number(p.r)).collect()),
    });
    DirectionEntry {
        theta: written.direction.theta().theta(),
        phi: written.direction.phi().theta(),
        direction: written.direction.components().map(|u| u.to_string()),
        discriminants: written.answer.discriminants.clone(),
        signs: written.answer.branches.clone(),
        radii: radii.collect(),
    }
}
