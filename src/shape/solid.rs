//! [`Solid`]: a closed mesh of triangles that was measured or modelled.

use std::collections::HashMap;

use crate::error::{Error, Result};

/// A closed mesh of triangles, the surface of a solid.
///
/// Each edge belongs to exactly two triangles, which agree about which side is outside, and all triangles are connected by edges. The
/// triangles are counter-clockwise as seen from outside: the volume that they enclose is positive.
#[derive(Clone, Debug)]
pub struct Solid {
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    /// For each triangle the ones across the edges from its corners 0, 1 and 2 to the next ones.
    neighbours: Vec<[u32; 3]>,
    place: String,
}

impl Solid {
    /// The solid with these vertices and triangles; `place` names it in messages. Vertices of no triangle are left out.
    ///
    /// ```
    /// use stellate::shape::Solid;
    /// let vertices = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let triangles = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
    /// assert!(Solid::new(vertices.clone(), triangles.clone(), "a").is_ok());
    /// let open = Solid::new(vertices, triangles[1..].to_vec(), "a").unwrap_err();
    /// assert!(open.to_string().contains("hole"));
    /// ```
    ///
    /// # Errors
    /// [`Error::Data`] for a coordinate that is not finite, a triangle with a corner that is no vertex or is there twice, an edge with one
    /// triangle or with more than two, triangles that disagree about the outside, several pieces, and a mesh that is inside out.
    pub fn new(
        vertices: Vec<[f64; 3]>,
        triangles: Vec<[u32; 3]>,
        place: impl Into<String>,
    ) -> Result<Self> {
        let place = place.into();
        if let Some(bad) = vertices
            .iter()
            .position(|v| v.iter().any(|x| !x.is_finite()))
        {
            let message = format!("vertex {}: a coordinate is not finite", bad + 1);
            return Err(Error::data(place, message));
        }
        for (k, corners) in triangles.iter().enumerate() {
            let [a, b, c] = *corners;
            if let Some(missing) = corners.iter().find(|v| **v as usize >= vertices.len()) {
                let message = format!(
                    "triangle {}: there is no vertex {}, only {}",
                    k + 1,
                    u64::from(*missing) + 1,
                    vertices.len()
                );
                return Err(Error::data(place, message));
            }
            if a == b || b == c || c == a {
                let message = format!("triangle {}: two of its corners are one vertex", k + 1);
                return Err(Error::data(place, message));
            }
        }
        let neighbours = match neighbours(&triangles) {
            Ok(neighbours) => neighbours,
            Err(message) => return Err(Error::data(place, message)),
        };
        let (vertices, triangles) = with_used_vertices(vertices, triangles);
        let solid = Self {
            vertices,
            triangles,
            neighbours,
            place,
        };
        solid.check_sides()?;
        Ok(solid)
    }

    fn check_sides(&self) -> Result<()> {
        if self.triangles.is_empty() {
            return Err(Error::data(&self.place, "the mesh has no triangle"));
        }
        let reached = self.reached_from_first();
        if reached < self.triangles.len() {
            let message = format!(
                "the mesh has several pieces: {reached} of its {} triangles are connected with the first one; each piece is a mesh of its own",
                self.triangles.len()
            );
            return Err(Error::data(&self.place, message));
        }
        if self.moments().0 <= 0.0 {
            return Err(Error::data(
                &self.place,
                "the mesh is inside out: the triangles are clockwise as seen from outside; reverse all of them",
            ));
        }
        Ok(())
    }

