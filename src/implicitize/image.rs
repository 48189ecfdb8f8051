//! The part of a real curve that real values of the parameter reach.

use std::collections::BTreeSet;

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::eliminant::subresultant;
use super::inverse::{Inverse, invert};
use super::isolated::isolated;
use super::isolated_point::Isolated;
use super::symmetric::Rows;
use super::tracing::{common_numerator, tracing_index_bound};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, RationalFunction, SparsePolynomial, polynomial_gcd, scaled};
use crate::roots::{RealRoot, between, disjoint, real_roots};
use crate::shape::ParametricCurve;

/// The real points of the zero set of a curve that no real parameter value reaches.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RealImage<const N: usize> {
    /// The point that the curve tends to as the parameter goes to infinity, if no parameter value reaches it.
    pub approached: Option<[Rational; N]>,
    /// The one-dimensional part that is reached.
    pub coverage: Coverage<N>,
    /// The numbers of real values of s, infinity included, of a general point, one number for each piece of the curve that is
    /// reached; ascending and distinct. `None` if they were not decided.
    pub real_counts: Option<Vec<usize>>,
    /// The isolated real points, which only conjugate complex parameters reach.
    pub isolated: Isolated,
}

/// The part of the real curve that is reached.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Coverage<const N: usize> {
    /// All of the curve except finitely many points.
    Whole,
    /// Only a part of the curve: at these parameter values (doubles near the exact ones, infinite for s = ∞) the
    /// parametrization turns back, and the curve goes on beyond them, where no parameter value reaches it.
    Part(Vec<f64>),
    /// It was not decided.
    Unknown,
}

/// Finds the real points of the zero set of a curve beyond the real image of the parametrization.
///
/// - A parameter that is a number reaches its value at infinity only in the limit.
/// - If the tracing index k is larger than 1, the point is a function of some function m(s) of degree k (Lüroth). If k is odd,
///   or if m has no real turning point, real values of s reach all real values of m.
/// - With k = 1, or for m as the parameter, the other real points are finitely many. Each of them has two conjugate parameters
///   s, s̄ and no real one, infinity included, and each is decided exactly. Those of a general elliptic series are always found; of
///   other curves they are not searched if the degrees are large.
///
/// # Errors
/// Those of `limits`.
pub fn real_image<const N: usize>(
    curve: &ParametricCurve<N>,
    tracing_index: usize,
    limits: &Limits,
) -> Result<RealImage<N>> {
    let mut coverage = Coverage::Whole;
    let mut counts = Some(BTreeSet::from([1]));
    let mut proper = Some(curve.coordinates().clone());
    if tracing_index > 1 {
        let common = common_numerator(curve.coordinates(), limits)?;
        let generator = generator(&common);
        (coverage, counts) = match &generator {
            Some(m) => values_taken(m, limits)?,
            None => (Coverage::Unknown, None),
        };
        proper = match generator {
            Some(m) => in_terms_of(curve.coordinates(), &m, limits)?,
            None => None,
        };
    }
    let isolated = match &proper {
        Some(proper) => complete_or_not(isolated(proper.each_ref(), limits), limits)?,
        None => None,
    };
    Ok(RealImage {
        approached: approached(curve),
        coverage,
        real_counts: counts.map(positive),
        isolated: isolated.unwrap_or(Isolated {
            points: Vec::new(),
            complete: false,
        }),
    })
}

/// The part of the real curve that real parameters reach.
///
/// # Errors
/// Those of `limits`.
pub(crate) fn coverage<const N: usize>(
    curve: &ParametricCurve<N>,
    tracing_index: usize,
    limits: &Limits,
) -> Result<Coverage<N>> {
    // An odd number of values of s, of which the others are conjugate, has a real one.
    if !tracing_index.is_multiple_of(2) {
        return Ok(Coverage::Whole);
    }
    let common = common_numerator(curve.coordinates(), limits)?;
    match generator(&common) {
        Some(m) => Ok(values_taken(&m, limits)?.0),
        None => Ok(Coverage::Unknown),
    }
}

