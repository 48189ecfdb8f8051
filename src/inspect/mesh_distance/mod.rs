//! Certified bounds of the Hausdorff distance of a closed mesh and a harmonic surface, by branch and bound from both sides.
//!
//! Triangles of the mesh are compared with tangent planes of the surface, and the parts of the surface behind or before these triangles,
//! as seen from the center, with planes of the mesh. Both bounds are off by what is proportional to the square of the size of a piece. A piece whose bound is not small
//! enough is divided.

mod faces;
#[cfg(test)]
mod laws;

use super::DistanceBounds;
use super::cells::{CellTree, FlatPart};
use crate::error::{Error, Invariant, Result};
use crate::fit::turns_of_mesh;
use crate::intervals::interval::UNIT;
use crate::limits::Limits;
use crate::parallel;
use crate::shape::{HarmonicPair, HarmonicSurface, Solid, dot, minus};
use faces::{Face, Faces};

/// The bounds are this close together, relative to the lower one, …
const RELATIVE: f64 = 0.005;
/// … or this close, relative to the size of the surface.
const ABSOLUTE: f64 = 5e-7;
/// The largest number of pieces of either side. Then the bounds stay as wide as they are.
const MOST_PIECES: usize = 1 << 20;

/// Certified bounds of the Hausdorff distance of a closed mesh and a surface R(θ, φ): the largest distance of a point of either one from
/// the other. The mesh must go around the center of the surface. `None` if R is 0 in every direction, or if lengths are beyond the range of doubles.
///
/// The bounds are at most 1 % apart, or 10^(−6) of the size of the surface, unless a mesh is so different from the surface that this takes
/// more than 2^20 pieces. They are proved for the exact corners and coefficients, provided that the arithmetic of doubles is that of
/// IEEE 754.
///
/// ```
/// use stellate::inspect::mesh_distance;
/// use stellate::limits::Limits;
/// use stellate::reading::{SolidFormat, read_solid};
/// use stellate::shape::HarmonicSurface;
/// // An octahedron in the unit sphere: the middles of its faces are 1 − 1/√3 away from it.
/// let text = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n\
///     f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
/// let solid = read_solid(text.as_bytes(), SolidFormat::Obj, "octahedron.obj")?;
/// let sphere = HarmonicSurface::new([((0, 0), 1.into())])?;
/// let found = mesh_distance(&solid, &sphere, &Limits::none())?.unwrap();
/// let exact = 1.0 - 1.0 / 3.0f64.sqrt();
/// assert!(found.low <= exact && exact <= found.high && found.high < 1.01 * found.low);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// Cost: about L² operations for each triangle, and for each piece in which the distance is nearly the largest one.
///
/// # Errors
/// [`Error::Usage`] for a mesh that does not go around the center; those of `limits`.
pub fn mesh_distance(
    solid: &Solid,
    surface: &HarmonicSurface,
    limits: &Limits,
) -> Result<Option<DistanceBounds>> {
    let Some(tree) = CellTree::new(surface, &HarmonicPair::new(surface)) else {
        return Ok(None);
    };
    if turns_of_mesh(solid, surface.center()) == 0 {
        return Err(Error::Usage(format!(
            "{}: the mesh does not go around the center of the surface, as it must for their distance",
            solid.place()
        )));
    }
    // The mesh in units of the surface, relative to its center.
    let mut wrong: f64 = 0.0;
    let mut size: f64 = 1.0;
    let mut vertices = Vec::with_capacity(solid.vertices().len());
    for vertex in solid.vertices() {
        let Some((inside, slack)) = tree.inside(*vertex, 0.0) else {
            return Ok(None);
        };
        wrong = wrong.max(slack);
        size = inside.iter().fold(size, |size, x| size.max(x.abs()));
        vertices.push(inside);
    }
    // Corners of parts of triangles are rounded at each division.
    let wrong = wrong + 256.0 * UNIT * size;
    let corners = |t: &[u32; 3]| t.map(|v| vertices[v as usize]);
    let mesh: Vec<Face> = solid.triangles().iter().map(|t| Face(corners(t))).collect();
    let faces = Faces::new(mesh.clone());

    let from_mesh = |_: &Face, part: &Face, _| {
        let found = tree.triangle_distance(&part.0, RELATIVE);
        [found.low, found.high]
    };
    let outwards = enclose(&mesh, 0.0, from_mesh, limits)?;
    // The mesh goes around the center, so every direction is one of a triangle.
    let from_part = |face: &Face, part: &Face, enough| match tree.flat_part(&part.0) {
        Some(part) => from_mesh_of(&faces, face, &part, enough),
        None => [0.0, f64::INFINITY],
    };
    let inwards = enclose(&mesh, outwards[0], from_part, limits)?;
    let [low, high] = [0, 1].map(|i| outwards[i].max(inwards[i]));
    Ok(Some(DistanceBounds {
        low: ((low - wrong) * tree.unit()).max(0.0),
        high: (high + wrong) * (1.0 + 4.0 * UNIT) * tree.unit(),
    }))
}

