//! Polynomials with exact coefficients.
//!
//! Conventions: univariate coefficients are ascending; the zero polynomial has no degree; a plane
//! polynomial *is* its homogeneous parts, and a binary form of degree d is the univariate
//! polynomial f(1, t) together with d.

mod form;
mod plane;
mod ring;
mod shift;
mod sparse;
mod trig;

pub use form::BinaryForm;
pub use malachite::integer_polynomial::IntegerPolynomial;
pub use plane::PlanePolynomial;
pub use ring::Ring;
pub use shift::{shift_by_minus_one, shift_by_one};
pub use sparse::{SparsePolynomial, term_order};
pub use trig::TrigPolynomial;
