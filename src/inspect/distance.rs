//! Bounds of the distance from a point to a surface, by branch and bound over cubes, in doubles with bounds of their errors.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::DistanceBounds;
use super::foot::{approach, enclose};
use crate::intervals::interval::{UNIT, cross, exactly, minus, product, separation, square};
use crate::intervals::{BoxBounds, Field, Interval, distance, largest};
use crate::limits::Limits;

/// Cubes smaller than this part of the reach are not divided.
const SMALLEST: f64 = 1e-11;
/// The precision of a foot, relative to the distance.
const FOOT_GOAL: f64 = 1e-8;

/// The goal of a search for the distance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Goal {
    /// The search radius; nothing farther away is examined.
    pub(super) reach: f64,
    /// Cubes that may be nearer than this are divided until dividing them proves nothing more.
    pub(super) tolerance: f64,
    /// The largest value of (high − low)/high that is precise enough.
    pub(super) relative: f64,
    /// The largest number of cubes that are divided.
    pub(super) cubes: usize,
}

/// The result of a search.
#[derive(Debug)]
pub(super) struct Nearby {
    pub(super) bounds: DistanceBounds,
    /// All zeros within the tolerance are in these cubes. The list is empty if the bounds decide whether there are any.
    pub(super) left: Vec<Cube>,
    /// Places near the nearest zero, without certificate.
    pub(super) near: Vec<[f64; 3]>,
}

/// A cube that may hold zeros.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cube {
    /// A lower bound of the distance between the point and the zeros in the cube.
    pub(super) low: f64,
    pub(super) middle: [f64; 3],
    pub(super) half: f64,
    /// Whether the derivative along the rays from the point is different from 0 in the whole cube.
    pub(super) is_radial: bool,
}

impl Cube {
    /// Whether doubles hardly tell the corners of the cube apart, so that its parts are not smaller.
    pub(super) fn is_unresolved(&self) -> bool {
        self.half <= 16.0 * UNIT * largest(&self.middle)
    }

    /// A bound of the distances of the points of the cube from its middle.
    pub(super) fn radius(&self) -> Interval {
        Interval::from(3.0).sqrt() * self.half
    }
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

/// The nearest cube is the greatest, as the heap requires.
impl Ord for Cube {
    fn cmp(&self, other: &Self) -> Ordering {
        other.low.total_cmp(&self.low)
    }
}

/// Bounds of the distance from p to the zeros of f. The caller must give the sign of f at p.
///
/// The cube with the least lower bound is divided first. On a cube with middle m, f(m + v) = f(m) + ∇f·v + rest with |rest| ≤
/// ρ, so its zeros are in the slab |f(m) + ∇f·v| ≤ ρ; the lower bound is the larger one of the distances of the slab and of the
/// cube. The upper bound is that of a foot, or of any point at which f has the other sign. If `limits` end the search, the
/// bounds found until then are returned.
pub(super) fn nearest(
    field: &Field,
    p: [f64; 3],
    sign: i8,
    known: DistanceBounds,
    goal: Goal,
    limits: &Limits,
) -> Nearby {
    let mut search = DistanceSearch {
        limits,
        field,
        p,
        sign,
        goal,
        high: known.high,
        best: None,
        heap: BinaryHeap::new(),
        budget: goal.cubes,
    };
    let root = Cube {
        low: known.low,
        middle: p,
        half: goal.reach,
        is_radial: false,
    };
    search.heap.push(root);
    let low = search.best_first().max(known.low);
    let first = search.heap.peek().map(|cube| cube.middle);
    let mut found = Nearby {
        bounds: DistanceBounds {
            low: low.min(search.high),
            high: search.high,
        },
        left: Vec::new(),
        near: search.best.into_iter().chain(first).collect(),
    };
    if found.bounds.low <= goal.tolerance && goal.tolerance < found.bounds.high {
        found.left = search.all_left();
    }
    found
}

struct DistanceSearch<'a> {
    limits: &'a Limits,
    field: &'a Field,
    p: [f64; 3],
    sign: i8,
    goal: Goal,
    high: f64,
    /// The place from which the upper bound comes.
    best: Option<[f64; 3]>,
    heap: BinaryHeap<Cube>,
    budget: usize,
}

