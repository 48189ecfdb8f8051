//! Chinese remainders: integers are computed from their residues modulo more and more primes.

use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;
use malachite::integer_polynomial::IntegerPolynomial;
use malachite::{Integer, Natural};

use super::PrimeField;

/// The residues of one polynomial modulo a growing product of primes.
pub(crate) struct Images {
    pub(crate) residues: Vec<Natural>,
    pub(crate) modulus: Natural,
}

impl Images {
    /// The residues of `len` coefficients modulo 1, which determine nothing.
    pub(crate) fn unknown(len: usize) -> Self {
        Self {
            residues: vec![Natural::ZERO; len],
            modulus: Natural::ONE,
        }
    }

    /// The residues modulo one prime.
    pub(crate) fn new(image: &[u64], prime: u64) -> Self {
        Self {
            residues: image.iter().map(|&c| Natural::from(c)).collect(),
            modulus: Natural::from(prime),
        }
    }

    /// Adds the residues modulo another prime. Returns whether the balanced values remain unchanged.
    pub(crate) fn add(&mut self, image: &[u64], prime: u64) -> bool {
        let same = self.has_image(image, prime);
        self.push(image, prime);
        same
    }

    /// Whether the balanced values have these residues modulo a prime.
    ///
    /// Lemma 2. If they do, [`Images::push`] of this image changes no balanced value; if not, it changes one.
    /// Proof. The new value is the only number of absolute value at most half the new modulus that has all the residues. The
    /// old value is such a number exactly if it has the new residue.
    /// Law: `an_image_that_agrees_changes_nothing`.
    fn has_image(&self, image: &[u64], prime: u64) -> bool {
        let field = PrimeField::new(prime);
        let half = &self.modulus >> 1u64;
        let modulus = field.reduce_natural(&self.modulus);
        self.residues.iter().zip(image).all(|(residue, &c)| {
            let above = if *residue > half { modulus } else { 0 };
            field.reduce_natural(residue) == field.sum(c, above)
        })
    }

    /// Adds the residues modulo another prime.
    pub(crate) fn push(&mut self, image: &[u64], prime: u64) {
        let field = PrimeField::new(prime);
        let inverse = field.inverse(field.reduce_natural(&self.modulus));
        for (residue, &c) in self.residues.iter_mut().zip(image) {
            let more = field.minus(c, field.reduce_natural(residue));
            *residue += &self.modulus * Natural::from(field.mul(more, inverse));
        }
        self.modulus *= Natural::from(prime);
    }

    /// Whether these images determine integers of absolute value up to `bound`.
    ///
    /// Lemma 1. If |c| ≤ B and the modulus M is greater than 2B, then [`Images::balanced`] is c.
    /// Proof. It is congruent to c modulo M and at most M/2 in absolute value, so the two differ by less than M.
    /// Laws: `the_bound_is_reached_at_half_the_modulus` in resultant.rs and in subresultant.rs.
    pub(crate) fn determine(&self, bound: &Natural) -> bool {
        self.modulus > bound << 1u64
    }

    /// The polynomial whose coefficients are the representatives of least absolute value.
    pub(crate) fn balanced(&self) -> IntegerPolynomial {
        let half = &self.modulus >> 1u64;
        let coefficients = self.residues.iter().map(|r| {
            if *r > half {
                Integer::from(r) - Integer::from(&self.modulus)
            } else {
                Integer::from(r)
            }
        });
        IntegerPolynomial::from_coefficients_asc(coefficients.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modular::large_primes;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn an_image_that_agrees_changes_nothing(
            c in prop::collection::vec((any::<i128>(), 0u64..300), 1..4), other in 0usize..4, more in 0u64..3,
        ) {
            let mut integers: Vec<Integer> = c.iter().map(|(c, shift)| Integer::from(*c) >> (shift % 128)).collect();
            let image = |integers: &[Integer], p: u64| -> Vec<u64> {
                integers.iter().map(|c| PrimeField::new(p).reduce_integer(c)).collect()
            };
            let mut images = Images::unknown(integers.len());
            let mut primes = large_primes();
            for p in primes.by_ref().take(6) {
                let before = images.balanced();
                let same = images.add(&image(&integers, p), p);
                prop_assert_eq!(same, images.balanced() == before);
            }
            // 186 bits determine numbers of 128 bits.
            let found = images.balanced();
            prop_assert_eq!(&found, &IntegerPolynomial::from_coefficients_asc(integers.clone()));
            let Some(p) = primes.next() else { unreachable!("there are more primes") };
            if let Some(c) = integers.get_mut(other) {
                *c += Integer::from(more);
            }
            let same = images.add(&image(&integers, p), p);
            prop_assert_eq!(same, images.balanced() == found);
            prop_assert_eq!(same, other >= integers.len() || more == 0);
        }
    }
}
