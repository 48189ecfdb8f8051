//! Which real points of a curve real values of the parameter reach.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::inverse::{Inverse, invert};
use super::tracing::{common_numerator, difference};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{
    IntegerPolynomial, RationalFunction, RealRoot, Ring, SparsePolynomial, polynomial_gcd,
    real_roots, resultant,
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

/// The isolated real points that were found.
#[derive(Clone, Debug, PartialEq)]
pub struct Isolated<const N: usize> {
    /// Exact where rational, else rounded.
    pub points: Vec<IsolatedPoint<N>>,
    /// Whether there are no others.
    pub complete: bool,
}

/// An isolated real point.
#[derive(Clone, Debug, PartialEq)]
pub enum IsolatedPoint<const N: usize> {
    /// With rational coordinates.
    Exact([Rational; N]),
    /// Its coordinates, rounded.
    Near([f64; N]),
}

/// What the real zero set of a curve has beyond the real image of the parametrization.
///
/// - A parameter that is a number reaches infinity only in the limit.
/// - With tracing index k > 1 the point is a function of a function m(s) of degree k (Lüroth). If k is odd, or if m
///   has no real turning point, real values of s reach all real values of m.
/// - With k = 1, or in m, the finitely many other real points have two conjugate parameters s, s̄: common zeros of
///   (x(s) − x(σ))/(s − σ) and (y(s) − y(σ))/(s − σ), written in s + σ and sσ, with (s + σ)² < 4sσ. They are found
///   where s + σ is rational.
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

/// The isolated points of a curve that is run over once.
fn isolated<const N: usize>(
    coordinates: &[RationalFunction; N],
    limits: &Limits,
) -> Result<Isolated<N>> {
    let none = Isolated {
        points: Vec::new(),
        complete: true,
    };
    let [Some(a), Some(b)] = [0, 1].map(|k| coordinates.get(k)) else {
        return Ok(none);
    };
    if a.degree() < 2 || b.degree() < 2 {
        // Different parameters have different points.
        return Ok(none);
    }
    let [a, b] = [a, b].map(|f| in_sum_and_product(divided_by_difference(&difference(f))));
    let eliminated = resultant(&a, &b, 1, limits)?;
    let mut found = none;
    for sum in real_roots(&to_univariate(&eliminated, 0)) {
        limits.check()?;
        let Some(sum) = sum.as_rational() else {
            // A common zero there may or may not be real.
            found.complete = false;
            continue;
        };
        let [a, b] = [&a, &b].map(|f| at_sum(f, &sum));
        for product in real_roots(&polynomial_gcd(&a, &b)) {
            let quarter = &sum * &sum / Rational::from(4);
            // (s + σ)² < 4sσ
            if product.cmp_rational(&quarter).is_gt() {
                let point = conjugate_point(coordinates, &sum, &product);
                found
                    .points
                    .extend(point.filter(|p| !found.points.contains(p)));
            }
        }
    }
    Ok(found)
}

/// f/(s − σ), for an f that vanishes at s = σ: by synthetic division in s.
fn divided_by_difference(f: &SparsePolynomial<2>) -> SparsePolynomial<2> {
    let degree = f.terms().map(|(e, _)| e[0]).max().unwrap_or(0);
    let mut quotient = SparsePolynomial::zero();
    let mut carried = SparsePolynomial::<2>::zero();
    let sigma = SparsePolynomial::variable(1);
    for k in (1..=degree).rev() {
        let here = f.terms().filter(|(e, _)| e[0] == k);
        let here = SparsePolynomial::from_terms(here.map(|(e, c)| ([0, e[1]], c.clone())));
        carried = carried.times(&sigma).plus(&here);
        for (e, c) in carried.terms() {
            quotient.add_term([k - 1, e[1]], c.clone());
        }
    }
    quotient
}

/// A symmetric polynomial in s and σ as a polynomial in s + σ and sσ, the first two of three variables.
fn in_sum_and_product(mut f: SparsePolynomial<2>) -> SparsePolynomial<3> {
    let sum = SparsePolynomial::variable(0).plus(&SparsePolynomial::variable(1));
    let mut result = SparsePolynomial::zero();
    // The largest power of s: s^a σ^b + … = (s+σ)^(a−b) (sσ)^b + …
    while let Some((a, b, c)) = f
        .terms()
        .map(|(e, c)| (e[0], e[1], c.clone()))
        .max_by_key(|(a, b, _)| (*a, *b))
    {
        let (high, low) = (a.max(b), a.min(b));
        let product = SparsePolynomial::from_terms([([low, low], c.clone())]);
        let part = sum.pow(high - low).times(&product);
        f = f.minus(&part);
        result.add_term([high - low, low, 0], c);
    }
    result
}

/// With a value of s + σ, as a polynomial in sσ.
fn at_sum(f: &SparsePolynomial<3>, sum: &Rational) -> IntegerPolynomial {
    let mut value = SparsePolynomial::zero();
    for (e, c) in f.terms() {
        let power = sum.pow(i64::from(e[0])).unwrap_or_default();
        value.add_term([0, e[1], 0], c * &power);
    }
    to_univariate(&value, 1)
}

fn to_univariate(f: &SparsePolynomial<3>, variable: usize) -> IntegerPolynomial {
    let f = f.primitive();
    to_univariate_as_is(f.terms().map(|(e, c)| (e[variable], c.numerator())))
}

fn to_univariate_as_is(terms: impl Iterator<Item = (u32, Integer)>) -> IntegerPolynomial {
    let mut coefficients = Vec::new();
    for (k, c) in terms {
        let k = k as usize;
        if coefficients.len() <= k {
            coefficients.resize(k + 1, Integer::ZERO);
        }
        coefficients[k] = c;
    }
    IntegerPolynomial::from_coefficients_asc(coefficients)
}

/// The point of the two roots of s² − sum·s + product; `None` if they are poles.
fn conjugate_point<const N: usize>(
    coordinates: &[RationalFunction; N],
    sum: &Rational,
    product: &RealRoot,
) -> Option<IsolatedPoint<N>> {
    let mut exact = std::array::from_fn(|_| Some(Rational::zero()));
    for (value, f) in exact.iter_mut().zip(coordinates) {
        let [above, below] = modulo([f.numerator(), f.denominator()], sum);
        let is_zero = |p: &IntegerPolynomial| *p == IntegerPolynomial::ZERO;
        let vanishes =
            |uv: &[IntegerPolynomial; 2]| uv.iter().all(|p| is_zero(p) || product.is_root_of(p));
        if vanishes(&below) {
            return None;
        }
        if !vanishes(&above) {
            // (a + b s)/(c + d s) is a real number x: a = x c, b = x d.
            *value = product.as_rational().and_then(|product| {
                let at = |p: &IntegerPolynomial| at_rational(p, &product);
                let [[a, b], [c, d]] = [&above, &below].map(|uv| uv.each_ref().map(at));
                if d.is_zero() {
                    Some(a * c.recip()?)
                } else {
                    Some(b * d.recip()?)
                }
            });
        }
    }
    if exact.iter().all(Option::is_some) {
        return Some(IsolatedPoint::Exact(exact.map(Option::unwrap_or_default)));
    }
    Some(IsolatedPoint::Near(near(
        coordinates,
        sum.to_f64(),
        product.to_f64(),
    )))
}

/// Both modulo s² − sum·s + P as u + v s: u and v as polynomials in P, all times the same number.
fn modulo(functions: [&IntegerPolynomial; 2], sum: &Rational) -> [[IntegerPolynomial; 2]; 2] {
    let product = SparsePolynomial::<3>::variable(1);
    let zero = SparsePolynomial::zero;
    // The other two variables keep u, v and the two functions apart.
    let mut all = zero();
    for (f, k) in functions.into_iter().zip(0_u32..) {
        let coefficients = f.coefficients_asc().iter().rev();
        let [u, v] = coefficients.fold([zero(), zero()], |[u, v], c| {
            // (u + v s) s = −v P + (u + v·sum) s
            let constant = SparsePolynomial::constant(Rational::from(c));
            [constant.minus(&v.times(&product)), u.plus(&v.scaled(sum))]
        });
        let place = |j: u32| SparsePolynomial::from_terms([([j, 0, k], Rational::one())]);
        all = all.plus(&u.times(&place(0))).plus(&v.times(&place(1)));
    }
    let all = all.primitive();
    [0, 1].map(|k| {
        [0, 1].map(|j| {
            let part = all.terms().filter(|(e, _)| e[0] == j && e[2] == k);
            to_univariate_as_is(part.map(|(e, c)| (e[1], c.numerator())))
        })
    })
}

fn at_rational(f: &IntegerPolynomial, at: &Rational) -> Rational {
    let coefficients = f.coefficients_asc().iter().rev();
    coefficients.fold(Rational::zero(), |v, c| v * at + Rational::from(c))
}

/// The same in doubles.
fn near<const N: usize>(coordinates: &[RationalFunction; N], sum: f64, product: f64) -> [f64; N] {
    use nalgebra::Complex;
    let s = Complex::new(sum / 2.0, (product - sum * sum / 4.0).max(0.0).sqrt());
    let at = |f: &IntegerPolynomial| {
        let coefficients = f.coefficients_asc().iter().rev();
        coefficients.fold(Complex::new(0.0, 0.0), |v, c| {
            v * s + Rational::from(c).to_f64()
        })
    };
    coordinates
        .each_ref()
        .map(|f| (at(f.numerator()) / at(f.denominator())).re)
}
