//! A small part of the surface that holds the nearest point, for its refinement in exact arithmetic.

use smallvec::SmallVec;

use super::expansion::{ANGLE, Expansion, dot, length, turn};
use super::search::{Target, search_about};
use super::waves::ABOVE;
use super::{CellTree, NearestOnSphere, Place};
use crate::intervals::Interval;
use crate::intervals::interval::UNIT;

/// The half sides of the rectangles of angles that are tried in turn.
const HALF_SIDES: [f64; 4] = [1e-3, 1e-4, 1e-5, 1e-6];
/// The largest number of cells and their parts that are searched outside of the rectangle.
const MOST_PIECES: usize = 20_000;
/// A cap of this part of the half side about the middle of a rectangle is inside, because sin φ ≥ √½ − 10^(−3) in its chart.
const CAP: f64 = 0.69;
/// Shorter parts are not divided.
const SHORTEST: f64 = 1e-9;

/// A rectangle of angles of a chart, on which the squared distance from a point is convex.
#[derive(Clone, Copy, Debug)]
pub(in crate::inspect) struct Isolated {
    /// The direction of the middle.
    pub(in crate::inspect) direction: [f64; 3],
    /// The distance of every point outside is at least this.
    pub(in crate::inspect) outside: f64,
    /// Half the second derivatives of the squared distance along (θ, φ) are at least this.
    pub(in crate::inspect) curvature: f64,
    /// Directions at most so far from the middle are inside.
    radius: f64,
    /// The vectors along which θ and φ grow, in space.
    along: [[f64; 3]; 2],
    /// Half the second derivatives of the squared distance.
    second: [f64; 3],
}

impl Isolated {
    /// Whether a direction is in the rectangle.
    pub(in crate::inspect) fn holds(&self, direction: &[f64; 3]) -> bool {
        let off = std::array::from_fn(|i| direction[i] - self.direction[i]);
        length(&off) <= 0.9 * self.radius
    }

    /// A step of Newton's method, for half the gradient of the squared distance along the sphere.
    pub(in crate::inspect) fn step_of(&self, gradient: &[f64; 3]) -> [f64; 3] {
        let [g, h] = self.along.each_ref().map(|along| dot(along, gradient));
        let [a, b, c] = self.second;
        let determinant = a * c - b * b;
        let step = [(b * h - c * g) / determinant, (b * g - a * h) / determinant];
        std::array::from_fn(|i| step[0] * self.along[0][i] + step[1] * self.along[1][i])
    }
}

impl CellTree {
    /// A rectangle about the nearest point that was found; `None` if doubles do not show that the nearest point is there.
    pub(in crate::inspect) fn isolate(
        &self,
        near: [f64; 3],
        slack: f64,
        found: &NearestOnSphere,
    ) -> Option<Isolated> {
        let (p, slack) = self.inside(near, slack)?;
        let target = &self.target(p);
        let (chart, at) = found.at;
        let best = self.expansion(chart, at, target);
        let [theta, phi] = at.map(turn);
        let ([ct, st], [cp, sp]) = (theta, phi);
        let in_space = |local: [f64; 3]| {
            let mut v = [0.0; 3];
            for (x, axis) in local.into_iter().zip(self.charts[chart].axes) {
                v[axis] = x;
            }
            v
        };
        let direction = in_space([sp * ct, sp * st, cp]);
        for half in HALF_SIDES {
            let curvature = self.curvature_about(chart, &best, half, slack);
            if curvature <= 0.0 {
                continue;
            }
            let Some(outside) = self.least_outside(chart, &best, &direction, CAP * half, target)
            else {
                continue;
            };
            let outside = (Interval::from(outside) - Interval::from(slack)) * self.unit;
            let curvature = Interval::from(curvature) * self.unit * self.unit;
            let square = self.unit * self.unit;
            return Some(Isolated {
                direction,
                outside: outside.low().max(0.0),
                curvature: curvature.low(),
                radius: CAP * half,
                along: [
                    in_space([-sp * st, sp * ct, 0.0]),
                    in_space([cp * ct, cp * st, -sp]),
                ],
                second: best.curvature().map(|c| c * square),
            });
        }
        None
    }

