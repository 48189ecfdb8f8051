//! Polynomials with exact coefficients.
//!
//! Conventions: univariate coefficients are ascending; the zero polynomial has no degree; a plane
//! polynomial *is* its homogeneous parts, and a binary form of degree d is the univariate
//! polynomial f(1, t) together with d.

mod all_roots;
mod binomials;
mod bounded;
mod circle;
mod eliminate;
mod evaluate;
mod flat;
mod form;
mod form_size;
mod function;
mod gcd;
mod homogeneous;
mod isolate;
mod kernel;
mod limbs;
mod mobius;
mod modular;
mod pair;
mod plane;
mod prime_field;
mod residues;
mod resultant;
mod ring;
mod root_sign;
mod roots;
mod shift;
mod space;
mod sparse;
mod sqrt;
mod subresultant;
mod ternary;
mod trig;

pub use all_roots::real_roots;
pub(crate) use all_roots::sort_distinct;
pub(crate) use binomials::binomials;
#[cfg(test)]
pub(crate) use bounded::Draw;
pub(crate) use bounded::{
    BoundedRoot, Coefficients, FOR_DOUBLES, ScaledBall, UnitBall, UnitBalls, Unproved, roots_of,
    rotations,
};
pub use circle::{doubled_form_from_harmonics, harmonics_of_form};
pub(crate) use circle::{doubled_harmonics, flat_form, harmonic_bits, scaled_harmonics};
pub(crate) use eliminate::{eliminate, resultant_mod};
pub(crate) use evaluate::integer_sign;
pub use evaluate::{numerator_at, sign_at, sign_at_rational};
pub(crate) use flat::{FlatPolynomial, Place};
pub use form::BinaryForm;
pub(crate) use form_size::{FormSize, form_bits};
pub use function::RationalFunction;
pub use gcd::{divide_exactly, polynomial_gcd, primitive_part, squarefree_decomposition};
pub use homogeneous::Form;
pub(crate) use kernel::{Kernel, Reconstruction, Span, kernel, kernel_primes};
pub use malachite::integer_polynomial::IntegerPolynomial;
#[cfg(test)]
pub(crate) use mobius::tests::bounded_integer;
pub(crate) use modular::{
    Images, SplitMix, dot_mod, gcd_mod, interpolate, inverse_mod, power_mod, powers_mod,
    reduce_integer,
};
pub use plane::PlanePolynomial;
pub(crate) use prime_field::PrimeField;
pub(crate) use residues::{
    Bases, Lifting, Quad, Quartet, Residues, Sizes, for_each_quartet, minus, plus, value_of_form,
    value_of_integers, value_of_rho,
};
pub(crate) use resultant::resultant;
pub use ring::Ring;
pub(crate) use root_sign::constant_sign;
pub use roots::RealRoot;
pub(crate) use shift::negate_odd;
pub use shift::{shift_by_minus_one, shift_by_one};
pub use space::SpacePolynomial;
pub use sparse::{SparsePolynomial, term_order, total_degree};
pub use sqrt::polynomial_sqrt;
pub(crate) use subresultant::{Weights, determinant, signed_subresultant};
pub use ternary::TernaryForm;
pub use trig::TrigPolynomial;
