//! Bounds of distances between a point and a superquadric, by branch and bound over pieces of its first octant.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use smallvec::SmallVec;

use super::arc::{ArcPoint, Piece, UnitArc};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::inspect::DistanceBounds;
use crate::intervals::interval::{cross, minus, square};
use crate::intervals::{Interval, dot};
use crate::limits::Limits;
use crate::shape::{SpaceSuperquadric, Superquadric};

/// Steps towards the nearest point of a convex hull, in doubles.
const HULL_STEPS: usize = 8;

/// The part of a superquadric with x, y, z ≥ 0: the points (a ρ ξ, b ρ η, c ζ), where (ξ, η) is on one unit arc and (ρ, ζ) on another
/// one. In the plane ρ = 1 and ζ = 0.
#[derive(Debug)]
pub(super) struct Body {
    /// The semi-axes of the surface with the level 1.
    pub(super) axes: [Interval; 3],
    /// The arc of (ξ, η).
    pub(super) around: UnitArc,
    /// The arc of (ρ, ζ).
    pub(super) profile: Option<UnitArc>,
}

/// A part of the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// The bound by which the search is ordered.
    bound: f64,
    around: Piece,
    profile: Option<Piece>,
}

/// The corners of a polyhedron that holds a part of the surface.
type Corners = SmallVec<[[Interval; 3]; 16]>;

/// A point by its parameters on the two arcs: whether it is on the upper half, and t.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) around: (bool, f64),
    pub(super) profile: Option<(bool, f64)>,
}

/// The nearest point of a search, and bounds of its distance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) distance: DistanceBounds,
    pub(super) place: Place,
}

/// The least and the largest distance are sought in the same way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sense {
    Nearest,
    Farthest,
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The cell with the least bound is the greatest, as the heap requires.
impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound)
    }
}

/// The axes a λ of the superquadric with the level 1, for the scale λ = c^(ε/2) = c^(1/n), n being the exponent of an arc.
fn scaled<const N: usize>(
    axes: &[Rational; N],
    level: &Rational,
    arc: &UnitArc,
    exact: Option<Rational>,
) -> [Interval; N] {
    if let Some(scale) = exact {
        return axes.each_ref().map(|a| Interval::narrowest(&(a * &scale)));
    }
    let scale = arc.root(Interval::narrowest(level));
    axes.each_ref().map(|a| Interval::narrowest(a) * scale)
}

impl Body {
    pub(super) fn plane(shape: &Superquadric) -> Result<Self> {
        let around = UnitArc::new(&shape.exponent())?;
        let exact = shape.exact_scale();
        let [a, b] = scaled(shape.semi_axes(), shape.level(), &around, exact);
        Ok(Self {
            axes: [a, b, Interval::ZERO],
            around,
            profile: None,
        })
    }

    pub(super) fn space(shape: &SpaceSuperquadric) -> Result<Self> {
        let [of_xy, _, of_z] = shape.exponents();
        let profile = UnitArc::new(&of_z)?;
        let exact = shape.exact_scale();
        Ok(Self {
            axes: scaled(shape.semi_axes(), shape.level(), &profile, exact),
            around: UnitArc::new(&of_xy)?,
            profile: Some(profile),
        })
    }

    /// The point with these coordinates on the two arcs.
    fn point(&self, [u, v]: [Interval; 2], [r, z]: [Interval; 2]) -> [Interval; 3] {
        let [a, b, c] = self.axes;
        match self.profile {
            None => [a * u, b * v, Interval::ZERO],
            Some(_) => [a * r * u, b * r * v, c * z],
        }
    }

    /// The points on the two arcs at a place.
    pub(super) fn arc_points(&self, place: &Place) -> (ArcPoint, Option<ArcPoint>) {
        let (is_upper, t) = place.around;
        let profile = self.profile.as_ref().zip(place.profile);
        (
            self.around.point(is_upper, t),
            profile.map(|(arc, (is_upper, t))| arc.point(is_upper, t)),
        )
    }

    /// The point of the surface at a place.
    pub(super) fn at(&self, place: &Place) -> [Interval; 3] {
        let (around, profile) = self.arc_points(place);
        let profile = profile.map_or([Interval::from(1.0), Interval::ZERO], |p| p.at);
        self.point(around.at, profile)
    }

    /// Bounds of the norm of a vector: 1 on the surface, less inside.
    pub(super) fn norm(&self, p: [Interval; 3]) -> Interval {
        let part = |i: usize| p[i].abs() / self.axes[i];
        let around = self.around.norm(part(0), part(1));
        match &self.profile {
            None => around,
            Some(arc) => arc.norm(around, part(2)),
        }
    }

    /// A polyhedron that holds a cell.
    ///
    /// The point of the surface is bilinear in the points of the two arcs. So it is in the convex hull of the images of all pairs of
    /// corners.
    fn corners(&self, cell: &Cell) -> Corners {
        let single = [[Interval::from(1.0), Interval::ZERO]];
        let profile = cell.profile.as_ref().map_or(&single[..], |p| &p.hull[..]);
        let pairs = profile
            .iter()
            .flat_map(|r| cell.around.hull.iter().map(move |u| (*u, *r)));
        pairs.map(|(u, r)| self.point(u, r)).collect()
    }

