//! Chinese remainders for many short primes at once.
//!
//! Lemma. Let P be the product of the moduli m, x an integer with |x| < P/4, and y ≡ x (P/m)^(−1) in [0, m). Then x = Σ y P/m − qP,
//! where q is the integer nearest to the sum of fl(y/m) in doubles.
//! Proof. Σ y P/m is congruent to x modulo each m, so Σ y/m = q + x/P for an integer q; below 2^16 terms of at most 1 have errors of
//! at most 2^-53, and their sums below 2^16 of 2^-37 each: less than 1/4 together.
//! Law: `integers_are_those_whose_residues_they_are`.

use malachite::base::num::arithmetic::traits::{AddMulAssign, DivExact};
use malachite::base::num::basic::traits::Zero;
use malachite::{Integer, Natural};

use super::PrimeField;
use super::short::{BITS_OF_TEN_PRIMES, FourFields};
use crate::error::Invariant;

/// A pair of primes p, q, and what is the same for all integers.
#[derive(Debug)]
struct Modulus {
    fields: [PrimeField; 2],
    /// The inverse of p modulo q.
    inverse: u64,
    /// The inverse of P/m modulo m.
    weight: u64,
    /// The number P/m.
    cofactor: Natural,
}

impl Modulus {
    fn value(&self) -> u64 {
        self.fields[0].prime() * self.fields[1].prime()
    }

    /// The number in [0, m) with these residues modulo p and q.
    fn combined(&self, [a, b]: [u64; 2]) -> u64 {
        let [p, q] = &self.fields;
        let difference = q.minus(b, a % q.prime());
        a + p.prime() * q.mul(difference, self.inverse)
    }
}

/// The reconstruction of integers from residues modulo given primes.
#[derive(Debug)]
pub(crate) struct ShortRemainders {
    moduli: Vec<Modulus>,
    product: Natural,
}

/// The number of times four primes that are enough for integers of absolute value below 2^`bits`.
pub(crate) fn fours_for(bits: u64) -> usize {
    let tens = (10 * (bits + 2)).div_ceil(BITS_OF_TEN_PRIMES);
    usize::try_from(tens.div_ceil(4)).invariant("numbers of bits are lengths in memory")
}

impl ShortRemainders {
    pub(crate) fn new(fields: &[FourFields]) -> Self {
        let primes: Vec<u64> = fields.iter().flat_map(FourFields::primes).collect();
        let pairs = primes.as_chunks::<2>().0;
        let product: Natural = pairs.iter().map(|[p, q]| Natural::from(p * q)).product();
        let moduli = pairs.iter().map(|pair| {
            let fields = pair.map(PrimeField::new);
            let [p, q] = &fields;
            let mut modulus = Modulus {
                fields,
                inverse: q.inverse(p.prime() % q.prime()),
                weight: 0,
                cofactor: (&product).div_exact(Natural::from(p.prime() * q.prime())),
            };
            let weights =
                fields.map(|field| field.inverse(field.reduce_natural(&modulus.cofactor)));
            modulus.weight = modulus.combined(weights);
            modulus
        });
        Self {
            moduli: moduli.collect(),
            product,
        }
    }

    /// The integer with these residues in [0, p), in the order of the primes, if its absolute value is below a quarter of their
    /// product.
    #[expect(clippy::cast_precision_loss, reason = "numbers below 2^50 are doubles")]
    pub(crate) fn integer(&self, residues: &[u64]) -> Integer {
        let mut sum = Natural::ZERO;
        let mut fractions = 0.0;
        for (modulus, residues) in self.moduli.iter().zip(residues.as_chunks::<2>().0) {
            let m = modulus.value();
            let x = modulus.combined(*residues);
            let y = u128::from(x) * u128::from(modulus.weight) % u128::from(m);
            let y = u64::try_from(y).invariant("a residue is less than its modulus");
            fractions += y as f64 / m as f64;
            sum.add_mul_assign(&modulus.cofactor, Natural::from(y));
        }
        let quotient = Natural::try_from(fractions.round_ties_even());
        let quotient = quotient.invariant("a sum of fractions is not negative");
        Integer::from(sum) - Integer::from(quotient * &self.product)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modular::short::four_fields;
    use malachite::base::num::arithmetic::traits::Pow;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn integers_are_those_whose_residues_they_are(bits in 0u64..2000, off in -3i64..4, part in 1i64..100) {
            let fields = four_fields(fours_for(bits), |_| true).unwrap();
            let remainders = ShortRemainders::new(&fields);
            prop_assert!(remainders.product > Natural::from(4u32) << bits);
            let largest = Integer::from(2).pow(bits) - Integer::from(1);
            let values = [largest.clone(), -&largest, &largest / Integer::from(part) + Integer::from(off), Integer::from(off)];
            for value in values {
                if value >= -&largest && value <= largest {
                    let primes = fields.iter().flat_map(FourFields::primes);
                    let residues: Vec<u64> = primes.map(|p| PrimeField::new(p).reduce_integer(&value)).collect();
                    prop_assert_eq!(remainders.integer(&residues), value);
                }
            }
        }
    }
}
