//! Residues modulo four primes of 25 bits at once, in doubles: sums of many products are exact and need no reduction.
//!
//! In all lemmas p is a prime between 2^24 and 2^25, and a residue is *reduced* if its absolute value is at most p/2 + 4.
//!
//! Lemma 1 (reduction). For an integer |a| ≤ 2^53 and q = ⌊a fl(1/p)⌉ the number a − qp is reduced, and computed exactly.
//! Proof. The computed quotient has two relative errors of 2^-53 and is at most 2^29, so it differs from a/p by less than 2^-23, and
//! |a/p − q| ≤ 1/2 + 2^-23. The fused a − qp is an integer of at most p/2 + 4, so it is not rounded.
//!
//! Lemma 2 (sums). A reduced residue plus [`TOGETHER`] products of reduced residues is below 2^53, and so is every partial sum.
//! Proof. A product is at most (2^24 + 4)² < 2^48 (1 + 2^-20), and 30 (1 + 2^-20) + 1 < 32.
//!
//! The law of both is `sums_of_products_are_congruent`.

use super::PrimeField;
use crate::error::Invariant;
use malachite::base::num::factorization::traits::IsPrime;

/// Four numbers, one for each prime. They are integers of at most 2^53.
pub(crate) type Four = [f64; 4];

/// So many products of reduced residues are added to a reduced residue before the sum is reduced.
pub(crate) const TOGETHER: usize = 30;

/// All primes have this many bits.
const BITS: u32 = 25;

/// The product of ten primes is above 2 to this power, because each is at least [`LEAST`].
pub(crate) const BITS_OF_TEN_PRIMES: u64 = 249;
const LEAST: u64 = 31_310_000;

/// The number ab + c.
#[inline(always)]
pub(crate) fn multiplied(a: Four, b: Four, c: Four) -> Four {
    let one = |i: usize| a[i].mul_add(b[i], c[i]);
    [one(0), one(1), one(2), one(3)]
}

#[inline(always)]
pub(crate) fn negated(a: Four) -> Four {
    a.map(|a| -a)
}

/// The integers modulo four primes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FourFields {
    primes: [u64; 4],
    p: Four,
    /// The rounded inverses 1/p.
    inverse: Four,
}

impl FourFields {
    fn new(primes: [u64; 4]) -> Self {
        let p = primes.map(double);
        Self {
            primes,
            p,
            inverse: p.map(|p| 1.0 / p),
        }
    }

    pub(crate) fn primes(&self) -> [u64; 4] {
        self.primes
    }

    /// The reduced residue of an integer of at most 2^53. Lemma 1.
    #[inline(always)]
    pub(crate) fn reduced(&self, a: Four) -> Four {
        let one = |i: usize| {
            let q = (a[i] * self.inverse[i]).round_ties_even();
            (-q).mul_add(self.p[i], a[i])
        };
        [one(0), one(1), one(2), one(3)]
    }

    /// The reduced product of reduced residues.
    #[inline(always)]
    pub(crate) fn times(&self, a: Four, b: Four) -> Four {
        self.reduced(multiplied(a, b, [0.0; 4]))
    }

    /// The reduced sum of products of pairs of reduced residues.
    #[inline(always)]
    pub(crate) fn sum_of_products(&self, pairs: impl Iterator<Item = (Four, Four)>) -> Four {
        let mut sum = [0.0; 4];
        for (k, (a, b)) in pairs.enumerate() {
            sum = multiplied(a, b, sum);
            if k % TOGETHER == TOGETHER - 1 {
                sum = self.reduced(sum);
            }
        }
        self.reduced(sum)
    }

    /// The reduced residues with these representatives in [0, p).
    pub(crate) fn of(&self, residue: impl Fn(PrimeField) -> u64) -> Four {
        let residues = self.primes.map(|p| double(residue(PrimeField::new(p))));
        self.reduced(residues)
    }

    /// The reduced inverse of a residue that is not 0.
    pub(crate) fn inverse(&self, a: Four) -> Four {
        let residues = self.representatives(a);
        let inverses =
            std::array::from_fn(|i| double(PrimeField::new(self.primes[i]).inverse(residues[i])));
        self.reduced(inverses)
    }

    /// The representatives in [0, p) of reduced residues.
    pub(crate) fn representatives(&self, a: Four) -> [u64; 4] {
        std::array::from_fn(|i| {
            let a = self.reduced(a)[i];
            let a = if a < 0.0 { a + self.p[i] } else { a };
            integer(a)
        })
    }

    /// The coefficients from z^`range.start` on of the product of two polynomials, reduced.
    ///
    /// Sums for neighbouring coefficients are kept in registers together.
    #[inline(always)]
    pub(crate) fn product(
        &self,
        a: &[Four],
        b: &[Four],
        range: std::ops::Range<usize>,
    ) -> Vec<Four> {
        const TILE: usize = 8;
        let mut padded = vec![[0.0; 4]; b.len() + 2 * TILE];
        padded[TILE..TILE + b.len()].copy_from_slice(b);
        let mut product = Vec::with_capacity(range.len() + TILE);
        for first in range.clone().step_by(TILE) {
            // The coefficient k is the sum of a_i b_(k−i).
            let low = (first + 1).saturating_sub(b.len());
            let high = a.len().min(first + TILE);
            let mut sums = [[0.0; 4]; TILE];
            if low < high {
                // The windows begin with b_(first − i).
                let others = &padded[TILE + first + 1 - high..2 * TILE + first - low];
                let mut windows = others.windows(TILE).rev();
                for factors in a[low..high].chunks(TOGETHER) {
                    for (&factor, window) in factors.iter().zip(&mut windows) {
                        for (sum, &other) in sums.iter_mut().zip(window) {
                            *sum = multiplied(factor, other, *sum);
                        }
                    }
                    for sum in &mut sums {
                        *sum = self.reduced(*sum);
                    }
                }
            }
            product.extend_from_slice(&sums);
        }
        product.truncate(range.len());
        product
    }
}

