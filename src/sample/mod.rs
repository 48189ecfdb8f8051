//! Certified points on a curve: a float says where to look, exact arithmetic says what is true.

mod direction;
mod guess;
mod ray;
mod superquadric;

pub use direction::Direction;
pub use ray::{Ray, RaySolver, Sample};
pub use superquadric::{MAX_ROOT_BITS, SuperquadricSolver};
