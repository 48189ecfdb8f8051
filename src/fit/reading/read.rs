//! Outlines are read from files.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

#[cfg(feature = "images")]
use super::drawing::read_drawing;
use super::geojson::read_geojson;
use super::numpy::read_array;
use super::rings::Rings;
use super::rows::read_rows;
#[cfg(feature = "images")]
use super::silhouette::Silhouette;
use super::{LeftOut, OutlineOptions};
use crate::error::{Error, Result};
use crate::reading::bytes_within;
use crate::shape::{Contour, GivenPoints, PointCloud};

/// The largest number of bytes that are read from one file.
const MAX_BYTES: u64 = 1 << 30;
/// The largest number of bytes of a text that is not read row by row.
const MAX_TEXT: u64 = 256 << 20;

/// The kind of a file that holds an outline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum ContourKind {
    /// Rows `x,y`.
    #[default]
    Rows,
    /// An array of NumPy.
    Array,
    /// Polygons in GeoJSON.
    Polygons,
    /// A drawing in SVG.
    Drawing,
    /// A picture of a silhouette on a plain background.
    Image,
}

impl ContourKind {
    /// The kind that the extension of a file means, in upper or lower case: `csv`, `tsv`, `dat`, `xy` for rows; `npy`, `geojson`,
    /// `svg`; `png`, `jpg`, `jpeg`, `bmp`, `tif`, `tiff`, `gif`, `webp` for a picture.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "csv" | "tsv" | "dat" | "xy" => Some(Self::Rows),
            "npy" => Some(Self::Array),
            "geojson" => Some(Self::Polygons),
            "svg" => Some(Self::Drawing),
            "png" | "jpg" | "jpeg" | "bmp" | "tif" | "tiff" | "gif" | "webp" => Some(Self::Image),
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
            "{}: an outline is read from .csv, .tsv, .dat, .xy, .npy, .geojson, .svg, .png, .jpg or .bmp",
            path.display()
        ))
    })?;
    let file = File::open(path).map_err(|source| Error::Io {
        path: path.into(),
        source,
    })?;
    contour_from_reader(file, kind, &path.display().to_string())
}

/// Reads an outline; `place` names the source in messages. If the file has several outlines, the largest is taken.
///
/// Rows are `x,y` in order along the outline: decimal numbers or hexadecimal floats, read as the nearest doubles. Fields are
/// separated by commas, semicolons, tabs or blanks; where the separator is no comma, decimal commas are read. The first row may
/// be a header, which says which of several columns are x and y (also lon and lat, easting and northing); blank rows and rows
/// that begin with `#` are skipped. Rows are read one by one; at most 10 000 000 rows.
///
/// An array is a file `.npy` of NumPy: integers or floating-point numbers of shape (n, 2) or (n, 1, 2), or complex numbers of
/// shape (n,), of either byte order and in the order of C or Fortran.
///
/// Polygons are those of GeoJSON wherever they are in it, and lines that end where they begin. Longitude and latitude are taken
/// for x and y in the plane, and an altitude is dropped. The polygon with the largest area is taken; its holes are no outlines.
///
/// A drawing is SVG. Its closed paths and basic shapes count, each with the transforms and uses of its elements; a closed path within
/// another one of the same element is a hole, and a rectangle that covers the whole drawing is the background. Curves are cut
/// into edges: no point of a curve is farther from its edge than 1e-4 times the longer side of the box around the path.
/// Coordinates are those of the view box, and y is mirrored about its middle line, so that y points up in the same range;
/// without a view box the range is from 0 to the height.
///
/// A picture shows a silhouette on a plain background. If most border pixels are transparent, the opaque pixels are the
/// silhouette; otherwise transparent pixels are put on white, Otsu's threshold separates dark from bright, and the background is
/// the class of most border pixels, a frame of at most 2 % of the picture's side left out. The silhouette's part with the most
/// pixels is taken, and its outer boundary is traced by marching squares with linear interpolation; holes are no
/// outlines. Coordinates are pixels from the lower left corner, y upwards: the center of pixel (i, j) is (i + 1/2, height − j −
/// 1/2). A picture has at most 20 000 pixels a side and 64 million in all. Of an animation the first picture is read.
///
/// ```
/// use stellate::fit::{ContourKind, contour_from_reader};
/// let rows = "x,y\n0,0\n# a comment\n1,0\n 0x1p-1 , 1\n";
/// let triangle = contour_from_reader(rows.as_bytes(), ContourKind::Rows, "triangle.csv").unwrap();
/// assert_eq!(triangle.points(), [[0.0, 0.0], [1.0, 0.0], [0.5, 1.0]]);
/// ```
///
/// # Errors
/// [`Error::Data`] with the row, or with the fault of the file or of the outline (see [`Contour::new`]); [`Error::Limit`]
/// beyond the limits above, 1 GiB, or 256 MiB of GeoJSON or SVG; [`Error::Io`] if reading fails; [`Error::Usage`] for pictures
/// and drawings without the feature `images`.
pub fn contour_from_reader(reader: impl Read, kind: ContourKind, place: &str) -> Result<Contour> {
    let options = OutlineOptions::default();
    outline_from_reader(reader, kind, &options, place).map(|(outline, _)| outline)
}

