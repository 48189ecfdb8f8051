//! Rational numbers are reconstructed from their residues.

use malachite::base::num::arithmetic::traits::{Abs, Mod};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural};

use super::Images;

/// A vector of rational numbers, one of which is 1, from its images modulo primes.
pub(crate) struct Reconstruction {
    images: Option<Images>,
    last: Option<Vec<Integer>>,
}

impl Reconstruction {
    pub(crate) fn new() -> Self {
        Self {
            images: None,
            last: None,
        }
    }

    /// Adds an image. Returns the vector with coprime integers if it is found and this image did not change it.
    pub(crate) fn add(&mut self, image: &[u64], prime: u64) -> Option<Vec<Integer>> {
        self.push(image, prime);
        self.attempt()
    }

    /// Adds an image.
    pub(crate) fn push(&mut self, image: &[u64], prime: u64) {
        match &mut self.images {
            Some(images) => images.push(image, prime),
            None => self.images = Some(Images::new(image, prime)),
        }
    }

    /// The vector with coprime integers, if it is found and is the same as in the last attempt.
    pub(crate) fn attempt(&mut self) -> Option<Vec<Integer>> {
        let images = self.images.as_ref()?;
        let found = integers(&images.residues, &images.modulus);
        let stable = found.is_some() && found == self.last;
        self.last = found;
        if stable { self.last.clone() } else { None }
    }
}

/// The integers n_i with n_i/d = residue_i modulo m for one small d; `None` if there are none.
fn integers(residues: &[Natural], modulus: &Natural) -> Option<Vec<Integer>> {
    let modulus = Integer::from(modulus);
    let mut denominator = Integer::ONE;
    let balanced = |value: Integer| {
        let value = value.mod_op(&modulus);
        if &value + &value > modulus {
            value - &modulus
        } else {
            value
        }
    };
    for residue in residues {
        let value = balanced(Integer::from(residue) * &denominator);
        if (&value * &value) << 1u64 >= modulus {
            let part = small_denominator(&value, &modulus)?;
            denominator *= part;
            if (&denominator * &denominator) << 1u64 >= modulus {
                return None;
            }
        }
    }
    let all = residues
        .iter()
        .map(|residue| balanced(Integer::from(residue) * &denominator));
    Some(all.collect())
}

/// The d > 0 for which d·value is small modulo m, both at most √(m/2), by Euclid's algorithm; `None` if there is none.
fn small_denominator(value: &Integer, modulus: &Integer) -> Option<Integer> {
    let (mut r0, mut r1) = (modulus.clone(), value.mod_op(modulus));
    let (mut t0, mut t1) = (Integer::ZERO, Integer::ONE);
    while (&r1 * &r1) << 1u64 >= *modulus {
        let quotient = &r0 / &r1;
        let (r2, t2) = (&r0 - &quotient * &r1, &t0 - &quotient * &t1);
        (r0, r1, t0, t1) = (r1, r2, t1, t2);
    }
    ((&t1 * &t1) << 1u64 < *modulus && t1 != 0).then(|| t1.abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::modular::{PrimeField, large_primes};
    use proptest::prelude::*;

    fn lcm(a: &Integer, b: &Integer) -> Integer {
        use malachite::base::num::arithmetic::traits::Lcm;
        Integer::from(a.unsigned_abs_ref().lcm(b.unsigned_abs_ref()))
    }

    proptest! {
        #[test]
        fn fractions_come_back(values in prop::collection::vec((-1000i64..1000, 1i64..1000), 1..5)) {
            let mut vector: Vec<Rational> = values.iter().map(|&(p, q)| Rational::from_integers(p.into(), q.into()).unwrap()).collect();
            vector.push(Rational::one());
            let common = vector.iter().fold(Integer::ONE, |d, c| lcm(&d, &c.denominator()));
            let expected: Vec<Integer> = vector.iter().map(|c| (c * &Rational::whole(&common)).numerator()).collect();
            let mut reconstruction = Reconstruction::new();
            let found = large_primes().take(8).find_map(|p| {
                let image: Vec<u64> = vector.iter().map(|c| {
                    let residue = |n: Integer| u64::try_from(&n.mod_op(Integer::from(p))).unwrap();
                    residue(c.numerator()) * PrimeField::new(p).inverse(residue(c.denominator())) % p
                }).collect();
                reconstruction.add(&image, p)
            });
            prop_assert_eq!(found, Some(expected));
        }
    }
}
