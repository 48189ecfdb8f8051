//! The claims of the verbs for proof files: everything that an output says of a form.

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::Work;
use crate::describe::Description;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::fit::Distances;
use crate::implicitize::{SquaredForm, SquaredHarmonics};
use crate::parametrize::{BranchRadius, Parametrization, Rationality};
use crate::sample::{HomogeneousParts, SampledRay, UnitVector};
use crate::shape::{Form, FourierRadius, HarmonicSurface, ImplicitSurface, Parameter, PlaneCurve};
use crate::sphere::Positivity;
use crate::witness::{self, Proof, curve_form, harmonic_form, radius_form, surface_form};

/// Claims all points of rays, those with r < 0 included. `form` is the index of the polynomial, and `center` the origin of the
/// coordinates of the points.
pub(super) fn claim_rays<P, D, const V: usize>(
    proof: &mut Proof,
    form: Option<usize>,
    polynomial: &P,
    center: &[Rational; V],
    rays: &[SampledRay<D, V>],
    work: &Work,
) -> Result<()>
where
    P: HomogeneousParts<V> + Sync,
    D: UnitVector<V> + Sync,
{
    let claims = rays.par_iter().map(|SampledRay { direction, ray }| {
        work.bounds().check()?;
        Ok(witness::ray(form, polynomial, center, direction, ray))
    });
    for claim in claims.collect::<Result<Vec<_>>>()? {
        proof.add(claim);
    }
    Ok(())
}

/// Claims the factors, that they are irreducible, and the sign of a radius.
pub(super) fn claim_description(
    proof: &mut Proof,
    form: &Form,
    description: &Description,
    work: &Work,
) -> Result<()> {
    if let Some(fourier) = &description.fourier {
        witness::positive_radius(proof, &fourier.radius, fourier.star_shaped());
    }
    let Some(factors) = &description.factors else {
        return Ok(());
    };
    let mut indices = Vec::new();
    let mut product = Rational::one();
    for factor in factors {
        let (index, first) = match &factor.shape {
            Form::Curve(curve) => {
                let index = curve_form(proof, curve.polynomial());
                match &description.fourier {
                    Some(fourier) if !fourier.perfect_square => {
                        let series = radius_form(proof, &fourier.radius);
                        witness::of_radius(proof, index, series, false, "center");
                    }
                    _ => witness::irreducible(proof, index, curve.polynomial(), work.bounds())?,
                }
                (index, curve.polynomial().first_coefficient())
            }
            Form::Surface(surface) => {
                let index = surface_form(proof, surface.polynomial());
                witness::irreducible(proof, index, surface.polynomial(), work.bounds())?;
                (index, first_of(surface))
            }
            _ => return Ok(()),
        };
        indices.push((index, factor.multiplicity));
        let first = first.invariant("a factor is not 0");
        for _ in 0..factor.multiplicity {
            product = &product * &first;
        }
    }
    let (whole, first) = match form {
        Form::Curve(curve) => (
            curve_form(proof, curve.polynomial()),
            curve.polynomial().first_coefficient(),
        ),
        Form::Surface(surface) => (surface_form(proof, surface.polynomial()), first_of(surface)),
        _ => return Ok(()),
    };
    let first = first.invariant("a polynomial with factors is not 0");
    witness::factors(proof, whole, &(&first / &product), &indices);
    Ok(())
}

fn first_of(surface: &ImplicitSurface) -> Option<Rational> {
    let first = surface.polynomial().terms().next();
    first.map(|(_, coefficient)| coefficient.clone())
}

/// Claims that the equation, in the coordinates `center` or `original`, belongs to the form, that it is irreducible, and what is found of the real image.
pub(super) fn claim_equation(
    proof: &mut Proof,
    form: &Form,
    found: &Form,
    coordinates: &'static str,
    work: &Work,
) -> Result<()> {
    let (indices, degrees) = match found {
        Form::Curve(curve) => {
            let f = curve.polynomial();
            (vec![curve_form(proof, f)], vec![f.degree()])
        }
        Form::Surface(surface) => surface_forms(proof, std::slice::from_ref(surface)),
        Form::Intersection(surfaces) => surface_forms(proof, surfaces),
        _ => return Ok(()),
    };
    let degrees: Vec<usize> = degrees.into_iter().flatten().collect();
    match form {
        Form::Fourier(radius) => {
            let is_square = SquaredForm::new(radius)?.is_perfect_square();
            let series = radius_form(proof, radius);
            witness::of_radius(proof, indices[0], series, is_square, coordinates);
            if !is_square {
                return Ok(());
            }
        }
        Form::Harmonic(surface) => {
            let is_square = SquaredHarmonics::new(surface)?.is_perfect_square();
            let series = harmonic_form(proof, surface);
            witness::of_radius(proof, indices[0], series, is_square, "center");
            if !is_square {
                return Ok(());
            }
        }
        Form::PlaneCurve(_) | Form::SpaceCurve(_) | Form::Patch(_) => {
            witness::identity(proof, &indices, &degrees, form);
            witness::unproved(proof, "tracing-index", &indices);
            witness::unproved(proof, "real-image", &indices);
        }
        _ => return Ok(()),
    }
    match found {
        Form::Curve(curve) => {
            witness::irreducible(proof, indices[0], curve.polynomial(), work.bounds())
        }
        Form::Surface(surface) => {
            witness::irreducible(proof, indices[0], surface.polynomial(), work.bounds())
        }
        _ => Ok(()),
    }
}

