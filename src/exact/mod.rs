//! Exact numbers: integers and rationals, how they are read, rounded and printed.
//!
//! [`Rational`] is the one exact number that users see: an integer is a rational number with denominator 1. Inside, integers
//! are malachite's; what goes in and out of the library are the types of `num-bigint` and `num-rational`.

mod angle;
mod cosine;
mod dyadic;
mod literal;
mod rational;
mod rounding;

pub use literal::exact_literal;
pub use rational::{NotANumber, NotAnInteger, Rational};
pub(crate) use rounding::nearest_double;

// For the tests and benches of this project; no part of what the library promises.
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
