//! Theorem 6: the branches R(θ, φ) of a surface, by Lemmas 7 to 10.

use malachite::base::num::arithmetic::traits::Gcd;

use super::closed::{LARGEST_SOLVED_DEGREE, Rule, Solved, branches_of, discriminant, solve};
use super::condition::Condition;
use super::expression::Expression;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::factor::factor_space;
use crate::limits::Limits;
use crate::poly::{HomogeneousPolynomial, SpacePolynomial, TernaryForm};
use crate::shape::{Form, ImplicitSurface};

/// A surface in spherical form: cones with their apex at the origin, and branches R(θ, φ) with
/// `x = R sin φ cos θ`, `y = R sin φ sin θ`, `z = R cos φ`.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SurfaceParametrization {
    /// The method that gives the branches.
    pub method: SurfaceMethod,
    /// The step k, where R^k is the root of a polynomial; 1 if there are several factors.
    pub step: usize,
    /// The irreducible factors, in the order of the indices in the branches.
    pub factors: Vec<SurfaceFactor>,
    /// The branches of all factors.
    pub branches: Vec<SurfaceBranch>,
    /// Further notes for the reader.
    pub notes: Vec<String>,
    /// The form of which this is the spherical form: an implicit surface or a superquadric in space.
    pub of: Form,
}

impl SurfaceParametrization {
    /// The point from which R is measured, if it is not the origin.
    #[must_use]
    pub fn center(&self) -> Option<&[Rational; 3]> {
        match &self.of {
            Form::Surface(surface) if !surface.is_centered() => Some(surface.center()),
            _ => None,
        }
    }
}

/// The method that gives the branches of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SurfaceMethod {
    /// There are no branches, only cones.
    Cones,
    /// One of Lemmas 7 to 10.
    Lemma(usize),
    /// The surface has several factors, each with its own lemma.
    Factors,
    /// The roots are found direction by direction, because the degree in R^k is more than four.
    Numeric,
}

/// An irreducible factor of the polynomial of a surface.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SurfaceFactor {
    /// The factor, by its homogeneous parts.
    pub polynomial: SpacePolynomial,
    /// The discriminant with respect to R^k, if the degree is 2 to 4: a form in (α, β, γ) = (sin φ cos θ, sin φ sin θ, cos φ).
    pub discriminant: Option<TernaryForm>,
    /// The step k, where the factor is a polynomial in R^k; 0 for a form, whose zero set is a cone.
    pub step: usize,
    /// The coefficients of the polynomial in R^k, descending; the list is empty if there is no closed form.
    pub(super) parts: Vec<TernaryForm>,
    pub(super) solved: Option<Solved<TernaryForm>>,
}

/// A branch of a surface.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SurfaceBranch {
    /// The index of the factor to which the branch belongs, from 0.
    pub factor: usize,
    /// The radius R(θ, φ).
    pub radius: Expression<TernaryForm>,
    /// The condition on the direction under which the formula holds, in words.
    pub condition: String,
    /// The exact condition.
    pub real_where: Condition,
    /// Whether the formula is real only where it holds.
    pub holds_where_real: bool,
}

impl SurfaceFactor {
    /// Whether the factor is a form, so that its zero set is a cone with its apex at the origin.
    #[must_use]
    pub fn is_cone(&self) -> bool {
        self.step == 0
    }

    /// Whether there is no closed form, because the degree in R^k is more than four.
    #[must_use]
    pub fn is_numeric(&self) -> bool {
        !self.is_cone() && self.solved.is_none()
    }
}

