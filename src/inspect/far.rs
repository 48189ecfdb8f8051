//! The distance of a point that is farther away than the tolerance.

use super::DistanceBounds;
use super::distance::{Goal, nearest};
use super::exact::{critical_point, exact_difference, rational_zero, squared_length};
use super::inspector::{Factor, Inspector};
use super::known::{PartialInspection, Point};
use crate::exact::Rational;
use crate::intervals::interval::separation;
use crate::intervals::{Field, Interval, rational, rationals};

/// The part of the cubes of a verdict that may be divided for a distance.
pub(super) const SHARE: usize = 8;
/// How often the search radius is doubled along a ray, from the tolerance on.
const DOUBLINGS: u32 = 64;
/// How near a rational point must be to a critical point in doubles, relative to the size of the coordinates.
const WIDTH: f64 = 1e-9;
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
                    high: self.on_rays(field, p).min(towards_extremum(field, p.near)),
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
        if !self.is_close(&known.bounds) && self.is_exact_possible(field) {
            self.by_rational_point(field, p, &found.near, known);
        }
    }

    /// Improves the upper bound by zeros at rational points near `starts` at which the gradient vanishes. There f need not change its
    /// sign, as at isolated points.
    fn by_rational_point(
        &self,
        field: &Field,
        p: &Point,
        starts: &[[f64; 3]],
        known: &mut PartialInspection,
    ) {
        let size = p.near.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let width = rational(WIDTH * size.max(self.goal.reach));
        for start in starts {
            let Some(critical) = critical_point(field, *start) else {
                continue;
            };
            let Some(zero) = rational_zero(field, &rationals(critical), &width) else {
                continue;
            };
            let square = squared_length(&exact_difference(p.exactly(), &zero));
            let high = Interval::from(&square).sqrt().high();
            if high < known.bounds.high {
                known.bounds.high = high;
                known.foot = Some(zero.each_ref().map(Rational::to_f64));
                known.exact_foot = Some(zero);
            }
        }
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

/// An upper bound of the distance of a change of the sign between a point and a critical point of f that is found from it; ∞ if f has one
/// sign at both. Rays in fixed directions miss a surface that is thin, but its inside has an extremum.
fn towards_extremum(field: &Field, p: [f64; 3]) -> f64 {
    let sign = field.sign(p);
    let Some(extremum) = critical_point(field, p).filter(|x| field.sign(*x) != sign) else {
        return f64::INFINITY;
    };
    let (mut near, mut far) = (p, extremum);
    for _ in 0..HALVINGS {
        let middle = std::array::from_fn(|i| f64::midpoint(near[i], far[i]));
        if field.sign(middle) == sign {
            near = middle;
        } else {
            far = middle;
        }
    }
    separation(p, far).high()
}
