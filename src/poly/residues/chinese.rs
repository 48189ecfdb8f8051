//! Chinese remainders: integers from their residues modulo many primes.

use std::ops::Range;
use std::sync::OnceLock;

use malachite::Natural;
use malachite::base::num::arithmetic::traits::{DivExact, Mod};
use malachite::base::num::logic::traits::SignificantBits;
use pulp::{Arch, NullaryFnOnce};
use rayon::prelude::*;

use super::quad::{Quad, f64_from, plus, u64_from};
use super::quartet::Quartet;
use crate::poly::FlatPolynomial;
use crate::poly::limbs::{LIMB_BITS, is_negative, width_for};

/// So many products of 50 and 64 bits, and a carry, fit 128 bits.
const MOST_PRIMES: usize = (1 << 14) - 8;

/// Coefficients that are lifted with the same primes.
const TOGETHER: usize = 32;

/// The way from residues to polynomials with integer coefficients: the smaller a coefficient, the fewer primes.
pub(crate) struct Lifting<'a> {
    quartets: &'a [Quartet],
    /// By how many quartets the sets of primes grow.
    step: usize,
    sets: Vec<OnceLock<Remainders<'a>>>,
}

impl<'a> Lifting<'a> {
    pub(crate) fn new(quartets: &'a [Quartet]) -> Self {
        /// Sets of primes to choose from.
        const SETS: usize = 16;
        let step = quartets.len().div_ceil(SETS);
        let sets = quartets.chunks(step).map(|_| OnceLock::new()).collect();
        Self {
            quartets,
            step,
            sets,
        }
    }

    /// The number of the smallest set for coefficients below 2^`bits`.
    fn set(&self, bits: u64) -> usize {
        let set = Quartet::number_for(bits).div_ceil(self.step) - 1;
        set.min(self.sets.len() - 1)
    }

    /// How many of the quartets are asked for coefficients below 2^`bits`.
    pub(crate) fn quartets_for(&self, bits: u64) -> usize {
        self.quartets.len().min((self.set(bits) + 1) * self.step)
    }

    fn remainders(&self, set: usize) -> &Remainders<'a> {
        self.sets[set].get_or_init(|| {
            let count = self.quartets.len().min((set + 1) * self.step);
            Remainders::new(&self.quartets[..count])
        })
    }

    /// The polynomial with `len` coefficients of which these are the residues, of at most 2p: a list for each quartet.
    /// The coefficients of a range are below 2 to the power `bits`, for which there are enough quartets.
    ///
    /// Cost: for each coefficient, and for each set, the number of its primes squared, in products of words.
    pub(crate) fn polynomial(
        &self,
        residues: &[Vec<Quad>],
        len: usize,
        bits: impl Fn(Range<usize>) -> u64,
    ) -> FlatPolynomial {
        /// Fewer limbs are sooner done than given to threads.
        const SMALL: usize = 10_000;
        let ranges = (0..len).step_by(TOGETHER);
        let sizes: Vec<u64> = ranges.map(|k| bits(k..len.min(k + TOGETHER))).collect();
        let width = width_for(sizes.iter().copied().max().unwrap_or(0));
        let mut limbs = vec![0; len * width];
        let lift = |(k, target): (usize, &mut [u64])| {
            let remainders = self.remainders(self.set(sizes[k]));
            let start = k * TOGETHER;
            Arch::new().dispatch(Lift {
                remainders,
                residues,
                start,
                target,
                width,
            });
        };
        if limbs.len() < SMALL {
            limbs
                .chunks_mut(TOGETHER * width)
                .enumerate()
                .for_each(lift);
        } else {
            limbs
                .par_chunks_mut(TOGETHER * width)
                .enumerate()
                .for_each(lift);
        }
        FlatPolynomial::from_limbs(limbs, width)
    }
}

/// The way from residues modulo some primes to integers.
///
/// With P the product of the primes and `y ≡ x · (P/p)^(−1)` in [0, p) for each of them, `x ≡ Σ y P/p` modulo P, and
/// x = Σ y P/p − qP with q the integer nearest to `Σ y/p` for |x| < P/4.
struct Remainders<'a> {
    quartets: &'a [Quartet],
    /// (P/p)^(−1) mod p.
    weights: Vec<Quad>,
    /// Limbs that P has room in, with a sign.
    width: usize,
    /// For each limb, four at a time: those limbs of all P/p and, last, of −P in two's complement.
    columns: Vec<[u64; 4]>,
}

impl<'a> Remainders<'a> {
    /// Cost: the number of primes squared.
    fn new(quartets: &'a [Quartet]) -> Self {
        let primes: Vec<u64> = quartets.iter().flat_map(Quartet::primes).collect();
        assert!(
            primes.len() < MOST_PRIMES,
            "coefficients of {MOST_PRIMES} primes"
        );
        let product: Natural = primes.iter().map(|p| Natural::from(*p)).product();
        let width = width_for(product.significant_bits());
        let across = primes.len() + 1;
        let mut columns = vec![[0; 4]; width.div_ceil(4) * across];
        let mut set_column = |i: usize, value: &Natural| {
            for (k, limb) in value.limbs().enumerate() {
                columns[k / 4 * across + i][k % 4] = limb;
            }
        };
        let mut residues = Vec::with_capacity(primes.len());
        for (i, &p) in primes.iter().enumerate() {
            let others = (&product).div_exact(Natural::from(p));
            let residue = (&others).mod_op(Natural::from(p));
            residues.push(f64_from(u64::try_from(&residue).unwrap_or(0)));
            set_column(i, &others);
        }
        let negative = (Natural::from(1_u32) << (width as u64 * LIMB_BITS)) - product;
        set_column(primes.len(), &negative);
        let residues = residues.as_chunks::<4>().0;
        let weights = Arch::new().dispatch(Inverses { quartets, residues });
        Self {
            quartets,
            weights,
            width,
            columns,
        }
    }
}

