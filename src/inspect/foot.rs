//! The foot of a point on a surface, and bounds of the distance that one Taylor expansion at the foot proves.
//!
//! The foot of p is a point of the surface f = 0 at which the distance from p is stationary. [`approach`] and [`stationary`] find
//! a foot in doubles; nothing rests on how good it is. Only [`enclose`] proves something, at whatever point it is given.

use nalgebra::{Matrix3, Matrix4, Vector4};

use super::DistanceBounds;
use crate::intervals::interval::{exactly, minus, product, square};
use crate::intervals::{Field, Interval, Local, distance, dot};

/// How many steps towards a foot are made at most.
const STEPS: usize = 24;

/// A foot of p near `start`, for distances that are small against the radii of curvature.
///
/// Each step goes to the point that is nearest to p in the tangent plane of f (where the linear part of f vanishes). The
/// iteration ends when a step is at most `goal` times the distance. Each step is shorter than the one before by about the ratio
/// of the distance to the radius of curvature, so the answer is `None` where this ratio is not small.
pub(super) fn approach(field: &Field, p: [f64; 3], start: [f64; 3], goal: f64) -> Option<[f64; 3]> {
    let mut x = start;
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let (value, normal) = field.value_and_gradient(x);
        let back = difference(p, x);
        let weight = (value + dot(normal, back)) / dot(normal, normal);
        let next: [f64; 3] = std::array::from_fn(|i| p[i] - weight * normal[i]);
        let step = distance(next, x);
        if !step.is_finite() || step > 4.0 * last {
            return None;
        }
        let length = distance(p, next);
        x = next;
        // A step of a few units in the last place of x is rounding.
        let size = x.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        if step <= goal * length || step <= 4.0 * f64::EPSILON * size {
            return Some(x);
        }
        last = step;
    }
    None
}

/// A foot of p near `start`, for any distance: Newton's method for q and ν in q + ν∇f(q) = p, f(q) = 0.
pub(crate) fn stationary(field: &Field, p: [f64; 3], start: [f64; 3]) -> Option<[f64; 3]> {
    let mut q = start;
    let mut nu: Option<f64> = None;
    for _ in 0..STEPS {
        let local = field.local(q);
        let gradient = local.direction();
        let away = difference(p, q);
        let factor = nu.unwrap_or_else(|| dot(away, gradient) / dot(gradient, gradient));
        let inverse = lagrange(&local, factor).try_inverse()?;
        let [a, b, c] = [0, 1, 2].map(|i| away[i] - factor * gradient[i]);
        let step = inverse * Vector4::new(a, b, c, local.value.middle());
        if !step.iter().all(|s| s.is_finite()) {
            return None;
        }
        q = [0, 1, 2].map(|i| q[i] - step[i]);
        nu = Some(factor - step[3]);
        let size = q.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        if step.rows(0, 3).amax() <= 1e-12 * size {
            return size.is_finite().then_some(q);
        }
    }
    None
}

/// The Jacobian matrix of (p − q − ν∇f(q), f(q)) with respect to q and ν.
pub(super) fn lagrange(local: &Local, nu: f64) -> Matrix4<f64> {
    let block = -Matrix3::identity() - local.hessian() * nu;
    let mut derivatives = Matrix4::zeros();
    derivatives.fixed_view_mut::<3, 3>(0, 0).copy_from(&block);
    for (i, g) in local.direction().iter().enumerate() {
        derivatives[(i, 3)] = -g;
        derivatives[(3, i)] = *g;
    }
    derivatives
}

