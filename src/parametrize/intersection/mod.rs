//! Theorem 7: the curve in which surfaces meet, as parametric space curves.

mod lines;
mod real;
mod search;
mod unreached;

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use search::Search;
pub(super) use search::passes;

use super::fourier::fourier_branches;
use super::rational::{RationalCurve, Rationality, rational_parametrization};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::factor::{factor_plane, greatest_common_divisor};
use crate::implicitize::lies_on;
use crate::limits::Limits;
use crate::poly::{
    IntegerPolynomial, PlanePolynomial, RationalFunction, SparsePolynomial, resultant,
};
use crate::shape::{ImplicitCurve, ImplicitSurface, Parameter, PlaneCurve, SpaceCurve};

/// The intersection of surfaces, component by component.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct IntersectionParametrization {
    /// The surfaces.
    pub surfaces: Vec<ImplicitSurface>,
    /// The components with an exact parametrization; each of these curves satisfies every equation identically.
    pub curves: Vec<SpaceCurve>,
    /// The components with infinitely many real points that have no parametrization.
    pub others: Vec<UnparametrizedComponent>,
    /// The real points of components that have only finitely many, such as points where surfaces touch.
    pub points: Vec<CommonPoint>,
    /// The real points of the components of `curves` that no real parameter value reaches.
    pub unreached: Vec<UnreachedPoint>,
    /// The index of the coordinate along which the intersection was projected: 0, 1 or 2.
    pub axis: usize,
    /// The components with no real point or finitely many.
    pub finite: Vec<FiniteComponent>,
    /// Further notes for the reader.
    pub notes: Vec<String>,
}

impl IntersectionParametrization {
    /// The curve that is the whole intersection, if there is one with a parametrization. Points that it approaches are not counted
    /// as more, but its isolated points are.
    #[must_use]
    pub fn as_one_curve(&self) -> Option<&SpaceCurve> {
        let has_isolated = self.unreached.iter().any(|point| point.is_isolated);
        match &self.curves[..] {
            [curve] if self.others.is_empty() && self.points.is_empty() && !has_isolated => {
                Some(curve)
            }
            _ => None,
        }
    }
}

/// A real common point of surfaces on no curve that a parameter runs over.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CommonPoint {
    /// A point with rational coordinates.
    Exact([Rational; 3]),
    /// The doubles near its coordinates.
    Near([f64; 3]),
}

impl CommonPoint {
    /// The doubles near its coordinates.
    #[must_use]
    pub fn near(&self) -> [f64; 3] {
        match self {
            Self::Exact(point) => point.each_ref().map(Rational::to_f64),
            Self::Near(near) => *near,
        }
    }
}

/// A real point of a parametrized component that no real parameter value of any of the curves reaches.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct UnreachedPoint {
    /// The index of the curve in [`IntersectionParametrization::curves`].
    pub curve: usize,
    /// The point.
    pub point: CommonPoint,
    /// Whether the point is isolated: conjugate complex parameters have it. Otherwise the curve approaches it as the parameter
    /// goes to infinity.
    pub is_isolated: bool,
}

/// A component with finitely many real points.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FiniteComponent {
    /// The irreducible equation of its projection along the axis.
    pub projection: SparsePolynomial<3>,
    /// The number of its real points that were found.
    pub points: usize,
}

/// A component for which no rational or trigonometric parametrization is known.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct UnparametrizedComponent {
    /// The irreducible equation of its projection along the axis.
    pub projection: SparsePolynomial<3>,
    /// The reason why there is no parametrization, or why none was found.
    pub reason: String,
}

