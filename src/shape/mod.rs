//! Forms and contours: Fourier radii, parametric curves and patches, implicit curves and surfaces, superquadrics.

mod contour;
mod crossing;
mod curve;
mod curve_values;
mod drawn;
mod elliptic;
mod fourier;
mod harmonic;
mod harmonic_pair;
mod harmonic_waves;
mod harmonics;
mod implicit;
mod normalized;
mod orientation;
mod parameter;
mod patch;
#[cfg(feature = "pictures")]
mod patch_facets;
mod patch_grid;
mod points;
mod polyline;
mod radial;
mod repair;
mod solid;
mod superquadric;
mod swept_edge;

pub use contour::Contour;
pub use curve::{ParametricCurve, PlaneCurve, SpaceCurve};
#[cfg(feature = "pictures")]
pub(crate) use drawn::DRAWN_NUMBERS;
pub(crate) use drawn::{CurveInDoubles, PatchInDoubles};
pub use elliptic::EllipticSeries;
pub(crate) use elliptic::harmonics_of_curve;
pub use fourier::FourierRadius;
pub(crate) use fourier::series;
pub use harmonic::{HarmonicSurface, MAX_HARMONIC_DEGREE};
pub use harmonic_pair::HarmonicPair;
pub(crate) use harmonic_pair::rho_power_in_space;
pub(crate) use harmonic_waves::{WaveCoefficients, wave_coefficients};
pub(crate) use harmonics::{Basis, Expansion, quotient_in_harmonics};
pub use implicit::{ImplicitCurve, ImplicitSurface};
pub(crate) use normalized::{NormalizedHarmonics, harmonic_norm};
pub(crate) use orientation::{coordinate_fault, orientation};
pub use parameter::Parameter;
pub use patch::{Patch, PatchFunction};
pub use points::{GivenPoints, PointCloud};
pub use radial::Radial;
pub use repair::Removed;
pub use solid::Solid;
pub(crate) use solid::{cross, determinant, dot, minus};
pub use superquadric::{SpaceSuperquadric, Superquadric};
pub(crate) use swept_edge::SweptEdge;

/// An exact form, of any kind that the input language or a document can describe.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Form {
    /// A radius `r = …` that is a Fourier series.
    Fourier(FourierRadius),
    /// A radius `R = …` in space that is a finite sum of spherical harmonics.
    Harmonic(HarmonicSurface),
    /// A polynomial in x and y.
    Curve(ImplicitCurve),
    /// A polynomial in x, y and z.
    Surface(ImplicitSurface),
    /// A plane superquadric, `superquadric 2d …`.
    Superquadric(Superquadric),
    /// A superquadric in space, `superquadric 3d …`.
    SpaceSuperquadric(SpaceSuperquadric),
    /// A plane curve `x = …; y = …` with one parameter.
    PlaneCurve(PlaneCurve),
    /// A space curve `x = …; y = …; z = …` with one parameter.
    SpaceCurve(SpaceCurve),
    /// A patch `x = …; y = …; z = …` with two parameters.
    Patch(Patch),
    /// The intersection of two or more surfaces, each given by a polynomial in x, y and z.
    Intersection(Vec<ImplicitSurface>),
}

impl From<FourierRadius> for Form {
    fn from(radius: FourierRadius) -> Self {
        Self::Fourier(radius)
    }
}

impl From<HarmonicSurface> for Form {
    fn from(surface: HarmonicSurface) -> Self {
        Self::Harmonic(surface)
    }
}

impl From<ImplicitCurve> for Form {
    fn from(curve: ImplicitCurve) -> Self {
        Self::Curve(curve)
    }
}

impl From<ImplicitSurface> for Form {
    fn from(surface: ImplicitSurface) -> Self {
        Self::Surface(surface)
    }
}
