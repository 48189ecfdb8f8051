//! The topology of a plane curve, for `describe` and `plot`.

use super::{Part, Work};
use crate::describe::Description;
use crate::error::{Error, Result};
use crate::limits::Limits;
use crate::shape::Form;
use crate::topology::{Genus, Topology};

/// The topology of the zero set of the equation of a form.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct CurveTopology {
    /// The components, singular points and asymptotes; `None` if a limit was reached.
    pub topology: Option<Topology>,
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

/// The topology of the curve that is described. `is_rational` says that it was given by rational functions of a parameter.
pub(super) fn topology_of(
    form: &Form,
    description: &Description,
    is_rational: bool,
    work: &Work,
) -> Result<CurveTopology> {
    let polynomial = match form {
        Form::Curve(curve) => Some(curve.polynomial().clone()),
        Form::Fourier(_) => None,
        _ => return Err(not_a_plane_curve(form)),
    };
    let born = description.fourier.as_ref();
    let radius = born.map(|born| (born.radius.clone(), description.origin_multiplicity));
    let find = move |limits: &Limits| match (radius, polynomial) {
        (Some((radius, multiplicity)), _) => Topology::of_radius(&radius, multiplicity, limits),
        (None, Some(polynomial)) => Topology::of(&polynomial, limits),
        (None, None) => Err(Error::internal(
            "the topology of a form",
            "a radius has a description as a radius",
        )),
    };
    let topology = work.stage("topology", || work.unless_limited(Part::Topology, find))?;
    let factors = description.factors.clone().unwrap_or_default();
    // An irreducible curve with a parametrization by rational functions, or by a series, is rational.
    let is_rational = (is_rational || born.is_some()) && factors.len() == 1;
    let mut genera = Vec::with_capacity(factors.len());
    for factor in factors {
        genera.push(match factor.shape {
            _ if is_rational => Some(Genus::rational()),
            Form::Curve(curve) => {
                let find = move |limits: &Limits| Genus::of(curve.polynomial(), limits);
                let found = work.stage("genus", || work.unless_limited(Part::Genus, find))?;
                found.flatten()
            }
            _ => None,
        });
    }
    Ok(CurveTopology { topology, genera })
}
