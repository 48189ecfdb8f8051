//! Claims about equations: where they come from, their factors, and why those are irreducible (T2, T3, T4).

use serde_json::{Value, json};

use super::forms::parametric_form;
use super::line::LinePoly;
use super::line::line_and_prime;
use super::proof::{Proof, by_expansion};
use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::shape::Form;

/// The products of two polynomials that a checker multiplies at most.
const MOST_PRODUCTS: usize = 30_000_000;

/// Claims that the polynomial of the index `form` is that of Theorem 2 for the radius of the index `series`, in coordinates about its center or in the
/// original ones: `series-equation`; and that it is irreducible. If the polynomial of the theorem is the square of this one, the
/// second is not claimed here.
pub(crate) fn of_radius(
    proof: &mut Proof,
    form: Option<usize>,
    series: Option<usize>,
    is_square: bool,
    coordinates: &'static str,
) {
    let both = form.is_some() && series.is_some();
    let mut statement = json!({ "form": form, "radius": series, "coordinates": coordinates });
    if is_square {
        statement["square"] = json!(true);
    }
    proof.claim(
        "series-equation",
        &statement,
        both.then(by_expansion).flatten(),
    );
    if is_square {
        return;
    }
    let witness = json!({ "radius": series, "coordinates": coordinates });
    proof.claim(
        "irreducible",
        &json!({ "form": form }),
        both.then_some(witness),
    );
}

/// Claims that equations vanish on a curve or patch with parameters: `identity`.
pub(crate) fn identity(
    proof: &mut Proof,
    equations: &[Option<usize>],
    degrees: &[usize],
    form: &Form,
) {
    let curve = parametric_form(proof, form);
    let parameters = if matches!(form, Form::Patch(_)) { 2 } else { 1 };
    // A substitution of degree d in functions of degree m has about d m^p terms for p parameters.
    let cost = |degree: usize| {
        let terms = degree
            .checked_mul(size(form)?)?
            .checked_pow(parameters + 1)?;
        terms.checked_mul(degree)
    };
    let is_short = degrees
        .iter()
        .all(|&degree| cost(degree).is_some_and(|cost| cost <= MOST_PRODUCTS));
    let all = equations.iter().all(Option::is_some) && curve.is_some() && is_short;
    let statement = json!({ "equations": equations, "curve": curve });
    proof.claim("identity", &statement, all.then(by_expansion).flatten());
}

/// The largest degree of a coordinate in a parameter; `None` for a form without parameters.
fn size(form: &Form) -> Option<usize> {
    match form {
        Form::PlaneCurve(curve) => curve.coordinates().iter().map(|f| f.degree()).max(),
        Form::SpaceCurve(curve) => curve.coordinates().iter().map(|f| f.degree()).max(),
        Form::Patch(patch) => patch
            .coordinates()
            .iter()
            .map(|f| f.degree_in(0).max(f.degree_in(1)) as usize)
            .max(),
        _ => None,
    }
}

/// Claims that a polynomial is irreducible over Q, with a line and a prime as the witness if one is found: `irreducible`.
///
/// # Errors
/// Those of `limits`.
pub(crate) fn irreducible<const V: usize>(
    proof: &mut Proof,
    form: Option<usize>,
    polynomial: &impl LinePoly<V>,
    limits: &Limits,
) -> Result<()> {
    let witness = match form {
        Some(_) => line_and_prime(polynomial, limits)?,
        None => None,
    };
    proof.claim("irreducible", &json!({ "form": form }), witness);
    Ok(())
}

/// Claims that a polynomial is a constant times a product of powers of factors, each given by its index and multiplicity:
/// `factorization`.
pub(crate) fn factors(
    proof: &mut Proof,
    form: Option<usize>,
    constant: &Rational,
    factors: &[(Option<usize>, usize)],
) {
    let all = form.is_some() && factors.iter().all(|(index, _)| index.is_some());
    let list: Vec<Value> = factors
        .iter()
        .map(|(index, multiplicity)| json!({ "form": index, "multiplicity": multiplicity }))
        .collect();
    let statement = json!({ "form": form, "constant": constant.to_string(), "factors": list });
    proof.claim(
        "factorization",
        &statement,
        all.then(by_expansion).flatten(),
    );
}

/// Makes a claim that has no witness.
pub(crate) fn unproved(proof: &mut Proof, name: &'static str, statement: &Value) {
    proof.claim(name, statement, None);
}
