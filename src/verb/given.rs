//! The input of a verb: a form or a contour, from text or from a file.

use std::io::Read;
use std::path::Path;

use crate::error::{Error, Result};
use crate::fit::{
    ContourKind, LeftOut, PictureOptions, contour_from_reader, silhouette_from_reader,
};
use crate::language::{MAX_TEXT_BYTES, Numbers};
use crate::options::options;
use crate::reading::{
    is_elliptic_header, read_coefficients_csv, read_elliptic_csv, read_fourier_csv, read_text,
};
use crate::rows::{double, words};
use crate::shape::{Contour, Form};

use super::{Remark, Work};

/// A form or a contour, with the name that messages and legends use for it.
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::verb::{Content, Given};
/// let given = Given::read("r = 1 + 1/5*cos(3*t)", Numbers::Exact)?;
/// assert!(matches!(given.content(), Content::Exact(_)));
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Given {
    name: String,
    content: Content,
    /// What of a picture is not in the outline.
    left_out: LeftOut,
}

options! {
    /// How what is handed in is read.
    ReadOptions {
        /// How numbers are taken.
        numbers: Numbers = Numbers::Exact,
        /// How a silhouette is found in a picture.
        picture: PictureOptions = PictureOptions::default(),
    }
}

/// The content of an input.
#[expect(
    clippy::large_enum_variant,
    reason = "there is one of these for each form that is handed in"
)]
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Content {
    /// An exact form.
    Exact(Form),
    /// A contour. It becomes an exact form by a fit.
    Contour(Contour),
}

impl From<Form> for Given {
    fn from(form: Form) -> Self {
        Self::new("the form", Content::Exact(form))
    }
}

impl From<Contour> for Given {
    fn from(contour: Contour) -> Self {
        Self::new("the contour", Content::Contour(contour))
    }
}

impl Given {
    /// An input with this name and this content.
    #[must_use]
    pub fn new(name: impl Into<String>, content: Content) -> Self {
        Self {
            name: name.into(),
            content,
            left_out: LeftOut::default(),
        }
    }

    /// Reads an argument, which is a text of the input language or the name of a file. A name with a known extension is always
    /// the name of a file; any other text is one only if a file or a pipe of this name exists.
    ///
    /// # Errors
    /// Those of [`Given::from_path`] and of [`crate::language::parse_form`].
    pub fn read(argument: &str, numbers: Numbers) -> Result<Self> {
        let options = ReadOptions::default().numbers(numbers);
        Self::read_with(argument, &options, &Work::default())
    }

    /// Reads as [`Given::read`] does, with options, and remarks what of a picture is not in the outline.
    ///
    /// # Errors
    /// Those of [`Given::read`]; [`Error::Usage`] for options of pictures if it is none.
    pub fn read_with(argument: &str, options: &ReadOptions, work: &Work) -> Result<Self> {
        let path = Path::new(argument);
        if names_a_file(path) {
            return Self::from_path_with(path, options, work);
        }
        refuse_picture_options(&options.picture)?;
        let form = read_text(argument, "<form>", options.numbers);
        let form = form.map_err(|error| folder_instead(path, error))?;
        Ok(Self::new(argument.trim(), Content::Exact(form)))
    }

    /// Reads a file: a contour (`.csv` rows `x,y`, or a picture of a silhouette), a table of coefficients, a JSON document,
    /// or text of the input language.
    ///
    /// # Errors
    /// [`Error::Io`] if the file cannot be read; those of the readers in [`crate::reading`] and [`crate::fit`].
    pub fn from_path(path: &Path, numbers: Numbers) -> Result<Self> {
        let options = ReadOptions::default().numbers(numbers);
        Self::from_path_with(path, &options, &Work::default())
    }

    /// Reads as [`Given::from_path`] does, with options, and remarks what of a picture is not in the outline.
    ///
    /// # Errors
    /// Those of [`Given::from_path`]; [`Error::Usage`] for options of pictures if it is none.
    pub fn from_path_with(path: &Path, options: &ReadOptions, work: &Work) -> Result<Self> {
        let name = path
            .file_name()
            .unwrap_or(path.as_os_str())
            .to_string_lossy();
        let place = path.display().to_string();
        let kind = ContourKind::of(path);
        if kind == Some(ContourKind::Image) {
            let (outline, left_out) =
                silhouette_from_reader(open(path)?, &options.picture, &place)?;
            if !left_out.is_nothing() {
                let outline = place;
                work.remark(Remark::LeftOut { outline, left_out });
            }
            return Ok(Self {
                left_out,
                ..Self::new(name, Content::Contour(outline))
            });
        }
        refuse_picture_options(&options.picture)?;
        let content = if kind == Some(ContourKind::Rows) {
            table(&read_limited(open(path)?, &place)?, &place, options.numbers)?
        } else {
            refuse_other_formats(path)?;
            let text = read_limited(open(path)?, &place)?;
            if looks_like_rows(&text) {
                table(&text, &place, options.numbers)?
            } else {
                Content::Exact(read_text(&text, &place, options.numbers)?)
            }
        };
        Ok(Self::new(name, content))
    }

    /// Reads everything that a reader gives: rows of a contour, a table of coefficients, a JSON document, or text of the input
    /// language. `place` names the source in messages.
    ///
    /// # Errors
    /// Those of the readers in [`crate::reading`] and [`crate::fit`].
    pub fn from_reader(reader: impl Read, place: &str, numbers: Numbers) -> Result<Self> {
        let text = read_limited(reader, place)?;
        let content = if looks_like_rows(&text) {
            table(&text, place, numbers)?
        } else {
            Content::Exact(read_text(&text, place, numbers)?)
        };
        Ok(Self::new(place, content))
    }

