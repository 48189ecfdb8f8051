//! Parametrization: radii of implicit forms (§3 of the paper).

mod angle;
mod approximate;
mod cells;
mod closed;
mod condition;
mod expression;
mod fourier;
mod harmonic;
mod intersection;
mod meridian;
mod parametrization;
mod ranges;
mod rational;
mod same_angle;
mod series_error;
mod singular;
mod superquadric;
mod surface;
mod traced;

pub use angle::{AngleRange, ExactAngle};

pub use approximate::{BranchFit, BranchFitOptions, DEFAULT_HARMONICS, fit_branch};
pub use condition::{Condition, Relation};
pub use expression::Expression;
pub(crate) use fourier::born_of_radius;
pub use fourier::{FourierBranches, fourier_branches};
pub use harmonic::harmonic_radii;
pub use intersection::{
    CommonPoint, FiniteComponent, IntersectionParametrization, UnparametrizedComponent,
    UnreachedPoint, parametrize_intersection,
};
pub use meridian::{DirectionAnswer, MeridianBranch};
pub(crate) use parametrization::critical_slopes;
pub use parametrization::{Branch, BranchRadius, Parametrization, PolarMethod, parametrize};
pub(crate) use ranges::is_full_circle;
pub use ranges::{is_positive, positive_ranges};
pub use rational::{
    Cover, FactorRationality, Place, RationalCurve, Rationality, rational_parametrization,
};
pub(crate) use series_error::rounded_up;
pub use singular::{SingularLocus, singular_locus};
pub use superquadric::{parametrize_space_superquadric, parametrize_superquadric};
pub use surface::{
    SurfaceBranch, SurfaceFactor, SurfaceMethod, SurfaceParametrization, parametrize_surface,
};
pub use traced::{RootArc, RootBranch};
