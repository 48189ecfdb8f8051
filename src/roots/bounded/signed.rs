//! Fractions with a sign, without errors. Each operation states how it rounds; `ball.rs` states the effect on an error.

use malachite::Integer;

use super::fixed::{Fixed, Fraction};
use crate::error::Invariant;

/// A number in (−1, 1).
#[derive(Clone, Copy, Debug)]
pub(super) struct Signed<const W: usize> {
    pub(super) size: Fraction<W>,
    pub(super) is_negative: bool,
}

impl<const W: usize> Signed<W> {
    /// The largest number, 1 − 2^(−64W).
    pub(super) const LARGEST: Self = Self {
        size: Fraction::LARGEST,
        is_negative: false,
    };

    /// The number 0.
    pub(super) const ZERO: Self = Self {
        size: Fraction::ZERO,
        is_negative: false,
    };

    /// The quotient p / q, for |p| ≤ |q| ≠ 0, rounded towards 0.
    pub(super) fn quotient(p: &Integer, q: &Integer) -> Self {
        Self {
            size: Fraction::quotient(p, q),
            is_negative: (*p < 0) != (*q < 0),
        }
    }

    /// The product self · other, rounded towards 0 by less than W 2^(−64W).
    pub(super) fn times(&self, other: &Self) -> Self {
        Self {
            size: self.size.times(&other.size),
            is_negative: self.is_negative != other.is_negative,
        }
    }

    /// The sum self + other, or ±[`Fraction::LARGEST`] if its size is at least 1.
    pub(super) fn plus(&self, other: &Self) -> Self {
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
                size: other
                    .size
                    .minus(&self.size)
                    .invariant("one of two numbers is not below the other"),
                ..*other
            },
        }
    }

    /// The number self · 2^(−bits), rounded towards 0.
    pub(super) fn shifted_down(self, bits: u32) -> Self {
        Self {
            size: self.size.shifted_down(bits),
            ..self
        }
    }

    pub(super) fn negated(self) -> Self {
        Self {
            is_negative: !self.is_negative,
            ..self
        }
    }
}

impl<const W: usize> Fixed<W> {
    /// The number self / 2^8, in (−1, 1).
    pub(super) fn over_256(self) -> Signed<W> {
        Signed {
            size: self.size(),
            is_negative: self.is_negative(),
        }
    }

    /// The number self + 2^8 a b, rounded by less than W ulps.
    #[inline]
    pub(super) fn plus_product(self, a: &Signed<W>, b: &Signed<W>) -> Self {
        self.plus_or_minus_product(&a.size, &b.size, a.is_negative != b.is_negative)
    }
}
