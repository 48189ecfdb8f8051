//! What a user holds: Fourier radii, implicit curves, contours.

mod fourier;

pub use fourier::FourierRadius;