/// The numbers [`RealImage::real_counts`] alone: how many real values of s, infinity included, a general point of the real
/// image has.
///
/// # Errors
/// Those of `limits`.
pub(crate) fn real_counts<const N: usize>(
    curve: &ParametricCurve<N>,
    tracing_index: usize,
    limits: &Limits,
) -> Result<Option<Vec<usize>>> {
    if tracing_index <= 1 {
        return Ok(Some(vec![1]));
    }
    let common = common_numerator(curve.coordinates(), limits)?;
    let Some(m) = generator(&common) else {
        return Ok(None);
    };
    let (_, counts) = values_taken::<N>(&m, limits)?;
    Ok(counts.map(positive))
}

/// The coordinates as functions of a parameter that traces the curve once, if a general point has an even number of parameters and
/// some of them are real at every general point. `None` otherwise: an odd tracing index does not change the parity of anything that
/// is counted along the curve, and a curve of which only a part is reached is traced there and back.
///
/// # Errors
/// [`Error::Limit`] if this is too much work; those of `limits`.
pub(crate) fn traced_once<const N: usize>(
    coordinates: &[RationalFunction; N],
    limits: &Limits,
) -> Result<Option<[RationalFunction; N]>> {
    if tracing_index_bound(coordinates) == 1 {
        return Ok(None);
    }
    let common = common_numerator(coordinates, limits)?;
    let generator = generator(&common);
    let m =
        generator.invariant("two coefficients of the common numerator have no constant quotient");
    // Its degree is the tracing index.
    if m.degree() % 2 == 1
        || counts_by_value(&m, limits)?
            .iter()
            .any(|(_, count)| *count == 0)
    {
        return Ok(None);
    }
    let once = in_terms_of(coordinates, &m, limits)?;
    Ok(Some(once.invariant(
        "the coordinates are functions of what generates the field of all functions of the point",
    )))
}

fn positive(counts: BTreeSet<usize>) -> Vec<usize> {
    counts.into_iter().filter(|&k| k > 0).collect()
}

/// `None` if a search was omitted because it is too long. A time limit is still an error.
fn complete_or_not<T>(found: Result<T>, limits: &Limits) -> Result<Option<T>> {
    match found {
        Err(Error::Limit { .. }) => limits.check().map(|()| None),
        found => found.map(Some),
    }
}

/// Whether m takes all real values, and the numbers of real s for a general value; undecided if that is too much work.
fn values_taken<const N: usize>(
    m: &RationalFunction,
    limits: &Limits,
) -> Result<(Coverage<N>, Option<BTreeSet<usize>>)> {
    let Some(counts) = complete_or_not(counts_by_value(m, limits), limits)? else {
        let is_odd = m.degree() % 2 == 1;
        let coverage = if is_odd {
            Coverage::Whole
        } else {
            Coverage::Unknown
        };
        return Ok((coverage, None));
    };
    let coverage = if counts.iter().any(|(_, count)| *count == 0) {
        Coverage::Part(turning_points(m, &counts))
    } else {
        Coverage::Whole
    };
    Ok((
        coverage,
        Some(counts.into_iter().map(|(_, count)| count).collect()),
    ))
}

/// The coordinates as functions of m, which generates the field of all functions of the point.
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

/// The point α(∞) for a parameter that is a number, unless a real number reaches the point.
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

/// The numbers of real s, infinity included, with m(s) = v, for general real values v. The number is constant between two
/// neighbouring critical values; each number, which may be 0, stands beside a value v between them, in ascending order.
///
/// The critical values are the zeros v of the resultant of the Wronskian p′q − p q′ and p − v q, and perhaps m(∞). Between two
/// of them the real roots of p − v q are counted at one rational v.
fn counts_by_value(m: &RationalFunction, limits: &Limits) -> Result<Vec<(Rational, usize)>> {
    let (p, q) = (m.numerator(), m.denominator());
    // The coefficients of the powers of s are polynomials in v.
    let fibre = (0..=m.degree()).map(|k| {
        let at = |f: &IntegerPolynomial| {
            f.coefficients_asc()
                .get(k)
                .cloned()
                .unwrap_or(Integer::ZERO)
        };
        IntegerPolynomial::from_coefficients_asc(vec![at(p), -at(q)])
    });
    let constant = |c: &Integer| IntegerPolynomial::from_coefficients_asc(vec![c.clone()]);
    let wronskian = wronskian(m);
    let wronskian = Rows::new(wronskian.coefficients_asc().iter().map(constant).collect());
    let mut critical =
        subresultant([&wronskian, &Rows::new(fibre.collect())], 0, limits)?.remove(0);
    if let Some(v) = m.evaluate_at_infinity() {
        critical *= IntegerPolynomial::from_coefficients_asc(vec![-v.numerator(), v.denominator()]);
    }
    if critical == IntegerPolynomial::ZERO {
        return Err(Error::internal(
            "real values",
            "a function has finitely many critical values",
        ));
    }
    let values = between(&disjoint(real_roots(&critical))).into_iter();
    let counted = values.map(|v| {
        limits.check()?;
        let count = real_roots(m.plus_constant(&-v.clone()).numerator()).len();
        Ok((v, count))
    });
    counted.collect()
}

