//! Tests whether a closed polygon touches or crosses itself.

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::ops::Bound;

use rayon::slice::ParallelSliceMut;

use super::orientation::{in_box, orientation};
use super::swept_edge::SweptEdge;
use crate::error::Invariant;

/// Two edges, named by the index of their first vertex, that share a point they must not share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    pub(super) first: usize,
    pub(super) second: usize,
    /// The approximate place of the shared point.
    pub(super) near: [f64; 2],
}

/// The first point, in a sweep from left to right, in which the closed polygon crosses or touches itself.
///
/// Neighbouring edges may share only their common vertex, and all other pairs of edges must be disjoint. Consecutive points
/// must be different. This is the sweep of Shamos and Hoey with exact signs: before anything has crossed, the edges that the
/// sweeping line meets are ordered, and the first two edges that will meet are neighbours in this order before they do. Cost:
/// O(n log n).
pub(super) fn find_crossing(points: &[[f64; 2]]) -> Option<Crossing> {
    let n = points.len();
    let before = |i: usize| (i + n - 1) % n;
    let after = |i: usize| (i + 1) % n;
    let crossing = |i: usize, j: usize| {
        let (first, second) = (i.min(j), i.max(j));
        Crossing {
            first,
            second,
            near: meeting_point(
                [points[first], points[after(first)]],
                [points[second], points[after(second)]],
            ),
        }
    };
    if let Some(i) = (0..n).find(|&i| doubles_back(points[before(i)], points[i], points[after(i)]))
    {
        return Some(crossing(before(i), i));
    }
    let mut order: Vec<usize> = (0..n).collect();
    order.par_sort_unstable_by(|&i, &j| left_to_right(points[i], points[j]).then(i.cmp(&j)));
    if let Some(pair) = order
        .windows(2)
        .find(|pair| left_to_right(points[pair[0]], points[pair[1]]) == Ordering::Equal)
    {
        return Some(crossing(pair[0], pair[1]));
    }
    let directed = |index: usize| {
        let (p, q) = (points[index], points[after(index)]);
        let ends = match left_to_right(p, q) {
            Ordering::Less => [p, q],
            _ => [q, p],
        };
        SweptEdge { index, ends }
    };
    let meet = |a: Option<&SweptEdge>, b: Option<&SweptEdge>| {
        let (i, j) = (a?.index, b?.index);
        let neighbours = after(i) == j || after(j) == i;
        let met =
            !neighbours && share_a_point(points[i], points[after(i)], points[j], points[after(j)]);
        met.then(|| crossing(i, j))
    };
    let mut status: BTreeSet<SweptEdge> = BTreeSet::new();
    for v in order {
        let (ending, beginning): (Vec<SweptEdge>, Vec<SweptEdge>) = [before(v), v]
            .map(directed)
            .into_iter()
            .partition(|edge| left_to_right(edge.ends[1], points[v]) == Ordering::Equal);
        for edge in ending {
            status.remove(&edge);
            let (below, above) = neighbours(&status, &edge);
            if let Some(found) = meet(below, above) {
                return Some(found);
            }
        }
        for edge in beginning {
            let (below, above) = neighbours(&status, &edge);
            if let Some(found) = meet(below, Some(&edge)).or_else(|| meet(Some(&edge), above)) {
                return Some(found);
            }
            status.insert(edge);
        }
    }
    None
}

/// The order of the sweep: by x, then by y.
fn left_to_right(p: [f64; 2], q: [f64; 2]) -> Ordering {
    p.partial_cmp(&q).invariant("coordinates are finite")
}

/// The neighbours of `edge` in the status, which does not contain `edge`.
fn neighbours<'a>(
    status: &'a BTreeSet<SweptEdge>,
    edge: &SweptEdge,
) -> (Option<&'a SweptEdge>, Option<&'a SweptEdge>) {
    let mut below = status.range((Bound::Unbounded, Bound::Excluded(edge)));
    let mut above = status.range((Bound::Excluded(edge), Bound::Unbounded));
    (below.next_back(), above.next())
}

