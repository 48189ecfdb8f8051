//! The sums of a radius over its odd and its even harmonics, as Theorem 2 squares them.

use crate::bigint::FlatPolynomial;

/// The two sums, times one integer, in the basis z^j w^(d−j): homogeneous of degree N where the parity is that of N, else
/// N − 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct SummedHarmonics {
    /// N.
    pub(super) harmonics: usize,
    /// None for N = 0.
    pub(super) odd: Option<FlatPolynomial>,
    pub(super) even: FlatPolynomial,
    /// The coefficients of each add up to less than 2 to this power.
    pub(super) bits: u64,
}

impl SummedHarmonics {
    /// ⌊N/2+1⌋, the power of ρ that the odd sum is multiplied by.
    pub(super) fn rho_power(&self) -> usize {
        self.harmonics / 2 + 1
    }
}