/// Parametrizes the intersection of surfaces, where a rational or trigonometric relation gives a curve (Theorem 7).
///
/// One coordinate is eliminated: the irreducible factors of the resultant of two equations contain the projections of the
/// components. If a factor has a parametrization (x(t), y(t)), which is a Fourier radius by Lemmas 2 and 3 or a rational curve,
/// it is substituted into the equations. They become polynomials in z over Q(t), and a linear factor of their greatest common
/// divisor gives z(t). Every curve is verified by substitution into all the equations. Straight lines parallel to the axis are the
/// common zeros of the coefficients of the powers of z. Components without real points are noted; those with finitely many
/// give [`IntersectionParametrization::points`], and the real points of the curves that no parameter value reaches
/// [`IntersectionParametrization::unreached`].
///
/// ```
/// use stellate::document::{Coordinates, Format};
/// use stellate::language::{Numbers, parse_form};
/// use stellate::limits::Limits;
/// use stellate::parametrize::parametrize_intersection;
/// use stellate::shape::Form;
///
/// // Example 11
/// let Form::Intersection(surfaces) = parse_form("x^2 + y^2 = 1; z = y^5", "<form>", Numbers::Exact)? else { panic!() };
/// let found = parametrize_intersection(&surfaces, &Limits::none())?;
/// let formulas = Coordinates::from(&found.curves[0]).formulas(Format::Text);
/// assert_eq!(formulas, ["cos(t)", "sin(t)", "sin(t)^5"]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Usage`] for fewer than two surfaces, or if the first two have a surface in common; [`Error::Limit`] if a
/// resultant is too large; those of [`factor_plane`].
pub fn parametrize_intersection(
    surfaces: &[ImplicitSurface],
    limits: &Limits,
) -> Result<IntersectionParametrization> {
    let surfaces = &ImplicitSurface::all_in_original_coordinates(surfaces, limits)?[..];
    let [first, second, ..] = surfaces else {
        return Err(Error::Usage("an intersection has two surfaces".into()));
    };
    let pair = [first.polynomial(), second.polynomial()];
    if greatest_common_divisor(pair[0], pair[1], limits)?.degree() > Some(0) {
        return Err(Error::Usage(
            "the first two surfaces have a surface in common: they do not meet in a curve only"
                .into(),
        ));
    }
    let mut best: Option<IntersectionParametrization> = None;
    let mut failure = None;
    for axis in axes(pair) {
        limits.check()?;
        match along(axis, surfaces, pair, limits) {
            Ok(found) => {
                let is_better = best
                    .as_ref()
                    .is_none_or(|known| found.others.len() < known.others.len());
                let is_whole = found.others.is_empty();
                if is_better {
                    best = Some(found);
                }
                if is_whole {
                    break;
                }
            }
            Err(error) => failure = Some(error),
        }
    }
    let none = || Error::Usage("a constant is no surface".into());
    let mut best = best.ok_or_else(|| failure.unwrap_or_else(none))?;
    unreached::add_unreached(&mut best, limits)?;
    Ok(best)
}

/// The axes along which the surfaces can be projected, the cheapest first: those whose coordinate has small degrees, of which
/// at least one is not 0.
fn axes(pair: [&SparsePolynomial<3>; 2]) -> Vec<usize> {
    let degrees = |axis: usize| pair.map(|f| f.degree_in(axis));
    let mut axes: Vec<usize> = (0..3).filter(|&axis| degrees(axis) != [0, 0]).collect();
    // z is first among equally cheap axes, so that the projection is a curve in x and y.
    axes.sort_unstable_by_key(|&axis| {
        let [m, n] = degrees(axis);
        (m * n, m + n, 2 - axis)
    });
    axes
}

/// The names of the coordinates.
const AXES: [&str; 3] = ["x", "y", "z"];

/// The two other coordinates, in ascending order.
fn others(axis: usize) -> [usize; 2] {
    match axis {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    }
}