/// Finds the spherical form of a surface (Theorem 6, Lemmas 7 to 10).
///
/// The polynomial is factored over Q. A factor that is a form is a cone. If a factor has two to five homogeneous parts of
/// equally spaced degrees, R is the root of a polynomial of degree at most four in R^k and has a closed form, by the formulas
/// of Lemmas 2 to 5 with forms in (sin φ cos θ, sin φ sin θ, cos φ). A factor of a higher degree in R^k has no branches here;
/// [`SurfaceParametrization::on_meridian`] and sampling give its roots direction by direction.
///
/// R is the distance from the center of the surface.
///
/// ```
/// use stellate::limits::Limits;
/// use stellate::parametrize::{SurfaceMethod, parametrize_surface};
/// use stellate::poly::{Ring, SparsePolynomial};
/// use stellate::shape::ImplicitSurface;
///
/// // The sphere x² + y² + z² = 4x through the origin: R = 4 sin φ cos θ.
/// let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
/// let f = x.squared().plus(&y.squared()).plus(&z.squared()).minus(&x.scaled(&4.into()));
/// let sphere = parametrize_surface(&ImplicitSurface::new(f), &Limits::none())?;
/// assert_eq!(sphere.method, SurfaceMethod::Lemma(7));
/// assert_eq!(sphere.branches[0].radius.approximate([0.6, 0.8, 0.0]), 4.0 * 0.6);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Usage`] for a constant; those of [`factor_space`].
pub fn parametrize_surface(
    surface: &ImplicitSurface,
    limits: &Limits,
) -> Result<SurfaceParametrization> {
    let f = surface.polynomial();
    if f.degree().is_none_or(|degree| degree == 0) {
        return Err(Error::Usage(
            "a constant has no zero set with branches".into(),
        ));
    }
    let mut result = SurfaceParametrization {
        method: SurfaceMethod::Cones,
        step: 1,
        factors: Vec::new(),
        branches: Vec::new(),
        notes: Vec::new(),
        of: Form::Surface(surface.clone()),
    };
    for (index, found) in factor_space(f, limits)?.factors.iter().enumerate() {
        limits.check()?;
        if found.multiplicity > 1 {
            let m = found.multiplicity;
            result
                .notes
                .push(format!("factor {index} has multiplicity {m}"));
        }
        let factor = factor(SpacePolynomial::from(&found.polynomial));
        add_branches(&factor, index, &mut result)?;
        result.factors.push(factor);
    }
    if result.factors.len() > 1 && result.factors.iter().any(|f| !f.is_cone()) {
        result.method = SurfaceMethod::Factors;
        result.step = 1;
    }
    let lowest = surface.by_degree().homogeneous_degrees().pop();
    if let Some(multiplicity) = lowest.filter(|&m| m > 0) {
        result.notes.push(format!(
            "the origin belongs to the surface, with multiplicity {multiplicity}"
        ));
    }
    Ok(result)
}

fn factor(polynomial: SpacePolynomial) -> SurfaceFactor {
    let degrees = polynomial.homogeneous_degrees();
    let step = degrees.windows(2).fold(0, |g: usize, w| g.gcd(w[0] - w[1]));
    let parts: Vec<TernaryForm> = match (degrees.first(), degrees.last()) {
        (Some(&top), Some(&low))
            if (1..=LARGEST_SOLVED_DEGREE).contains(&degree_in_power(&polynomial, step)) =>
        {
            let all = (low..=top).rev().step_by(step);
            all.map(|degree| polynomial.part(degree)).collect()
        }
        _ => Vec::new(),
    };
    SurfaceFactor {
        discriminant: discriminant(&parts),
        solved: solve(&parts),
        polynomial,
        step,
        parts,
    }
}

/// The degree in R^step, after the smallest power of R is divided out; 0 for a cone, whose step is 0.
fn degree_in_power(polynomial: &SpacePolynomial, step: usize) -> usize {
    let degrees = polynomial.homogeneous_degrees();
    match (degrees.first(), degrees.last()) {
        (Some(top), Some(low)) if step > 0 => (top - low) / step,
        _ => 0,
    }
}

