//! Long polynomials with integer coefficients by their residues modulo many primes of 50 bits.
//!
//! Where a result is bounded by B, residues modulo primes with a product above 2B determine it, and modulo a prime all
//! steps of a long computation are cheap: no number grows. Residues are held in doubles, four primes side by side
//! ([`lanes`], [`quartet`]); products are products of values at roots of unity ([`transform`]), and so is a change of basis
//! ([`shift`]); the end ([`lifting`]) is one sum of large integers for each coefficient ([`chinese`]), formed as it stands or,
//! for many primes, by transforms again ([`blocks`]). What was lifted is compared with what it should be at one more point
//! modulo one more prime ([`one_more_prime`]).
//!
//! Bounds are lemmas, numbered in each file. Sizes of residues are given as multiples of their prime: "at most 2p" is |a| ≤ 2p.

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