    /// A lower bound of half the second derivatives of the squared distance on the rectangle of a half side about an expansion.
    ///
    /// **Lemma 7.** With D, t, b, M as in Lemma 3 and s ≤ r, along directions of length |v₁| + |v₂| = 1 half the squared distance's third
    /// derivative X'''·(X − p) + 3X'·X'' is at most K = 6M(|D| + tr + br² + Mr³) + 3(t + 2br + 3Mr²)(2b + 6Mr); so half the second derivative
    /// along v changes by at most Kr s² ≤ 2Kr|v|². A point p that is off by `slack` changes it by at most `slack` |X''| s².
    fn curvature_about(&self, chart: usize, best: &Expansion, half: f64, slack: f64) -> f64 {
        let rectangle = Place {
            chart,
            low: best.at.map(|x| x - half),
            high: best.at.map(|x| x + half),
        };
        let Some(third) = self.third_about(&rectangle) else {
            return 0.0;
        };
        let (t, b) = best.sizes();
        let r = 2.0 * (half + ANGLE);
        let errors = &self.charts[chart].errors;
        let distance = length(&best.value) + errors.value + slack;
        let away = distance + r * (t + r * (b + r * third));
        let slope = t + r * (2.0 * b + 3.0 * r * third);
        let bend = 2.0 * b + 6.0 * third * r;
        let changes = 2.0 * r * (6.0 * third * away + 3.0 * slope * bend);
        let [first, mixed, second] = best.curvature();
        let parts = t * t + 2.0 * b * distance;
        let wrong = 2.0 * slack * bend
            + 4.0 * (errors.bend * distance + errors.slope * t)
            + 64.0 * UNIT * parts;
        first.min(second) - (mixed.abs() + changes + wrong) * ABOVE
    }

    /// A bound of |X'''|/6 on a rectangle.
    fn third_about(&self, rectangle: &Place) -> Option<f64> {
        let band = Self::square(0);
        let is_in_band = band.low[1] <= rectangle.low[1] && rectangle.high[1] <= band.high[1];
        if rectangle.chart == 0 && is_in_band {
            return Some(self.third_of_band);
        }
        let mut codes = (0..6).filter(|code| {
            let square = Self::square(*code);
            square.chart == rectangle.chart
                && [rectangle.low, rectangle.high]
                    .iter()
                    .all(|at| square.holds(at))
        });
        codes.next().map(|code| self.node(0, code).third)
    }

    /// A lower bound of the distance from the surface outside of the cap about a direction, above the upper bound of the distance; `None`
    /// if there is none.
    fn least_outside(
        &self,
        chart: usize,
        best: &Expansion,
        direction: &[f64; 3],
        radius: f64,
        target: &Target,
    ) -> Option<f64> {
        let mut search = search_about(chart, best, &self.charts[chart].errors);
        let mut low = f64::INFINITY;
        let mut waiting: SmallVec<[(Place, usize, usize); 64]> = SmallVec::new();
        waiting.extend((0..6).map(|code| (Self::square(code), 0, code)));
        let mut work = 0;
        while let Some((place, level, code)) = waiting.pop() {
            work += 1;
            if work > MOST_PIECES {
                return None;
            }
            let middle = self.direction_of(&place);
            let off = std::array::from_fn(|i| middle[i] - direction[i]);
            let reach = place.high[0] - place.low[0] + ANGLE;
            if 1.0001 * length(&off) + reach <= radius {
                continue;
            }
            let mut bound = self.node(level, code).extent.least_square(&target.p);
            if bound < search.enough {
                bound = bound.max(self.bound_by_best(&search, &place, level, code));
            }
            if bound < search.enough && level == self.divisions {
                bound = bound.max(self.piece(&mut search, &place, level, code, target));
            }
            if bound >= search.enough {
                low = low.min(bound);
                continue;
            }
            if place.high[0] - place.low[0] < SHORTEST {
                return None;
            }
            let next = |i: usize| match level < self.divisions {
                true => (level + 1, 4 * code + i),
                false => (level, code),
            };
            for (i, part) in place.parts().into_iter().enumerate() {
                let (level, code) = next(i);
                waiting.push((part, level, code));
            }
        }
        Some(Interval::from(low).sqrt().low())
    }

    /// The direction of the middle of a piece, in space.
    fn direction_of(&self, place: &Place) -> [f64; 3] {
        let [[ct, st], [cp, sp]] = place.middle().map(turn);
        let mut direction = [0.0; 3];
        for (x, axis) in [sp * ct, sp * st, cp]
            .into_iter()
            .zip(self.charts[place.chart].axes)
        {
            direction[axis] = x;
        }
        direction
    }
}
