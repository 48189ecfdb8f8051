//! Cosines and sines of the multiples of an angle, as integers.

use crate::error::Invariant;
use crate::exact::{Rational, cosine_and_sine, pi};
use crate::roots::{UnitBall, rotations};

/// The cosines and sines are multiples of 2^(−62).
pub(super) const BITS: u32 = 62;
/// The number of 64-bit words of the numbers from which they are rounded.
const WORDS: usize = 2;

/// cos kπ/K and sin kπ/K for a power of two K ≥ 4.
#[derive(Debug)]
pub(super) struct Waves {
    /// The values for 0 ≤ k < K/2, in units of 2^(−62).
    quarter: Vec<[i64; 2]>,
}

impl Waves {
    /// **Lemma 1.** For K ≤ 2^20 each value is within 2 units of 2^(−62).
    ///
    /// Proof. All angles are in [0, π/2), so no value is negative. The angle π/K and its cosine and sine are wrong by less than
    /// 2^(−128) each. By Lemma 12 of [`rotations`] each step adds less than 16 units of 2^(−128) to the error, so the balls are
    /// wrong by less than 2^(−100). Their midpoints are cut by less than one unit. Law: `waves_are_near`.
    pub(super) fn new(arcs: usize) -> Self {
        let bits = u32::try_from(64 * WORDS).invariant("a number has few words") + 8;
        let count = Rational::from(i64::try_from(arcs).invariant("there are few arcs"));
        let step = cosine_and_sine(&(pi(bits).0 / count), bits).map(|c| UnitBall::near(&c));
        let [cosines, sines] = rotations::<WORDS>(step, arcs / 2 - 1);
        let fixed = |ball: &UnitBall<WORDS>| {
            let (units, _) = ball.digits(BITS);
            i64::try_from(units).invariant("a cosine is at most 1")
        };
        let pairs = cosines.iter().zip(&sines);
        Self {
            quarter: pairs.map(|(c, s)| [fixed(c), fixed(s)]).collect(),
        }
    }

    /// cos kπ/K and sin kπ/K for any k.
    pub(super) fn at(&self, k: usize) -> [i64; 2] {
        let quarter = self.quarter.len();
        let [c, s] = self.quarter[k % quarter];
        match k / quarter % 4 {
            0 => [c, s],
            1 => [-s, c],
            2 => [-c, -s],
            _ => [s, -c],
        }
    }
}
