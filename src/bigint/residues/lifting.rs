//! Polynomials with integer coefficients are computed from their residues modulo many primes.
//!
//! Lemma 1. A coefficient below 2^bits is computed rightly from the smallest set of quartets that has at least
//! [`Quartet::number_for`]\(bits) of them.
//! Proof. The product P of their primes is above 2^(bits + 2) (Lemma 1 of [`Quartet::enough_for`]), so the coefficient is below
//! P/4, as Lemma 1 of [`chinese`](super::chinese) requires. All coefficients that are computed together are below the same
//! power of two ([`Sizes::new`]).
//! Law: `lifted_integers_are_those_whose_residues_they_are`.

use std::ops::Range;
use std::sync::OnceLock;

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use rayon::prelude::*;

use super::chinese::{Lift, Remainders};
use super::lanes::Lanes;
use super::quartet::Quartet;
use crate::bigint::limbs::{to_integer, width_for};
use crate::bigint::{FlatPolynomial, Machine};
use crate::error::Invariant;

/// Up to this number of primes, sums are faster if they are computed directly. With blocks for larger numbers, 10 000
/// harmonics, which need up to 420 primes, take 0.93 of the time of direct sums alone, and 30 000 harmonics take 0.58.
const DIRECT: usize = 250;

/// The number of coefficients that are computed with the same primes.
const TOGETHER: usize = 32;

/// The sizes of the coefficients of a polynomial.
pub(crate) struct Sizes {
    len: usize,
    /// For each group of coefficients that are computed with the same primes, the exponent of a power of 2 that is above them.
    bits: Vec<u64>,
}

impl Sizes {
    /// The sizes of `len` coefficients; those in a range are below 2 to the power `bits` of this range.
    pub(crate) fn new(len: usize, bits: impl Fn(Range<usize>) -> u64) -> Self {
        let starts = (0..len).step_by(TOGETHER);
        let bits = starts.map(|start| bits(start..len.min(start + TOGETHER)));
        Self {
            len,
            bits: bits.collect(),
        }
    }
}

/// The residues, of at most 2p, of consecutive coefficients modulo four primes.
#[derive(Default)]
pub(crate) struct Residues {
    /// The index of the first of these coefficients.
    pub(crate) start: usize,
    pub(crate) values: Vec<Lanes>,
}

/// Computes polynomials with integer coefficients from residues. A smaller coefficient needs fewer primes.
pub(crate) struct Lifting<'a> {
    machine: Machine,
    quartets: &'a [Quartet],
    /// The number of quartets by which the sets of primes grow.
    step: usize,
    sets: Vec<OnceLock<Remainders<'a>>>,
    /// Sums of more primes than this are computed in blocks.
    direct: usize,
}

impl<'a> Lifting<'a> {
    pub(crate) fn new(machine: Machine, quartets: &'a [Quartet]) -> Self {
        Self::with_blocks_above(machine, quartets, DIRECT)
    }

    fn with_blocks_above(machine: Machine, quartets: &'a [Quartet], direct: usize) -> Self {
        /// The number of sets of primes.
        const SETS: usize = 16;
        let step = quartets.len().div_ceil(SETS);
        let sets = quartets.chunks(step).map(|_| OnceLock::new()).collect();
        Self {
            machine,
            quartets,
            step,
            sets,
            direct,
        }
    }

    /// The index of the smallest set for coefficients below 2^`bits`. Lemma 1.
    fn set(&self, bits: u64) -> usize {
        let number = Quartet::number_for(bits);
        assert!(
            number <= self.quartets.len(),
            "there are enough primes for all coefficients"
        );
        number.div_ceil(self.step) - 1
    }

    /// The number of quartets in a set.
    fn len(&self, set: usize) -> usize {
        self.quartets.len().min((set + 1) * self.step)
    }

