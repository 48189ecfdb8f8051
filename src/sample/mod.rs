//! Certified points on curves and surfaces: a float says where to look, exact arithmetic says what is true.

mod direction;
mod guess;
mod ladder;
#[cfg(test)]
mod laws;
mod parts;
mod point;
mod radial;
mod ray;
mod root_rounding;
mod sampled;
mod space_direction;
mod truncated;
mod wide;

pub use direction::{Direction, UnitVector};
pub use parts::{Basis, ExpandedPart, Expansion, HomogeneousParts, Term};
pub use point::{Ray, Sample};
pub use radial::solve_radial;
pub(crate) use ray::along;
pub use ray::{RaySolver, StageCounts};
pub use sampled::{NominalAngles, SampledRay};
pub use space_direction::SpaceDirection;
