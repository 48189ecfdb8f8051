//! Positive numbers with 128 leading bits and a bound of their error.

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

/// About mantissa · 2^exponent with a mantissa of 128 bits, which is wrong by at most `error`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wide {
    mantissa: u128,
    exponent: i64,
    error: u64,
}

impl Wide {
    /// From the leading bits of a number that is not 0: it is at least (mantissa, exponent), and less than the next one.
    pub(super) fn from_leading((mantissa, exponent): (u128, i64)) -> Self {
        Self {
            mantissa,
            exponent,
            error: 1,
        }
    }

    /// mantissa · 2^exponent for a mantissa that is not 0, exactly.
    pub(super) fn exact(mantissa: u64, exponent: i64) -> Self {
        let zeros = u128::from(mantissa).leading_zeros();
        Self {
            mantissa: u128::from(mantissa) << zeros,
            exponent: exponent - i64::from(zeros),
            error: 0,
        }
    }

    /// |p / q|, neither of them 0.
    pub(super) fn quotient(p: &Integer, q: &Integer) -> Self {
        let (p, q) = (p.unsigned_abs_ref(), q.unsigned_abs_ref());
        let bits = |n: u64| i64::try_from(n).unwrap_or(i64::MAX);
        let shift = 129 + bits(q.significant_bits()) - bits(p.significant_bits());
        let quotient = if shift >= 0 {
            (p << shift.unsigned_abs()) / q
        } else {
            p / (q << shift.unsigned_abs())
        };
        // 129 or 130 bits.
        let surplus = quotient.significant_bits() - 128;
        let mantissa = u128::try_from(&(quotient >> surplus)).unwrap_or(u128::MAX);
        Self {
            mantissa,
            exponent: bits(surplus) - shift,
            error: 1,
        }
    }

    #[inline]
    pub(super) fn times(self, other: Self) -> Self {
        let low = |m: u128| m & u128::from(u64::MAX);
        let [a, b] = [low(self.mantissa), self.mantissa >> 64];
        let [c, d] = [low(other.mantissa), other.mantissa >> 64];
        let carried = low(a * d) + low(b * c) + ((a * c) >> 64);
        let high = b * d + ((a * d) >> 64) + ((b * c) >> 64) + (carried >> 64);
        // At least 2^126; the last bit is lost, or two.
        let zeros = high.leading_zeros();
        let error = self.error.saturating_add(other.error);
        Self {
            mantissa: high << zeros,
            exponent: self.exponent + other.exponent + 128 - i64::from(zeros),
            error: error.saturating_mul(2).saturating_add(4),
        }
    }

    pub(super) fn power(self, k: u32) -> Self {
        let mut result = self;
        for _ in 1..k {
            result = result.times(self);
        }
        result
    }

    pub(super) fn times_power_of_two(self, k: i64) -> Self {
        Self {
            exponent: self.exponent + k,
            ..self
        }
    }

    /// About the value.
    #[expect(clippy::cast_precision_loss, reason = "an approximation")]
    pub(super) fn to_f64(self) -> f64 {
        // In two steps, for the smallest doubles.
        let half = i32::try_from(self.exponent / 2).unwrap_or(i32::MAX);
        let rest = i32::try_from(self.exponent - self.exponent / 2).unwrap_or(i32::MAX);
        self.mantissa as f64 * f64::from(half).exp2() * f64::from(rest).exp2()
    }

    /// How the numbers compare, if their errors leave no doubt.
    pub(super) fn certain_order(self, other: Self) -> Option<Ordering> {
        if self.exponent != other.exponent {
            // The mantissas differ by a factor below 2, the errors are small; so only far apart is certain.
            let far =
                self.exponent.abs_diff(other.exponent) > 1 && self.error.max(other.error) < 1 << 60;
            if far {
                return Some(self.exponent.cmp(&other.exponent));
            }
            let (low, high) = if self.exponent < other.exponent {
                (self, other)
            } else {
                (other, self)
            };
            // Both in units of the lower exponent, halved.
            let apart = high.mantissa.checked_sub(low.mantissa / 2)?;
            let errors = u128::from(self.error) + u128::from(other.error) + 2;
            return (apart > errors).then_some(self.exponent.cmp(&other.exponent));
        }
        let apart = self.mantissa.abs_diff(other.mantissa);
        let errors = u128::from(self.error) + u128::from(other.error);
        (apart > errors).then_some(self.mantissa.cmp(&other.mantissa))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use proptest::prelude::*;

    fn ends(a: Wide) -> [Rational; 2] {
        [-1, 1].map(|sign| {
            let error = Integer::from(a.error) * Integer::from(sign);
            Rational::from_parts(Integer::from(a.mantissa) + error, a.exponent)
        })
    }

    proptest! {
        /// Against exact rational numbers.
        #[test]
        fn bounds_hold(a in 1i64.., b in 1i64.., c in 1i64.., d in 1i64.., k in 1u32..6, shift in -3i64..3) {
            let exact = |p: i64, q: i64| Rational::from(p) / Rational::from(q);
            let wide = |p: i64, q: i64| Wide::quotient(&Integer::from(p), &Integer::from(q));
            let is_within = |w: Wide, q: &Rational| {
                let [low, high] = ends(w);
                low <= *q && *q <= high
            };
            let (x, y) = (exact(a, b), exact(c, d));
            let (u, v) = (wide(a, b), wide(c, d));
            prop_assert!(is_within(u, &x));
            prop_assert!(is_within(u.times(v), &(&x * &y)));
            prop_assert!(is_within(u.power(k), &x.pow(i64::from(k)).unwrap()));
            prop_assert_eq!(u.certain_order(v).unwrap_or_else(|| x.cmp(&y)), x.cmp(&y));
            let near = u.times_power_of_two(shift);
            if let Some(order) = near.certain_order(u) {
                prop_assert_eq!(order, shift.cmp(&0));
            }
            let whole = Wide::exact(a.unsigned_abs(), shift);
            prop_assert!(ends(whole).iter().all(|end| *end == Rational::from_parts(Integer::from(a), shift)));
        }
    }
}