    /// The content of the input.
    #[must_use]
    pub fn content(&self) -> &Content {
        &self.content
    }

    /// The content of the input, as its owner.
    #[must_use]
    pub fn into_content(self) -> Content {
        self.content
    }

    /// What of a picture is not in the outline.
    #[must_use]
    pub fn left_out(&self) -> LeftOut {
        self.left_out
    }

    /// The name on one line, cut if it is long.
    #[must_use]
    pub fn short_name(&self) -> String {
        const LONGEST: usize = 40;
        let line: String = self.name.split_whitespace().collect::<Vec<_>>().join(" ");
        if line.chars().count() <= LONGEST {
            return line;
        }
        line.chars().take(LONGEST).chain(['…']).collect()
    }
}

/// The error for a text that is not a form but is the name of a folder: the user meant a file.
fn folder_instead(path: &Path, error: Error) -> Error {
    if path.is_dir() {
        is_a_folder(path)
    } else {
        error
    }
}

fn is_a_folder(path: &Path) -> Error {
    Error::Usage(format!(
        "{}: that is a folder; a form is text, a file, or - for standard input",
        path.display()
    ))
}

/// Whether a text is a table: its first row, or the row after one of words, has several numbers and nothing else.
fn looks_like_rows(text: &str) -> bool {
    let mut rows = text
        .lines()
        .map(|line| {
            line.trim_start_matches('\u{feff}')
                .split('#')
                .next()
                .unwrap_or("")
                .trim()
        })
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

/// Refuses the options of pictures for anything else.
fn refuse_picture_options(options: &PictureOptions) -> Result<()> {
    let usual = PictureOptions::default();
    let given = [
        ("--blob", options.blob != usual.blob),
        ("--threshold", options.threshold != usual.threshold),
        ("--invert", options.invert != usual.invert),
    ];
    match given.iter().find(|(_, given)| *given) {
        Some((name, _)) => Err(Error::Usage(format!(
            "{name} is for pictures; this is none"
        ))),
        None => Ok(()),
    }
}

/// Files of other programs, which are no text of a form.
fn refuse_other_formats(path: &Path) -> Result<()> {
    const OTHERS: [&str; 14] = [
        "doc", "docx", "gif", "npy", "obj", "odt", "pdf", "ply", "stl", "svg", "tif", "tiff",
        "webp", "xlsx",
    ];
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .map(str::to_ascii_lowercase);
    match extension.filter(|e| OTHERS.contains(&e.as_str())) {
        None => Ok(()),
        Some(extension) => Err(Error::Usage(format!(
            "{}: files .{extension} are not read; a form is a text or a JSON document, a contour rows x,y in a .csv file or a \
             silhouette in a .png, .jpg or .bmp file",
            path.display()
        ))),
    }
}

fn names_a_file(path: &Path) -> bool {
    // `/` begins no formula.
    if path.has_root() || path.starts_with(".") || path.starts_with("..") || path.starts_with("~") {
        return true;
    }
    let known = [
        "bmp", "csv", "dat", "jpeg", "jpg", "json", "png", "tsv", "txt", "xy",
    ];
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .map(str::to_ascii_lowercase);
    extension.is_some_and(|e| known.contains(&e.as_str())) || (path.exists() && !path.is_dir())
}

/// Reads a CSV file. It is a table of coefficients if it has the header of one, else a contour.
fn table(text: &str, name: &str, numbers: Numbers) -> Result<Content> {
    let mut rows = text
        .lines()
        .map(str::trim)
        .filter(|l| !l.is_empty() && !l.starts_with('#'));
    let header = rows.next().unwrap_or("");
    let header = header.replace(' ', "").to_ascii_lowercase();
    if header.starts_with("i,j,") {
        return read_coefficients_csv(text, name, numbers).map(Content::Exact);
    }
    if header == "n,cos,sin" {
        let radius = read_fourier_csv(text, name, numbers)?;
        return Ok(Content::Exact(Form::Fourier(radius)));
    }
    if is_elliptic_header(&header) {
        let series = read_elliptic_csv(text, name, numbers)?;
        return Ok(Content::Exact(Form::PlaneCurve(series.to_plane_curve())));
    }
    contour_from_reader(text.as_bytes(), ContourKind::Rows, name).map(Content::Contour)
}

fn open(path: &Path) -> Result<std::fs::File> {
    if path.is_dir() {
        return Err(is_a_folder(path));
    }
    std::fs::File::open(path).map_err(|source| Error::Io {
        path: path.to_path_buf(),
        source,
    })
}

/// Reads a text of at most [`MAX_TEXT_BYTES`] bytes; `place` names its source in messages.
///
/// # Errors
/// [`Error::Io`] if reading fails, [`Error::Limit`] if the text is longer, [`Error::Data`] if it is not UTF-8.
pub fn read_limited(source: impl Read, place: &str) -> Result<String> {
    let failed = |source| Error::Io {
        path: place.into(),
        source,
    };
    let limit = MAX_TEXT_BYTES as u64;
    let mut bytes = Vec::new();
    source
        .take(limit + 1)
        .read_to_end(&mut bytes)
        .map_err(failed)?;
    if bytes.len() as u64 > limit {
        return Err(Error::limit(format!(
            "{place}: a text has at most {limit} bytes"
        )));
    }
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(Error::data(place, "this is UTF-16 text; save it as UTF-8"));
    }
    String::from_utf8(bytes).map_err(|e| {
        let byte = e.utf8_error().valid_up_to() + 1;
        Error::data(place, format!("byte {byte} is not UTF-8 text"))
    })
}
