//! Certified bounds of the distance between points and a surface whose radius is a sum of spherical harmonics, in doubles.
//!
//! Two charts cover the sphere: angles (θ, φ) about the z axis for the directions with |cos φ| ≤ √½, and the same about the x axis
//! for the others. Neither is used near its poles. In both the radius is a sum of harmonics of the two angles ([`waves`]). Six squares
//! of 90° are cut into cells; for each cell, and for each square of four cells, and so on, a box that holds its part of the surface and
//! a bound of the third derivatives are kept. The search for the nearest point ([`search`]) leaves out boxes that are too far away; on a
//! cell, a bound by the second derivatives ([`expansion`]) leaves out the rest, or else the cell is divided.

mod expansion;
#[cfg(feature = "meshes")]
mod flat;
mod foot;
mod isolate;
mod search;
mod waves;

#[cfg(test)]
mod laws;

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

use super::tree::Extent;
use crate::exact::Rational;
use crate::intervals::Interval;
use crate::intervals::interval::UNIT;
use crate::shape::{HarmonicPair, HarmonicSurface, wave_coefficients};

use expansion::{ANGLE, Errors, Expansion, length, turn};
#[cfg(feature = "meshes")]
pub(super) use flat::FlatPart;
pub(super) use isolate::Isolated;
pub(super) use search::NearestOnSphere;
use waves::{ABOVE, ORDERS, Waves, as_f64};

/// The coordinates (x_i, x_j, x_k) of the charts; φ is the angle from the last one.
const AXES: [[usize; 3]; 2] = [[0, 1, 2], [1, 2, 0]];
/// The squares of the charts: the chart and the least θ. φ is between π/4 and 3π/4.
const SQUARES: [(usize, f64); 6] = [
    (0, -FRAC_PI_4),
    (0, FRAC_PI_4),
    (0, 3.0 * FRAC_PI_4),
    (0, 5.0 * FRAC_PI_4),
    (1, FRAC_PI_4),
    (1, 5.0 * FRAC_PI_4),
];
/// The product of the degree and the sides of the cells is at most this, unless there would be too many cells.
const FINENESS: f64 = 0.7;
/// Sides are divided at least and at most so often.
const FEWEST_DIVISIONS: usize = 2;
const MOST_DIVISIONS: usize = 6;
/// Points whose coordinates are farther than this away, in units of the surface's size, are not searched.
const FARTHEST: f64 = 1e60;

/// A surface as a tree of cells, ready to be compared with points.
#[derive(Debug)]
pub(super) struct CellTree {
    charts: [Chart; 2],
    /// The unit, a power of two.
    unit: f64,
    /// How often the sides of the six squares are divided.
    divisions: usize,
    /// The nodes of all levels: those of level l begin at 2(4^l − 1), and the children of the node c of a level are the nodes 4c to 4c + 3
    /// of the next.
    nodes: Vec<Node>,
    /// A bound of |X'''|/6 on the squares of the first chart, which are all directions with φ between π/4 and 3π/4.
    third_of_band: f64,
    center: [Rational; 3],
}

#[derive(Debug)]
struct Chart {
    waves: Waves,
    errors: Errors,
    axes: [usize; 3],
}

/// A part of the surface.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// The box, in the coordinates of space.
    extent: Extent<3>,
    /// A bound of |X'''|/6 along all directions of length |v₁| + |v₂| = 1 of the angles.
    third: f64,
}

/// The angles of a square of cells.
#[derive(Clone, Copy, Debug)]
struct Place {
    chart: usize,
    low: [f64; 2],
    high: [f64; 2],
}

