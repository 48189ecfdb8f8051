//! Triangle meshes of surfaces, with exact signs at grid points and a certified zero near each vertex.

mod cells;
mod collapse;
mod radial;
mod refine;
mod tetrahedra;
mod topology;
mod triangles;

pub use radial::{mesh_harmonic, mesh_radial};
pub use topology::Topology;
pub use triangles::{MAX_MESH_CELLS, Mesh, MeshOptions, mesh_bounds, mesh_surface};
