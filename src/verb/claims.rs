//! The claims of the verbs for proof files: everything that an output says of a form.

use serde_json::json;

use super::Work;
use super::topology::CurveTopology;
use crate::arcs::IntersectionArcs;
use crate::describe::Description;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::factor::{factor_plane, factor_space};
use crate::fit::Distances;
use crate::implicitize::{SquaredForm, SquaredHarmonics};
use crate::parallel;
use crate::parametrize::{
    BranchRadius, IntersectionParametrization, Parametrization, Rationality,
    SurfaceParametrization, born_of_radius, critical_slopes, is_full_circle, is_positive,
};
use crate::poly::PlanePolynomial;
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
    let claims = parallel::try_map(rays, work.bounds(), |SampledRay { direction, ray }| {
        Ok(witness::ray(form, polynomial, center, direction, ray))
    });
    for claim in claims? {
        proof.add(claim);
    }
    Ok(())
}

/// Claims without a witness that so many zeros of the equation of a parametric curve, on rays, have no real parameter.
pub(super) fn claim_left_out(proof: &mut Proof, equation: &PlanePolynomial, count: usize) {
    let statement = json!({ "equations": [curve_form(proof, equation)], "left_out": count });
    witness::unproved(proof, "real-image", &statement);
}

/// Claims all points of rays of a superquadric with these semi-axes, exponents ε and level, without witnesses.
pub(super) fn claim_superquadric_rays<D: UnitVector<V>, const V: usize>(
    proof: &mut Proof,
    shape: [&[Rational]; 3],
    rays: &[SampledRay<D, V>],
) {
    for SampledRay { direction, ray } in rays {
        proof.add(witness::superquadric_ray(shape, direction, ray));
    }
}

/// Claims that all common points of two surfaces in a box lie near the arcs that were found, or in boxes that are not resolved,
/// without a witness.
pub(super) fn claim_arcs(
    proof: &mut Proof,
    surfaces: &[ImplicitSurface],
    found: &IntersectionArcs,
) {
    let (indices, _) = surface_forms(proof, surfaces);
    let ends = |[a, b]: &[f64; 2]| [format!("{a:e}"), format!("{b:e}")];
    let sides = found.bounds.each_ref().map(ends);
    let [arcs, open] = [found.arcs.len(), found.unresolved.len()];
    let statement = json!({ "equations": indices, "box": sides, "arcs": arcs, "unresolved": open });
    witness::unproved(proof, "real-image", &statement);
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
    let mut entered = Vec::new();
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
        let first = first.invariant("a factor is not 0");
        entered.push((index, factor.multiplicity, first));
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
    claim_product(proof, whole, &first, &entered);
    Ok(())
}

/// Claims that a polynomial with this first coefficient is a product of factors, given by their indices, multiplicities and first
/// coefficients.
fn claim_product(
    proof: &mut Proof,
    whole: Option<usize>,
    first: &Rational,
    factors: &[(Option<usize>, usize, Rational)],
) {
    let mut product = Rational::one();
    for (_, multiplicity, first) in factors {
        for _ in 0..*multiplicity {
            product = &product * first;
        }
    }
    let indices: Vec<_> = factors.iter().map(|(index, m, _)| (*index, *m)).collect();
    witness::factors(proof, whole, &(first / &product), &indices);
}

/// Claims what is found of the components of a curve and of the genus of its factors, without witnesses.
pub(super) fn claim_topology(proof: &mut Proof, form: &Form, found: &CurveTopology) {
    let form = match form {
        Form::Curve(curve) => curve_form(proof, curve.polynomial()),
        Form::Fourier(radius) => radius_form(proof, radius),
        _ => None,
    };
    if let Some(topology) = &found.topology {
        let statement = json!({
            "form": form,
            "components": topology.components.len(),
            "singular_points": topology.singular_points.len(),
        });
        witness::unproved(proof, "topology", &statement);
    }
    for (factor, genus) in found.genera.iter().enumerate() {
        if genus.is_some() {
            let statement = json!({ "form": form, "factor": factor });
            witness::unproved(proof, "genus", &statement);
        }
    }
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
            witness::of_radius(proof, indices[0], series, is_square, coordinates);
            if !is_square {
                return Ok(());
            }
        }
        Form::PlaneCurve(_) | Form::SpaceCurve(_) | Form::Patch(_) => {
            witness::identity(proof, &indices, &degrees, form);
            let statement = json!({ "equations": indices });
            witness::unproved(proof, "tracing-index", &statement);
            witness::unproved(proof, "real-image", &statement);
        }
        Form::Superquadric(_) | Form::SpaceSuperquadric(_) => {
            let statement = json!({ "equations": indices, "curve": null });
            witness::unproved(proof, "identity", &statement);
        }
        // An equation is written as it was given.
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

