//! Exact numbers: rational numbers and dyadic numbers, with reading, rounding and printing.
//!
//! [`Rational`] is the exact number of the public interface: an integer is a rational number with denominator 1. The library
//! computes with malachite's integers; its functions take and return the types of `num-bigint` and `num-rational`.

mod angle;
mod cosine;
mod dyadic;
mod literal;
mod rational;
mod rounding;
mod written_angle;

pub use literal::exact_literal;
pub use rational::{NotANumber, NotAnInteger, Rational};
pub(crate) use rounding::nearest_double;
pub use written_angle::WrittenAngle;

// Only the tests and benches of this project use these; they are no part of the public interface.
#[doc(hidden)]
pub use angle::{arctangent, pi};
#[doc(hidden)]
pub use cosine::cosine_and_sine;
#[doc(hidden)]
pub use dyadic::Dyadic;
#[doc(hidden)]
pub use literal::{double_literal, hex_literal};
#[doc(hidden)]
pub use rational::{integer_from_num, integer_to_num};
