//! The foot of a point on a harmonic surface, in doubles.

use super::CellTree;
use super::expansion::{dot, length};

/// The largest number of steps of Newton's method.
const STEPS: usize = 30;
/// A normal of X_θ × X_φ that is less than this part of the squared size is none.
const SINGULAR: f64 = 1e-8;

impl CellTree {
    /// The nearest point of the surface to a point, relative to the center, and the unit normal there, away from the center.
    pub(in crate::inspect) fn foot(&self, near: [f64; 3]) -> Option<([f64; 3], Option<[f64; 3]>)> {
        let (p, _) = self.inside(near, 0.0)?;
        let target = &self.target(p);
        let (chart, mut at) = self.nearest(near, 0.0, 0.0)?.at;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let Some(step) = self.expansion(chart, at, target).newton_step() else {
                break;
            };
            let size = step[0].abs().max(step[1].abs());
            if !size.is_finite() || size >= last {
                break;
            }
            at = [at[0] + step[0], at[1] + step[1]];
            last = size;
        }
        let best = self.expansion(chart, at, &self.target([0.0; 3]));
        let [u, v] = best.slopes;
        let outward = [
            v[1] * u[2] - v[2] * u[1],
            v[2] * u[0] - v[0] * u[2],
            v[0] * u[1] - v[1] * u[0],
        ];
        let size = length(&outward);
        let scale = length(&u).max(length(&v)).max(length(&best.value));
        let normal = (size > SINGULAR * scale * scale).then(|| {
            let sign = dot(&outward, &best.value).signum();
            self.charts[chart].in_space(outward.map(|x| sign * x / size))
        });
        let point = self.charts[chart].in_space(best.value.map(|x| x * self.unit));
        Some((point, normal))
    }
}
