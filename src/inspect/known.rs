//! A point that is inspected, and what is known of it.

use std::cell::OnceCell;

use super::DistanceBounds;
use crate::exact::Rational;
use crate::intervals::Interval;
use crate::intervals::interval::UNIT;

/// A point, by its nearest doubles and exactly.
pub(super) struct Point<'a> {
    pub(super) near: [f64; 3],
    /// A bound of the distance between the exact point and the doubles.
    pub(super) slack: f64,
    exactly: OnceCell<[Rational; 3]>,
    read: &'a dyn Fn() -> [Rational; 3],
    is_flat: bool,
}

impl<'a> Point<'a> {
    pub(super) fn new(near: [f64; 3], slack: f64, read: &'a dyn Fn() -> [Rational; 3]) -> Self {
        Self {
            near,
            slack,
            exactly: OnceCell::new(),
            read,
            is_flat: false,
        }
    }

    pub(super) fn exactly(&self) -> &[Rational; 3] {
        self.exactly.get_or_init(|| {
            let mut exactly = (self.read)();
            if self.is_flat {
                exactly[2] = Rational::zero();
            }
            exactly
        })
    }

    /// Intervals that hold the exact coordinates.
    pub(super) fn around(&self) -> [Interval; 3] {
        self.near.map(|x| Interval::around(x, self.slack))
    }

    /// The projection of the point to the plane of x and y. It has the same distance from a surface whose equation does not
    /// have z.
    pub(super) fn flattened(&self) -> Self {
        let [x, y, _] = self.near;
        Self {
            is_flat: true,
            ..Self::new([x, y, 0.0], self.slack, self.read)
        }
    }
}

/// A bound of the distance of a point from the doubles that are nearest to its coordinates: each differs from the coordinate by at
/// most `UNIT` times itself, or by half of the least subnormal double.
pub(crate) fn rounding<const N: usize>(near: [f64; N]) -> f64 {
    let sizes = near.iter().map(|x| Interval::from(*x).abs());
    let size = sizes.fold(Interval::ZERO, |sum, x| sum + x);
    (size * UNIT + Interval::from(f64::MIN_POSITIVE)).high()
}

/// A point of the plane, by its nearest doubles and exactly.
pub(crate) struct PlanePoint<'a> {
    pub(crate) near: [f64; 2],
    /// A bound of the distance between the exact point and the doubles.
    pub(crate) slack: f64,
    pub(crate) exactly: &'a dyn Fn() -> [Rational; 2],
}

/// The findings about one factor of the polynomial.
#[derive(Clone, Debug)]
pub(super) struct PartialInspection {
    pub(super) bounds: DistanceBounds,
    pub(super) inside: Option<bool>,
    pub(super) curve: Option<bool>,
    /// The nearest point that was found, in doubles.
    pub(super) foot: Option<[f64; 3]>,
    /// The nearest point that was found, more precisely than doubles can hold it.
    pub(super) exact_foot: Option<[Rational; 3]>,
    /// Whether doubles lose all digits of the polynomial at the point, so that other coordinates are needed.
    pub(super) is_blurred: bool,
}

impl PartialInspection {
    /// Nothing is known.
    pub(super) const NOTHING: Self = Self {
        bounds: DistanceBounds::UNKNOWN,
        inside: None,
        curve: None,
        foot: None,
        exact_foot: None,
        is_blurred: false,
    };

    /// Records a zero within the tolerance; `tolerance` is a double that is not below the tolerance, and `high` is the square
    /// of a bound of the distance of the zero.
    pub(super) fn has_zero(
        &mut self,
        foot: [Rational; 3],
        touches: bool,
        high: &Rational,
        tolerance: f64,
    ) {
        self.inside = Some(true);
        self.curve = touches.then_some(true);
        self.exact_foot = Some(foot);
        let high = Interval::from(high).sqrt().high();
        self.bounds.high = self.bounds.high.min(high.min(tolerance));
        self.bounds.low = self.bounds.low.min(self.bounds.high);
    }
}
