//! The sums of a radius over its odd and over its even harmonics, which Theorem 2 squares.

use crate::bigint::FlatPolynomial;

/// The two sums, multiplied by one integer, in the basis z^j w^(d−j). The sum whose parity is that of N is homogeneous of
/// degree N, the other one of degree N − 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct SummedHarmonics {
    /// The number of harmonics N.
    pub(super) harmonics: usize,
    /// The sum over the odd harmonics; `None` for N = 0.
    pub(super) odd: Option<FlatPolynomial>,
    pub(super) even: FlatPolynomial,
    /// The absolute values of the coefficients of each sum add up to less than 2 to this power.
    pub(super) bits: u64,
}

impl SummedHarmonics {
    /// The power ⌊N/2+1⌋ of ρ by which the odd sum is multiplied.
    pub(super) fn rho_power(&self) -> usize {
        self.harmonics / 2 + 1
    }
}
