//! Exact numbers are rounded to the nearest double and to the nearest decimal.

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Abs, DivRound, Pow};
use malachite::base::num::conversion::traits::{FromStringBase, RoundingFrom};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode;

use super::Rational;
use crate::error::{Invariant, broken};

/// The double nearest to a real number x, where `compare` compares x with any rational number.
///
/// Ties are rounded to even. A number that is too large for a double becomes ±∞. A zero has the sign of `guess`.
///
/// Cost: two comparisons if the guess is right, about 2 log₂ n comparisons if it is n doubles away.
pub(crate) fn nearest_double<E>(
    guess: f64,
    compare: impl Fn(&Rational) -> Result<Ordering, E>,
) -> Result<f64, E> {
    let infinity = rank(f64::INFINITY);
    // `above(rank)` compares x with the midpoint between the double of this rank and the next one. The answer is the lowest
    // double for which x is not greater than this midpoint.
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

/// The rank of a double among all doubles: 0 for ±0, and one more for each next larger double.
fn rank(double: f64) -> i64 {
    let magnitude = double.abs().to_bits().cast_signed();
    if double < 0.0 { -magnitude } else { magnitude }
}

fn of_rank(rank: i64) -> f64 {
    let magnitude = f64::from_bits(rank.unsigned_abs());
    if rank < 0 { -magnitude } else { magnitude }
}

/// The decimal exponent ⌊log₁₀ q⌋ of a number q, where 2^(binary − 1) < q < 2^(binary + 1), with an error of at most 1 if
/// |`binary`| is at most 10^9. The factor needs its eleven digits: 0.30103 instead is wrong by 1.4 at 10^(10^8).
fn decimal_of_binary(binary: i64) -> i64 {
    let decimal = (i128::from(binary) * 30_102_999_566).div_euclid(100_000_000_000);
    i64::try_from(decimal).invariant("a decimal exponent is smaller than the binary one")
}

/// The number half an ulp above the largest double, which is (2^53 − 1) 2^971. Numbers from here on are rounded to ∞.
fn beyond_all_doubles() -> Rational {
    Rational::from_dyadic(Integer::from((1_i64 << 54) - 1), 970)
}

/// The exact midpoint of two neighbouring doubles; beyond the largest, half an ulp above it.
fn midpoint(a: f64, b: f64) -> Rational {
    match (Rational::try_from(a), Rational::try_from(b)) {
        (Ok(a), Ok(b)) => (a + b) / Rational::from(2),
        (Ok(_), Err(_)) => beyond_all_doubles(),
        (Err(_), Ok(_)) => -beyond_all_doubles(),
        (Err(_), Err(_)) => broken("of two neighbouring doubles one is finite"),
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
        f64::rounding_from(self.inner(), RoundingMode::Nearest).0
    }

    /// The nearest multiple of 10^−`decimals` (ties to even).
    #[must_use]
    pub fn round_decimals(&self, decimals: u32) -> Rational {
        let scale = Rational::whole(Integer::from(10).pow(u64::from(decimals)));
        let rounded = Integer::rounding_from((self * &scale).inner(), RoundingMode::Nearest).0;
        Rational::whole(rounded) / scale
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
        let scaled = self * &Rational::whole(&scale);
        let rounded = Integer::rounding_from(scaled.inner(), RoundingMode::Nearest).0;
        let sign = if rounded < 0 { "-" } else { "" };
        let digits = (&rounded).abs().to_string();
        // The width of a format is at most 65 535.
        let missing = (decimals as usize + 1).saturating_sub(digits.len());
        let padded = "0".repeat(missing) + &digits;
        let (whole, fraction) = padded.split_at(padded.len() - decimals as usize);
        if fraction.is_empty() {
            format!("{sign}{whole}")
        } else {
            format!("{sign}{whole}.{fraction}")
        }
    }

    /// Decimal text with `digits` significant digits, correctly rounded (ties to even), without zeros at the end. It has an
    /// exponent if the number is below 10^−5 or at least 10^16.
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
            // The number was rounded up to the next power of ten.
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
            let value = Rational::whole(digits) * ten(-after);
            let decimals = u32::try_from(after.max(0)).invariant("few digits follow the point");
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
        let binary = bits(size.numerator()) - bits(size.denominator());
        // The first value is only a guess; the comparisons make it exact.
        let mut exponent = decimal_of_binary(binary);
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
    pub fn floor(&self) -> Self {
        Self::whole(self.floor_integer())
    }

    /// ⌊self⌋ as malachite's integer.
    pub(crate) fn floor_integer(&self) -> Integer {
        self.numerator()
            .div_round(self.denominator(), RoundingMode::Floor)
            .0
    }

    /// `numerator · 2^power_of_two`.
    pub(crate) fn from_dyadic(numerator: Integer, power_of_two: i64) -> Rational {
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
        let huge = Rational::from_dyadic(Integer::from(1), 5000);
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
    fn decimals_are_as_many_as_are_asked_for() {
        let tenth: Rational = "-1/10".parse().unwrap();
        assert_eq!(
            tenth.to_decimal(70_000),
            format!("-0.1{}", "0".repeat(69_999))
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

    /// Finite doubles: random ones, and those at the ends of a binade, of the subnormal doubles, and of all doubles.
    fn double() -> impl Strategy<Value = f64> {
        let power = (0_u64..0x7FF, 0_u64..3).prop_map(|(exponent, more)| (exponent << 52) + more);
        let before = (1_u64..0x7FF, 1_u64..3).prop_map(|(exponent, less)| (exponent << 52) - less);
        let end = prop::sample::select(vec![0, 1, 2, 3, (1 << 52) - 1, 1 << 52]);
        let top = (0_u64..4).prop_map(|less| f64::MAX.to_bits() - less);
        let bits = prop_oneof![
            0..=f64::MAX.to_bits(),
            0_u64..1 << 53,
            power,
            before,
            end,
            top
        ];
        (bits, any::<bool>()).prop_map(|(bits, negative)| {
            let size = f64::from_bits(bits.min(f64::MAX.to_bits()));
            if negative { -size } else { size }
        })
    }

    /// Numbers that are much smaller than 1: 0, powers of two, and those whose low bits are all 0, all 1 or random.
    fn tiny() -> impl Strategy<Value = Rational> {
        let power = |bits: i64| Rational::from_dyadic(Integer::from(1), -bits);
        let one_bit = prop_oneof![Just(60_i64), 2_i64..70, 100_i64..2000].prop_map(power);
        let limb = prop_oneof![Just(0), Just(u64::MAX), any::<u64>()];
        let long = prop::collection::vec(limb, 2..32).prop_map(move |limbs| {
            let bits = 64 * i64::try_from(limbs.len()).unwrap();
            let size = Integer::from(malachite::Natural::from_owned_limbs_asc(limbs));
            Rational::from_dyadic(size, -bits) * power(7)
        });
        prop_oneof![Just(Rational::zero()), one_bit, long]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]
        /// Numbers at and next to doubles and the midpoints between them. Of the two doubles of a tie, the one with the even
        /// last bit is nearest.
        #[test]
        fn numbers_beside_midpoints_are_rounded_to_the_right_side(
            double in double(), tiny in tiny(), at in 0..4, guess in any::<u64>(), steps in -70_i64..70,
        ) {
            let above = double.next_up();
            let exact = Rational::try_from(double).unwrap();
            // The distance to the next double, or to where it would be if there were one.
            let gap = Rational::try_from(above).map_or_else(|_| Rational::from_dyadic(Integer::from(1), 971), |above| above - &exact);
            let half = Rational::one() / Rational::from(2);
            let part = match at {
                0 => tiny.clone(),
                1 => &half - &tiny,
                2 => &half + &tiny,
                _ => Rational::one() - &tiny,
            };
            let is_even = double.to_bits().is_multiple_of(2);
            let expected = match part.cmp(&half) {
                Ordering::Less => double,
                Ordering::Equal if is_even => double,
                Ordering::Equal | Ordering::Greater => above,
            };
            let value = exact + gap * part;
            prop_assert_eq!(value.to_f64(), expected);
            prop_assert_eq!((-&value).to_f64(), -expected);
            let beside = of_rank(rank(double).saturating_add(steps.signum() * (1_i64 << steps.unsigned_abs().min(62))).clamp(-rank(f64::INFINITY), rank(f64::INFINITY)));
            for guess in [double, above, beside, f64::from_bits(guess), 0.0, -f64::MAX, f64::INFINITY] {
                if guess.is_nan() {
                    continue;
                }
                let found = nearest_double(guess, |m| Ok::<_, ()>(value.cmp(m))).unwrap();
                prop_assert_eq!(found, expected);
                let found = nearest_double(guess, |m| Ok::<_, ()>((-&value).cmp(m))).unwrap();
                prop_assert_eq!(found, -expected);
            }
        }

        /// Numbers at and next to decimals and the midpoints between them.
        #[test]
        fn decimals_beside_midpoints_are_rounded_to_the_right_side(
            limbs in prop::collection::vec(any::<u64>(), 0..20), negative in any::<bool>(), tiny in tiny(), side in -1..2, decimals in 0_u32..40,
        ) {
            let size = Integer::from(malachite::Natural::from_owned_limbs_asc(limbs));
            let below = if negative { -size } else { size };
            let unit = Rational::from(10).pow(-i64::from(decimals)).unwrap();
            let half = Rational::one() / Rational::from(2);
            let value = (Rational::whole(&below) + half + tiny.clone() * Rational::from(side)) * &unit;
            use malachite::base::num::arithmetic::traits::Parity;
            let is_above = match side * i32::from(tiny.signum()) {
                0 => below.odd(),
                side => side > 0,
            };
            let expected = Rational::whole(below + Integer::from(u8::from(is_above))) * unit;
            prop_assert_eq!(&value.round_decimals(decimals), &expected);
            let text = value.to_decimal(decimals);
            prop_assert_eq!(text.parse::<Rational>().unwrap(), expected);
            let after = text.split_once('.').map_or(0, |(_, fraction)| fraction.len());
            prop_assert_eq!(after, usize::try_from(decimals).unwrap());
            // The text has a digit before the point, and a sign only if a digit is not 0.
            prop_assert!(text.trim_start_matches('-').starts_with(|c: char| c.is_ascii_digit()));
            prop_assert_eq!(text.starts_with('-'), text.parse::<Rational>().unwrap().signum() < 0);
        }

        /// Numbers next to powers of ten and to midpoints, with exponents around every change of the notation.
        #[test]
        fn significant_digits_are_those_of_the_nearest_decimal(
            lead in 1_u64..100_000, exponent in -30_i64..30, half in any::<bool>(), tiny in tiny(), side in -1..2, digits in 1_u32..8,
        ) {
            let ten = |e: i64| Rational::from(10).pow(e).unwrap();
            let middle = Rational::from(i64::try_from(lead).unwrap()) + Rational::from(i32::from(half)) / Rational::from(2);
            let value = (middle + tiny * Rational::from(side)) * ten(exponent);
            let text = value.to_significant(digits);
            let found: Rational = text.parse().unwrap();
            let unit = ten(value.decimal_exponent().unwrap() + 1 - i64::from(digits));
            let error = (&found - &value).abs() * Rational::from(2);
            prop_assert!(error <= unit);
            let in_units = &found / &unit;
            prop_assert!(in_units.is_integer());
            use malachite::base::num::arithmetic::traits::Parity;
            prop_assert!(error < unit || in_units.numerator().even());
            // A number is written in full from 10^-5 to below 10^16. A fraction, and the digits before an exponent, do not end
            // with 0.
            let exponent = found.decimal_exponent().unwrap();
            prop_assert_eq!(text.contains('e'), !(-5..16).contains(&exponent));
            let mantissa = text.split('e').next().unwrap();
            prop_assert!(!mantissa.contains('.') || !mantissa.ends_with(['0', '.']));
            prop_assert_eq!((-&value).to_significant(digits), format!("-{text}"));
        }

        #[test]
        fn decimal_exponents_are_exact_at_powers_of_ten(exponent in -700_i64..700, tiny in tiny(), side in -1..2) {
            let ten = |e: i64| Rational::from(10).pow(e).unwrap();
            let value = ten(exponent) * (Rational::one() + tiny.clone() * Rational::from(side));
            let expected = if side < 0 && !tiny.is_zero() { exponent - 1 } else { exponent };
            prop_assert_eq!(value.decimal_exponent(), Some(expected));
            prop_assert_eq!((-value).decimal_exponent(), Some(expected));
        }
    }

    #[test]
    fn guesses_of_decimal_exponents_are_at_most_one_off() {
        // log₁₀ 2 is approximated from above and from below: 10^(10^8) has 332 192 810 bits.
        for (binary, decimal) in [
            (0, 0),
            (332_192_809, 100_000_000),
            (-332_192_809, -100_000_000),
        ] {
            assert!((decimal_of_binary(binary) - decimal).abs() <= 1);
        }
        for exponent in [1_i64, 20, 300, 5000, 60_000] {
            for sign in [1, -1] {
                let value = Rational::from(10).pow(sign * exponent).unwrap();
                let bits = |n: Integer| n.significant_bits().cast_signed();
                let binary = bits(value.numerator()) - bits(value.denominator());
                assert!((decimal_of_binary(binary) - sign * exponent).abs() <= 1);
                assert_eq!(value.decimal_exponent(), Some(sign * exponent));
            }
        }
    }

    proptest! {
        #[test]
        fn the_nearest_double_is_found_from_any_guess(p in any::<i64>(), q in 1..i64::MAX, bits in any::<u64>()) {
            let value = Rational::from(p) / Rational::from(q);
            let guess = f64::from_bits(bits);
            prop_assume!(!guess.is_nan());
            for value in [value.clone(), value * Rational::from_dyadic(Integer::from(1), -1074)] {
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
        fn the_floor_is_the_largest_integer_that_is_not_above(p in any::<i64>(), q in prop_oneof![Just(1), 1..100_i64, 1..i64::MAX]) {
            let value = Rational::from(p) / Rational::from(q);
            let floor = value.floor();
            prop_assert!(floor <= value && value < floor + Rational::one());
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
