//! What a user holds: Fourier radii, implicit curves and surfaces, contours.

mod fourier;
mod implicit;

pub use fourier::FourierRadius;
pub use implicit::{ImplicitCurve, ImplicitSurface};

/// Any form that the input language or a document can say exactly.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// `r = …`
    Fourier(FourierRadius),
    /// A polynomial in x and y.
    Curve(ImplicitCurve),
    /// A polynomial in x, y and z.
    Surface(ImplicitSurface),
}
