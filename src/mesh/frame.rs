//! Coordinates in which a box is about a cube around the origin, for boxes that are thin or far away.
//!
//! In such a box cells of equal sides are too coarse for the thin side, and doubles lose the digits of the distance from the origin.
//! The change of coordinates x = c + 2^e X is exact.

use nalgebra::Vector3;

use super::extent::BoxSides;
use crate::error::Result;
use crate::intervals::rational;
use crate::limits::Limits;
use crate::poly::SparsePolynomial;

/// A box is thin if a side is less than this part of the longest one.
const THIN: f64 = 1.0 / 8.0;
/// A box is far away if it is farther from the origin than this many of its longest side.
const FAR: f64 = 1024.0;
/// The sides of boxes that are neither too small nor too large.
const SIDES: [f64; 2] = [1e-6, 1e9];

/// The coordinates X with x = c + 2^e X along each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    center: [f64; 3],
    exponents: [i32; 3],
}

impl Frame {
    /// The frame in which a box is about the cube with sides from −1 to 1; `None` if the box is not thin, far away, very small or very
    /// large, or is no box.
    pub(super) fn of(bounds: &BoxSides) -> Option<Self> {
        let sides = bounds.map(|[a, b]| b - a);
        let longest = sides.iter().copied().fold(0.0, f64::max);
        let shortest = sides.iter().copied().fold(f64::INFINITY, f64::min);
        let away = bounds
            .iter()
            .flatten()
            .fold(0.0, |m: f64, x| m.max(x.abs()));
        if !(longest.is_finite() && shortest > 0.0) {
            return None;
        }
        let is_usual = (SIDES[0]..SIDES[1]).contains(&longest);
        if is_usual && shortest >= THIN * longest && away <= FAR * longest {
            return None;
        }
        Some(Self {
            center: bounds.map(|[a, b]| f64::midpoint(a, b)),
            exponents: sides.map(|side| exponent(side / 2.0)),
        })
    }

    /// Whether the boxes of both frames are of about the same size.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        let mut pairs = self.exponents.iter().zip(other.exponents);
        pairs.all(|(a, b)| (a - b).abs() <= 1)
    }

    /// The polynomial in the coordinates X.
    ///
    /// # Errors
    /// Those of `limits`.
    pub(super) fn polynomial(
        &self,
        f: &SparsePolynomial<3>,
        limits: &Limits,
    ) -> Result<SparsePolynomial<3>> {
        f.in_coordinates(&self.center.map(rational), self.exponents, limits)
    }

    fn unit(&self, axis: usize) -> f64 {
        2f64.powi(self.exponents[axis])
    }

    /// About the point in the coordinates X.
    pub(super) fn inward(&self, point: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| (point[i] - self.center[i]) / self.unit(i))
    }

    /// About the point of the coordinates X.
    pub(super) fn outward(&self, point: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| self.center[i] + self.unit(i) * point[i])
    }

    /// The box in the coordinates X, rounded.
    pub(super) fn box_inward(&self, bounds: &BoxSides) -> BoxSides {
        let [low, high] = [0, 1].map(|end| self.inward(bounds.map(|side| side[end])));
        std::array::from_fn(|i| [low[i], high[i]])
    }

    /// A box that holds the box of the coordinates X.
    pub(super) fn box_outward(&self, bounds: &BoxSides) -> BoxSides {
        let [low, high] = [0, 1].map(|end| self.outward(bounds.map(|side| side[end])));
        std::array::from_fn(|i| [low[i].next_down(), high[i].next_up()])
    }

    /// The direction of the gradient, from that in the coordinates X; 0 if that is 0.
    pub(super) fn normal_outward(&self, normal: [f64; 3]) -> [f64; 3] {
        // Gradients are divided by the units.
        let largest = self.largest_unit();
        let turned = Vector3::from_fn(|i, _| normal[i] * (largest / self.unit(i)));
        turned.try_normalize(0.0).unwrap_or_default().into()
    }

    /// The largest factor by which lengths grow from the coordinates X outward.
    pub(super) fn largest_unit(&self) -> f64 {
        (0..3).map(|axis| self.unit(axis)).fold(0.0, f64::max)
    }
}

/// The least e with 2^e ≥ x.
#[expect(
    clippy::cast_possible_truncation,
    reason = "exponents of doubles are small"
)]
fn exponent(x: f64) -> i32 {
    x.log2().ceil() as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The polynomial in the coordinates of a frame has the values of the polynomial.
        #[test]
        fn a_frame_keeps_values(
            terms in prop::collection::vec((prop::array::uniform3(0u32..5), -9i64..9), 1..8),
            center in prop::array::uniform3(-8i32..8),
            exponents in prop::array::uniform3(-5i32..5),
            at in prop::array::uniform3(-8i32..8),
        ) {
            let f = SparsePolynomial::from_terms(terms.into_iter().map(|(e, c)| (e, c.into())));
            let frame = Frame { center: center.map(|c| f64::from(c) / 4.0), exponents };
            let at = at.map(|x| f64::from(x) / 8.0);
            let local = frame.polynomial(&f, &Limits::none()).unwrap();
            let there = frame.outward(at);
            prop_assert_eq!(local.evaluate(&at.map(rational)), f.evaluate(&there.map(rational)));
            let back = frame.inward(there);
            prop_assert_eq!(back.map(rational), at.map(rational));
        }
    }

    #[test]
    fn only_thin_and_far_boxes_have_frames() {
        assert_eq!(Frame::of(&[[-1.0, 1.0], [-1.0, 1.0], [-0.3, 0.3]]), None);
        assert_eq!(Frame::of(&[[-1.0, 1.0], [-1.0, 1.0], [0.0, 0.0]]), None);
        let thin = Frame::of(&[[-1.0, 1.0], [-1.0, 1.0], [-0.01, 0.01]]).unwrap();
        assert_eq!(thin.exponents, [0, 0, -6]);
        let far = Frame::of(&[[1e9 - 1.0, 1e9 + 1.0], [-1.0, 1.0], [-1.0, 1.0]]).unwrap();
        assert_eq!(far.center.map(rational), [1e9, 0.0, 0.0].map(rational));
        assert_eq!(far.exponents, [0; 3]);
        assert!(Frame::of(&[[-1e-12, 1e-12]; 3]).is_some());
    }
}
