//! Implicit → parametric (§3 of the paper).

mod angle;
mod approximate;
mod cells;
mod closed;
mod condition;
mod expression;
mod fourier;
mod intersection;
mod meridian;
mod parametrization;
mod ranges;
mod rational;
mod same_angle;
mod superquadric;
mod surface;
mod traced;

pub use angle::{AngleRange, ExactAngle};
pub use approximate::{BranchFit, BranchFitOptions, DEFAULT_HARMONICS, fit_branch, rounded_up};
pub use condition::{Condition, Relation};
pub use expression::Expression;
pub use fourier::{FourierBranches, born_of_radius, fourier_branches};
pub use intersection::{
    IntersectionParametrization, UnparametrizedComponent, parametrize_intersection,
};
pub use meridian::{DirectionAnswer, MeridianBranch};
pub use parametrization::{Branch, Parametrization, PolarMethod, Radius, parametrize};
pub use ranges::positive_ranges;
pub use rational::{
    Cover, FactorRationality, Place, RationalCurve, Rationality, rational_parametrization,
};
pub use superquadric::{parametrize_space_superquadric, parametrize_superquadric};
pub use surface::{
    SurfaceBranch, SurfaceFactor, SurfaceMethod, SurfaceParametrization, SurfaceSource,
    parametrize_surface,
};
pub use traced::{RootArc, RootBranch};
