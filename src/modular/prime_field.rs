//! The integers modulo a prime below 2³¹.

use malachite::base::num::arithmetic::traits::Mod;
use malachite::{Integer, Natural};

use crate::error::Invariant;

/// The integers modulo a prime p < 2³¹. Residues are numbers in [0, p).
///
/// Products of residues fit 62 bits, so sums of products are kept below p² by a conditional
/// subtraction and divided once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PrimeField {
    p: u64,
    square: u64,
}

impl PrimeField {
    /// For a prime below 2³¹.
    pub(crate) fn new(p: u64) -> Self {
        Self { p, square: p * p }
    }

    /// p.
    pub(crate) fn prime(&self) -> u64 {
        self.p
    }

    /// p².
    pub(super) fn square(&self) -> u64 {
        self.square
    }

    pub(crate) fn sum(&self, a: u64, b: u64) -> u64 {
        (a + b) % self.p
    }

    /// a − b.
    pub(crate) fn minus(&self, a: u64, b: u64) -> u64 {
        if a >= b { a - b } else { a + self.p - b }
    }

    pub(crate) fn mul(&self, a: u64, b: u64) -> u64 {
        a * b % self.p
    }

    /// base^exponent.
    pub(crate) fn power(&self, base: u64, mut exponent: u64) -> u64 {
        let (mut result, mut square) = (1, base % self.p);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = self.mul(result, square);
            }
            square = self.mul(square, square);
            exponent >>= 1;
        }
        result
    }

    /// 1, a, a², …: so many powers.
    pub(crate) fn powers(&self, a: u64, count: usize) -> Vec<u64> {
        let mut powers = vec![1; count];
        if let Some(first) = powers.get_mut(1) {
            *first = a;
        }
        for k in 2..count {
            // Shorter chains of products that wait for each other than one by one.
            powers[k] = self.mul(powers[k / 2], powers[k - k / 2]);
        }
        powers
    }

    /// 1/a for a ≠ 0, by Euclid.
    pub(crate) fn inverse(&self, a: u64) -> u64 {
        let (mut r, mut next) = (self.p, a);
        // The cofactors of a, whose signs alternate.
        let (mut t, mut cofactor) = (0, 1);
        let mut negative = false;
        while next > 1 {
            let quotient = r / next;
            (r, next) = (next, r - quotient * next);
            (t, cofactor) = (cofactor, t + quotient * cofactor);
            negative = !negative;
        }
        if negative {
            self.p - cofactor
        } else {
            cofactor
        }
    }

    /// The inverses of the numbers below n ≤ p, with 0 for 0.
    pub(crate) fn inverses(&self, n: usize) -> Vec<u64> {
        let mut inverses = vec![0; n];
        if let Some(one) = inverses.get_mut(1) {
            *one = 1;
        }
        for k in 2..n {
            // p = qk + r, so 1/k = −q/r.
            let (quotient, rest) = (
                self.p / k as u64,
                usize::try_from(self.p % k as u64).invariant("a rest is less than its divisor"),
            );
            inverses[k] = self.mul(self.p - quotient, inverses[rest]);
        }
        inverses
    }

    /// Σ f_i g_i of residues, as far as both go.
    pub(crate) fn dot(&self, f: &[u64], g: &[u64]) -> u64 {
        const HALF: u64 = (1 << 32) - 1;
        // Two sums of halves cannot overflow, and the processor takes several products at once.
        let (mut low, mut high) = (0, 0);
        for (a, b) in f.iter().zip(g) {
            let product = (a & HALF) * (b & HALF);
            low += product & HALF;
            high += product >> 32;
        }
        (high % self.p * ((1 << 32) % self.p) + low) % self.p
    }

    /// The residue of an integer.
    pub(crate) fn reduce_integer(&self, value: &Integer) -> u64 {
        u64::try_from(&value.mod_op(Integer::from(self.p)))
            .invariant("a residue is less than its prime")
    }

    /// The residue of a natural number.
    pub(super) fn reduce_natural(&self, value: &Natural) -> u64 {
        u64::try_from(&(value % Natural::from(self.p)))
            .invariant("a residue is less than its prime")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const P: u64 = 2_147_483_647;

    proptest! {
        #[test]
        fn inverses_are_those_of_fermat(a in 1..P) {
            let field = PrimeField::new(P);
            for a in [a, 1, P - 1] {
                prop_assert_eq!(field.inverse(a), field.power(a, P - 2));
            }
            let n = usize::try_from(a % 100).unwrap() + 2;
            let small = PrimeField::new(101);
            prop_assert_eq!(small.inverses(n)[n - 1], small.power(n as u64 - 1, 99));
        }

        #[test]
        fn sums_and_powers_are_those_made_one_by_one(
            f in prop::collection::vec(0..P, 0..20), g in prop::collection::vec(0..P, 0..20), a in 0..P,
        ) {
            let field = PrimeField::new(P);
            let sum = f.iter().zip(&g).fold(0, |sum, (a, b)| field.sum(sum, field.mul(*a, *b)));
            prop_assert_eq!(field.dot(&f, &g), sum);
            prop_assert_eq!(field.dot(&[P - 1; 4000], &[P - 1; 4000]), 4000);
            for (k, power) in field.powers(a, f.len()).into_iter().enumerate() {
                prop_assert_eq!(power, field.power(a, k as u64));
            }
        }
    }
}
