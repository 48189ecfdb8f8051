//! Files of other programs that are not read: what each is, and what would work.

use std::path::Path;

use crate::error::{Error, Result};

/// A kind of files that is not read.
struct Foreign {
    /// Extensions in small letters.
    extensions: &'static [&'static str],
    /// What such a file may begin with.
    beginnings: &'static [&'static [u8]],
    what: &'static str,
    instead: &'static str,
}

const AS_ROWS: &str = "save the points as rows x,y in a .csv file";
const AS_PICTURE: &str = "save it as .png";
const AS_DRAWING: &str = "save the drawing as .svg, or the points as rows x,y in a .csv file";
const AS_GEOJSON: &str =
    "save it as GeoJSON, with ogr2ogr -f GeoJSON outline.geojson FILE or from a geographic program";

/// The order matters: what is packed begins like any archive.
const ALL: [Foreign; 15] = [
    Foreign {
        extensions: &["pdf"],
        beginnings: &[b"%PDF"],
        what: "a PDF document",
        instead: AS_DRAWING,
    },
    Foreign {
        extensions: &["ai", "cdr", "eps", "ps"],
        beginnings: &[b"%!PS", b"\xc5\xd0\xd3\xc6"],
        what: "a drawing in PostScript or of a drawing program",
        instead: AS_DRAWING,
    },
    Foreign {
        extensions: &["dwg", "dxf"],
        beginnings: &[b"AC10", b"AutoCAD Binary DXF"],
        what: "a CAD drawing (DXF or DWG)",
        instead: AS_DRAWING,
    },
    Foreign {
        extensions: &["gml", "gpx", "kml", "kmz"],
        beginnings: &[],
        what: "a map of places (KML, GPX or GML)",
        instead: AS_GEOJSON,
    },
    Foreign {
        extensions: &["dbf", "gpkg", "shp", "shx", "topojson"],
        beginnings: &[b"\x00\x00\x27\x0a", b"SQLite format 3"],
        what: "a map of places (a shapefile, GeoPackage or TopoJSON)",
        instead: AS_GEOJSON,
    },
    Foreign {
        extensions: &["npz"],
        beginnings: &[],
        what: "an archive of NumPy arrays",
        instead: "save the array of the outline with numpy.save(\"outline.npy\", array)",
    },
    Foreign {
        extensions: &["ods", "xls", "xlsm", "xlsx"],
        beginnings: &[],
        what: "a spreadsheet",
        instead: "save the sheet with the columns x and y as .csv",
    },
    Foreign {
        extensions: &["doc", "docx", "odt", "rtf"],
        beginnings: &[b"{\\rtf", b"\xd0\xcf\x11\xe0"],
        what: "a document of an office program",
        instead: AS_ROWS,
    },
    Foreign {
        extensions: &["mat"],
        beginnings: &[b"MATLAB 5.0 MAT-file"],
        what: "data of MATLAB",
        instead: "save the points with writematrix([x y], \"outline.csv\")",
    },
    Foreign {
        extensions: &["feather", "h5", "hdf5", "nc", "parquet", "pkl", "rds"],
        beginnings: &[b"\x89HDF", b"PAR1", b"ARROW1", b"CDF\x01", b"CDF\x02"],
        what: "binary data of another program",
        instead: "save the points as rows x,y in a .csv file, or with numpy.save as .npy",
    },
    Foreign {
        extensions: &["roi"],
        beginnings: &[b"Iout"],
        what: "a region of interest of ImageJ",
        instead: "save it with File, Save As, XY Coordinates as .csv",
    },
    Foreign {
        extensions: &["avif", "exr", "heic", "heif", "ico", "jp2", "psd", "tga"],
        beginnings: &[b"8BPS", b"\x00\x00\x00\x0cjP  "],
        what: "a picture of a kind that is not read",
        instead: AS_PICTURE,
    },
    Foreign {
        extensions: &[
            "3mf", "glb", "gltf", "iges", "igs", "obj", "off", "ply", "step", "stl", "stp",
        ],
        beginnings: &[b"ISO-10303-21", b"glTF"],
        what: "a surface in space as a mesh or a CAD model",
        instead: "a surface is given as an equation or as a patch; `fit` takes a closed mesh .obj, .ply or .stl and makes one",
    },
    Foreign {
        extensions: &["7z", "bz2", "gz", "rar", "svgz", "tar", "xz", "zip", "zst"],
        beginnings: &[
            b"PK\x03\x04",
            b"\x1f\x8b",
            b"7z\xbc\xaf\x27\x1c",
            b"Rar!",
            b"\x28\xb5\x2f\xfd",
            b"\xfd7zXZ",
            b"BZh",
        ],
        what: "packed",
        instead: "unpack it first",
    },
    Foreign {
        extensions: &["htm", "html"],
        beginnings: &[],
        what: "a web page",
        instead: AS_ROWS,
    },
];

