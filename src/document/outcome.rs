//! Writers for the outcomes of verbs. Each outcome has the formats of its [`Kind`].

use std::io::Write;

use super::{
    Format, Kind, arcs_text,
    harmonic::{write_harmonic_description, write_harmonic_radii},
    write_arcs, write_description, write_implicit, write_intersection, write_intersection_curves,
    write_parametrization, write_samples, write_space_curve_description,
    write_space_superquadric_description, write_superquadric_description, write_surface,
    write_surface_parametrization,
};
use crate::error::{Error, Result};
use crate::shape::Form;
use crate::verb::{
    DIGITS, Described, DescribedForm, Implicitization, Parametrized, SampledPoints, Samples,
};

/// Writes the equation or equations that `implicitize` found, with the facts about them.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub fn write_implicitization(
    found: &Implicitization,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    match &found.form {
        Form::Curve(curve) => write_implicit(curve, &found.facts, format, out),
        Form::Surface(surface) => write_surface(surface, &found.facts, format, out),
        Form::Intersection(surfaces) => write_intersection(surfaces, &found.facts, format, out),
        _ => Err(Error::internal(
            "implicitize",
            "the result is one equation or several",
        )),
    }
}

/// Writes the description of a form; angles have `digits` decimals.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub fn write_described(
    found: &Described,
    digits: u32,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    DIGITS.check(digits)?;
    match &found.what {
        DescribedForm::Equation(description) => write_description(
            description,
            &found.facts,
            found.topology.as_ref(),
            digits,
            format,
            out,
        ),
        DescribedForm::Intersection(surfaces) => {
            write_space_curve_description(surfaces, &found.facts, format, out)
        }
        DescribedForm::Harmonic(described) => {
            write_harmonic_description(described, &found.facts, format, out)
        }
        DescribedForm::Superquadric(shape) => write_superquadric_description(shape, format, out),
        DescribedForm::SpaceSuperquadric(shape) => {
            write_space_superquadric_description(shape, format, out)
        }
    }
}

/// Writes the parametric form that `parametrize` found; angles have `digits` decimals.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub fn write_parametrized(
    found: &Parametrized,
    digits: u32,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    DIGITS.check(digits)?;
    match found {
        Parametrized::Curve { polar, fit } => {
            if !found.is_series() {
                Kind::ClosedForms.check(format)?;
            }
            write_parametrization(polar, fit.as_ref(), digits, format, out)
        }
        Parametrized::Harmonics(radii) => write_harmonic_radii(radii, format, out),
        Parametrized::Surface {
            spherical,
            meridians,
            directions,
        } => write_surface_parametrization(spherical, meridians, directions, digits, format, out),
        Parametrized::Intersection {
            arcs: Some(arcs), ..
        } if format == Format::Csv => write_arcs(arcs, format, out),
        Parametrized::Intersection { found, arcs } => {
            write_intersection_curves(found, arcs.as_ref(), format, out)
        }
    }
}

/// Writes certified points.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub fn write_sampled(found: &Samples, format: Format, out: &mut dyn Write) -> Result<()> {
    match &found.points {
        SampledPoints::Plane { rays, center } => write_samples(rays, center, format, out),
        SampledPoints::Space { rays, center } => write_samples(rays, center, format, out),
        SampledPoints::Arcs(arcs) => write_arcs(arcs, format, out),
    }
}

/// Lines of text that accompany the table of certified points. Only arcs have any, see [`Samples`].
#[must_use]
pub fn sampled_text(found: &Samples) -> Vec<String> {
    match &found.points {
        SampledPoints::Arcs(arcs) => arcs_text(arcs),
        SampledPoints::Plane { .. } | SampledPoints::Space { .. } => Vec::new(),
    }
}
