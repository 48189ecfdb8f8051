//! Values of forms at polynomials.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use crate::poly::{BinaryForm, IntegerPolynomial};

/// The constant polynomial c.
pub(super) fn constant(c: impl Into<Integer>) -> IntegerPolynomial {
    IntegerPolynomial::from_coefficients_asc(vec![c.into()])
}

/// The power f^k.
pub(super) fn power(f: &IntegerPolynomial, k: usize) -> IntegerPolynomial {
    (0..k).fold(constant(1), |product, _| product * f)
}

/// The polynomial form(a(t), b(t)), by Horner's rule. Cost: 2d products of polynomials.
pub(super) fn form_at(form: &BinaryForm, [a, b]: &[IntegerPolynomial; 2]) -> IntegerPolynomial {
    let mut value = IntegerPolynomial::ZERO;
    let mut a_power = constant(1);
    for k in (0..=form.degree()).rev() {
        value = value * b + &a_power * constant(form.coefficient(k));
        if k > 0 {
            a_power *= a;
        }
    }
    value
}
