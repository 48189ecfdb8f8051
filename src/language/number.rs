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

/// The point that a form is relative to: that of a form in the plane, or in space.
#[derive(Clone, Debug)]
pub(crate) enum WrittenCenter {
    Plane([Rational; 2]),
    Space([Rational; 3]),
}

impl WrittenCenter {
    /// The center of a form in the plane, or the reason why it is none.
    pub(crate) fn in_plane(self) -> std::result::Result<[Rational; 2], &'static str> {
        match self {
            Self::Plane(point) => Ok(point),
            Self::Space(_) => Err(
                "a center of three coordinates belongs to a surface, this is a form in the plane: expected one such as `1/2, -3`",
            ),
        }
    }

    /// The center of a surface, or the reason why it is none.
    pub(crate) fn in_space(self) -> std::result::Result<[Rational; 3], &'static str> {
        match self {
            Self::Space(point) => Ok(point),
            Self::Plane(_) => Err(
                "a center of two coordinates belongs to a plane curve, this is a surface: expected one such as `1/2, -3, 0`",
            ),
        }
    }
}

/// The point `p/q, p/q` or `p/q, p/q, p/q` that a `# center:` comment gives.
pub(crate) fn written_center(
    text: &str,
    numbers: Numbers,
) -> std::result::Result<WrittenCenter, String> {
    let parts: Vec<&str> = text.split(',').collect();
    let number = |part: &str| written_number(part, numbers);
    match parts[..] {
        [x, y] => Ok(WrittenCenter::Plane([number(x)?, number(y)?])),
        [x, y, z] => Ok(WrittenCenter::Space([number(x)?, number(y)?, number(z)?])),
        _ => Err("expected a center such as `1/2, -3`, or `1/2, -3, 0` in space".to_owned()),
    }
}

/// The value of a number at a place in a data file; the error names the place.
pub(crate) fn number_at(place: &str, text: &str, numbers: Numbers) -> Result<Rational> {
    written_number(text, numbers).map_err(|message| Error::data(place, message))
}
