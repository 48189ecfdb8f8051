//! Exact arithmetic for points that doubles leave open: bounds of the distance at a refined foot, and zeros at rational points.

use nalgebra::{Vector3, Vector4};

use super::foot::{difference, lagrange};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::intervals::{Field, Interval, dot, rational, rationals};
use crate::limits::Limits;

#[cfg(test)]
#[path = "exact_laws.rs"]
mod laws;

/// The numbers of bits after the point to which feet are refined in turn.
const LEVELS: [i64; 3] = [128, 256, 640];
/// The largest number of steps towards a foot; each step gains about 40 bits.
const STEPS: usize = 80;
/// The number of bits after the point in the coordinates of directions.
const SPHERE_BITS: i64 = 320;
/// A rational point is searched in an interval that is this many bits wider than the precision of the foot.
const GUARD_BITS: i64 = 32;

/// The decision whether there is a zero within d of a point.
#[derive(Clone, Debug)]
pub(super) enum Answer {
    /// There is no zero within d of the point.
    Outside {
        /// The square of a distance within which there is no zero.
        low: Rational,
    },
    /// There is a zero within d of the point.
    Inside {
        /// The square of a lower bound of the distance of the nearest zero.
        low: Rational,
        /// The square of an upper bound of it.
        high: Rational,
        /// Whether there is a zero exactly at the distance d.
        touches: bool,
        /// A point near the zero.
        foot: Box<[Rational; 3]>,
    },
}

pub(super) fn squared_length(v: &[Rational; 3]) -> Rational {
    v.iter().fold(Rational::zero(), |sum, x| sum + x * x)
}

