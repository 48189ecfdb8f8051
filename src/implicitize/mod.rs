//! Parametric → implicit (§2 of the paper).

mod theorem2;

pub use theorem2::{Parts, SquaredForm, parity_sums, square_away};
