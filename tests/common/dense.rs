//! Univariate polynomials between malachite's type, in which they are computed with, and the coefficients that the library
//! takes and gives.

use malachite::base::polynomial::Polynomial;
use num_bigint::BigInt;
use stellate::exact::{Rational, integer_from_num, integer_to_num};
use stellate::poly::IntegerPolynomial;

pub(crate) fn rational(f: &IntegerPolynomial) -> Vec<Rational> {
    let coefficients = f.coefficients_asc().iter();
    coefficients
        .map(|c| Rational::from(integer_to_num(c)))
        .collect()
}

/// Of coefficients that are integers.
pub(crate) fn integral(f: &[Rational]) -> IntegerPolynomial {
    let coefficients = f.iter().map(|c| BigInt::try_from(c).unwrap());
    of_integers(&coefficients.collect::<Vec<_>>())
}

pub(crate) fn of_integers(f: &[BigInt]) -> IntegerPolynomial {
    IntegerPolynomial::from_coefficients_asc(f.iter().map(integer_from_num).collect())
}
