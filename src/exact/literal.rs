//! Numbers in the notations of people and programs are read.

use std::str::FromStr;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::conversion::traits::FromStringBase;

use super::Rational;
use crate::error::{Error, Invariant, Result};

/// The largest decimal exponent: `1e999999999` would not fit in memory.
const MAX_EXPONENT: i64 = 100_000;

/// The exact value of `text`: an integer `-12`, a decimal `0.1` (one tenth) or `1e-5`, a fraction
/// `p/q` of any of these, or a hexadecimal float `0x1.8p+1`.
///
/// ```
/// use stellate::exact::exact_literal;
/// assert_eq!(exact_literal("1e-5").unwrap().to_string(), "1/100000");
/// assert_eq!(exact_literal("-2.50/5").unwrap().to_string(), "-1/2");
/// assert_eq!(exact_literal("0x1.8p+1").unwrap().to_string(), "3");
/// ```
///
/// # Errors
/// [`Error::Syntax`] if the text is none of these, if a denominator is 0, or if an exponent is
/// beyond ±100 000.
pub fn exact_literal(text: &str) -> Result<Rational> {
    let trimmed = text.trim();
    match trimmed.split_once('/') {
        None => simple(trimmed, text),
        Some((p, q)) => {
            let (p, q) = (simple(p.trim(), text)?, simple(q.trim(), text)?);
            if q.is_zero() {
                return Err(wrong(text, "the denominator is 0"));
            }
            Ok(p / q)
        }
    }
}

/// The exact value of the double that is nearest to a decimal number, or of a hexadecimal float.
///
/// ```
/// use stellate::exact::double_literal;
/// assert_eq!(double_literal("0.1").unwrap().to_string(), "3602879701896397/36028797018963968");
/// ```
///
/// # Errors
/// [`Error::Syntax`] if the text is not a finite number.
pub fn double_literal(text: &str) -> Result<Rational> {
    Ok(exact_literal(text)?.to_f64()).and_then(|double| {
        Rational::try_from(double).map_err(|_| wrong(text, "too large for a double"))
    })
}

/// A double as a hexadecimal float with all its bits, in the notation of C's `%a` and Python's `float.fromhex`; `inf`, `-inf`
/// or `nan` if it is not finite.
///
/// ```
/// use stellate::exact::hex_literal;
/// assert_eq!(hex_literal(0.1), "0x1.999999999999ap-4");
/// assert_eq!([hex_literal(-3.0), hex_literal(0.0)], ["-0x1.8p+1", "0x0p+0"]);
/// ```
#[must_use]
pub fn hex_literal(double: f64) -> String {
    const FRACTION_BITS: u64 = 52;
    let sign = if double.is_sign_negative() { "-" } else { "" };
    if !double.is_finite() {
        return if double.is_nan() {
            "nan".into()
        } else {
            format!("{sign}inf")
        };
    }
    let bits = double.abs().to_bits();
    let fraction = bits & ((1 << FRACTION_BITS) - 1);
    // Subnormal numbers have the exponent of the smallest normal number, and no leading 1.
    let (lead, exponent) = match bits >> FRACTION_BITS {
        0 if fraction == 0 => (0, 0),
        0 => (0, -1022),
        biased => (1, biased.cast_signed() - 1023),
    };
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x{lead}{point}{digits}p{exponent:+}")
}

fn simple(text: &str, whole: &str) -> Result<Rational> {
    let (negative, digits) = match text.strip_prefix(['-', '−']) {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let value = match digits
        .strip_prefix("0x")
        .or_else(|| digits.strip_prefix("0X"))
    {
        Some(hex) => radix(hex, 16, &['p', 'P'], whole)?,
        None => radix(digits, 10, &['e', 'E'], whole)?,
    };
    Ok(if negative { -value } else { value })
}

/// Reads `digits[.digits][mark exponent]` in base 10 or 16. The exponent is a power of 10 or of 2.
fn radix(text: &str, base: u8, marks: &[char], whole: &str) -> Result<Rational> {
    let (mantissa, exponent) = match text.split_once(marks) {
        None => (text, 0),
        Some((m, e)) => {
            let e = i64::from_str(e.strip_prefix('+').unwrap_or(e))
                .map_err(|_| wrong(whole, "the exponent is not an integer"))?;
            (m, e)
        }
    };
    if exponent.abs() > MAX_EXPONENT {
        return Err(wrong(whole, "the exponent is beyond ±100000"));
    }
    let (integer, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{integer}{fraction}");
    let all_digits = digits.chars().all(|c| c.is_digit(u32::from(base)));
    if digits.is_empty() || !all_digits {
        return Err(wrong(
            whole,
            "expected a number such as 3, 0.1, 1e-5, 1/3 or 0x1.8p+1",
        ));
    }
    let value = Integer::from_string_base(base, &digits)
        .ok_or_else(|| wrong(whole, "expected a number"))?;
    let places = fraction.len() as u64;
    let below = Rational::whole(Integer::from(base).pow(places));
    let two_or_ten = Rational::whole(if base == 10 { 10 } else { 2 });
    let scale = two_or_ten.pow(exponent).invariant("a base is not zero");
    Ok(Rational::whole(value) * scale / below)
}

fn wrong(text: &str, message: &str) -> Error {
    Error::Syntax {
        message: message.into(),
        source_name: "number".into(),
        text: text.into(),
        at: 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_are_what_is_written() {
        for (text, value) in [
            ("0.1", "1/10"),
            ("-0.50", "-1/2"),
            (".5", "1/2"),
            ("2.", "2"),
            ("−3", "-3"),
            ("1E+3", "1000"),
            ("1/3", "1/3"),
            ("0.1/0.3", "1/3"),
            ("0x1p-2", "1/4"),
            ("-0xA.8P1", "-21"),
        ] {
            assert_eq!(exact_literal(text).unwrap().to_string(), value, "{text}");
        }
    }

    proptest! {
        #[test]
        fn a_hexadecimal_float_is_the_double_bit_for_bit(bits in any::<u64>()) {
            let double = f64::from_bits(bits);
            match Rational::try_from(double) {
                Ok(exact) => prop_assert_eq!(exact_literal(&hex_literal(double)).unwrap(), exact),
                Err(_) => prop_assert!(exact_literal(&hex_literal(double)).is_err()),
            }
        }
    }

    #[test]
    fn what_is_not_a_number_is_refused() {
        for text in [
            "",
            "x",
            "1/0",
            "1e",
            "1e99999999999",
            "0x",
            "1.2.3",
            "--1",
            "nan",
            "1_000",
            ".",
        ] {
            assert!(exact_literal(text).is_err(), "{text}");
        }
        assert!(double_literal("1e400").is_err());
    }
}
