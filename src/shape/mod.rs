//! What a user holds: Fourier radii, implicit curves, contours.

mod contour;
mod crossing;
mod fourier;
mod orientation;
mod swept_edge;

pub use contour::Contour;
pub(crate) use contour::coordinate_fault;
pub use fourier::FourierRadius;
pub(crate) use orientation::orientation;
pub(crate) use swept_edge::SweptEdge;
