//! Meshes of forms that every ray from the origin meets once, by points in given directions.

use nalgebra::Vector3;

use super::bounds::Held;
use super::triangles::Mesh;
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::parallel;
use crate::sample::{Direction, Ray, SpaceDirection, harmonic_point, solve_radial};
use crate::shape::{HarmonicPair, HarmonicSurface, Radial};

/// Meshes a form that every ray from the origin meets once. The mesh is closed, and each vertex is the exact point in an exact
/// direction, correctly rounded.
///
/// The angles θ run around from 0 to below 2π, and the angles φ run from pole to pole, from 0 to π; both are ascending.
///
/// # Errors
/// Those of [`solve_radial`] and of `limits`; [`Error::Usage`] for fewer than three angles of a kind.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::limits::Limits;
/// use stellate::mesh::mesh_radial;
/// use stellate::shape::SpaceSuperquadric;
///
/// let one = Rational::one;
/// let shape = SpaceSuperquadric::new([one(), one(), one()], [3.into(), one()], one()).unwrap();
/// let mesh = mesh_radial(&shape, shape.angles(4), &Limits::none(), &|_| {})?;
/// assert!(mesh.topology().is_watertight());
/// assert_eq!(mesh.topology().euler_characteristic, 2);
/// # Ok::<(), stellate::error::Error>(())
/// ```
pub fn mesh_radial(
    form: &dyn Radial<3>,
    angles: [Vec<f64>; 2],
    limits: &Limits,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Mesh> {
    let point = |direction: &SpaceDirection| match solve_radial(form, direction)? {
        Ray::Points(points) if !points.is_empty() => Ok(points[0].position),
        _ => Err(Error::internal(
            "the mesh of a radial form",
            "every direction has a point of it",
        )),
    };
    mesh_of_directions(&point, angles, limits, progress)
}

/// Meshes a harmonic surface by its exact points in `rows` + 1 latitudes and twice as many longitudes, each correctly rounded. The mesh
/// is closed by construction: it is the image of a triangulated sphere. [`Mesh::may_meet_origin`] is set, because the sign of R in
/// all directions is not asked for here; [`crate::sphere::positivity`] proves it.
///
/// # Errors
/// Those of `limits`; [`Error::Usage`] for fewer than two rows.
#[expect(clippy::cast_precision_loss, reason = "counts of angles are small")]
pub fn mesh_harmonic(
    surface: &HarmonicSurface,
    rows: usize,
    limits: &Limits,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Mesh> {
    let pair = HarmonicPair::new(surface);
    let angle = |k: usize| std::f64::consts::PI * k as f64 / rows as f64;
    let angles = [
        (0..2 * rows).map(angle).collect(),
        (0..=rows).map(angle).collect(),
    ];
    let point = |direction: &SpaceDirection| Ok(harmonic_point(&pair, surface.center(), direction));
    let mut mesh = mesh_of_directions(&point, angles, limits, progress)?;
    // Where R < 0 everywhere, the image of the sphere is turned.
    mesh.turn_outward();
    mesh.may_meet_origin = true;
    Ok(mesh)
}

/// The mesh of the points in all directions of the angles θ and φ, with the poles.
fn mesh_of_directions(
    point: &(dyn Fn(&SpaceDirection) -> Result<[f64; 3]> + Sync),
    [thetas, phis]: [Vec<f64>; 2],
    limits: &Limits,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Mesh> {
    if thetas.len() < 3 || phis.len() < 3 {
        return Err(Error::Usage(
            "a closed mesh has at least three angles around and three from pole to pole".into(),
        ));
    }
    let around = thetas.len();
    let turned = thetas.iter().map(|&theta| Direction::from_radians(theta));
    let thetas: Vec<Direction> = turned.collect();
    // The poles are first, then the points row by row.
    let inner = &phis[1..phis.len() - 1];
    let pole = |half_turns: i32| {
        let phi = Direction::from_degrees(&Rational::from(180 * half_turns));
        SpaceDirection::new(thetas[0].clone(), phi)
    };
    let mut directions = vec![pole(0), pole(1)];
    for &phi in inner {
        let phi = Direction::from_radians(phi);
        let row = thetas.iter();
        directions.extend(row.map(|theta| SpaceDirection::new(theta.clone(), phi.clone())));
    }
    let total = directions.len() as u64;
    let done = std::sync::atomic::AtomicU64::new(0);
    let solve = |direction: &SpaceDirection| -> Result<[f64; 3]> {
        let position = point(direction)?;
        progress(done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) * 1000 / total);
        Ok(position)
    };
    let vertices = parallel::try_map(&directions, limits, solve)?;
    if vertices.iter().flatten().any(|x| !x.is_finite()) {
        return Err(Error::Usage(
            "the points of this surface are beyond the largest double: move its center, or divide it by a number".into(),
        ));
    }
    let at = |row: usize, column: usize| 2 + row * around + column % around;
    let mut triangles: Vec<[usize; 3]> = Vec::new();
    for column in 0..around {
        triangles.push([0, at(0, column), at(0, column + 1)]);
        for row in 1..inner.len() {
            let [a, b] = [at(row - 1, column), at(row - 1, column + 1)];
            let [c, d] = [at(row, column), at(row, column + 1)];
            triangles.extend([[a, c, b], [b, c, d]]);
        }
        let last = inner.len() - 1;
        triangles.push([1, at(last, column + 1), at(last, column)]);
    }
    let number = |v: usize| u32::try_from(v).invariant("a mesh has fewer than 2^32 vertices");
    let triangles: Vec<[u32; 3]> = triangles.into_iter().map(|t| t.map(number)).collect();
    let sizes = vertices.iter().flatten().map(|v| v.abs());
    let largest = sizes.fold(0.0, f64::max);
    Ok(Mesh {
        normals: normals(&vertices, &triangles),
        vertices,
        triangles,
        factors: vec![0],
        // Each of the three coordinates is wrong by half a unit in the last place.
        vertex_bound: largest * f64::EPSILON,
        held: Held::Whole,
        ..Mesh::default()
    })
}

/// The normals at the vertices, as unit vectors in the direction of the sum of the normals of the triangles there.
fn normals(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> Vec<[f64; 3]> {
    let mut sums = vec![Vector3::zeros(); vertices.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|v| Vector3::from(vertices[v as usize]));
        let normal = (b - a).cross(&(c - a));
        for vertex in triangle {
            sums[*vertex as usize] += normal;
        }
    }
    // There is no direction if all these triangles are points.
    let unit = |sum: Vector3<f64>| sum.try_normalize(0.0).map_or([0.0; 3], Into::into);
    sums.into_iter().map(unit).collect()
}