impl CellTree {
    /// The cells of a surface; `None` if its radius is 0 everywhere.
    pub(super) fn new(surface: &HarmonicSurface, pair: &HarmonicPair) -> Option<Self> {
        let degree = surface.degree();
        let lists = AXES.map(|axes| wave_coefficients(pair, axes));
        let sums = lists
            .each_ref()
            .map(|list| list.iter().map(|(.., c)| c.abs()).sum::<Rational>());
        let [first, second] = sums;
        let largest = first.max(second);
        if largest.is_zero() {
            return None;
        }
        // A power of two above the sum.
        let bits = |n: Integer| n.significant_bits().cast_signed();
        let exponent = bits(largest.numerator()) - bits(largest.denominator()) + 1;
        let scale = Rational::from(2).pow(-exponent)?;
        let charts = [0, 1].map(|chart| {
            let waves = Waves::new(degree, &lists[chart], &scale);
            Chart {
                errors: Errors::new(&waves),
                waves,
                axes: AXES[chart],
            }
        });
        let sides = as_f64(degree) * FRAC_PI_2 / FINENESS;
        let divisions = (FEWEST_DIVISIONS..MOST_DIVISIONS)
            .find(|k| as_f64(1 << k) >= sides)
            .unwrap_or(MOST_DIVISIONS);
        let rest = highest_derivatives(surface, &scale);
        let mut tree = Self {
            charts,
            unit: 0.0,
            divisions,
            nodes: Vec::new(),
            third_of_band: 0.0,
            center: surface.center().clone(),
        };
        tree.fill(rest);
        let unit = scale.recip()?.to_f64();
        (unit.is_normal() && unit.recip().is_normal()).then_some(Self { unit, ..tree })
    }

    /// The first node of a level.
    fn first_of(level: usize) -> usize {
        2 * ((1 << (2 * level)) - 1)
    }

    fn node(&self, level: usize, code: usize) -> &Node {
        &self.nodes[Self::first_of(level) + code]
    }

    /// The angles of a square of the sphere.
    fn square(code: usize) -> Place {
        let (chart, theta) = SQUARES[code];
        Place {
            chart,
            low: [theta, FRAC_PI_4],
            high: [theta + FRAC_PI_2, 3.0 * FRAC_PI_4],
        }
    }

    /// Computes the nodes, from the cells upwards; `rest` bounds the derivatives of order [`ORDERS`] of R.
    fn fill(&mut self, rest: f64) {
        let mut leaves = Vec::with_capacity(6 << (2 * self.divisions));
        for square in 0..6 {
            self.add_leaves(Self::square(square), self.divisions, rest, &mut leaves);
        }
        let mut levels = vec![leaves];
        for _ in 0..self.divisions {
            let below = &levels[levels.len() - 1];
            levels.push(below.chunks_exact(4).map(Node::joined).collect());
        }
        self.nodes = levels.into_iter().rev().flatten().collect();
        let band = self
            .nodes
            .iter()
            .zip(SQUARES)
            .filter(|(_, (chart, _))| *chart == 0);
        self.third_of_band = band.fold(0.0, |third, (node, _)| third.max(node.third));
    }

    fn add_leaves(&self, place: Place, divisions: usize, rest: f64, leaves: &mut Vec<Node>) {
        match divisions.checked_sub(1) {
            None => leaves.push(self.leaf(&place, rest)),
            Some(left) => {
                for part in place.parts() {
                    self.add_leaves(part, left, rest, leaves);
                }
            }
        }
    }

