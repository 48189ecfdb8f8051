//! How near a surface comes to a point: branch and bound over cubes, in doubles with bounds of their errors.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::DistanceBounds;
use super::foot::{approach, difference, enclose};
use crate::field::{BoxBounds, Field, distance, dot};
use crate::limits::Limits;

/// Cubes are not divided below this part of the reach.
const SMALLEST: f64 = 1e-11;
/// How near the foot has to be found, relative to the distance.
const FOOT_GOAL: f64 = 1e-8;

/// How a distance is looked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Goal {
    /// Nothing farther away is looked for.
    pub(super) reach: f64,
    /// Cubes that may be nearer than this are divided until nothing more is to be learnt of them.
    pub(super) tolerance: f64,
    /// The goal for (high − low)/high.
    pub(super) relative: f64,
    /// At most so many cubes are divided.
    pub(super) cubes: usize,
}

/// What the search has found.
#[derive(Debug)]
pub(super) struct Nearby {
    pub(super) bounds: DistanceBounds,
    /// All zeros within the tolerance are in these cubes; empty unless the bounds leave it open whether there are any.
    pub(super) left: Vec<Cube>,
}

/// A cube that may hold zeros.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cube {
    /// No zero in it is nearer to the point than this.
    pub(super) low: f64,
    pub(super) middle: [f64; 3],
    pub(super) half: f64,
    /// The derivative away from the point vanishes nowhere in it.
    pub(super) is_radial: bool,
}

impl PartialEq for Cube {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cube {}

impl PartialOrd for Cube {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The nearest is the greatest, for the heap.
impl Ord for Cube {
    fn cmp(&self, other: &Self) -> Ordering {
        other.low.total_cmp(&self.low)
    }
}

/// Bounds of the distance from p to the zeros of f, which has the given sign at p.
///
/// Best first: of a cube with f(m + v) = f(m) + ∇f·v + rest, |rest| ≤ ρ, the surface is no nearer than the slab
/// |f(m) + ∇f·v| ≤ ρ, nor than the cube. It ends when `limits` say so, with what is known then. Above, the bound is that of a foot, or of any point where f has the other sign.
pub(super) fn nearest(
    field: &Field,
    p: [f64; 3],
    sign: i8,
    known: DistanceBounds,
    goal: Goal,
    limits: &Limits,
) -> Nearby {
    let mut search = Search {
        limits,
        field,
        p,
        sign,
        goal,
        high: known.high,
        heap: BinaryHeap::new(),
        budget: goal.cubes,
    };
    let root = Cube {
        low: known.low,
        middle: p,
        half: goal.reach * (1.0 + 1e-12),
        is_radial: false,
    };
    search.heap.push(root);
    let low = search.best_first().max(known.low);
    let mut found = Nearby {
        bounds: DistanceBounds {
            low: low.min(search.high),
            high: search.high,
        },
        left: Vec::new(),
    };
    if found.bounds.low <= goal.tolerance && goal.tolerance < found.bounds.high {
        found.left = search.all_left();
    }
    found
}

struct Search<'a> {
    limits: &'a Limits,
    field: &'a Field,
    p: [f64; 3],
    sign: i8,
    goal: Goal,
    high: f64,
    heap: BinaryHeap<Cube>,
    budget: usize,
}

impl Search<'_> {
    /// Divides the nearest cube until the bounds are close. The lower bound.
    fn best_first(&mut self) -> f64 {
        while let Some(cube) = self.heap.pop() {
            if cube.low >= self.high * (1.0 - self.goal.relative)
                || self.budget == 0
                || cube.half < SMALLEST * self.goal.reach
            {
                // Best first: no other cube can be nearer.
                self.heap.push(cube);
                return cube.low;
            }
            self.look_for_zeros(&cube);
            self.divide(&cube);
        }
        self.goal.reach
    }

    /// The cubes that may hold zeros within the tolerance, divided as long as that can help.
    fn all_left(mut self) -> Vec<Cube> {
        let mut left = Vec::new();
        self.goal.reach = self.goal.tolerance * (1.0 + 1e-14);
        while let Some(cube) = self.heap.pop() {
            if cube.low > self.goal.tolerance {
                break;
            }
            if cube.is_radial && cube.half < self.goal.tolerance / 64.0
                || self.budget == 0
                || cube.half < SMALLEST * self.goal.tolerance
            {
                left.push(cube);
            } else {
                self.divide(&cube);
            }
        }
        left
    }

