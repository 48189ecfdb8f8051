//! Exact conversion between parametric and implicit forms of star-shaped curves and surfaces.

pub mod document;
pub mod error;
pub mod exact;
pub mod language;
pub mod poly;
pub mod shape;
