//! The equation of a form, for the verbs that work with equations.

use super::{Remark, Work};
use crate::error::{Error, Result};
use crate::implicitize::{
    Coverage, SquaredForm, SquaredHarmonics, coverage, implicitize_patch, implicitize_plane,
    point_beyond, real_image,
};
use crate::poly::SparsePolynomial;
use crate::shape::{
    Form, HarmonicSurface, ImplicitCurve, ImplicitSurface, PlaneCurve, SpaceSuperquadric,
    Superquadric,
};

/// A verb and the forms that it takes, for messages.
pub(super) struct Taken {
    pub(super) verb: &'static str,
    pub(super) these: &'static str,
}

impl Taken {
    /// The error for a form that the verb does not take.
    pub(super) fn not_this(&self) -> Error {
        Error::Usage(format!(
            "this is a curve in space: {} takes {}",
            self.verb, self.these
        ))
    }
}

/// The implicit form of a parametric curve or patch, or of a harmonic surface, relative to its center. Other forms are returned
/// unchanged. A remark says if the equation is known to have more points than the form.
pub(super) fn through_equation(form: Form, work: &Work) -> Result<Form> {
    Ok(match form {
        Form::PlaneCurve(curve) => {
            let found = work.stage("implicitize", || implicitize_plane(&curve, work.bounds()))?;
            let image = real_image(&curve, found.tracing_index, work.bounds())?;
            let has_part = matches!(image.coverage, Coverage::Part(_));
            if has_part || !image.isolated.points.is_empty() {
                work.remark(Remark::EquationHasMore("curve"));
            }
            Form::Curve(found.curve)
        }
        Form::Patch(patch) => {
            let found = work.stage("implicitize", || implicitize_patch(&patch, work.bounds()))?;
            if point_beyond(&patch, &found.surface).is_some() {
                work.remark(Remark::EquationHasMore("patch"));
            }
            Form::Surface(found.surface)
        }
        Form::Harmonic(surface) => Form::Surface(
            work.stage("implicitize", || squared_harmonics(&surface, work))?
                .expand(),
        ),
        other => other,
    })
}

/// The equation of a parametric plane curve, and how much of its real zero set the curve is.
pub(super) fn equation_and_coverage(
    curve: &PlaneCurve,
    work: &Work,
) -> Result<(ImplicitCurve, Coverage<2>)> {
    let found = work.stage("implicitize", || implicitize_plane(curve, work.bounds()))?;
    let coverage = coverage(curve, found.tracing_index, work.bounds())?;
    Ok((found.curve, coverage))
}

/// The equation of a harmonic surface, not expanded.
pub(super) fn squared_harmonics(
    surface: &HarmonicSurface,
    work: &Work,
) -> Result<SquaredHarmonics> {
    work.check_degree(2 * surface.degree() + 2)?;
    SquaredHarmonics::new(surface)
}

/// The plane curve that a form is, or that its implicit form is.
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

/// Refuses a surface of a degree above the largest one that is allowed.
pub(super) fn check_surface(surface: &ImplicitSurface, work: &Work) -> Result<()> {
    let degree = surface.polynomial().degree().unwrap_or(0);
    work.check_degree(usize::try_from(degree).unwrap_or(usize::MAX))
}

/// The cylinder in space that has the same equation as a plane curve.
pub(super) fn cylinder(curve: &ImplicitCurve) -> ImplicitSurface {
    let original = curve.in_original_coordinates();
    ImplicitSurface::new(SparsePolynomial::from(original.polynomial()))
}

/// The implicit curve of a superquadric; an error if its equation is not a polynomial.
pub(super) fn curve_of_superquadric(shape: &Superquadric) -> Result<ImplicitCurve> {
    let polynomial = shape.polynomial().ok_or_else(|| Error::Hypothesis {
        statement: "implicitization as a polynomial",
        witness: format!(
            "|x/a1|^n + |y/a2|^n = level is polynomial only for an even integer n = 2/e, and here n = {}; what needs no equation takes any n: describe without --topology, parametrize, sample, inspect and plot",
            shape.exponent()
        ),
    })?;
    Ok(ImplicitCurve::new(polynomial))
}

/// The implicit surface of a superquadric in space; an error if its equation is not a polynomial.
pub(super) fn surface_of_superquadric(shape: &SpaceSuperquadric) -> Result<ImplicitSurface> {
    Ok(ImplicitSurface::new(shape.polynomial()?))
}
