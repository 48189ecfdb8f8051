//! Chinese remainders: an integer is computed from its residues modulo many primes.
//!
//! Lemma 1. Let P be the product of n primes, n ≤ [`MOST_PRIMES`], x an integer with |x| < P/4, and y ≡ x (P/p)^(−1) in [0, p)
//! for each prime p. Then x = Σ y P/p − qP, where q is the integer nearest to the sum s of fl(y fl(1/p)) in doubles.
//! Proof. Σ y P/p is congruent to x modulo each p, hence modulo P, so Σ y/p = q + x/P for an integer q. Each term of s has an
//! error below 2^-52, and each of at most n additions of sums below 2^16 an error of at most 2^-38. So |s − Σ y/p| < 2^16 ·
//! (2^-52 + 2^-38) < 2^-21, and s differs from q by less than 1/4 + 2^-21.
//! Law: `remainders_are_right_up_to_a_quarter_of_the_product`.

use malachite::Natural;
use malachite::base::num::arithmetic::traits::{DivExact, Mod, Square};
use malachite::base::num::logic::traits::SignificantBits;
use pulp::NullaryFnOnce;
use smallvec::SmallVec;

use super::blocks::{Blocks, LANES, MOST_PRIMES};
use super::lanes::{Lanes, plus};
use super::quartet::Quartet;
use crate::bigint::limbs::{LIMB_BITS, sign_limb, width_for};
use crate::bigint::{Columns, Machine, Sums, digits, digits_for, f64_from};
use crate::error::Invariant;

/// Chinese remainders for some primes.
///
/// The integer is x = Σ y P/p − qP, as in Lemma 1.
pub(super) struct Remainders<'a> {
    quartets: &'a [Quartet],
    /// The inverse of P/p modulo p.
    weights: Vec<Lanes>,
    /// The number of limbs of −P in two's complement.
    width: usize,
    sum: Sum,
}

/// The method that computes Σ y P/p − qP.
enum Sum {
    /// The sum is computed directly. The last of the numbers is −P.
    Directly(Columns),
    InBlocks(Box<Blocks>),
}

