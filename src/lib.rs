//! Exact conversion between parametric and implicit forms of star-shaped curves and surfaces.

pub mod error;
pub mod exact;
pub mod fit;
pub mod shape;
