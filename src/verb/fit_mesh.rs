//! Fits of closed meshes by sums of spherical harmonics, for the verb `fit`.

use std::fs::File;
use std::path::Path;

use super::Work;
use crate::error::{Error, Result};
use crate::fit::{MeshFit, MeshFitOptions, MeshFitSize, fit_mesh as fit};
use crate::inspect::{DistanceBounds, mesh_distance};
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

/// A fit to a mesh, and how far it is from the mesh.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct FittedMesh {
    /// The fit.
    pub fit: MeshFit,
    /// Certified bounds of the Hausdorff distance of mesh and surface; `None` if R is 0 or if lengths are beyond the range of doubles.
    pub distance: Option<DistanceBounds>,
}

/// Fits a sum of spherical harmonics to a closed mesh.
///
/// # Errors
/// Those of [`crate::fit::fit_mesh`]; [`Error::Limit`] if the equation of the sum has a degree above that which the work allows.
pub fn fit_mesh(solid: &Solid, options: &MeshFitOptions, work: &Work) -> Result<FittedMesh> {
    if let MeshFitSize::Degree(degree) = options.size {
        work.check_degree(2 * degree + 2)?;
    }
    let fit = work.stage("fit", || fit(solid, options, work.bounds()))?;
    let distance = work.stage("distance", || {
        mesh_distance(solid, &fit.surface, work.bounds())
    })?;
    Ok(FittedMesh { fit, distance })
}
