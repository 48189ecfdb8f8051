//! Fast arithmetic of integers: limbs, flat polynomials, residues modulo many primes, and long numbers in decimal.
//!
//! All results are exact: they are the integers that ordinary arithmetic gives, and laws compare the two.

mod binomials;
mod columns;
mod content;
mod decimal;
mod flat;
mod form_size;
mod limbs;
mod machine;
mod mobius;
mod residues;
mod whole;

pub(crate) use binomials::binomials;
pub(crate) use columns::{
    Columns, DIGIT_BITS, Sums, digits, digits_for, digits_of_bits, halves_of_product,
};
pub(crate) use content::content;
pub(crate) use decimal::{Decimal, append_decimal};
pub(crate) use flat::{FlatPolynomial, Target};
pub(crate) use form_size::{FormSize, form_bits};
pub(crate) use limbs::{negate, sign_limb, widen};
pub(crate) use machine::Machine;
#[cfg(test)]
pub(crate) use mobius::tests::bounded_integer;
pub(crate) use mobius::{ShiftByOne, change_of_basis};
pub(crate) use residues::{
    Bases, Lanes, Lifting, Quartet, Residues, Sizes, for_each_quartet, minus, plus, value_of_form,
    value_of_integers, value_of_rho,
};
pub(crate) use whole::{f64_from, u64_from};