    /// The node of a cell.
    ///
    /// **Lemma 4.** Let J_k be the largest derivative of order k of R at the middle, plus its error; h the sum of half the sides, and Q the
    /// bound of all derivatives of order N = 6. On the cell every derivative of order k < N is at most S_k = Σ J_(k+s) h^s/s! + Q h^(N−k)/(N−k)!
    /// in size, and the derivatives of X of order 2 and 3 along directions of length |v₁| + |v₂| = 1 are at most S₂ + 2S₁ + S₀ and
    /// S₃ + 3S₂ + 3S₁ + S₀.
    ///
    /// Proof. Taylor's formula along the line from the middle, on which a derivative of order s along v is a mean of partial ones times
    /// (|v₁| + |v₂|)^s. The unit vector d has derivatives of length at most 1 along such directions, and X = Rd.
    ///
    /// Law: `boxes_and_bounds_hold_the_surface`.
    fn leaf(&self, place: &Place, rest: f64) -> Node {
        let chart = &self.charts[place.chart];
        let at = place.middle();
        let [theta, phi] = at.map(turn);
        let found = chart.waves.derivatives::<ORDERS>(theta, phi);
        let mut sizes = [0.0f64; ORDERS];
        for (i, row) in found.iter().enumerate() {
            for (j, value) in row.iter().enumerate().take(ORDERS - i) {
                sizes[i + j] = sizes[i + j].max(value.abs());
            }
        }
        for (size, error) in sizes.iter_mut().zip(chart.waves.errors()) {
            *size += error;
        }
        let half = [0, 1].map(|i| (place.high[i] - place.low[i]) / 2.0 + ANGLE);
        let h = half[0] + half[1];
        let bound = |k: usize| {
            let mut power = 1.0;
            let mut sum = 0.0;
            for s in 0..ORDERS - k {
                sum += sizes[k + s] * power;
                power *= h / as_f64(s + 1);
            }
            (sum + rest * power) * ABOVE
        };
        let [s0, s1, s2, s3] = [0, 1, 2, 3].map(bound);
        let bend = (s2 + 2.0 * s1 + s0) * ABOVE;
        let middle = Expansion::new(&chart.waves, at, &[0.0; 3]);
        let [a, b] = middle.slopes;
        let off = 0.5 * bend * h * h + chart.errors.within(h) + 32.0 * UNIT;
        let mut node = Node::EMPTY;
        for i in 0..3 {
            let reach = (a[i].abs() * half[0] + b[i].abs() * half[1] + off) * ABOVE;
            let axis = chart.axes[i];
            node.extent.low[axis] = middle.value[i] - reach;
            node.extent.high[axis] = middle.value[i] + reach;
        }
        node.third = (s3 + 3.0 * s2 + 3.0 * s1 + s0) / 6.0 * ABOVE;
        node
    }

    /// A point in units of the surface and relative to its center, with a bound of its error; `None` if it is too far away.
    pub(super) fn inside(&self, point: [f64; 3], slack: f64) -> Option<([f64; 3], f64)> {
        let mut wrong = Interval::from(slack);
        let mut inside = [0.0; 3];
        for i in 0..3 {
            let relative = Interval::from(point[i]) - Interval::narrowest(&self.center[i]);
            let middle = relative.middle();
            wrong = wrong + Interval::from((relative.high() - relative.low()).max(0.0));
            inside[i] = middle / self.unit;
        }
        let wrong = wrong * (1.0 / self.unit);
        let is_near = inside.iter().all(|x| x.abs() <= FARTHEST) && wrong.high() <= FARTHEST;
        is_near.then(|| (inside, wrong.high()))
    }

    /// The value R in the direction of a point in units of the surface, relative to the center, and a bound of its error; the point may
    /// be wrong by `slack`. `None` for the center.
    pub(super) fn radius_towards(&self, near: [f64; 3], slack: f64) -> Option<Interval> {
        let (p, slack) = self.inside(near, slack)?;
        let distance = length(&p);
        if distance <= 4.0 * slack {
            return None;
        }
        let (chart, at) = self.angles(&p);
        let waves = &self.charts[chart].waves;
        let [theta, phi] = at.map(turn);
        let [[value, by_phi], [by_theta, _]] = waves.derivatives::<2>(theta, phi);
        // The angles are wrong by at most this; sin φ is at least √½ up to rounding.
        let angle = 2.0 * slack / distance + ANGLE;
        let steepness =
            by_phi.abs() + by_theta.abs() + waves.errors()[1] + angle * waves.sizes()[2];
        let wrong = waves.errors()[0] + 2.0 * steepness * angle;
        Some(Interval::around(value, wrong * ABOVE) * self.unit)
    }

