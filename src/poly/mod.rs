//! Polynomials with exact coefficients.
//!
//! Conventions: univariate coefficients are ascending; the zero polynomial has no degree; a plane
//! polynomial *is* its homogeneous parts, and a binary form of degree d is the univariate
//! polynomial f(1, t) together with d.

mod eliminate;
mod evaluate;
mod form;
mod function;
mod gcd;
mod harmonic_basis;
mod homogeneous;
mod plane;
mod resultant;
mod ring;
mod shift;
mod space;
mod sparse;
mod sqrt;
mod subresultant;
mod terms;
mod ternary;
mod ternary_terms;
mod trig;

pub(crate) use eliminate::eliminate;
pub(crate) use evaluate::{integer_sign, leading_value};
pub use evaluate::{numerator_at, sign_at, sign_at_rational};
pub use form::BinaryForm;
pub use function::RationalFunction;
pub use gcd::{divide_exactly, polynomial_gcd, primitive_part, squarefree_decomposition};
pub use harmonic_basis::{doubled_form_from_harmonics, harmonics_of_form};
pub(crate) use harmonic_basis::{
    doubled_harmonics, from_harmonic_basis, harmonic_bits, scaled_harmonics,
};
pub use homogeneous::HomogeneousPolynomial;
pub use malachite::integer_polynomial::IntegerPolynomial;
pub use plane::PlanePolynomial;
pub(crate) use resultant::resultant;
pub use ring::Ring;
pub(crate) use shift::negate_odd;
#[cfg(test)]
pub(crate) use shift::shift_classical;
pub use shift::{shift_by_minus_one, shift_by_one};
pub use space::SpacePolynomial;
pub use sparse::{SparsePolynomial, term_order, total_degree};
pub use sqrt::polynomial_sqrt;
pub(crate) use subresultant::{Weights, signed_subresultant};
pub(crate) use terms::IntegerTerms;
#[cfg(test)]
pub(crate) use terms::tests::terms as any_integer_terms;
pub use ternary::TernaryForm;
pub use trig::TrigPolynomial;
