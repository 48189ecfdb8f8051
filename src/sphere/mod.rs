//! Certified properties of radii that are finite sums of spherical harmonics.

mod grid;
mod positive;
mod touching;

pub use positive::{Positivity, positivity};
