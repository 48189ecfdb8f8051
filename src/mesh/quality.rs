//! How well triangles lie along the surface that they stand for, and what shape they have.

use nalgebra::Vector3;

use crate::intervals::Crossing;

/// A triangle whose normal is further than this cosine from that of the surface is judged by its direction alone.
const ALONG: f64 = 0.9;

/// The vertices of a mesh with the normals of the surface at them.
pub(super) struct Surface<'a> {
    pub(super) vertices: &'a [Crossing],
    /// Unit normals, 0 where the surface has none.
    pub(super) normals: &'a [[f64; 3]],
}

impl Surface<'_> {
    /// The least cosine of the angles between the normal of a triangle and those of the surface at its corners. It is below 0 if the
    /// triangle has turned over, and −1 for a triangle without a normal.
    pub(super) fn alignment(&self, triangle: [u32; 3]) -> f64 {
        let (normal, _) = self.normal(triangle);
        self.alignment_of(triangle, &normal)
    }

    /// The cosine of the angle between two triangles; 0 if one of them has no normal.
    pub(super) fn cosine_between(&self, first: [u32; 3], second: [u32; 3]) -> f64 {
        let [(m, _), (n, _)] = [first, second].map(|t| self.normal(t));
        let lengths = m.norm() * n.norm();
        if lengths > 0.0 {
            m.dot(&n) / lengths
        } else {
            0.0
        }
    }

    /// A number that grows with the quality of a triangle: below 0 for one that is not along the surface, and else its area in
    /// parts of that of an equilateral triangle with the same sum of the squares of the sides, from 0 for a sliver to 1.
    pub(super) fn score(&self, triangle: [u32; 3]) -> f64 {
        let (normal, squares) = self.normal(triangle);
        let alignment = self.alignment_of(triangle, &normal);
        if alignment < ALONG {
            return alignment - 1.0;
        }
        2.0 * 3.0_f64.sqrt() * normal.norm() / squares
    }

    /// The normal of a triangle, twice its area long, and the sum of the squares of its sides.
    fn normal(&self, triangle: [u32; 3]) -> (Vector3<f64>, f64) {
        let [a, b, c] = triangle.map(|v| Vector3::from(self.vertices[v as usize].point));
        let (u, v) = (b - a, c - a);
        let squares = u.norm_squared() + v.norm_squared() + (v - u).norm_squared();
        (u.cross(&v), squares)
    }

    fn alignment_of(&self, triangle: [u32; 3], normal: &Vector3<f64>) -> f64 {
        let length = normal.norm();
        if length == 0.0 {
            return -1.0;
        }
        let at_corners = triangle.map(|v| Vector3::from(self.normals[v as usize]));
        let cosines = at_corners.iter().map(|n| n.dot(normal) / length);
        cosines.fold(1.0, f64::min)
    }
}
