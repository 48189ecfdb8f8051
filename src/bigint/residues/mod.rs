//! Long polynomials with integer coefficients, by their residues modulo many primes of 50 bits.
//!
//! If a result is bounded by B, its residues modulo primes with a product above 2B determine it. Modulo a prime all steps of a
//! long computation are cheap, because no number grows. Residues are doubles, for four primes side by side ([`lanes`],
//! [`quartet`]). Products of polynomials are products of values at roots of unity ([`transform`]), and so is a change of basis
//! ([`shift`]). The last step ([`lifting`]) is one sum of large integers for each coefficient ([`chinese`]); it is computed
//! directly or, for many primes, by transforms ([`blocks`]). The result is checked at one more point modulo one more prime
//! ([`one_more_prime`]).
//!
//! Each file numbers the lemmas that bound its numbers. Bounds of residues are multiples of their prime: "at most 2p" means |a|
//! ≤ 2p.

mod blocks;
mod chinese;
mod lanes;
mod lifting;
mod one_more_prime;
mod primes;
mod quartet;
mod shift;
mod transform;

pub(crate) use lanes::{Lanes, minus, plus};
pub(crate) use lifting::{Lifting, Residues, Sizes};
pub(crate) use one_more_prime::{value_of_form, value_of_integers, value_of_rho};
pub(crate) use quartet::{Quartet, for_each_quartet};
pub(crate) use shift::{Bases, changed_by_residues};