    fn remainders(&self, set: usize) -> &Remainders<'a> {
        self.sets[set].get_or_init(|| {
            Remainders::new(self.machine, &self.quartets[..self.len(set)], self.direct)
        })
    }

    /// The range of coefficients that need the k-th quartet, from the first to the last. Their residues must be computed.
    pub(crate) fn asked(&self, sizes: &Sizes, k: usize) -> Range<usize> {
        let is_asked = |bits: &u64| self.len(self.set(*bits)) > k;
        let Some(first) = sizes.bits.iter().position(is_asked) else {
            return 0..0;
        };
        let last = sizes
            .bits
            .iter()
            .rposition(is_asked)
            .invariant("where there is a first there is a last");
        first * TOGETHER..sizes.len.min((last + 1) * TOGETHER)
    }

    /// The polynomial with these residues, which must be those of [`Self::asked`] for each quartet.
    ///
    /// Cost: for each coefficient and each set, the square of the number of its primes in products of words, 0.11 ns each;
    /// several times less for many primes in [`Blocks`](super::blocks::Blocks).
    pub(crate) fn polynomial(&self, sizes: &Sizes, residues: &[Residues]) -> FlatPolynomial {
        let width = width_for(sizes.bits.iter().copied().max().unwrap_or(0));
        let mut limbs = vec![0; sizes.len * width];
        for_each_part(&mut limbs, TOGETHER * width, |(k, target)| {
            self.lift(sizes, residues, k, target, width);
        });
        FlatPolynomial::from_limbs(limbs, width)
    }

    /// The coefficients of that polynomial, each in as much memory as it needs. The memory of the residues is freed.
    pub(crate) fn integers(&self, sizes: &Sizes, residues: Vec<Residues>) -> Vec<Integer> {
        let mut integers = vec![Integer::ZERO; sizes.len];
        for_each_part(&mut integers, TOGETHER, |(k, target)| {
            let width = width_for(sizes.bits[k]);
            let mut limbs = vec![0; target.len() * width];
            self.lift(sizes, &residues, k, &mut limbs, width);
            let mut scratch = Vec::with_capacity(width);
            for (target, limbs) in target.iter_mut().zip(limbs.chunks_exact(width)) {
                *target = to_integer(limbs, 0, &mut scratch);
            }
        });
        integers
    }

    /// Computes the k-th group of coefficients, as limbs.
    fn lift(
        &self,
        sizes: &Sizes,
        residues: &[Residues],
        k: usize,
        target: &mut [u64],
        width: usize,
    ) {
        let set = self.set(sizes.bits[k]);
        let from = k * TOGETHER;
        let residues = residues[..self.len(set)].iter();
        let residues: Vec<&[Lanes]> = residues.map(|r| &r.values[from - r.start..]).collect();
        self.machine.dispatch_fused(Lift {
            remainders: self.remainders(set),
            residues: &residues,
            target,
            width,
        });
    }
}

/// Runs the work for each part of the target, with its index, on all threads if there are many parts.
fn for_each_part<T: Send>(
    target: &mut [T],
    part: usize,
    work: impl Fn((usize, &mut [T])) + Sync + Send,
) {
    /// Below this number of parts one thread is faster.
    const FEW: usize = 16;
    if target.len() < FEW * part {
        target.chunks_mut(part).enumerate().for_each(work);
    } else {
        target.par_chunks_mut(part).enumerate().for_each(work);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bigint::residues::lanes::plus;
    use malachite::base::num::arithmetic::traits::Pow;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// Integers up to the bound are computed from their residues, each from as few primes as it needs.
        #[test]
        fn lifted_integers_are_those_whose_residues_they_are(
            bits in prop_oneof![8 => 0u64..800, 8 => 3000u64..9000, 1 => 15_000u64..16_000], len in 1usize..100, seed in any::<u64>(), extreme in any::<bool>(),
        ) {
            let mut random = crate::modular::SplitMix(seed);
            let size = |k: usize| bits * (k as u64 % 40) / 39;
            let integers: Vec<Integer> = (0..len).map(|k| {
                let most = Integer::from(2).pow(size(k)) - Integer::from(1);
                let sign = Integer::from(if random.next().is_multiple_of(2) { 1 } else { -1 });
                if extreme { most * sign } else { (most * sign * Integer::from(random.next())) >> 64u64 }
            }).collect();
            let quartets = Quartet::enough_for(bits);
            let flat = FlatPolynomial::from_integers(integers.iter(), bits);
            // Other representatives of the residues are allowed as well.
            let residues: Vec<Vec<Lanes>> = quartets.iter().map(|quartet| {
                let residues = flat.coefficients().map(|limbs| quartet.field.residue(limbs));
                residues.map(|r| if random.next().is_multiple_of(2) { plus(r, quartet.field.p) } else { r }).collect()
            }).collect();
            let largest = |range: Range<usize>| range.map(size).max().unwrap_or(0);
            let sizes = Sizes::new(len, largest);
            // All sums are computed directly, then all in blocks.
            for direct in [usize::MAX, 0] {
                let lifting = Lifting::with_blocks_above(Machine::this(), &quartets, direct);
                let asked = |(k, residues): (usize, &Vec<Lanes>)| {
                    let asked = lifting.asked(&sizes, k);
                    Residues { start: asked.start, values: residues[asked].to_vec() }
                };
                let residues: Vec<Residues> = residues.iter().enumerate().map(asked).collect();
                let lifted = lifting.polynomial(&sizes, &residues);
                let lifted: Vec<Integer> = lifted.to_integers(0).collect();
                prop_assert_eq!(&lifted, &integers);
                prop_assert_eq!(&lifting.integers(&sizes, residues), &integers);
            }
        }
    }
}
