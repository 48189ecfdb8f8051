//! What a file or a stream holds: it is recognised by its first bytes and by its name.

use std::io::Read;
use std::path::{Path, PathBuf};

use super::foreign::{is_foreign, refuse_beginning};
use crate::error::{Error, Result};
use crate::fit::ContourKind;
use crate::language::{MAX_TEXT_BYTES, with_newlines};
use crate::reading::{HarmonicLayout, bytes_within, is_elliptic_header, layout_of_header};
use crate::rows::{double, words};

/// The number of bytes by which a file is recognised.
const HEAD: u64 = 1 << 16;

/// What a source holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Held {
    /// An outline.
    Outline(ContourKind),
    /// A table of the coefficients of a polynomial.
    Coefficients,
    /// A table of the coefficients of a Fourier radius.
    Fourier,
    /// A table of the coefficients of an elliptic series.
    Elliptic,
    /// A file of the coefficients of spherical harmonics, with the layout that its name says.
    Harmonics(Option<HarmonicLayout>),
    /// A formula, a JSON document, or GeoJSON.
    Text,
}

/// The first bytes of a source; the reader goes on behind them.
///
/// # Errors
/// [`Error::Io`] if reading fails.
pub(super) fn head_of(reader: &mut impl Read, place: &str) -> Result<Vec<u8>> {
    let mut head = Vec::new();
    let read = reader.take(HEAD).read_to_end(&mut head);
    read.map_err(|source| Error::Io {
        path: place.into(),
        source,
    })?;
    Ok(head)
}

/// What a source with these first bytes holds. `has_columns` says that the columns of a table are given.
///
/// # Errors
/// [`Error::Usage`] for a file of another program; [`Error::Data`] for a text that is not UTF-8.
pub(super) fn held(
    path: Option<&Path>,
    head: &[u8],
    has_columns: bool,
    place: &str,
) -> Result<Held> {
    use ContourKind::{Array, Drawing, Image, Polygons, Rows};
    if let Some(kind) = kind_of_beginning(head) {
        return Ok(Held::Outline(kind));
    }
    if let Some(layout) = path.and_then(layout_of_name) {
        refuse_utf16(head, place)?;
        return Ok(Held::Harmonics(Some(layout)));
    }
    let named = path.and_then(ContourKind::of);
    if let Some(kind @ (Image | Array)) = named {
        return Ok(Held::Outline(kind));
    }
    refuse_beginning(head, place)?;
    refuse_utf16(head, place)?;
    let text = String::from_utf8_lossy(head);
    let text = with_newlines(&text);
    let text = text.trim_start_matches('\u{feff}').trim_start();
    if text.starts_with('<') {
        return Ok(Held::Outline(Drawing));
    }
    Ok(match named {
        Some(kind @ (Drawing | Polygons)) => Held::Outline(kind),
        _ if text.starts_with('{') => Held::Text,
        _ if has_columns => Held::Outline(Rows),
        Some(_) => table(text),
        None if looks_like_rows(text) => table(text),
        None => Held::Text,
    })
}

/// The layout of a file of harmonics that has one of the usual names: `*.sh`, `*.sha`, `*anm*.dat`.
fn layout_of_name(path: &Path) -> Option<HarmonicLayout> {
    let name = path.file_name()?.to_str()?.to_ascii_lowercase();
    let (stem, extension) = name.rsplit_once('.')?;
    match extension {
        "sh" | "sha" | "shadr" => Some(HarmonicLayout::Real),
        "dat" if stem.contains("anm") => Some(HarmonicLayout::Complex),
        _ => None,
    }
}

/// The name without `.gz` of a packed file of harmonics, such as `model.sh.gz`.
pub(super) fn packed_harmonics(path: &Path) -> Option<PathBuf> {
    let extension = path.extension()?.to_str()?;
    let unpacked = path.with_extension("");
    let is_packed = extension.eq_ignore_ascii_case("gz") && layout_of_name(&unpacked).is_some();
    is_packed.then_some(unpacked)
}

/// The kind of an outline in binary data.
fn kind_of_beginning(head: &[u8]) -> Option<ContourKind> {
    const PICTURES: [&[u8]; 6] = [
        b"\x89PNG\r\n\x1a\n",
        b"\xff\xd8\xff",
        b"GIF87a",
        b"GIF89a",
        b"II*\0",
        b"MM\0*",
    ];
    let is_webp = head.starts_with(b"RIFF") && head.get(8..12) == Some(b"WEBP");
    // The two letters of a bitmap could begin a text, but its reserved bytes could not.
    let is_bitmap = head.starts_with(b"BM") && head.get(6..10) == Some(&[0; 4]);
    if head.starts_with(b"\x93NUMPY") {
        Some(ContourKind::Array)
    } else if is_webp || is_bitmap || PICTURES.iter().any(|bytes| head.starts_with(bytes)) {
        Some(ContourKind::Image)
    } else {
        None
    }
}

/// A table is one of coefficients if it has the header of one, else an outline.
fn table(head: &str) -> Held {
    let mut rows = head
        .lines()
        .map(str::trim)
        .filter(|l| !l.is_empty() && !l.starts_with('#'));
    let header = rows.next().unwrap_or("");
    let names: Vec<String> = words(header).map(str::to_ascii_lowercase).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let header = header.replace(' ', "").to_ascii_lowercase();
    if layout_of_header(&names).is_some() {
        Held::Harmonics(None)
    } else if header.starts_with("i,j,") {
        Held::Coefficients
    } else if header == "n,cos,sin" {
        Held::Fourier
    } else if is_elliptic_header(&header) {
        Held::Elliptic
    } else {
        Held::Outline(ContourKind::Rows)
    }
}

