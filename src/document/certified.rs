//! Certified bounds for people: few digits, rounded outward.

use crate::error::Invariant;
use crate::exact::Rational;

/// The digits that are shown.
const DIGITS: usize = 4;

/// Two bounds of a number, as `4.695e1 to 4.701e1`: the first one is rounded down and the second one up, so that the number is between
/// what is shown.
///
/// ```
/// use stellate::document::certified_bounds;
/// assert_eq!(certified_bounds(46.9509, 47.0011), "4.695e1 to 4.701e1");
/// assert_eq!(certified_bounds(0.0, 9.9999e-5), "0 to 1.000e-4");
/// ```
#[must_use]
pub fn certified_bounds(low: f64, high: f64) -> String {
    format!("{} to {}", rounded(low, false), rounded(high, true))
}

/// The nearest decimal of four digits that is not below (or not above) a number that is not negative.
fn rounded(value: f64, is_upward: bool) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let text = format!("{value:.*e}", DIGITS - 1);
    let Ok(exact) = Rational::try_from(value) else {
        // Infinities have no digits.
        return value.to_string();
    };
    let shown: Rational = text.parse().invariant("a decimal is a number");
    let is_right = if is_upward {
        shown >= exact
    } else {
        shown <= exact
    };
    if is_right {
        return text;
    }
    // One unit of the last digit farther.
    let (digits, exponent) = text.split_once('e').invariant("the text has an exponent");
    let exponent: i32 = exponent.parse().invariant("an exponent is short");
    let mantissa: u32 = digits
        .replace('.', "")
        .parse()
        .invariant("the digits are a number");
    let (mantissa, exponent) = match (is_upward, mantissa) {
        (true, 9999) => (1000, exponent + 1),
        (true, m) => (m + 1, exponent),
        (false, 1000) => (9999, exponent - 1),
        (false, m) => (m - 1, exponent),
    };
    format!("{}.{:03}e{exponent}", mantissa / 1000, mantissa % 1000)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn what_is_shown_holds_the_number(mantissa in 1.0f64..10.0, exponent in -300i32..300, near in 0u32..3) {
            let value = match near {
                0 => mantissa,
                // On both sides of a power of ten.
                1 => 1.0 + f64::EPSILON,
                _ => 10.0 * (1.0 - f64::EPSILON),
            } * 10f64.powi(exponent);
            let text = certified_bounds(value, value);
            let [low, high] = [0, 1].map(|i| text.split(" to ").nth(i).unwrap().parse::<Rational>().unwrap());
            let exact = Rational::try_from(value).unwrap();
            prop_assert!(low <= exact && exact <= high, "{text}");
            prop_assert!(&high - &low <= exact / Rational::from(500), "{text}");
        }
    }
}
