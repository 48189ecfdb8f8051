//! From an exact number to digits: the nearest double, the nearest decimal.

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Abs, DivRound, Pow};
use malachite::base::num::conversion::traits::{FromStringBase, RoundingFrom};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode;

use super::Rational;
use crate::error::Invariant;

/// The double nearest to a real number, given how the number compares with any rational one (ties to even; beyond
/// the largest double ±∞; a zero has the sign of the guess).
///
/// Two comparisons if the guess is right, about 2 log₂ n if it is n doubles away.
pub(crate) fn nearest_double<E>(
    guess: f64,
    compare: impl Fn(&Rational) -> Result<Ordering, E>,
) -> Result<f64, E> {
    let infinity = rank(f64::INFINITY);
    // How the number compares with the midpoint above a double: the answer is the lowest double for which it is
    // not greater.
    let above = |rank: i64| {
        if rank >= infinity {
            return Ok(Ordering::Less);
        }
        if rank < -infinity {
            return Ok(Ordering::Greater);
        }
        let double = of_rank(rank);
        compare(&midpoint(double, double.next_up()))
    };
    let mut high = rank(guess);
    let mut order = above(high)?;
    let mut low = high;
    let mut step = 1_i64;
    if order == Ordering::Greater {
        while order == Ordering::Greater {
            low = high;
            high = high.saturating_add(step).min(infinity);
            step = step.saturating_mul(2);
            order = above(high)?;
        }
    } else {
        loop {
            low = low.saturating_sub(step).max(-infinity - 1);
            step = step.saturating_mul(2);
            match above(low)? {
                Ordering::Greater => break,
                lower => (high, order) = (low, lower),
            }
        }
    }
    while low + 1 < high {
        let middle = i64::midpoint(low, high);
        match above(middle)? {
            Ordering::Greater => low = middle,
            lower => (high, order) = (middle, lower),
        }
    }
    let double = match high.clamp(-infinity, infinity) {
        0 => 0.0_f64.copysign(guess),
        other => of_rank(other),
    };
    Ok(if order == Ordering::Equal {
        midpoint(double, double.next_up()).to_f64()
    } else {
        double
    })
}

/// The place of a double among all doubles: 0 for ±0, one more for each next larger one.
fn rank(double: f64) -> i64 {
    let magnitude = double.abs().to_bits().cast_signed();
    if double < 0.0 { -magnitude } else { magnitude }
}

fn of_rank(rank: i64) -> f64 {
    let magnitude = f64::from_bits(rank.unsigned_abs());
    if rank < 0 { -magnitude } else { magnitude }
}

/// The exact midpoint of two neighbouring doubles; beyond the largest, half an ulp above it.
fn midpoint(a: f64, b: f64) -> Rational {
    let half_ulp = |sign: i32| Rational::from(sign) * Rational::from_parts(Integer::from(1), 970);
    match (Rational::try_from(a), Rational::try_from(b)) {
        (Ok(a), Ok(b)) => (a + b) / Rational::from(2),
        (Ok(a), Err(_)) => a + half_ulp(1),
        (Err(_), Ok(b)) => b + half_ulp(-1),
        (Err(_), Err(_)) => Rational::zero(),
    }
}

