//! Bounds of the Hausdorff distance of two polygons.
//!
//! The distance of a point p of one polygon from the other one is at most its distance from any one edge of it, which is a
//! convex function of p. So on a piece of an edge it is at most the larger one of the distances of its two ends from the same
//! edge of the other polygon. It also changes by at most the way that p goes. Pieces on which neither bound is small enough
//! are halved.

use super::polygon::{Nearest, Polygon};
use super::{ABSOLUTE, RELATIVE};
use crate::error::Result;
use crate::limits::Limits;
use crate::parallel;

/// The number of edges that one thread takes at a time.
const CHUNK: usize = 1024;
/// How many points that are far from the other polygon are kept.
const KEPT: usize = 16;

/// Bounds of a distance as it is computed in doubles, and points of the first polygon that are far from the second one.
#[derive(Debug)]
pub(super) struct Enclosed {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) far: Vec<[f64; 2]>,
}

/// A piece of an edge: its ends, and the nearest edges of the other polygon.
#[derive(Clone, Copy)]
struct Piece {
    ends: [[f64; 2]; 2],
    nearest: [Nearest; 2],
}

/// Encloses the Hausdorff distance of two polygons; rounding is not in the bounds.
pub(super) fn enclose([first, second]: [&Polygon; 2], limits: &Limits) -> Result<Enclosed> {
    let sides = [[first, second], [second, first]];
    let ends = sides.map(|[from, to]| at_vertices(from, to));
    let known = ends
        .iter()
        .flatten()
        .map(|n| n.distance)
        .fold(0.0, f64::max);
    let mut bounds = (known, known);
    for ([from, to], nearest) in sides.into_iter().zip(&ends) {
        let [low, high] = one_sided(from, to, nearest, known, limits)?;
        bounds = (f64::max(bounds.0, low), f64::max(bounds.1, high));
    }
    Ok(Enclosed {
        low: bounds.0,
        high: bounds.1,
        far: farthest(first, &ends[0]),
    })
}

/// The vertices that are farthest from the other polygon.
fn farthest(polygon: &Polygon, nearest: &[Nearest]) -> Vec<[f64; 2]> {
    let mut kept: Vec<(f64, [f64; 2])> = Vec::with_capacity(KEPT + 1);
    for (&point, at) in polygon.points().iter().zip(nearest) {
        let least = kept.get(KEPT - 1).map_or(-1.0, |(distance, _)| *distance);
        if at.distance > least {
            let place = kept.partition_point(|(distance, _)| *distance >= at.distance);
            kept.insert(place, (at.distance, point));
            kept.truncate(KEPT);
        }
    }
    kept.into_iter().map(|(_, point)| point).collect()
}

/// The mean distance of the points of the first polygon from the second one, by arc length, from the distances at the ends and
/// the middles of pieces of edges.
pub(super) fn mean(from: &Polygon, to: &Polygon) -> f64 {
    const PIECES: f64 = 4096.0;
    let length = |k: usize| {
        let [p, q] = from.edge(k);
        f64::hypot(q[0] - p[0], q[1] - p[1])
    };
    let perimeter: f64 = (0..from.len()).map(length).sum();
    let chunks = parallel::map_numbers(from.len().div_ceil(CHUNK), |chunk| {
        let mut hint = 0;
        let mut sum = 0.0;
        for k in chunk * CHUNK..from.len().min((chunk + 1) * CHUNK) {
            let [p, q] = from.edge(k);
            let pieces = (PIECES * length(k) / perimeter).ceil().max(1.0);
            let mut place = 0.5;
            while place < pieces {
                let t = place / pieces;
                let middle = [0, 1].map(|i| p[i] + t * (q[i] - p[i]));
                let nearest = to.nearest(middle, hint);
                hint = nearest.edge;
                sum += nearest.distance * length(k) / pieces;
                place += 1.0;
            }
        }
        sum
    });
    chunks.iter().sum::<f64>() / perimeter
}

/// The nearest edge of the second polygon for each vertex of the first one.
fn at_vertices(from: &Polygon, to: &Polygon) -> Vec<Nearest> {
    let chunks: Vec<&[[f64; 2]]> = from.points().chunks(CHUNK).collect();
    let nearest = parallel::map(&chunks, |points| {
        let mut hint = 0;
        let nearest = points.iter().map(|&p| {
            let nearest = to.nearest(p, hint);
            hint = nearest.edge;
            nearest
        });
        nearest.collect::<Vec<Nearest>>()
    });
    nearest.into_iter().flatten().collect()
}

