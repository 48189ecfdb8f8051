//! Readers of points and boxes: numbers that are separated by commas, semicolons or blanks, with or without brackets around
//! them.

use stellate::exact::Rational;
use stellate::fit::{CenterChoice, Column, Columns};
use stellate::inspect::ToleranceZone;
use stellate::picture::Window;
use stellate::verb::{BoxSides, Frame};

use super::Read;
use super::number::{advice, number, positive};

/// The fields of a list.
pub(super) fn fields(text: &str) -> Vec<&str> {
    let text = text.trim();
    let pairs = [('(', ')'), ('[', ']'), ('{', '}')];
    let inner = pairs
        .iter()
        .find_map(|(open, close)| text.strip_prefix(*open)?.strip_suffix(*close))
        .unwrap_or(text);
    match [';', ','].into_iter().find(|mark| inner.contains(*mark)) {
        Some(mark) => inner.split(mark).map(str::trim).collect(),
        None => inner.split_whitespace().collect(),
    }
}

/// Reads one number of a list.
fn coordinate(field: &str, expected: &str) -> Read<Rational> {
    number(field).ok_or_else(|| match advice(field) {
        Some(advice) => format!("{field}: {advice}"),
        None => format!("{field:?} is not a number; {expected}"),
    })
}

/// Reads N numbers.
fn exactly<const N: usize>(text: &str, expected: &str) -> Read<[Rational; N]> {
    let numbers = fields(text).into_iter();
    let numbers = numbers.map(|field| coordinate(field, expected));
    let numbers = numbers.collect::<Read<Vec<_>>>()?;
    numbers.try_into().map_err(|_| expected.into())
}

/// Reads N numbers as doubles.
fn doubles<const N: usize>(text: &str, expected: &str) -> Read<[f64; N]> {
    let numbers = exactly::<N>(text, expected)?.map(|number| number.to_f64());
    let all_finite = numbers.iter().all(|number| number.is_finite());
    all_finite.then_some(numbers).ok_or_else(|| expected.into())
}

/// Reads the center of a fit.
pub(crate) fn center(text: &str) -> Read<CenterChoice> {
    match text.trim().to_ascii_lowercase().as_str() {
        "auto" => Ok(CenterChoice::Auto),
        "centroid" => Ok(CenterChoice::Centroid),
        "kernel" => Ok(CenterChoice::Kernel),
        "best" => Ok(CenterChoice::Best),
        _ if fields(text).len() == 3 => exactly(text, CENTER).map(CenterChoice::InSpace),
        _ => exactly(text, CENTER).map(CenterChoice::Point),
    }
}

/// What a center is expected to be.
const CENTER: &str =
    "expected auto, centroid, kernel, best or X,Y, such as 12.5,-3, or X,Y,Z for a mesh";

/// Reads the columns of x and y of a table.
pub(crate) fn columns(text: &str) -> Read<Columns> {
    text.parse().map_err(|_| {
        "expected two names, or numbers from 1, with a comma between them, such as 2,3 or lon,lat".into()
    })
}

/// Reads a column of a table.
pub(crate) fn column(text: &str) -> Read<Column> {
    text.parse()
        .map_err(|_| "expected a name or a number from 1, such as 3 or weight".into())
}

/// Reads a tolerance, or two limits of the signed distance.
pub(crate) fn tolerance(text: &str) -> Read<ToleranceZone> {
    let expected = "expected a tolerance such as 0.1, or two limits LOW ≤ 0 ≤ HIGH of the signed distance, not both 0, such as -0.02,0.05";
    if fields(text).len() < 2 {
        let tolerance = positive(text)?;
        return ToleranceZone::within(tolerance).map_err(|error| error.to_string());
    }
    // 0,1 may be the number 0.1 as well; -1,2 cannot be a tolerance.
    let is_negative = |text: &str| number(text).is_some_and(|low| low.signum() < 0);
    if !is_negative(fields(text)[0])
        && let Some(advice) = advice(text)
    {
        let limits = text.replacen(',', ";", 1);
        return Err(match limits.parse::<ToleranceZone>() {
            Ok(zone) => {
                format!("{advice}; the limits {zone} are written with a semicolon: {limits}")
            }
            Err(_) => advice,
        });
    }
    let [low, high] = exactly(text, expected)?;
    ToleranceZone::new(low, high).map_err(|_| expected.into())
}

/// Reads a point that is inspected. Its coordinates remain texts, which are read exactly later.
pub(crate) fn point(text: &str) -> Read<String> {
    let expected = "expected X,Y,Z, such as 0.8,0.6,0, or X,Y for a plane curve";
    let fields = fields(text);
    for field in &fields {
        coordinate(field, expected)?;
    }
    match fields.len() {
        2 | 3 => Ok(fields.join(",")),
        _ => Err(expected.into()),
    }
}

/// Reads a point that is marked in a picture.
pub(crate) fn marked_point(text: &str) -> Read<[f64; 3]> {
    doubles(text, "expected X,Y,Z, such as 0.8,0.6,0")
}

/// Reads the part of the plane or of space that a picture shows.
pub(crate) fn frame(text: &str) -> Read<Frame> {
    if fields(text).len() > 4 {
        return space_window(text).map(Frame::Space);
    }
    let expected = "expected X0,X1,Y0,Y1 with X0 < X1 and Y0 < Y1, such as -1,1,-1,1";
    let [x0, x1, y0, y1] = doubles(text, expected)?;
    if x0 < x1 && y0 < y1 {
        let (x, y) = ([x0, x1], [y0, y1]);
        Ok(Frame::Plane(Window { x, y }))
    } else {
        Err(expected.into())
    }
}

/// Reads a box in space.
pub(crate) fn space_window(text: &str) -> Read<BoxSides> {
    let expected = "expected X0,X1,Y0,Y1,Z0,Z1 with X0 < X1 and so on, such as -1,1,-1,1,0,2";
    let [x0, x1, y0, y1, z0, z1] = doubles(text, expected)?;
    if x0 < x1 && y0 < y1 && z0 < z1 {
        Ok([[x0, x1], [y0, y1], [z0, z1]])
    } else {
        Err(expected.into())
    }
}
