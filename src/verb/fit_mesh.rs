//! Fits of closed meshes by sums of spherical harmonics, for the verb `fit`.

use super::Work;
use crate::error::Result;
use crate::fit::{MeshFit, MeshFitOptions, MeshFitSize, fit_mesh as fit};
use crate::inspect::{DistanceBounds, mesh_distance};
use crate::shape::Solid;

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
/// Those of [`crate::fit::fit_mesh`]; [`Error::Limit`](crate::error::Error::Limit) if the equation of the sum has a degree above that which the work allows.
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
