//! The foot of a point on a harmonic surface, in doubles.

use super::CellTree;
use super::expansion::{dot, length};
use crate::inspect::nearest::{SINGULAR, after_steps};
use crate::shape::cross;

/// The largest number of steps of Newton's method.
const STEPS: usize = 30;

impl CellTree {
    /// The nearest point of the surface to a point, relative to the center, and the unit normal there, away from the center.
    pub(in crate::inspect) fn foot(&self, near: [f64; 3]) -> Option<([f64; 3], Option<[f64; 3]>)> {
        let (p, _) = self.inside(near, 0.0)?;
        let target = &self.target(p);
        let (chart, start) = self.nearest(near, 0.0, 0.0)?.at;
        let step = |at| self.expansion(chart, at, target).newton_step();
        let at = after_steps(start, STEPS, step);
        let best = self.expansion(chart, at, &self.target([0.0; 3]));
        let [u, v] = best.slopes;
        let outward = cross(v, u);
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
