//! Triangle meshes of implicit surfaces: exact signs at grid points, certified vertices, every sheet.

mod cells;
mod collapse;
mod radial;
mod refine;
mod tetrahedra;
mod topology;
mod triangles;

pub use radial::mesh_radial;
pub use topology::Topology;
pub use triangles::{MAX_MESH_CELLS, Mesh, MeshOptions, mesh_bounds, mesh_surface};