/// Whether an extension, in small letters, is that of a file that is not read.
pub(super) fn is_foreign(extension: &str) -> bool {
    ALL.iter().any(|one| one.extensions.contains(&extension))
}

/// Refuses a file of another program by its name.
///
/// # Errors
/// [`Error::Usage`] with what it is and what would work.
pub(super) fn refuse_name(path: &Path) -> Result<()> {
    let extension = path.extension().and_then(|e| e.to_str());
    let extension = extension.unwrap_or_default().to_ascii_lowercase();
    let mut all = ALL.iter();
    let found = all.find(|one| one.extensions.contains(&extension.as_str()));
    found.map_or(
        Ok(()),
        |found| Err(found.error(&path.display().to_string())),
    )
}

/// Refuses a file of another program by its first bytes.
///
/// # Errors
/// [`Error::Usage`] with what it is and what would work.
pub(super) fn refuse_beginning(head: &[u8], place: &str) -> Result<()> {
    let mut all = ALL.iter();
    let begins = |one: &&Foreign| one.beginnings.iter().any(|bytes| head.starts_with(bytes));
    if let Some(found) = all.find(begins) {
        return Err(found.error(place));
    }
    let text = String::from_utf8_lossy(&head[..head.len().min(2000)]);
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let mut words = text.split_whitespace();
    // A DXF file in text begins with pairs of rows: a code, and what it means.
    let is_dxf = words.next() == Some("0") && words.next() == Some("SECTION");
    let extension = if is_dxf {
        "dxf"
    } else if !text.starts_with('<') {
        return Ok(());
    } else if text.contains("<kml") {
        "kml"
    } else if text.contains("<gpx") {
        "gpx"
    } else if text.contains("<html") || text.contains("<HTML") || text.contains("<!DOCTYPE html") {
        "html"
    } else {
        return Ok(());
    };
    let mut all = ALL.iter();
    let found = all.find(|one| one.extensions.contains(&extension));
    found.map_or(Ok(()), |found| Err(found.error(place)))
}

impl Foreign {
    fn error(&self, place: &str) -> Error {
        let Self { what, instead, .. } = self;
        Error::Usage(format!(
            "{place}: this is {what}, which is not read; {instead}"
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_read_is_named() {
        for (name, part) in [
            ("a/b.PDF", "a PDF document"),
            ("b.npz", "numpy.save(\"outline.npy\", array)"),
            ("b.mat", "writematrix"),
            ("b.dxf", "a CAD drawing"),
            ("b.kml", "ogr2ogr"),
            ("b.shp", "ogr2ogr"),
            ("b.xlsx", "save the sheet"),
        ] {
            let message = refuse_name(Path::new(name)).unwrap_err().to_string();
            assert!(
                message.starts_with(name) && message.contains(part),
                "{message}"
            );
        }
        for (head, part) in [
            (&b"%PDF-1.4"[..], "a PDF document"),
            (b"PK\x03\x04....", "this is packed"),
            (b"  0\r\nSECTION\r\n  2\r\n", "a CAD drawing"),
            (b"<?xml version=\"1.0\"?>\n<kml xmlns=\"\">", "KML"),
            (b"<!DOCTYPE html><html>", "a web page"),
        ] {
            let message = refuse_beginning(head, "<stdin>").unwrap_err().to_string();
            assert!(message.contains(part), "{message}");
        }
        for head in [&b"r = 1"[..], b"x,y\n0,1", b"0\n1\n", b"<svg>", b""] {
            assert!(refuse_beginning(head, "a").is_ok());
        }
    }
}