fn along(
    axis: usize,
    surfaces: &[ImplicitSurface],
    pair: [&SparsePolynomial<3>; 2],
    limits: &Limits,
) -> Result<IntersectionParametrization> {
    let projection = match pair.map(|f| f.degree_in(axis)) {
        [0, _] => pair[0].clone(),
        [_, 0] => pair[1].clone(),
        _ => resultant(pair[0], pair[1], axis, limits)?,
    };
    let [u, w] = others(axis);
    let plane = PlanePolynomial::from_terms(
        projection
            .terms()
            .map(|(e, c)| ((e[u] as usize, e[w] as usize), c.clone())),
    );
    let vertical = lines::lines(axis, pair, limits)?;
    let result = IntersectionParametrization {
        surfaces: surfaces.to_vec(),
        curves: Vec::new(),
        others: vertical.others,
        points: Vec::new(),
        unreached: Vec::new(),
        finite: Vec::new(),
        axis,
        notes: vertical.notes,
    };
    let mut search = Search {
        surfaces,
        pair,
        limits,
        result,
    };
    search.add(vertical.curves);
    for factor in factor_plane(&plane, limits)?.factors {
        limits.check()?;
        search.add_component(&factor.polynomial)?;
    }
    Ok(search.result)
}

/// The coordinates in their order, of the two of the projection and the third one.
fn in_space<T>(axis: usize, [a, b, height]: [T; 3]) -> [T; 3] {
    match axis {
        0 => [height, a, b],
        1 => [a, height, b],
        _ => [a, b, height],
    }
}

/// A parametrization of an irreducible plane curve, or the reason why there is none.
fn projected(f: &PlanePolynomial) -> std::result::Result<PlaneCurve, String> {
    if let Ok(found) = fourier_branches(&ImplicitCurve::new(f.clone()))
        && let Some(radius) = found.radii.first()
    {
        return Ok(radius.to_plane_curve());
    }
    if let Some(line) = line(f) {
        return Ok(rational(line));
    }
    match rational_parametrization(f) {
        Some(Rationality::Parametrized(curve)) => Ok(rational(curve)),
        Some(Rationality::PositiveGenus { genus, .. }) => Err(format!(
            "its projection has genus {genus}, so neither has a rational parametrization, over any field"
        )),
        Some(Rationality::NoRationalPoint { field, .. }) => Err(format!(
            "its projection has genus 0 but no rational parametrization over Q (there is one over Q(sqrt({field})))"
        )),
        Some(Rationality::Conjugates { count }) => Err(format!(
            "its projection consists of {count} conjugate curves"
        )),
        _ => Err("no rational or trigonometric parametrization of its projection is known".into()),
    }
}

fn rational(curve: RationalCurve) -> PlaneCurve {
    PlaneCurve::new(Parameter::number("t"), [curve.x, curve.y])
}

/// The straight line a x + b y + c = 0, parametrized by a coordinate that determines the other one.
fn line(f: &PlanePolynomial) -> Option<RationalCurve> {
    if f.degree() != Some(1) {
        return None;
    }
    let coefficient = |i: usize, j: usize| {
        let term = f.terms().find(|(e, _)| *e == (i, j));
        term.map_or_else(Rational::zero, |(_, c)| c)
    };
    let [a, b, c] = [(1, 0), (0, 1), (0, 0)].map(|(i, j)| coefficient(i, j));
    let t = || linear(&Rational::one(), &Rational::zero());
    if b.is_zero() {
        let x = linear(&Rational::zero(), &(-c / a));
        return Some(RationalCurve { x, y: t() });
    }
    let y = linear(&(-a / &b), &(-c / b));
    Some(RationalCurve { x: t(), y })
}

/// The function a t + b.
fn linear(a: &Rational, b: &Rational) -> RationalFunction {
    let denominator = a.denominator() * b.denominator();
    let scaled = |q: &Rational| (q * &Rational::whole(&denominator)).numerator();
    let numerator = IntegerPolynomial::from_coefficients_asc(vec![scaled(b), scaled(a)]);
    let below = IntegerPolynomial::from_coefficients_asc(vec![denominator]);
    RationalFunction::from_integers(numerator, below).invariant("no denominator is 0")
}

