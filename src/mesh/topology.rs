//! The topology of a mesh: whether it is closed, the number of its pieces, and the number of its holes.

use std::collections::HashMap;

use super::bounds::Held;
use super::refine::edges;
use super::triangles::Mesh;
use crate::error::Invariant;

/// Exact counts that describe a mesh as a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct MeshTopology {
    /// The number of edges with one triangle.
    pub boundary_edges: usize,
    /// The number of edges with more than two triangles, or with two triangles that disagree about which side is outside.
    pub irregular_edges: usize,
    /// The number of connected pieces.
    pub components: usize,
    /// The number of vertices − edges + triangles: 2 for a sphere, 0 for a torus.
    pub euler_characteristic: i64,
    /// The number of triangles with two corners at the same place.
    pub flat_triangles: usize,
}

impl MeshTopology {
    /// Whether every edge has exactly two triangles, which agree about which side is outside.
    #[must_use]
    pub fn is_watertight(&self) -> bool {
        self.boundary_edges == 0 && self.irregular_edges == 0
    }
}

impl Mesh {
    /// Counts edges and pieces. Cost: linear in the number of triangles.
    #[must_use]
    pub fn topology(&self) -> MeshTopology {
        // For each edge, how many triangles have it in the ascending and in the descending direction.
        let mut uses: HashMap<(u32, u32), [usize; 2]> = HashMap::new();
        // A triangle with two corners at one vertex is no part of a surface.
        let is_real = |[a, b, c]: &&[u32; 3]| a != b && b != c && c != a;
        let triangles = self.triangles.iter().filter(is_real);
        for triangle in triangles.clone() {
            for (corner, edge) in edges(triangle).into_iter().enumerate() {
                let downwards = triangle[corner] != edge.0;
                uses.entry(edge).or_default()[usize::from(downwards)] += 1;
            }
        }
        let boundary = uses.values().filter(|[up, down]| up + down == 1).count();
        let regular = uses.values().filter(|counts| **counts == [1, 1]).count();
        let signed = |n: usize| i64::try_from(n).invariant("numbers in memory are less than 2^63");
        MeshTopology {
            boundary_edges: boundary,
            irregular_edges: uses.len() - boundary - regular,
            components: self.pieces().1,
            euler_characteristic: signed(self.vertices.len()) - signed(uses.len())
                + signed(triangles.count()),
            flat_triangles: self.triangles.iter().filter(|t| self.is_flat(t)).count(),
        }
    }

    /// Whether two corners of a triangle are at the same place.
    #[expect(clippy::float_cmp, reason = "the same place is meant exactly")]
    fn is_flat(&self, triangle: &[u32; 3]) -> bool {
        let [a, b, c] = triangle.map(|v| self.vertices[v as usize]);
        a == b || b == c || c == a
    }

    /// Whether it is proved that the mesh has the topology of the whole surface.
    ///
    /// Lemma 3. Let all zeros of f be in the grid, and let each cell be proved to be empty, or regular in the sense that the
    /// bounds of the components of the gradient in the cell satisfy Σ Xᵢ·Xᵢ > 0. Then the triangles of marching tetrahedra are
    /// isotopic to the zero set.
    /// Proof. Let L be the function that is linear in each tetrahedron and has the values of f at the corners of the cells. The
    /// components of ∇L in a tetrahedron are means of those of ∇f along three of its edges, because Kuhn's tetrahedra have an
    /// edge in each direction of the axes; so ∇L·∇f(p) ≥ Σ Xᵢ·Xᵢ > 0 at its points p. Hence each h = (1 − t) f + t L grows along
    /// the flow of ∇f in the regular cells, and has exactly one zero on a line of the flow that has one for t = 0, which moves
    /// continuously with t. It stays in the regular cells: on a face of an empty cell f, and thus L, has one sign. The zero set
    /// of L is a surface of triangles with the same corners on the same edges.
    /// Later steps move these corners, collapse edges under the link condition, turn edges to diagonals that were no edges, and split
    /// them, which keeps the topology.
    /// Lemma 4. If this holds for every factor, and no cell is left for two of them, it holds for their union.
    /// Proof. A cell that is not left for a factor has no zero of it, the sides of the cell included; so a zero of two factors would be in a
    /// cell that is left for both. Factors that are meshed in boxes of their own, which hold all of their zeros and are disjoint, have no
    /// common zero.
    /// Laws: `what_is_proved_is_the_topology`, `factors_that_meet_are_not_proved_to_be_apart`.
    #[must_use]
    pub fn has_proved_topology(&self) -> bool {
        self.held == Held::Whole
            && self.cells[1] == 0
            && self.shared_cells == 0
            && !self.may_meet_origin
            && self.merged == 0
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
