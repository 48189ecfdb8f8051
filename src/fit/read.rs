//! Outlines are read from files.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use super::rows::read_rows;
#[cfg(feature = "images")]
use super::silhouette::trace_silhouette;
use super::{LeftOut, PictureOptions};
use crate::error::{Error, Result};
use crate::shape::Contour;

/// The largest number of bytes that are read from one file.
const MAX_BYTES: u64 = 1 << 30;

/// The kind of a file that holds an outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ContourKind {
    /// Rows `x,y`.
    Rows,
    /// A picture of a silhouette on a plain background.
    Image,
}

impl ContourKind {
    /// The kind that the extension of a file means, in upper or lower case: `csv`, `tsv`, `dat`, `xy` for rows; `png`, `jpg`,
    /// `jpeg`, `bmp` for a picture.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "csv" | "tsv" | "dat" | "xy" => Some(Self::Rows),
            "png" | "jpg" | "jpeg" | "bmp" => Some(Self::Image),
            _ => None,
        }
    }
}

/// Reads the outline in a file: see [`contour_from_reader`].
///
/// # Errors
/// [`Error::Io`] if the file cannot be read, [`Error::Usage`] if its extension is not one of [`ContourKind::of`], and those of
/// [`contour_from_reader`].
pub fn read_contour(path: &Path) -> Result<Contour> {
    let kind = ContourKind::of(path).ok_or_else(|| {
        Error::Usage(format!(
            "{}: an outline is read from .csv, .png, .jpg, .jpeg or .bmp",
            path.display()
        ))
    })?;
    let file = File::open(path).map_err(|source| Error::Io {
        path: path.into(),
        source,
    })?;
    contour_from_reader(file, kind, &path.display().to_string())
}

/// Reads an outline; `place` names the source in messages.
///
/// Rows are `x,y` in order along the outline: decimal numbers or hexadecimal floats, read as the nearest doubles. Fields are
/// separated by commas, semicolons, tabs or blanks; where the separator is no comma, decimal commas are read. The first row may
/// be a header, which says which of several columns are x and y (also lon and lat, easting and northing); blank rows and rows
/// that begin with `#` are skipped.
/// At most 10 000 000 rows.
///
/// A picture shows a silhouette on a plain background. If most border pixels are transparent, the opaque pixels are the
/// silhouette; otherwise transparent pixels are put on white, Otsu's threshold separates dark from bright, and the background is
/// the class of most border pixels, a frame of at most 2 % of the picture's side left out. The silhouette's part with the most
/// pixels is taken, and its outer boundary is traced by marching squares with linear interpolation; holes are no
/// outlines. Coordinates are pixels from the lower left corner, y upwards: the center of pixel (i, j) is (i + 1/2, height − j −
/// 1/2). A picture has at most 20 000 pixels a side and 64 million in all.
///
/// ```
/// use stellate::fit::{ContourKind, contour_from_reader};
/// let rows = "x,y\n0,0\n# a comment\n1,0\n 0x1p-1 , 1\n";
/// let triangle = contour_from_reader(rows.as_bytes(), ContourKind::Rows, "triangle.csv").unwrap();
/// assert_eq!(triangle.points(), [[0.0, 0.0], [1.0, 0.0], [0.5, 1.0]]);
/// ```
///
/// # Errors
/// [`Error::Data`] with the row, or with the fault of the picture or of the outline (see [`Contour::new`]); [`Error::Limit`]
/// beyond the limits above or 1 GiB; [`Error::Io`] if reading fails.
pub fn contour_from_reader(reader: impl Read, kind: ContourKind, place: &str) -> Result<Contour> {
    match kind {
        ContourKind::Rows => {
            let mut limited = reader.take(MAX_BYTES + 1);
            let (points, rows) = read_rows(&mut BufReader::new(&mut limited), place)?;
            if limited.limit() == 0 {
                return Err(too_long(place));
            }
            Contour::from_rows(points, &rows, place)
        }
        ContourKind::Image => silhouette_from_reader(reader, &PictureOptions::default(), place)
            .map(|(outline, _)| outline),
    }
}

/// Reads the outline of a silhouette in a picture, and what else the picture shows. The rules are those of
/// [`contour_from_reader`].
///
/// ```
/// use stellate::fit::{PictureOptions, silhouette_from_reader};
/// let file = std::fs::File::open("paper-examples/e02-butterfly/butterfly.png").unwrap();
/// let (outline, left_out) = silhouette_from_reader(file, &PictureOptions::default(), "butterfly.png")?;
/// assert!(outline.len() > 100);
/// assert_eq!(left_out.frame, 0);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of [`contour_from_reader`]; [`Error::Data`] if the silhouette has fewer parts than [`PictureOptions::blob`] says.
pub fn silhouette_from_reader(
    reader: impl Read,
    options: &PictureOptions,
    place: &str,
) -> Result<(Contour, LeftOut)> {
    let mut bytes = Vec::new();
    let mut limited = reader.take(MAX_BYTES + 1);
    let read = limited.read_to_end(&mut bytes);
    read.map_err(|source| Error::Io {
        path: place.into(),
        source,
    })?;
    if limited.limit() == 0 {
        return Err(too_long(place));
    }
    outline_of(&bytes, options, place)
}

#[cfg(feature = "images")]
fn outline_of(picture: &[u8], options: &PictureOptions, place: &str) -> Result<(Contour, LeftOut)> {
    trace_silhouette(picture, options, place)
}

/// The error for a picture, if the feature `images` is off.
#[cfg(not(feature = "images"))]
fn outline_of(_: &[u8], _: &PictureOptions, place: &str) -> Result<(Contour, LeftOut)> {
    Err(Error::Usage(format!(
        "{place}: pictures are read by stellate with the feature `images` only"
    )))
}

fn too_long(place: &str) -> Error {
    Error::limit(format!("{place} is longer than {MAX_BYTES} bytes"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_decides() {
        for (name, kind) in [
            ("a/b.CSV", Some(ContourKind::Rows)),
            ("b.jpeg", Some(ContourKind::Image)),
            ("b.txt", None),
            ("csv", None),
        ] {
            assert_eq!(ContourKind::of(Path::new(name)), kind);
        }
        let error = read_contour(Path::new("outline.svg")).unwrap_err();
        assert!(error.to_string().contains(".png"), "{error}");
        assert!(matches!(
            read_contour(Path::new("does/not/exist.csv")),
            Err(Error::Io { .. })
        ));
    }
}