/// Bounds of the largest distance of a point of the first polygon from the second one, provided that it is at least `known`.
fn one_sided(
    from: &Polygon,
    to: &Polygon,
    nearest: &[Nearest],
    known: f64,
    limits: &Limits,
) -> Result<[f64; 2]> {
    let chunks = parallel::try_map_numbers(from.len().div_ceil(CHUNK), limits, |chunk| {
        let (mut low, mut high) = (known, known);
        let mut pieces = Vec::new();
        for k in chunk * CHUNK..from.len().min((chunk + 1) * CHUNK) {
            pieces.push(Piece {
                ends: from.edge(k),
                nearest: [nearest[k], nearest[(k + 1) % from.len()]],
            });
            while let Some(piece) = pieces.pop() {
                let bound = piece.bound(to);
                if bound <= f64::max(low * (1.0 + RELATIVE / 2.0), low + ABSOLUTE / 2.0) {
                    high = f64::max(high, bound);
                    continue;
                }
                let halves = piece.halves(to);
                low = low.max(halves[0].nearest[1].distance);
                pieces.extend(halves);
            }
        }
        Ok([low, high])
    })?;
    let largest = |i: usize| chunks.iter().map(|c| c[i]).fold(known, f64::max);
    Ok([largest(0), largest(1)])
}

impl Piece {
    /// An upper bound of the distance on the piece.
    fn bound(&self, to: &Polygon) -> f64 {
        let [p, q] = self.ends;
        let [at_p, at_q] = self.nearest;
        let from_edge = |edge: usize, at_first: f64, other: [f64; 2]| {
            at_first.max(to.distance_from_edge(other, edge))
        };
        let way = f64::hypot(q[0] - p[0], q[1] - p[1]);
        from_edge(at_p.edge, at_p.distance, q)
            .min(from_edge(at_q.edge, at_q.distance, p))
            .min(f64::midpoint(at_p.distance, at_q.distance) + way / 2.0)
    }

    fn halves(self, to: &Polygon) -> [Self; 2] {
        let [p, q] = self.ends;
        let middle = [0, 1].map(|i| f64::midpoint(p[i], q[i]));
        let nearest = to.nearest(middle, self.nearest[0].edge);
        [
            Self {
                ends: [p, middle],
                nearest: [self.nearest[0], nearest],
            },
            Self {
                ends: [middle, q],
                nearest: [nearest, self.nearest[1]],
            },
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn square(half: f64) -> Polygon {
        Polygon::new(vec![
            [half, -half],
            [half, half],
            [-half, half],
            [-half, -half],
        ])
    }

    #[test]
    fn distances_of_squares() {
        let found = enclose([&square(1.0), &square(0.5)], &Limits::none()).unwrap();
        // The corners are the farthest points.
        assert!((found.low - 0.5f64.sqrt()).abs() < 1e-15 && found.high >= found.low);
        assert!(found.high < found.low * 1.01);
        assert!((mean(&square(1.0), &square(0.5)) - mean_of_squares()).abs() < 1e-6);
    }

    /// The mean for the squares above: on half of each side it is 1/2, else √(1/4 + x²) for x in [0, 1/2].
    fn mean_of_squares() -> f64 {
        let x: f64 = 0.5;
        let root = (0.25 + x * x).sqrt();
        let integral = 0.5 * (x * root + 0.25 * ((x + root) / 0.5).ln());
        (0.5 * 0.5 + integral) / 1.0
    }

    #[test]
    fn the_middle_of_an_edge_can_be_farthest() {
        // A notch that the triangle does not have.
        let notched = Polygon::new(vec![[-1.0, 0.0], [0.0, 0.8], [1.0, 0.0], [0.0, 0.9]]);
        let plain = Polygon::new(vec![[-1.0, 0.0], [1.0, 0.0], [0.0, 0.9]]);
        let found = enclose([&notched, &plain], &Limits::none()).unwrap();
        assert!(
            found.low > 0.58 && found.high < found.low * 1.01,
            "{found:?}"
        );
    }

    proptest! {
        /// Many points of either polygon are no farther than the bound, and some point is nearly as far.
        #[test]
        fn sampled_distances_are_within_the_bounds(
            a in prop::collection::vec([-1.0f64..1.0, -1.0..1.0], 3..20),
            b in prop::collection::vec([-1.0f64..1.0, -1.0..1.0], 3..20),
        ) {
            let (a, b) = (Polygon::new(a), Polygon::new(b));
            let found = enclose([&a, &b], &Limits::none()).unwrap();
            let mut largest: f64 = 0.0;
            for [from, to] in [[&a, &b], [&b, &a]] {
                for k in 0..from.len() {
                    let [p, q] = from.edge(k);
                    for step in 0..=400 {
                        let t = f64::from(step) / 400.0;
                        let point = [0, 1].map(|i| p[i] + t * (q[i] - p[i]));
                        let all = (0..to.len()).map(|e| to.distance_from_edge(point, e));
                        largest = largest.max(all.fold(f64::INFINITY, f64::min));
                    }
                }
            }
            prop_assert!(largest <= found.high + 1e-14);
            // Samples are at most 3/800 apart from any point.
            prop_assert!(found.low <= largest + 0.004);
            prop_assert!(found.high - found.low <= f64::max(RELATIVE * found.low, ABSOLUTE));
        }
    }
}
