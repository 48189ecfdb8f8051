//! The little that Theorem 2 asks of its coefficients.

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