/// The variables of a relation: the parameter s of the projection, and the third coordinate.
const PARAMETER: usize = 0;
const HEIGHT: usize = 1;

/// The part of the intersection above a parametrized projection. If it is empty, the factor of the resultant belongs to points at
/// infinity.
struct Lifted {
    /// Curves that satisfy both equations.
    curves: Vec<SpaceCurve>,
    /// Irreducible equations of the third coordinate over the functions of the parameter, of degree at least 2.
    relations: Vec<SparsePolynomial<3>>,
}

fn lifted(
    below: &PlaneCurve,
    axis: usize,
    pair: [&SparsePolynomial<3>; 2],
    limits: &Limits,
) -> Result<Lifted> {
    let [f, g] = pair.map(|f| substituted(f, axis, below));
    let common = greatest_common_divisor(&f, &g, limits)?;
    let terms = common.terms();
    let plane = PlanePolynomial::from_terms(
        terms.map(|(e, c)| ((e[0] as usize, e[1] as usize), c.clone())),
    );
    let mut curves = Vec::new();
    let mut relations = Vec::new();
    for factor in factor_plane(&plane, limits)?.factors {
        // The coefficients a(t) of the powers of z.
        let mut rows: Vec<Vec<Integer>> = Vec::new();
        for ((i, k), c) in factor.polynomial.terms() {
            rows.resize_with(rows.len().max(k + 1), Vec::new);
            let row_length = rows[k].len().max(i + 1);
            rows[k].resize(row_length, Integer::ZERO);
            rows[k][i] = c.numerator();
        }
        match rows.len() {
            0 | 1 => {}
            2 => {
                let mut rows = rows
                    .into_iter()
                    .map(IntegerPolynomial::from_coefficients_asc);
                let [b, a] = [rows.next(), rows.next()].map(Option::unwrap_or_default);
                let Some(height) = RationalFunction::from_integers(-b, a) else {
                    continue;
                };
                let [x, y] = below.coordinates().clone();
                let coordinates = in_space(axis, [x, y, height]);
                let curve = SpaceCurve::new(below.parameter().clone(), coordinates);
                // This is a proof that does not depend on the way in which the curve was found.
                if pair.iter().all(|f| lies_on(&curve, f)) {
                    curves.push(curve);
                }
            }
            _ => relations.push(SparsePolynomial::from(&factor.polynomial)),
        }
    }
    Ok(Lifted { curves, relations })
}

/// f with a plane curve substituted for two of its variables: a polynomial in the parameter s and the third variable, times a
/// power of the denominators.
fn substituted(f: &SparsePolynomial<3>, axis: usize, curve: &PlaneCurve) -> SparsePolynomial<2> {
    let variables = others(axis);
    let f = f.primitive();
    // For both coordinates, the products numerator^i · denominator^(d − i) for i = 0 … d.
    let powers = [0, 1].map(|n: usize| {
        let degree = f.degree_in(variables[n]);
        let function = &curve.coordinates()[n];
        let all = |base: &IntegerPolynomial| {
            let mut list = vec![IntegerPolynomial::one()];
            for k in 0..degree as usize {
                let next = &list[k] * base;
                list.push(next);
            }
            list
        };
        let (above, below) = (all(function.numerator()), all(function.denominator()));
        let pairs = above.iter().zip(below.iter().rev());
        pairs.map(|(a, b)| a * b).collect::<Vec<_>>()
    });
    let mut sum = SparsePolynomial::zero();
    for (e, c) in f.terms() {
        let [i, j] = variables.map(|v| e[v] as usize);
        let product = &powers[0][i] * &powers[1][j];
        for (k, value) in product.coefficients_asc().iter().enumerate() {
            let power = u32::try_from(k).invariant("a degree is below 2^32");
            sum.add_term([power, e[axis]], c * &Rational::whole(value));
        }
    }
    sum
}