/// Whether the edges a → b and b → c overlap: c lies on the ray from b to a.
pub(super) fn doubles_back(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> bool {
    // All three points are on one line, so a coordinate in which a and b differ tells whether a and c are on the same side of
    // b.
    let same_side = (0..2).any(|k| (a[k] < b[k] && c[k] < b[k]) || (a[k] > b[k] && c[k] > b[k]));
    same_side && orientation(a, b, c) == Ordering::Equal
}

/// Whether the closed segments p–q and r–s have a point in common.
pub(super) fn share_a_point(p: [f64; 2], q: [f64; 2], r: [f64; 2], s: [f64; 2]) -> bool {
    let (r_side, s_side) = (orientation(p, q, r), orientation(p, q, s));
    if r_side == Ordering::Equal && s_side == Ordering::Equal {
        return in_box(p, q, r) || in_box(p, q, s) || in_box(r, s, p);
    }
    if r_side == s_side {
        return false;
    }
    let (p_side, q_side) = (orientation(r, s, p), orientation(r, s, q));
    p_side == Ordering::Equal || p_side != q_side
}

/// The approximate point in which two segments meet: the crossing of their lines, or the middle of their common part.
pub(super) fn meeting_point([p, q]: [[f64; 2]; 2], [r, s]: [[f64; 2]; 2]) -> [f64; 2] {
    let (u, v) = ([q[0] - p[0], q[1] - p[1]], [s[0] - r[0], s[1] - r[1]]);
    let cross = u[0] * v[1] - u[1] * v[0];
    let t = ((r[0] - p[0]) * v[1] - (r[1] - p[1]) * v[0]) / cross;
    if (0.0..=1.0).contains(&t) && orientation(p, q, r) != orientation(p, q, s) {
        return [p[0] + t * u[0], p[1] + t * u[1]];
    }
    let shared: Vec<[f64; 2]> = [(p, r, s), (q, r, s), (r, p, q), (s, p, q)]
        .into_iter()
        .filter(|&(point, a, b)| in_box(a, b, point))
        .map(|(point, ..)| point)
        .collect();
    match (shared.first(), shared.last()) {
        (Some(a), Some(b)) => [f64::midpoint(a[0], b[0]), f64::midpoint(a[1], b[1])],
        _ => q,
    }
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "these meeting points are exact")]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_bow_tie_crosses_in_the_middle() {
        let bow_tie = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
        let crossing = find_crossing(&bow_tie).unwrap();
        assert_eq!((crossing.first, crossing.second), (0, 2));
        assert_eq!(crossing.near, [1.0, 1.0]);
    }

    #[test]
    fn touching_counts_as_crossing() {
        // A vertex on another edge, a vertex visited twice, an overlap, a spike, a spike at the end.
        let vertex_on_edge = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]];
        let twice = [
            [0., 0.],
            [1., -1.],
            [2., 0.],
            [1., 1.],
            [0., 0.],
            [-1., 1.],
            [-1., -1.],
        ];
        let overlap = [[0., 0.], [4., 0.], [4., 2.], [3., 0.], [1., 0.], [0., 2.]];
        let spike = [[0.0, 0.0], [3.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
        let spike_at_the_start = [[3.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]];
        for (i, polygon) in [
            &vertex_on_edge[..],
            &twice,
            &overlap,
            &spike,
            &spike_at_the_start,
        ]
        .into_iter()
        .enumerate()
        {
            assert!(find_crossing(polygon).is_some(), "polygon {i}");
        }
    }

    #[test]
    fn neighbours_on_one_line_are_fine_when_they_go_on() {
        let square = [
            [0.0, 0.0],
            [1.0, 0.0],
            [2.0, 0.0],
            [2.0, 2.0],
            [0.0, 2.0],
            [0.0, 1.0],
        ];
        assert_eq!(find_crossing(&square), None);
        assert_eq!(find_crossing(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), None);
    }

    proptest! {
        #[test]
        fn the_sweep_finds_what_all_pairs_find(
            points in prop::collection::vec((0i8..7, 0i8..7), 3..10)
        ) {
            let mut points = points;
            points.dedup();
            while points.len() > 1 && points.first() == points.last() {
                points.pop();
            }
            let n = points.len();
            if n < 3 {
                return Ok(());
            }
            let points: Vec<[f64; 2]> =
                points.iter().map(|&(x, y)| [f64::from(x), f64::from(y)]).collect();
            let mut all = Vec::new();
            for i in 0..n {
                for j in i + 1..n {
                    let (p, q) = (points[i], points[i + 1]);
                    let (r, s) = (points[j], points[(j + 1) % n]);
                    let after = j == i + 1 && doubles_back(p, q, s);
                    let before = (j + 1) % n == i && doubles_back(r, p, q);
                    let apart = j > i + 1 && (j + 1) % n != i;
                    if after || before || (apart && share_a_point(p, q, r, s)) {
                        all.push((i, j));
                    }
                }
            }
            match find_crossing(&points) {
                None => prop_assert_eq!(all, []),
                Some(found) => prop_assert!(all.contains(&(found.first, found.second))),
            }
        }
    }
}
