//! Certified points on curves and surfaces. Doubles guess where the roots are, and exact arithmetic proves it.

mod direction;
mod guess;
mod harmonic;
mod ladder;
#[cfg(test)]
mod laws;
mod leading_bits;
mod parts;
mod point;
mod radial;
mod ray;
mod real_parameters;
mod root_rounding;
mod sampled;
mod space_direction;
mod truncated;
mod unit_vector;

pub use direction::Direction;
pub(crate) use harmonic::harmonic_point;
pub use harmonic::harmonic_ray;
pub use parts::HomogeneousParts;
#[cfg(test)]
pub(crate) use parts::PartsByDegree;
pub use point::{Ray, Sample};
pub use radial::solve_radial;
pub(crate) use ray::along;
pub use ray::{RaySolver, StageCounts};
pub(crate) use real_parameters::RealParameters;
pub(crate) use sampled::NominalAngles;
pub use sampled::SampledRay;
pub use space_direction::SpaceDirection;
pub(crate) use unit_vector::IntegerVector;
pub use unit_vector::{RationalDirection, UnitVector};
