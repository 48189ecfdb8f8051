//! Which real points of a curve real values of the parameter reach.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::inverse::{Inverse, invert};
use super::isolated::{Isolated, isolated, to_univariate_as_is};
use super::tracing::common_numerator;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{
    IntegerPolynomial, RationalFunction, RealRoot, SparsePolynomial, polynomial_gcd, real_roots,
};
use crate::shape::ParametricCurve;

/// What the real zero set has beyond the points of real parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct RealImage<const N: usize> {
    /// The point that is only approached, as the parameter goes to infinity.
    pub approached: Option<[Rational; N]>,
    /// How much of the one-dimensional part is reached.
    pub coverage: Coverage<N>,
    /// Isolated real points: those that only two conjugate complex parameters reach.
    pub isolated: Isolated<N>,
}

/// How much of the curve is reached.
#[derive(Clone, Debug, PartialEq)]
pub enum Coverage<const N: usize> {
    /// All of it, but for finitely many points.
    Whole,
    /// Real parameters run to and fro between the points of these parameter values (roundings of exact ones;
    /// infinite for s = ∞); beyond them the curve goes on.
    Part(Vec<f64>),
    /// Not decided.
    Unknown,
}

/// What the real zero set of a curve has beyond the real image of the parametrization.
///
/// - A parameter that is a number reaches infinity only in the limit.
/// - With tracing index k > 1 the point is a function of a function m(s) of degree k (Lüroth). If k is odd, or if m
///   has no real turning point, real values of s reach all real values of m.
/// - With k = 1, or in m, the finitely many other real points have two conjugate parameters s, s̄: common zeros of
///   (x(s) − x(σ))/(s − σ) and (y(s) − y(σ))/(s − σ), written in s + σ and sσ, with (s + σ)² < 4sσ. Undecided is
///   only a multiple irrational zero s + σ of their resultant.
///
/// # Errors
/// Those of `limits`.
pub fn real_image<const N: usize>(
    curve: &ParametricCurve<N>,
    tracing_index: usize,
    limits: &Limits,
) -> Result<RealImage<N>> {
    let mut coverage = Coverage::Whole;
    let mut proper = Some(curve.coordinates().clone());
    if tracing_index > 1 {
        let common = common_numerator(curve.coordinates(), limits)?;
        let generator = generator(&common);
        if tracing_index.is_multiple_of(2) {
            coverage = match &generator {
                Some(m) => turning_points(m, limits)?,
                None => Coverage::Unknown,
            };
        }
        proper = match generator {
            Some(m) => in_terms_of(curve.coordinates(), &m, limits)?,
            None => None,
        };
    }
    let isolated = match proper.filter(|_| N == 2).map(|f| isolated(&f, limits)) {
        None | Some(Err(Error::Limit { .. })) => Isolated {
            points: Vec::new(),
            complete: false,
        },
        Some(found) => found?,
    };
    Ok(RealImage {
        approached: approached(curve),
        coverage,
        isolated,
    })
}

/// The coordinates as functions of m, which generates their field.
fn in_terms_of<const N: usize>(
    coordinates: &[RationalFunction; N],
    m: &RationalFunction,
    limits: &Limits,
) -> Result<Option<[RationalFunction; N]>> {
    let mut proper = std::array::from_fn(|_| RationalFunction::default());
    for (function, f) in proper.iter_mut().zip(coordinates) {
        let Inverse::Function(fraction) = invert(f, m, limits)? else {
            return Ok(None);
        };
        let Some(found) = fraction.to_function() else {
            return Ok(None);
        };
        *function = found;
    }
    Ok(Some(proper))
}

/// α(∞) for a number, if it is a point that no real number reaches.
fn approached<const N: usize>(curve: &ParametricCurve<N>) -> Option<[Rational; N]> {
    if curve.parameter().is_angle() {
        return None;
    }
    let limit = curve.point_at_infinity()?;
    let mut common = IntegerPolynomial::ZERO;
    for (f, value) in curve.coordinates().iter().zip(&limit) {
        let numerator = f.plus_constant(&-value.clone());
        common = polynomial_gcd(&common, numerator.numerator());
    }
    real_roots(&common).is_empty().then_some(limit)
}

/// Whether m runs to and fro, and then whether it takes all values.
fn turning_points<const N: usize>(m: &RationalFunction, limits: &Limits) -> Result<Coverage<N>> {
    let (p, q) = (m.numerator(), m.denominator());
    let wronskian = derivative(p) * q - p * derivative(q);
    let degree = wronskian.coefficients_asc().len().saturating_sub(1);
    let mut turns: Vec<f64> = real_roots(&wronskian)
        .iter()
        .filter(|root| root.multiplicity() % 2 == 1)
        .map(RealRoot::to_f64)
        .collect();
    // As a form of degree 2k − 2 it may vanish at infinity.
    if (2 * m.degree() - 2 - degree) % 2 == 1 {
        turns.push(f64::INFINITY);
    }
    if turns.is_empty() {
        return Ok(Coverage::Whole);
    }
    // Values of m between its values at the turning points: is one of them never taken?
    let value = |s: f64| {
        let at = |f: &IntegerPolynomial| {
            let c = f.coefficients_asc().iter().rev();
            c.fold(0.0, |v, c| v * s + Rational::from(c).to_f64())
        };
        if s.is_finite() {
            at(p) / at(q)
        } else {
            m.evaluate_at_infinity()
                .map_or(f64::INFINITY, |v| v.to_f64())
        }
    };
    let mut values: Vec<f64> = turns
        .iter()
        .map(|&s| value(s))
        .filter(|v| v.is_finite())
        .collect();
    values.sort_by(f64::total_cmp);
    let (Some(&low), Some(&high)) = (values.first(), values.last()) else {
        return Ok(Coverage::Unknown);
    };
    let mut candidates = vec![low - 1.0 - low.abs(), high + 1.0 + high.abs()];
    candidates.extend(values.windows(2).map(|w| f64::midpoint(w[0], w[1])));
    for v in candidates {
        limits.check()?;
        let Ok(v) = Rational::try_from(v) else {
            continue;
        };
        let fibre = m.plus_constant(&-v);
        let at_infinity = fibre.evaluate_at_infinity().is_some_and(|v| v.is_zero());
        if !at_infinity && real_roots(fibre.numerator()).is_empty() {
            return Ok(Coverage::Part(turns));
        }
    }
    Ok(Coverage::Unknown)
}

/// The quotient of two coefficients of a polynomial in s over Q(σ), not constant.
fn generator(common: &SparsePolynomial<2>) -> Option<RationalFunction> {
    let degree = common.terms().map(|(e, _)| e[0]).max()?;
    let coefficient = |k: u32| {
        let terms = common.terms().filter(|(e, _)| e[0] == k);
        to_univariate_as_is(terms.map(|(e, c)| (e[1], c.numerator())))
    };
    let lead = coefficient(degree);
    (0..degree)
        .filter_map(|k| RationalFunction::new(coefficient(k), lead.clone()))
        .find(|f| !f.is_constant())
}

fn derivative(f: &IntegerPolynomial) -> IntegerPolynomial {
    let coefficients = f.coefficients_asc().iter().enumerate().skip(1);
    let coefficients = coefficients.map(|(k, c)| c * Integer::from(k));
    IntegerPolynomial::from_coefficients_asc(coefficients.collect())
}
