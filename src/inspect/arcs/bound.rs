//! A lower bound of the distance between a point and a piece of an arc.

use super::polynomials::{Expansion, length};
use crate::intervals::interval::UNIT;

impl<const N: usize> Expansion<N> {
    /// The computed distance, and a bound of its rounding error and of the part of the expansion's error that is relative to
    /// it.
    pub(super) fn distance(&self) -> [f64; 2] {
        let distance = dot(&self.value, &self.value).sqrt();
        [distance, 16.0 * UNIT * distance]
    }

    /// A step of Newton's method to a minimum of the distance; `None` where the squared distance is not convex.
    pub(super) fn newton_step(&self) -> Option<f64> {
        let curvature = dot(&self.slope, &self.slope) + 2.0 * dot(&self.value, &self.bend);
        (curvature > 0.0).then(|| -dot(&self.value, &self.slope) / curvature)
    }

    /// A number that the distance |C(u + v) − p| is not below, up to the error of the arcs, for all v with low ≤ u + v ≤ high;
    /// `third` is a bound of |c'''|/6, and u is in this range.
    ///
    /// **Lemma 4.** Let D, T, B be value, slope and bend, |v| ≤ r, and M = `third`. Then
    ///
    /// |D + Tv + Bv² + κ|² ≥ |D|² + 2(D·T)v + μv² with μ = |T|² + 2D·B − 2r(|T·B| + M(|D| + |T|r + |B|r²)).
    ///
    /// Proof. Let P = D + Tv + Bv². Then |P + κ|² ≥ |P|² − 2|P||κ| with |κ| ≤ M|v|³; and |P|² ≥ |D|² + 2(D·T)v + (|T|² +
    /// 2D·B)v² − 2|T·B||v|³, as |B|²v⁴ ≥ 0. Here |v|³ ≤ rv².
    ///
    /// Rounding. A computed scalar product is wrong by at most 4·2^(−53) times the product of the lengths. So |D|² gets
    /// smaller, and 2(D·T)v by at most 2·`error`·|v|, on the side of u where the distance falls and on the side where it rises.
    /// The sizes of the terms of μ add up to at most `parts`, and each is rounded less than 60 times. The smallest value over a
    /// side is that at its end or the one at the vertex, −(D·T)²/μ; its terms are rounded less than 12 times.
    ///
    /// Law: `pieces_are_not_nearer`.
    pub(super) fn least_distance(&self, [low, high]: [f64; 2], third: f64) -> f64 {
        let Self {
            at,
            value,
            slope,
            bend,
        } = self;
        let square = dot(value, value);
        let distance = square.sqrt();
        let along = dot(value, slope);
        let lengths = [length(slope), length(bend)];
        let (below, above) = (at - low, high - at);
        let radius = below.max(above);

        let cubic = distance + radius * (lengths[0] + radius * lengths[1]);
        let bent = radius * 2.0 * (dot(slope, bend).abs() + third * cubic);
        let steepness = dot(slope, slope);
        let parts = steepness
            + 2.0 * distance * lengths[1]
            + radius * 2.0 * (lengths[0] * lengths[1] + third * cubic);
        let curvature = steepness + 2.0 * dot(value, bend) - bent - 64.0 * UNIT * parts;

        let error = 8.0 * UNIT * distance * lengths[0];
        let (falling, rising) = if along > 0.0 {
            (below, above)
        } else {
            (above, below)
        };
        let change =
            lowest(along.abs() + error, curvature, falling).min(lowest(error, curvature, rising));
        let least = square * (1.0 - 8.0 * UNIT) + change;
        if least > 0.0 {
            least.sqrt() * (1.0 - 4.0 * UNIT) - 8.0 * UNIT * distance
        } else {
            0.0
        }
    }
}

/// A lower bound of −2·`slope`·v + `curvature`·v² for 0 ≤ v ≤ `length`, where `slope` ≥ 0.
fn lowest(slope: f64, curvature: f64, length: f64) -> f64 {
    const ROUNDING: f64 = 16.0 * UNIT;
    if curvature * length > slope {
        -(slope * slope / curvature) * (1.0 + ROUNDING)
    } else {
        let (linear, square) = (2.0 * slope * length, curvature * length * length);
        square - linear - ROUNDING * (linear + square.abs())
    }
}

/// The scalar product.
fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let mut sum = 0.0;
    for i in 0..N {
        sum += a[i] * b[i];
    }
    sum
}
