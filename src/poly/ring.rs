//! The little that Theorem 2 asks of its coefficients, and the same as operators.

use super::{BinaryForm, PlanePolynomial, RationalFunction, SparsePolynomial};

/// A commutative ring, as far as squaring away the odd powers of r needs one: forms with integer
/// coefficients in production, polynomials in symbols K0, K1, … when Appendix B is reproduced.
pub trait Ring: Clone {
    /// self + other.
    #[must_use]
    fn plus(&self, other: &Self) -> Self;
    /// self − other.
    #[must_use]
    fn minus(&self, other: &Self) -> Self;
    /// self · other.
    #[must_use]
    fn times(&self, other: &Self) -> Self;
    /// self².
    #[must_use]
    fn squared(&self) -> Self {
        self.times(self)
    }
}

/// Sums, differences and products of polynomials as operators between references.
macro_rules! operators {
    ($type:ty $(, const $v:ident)?) => {
        impl$(<const $v: usize>)? std::ops::Add for &$type {
            type Output = $type;
            fn add(self, other: Self) -> $type {
                self.plus(other)
            }
        }
        impl$(<const $v: usize>)? std::ops::Sub for &$type {
            type Output = $type;
            fn sub(self, other: Self) -> $type {
                self.minus(other)
            }
        }
        impl$(<const $v: usize>)? std::ops::Mul for &$type {
            type Output = $type;
            fn mul(self, other: Self) -> $type {
                self.times(other)
            }
        }
    };
}

operators!(BinaryForm);
operators!(PlanePolynomial);
operators!(RationalFunction);
operators!(SparsePolynomial<V>, const V);