fn add_branches(
    factor: &SurfaceFactor,
    index: usize,
    result: &mut SurfaceParametrization,
) -> Result<()> {
    if factor.is_cone() {
        return Ok(());
    }
    let k = u32::try_from(factor.step).map_err(|_| Error::limit("the step of the degrees"))?;
    let degree = degree_in_power(&factor.polynomial, factor.step);
    result.step = factor.step;
    let Some(solved) = &factor.solved else {
        result.method = SurfaceMethod::Numeric;
        result.notes.push(format!(
            "factor {index} has degree {degree} in {}, and the lemmas give a closed form up to degree 4: its radii are certified root by root, on a meridian or in a direction, or by sampling",
            power("R", factor.step)
        ));
        return Ok(());
    };
    result.method = SurfaceMethod::Lemma(degree + 6);
    let may_vanish = may_vanish(&factor.parts[0]);
    if may_vanish && degree > 1 {
        result.notes.push(format!(
            "where the denominator of the formulas of factor {index} is 0, {} is a root of a lower degree, which they give at most as a limit: it is certified on a meridian, in a direction, or by sampling",
            power("R", factor.step)
        ));
    }
    for (root, rule) in &solved.roots {
        let even = k.is_multiple_of(2);
        let condition = condition(*rule, may_vanish, even, &power("R", factor.step));
        let branches = branches_of(root, k).into_iter();
        let mut real_where = vec![rule.condition(&solved.critical)];
        if even {
            real_where.push(Condition::NotNegative(root.clone()));
        }
        result.branches.extend(branches.map(|radius| SurfaceBranch {
            factor: index,
            radius,
            condition: condition.clone(),
            real_where: Condition::all(real_where.clone()),
            holds_where_real: rule.holds_where_real(),
        }));
    }
    Ok(())
}

fn power(name: &str, k: usize) -> String {
    if k == 1 {
        name.into()
    } else {
        format!("{name}^{k}")
    }
}

/// Whether a form may have a zero on unit vectors. It has none if it is a power of ρ, or if its terms are squares with coefficients
/// of one sign and those of x, y and z are among them.
fn may_vanish(form: &TernaryForm) -> bool {
    let form = form.on_unit_vectors();
    let terms = form.monomials();
    let is_square = |e: &[usize; 3]| e.iter().all(|k| k.is_multiple_of(2));
    let is_positive = terms.first().is_some_and(|(_, c)| **c > 0);
    let is_definite = terms
        .iter()
        .all(|(e, c)| is_square(e) && (**c > 0) == is_positive);
    let powers = terms.iter().filter(|(e, _)| e.contains(&form.degree()));
    !(form.degree() == 0 || is_definite && powers.count() == 3)
}

/// The condition under which a formula holds, in words; D stands for the discriminant, and `may_vanish` says whether the denominator
/// may be 0.
fn condition(rule: Rule, may_vanish: bool, even: bool, power: &str) -> String {
    let (condition, root) = match rule {
        Rule::Linear => ("", ""),
        Rule::Quadratic(_) => ("D >= 0", ""),
        Rule::CubicOne => ("D <= 0", ": the only real root"),
        Rule::CubicThree(0) => ("D >= 0", ": the first of three real roots"),
        Rule::CubicThree(1) => ("D >= 0", ": the second of three real roots"),
        Rule::CubicThree(_) => ("D >= 0", ": the third of three real roots"),
        Rule::Quartic { cosine: true, .. } => ("all four roots are real", ""),
        Rule::Quartic { .. } => (
            "D <= 0 and the inner square root is real",
            ": one of two real roots",
        ),
        Rule::SymmetricQuartic(_) => ("both square roots are real", ""),
        Rule::Biquadratic(_) => (
            "the depressed quartic has no linear term and not all roots are real",
            "",
        ),
    };
    let denominator = if may_vanish {
        "the denominator is not 0"
    } else {
        ""
    };
    let all: Vec<&str> = [denominator, condition]
        .into_iter()
        .filter(|text| !text.is_empty())
        .collect();
    let real = format!("{}{root}", all.join(" and "));
    let of_power = format!("{power} >= 0");
    match (real.is_empty(), even) {
        (true, true) => format!("where {of_power}"),
        (true, false) => "everywhere".into(),
        (false, true) => format!("where {real}, and {of_power}"),
        (false, false) => format!("where {real}"),
    }
}
