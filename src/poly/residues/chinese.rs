//! Chinese remainders: integers from their residues modulo many primes.

use std::ops::Range;
use std::sync::OnceLock;

use malachite::base::num::arithmetic::traits::{DivExact, Mod};
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural};
use pulp::{Arch, NullaryFnOnce};
use rayon::prelude::*;
use smallvec::SmallVec;

use super::blocks::{Blocks, LANES};
use super::quad::{Quad, plus};
use super::quartet::Quartet;
use crate::exact::{Columns, Sums, digits, f64_from};
use crate::poly::FlatPolynomial;
use crate::poly::limbs::{LIMB_BITS, sign_limb, to_integer, width_for};

/// So many products of 50 and 48 bits are summed up.
const MOST_PRIMES: usize = 1 << 12;

/// Up to so many primes sums are faster formed directly: of all time, blocks take 1.1 at 10 000 harmonics, with up to 420
/// primes, 0.95 at 15 000 and 0.67 at 30 000.
const DIRECT: usize = 480;

/// Coefficients that are lifted with the same primes.
const TOGETHER: usize = 32;

/// The way from residues to polynomials with integer coefficients: the smaller a coefficient, the fewer primes.
pub(crate) struct Lifting<'a> {
    quartets: &'a [Quartet],
    /// By how many quartets the sets of primes grow.
    step: usize,
    sets: Vec<OnceLock<Remainders<'a>>>,
    /// Sums of more primes than that are formed in blocks.
    direct: usize,
}

impl<'a> Lifting<'a> {
    pub(crate) fn new(quartets: &'a [Quartet]) -> Self {
        Self::with_blocks_above(quartets, DIRECT)
    }

    fn with_blocks_above(quartets: &'a [Quartet], direct: usize) -> Self {
        /// Sets of primes to choose from.
        const SETS: usize = 16;
        let step = quartets.len().div_ceil(SETS);
        let sets = quartets.chunks(step).map(|_| OnceLock::new()).collect();
        Self {
            quartets,
            step,
            sets,
            direct,
        }
    }

    /// The number of the smallest set for coefficients below 2^`bits`.
    fn set(&self, bits: u64) -> usize {
        let set = Quartet::number_for(bits).div_ceil(self.step) - 1;
        set.min(self.sets.len() - 1)
    }

    /// How many of the quartets are asked for coefficients below 2^`bits`.
    pub(crate) fn quartets_for(&self, bits: u64) -> usize {
        self.quartets_in(self.set(bits)).len()
    }

    fn quartets_in(&self, set: usize) -> &'a [Quartet] {
        &self.quartets[..self.quartets.len().min((set + 1) * self.step)]
    }

    fn remainders(&self, set: usize) -> &Remainders<'a> {
        self.sets[set].get_or_init(|| Remainders::new(self.quartets_in(set), self.direct))
    }

    /// The polynomial with `len` coefficients of which these are the residues, of at most 2p: a list for each quartet.
    /// The coefficients of a range are below 2 to the power `bits`, for which there are enough quartets.
    ///
    /// Cost: for each coefficient, and for each set, the number of its primes squared, in products of words, 0.11 ns
    /// each; for many primes some times less in [`Blocks`].
    pub(crate) fn polynomial(
        &self,
        residues: &[Vec<Quad>],
        len: usize,
        bits: impl Fn(Range<usize>) -> u64,
    ) -> FlatPolynomial {
        let sizes = sizes(len, bits);
        let width = width_for(sizes.iter().copied().max().unwrap_or(0));
        let mut limbs = vec![0; len * width];
        for_each_part(&mut limbs, TOGETHER * width, |(k, target)| {
            self.lift(residues, k, sizes[k], target, width);
        });
        FlatPolynomial::from_limbs(limbs, width)
    }

    /// The same, each coefficient in as much memory as it needs.
    pub(crate) fn integers(
        &self,
        residues: &[Vec<Quad>],
        len: usize,
        bits: impl Fn(Range<usize>) -> u64,
    ) -> Vec<Integer> {
        let sizes = sizes(len, bits);
        let mut integers = vec![Integer::ZERO; len];
        for_each_part(&mut integers, TOGETHER, |(k, target)| {
            let width = width_for(sizes[k]);
            let mut limbs = vec![0; target.len() * width];
            self.lift(residues, k, sizes[k], &mut limbs, width);
            let mut scratch = Vec::with_capacity(width);
            for (target, limbs) in target.iter_mut().zip(limbs.chunks_exact(width)) {
                *target = to_integer(limbs, 0, &mut scratch);
            }
        });
        integers
    }

    /// The k-th coefficients that are lifted together, which are below 2^`bits`, in limbs.
    fn lift(&self, residues: &[Vec<Quad>], k: usize, bits: u64, target: &mut [u64], width: usize) {
        Arch::new().dispatch(Lift {
            remainders: self.remainders(self.set(bits)),
            residues,
            start: k * TOGETHER,
            target,
            width,
        });
    }
}

/// The bits of all coefficients that are lifted together.
fn sizes(len: usize, bits: impl Fn(Range<usize>) -> u64) -> Vec<u64> {
    let starts = (0..len).step_by(TOGETHER);
    starts.map(|k| bits(k..len.min(k + TOGETHER))).collect()
}

