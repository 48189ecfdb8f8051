//! Meshes of implicit surfaces by marching tetrahedra.

use std::collections::HashMap;

use super::bounds::Held;
use super::cells::{Cell, Grid};
use super::frame::Frame;
use super::quality::Surface;
use super::{collapse, flip, refine, tetrahedra};
use crate::error::{Error, Result};
use crate::factor::factor_space;
use crate::intervals::{Crossing, Field};
use crate::limits::Limits;
use crate::options::options;
use crate::poly::SparsePolynomial;
use crate::shape::ImplicitSurface;

/// The largest number of cells of the grid that may hold a part of the surface.
pub const MAX_MESH_CELLS: usize = 4_000_000;
/// Edges shorter than this part of a cell are collapsed.
const COLLAPSED: f64 = 0.35;
/// The largest number of rounds in which edges are split.
const ROUNDS: usize = 4;
/// Edges shorter than this part of a cell are not split.
const SHORTEST: f64 = 1.0 / 24.0;

options! {
    /// How a surface is meshed.
    MeshOptions of {
        /// The box in which the surface is meshed; the mesh ends less than two cells beyond it.
        bounds: [[f64; 2]; 3],
    } {
        /// The number of cells along the longest side of the box.
        resolution: u32 = 64,
        /// Edges are split if the normals at their ends differ by more than this angle, in degrees.
        angle: f64 = 20.0,
        /// The points beside which cells that are not proved to hold a single smooth sheet are divided. Around these cells the mesh
        /// has cracks, which are small compared with a cell.
        near: Vec<[f64; 3]> = Vec::new(),
        /// How many parts such cells have along each axis: a power of two.
        fine: u32 = 4,
    }
}

/// A mesh of triangles in space.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct Mesh {
    /// The vertices. The polynomial has a certified zero within [`Mesh::vertex_bound`] of each.
    pub vertices: Vec<[f64; 3]>,
    /// Unit normals at the vertices, in doubles; 0 at singular points.
    pub normals: Vec<[f64; 3]>,
    /// The triangles, as indices of vertices, counter-clockwise seen from outside (for a closed piece), or else from where f >
    /// 0.
    pub triangles: Vec<[u32; 3]>,
    /// The index of the first triangle of every factor of the polynomial.
    pub factors: Vec<usize>,
    /// A bound of the distance between a vertex and the certified zero near it.
    pub vertex_bound: f64,
    /// The side of a cell; of several grids the largest, of those with cells of the second kind if there are some.
    pub cell: f64,
    /// The number of boxes in which parts of the surface are meshed; 0 if it is meshed along rays.
    pub boxes: usize,
    /// The number of cells that could not be proved to be empty, and how many of these could not be proved to hold a single
    /// smooth sheet. Only in cells of the second kind the mesh may miss a part that is smaller than a cell.
    pub cells: [usize; 2],
    /// The number of cells that may hold parts of more than one factor. If there are none, the factors do not meet in the box.
    pub shared_cells: usize,
    /// What is known about the parts of the surface outside of the box.
    pub held: Held,
    /// Whether the surface may have singular points in the box. Triangles do not show what it has only there: isolated points, and
    /// curves at which no sheets end.
    pub may_be_singular: bool,
    /// Whether the surface is a radius that is not proved to have one sign. Then it may pass through its origin, and the mesh, an
    /// image of a sphere, does not tell its topology.
    pub may_meet_origin: bool,
    /// Curves of singular points that were found, as polylines, without those along which one sheet runs.
    pub curves: Vec<Vec<[f64; 3]>>,
    /// Whether sheets cross along these curves, so that triangles may have gaps beside them.
    pub has_crossings: bool,
    /// Isolated points that were found.
    pub points: Vec<[f64; 3]>,
    /// The number of closed pieces that point inward, as the boundary of a solid does where it has a hollow.
    pub inward: usize,
    /// The number of edges at whose ends the surface has directions that differ by more than the wanted angle.
    pub bent_edges: usize,
    /// The number of vertices that single precision has put at the places of others; see [`Mesh::in_single_precision`].
    pub merged: usize,
}

