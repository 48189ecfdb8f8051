//! Dyadic numbers `m · 2^e`: the points at which polynomials are evaluated exactly.

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Parity, Pow, ShlRound};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode;

use super::Rational;
use crate::error::Invariant;

/// The number `mantissa · 2^exponent`. Sums, products and halves of such numbers are such numbers, and they need no gcds.
///
/// The exponent and the position of the leading bit must fit in 64 bits; the program stops if those of a result do not.
#[derive(Clone, Debug)]
pub struct Dyadic {
    mantissa: Integer,
    exponent: i64,
}

impl Dyadic {
    /// The number `mantissa · 2^exponent`.
    #[must_use]
    pub fn new(mantissa: Integer, exponent: i64) -> Self {
        let mut value = Self { mantissa, exponent };
        value.normalize();
        value
    }

    /// Divides the mantissa by its power of two, so that it stays short.
    fn normalize(&mut self) {
        if self.mantissa == 0 {
            self.exponent = 0;
        } else if self.mantissa.even() {
            let zeros = self
                .mantissa
                .unsigned_abs_ref()
                .trailing_zeros()
                .invariant("a number that is not 0 has a lowest bit");
            self.mantissa >>= zeros;
            self.exponent = raised(self.exponent, zeros.cast_signed());
        }
    }

    /// The number 0.
    #[must_use]
    pub fn zero() -> Self {
        Self::new(Integer::from(0), 0)
    }

    /// The exact value of a finite double; `None` for ±∞ and NaN.
    #[must_use]
    pub fn from_f64(value: f64) -> Option<Self> {
        let q = Rational::try_from(value).ok()?;
        // The denominator is a power of two.
        let exponent = q.denominator().significant_bits().cast_signed() - 1;
        Some(Self::new(q.numerator(), -exponent))
    }

    /// The mantissa m, which is odd or 0.
    #[must_use]
    pub fn mantissa(&self) -> &Integer {
        &self.mantissa
    }

    /// The exponent e.
    #[must_use]
    pub fn exponent(&self) -> i64 {
        self.exponent
    }

    /// The same number as a fraction.
    #[must_use]
    pub fn to_rational(&self) -> Rational {
        Rational::from_dyadic(self.mantissa.clone(), self.exponent)
    }

    /// The nearest double.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.to_rational().to_f64()
    }

    /// The sign: −1, 0 or 1.
    #[must_use]
    pub fn signum(&self) -> i8 {
        match self.mantissa.cmp(&Integer::from(0)) {
            Ordering::Less => -1,
            Ordering::Equal => 0,
            Ordering::Greater => 1,
        }
    }

    /// The integer ⌊log₂ |self|⌋; `None` for 0.
    #[must_use]
    pub fn log2(&self) -> Option<i64> {
        let bits = self.mantissa.significant_bits().cast_signed();
        (bits > 0).then(|| raised(self.exponent, bits - 1))
    }

    /// The number −self.
    #[must_use]
    pub fn negated(&self) -> Self {
        Self {
            mantissa: -&self.mantissa,
            exponent: self.exponent,
        }
    }

    /// Both mantissas for the smaller one of the exponents, and that exponent.
    fn aligned(&self, other: &Self) -> (Integer, Integer, i64) {
        let exponent = self.exponent.min(other.exponent);
        let raise = |d: &Self| &d.mantissa << d.exponent.abs_diff(exponent);
        (raise(self), raise(other), exponent)
    }

    /// The sum self + other.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let (a, b, e) = self.aligned(other);
        Self::new(a + b, e)
    }

    /// The difference self − other.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        let (a, b, e) = self.aligned(other);
        Self::new(a - b, e)
    }

    /// The product self · 2^k.
    ///
    /// # Panics
    /// If the exponent of the result does not fit in 64 bits.
    #[must_use]
    pub fn times_power_of_two(&self, k: i64) -> Self {
        Self::new(self.mantissa.clone(), raised(self.exponent, k))
    }

    /// The product self · n.
    #[must_use]
    pub fn times_integer(&self, n: &Integer) -> Self {
        Self::new(&self.mantissa * n, self.exponent)
    }

    /// The number in units of 2^−digits, rounded to an integer.
    pub(crate) fn in_units(&self, digits: u64, mode: RoundingMode) -> Integer {
        let shift = self.exponent + digits.cast_signed();
        (&self.mantissa).shl_round(shift, mode).0
    }

    /// The power self^k.
    ///
    /// # Panics
    /// If the exponent of the result does not fit in 64 bits.
    #[must_use]
    pub fn power(&self, k: u32) -> Self {
        Self::new(
            (&self.mantissa).pow(u64::from(k)),
            self.exponent.checked_mul(i64::from(k)).invariant(SMALL),
        )
    }

    /// The mean (self + other) / 2.
    #[must_use]
    pub fn midpoint(&self, other: &Self) -> Self {
        self.plus(other).times_power_of_two(-1)
    }
}

/// The message if an exponent is too large: the program stops instead of returning a wrong number.
const SMALL: &str = "the exponent of a dyadic number is between -2^63 and 2^63";

/// `exponent + by`.
fn raised(exponent: i64, by: i64) -> i64 {
    exponent.checked_add(by).invariant(SMALL)
}

impl PartialEq for Dyadic {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Dyadic {}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_sign = self.signum().cmp(&other.signum());
        if by_sign != Ordering::Equal {
            return by_sign;
        }
        match (self.log2(), other.log2()) {
            (Some(a), Some(b)) if a != b => {
                if self.signum() > 0 {
                    a.cmp(&b)
                } else {
                    b.cmp(&a)
                }
            }
            _ => {
                let (a, b, _) = self.aligned(other);
                a.cmp(&b)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_reach_the_ends_of_their_range() {
        let one = Dyadic::new(Integer::from(1), 0);
        assert_eq!(one.times_power_of_two(i64::MAX).exponent(), i64::MAX);
        assert_eq!(
            Dyadic::new(Integer::from(1), i64::MIN / 4)
                .power(4)
                .exponent(),
            i64::MIN
        );
        assert_eq!(Dyadic::new(Integer::from(0), i64::MAX).exponent(), 0);
        assert_eq!(
            Dyadic::new(Integer::from(1), i64::MAX).log2(),
            Some(i64::MAX)
        );
    }

    #[test]
    #[should_panic(expected = "between -2^63 and 2^63")]
    fn a_product_with_a_larger_exponent_stops() {
        let _ = Dyadic::new(Integer::from(1), i64::MAX).times_power_of_two(1);
    }

    #[test]
    #[should_panic(expected = "between -2^63 and 2^63")]
    fn a_power_with_a_larger_exponent_stops() {
        let _ = Dyadic::new(Integer::from(3), i64::MIN / 2).power(3);
    }

    #[test]
    #[should_panic(expected = "between -2^63 and 2^63")]
    fn factors_of_two_are_not_moved_beyond_the_range() {
        let _ = Dyadic::new(Integer::from(2), i64::MAX);
    }
}