impl DistanceSearch<'_> {
    /// Divides the nearest cube until the bounds are close, and returns the lower bound.
    fn best_first(&mut self) -> f64 {
        while let Some(cube) = self.heap.pop() {
            if cube.low >= self.high * (1.0 - self.goal.relative)
                || self.budget == 0
                || cube.half < SMALLEST * self.goal.reach
                || cube.is_unresolved()
            {
                // The nearest cube is next, so no other cube can be nearer.
                self.heap.push(cube);
                return cube.low;
            }
            self.look_for_zeros(&cube);
            self.divide(&cube);
        }
        self.goal.reach
    }

    /// The cubes that may hold zeros within the tolerance, after all divisions that help.
    fn all_left(mut self) -> Vec<Cube> {
        let mut left = Vec::new();
        // A zero exactly at the tolerance must stay in the list.
        self.goal.reach = self.goal.tolerance.next_up();
        while let Some(cube) = self.heap.pop() {
            if cube.low > self.goal.tolerance {
                break;
            }
            if cube.is_radial && cube.half < self.goal.tolerance / 64.0
                || self.budget == 0
                || cube.half < SMALLEST * self.goal.tolerance
                || cube.is_unresolved()
            {
                left.push(cube);
            } else {
                self.divide(&cube);
            }
        }
        left
    }

    /// Improves the upper bound by the foot that is found from the middle of a cube, or by the middle itself.
    fn look_for_zeros(&mut self, cube: &Cube) {
        let away = separation(self.p, cube.middle).high();
        if away < self.high && self.field.sign(cube.middle) != self.sign {
            self.high = away;
            self.best = Some(cube.middle);
        }
        if let Some(q) = approach(self.field, self.p, cube.middle, FOOT_GOAL)
            && distance(self.p, q) < self.high
        {
            let found = enclose(self.field, self.p, q, self.sign).high;
            if found < self.high {
                self.high = found;
                self.best = Some(q);
            }
        }
    }

    fn divide(&mut self, cube: &Cube) {
        self.budget -= 1;
        if self.budget.is_multiple_of(64) && self.limits.check().is_err() {
            self.budget = 0;
        }
        let half = cube.half / 2.0;
        let axes = if self.field.is_flat() { 2 } else { 3 };
        let p = exactly(self.p);
        for corner in 0..1u32 << axes {
            let mut middle = cube.middle;
            for (i, m) in middle.iter_mut().enumerate().take(axes) {
                *m += if corner >> i & 1 == 1 { half } else { -half };
            }
            let grown = half_side(cube, middle, corner, axes);
            let bounds = self.field.on_box(middle, [grown; 3]);
            if bounds.is_empty() {
                continue;
            }
            let away = minus(p, exactly(middle));
            let half = Interval::from(grown);
            let known = beside(away, grown, axes).max(cube.low);
            let slab = bounds.nearest_zero(away.map(|x| x / half), known / grown);
            let low = (Interval::from(slab) * half).low().max(known);
            if low < self.goal.reach && low < self.high {
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

/// The half side of the cube about `middle`, a double near the middle of an eighth of another cube, that is enough to hold this
/// eighth.
///
/// Lemma 13. Along an axis the eighth lies between the middle m of the cube and its side m ± h, so a half side of at least
/// |m − middle| and |m ± h − middle| is enough.
///
/// Law: `the_parts_of_a_cube_cover_it`.
pub(super) fn half_side(cube: &Cube, middle: [f64; 3], corner: u32, axes: usize) -> f64 {
    (0..axes).fold(0.0, |grown: f64, i| {
        let inner = Interval::from(cube.middle[i]);
        let half = if corner >> i & 1 == 1 {
            cube.half
        } else {
            -cube.half
        };
        let own = Interval::from(middle[i]);
        let ends = [inner - own, inner + Interval::from(half) - own];
        ends.iter()
            .fold(grown, |grown, end| grown.max(end.magnitude()))
    })
}

/// A lower bound of the distance of a point from a cube; `away` points from the middle of the cube to the point.
pub(super) fn beside(away: [Interval; 3], half: f64, axes: usize) -> f64 {
    let beyond = away.iter().take(axes);
    let beyond = beyond.map(|x| (x.abs() - Interval::from(half)).or_zero().squared());
    beyond.fold(Interval::ZERO, |sum, b| sum + b).sqrt().low()
}

/// Whether it is proved that ∇f(x)·(x − p) ≠ 0 for all x of a cube; `away` points from the middle of the cube to p.
fn is_radial(bounds: &BoxBounds, away: [Interval; 3], half: f64) -> bool {
    let radial = [0, 1, 2].map(|i| away[i] + Interval::up_to(half));
    let slopes = [0, 1, 2].map(|i| bounds.slope(i));
    product(slopes, radial).sign().is_some()
}

/// Whether it is proved that no closed piece of the surface, and no isolated zero, is inside these cubes.
///
/// Lemma. If the derivative of f along the rays from p is not 0 anywhere in the cubes, and some ray from p meets none of them, the
/// zeros of f in the cubes have no compact piece without boundary.
/// Proof. The gradient is not 0 there, so such a piece would be a smooth surface. The projection from p onto the sphere of
/// directions would be a local diffeomorphism on it, so its image would be open. The image would also be compact, hence the
/// whole sphere, and every ray would meet the piece.
pub(super) fn holds_no_closed_piece(left: &[Cube], p: [f64; 3], is_flat: bool) -> bool {
    let rays = (0..27).map(|n| [n % 3, n / 3 % 3, n / 9].map(|k| f64::from(k) - 1.0));
    let mut rays =
        rays.filter(|u| u.iter().any(|x| x.abs() > 0.5) && (!is_flat || u[2].abs() < 0.5));
    // A ray misses a cube if the middle of the cube is farther from the ray than the corners are from the middle.
    let misses = |u: &[f64; 3], cube: &Cube| {
        let (at, u) = (minus(exactly(cube.middle), exactly(p)), exactly(*u));
        let beside = if product(at, u).is_negative() {
            square(at)
        } else {
            square(cross(at, u)) / square(u)
        };
        cube.radius().squared().is_below(beside)
    };
    left.iter().all(|cube| cube.is_radial) && rays.any(|u| left.iter().all(|cube| misses(&u, cube)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::intervals::rational;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

        /// Lemma 13: every eighth of a cube is in the new cube for it, even if the half side is as small as the last place of
        /// the middle.
        #[test]
        fn the_parts_of_a_cube_cover_it(m in prop::array::uniform3(-8.0f64..8.0), half in 1.0f64..2.0, e in -56i32..1, corner in 0u32..8) {
            let cube = Cube { low: 0.0, middle: m, half: half * 2f64.powi(e), is_radial: false };
            let side = |i: usize| if corner >> i & 1 == 1 { cube.half } else { -cube.half };
            let middle: [f64; 3] = std::array::from_fn(|i| m[i] + side(i) / 2.0);
            let grown = rational(half_side(&cube, middle, corner, 3));
            for i in 0..3 {
                let [own, inner, half] = [middle[i], m[i], side(i)].map(rational);
                for end in [&inner + &half, inner] {
                    prop_assert!((end - &own).abs() <= grown);
                }
            }
            let exact = Interval::from(3.0).sqrt();
            prop_assert!(rational(exact.low()) * rational(exact.low()) < Rational::from(3));
            prop_assert!(Rational::from(3) < rational(exact.high()) * rational(exact.high()));
        }

        /// The lower bound of the distance from a cube is not too large at its border, and a derivative that vanishes at a
        /// corner is not proved to be different from 0.
        #[test]
        fn the_border_of_a_cube_is_not_passed(m in prop::array::uniform3(-8.0f64..8.0), half in 0.01f64..1.0, off in prop::array::uniform3(-4.0f64..4.0)) {
            let p: [f64; 3] = std::array::from_fn(|i| m[i] + off[i]);
            let away = minus(exactly(p), exactly(m));
            let found = rational(beside(away, half, 3));
            let exact: Rational = (0..3).map(|i| {
                let beyond = ((rational(p[i]) - rational(m[i])).abs() - rational(half)).max(Rational::zero());
                &beyond * &beyond
            }).sum();
            prop_assert!(&found * &found <= exact);
        }
    }
}
