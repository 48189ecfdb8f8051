//! Positive numbers as 128 leading bits and a bound of their relative error.

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

use crate::error::Invariant;

/// A positive number x with |x − m 2^exponent| ≤ error · 2^(−127) · m 2^exponent, for a mantissa m of exactly 128 bits. Every
/// operation computes the error of its result from those of its operands.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeadingBits {
    mantissa: u128,
    exponent: i64,
    error: u64,
}

impl LeadingBits {
    /// The number from its leading bits: it is at least mantissa · 2^exponent, and less than (mantissa + 1) · 2^exponent.
    ///
    /// So the error is below 1 in the last place, and 1 is at most 2^(−127) times a mantissa of 128 bits.
    pub(super) fn from_leading((mantissa, exponent): (u128, i64)) -> Self {
        Self {
            mantissa,
            exponent,
            error: 1,
        }
    }

    /// The exact number mantissa · 2^exponent, for a mantissa that is not 0.
    pub(super) fn exact(mantissa: u64, exponent: i64) -> Self {
        let zeros = u128::from(mantissa).leading_zeros();
        Self {
            mantissa: u128::from(mantissa) << zeros,
            exponent: exponent - i64::from(zeros),
            error: 0,
        }
    }

    /// The quotient |p / q|, where neither p nor q is 0.
    ///
    /// The quotient is cut twice, and loses less than 1 in the last place of the mantissa.
    pub(super) fn quotient(p: &Integer, q: &Integer) -> Self {
        let (p, q) = (p.unsigned_abs_ref(), q.unsigned_abs_ref());
        let signed = |bits: u64| i64::try_from(bits).invariant("bits are far below 2^63");
        let shift = 129 + signed(q.significant_bits()) - signed(p.significant_bits());
        let quotient = if shift >= 0 {
            (p << shift.unsigned_abs()) / q
        } else {
            p / (q << shift.unsigned_abs())
        };
        // The quotient has 129 or 130 bits.
        let surplus = quotient.significant_bits() - 128;
        let mantissa = u128::try_from(&(quotient >> surplus));
        Self {
            mantissa: mantissa.invariant("128 bits are left"),
            exponent: signed(surplus) - shift,
            error: 1,
        }
    }

