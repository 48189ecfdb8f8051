//! The polar form of a plane curve by all of §3: straight lines through the origin, and branches r(θ).

use std::sync::Arc;

use malachite::base::num::arithmetic::traits::Gcd;
use malachite::base::num::basic::traits::Zero;

use super::angle::{AngleRange, ExactAngle};
use super::closed::{branches_of, ranges, solve};
use super::expression::Expression;
use super::fourier::{born_of_radius, fourier_branches};
use super::ranges::positive_ranges;
use super::rational::{FactorRationality, Rationality, rational_parametrization};
use super::traced::{Equation, RootBranch, Tracing};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::factor::factor_plane;
use crate::limits::Limits;
use crate::poly::{BinaryForm, IntegerPolynomial, PlanePolynomial};
use crate::roots::{RealRoot, real_roots};
use crate::sample::Direction;
use crate::shape::{Form, FourierRadius, ImplicitCurve};

/// A curve in polar form: straight lines through the origin, and branches r(θ).
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Parametrization {
    /// The method that gives the branches.
    pub method: PolarMethod,
    /// The step k, where r^k is the root of a polynomial; 1 if there are several factors.
    pub step: usize,
    /// The angles in [0, π) of straight lines through the origin that belong to the curve.
    pub lines: Vec<ExactAngle>,
    /// The branches of all factors.
    pub branches: Vec<Branch>,
    /// Further notes for the reader.
    pub notes: Vec<String>,
    /// The center, from which r is measured.
    pub center: [Rational; 2],
    /// The findings about rational parametrizations, factor by factor. Factors without findings are left out.
    pub rational: Vec<FactorRationality>,
    /// The form of which this is the polar form: an implicit curve or a superquadric.
    pub of: Form,
}

/// The method that gives the branches of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PolarMethod {
    /// There are no branches, only lines through the origin.
    Lines,
    /// One of Lemmas 2 to 5.
    Lemma(usize),
    /// The curve has several factors, each with its own lemma.
    Factors,
    /// Lemma 6: the roots are found direction by direction, because the degree in r^k is more than four.
    Numeric,
}

/// A branch of a curve.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Branch {
    /// The index of the factor to which the branch belongs, from 0.
    pub factor: usize,
    /// The radius r(θ).
    pub radius: BranchRadius,
    /// The ranges of θ in which r is real and finite, of either sign.
    pub real: Vec<AngleRange>,
    /// The ranges of θ in which r > 0.
    pub positive: Vec<AngleRange>,
    /// Whether the formula is real only in `real`. The formulas of Lemmas 4 and 5 may be real elsewhere, where they give the
    /// root of another branch or no root.
    pub holds_where_real: bool,
}

/// The exact radius r(θ) of a branch.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum BranchRadius {
    /// A trigonometric polynomial.
    Fourier(FourierRadius),
    /// Any other closed form.
    Closed(Expression),
    /// A certified root in each direction (Lemma 6).
    Root(RootBranch),
}

/// Finds the polar form of a plane curve (Lemmas 2 to 6), with exact ranges.
///
/// The polynomial is factored over Q. The real zeros of a factor that is a form are straight lines through the origin. If a
/// factor has two to five homogeneous parts of equally spaced degrees, the radius is the root of a polynomial of degree at most
/// four in r^k and has a closed form (Lemmas 2 to 5); otherwise it is a certified root in each direction (Lemma 6). A radius
/// that is a trigonometric polynomial is returned as one. Multiplicities do not change the curve; the notes state them.
///
/// # Errors
/// [`Error::Usage`] for the polynomial 0; [`Error::Limit`] if a discriminant is too large to be computed; those of
/// [`factor_plane`].
pub fn parametrize(curve: &ImplicitCurve, limits: &Limits) -> Result<Parametrization> {
    let mut result = Parametrization {
        method: PolarMethod::Lines,
        step: 1,
        lines: Vec::new(),
        branches: Vec::new(),
        notes: Vec::new(),
        center: curve.center().clone(),
        rational: Vec::new(),
        of: Form::Curve(curve.clone()),
    };
    if let Some(found) = born_of_radius(curve) {
        result.method = PolarMethod::Lemma(found.lemma);
        result.step = found.step;
        result.branches = found
            .radii
            .into_iter()
            .map(|r| Branch::fourier(0, r))
            .collect();
        result
            .rational
            .extend(rationality(curve.polynomial(), 0, &result));
        note_points(curve, &mut result);
        return Ok(result);
    }
    let factors = factor_plane(curve.polynomial(), limits)?.factors;
    let only_lines = |f: &PlanePolynomial| f.homogeneous_degrees().len() == 1;
    for (index, factor) in factors.iter().enumerate() {
        limits.check()?;
        if factor.multiplicity > 1 {
            result.notes.push(format!(
                "factor {index} has multiplicity {}",
                factor.multiplicity
            ));
        }
        if only_lines(&factor.polynomial) {
            result
                .lines
                .extend(factor.polynomial.parts().flat_map(directions));
        } else {
            add_factor(&factor.polynomial, index, &mut result, limits)?;
            result
                .rational
                .extend(rationality(&factor.polynomial, index, &result));
        }
    }
    if factors.len() > 1 && factors.iter().any(|f| !only_lines(&f.polynomial)) {
        result.method = PolarMethod::Factors;
        result.step = 1;
    }
    note_points(curve, &mut result);
    Ok(result)
}

