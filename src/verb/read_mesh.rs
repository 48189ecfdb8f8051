//! Closed meshes from files.

use std::fs::File;
use std::path::Path;

use super::Work;
use crate::error::{Error, Result};
use crate::reading::{MAX_MESH_BYTES, SolidFormat, bytes_within, read_solid};
use crate::shape::Solid;

/// Whether an argument is the name of a mesh: of an .obj, .ply or .stl file.
#[must_use]
pub fn is_mesh_name(argument: &str) -> bool {
    SolidFormat::of(Path::new(argument)).is_some()
}

/// Reads a closed mesh from an .obj, .ply or .stl file.
///
/// # Errors
/// [`Error::Io`] for a file that cannot be read; [`Error::Usage`] for another extension; those of [`read_solid`].
pub fn read_mesh(path: &Path, work: &Work) -> Result<Solid> {
    let place = path.display().to_string();
    let format = SolidFormat::of(path)
        .ok_or_else(|| Error::Usage(format!("{place}: a mesh is an .obj, .ply or .stl file")))?;
    work.stage("read", || {
        let file = File::open(path).map_err(|source| Error::Io {
            path: path.to_owned(),
            source,
        })?;
        let bytes = bytes_within(file, MAX_MESH_BYTES as u64, &place)?
            .ok_or_else(|| Error::limit(format!("a mesh of more than {MAX_MESH_BYTES} bytes")))?;
        read_solid(&bytes, format, &place)
    })
}