/// Claims the factors of a curve, its radii, in which directions they are real, and its rational parametrizations.
pub(super) fn claim_branches(
    proof: &mut Proof,
    found: &Parametrization,
    work: &Work,
) -> Result<()> {
    let factors = match &found.of {
        // The equation of a series is irreducible, or the square of an irreducible polynomial.
        Form::Curve(curve) if born_of_radius(curve).is_some() => vec![curve.polynomial().clone()],
        Form::Curve(curve) => claim_factors(proof, curve.polynomial(), work)?,
        _ => Vec::new(),
    };
    let forms: Vec<_> = factors.iter().map(|f| curve_form(proof, f)).collect();
    for (index, branch) in found.branches.iter().enumerate() {
        let factor = forms.get(branch.factor).copied().flatten();
        let statement = json!({ "form": factor, "branch": index });
        match &branch.radius {
            BranchRadius::Fourier(radius) if branch.factor < forms.len() => {
                let is_square = SquaredForm::new(radius)?.is_perfect_square();
                let series = radius_form(proof, radius);
                witness::of_radius(proof, factor, series, is_square, "center");
                // If r has one sign everywhere, this says all about its ranges.
                let of_one_sign = if is_full_circle(&branch.positive) {
                    Some(radius.clone())
                } else {
                    let negated = branch.positive.is_empty().then(|| negated(radius));
                    negated.filter(is_positive)
                };
                if let Some(positive) = of_one_sign {
                    witness::positive_radius(proof, &positive, true);
                    continue;
                }
            }
            // A root in each direction is all that there is to say; the sectors say how many there are.
            BranchRadius::Root(_) => {}
            _ => witness::unproved(proof, "closed-form", &statement),
        }
        // What happens within the cuts between the sectors, once for a factor.
        witness::unproved(proof, "ranges", &json!({ "form": factor }));
    }
    for f in &factors {
        if let Some(slopes) = critical_slopes(f, work.bounds())? {
            witness::sectors(proof, f, &slopes, work.bounds())?;
        }
    }
    for rational in &found.rational {
        if let (Some(f), Rationality::Parametrized(curve)) =
            (factors.get(rational.factor), &rational.rationality)
        {
            let coordinates = [curve.x.clone(), curve.y.clone()];
            let traced = PlaneCurve::new(Parameter::number("t"), coordinates);
            let degree: Vec<usize> = f.degree().into_iter().collect();
            let form = forms[rational.factor];
            witness::identity(proof, &[form], &degree, &Form::PlaneCurve(traced));
        }
    }
    Ok(())
}

/// The radius −r.
fn negated(radius: &FourierRadius) -> FourierRadius {
    let of = |list: &[Rational]| list.iter().map(|c| -c).collect();
    FourierRadius::new(of(radius.cosines()), of(radius.sines()))
        .with_center(radius.center().clone())
}

/// Claims the factors of a polynomial, and that they are irreducible, unless it is irreducible itself.
fn claim_factors(
    proof: &mut Proof,
    f: &PlanePolynomial,
    work: &Work,
) -> Result<Vec<PlanePolynomial>> {
    let factors = factor_plane(f, work.bounds())?.factors;
    let whole = curve_form(proof, f);
    let mut entered = Vec::new();
    for factor in &factors {
        let index = curve_form(proof, &factor.polynomial);
        witness::irreducible(proof, index, &factor.polynomial, work.bounds())?;
        let first = factor.polynomial.first_coefficient();
        let first = first.invariant("a factor is not 0");
        entered.push((index, factor.multiplicity, first));
    }
    let first = f.first_coefficient();
    let first = first.invariant("a polynomial with factors is not 0");
    claim_product(proof, whole, &first, &entered);
    Ok(factors
        .into_iter()
        .map(|factor| factor.polynomial)
        .collect())
}

