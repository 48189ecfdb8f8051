//! The equation of a plane curve, by a resultant.

use super::elliptic::resultant_of_series;
use super::map::RationalMap;
use super::proper::proper_parametrization;
use super::tracing::tracing_index_bound;
use crate::error::{Error, Result};
use crate::factor::squarefree_plane;
use crate::limits::Limits;
use crate::poly::{PlanePolynomial, SparsePolynomial, eliminate};
use crate::shape::{EllipticSeries, ImplicitCurve, PlaneCurve};

/// The equation of a parametric plane curve.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct PlaneEquation {
    /// The irreducible equation, primitive and with a positive first coefficient.
    pub curve: ImplicitCurve,
    /// How often the parametrization traces the curve while s runs through all complex numbers and infinity: the degree of Q(s)
    /// over Q(x, y). If the parameter is an angle, s runs through all numbers while the angle makes one turn.
    pub tracing_index: usize,
    /// Why the equation vanishes on the curve.
    pub proof: EquationProof,
}

/// Why an irreducible equation vanishes identically on the form that it was made from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EquationProof {
    /// The substitution of the form is 0, modulo primes whose product is larger than its coefficients could be.
    Substitution,
    /// The equation is the resultant itself, computed modulo primes whose product is larger than its coefficients could be.
    CoefficientBound,
}

/// Finds the implicit equation of a plane curve.
///
/// Write x = p1/q1 and y = p2/q2 in lowest terms, of degrees m and n in s. Then `Res_s(q1 X − p1, q2 Y − p2) = c f^k`, where f
/// is irreducible over Q and k is the tracing index; there is no extraneous factor (Sederberg; Sendra & Winkler, *Rational
/// Algebraic Curves*, Theorem 4.41). If k > 1, the curve first gets a parameter that traces it once, which divides both degrees
/// by k. If the coordinates are trigonometric polynomials and k = 1, the resultant is computed in z = e^(it), exactly: modulo
/// primes of which there are enough for its coefficients. Otherwise the returned f has three proofs. It vanishes identically on
/// the curve: its substitution is 0 modulo primes whose product is larger than its coefficients could be. Its degree in X is
/// n/k', where k' is an upper bound of the tracing index. So, by degrees, f is the minimal polynomial and k = k'.
///
/// ```
/// use stellate::implicitize::implicitize_plane;
/// use stellate::language::{Numbers, parse_form};
/// use stellate::limits::Limits;
/// use stellate::shape::Form;
///
/// // Example 1
/// let form = parse_form("x = sin(t); y = sin(t)*cos(t)", "<form>", Numbers::Exact)?;
/// let Form::PlaneCurve(curve) = form else { panic!("a plane curve") };
/// let equation = implicitize_plane(&curve, &Limits::none())?;
/// assert_eq!(equation.curve, match parse_form("x^4 - x^2 + y^2", "<form>", Numbers::Exact)? {
///     Form::Curve(expected) => expected,
///     _ => unreachable!(),
/// });
/// assert_eq!(equation.tracing_index, 1);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// Cost: m n³ products of residues for each of about (m + n)·(bits of a coefficient)/31 primes; the proof takes 2 m n (number
/// of terms) products for each of as many primes.
///
/// # Errors
/// [`Error::Hypothesis`] if both coordinates are constant; [`Error::Limit`] if the resultant is too large; those
/// of `limits`.
pub fn implicitize_plane(curve: &PlaneCurve, limits: &Limits) -> Result<PlaneEquation> {
    let [x, y] = curve.coordinates();
    if curve.is_point() {
        return Err(Error::Hypothesis {
            statement: "implicitization",
            witness: "all coordinates are constant: that is a point, not a curve".into(),
        });
    }
    let tracing_index = tracing_index_bound(curve.coordinates());
    // The resultant is exact, so it needs no proof by substitution.
    if tracing_index == 1
        && let Some(series) = EllipticSeries::of_plane_curve(curve)
        && let Some(resultant) = resultant_of_series(&series, limits)?
    {
        return Ok(PlaneEquation {
            curve: ImplicitCurve::new(resultant.primitive()),
            tracing_index,
            proof: EquationProof::CoefficientBound,
        });
    }
    let map = RationalMap::of_curve(curve);
    let proper = if tracing_index > 1 {
        proper_parametrization(curve.coordinates(), tracing_index, limits)?
    } else {
        Some(curve.coordinates().clone())
    };
    let [x_once, y_once] = proper.as_ref().unwrap_or(curve.coordinates());
    let f = eliminate(x_once, y_once, limits, |resultant| {
        let f = if proper.is_some() {
            resultant.primitive()
        } else {
            squarefree_plane(resultant, limits)?
        };
        let [in_x, in_y] = degrees(&f);
        let fits = in_x * tracing_index == y.degree() && in_y * tracing_index == x.degree();
        let proved = fits && map.annihilates(&SparsePolynomial::from(&f), limits)?;
        Ok(proved.then_some(f))
    })?;
    Ok(PlaneEquation {
        curve: ImplicitCurve::new(f),
        tracing_index,
        proof: EquationProof::Substitution,
    })
}

/// The degrees in x and in y.
fn degrees(f: &PlanePolynomial) -> [usize; 2] {
    f.terms()
        .fold([0, 0], |[a, b], ((i, j), _)| [a.max(i), b.max(j)])
}
