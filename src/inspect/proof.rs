//! Verdicts by exact arithmetic for the points that the search in doubles leaves open.
//!
//! The search leaves a few small cubes around the point p, and it has proved that every zero within the tolerance is in one of
//! them. Four methods are tried in turn: expansions at refined feet; zeros at rational points; the exact section of the surface
//! with the sphere of the tolerance; and, for critical points that are not rational, the gap between 0 and the smallest positive
//! minimum ([`super::gap`]).

use super::distance::{Cube, holds_no_closed_piece};
use super::exact::{self, Answer};
use super::foot::{approach, stationary};
use super::gap::zero_in_ball;
use super::inspector::Inspector;
use super::known::{PartialInspection, Point};
use crate::exact::Rational;
use crate::intervals::interval::{exactly, minus, separation, square};
use crate::intervals::{Field, Interval, distance, rational, rationals};

/// The middles of about this many cubes are starting points for feet and for rational zeros.
const CANDIDATES: usize = 24;

impl Inspector {
    /// Decides whether f has a zero within the tolerance, and writes the verdict into `known`; `sign` is the sign of f at p.
    /// The caller must ensure that all zeros within the tolerance are in the cubes `left`.
    ///
    /// The verdict `outside` of the section is right: if the sphere of the tolerance meets no zero, the zeros inside it form
    /// closed pieces and isolated points. The cubes outside the balls of `lonely` hold neither ([`holds_no_closed_piece`]), and
    /// the only zero of such a ball is farther away than the tolerance.
    pub(super) fn by_proof(
        &self,
        field: &Field,
        p: &Point,
        left: &[Cube],
        sign: i8,
        known: &mut PartialInspection,
    ) {
        let step = left.len().div_ceil(CANDIDATES).max(1);
        let starts: Vec<[f64; 3]> = left.iter().step_by(step).map(|c| c.middle).collect();
        self.by_feet(field, p, left, &starts, sign, known);
        if known.inside.is_some() {
            return;
        }
        let Some(lonely) = self.by_rational_zero(field, p, &starts, known) else {
            return;
        };
        known.curve = if field.is_flat() {
            Some(self.circle_meets(field, p))
        } else {
            self.section(field, p)
        };
        if known.curve == Some(true) {
            known.inside = Some(true);
            known.bounds.high = known.bounds.high.min(self.around[1]);
        } else if known.curve == Some(false)
            && holds_no_closed_piece(&without(left, &lonely), p.near, field.is_flat())
        {
            known.inside = Some(false);
            known.bounds.low = known.bounds.low.max(self.around[0]);
        } else {
            self.by_gap(field, p, &starts, known);
        }
    }

    /// Decides by expansions at the feet that are found from `starts`. Each cube belongs to the nearest foot. One expansion may
    /// prove a zero within the tolerance; or all of them together exclude zeros in all cubes.
    fn by_feet(
        &self,
        field: &Field,
        p: &Point,
        left: &[Cube],
        starts: &[[f64; 3]],
        sign: i8,
        known: &mut PartialInspection,
    ) {
        let mut feet: Vec<([f64; 3], f64)> = Vec::new();
        for start in starts {
            let quick = approach(field, p.near, *start, 1e-9);
            if let Some(q) = quick.or_else(|| stationary(field, p.near, *start))
                && !feet
                    .iter()
                    .any(|(x, _)| distance(*x, q) < 1e-6 * self.goal.reach)
            {
                feet.push((q, 0.0));
            }
        }
        for cube in left {
            let far = |q: [f64; 3]| (separation(q, cube.middle) + cube.radius()).high();
            let nearest = feet.iter_mut().min_by(|a, b| far(a.0).total_cmp(&far(b.0)));
            if let Some((q, radius)) = nearest {
                *radius = radius.max(far(*q));
            }
        }
        let mut is_outside = !feet.is_empty();
        for (q, radius) in feet {
            let d = &self.tolerance;
            let found = exact::decide(field, p.exactly(), d, q, sign, Some(radius), &self.limits);
            match found {
                Some(Answer::Outside { .. }) => {}
                Some(Answer::Inside {
                    high,
                    touches,
                    foot,
                    ..
                }) => {
                    known.has_zero(*foot, touches, &high, self.around[1]);
                    return;
                }
                None => is_outside = false,
            }
        }
        if is_outside {
            known.inside = Some(false);
            known.bounds.low = known.bounds.low.max(self.around[0]);
        }
    }

