//! Forms as proof files write them.

use serde_json::{Value, json};

use super::proof::{LONGEST_NUMBER, Proof};
use crate::exact::Rational;
use crate::poly::{PlanePolynomial, RationalFunction, SparsePolynomial};
use crate::shape::{Form, FourierRadius, HarmonicSurface, Patch};

/// The largest degree of a polynomial, and the largest number of its terms, in a proof file.
const MOST_DEGREE: usize = 512;
const MOST_TERMS: usize = 100_000;
/// The largest number of harmonics of a radius in a proof file.
const MOST_HARMONICS: usize = 511;
/// The largest degree of a sum of spherical harmonics in a proof file.
const MOST_SPHERICAL: usize = 128;
/// The longest number in a proof file has 20 000 characters.
const MOST_BITS: u64 = 66_000;

/// The index of the polynomial of a plane curve in the coordinates of that polynomial; `None` beyond the limits of the format.
pub(crate) fn curve_form(proof: &mut Proof, f: &PlanePolynomial) -> Option<usize> {
    let fits = f.degree()? <= MOST_DEGREE && f.coefficient_bits() / 2 <= MOST_BITS;
    let terms = f.terms().map(|((i, j), c)| term(&[i as u64, j as u64], &c));
    fits.then(|| implicit(proof, &["x", "y"], terms.collect()))
        .flatten()
}

/// The index of the polynomial of a surface; `None` beyond the limits of the format.
pub(crate) fn surface_form(proof: &mut Proof, f: &SparsePolynomial<3>) -> Option<usize> {
    let fits = f.degree()? <= MOST_DEGREE as u64;
    let terms = f.terms().map(|(e, c)| term(&e.map(u64::from), c)).collect();
    fits.then(|| implicit(proof, &["x", "y", "z"], terms))
        .flatten()
}

fn implicit(proof: &mut Proof, variables: &[&str], terms: Vec<Value>) -> Option<usize> {
    let fits = !terms.is_empty() && terms.len() <= MOST_TERMS;
    fits.then(|| proof.form(&json!({ "kind": "implicit", "variables": variables, "terms": terms })))
}

/// The index of a Fourier radius with its center; `None` beyond the limits of the format.
pub(crate) fn radius_form(proof: &mut Proof, radius: &FourierRadius) -> Option<usize> {
    if radius.harmonics() > MOST_HARMONICS || !is_short(radius.center()) {
        return None;
    }
    let mut form = json!({
        "kind": "fourier",
        "cos": texts(radius.cosines()),
        "sin": texts(radius.sines()),
    });
    if radius.center().iter().any(|c| !c.is_zero()) {
        form["center"] = texts(radius.center());
    }
    Some(proof.form(&form))
}

/// The index of a sum of spherical harmonics with its center; `None` beyond the limits of the format.
pub(crate) fn harmonic_form(proof: &mut Proof, surface: &HarmonicSurface) -> Option<usize> {
    if surface.degree() > MOST_SPHERICAL || !is_short(surface.center()) {
        return None;
    }
    let coefficients: Vec<Value> = surface
        .terms()
        .map(|(l, m, value)| json!({ "l": l, "m": m, "value": value.to_string() }))
        .collect();
    let mut form = json!({
        "kind": "spherical",
        "degree": surface.degree(),
        "coefficients": coefficients,
    });
    if !surface.is_centered() {
        form["center"] = texts(surface.center());
    }
    Some(proof.form(&form))
}

/// The index of a curve or patch with its parameters, as rational functions of them or of the tangents of their halves; `None`
/// beyond the limits of the format, or for another form.
pub(super) fn parametric_form(proof: &mut Proof, form: &Form) -> Option<usize> {
    let of_curve = |functions: &[RationalFunction]| {
        let fits = functions.iter().all(|f| f.degree() <= MOST_DEGREE);
        fits.then(|| {
            let coordinates: Vec<Value> = functions.iter().map(coordinate).collect();
            json!({ "kind": "parametric", "parameters": ["rational"], "coordinates": coordinates })
        })
    };
    let form = match form {
        Form::PlaneCurve(curve) => of_curve(curve.coordinates())?,
        Form::SpaceCurve(curve) => of_curve(curve.coordinates())?,
        Form::Patch(patch) => of_patch(patch),
        _ => return None,
    };
    Some(proof.form(&form))
}

fn coordinate(f: &RationalFunction) -> Value {
    let [numerator, denominator] = f.coefficients().map(|coefficients| {
        let terms = coefficients.iter().enumerate();
        let terms = terms.filter(|(_, c)| !c.is_zero());
        terms
            .map(|(i, c)| term(&[i as u64], c))
            .collect::<Vec<Value>>()
    });
    json!({ "numerator": numerator, "denominator": denominator })
}

fn of_patch(patch: &Patch) -> Value {
    let terms = |f: &SparsePolynomial<2>| -> Vec<Value> {
        f.terms().map(|(e, c)| term(&e.map(u64::from), c)).collect()
    };
    let coordinates: Vec<Value> = patch
        .coordinates()
        .iter()
        .map(
            |f| json!({ "numerator": terms(f.numerator()), "denominator": terms(f.denominator()) }),
        )
        .collect();
    json!({ "kind": "parametric", "parameters": ["rational", "rational"], "coordinates": coordinates })
}

fn term(exponents: &[u64], coefficient: &Rational) -> Value {
    json!({ "exponents": exponents, "coefficient": coefficient.to_string() })
}

/// Whether all coordinates are as short as a proof file needs them.
fn is_short(point: &[Rational]) -> bool {
    point.iter().all(|c| c.to_string().len() <= LONGEST_NUMBER)
}

/// Exact numbers as a list of texts.
pub(super) fn texts(numbers: &[Rational]) -> Value {
    numbers.iter().map(Rational::to_string).collect()
}