impl<'a> Remainders<'a> {
    /// Chinese remainders for these quartets. Sums of more than `direct` primes are computed in blocks. Cost: the square of the
    /// number of primes in time and, if sums are computed directly, in space.
    pub(super) fn new(machine: Machine, quartets: &'a [Quartet], direct: usize) -> Self {
        let primes: Vec<u64> = quartets.iter().flat_map(Quartet::primes).collect();
        assert!(
            primes.len() <= MOST_PRIMES,
            "coefficients of more than {MOST_PRIMES} primes"
        );
        let product: Natural = primes.iter().map(|p| Natural::from(*p)).product();
        let width = width_for(product.significant_bits());
        // P/p modulo p is the quotient of P modulo p² by p.
        let residue = |p: &u64| {
            let p = Natural::from(*p);
            let quotient = (&product).mod_op((&p).square()) / p;
            f64_from(u64::try_from(&quotient).invariant("a residue is less than its prime"))
        };
        let residues: Vec<f64> = primes.iter().map(residue).collect();
        let residues = residues.as_chunks::<4>().0;
        let weights = machine.dispatch_fused(Inverses { quartets, residues });
        let minus_p = (Natural::from(1_u32) << (width as u64 * LIMB_BITS)) - &product;
        let sum = if primes.len() <= direct {
            let numbers = primes
                .iter()
                .map(|p| (&product).div_exact(Natural::from(*p)));
            let numbers = numbers.chain([minus_p]);
            let numbers: Vec<_> = numbers.map(|number| digits(number.limbs())).collect();
            Sum::Directly(Columns::new(machine, &numbers))
        } else {
            Sum::InBlocks(Box::new(Blocks::new(
                machine,
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

/// Computes the inverses of residues in [0, p).
struct Inverses<'a> {
    quartets: &'a [Quartet],
    residues: &'a [Lanes],
}

impl NullaryFnOnce for Inverses<'_> {
    type Output = Vec<Lanes>;

    #[inline(always)]
    fn call(self) -> Vec<Lanes> {
        let mut inverses = self.residues.to_vec();
        for (inverse, quartet) in inverses.iter_mut().zip(self.quartets) {
            *inverse = quartet.field.inverse_of(*inverse);
        }
        inverses
    }
}

/// Computes consecutive coefficients of `width` limbs each from their residues, of at most 2p. For each quartet there are the
/// residues of the first coefficient, of the next one, and so on.
pub(super) struct Lift<'a> {
    pub(super) remainders: &'a Remainders<'a>,
    pub(super) residues: &'a [&'a [Lanes]],
    pub(super) target: &'a mut [u64],
    pub(super) width: usize,
}

impl NullaryFnOnce for Lift<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        /// The number of coefficients whose sums are computed together.
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
        for (start, targets) in (0..).step_by(BATCH).zip(batches) {
            let count = targets.len() / self.width;
            for (k, y) in (start..).zip(all_y.chunks_exact_mut(across)).take(count) {
                let mut fractions = [0.0; 4];
                let by_quartet = quartets.iter().zip(weights).zip(self.residues);
                for (((quartet, weight), residues), y) in by_quartet.zip(y.as_chunks_mut::<4>().0) {
                    let field = &quartet.field;
                    *y = field.canonical(field.times(residues[k], *weight));
                    fractions = plus(fractions, field.fraction(*y));
                }
                // The number q of Lemma 1.
                y[across - 1] = fractions.iter().sum::<f64>().round_ties_even();
            }
            let y: SmallVec<[&[f64]; BATCH]> = all_y.chunks_exact(across).take(count).collect();
            let mut targets = targets.chunks_exact_mut(self.width);
            match sum {
                Sum::Directly(columns) => {
                    let width = (*width).min(self.width);
                    columns.sums(&y, digits_for(width), &mut sums[..count]);
                    for (target, sums) in targets.zip(&sums) {
                        sums.limbs(&mut target[..width]);
                        extend_sign(target, width);
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

/// Fills all limbs from this one on with the sign.
fn extend_sign(target: &mut [u64], from: usize) {
    if from < target.len() {
        let (target, above) = target.split_at_mut(from);
        above.fill(sign_limb(target));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modular::SplitMix;
    use malachite::Integer;
    use malachite::base::num::basic::traits::{One, Zero};
    use proptest::prelude::*;

    /// A y in [0, p): 0, 1, p/2, p − 1 or a random one, as `kind` says.
    fn extreme_y(p: u64, kind: u64, random: &mut SplitMix) -> u64 {
        match kind % 6 {
            0 => 0,
            1 => p - 1,
            2 => random.next() % p,
            3 => p / 2,
            4 => (p - 1) * (random.next() % 2),
            _ => 1,
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// Both methods, with all instructions, for integers up to ±P/4 and for sums of the largest, the smallest and random y.
        #[test]
        fn remainders_are_right_up_to_a_quarter_of_the_product(
            count in prop_oneof![4 => 1usize..8, 1 => 12usize..40], seed in any::<u64>(),
            machine in prop::sample::select(Machine::all().to_vec()),
        ) {
            let quartets = Quartet::enough_for(199 * count as u64 - 3);
            prop_assert_eq!(quartets.len(), count);
            let primes: Vec<u64> = quartets.iter().flat_map(Quartet::primes).collect();
            let product: Natural = primes.iter().map(|p| Natural::from(*p)).product();
            let mut random = SplitMix(seed);
            let quarter = Integer::from(&product >> 2u64);
            let mut integers = vec![Integer::ZERO, Integer::ONE, -Integer::ONE];
            for less in [0, 1, 2] {
                integers.extend([&quarter - Integer::from(less), Integer::from(less) - &quarter]);
            }
            for kind in 0..18 {
                // The integer with these y, if it is small enough.
                let mut sum = Integer::ZERO;
                for (k, p) in primes.iter().enumerate() {
                    let kind = if kind < 6 { kind } else { kind + k as u64 % 2 + 1 };
                    let y = extreme_y(*p, kind, &mut random);
                    sum += Integer::from((&product).div_exact(Natural::from(*p)) * Natural::from(y));
                }
                let product = Integer::from(&product);
                let x = sum.mod_op(&product);
                let x = if &x + &x > product { x - &product } else { x };
                if x <= quarter && -&x <= quarter {
                    integers.push(x);
                }
            }
            let residue = |x: &Integer, p: f64| {
                let p = Integer::try_from(p).unwrap();
                f64_from(u64::try_from(&x.mod_op(p)).unwrap())
            };
            let residues: Vec<Vec<Lanes>> = quartets.iter().map(|quartet| {
                integers.iter().map(|x| quartet.field.p.map(|p| residue(x, p))).collect()
            }).collect();
            let residues: Vec<&[Lanes]> = residues.iter().map(Vec::as_slice).collect();
            for direct in [usize::MAX, 0] {
                let remainders = Remainders::new(machine, &quartets, direct);
                for width in [remainders.width, remainders.width + 2] {
                    let mut target = vec![7; integers.len() * width];
                    machine.dispatch_fused(Lift { remainders: &remainders, residues: &residues, target: &mut target, width });
                    for (x, limbs) in integers.iter().zip(target.chunks_exact(width)) {
                        prop_assert_eq!(&Integer::from_twos_complement_limbs_asc(limbs), x);
                    }
                }
            }
        }
    }
}