    /// Looks for zeros at rational points near `starts`: points where the ball touches the surface, and singular points. If one is
    /// within the tolerance, `known` gets the verdict and the answer is `None`. If not, the answer is a list of balls, each about
    /// a rational zero beyond the tolerance that is the only zero in its ball.
    fn by_rational_zero(
        &self,
        field: &Field,
        p: &Point,
        starts: &[[f64; 3]],
        known: &mut PartialInspection,
    ) -> Option<Vec<Lonely>> {
        let mut lonely: Vec<Lonely> = Vec::new();
        let square = &self.tolerance * &self.tolerance;
        let size = p
            .near
            .iter()
            .fold(self.goal.reach, |m: f64, x| m.max(x.abs()));
        let width = rational(1e-9 * size);
        for start in starts {
            if lonely.iter().any(|ball| ball.holds(*start, Interval::ZERO)) {
                continue;
            }
            let candidates = [
                exact::critical_point(field, *start),
                approach(field, p.near, *start, 1e-9),
                Some(*start),
            ];
            for x in candidates.into_iter().flatten() {
                let Some(zero) = exact::rational_zero(field, &rationals(x), &width) else {
                    continue;
                };
                let away = exact::squared_length(&exact::exact_difference(p.exactly(), &zero));
                if away <= square {
                    known.has_zero(zero, away == square, &away, self.around[1]);
                    return None;
                }
                lonely.extend(self.lonely(field, &zero));
            }
        }
        Some(lonely)
    }

    /// A ball about a zero that is the only zero in the ball. It exists if the gradient is 0 at the zero and f, or −f, is strictly
    /// convex in the ball: then the zero is the only minimum of |f| there.
    fn lonely(&self, field: &Field, zero: &[Rational; 3]) -> Option<Lonely> {
        let (_, gradient) = field.exact_value_and_gradient(zero);
        if !gradient.iter().all(Rational::is_zero) {
            return None;
        }
        let local = field.exact_local(zero);
        let mut radii = (0..40).map(|k| self.goal.reach * 0.5f64.powi(k));
        let radius = radii.find(|radius| local.is_convex(*radius))?;
        let middle = zero.each_ref().map(Interval::from);
        Some(Lonely { middle, radius })
    }

    /// Looks for zeros at critical points that are not rational. The gap proves that a zero exists within the tolerance, but not
    /// where it is.
    fn by_gap(&self, field: &Field, p: &Point, starts: &[[f64; 3]], known: &mut PartialInspection) {
        let critical = starts
            .iter()
            .filter_map(|x| exact::critical_point(field, *x));
        let inside = critical.filter(|x| distance(*x, p.near) < self.around[0]);
        let mut tried: Vec<[f64; 3]> = Vec::new();
        for x in inside {
            let is_known = |y: &[f64; 3]| distance(*y, x) < 1e-6 * self.around[0];
            if tried.iter().any(is_known) {
                continue;
            }
            tried.push(x);
            if let Some(near) = zero_in_ball(field, p.exactly(), &self.tolerance, x) {
                // The zero is somewhere in the ball; its distance from `near` is not known.
                let square = &self.tolerance * &self.tolerance;
                known.has_zero(near, false, &square, self.around[1]);
                return;
            }
        }
    }
}

/// A ball that holds one zero, in its middle, and no other.
struct Lonely {
    middle: [Interval; 3],
    radius: f64,
}

impl Lonely {
    /// Whether the ball of the given radius about a point is inside this ball.
    fn holds(&self, point: [f64; 3], radius: Interval) -> bool {
        let away = square(minus(self.middle, exactly(point))).sqrt();
        (away + radius).high() < self.radius
    }
}

/// The cubes that are not inside one of the balls.
fn without(cubes: &[Cube], balls: &[Lonely]) -> Vec<Cube> {
    let is_inside = |cube: &Cube| {
        balls
            .iter()
            .any(|ball| ball.holds(cube.middle, cube.radius()))
    };
    let outside = cubes.iter().filter(|cube| !is_inside(cube));
    outside.copied().collect()
}
