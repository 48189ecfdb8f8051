//! Kernels of matrices modulo a prime, and their vectors over the rational numbers.

use malachite::base::num::arithmetic::traits::{Abs, Mod};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural};

use super::residue::{ABOVE_PRIMES, Images, inverse_mod, previous_prime};

/// The primes that kernels are computed modulo: below 2³¹, descending.
pub(crate) fn kernel_primes() -> impl Iterator<Item = u64> {
    std::iter::successors(Some(previous_prime(ABOVE_PRIMES)), |&p| {
        Some(previous_prime(p))
    })
}

/// The kernel of a matrix modulo a prime.
pub(crate) struct Kernel {
    /// For each column that depends on those before it, the vector that is 1 there, 0 at the other such columns,
    /// and 0 after it.
    pub(crate) vectors: Vec<Vec<u64>>,
}

/// The kernel of the matrix with the given rows, all of length `columns`, modulo a prime below 2³¹. Gauss.
///
/// What is still to be eliminated is kept below p² and divided when it is looked at.
pub(crate) fn kernel(mut rows: Vec<Vec<u64>>, columns: usize, p: u64) -> Kernel {
    let square = p * p;
    let mut pivots: Vec<usize> = Vec::new();
    let mut free = Vec::new();
    for column in 0..columns {
        let rank = pivots.len();
        for row in &mut rows[rank..] {
            row[column] %= p;
        }
        let Some(found) = (rank..rows.len()).find(|&i| rows[i][column] != 0) else {
            free.push(column);
            continue;
        };
        rows.swap(rank, found);
        let inverse = inverse_mod(rows[rank][column], p);
        for c in &mut rows[rank][column..] {
            *c = *c % p * inverse % p;
        }
        let (done, open) = rows.split_at_mut(rank + 1);
        let top = &done[rank];
        for row in open.iter_mut().filter(|row| row[column] != 0) {
            let factor = p - row[column];
            for (c, t) in row[column..].iter_mut().zip(&top[column..]) {
                *c += factor * t;
                if *c >= square {
                    *c -= square;
                }
            }
        }
        pivots.push(column);
    }
    let vectors = free.iter().map(|&column| {
        let mut vector = vec![0; columns];
        vector[column] = 1;
        for (row, &pivot) in rows.iter().zip(&pivots).rev() {
            if pivot < column {
                let entries = row[pivot + 1..=column].iter().zip(&vector[pivot + 1..]);
                let sum = entries.fold(0, |sum, (a, b)| (sum + a * b) % p);
                vector[pivot] = (p - sum) % p;
            }
        }
        vector
    });
    Kernel {
        vectors: vectors.collect(),
    }
}

/// A growing space of vectors modulo a prime below 2³¹.
pub(crate) struct Span {
    prime: u64,
    /// For each column the vector of the basis whose first entry, a 1, is there.
    rows: Vec<Option<Vec<u64>>>,
    dimension: usize,
}

impl Span {
    pub(crate) fn new(columns: usize, prime: u64) -> Self {
        Self {
            prime,
            rows: vec![None; columns],
            dimension: 0,
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.dimension
    }

    /// Whether the vector was not in the space; then it is added.
    pub(crate) fn add(&mut self, mut vector: Vec<u64>) -> bool {
        let p = self.prime;
        let square = p * p;
        // Kept below p², and divided when it is looked at.
        for column in 0..vector.len() {
            vector[column] %= p;
            if vector[column] == 0 {
                continue;
            }
            match &self.rows[column] {
                Some(row) => {
                    let factor = p - vector[column];
                    for (c, r) in vector[column..].iter_mut().zip(&row[column..]) {
                        *c += factor * r;
                        if *c >= square {
                            *c -= square;
                        }
                    }
                }
                None => {
                    let inverse = inverse_mod(vector[column], p);
                    for c in &mut vector[column..] {
                        *c = *c % p * inverse % p;
                    }
                    self.rows[column] = Some(vector);
                    self.dimension += 1;
                    return true;
                }
            }
        }
        false
    }
}

/// A vector of rational numbers, one of them 1, from its images modulo primes.
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

    /// One more image. The vector with coprime integers, if it is found and this image did not change it.
    pub(crate) fn add(&mut self, image: &[u64], prime: u64) -> Option<Vec<Integer>> {
        self.push(image, prime);
        self.attempt()
    }