    fn reached_from_first(&self) -> usize {
        let mut is_reached = vec![false; self.triangles.len()];
        let mut waiting = vec![0];
        is_reached[0] = true;
        let mut count = 0;
        while let Some(at) = waiting.pop() {
            count += 1;
            for next in self.neighbours[at] {
                let next = next as usize;
                if !is_reached[next] {
                    is_reached[next] = true;
                    waiting.push(next);
                }
            }
        }
        count
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    /// The triangles, as indices of vertices.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The triangles across the edges of a triangle: those from its corners 0, 1 and 2 to the next ones.
    pub(crate) fn neighbours(&self, triangle: usize) -> [usize; 3] {
        self.neighbours[triangle].map(|k| k as usize)
    }

    /// The name of the mesh in messages.
    #[must_use]
    pub fn place(&self) -> &str {
        &self.place
    }

    /// The corners of a triangle.
    pub(crate) fn corners(&self, triangle: usize) -> [[f64; 3]; 3] {
        self.triangles[triangle].map(|v| self.vertices[v as usize])
    }

    /// Six times the volume, and the centroid of the solid, in doubles.
    pub(crate) fn moments(&self) -> (f64, [f64; 3]) {
        // Measured from the first vertex, so that differences of large coordinates do not cancel in the sums.
        let first = self.vertices[0];
        let (mut volume, mut sum) = (0.0, [0.0; 3]);
        for k in 0..self.triangles.len() {
            let corners = self.corners(k).map(|v| minus(v, first));
            let part = determinant(corners);
            volume += part;
            for (i, sum) in sum.iter_mut().enumerate() {
                *sum += part * (corners[0][i] + corners[1][i] + corners[2][i]) / 4.0;
            }
        }
        let centroid = std::array::from_fn(|i| first[i] + sum[i] / volume);
        (volume, centroid)
    }
}

/// The difference of two vectors.
pub(crate) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The cross product.
pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The scalar product.
pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The determinant, in doubles.
pub(crate) fn determinant([a, b, c]: [[f64; 3]; 3]) -> f64 {
    dot(a, cross(b, c))
}

/// The vertices that belong to a triangle, in their order, and the triangles with their new indices.
fn with_used_vertices(
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let mut is_used = vec![false; vertices.len()];
    for corner in triangles.iter().flatten() {
        is_used[*corner as usize] = true;
    }
    let before = is_used.iter().scan(0, |count, used| {
        let index = *count;
        *count += u32::from(*used);
        Some(index)
    });
    let indices: Vec<u32> = before.collect();
    let triangles = triangles.iter().map(|t| t.map(|v| indices[v as usize]));
    let triangles = triangles.collect();
    let used = vertices.into_iter().zip(is_used).filter(|(_, used)| *used);
    (used.map(|(vertex, _)| vertex).collect(), triangles)
}

/// The triangles across the edges, or what is wrong with an edge.
fn neighbours(triangles: &[[u32; 3]]) -> std::result::Result<Vec<[u32; 3]>, String> {
    // The triangle of each directed edge.
    let mut owners: HashMap<(u32, u32), u32> = HashMap::with_capacity(3 * triangles.len());
    let short =
        |k: usize| u32::try_from(k).map_err(|_| "a mesh has at most 2^32 triangles".to_owned());
    for (k, corners) in triangles.iter().enumerate() {
        for i in 0..3 {
            let edge = (corners[i], corners[(i + 1) % 3]);
            if let Some(other) = owners.insert(edge, short(k)?) {
                return Err(format!(
                    "triangles {} and {} both go from vertex {} to vertex {}: they disagree about which side is outside, or more than two meet",
                    other + 1,
                    k + 1,
                    edge.0 + 1,
                    edge.1 + 1
                ));
            }
        }
    }
    let mut found = Vec::with_capacity(triangles.len());
    for (k, corners) in triangles.iter().enumerate() {
        let mut row = [0; 3];
        for (i, next) in row.iter_mut().enumerate() {
            let (a, b) = (corners[i], corners[(i + 1) % 3]);
            *next = *owners.get(&(b, a)).ok_or_else(|| {
                format!(
                    "the mesh has a hole: the edge between the vertices {} and {} belongs to triangle {} alone",
                    a + 1,
                    b + 1,
                    k + 1
                )
            })?;
        }
        found.push(row);
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_of_no_triangle_are_left_out() {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
        let plain = Solid::new(corners.to_vec(), triangles.to_vec(), "a").unwrap();
        let far = [50.0, 0.0, 0.0];
        let [a, b, c, d] = corners;
        let more = vec![far, a, b, far, c, d, far];
        let moved = triangles.map(|t| t.map(|v: u32| [1, 2, 4, 5][v as usize]));
        let solid = Solid::new(more, moved.to_vec(), "a").unwrap();
        assert_eq!(solid.vertices(), plain.vertices());
        assert_eq!(solid.triangles(), plain.triangles());
    }
}
