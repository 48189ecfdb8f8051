//! Certified points on a curve: a float says where to look, exact arithmetic says what is true.

mod direction;
mod guess;
mod ray;

pub use direction::Direction;
pub use ray::{Ray, RaySolver, Sample};
