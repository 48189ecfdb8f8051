//! Short edges are collapsed: marching tetrahedra make slivers where the surface passes close to a grid point.

use std::collections::BTreeSet;

use super::quality::Surface;
use super::refine::edges;
use crate::error::Invariant;
use crate::intervals::{Crossing, distance};

/// The cosine of the largest angle between a triangle next to a collapsed edge and the surface, unless it was larger before.
const ALONG: f64 = 0.8;
/// The cosine of the largest angle by which such a triangle may turn in any case: the surface has no normals at singular points.
const UNTURNED: f64 = 0.95;

/// Collapses edges shorter than `shortest`, the shortest first, to one of their ends, so that every vertex stays a certified
/// one. An edge is collapsed only under three conditions. The triangles around it remain a surface: the ends of the edge have
/// exactly the two common neighbours that its triangles have (the link condition of Dey, Edelsbrunner, Guha & Nekhayev 1999).
/// No triangle turns away from the surface, whose normals at the vertices are given. And no end is on the rim. So pieces, holes and
/// rims do not change.
pub(super) fn collapse(surface: &Surface<'_>, triangles: &mut Vec<[u32; 3]>, shortest: f64) {
    let vertices = surface.vertices;
    let mut around: Vec<Vec<u32>> = vec![Vec::new(); vertices.len()];
    for (number, triangle) in (0u32..).zip(triangles.iter()) {
        for vertex in triangle {
            around[*vertex as usize].push(number);
        }
    }
    let length =
        |(a, b): (u32, u32)| distance(vertices[a as usize].point, vertices[b as usize].point);
    let mut short: Vec<((u32, u32), f64)> = triangles
        .iter()
        .flat_map(edges)
        .map(|edge| (edge, length(edge)))
        .filter(|(_, length)| *length < shortest)
        .collect();
    short.sort_unstable_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
    // Most edges have two triangles.
    short.dedup_by_key(|(edge, _)| *edge);
    for ((a, b), _) in short {
        for (from, to) in [(b, a), (a, b)] {
            if may_collapse(from, to, surface, triangles, &around) {
                merge(from, to, triangles, &mut around);
                break;
            }
        }
    }
    triangles.retain(|&t| !is_removed(t));
}

/// Whether a triangle was removed; then its three corners are equal.
fn is_removed(triangle: [u32; 3]) -> bool {
    triangle[0] == triangle[1]
}

fn neighbours(vertex: u32, triangles: &[[u32; 3]], around: &[Vec<u32>]) -> BTreeSet<u32> {
    let corners = around[vertex as usize]
        .iter()
        .flat_map(|&t| triangles[t as usize]);
    corners.filter(|&v| v != vertex).collect()
}

fn may_collapse(
    from: u32,
    to: u32,
    surface: &Surface<'_>,
    triangles: &[[u32; 3]],
    around: &[Vec<u32>],
) -> bool {
    let [of_from, of_to] = [from, to].map(|v| neighbours(v, triangles, around));
    let valence = |v: u32| around[v as usize].len();
    // Around a vertex in the interior of the surface there are as many triangles as neighbours.
    let inside = of_from.len() == valence(from) && of_to.len() == valence(to);
    if !inside || !of_from.contains(&to) {
        return false;
    }
    let common: Vec<u32> = of_from.intersection(&of_to).copied().collect();
    if common.len() != 2 || common.iter().any(|&v| valence(v) <= 3) {
        return false;
    }
    around[from as usize].iter().all(|&t| {
        let old = triangles[t as usize];
        if old.contains(&to) {
            return true;
        }
        let new = old.map(|v| if v == from { to } else { v });
        surface.alignment(new) >= ALONG.min(surface.alignment(old))
            || surface.cosine_between(new, old) > UNTURNED
    })
}

fn merge(from: u32, to: u32, triangles: &mut [[u32; 3]], around: &mut [Vec<u32>]) {
    for t in std::mem::take(&mut around[from as usize]) {
        let triangle = triangles[t as usize];
        if triangle.contains(&to) {
            for vertex in triangle {
                around[vertex as usize].retain(|&other| other != t);
            }
            triangles[t as usize] = [to; 3];
        } else {
            triangles[t as usize] = triangle.map(|v| if v == from { to } else { v });
            around[to as usize].push(t);
        }
    }
}

/// Deletes the vertices that belong to no triangle.
pub(super) fn compact(vertices: &mut Vec<Crossing>, triangles: &mut [[u32; 3]]) {
    let mut numbers: Vec<Option<u32>> = vec![None; vertices.len()];
    let mut kept = Vec::with_capacity(vertices.len());
    for triangle in triangles.iter_mut() {
        *triangle = triangle.map(|v| {
            *numbers[v as usize].get_or_insert_with(|| {
                kept.push(vertices[v as usize]);
                u32::try_from(kept.len() - 1).invariant("a mesh has fewer than 2^32 vertices")
            })
        });
    }
    *vertices = kept;
}