    /// An upper bound from the foot that is found from the middle of a cube, or from the middle itself.
    fn look_for_zeros(&mut self, cube: &Cube) {
        let away = distance(self.p, cube.middle);
        if away < self.high && self.field.sign(cube.middle) != self.sign {
            self.high = away * (1.0 + 1e-14);
        }
        if let Some(q) = approach(self.field, self.p, cube.middle, FOOT_GOAL)
            && distance(self.p, q) < self.high
        {
            let found = enclose(self.field, self.p, q, self.sign).high;
            self.high = self.high.min(found);
        }
    }

    fn divide(&mut self, cube: &Cube) {
        self.budget -= 1;
        if self.budget.is_multiple_of(64) && self.limits.check().is_err() {
            self.budget = 0;
        }
        let half = cube.half / 2.0;
        let axes = if self.field.is_flat() { 2 } else { 3 };
        for corner in 0..1u32 << axes {
            let mut middle = cube.middle;
            for (i, m) in middle.iter_mut().enumerate().take(axes) {
                *m += if corner >> i & 1 == 1 { half } else { -half };
            }
            // A little larger than it is, for the rounding of its middle.
            let size: f64 = middle.iter().map(|m| m.abs()).sum();
            let grown = half * (1.0 + 1e-12) + size * f64::EPSILON;
            let bounds = self.field.on_box(middle, [grown; 3]);
            if bounds.is_empty() {
                continue;
            }
            let away = difference(self.p, middle);
            let slab = bounds.nearest_zero(away.map(|x| x / grown)) * grown;
            let low = slab.max(beside(away, grown, axes)).max(cube.low);
            if low < self.goal.reach && low < self.high * (1.0 + 1e-14) {
                self.heap.push(Cube {
                    low,
                    middle,
                    half: grown,
                    is_radial: is_radial(&bounds, away, grown),
                });
            }
        }
    }
}

/// How far a point is at least from a cube.
fn beside(away: [f64; 3], half: f64, axes: usize) -> f64 {
    let beyond = away.iter().take(axes).map(|x| (x.abs() - half).max(0.0));
    beyond.map(|b| b * b).sum::<f64>().sqrt() * (1.0 - 1e-14)
}

/// Whether ∇f(x)·(x − p) ≠ 0 for all x of a cube; `away` points from its middle to p.
fn is_radial(bounds: &BoxBounds, away: [f64; 3], half: f64) -> bool {
    let middle = dot(bounds.slopes.map(|[m, _]| m), away).abs();
    let spread: f64 = bounds
        .slopes
        .iter()
        .zip(away)
        .map(|([m, r], a)| m.abs() * half + r * (a.abs() + half))
        .sum();
    middle > spread * (1.0 + 1e-9)
}

/// No compact piece of a smooth surface is inside these cubes, if on all of them the derivative away from p is not 0, and
/// some ray from p meets none of them: along the rays such a piece would lie over the sphere of directions locally one to
/// one, and so, being compact, over all of it.
pub(super) fn holds_no_closed_piece(left: &[Cube], p: [f64; 3], is_flat: bool) -> bool {
    let axes = if is_flat { 2 } else { 3 };
    let rays = (0..27).map(|n| [n % 3, n / 3 % 3, n / 9].map(|k| f64::from(k) - 1.0));
    let mut rays = rays.filter(|u| dot(*u, *u) > 0.0 && (!is_flat || u[2].abs() < 0.5));
    let misses = |u: &[f64; 3], cube: &Cube| {
        let at = difference(cube.middle, p);
        let along = (dot(at, *u) / dot(*u, *u)).max(0.0);
        (0..axes).any(|i| (at[i] - along * u[i]).abs() > 4.0 * cube.half)
    };
    left.iter().all(|cube| cube.is_radial) && rays.any(|u| left.iter().all(|cube| misses(&u, cube)))
}