/// Whether a text is a table: its first row, or the row after one of words, has several numbers and nothing else.
fn looks_like_rows(text: &str) -> bool {
    let mut rows = text
        .lines()
        .map(|line| line.split('#').next().unwrap_or("").trim())
        .filter(|line| !line.is_empty() && !line.starts_with("//"));
    // The number of fields, and whether they are words; nothing for anything else.
    let fields = |row: &str| -> Option<(usize, bool)> {
        let parts: Vec<&str> = words(row).collect();
        let is_number = |part: &&&str| part.split('/').all(|n| double(n).is_ok());
        let numbers = parts.iter().filter(is_number);
        let has_words = parts
            .iter()
            .all(|part| part.starts_with(char::is_alphabetic));
        let is_row = has_words || numbers.count() == parts.len();
        is_row.then_some((parts.len(), has_words))
    };
    let mut found = rows.next().and_then(fields);
    if let Some((_, true)) = found {
        found = rows.next().and_then(fields);
    }
    matches!(found, Some((2.., false)))
}

/// Whether an argument is the name of a file rather than a text of the input language.
pub(super) fn names_a_file(path: &Path) -> bool {
    // `/` begins no formula.
    if path.has_root() || path.starts_with(".") || path.starts_with("..") || path.starts_with("~") {
        return true;
    }
    let extension = path.extension().and_then(|e| e.to_str());
    let extension = extension.unwrap_or_default().to_ascii_lowercase();
    ContourKind::of(path).is_some()
        || ["json", "txt"].contains(&extension.as_str())
        || layout_of_name(path).is_some()
        || is_foreign(&extension)
        || (path.exists() && !path.is_dir())
}

/// Opens a file.
///
/// # Errors
/// [`Error::Io`] if it cannot be opened; [`Error::Usage`] for a folder.
pub(super) fn open(path: &Path) -> Result<std::fs::File> {
    if path.is_dir() {
        return Err(is_a_folder(path));
    }
    std::fs::File::open(path).map_err(|source| Error::Io {
        path: path.to_path_buf(),
        source,
    })
}

/// Opens a file that gzip packed, to read what is in it.
///
/// # Errors
/// Those of [`open`]; [`Error::Usage`] without the feature `gzip`.
pub(super) fn open_packed(path: &Path) -> Result<impl Read> {
    #[cfg(feature = "gzip")]
    return open(path).map(flate2::read::GzDecoder::new);
    #[cfg(not(feature = "gzip"))]
    Err::<std::fs::File, _>(Error::Usage(format!(
        "{}: packed files are read by stellate with the feature `gzip` only; unpack it with gunzip",
        path.display()
    )))
}

/// The error for a folder in the place of a form.
pub(super) fn is_a_folder(path: &Path) -> Error {
    Error::Usage(format!(
        "{}: that is a folder; a form is text, a file, or - for standard input",
        path.display()
    ))
}

/// Reads a text of at most [`MAX_TEXT_BYTES`] bytes; `place` names its source in messages.
///
/// # Errors
/// [`Error::Io`] if reading fails, [`Error::Limit`] if the text is longer, [`Error::Data`] if it is not UTF-8.
pub fn read_limited(source: impl Read, place: &str) -> Result<String> {
    let limit = MAX_TEXT_BYTES as u64;
    let bytes = bytes_within(source, limit, place)?
        .ok_or_else(|| Error::limit(format!("{place}: a text has at most {limit} bytes")))?;
    refuse_utf16(&bytes, place)?;
    String::from_utf8(bytes).map_err(|e| {
        let byte = e.utf8_error().valid_up_to() + 1;
        Error::data(place, format!("byte {byte} is not UTF-8 text"))
    })
}

fn refuse_utf16(bytes: &[u8], place: &str) -> Result<()> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(Error::data(place, "this is UTF-16 text; save it as UTF-8"));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contents_decide_before_names() {
        let held = |name: &str, head: &[u8]| {
            let path = (!name.is_empty()).then_some(Path::new(name));
            held(path, head, false, "a").unwrap()
        };
        use ContourKind::{Array, Drawing, Image, Polygons, Rows};
        for (name, head, expected) in [
            ("", &b"\x89PNG\r\n\x1a\n..."[..], Held::Outline(Image)),
            ("a.csv", b"GIF89a...", Held::Outline(Image)),
            ("", b"\x93NUMPY\x01\0", Held::Outline(Array)),
            ("a.npy", b"1,2\n", Held::Outline(Array)),
            ("", b"<?xml?>\n<svg>", Held::Outline(Drawing)),
            ("a.svg", b"M0 0", Held::Outline(Drawing)),
            ("a.geojson", b"{}", Held::Outline(Polygons)),
            ("a.json", b"{\"type\":\"Point\"}", Held::Text),
            ("a.csv", b"x,y\n1,2\n", Held::Outline(Rows)),
            ("a.csv", b"n,cos,sin\n0,1,0\n", Held::Fourier),
            ("a.csv", b"n,a,b,c,d\n1,3,0,0,2\n", Held::Elliptic),
            ("", b"i,j,value\n0,1,0\n", Held::Coefficients),
            ("a.txt", b"# points\n1 2\n3 4\n", Held::Outline(Rows)),
            ("a.txt", b"BM = 1", Held::Text),
            ("a.csv", b"l,m,value\n0,0,1\n", Held::Harmonics(None)),
            (
                "a.sh",
                b"0 0 1 0\n",
                Held::Harmonics(Some(HarmonicLayout::Real)),
            ),
            (
                "C-anm-1.dat",
                b"0 0 1 0\n",
                Held::Harmonics(Some(HarmonicLayout::Complex)),
            ),
            ("", b"r = 1", Held::Text),
            ("", b"", Held::Text),
        ] {
            assert_eq!(held(name, head), expected, "{name} {head:?}");
        }
    }
}
