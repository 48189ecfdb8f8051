//! Arithmetic modulo primes below 2³¹ and their powers: fields, polynomials, linear algebra, Chinese remainders, factorization
//! and lifting.
//!
//! There is one arithmetic: [`PrimeField`] has the operations on residues and, in `polynomial.rs`, the operations on
//! polynomials, which are ascending lists of residues.

mod factors;
mod hensel;
mod images;
mod linear;
mod polynomial;
mod power_series;
mod prime_field;
mod primes;
mod random;
mod reconstruction;
mod short;
mod short_remainders;

pub(crate) use factors::{distinct_degrees, equal_degree, is_irreducible};
pub(crate) use hensel::lift;
pub(crate) use images::Images;
pub(crate) use linear::{Kernel, Span, determinant, kernel};
pub(crate) use polynomial::trimmed;
pub(crate) use power_series::{TruncatedRing, balanced};
pub(crate) use prime_field::PrimeField;
pub(crate) use primes::large_primes;
pub(crate) use random::SplitMix;
pub(crate) use reconstruction::Reconstruction;
pub(crate) use short::{Four, FourFields, four_fields, imaginary_unit, multiplied, negated};
pub(crate) use short_remainders::{ShortRemainders, fours_for};
