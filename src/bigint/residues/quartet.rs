//! Quartets: four primes for which residues are computed side by side.

use rayon::prelude::*;

use super::lanes::{LaneFields, Lanes};
use super::primes::fours_of_primes;
use super::transform::Transform;
use crate::bigint::u64_from;
use crate::error::Invariant;

/// The product of the four primes has more bits than this. Lemma 1 of [`Quartet::enough_for`].
const BITS_OF_QUARTET: u64 = 199;

/// Four primes between 2^49.99 and 2^50.
#[derive(Clone, Debug)]
pub(crate) struct Quartet {
    pub(super) field: LaneFields,
    root: Lanes,
}

impl Quartet {
    /// Quartets whose primes have a product above 2^(bits + 2). By Lemma 1 of [`chinese`](super::chinese) they are enough for
    /// integers of absolute value below 2^`bits`.
    ///
    /// Lemma 1. n = ⌈(bits + 3)/199⌉ quartets are enough.
    /// Proof. Primes are above 2^49.99 (Lemma 1 of [`primes`](super::primes)), so the product is above 2^(199.96 n) ≥ 2^(bits +
    /// 3). Laws: `the_least_quartet_has_the_bits_that_are_said`, `products_of_quartets_are_large_enough`.
    pub(crate) fn enough_for(bits: u64) -> Vec<Self> {
        let fours = fours_of_primes(Self::number_for(bits));
        let quartets = fours.into_iter().map(|[p, root]| Self {
            field: LaneFields::new(p),
            root,
        });
        quartets.collect()
    }

    /// The number of quartets that are enough for integers below 2^`bits`.
    pub(crate) fn number_for(bits: u64) -> usize {
        usize::try_from((bits + 3).div_ceil(BITS_OF_QUARTET))
            .invariant("a number of primes fits in memory")
    }

    /// The four primes.
    pub(super) fn primes(&self) -> [u64; 4] {
        self.field.p.map(u64_from)
    }

    /// A quartet with one of the primes four times.
    pub(super) fn of_one_prime(&self, i: usize) -> Self {
        Self {
            field: LaneFields::new([self.field.p[i]; 4]),
            root: [self.root[i]; 4],
        }
    }

    /// Sets up the transform of `len` numbers.
    #[inline(always)]
    pub(super) fn set_transform(&self, transform: &mut Transform, len: usize) {
        transform.set(self.field, self.root, len);
    }

    /// The transform of `len` numbers.
    #[inline(always)]
    pub(super) fn transform(&self, len: usize) -> Transform {
        let mut transform = Transform::default();
        self.set_transform(&mut transform, len);
        transform
    }
}

/// Runs the work for each quartet, with its index, on all threads if there are several quartets. Each thread has a `workspace`
/// of its own, which the work for each quartet overwrites.
pub(crate) fn for_each_quartet<W, T: Send>(
    quartets: &[Quartet],
    workspace: impl Fn() -> W + Sync + Send,
    work: impl Fn(&mut W, usize, &Quartet) -> T + Sync + Send,
) -> Vec<T> {
    /// A workspace is used for at least this many quartets.
    const TOGETHER: usize = 4;
    if quartets.len() < 2 * TOGETHER {
        let mut workspace = workspace();
        let items = quartets.iter().enumerate();
        return items
            .map(|(k, quartet)| work(&mut workspace, k, quartet))
            .collect();
    }
    let items = quartets.par_iter().enumerate().with_min_len(TOGETHER);
    let results = items.map_init(workspace, |workspace, (k, quartet)| {
        work(workspace, k, quartet)
    });
    results.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bigint::residues::primes::LEAST;
    use malachite::Natural;
    use malachite::base::num::arithmetic::traits::Pow;
    use malachite::base::num::logic::traits::SignificantBits;

    #[test]
    fn the_least_quartet_has_the_bits_that_are_said() {
        let least = Natural::from(LEAST).pow(4);
        assert_eq!(least.significant_bits(), BITS_OF_QUARTET + 1);
    }

    #[test]
    fn products_of_quartets_are_large_enough() {
        for bits in (0..2400).chain([9_950, 15_917, 15_918]) {
            let quartets = Quartet::enough_for(bits);
            let primes = quartets.iter().flat_map(Quartet::primes).map(Natural::from);
            let product: Natural = primes.product();
            assert!(product > Natural::from(1_u32) << (bits + 2), "{bits}");
        }
    }
}
