//! The topology of the equation of a Fourier radius, of any degree, from the series itself.
//!
//! By Theorem 2, F(ρ cos θ, ρ sin θ) is ρ^(2N) times (ρ − r(θ))(ρ + r(θ + π)) up to a factor without real zeros. So the real zero set
//! is the image of the closed curve r(θ)(cos θ, sin θ), which is connected, and the origin if r has no real zero.
//! Two branches meet away from the origin where r(θ) = −r(θ + π) ≠ 0, which are the zeros of the even part E of r. Both are smooth, and
//! their intersection number is the order k of the zero of E, so the point is an A_(2k−1).

use super::components::ComponentKind;
use super::coordinate::Coordinate;
use super::origin::{at_origin, order_at_infinity};
use super::singular::Singularity;
use super::{Component, SingularPoint, Topology};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::roots::{RealRoot, real_roots};
use crate::shape::FourierRadius;

/// How narrow the parameter of an extremum is known before the extremum is bounded.
const PARAMETER_BITS: i64 = -160;

/// Numerator and denominator of a short fraction have at most this many bits each.
const SHORT_BITS: u64 = 64;

impl Topology {
    /// The topology of the zero set of the equation of a radius, relative to its centre. `origin_multiplicity` is the multiplicity of
    /// the origin on the curve of the (reduced) equation.
    ///
    /// Cost: the real roots of some polynomials of degree 2N + 2.
    ///
    /// # Errors
    /// Those of the limits.
    pub fn of_radius(
        radius: &FourierRadius,
        origin_multiplicity: usize,
        limits: &Limits,
    ) -> Result<Self> {
        let mut components = Vec::new();
        let mut singular_points = Vec::new();
        let zeros = zeros(radius).len();
        // If r has odd harmonics only, the curve is traced twice.
        let is_odd = even_part(radius).is_zero();
        let branches = if is_odd { zeros / 2 } else { zeros };
        let is_point = radius.is_zero();
        if !is_point {
            let mut extent = Vec::with_capacity(2);
            for axis in [0, 1] {
                limits.check()?;
                extent.push(range(&turned(radius, axis)).map(Some));
            }
            let extent = <[_; 2]>::try_from(extent).invariant("there are two axes");
            components.push(Component {
                kind: ComponentKind::Oval,
                contains: Vec::new(),
                extent,
                singular_points: Vec::new(),
                some_points: vec![[value(&turned(radius, 0), None)[0].to_f64(), 0.0]],
            });
        }
        if !is_odd {
            for (at, order) in crossings(radius) {
                components[0].singular_points.push(singular_points.len());
                singular_points.push(SingularPoint {
                    at,
                    singularity: Singularity {
                        multiplicity: 2,
                        milnor: Some(2 * order - 1),
                        delta: Some(order),
                        branches: Some(2),
                        tangents: Some(if order == 1 { 2 } else { 1 }),
                        real_half_branches: 4,
                    },
                    component: 0,
                });
            }
        }
        let origin = || {
            let zero = Rational::zero();
            Coordinate::between(zero.clone(), zero)
        };
        if origin_multiplicity > 0 && branches == 0 {
            // An isolated point; it is inside the oval, because r has one sign and runs once around it.
            if let Some(oval) = components.first_mut() {
                oval.contains.push(1);
            }
            components.push(Component {
                kind: ComponentKind::Point,
                contains: Vec::new(),
                extent: [0, 1].map(|_| [Some(origin()), Some(origin())]),
                singular_points: Vec::new(),
                some_points: vec![[0.0, 0.0]],
            });
        }
        if origin_multiplicity > 1 {
            let component = components.len() - 1;
            components[component]
                .singular_points
                .push(singular_points.len());
            singular_points.push(SingularPoint {
                at: [origin(), origin()],
                singularity: at_origin(radius, origin_multiplicity, 2 * branches),
                component,
            });
        }
        Ok(Self {
            components,
            singular_points,
            at_infinity: super::AtInfinity::default(),
        })
    }
}

/// The zeros of a series in s = tan(θ/2), without θ = π.
fn finite_zeros(series: &FourierRadius) -> Vec<RealRoot> {
    real_roots(series.to_function().numerator())
}

/// The zeros of r; `None` stands for θ = π.
fn zeros(radius: &FourierRadius) -> Vec<Option<RealRoot>> {
    let mut zeros: Vec<Option<RealRoot>> = finite_zeros(radius).into_iter().map(Some).collect();
    if order_at_infinity(radius) > 0 {
        zeros.push(None);
    }
    zeros
}

/// r cos θ or r sin θ.
fn turned(radius: &FourierRadius, axis: usize) -> FourierRadius {
    let n = radius.harmonics();
    let half = Rational::one() / Rational::from(2);
    let mut cos = vec![Rational::zero(); n + 2];
    let mut sin = vec![Rational::zero(); n + 2];
    let mut add = |list: usize, k: i64, c: Rational| {
        // cos(−kθ) = cos kθ and sin(−kθ) = −sin kθ
        let index = usize::try_from(k.abs()).invariant("a harmonic is small");
        match list {
            0 => cos[index] = &cos[index] + &c,
            _ if k < 0 => sin[index] = &sin[index] - &c,
            _ => sin[index] = &sin[index] + &c,
        }
    };
    for m in 0..=n {
        let k = i64::try_from(m).invariant("a harmonic is small");
        let (a, b) = (radius.cos(m) * &half, radius.sin(m) * &half);
        if axis == 0 {
            // 2 cos kθ cos θ = cos(k+1)θ + cos(k−1)θ, 2 sin kθ cos θ = sin(k+1)θ + sin(k−1)θ
            add(0, k + 1, a.clone());
            add(0, k - 1, a);
            add(1, k + 1, b.clone());
            add(1, k - 1, b);
        } else {
            // 2 cos kθ sin θ = sin(k+1)θ − sin(k−1)θ, 2 sin kθ sin θ = cos(k−1)θ − cos(k+1)θ
            add(1, k + 1, a.clone());
            add(1, k - 1, -a);
            add(0, k - 1, b.clone());
            add(0, k + 1, -b);
        }
    }
    FourierRadius::new(cos, sin)
}

