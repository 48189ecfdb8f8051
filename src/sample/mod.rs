//! Certified points on curves and surfaces: a float says where to look, exact arithmetic says what is true.

mod direction;
mod guess;
mod ray;
mod space_direction;
mod space_superquadric;
mod superquadric;
mod truncated;
mod wide;

pub use direction::{Direction, UnitVector};
pub(crate) use ray::along;
pub use ray::{HomogeneousParts, Ray, RaySolver, Sample, StageCounts, Term};
pub use space_direction::SpaceDirection;
pub use space_superquadric::SpaceSuperquadricSolver;
pub use superquadric::{MAX_ROOT_BITS, SuperquadricSolver};
