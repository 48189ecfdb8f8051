//! What a user holds: Fourier radii, implicit curves and surfaces, superquadrics, contours.

mod contour;
mod crossing;
mod fourier;
mod implicit;
mod orientation;
mod superquadric;
mod swept_edge;

pub use contour::Contour;
pub(crate) use contour::coordinate_fault;
pub use fourier::FourierRadius;
pub use implicit::{ImplicitCurve, ImplicitSurface};
pub(crate) use orientation::orientation;
pub use superquadric::Superquadric;
pub(crate) use swept_edge::SweptEdge;

/// Any form that the input language or a document can say exactly.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// `r = …`
    Fourier(FourierRadius),
    /// A polynomial in x and y.
    Curve(ImplicitCurve),
    /// A polynomial in x, y and z.
    Surface(ImplicitSurface),
    /// `superquadric 2d …`
    Superquadric(Superquadric),
}
