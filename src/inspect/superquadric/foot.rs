//! The nearest point of a superquadric, and the normal there, in doubles.

use std::cmp::Ordering;

use super::arc::ArcPoint;
use super::body::{Body, Place};
use crate::inspect::nearest::{FootCandidate, SINGULAR, after_steps, unit};
use crate::intervals::{Interval, distance, dot};

/// The part of a parameter by which derivatives are estimated.
const STEP: f64 = 1e-6;
const NEWTON_STEPS: usize = 30;
/// A point is far from its foot beyond this part of its size,
const FAR: f64 = 1e-3;
/// and directions are different beyond this distance.
const DIFFERENT: f64 = 1e-6;
/// Parameters from which a foot near an axis is looked for.
const BESIDE: [f64; 3] = [0.0, 1e-3, 0.05];

impl Body {
    /// The foot of a point with coordinates of at least 0, by Newton's method from a place near it.
    pub(super) fn foot(&self, p: [f64; 3], start: &Place) -> FootCandidate {
        // Where the halves of an arc meet, the foot may be on either; and on an axis there may be no step.
        let sides = |(is_upper, t): (bool, f64)| match t {
            1.0.. => vec![(is_upper, t), (!is_upper, t)],
            0.0..=0.0 => BESIDE.map(|t| (is_upper, t)).to_vec(),
            _ => vec![(is_upper, t)],
        };
        let profiles = start.profile.map_or(vec![None], |profile| {
            sides(profile).into_iter().map(Some).collect()
        });
        let starts = sides(start.around)
            .into_iter()
            .flat_map(|around| profiles.iter().map(move |profile| (around, *profile)));
        let middle = |place: &Place| self.at(place).map(Interval::middle);
        let length = |place: &Place| distance(middle(place), p);
        // At a cusp or an edge the steps lead away, and the start stays the best place.
        let best = starts.fold(*start, |best, (around, profile)| {
            let found = self.stationary(p, &Place { around, profile });
            match length(&found) <= length(&best) {
                true => found,
                false => best,
            }
        });
        let foot = middle(&best);
        let away = std::array::from_fn(|i| p[i] - foot[i]);
        let normal = self.outward(&best).and_then(unit);
        let normal = normal.map(|normal| perpendicular(away, normal, distance(p, [0.0; 3])));
        FootCandidate::on_form(foot, normal)
    }

    /// The place that Newton's method finds on the same halves of the arcs.
    fn stationary(&self, p: [f64; 3], start: &Place) -> Place {
        let place = |[t, s]: [f64; 2]| Place {
            around: (start.around.0, t.clamp(0.0, 1.0)),
            profile: start
                .profile
                .map(|(is_upper, _)| (is_upper, s.clamp(0.0, 1.0))),
        };
        let first = [start.around.1, start.profile.map_or(0.0, |(_, t)| t)];
        let step = |at: [f64; 2]| self.newton_step(p, &place(at));
        place(after_steps(first, NEWTON_STEPS, step))
    }

    /// The tangents along the two arcs, perpendicular to their normals, of any length.
    fn tangents(&self, place: &Place) -> [[f64; 3]; 2] {
        let (around, profile) = self.arc_points(place);
        let middle = |v: [Interval; 2]| v.map(Interval::middle);
        let turned = |[a, b]: [f64; 2]| [-b, a];
        let (at, along) = (middle(around.at), turned(middle(around.normal)));
        let [a, b, c] = self.axes.map(Interval::middle);
        match profile {
            None => [[a * along[0], b * along[1], 0.0], [0.0; 3]],
            Some(profile) => {
                let up = turned(middle(profile.normal));
                [
                    [a * along[0], b * along[1], 0.0],
                    [a * up[0] * at[0], b * up[0] * at[1], c * up[1]],
                ]
            }
        }
    }

    /// The parts of the way from p to the surface along the tangents, which are 0 at a foot.
    fn aside(&self, p: [f64; 3], place: &Place) -> [f64; 2] {
        let at = self.at(place).map(Interval::middle);
        let away = std::array::from_fn(|i| at[i] - p[i]);
        self.tangents(place).map(|tangent| dot(tangent, away))
    }

    fn newton_step(&self, p: [f64; 3], place: &Place) -> Option<[f64; 2]> {
        let at = [place.around.1, place.profile.map_or(0.0, |(_, t)| t)];
        let moved = |t: [f64; 2]| Place {
            around: (place.around.0, t[0]),
            profile: place.profile.map(|(is_upper, _)| (is_upper, t[1])),
        };
        let value = self.aside(p, place);
        // Derivatives by t and s, as quotients of differences.
        let slope = |axis: usize| {
            let step = (STEP * at[axis]).max(f64::MIN_POSITIVE);
            let ends = [-step, step].map(|step| {
                let mut t = at;
                t[axis] = (t[axis] + step).clamp(0.0, 1.0);
                (t[axis], self.aside(p, &moved(t)))
            });
            let [(a, first), (b, last)] = ends;
            [0, 1].map(|i: usize| (last[i] - first[i]) / (b - a))
        };
        let by_t = slope(0);
        if place.profile.is_none() {
            return Some([-value[0] / by_t[0], 0.0]);
        }
        let by_s = slope(1);
        let determinant = by_t[0] * by_s[1] - by_s[0] * by_t[1];
        let step = [
            (by_s[0] * value[1] - by_s[1] * value[0]) / determinant,
            (by_t[1] * value[0] - by_t[0] * value[1]) / determinant,
        ];
        step.iter().all(|s| s.is_finite()).then_some(step)
    }

    /// The gradient of the norm, which is 1 on the surface; `None` where it has none.
    fn outward(&self, place: &Place) -> Option<[f64; 3]> {
        let (around, profile) = self.arc_points(place);
        // The gradient of the norm of an arc, at a point where the norm is 1. Inward arcs have cusps on the axes, and straight ones corners.
        let gradient = |bend: Ordering, point: &ArcPoint| {
            let (at, normal) = (
                point.at.map(Interval::middle),
                point.normal.map(Interval::middle),
            );
            let scale = at[0] * normal[0] + at[1] * normal[1];
            let is_smooth = bend == Ordering::Greater || at[0].min(at[1]) > SINGULAR;
            is_smooth.then(|| normal.map(|x| x / scale))
        };
        let of_around = gradient(self.around.bend, &around);
        let [a, b, c] = self.axes.map(Interval::middle);
        let Some((arc, profile)) = self.profile.as_ref().zip(profile) else {
            let [u, v] = of_around?;
            return Some([u / a, v / b, 0.0]);
        };
        let [r, z] = gradient(arc.bend, &profile)?;
        if r.abs() <= 0.0 {
            // At a pole the direction around does not matter.
            return Some([0.0, 0.0, z / c]);
        }
        let [u, v] = of_around?;
        Some([r * u / a, r * v / b, z / c])
    }
}

/// The normal, or the direction towards the point if the two differ. On an axis the normal turns infinitely fast for exponents from 1 to
/// 2, so that doubles of the foot do not determine it, but the direction does.
fn perpendicular(away: [f64; 3], normal: [f64; 3], size: f64) -> [f64; 3] {
    let Some(direction) = unit(away).filter(|_| distance(away, [0.0; 3]) > FAR * size) else {
        return normal;
    };
    let side = dot(direction, normal).signum();
    let towards = direction.map(|x| side * x);
    match distance(towards, normal) > DIFFERENT {
        true => towards,
        false => normal,
    }
}
