//! The equation of a form, for the verbs that work with equations.

use super::Work;
use crate::error::{Error, Result};
use crate::implicitize::{SquaredForm, implicitize_patch, implicitize_plane};
use crate::poly::SparsePolynomial;
use crate::shape::{Form, ImplicitCurve, ImplicitSurface, SpaceSuperquadric, Superquadric};

/// A verb and what it takes, for messages.
pub(super) struct Taken {
    pub(super) verb: &'static str,
    pub(super) these: &'static str,
}

impl Taken {
    /// Why a form is not taken.
    pub(super) fn not_this(&self) -> Error {
        Error::Usage(format!(
            "this is a curve in space: {} takes {}",
            self.verb, self.these
        ))
    }
}

/// A parametric curve as its implicit equation, a patch as that of its surface; other forms as they are.
pub(super) fn through_equation(form: Form, work: &Work) -> Result<Form> {
    Ok(match form {
        Form::PlaneCurve(curve) => Form::Curve(
            work.stage("implicitize", || implicitize_plane(&curve, work.bounds()))?
                .curve,
        ),
        Form::Patch(patch) => Form::Surface(
            work.stage("implicitize", || implicitize_patch(&patch, work.bounds()))?
                .surface,
        ),
        other => other,
    })
}

/// The plane curve that a form is or has.
pub(super) fn implicit_curve(form: Form, taken: &Taken, work: &Work) -> Result<ImplicitCurve> {
    match form {
        Form::Fourier(radius) => {
            work.check_degree(2 * radius.harmonics() + 2)?;
            Ok(SquaredForm::new(&radius)?.expand())
        }
        Form::Curve(curve) => {
            check_curve(&curve, work)?;
            Ok(curve)
        }
        Form::Superquadric(shape) => curve_of_superquadric(&shape),
        _ => Err(taken.not_this()),
    }
}

/// Refuses a curve of a degree above the largest one that is allowed.
pub(super) fn check_curve(curve: &ImplicitCurve, work: &Work) -> Result<()> {
    work.check_degree(curve.polynomial().degree().unwrap_or(0))
}

/// The same for a surface.
pub(super) fn check_surface(surface: &ImplicitSurface, work: &Work) -> Result<()> {
    let degree = surface.polynomial().degree().unwrap_or(0);
    work.check_degree(usize::try_from(degree).unwrap_or(usize::MAX))
}

/// An equation in x and y is a cylinder in space.
pub(super) fn cylinder(curve: &ImplicitCurve) -> ImplicitSurface {
    let original = curve.in_original_coordinates();
    ImplicitSurface::new(SparsePolynomial::from(original.polynomial()))
}

/// The implicit curve of a superquadric, where it has one.
pub(super) fn curve_of_superquadric(shape: &Superquadric) -> Result<ImplicitCurve> {
    let polynomial = shape.polynomial().ok_or_else(|| Error::Hypothesis {
        statement: "implicitization as a polynomial",
        witness: format!(
            "|x/a1|^n + |y/a2|^n = level is polynomial only for an even integer n = 2/e, and here n = {}; describe, parametrize, sample and plot take any n",
            shape.exponent()
        ),
    })?;
    Ok(ImplicitCurve::new(polynomial))
}

/// The implicit surface of a superquadric in space, where it has one.
pub(super) fn surface_of_superquadric(shape: &SpaceSuperquadric) -> Result<ImplicitSurface> {
    Ok(ImplicitSurface::new(shape.polynomial()?))
}
