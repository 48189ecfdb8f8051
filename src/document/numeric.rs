//! Branches without a closed form (Lemma 6) in parametric documents: their equations, the ranks of their roots, and the fit.

use serde::Serialize;

use super::Format;
use super::angles::{Angle, Fourier, PlaneFormulas, Range, angle, coordinates, fourier};
use super::expression::equation_text;
use super::fourier::expression;
use crate::parametrize::{BranchFit, BranchRadius, Parametrization, RootBranch, rounded_up};
use crate::roots::RealRoot;

/// The equation of the roots of a factor that has no closed form.
#[derive(Serialize)]
pub(super) struct EquationEntry {
    pub(super) factor: usize,
    pub(super) text: String,
    pub(super) latex: String,
    pub(super) sympy: String,
    pub(super) discriminant: DiscriminantEntry,
}

#[derive(Serialize)]
pub(super) struct DiscriminantEntry {
    pub(super) degree: usize,
    pub(super) real_roots: Vec<String>,
}

/// The rank of a branch among the real roots on a range of angles; 1 is the largest root.
#[derive(Serialize)]
pub(super) struct RootEntry {
    pub(super) root: usize,
    pub(super) of: usize,
    pub(super) from: String,
    pub(super) to: String,
}

/// The Fourier fit of a branch without a closed form.
#[derive(Serialize)]
pub(super) struct FitEntry {
    /// The index of the branch, or null for the outermost positive radius.
    pub(super) branch: Option<usize>,
    pub(super) radius: String,
    pub(super) latex: String,
    pub(super) sympy: String,
    pub(super) coordinates: PlaneFormulas,
    pub(super) fourier: Fourier,
    pub(super) harmonics: usize,
    pub(super) samples: usize,
    pub(super) max_error_at_samples: String,
    pub(super) max_error_between_estimate: String,
    pub(super) checks: usize,
    pub(super) jumps: Vec<Angle>,
}

/// For each factor that has no closed form, its index and one of its branches.
pub(super) fn equations(curve: &Parametrization) -> impl Iterator<Item = (usize, &RootBranch)> {
    let mut last = None;
    curve
        .branches
        .iter()
        .filter_map(move |branch| match &branch.radius {
            BranchRadius::Root(root) if last != Some(branch.factor) => {
                last = Some(branch.factor);
                Some((branch.factor, root))
            }
            _ => None,
        })
}

pub(super) fn equation_entry(factor: usize, root: &RootBranch, digits: u32) -> EquationEntry {
    let (forms, step) = root.equation();
    let in_format = |format| equation_text(forms, step, format);
    let discriminant = root.discriminant();
    EquationEntry {
        factor,
        text: in_format(Format::Text),
        latex: in_format(Format::Latex),
        sympy: in_format(Format::Sympy),
        discriminant: DiscriminantEntry {
            degree: discriminant.len().saturating_sub(1),
            real_roots: RealRoot::all_of(&discriminant)
                .iter()
                .map(|t| t.to_decimal(digits))
                .collect(),
        },
    }
}

pub(super) fn root_entries(root: &RootBranch, digits: u32) -> Vec<RootEntry> {
    let arcs = root.arcs().into_iter();
    arcs.map(|arc| RootEntry {
        root: arc.rank + 1,
        of: arc.of,
        from: arc.range.from.to_decimal(digits),
        to: arc.range.to.to_decimal(digits),
    })
    .collect()
}

/// The ranks of a branch as text, such as `root 1 of 3 for theta in (0, pi/2), …`.
pub(super) fn roots_text(radius: &BranchRadius, digits: u32) -> String {
    let BranchRadius::Root(root) = radius else {
        return String::new();
    };
    let arcs = root.arcs().into_iter().map(|arc| {
        let range = Range::new(&arc.range, digits).text();
        format!("root {} of {} for theta in {range}", arc.rank + 1, arc.of)
    });
    let text = arcs.collect::<Vec<_>>().join(", ");
    if root.is_point() && !text.is_empty() {
        format!("a single point, of the finite real r from the largest: {text}")
    } else if text.is_empty() {
        "an isolated point".into()
    } else {
        format!("real r from the largest: {text}")
    }
}

pub(super) fn fit_entry(fit: &BranchFit, digits: u32) -> FitEntry {
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

impl EquationEntry {
    /// The equation and its discriminant, as comments.
    pub(super) fn comments(&self) -> [String; 2] {
        let Self {
            factor,
            text,
            discriminant,
            ..
        } = self;
        let zeros = match discriminant.real_roots.len() {
            0 => "no real zero".into(),
            _ => format!("real zeros {}", discriminant.real_roots.join(", ")),
        };
        [
            format!("factor {factor}: {text} = 0"),
            format!(
                "its discriminant has degree {} in t = tan(theta), {zeros}",
                discriminant.degree
            ),
        ]
    }
}

/// The branch that is fitted and the errors of the fit, as comments.
pub(super) fn fit_comments(fit: &BranchFit, digits: u32) -> Vec<String> {
    let of = match fit.branch {
        Some(index) => format!("branch {index}"),
        None => "the outermost positive radius, of several branches".into(),
    };
    let mut comments = vec![format!(
        "Fourier fit of {of}: N = {}, {} samples; |error| <= {} at the samples (certified), ≈ {} between them (the largest at {} more directions)",
        fit.radius.harmonics(),
        fit.samples,
        rounded_up(&fit.error_at_samples),
        rounded_up(&fit.error_between),
        fit.checks
    )];
    comments.extend(fit.jumps.iter().map(|jump| {
        let theta = jump.to_decimal(digits);
        format!("at theta = {theta} it jumps from one branch to another")
    }));
    comments
}