/// Bounds of the distance from p to the surface f = 0, where f(p) has the given sign, from the expansion of f at q. The bounds
/// hold for every q, and they are narrow if q is near a foot of p.
///
/// Hypotheses of Lemma 12. a = p − q; s is the sign of f(p); G = s∇f(q) = λa + e with λ > 0; and
/// s f(q) + G·w + κ|w|² ≤ s f(q + w) ≤ s f(q) + G·w + κ′|w|² for all |w| ≤ 2|a|.
///
/// Lemma 12 (a). If λ/2 + κ > 0, f has no zero nearer to p than ρ, for every ρ ≥ 0 with
/// ρ² ≤ |a|² + (2/λ) min(0, s f(q) − |e|²/(4(λ/2 + κ))).
///
/// Proof. Let q + w be nearer to p than ρ ≤ |a|: |w − a| < ρ, that is 2 a·w > |w|² + |a|² − ρ², and |w| < 2|a|. So
/// s f(q + w) > s f(q) + λ(|a|² − ρ²)/2 − |e||w| + (λ/2 + κ)|w|² ≥ s f(q) + λ(|a|² − ρ²)/2 − |e|²/(4(λ/2 + κ)) ≥ 0.
///
/// Lemma 12 (b). Let G·a > 0 and t = 2 max(0, s f(q))/(G·a). If t ≤ 1 and κ′t|a|² ≤ G·a/2, f has a zero at a distance of at most
/// (1 + t)|a| from p.
///
/// Proof. At w = −ta, s f ≤ s f(q) − t G·a + t (κ′t|a|²) ≤ s f(q) − t G·a/2 ≤ 0, and s f(p) > 0: f has a zero on the segment from
/// p to q − ta, which is (1 + t)|a| long.
///
/// Laws: `bounds_hold_on_random_cubics`, `the_distance_to_a_sphere_is_enclosed`, `a_parabola_has_an_upper_bound_where_it_has_zeros`.
pub(super) fn enclose(field: &Field, p: [f64; 3], q: [f64; 3], sign: i8) -> DistanceBounds {
    let local = field.local(q);
    bounds_from(&local, p, q, sign)
}

fn bounds_from(local: &Local, p: [f64; 3], q: [f64; 3], sign: i8) -> DistanceBounds {
    let mut found = DistanceBounds::UNKNOWN;
    let away = minus(exactly(p), exactly(q));
    let away_squared = square(away);
    let length = away_squared.sqrt();
    let signed = |x: Interval| if sign < 0 { -x } else { x };
    let gradient = local.gradient.map(signed);
    // G·a
    let slope = product(gradient, away);
    let lambda = (slope / away_squared).middle();
    if !(lambda.is_finite() && lambda > 0.0) {
        return found;
    }
    let value = signed(local.value);
    let curvature = signed(local.curvature((length * 2.0).high(), false));
    let convexity = Interval::from(lambda) * 0.5 + curvature;
    if convexity.is_positive() {
        let rest = [0, 1, 2].map(|i| gradient[i] - away[i] * lambda);
        let loss = square(rest) / (convexity * 4.0) - value;
        let inside = away_squared - loss.or_zero() * 2.0 / Interval::from(lambda);
        found.low = inside.or_zero().sqrt().low();
    }
    if slope.is_positive() {
        let beyond = value.or_zero() * 2.0 / slope;
        let bend = curvature * beyond * away_squared * 2.0;
        if beyond.high() <= 1.0 && bend.high() <= slope.low() {
            found.high = (length + length * beyond).high();
        }
    }
    found
}

