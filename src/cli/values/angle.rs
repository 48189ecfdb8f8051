//! Readers of angles, and of ranges of parameters and views, which have angles in them.

use std::f64::consts::{PI, TAU};

use stellate::exact::WrittenAngle;
use stellate::sample::Direction;

use super::Read;
use super::list::fields;

/// An angle of an option that may be repeated.
#[derive(Clone, Debug)]
pub(crate) struct Angle {
    pub(crate) direction: Direction,
    /// The text of a number that is so large that degrees may be meant.
    pub(crate) doubtful: Option<String>,
}

/// Reads an angle; a number without a unit is in radians.
pub(crate) fn angle(text: &str) -> Read<Angle> {
    let direction: Direction = text.parse().map_err(|wrong| match fields(text).len() {
        0 | 1 => format!("{wrong}"),
        _ => "expected one angle, such as 0.5, pi/6 or 30deg; for several the option is repeated"
            .into(),
    })?;
    let is_plain = matches!(text.parse(), Ok(WrittenAngle::Plain(_)));
    let doubtful = (is_plain && direction.theta().abs() > TAU).then(|| text.trim().into());
    Ok(Angle {
        direction,
        doubtful,
    })
}

/// Reads an angle in degrees; a number without a unit is in degrees.
pub(crate) fn degrees(text: &str) -> Read<f64> {
    in_degrees(text).ok_or_else(|| "expected degrees such as 20, or an angle such as pi/9".into())
}

fn in_degrees(text: &str) -> Option<f64> {
    let degrees = match text.parse().ok()? {
        WrittenAngle::Plain(degrees) | WrittenAngle::Degrees(degrees) => degrees.to_f64(),
        WrittenAngle::Radians(radians) => radians.to_f64() / PI * 180.0,
    };
    Some(degrees).filter(|degrees| degrees.is_finite())
}

fn in_radians(text: &str) -> Option<f64> {
    let radians = match text.parse().ok()? {
        WrittenAngle::Plain(radians) | WrittenAngle::Radians(radians) => radians.to_f64(),
        WrittenAngle::Degrees(degrees) => degrees.to_f64() / 180.0 * PI,
    };
    Some(radians).filter(|radians| radians.is_finite())
}

/// Reads the range of a parameter; its ends may be angles.
pub(crate) fn range(text: &str) -> Read<(String, [f64; 2])> {
    let read = || {
        let (name, ends) = text.split_once('=')?;
        let (a, b) = match (ends.split_once(".."), &fields(ends)[..]) {
            (Some(ends), _) => ends,
            (None, &[a, b]) => (a, b),
            _ => return None,
        };
        let name = match name.trim() {
            "θ" => "theta",
            "φ" | "ϕ" => "phi",
            name => name,
        };
        let [a, b] = [in_radians(a)?, in_radians(b)?];
        (a < b).then(|| (name.to_owned(), [a, b]))
    };
    read().ok_or_else(|| "expected NAME=A,B with A < B, such as t=-2,2 or t=0,2pi".into())
}

/// Reads the direction of the eye.
pub(crate) fn view(text: &str) -> Read<[f64; 2]> {
    let found = match fields(text)[..] {
        [azimuth, elevation] => in_degrees(azimuth).zip(in_degrees(elevation)),
        _ => None,
    };
    let found = found.filter(|(_, elevation)| elevation.abs() < 90.0);
    found.map(<[f64; 2]>::from).ok_or_else(|| {
        "expected AZIMUTH,ELEVATION in degrees, such as 30,25, with the elevation between -90 and 90"
            .into()
    })
}