/// Claims that sums of spherical harmonics are radii of a surface, which is about the origin.
pub(super) fn claim_harmonic_radii(
    proof: &mut Proof,
    surface: &ImplicitSurface,
    radii: &[HarmonicSurface],
) -> Result<()> {
    let form = surface_form(proof, surface.polynomial());
    for radius in radii {
        let is_square = SquaredHarmonics::new(radius)?.is_perfect_square();
        let series = harmonic_form(proof, radius);
        witness::of_radius(proof, form, series, is_square, "center");
    }
    Ok(())
}

/// Claims the factors of a surface and, without witnesses, its branches.
pub(super) fn claim_surface_branches(
    proof: &mut Proof,
    found: &SurfaceParametrization,
    is_asked_for_ranges: bool,
    work: &Work,
) -> Result<()> {
    let form = match &found.of {
        Form::Surface(surface) => {
            claim_surface_factors(proof, surface, work)?;
            surface_form(proof, surface.polynomial())
        }
        _ => None,
    };
    for branch in 0..found.branches.len() {
        let statement = json!({ "form": form, "branch": branch });
        witness::unproved(proof, "closed-form", &statement);
        if is_asked_for_ranges {
            witness::unproved(proof, "ranges", &statement);
        }
    }
    Ok(())
}

/// Claims the factors of the polynomial of a surface, and that they are irreducible.
fn claim_surface_factors(proof: &mut Proof, surface: &ImplicitSurface, work: &Work) -> Result<()> {
    let whole = surface_form(proof, surface.polynomial());
    let mut entered = Vec::new();
    for factor in factor_space(surface.polynomial(), work.bounds())?.factors {
        let multiplicity = factor.multiplicity;
        let factor = ImplicitSurface::new(factor.polynomial);
        let index = surface_form(proof, factor.polynomial());
        witness::irreducible(proof, index, factor.polynomial(), work.bounds())?;
        let first = first_of(&factor).invariant("a factor is not 0");
        entered.push((index, multiplicity, first));
    }
    let first = first_of(surface).invariant("a polynomial with factors is not 0");
    claim_product(proof, whole, &first, &entered);
    Ok(())
}

/// Claims that curves are components of the intersection of surfaces, and, without a witness, that there are no others.
pub(super) fn claim_intersection(
    proof: &mut Proof,
    surfaces: &[ImplicitSurface],
    found: &IntersectionParametrization,
) {
    let (indices, degrees) = surface_forms(proof, surfaces);
    let degrees: Vec<usize> = degrees.into_iter().flatten().collect();
    for curve in &found.curves {
        let form = Form::SpaceCurve(curve.clone());
        witness::identity(proof, &indices, &degrees, &form);
    }
    let statement = json!({ "equations": indices, "curves": found.curves.len() });
    witness::unproved(proof, "real-image", &statement);
}

/// What a fit says of a radius.
pub(super) struct FittedRadius<'a> {
    pub(super) radius: &'a FourierRadius,
    /// Whether r > 0 for every angle, if that is known.
    pub(super) is_positive: Option<bool>,
    /// The points that were fitted, or the vertices of the outline.
    pub(super) points: &'a [[f64; 2]],
    /// The largest error and the root of the mean square.
    pub(super) errors: [f64; 2],
    /// Whether these are the errors at the points, all of which count alike.
    pub(super) is_at_points: bool,
}

/// Claims what is reported of a fit: of a radius, whether it is positive, and its errors; and the distances from the outline.
pub(super) fn claim_fit(
    proof: &mut Proof,
    fitted: Option<&FittedRadius<'_>>,
    distances: Option<&Distances>,
) {
    if let Some(fitted) = fitted {
        if let Some(is_positive) = fitted.is_positive {
            witness::positive_radius(proof, fitted.radius, is_positive);
        }
        let stated = fitted.is_at_points.then_some(fitted.errors);
        witness::fit_error(proof, fitted.radius, fitted.points, stated);
        if !fitted.is_at_points {
            // The largest error in more directions than those of the points.
            let [max, rms] = fitted.errors.map(|error| error.to_string());
            witness::unproved(proof, "fit-error", &json!({ "max": max, "rms": rms }));
        }
    }
    if let Some(distances) = distances {
        let [low, high] =
            [distances.hausdorff.low, distances.hausdorff.high].map(|d| d.to_string());
        let statement = json!({ "low": low, "high": high });
        witness::unproved(proof, "hausdorff-distance", &statement);
        let statement = json!({ "overlap": distances.overlap.to_string() });
        witness::unproved(proof, "overlap", &statement);
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
