//! Arithmetic modulo primes and their powers: residues, polynomials, kernels of matrices, Chinese remainders.

mod factors;
mod hensel;
mod kernel;
mod prime_field;
mod residue;
mod truncated;

pub(crate) use factors::{distinct_degrees, equal_degree};
pub(crate) use hensel::lift;
pub(crate) use kernel::{Kernel, Reconstruction, Span, kernel, kernel_primes};
pub(crate) use prime_field::PrimeField;
pub(crate) use residue::{
    ABOVE_PRIMES, Images, SplitMix, dot_mod, gcd_mod, interpolate, inverse_mod, inverses_mod,
    mul_mod, power_mod, powers_mod, previous_prime, reduce_integer,
};
pub(crate) use truncated::{TruncatedRing, balanced};
