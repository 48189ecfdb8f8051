//! Surfaces, meshes, arcs and superquadrics.

#[path = "../common/mod.rs"]
mod common;

mod arcs;
mod mesh;
mod mesh_quality;
mod singular;
mod superquadric;
mod superquadric_space;
mod surfaces;
mod surfaces_cli;
mod thin;
