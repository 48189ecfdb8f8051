//! Fractions with a sign, and the rotations cos mθ, sin mθ.

use malachite::Integer;

use super::fixed::{Fixed, Fraction};

/// A number in (−1, 1).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Signed<const W: usize> {
    pub(crate) size: Fraction<W>,
    pub(crate) is_negative: bool,
}

impl<const W: usize> Signed<W> {
    /// 1, but for 2^(−64W).
    pub(crate) const ONE: Self = Self {
        size: Fraction::LARGEST,
        is_negative: false,
    };

    /// 0.
    const ZERO: Self = Self {
        size: Fraction::ZERO,
        is_negative: false,
    };

    /// p / q for |p| ≤ |q| ≠ 0, rounded towards 0.
    pub(crate) fn quotient(p: &Integer, q: &Integer) -> Self {
        Self {
            size: Fraction::quotient(p, q),
            is_negative: (*p < 0) != (*q < 0),
        }
    }

    /// self · other, rounded towards 0 by less than W 2^(−64W).
    pub(crate) fn times(&self, other: &Self) -> Self {
        Self {
            size: self.size.times(&other.size),
            is_negative: self.is_negative != other.is_negative,
        }
    }

    /// self + other, or ±[`Fraction::LARGEST`] where that is beyond.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        if self.is_negative == other.is_negative {
            let size = self.size.plus(&other.size);
            return Self {
                size: size.unwrap_or(Fraction::LARGEST),
                ..*self
            };
        }
        match self.size.minus(&other.size) {
            Some(size) => Self { size, ..*self },
            None => Self {
                size: other.size.minus(&self.size).unwrap_or(Fraction::ZERO),
                ..*other
            },
        }
    }

    pub(crate) fn negated(self) -> Self {
        Self {
            is_negative: !self.is_negative,
            ..self
        }
    }
}

impl<const W: usize> Fixed<W> {
    /// self, as a number in (−1, 1) times 2^8.
    pub(crate) fn over_256(self) -> Signed<W> {
        Signed {
            size: self.size(),
            is_negative: self.is_negative(),
        }
    }

    /// self + 2^8 a b, with an error of less than W ulps.
    #[inline]
    pub(crate) fn plus_product(self, a: &Signed<W>, b: &Signed<W>) -> Self {
        self.plus_or_minus_product(&a.size, &b.size, a.is_negative != b.is_negative)
    }
}

/// cos mθ and sin mθ for m = 0, …, `last` from cos θ and sin θ, which are wrong by at most 2^(−64W); these are wrong by at
/// most ((3W + 2) m + 1) 2^(−64W).
pub(crate) fn rotations<const W: usize>(
    [cos, sin]: [Signed<W>; 2],
    last: usize,
) -> [Vec<Signed<W>>; 2] {
    // As complex numbers: the one before is wrong by E times a factor of modulus 1, the factor by √2, the four products by
    // less than W each, so the next one by less than E + √2 + 2√2 W and what is of second order: 3W + 2 more. What is
    // at least 1 and becomes the largest fraction is nearer to a true value, which is at most 1; that is the 1.
    let (mut cosines, mut sines) = (vec![Signed::ONE], vec![Signed::ZERO]);
    let (mut c, mut s) = (cos, sin);
    for _ in 0..last {
        cosines.push(c);
        sines.push(s);
        (c, s) = (
            c.times(&cos).plus(&s.times(&sin).negated()),
            s.times(&cos).plus(&c.times(&sin)),
        );
    }
    [cosines, sines]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::poly::TrigPolynomial;
    use proptest::prelude::*;

    const W: usize = 3;

    fn rational(a: &Signed<W>) -> Rational {
        let size = Rational::from_parts(a.size.to_integer(), -(64 * W as i64));
        if a.is_negative { -size } else { size }
    }

    proptest! {
        /// Against exact cosines and sines, by every kind of direction.
        #[test]
        fn rotations_are_as_near_as_is_said(p in -60i64..60, q in 1i64..60, big in any::<bool>(), last in 1usize..24) {
            // tan(θ/2) = p/q
            let shift = if big { 40u64 } else { 0 };
            let (p, q) = (Integer::from(p) << shift, (Integer::from(q) << shift) + Integer::from(1));
            let (pp, qq) = (&p * &p, &q * &q);
            let (w, u, v) = (&qq + &pp, &qq - &pp, &p * &q * Integer::from(2));
            let tables = rotations([&u, &v].map(|c| Signed::<W>::quotient(c, &w)), last);
            let exact = |n: &Integer| Rational::new(n.clone(), w.clone()).unwrap_or_default();
            for m in 0..=last {
                let index = i32::try_from(m).unwrap_or(0);
                let truths = [TrigPolynomial::cosine(index), TrigPolynomial::sine(index)];
                for (table, truth) in tables.iter().zip(truths) {
                    let off = rational(&table[m]) - truth.evaluate(&exact(&u), &exact(&v));
                    let ulps = Rational::from_parts(Integer::from((3 * W + 2) * m + 1), -(64 * W as i64));
                    prop_assert!(off <= ulps && -off <= ulps, "{m}");
                }
            }
        }
    }
}
