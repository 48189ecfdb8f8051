//! The integers modulo a prime below 2³¹.

use malachite::base::num::arithmetic::traits::Mod;
use malachite::{Integer, Natural};

use crate::error::Invariant;

/// The integers modulo a prime p < 2³¹. Residues are numbers in [0, p).
///
/// Products of residues have at most 62 bits. So sums of products are kept below p² by conditional subtractions and reduced
/// once at the end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PrimeField {
    p: u64,
    square: u64,
}

impl PrimeField {
    /// The field for a prime below 2³¹.
    pub(crate) fn new(p: u64) -> Self {
        Self { p, square: p * p }
    }

    /// The prime p.
    pub(crate) fn prime(&self) -> u64 {
        self.p
    }

    /// The number p².
    pub(super) fn square(&self) -> u64 {
        self.square
    }

    pub(crate) fn sum(&self, a: u64, b: u64) -> u64 {
        (a + b) % self.p
    }

    /// The difference a − b.
    pub(crate) fn minus(&self, a: u64, b: u64) -> u64 {
        if a >= b { a - b } else { a + self.p - b }
    }

    pub(crate) fn mul(&self, a: u64, b: u64) -> u64 {
        a * b % self.p
    }

    /// The power base^exponent.
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

    /// The first `count` of the powers 1, a, a², ….
    pub(crate) fn powers(&self, a: u64, count: usize) -> Vec<u64> {
        let mut powers = vec![1; count];
        if let Some(first) = powers.get_mut(1) {
            *first = a;
        }
        for k in 2..count {
            // The products depend on each other in shorter chains than if each power were computed from the one before.
            powers[k] = self.mul(powers[k / 2], powers[k - k / 2]);
        }
        powers
    }

    /// The inverse 1/a of a ≠ 0, by Euclid's algorithm.
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

    /// The inverses of all numbers below n ≤ p; the entry of 0 is 0.
    pub(crate) fn inverses(&self, n: usize) -> Vec<u64> {
        let mut inverses = vec![0; n];
        if let Some(one) = inverses.get_mut(1) {
            *one = 1;
        }
        for k in 2..n {
            // If p = qk + r, 1/k = −q/r.
            let (quotient, rest) = (
                self.p / k as u64,
                usize::try_from(self.p % k as u64).invariant("a rest is less than its divisor"),
            );
            inverses[k] = self.mul(self.p - quotient, inverses[rest]);
        }
        inverses
    }

    /// The sum Σ f_i g_i of products of residues, up to the length of the shorter list.
    pub(crate) fn dot(&self, f: &[u64], g: &[u64]) -> u64 {
        const HALF: u64 = (1 << 32) - 1;
        // Two sums, of the lower and the upper halves of the products, cannot overflow, and the processor computes several
        // products at once.
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
