//! The kernel of a mesh: the points from which every triangle is seen from inside.

use nalgebra::{Matrix4, Vector4};

use super::star::{exact_cross, exact_det};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::shape::{Solid, cross, dot, minus};

/// The largest number of exchanges of the linear program.
const MOST_STEPS: usize = 2000;
/// Planes that are nearer than this part of the size are met.
const MET: f64 = 1e-12;

/// What is known of the kernel of a mesh.
#[derive(Clone, Debug)]
pub(super) enum Kernel {
    /// A point that is, in doubles, as deep inside of all planes as possible.
    Point([f64; 3]),
    /// No point is inside of the planes of these triangles, which is proved.
    Empty(Vec<usize>),
    /// Doubles do not decide whether there is one.
    Unknown,
}

/// A half space n·x ≤ b with a unit normal, and its triangle.
struct HalfSpace {
    normal: [f64; 3],
    bound: f64,
    triangle: Option<usize>,
}

/// The point that is deepest inside of all planes of the triangles, by the dual simplex algorithm: the largest t with n·x + t ≤ b for all
/// planes. If t ≤ 0, four planes show that there is no such point, and that is proved exactly.
pub(super) fn kernel(solid: &Solid) -> Kernel {
    let (_, middle) = solid.moments();
    let size = solid
        .vertices()
        .iter()
        .map(|v| norm(minus(*v, middle)))
        .fold(0.0, f64::max);
    let mut planes: Vec<HalfSpace> = (0..solid.triangles().len())
        .filter_map(|k| {
            let [a, b, c] = solid.corners(k).map(|v| minus(v, middle).map(|x| x / size));
            let n = cross(minus(b, a), minus(c, a));
            let length = norm(n);
            (length > 0.0).then(|| {
                let normal = n.map(|x| x / length);
                HalfSpace {
                    normal,
                    bound: dot(normal, a),
                    triangle: Some(k),
                }
            })
        })
        .collect();
    // A large tetrahedron around everything is the first basis.
    let first = planes.len();
    let third = 3f64.sqrt().recip();
    for signs in [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ] {
        planes.push(HalfSpace {
            normal: signs.map(|s| s * third),
            bound: 100.0,
            triangle: None,
        });
    }
    let Some((basis, depth, point)) = deepest(&planes, first) else {
        return Kernel::Unknown;
    };
    if depth > MET {
        return Kernel::Point(std::array::from_fn(|i| middle[i] + size * point[i]));
    }
    let triangles: Option<Vec<usize>> = basis.iter().map(|k| planes[*k].triangle).collect();
    match triangles {
        Some(triangles) if is_empty_exactly(solid, &triangles) => Kernel::Empty(triangles),
        _ => Kernel::Unknown,
    }
}

/// The basis of four planes, the depth and the point of the linear program; `None` if doubles do not find it.
fn deepest(planes: &[HalfSpace], first: usize) -> Option<([usize; 4], f64, [f64; 3])> {
    let mut basis = [first, first + 1, first + 2, first + 3];
    let row = |k: usize| {
        let [x, y, z] = planes[k].normal;
        Vector4::new(x, y, z, 1.0)
    };
    for _ in 0..MOST_STEPS {
        let matrix = Matrix4::from_columns(&basis.map(row));
        let inverse = matrix.try_inverse()?;
        let bounds = Vector4::from(basis.map(|k| planes[k].bound));
        let x = inverse.transpose() * bounds;
        let point = [x[0], x[1], x[2]];
        let excess = |plane: &HalfSpace| dot(plane.normal, point) + x[3] - plane.bound;
        let worst = planes
            .iter()
            .enumerate()
            .map(|(k, plane)| (k, excess(plane)))
            .max_by(|a, b| a.1.total_cmp(&b.1))?;
        if worst.1 <= MET {
            return Some((basis, x[3], point));
        }
        // (0, 0, 0, 1) is a sum of the rows with these multipliers, and the entering row with those.
        let multipliers = inverse * Vector4::new(0.0, 0.0, 0.0, 1.0);
        let entering = inverse * row(worst.0);
        let leaving = (0..4).filter(|i| entering[*i] > MET).min_by(|i, j| {
            let ratio = |k: usize| multipliers[k] / entering[k];
            ratio(*i).total_cmp(&ratio(*j))
        })?;
        basis[leaving] = worst.0;
    }
    None
}

/// Whether no point is strictly inside of the planes of these triangles.
///
/// Lemma. With the outer normals nᵢ and the corners vᵢ, a point x inside has nᵢ·(vᵢ − x) > 0. If Σ λᵢ nᵢ = 0 for some λᵢ ≥ 0, not all 0,
/// then Σ λᵢ nᵢ·vᵢ > 0 for every such point; so if that sum is not positive, there is none.
fn is_empty_exactly(solid: &Solid, triangles: &[usize]) -> bool {
    let corners: Vec<[[Rational; 3]; 3]> = triangles
        .iter()
        .map(|k| solid.corners(*k).map(|v| v.map(exact)))
        .collect();
    let off = |a: &[Rational; 3], b: &[Rational; 3]| -> [Rational; 3] {
        std::array::from_fn(|i| &a[i] - &b[i])
    };
    let normals: Vec<[Rational; 3]> = corners
        .iter()
        .map(|[a, b, c]| exact_cross(&off(b, a), &off(c, a)))
        .collect();
    // The multipliers of four vectors of space: the determinants of the other three, with alternating signs.
    let multipliers: Vec<Rational> = (0..4)
        .map(|skipped| {
            let others: Vec<[Rational; 3]> = (0..4)
                .filter(|i| *i != skipped)
                .map(|i| normals[i].clone())
                .collect();
            let others: [[Rational; 3]; 3] = others.try_into().invariant("three are left");
            let value = exact_det(&others);
            if skipped % 2 == 0 { value } else { -value }
        })
        .collect();
    let sign = multipliers
        .iter()
        .map(Rational::signum)
        .find(|s| *s != 0)
        .unwrap_or(0);
    if sign == 0 || multipliers.iter().any(|m| m.signum() == -sign) {
        return false;
    }
    let sum: Rational = multipliers
        .iter()
        .zip(&normals)
        .zip(&corners)
        .map(|((m, n), [a, ..])| m * (0..3).map(|i| &n[i] * &a[i]).sum::<Rational>())
        .sum();
    sum.signum() * sign <= 0
}

fn exact(x: f64) -> Rational {
    Rational::try_from(x).invariant("coordinates of meshes are finite")
}

fn norm(v: [f64; 3]) -> f64 {
    dot(v, v).sqrt()
}
