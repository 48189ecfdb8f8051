//! The operations that Theorem 2 needs for its coefficients.

/// A commutative ring, in which the odd powers of r are squared away: forms with integer coefficients in general, and
/// polynomials in symbols K0, K1, … to reproduce Appendix B.
pub trait Ring: Clone {
    /// The sum self + other.
    #[must_use]
    fn plus(&self, other: &Self) -> Self;
    /// The difference self − other.
    #[must_use]
    fn minus(&self, other: &Self) -> Self;
    /// The product self · other.
    #[must_use]
    fn times(&self, other: &Self) -> Self;
    /// The square self².
    #[must_use]
    fn squared(&self) -> Self {
        self.times(self)
    }
}
