//! The operators +, − and · of polynomials.

use super::{BinaryForm, PlanePolynomial, RationalFunction, Ring, SparsePolynomial};

/// Implements sums, differences and products of polynomials as operators between references.
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
