//! Numbers, angles, boxes and ranges in options.

use stellate::error::{Error, Result};
use stellate::picture::Window;
use stellate::sample::Direction;
use stellate::verb::{ArcSearch, Bounds, Frame};

use super::flags::ArcFlags;

/// N finite numbers with commas between them.
pub(crate) fn numbers_of<const N: usize>(text: &str) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|t| t.trim().parse().ok()).collect();
    let numbers: [f64; N] = numbers?.try_into().ok()?;
    numbers.iter().all(|v| v.is_finite()).then_some(numbers)
}

/// `--window` of a picture, in the plane or in space.
pub(crate) fn frame(text: &str) -> Result<Frame> {
    if text.split(',').count() > 4 {
        return space_window(text).map(Frame::Space);
    }
    match numbers_of::<4>(text) {
        Some([x0, x1, y0, y1]) if x0 < x1 && y0 < y1 => Ok(Frame::Plane(Window {
            x: [x0, x1],
            y: [y0, y1],
        })),
        _ => Err(Error::Usage(format!(
            "--window {text}: expected X0,X1,Y0,Y1 with X0 < X1 and Y0 < Y1, such as -1,1,-1,1"
        ))),
    }
}

/// `--window` in space.
pub(crate) fn space_window(text: &str) -> Result<Bounds> {
    let wrong = || {
        Error::Usage(format!(
            "--window {text}: expected X0,X1,Y0,Y1,Z0,Z1 with X0 < X1 and so on, such as -1,1,-1,1,0,2"
        ))
    };
    let [x0, x1, y0, y1, z0, z1] = numbers_of::<6>(text).ok_or_else(wrong)?;
    if x0 < x1 && y0 < y1 && z0 < z1 {
        Ok([[x0, x1], [y0, y1], [z0, z1]])
    } else {
        Err(wrong())
    }
}

/// How arcs of an intersection are followed.
pub(crate) fn arc_search(flags: &ArcFlags) -> Result<ArcSearch> {
    let window = flags.window.as_deref().map(space_window).transpose()?;
    Ok(ArcSearch::default()
        .window(window)
        .resolution(flags.resolution))
}

/// The angles of a flag that may be repeated.
pub(crate) fn angles(flag: &str, texts: &[String]) -> Result<Vec<Direction>> {
    texts.iter().map(|text| angle(flag, text)).collect()
}

/// An angle as it is typed or printed.
fn angle(flag: &str, text: &str) -> Result<Direction> {
    text.parse()
        .map_err(|error| Error::Usage(format!("{flag} {text}: {error}")))
}

/// `--range NAME=A,B`
pub(crate) fn range(text: &str) -> Result<(String, [f64; 2])> {
    let read = || {
        let (name, numbers) = text.split_once('=')?;
        let [a, b] = numbers_of::<2>(numbers)?;
        (a < b).then(|| (name.trim().to_owned(), [a, b]))
    };
    read().ok_or_else(|| {
        Error::Usage(format!(
            "--range {text}: expected NAME=A,B with A < B, such as t=-2,2"
        ))
    })
}

/// `--view AZIMUTH,ELEVATION`
pub(crate) fn view(text: &str) -> Result<[f64; 2]> {
    let found = numbers_of::<2>(text).filter(|[_, elevation]| elevation.abs() < 90.0);
    found.ok_or_else(|| {
        Error::Usage(format!(
            "--view {text}: expected AZIMUTH,ELEVATION in degrees, such as 30,25, with the elevation between -90 and 90"
        ))
    })
}

/// `--point X,Y,Z` of a picture
pub(crate) fn point(text: &str) -> Result<[f64; 3]> {
    numbers_of::<3>(text)
        .ok_or_else(|| Error::Usage(format!("--point {text}: expected X,Y,Z, such as 0.8,0.6,0")))
}
