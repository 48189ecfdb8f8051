//! The topology of a plane curve, for `describe` and `plot`.

use super::{Part, Work};
use crate::describe::Description;
use crate::error::{Error, Result};
use crate::limits::Limits;
use crate::poly::PlanePolynomial;
use crate::shape::Form;
use crate::topology::{Genus, Topology};

/// The topology of the zero set of the equation of a form.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct CurveTopology {
    /// The components, singular points and asymptotes.
    pub topology: Topology,
    /// The genus of each irreducible factor of the description, in the same order; `None` where it was not found.
    pub genera: Vec<Option<Genus>>,
}

/// The error for a form that is no plane curve.
pub(super) fn not_a_plane_curve(form: &Form) -> Error {
    let what = match form {
        Form::SpaceCurve(_) | Form::Intersection(_) => "a curve in space",
        _ => "a surface",
    };
    Error::Usage(format!(
        "--topology describes plane curves, and this is {what}"
    ))
}

/// The topology of the curve that is described; `None` if a limit was reached.
pub(super) fn topology_of(
    form: &Form,
    description: &Description,
    work: &Work,
) -> Result<Option<CurveTopology>> {
    let Some(polynomial) = polynomial_of(form) else {
        return Err(not_a_plane_curve(form));
    };
    let description = description.clone();
    let search = move |limits: &Limits| curve_topology(&polynomial, &description, limits);
    work.stage("topology", || work.unless_limited(Part::Topology, search))
}

/// The polynomial of a plane curve; the one of a radius is not needed.
fn polynomial_of(form: &Form) -> Option<PlanePolynomial> {
    match form {
        Form::Fourier(_) => Some(PlanePolynomial::from_terms([])),
        Form::Curve(curve) => Some(curve.polynomial().clone()),
        _ => None,
    }
}

fn curve_topology(
    f: &PlanePolynomial,
    description: &Description,
    limits: &Limits,
) -> Result<CurveTopology> {
    let topology = match &description.fourier {
        Some(born) => Topology::of_radius(&born.radius, description.origin_multiplicity, limits)?,
        None => Topology::of(f, limits)?,
    };
    let factors = description.factors.as_deref().unwrap_or(&[]);
    let genus = |factor: &crate::describe::DescribedFactor| match &factor.shape {
        // A curve that is parametrized by a series is rational.
        _ if description.fourier.is_some() && factors.len() == 1 => Ok(Some(Genus::rational())),
        Form::Curve(curve) => Genus::of(curve.polynomial(), limits),
        _ => Ok(None),
    };
    Ok(CurveTopology {
        genera: factors.iter().map(genus).collect::<Result<_>>()?,
        topology,
    })
}