/// Adds notes about the origin, and about a curve that has no real points or only isolated ones.
fn note_points(curve: &ImplicitCurve, result: &mut Parametrization) {
    let multiplicity = curve.polynomial().lowest_degree().unwrap_or(0);
    if multiplicity > 0 {
        result.notes.push(format!(
            "the origin belongs to the curve, with multiplicity {multiplicity}"
        ));
    }
    if !result.lines.is_empty() {
        return;
    }
    let ranges: Vec<&AngleRange> = result.branches.iter().flat_map(|b| &b.real).collect();
    let note = match (ranges.is_empty(), multiplicity) {
        (true, 0) => "the curve has no real point",
        (true, _) => "the origin is its only real point",
        (false, _) if ranges.iter().all(|r| r.is_point()) => "its real points are isolated",
        _ => return,
    };
    result.notes.push(note.into());
}

/// The findings about the rational parametrizations of a factor whose branches are known.
fn rationality(
    f: &PlanePolynomial,
    factor: usize,
    known: &Parametrization,
) -> Option<FactorRationality> {
    let series = |b: &Branch| b.factor == factor && matches!(b.radius, BranchRadius::Fourier(_));
    let rationality = if known.branches.iter().any(series) {
        Rationality::HalfAngle
    } else {
        rational_parametrization(f)?
    };
    Some(FactorRationality {
        factor,
        rationality,
    })
}

/// The branches of one irreducible factor that is not a form.
fn add_factor(
    f: &PlanePolynomial,
    index: usize,
    result: &mut Parametrization,
    limits: &Limits,
) -> Result<()> {
    let curve = ImplicitCurve::new(f.clone()).with_center(result.center.clone());
    if let Ok(found) = fourier_branches(&curve) {
        result.method = PolarMethod::Lemma(found.lemma);
        result.step = found.step;
        result
            .branches
            .extend(found.radii.into_iter().map(|r| Branch::fourier(index, r)));
        return Ok(());
    }
    let degrees = f.homogeneous_degrees();
    let step = degrees.windows(2).fold(0, |g: usize, w| g.gcd(w[0] - w[1]));
    let (top, low) = (degrees[0], degrees[degrees.len() - 1]);
    let k = u32::try_from(step).map_err(|_| Error::limit("the step of the degrees"))?;
    let part = |d: usize| f.part(d).cloned().unwrap_or_else(|| BinaryForm::zero(d));
    let degree = (top - low) / step;
    let parts: Vec<BinaryForm> = (0..=degree).map(|j| part(top - j * step)).collect();
    let Some(solved) = solve(&parts) else {
        return add_traced(f, index, step, result, limits);
    };
    result.method = PolarMethod::Lemma(degree + 1);
    result.step = step;
    let rules = solved.roots.iter().map(|(_, rule)| *rule);
    let ranges = ranges(rules, &solved.critical, &parts, k);
    let radii = solved.roots.iter().flat_map(|(root, rule)| {
        let branches = branches_of(root, k).into_iter();
        branches.map(|radius| (radius, rule.holds_where_real()))
    });
    let branches = radii.zip(ranges);
    let branches = branches.map(|((radius, holds_where_real), ranges)| Branch {
        factor: index,
        radius: BranchRadius::Closed(radius),
        real: ranges.real,
        positive: ranges.positive,
        holds_where_real,
    });
    // Many of the formulas of Lemmas 4 and 5 hold in no direction.
    result
        .branches
        .extend(branches.filter(|b| degree < 3 || !b.real.is_empty()));
    if degree > 1 && !directions(&part(top)).is_empty() {
        let tracing = Arc::new(Tracing::new(equation(f, step), limits)?);
        let points = tracing.finite_where_one_is_infinite();
        if !points.is_empty() {
            let others = match degree {
                2 => "the other one is the limit of its formula, which is 0/0 there",
                _ => "the formulas have no value; the finite ones there are branches of their own",
            };
            result.notes.push(format!(
                "factor {index}: where the part of degree {top} vanishes one root is infinite, and {others}"
            ));
        }
        if degree > 2 {
            result
                .branches
                .extend(points.into_iter().map(|b| Branch::root(index, b)));
        }
    }
    Ok(())
}

