//! Distances from the curve in which two surfaces meet, g = h = 0, by branch and bound over cubes.

use std::collections::BinaryHeap;

use nalgebra::{Matrix3, Vector3};

use super::DistanceBounds;
use super::distance::{Cube, Goal, beside, half_side};
use crate::arcs::{CommonZero, enclose_common_zero, leaves_window};
use crate::error::Result;
use crate::exact::Rational;
use crate::intervals::interval::{exactly, minus, separation, square};
use crate::intervals::{Field, Interval, distance, rational, weights_of_common_zero};
use crate::limits::Limits;
use crate::poly::SparsePolynomial;

/// Cubes smaller than this part of the reach are not divided.
const SMALLEST: f64 = 1e-11;
/// Steps of Newton's method in doubles.
const STEPS: usize = 20;
/// A common zero is enclosed if it is alone within these parts of the size of its coordinates.
const ALONE: [f64; 3] = [1e-3, 1e-6, 1e-10];

/// Two polynomials without a common factor.
#[derive(Debug)]
pub(super) struct CommonZeros {
    fields: [Field; 2],
}

/// Half the side of the window that an arc must leave, in radii of the ball.
const WINDOW: f64 = 1.125;

/// The result of a search.
#[derive(Debug)]
pub(super) struct NearestCommonZero {
    pub(super) bounds: DistanceBounds,
    /// The common zero from which the upper bound comes.
    pub(super) foot: Option<CommonZero>,
}

impl CommonZeros {
    /// `None` if one of them is a constant: then there is no common zero.
    pub(super) fn new(pair: &[SparsePolynomial<3>; 2]) -> Option<Self> {
        let has_zeros = pair.iter().all(|f| f.degree().is_some_and(|n| n > 0));
        has_zeros.then(|| Self {
            fields: pair.each_ref().map(Field::new),
        })
    }

    /// The common zeros in coordinates about a point.
    ///
    /// # Errors
    /// Those of `limits`.
    pub(super) fn about(&self, point: &[Rational; 3], limits: &Limits) -> Result<Self> {
        let [f, g] = self.both();
        Ok(Self {
            fields: [f.about(point, limits)?, g.about(point, limits)?],
        })
    }

    pub(super) fn both(&self) -> [&Field; 2] {
        self.fields.each_ref()
    }

    /// Whether a point is a common zero.
    pub(super) fn is_zero(&self, p: &[Rational; 3]) -> bool {
        let mut fields = self.fields.iter();
        fields.all(|field| field.polynomial().evaluate(p).is_zero())
    }

    /// Bounds of the distance from p to the common zeros within the reach of the goal.
    ///
    /// As in the search for one surface, the cube with the least lower bound is divided first. In a cube the common zeros are
    /// zeros of g, of h, and of the combination that is 0, linearized, on the plane through the nearest common zero that faces p.
    pub(super) fn nearest(
        &self,
        p: [f64; 3],
        known: DistanceBounds,
        goal: Goal,
        limits: &Limits,
    ) -> NearestCommonZero {
        let mut search = Search {
            of: self,
            p,
            reach: goal.reach,
            relative: goal.relative,
            high: known.high,
            foot: None,
            heap: BinaryHeap::new(),
        };
        search.look_for_zero(p);
        search.heap.push(Cube {
            low: known.low,
            middle: p,
            half: goal.reach,
            is_radial: false,
        });
        let mut low = goal.reach;
        for count in 0..=goal.cubes {
            let Some(cube) = search.heap.pop() else {
                break;
            };
            let is_over = count == goal.cubes || count % 64 == 63 && limits.check().is_err();
            let is_small = cube.half < SMALLEST * goal.reach || cube.is_unresolved();
            if cube.low >= search.high * (1.0 - goal.relative) || is_over || is_small {
                // The nearest cube is first.
                low = cube.low;
                break;
            }
            search.look_for_zero(cube.middle);
            search.divide(&cube);
        }
        let low = low.max(known.low);
        NearestCommonZero {
            bounds: DistanceBounds {
                low: low.min(search.high),
                high: search.high,
            },
            foot: search.foot,
        }
    }

    /// An enclosed common zero near some point, if there is one that is regular.
    fn enclosed(&self, q: [f64; 3]) -> Option<CommonZero> {
        let size = q.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let size = size.max(f64::MIN_POSITIVE);
        ALONE
            .iter()
            .find_map(|part| enclose_common_zero(self.both(), q, part * size))
    }

    /// Whether the arc through a common zero that is inside of the ball of radius d about p is proved to go on to its outside.
    pub(super) fn leaves(&self, foot: &CommonZero, p: [Interval; 3], d: Interval) -> bool {
        let middle = p.map(Interval::middle);
        let half = WINDOW * d.high();
        let window = middle.map(|x| [x - half, x + half]);
        leaves_window(self.both(), foot, window).is_some_and(|outside| {
            let away = square(minus(exactly(outside.position), p)).sqrt();
            d.is_below(away - Interval::from(outside.radius))
        })
    }