impl Rational {
    /// The double nearest to this number, ties to even; beyond the largest double, ±∞.
    ///
    /// ```
    /// use stellate::exact::Rational;
    /// let third: Rational = "1/3".parse().unwrap();
    /// assert_eq!(third.to_f64(), 1.0 / 3.0);
    /// assert_eq!(Rational::try_from(0.1).unwrap().to_f64(), 0.1);
    /// ```
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let rounded = f64::rounding_from(self.inner(), RoundingMode::Nearest).0;
        if rounded.abs() >= f64::MAX {
            // malachite stops at the largest finite double; IEEE 754 goes on to infinity from
            // half an ulp above it.
            let half_ulp_above = Rational::from(2)
                .pow(1024)
                .map(|p| p - Rational::from(2).pow(970).unwrap_or_default());
            if half_ulp_above.is_some_and(|bound| self.abs() >= bound) {
                return f64::INFINITY.copysign(rounded);
            }
        }
        rounded
    }

    /// The nearest multiple of 10^−`decimals` (ties to even).
    #[must_use]
    pub fn round_decimals(&self, decimals: u32) -> Rational {
        let scale = Rational::from(Integer::from(10).pow(u64::from(decimals)));
        let rounded = Integer::rounding_from((self * &scale).inner(), RoundingMode::Nearest).0;
        Rational::from(rounded) / scale
    }

    /// Decimal text with exactly `decimals` digits after the point, correctly rounded (ties to even).
    ///
    /// ```
    /// use stellate::exact::Rational;
    /// let q: Rational = "-2/3".parse().unwrap();
    /// assert_eq!(q.to_decimal(5), "-0.66667");
    /// assert_eq!("0.125".parse::<Rational>().unwrap().to_decimal(2), "0.12");
    /// ```
    #[must_use]
    pub fn to_decimal(&self, decimals: u32) -> String {
        let scale = Integer::from(10).pow(u64::from(decimals));
        let scaled = self * &Rational::from(&scale);
        let rounded = Integer::rounding_from(scaled.inner(), RoundingMode::Nearest).0;
        let sign = if rounded < 0 { "-" } else { "" };
        let digits = (&rounded).abs().to_string();
        let width = decimals as usize + 1;
        let padded = format!("{digits:0>width$}");
        let (whole, fraction) = padded.split_at(padded.len() - decimals as usize);
        if fraction.is_empty() {
            format!("{sign}{whole}")
        } else {
            format!("{sign}{whole}.{fraction}")
        }
    }

    /// Decimal text with `digits` significant digits, correctly rounded (ties to even), without zeros at the end; with an
    /// exponent where it would be long without one.
    ///
    /// ```
    /// use stellate::exact::Rational;
    /// let shown = |text: &str| text.parse::<Rational>().unwrap().to_significant(5);
    /// assert_eq!([shown("-2/3"), shown("1/4"), shown("1e30")], ["-0.66667", "0.25", "1e30"]);
    /// assert_eq!([shown("99999.7"), shown("1/300000"), shown("0")], ["100000", "3.3333e-6", "0"]);
    /// ```
    #[must_use]
    pub fn to_significant(&self, digits: u32) -> String {
        let places = i64::from(digits.max(1)) - 1;
        let ten = |e: i64| Rational::from(10).pow(e).invariant("ten is not zero");
        let Some(mut exponent) = self.decimal_exponent() else {
            return "0".into();
        };
        let mut text = (self.abs() * ten(places - exponent)).to_decimal(0);
        if i64::try_from(text.len()).invariant("a text is shorter than 2^63 bytes") > places + 1 {
            // Rounded up to the next power of ten.
            exponent += 1;
            text.pop();
        }
        let text = text.trim_end_matches('0');
        let sign = if self.signum() < 0 { "-" } else { "" };
        if (-5..16).contains(&exponent) {
            let after = i64::try_from(text.len()).invariant("a text is shorter than 2^63 bytes")
                - 1
                - exponent;
            let digits = Integer::from_string_base(10, text).invariant("digits are a number");
            let value = Rational::from(digits) * ten(-after);
            let decimals = u32::try_from(after).unwrap_or(0);
            return format!("{sign}{}", value.to_decimal(decimals));
        }
        let (first, rest) = text.split_at(1);
        let point = if rest.is_empty() { "" } else { "." };
        format!("{sign}{first}{point}{rest}e{exponent}")
    }

    /// ⌊log₁₀ |self|⌋, exactly; `None` for 0.
    #[must_use]
    pub fn decimal_exponent(&self) -> Option<i64> {
        if self.is_zero() {
            return None;
        }
        let size = self.abs();
        let bits = |n: Integer| {
            i64::try_from(n.significant_bits()).invariant("a length in bits fits in 63 bits")
        };
        // log₁₀ 2 ≈ 30103/100000: off by little, and the comparisons decide.
        let binary = bits(size.numerator()) - bits(size.denominator());
        let mut exponent = (binary * 30_103).div_euclid(100_000);
        let ten = |e: i64| Rational::from(10).pow(e).invariant("ten is not zero");
        while ten(exponent) > size {
            exponent -= 1;
        }
        while ten(exponent + 1) <= size {
            exponent += 1;
        }
        Some(exponent)
    }

    /// ⌊self⌋.
    #[must_use]
    pub fn floor(&self) -> Integer {
        self.numerator()
            .div_round(self.denominator(), RoundingMode::Floor)
            .0
    }

    /// Built from malachite's own type by the modules next door.
    #[must_use]
    pub fn from_parts(numerator: Integer, power_of_two: i64) -> Rational {
        Rational::from_inner(malachite::Rational::from(numerator) << power_of_two)
    }
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "correct rounding is about exact equality")]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn beyond_the_doubles_the_nearest_is_infinite() {
        let huge = Rational::from_parts(Integer::from(1), 5000);
        let nearest = |value: Rational| nearest_double(1.0, |m| Ok::<_, ()>(value.cmp(m))).unwrap();
        assert_eq!(nearest(huge.clone()), f64::INFINITY);
        assert_eq!(nearest(-huge), f64::NEG_INFINITY);
        // A tie: 2^53 + 1 lies between two doubles.
        assert_eq!(
            nearest(Rational::from((1i64 << 53) + 1)),
            9_007_199_254_740_992.0
        );
        assert_eq!(
            nearest(Rational::from((1i64 << 53) + 3)),
            9_007_199_254_740_996.0
        );
    }

    #[test]
    fn the_largest_doubles_and_beyond() {
        let max = Rational::try_from(f64::MAX).unwrap();
        assert_eq!(max.to_f64(), f64::MAX);
        let half_ulp = Rational::from(2).pow(970).unwrap();
        let below = &max + &half_ulp - Rational::one();
        assert_eq!(below.to_f64(), f64::MAX);
        assert_eq!((&max + &half_ulp).to_f64(), f64::INFINITY);
        assert_eq!((-(&max + &half_ulp)).to_f64(), f64::NEG_INFINITY);
    }

    #[test]
    fn the_smallest_doubles() {
        let tiny = Rational::try_from(f64::from_bits(1)).unwrap();
        assert_eq!(tiny.to_f64(), f64::from_bits(1));
        let half = &tiny / Rational::from(2);
        assert_eq!(half.to_f64(), 0.0);
        let more = &half + &tiny / Rational::from(100);
        assert_eq!(more.to_f64(), f64::from_bits(1));
    }

    proptest! {
        #[test]
        fn the_nearest_double_is_found_from_any_guess(p in any::<i64>(), q in 1..i64::MAX, bits in any::<u64>()) {
            let value = Rational::from(p) / Rational::from(q);
            let guess = f64::from_bits(bits);
            prop_assume!(!guess.is_nan());
            for value in [value.clone(), value * Rational::from_parts(Integer::from(1), -1074)] {
                let found = nearest_double(guess, |m| Ok::<_, ()>(value.cmp(m))).unwrap();
                prop_assert_eq!(found, value.to_f64());
            }
        }

        #[test]
        fn a_double_survives_the_trip(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            match Rational::try_from(value) {
                Ok(q) => prop_assert_eq!(q.to_f64(), value),
                Err(_) => prop_assert!(!value.is_finite()),
            }
        }

        #[test]
        fn rounding_agrees_with_the_standard_library(p in any::<i64>(), places in 0u32..25) {
            let q = Rational::from(p) / Rational::from(10).pow(i64::from(places)).unwrap();
            let text = q.to_decimal(places);
            prop_assert_eq!(q.to_f64(), text.parse::<f64>().unwrap());
        }

        #[test]
        fn rounding_to_decimals_is_within_half_a_unit(p in any::<i64>(), q in 1..i64::MAX, d in 0u32..12) {
            let value = Rational::from(p) / Rational::from(q);
            let rounded = value.round_decimals(d);
            prop_assert_eq!(&value.to_decimal(d).parse::<Rational>().unwrap(), &rounded);
            let unit = Rational::from(10).pow(-i64::from(d)).unwrap();
            prop_assert!((value - rounded).abs() * Rational::from(2) <= unit);
        }
    }
}
