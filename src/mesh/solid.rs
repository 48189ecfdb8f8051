//! The direction of the closed pieces of a mesh that is the boundary of a solid.

use nalgebra::Vector3;

use super::triangles::Mesh;

impl Mesh {
    /// Turns the closed pieces that lie inside an odd number of others, so that all triangles look out of the solid between the
    /// pieces. Returns whether all pieces are closed; if they are not, nothing is changed.
    ///
    /// Cost: for each two pieces, linear in the number of triangles of one of them.
    pub fn turn_as_solid(&mut self) -> bool {
        if !self.topology().is_watertight() {
            return false;
        }
        let (pieces, count) = self.pieces();
        let mut triangles: Vec<Vec<[u32; 3]>> = vec![Vec::new(); count];
        for triangle in &self.triangles {
            triangles[pieces[triangle[0] as usize]].push(*triangle);
        }
        let is_hollow: Vec<bool> = (0..count)
            .map(|piece| {
                let Some([corner, ..]) = triangles[piece].first() else {
                    return false;
                };
                let at = self.vertices[*corner as usize];
                let around = (0..count)
                    .filter(|&other| other != piece && self.winds_around(&triangles[other], at));
                around.count() % 2 == 1
            })
            .collect();
        for triangle in &mut self.triangles {
            if is_hollow[pieces[triangle[0] as usize]] {
                triangle.swap(1, 2);
            }
        }
        for (normal, piece) in self.normals.iter_mut().zip(&pieces) {
            if is_hollow[*piece] {
                *normal = normal.map(|n| -n);
            }
        }
        self.inward = is_hollow.iter().filter(|hollow| **hollow).count();
        true
    }

    /// Whether a closed piece winds around a point: whether the solid angles of its triangles, seen from the point, add up to a whole
    /// sphere.
    fn winds_around(&self, triangles: &[[u32; 3]], point: [f64; 3]) -> bool {
        let point = Vector3::from(point);
        let angle = |triangle: &[u32; 3]| -> f64 {
            let [a, b, c] = triangle.map(|v| Vector3::from(self.vertices[v as usize]) - point);
            let [l, m, n] = [a.norm(), b.norm(), c.norm()];
            // Van Oosterom & Strackee 1983
            let below = l * m * n + a.dot(&b) * n + b.dot(&c) * l + c.dot(&a) * m;
            2.0 * a.dot(&b.cross(&c)).atan2(below)
        };
        let sum: f64 = triangles.iter().map(angle).sum();
        sum.abs() > 2.0 * std::f64::consts::PI
    }
}