/// The inverses of residues in [0, p).
struct Inverses<'a> {
    quartets: &'a [Quartet],
    residues: &'a [Quad],
}

impl NullaryFnOnce for Inverses<'_> {
    type Output = Vec<Quad>;

    #[inline(always)]
    fn call(self) -> Vec<Quad> {
        let mut inverses = self.residues.to_vec();
        for (inverse, quartet) in inverses.iter_mut().zip(self.quartets) {
            *inverse = quartet.field.inverse_of(*inverse);
        }
        inverses
    }
}

/// The coefficients from `start` on, of `width` limbs each.
struct Lift<'a> {
    remainders: &'a Remainders<'a>,
    residues: &'a [Vec<Quad>],
    start: usize,
    target: &'a mut [u64],
    width: usize,
}

impl NullaryFnOnce for Lift<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Remainders {
            quartets,
            weights,
            width,
            columns,
        } = self.remainders;
        let mut y = vec![0_u64; 4 * quartets.len() + 1];
        for (k, target) in (self.start..).zip(self.target.chunks_exact_mut(self.width)) {
            let mut fractions = [0.0; 4];
            let by_quartet = quartets.iter().zip(weights).zip(self.residues);
            for (((quartet, weight), residues), y) in by_quartet.zip(y.as_chunks_mut::<4>().0) {
                let field = &quartet.field;
                let value = field.canonical(field.times(residues[k], *weight));
                fractions = plus(fractions, field.fraction(value));
                *y = [
                    u64_from(value[0]),
                    u64_from(value[1]),
                    u64_from(value[2]),
                    u64_from(value[3]),
                ];
            }
            // Every fraction is wrong by 2^-52, the sum of them by far less than 1/4.
            let nearest = fractions.iter().sum::<f64>().round_ties_even();
            if let Some(last) = y.last_mut() {
                *last = u64_from(nearest);
            }
            let (target, above) = target.split_at_mut(self.width.min(*width));
            let mut carry = 0_u128;
            for (limbs, columns) in target.chunks_mut(4).zip(columns.chunks_exact(y.len())) {
                let sums = dot(&y, columns);
                for (limb, sum) in limbs.iter_mut().zip(sums) {
                    let sum = sum + carry;
                    *limb = low_limb(sum);
                    carry = sum >> LIMB_BITS;
                }
            }
            above.fill(if is_negative(target) { u64::MAX } else { 0 });
        }
    }
}

/// Σ y c for four c to each y.
#[inline(always)]
fn dot(y: &[u64], columns: &[[u64; 4]]) -> [u128; 4] {
    let [mut a, mut b, mut c, mut d] = [0_u128; 4];
    for (&y, column) in y.iter().zip(columns) {
        let times = |limb: u64| u128::from(y) * u128::from(limb);
        a += times(column[0]);
        b += times(column[1]);
        c += times(column[2]);
        d += times(column[3]);
    }
    [a, b, c, d]
}

#[inline(always)]
fn low_limb(a: u128) -> u64 {
    #[expect(clippy::cast_possible_truncation, reason = "the low half is meant")]
    {
        a as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::Integer;
    use malachite::base::num::arithmetic::traits::Pow;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// Integers up to the bound are lifted from their residues, each from as few primes as it needs.
        #[test]
        fn lifted_integers_are_those_whose_residues_they_are(
            bits in prop_oneof![0u64..800, 3000u64..4000], len in 1usize..100, seed in any::<u64>(), extreme in any::<bool>(),
        ) {
            let mut random = crate::poly::SplitMix(seed);
            let size = |k: usize| bits * (k as u64 % 40) / 39;
            let integers: Vec<Integer> = (0..len).map(|k| {
                let most = Integer::from(2).pow(size(k)) - Integer::from(1);
                let sign = Integer::from(if random.next().is_multiple_of(2) { 1 } else { -1 });
                if extreme { most * sign } else { (most * sign * Integer::from(random.next())) >> 64u64 }
            }).collect();
            let quartets = Quartet::enough_for(bits);
            let flat = FlatPolynomial::from_integers(integers.iter(), bits);
            // The other representatives are residues as well.
            let residues: Vec<Vec<Quad>> = quartets.iter().map(|quartet| {
                let residues = flat.coefficients().map(|limbs| quartet.residue(limbs));
                residues.map(|r| if random.next().is_multiple_of(2) { plus(r, quartet.field.p) } else { r }).collect()
            }).collect();
            let lifting = Lifting::new(&quartets);
            prop_assert_eq!(lifting.quartets_for(bits), quartets.len());
            let largest = |range: Range<usize>| range.map(size).max().unwrap_or(0);
            let lifted = lifting.polynomial(&residues, len, largest);
            let lifted: Vec<Integer> = lifted.to_integers(0).collect();
            prop_assert_eq!(lifted, integers);
        }
    }
}
