//! Whether a mesh is star-shaped about a point, exactly.

use std::f64::consts::PI;

use robust::{Coord3D, orient3d};

use crate::error::Invariant;
use crate::exact::Rational;
use crate::shape::{Solid, determinant, dot, minus};

/// The signs of the volumes of the tetrahedra from a point to all triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Visible {
    /// The number of triangles whose outer side is towards the point, or whose plane holds it.
    pub(super) turned: usize,
    /// How often the mesh goes around the point.
    pub(super) turns: i64,
}

impl Visible {
    /// Whether every ray from the point meets the mesh once.
    ///
    /// Lemma. A closed connected mesh is star-shaped about c, so that every ray from c crosses it once, from inside to outside, exactly if
    /// `det(v₀ − c, v₁ − c, v₂ − c) > 0` for all triangles and their solid angles at c add up to 4π.
    ///
    /// Proof. If all determinants are positive, the projection from c to the sphere keeps the orientation of every triangle, so nearly every
    /// direction is covered as often as the mesh goes around c, which is the sum of the solid angles over 4π. If that is 1, no direction is
    /// covered by the interiors of two triangles; if the mesh is star-shaped, both hold.
    pub(super) fn is_star_shaped(self) -> bool {
        self.turned == 0 && self.turns == 1
    }
}

/// What is seen of a mesh from a point. The signs are exact; the sum of the solid angles is a multiple of 4π, so doubles are enough for it.
pub(super) fn visible(solid: &Solid, center: &[Rational; 3]) -> Visible {
    let near = center.each_ref().map(Rational::to_f64);
    let is_double = near
        .iter()
        .zip(center)
        .all(|(near, exact)| Rational::try_from(*near).as_ref() == Ok(exact));
    let point = |[x, y, z]: [f64; 3]| Coord3D { x, y, z };
    let mut turned = 0;
    let mut angles = 0.0;
    for k in 0..solid.triangles().len() {
        let corners = solid.corners(k);
        let sees = if is_double {
            let [a, b, c] = corners.map(point);
            // The determinant of a − d, b − d and c − d.
            orient3d(a, b, c, point(near)) > 0.0
        } else {
            exact_determinant(&corners, center).signum() > 0
        };
        turned += usize::from(!sees);
        angles += solid_angle(corners.map(|v| minus(v, near)));
    }
    Visible {
        turned,
        turns: whole(angles / (4.0 * PI)),
    }
}

/// The nearest whole number.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the number of turns is small"
)]
fn whole(x: f64) -> i64 {
    x.round() as i64
}

/// The solid angle of a triangle at the origin, with the sign of its orientation (Van Oosterom and Strackee).
fn solid_angle(corners: [[f64; 3]; 3]) -> f64 {
    let [a, b, c] = corners.map(|v| dot(v, v).sqrt());
    let [u, v, w] = corners;
    let below = a * b * c + dot(u, v) * c + dot(v, w) * a + dot(w, u) * b;
    2.0 * determinant(corners).atan2(below)
}

fn exact_determinant(corners: &[[f64; 3]; 3], center: &[Rational; 3]) -> Rational {
    let off = corners.map(|v| -> [Rational; 3] {
        std::array::from_fn(|i| {
            let x = Rational::try_from(v[i]).invariant("coordinates of meshes are finite");
            x - &center[i]
        })
    });
    exact_det(&off)
}

/// The determinant of three vectors.
pub(super) fn exact_det([a, b, c]: &[[Rational; 3]; 3]) -> Rational {
    let cross = exact_cross(b, c);
    (0..3).map(|i| &a[i] * &cross[i]).sum()
}

pub(super) fn exact_cross(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}
