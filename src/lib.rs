//! Exact conversion between parametric and implicit forms of star-shaped curves and surfaces.

pub mod describe;
pub mod document;
pub mod error;
pub mod exact;
pub mod fit;
pub mod implicitize;
pub mod language;
pub mod limits;
pub mod parametrize;
pub mod picture;
pub mod poly;
pub mod sample;
pub mod shape;
