//! Text of numbers, polynomials and functions of parameters, in the notations of people and of other programs.

mod coordinates;
mod format;
mod in_order;
mod powers;
mod terms;

pub use coordinates::Coordinates;
pub(crate) use coordinates::NAMES;
pub use format::Format;
pub(crate) use in_order::write_in_order;
pub(crate) use terms::{Notation, Number, append_word, polynomial_text};