/// The Wronskian p′q − p q′.
fn wronskian(m: &RationalFunction) -> IntegerPolynomial {
    let (p, q) = (m.numerator(), m.denominator());
    derivative(p) * q - p * derivative(q)
}

/// The values of s at which m turns back and beyond which there are values that it does not take, as doubles near the exact ones,
/// infinite for s = ∞. The counts are those of [`counts_by_value`].
fn turning_points(m: &RationalFunction, counts: &[(Rational, usize)]) -> Vec<f64> {
    // A critical value is between two of the values; at a pole, where m is infinite, these are the last and the first one.
    let is_end = |value_is_above: &dyn Fn(&Rational) -> bool, is_pole: bool| {
        let above = match is_pole {
            true => 0,
            false => counts.partition_point(|(v, _)| value_is_above(v)),
        };
        let below = above.checked_sub(1).unwrap_or(counts.len() - 1);
        let mut beside = [counts.get(above), counts.get(below)].into_iter().flatten();
        beside.any(|(_, count)| *count == 0)
    };
    let (p, q) = (m.numerator(), m.denominator());
    let is_end_at = |s: &RealRoot| {
        let sign = s.sign_of(q);
        let is_above = |v: &Rational| {
            let difference = scaled(p, &v.denominator()) - scaled(q, &v.numerator());
            s.sign_of(&difference) * sign > 0
        };
        is_end(&is_above, sign == 0)
    };
    let wronskian = wronskian(m);
    let degree = wronskian.coefficients_asc().len().saturating_sub(1);
    let mut turns: Vec<f64> = real_roots(&wronskian)
        .iter()
        .filter(|root| root.multiplicity() % 2 == 1 && is_end_at(root))
        .map(RealRoot::to_f64)
        .collect();
    // The Wronskian is a form of degree 2k − 2; it vanishes at infinity if its degree in s is smaller.
    if (2 * m.degree() - 2 - degree) % 2 == 1 {
        let value = m.evaluate_at_infinity();
        let is_above = |v: &Rational| value.as_ref().is_some_and(|value| value > v);
        if is_end(&is_above, value.is_none()) {
            turns.push(f64::INFINITY);
        }
    }
    turns
}

/// The quotient of two coefficients of a polynomial in s over Q(σ), chosen so that it is not constant.
fn generator(common: &SparsePolynomial<2>) -> Option<RationalFunction> {
    let degree = common.terms().map(|(e, _)| e[0]).max()?;
    let coefficient = |k: u32| {
        let terms = common.terms().filter(|(e, _)| e[0] == k);
        let mut coefficients = Vec::new();
        for (e, c) in terms {
            let k = e[1] as usize;
            coefficients.resize(coefficients.len().max(k + 1), Integer::ZERO);
            coefficients[k] = c.numerator();
        }
        IntegerPolynomial::from_coefficients_asc(coefficients)
    };
    let lead = coefficient(degree);
    (0..degree)
        .filter_map(|k| RationalFunction::from_integers(coefficient(k), lead.clone()))
        .find(|f| !f.is_constant())
}

fn derivative(f: &IntegerPolynomial) -> IntegerPolynomial {
    let coefficients = f.coefficients_asc().iter().enumerate().skip(1);
    let coefficients = coefficients.map(|(k, c)| c * Integer::from(k));
    IntegerPolynomial::from_coefficients_asc(coefficients.collect())
}
