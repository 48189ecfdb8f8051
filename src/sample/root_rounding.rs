//! The double nearest to a multiple of a root of an enclosed number.

use std::cmp::Ordering;

use malachite::Integer;

use super::leading_bits::LeadingBits;
use crate::error::Invariant;
use crate::exact::{Rational, nearest_double};
use crate::roots::BoundedRoot;

/// The number of neighbouring doubles that are tried if the guess is not the nearest double.
const TRIES: usize = 4;

/// Rounds multiples of |root|^(1/gap). Only [`RootRounding::compare`] is trusted; a bad guess only costs time.
#[derive(Debug)]
pub(super) struct RootRounding {
    gap: u32,
    is_inverted: bool,
    scale: i64,
    low: LeadingBits,
    high: LeadingBits,
    /// An approximation of |root|^(1/gap).
    guess: f64,
}

impl RootRounding {
    pub(super) fn new<const W: usize>(root: &BoundedRoot<W>, gap: u32) -> Self {
        let y = root.low.to_f64();
        let sign = if root.is_inverted { -1.0 } else { 1.0 };
        let gap_f64 = f64::from(gap);
        // 2^s = 2^(whole · gap) 2^rest, for roots that are too large or too small for doubles.
        let whole = root.scale.div_euclid(i64::from(gap));
        let rest = root.scale.rem_euclid(i64::from(gap));
        // A guess that overflows is not used.
        let small = |k: i64| {
            let k = i32::try_from(k.clamp(-2000, 2000));
            f64::from(k.invariant("it is clamped")).exp2()
        };
        let guess = if gap == 1 {
            if root.is_inverted { 1.0 / y } else { y }
        } else {
            y.powf(sign / gap_f64) * (small(rest).powf(1.0 / gap_f64))
        };
        Self {
            gap,
            is_inverted: root.is_inverted,
            scale: root.scale,
            low: LeadingBits::from_leading(root.low.leading()),
            high: LeadingBits::from_leading(root.high.leading()),
            guess: guess * small(whole),
        }
    }

    /// The double nearest to |root|^(1/gap) · |other / unit|.
    pub(super) fn nearest(&self, unit: &Integer, other: &Integer) -> Option<f64> {
        let inverse = LeadingBits::quotient(unit, other);
        let mut guess = self.guess / inverse.to_f64();
        for _ in 0..TRIES {
            if !(guess.is_normal() && guess.next_down().is_normal() && guess.next_up().is_finite())
            {
                return None;
            }
            let [below, above] = midpoints(guess);
            if self.compare(above, inverse, Ordering::Less)? == Ordering::Greater {
                guess = guess.next_up();
            } else if self.compare(below, inverse, Ordering::Greater)? == Ordering::Less {
                guess = guess.next_down();
            } else {
                return Some(guess);
            }
        }
        None
    }

    /// The double nearest to from ± |root|^(1/gap) · |other / unit|; the sign is − if `is_negative`.
    pub(super) fn nearest_from(
        &self,
        from: &Rational,
        is_negative: bool,
        unit: &Integer,
        other: &Integer,
    ) -> Option<f64> {
        let inverse = LeadingBits::quotient(unit, other);
        let step = self.guess / inverse.to_f64();
        let guess = from.to_f64() + if is_negative { -step } else { step };
        if !guess.is_finite() {
            return None;
        }
        let sign = if is_negative { -1 } else { 1 };
        let found: Result<f64, ()> = nearest_double(guess, |bound| {
            // The signed step is compared with the distance of the bound from `from`.
            let away = bound - from;
            if away.signum() != sign {
                return Ok(sign.cmp(&away.signum()));
            }
            let size = LeadingBits::quotient(&away.numerator(), &away.denominator());
            let order = self.compare(size, inverse, Ordering::Less).ok_or(())?;
            Ok(if is_negative { order.reverse() } else { order })
        });
        // The number 0 has no sign.
        found.ok().map(|double| double + 0.0)
    }

    /// The order of |root|^(1/gap) / inverse and a bound. The order that is likely is tested first.
    fn compare(
        &self,
        bound: LeadingBits,
        inverse: LeadingBits,
        likely: Ordering,
    ) -> Option<Ordering> {
        // The root is 2^s y, or 2^s / y, and is compared with q 2^s.
        let q = bound.times(inverse).power(self.gap);
        let q = q.times_power_of_two(-self.scale);
        [likely, likely.reverse()].into_iter().find(|order| {
            // The root is larger than the bound if the lower end of its enclosure is, and smaller if the upper end is.
            let y = if (*order == Ordering::Greater) == self.is_inverted {
                self.high
            } else {
                self.low
            };
            let certain = if self.is_inverted {
                LeadingBits::exact(1, 0).certain_order(q.times(y))
            } else {
                y.certain_order(q)
            };
            certain == Some(*order)
        })
    }
}

/// The midpoints between a positive normal double and its neighbours.
fn midpoints(double: f64) -> [LeadingBits; 2] {
    let bits = double.to_bits();
    let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
    let exponent =
        i64::try_from(bits >> 52).invariant("a positive double has 11 bits above") - 1075;
    let below = if mantissa == 1 << 52 {
        // Below a power of two, doubles are twice as close.
        LeadingBits::exact(4 * mantissa - 1, exponent - 2)
    } else {
        LeadingBits::exact(2 * mantissa - 1, exponent - 1)
    };
    [below, LeadingBits::exact(2 * mantissa + 1, exponent - 1)]
}