/// dr/dθ.
fn derivative(series: &FourierRadius) -> FourierRadius {
    let times = |m: usize| Rational::from(i64::try_from(m).invariant("a harmonic is small"));
    let all = 0..=series.harmonics();
    let cos = all.clone().map(|m| series.sin(m) * &times(m)).collect();
    let sin = all.map(|m| -(series.cos(m) * &times(m))).collect();
    FourierRadius::new(cos, sin)
}

/// The even harmonics, as a series in 2θ.
fn even_part(series: &FourierRadius) -> FourierRadius {
    let even = (0..=series.harmonics()).step_by(2);
    FourierRadius::new(
        even.clone().map(|m| series.cos(m).clone()).collect(),
        even.map(|m| series.sin(m).clone()).collect(),
    )
}

/// The value of a series at s = tan(θ/2), or at θ = π, within bounds; exactly if it is a short fraction.
///
/// |f(s) − f(m)| ≤ 2 |s − m| max |df/dθ| because dθ/ds = 2/(1 + s²), and |df/dθ| ≤ Σ n (|a_n| + |b_n|).
fn value(series: &FourierRadius, at: Option<&RealRoot>) -> [Rational; 2] {
    let function = series.to_function();
    let Some(root) = at else {
        let value = function.evaluate_at_infinity();
        let value = value.invariant("a series is finite at π");
        return [value.clone(), value];
    };
    if let Some(s) = root.as_rational() {
        let value = function.evaluate(&s).invariant("1 + s² is not 0");
        return [value.clone(), value];
    }
    let mut root = root.clone();
    root.refine_to_width(PARAMETER_BITS);
    let (low, high) = root.bounds();
    let slope: Rational = (1..=series.harmonics())
        .map(|m| {
            let m_times = Rational::from(i64::try_from(m).invariant("a harmonic is small"));
            (series.cos(m).abs() + series.sin(m).abs()) * m_times
        })
        .fold(Rational::zero(), |sum, term| sum + term);
    let bound = (&high - &low) * Rational::from(2) * slope;
    let middle = function.evaluate(&low).invariant("1 + s² is not 0");
    let [low, high] = [&middle - &bound, middle + bound];
    // A short fraction, such as the radius of a circle that is off center, is recognized.
    let short = Rational::simplest_between(&low, &high);
    let is_short = short.bits() <= SHORT_BITS;
    if is_short && root.is_root_of(function.plus_constant(&-&short).numerator()) {
        return [short.clone(), short];
    }
    [low, high]
}

/// The smallest and the largest value of a series.
fn range(series: &FourierRadius) -> [Coordinate; 2] {
    let mut places: Vec<Option<RealRoot>> = vec![None];
    places.extend(finite_zeros(&derivative(series)).into_iter().map(Some));
    let values: Vec<[Rational; 2]> = places
        .iter()
        .map(|place| value(series, place.as_ref()))
        .collect();
    let end = |pick: fn(Rational, Rational) -> Rational| {
        let bound = |side: usize| {
            let sides = values.iter().map(|v| v[side].clone());
            sides.reduce(pick).invariant("π is a place")
        };
        Coordinate::between(bound(0), bound(1))
    };
    [end(Rational::min), end(Rational::max)]
}

/// The points other than the origin at which E = 0, with the order of the zero.
fn crossings(radius: &FourierRadius) -> Vec<([Coordinate; 2], usize)> {
    let even = even_part(radius);
    // With E = 0, the point is the odd part times (cos θ, sin θ), whose harmonics are even.
    let odd = |list: &[Rational]| {
        let mut kept = list.to_vec();
        kept.iter_mut()
            .step_by(2)
            .for_each(|c| *c = Rational::zero());
        kept
    };
    let odd = FourierRadius::new(odd(radius.cosines()), odd(radius.sines()));
    let point = [0, 1].map(|axis| even_part(&turned(&odd, axis)));
    let mut zeros: Vec<(Option<RealRoot>, usize)> = finite_zeros(&even)
        .into_iter()
        .map(|root| (Some(root.clone()), root.multiplicity()))
        .collect();
    let order = order_at_infinity(&even);
    if order > 0 {
        zeros.push((None, order));
    }
    let vanishes = |at: &Option<RealRoot>| {
        point.iter().all(|series| match at {
            Some(root) => series.is_zero() || root.is_root_of(series.to_function().numerator()),
            None => series.is_zero() || order_at_infinity(series) > 0,
        })
    };
    zeros.retain(|(at, _)| !vanishes(at));
    let places = zeros.into_iter().map(|(at, order)| {
        let at = point.each_ref().map(|series| {
            let [low, high] = value(series, at.as_ref());
            Coordinate::between(low, high)
        });
        (at, order)
    });
    places.collect()
}