/// Reads the outline that the options choose, and what else the file has. The rules are those of [`contour_from_reader`].
///
/// ```
/// use stellate::fit::{ContourKind, OutlineOptions, outline_from_reader};
/// let file = std::fs::File::open("paper-examples/e02-butterfly/butterfly.png").unwrap();
/// let options = OutlineOptions::default();
/// let (outline, left_out) =
///     outline_from_reader(file, ContourKind::Image, &options, "butterfly.png")?;
/// assert!(outline.len() > 100);
/// assert_eq!(left_out.frame, 0);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of [`contour_from_reader`]; [`Error::Data`] if there are fewer outlines than [`OutlineOptions::blob`] says, or not the
/// columns of [`OutlineOptions::columns`]; [`Error::Usage`] for options that mean nothing for this kind.
pub fn outline_from_reader(
    reader: impl Read,
    kind: ContourKind,
    options: &OutlineOptions,
    place: &str,
) -> Result<(Contour, LeftOut)> {
    let mut outlines = Outlines::read(reader, kind, options, place)?;
    outlines.outline(options.blob, options, place)
}

/// Reads all outlines of a file, the largest first: those that [`outline_from_reader`] gives for `blob` = 1, 2, … If one of them
/// is none, because it touches itself, the others are read all the same.
///
/// ```
/// use stellate::fit::{ContourKind, OutlineOptions, outlines_from_reader};
/// let text = r#"{"type": "MultiPolygon", "coordinates": [
///     [[[0, 0], [1, 0], [0, 1], [0, 0]]], [[[0, 0], [3, 0], [3, 3], [0, 0]]]]}"#;
/// let options = OutlineOptions::default();
/// let all = outlines_from_reader(text.as_bytes(), ContourKind::Polygons, &options, "two")?;
/// let areas: Vec<f64> = all.iter().flatten().map(|(outline, _)| outline.area()).collect();
/// assert_eq!(areas, [4.5, 0.5]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of [`outline_from_reader`].
pub fn outlines_from_reader(
    reader: impl Read,
    kind: ContourKind,
    options: &OutlineOptions,
    place: &str,
) -> Result<Vec<Result<(Contour, LeftOut)>>> {
    let mut outlines = Outlines::read(reader, kind, options, place)?;
    let count = outlines.count();
    let each = |blob: usize| match count {
        1 => outlines.outline(blob, options, place),
        _ => outlines.outline(blob, options, &format!("{place}, blob {blob}")),
    };
    Ok((1..=count).map(each).collect())
}

