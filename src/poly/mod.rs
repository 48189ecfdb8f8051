//! Polynomials with exact coefficients.
//!
//! Conventions: the coefficients of univariate polynomials are ascending; the zero polynomial has no degree; a plane polynomial
//! *is* the list of its homogeneous parts; and a binary form of degree d is the univariate polynomial f(1, t) together with d.

mod coordinates;
mod dense;
mod eliminate;
mod evaluate;
mod form;
mod function;
mod gcd;
mod harmonic_basis;
mod homogeneous;
mod operators;
mod plane;
mod resultant;
mod ring;
mod shift;
mod space;
mod sparse;
mod spherical;
mod sqrt;
mod subresultant;
mod terms;
mod ternary;
mod ternary_terms;
mod trig;

pub(crate) use dense::{coefficients, scaled, with_integers};
pub(crate) use eliminate::eliminate;
pub(crate) use evaluate::{integer_sign, leading_value, numerator_at, sign_at_rational};
pub use form::BinaryForm;
pub use function::RationalFunction;
pub(crate) use gcd::primitive_part;
pub(crate) use harmonic_basis::{
    doubled_harmonics, from_harmonic_basis, harmonic_bits, harmonics_of_form, scaled_harmonics,
};
pub(crate) use homogeneous::HomogeneousPolynomial;
pub use plane::PlanePolynomial;
pub(crate) use plane::shift_rational;
pub(crate) use resultant::{resultant, resultant_work};
pub(crate) use shift::negate_odd;
#[cfg(test)]
pub(crate) use shift::shift_classical;
pub use space::SpacePolynomial;
pub use sparse::SparsePolynomial;
pub(crate) use sparse::{term_order, total_degree};
pub(crate) use spherical::{
    NotOnSphere, SphericalPolynomial, harmonics_of_ternary_form, legendre_derivative,
};
pub(crate) use sqrt::polynomial_sqrt;
pub(crate) use subresultant::{Weights, signed_subresultant};
pub(crate) use terms::IntegerTerms;
#[cfg(test)]
pub(crate) use terms::tests::terms as any_integer_terms;
pub use ternary::TernaryForm;
pub(crate) use trig::TrigPolynomial;

// Only the tests and benches of this project use this; it is no part of the public interface.
#[doc(hidden)]
pub use evaluate::sign_at;
#[doc(hidden)]
pub use gcd::{divide_exactly, polynomial_gcd, squarefree_decomposition};
#[doc(hidden)]
pub use harmonic_basis::doubled_form_from_harmonics;
#[doc(hidden)]
pub use malachite::integer_polynomial::IntegerPolynomial;
#[doc(hidden)]
pub use ring::Ring;
#[doc(hidden)]
pub use shift::shift_by_one;
