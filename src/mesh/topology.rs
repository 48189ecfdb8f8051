//! The topology of a mesh: whether it is closed, the number of its pieces, and the number of its holes.

use std::collections::HashMap;

use super::refine::edges;
use super::triangles::Mesh;
use crate::error::Invariant;

/// Exact counts that describe a mesh as a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Topology {
    /// The number of edges with one triangle.
    pub boundary_edges: usize,
    /// The number of edges with more than two triangles, or with two triangles that disagree about which side is outside.
    pub irregular_edges: usize,
    /// The number of connected pieces.
    pub components: usize,
    /// The number of vertices − edges + triangles: 2 for a sphere, 0 for a torus.
    pub euler_characteristic: i64,
}

impl Topology {
    /// Whether every edge has exactly two triangles, which agree about which side is outside.
    #[must_use]
    pub fn is_watertight(&self) -> bool {
        self.boundary_edges == 0 && self.irregular_edges == 0
    }
}

impl Mesh {
    /// Counts edges and pieces. Cost: linear in the number of triangles.
    #[must_use]
    pub fn topology(&self) -> Topology {
        // For each edge, how many triangles have it in the ascending and in the descending direction.
        let mut uses: HashMap<(u32, u32), [usize; 2]> = HashMap::new();
        for triangle in &self.triangles {
            for (corner, edge) in edges(triangle).into_iter().enumerate() {
                let downwards = triangle[corner] != edge.0;
                uses.entry(edge).or_default()[usize::from(downwards)] += 1;
            }
        }
        let boundary = uses.values().filter(|[up, down]| up + down == 1).count();
        let regular = uses.values().filter(|counts| **counts == [1, 1]).count();
        let signed = |n: usize| i64::try_from(n).invariant("numbers in memory are less than 2^63");
        Topology {
            boundary_edges: boundary,
            irregular_edges: uses.len() - boundary - regular,
            components: self.pieces().1,
            euler_characteristic: signed(self.vertices.len()) - signed(uses.len())
                + signed(self.triangles.len()),
        }
    }

    /// The index of the piece of every vertex, and the number of pieces.
    pub(super) fn pieces(&self) -> (Vec<usize>, usize) {
        let count = u32::try_from(self.vertices.len());
        let count = count.invariant("a mesh has fewer than 2^32 vertices");
        let mut parent: Vec<u32> = (0..count).collect();
        for [a, b, c] in &self.triangles {
            for other in [b, c] {
                let (p, q) = (root(&mut parent, *a), root(&mut parent, *other));
                parent[p.max(q) as usize] = p.min(q);
            }
        }
        let mut names: HashMap<u32, usize> = HashMap::new();
        let mut pieces = Vec::with_capacity(self.vertices.len());
        for vertex in 0..count {
            let next = names.len();
            pieces.push(*names.entry(root(&mut parent, vertex)).or_insert(next));
        }
        (pieces, names.len())
    }
}

/// The smallest vertex of a piece. The path to it is shortened for later searches.
fn root(parent: &mut [u32], vertex: u32) -> u32 {
    let mut at = vertex;
    while parent[at as usize] != at {
        let above = parent[parent[at as usize] as usize];
        parent[at as usize] = above;
        at = above;
    }
    at
}
