//! The foot of a point on a surface, and what one expansion there proves of the distance.

use nalgebra::{Matrix3, Matrix4, Vector4};

use super::DistanceBounds;
use crate::field::{Field, Local, distance, dot};

/// Steps towards the foot.
const STEPS: usize = 24;
/// More than the relative rounding error of any of the short sums below.
const ROUNDING: f64 = 1e-15;

/// The stationary point of the distance that Newton's method finds from `start`: step by step the nearest point to p
/// where the linear part of f vanishes. It ends when a step is less than `goal` times the distance.
///
/// The steps shrink by the ratio of the distance to the radius of curvature; none is found where that is not small.
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
        // Below this only roundings are left.
        let size = x.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        if step <= goal * length || step <= 4.0 * f64::EPSILON * size {
            return Some(x);
        }
        last = step;
    }
    None
}

/// The same where the distance is not small against the radii of curvature: Newton's method on q + ν∇f(q) = p, f(q) = 0.
pub(super) fn stationary(field: &Field, p: [f64; 3], start: [f64; 3]) -> Option<[f64; 3]> {
    let mut q = start;
    let mut nu: Option<f64> = None;
    for _ in 0..STEPS {
        let local = field.local(q);
        let gradient = local.gradient;
        let away = difference(p, q);
        let factor = nu.unwrap_or_else(|| dot(away, gradient) / dot(gradient, gradient));
        let inverse = lagrange(&local, factor).try_inverse()?;
        let [a, b, c] = [0, 1, 2].map(|i| away[i] - factor * gradient[i]);
        let step = inverse * Vector4::new(a, b, c, local.value);
        if !step.iter().all(|s| s.is_finite()) {
            return None;
        }
        q = [0, 1, 2].map(|i| q[i] - step[i]);
        nu = Some(factor - step[3]);
        let size = q.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        if step.rows(0, 3).amax() <= 1e-12 * size {
            return Some(q);
        }
    }
    None
}

/// The derivatives of (p − q − ν∇f(q), f(q)) by q and ν.
pub(super) fn lagrange(local: &Local, nu: f64) -> Matrix4<f64> {
    let block = -Matrix3::identity() - local.hessian() * nu;
    let mut derivatives = Matrix4::zeros();
    derivatives.fixed_view_mut::<3, 3>(0, 0).copy_from(&block);
    for (i, g) in local.gradient.iter().enumerate() {
        derivatives[(i, 3)] = -g;
        derivatives[(3, i)] = *g;
    }
    derivatives
}

/// Bounds of the distance from p to a surface, where f(p) has the given sign, from the expansion at a point q near its foot.
///
/// Write a = p − q, s for the sign, G = s∇f(q) = λa + e. In the ball |w − a| ≤ ρ around p (w from q) 2 a·w ≥ |w|² + |a|² − ρ²,
/// and s f(q + w) ≥ s f(q) + G·w + κ|w|² with κ the lower bound of the curvature within reach. So
///
/// s f ≥ s f(q) + λ(|a|² − ρ²)/2 − |e||w| + (λ/2 + κ)|w|² ≥ s f(q) + λ(|a|² − ρ²)/2 − |e|²/(4(λ/2 + κ)),
///
/// which is positive for all ρ² < |a|² + (2/λ)(s f(q) − |e|²/(4(λ/2 + κ))): there is no zero. On the other side of q, at
/// w = −ta with 0 ≤ t ≤ 1, s f ≤ s f(q) − tλ|a|² + κ′t²|a|² is negative for t = 2 s f(q)/(λ|a|²) if κ′t ≤ λ/2: between p
/// and there f has a zero.
pub(super) fn enclose(field: &Field, p: [f64; 3], q: [f64; 3], sign: i8) -> DistanceBounds {
    let local = field.local(q);
    bounds_from(&local, p, q, f64::from(sign))
}

fn bounds_from(local: &Local, p: [f64; 3], q: [f64; 3], sign: f64) -> DistanceBounds {
    let mut found = DistanceBounds::UNKNOWN;
    let away = difference(p, q);
    let square = dot(away, away);
    let length = square.sqrt();
    let gradient = local.gradient.map(|g| sign * g);
    let lambda = dot(gradient, away) / square;
    if !(lambda.is_finite() && lambda > 0.0) {
        return found;
    }
    let rest: [f64; 3] = std::array::from_fn(|i| gradient[i] - lambda * away[i]);
    let size = dot(gradient, gradient).sqrt() + lambda * length;
    let defect = dot(rest, rest).sqrt() + local.gradient_error + 4.0 * ROUNDING * size;
    let value = sign * local.value;
    let [least, most] = local.curvature(2.0 * length * (1.0 + 1e-9), false);
    let [least, most] = if sign > 0.0 {
        [least, most]
    } else {
        [-most, -least]
    };
    let convexity = (lambda / 2.0 + least) - 1e-9 * (lambda + least.abs());
    if convexity > 0.0 {
        let loss = (local.error - value).max(0.0) + defect * defect / (4.0 * convexity);
        let inside = square * (1.0 - 8.0 * ROUNDING) - 2.0 * loss / lambda * (1.0 + 1e-9);
        found.low = inside.max(0.0).sqrt() * (1.0 - ROUNDING);
    }
    // G·a is at least this.
    let slope = lambda * square * (1.0 - 8.0 * ROUNDING) - defect * length;
    let beyond = 2.0 * (value + local.error).max(0.0) / slope * (1.0 + 1e-9);
    if slope > 0.0 && beyond <= 1.0 && most * beyond * square <= slope / 2.0 * (1.0 - 1e-9) {
        found.high = length * (1.0 + beyond) * (1.0 + 4.0 * ROUNDING);
    }
    found
}

pub(super) fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::tests::cubic;
    use proptest::prelude::*;

    proptest! {
        /// Whatever surface and point: no zero nearer than the lower bound, and one within the upper bound on the way to q.
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
