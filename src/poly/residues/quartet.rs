//! Four primes that are worked with side by side.

use pulp::Arch;
use rayon::prelude::*;

use super::primes::fours_of_primes;
use super::quad::{Quad, QuadField, f64_from, plus, u64_from};
use super::transform::Transform;
use crate::poly::limbs::is_negative;

/// Four primes between 2^49.99 and 2^50.
#[derive(Clone, Debug)]
pub(crate) struct Quartet {
    pub(super) field: QuadField,
    root: Quad,
}

impl Quartet {
    /// Primes with a product above 2^(bits + 2): enough to know integers of absolute value below 2^`bits`, and to tell
    /// their signs.
    pub(crate) fn enough_for(bits: u64) -> Vec<Self> {
        let fours = fours_of_primes(Self::number_for(bits));
        let quartets = fours.into_iter().map(|[p, root]| Self {
            field: QuadField::new(p),
            root,
        });
        quartets.collect()
    }

    /// How many they are.
    pub(crate) fn number_for(bits: u64) -> usize {
        // Four of them have more than 199.9 bits.
        usize::try_from((bits + 3).div_ceil(199)).unwrap_or(usize::MAX)
    }

    /// The four primes.
    pub(super) fn primes(&self) -> [u64; 4] {
        self.field.p.map(u64_from)
    }

    /// The first of the primes, four times.
    pub(super) fn first_prime(&self) -> Self {
        Self {
            field: QuadField::new([self.field.p[0]; 4]),
            root: [self.root[0]; 4],
        }
    }

    /// Transforms of `len` numbers.
    #[inline(always)]
    pub(super) fn transform(&self, len: usize) -> Transform {
        Transform::new(self.field, self.root, len)
    }

    /// The residues of an integer in two's complement, of at most p.
    #[inline(always)]
    pub(super) fn residue(&self, limbs: &[u64]) -> Quad {
        // By Horner's rule in 2^32.
        let by = self.field.factor([f64_from(1 << 32); 4]);
        let mut value = [if is_negative(limbs) { -1.0 } else { 0.0 }; 4];
        for limb in limbs.iter().rev() {
            for half in [limb >> 32, limb & 0xFFFF_FFFF] {
                value = plus(self.field.times_factor(value, by), [f64_from(half); 4]);
            }
        }
        value
    }
}

/// Whether the machine has the instructions: else every product is rounded by a function of the library, rightly and some
/// fifty times slower.
pub(crate) fn residues_are_quick() -> bool {
    !matches!(Arch::new(), Arch::Scalar)
}

/// The work for each quartet and its number, on all threads where there are several quartets.
pub(crate) fn for_each_quartet<T: Send>(
    quartets: &[Quartet],
    work: impl Fn(usize, &Quartet) -> T + Sync + Send,
) -> Vec<T> {
    let work = |(k, quartet)| work(k, quartet);
    if quartets.len() < 4 {
        quartets.iter().enumerate().map(work).collect()
    } else {
        quartets.par_iter().enumerate().map(work).collect()
    }
}
