//! Edges are turned where their triangles are slivers or do not lie along the surface.

use std::collections::HashMap;

use super::quality::Surface;
use super::refine::{Edge, edges};

/// Triangles with a lower score are improved.
const GOOD: f64 = 0.3;
/// The least improvement that counts.
const LEAST: f64 = 1e-6;

/// Turns edges: in the quadrilateral of its two triangles an edge is replaced by the other diagonal, if that is no edge yet and the
/// worse of the two new triangles is better than the worse of the two old ones. So the mesh stays the same surface with the same
/// vertices; and as the scores of the triangles, in ascending order, only grow, it comes to an end.
pub(super) fn flip(surface: &Surface<'_>, triangles: &mut [[u32; 3]]) {
    let is_bad = |t: &[u32; 3]| surface.score(*t) < GOOD;
    let mut waiting: Vec<Edge> = triangles
        .iter()
        .filter(|t| is_bad(t))
        .flat_map(edges)
        .collect();
    if waiting.is_empty() {
        return;
    }
    let mut beside = triangles_of_edges(triangles);
    while let Some(edge) = waiting.pop() {
        let Some([Some(first), Some(second)]) = beside.get(&edge).copied() else {
            continue;
        };
        let old = [first, second].map(|t| triangles[t as usize]);
        let before = old
            .map(|t| surface.score(t))
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        if before >= GOOD {
            continue;
        }
        let Some([a, b, c, d]) = quadrilateral(edge, old) else {
            continue;
        };
        if beside.contains_key(&ascending(c, d)) {
            continue;
        }
        let new = [[c, d, b], [d, c, a]];
        let after = new
            .map(|t| surface.score(t))
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        if after <= before + LEAST {
            continue;
        }
        beside.remove(&edge);
        beside.insert(ascending(c, d), [Some(first), Some(second)]);
        // The sides that change from one triangle to the other.
        for (side, from, to) in [
            (ascending(b, d), second, first),
            (ascending(a, c), first, second),
        ] {
            for place in beside.get_mut(&side).into_iter().flatten() {
                if *place == Some(from) {
                    *place = Some(to);
                }
            }
        }
        triangles[first as usize] = new[0];
        triangles[second as usize] = new[1];
        waiting.extend([(a, c), (a, d), (b, c), (b, d)].map(|(p, q)| ascending(p, q)));
    }
}

fn ascending(a: u32, b: u32) -> Edge {
    (a.min(b), a.max(b))
}

/// The triangles at every edge, one at the rim and else two; none at an edge with more.
fn triangles_of_edges(triangles: &[[u32; 3]]) -> HashMap<Edge, [Option<u32>; 2]> {
    let mut beside: HashMap<Edge, [Option<u32>; 2]> = HashMap::new();
    let mut crowded = Vec::new();
    for (number, triangle) in (0u32..).zip(triangles) {
        for edge in edges(triangle) {
            let places = beside.entry(edge).or_default();
            match places.iter_mut().find(|place| place.is_none()) {
                Some(place) => *place = Some(number),
                None => crowded.push(edge),
            }
        }
    }
    for edge in crowded {
        beside.insert(edge, [None; 2]);
    }
    beside
}

/// The corners a, b, c, d of the two triangles abc and bad; `None` if they are no such triangles.
fn quadrilateral((p, q): Edge, [first, second]: [[u32; 3]; 2]) -> Option<[u32; 4]> {
    let start = (0..3).find(|&i| ascending(first[i], first[(i + 1) % 3]) == (p, q))?;
    let [a, b, c] = [0, 1, 2].map(|k| first[(start + k) % 3]);
    let start = (0..3).find(|&i| [second[i], second[(i + 1) % 3]] == [b, a])?;
    let d = second[(start + 2) % 3];
    (c != d).then_some([a, b, c, d])
}
