//! What a user holds: Fourier radii, parametric curves and patches, implicit curves and surfaces,
//! superquadrics, contours.

mod contour;
mod crossing;
mod curve;
mod drawn;
mod fourier;
mod harmonics;
mod implicit;
mod orientation;
mod parameter;
mod patch;
mod radial;
mod superquadric;
mod swept_edge;

pub use contour::Contour;
pub(crate) use contour::coordinate_fault;
pub use curve::{ParametricCurve, PlaneCurve, SpaceCurve};
#[cfg(feature = "pictures")]
pub(crate) use drawn::DRAWN_NUMBERS;
pub(crate) use drawn::{CurveInDoubles, PatchInDoubles};
pub use fourier::FourierRadius;
pub(crate) use harmonics::{Basis, Expansion, quotient_in_harmonics};
pub use implicit::{ImplicitCurve, ImplicitSurface};
pub(crate) use orientation::orientation;
pub use parameter::Parameter;
pub use patch::{Patch, PatchFunction};
pub use radial::Radial;
pub use superquadric::{SpaceSuperquadric, Superquadric};
pub(crate) use swept_edge::SweptEdge;

/// Any form that the input language or a document can say exactly.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Form {
    /// `r = …`
    Fourier(FourierRadius),
    /// A polynomial in x and y.
    Curve(ImplicitCurve),
    /// A polynomial in x, y and z.
    Surface(ImplicitSurface),
    /// `superquadric 2d …`
    Superquadric(Superquadric),
    /// `superquadric 3d …`
    SpaceSuperquadric(SpaceSuperquadric),
    /// `x = …; y = …` in one parameter
    PlaneCurve(PlaneCurve),
    /// `x = …; y = …; z = …` in one parameter
    SpaceCurve(SpaceCurve),
    /// `x = …; y = …; z = …` in two parameters
    Patch(Patch),
    /// The common points of two or more surfaces: one polynomial in x, y and z to an equation.
    Intersection(Vec<ImplicitSurface>),
}
