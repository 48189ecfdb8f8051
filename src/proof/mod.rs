//! Checking proof files: documents that state what a run claims, each claim with a witness that makes it a theorem.
//!
//! The checker shares nothing with the programs whose results it checks: it reads JSON and computes with big integers. Every
//! claim has a file of its own here. The page about proof files states the theorems T1 to T8 to which the files refer.

mod arcs;
mod bernstein;
mod checker;
mod clock;
mod cover;
mod distance;
mod factorization;
mod fit_error;
mod forms;
mod identity;
mod irreducible;
mod json;
mod modular;
mod numbers;
mod one_sign;
mod parametric;
mod positive_radius;
mod refusal;
mod root_count;
mod sectors;
mod series;
mod series_equation;
mod side;
mod sparse;
mod tangent;
#[cfg(test)]
mod tests;
mod univariate;

pub use checker::{Count, LONGEST_DOCUMENT, RefusedClaim, Report, check};
pub use refusal::Refusal;

/// The same checker as a program in Python 3.10 or newer, which needs the standard library alone.
pub const PYTHON_CHECKER: &str = include_str!("checker.py");
