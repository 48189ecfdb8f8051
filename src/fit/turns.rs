//! Certified cosines and sines of angles that are given in turns.

use malachite::Integer;

use crate::error::Invariant;
use crate::exact::{Rational, cosine_and_sine, pi};
use crate::roots::UnitBall;

/// The number of leading bits of an angle that choose an entry of the table.
const TABLE_BITS: u32 = 6;

/// The table and the coefficients from which cosines and sines are computed.
#[derive(Debug)]
pub(super) struct Turns<const W: usize> {
    /// cos and sin of 2πk/64.
    table: Vec<[UnitBall<W>; 2]>,
    /// The numbers (π/16)^m/m! for m = 0, 1, ….
    coefficients: Vec<UnitBall<W>>,
}

/// The number of bits of W limbs.
pub(super) fn bits_of<const W: usize>() -> u32 {
    u32::try_from(64 * W).invariant("a number has few limbs")
}

impl<const W: usize> Turns<W> {
    pub(super) fn new() -> Self {
        let bits = bits_of::<W>() + 8;
        let (pi, _) = pi(bits + 8);
        let count = 1u32 << TABLE_BITS;
        let step = &pi * &Rational::from(2) / Rational::from(i64::from(count));
        let entry = |k: u32| {
            // The angle is wrong by less than 2^(−bits), and its cosine by no more.
            cosine_and_sine(&(&step * &Rational::from(i64::from(k))), bits)
                .map(|c| UnitBall::near(&c))
        };
        let mut coefficients = vec![UnitBall::ONE];
        let mut term = Rational::one();
        let smallest = Rational::from_dyadic(Integer::from(1), -64 * W as i64);
        // One term beyond the last one that counts bounds both remainders.
        while coefficients.len() % 2 == 1 || term >= smallest {
            let m = Rational::from(coefficients.len() as i64);
            term = term * &step * Rational::from(2) / m;
            coefficients.push(UnitBall::near(&term));
        }
        Self {
            table: (0..count).map(entry).collect(),
            coefficients,
        }
    }

    /// cos 2πτ and sin 2πτ, for a number τ = 2^bits · `part` in [0, 1] of turns.
    ///
    /// **Lemma.** The balls hold both. Proof: τ = k/64 + y/32 with y in [0, 1/2), and the series of cos x and sin x in
    /// x = (π/16) y alternate and decrease, so the rest is at most the first term that is left out. That one is below
    /// 2^(−64W), or 1 unit. The rest is arithmetic of balls. Law: `turns_are_inside`.
    pub(super) fn at(&self, part: UnitBall<W>, bits: u32) -> [UnitBall<W>; 2] {
        let (k, rest) = part.digits(bits + TABLE_BITS);
        let y = rest.shifted_down(1);
        let square = y.times(&y);
        let series = |first: usize| {
            let terms = self.coefficients[first..].iter().step_by(2).rev();
            let sum = terms.fold(UnitBall::ZERO, |sum, c| {
                c.plus(&square.times(&sum).negated())
            });
            sum.widened(1.0)
        };
        let (c, s) = (series(0), y.times(&series(1)));
        // Near a full turn the midpoint may be one.
        let k = usize::try_from(k).invariant("an index of the table is small");
        let [table_c, table_s] = &self.table[k % self.table.len()];
        [
            c.times(table_c).plus(&s.times(table_s).negated()),
            s.times(table_c).plus(&c.times(table_s)),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<const W: usize>() {
        let turns = Turns::<W>::new();
        let (pi, _) = pi(bits_of::<W>() + 70);
        let denominator = Integer::from(1) << (64 * W as u64);
        for k in 0..400u64 {
            // Angles everywhere, and those at the ends of the entries of the table.
            let near_end = Integer::from(k % 65) * (&denominator >> 6u64);
            let off = Integer::from(k % 3) - Integer::from(1);
            let numerator = match k % 2 {
                0 => (near_end + off).min(&denominator - Integer::from(1)),
                _ => &denominator * Integer::from(k) / Integer::from(401),
            };
            if numerator < 0 {
                continue;
            }
            let angle =
                &pi * &Rational::from_integers(&numerator << 1u64, denominator.clone()).unwrap();
            let truths = cosine_and_sine(&angle, bits_of::<W>() + 60);
            let turn = UnitBall::quotient(&numerator, &denominator);
            let eighth = UnitBall::quotient(&numerator, &(&denominator << 3u64));
            let found = [turns.at(turn, 0), turns.at(eighth, 3)];
            for (truth, ball) in truths.iter().cycle().zip(found.into_iter().flatten()) {
                let [low, high] = ball.bounds();
                assert!(
                    low <= *truth && *truth <= high,
                    "{numerator} / {denominator}"
                );
                let width = high - low;
                assert!(width < Rational::from_dyadic(Integer::from(1), 24 - 64 * W as i64));
            }
        }
    }

    #[test]
    fn turns_are_inside() {
        check::<2>();
        check::<5>();
        check::<10>();
    }
}
