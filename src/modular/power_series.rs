//! Polynomials in x over (Z/M)[y, z]/(y^K, z^L), packed into univariate polynomials.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Mod;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::{MulPowerOfX, Polynomial};
use malachite::integer_polynomial::IntegerPolynomial;

use super::PrimeField;
use crate::error::Invariant;

/// The ring R = (Z/M)[y, z]/(y^K, z^L), with the arithmetic of polynomials in x over R.
///
/// A polynomial is packed by Kronecker substitution: the coefficient of `x^i z^l y^j` is at the index `(i(2L−1) + l)(2K−1) +
/// j`, so a product is one fast product of univariate polynomials. For K = L = 1 the ring is Z/M itself.
#[derive(Clone, Debug)]
pub(crate) struct TruncatedRing {
    pub(crate) modulus: Integer,
    /// The precision K in y.
    pub(crate) y: usize,
    /// The precision L in z.
    pub(crate) z: usize,
}

impl TruncatedRing {
    /// The distance between the indices of neighbouring powers of z.
    pub(crate) fn row(&self) -> usize {
        2 * self.y - 1
    }

    /// The distance between the indices of neighbouring powers of x.
    pub(crate) fn block(&self) -> usize {
        (2 * self.z - 1) * self.row()
    }

    /// The exponents (j, l) of y and z at an offset within a block; `None` if such terms are truncated.
    pub(crate) fn exponents(&self, offset: usize) -> Option<(usize, usize)> {
        let (j, l) = (offset % self.row(), offset / self.row() % (2 * self.z - 1));
        (j < self.y && l < self.z).then_some((j, l))
    }

    /// The residue in [0, M).
    pub(crate) fn reduced(&self, c: Integer) -> Integer {
        if c >= 0 && c < self.modulus {
            c
        } else {
            c.mod_op(&self.modulus)
        }
    }

    /// Truncates powers and reduces coefficients.
    pub(crate) fn normalize(&self, f: IntegerPolynomial) -> IntegerPolynomial {
        let mut coefficients = f.into_coefficients_asc();
        let scalar = self.block() == 1;
        for (k, c) in coefficients.iter_mut().enumerate() {
            if scalar || self.exponents(k).is_some() {
                *c = self.reduced(std::mem::take(c));
            } else {
                *c = Integer::ZERO;
            }
        }
        IntegerPolynomial::from_coefficients_asc(coefficients)
    }

    pub(crate) fn product(
        &self,
        f: &IntegerPolynomial,
        g: &IntegerPolynomial,
    ) -> IntegerPolynomial {
        self.normalize(f * g)
    }

    pub(crate) fn sum(&self, f: &IntegerPolynomial, g: &IntegerPolynomial) -> IntegerPolynomial {
        self.normalize(f + g)
    }

    pub(crate) fn difference(
        &self,
        f: &IntegerPolynomial,
        g: &IntegerPolynomial,
    ) -> IntegerPolynomial {
        self.normalize(f - g)
    }

    /// The product of all factors.
    pub(crate) fn product_of(&self, factors: &[IntegerPolynomial]) -> IntegerPolynomial {
        match factors {
            [] => IntegerPolynomial::one(),
            [one] => one.clone(),
            more => {
                let (left, right) = more.split_at(more.len() / 2);
                self.product(&self.product_of(left), &self.product_of(right))
            }
        }
    }

    /// The degree in x; 0 for the polynomial 0.
    pub(crate) fn degree(&self, f: &IntegerPolynomial) -> usize {
        f.coefficients_asc().len().saturating_sub(1) / self.block()
    }

    /// The remainder of f modulo g, which must be monic in x.
    pub(crate) fn remainder(
        &self,
        f: &IntegerPolynomial,
        g: &IntegerPolynomial,
    ) -> IntegerPolynomial {
        let (block, degree) = (self.block(), self.degree(g));
        let mut rest = f.coefficients_asc().to_vec();
        let low = &g.coefficients_asc()[..degree * block];
        let low_polynomial = IntegerPolynomial::from_coefficients_asc(low.to_vec());
        for top in (degree..=self.degree(f)).rev() {
            let at = (top - degree) * block;
            let quotient = IntegerPolynomial::from_coefficients_asc(rest.split_off(top * block));
            let quotient = self.normalize(quotient);
            if block == 1 {
                if let Some(q) = quotient.coefficients_asc().first() {
                    for (slot, c) in rest[at..].iter_mut().zip(low) {
                        *slot -= c * q;
                    }
                }
                continue;
            }
            let product = &low_polynomial * quotient;
            for (k, c) in product.into_coefficients_asc().into_iter().enumerate() {
                if c != 0 && self.exponents(k).is_some() {
                    rest[at + k] -= c;
                }
            }
        }
        self.normalize(IntegerPolynomial::from_coefficients_asc(rest))
    }

    /// Converts f from another such ring. Exponents and coefficients are truncated to those of both rings.
    pub(crate) fn convert(&self, from: &Self, f: &IntegerPolynomial) -> IntegerPolynomial {
        if from.y == self.y && from.z == self.z {
            return self.normalize(f.clone());
        }
        let mut coefficients = vec![Integer::ZERO; (from.degree(f) + 1) * self.block()];
        for (k, c) in f.coefficients_asc().iter().enumerate() {
            if let Some((j, l)) = from.exponents(k)
                && j < self.y
                && l < self.z
            {
                let at = k / from.block() * self.block() + l * self.row() + j;
                coefficients[at] = self.reduced(c.clone());
            }
        }
        IntegerPolynomial::from_coefficients_asc(coefficients)
    }

    /// The inverse 1/u of an element u of R, by Newton's iteration. The constant term of u must be invertible modulo the prime
    /// of which M is a power.
    pub(crate) fn inverse(&self, u: &IntegerPolynomial, field: &PrimeField) -> IntegerPolynomial {
        let constant = u
            .coefficients_asc()
            .first()
            .map(|c| field.reduce_integer(c))
            .invariant("a unit has a constant term");
        let start = Integer::from(field.inverse(constant));
        let mut inverse = IntegerPolynomial::from_coefficients_asc(vec![start]);
        let one = IntegerPolynomial::one();
        loop {
            let error = self.difference(&one, &self.product(u, &inverse));
            if error.coefficients_asc().is_empty() {
                return inverse;
            }
            inverse = self.sum(&inverse, &self.product(&inverse, &error));
        }
    }

    /// The leading coefficient in x.
    pub(crate) fn lead(&self, f: &IntegerPolynomial) -> IntegerPolynomial {
        let at = self.degree(f) * self.block();
        IntegerPolynomial::from_coefficients_asc(f.coefficients_asc()[at..].to_vec())
    }

    /// The quotient of f and its leading coefficient in x, which must be a unit of R.
    pub(crate) fn monic(&self, f: &IntegerPolynomial, field: &PrimeField) -> IntegerPolynomial {
        let degree = self.degree(f);
        let inverse = self.inverse(&self.lead(f), field);
        let at = degree * self.block();
        let low = IntegerPolynomial::from_coefficients_asc(f.coefficients_asc()[..at].to_vec());
        let lead = IntegerPolynomial::from_coefficients_asc(vec![Integer::ONE]);
        self.product(&low, &inverse) + lead.mul_power_of_x(at as u64)
    }
}

/// The representative of least absolute value of a residue.
pub(crate) fn balanced(residue: &Integer, modulus: &Integer) -> Integer {
    if residue << 1u64 > *modulus {
        residue - modulus
    } else {
        residue.clone()
    }
}