/// The work for each part of the target and its number, on all threads if it is long.
fn for_each_part<T: Send>(
    target: &mut [T],
    part: usize,
    work: impl Fn((usize, &mut [T])) + Sync + Send,
) {
    /// Fewer parts are sooner done than given to threads.
    const FEW: usize = 16;
    if target.len() < FEW * part {
        target.chunks_mut(part).enumerate().for_each(work);
    } else {
        target.par_chunks_mut(part).enumerate().for_each(work);
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
    /// How many limbs −P has in two's complement.
    width: usize,
    sum: Sum,
}

/// How Σ y P/p − qP is formed.
enum Sum {
    /// As it stands; the last of the numbers is −P.
    Directly(Columns),
    InBlocks(Box<Blocks>),
}

impl<'a> Remainders<'a> {
    /// Sums of more than `direct` primes are formed in blocks. Cost: the number of primes squared.
    fn new(quartets: &'a [Quartet], direct: usize) -> Self {
        let primes: Vec<u64> = quartets.iter().flat_map(Quartet::primes).collect();
        assert!(
            primes.len() < MOST_PRIMES,
            "coefficients of {MOST_PRIMES} primes"
        );
        let product: Natural = primes.iter().map(|p| Natural::from(*p)).product();
        let width = width_for(product.significant_bits());
        let mut numbers: Vec<Natural> = primes
            .iter()
            .map(|p| (&product).div_exact(Natural::from(*p)))
            .collect();
        let residue = |(others, p): (&Natural, &u64)| {
            let residue = others.mod_op(Natural::from(*p));
            f64_from(u64::try_from(&residue).unwrap_or(0))
        };
        let residues: Vec<f64> = numbers.iter().zip(&primes).map(residue).collect();
        let residues = residues.as_chunks::<4>().0;
        let weights = Arch::new().dispatch(Inverses { quartets, residues });
        let minus_p = (Natural::from(1_u32) << (width as u64 * LIMB_BITS)) - &product;
        let sum = if primes.len() <= direct {
            numbers.push(minus_p);
            let numbers: Vec<_> = numbers
                .iter()
                .map(|number| digits(number.limbs()))
                .collect();
            Sum::Directly(Columns::new(&numbers))
        } else {
            Sum::InBlocks(Box::new(Blocks::new(
                quartets,
                &product,
                &minus_p.to_limbs_asc(),
            )))
        };
        Self {
            quartets,
            weights,
            width,
            sum,
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
        /// Coefficients whose sums are formed together.
        const BATCH: usize = 8;
        let Remainders {
            quartets,
            weights,
            width,
            sum,
        } = self.remainders;
        let across = 4 * quartets.len() + 1;
        let mut all_y = vec![0.0; BATCH * across];
        let mut sums = [(); BATCH].map(|()| Sums::default());
        let mut limbs = vec![[0; LANES]; *width];
        let batches = self.target.chunks_mut(BATCH * self.width);
        for (start, targets) in (self.start..).step_by(BATCH).zip(batches) {
            let count = targets.len() / self.width;
            for (k, y) in (start..).zip(all_y.chunks_exact_mut(across)).take(count) {
                let mut fractions = [0.0; 4];
                let by_quartet = quartets.iter().zip(weights).zip(self.residues);
                for (((quartet, weight), residues), y) in by_quartet.zip(y.as_chunks_mut::<4>().0) {
                    let field = &quartet.field;
                    *y = field.canonical(field.times(residues[k], *weight));
                    fractions = plus(fractions, field.fraction(*y));
                }
                // Every fraction is wrong by 2^-52, the sum of them by far less than 1/4.
                y[across - 1] = fractions.iter().sum::<f64>().round_ties_even();
            }
            let y: SmallVec<[&[f64]; BATCH]> = all_y.chunks_exact(across).take(count).collect();
            let mut targets = targets.chunks_exact_mut(self.width);
            match sum {
                Sum::Directly(columns) => {
                    columns.sums(&y, &mut sums[..count]);
                    for (target, sums) in targets.zip(&sums) {
                        sums.limbs(&mut target[..(*width).min(self.width)]);
                        extend_sign(target, *width);
                    }
                }
                Sum::InBlocks(blocks) => {
                    for y in y.chunks(LANES) {
                        blocks.sum(y, &mut sums[..y.len()], &mut limbs);
                        for (lane, target) in (0..y.len()).zip(&mut targets) {
                            for (to, from) in target.iter_mut().zip(&limbs) {
                                *to = from[lane];
                            }
                            extend_sign(target, *width);
                        }
                    }
                }
            }
        }
    }
}

/// All limbs from this one on those of the sign.
fn extend_sign(target: &mut [u64], from: usize) {
    if from < target.len() {
        let (target, above) = target.split_at_mut(from);
        above.fill(sign_limb(target));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::base::num::arithmetic::traits::Pow;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// Integers up to the bound are lifted from their residues, each from as few primes as it needs.
        #[test]
        fn lifted_integers_are_those_whose_residues_they_are(
            bits in prop_oneof![0u64..800, 3000u64..9000], len in 1usize..100, seed in any::<u64>(), extreme in any::<bool>(),
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
                let residues = flat.coefficients().map(|limbs| quartet.field.residue(limbs));
                residues.map(|r| if random.next().is_multiple_of(2) { plus(r, quartet.field.p) } else { r }).collect()
            }).collect();
            let largest = |range: Range<usize>| range.map(size).max().unwrap_or(0);
            // All sums directly, and all in blocks.
            for direct in [usize::MAX, 0] {
                let lifting = Lifting::with_blocks_above(&quartets, direct);
                prop_assert_eq!(lifting.quartets_for(bits), quartets.len());
                let lifted = lifting.polynomial(&residues, len, largest);
                let lifted: Vec<Integer> = lifted.to_integers(0).collect();
                prop_assert_eq!(&lifted, &integers);
                prop_assert_eq!(&lifting.integers(&residues, len, largest), &integers);
            }
        }
    }
}
