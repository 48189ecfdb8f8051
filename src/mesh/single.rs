//! Meshes in single precision, as some files hold them.

use std::collections::HashMap;

use super::triangles::Mesh;
use crate::error::{Error, Invariant, Result};

/// The roundings of the length of a vector of three exact doubles are within this factor.
const ROUNDINGS: f64 = 1.0 + 4.0 * f64::EPSILON;

/// The number in single precision that is nearest to a double.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the rounding is what is wanted"
)]
pub(crate) fn single(value: f64) -> f32 {
    value as f32
}

impl Mesh {
    /// The mesh with the coordinates that single precision holds. [`Mesh::vertex_bound`] grows by the largest distance by which a
    /// vertex moves. Vertices at one place become one, as in a file that has only places; [`Mesh::merged`] counts them.
    ///
    /// ```
    /// use stellate::language::Numbers;
    /// use stellate::verb::{self, Given, MeshingOptions, Work};
    /// let given = Given::read("x^2 + y^2 + z^2 = 1", Numbers::Exact)?;
    /// let mesh = verb::mesh(given, &MeshingOptions::default().resolution(8), &Work::default())?;
    /// assert!(mesh.vertex_bound < 1e-8);
    /// let rounded = mesh.in_single_precision()?;
    /// let distance = |v: &[f64; 3]| (v.iter().map(|c| c * c).sum::<f64>().sqrt() - 1.0).abs();
    /// assert!(rounded.vertices.iter().all(|v| distance(v) <= rounded.vertex_bound));
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`] for a coordinate that is too large for single precision, 3.4e38.
    pub fn in_single_precision(mut self) -> Result<Self> {
        let mut largest: f64 = 0.0;
        for vertex in &mut self.vertices {
            let mut moved: f64 = 0.0;
            for coordinate in vertex.iter_mut() {
                let rounded = f64::from(single(*coordinate));
                if !rounded.is_finite() {
                    return Err(Error::Usage(format!(
                        "the coordinate {coordinate:e} is too large for single precision, which an STL file holds; OBJ and PLY hold doubles"
                    )));
                }
                // The difference is exact, because both are multiples of the same small unit and it has no more digits than they.
                moved = f64::hypot(moved, rounded - *coordinate);
                *coordinate = rounded;
            }
            largest = largest.max(moved);
        }
        self.vertex_bound = (self.vertex_bound + largest * ROUNDINGS).next_up();
        self.merge_equal_vertices();
        Ok(self)
    }

    fn merge_equal_vertices(&mut self) {
        let mut places: HashMap<[u64; 3], u32> = HashMap::new();
        let (mut vertices, mut normals) = (Vec::new(), Vec::new());
        let mut indices = Vec::with_capacity(self.vertices.len());
        for (vertex, normal) in self.vertices.iter().zip(&self.normals) {
            // The sum has no negative zero.
            let place = vertex.map(|x| (x + 0.0).to_bits());
            let next =
                u32::try_from(vertices.len()).invariant("a mesh has fewer than 2^32 vertices");
            let index = *places.entry(place).or_insert(next);
            if index == next {
                vertices.push(*vertex);
                normals.push(*normal);
            }
            indices.push(index);
        }
        self.merged += self.vertices.len() - vertices.len();
        (self.vertices, self.normals) = (vertices, normals);
        for triangle in &mut self.triangles {
            *triangle = triangle.map(|v| indices[v as usize]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_that_become_equal_are_one() {
        // Of the two triangles of a thin square, single precision leaves one, with an edge that is now at the rim.
        let far = 1e9;
        let mesh = Mesh {
            vertices: vec![
                [far, 0.0, 0.0],
                [far + 1.0, 0.0, -0.0],
                [far, 9.0, 0.0],
                [far + 1.0, 9.5, 0.0],
            ],
            normals: vec![[0.0, 0.0, 1.0]; 4],
            triangles: vec![[0, 1, 2], [1, 3, 2]],
            ..Mesh::default()
        };
        assert_eq!(mesh.topology().components, 1);
        let rounded = mesh.in_single_precision().unwrap();
        assert_eq!((rounded.vertices.len(), rounded.merged), (3, 1));
        assert_eq!(rounded.triangles, [[0, 0, 1], [0, 2, 1]]);
        let topology = rounded.topology();
        assert_eq!((topology.flat_triangles, topology.boundary_edges), (1, 3));
        assert_eq!(
            (topology.irregular_edges, topology.euler_characteristic),
            (0, 1)
        );
        assert!(!rounded.has_proved_topology());
    }
}
