//! Random inputs for laws: numbers with long runs of equal bits, of which a cut loses as much as it can.

use malachite::base::num::arithmetic::traits::Pow;
use malachite::{Integer, Natural};

use super::fixed::Fraction;

/// The generator SplitMix64 (Steele, Lea & Flood).
#[derive(Debug)]
pub(crate) struct Draw(pub(crate) u64);

impl Draw {
    pub(crate) fn word(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.word() % n as u64).expect("small")
    }

    pub(crate) fn limb(&mut self) -> u64 {
        let bit = 1u64 << self.below(64);
        match self.below(8) {
            0 | 1 => u64::MAX,
            2 => 0,
            3 => bit,
            4 => bit - 1,
            5 => !bit,
            6 => u64::MAX - self.word() % 4,
            _ => self.word(),
        }
    }

    /// Limbs with long runs of equal bits; often all runs are of the same kind.
    pub(crate) fn limbs<const W: usize>(&mut self) -> [u64; W] {
        match self.below(4) {
            0 => [u64::MAX; W],
            1 => {
                let top = self.limb();
                let mut limbs = [0; W];
                limbs[W - 1] = top;
                limbs
            }
            _ => std::array::from_fn(|_| self.limb()),
        }
    }

    pub(crate) fn natural<const W: usize>(&mut self) -> Natural {
        Natural::from_limbs_asc(&self.limbs::<W>())
    }

    /// An integer of up to 64 · `limbs` bits of either sign.
    pub(crate) fn integer(&mut self, limbs: usize) -> Integer {
        let count = 1 + self.below(limbs);
        let limbs: Vec<u64> = match self.below(3) {
            0 => vec![u64::MAX; count],
            _ => (0..count).map(|_| self.limb()).collect(),
        };
        let size = Integer::from(Natural::from_limbs_asc(&limbs)) >> (self.below(64) as u64);
        if self.below(2) == 0 { size } else { -size }
    }

    pub(crate) fn fraction<const W: usize>(&mut self) -> Fraction<W> {
        Fraction::quotient(
            &Integer::from(self.natural::<W>()),
            &(Integer::from(2).pow(64 * W as u64)),
        )
    }
}
