//! Exact numbers: integers and rationals, how they are read, rounded and printed.
//!
//! [`Integer`] is malachite's; [`Rational`] wraps malachite's so that the types of `num-bigint` and
//! `num-rational` convert to and from it.

mod angle;
mod cosine;
mod dyadic;
mod literal;
mod rational;
mod rounding;

pub use angle::{arctangent, pi};
pub use cosine::cosine_and_sine;
pub use dyadic::Dyadic;
pub use literal::{double_literal, exact_literal, hex_literal};
pub use malachite::Integer;
pub use rational::{NotANumber, NotAnInteger, Rational};
pub(crate) use rounding::nearest_double;
