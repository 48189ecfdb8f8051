//! The exact value of a literal.

use malachite::Integer;
use malachite::base::num::conversion::traits::FromStringBase;

use super::budget::MAX_DIGITS;
use crate::error::{Error, Result};
use crate::exact::{Rational, double_literal, exact_literal};

/// How the numbers of a text are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Numbers {
    /// Numbers have the value that is written: `0.1` is 1/10.
    #[default]
    Exact,
    /// Numbers are rounded to the nearest doubles, and the values of these are exact. This is meant for data of a float
    /// program.
    F64,
}

const EXPECTED: &str = "expected a number such as 3, 0.1, 1e-5, 1/3 or 0x1.8p+1";

/// The value of one literal without sign, or what is wrong with it.
pub(crate) fn literal(text: &str, numbers: Numbers) -> std::result::Result<Rational, String> {
    if text.len() > MAX_DIGITS {
        return Err(format!("a number of more than {MAX_DIGITS} digits"));
    }
    if numbers == Numbers::Exact && !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit()) {
        return match Integer::from_string_base(10, text) {
            Some(value) => Ok(Rational::whole(value)),
            None => Err("expected a number".into()),
        };
    }
    if !text.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
        return Err(EXPECTED.into());
    }
    // A typographic minus may stand in the exponent.
    let ascii = text.replace('−', "-");
    let value = match numbers {
        Numbers::Exact => exact_literal(&ascii),
        Numbers::F64 => double_literal(&ascii),
    };
    value.map_err(|error| match error {
        Error::Syntax { message, .. } => message,
        other => other.to_string(),
    })
}

/// The value of a number in a document or a comment: `p`, `p/q`, a decimal or a hexadecimal float, with a sign. In a fraction,
/// p and q are read separately.
pub(crate) fn written_number(
    text: &str,
    numbers: Numbers,
) -> std::result::Result<Rational, String> {
    let signed = |part: &str| {
        let part = part.trim();
        match part.strip_prefix(['-', '−']) {
            Some(digits) if !digits.starts_with(['-', '−', '+']) => {
                literal(digits, numbers).map(|value| -value)
            }
            Some(_) => Err("two signs".into()),
            None => literal(part, numbers),
        }
    };
    if text.trim().is_empty() {
        return Err(EXPECTED.into());
    }
    let Some((p, q)) = text.split_once('/') else {
        return signed(text);
    };
    if q.contains('/') {
        return Err("two fraction bars".into());
    }
    let (p, q) = (signed(p)?, signed(q)?);
    if q.is_zero() {
        return Err("the denominator is 0".into());
    }
    Ok(p / q)
}

/// The point `p/q, p/q` that a `# center:` comment gives.
pub(crate) fn written_point(
    text: &str,
    numbers: Numbers,
) -> std::result::Result<[Rational; 2], String> {
    let expected = || "expected a center such as `1/2, -3`".to_owned();
    let (x, y) = text.split_once(',').ok_or_else(expected)?;
    Ok([written_number(x, numbers)?, written_number(y, numbers)?])
}

/// The center of a surface, `p/q, p/q, p/q`.
pub(super) fn written_coordinates(
    text: &str,
    numbers: Numbers,
) -> std::result::Result<[Rational; 3], String> {
    let parts: Vec<&str> = text.split(',').collect();
    let [x, y, z] = parts[..] else {
        return Err("expected a center such as `1/2, -3, 0`".to_owned());
    };
    Ok([
        written_number(x, numbers)?,
        written_number(y, numbers)?,
        written_number(z, numbers)?,
    ])
}

/// The value of a number at a place in a data file; the error names the place.
pub(crate) fn number_at(place: &str, text: &str, numbers: Numbers) -> Result<Rational> {
    written_number(text, numbers).map_err(|message| Error::data(place, message))
}
