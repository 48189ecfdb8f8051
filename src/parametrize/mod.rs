//! Implicit → parametric (§3 of the paper).

mod fourier;
mod ranges;

pub use fourier::{FourierBranches, fourier_branches};
pub use ranges::{AngleRange, ExactAngle, positive_ranges};
