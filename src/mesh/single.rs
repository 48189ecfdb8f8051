//! Meshes in single precision, as some files hold them.

use super::triangles::Mesh;
use crate::error::{Error, Result};

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
    /// vertex moves.
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
        Ok(self)
    }
}
