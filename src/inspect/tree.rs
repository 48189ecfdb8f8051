//! What the searches for a nearest point in trees of boxes have in common.

use crate::intervals::interval::UNIT;

/// A box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent<const N: usize> {
    pub(super) low: [f64; N],
    pub(super) high: [f64; N],
}

impl<const N: usize> Extent<N> {
    /// The box of nothing.
    pub(super) const EMPTY: Self = Self {
        low: [f64::INFINITY; N],
        high: [f64::NEG_INFINITY; N],
    };

    /// The box about a middle with half its sides. The ends are at most 1 in size, so each is rounded by less than 4·`UNIT`.
    pub(super) fn of((middle, half): ([f64; N], [f64; N])) -> Self {
        Self {
            low: std::array::from_fn(|i| middle[i] - half[i] - 4.0 * UNIT),
            high: std::array::from_fn(|i| middle[i] + half[i] + 4.0 * UNIT),
        }
    }

    /// The box about both.
    pub(super) fn joined(&self, other: &Self) -> Self {
        Self {
            low: std::array::from_fn(|i| self.low[i].min(other.low[i])),
            high: std::array::from_fn(|i| self.high[i].max(other.high[i])),
        }
    }

    /// A lower bound of the squared distance of a point from the box, of which each coordinate has four roundings.
    pub(super) fn least_square(&self, p: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for ((low, high), x) in self.low.iter().zip(&self.high).zip(p) {
            let away = (low - x).max(x - high).max(0.0);
            sum += away * away;
        }
        sum * (1.0 - 8.0 * UNIT)
    }

    /// An upper bound of the squared distance of a point from the points of the box.
    pub(super) fn greatest_square(&self, p: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for ((low, high), x) in self.low.iter().zip(&self.high).zip(p) {
            let away = (high - x).max(x - low);
            sum += away * away;
        }
        sum * (1.0 + 8.0 * UNIT)
    }
}

/// What is known of the distance from one point.
pub(super) struct Search<P> {
    /// The squared distance of the parts that were left out is at least this.
    pub(super) low: f64,
    /// The distance of some point of the curve or surface is at most this.
    pub(super) high: f64,
    /// Where that point is.
    pub(super) place: P,
    /// The parts whose squared distance is at least this are left out.
    pub(super) enough: f64,
    pub(super) relative: f64,
    pub(super) error: f64,
}

impl<P> Search<P> {
    /// Takes note of a point with this computed distance, which is wrong by at most `error`.
    pub(super) fn found(&mut self, distance: f64, error: f64, place: impl FnOnce() -> P) {
        let high = distance + error + self.error;
        if high < self.high {
            self.high = high;
            self.place = place();
            // Bounds cannot be nearer to each other than their rounding errors.
            let width = (self.relative * high).max(4.0 * self.error + 64.0 * UNIT * high);
            let enough = (high - width).max(0.0);
            self.enough = enough * enough;
        }
    }

    /// Whether a part with this bound can be left out, which is then done.
    pub(super) fn leaves_out(&mut self, bound: f64) -> bool {
        let is_enough = bound >= self.enough;
        if is_enough {
            self.low = self.low.min(bound);
        }
        is_enough
    }
}
