//! The triangles of a mesh in a tree of boxes, for the distance of points from the mesh.

use rstar::{AABB, PointDistance, RTree, RTreeObject};

use crate::error::Invariant;
use crate::intervals::interval::UNIT;
use crate::shape::{cross, dot, minus};

/// A triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face(pub(super) [[f64; 3]; 3]);

/// All triangles of a mesh.
#[derive(Debug)]
pub(super) struct Faces(RTree<Face>);

impl Faces {
    pub(super) fn new(faces: Vec<Face>) -> Self {
        Self(RTree::bulk_load(faces))
    }

    /// A triangle that is about as near to the point as any, and a lower bound of the distance of all of them.
    pub(super) fn nearest(&self, p: [f64; 3]) -> Option<(Face, f64)> {
        let face = self.0.nearest_neighbor(p)?;
        Some((*face, face.least_distance(&p)))
    }
}

impl RTreeObject for Face {
    type Envelope = AABB<[f64; 3]>;

    fn envelope(&self) -> Self::Envelope {
        AABB::from_points(&self.0)
    }
}

impl PointDistance for Face {
    fn distance_2(&self, p: &[f64; 3]) -> f64 {
        self.least_distance(p).powi(2)
    }
}

impl Face {
    /// An upper bound of the distance of a point.
    pub(super) fn greatest_distance(&self, p: &[f64; 3]) -> f64 {
        let away = minus(*p, self.near(p));
        dot(away, away).sqrt() * (1.0 + 8.0 * UNIT) + self.rounding(p)
    }

    /// A lower bound of the distance of a point p: by a plane with the unit normal n that has p on one side and the triangle on the other,
    /// it is at least n·(p − c) for the corner c for which that is least. The normal from the nearest point gives the distance itself,
    /// and any other one gives less.
    fn least_distance(&self, p: &[f64; 3]) -> f64 {
        let away = minus(*p, self.near(p));
        let size = dot(away, away).sqrt();
        if size <= self.rounding(p) {
            return 0.0;
        }
        let beyond = self.0.map(|corner| dot(away, minus(*p, corner)) / size);
        let least = beyond.into_iter().fold(f64::INFINITY, f64::min);
        (least * (1.0 - 16.0 * UNIT) - self.rounding(p)).max(0.0)
    }

    /// A bound of the rounding errors of coordinates and of scalar products with unit vectors.
    fn rounding(&self, p: &[f64; 3]) -> f64 {
        let all = self.0.iter().flatten().chain(p);
        32.0 * UNIT * all.fold(0.0, |largest: f64, x| largest.max(x.abs()))
    }

    /// A point of the triangle, up to rounding, that is about as near as any.
    fn near(&self, p: &[f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.0;
        let normal = cross(minus(b, a), minus(c, a));
        let square = dot(normal, normal);
        let off = minus(*p, a);
        // The coordinates of the foot of p in the plane: a + s(b − a) + t(c − a).
        let s = dot(cross(off, minus(c, a)), normal) / square;
        let t = dot(cross(minus(b, a), off), normal) / square;
        let foot: [f64; 3] = std::array::from_fn(|i| a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]));
        let is_inside = s >= 0.0 && t >= 0.0 && s + t <= 1.0;
        let edges = [[a, b], [b, c], [c, a]].map(|edge| near_on_edge(edge, p));
        let all = edges.into_iter().chain(is_inside.then_some(foot));
        let far = |q: &[f64; 3]| {
            let off = minus(*p, *q);
            dot(off, off)
        };
        let best = all.min_by(|a, b| far(a).total_cmp(&far(b)));
        best.invariant("a triangle has edges")
    }
}

/// The nearest point of an edge.
fn near_on_edge([a, b]: [[f64; 3]; 2], p: &[f64; 3]) -> [f64; 3] {
    let way = minus(b, a);
    let square = dot(way, way);
    let t = if square > 0.0 {
        (dot(minus(*p, a), way) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    std::array::from_fn(|i| a[i] + t * way[i])
}