    /// One more image.
    pub(crate) fn push(&mut self, image: &[u64], prime: u64) {
        match &mut self.images {
            Some(images) => images.push(image, prime),
            None => self.images = Some(Images::new(image, prime)),
        }
    }

    /// The vector with coprime integers, if it is found and the same as at the last attempt.
    pub(crate) fn attempt(&mut self) -> Option<Vec<Integer>> {
        let images = self.images.as_ref()?;
        let found = integers(&images.residues, &images.modulus);
        let stable = found.is_some() && found == self.last;
        self.last = found;
        if stable { self.last.clone() } else { None }
    }
}

/// The integers n_i with n_i/d = residue_i modulo m, for one small d.
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

/// The d > 0 with d·value small modulo m, by Euclid: both at most √(m/2). `None` if there is none.
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
    use proptest::prelude::*;

    const P: u64 = 1_000_003;

    fn lcm(a: &Integer, b: &Integer) -> Integer {
        use malachite::base::num::arithmetic::traits::Lcm;
        Integer::from(a.unsigned_abs_ref().lcm(b.unsigned_abs_ref()))
    }

    proptest! {
        #[test]
        fn kernels_vanish_and_have_the_right_dimension(
            basis in prop::collection::vec(prop::collection::vec(0..P, 7), 1..6),
            mix in prop::collection::vec(prop::collection::vec(0..P, 5), 9),
        ) {
            let rows: Vec<Vec<u64>> = mix.iter().map(|m| {
                (0..7).map(|c| m.iter().zip(&basis).fold(0, |s, (a, b)| (s + a * b[c]) % P)).collect()
            }).collect();
            let kernel = kernel(rows.clone(), 7, P);
            for vector in &kernel.vectors {
                for row in &rows {
                    prop_assert_eq!(row.iter().zip(vector).fold(0, |s, (a, b)| (s + a * b) % P), 0);
                }
            }
            // Random vectors are independent, but for an exception of probability 1e-5.
            prop_assert_eq!(kernel.vectors.len(), 7 - basis.len());
        }

        #[test]
        fn fractions_come_back(values in prop::collection::vec((-1000i64..1000, 1i64..1000), 1..5)) {
            let mut vector: Vec<Rational> = values.iter().map(|&(p, q)| Rational::new(p.into(), q.into()).unwrap()).collect();
            vector.push(Rational::one());
            let common = vector.iter().fold(Integer::ONE, |d, c| lcm(&d, &c.denominator()));
            let expected: Vec<Integer> = vector.iter().map(|c| (c * &Rational::from(&common)).numerator()).collect();
            let mut reconstruction = Reconstruction::new();
            let found = kernel_primes().take(8).find_map(|p| {
                let image: Vec<u64> = vector.iter().map(|c| {
                    let residue = |n: Integer| u64::try_from(&n.mod_op(Integer::from(p))).unwrap();
                    residue(c.numerator()) * inverse_mod(residue(c.denominator()), p) % p
                }).collect();
                reconstruction.add(&image, p)
            });
            prop_assert_eq!(found, Some(expected));
        }
    }
    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]
        #[test]
        fn large_kernels_are_those_of_a_span(seed in 0u64..1000, rank in 1usize..190) {
            let mut random = super::super::SplitMix(seed);
            let columns = 200;
            // In steps, so that other columns than the last ones are free.
            let basis: Vec<Vec<u64>> = (0..rank).map(|k| {
                (0..columns).map(|c| if c < k { 0 } else { random.next() % P }).collect()
            }).collect();
            let rows: Vec<Vec<u64>> = (0..columns + 8).map(|_| {
                let weights: Vec<u64> = (0..rank).map(|_| random.next() % P).collect();
                (0..columns).map(|c| weights.iter().zip(&basis).fold(0, |s, (a, b)| (s + a * b[c]) % P)).collect()
            }).collect();
            let mut span = Span::new(columns, P);
            for row in &rows {
                span.add(row.clone());
            }
            let kernel = kernel(rows.clone(), columns, P);
            prop_assert_eq!(kernel.vectors.len(), columns - span.len());
            for (vector, row) in kernel.vectors.iter().zip(rows.iter().cycle().skip(rank)) {
                prop_assert_eq!(row.iter().zip(vector).fold(0, |s, (a, b)| (s + a * b) % P), 0);
            }
        }
    }
}