pub(super) fn exact_difference(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn exact_dot(a: &[Rational; 3], b: &[Rational; 3]) -> Rational {
    a.iter()
        .zip(b)
        .fold(Rational::zero(), |sum, (x, y)| sum + x * y)
}

/// 2^k
pub(super) fn power_of_two(k: i64) -> Rational {
    Rational::from(2).pow(k).invariant("2 has every power")
}

/// The number rounded down to this many bits after the point.
fn rounded(x: &Rational, bits: i64) -> Rational {
    Rational::from_dyadic((x * &power_of_two(bits)).floor_integer(), -bits)
}

/// Decides whether f has a zero within d of p, by the expansion at the foot near `start`; f has the given sign at p. The rule
/// is that of [`super::foot::enclose`], with exact numbers except for the bounds of the curvature.
///
/// If a radius is given, only zeros within this radius of `start` are excluded. The result is `None` if the expansion decides
/// nothing or a limit is reached.
pub(super) fn decide(
    field: &Field,
    p: &[Rational; 3],
    d: &Rational,
    start: [f64; 3],
    sign: i8,
    radius: Option<f64>,
    limits: &Limits,
) -> Option<Answer> {
    let target = d * d;
    let mut q = start.map(rational);
    for bits in LEVELS {
        q = refined_foot(field, p, &q, bits, limits)?;
        limits.check().ok()?;
        let radius = radius.map(|radius| {
            let moved = exact_difference(&q, &rationals(start));
            (Interval::from(&squared_length(&moved)).sqrt() + Interval::from(radius)).high()
        });
        let (low, high) = squared_bounds(field, p, &q, sign, radius);
        if let Some(low) = &low
            && *low > target
        {
            return Some(Answer::Outside { low: low.clone() });
        }
        if let Some(high) = high
            && high <= target
        {
            return Some(Answer::Inside {
                low: low.unwrap_or_else(Rational::zero),
                high,
                touches: false,
                foot: Box::new(q),
            });
        }
        let width = power_of_two(GUARD_BITS - bits);
        if let Some(zero) = rational_zero(field, &q, &width) {
            let high = squared_length(&exact_difference(p, &zero));
            if high <= target {
                let touches = high == target;
                // If the rule gives a lower bound, the foot is the only minimum of the distance within reach.
                let low = low.filter(|low| *low <= high);
                let low = low.unwrap_or_else(Rational::zero);
                return Some(Answer::Inside {
                    low,
                    high,
                    touches,
                    foot: Box::new(zero),
                });
            }
        }
    }
    None
}

/// The squares of bounds of the distance from p, by the expansion at the refined foot near `start`; f has the given sign at p. The
/// result is `None` if the expansion does not bound the distance from both sides or a limit is reached.
pub(super) fn enclose(
    field: &Field,
    p: &[Rational; 3],
    start: [f64; 3],
    sign: i8,
    limits: &Limits,
) -> Option<[Rational; 2]> {
    let q = refined_foot(field, p, &start.map(rational), LEVELS[0], limits)?;
    let (low, high) = squared_bounds(field, p, &q, sign, None);
    Some([low?, high?])
}

/// The foot near q to `bits` bits after the point, that is the solution of q + ν∇f(q) = p, f(q) = 0. Newton's method uses the
/// inverse of the derivatives in doubles, and exact residuals.
pub(super) fn refined_foot(
    field: &Field,
    p: &[Rational; 3],
    start: &[Rational; 3],
    bits: i64,
    limits: &Limits,
) -> Option<[Rational; 3]> {
    let near = start.each_ref().map(Rational::to_f64);
    let local = field.exact_local(&near.map(rational));
    let away = difference(p.each_ref().map(Rational::to_f64), near);
    let gradient = local.direction();
    let nu = dot(away, gradient) / dot(gradient, gradient);
    let inverse = lagrange(&local, nu).try_inverse()?;
    let mut q = start.clone();
    let mut nu = rational(if nu.is_finite() { nu } else { return None });
    let goal = power_of_two(-bits);
    let mut last: Option<Rational> = None;
    for _ in 0..STEPS {
        limits.check().ok()?;
        let (value, gradient) = field.exact_value_and_gradient(&q);
        let away = exact_difference(p, &q);
        let first: [Rational; 3] = std::array::from_fn(|i| &away[i] - &(&nu * &gradient[i]));
        // The residuals are scaled to size 1, so that doubles can hold them however small they are.
        let largest = first.iter().chain([&value]).map(Rational::abs).max()?;
        if largest.is_zero() {
            return Some(q);
        }
        // From a good start the residuals shrink in every step.
        if last.is_some_and(|last| largest >= last) {
            return None;
        }
        let residual = |x: &Rational| (x / &largest).to_f64();
        let [a, b, c] = first.each_ref().map(residual);
        let step = -(inverse * Vector4::new(a, b, c, residual(&value)));
        if !step.iter().all(|s| s.is_finite()) {
            return None;
        }
        let steps = step.map(|s| rational(s) * &largest);
        q = std::array::from_fn(|i| rounded(&(&q[i] + &steps[i]), bits + 16));
        nu = rounded(&(&nu + &steps[3]), bits + 16);
        if steps.iter().take(3).all(|s| s.abs() < goal) {
            return Some(q);
        }
        last = Some(largest);
    }
    None
}

/// The squares of bounds of the distance from p, by the expansion at q. If a radius is given, the lower bound is only for zeros
/// within this radius of q.
///
/// If the radius R is small, the curvature along a need not be small. With n = a/|a| and w = u + τn, Lemma 12's ball |w − a| ≤
/// ρ ≤ |a| gives τ ≥ (|w|² + |a|² − ρ²)/(2|a|) ≥ 0. So a loss of kτ|w| ≤ kRτ only diminishes λ by kR/|a|.
fn squared_bounds(
    field: &Field,
    p: &[Rational; 3],
    q: &[Rational; 3],
    sign: i8,
    radius: Option<f64>,
) -> (Option<Rational>, Option<Rational>) {
    let (value, gradient) = field.exact_value_and_gradient(q);
    let sign_factor = Rational::from(i32::from(sign));
    let value = value * &sign_factor;
    let gradient = gradient.map(|g| g * &sign_factor);
    let away = exact_difference(p, q);
    let away_squared = squared_length(&away);
    let slope = exact_dot(&gradient, &away);
    if slope.signum() <= 0 {
        return (None, None);
    }
    // The doubles from here on are bounds, or numbers that may be chosen freely.
    let lambda = (&slope / &away_squared).to_f64();
    let length = Interval::from(&away_squared).sqrt();
    // The expansion is made at the nearest doubles of q.
    let near = q.each_ref().map(Rational::to_f64);
    let is_near = near.iter().all(|x| x.is_finite());
    if !is_near || !lambda.is_finite() || lambda <= 0.0 {
        return (None, None);
    }
    let off = Interval::from(&squared_length(&exact_difference(q, &rationals(near)))).sqrt();
    let local = field.exact_local(&rationals(near));
    // Zeros within |away| of p are within this distance of q.
    let around = (length * 2.0).high().min(radius.unwrap_or(f64::INFINITY));
    let around = Interval::from(around);
    let reach = (around + off).high();
    let curvature = local.curvature(reach, true);
    let curvature = if sign < 0 { -curvature } else { curvature };
    let [across, along] = local.one_sided(sign, away.each_ref().map(Interval::from), reach);
    let reduced = (Interval::from(lambda) - Interval::from(along) * around / length).low();
    // Two rules for the lower bound, each with its λ and its bound of the curvature.
    let rules = [(lambda, curvature.low()), (reduced, across)];
    let low = rules.into_iter().filter_map(|(pull, curvature)| {
        let convexity = (Interval::from(pull) * 0.5 + Interval::from(curvature)).low();
        (pull > 0.0 && convexity > 0.0).then(|| {
            let lambda = rational(lambda);
            let rest: [Rational; 3] = std::array::from_fn(|i| &gradient[i] - &(&lambda * &away[i]));
            let loss = squared_length(&rest) / (Rational::from(4) * rational(convexity));
            let surplus = if value.signum() < 0 {
                &value - &loss
            } else {
                -loss
            };
            &away_squared + &(surplus * Rational::from(2) / rational(pull))
        })
    });
    let low = low.max();
    let two = Rational::from(2);
    let above = if value.signum() > 0 {
        value
    } else {
        Rational::zero()
    };
    let beyond = above * &two / &slope;
    let bend = curvature.high().max(0.0);
    let is_within = (Interval::from(&beyond) * length).high() < around.low();
    let fits = bend.is_finite()
        && is_within
        && beyond <= Rational::one()
        && rational(bend) * &beyond * &away_squared * &two <= slope;
    let longer = Rational::one() + beyond;
    let high = fits.then(|| &away_squared * &(&longer * &longer));
    (low, high)
}

/// A zero of f whose coordinates are the simplest fractions within `width` of those of q; `None` if f is not 0 there.
pub(super) fn rational_zero(
    field: &Field,
    q: &[Rational; 3],
    width: &Rational,
) -> Option<[Rational; 3]> {
    let simple = q
        .each_ref()
        .map(|x| Rational::simplest_between(&(x - width), &(x + width)));
    field
        .polynomial()
        .evaluate(&simple)
        .is_zero()
        .then_some(simple)
}

/// A critical point of f near `start`, in doubles, by Newton's method. Directions in which f does not bend are left unchanged.
pub(super) fn critical_point(field: &Field, start: [f64; 3]) -> Option<[f64; 3]> {
    let mut x = start;
    for _ in 0..50 {
        let local = field.local(x);
        let svd = local.hessian().svd(true, true);
        let flat = 1e-7 * svd.singular_values.max();
        let step = svd.solve(&Vector3::from(local.direction()), flat).ok()?;
        x = difference(x, step.into());
        if !x.iter().all(|x| x.is_finite()) {
            return None;
        }
        if step.amax() <= 1e-15 * x.iter().fold(1e-3, |m: f64, x| m.max(x.abs())) {
            break;
        }
    }
    Some(x)
}

/// An exact point of the sphere of radius d about p, near a direction, by stereographic projection from the pole opposite to
/// the largest component of the direction. It differs from the direction by about 2^−300. `None` if the direction is 0.
pub(super) fn on_sphere(
    p: &[Rational; 3],
    d: &Rational,
    direction: &[Rational; 3],
) -> Option<[Rational; 3]> {
    let scale = direction.iter().map(Rational::abs).max()?.recip()?;
    let near = direction.each_ref().map(|x| (x * &scale).to_f64());
    let scale = scale / rational(dot(near, near).sqrt());
    let unit = direction.each_ref().map(|x| x * &scale);
    let larger = |i: usize, j: usize| if unit[j].abs() > unit[i].abs() { j } else { i };
    let axis = larger(larger(0, 1), 2);
    let side = if unit[axis].signum() < 0 { -1 } else { 1 };
    let below = length(&unit) + unit[axis].abs();
    let others = [(axis + 1) % 3, (axis + 2) % 3];
    let [s, t] = others.map(|i| rounded(&(&unit[i] / &below), SPHERE_BITS));
    let one = Rational::one();
    let squares = &s * &s + &t * &t;
    let weight = &one + &squares;
    let mut vector: [Rational; 3] = std::array::from_fn(|_| Rational::zero());
    vector[axis] = (one - squares) / &weight * Rational::from(side);
    vector[others[0]] = s * Rational::from(2) / &weight;
    vector[others[1]] = t * Rational::from(2) / weight;
    Some(std::array::from_fn(|i| &p[i] + &(d * &vector[i])))
}

/// The length of a vector of length about 1, by Heron's rule from a double; every step doubles the number of correct digits.
fn length(v: &[Rational; 3]) -> Rational {
    let square = squared_length(v);
    (0..4).fold(Rational::one(), |root, _| {
        rounded(
            &((&root + &(&square / &root)) / Rational::from(2)),
            SPHERE_BITS,
        )
    })
}