/// Bounds of the largest distance of a part of the surface from the mesh. The distance from one triangle is convex, so in a convex hull it
/// is largest at a corner. Taken are the triangle in the same directions and, if that one is not near enough, the one that is nearest to
/// the middle.
fn from_mesh_of(faces: &Faces, same: &Face, part: &FlatPart, enough: f64) -> [f64; 2] {
    let from = |face: &Face| {
        let at_corners = part.hull.iter().map(|c| face.greatest_distance(c));
        at_corners.fold(0.0, f64::max) + part.off
    };
    let high = from(same);
    if high <= enough {
        return [0.0, high];
    }
    let Some((nearest, least)) = faces.nearest(part.middle) else {
        return [0.0, f64::INFINITY];
    };
    [(least - part.wrong).max(0.0), high.min(from(&nearest))]
}

/// A part of a triangle of the mesh.
struct Piece {
    face: Face,
    part: Face,
    /// A bound that holds for the piece.
    most: f64,
}

/// Bounds of the largest distance of pieces, if it is at least `known`. `measure` is given a triangle, a part of it, and a distance that is
/// small enough, and gives a distance that some point has at least, and one that all have at most.
fn enclose(
    mesh: &[Face],
    known: f64,
    measure: impl Fn(&Face, &Face, f64) -> [f64; 2] + Sync,
    limits: &Limits,
) -> Result<[f64; 2]> {
    let (mut low, mut high) = (known, known);
    let whole = |face: &Face| Piece {
        face: *face,
        part: *face,
        most: f64::INFINITY,
    };
    let mut open: Vec<Piece> = mesh.iter().map(whole).collect();
    let enough = |low: f64| f64::max(low * (1.0 + RELATIVE), low + ABSOLUTE);
    let mut work = 0;
    while !open.is_empty() {
        work += open.len();
        let known_enough = enough(low);
        let found = parallel::try_map(&open, limits, |piece| {
            let [least, most] = measure(&piece.face, &piece.part, known_enough);
            Ok([least, most.min(piece.most)])
        })?;
        low = found.iter().fold(low, |low, bounds| low.max(bounds[0]));
        let enough = enough(low);
        let mut rest = Vec::new();
        for (piece, [_, most]) in open.iter().zip(found) {
            if most <= enough || work > MOST_PIECES {
                high = high.max(most);
            } else {
                let face = piece.face;
                let halves = piece.part.halves();
                rest.extend(halves.map(|part| Piece { face, part, most }));
            }
        }
        open = rest;
    }
    Ok([low, high])
}

impl Face {
    /// The two halves on both sides of the middle of the longest edge.
    fn halves(&self) -> [Self; 2] {
        let corners = self.0;
        let square = |i: usize| {
            let edge = minus(corners[(i + 1) % 3], corners[i]);
            dot(edge, edge)
        };
        let longest = (0..3).max_by(|a, b| square(*a).total_cmp(&square(*b)));
        let i = longest.invariant("a triangle has edges");
        let [p, q, r] = [0, 1, 2].map(|k| corners[(i + k) % 3]);
        let middle = std::array::from_fn(|k| f64::midpoint(p[k], q[k]));
        [Self([p, middle, r]), Self([middle, q, r])]
    }
}