pub(super) fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::intervals::rational;
    use crate::intervals::tests::{cubic, sphere};
    use crate::poly::{Ring, SparsePolynomial};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

        /// Lemma 12 against the exact distance | |p| − 1 | from the unit sphere, for points p just beside the sphere, far
        /// away and near its center, and for points q that are feet, nearly feet or no feet. For feet the bounds are within a few
        /// units in the last place of the distance.
        #[test]
        fn the_distance_to_a_sphere_is_enclosed(v in prop::array::uniform3(-1.0f64..1.0), scale in prop_oneof![Just(1.0), 0.5f64..3.0], e in -52i32..0, ulps in -4i32..5, off in prop::array::uniform3(-1.0f64..1.0), size in prop::sample::select(vec![0.0, 1e-16, 1e-12, 1e-8, 1e-3])) {
            let field = Field::new(&sphere(1));
            let length = dot(v, v).sqrt();
            prop_assume!(length > 0.1);
            let factor = (scale + 2f64.powi(e) + f64::from(ulps) * f64::EPSILON) / length;
            let p = v.map(|x| x * factor);
            let q: [f64; 3] = std::array::from_fn(|i| v[i] / length + size * off[i]);
            let sign = field.sign(p);
            prop_assume!(sign != 0);
            let found = enclose(&field, p, q, sign);
            // low ≤ | |p| − 1 | ≤ high: |p| is at least 1 + low outside, at most 1 − low inside, and so on.
            let square: Rational = p.iter().map(|x| rational(*x) * rational(*x)).sum();
            let end = |off: f64| (Rational::one() + rational(off) * Rational::from(i32::from(sign))).max(Rational::zero());
            let is_beyond = |off: f64| {
                let end = end(off);
                if sign > 0 { square >= &end * &end } else { square <= &end * &end }
            };
            prop_assert!(is_beyond(found.low));
            if found.high.is_finite() {
                prop_assert!(found.high >= 1.0 || !is_beyond(found.high.next_up()));
            }
            if size <= 1e-16 && scale > 0.9 {
                // Next to the surface the error of f may be larger than f.
                prop_assert!(found.high.is_finite() || (scale - 1.0).abs() < 1e-3, "{found:?}");
                prop_assert!(found.high - found.low <= 1e-14 * (1.0 + found.high), "{found:?}");
            }
        }
    }

    proptest! {
        /// The hypothesis of Lemma 12 (b) is sharp for a parabola: v − bx + cx² gets an upper bound of the distance if it has a zero
        /// within reach, and none if it has no zero.
        #[test]
        fn a_parabola_has_an_upper_bound_where_it_has_zeros(v in 1i64..200, b in 1i64..60, c in 1i64..60) {
            let x = SparsePolynomial::<3>::variable(0);
            let constant = |n: i64| SparsePolynomial::constant(Rational::from(n));
            let f = x.squared().scaled(&c.into()).minus(&x.scaled(&b.into())).plus(&constant(v));
            // q = 0 is no foot; it is at the distance 1 from p.
            let found = enclose(&Field::new(&f), [-1.0, 0.0, 0.0], [0.0; 3], 1);
            let discriminant = b * b - 4 * v * c;
            if discriminant < 0 {
                prop_assert!(found.high.is_infinite());
            } else if discriminant > 0 && 2 * v < b {
                prop_assert!(found.high.is_finite());
            }
        }

        /// For any surface and point, f has no zero nearer than the lower bound, and it has one within the upper bound, on the
        /// ray from p through q.
        #[test]
        fn bounds_hold_on_random_cubics(c in prop::collection::vec(-9i64..10, 20), p in prop::array::uniform3(-2.0f64..2.0), v in prop::array::uniform3(-1.0f64..1.0)) {
            let field = Field::new(&cubic(&c));
            let sign = field.sign(p);
            prop_assume!(sign != 0);
            if let Some(q) = approach(&field, p, p, 1e-6) {
                let found = enclose(&field, p, q, sign);
                prop_assert!(found.low <= found.high);
                let length = dot(v, v).sqrt();
                let inside = std::array::from_fn(|i| p[i] + 0.999_999 * found.low * v[i] / length.max(1.0));
                prop_assert_eq!(field.sign(inside), sign);
                if found.high.is_finite() {
                    let away = difference(q, p);
                    let reach = found.high * (1.0 + 1e-12) / dot(away, away).sqrt();
                    let there = std::array::from_fn(|i| p[i] + reach * away[i]);
                    prop_assert!(field.sign(there) != sign);
                    prop_assert!(found.high <= 1.000_1 * found.low || found.low <= 0.0 || found.high < 1e-9);
                }
            }
        }
    }
}