/// The equation of a factor as a polynomial in r^step.
fn equation(f: &PlanePolynomial, step: usize) -> Equation {
    let degrees = f.homogeneous_degrees();
    let (top, lowest) = (degrees[0], degrees[degrees.len() - 1]);
    let part = |d: usize| f.part(d).cloned().unwrap_or_else(|| BinaryForm::zero(d));
    Equation {
        forms: (lowest..=top).step_by(step).map(part).collect(),
        lowest,
        step,
    }
}

/// The slopes of all directions but the vertical one in which a root λ of f(λ cos θ, λ sin θ) may be multiple, 0 or infinite, besides
/// the root 0 that all directions have; and 0. The polynomial must be irreducible. `None` for a form, whose zeros are straight lines,
/// and where a discriminant would be large.
///
/// # Errors
/// Those of `limits`.
pub(crate) fn critical_slopes(
    f: &PlanePolynomial,
    limits: &Limits,
) -> Result<Option<Vec<RealRoot>>> {
    const MOST_DEGREE: usize = 40;
    const MOST_DEGREE_IN_R: usize = 12;
    let degrees = f.homogeneous_degrees();
    let step = degrees.windows(2).fold(0, |g: usize, w| g.gcd(w[0] - w[1]));
    if step == 0 || degrees[0] > MOST_DEGREE {
        return Ok(None);
    }
    let equation = equation(f, step);
    if equation.forms.len() > MOST_DEGREE_IN_R + 1 {
        return Ok(None);
    }
    equation.critical_slopes(limits).map(Some)
}

/// Adds the branches of a factor of degree more than four in r^step, each as a root.
fn add_traced(
    f: &PlanePolynomial,
    index: usize,
    step: usize,
    result: &mut Parametrization,
    limits: &Limits,
) -> Result<()> {
    let degrees = f.homogeneous_degrees();
    let (top, low) = (degrees[0], degrees[degrees.len() - 1]);
    let tracing = Arc::new(Tracing::new(equation(f, step), limits)?);
    let list: Vec<String> = degrees.iter().map(ToString::to_string).collect();
    let in_power = if step > 1 {
        format!("r^{step}")
    } else {
        "r".into()
    };
    result.notes.push(format!(
        "factor {index} has homogeneous parts of degrees {}: degree {} in {in_power}, and the lemmas give a closed form up to degree 4 (Theorem 5 needs equally spaced degrees)",
        list.join(", "),
        (top - low) / step,
    ));
    for angle in tracing.open_angles() {
        result.notes.push(format!(
            "at theta = {} several roots meet, and which goes on as which is not decided: branches end there",
            angle.describe()
        ));
    }
    result.method = PolarMethod::Numeric;
    result.step = step;
    result.branches.extend(
        tracing
            .branches()
            .into_iter()
            .map(|b| Branch::root(index, b)),
    );
    Ok(())
}

impl BranchRadius {
    /// The value r(θ) in doubles, without a bound of its error, for drawing and comparing.
    #[must_use]
    pub fn approximate(&self, theta: f64) -> f64 {
        match self {
            Self::Fourier(radius) => radius.approximate(theta),
            Self::Closed(expression) => {
                let (s, c) = theta.sin_cos();
                expression.approximate([c, s, 0.0])
            }
            Self::Root(branch) => branch
                .radius(&Direction::from_radians(theta))
                .unwrap_or(f64::NAN),
        }
    }
}

impl Branch {
    /// A branch whose radius is a trigonometric polynomial, so that it is real everywhere.
    pub(crate) fn fourier(factor: usize, radius: FourierRadius) -> Self {
        Self {
            factor,
            real: vec![AngleRange::full_circle()],
            positive: positive_ranges(&radius),
            radius: BranchRadius::Fourier(radius),
            holds_where_real: true,
        }
    }

    fn root(factor: usize, branch: RootBranch) -> Self {
        Self {
            factor,
            real: branch.real.clone(),
            positive: branch.positive.clone(),
            radius: BranchRadius::Root(branch),
            holds_where_real: false,
        }
    }
}

/// The angles in [0, π) at which a form vanishes, ascending.
fn directions(form: &BinaryForm) -> Vec<ExactAngle> {
    let roots = real_roots(form.dehomogenized());
    let (negative, other): (Vec<_>, Vec<_>) = roots.into_iter().partition(|t| t.signum() < 0);
    let vertical = form.dehomogenized().coefficients_asc().len() <= form.degree()
        && *form.dehomogenized() != IntegerPolynomial::ZERO;
    let up = vertical.then(|| ExactAngle::Pi(Rational::one() / Rational::from(2)));
    let tangents = |list: Vec<_>| list.into_iter().map(ExactAngle::of_tangent);
    tangents(other)
        .chain(up)
        .chain(tangents(negative))
        .collect()
}
