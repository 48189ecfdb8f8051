//! The distance of a double from an exact value.

use std::convert::Infallible;

use malachite::base::num::arithmetic::traits::FloorSqrt;
use malachite::base::num::logic::traits::SignificantBits;

use crate::exact::{Rational, nearest_double};

/// The largest number of correct digits that is reported: 17 digits tell any double from all others.
pub(crate) const MOST_DIGITS: f64 = 17.0;

/// The number of correct digits that a correctly rounded double has at least: its relative error is at most 2^−53, and log₁₀
/// 2⁵³ > 15.95.
pub(crate) const DOUBLE_DIGITS: f64 = 15.95;

/// The difference between a double and a number that is only enclosed is known with a relative width of 2^−DIFFERENCE_BITS.
const DIFFERENCE_BITS: i64 = 20;

/// The number itself is then known with a relative width of 2^−VALUE_BITS.
const VALUE_BITS: i64 = 64;

/// The distance of a double from an exact value, relative to that value and in units of its last place.
///
/// If the exact value is known as a rational number, the relative distance is exact. If the value is only enclosed, the
/// relative distance is an upper bound, within a millionth of itself.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Deviation {
    relative: Option<Rational>,
    /// The distance in units in the last place of the double nearest to the exact value, rounded; infinite if there is nothing
    /// to compare with.
    pub ulps: f64,
}

impl Deviation {
    /// The deviation of `got` from `exact`.
    ///
    /// ```
    /// use stellate::check::Deviation;
    /// use stellate::exact::Rational;
    /// let third = Rational::from(1) / Rational::from(3);
    /// let rounded = Deviation::between(&Rational::try_from(1.0 / 3.0).unwrap(), &third);
    /// assert_eq!(rounded.ulps, 1.0 / 3.0);
    /// assert!(rounded.reaches(16) && !rounded.reaches(17));
    /// ```
    #[must_use]
    pub fn between(got: &Rational, exact: &Rational) -> Self {
        let distance = (got - exact).abs();
        let ulps = (&distance / &unit_in_the_last_place(exact.to_f64())).to_f64();
        let relative = match exact.recip() {
            Some(inverse) => Some(distance * inverse.abs()),
            None if distance.is_zero() => Some(distance),
            None => None,
        };
        Self { relative, ulps }
    }

    /// A number that `bounds` encloses in a number of bits, and the deviation of `got` from it. The numbers of bits are tried in
    /// turn until the deviation is known within 2^−[`DIFFERENCE_BITS`] of itself; after the last one it is what is known then. The
    /// number is rational only if its enclosure is a point.
    pub(super) fn enclosed(
        got: &Rational,
        bits: impl IntoIterator<Item = u32>,
        bounds: impl Fn(u32) -> [Rational; 2],
    ) -> (Rational, Self) {
        let mut bits = bits.into_iter().peekable();
        while let Some(now) = bits.next() {
            let [low, high] = bounds(now);
            if low == high {
                let deviation = Self::between(got, &low);
                return (low, deviation);
            }
            let width = &high - &low;
            let is_close =
                |size: &Rational, k: i64| width <= size * &Rational::from_dyadic(1.into(), -k);
            let nearer = |a: Rational, b: Rational| {
                if a.signum() == b.signum() {
                    a.abs().min(b.abs())
                } else {
                    Rational::zero()
                }
            };
            let difference = nearer(&low - got, &high - got);
            let size = nearer(low.clone(), high.clone());
            let is_enough = is_close(&difference, DIFFERENCE_BITS) && is_close(&size, VALUE_BITS);
            if is_enough || bits.peek().is_none() {
                let most = difference + width;
                let ulps = &most / &unit_in_the_last_place(low.to_f64());
                let deviation = match size.recip() {
                    Some(inverse) => Self::bounded(most * inverse, ulps.to_f64()),
                    None => Self::infinite(),
                };
                return (low, deviation);
            }
        }
        (Rational::zero(), Self::infinite())
    }

    /// The deviation of a number that is exact.
    pub(super) fn exact() -> Self {
        Self::bounded(Rational::zero(), 0.0)
    }

    /// A deviation with an upper bound of the relative distance.
    pub(super) fn bounded(relative: Rational, ulps: f64) -> Self {
        Self {
            relative: Some(relative),
            ulps,
        }
    }

    /// The deviation of a number that has no exact counterpart: no digit of it is right.
    pub(super) fn infinite() -> Self {
        Self {
            relative: None,
            ulps: f64::INFINITY,
        }
    }

