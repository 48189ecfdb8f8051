//! The radii of a star-shaped mesh.

use crate::shape::{Solid, cross, determinant, dot, minus};

/// A mesh that is star-shaped about a center, for its radii.
pub(super) struct Rays<'a> {
    solid: &'a Solid,
    center: [f64; 3],
    /// The triangle of the last ray: neighbouring rays meet neighbouring triangles.
    last: usize,
}

impl<'a> Rays<'a> {
    pub(super) fn new(solid: &'a Solid, center: [f64; 3]) -> Self {
        Self {
            solid,
            center,
            last: 0,
        }
    }

    /// The number of triangles.
    pub(super) fn triangles(&self) -> usize {
        self.solid.triangles().len()
    }

    /// The corners of a triangle, from the center.
    fn corners(&self, triangle: usize) -> [[f64; 3]; 3] {
        self.solid.corners(triangle).map(|v| minus(v, self.center))
    }

    /// The radius in a direction, in doubles: the search goes from triangle to triangle across the edge that the ray is beyond, at
    /// most as often as there are triangles; then all are tried.
    pub(super) fn radius(&mut self, direction: [f64; 3]) -> f64 {
        let mut at = self.last;
        let count = self.solid.triangles().len();
        for step in 0..count {
            let corners = self.corners(at);
            // The edges are tried in turn from another one at each step, so that the search does not go around in circles.
            let beyond = (0..3)
                .map(|i| (i + step) % 3)
                .find(|i| outside(&corners, *i, direction) < 0.0);
            let Some(edge) = beyond else {
                self.last = at;
                return radius(&corners, direction);
            };
            at = self.solid.neighbours(at)[edge];
        }
        let least = |k: &usize| {
            let corners = self.corners(*k);
            let sides = (0..3).map(|i| outside(&corners, i, direction) / volume(&corners));
            sides.fold(f64::INFINITY, f64::min)
        };
        let nearest = (0..count).max_by(|a, b| least(a).total_cmp(&least(b)));
        self.last = nearest.unwrap_or(self.last);
        radius(&self.corners(self.last), direction)
    }

    /// The directions and radii of all vertices.
    pub(super) fn vertices(&self) -> impl Iterator<Item = ([f64; 3], f64)> + '_ {
        self.solid.vertices().iter().map(|v| {
            let off = minus(*v, self.center);
            let r = dot(off, off).sqrt();
            (off.map(|x| x / r), r)
        })
    }

    /// The directions and radii of the points of triangles and of edges that are nearest to the center, as far as they are inside
    /// of these: there the radius of a triangle or an edge is least.
    pub(super) fn feet(&self) -> impl Iterator<Item = ([f64; 3], f64)> + '_ {
        let of_triangle = |k: usize| {
            let corners = self.corners(k);
            let [a, b, c] = corners;
            let normal = cross(minus(b, a), minus(c, a));
            let share = dot(normal, a) / dot(normal, normal);
            let foot = normal.map(|n| share * n);
            let is_inside = (0..3).all(|edge| outside(&corners, edge, foot) > 0.0);
            is_inside.then_some(foot)
        };
        let of_edge = |k: usize, i: usize| {
            let ends = [i, (i + 1) % 3].map(|i| self.solid.triangles()[k][i]);
            let [a, b] = [i, (i + 1) % 3].map(|i| self.corners(k)[i]);
            let along = minus(b, a);
            let share = -dot(a, along) / dot(along, along);
            // An edge has two triangles.
            let is_inside = ends[0] < ends[1] && share > 0.0 && share < 1.0;
            is_inside.then(|| std::array::from_fn(|i| a[i] + share * along[i]))
        };
        let feet = (0..self.triangles()).flat_map(move |k| {
            let edges = (0..3).filter_map(move |i| of_edge(k, i));
            of_triangle(k).into_iter().chain(edges)
        });
        feet.map(|foot: [f64; 3]| {
            let r = dot(foot, foot).sqrt();
            (foot.map(|x| x / r), r)
        })
    }

    /// A third of the solid angle of all triangles at each vertex.
    pub(super) fn weights(&self) -> Vec<f64> {
        let mut weights = vec![0.0; self.solid.vertices().len()];
        for (k, corners) in self.solid.triangles().iter().enumerate() {
            let [a, b, c] = self.corners(k).map(|v| {
                let r = dot(v, v).sqrt();
                v.map(|x| x / r)
            });
            let n = cross(minus(b, a), minus(c, a));
            let area = dot(n, n).sqrt() / 6.0;
            for corner in corners {
                weights[*corner as usize] += area;
            }
        }
        weights
    }
}

/// Six times the volume.
fn volume(corners: &[[f64; 3]; 3]) -> f64 {
    determinant(*corners)
}

/// On which side of the plane through the center and an edge a direction is: positive on the triangle's side.
fn outside(corners: &[[f64; 3]; 3], edge: usize, direction: [f64; 3]) -> f64 {
    determinant([corners[edge], corners[(edge + 1) % 3], direction])
}

/// The radius of the plane of a triangle in a direction.
fn radius(corners: &[[f64; 3]; 3], direction: [f64; 3]) -> f64 {
    let [a, b, c] = *corners;
    let normal = cross(minus(b, a), minus(c, a));
    dot(normal, a) / dot(normal, direction)
}
