//! Exact numbers: integers and rationals, how they are read, rounded and printed.
//!
//! [`Integer`] is malachite's; [`Rational`] wraps malachite's so that the types of `num-bigint` and
//! `num-rational` convert to and from it.

mod angle;
mod circle;
mod columns;
mod decimal;
mod dyadic;
mod literal;
mod machine;
mod rational;
mod rounding;
mod whole;

pub use angle::{arctangent, pi};
pub use circle::cosine_and_sine;
pub(crate) use columns::{
    Columns, DIGIT_BITS, Sums, digits, digits_for, digits_of_bits, halves_of_product,
};
pub(crate) use decimal::append_decimal;
pub use dyadic::Dyadic;
pub use literal::{double_literal, exact_literal, hex_literal};
pub(crate) use machine::Machine;
pub use malachite::Integer;
pub use rational::{NotANumber, NotAnInteger, Rational};
pub(crate) use rounding::nearest_double;
pub(crate) use whole::{f64_from, u64_from};