/// Meshes the zero set of a polynomial in a box.
///
/// The polynomial is factored and every factor is meshed separately, so double sheets are not missed. An octree drops the cubes
/// in which a Taylor bound proves that f ≠ 0. In the cells that remain, the exact signs of f at the corners give triangles by
/// marching tetrahedra, which fit together across cells. Their slivers, and triangles that do not lie along the surface, are removed by
/// collapsing short edges and by turning edges. So a surface that is closed inside
/// the box has a closed mesh. Every vertex is a point between two points at most 2·[`Mesh::vertex_bound`] apart, at which f has
/// exactly opposite signs. At the end edges are split where the surface bends.
///
/// A box that is thin or far from the origin is meshed in coordinates in which it is neither, by an exact change of coordinates
/// x = c + 2^e X along each axis. Then the cells have the proportions of the box, and `angle` holds in these coordinates.
///
/// `progress` is called with numbers from 0 to 1000.
///
/// Cost: a Taylor expansion for every cube of the octree, about resolution² times a constant.
///
/// ```
/// use stellate::limits::Limits;
/// use stellate::mesh::{MeshOptions, mesh_surface};
/// use stellate::poly::{Ring, SparsePolynomial};
/// use stellate::shape::ImplicitSurface;
///
/// let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
/// let one = SparsePolynomial::constant(1.into());
/// let sphere = x.squared().plus(&y.squared()).plus(&z.squared()).minus(&one);
/// let options = MeshOptions::new([[-1.1, 1.1]; 3]).resolution(12);
/// let mesh = mesh_surface(&ImplicitSurface::new(sphere), &options, &Limits::none(), &|_| {})?;
/// let topology = mesh.topology();
/// assert!(topology.is_watertight());
/// assert_eq!((topology.components, topology.euler_characteristic), (1, 2));
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Limit`] for more than [`MAX_MESH_CELLS`] cells with a part of the surface; [`Error::Usage`] for a constant, or for
/// a box with an empty side; those of [`factor_space`].
pub fn mesh_surface(
    surface: &ImplicitSurface,
    options: &MeshOptions,
    limits: &Limits,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Mesh> {
    let surface = surface.in_original_coordinates(limits)?;
    let f = surface.polynomial();
    if f.degree().is_none_or(|degree| degree == 0) {
        return Err(Error::Usage("a constant has no surface".into()));
    }
    if options.bounds.iter().flatten().any(|x| !x.is_finite()) {
        return Err(Error::Usage("the box of a mesh has finite sides".into()));
    }
    let is_box = |[a, b]: &[f64; 2]| a < b;
    if !options.bounds.iter().all(is_box) || options.resolution == 0 {
        return Err(Error::Usage(
            "a mesh needs a box with positive sides and at least one cell".into(),
        ));
    }
    let Some(frame) = Frame::of(&options.bounds) else {
        return mesh_in_place(f, options, limits, progress);
    };
    let local = MeshOptions {
        bounds: frame.box_inward(&options.bounds),
        near: options.near.iter().map(|p| frame.inward(*p)).collect(),
        ..options.clone()
    };
    let f = frame.polynomial(f, limits)?;
    let mut mesh = mesh_in_place(&f, &local, limits, progress)?;
    let mut size: f64 = 0.0;
    for vertex in &mut mesh.vertices {
        *vertex = frame.outward(*vertex);
        size = vertex.iter().fold(size, |m, x| m.max(x.abs()));
    }
    for normal in &mut mesh.normals {
        *normal = frame.normal_outward(*normal);
    }
    let unit = frame.largest_unit();
    // Each of the three coordinates was rounded by at most half a unit in the last place.
    mesh.vertex_bound = (mesh.vertex_bound * unit + size * f64::EPSILON).next_up();
    mesh.cell *= unit;
    Ok(mesh)
}

/// The mesh in a box of usual proportions.
fn mesh_in_place(
    f: &SparsePolynomial<3>,
    options: &MeshOptions,
    limits: &Limits,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Mesh> {
    let grid = Grid::covering(&options.bounds, options.resolution);
    let mut mesh = Mesh {
        cell: grid.side,
        boxes: 1,
        ..Mesh::default()
    };
    let factors = factor_space(f, limits)?.factors;
    let share = 1000 / factors.len().max(1) as u64;
    // How many factors may have a part in a cell.
    let mut uses: HashMap<[u32; 3], usize> = HashMap::new();
    for (index, factor) in factors.iter().enumerate() {
        let before = share * index as u64;
        let heard = |part: u64| progress(before + share * part / 1000);
        let field = Field::new(&factor.polynomial);
        let used = add_factor(&field, &grid, options, limits, &heard, &mut mesh)?;
        if factors.len() > 1 {
            used.into_iter()
                .for_each(|cell| *uses.entry(cell).or_default() += 1);
        }
    }
    mesh.shared_cells = uses.values().filter(|count| **count > 1).count();
    mesh.turn_outward();
    progress(1000);
    Ok(mesh)
}

/// Adds the triangles of a factor. The result are the cells that may hold a part of it.
fn add_factor(
    field: &Field,
    grid: &Grid,
    options: &MeshOptions,
    limits: &Limits,
    progress: &(dyn Fn(u64) + Sync),
    mesh: &mut Mesh,
) -> Result<Vec<[u32; 3]>> {
    let blocks = std::sync::atomic::AtomicU64::new(0);
    let cells = grid.cells(field, limits, &|| {
        let done = blocks.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        progress(done * 500 / 512);
    })?;
    if cells.len() > MAX_MESH_CELLS {
        return Err(too_many_cells());
    }
    let used = cells.iter().map(|cell| cell.index).collect();
    mesh.cells[0] += cells.len();
    mesh.cells[1] += cells.iter().filter(|cell| !cell.is_regular).count();
    mesh.may_be_singular |= !grid.is_smooth(field, &cells, limits)?;
    let (cells, open): (Vec<Cell>, Vec<Cell>) = cells
        .into_iter()
        .partition(|cell| cell.is_regular || !grid.is_beside(cell, &options.near));
    let (mut vertices, mut triangles) = marched(field, grid, &cells);
    progress(750);
    let cosine = options.angle.to_radians().cos();
    for round in 0..ROUNDS as u64 {
        limits.check()?;
        let shortest = SHORTEST * grid.side;
        if !refine::split(field, &mut vertices, &mut triangles, cosine, shortest) {
            break;
        }
        let surface = Surface {
            normals: &refine::normals(field, &vertices),
            vertices: &vertices,
        };
        flip::flip(&surface, &mut triangles);
        progress(750 + 60 * (round + 1));
    }
    let refined = triangles.len();
    if !open.is_empty() {
        let fine = grid.divided(options.fine);
        let parts = fine.cells_within(field, &open, options.fine, limits)?;
        if parts.len() > MAX_MESH_CELLS {
            return Err(too_many_cells());
        }
        let (more, others) = marched(field, &fine, &parts);
        let first = u32::try_from(vertices.len()).map_err(|_| Error::limit("2^32 vertices"))?;
        vertices.extend(more);
        triangles.extend(others.into_iter().map(|t| t.map(|v| v + first)));
    }
    let first = mesh.index_of_next(vertices.len())?;
    mesh.factors.push(mesh.triangles.len());
    let normals = refine::normals(field, &vertices);
    mesh.bent_edges += refine::bent(&normals, &triangles[..refined], cosine);
    mesh.normals.extend(normals);
    let bounds = vertices.iter().map(|v: &Crossing| v.radius);
    mesh.vertex_bound = bounds.fold(mesh.vertex_bound, f64::max);
    mesh.vertices.extend(vertices.iter().map(|v| v.point));
    let moved = triangles.into_iter().map(|t| t.map(|v| v + first));
    mesh.triangles.extend(moved);
    Ok(used)
}

fn too_many_cells() -> Error {
    Error::limit(format!(
        "{MAX_MESH_CELLS} cells with a part of the surface; a coarser --resolution or a smaller --window needs fewer"
    ))
}

/// The vertices and triangles in cells of a grid, without slivers.
fn marched(field: &Field, grid: &Grid, cells: &[Cell]) -> (Vec<Crossing>, Vec<[u32; 3]>) {
    let (mut vertices, mut triangles) = tetrahedra::triangles(field, grid, cells);
    let surface = Surface {
        normals: &refine::normals(field, &vertices),
        vertices: &vertices,
    };
    // Turned edges let more short edges be collapsed.
    for _ in 0..2 {
        collapse::collapse(&surface, &mut triangles, COLLAPSED * grid.side);
        flip::flip(&surface, &mut triangles);
    }
    collapse::compact(&mut vertices, &mut triangles);
    (vertices, triangles)
}

impl Mesh {
    /// The index of the first of some vertices that will be added.
    ///
    /// # Errors
    /// [`Error::Limit`] if there are more than 2³² vertices then.
    pub(super) fn index_of_next(&self, more: usize) -> Result<u32> {
        let before = self.vertices.len();
        match (u32::try_from(before), u32::try_from(before + more)) {
            (Ok(first), Ok(_)) => Ok(first),
            _ => Err(Error::limit("2^32 vertices")),
        }
    }

    /// Turns the closed pieces whose triangles look inward.
    pub(super) fn turn_outward(&mut self) {
        let (pieces, count) = self.pieces();
        let mut volumes = vec![0.0; count];
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|v| self.vertices[v as usize]);
            let cross = [0, 1, 2].map(|i: usize| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                b[j] * c[k] - b[k] * c[j]
            });
            let volume: f64 = a.iter().zip(cross).map(|(a, n)| a * n).sum();
            volumes[pieces[triangle[0] as usize]] += volume;
        }
        let mut is_open = vec![false; count];
        for edge in self.boundary() {
            is_open[pieces[edge.0 as usize]] = true;
        }
        let turned = |v: u32| {
            let piece = pieces[v as usize];
            !is_open[piece] && volumes[piece] < 0.0
        };
        for triangle in self.triangles.iter_mut().filter(|t| turned(t[0])) {
            triangle.swap(1, 2);
        }
        for (vertex, normal) in (0..).zip(&mut self.normals) {
            if turned(vertex) {
                *normal = normal.map(|n| -n);
            }
        }
    }

    fn boundary(&self) -> Vec<(u32, u32)> {
        let mut edges: Vec<(u32, u32)> = self.triangles.iter().flat_map(refine::edges).collect();
        edges.sort_unstable();
        let alone = edges.chunk_by(|a, b| a == b).filter(|same| same.len() == 1);
        alone.map(|same| same[0]).collect()
    }
}
