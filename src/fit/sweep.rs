//! The outermost edge of a contour in every direction from a point: an angular sweep.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use rayon::slice::ParallelSliceMut;

use crate::error::Invariant;
use crate::shape::{SweptEdge, orientation};

/// A range of directions, counter-clockwise from one vertex's direction to another's, in which one
/// edge is the outermost. Numbers are indices of vertices; edge i joins vertices i and i + 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Visible {
    pub(super) edge: u32,
    pub(super) from: u32,
    pub(super) to: u32,
}

/// The outermost edges in all directions from `center`, in order. The caller must ensure that `points` is a simple
/// counter-clockwise polygon and that `center` is strictly inside. The first range begins at or after direction 0, or contains
/// it.
///
/// On a ray from an interior point the last crossing of the boundary leaves the polygon, so only edges that are
/// counter-clockwise from the center count. Edges do not cross, so the edges that a ray meets keep their order along it. Exact
/// turns decide this order; nothing is rounded.
///
/// Cost: O(n log n); O(n) after the sort where the polygon is star-shaped.
pub(super) fn outermost(points: &[[f64; 2]], center: [f64; 2]) -> Vec<Visible> {
    let n = points.len();
    let number = |vertex: usize| {
        u32::try_from(vertex).invariant("an outline in memory has fewer than 2^32 vertices")
    };
    let next = |i: usize| (i + 1) % n;
    let at = |vertex: u32| points[vertex as usize];
    let mut order: Vec<u32> = (0..number(n)).collect();
    order.par_sort_unstable_by(|&i, &j| by_direction(center, at(i), at(j)).then(i.cmp(&j)));
    // Vertices in the same direction share a rank.
    let mut rank = vec![0u32; n];
    let mut first_of_rank: Vec<u32> = Vec::with_capacity(n);
    for &i in &order {
        let is_new = first_of_rank
            .last()
            .is_none_or(|&j| by_direction(center, at(j), at(i)) != Ordering::Equal);
        if is_new {
            first_of_rank.push(i);
        }
        rank[i as usize] = number(first_of_rank.len() - 1);
    }
    let outgoing: Vec<bool> = (0..n)
        .map(|i| orientation(center, points[i], points[next(i)]) == Ordering::Greater)
        .collect();
    // The center is to the left of the active edges, so the greatest one is the farthest.
    let key = |edge: usize| SweptEdge {
        index: edge,
        ends: [points[edge], points[next(edge)]],
    };
    // The edges that are active before direction 0, because they pass over it.
    let mut active: BTreeSet<SweptEdge> = (0..n)
        .filter(|&i| outgoing[i] && rank[next(i)] <= rank[i])
        .map(key)
        .collect();
    let mut found: Vec<Visible> = Vec::with_capacity(first_of_rank.len());
    let same_rank = |&i: &u32, &j: &u32| rank[i as usize] == rank[j as usize];
    for (group, &here) in order.chunk_by(same_rank).zip(&first_of_rank) {
        // Edges that end in this direction are removed before edges that begin here are added. The two kinds share no ray, and
        // only edges that share a ray can be compared.
        for &i in group {
            let before = (i as usize + n - 1) % n;
            if outgoing[before] {
                active.remove(&key(before));
            }
        }
        let beginning = group.iter().map(|&i| i as usize).filter(|&i| outgoing[i]);
        active.extend(beginning.map(key));
        let Some(outer) = active.last() else { continue };
        match found.last_mut() {
            Some(last) if last.edge as usize == outer.index => {}
            last => {
                if let Some(last) = last {
                    last.to = here;
                }
                found.push(Visible {
                    edge: number(outer.index),
                    from: here,
                    to: here,
                });
            }
        }
    }
    // The last range ends where the first one begins; if the same edge has both, they are one range.
    if let [first, .., last] = found.as_mut_slice() {
        if first.edge == last.edge {
            first.from = last.from;
            found.pop();
        } else {
            last.to = first.from;
        }
    }
    found
}

/// Counter-clockwise order of directions from `center`, starting at direction 0 (to the right).
fn by_direction(center: [f64; 2], p: [f64; 2], q: [f64; 2]) -> Ordering {
    let below = |v: [f64; 2]| v[1] < center[1] || (v[1] <= center[1] && v[0] < center[0]);
    below(p)
        .cmp(&below(q))
        .then_with(|| orientation(center, p, q).reverse())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_shows_each_side_once() {
        let square = [[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]];
        let visible = |edge: u32, from, to| Visible { edge, from, to };
        assert_eq!(
            outermost(&square, [0.0, 0.0]),
            [
                visible(1, 1, 2),
                visible(2, 2, 3),
                visible(3, 3, 0),
                visible(0, 0, 1)
            ]
        );
    }

    #[test]
    fn a_notch_hides_behind_the_tip_in_front_of_it() {
        // A hook: from the origin its tip (edges 2 to 4) is behind its inner side.
        let hook = [
            [-1.0, -1.0],
            [4.0, -1.0],
            [4.0, 3.0],
            [3.0, 3.0],
            [3.0, 0.5],
            [-1.0, 0.5],
        ];
        let edges: Vec<u32> = outermost(&hook, [0.0, 0.0])
            .iter()
            .map(|visible| visible.edge)
            .collect();
        // Edge 3 (the inner side of the hook) is clockwise from the center, edge 4 is partly hidden.
        assert_eq!(edges, [1, 2, 4, 5, 0]);
    }
}