    /// The chart and the angles of the direction of a point.
    fn angles(&self, p: &[f64; 3]) -> (usize, [f64; 2]) {
        let chart = usize::from(2.0 * p[2] * p[2] > length(p).powi(2));
        let [theta, phi] = self.charts[chart].angles(p);
        // θ in the range of the squares, from −π/4.
        let theta = theta + if theta < -FRAC_PI_4 { TAU } else { 0.0 };
        (chart, [theta, phi])
    }
}

impl Chart {
    /// A vector of space in the coordinates of the chart.
    fn turned(&self, p: &[f64; 3]) -> [f64; 3] {
        self.axes.map(|axis| p[axis])
    }

    /// A vector in the coordinates of the chart, in those of space.
    fn in_space(&self, v: [f64; 3]) -> [f64; 3] {
        let mut p = [0.0; 3];
        for (axis, x) in self.axes.into_iter().zip(v) {
            p[axis] = x;
        }
        p
    }

    /// The angles of the direction of a vector of space, θ from −π to π.
    fn angles(&self, p: &[f64; 3]) -> [f64; 2] {
        let [x, y, z] = self.turned(p);
        [y.atan2(x), x.hypot(y).atan2(z)]
    }
}

/// A bound of the derivatives of order [`ORDERS`] of R in the angles of a chart.
///
/// **Lemma 5.** It is `Σ l^N M_l`, where `M_l² = Σ_m c_lm² (l+|m|)!/((2 − δ_m0)(l−|m|)!)`.
///
/// Proof. By the addition theorem the harmonics normalised to the mean square 1 have Σ Y² = 2l + 1 in each direction, so Cauchy's inequality
/// bounds the harmonics of degree l by M_l. In each angle they are trigonometric polynomials of degree l, which M_l bounds for all real
/// angles: by Bernstein's inequality each derivative multiplies the bound by l.
fn highest_derivatives(surface: &HarmonicSurface, scale: &Rational) -> f64 {
    let mut squares = vec![Rational::zero(); surface.degree() + 1];
    for (l, m, c) in surface.terms() {
        let order = m.unsigned_abs();
        let above = (l - order + 1..=l + order).map(|k| Rational::whole(Integer::from(k)));
        let product = above.fold(Rational::one(), |product, k| product * k);
        let halves = if m == 0 { 1 } else { 2 };
        let c = c * scale;
        squares[l] = &squares[l] + &c * &c * product / Rational::from(halves);
    }
    let bounds = squares.iter().enumerate().map(|(l, square)| {
        let mut bound = Interval::from(square).sqrt();
        for _ in 0..ORDERS {
            bound = bound * as_f64(l);
        }
        bound
    });
    bounds.fold(Interval::ZERO, |sum, bound| sum + bound).high()
}

impl Place {
    fn middle(&self) -> [f64; 2] {
        [0, 1].map(|i| f64::midpoint(self.low[i], self.high[i]))
    }

    /// The four parts of half the sides.
    fn parts(&self) -> [Self; 4] {
        let [a, b] = self.middle();
        let part = |is_right: bool, is_upper: bool| {
            let mut part = *self;
            let sides = [(is_right, a), (is_upper, b)];
            for (i, (is_second, middle)) in sides.into_iter().enumerate() {
                match is_second {
                    true => part.low[i] = middle,
                    false => part.high[i] = middle,
                }
            }
            part
        };
        [
            part(false, false),
            part(true, false),
            part(false, true),
            part(true, true),
        ]
    }

    fn holds(&self, at: &[f64; 2]) -> bool {
        (0..2).all(|i| self.low[i] <= at[i] && at[i] <= self.high[i])
    }
}

impl Node {
    const EMPTY: Self = Self {
        extent: Extent::EMPTY,
        third: 0.0,
    };

    fn joined(parts: &[Self]) -> Self {
        parts.iter().fold(Self::EMPTY, |all, part| Self {
            extent: all.extent.joined(&part.extent),
            third: all.third.max(part.third),
        })
    }
}

#[cfg(test)]
pub(super) use laws::surface as surface_of_test;
