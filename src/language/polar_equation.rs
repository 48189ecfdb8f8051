//! The equation of a polar curve that is given by a power of its radius.

use crate::exact::Rational;
use crate::poly::PlanePolynomial;

/// What is known of the radius of `r^k = formula`, and the polynomial that is 0 on the curve.
pub(super) struct PolarEquation {
    pub(super) polynomial: PlanePolynomial,
    /// Whether r^k is 0 at some angle, and whether it is infinite at some angle.
    pub(super) has_zero: bool,
    pub(super) has_pole: bool,
    /// The sign of r^k at an angle at which it is neither.
    pub(super) sign: i8,
}

/// x² + y²
pub(super) fn rho() -> PlanePolynomial {
    PlanePolynomial::from_terms([((2, 0), Rational::one()), ((0, 2), Rational::one())])
}

/// The quotient f/(x² + y²), if it is a polynomial.
pub(super) fn divided_by_rho(f: &PlanePolynomial) -> Option<PlanePolynomial> {
    f.parts().map(|part| part.divided_by_rho()).collect()
}
