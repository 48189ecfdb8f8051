//! Meshes of triangles are read from OBJ, PLY and STL.

mod obj;
mod ply;
mod stl;

use std::collections::HashMap;
use std::path::Path;

use crate::error::{Error, Result};
use crate::shape::Solid;

/// The largest number of bytes of a mesh.
pub const MAX_MESH_BYTES: usize = 1 << 30;

/// A format of meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SolidFormat {
    /// Wavefront OBJ; faces with more than three corners are cut into triangles from their first corner.
    Obj,
    /// Stanford PLY, as text or binary.
    Ply,
    /// STL, as text or binary; corners with the same coordinates are one vertex.
    Stl,
}

impl SolidFormat {
    /// The format that the extension of a file says.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "obj" => Some(Self::Obj),
            "ply" => Some(Self::Ply),
            "stl" => Some(Self::Stl),
            _ => None,
        }
    }
}

/// The vertices of a PLY file as rows of text, after a row with the names of their properties.
///
/// # Errors
/// [`Error::Data`] for a file that is damaged or has no vertices.
pub(crate) fn rows_of_ply(bytes: &[u8], place: &str) -> Result<String> {
    ply::points(bytes, place)
}

/// Vertices and triangles as they were read.
#[derive(Debug, Default)]
struct Faces {
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Faces {
    /// Cuts a face into triangles from its first corner.
    fn add(&mut self, corners: &[u32]) {
        for pair in corners[1..].windows(2) {
            self.triangles.push([corners[0], pair[0], pair[1]]);
        }
    }

    /// Makes one vertex of all that have the same coordinates.
    fn joined(self) -> Self {
        let mut names: HashMap<[u64; 3], u32> = HashMap::new();
        let mut vertices = Vec::new();
        let mut new_names = Vec::with_capacity(self.vertices.len());
        for vertex in self.vertices {
            // −0 and 0 are one coordinate.
            let key = vertex.map(|x| (x + 0.0).to_bits());
            let next = u32::try_from(vertices.len()).unwrap_or(u32::MAX);
            let name = *names.entry(key).or_insert(next);
            if name == next {
                vertices.push(vertex);
            }
            new_names.push(name);
        }
        let rename = |corner: u32| new_names.get(corner as usize).copied().unwrap_or(u32::MAX);
        let triangles = self.triangles.into_iter().map(|t| t.map(rename));
        Self {
            vertices,
            // Triangles that are an edge or a point are left out.
            triangles: triangles
                .filter(|[a, b, c]| a != b && b != c && c != a)
                .collect(),
        }
    }
}

/// Reads a closed mesh.
///
/// ```
/// use stellate::reading::{SolidFormat, read_solid};
/// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
/// let solid = read_solid(text.as_bytes(), SolidFormat::Obj, "a.obj")?;
/// assert_eq!(solid.triangles().len(), 4);
/// assert!(read_solid(&text.as_bytes()[..50], SolidFormat::Obj, "a.obj").is_err());
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Data`] with the line for what is no mesh, and those of [`Solid::new`].
pub fn read_solid(bytes: &[u8], format: SolidFormat, place: &str) -> Result<Solid> {
    let faces = match format {
        SolidFormat::Obj => obj::read(text(bytes, place)?, place)?,
        SolidFormat::Ply => ply::read(bytes, place)?,
        SolidFormat::Stl => stl::read(bytes, place)?.joined(),
    };
    Solid::new(faces.vertices, faces.triangles, place)
}

fn text<'a>(bytes: &'a [u8], place: &str) -> Result<&'a str> {
    std::str::from_utf8(bytes).map_err(|_| Error::data(place, "this is no text in UTF-8"))
}

/// A coordinate as a double.
fn coordinate(word: Option<&str>, line: usize, place: &str) -> Result<f64> {
    let word = word.ok_or_else(|| {
        Error::data(
            place,
            format!("line {line}: a vertex has three coordinates"),
        )
    })?;
    let value: Option<f64> = word.parse().ok();
    value
        .filter(|x| x.is_finite())
        .ok_or_else(|| Error::data(place, format!("line {line}: `{word}` is no finite number")))
}

/// The vertex of the words after its keyword.
fn vertex<'a>(
    mut words: impl Iterator<Item = &'a str>,
    line: usize,
    place: &str,
) -> Result<[f64; 3]> {
    let mut found = [0.0; 3];
    for x in &mut found {
        *x = coordinate(words.next(), line, place)?;
    }
    Ok(found)
}
