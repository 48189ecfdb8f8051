//! Complex numbers of bounded size with a fixed number of fractional bits.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode;

/// A point of the complex plane in units of 2^−precision.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Point {
    pub(super) re: Integer,
    pub(super) im: Integer,
}

impl Point {
    pub(super) fn minus(&self, other: &Self) -> Self {
        Self {
            re: &self.re - &other.re,
            im: &self.im - &other.im,
        }
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        Self {
            re: &self.re * &other.re - &self.im * &other.im,
            im: &self.re * &other.im + &self.im * &other.re,
        }
    }

    pub(super) fn shifted_down(self, bits: u64) -> Self {
        Self {
            re: self.re >> bits,
            im: self.im >> bits,
        }
    }

    pub(super) fn zero() -> Self {
        Self {
            re: Integer::ZERO,
            im: Integer::ZERO,
        }
    }

    /// 1/z, rounded down; `None` for 0.
    pub(super) fn inverse(&self, precision: u64) -> Option<Self> {
        let square = self.square();
        if square == 0 {
            return None;
        }
        let part = |x: &Integer| (x << (2 * precision)) / &square;
        Some(Self {
            re: part(&self.re),
            im: -part(&self.im),
        })
    }

    fn square(&self) -> Integer {
        &self.re * &self.re + &self.im * &self.im
    }

    /// The binary logarithm of the absolute value, within 1e−9; −∞ for 0.
    pub(super) fn log2(&self) -> f64 {
        log2(&self.square()) / 2.0
    }

    /// The point, or its half if it is too far from 0.
    pub(super) fn within_unit_disc(self, precision: u64) -> Self {
        let bits = self.re.significant_bits().max(self.im.significant_bits());
        // |re|, |im| < 2^(precision − 1), so the absolute value is below √½.
        if bits < precision {
            return self;
        }
        let excess = bits + 1 - precision;
        self.shifted_down(excess)
    }
}

/// The binary logarithm of a natural number, within 1e−9; −∞ for 0.
pub(super) fn log2(n: &Integer) -> f64 {
    if *n == 0 {
        return f64::NEG_INFINITY;
    }
    let bits = n.significant_bits();
    let shift = bits.saturating_sub(62);
    let (top, _) = f64::rounding_from(&(n >> shift), RoundingMode::Nearest);
    #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
    let shift = shift as f64;
    top.log2() + shift
}