    /// The four or two ends of a cell, with their places.
    fn ends(&self, cell: &Cell) -> SmallVec<[(Place, [Interval; 3]); 4]> {
        let places = |piece: &Piece| {
            [0, 1].map(|i| {
                let t = if i == 0 { piece.from } else { piece.to };
                ((piece.is_upper, t), piece.ends[i].at)
            })
        };
        let around = places(&cell.around);
        match cell.profile.as_ref().map(places) {
            None => around
                .iter()
                .map(|(place, at)| {
                    let place = Place {
                        around: *place,
                        profile: None,
                    };
                    (place, self.point(*at, [Interval::ZERO; 2]))
                })
                .collect(),
            Some(profile) => {
                let pairs = profile
                    .iter()
                    .flat_map(|r| around.iter().map(move |u| (u, r)));
                pairs
                    .map(|(u, r)| {
                        let place = Place {
                            around: u.0,
                            profile: Some(r.0),
                        };
                        (place, self.point(u.1, r.1))
                    })
                    .collect()
            }
        }
    }

    fn first_cells(&self) -> Vec<Cell> {
        let around = self.around.halves();
        let profile: Vec<Option<Piece>> = match &self.profile {
            None => vec![None],
            Some(arc) => arc.halves().into_iter().map(Some).collect(),
        };
        let pairs = profile
            .iter()
            .flat_map(|r| around.iter().map(move |u| (*u, *r)));
        pairs
            .map(|(around, profile)| Cell {
                bound: f64::NEG_INFINITY,
                around,
                profile,
            })
            .collect()
    }

    /// The parts of a cell; the longer piece is divided.
    fn divided(&self, cell: &Cell) -> Option<[Cell; 2]> {
        let length = |piece: &Piece, scale: [f64; 2]| {
            let [p, q] = piece.ends.map(|end| end.at.map(Interval::middle));
            (scale[0] * (q[0] - p[0])).hypot(scale[1] * (q[1] - p[1]))
        };
        let by_around = || {
            let pieces = self.around.divided(&cell.around)?;
            Some(pieces.map(|around| Cell { around, ..*cell }))
        };
        let (Some(arc), Some(profile)) = (&self.profile, &cell.profile) else {
            return by_around();
        };
        let by_profile = || {
            let pieces = arc.divided(profile)?;
            Some(pieces.map(|piece| Cell {
                profile: Some(piece),
                ..*cell
            }))
        };
        let [a, b, c] = self.axes.map(Interval::middle);
        let radius = profile.ends.map(|end| end.at[0].middle());
        let radius = radius[0].max(radius[1]);
        let of_profile = length(profile, [a.max(b), c]);
        match length(&cell.around, [a, b]) * radius > of_profile {
            true => by_around().or_else(by_profile),
            false => by_profile().or_else(by_around),
        }
    }

    /// The distance from a point with coordinates of at least 0 and the place of the nearest point found. The search ends when the
    /// bounds differ by the given part of the distance, after so many divisions, or when cells cannot be divided.
    pub(super) fn nearest(
        &self,
        p: [Interval; 3],
        relative: f64,
        most: usize,
        limits: &Limits,
    ) -> Found {
        self.search(p, Sense::Nearest, relative, f64::INFINITY, most, limits)
    }

    /// Whether some point of the surface is farther away from a point than all of `distance`, or all of them are nearer; `None` if
    /// neither is found.
    pub(super) fn goes_beyond(
        &self,
        p: [Interval; 3],
        distance: Interval,
        most: usize,
        limits: &Limits,
    ) -> Option<bool> {
        // The farthest points are in the opposite octant.
        let p = p.map(|x| -x);
        let found = self.search(
            p,
            Sense::Farthest,
            0.0,
            distance.high().next_up(),
            most,
            limits,
        );
        match found.distance {
            DistanceBounds { low, .. } if low >= distance.high() => Some(true),
            DistanceBounds { high, .. } if high < distance.low() => Some(false),
            _ => None,
        }
    }

