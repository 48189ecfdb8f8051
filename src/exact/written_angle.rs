//! Angles as people and programs write them.

use std::str::FromStr;

use super::{Rational, exact_literal};
use crate::error::{Error, Result};

/// Units of degrees; the last two signs look like the first and are on the keyboards of some countries.
const DEGREES: [&str; 6] = ["degrees", "degree", "deg", "°", "º", "˚"];
const RADIANS: [&str; 3] = ["radians", "radian", "rad"];
/// Names of π, those that contain another one first.
const PI: [&str; 5] = ["numpy.pi", "math.pi", "np.pi", "pi", "π"];

/// An angle as it is written, exactly.
///
/// ```
/// use stellate::exact::{Rational, WrittenAngle};
/// assert_eq!("0.5".parse::<WrittenAngle>()?, WrittenAngle::Plain(Rational::one() / Rational::from(2)));
/// for right_angle in ["pi/2", "(pi/2)", "Pi*0.5", "np.pi/2", "90deg", "90°"] {
///     assert_eq!(right_angle.parse::<WrittenAngle>()?, WrittenAngle::Degrees(Rational::from(90)));
/// }
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum WrittenAngle {
    /// A number without a unit.
    Plain(Rational),
    /// A number of radians, with its unit.
    Radians(Rational),
    /// A number of degrees, or a multiple of π in degrees.
    Degrees(Rational),
}

impl FromStr for WrittenAngle {
    type Err = Error;

    /// A number, with a unit (`0.5rad`, `45deg`, `45°`) or without, or a multiple of π (`pi/4`, `3*pi/2`, `2π`, `pi*2`), with
    /// parentheses round it or not, in capitals or not.
    ///
    /// # Errors
    /// [`Error::Usage`] for anything else.
    fn from_str(text: &str) -> Result<Self> {
        let text = text.trim().to_lowercase();
        let inner = text.strip_prefix('(').and_then(|t| t.strip_suffix(')'));
        let text = inner.map_or(&*text, str::trim);
        if let Some(degrees) = without_one_of(&DEGREES, text) {
            return number(degrees).map(Self::Degrees);
        }
        if let Some(half_turns) = half_turns(text) {
            return half_turns.map(|half| Self::Degrees(half * Rational::from(180)));
        }
        match without_one_of(&RADIANS, text) {
            Some(radians) => number(radians).map(Self::Radians),
            None => number(text).map(Self::Plain),
        }
    }
}

/// The factor of a multiple of π; nothing where π does not occur.
fn half_turns(text: &str) -> Option<Result<Rational>> {
    let text = without_one_of(&RADIANS, text).unwrap_or(text).trim_end();
    let (before, after) = PI.iter().find_map(|name| text.split_once(name))?;
    let factor = match before.trim().trim_end_matches('*').trim_end() {
        "" | "+" => Ok(Rational::one()),
        "-" | "−" => Ok(-Rational::one()),
        factor => number(factor),
    };
    let after = after.trim();
    let second = match (after.strip_prefix('*'), after.strip_prefix('/')) {
        (Some(factor), _) => number(factor),
        (_, Some(divisor)) if !divisor.contains('/') => {
            number(divisor).and_then(|q| q.recip().ok_or_else(wrong))
        }
        _ if after.is_empty() => Ok(Rational::one()),
        _ => Err(wrong()),
    };
    Some(factor.and_then(|a| Ok(a * second?)))
}

fn without_one_of<'t>(units: &[&str], text: &'t str) -> Option<&'t str> {
    units.iter().find_map(|unit| text.strip_suffix(unit))
}

fn number(text: &str) -> Result<Rational> {
    exact_literal(text).map_err(|_| wrong())
}

fn wrong() -> Error {
    Error::Usage("expected an angle such as 0.5 or pi/6, or degrees such as 30deg".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_angle_has_many_spellings() {
        for (degrees, spellings) in [
            (
                30,
                &[
                    "30deg",
                    "30 degrees",
                    "30°",
                    "30º",
                    "30˚",
                    "30 DEG",
                    "(30deg)",
                    "pi/6",
                    "Pi/6",
                    "PI / 6",
                    "math.pi/6",
                ][..],
            ),
            (
                360,
                &[
                    "2pi",
                    "2*pi",
                    "pi*2",
                    "2π",
                    "+2 * np.pi",
                    "numpy.pi*2",
                    "2pi rad",
                ],
            ),
            (
                -135,
                &["-3pi/4", "-3*pi/4", "−135deg", "(-0.75π)", "pi*-3/4"],
            ),
        ] {
            for text in spellings {
                let expected = WrittenAngle::Degrees(Rational::from(degrees));
                assert_eq!(text.parse::<WrittenAngle>().unwrap(), expected, "{text}");
            }
        }
        let half = exact_literal("1/2").unwrap();
        assert_eq!(
            "0.5 rad".parse::<WrittenAngle>().unwrap(),
            WrittenAngle::Radians(half)
        );
    }

    #[test]
    fn what_is_no_angle_is_refused() {
        for text in [
            "", "x", "pi pi", "pi/0", "pi/2/3", "1pi2", "30 degs", "30grad", "(pi", "rad", "30°15'",
        ] {
            assert!(text.parse::<WrittenAngle>().is_err(), "{text}");
        }
    }
}
