//! The distance of a point that is farther away than the tolerance.

use super::DistanceBounds;
use super::distance::{Goal, nearest};
use super::inspector::{Factor, Inspector};
use super::known::{PartialInspection, Point};
use crate::intervals::interval::separation;
use crate::intervals::{Field, Interval};

/// The part of the cubes of a verdict that may be divided for a distance.
pub(super) const SHARE: usize = 8;
/// How often the search radius is doubled along a ray, from the tolerance on.
const DOUBLINGS: u32 = 64;
/// How often a piece of a ray with a zero is halved.
const HALVINGS: u32 = 30;
/// How often the search radius grows, by a factor of 4 each time, if no zero was found on the rays.
pub(super) const GROWTHS: u32 = 12;

impl Inspector {
    /// Improves the bounds of the distances of the factors' zeros from a point that is outside, until those of the nearest one are
    /// as close as the goal requires or the cubes are used up. `at` is the point for a factor.
    pub(super) fn far<'p>(
        &'p self,
        parts: &mut [PartialInspection],
        at: impl Fn(&'p Field) -> &'p Point<'p>,
    ) {
        let high = |parts: &[PartialInspection]| {
            let highs = parts.iter().map(|known| known.bounds.high);
            highs.fold(f64::INFINITY, f64::min)
        };
        let is_near = |known: &PartialInspection, best: f64| {
            known.bounds.low < best * (1.0 - self.goal.relative)
        };
        // The distances from the curves of common zeros are known.
        fn others<'k, 'p>(
            parts: &'k mut [PartialInspection],
            factors: &'p [Factor],
        ) -> impl Iterator<Item = (&'k mut PartialInspection, &'p Field)> {
            let pairs = parts.iter_mut().zip(factors);
            let pairs =
                pairs.filter(|(known, factor)| factor.curve.is_none() || known.foot.is_none());
            pairs.map(|(known, factor)| (known, &factor.field))
        }
        for (known, field) in others(parts, self.factors()) {
            self.by_refined_foot(field, at(field), known);
        }
        let best = high(parts);
        if parts.iter().all(|known| !is_near(known, best)) && best.is_finite() {
            return;
        }
        for (known, field) in others(parts, self.factors()) {
            if known.bounds.high.is_infinite() {
                let p = at(field);
                let found = DistanceBounds {
                    low: 0.0,
                    high: self.on_rays(field, p),
                };
                self.learn(known, found, p.slack);
            }
        }
        let mut reach = high(parts);
        let is_known = reach.is_finite();
        if !is_known {
            reach = self.goal.reach;
        }
        for _ in 0..if is_known { 1 } else { GROWTHS } {
            if !is_known {
                reach *= 4.0;
            }
            for (known, field) in others(parts, self.factors()) {
                if is_near(known, reach) {
                    self.search_within(field, at(field), known, reach);
                }
            }
            if high(parts).is_finite() || self.limits.check().is_err() {
                return;
            }
        }
    }

    /// A search of cubes within a radius.
    fn search_within(&self, field: &Field, p: &Point, known: &mut PartialInspection, reach: f64) {
        let slack = Interval::from(p.slack);
        let outer = DistanceBounds {
            low: (Interval::from(known.bounds.low) - slack).or_zero().low(),
            high: (Interval::from(known.bounds.high) + slack).high(),
        };
        let goal = Goal {
            reach: (Interval::from(reach) * (1.0 + 1e-9) + slack).high(),
            tolerance: 0.0,
            cubes: self.cubes_for(field) / SHARE,
            ..self.goal
        };
        let found = nearest(field, p.near, field.sign(p.near), outer, goal, &self.limits);
        self.learn(known, found.bounds, p.slack);
    }

    /// An upper bound of the distance of a zero, from changes of the sign along a few rays; ∞ if none is found.
    fn on_rays(&self, field: &Field, p: &Point) -> f64 {
        let sign = field.sign(p.near);
        let axes = if field.is_flat() { 2 } else { 3 };
        let steps = |n: u32| [n % 3, n / 3 % 3, n / 9].map(|k| f64::from(k) - 1.0);
        let rays = (0..3u32.pow(axes)).map(move |n| match axes {
            2 => [steps(n)[0], steps(n)[1], 0.0],
            _ => steps(n),
        });
        let rays = rays.filter(|u| u.iter().any(|x| x.abs() > 0.5));
        rays.chain([field.gradient(p.near)])
            .filter_map(|u| {
                let length = u.iter().map(|x| x * x).sum::<f64>().sqrt();
                let u = u.map(|x| x / length);
                self.first_change(field, p.near, u, sign)
            })
            .fold(f64::INFINITY, f64::min)
    }

    /// An upper bound of the distance of a change of the sign along a ray.
    fn first_change(&self, field: &Field, p: [f64; 3], u: [f64; 3], sign: i8) -> Option<f64> {
        let there = |t: f64| -> [f64; 3] { std::array::from_fn(|i| p[i] + t * u[i]) };
        let is_other = |t: f64| {
            let q = there(t);
            q.iter().all(|x| x.is_finite()) && field.sign(q) != sign
        };
        let mut radii = (0..DOUBLINGS).map(|k| self.goal.tolerance * f64::from(k).exp2());
        let mut high = radii.find(|&t| is_other(t))?;
        let mut low = 0.0;
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(low, high);
            if is_other(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        Some(separation(p, there(high)).high())
    }
}
