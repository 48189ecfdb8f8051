//! Marching tetrahedra: triangles from the signs at the corners of cells.

use std::collections::HashMap;

use rayon::slice::ParallelSliceMut;

use super::cells::{Cell, Grid};
use crate::error::Invariant;
use crate::intervals::{Crossing, Field};
use crate::parallel;

/// The six tetrahedra of a cell (Kuhn), with the corners as bits: x is 1, y is 2, z is 4. All six have the diagonal from 0 to
/// 7, and the triangulations of neighbouring cells fit together.
const TETRAHEDRA: [[u8; 4]; 6] = [
    [0, 1, 3, 7],
    [0, 1, 5, 7],
    [0, 2, 3, 7],
    [0, 2, 6, 7],
    [0, 4, 5, 7],
    [0, 4, 6, 7],
];

type GridPoint = [u32; 3];
/// An edge of a tetrahedron, from the end with f < 0 to the other end.
type Edge = [GridPoint; 2];

/// The vertices on the edges of the tetrahedra, and the triangles between them. The side with f < 0 is behind each triangle.
pub(super) fn triangles(
    field: &Field,
    grid: &Grid,
    cells: &[Cell],
) -> (Vec<Crossing>, Vec<[u32; 3]>) {
    let mut corners: Vec<GridPoint> = cells.iter().flat_map(|c| corners(c.index)).collect();
    corners.par_sort_unstable();
    corners.dedup();
    let signs = parallel::map(&corners, |&corner| field.sign(grid.point(corner)) < 0);
    let is_negative: HashMap<GridPoint, bool> = corners.into_iter().zip(signs).collect();
    let cut: Vec<[Edge; 3]> = cells
        .iter()
        .flat_map(|cell| in_cell(cell.index, &is_negative))
        .collect();
    let mut edges: Vec<Edge> = cut.iter().flatten().copied().collect();
    edges.par_sort_unstable();
    edges.dedup();
    let crossings = parallel::map(&edges, |&[a, b]| {
        field.crossing(grid.point(a), grid.point(b))
    });
    let number = |edge: &Edge| -> u32 {
        let found = edges.binary_search(edge);
        let found = found.invariant("the edges of all triangles are listed");
        u32::try_from(found).invariant("a mesh has fewer than 2^32 vertices")
    };
    let triangles = parallel::map(&cut, |edges| edges.each_ref().map(number));
    (crossings, triangles)
}

/// The corner of the cell with this index that the bits name.
fn corner([i, j, k]: GridPoint, bits: u8) -> GridPoint {
    let bit = |n: u8| u32::from(bits >> n & 1);
    [i + bit(0), j + bit(1), k + bit(2)]
}

fn corners(index: GridPoint) -> impl Iterator<Item = GridPoint> {
    (0..8).map(move |bits| corner(index, bits))
}

/// The triangles in a cell, each by the three edges on which its corners are. A tetrahedron with one or three negative corners has
/// one triangle, which cuts that corner off; one with two negative corners has a quadrilateral of two triangles.
fn in_cell(index: GridPoint, is_negative: &HashMap<GridPoint, bool>) -> Vec<[Edge; 3]> {
    let mut found = Vec::new();
    for tetrahedron in TETRAHEDRA {
        let points = tetrahedron.map(|bits| corner(index, bits));
        let negative = |p: &&GridPoint| {
            let known = is_negative.get(*p);
            *known.invariant("the signs at the corners of all cells are known")
        };
        let (behind, before): (Vec<&GridPoint>, Vec<&GridPoint>) =
            points.iter().partition(negative);
        let edge = |i: usize, j: usize| [*behind[i], *before[j]];
        match behind.len() {
            1 => found.push([edge(0, 0), edge(0, 1), edge(0, 2)]),
            2 => {
                let [a, b, c, d] = [edge(0, 0), edge(0, 1), edge(1, 1), edge(1, 0)];
                found.extend([[a, b, c], [a, c, d]]);
            }
            3 => found.push([edge(0, 0), edge(1, 0), edge(2, 0)]),
            _ => {}
        }
    }
    found.iter().map(oriented).collect()
}

/// The triangle with its corners ordered so that the ends with f < 0 are behind it: its normal has a positive scalar product with
/// the sum of the steps from the negative ends to the others.
fn oriented(triangle: &[Edge; 3]) -> [Edge; 3] {
    // Doubling the middles of the edges makes all numbers integers.
    let middle = |[a, b]: &Edge| [0, 1, 2].map(|i| i64::from(a[i]) + i64::from(b[i]));
    let [p, q, r] = triangle.each_ref().map(middle);
    let minus = |a: [i64; 3], b: [i64; 3]| [0, 1, 2].map(|i| a[i] - b[i]);
    let (u, v) = (minus(q, p), minus(r, p));
    let normal = [0, 1, 2].map(|i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        u[j] * v[k] - u[k] * v[j]
    });
    let outward: i64 = triangle
        .iter()
        .map(|[a, b]| {
            let step = minus(b.map(i64::from), a.map(i64::from));
            normal.iter().zip(step).map(|(n, s)| n * s).sum::<i64>()
        })
        .sum();
    let [a, b, c] = *triangle;
    if outward < 0 { [a, c, b] } else { [a, b, c] }
}