/// Reads the points of a table or an array as a cloud: their order does not matter.
///
/// ```
/// use stellate::fit::{ContourKind, OutlineOptions, cloud_from_reader};
/// let rows = "x,y,weight\n0,0,1\n1,1,0.5\n1,0,1\n0,1,1\n";
/// let options = OutlineOptions::default().weights("weight".parse().ok());
/// let cloud = cloud_from_reader(rows.as_bytes(), ContourKind::Rows, &options, "cloud.csv")?;
/// assert_eq!((cloud.points()[1], cloud.weights()[1]), ([1.0, 1.0], 0.5));
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Usage`] for a file of another kind, or for options of outlines; those of [`contour_from_reader`] about rows, and those
/// of [`PointCloud::new`].
pub fn cloud_from_reader(
    reader: impl Read,
    kind: ContourKind,
    options: &OutlineOptions,
    place: &str,
) -> Result<PointCloud> {
    if options.repair {
        return Err(Error::Usage(
            "--repair is for outlines; the points of a cloud have no order".into(),
        ));
    }
    match Outlines::read(reader, kind, options, place)? {
        Outlines::Points { given, .. } => PointCloud::new(given, place),
        _ => Err(Error::Usage(
            "--cloud is for tables of points; this is none".into(),
        )),
    }
}

/// The outlines of a file, before they are checked.
enum Outlines {
    /// The only one.
    Points {
        given: GivenPoints,
        kind: ContourKind,
    },
    Rings(Rings),
    #[cfg(feature = "images")]
    Silhouette(Box<Silhouette>),
}

impl Outlines {
    fn read(
        reader: impl Read,
        kind: ContourKind,
        options: &OutlineOptions,
        place: &str,
    ) -> Result<Self> {
        options.check(Some(kind))?;
        let mut limited = reader.take(MAX_BYTES + 1);
        Ok(match kind {
            ContourKind::Rows => {
                let given = read_rows(&mut BufReader::new(&mut limited), options, place)?;
                if limited.limit() == 0 {
                    return Err(too_long(place, MAX_BYTES));
                }
                Self::Points { given, kind }
            }
            ContourKind::Array => {
                let given = read_array(&bytes(limited, MAX_BYTES, place)?, options, place)?;
                Self::Points { given, kind }
            }
            ContourKind::Polygons => Self::Rings(read_geojson(&text(limited, place)?, place)?),
            ContourKind::Drawing => Self::drawing(&text(limited, place)?, place)?,
            ContourKind::Image => {
                Self::picture(&bytes(limited, MAX_BYTES, place)?, options, place)?
            }
        })
    }

    #[cfg(feature = "images")]
    fn drawing(text: &str, place: &str) -> Result<Self> {
        read_drawing(text, place).map(Self::Rings)
    }

    #[cfg(feature = "images")]
    fn picture(bytes: &[u8], options: &OutlineOptions, place: &str) -> Result<Self> {
        Silhouette::read(bytes, options, place).map(|found| Self::Silhouette(Box::new(found)))
    }

    #[cfg(not(feature = "images"))]
    fn drawing(_: &str, place: &str) -> Result<Self> {
        Err(Error::Usage(format!(
            "{place}: drawings are read by stellate with the feature `images` only"
        )))
    }

    #[cfg(not(feature = "images"))]
    fn picture(_: &[u8], _: &OutlineOptions, place: &str) -> Result<Self> {
        Err(Error::Usage(format!(
            "{place}: pictures are read by stellate with the feature `images` only"
        )))
    }

    fn count(&self) -> usize {
        match self {
            Self::Points { .. } => 1,
            Self::Rings(rings) => rings.len(),
            #[cfg(feature = "images")]
            Self::Silhouette(silhouette) => silhouette.count(),
        }
    }

    /// The outline with this number, from 1. Each is taken once.
    fn outline(
        &mut self,
        blob: usize,
        options: &OutlineOptions,
        place: &str,
    ) -> Result<(Contour, LeftOut)> {
        match self {
            Self::Points { given, kind } => {
                let (outline, removed) = options.outline(std::mem::take(given), place)?;
                let left_out = LeftOut {
                    kind: *kind,
                    removed,
                    ..LeftOut::default()
                };
                Ok((outline, left_out))
            }
            Self::Rings(rings) => rings.outline(blob.wrapping_sub(1), options, place),
            #[cfg(feature = "images")]
            Self::Silhouette(silhouette) => silhouette.outline(blob, options, place),
        }
    }
}

/// All bytes of a source that has at most `most`.
fn bytes(reader: impl Read, most: u64, place: &str) -> Result<Vec<u8>> {
    bytes_within(reader, most, place)?.ok_or_else(|| too_long(place, most))
}

fn text(reader: impl Read, place: &str) -> Result<String> {
    String::from_utf8(bytes(reader, MAX_TEXT, place)?).map_err(|error| {
        let byte = error.utf8_error().valid_up_to() + 1;
        Error::data(place, format!("byte {byte} is not UTF-8 text"))
    })
}

fn too_long(place: &str, most: u64) -> Error {
    Error::limit(format!("{place} is longer than {most} bytes"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_decides() {
        for (name, kind) in [
            ("a/b.CSV", Some(ContourKind::Rows)),
            ("b.jpeg", Some(ContourKind::Image)),
            ("b.npy", Some(ContourKind::Array)),
            ("b.GeoJSON", Some(ContourKind::Polygons)),
            ("b.svg", Some(ContourKind::Drawing)),
            ("b.TIFF", Some(ContourKind::Image)),
            ("b.txt", None),
            ("csv", None),
        ] {
            assert_eq!(ContourKind::of(Path::new(name)), kind);
        }
        let error = read_contour(Path::new("outline.pdf")).unwrap_err();
        assert!(error.to_string().contains(".png"), "{error}");
        assert!(matches!(
            read_contour(Path::new("does/not/exist.csv")),
            Err(Error::Io { .. })
        ));
    }
}
