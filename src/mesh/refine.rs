//! Edges are split where the surface bends.

use std::collections::{HashMap, HashSet};

use rayon::slice::ParallelSliceMut;

use crate::intervals::{Crossing, Field, between, distance};
use crate::parallel;

/// The distances from the middle of an edge, in parts of the edge, at which the surface is searched.
const STEPS: [f64; 5] = [1.0 / 32.0, 1.0 / 16.0, 0.125, 0.25, 0.5];

/// The two ends of an edge, the smaller one first.
pub(super) type Edge = (u32, u32);

/// Unit normals in the direction of growing f; 0 where the gradient is 0.
pub(super) fn normals(field: &Field, vertices: &[Crossing]) -> Vec<[f64; 3]> {
    let normal = |v: &Crossing| {
        let gradient = field.gradient(v.point);
        let length = distance(gradient, [0.0; 3]);
        if length > 0.0 && length.is_finite() {
            gradient.map(|g| g / length)
        } else {
            [0.0; 3]
        }
    };
    parallel::map(vertices, normal)
}

/// Splits every edge at whose ends the normals differ by an angle with a cosine below `cosine`. The new vertex is a certified
/// point of the surface near the middle of the edge. Edges shorter than `shortest` are not split. An edge is split in both of
/// its triangles, so a closed mesh stays closed. Returns whether any edge was split.
pub(super) fn split(
    field: &Field,
    vertices: &mut Vec<Crossing>,
    triangles: &mut Vec<[u32; 3]>,
    cosine: f64,
    shortest: f64,
) -> bool {
    let normals = normals(field, vertices);
    let edges = all_edges(triangles);
    let candidates = parallel::map(&edges, |&(a, b)| {
        let [m, n] = [a, b].map(|v| normals[v as usize]);
        let [p, q] = [a, b].map(|v| vertices[v as usize].point);
        let bends = dot(m, n) < cosine && distance(p, q) > shortest;
        let found = bends.then(|| beside(field, p, q)).flatten()?;
        Some(((a, b), found))
    });
    let candidates: Vec<(Edge, Crossing)> = candidates.into_iter().flatten().collect();
    let mut middles: HashMap<Edge, u32> = HashMap::new();
    // Where sheets cross, several edges may lead to one point.
    let place = |v: &Crossing| v.point.map(|x| (x + 0.0).to_bits());
    let mut taken: HashSet<[u64; 3]> = vertices.iter().map(place).collect();
    for (edge, crossing) in candidates {
        if !taken.insert(place(&crossing)) {
            continue;
        }
        let Ok(number) = u32::try_from(vertices.len()) else {
            break;
        };
        middles.insert(edge, number);
        vertices.push(crossing);
    }
    if middles.is_empty() {
        return false;
    }
    *triangles = triangles
        .iter()
        .flat_map(|t| divided(*t, &middles, vertices))
        .collect();
    true
}

/// The number of edges at whose ends the normals differ by an angle with a cosine below `cosine`; singular points have no normals.
pub(super) fn bent(normals: &[[f64; 3]], triangles: &[[u32; 3]], cosine: f64) -> usize {
    let is_bent = |&&(a, b): &&Edge| {
        let [m, n] = [a, b].map(|v| normals[v as usize]);
        dot(m, m) > 0.0 && dot(n, n) > 0.0 && dot(m, n) < cosine
    };
    all_edges(triangles).iter().filter(is_bent).count()
}

fn all_edges(triangles: &[[u32; 3]]) -> Vec<Edge> {
    let mut edges: Vec<Edge> = triangles.iter().flat_map(edges).collect();
    edges.par_sort_unstable();
    edges.dedup();
    edges
}

pub(super) fn edges(triangle: &[u32; 3]) -> [Edge; 3] {
    let [a, b, c] = *triangle;
    [(a, b), (b, c), (c, a)].map(|(a, b)| (a.min(b), a.max(b)))
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A certified point of the surface on the line through the middle of p and q, in the direction of the gradient.
fn beside(field: &Field, p: [f64; 3], q: [f64; 3]) -> Option<Crossing> {
    let middle = between(p, q, 0.5);
    let gradient = field.gradient(middle);
    let scale = distance(p, q) / distance(gradient, [0.0; 3]);
    if !scale.is_finite() {
        return None;
    }
    let is_negative = field.sign(middle) < 0;
    let towards = if is_negative { scale } else { -scale };
    let mut last = middle;
    for step in STEPS {
        let next = std::array::from_fn(|i| middle[i] + towards * step * gradient[i]);
        if (field.sign(next) < 0) != is_negative {
            return Some(if is_negative {
                field.crossing(last, next)
            } else {
                field.crossing(next, last)
            });
        }
        last = next;
    }
    None
}

/// The triangles into which a triangle is divided at the middles of its split edges.
fn divided(
    triangle: [u32; 3],
    middles: &HashMap<Edge, u32>,
    vertices: &[Crossing],
) -> Vec<[u32; 3]> {
    let mut t = triangle;
    let mut cut = edges(&t).map(|edge| middles.get(&edge).copied());
    // The triangle is turned so that its first edge is split and, if two edges are, its last edge is not.
    for _ in 0..3 {
        let is_first = cut[0].is_some() && (cut[1].is_some() || cut[2].is_none());
        if is_first {
            break;
        }
        t.rotate_left(1);
        cut.rotate_left(1);
    }
    let [a, b, c] = t;
    match cut {
        [Some(ab), Some(bc), Some(ca)] => vec![[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]],
        [Some(ab), Some(bc), None] => {
            let between =
                |i: u32, j: u32| distance(vertices[i as usize].point, vertices[j as usize].point);
            let corner = [ab, b, bc];
            if between(a, bc) < between(ab, c) {
                vec![corner, [a, ab, bc], [a, bc, c]]
            } else {
                vec![corner, [a, ab, c], [ab, bc, c]]
            }
        }
        [Some(ab), None, None] => vec![[a, ab, c], [ab, b, c]],
        _ => vec![t],
    }
}
