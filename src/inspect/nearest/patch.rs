//! The foot of a point on a patch.

use super::{FootCandidate, SINGULAR, after_steps, length_of, unit};
use crate::exact::Rational;
use crate::inspect::patch::PatchInspector;
use crate::intervals::dot;
use crate::shape::cross;

/// The step of the quotients of differences for first derivatives; their errors are about its fourth power.
const STEP: f64 = 2e-4;
/// The step for second derivatives.
const SECOND_STEP: f64 = 1e-3;
/// The largest number of steps of Newton's method.
const STEPS: usize = 12;

impl PatchInspector {
    /// The foot of a point; the normal is X_u × X_v.
    pub(crate) fn foot(&self, point: &[Rational; 3]) -> Option<FootCandidate> {
        let p = point.each_ref().map(Rational::to_f64);
        let at = after_steps(self.nearest_angles(&p)?, STEPS, |at| {
            self.newton_step(at, &p)
        });
        let q = self.near(at)?;
        let [u, v] = [self.exact_slope(at, 0)?, self.exact_slope(at, 1)?];
        let across = cross(u, v);
        // The size of the patch itself, however far from the origin it is.
        let beside = [[1.0, 0.0], [0.0, 1.0], [2.0, 2.0]];
        let beside = beside.map(|[a, b]| self.near([at[0] + a, at[1] + b]));
        let away = |p: [f64; 3]| length_of(&[0, 1, 2].map(|i| p[i] - q[i]));
        let sizes = beside.into_iter().flatten().map(away);
        let size = sizes.fold(length_of(&u).max(length_of(&v)), f64::max);
        let normal = (length_of(&across) > SINGULAR * size * size)
            .then(|| unit(across))
            .flatten();
        Some(FootCandidate::on_form(q, normal))
    }

    /// A step of Newton's method to a minimum of the distance; `None` where it is not convex.
    fn newton_step(&self, at: [f64; 2], p: &[f64; 3]) -> Option<[f64; 2]> {
        let q = self.near(at)?;
        let away = [0, 1, 2].map(|i| q[i] - p[i]);
        let [u, v] = [self.slope(at, 0)?, self.slope(at, 1)?];
        let moved = |du: f64, dv: f64| self.near([at[0] + du, at[1] + dv]);
        let h = SECOND_STEP;
        let second =
            |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| (a[i] - 2.0 * q[i] + b[i]) / (h * h));
        let uu = second(moved(h, 0.0)?, moved(-h, 0.0)?);
        let vv = second(moved(0.0, h)?, moved(0.0, -h)?);
        let corners = [moved(h, h)?, moved(h, -h)?, moved(-h, h)?, moved(-h, -h)?];
        let [a, b, c, d] = corners;
        let uv = [0, 1, 2].map(|i| (a[i] - b[i] - c[i] + d[i]) / (4.0 * h * h));
        let (g, k) = (dot(u, away), dot(v, away));
        let a = dot(u, u) + dot(uu, away);
        let b = dot(u, v) + dot(uv, away);
        let c = dot(v, v) + dot(vv, away);
        let determinant = a * c - b * b;
        (a > 0.0 && determinant > 0.0)
            .then(|| [(b * k - c * g) / determinant, (b * g - a * k) / determinant])
    }

    /// The derivative by one of the angles.
    fn slope(&self, at: [f64; 2], variable: usize) -> Option<[f64; 3]> {
        slope(at, variable, |from, to| {
            let [from, to] = [self.near(from)?, self.near(to)?];
            Some([0, 1, 2].map(|i| to[i] - from[i]))
        })
    }

    /// The derivative by one of the angles, from differences of exact points, which lose no digits far from the origin.
    fn exact_slope(&self, at: [f64; 2], variable: usize) -> Option<[f64; 3]> {
        slope(at, variable, |from, to| {
            let [from, to] = [self.exact_point(from)?, self.exact_point(to)?];
            Some([0, 1, 2].map(|i| (&to[i] - &from[i]).to_f64()))
        })
    }
}

/// The derivative by one of two angles of what has these differences between two places.
fn slope(
    at: [f64; 2],
    variable: usize,
    difference: impl Fn([f64; 2], [f64; 2]) -> Option<[f64; 3]>,
) -> Option<[f64; 3]> {
    let beside = |by: f64| {
        let mut there = at;
        there[variable] += by;
        there
    };
    let near = difference(beside(-STEP), beside(STEP))?;
    let far = difference(beside(-2.0 * STEP), beside(2.0 * STEP))?;
    Some([0, 1, 2].map(|i| (8.0 * near[i] - far[i]) / (12.0 * STEP)))
}