/// A prime or a representative as a double.
fn double(a: u64) -> f64 {
    f64::from(u32::try_from(a).invariant("the primes have 25 bits"))
}

/// The integer that is equal to a double in [0, 2^52).
fn integer(a: f64) -> u64 {
    // The last 52 bits of the double 2^52 + a are those of a.
    let above: f64 = 4_503_599_627_370_496.0;
    (a + above).to_bits() - above.to_bits()
}

/// Fields for `count` times four primes that are 1 modulo 4 and fulfil a condition; `None` if there are not enough primes.
pub(crate) fn four_fields(
    count: usize,
    is_good: impl Fn(PrimeField) -> bool,
) -> Option<Vec<FourFields>> {
    let candidates = (LEAST..1 << BITS)
        .rev()
        .filter(|p| p % 4 == 1 && p.is_prime());
    let mut primes = candidates.filter(|&p| is_good(PrimeField::new(p)));
    let mut next = || primes.next();
    (0..count)
        .map(|_| Some(FourFields::new([next()?, next()?, next()?, next()?])))
        .collect()
}

/// A square root of −1 modulo a prime that is 1 modulo 4.
pub(crate) fn imaginary_unit(field: PrimeField) -> u64 {
    let p = field.prime();
    let mut roots = (2..p).map(|g| field.power(g, (p - 1) / 4));
    let root = roots.find(|&i| field.mul(i, i) == p - 1);
    root.invariant("a prime that is 1 modulo 4 has a square root of −1")
}

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::Integer;
    use malachite::base::num::arithmetic::traits::{Mod, Pow};
    use proptest::prelude::*;

    fn fields() -> FourFields {
        four_fields(1, |_| true).unwrap()[0]
    }

    fn long(a: f64) -> Integer {
        Integer::try_from(a).unwrap()
    }

    /// Reduced residues, more often the largest ones than between.
    fn residue() -> impl Strategy<Value = f64> {
        prop_oneof![Just(1.0), Just(-1.0), Just(0.0), -1.0f64..1.0]
    }

    proptest! {
        #[test]
        fn sums_of_products_are_congruent(pairs in prop::collection::vec((residue(), residue()), 1..100), start in 0usize..100, len in 1usize..40) {
            let field = fields();
            let at = |share: f64| field.p.map(|p| ((p / 2.0 + 4.0) * share).trunc());
            let (a, b): (Vec<Four>, Vec<Four>) = pairs.iter().map(|(a, b)| (at(*a), at(*b))).unzip();
            let sum = field.sum_of_products(a.iter().copied().zip(b.iter().copied()));
            let product = field.product(&a, &b, start..start + len);
            prop_assert_eq!(product.len(), len);
            let congruent = |found: f64, expected: Integer, i: usize| {
                found.abs() <= field.p[i] / 2.0 + 4.0 && (long(found) - expected).mod_op(long(field.p[i])) == 0
            };
            for i in 0..4 {
                let expected = a.iter().zip(&b).map(|(a, b)| long(a[i]) * long(b[i])).sum();
                prop_assert!(congruent(sum[i], expected, i));
                for (k, found) in (start..).zip(&product) {
                    let pairs = (0..=k).filter(|&j| j < a.len() && k - j < b.len());
                    let expected = pairs.map(|j| long(a[j][i]) * long(b[k - j][i])).sum();
                    prop_assert!(congruent(found[i], expected, i));
                }
            }
            let ends = [9_007_199_254_740_992.0, -9_007_199_254_740_992.0, 9_007_199_254_740_991.0];
            for end in ends {
                prop_assert!(congruent(field.reduced([end; 4])[0], long(end), 0));
            }
        }
    }

    #[test]
    fn representatives_are_those_of_the_residues() {
        let fields = four_fields(60, |field| field.prime() % 3 == 1).unwrap();
        for field in &fields {
            for (p, unit) in field
                .primes()
                .into_iter()
                .zip(field.representatives(field.of(imaginary_unit)))
            {
                assert_eq!((p % 12, unit * unit % p), (1, p - 1));
            }
            assert_eq!(
                field.representatives([-1.0; 4]),
                field.primes().map(|p| p - 1)
            );
        }
        let mut primes: Vec<u64> = fields.iter().flat_map(FourFields::primes).collect();
        primes.dedup();
        assert_eq!(primes.len(), 240);
        // Ten of the primes have at least the bits that are said.
        let ten = Integer::from(LEAST).pow(10);
        assert!(ten >> BITS_OF_TEN_PRIMES >= 1);
    }
}