/// The indices of polynomials, and their degrees.
fn surface_forms(
    proof: &mut Proof,
    surfaces: &[ImplicitSurface],
) -> (Vec<Option<usize>>, Vec<Option<usize>>) {
    let of = |surface: &ImplicitSurface| {
        let f = surface.polynomial();
        let degree = f.degree().and_then(|degree| usize::try_from(degree).ok());
        (surface_form(proof, f), degree)
    };
    surfaces.iter().map(of).unzip()
}

/// Claims the radii and the rational parametrizations of a curve, and names what has no witness.
pub(super) fn claim_branches(proof: &mut Proof, found: &Parametrization) {
    let Form::Curve(curve) = &found.of else {
        return;
    };
    let form = curve_form(proof, curve.polynomial());
    let degree = curve.polynomial().degree().into_iter();
    let degrees: Vec<usize> = degree.collect();
    let is_irreducible = found.branches.iter().all(|branch| branch.factor == 0);
    for (index, branch) in found.branches.iter().enumerate() {
        match &branch.radius {
            BranchRadius::Fourier(radius) if is_irreducible => {
                let is_square = SquaredForm::new(radius).is_ok_and(|f| f.is_perfect_square());
                let series = radius_form(proof, radius);
                witness::of_radius(proof, form, series, is_square, "center");
            }
            _ => witness::unproved_branch(proof, "closed-form", form, index),
        }
        witness::unproved_branch(proof, "ranges", form, index);
    }
    for rational in &found.rational {
        if let (true, Rationality::Parametrized(curve)) = (is_irreducible, &rational.rationality) {
            let coordinates = [curve.x.clone(), curve.y.clone()];
            let traced = PlaneCurve::new(Parameter::number("t"), coordinates);
            witness::identity(proof, &[form], &degrees, &Form::PlaneCurve(traced));
        }
    }
}

/// Claims what is reported of a fit: of a radius, whether it is positive, if that is known, and its largest error; and the
/// distances from the outline.
pub(super) fn claim_fit(
    proof: &mut Proof,
    radius: Option<(&FourierRadius, Option<bool>, f64)>,
    distances: Option<&Distances>,
) {
    if let Some((radius, is_positive, error)) = radius {
        if let Some(is_positive) = is_positive {
            witness::positive_radius(proof, radius, is_positive);
        }
        witness::unproved_number(proof, "fit-error", "max", error);
    }
    if let Some(distances) = distances {
        witness::unproved_number(
            proof,
            "hausdorff-distance",
            "high",
            distances.hausdorff.high,
        );
        witness::unproved_number(proof, "overlap", "overlap", distances.overlap);
    }
}

/// Claims the sign of a sum of spherical harmonics, if it is known, its equation, and that this is irreducible.
pub(super) fn claim_harmonics(
    proof: &mut Proof,
    surface: &HarmonicSurface,
    equation: &SquaredHarmonics,
    positivity: &Positivity,
    work: &Work,
) -> Result<()> {
    match positivity {
        Positivity::Positive { .. } => witness::positive_sphere(proof, surface, None),
        Positivity::NotPositive { direction, .. } => {
            witness::positive_sphere(proof, surface, Some(direction));
        }
        Positivity::Unknown => {}
    }
    let series = harmonic_form(proof, surface);
    let is_square = equation.is_perfect_square();
    let expanded = equation.expand();
    let form = surface_form(proof, expanded.polynomial());
    witness::of_radius(proof, form, series, is_square, "center");
    match is_square {
        true => witness::irreducible(proof, form, expanded.polynomial(), work.bounds()),
        false => Ok(()),
    }
}