    /// |got − exact|/|exact|, or its bound; `None` where it is infinite.
    #[must_use]
    pub fn relative(&self) -> Option<&Rational> {
        self.relative.as_ref()
    }

    /// The number of correct digits: −log₁₀ of the relative distance, at least 0 and at most 17, rounded to a double.
    #[must_use]
    pub fn digits(&self) -> f64 {
        let relative = self.relative.as_ref().map_or(f64::INFINITY, |r| r.to_f64());
        // The difference from 0 is 0 for a distance of 1, while the negative of 0 would be −0.
        (0.0 - relative.log10()).clamp(0.0, MOST_DIGITS)
    }

    /// Whether the relative distance is at most 10^−digits, decided exactly.
    #[must_use]
    pub fn reaches(&self, digits: u32) -> bool {
        let mark = Rational::from(10).pow(-i64::from(digits));
        matches!((&self.relative, mark), (Some(relative), Some(mark)) if *relative <= mark)
    }
}

/// The distance from the double to its neighbour away from 0.
pub(super) fn unit_in_the_last_place(double: f64) -> Rational {
    let next = double.abs().next_up();
    let at = |v: f64| Rational::try_from(v).ok();
    match (at(next), at(double.abs())) {
        (Some(next), Some(here)) => next - here,
        // Beyond the largest double, its unit is taken.
        _ => Rational::from_dyadic(1.into(), 971),
    }
}

/// The double nearest to √q for q ≥ 0.
pub(super) fn nearest_root(q: &Rational) -> f64 {
    let compare = |bound: &Rational| {
        let order = if bound.signum() <= 0 && q.signum() > 0 {
            std::cmp::Ordering::Greater
        } else {
            q.cmp(&(bound * bound))
        };
        Ok::<_, Infallible>(order)
    };
    if q.is_zero() {
        return 0.0;
    }
    let Ok(root) = nearest_double(q.to_f64().sqrt(), compare);
    root
}

/// A rational number whose relative distance from √q is at most 2^−120, for q > 0.
pub(super) fn close_root(q: &Rational) -> Rational {
    const BITS: i64 = 124;
    // √(p/d) = √(p d 4^k) / (d 2^k). Here k is so large that p d 4^k has at least 248 bits, so the integer root has at least
    // 124.
    let (p, d) = (q.numerator(), q.denominator());
    let product = p * &d;
    let bits = product.significant_bits().cast_signed();
    let k = (BITS - bits / 2).max(0);
    let root = (product << (2 * k)).floor_sqrt();
    Rational::from_dyadic(root, -k) / Rational::whole(d)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn nothing_is_near_0_but_0() {
        let zero = Rational::zero();
        let wrong = Deviation::between(&Rational::from(1), &zero);
        assert_eq!((wrong.relative(), wrong.digits()), (None, 0.0));
        assert!(!wrong.reaches(0));
        let right = Deviation::between(&zero, &zero);
        assert!(right.reaches(1000) && right.digits() >= MOST_DIGITS && right.ulps <= 0.0);
    }

    #[test]
    fn the_mark_itself_is_reached() {
        let exact = Rational::from(1000);
        let off = Deviation::between(&Rational::from(1001), &exact);
        assert!(off.reaches(3) && !off.reaches(4));
    }

    proptest! {
        #[test]
        fn a_rounded_number_is_half_an_ulp_away_at_most(p in 1i64.., q in 1i64..) {
            let exact = Rational::from(p) / Rational::from(q);
            let off = Deviation::between(&Rational::try_from(exact.to_f64()).unwrap(), &exact);
            prop_assert!(off.ulps <= 0.5 && off.digits() >= DOUBLE_DIGITS);
        }

        #[test]
        fn the_ulps_of_a_neighbour_are_one_more(v in 1.1f64..1.9, k in 1i32..40) {
            let exact = Rational::try_from(v).unwrap();
            let neighbour = (0..k).fold(v, |v, _| v.next_up());
            let off = Deviation::between(&Rational::try_from(neighbour).unwrap(), &exact);
            prop_assert!((off.ulps - f64::from(k)).abs() < 1e-12);
        }

        #[test]
        fn the_root_of_a_square_is_exact(v in 0f64..1e200) {
            let q = Rational::try_from(v).unwrap();
            prop_assert_eq!(nearest_root(&(&q * &q)).to_bits(), v.to_bits());
            prop_assert_eq!(nearest_root(&q).to_bits(), v.sqrt().to_bits());
            if v > 0.0 {
                let square = close_root(&q).pow(2).unwrap();
                prop_assert!((&square - &q).abs() <= q * Rational::from_dyadic(1.into(), -119));
            }
        }
    }
}