    /// **Lemma.** With errors a and b of the factors, a + b < 2^63, that of the product is at most a + b + 4.
    ///
    /// Proof. The product of the mantissas is at least 2^254. Cut below 2^128 and shifted up by at most one bit, it loses less
    /// than 2 in the last place, so it is 1 + κ times what is left, κ < 2 · 2^(−127). With the relative errors α and β of the
    /// factors the true product is (1 + κ)(1 + α)(1 + β) times that, and the products of two of these are together below
    /// 2 · 2^(−127). Law: `bounds_hold`.
    #[inline]
    pub(super) fn times(self, other: Self) -> Self {
        let low = |m: u128| m & u128::from(u64::MAX);
        let [a, b] = [low(self.mantissa), self.mantissa >> 64];
        let [c, d] = [low(other.mantissa), other.mantissa >> 64];
        let carried = low(a * d) + low(b * c) + ((a * c) >> 64);
        let high = b * d + ((a * d) >> 64) + ((b * c) >> 64) + (carried >> 64);
        // At least 2^126.
        let zeros = high.leading_zeros();
        let sum = self.error.checked_add(other.error);
        let sum = sum.filter(|sum| *sum < 1 << 63).map(|sum| sum + 4);
        Self {
            mantissa: high << zeros,
            exponent: self.exponent + other.exponent + 128 - i64::from(zeros),
            error: sum.invariant("there are fewer than 2^60 factors"),
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
        // The power of two is multiplied in two steps, for the smallest doubles. An overflow gives ∞, an underflow 0.
        let exponent = i32::try_from(self.exponent.clamp(-4000, 4000)).invariant("it is clamped");
        let (half, rest) = (exponent / 2, exponent - exponent / 2);
        self.mantissa as f64 * f64::from(half).exp2() * f64::from(rest).exp2()
    }

    /// The order of the two numbers, if their errors leave no doubt.
    ///
    /// **Lemma.** Let m ≥ n be the mantissas in units of the larger exponent, the smaller number's cut (by less than 1). If m −
    /// n > 2a + 2b + 1, the errors being a and b, the numbers compare as m and n do. Proof: a mantissa is below 2^128, so
    /// it is wrong by less than 2a.
    pub(super) fn certain_order(self, other: Self) -> Option<Ordering> {
        let order = self.exponent.cmp(&other.exponent);
        let (low, high) = if order.is_lt() {
            (self, other)
        } else {
            (other, self)
        };
        let shift = u32::try_from(high.exponent - low.exponent).ok();
        let shifted = shift
            .and_then(|shift| low.mantissa.checked_shr(shift))
            .unwrap_or(0);
        let apart = high.mantissa.abs_diff(shifted);
        let errors = 2 * (u128::from(self.error) + u128::from(other.error)) + 1;
        let is_certain = apart > errors;
        let order = order.then_with(|| self.mantissa.cmp(&other.mantissa));
        is_certain.then_some(order)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use proptest::prelude::*;

    fn ends(a: LeadingBits) -> [Rational; 2] {
        let value = Rational::from_dyadic(Integer::from(a.mantissa), a.exponent);
        [-1, 1].map(|sign| {
            let error = Integer::from(a.error) * Integer::from(sign);
            &value + &value * Rational::from_dyadic(error, -127)
        })
    }

    /// Limbs that are all ones, all zeros, a single bit, or random.
    fn limb() -> impl Strategy<Value = u64> {
        let bit = (0..64u32).prop_map(|k| 1 << k);
        let below = (0..64u32).prop_map(|k| (1 << k) - 1);
        prop_oneof![
            Just(u64::MAX),
            Just(0),
            bit,
            below,
            any::<u64>(),
            any::<u64>()
        ]
    }

    /// Numbers without errors are told apart, unless they are neighbours.
    #[test]
    fn exact_numbers_have_an_order() {
        let [three, five, six] = [3, 5, 6].map(|n| LeadingBits::exact(n, -2));
        assert_eq!(three.certain_order(five), Some(Ordering::Less));
        assert_eq!(six.certain_order(five), Some(Ordering::Greater));
        assert_eq!(three.certain_order(three), None);
    }

    proptest! {
        /// The bounds hold in comparison with exact rational numbers.
        #[test]
        fn bounds_hold(a in 1i64.., b in 1i64.., c in 1i64.., d in 1i64.., k in 1u32..6, shift in -3i64..3) {
            let exact = |p: i64, q: i64| Rational::from(p) / Rational::from(q);
            let wide = |p: i64, q: i64| LeadingBits::quotient(&Integer::from(p), &Integer::from(q));
            let is_within = |w: LeadingBits, q: &Rational| {
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
            let whole = LeadingBits::exact(a.unsigned_abs(), shift);
            prop_assert!(ends(whole).iter().all(|end| *end == Rational::from_dyadic(Integer::from(a), shift)));
        }

        /// Quotients of integers of all lengths are cut by less than one in the last place of a mantissa of 128 bits.
        #[test]
        fn quotients_have_the_leading_bits(
            p in prop::collection::vec(limb(), 1..7), q in prop::collection::vec(limb(), 1..7), negative in any::<bool>(),
        ) {
            let [p, q] = [p, q].map(|limbs| Integer::from(malachite::Natural::from_owned_limbs_asc(limbs)));
            prop_assume!(p != 0 && q != 0);
            let p = if negative { -p } else { p };
            let found = LeadingBits::quotient(&p, &q);
            let exact = Rational::from_integers(p, q).unwrap().abs();
            prop_assert!(found.mantissa >> 127 == 1);
            let last = Rational::from_dyadic(Integer::from(1), found.exponent);
            let rest = exact - Rational::from_dyadic(Integer::from(found.mantissa), found.exponent);
            prop_assert!(rest.signum() >= 0 && rest < last);
            prop_assert_eq!(found.error, 1);
        }

        /// A product of mantissas loses less than 2 in its last place, whatever is carried.
        #[test]
        fn products_lose_less_than_two_in_the_last_place(a in [limb(), limb()], b in [limb(), limb()]) {
            let [a, b] = [a, b].map(|[low, high]| LeadingBits {
                mantissa: u128::from(high | 1 << 63) << 64 | u128::from(low),
                exponent: -5,
                error: 0,
            });
            let product = a.times(b);
            prop_assert!(product.mantissa >> 127 == 1);
            let value = |w: LeadingBits| Rational::from_dyadic(Integer::from(w.mantissa), w.exponent);
            let lost = value(a) * value(b) - value(product);
            prop_assert!(lost.signum() >= 0 && lost < Rational::from_dyadic(Integer::from(1), product.exponent + 1));
            prop_assert_eq!(product.error, 4);
        }

        /// The leading bits represent every number that begins with them.
        #[test]
        fn leading_bits_hold_what_follows_them(mantissa in (1u128 << 127).., exponent in -300i64..300, rest in any::<u64>()) {
            let [low, high] = ends(LeadingBits::from_leading((mantissa, exponent)));
            let number = (Integer::from(mantissa) << 64u64) + Integer::from(rest);
            let number = Rational::from_dyadic(number, exponent - 64);
            prop_assert!(low <= number && number <= high);
        }

        /// Numbers whose difference is about the sum of their errors, with one exponent and on both sides of a power of two.
        #[test]
        fn a_certain_order_is_that_of_all_numbers_within_the_errors(
            mantissa in (1u128 << 127)..u128::MAX - 500, errors in [0u64..60, 0u64..60], offs in [0u128..300, 0u128..300],
            around in any::<bool>(),
        ) {
            let number = |mantissa, exponent, error| LeadingBits { mantissa, exponent, error };
            let [a, b] = if around {
                [number(u128::MAX - offs[0], 7, errors[0]), number((1 << 127) + offs[1], 8, errors[1])]
            } else {
                [number(mantissa + offs[0], 7, errors[0]), number(mantissa + offs[1], 7, errors[1])]
            };
            for (a, b) in [(a, b), (b, a)] {
                let Some(order) = a.certain_order(b) else { continue };
                for x in ends(a) {
                    for y in ends(b) {
                        prop_assert_eq!(x.cmp(&y), order, "{:?} {:?}", a, b);
                    }
                }
            }
        }
    }
}
