//! Closed polygons in doubles, and their nearest edges.

use super::super::exponent_of;
use crate::error::Invariant;
use crate::shape::Contour;

/// The number of edges in a leaf of the tree.
const LEAF: usize = 4;

/// A bound of the error of a computed distance between a point and an edge, for coordinates of at most 4 in size, together with
/// that of the coordinates.
///
/// **Lemma.** Let u = 2^(−53). A coordinate is wrong by at most 4u, since it is a difference of doubles, rounded once; so a
/// distance is by at most 4·2·√2 u < 12u. The computed place t on an edge of length l is wrong by at most 8u times the distance
/// from its start over l, or it is 0 where l² underflows; so the computed foot is on the edge up to its rounding, 16u, and no
/// farther from the true foot than 8·√128 u < 91u. The difference and the root of the sum of squares add less than 16u.
/// Altogether less than 200u < 2^(−45).
pub(super) const ROUNDING: f64 = 2.9e-14;

/// The coordinates in which distances are measured: the middle of the outline's box is the origin, and all coordinates of the
/// outline are at most 1 in size.
#[derive(Debug)]
pub(in crate::fit) struct Frame {
    pub(in crate::fit) middle: [f64; 2],
    exponent: i32,
}

impl Frame {
    pub(in crate::fit) fn of(contour: &Contour) -> Self {
        let (middle, scale) = contour.frame();
        // The middle is rounded, so half the side may be a little less than the largest distance from it.
        Self::new(middle, scale)
    }

    /// Coordinates of at most about 1 in size for numbers up to this one.
    pub(in crate::fit) fn about_origin(size: f64) -> Self {
        Self::new([0.0; 2], size)
    }

    pub(super) fn new(middle: [f64; 2], size: f64) -> Self {
        let exponent =
            i32::try_from(exponent_of(size)).invariant("an exponent of a double is small");
        Self { middle, exponent }
    }

    /// The length of the unit, a power of two.
    pub(in crate::fit) fn scale(&self) -> f64 {
        f64::from(self.exponent).exp2()
    }

    pub(in crate::fit) fn exponent(&self) -> i64 {
        self.exponent.into()
    }

    /// The coordinates of a point; each is rounded once.
    pub(in crate::fit) fn inside(&self, point: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|i| (point[i] - self.middle[i]) / self.scale())
    }
}

/// A closed polygon. The nodes of a complete binary tree have the boxes of runs of edges, which are small because consecutive
/// edges are close to each other.
#[derive(Debug)]
pub(super) struct Polygon {
    points: Vec<[f64; 2]>,
    /// The boxes of the nodes: node 1 is the root, and the children of node k are 2k and 2k + 1.
    boxes: Vec<Rectangle>,
    /// The number of leaves, a power of two.
    leaves: usize,
}

#[derive(Clone, Copy, Debug)]
struct Rectangle {
    low: [f64; 2],
    high: [f64; 2],
}

impl Rectangle {
    const NOTHING: Self = Self {
        low: [f64::INFINITY; 2],
        high: [f64::NEG_INFINITY; 2],
    };

    fn with(self, point: [f64; 2]) -> Self {
        self.joined(Self {
            low: point,
            high: point,
        })
    }

    fn joined(self, other: Self) -> Self {
        Self {
            low: [0, 1].map(|i| self.low[i].min(other.low[i])),
            high: [0, 1].map(|i| self.high[i].max(other.high[i])),
        }
    }

    /// The square of the distance of a point; infinite for no points.
    fn square_distance(&self, p: [f64; 2]) -> f64 {
        let [x, y] = [0, 1].map(|i| (self.low[i] - p[i]).max(p[i] - self.high[i]).max(0.0));
        x * x + y * y
    }
}

/// The nearest point of a polygon.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest {
    pub(super) distance: f64,
    pub(super) edge: usize,
}

impl Polygon {
    pub(super) fn new(points: Vec<[f64; 2]>) -> Self {
        let leaves = points.len().div_ceil(LEAF).next_power_of_two();
        let mut polygon = Self {
            boxes: vec![Rectangle::NOTHING; 2 * leaves],
            points,
            leaves,
        };
        for edge in 0..polygon.points.len() {
            let [p, q] = polygon.edge(edge);
            let leaf = &mut polygon.boxes[leaves + edge / LEAF];
            *leaf = leaf.with(p).with(q);
        }
        for node in (1..leaves).rev() {
            polygon.boxes[node] = polygon.boxes[2 * node].joined(polygon.boxes[2 * node + 1]);
        }
        polygon
    }

    /// The number of edges.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    pub(super) fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The two ends of an edge.
    pub(super) fn edge(&self, k: usize) -> [[f64; 2]; 2] {
        let next = if k + 1 == self.points.len() { 0 } else { k + 1 };
        [self.points[k], self.points[next]]
    }

    /// The distance of a point from an edge.
    pub(super) fn distance_from_edge(&self, p: [f64; 2], edge: usize) -> f64 {
        square_distance(p, self.edge(edge)).sqrt()
    }

    /// The distance from the nearest edge; `hint` is an edge that may be near.
    pub(super) fn nearest(&self, p: [f64; 2], hint: usize) -> Nearest {
        let mut best = (square_distance(p, self.edge(hint)), hint);
        // A node and its sibling wait for each level of the tree.
        let mut waiting = [(0.0, 0usize); 2 * usize::BITS as usize];
        waiting[0] = (self.boxes[1].square_distance(p), 1);
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (bound, node) = waiting[count];
            if bound >= best.0 {
                continue;
            }
            if node >= self.leaves {
                let first = (node - self.leaves) * LEAF;
                for edge in first..(first + LEAF).min(self.points.len()) {
                    let square = square_distance(p, self.edge(edge));
                    if square < best.0 {
                        best = (square, edge);
                    }
                }
                continue;
            }
            let mut children =
                [2 * node, 2 * node + 1].map(|c| (self.boxes[c].square_distance(p), c));
            // The nearer one comes first.
            if children[0].0 < children[1].0 {
                children.swap(0, 1);
            }
            for child in children {
                waiting[count] = child;
                count += 1;
            }
        }
        Nearest {
            distance: best.0.sqrt(),
            edge: best.1,
        }
    }
}

/// The square of the distance of a point from the segment between two others.
fn square_distance(p: [f64; 2], [a, b]: [[f64; 2]; 2]) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let to = [p[0] - a[0], p[1] - a[1]];
    let length = along[0] * along[0] + along[1] * along[1];
    let place = along[0] * to[0] + along[1] * to[1];
    let t = if length > 0.0 {
        (place / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let away = [to[0] - t * along[0], to[1] - t * along[1]];
    away[0] * away[0] + away[1] * away[1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_tree_finds_the_nearest_edge(
            points in prop::collection::vec([-1.0f64..1.0, -1.0..1.0], 3..60),
            p in [-2.0f64..2.0, -2.0..2.0],
            hint: usize,
        ) {
            let polygon = Polygon::new(points);
            let all = (0..polygon.len()).map(|edge| polygon.distance_from_edge(p, edge));
            let found = polygon.nearest(p, hint % polygon.len());
            // A box may be left out that is nearer by a rounding error.
            prop_assert!((found.distance - all.fold(f64::INFINITY, f64::min)).abs() <= 1e-15);
            prop_assert!((polygon.distance_from_edge(p, found.edge) - found.distance).abs() <= 0.0);
        }
    }
}