    /// The search for the least or for the largest distance. A largest distance of at least `enough` is not improved.
    fn search(
        &self,
        p: [Interval; 3],
        sense: Sense,
        relative: f64,
        enough: f64,
        most: usize,
        limits: &Limits,
    ) -> Found {
        let mut heap = BinaryHeap::new();
        let mut best: Option<(f64, Place)> = None;
        let mut bounds = DistanceBounds {
            low: 0.0,
            high: f64::INFINITY,
        };
        let mut add = |mut cell: Cell, heap: &mut BinaryHeap<Cell>, bounds: &mut DistanceBounds| {
            for (place, at) in self.ends(&cell) {
                let distance = square(minus(at, p)).sqrt();
                let (is_better, middle) = match sense {
                    Sense::Nearest => {
                        bounds.high = bounds.high.min(distance.high());
                        let middle = distance.middle();
                        (best.is_none_or(|(least, _)| middle < least), middle)
                    }
                    Sense::Farthest => {
                        bounds.low = bounds.low.max(distance.low());
                        let middle = distance.middle();
                        (best.is_none_or(|(most, _)| middle > most), middle)
                    }
                };
                if is_better {
                    best = Some((middle, place));
                }
            }
            let corners = self.corners(&cell);
            cell.bound = match sense {
                Sense::Nearest => self.lower_bound(&cell, &corners, p).max(cell.bound),
                Sense::Farthest => {
                    let distances = corners.iter().map(|at| square(minus(*at, p)).sqrt().high());
                    (-distances.fold(0.0, f64::max)).max(cell.bound)
                }
            };
            heap.push(cell);
        };
        for cell in self.first_cells() {
            add(cell, &mut heap, &mut bounds);
        }
        // The bound of the cells that cannot be divided.
        let mut left = f64::INFINITY;
        for step in 0..=most {
            let Some(cell) = heap.pop() else { break };
            let is_done = match sense {
                Sense::Nearest => cell.bound >= bounds.high * (1.0 - relative),
                Sense::Farthest => -cell.bound < enough || bounds.low >= enough,
            };
            let is_over = step == most || step % 256 == 255 && limits.check().is_err();
            if is_done || is_over || left <= cell.bound {
                left = left.min(cell.bound);
                break;
            }
            match self.divided(&cell) {
                None => left = left.min(cell.bound),
                Some(parts) => {
                    for part in parts {
                        add(part, &mut heap, &mut bounds);
                    }
                }
            }
        }
        match sense {
            Sense::Nearest => bounds.low = left.max(0.0).min(bounds.high),
            Sense::Farthest => bounds.high = (-left).max(bounds.low),
        }
        let (_, place) = best.invariant("the first cells have ends");
        Found {
            distance: bounds,
            place,
        }
    }

    /// A lower bound of the distance of a point from the hull of the corners: the extent along some direction between the two.
    fn lower_bound(&self, cell: &Cell, corners: &Corners, p: [Interval; 3]) -> f64 {
        let from = p.map(Interval::middle);
        let towards = |v: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| v[i] - from[i]) };
        let all: SmallVec<[[f64; 3]; 16]> = corners
            .iter()
            .map(|corner| towards(corner.map(Interval::middle)))
            .collect();
        let support = |w: [f64; 3]| {
            let lengths = all.iter().map(|v| (dot(w, *v), *v));
            let least = lengths.min_by(|a, b| a.0.total_cmp(&b.0));
            least.invariant("there are corners")
        };
        // Towards the nearest point of the hull (Frank and Wolfe).
        #[expect(clippy::cast_precision_loss, reason = "there are at most 16 corners")]
        let count = all.len() as f64;
        let mut v: [f64; 3] =
            std::array::from_fn(|i| all.iter().map(|c| c[i]).sum::<f64>() / count);
        for _ in 0..HULL_STEPS {
            let (_, corner) = support(v);
            let step: [f64; 3] = std::array::from_fn(|i| corner[i] - v[i]);
            let part = -dot(v, step) / dot(step, step);
            if part.is_nan() || part <= 0.0 {
                break;
            }
            v = std::array::from_fn(|i| v[i] + part.min(1.0) * step[i]);
        }
        let normal = self.normal(cell);
        let opposite = normal.map(|x| -x);
        let bounds = [v, normal, opposite].map(|w| along(w, corners, p));
        bounds.into_iter().fold(0.0, f64::max)
    }

    /// About the normal of a cell, of any length.
    fn normal(&self, cell: &Cell) -> [f64; 3] {
        let chord = |ends: [[Interval; 3]; 2]| minus(ends[1], ends[0]);
        let one = [Interval::from(1.0), Interval::ZERO];
        let [u, v] = cell.around.ends.map(|end| end.at);
        let found = match &cell.profile {
            None => {
                let [x, y, _] = chord([self.point(u, one), self.point(v, one)]);
                [y, -x, Interval::ZERO]
            }
            Some(profile) => {
                let [r, s] = profile.ends.map(|end| end.at);
                let first = chord([self.point(u, r), self.point(v, s)]);
                let second = chord([self.point(u, s), self.point(v, r)]);
                cross(first, second)
            }
        };
        found.map(Interval::middle)
    }
}

/// The least distance from p, along a direction, of the corners; 0 if some of them are on both sides.
fn along(w: [f64; 3], corners: &Corners, p: [Interval; 3]) -> f64 {
    let length = (Interval::from(w[0]).squared() + Interval::from(w[1]).squared())
        + Interval::from(w[2]).squared();
    let length = length.sqrt();
    if !length.is_positive() || !length.high().is_finite() {
        return 0.0;
    }
    let extent = |corner: &[Interval; 3]| {
        let [x, y, z] = minus(*corner, p);
        (x * w[0] + y * w[1] + z * w[2]).low()
    };
    let least = corners.iter().map(extent).fold(f64::INFINITY, f64::min);
    (Interval::from(least.max(0.0)) / length).low().max(0.0)
}
