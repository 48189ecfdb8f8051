//! Chinese remainders: an integer from its residues modulo many primes.

use malachite::Natural;
use malachite::base::num::arithmetic::traits::{DivExact, Mod, Square};
use malachite::base::num::logic::traits::SignificantBits;
use pulp::NullaryFnOnce;
use smallvec::SmallVec;

use super::blocks::{Blocks, LANES, MOST_PRIMES};
use super::quad::{Quad, plus};
use super::quartet::Quartet;
use crate::error::Invariant;
use crate::exact::{Columns, Machine, Sums, digits, digits_for, f64_from};
use crate::poly::limbs::{LIMB_BITS, sign_limb, width_for};

/// The way from residues modulo some primes to integers.
///
/// With P the product of the primes and `y ≡ x · (P/p)^(−1)` in [0, p) for each of them, `x ≡ Σ y P/p` modulo P, and
/// x = Σ y P/p − qP with q the integer nearest to `Σ y/p` for |x| < P/4.
pub(super) struct Remainders<'a> {
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
    /// Sums of more than `direct` primes are formed in blocks. Cost: the number of primes squared, in time, and in space
    /// where sums are formed directly.
    pub(super) fn new(machine: Machine, quartets: &'a [Quartet], direct: usize) -> Self {
        let primes: Vec<u64> = quartets.iter().flat_map(Quartet::primes).collect();
        assert!(
            primes.len() <= MOST_PRIMES,
            "coefficients of more than {MOST_PRIMES} primes"
        );
        let product: Natural = primes.iter().map(|p| Natural::from(*p)).product();
        let width = width_for(product.significant_bits());
        // P/p modulo p is the quotient by p of P modulo p².
        let residue = |p: &u64| {
            let p = Natural::from(*p);
            let quotient = (&product).mod_op((&p).square()) / p;
            f64_from(u64::try_from(&quotient).invariant("a residue is less than its prime"))
        };
        let residues: Vec<f64> = primes.iter().map(residue).collect();
        let residues = residues.as_chunks::<4>().0;
        let weights = machine.dispatch(Inverses { quartets, residues });
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

/// Coefficients in a row, of `width` limbs each, from their residues, of at most 2p: for each quartet those of the first one, of
/// the next one, …
pub(super) struct Lift<'a> {
    pub(super) remainders: &'a Remainders<'a>,
    pub(super) residues: &'a [&'a [Quad]],
    pub(super) target: &'a mut [u64],
    pub(super) width: usize,
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
                // Every fraction is wrong by 2^-52, the sum of them by far less than 1/4.
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

/// All limbs from this one on those of the sign.
fn extend_sign(target: &mut [u64], from: usize) {
    if from < target.len() {
        let (target, above) = target.split_at_mut(from);
        above.fill(sign_limb(target));
    }
}
