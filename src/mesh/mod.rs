//! Triangle meshes of surfaces, with exact signs at grid points and a certified zero near each vertex.

mod apart;
mod bounds;
mod cells;
mod collapse;
mod critical;
mod extent;
mod flip;
mod frame;
mod quality;
mod radial;
mod refine;
mod single;
mod solid;
mod tetrahedra;
mod topology;
mod triangles;

pub(crate) use apart::parts_apart;
pub use bounds::{Held, SurfaceBox, mesh_bounds};
pub use extent::BoxSides;
pub use radial::{mesh_harmonic, mesh_radial};
pub(crate) use single::single;
pub use topology::MeshTopology;
pub use triangles::{MAX_MESH_CELLS, Mesh, MeshOptions, mesh_surface};