    /// A point with simple coordinates near a common zero, if it is one itself.
    pub(super) fn simple(&self, foot: &CommonZero) -> Option<[Rational; 3]> {
        let radius = rational(foot.radius);
        let point = foot.position.map(|x| {
            let x = rational(x);
            Rational::simplest_between(&(&x - &radius), &(&x + &radius))
        });
        self.is_zero(&point).then_some(point)
    }

    /// The nearest common zero of both, linearized at q.
    fn linearized(&self, q: [f64; 3]) -> Option<[f64; 3]> {
        let [(first, f), (second, g)] = self.both().map(|field| field.value_and_gradient(q));
        let [a, b] = weights_of_common_zero([first, second], [f, g])?;
        let next = std::array::from_fn(|i| q[i] - a * f[i] - b * g[i]);
        next.iter().all(|x: &f64| x.is_finite()).then_some(next)
    }

    /// A common zero near `start`, in doubles.
    fn on_both(&self, start: [f64; 3]) -> Option<[f64; 3]> {
        let mut q = start;
        for _ in 0..STEPS {
            let next = self.linearized(q)?;
            let size = next.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            let moved = distance(next, q);
            q = next;
            if moved <= 1e-15 * size {
                break;
            }
        }
        Some(q)
    }

    /// A common zero whose distance from p is stationary, near `start`: g = h = 0 and (∇g × ∇h)·(q − p) = 0.
    fn stationary(&self, p: [f64; 3], start: [f64; 3]) -> Option<[f64; 3]> {
        let mut q = start;
        for _ in 0..STEPS {
            let [f, g] = self.both().map(|field| field.local(q));
            let vector = |v: [f64; 3]| Vector3::from(v);
            let (a, b) = (vector(f.direction()), vector(g.direction()));
            let w = vector(q) - vector(p);
            let tangent = a.cross(&b);
            let turn = f.hessian() * b.cross(&w) + g.hessian() * w.cross(&a) + tangent;
            let matrix = Matrix3::from_rows(&[a.transpose(), b.transpose(), turn.transpose()]);
            let values = Vector3::new(f.value.middle(), g.value.middle(), tangent.dot(&w));
            let step = matrix.try_inverse()? * values;
            q = std::array::from_fn(|i| q[i] - step[i]);
            let size = q.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            if !size.is_finite() {
                return None;
            }
            if step.amax() <= 1e-14 * size {
                break;
            }
        }
        Some(q)
    }
}

struct Search<'a> {
    of: &'a CommonZeros,
    p: [f64; 3],
    reach: f64,
    relative: f64,
    high: f64,
    foot: Option<CommonZero>,
    heap: BinaryHeap<Cube>,
}

impl Search<'_> {
    /// Improves the upper bound by the common zeros that Newton's method finds from a point.
    fn look_for_zero(&mut self, start: [f64; 3]) {
        let Some(near) = self.of.on_both(start) else {
            return;
        };
        let foot = self.of.stationary(self.p, near);
        for q in foot.into_iter().chain([near]) {
            let is_better = distance(q, self.p) < self.high * (1.0 - 0.1 * self.relative);
            if is_better && let Some(found) = self.of.enclosed(q) {
                let away = separation(found.position, self.p) + Interval::from(found.radius);
                if away.high() < self.high {
                    self.high = away.high();
                    self.foot = Some(found);
                }
            }
        }
    }

    fn divide(&mut self, cube: &Cube) {
        let half = cube.half / 2.0;
        let p = exactly(self.p);
        for corner in 0..8u32 {
            let mut middle = cube.middle;
            for (i, m) in middle.iter_mut().enumerate() {
                *m += if corner >> i & 1 == 1 { half } else { -half };
            }
            let grown = half_side(cube, middle, corner, 3);
            let [f, g] = self.of.both().map(|f| f.on_box(middle, [grown; 3]));
            if f.exclude(&g) {
                continue;
            }
            let away = minus(p, exactly(middle));
            let scaled = away.map(|x| x / Interval::from(grown));
            let weights = f.weights_of_common_zero(&g, scaled.map(Interval::middle));
            let facing = weights.map(|[a, b]| f.combination(a, &g, b));
            let mut low = beside(away, grown, 3).max(cube.low);
            for bounds in facing.iter().chain([&f, &g]) {
                let slab = bounds.nearest_zero(scaled, low / grown);
                low = low.max((Interval::from(slab) * grown).low());
            }
            if low < self.reach && low < self.high {
                self.heap.push(Cube {
                    low,
                    middle,
                    half: grown,
                    is_radial: false,
                });
            }
        }
    }
}
