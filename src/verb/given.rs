//! The input of a verb: a form or a contour, from text or from a file.

use std::io::Read;
use std::path::Path;

use crate::error::{Error, Result};
use crate::fit::{
    ContourKind, LeftOut, OutlineOptions, cloud_from_reader, is_geojson, outline_from_reader,
    outlines_from_reader,
};
use crate::language::{Numbers, with_newlines};
use crate::options::options;
use crate::reading::{
    HarmonicConvention, Written, read_coefficients_csv, read_elliptic_csv, read_fourier_csv,
    read_harmonics, read_written,
};
use crate::shape::{Contour, Form, PointCloud};

use super::foreign::refuse_name;
use super::source::{
    Held, head_of, held, is_a_folder, names_a_file, open, open_packed, packed_harmonics,
    read_limited,
};
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
    /// What of a file is not in the outline.
    left_out: LeftOut,
}

options! {
    /// How what is handed in is read.
    ReadOptions {
        /// How numbers are taken.
        numbers: Numbers = Numbers::Exact,
        /// How an outline is found in a file.
        outline: OutlineOptions = OutlineOptions::default(),
        /// Whether the points of a table are a cloud, which has no order.
        cloud: bool = false,
        /// The convention of a file of spherical harmonics.
        harmonics: HarmonicConvention = HarmonicConvention::default(),
    }
}

impl ReadOptions {
    /// Refuses options that mean nothing for an exact form.
    fn check_form(&self) -> Result<()> {
        if self.cloud {
            return Err(Error::Usage(
                "--cloud is for tables of points; this is none".into(),
            ));
        }
        self.outline.check(None)
    }

    /// Refuses the convention of spherical harmonics for anything else.
    fn check_no_harmonics(&self) -> Result<()> {
        match self.harmonics.is_default() {
            true => Ok(()),
            false => Err(Error::Usage(
                "--normalization and --condon-shortley are for files of spherical harmonics; this is none".into(),
            )),
        }
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
    /// A cloud of points, likewise.
    Cloud(PointCloud),
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

impl From<PointCloud> for Given {
    fn from(cloud: PointCloud) -> Self {
        Self::new("the cloud", Content::Cloud(cloud))
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

    /// Reads as [`Given::read`] does, with options, and remarks what of a file is not in the outline.
    ///
    /// # Errors
    /// Those of [`Given::read`]; [`Error::Usage`] for options of outlines that mean nothing for this input.
    pub fn read_with(argument: &str, options: &ReadOptions, work: &Work) -> Result<Self> {
        let path = Path::new(argument);
        if names_a_file(path) {
            return Self::from_path_with(path, options, work);
        }
        Self::formula(argument, options, work)
    }

    /// Reads all outlines of a file, the largest first; any other argument is one input. Nothing is remarked: what each leaves
    /// out, [`Given::left_out`] says. An outline that touches itself is an error beside the others.
    ///
    /// ```
    /// use stellate::verb::{Given, ReadOptions};
    /// let options = ReadOptions::default();
    /// let all = Given::read_all_with("paper-examples/e02-butterfly/butterfly.png", &options)?;
    /// assert_eq!(all.len(), 1);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Given::read_with`].
    pub fn read_all_with(argument: &str, options: &ReadOptions) -> Result<Vec<Result<Self>>> {
        let path = Path::new(argument);
        if !names_a_file(path) {
            return Ok(vec![Ok(Self::formula(
                argument,
                options,
                &Work::default(),
            )?)]);
        }
        refuse_name(path)?;
        let place = path.display().to_string();
        let source = Source::new(open(path)?, Some(path), &place)?;
        source.all_given(&file_name(path), options)
    }

    /// Reads all outlines that a reader gives, as [`Given::read_all_with`] reads those of a file.
    ///
    /// # Errors
    /// Those of [`Given::from_reader_with`].
    pub fn all_from_reader_with(
        reader: impl Read,
        place: &str,
        options: &ReadOptions,
    ) -> Result<Vec<Result<Self>>> {
        Source::new(reader, None, place)?.all_given(place, options)
    }

    fn formula(argument: &str, options: &ReadOptions, work: &Work) -> Result<Self> {
        options.check_form()?;
        options.check_no_harmonics()?;
        let written = read_written(argument, "<form>", options.numbers);
        let written = written.map_err(|error| folder_instead(Path::new(argument), error))?;
        let form = remarked(written, work);
        Ok(Self::new(argument.trim(), Content::Exact(form)))
    }

    /// Reads a file: a contour (rows `x,y`, a NumPy array, GeoJSON, an SVG drawing, or a picture of a silhouette), a table of
    /// coefficients, a JSON document, or text of the input language.
    ///
    /// # Errors
    /// [`Error::Io`] if the file cannot be read; [`Error::Usage`] for a file of another program; those of the readers in
    /// [`crate::reading`] and [`crate::fit`].
    pub fn from_path(path: &Path, numbers: Numbers) -> Result<Self> {
        let options = ReadOptions::default().numbers(numbers);
        Self::from_path_with(path, &options, &Work::default())
    }

    /// Reads as [`Given::from_path`] does, with options, and remarks what of a file is not in the outline.
    ///
    /// # Errors
    /// Those of [`Given::from_path`]; [`Error::Usage`] for options of outlines that mean nothing for this input.
    pub fn from_path_with(path: &Path, options: &ReadOptions, work: &Work) -> Result<Self> {
        let place = path.display().to_string();
        if let Some(unpacked) = packed_harmonics(path) {
            let source = Source::new(open_packed(path)?, Some(&unpacked), &place)?;
            return source.given(&file_name(path), options, work);
        }
        refuse_name(path)?;
        let source = Source::new(open(path)?, Some(path), &place)?;
        source.given(&file_name(path), options, work)
    }

    /// Reads everything that a reader gives: what [`Given::from_path`] reads from a file. `place` names the source in messages.
    ///
    /// # Errors
    /// Those of [`Given::from_path`].
    pub fn from_reader(reader: impl Read, place: &str, numbers: Numbers) -> Result<Self> {
        let options = ReadOptions::default().numbers(numbers);
        Self::from_reader_with(reader, place, &options, &Work::default())
    }

    /// Reads as [`Given::from_reader`] does, with options, and remarks what of the source is not in the outline.
    ///
    /// # Errors
    /// Those of [`Given::from_path_with`].
    pub fn from_reader_with(
        reader: impl Read,
        place: &str,
        options: &ReadOptions,
        work: &Work,
    ) -> Result<Self> {
        Source::new(reader, None, place)?.given(place, options, work)
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

    /// What of a file is not in the outline.
    #[must_use]
    pub fn left_out(&self) -> &LeftOut {
        &self.left_out
    }

    /// The whole name on one line.
    #[must_use]
    pub fn whole_name(&self) -> String {
        let words: Vec<&str> = self.name.split_whitespace().collect();
        words.join(" ")
    }

    /// The name on one line, cut if it is long.
    #[must_use]
    pub fn short_name(&self) -> String {
        const LONGEST: usize = 40;
        let line = self.whole_name();
        if line.chars().count() <= LONGEST {
            return line;
        }
        line.chars().take(LONGEST).chain(['…']).collect()
    }
}

/// A file or a stream that is still to be read.
struct Source<'a, R> {
    head: Vec<u8>,
    rest: R,
    path: Option<&'a Path>,
    place: &'a str,
}

impl<'a, R: Read> Source<'a, R> {
    fn new(mut reader: R, path: Option<&'a Path>, place: &'a str) -> Result<Self> {
        Ok(Self {
            head: head_of(&mut reader, place)?,
            rest: reader,
            path,
            place,
        })
    }

    fn given(self, name: &str, options: &ReadOptions, work: &Work) -> Result<Given> {
        let place = self.place;
        let (content, left_out) = self.read(options, work)?;
        if !left_out.is_nothing() {
            let outline = place.to_owned();
            work.remark(Remark::LeftOut {
                outline,
                left_out: left_out.clone(),
            });
        }
        Ok(Given {
            name: name.into(),
            content,
            left_out,
        })
    }

    fn all_given(self, name: &str, options: &ReadOptions) -> Result<Vec<Result<Given>>> {
        let all = self.read_all(options)?;
        let count = all.len();
        let each = all.into_iter().enumerate().map(|(k, found)| {
            let name = match count {
                1 => name.into(),
                _ => format!("{name}, blob {}", k + 1),
            };
            found.map(|(content, left_out)| Given {
                name,
                content,
                left_out,
            })
        });
        Ok(each.collect())
    }

    /// The content, and what is left out.
    fn read(self, options: &ReadOptions, work: &Work) -> Result<(Content, LeftOut)> {
        let place = self.place;
        let outline = |text: &mut dyn Read, kind| {
            if options.cloud {
                let cloud = cloud_from_reader(text, kind, &options.outline, place)?;
                return Ok((Content::Cloud(cloud), LeftOut::default()));
            }
            let found = outline_from_reader(text, kind, &options.outline, place);
            found.map(|(outline, left_out)| (Content::Contour(outline), left_out))
        };
        match self.held(options)? {
            Held::Outline(kind) => outline(&mut self.all(), kind),
            held => match self.exact(held, options, work)? {
                Exact::Form(form) => Ok((Content::Exact(form), LeftOut::default())),
                Exact::Polygons(text) => outline(&mut text.as_bytes(), ContourKind::Polygons),
            },
        }
    }

    /// All outlines, or the only content.
    fn read_all(self, options: &ReadOptions) -> Result<Vec<Result<(Content, LeftOut)>>> {
        let place = self.place;
        let outlines = |text: &mut dyn Read, kind| -> Result<Vec<Result<(Content, LeftOut)>>> {
            if options.cloud {
                return Err(Error::Usage(
                    "--all is for several outlines; all points of a file are one cloud".into(),
                ));
            }
            let all = outlines_from_reader(text, kind, &options.outline, place)?.into_iter();
            let content = all.map(|found| {
                found.map(|(outline, left_out)| (Content::Contour(outline), left_out))
            });
            Ok(content.collect())
        };
        match self.held(options)? {
            Held::Outline(kind) => outlines(&mut self.all(), kind),
            held => match self.exact(held, options, &Work::default())? {
                Exact::Form(form) => Ok(vec![Ok((Content::Exact(form), LeftOut::default()))]),
                Exact::Polygons(text) => outlines(&mut text.as_bytes(), ContourKind::Polygons),
            },
        }
    }

    fn held(&self, options: &ReadOptions) -> Result<Held> {
        let has_columns = options.outline.columns.is_some();
        held(self.path, &self.head, has_columns, self.place)
    }

    /// Everything from the beginning.
    fn all(self) -> impl Read {
        std::io::Cursor::new(self.head).chain(self.rest)
    }

    /// What is no outline by its first bytes: an exact form, or else GeoJSON.
    fn exact(self, held: Held, options: &ReadOptions, work: &Work) -> Result<Exact> {
        let (place, numbers) = (self.place, options.numbers);
        let mut text = read_limited(self.all(), place)?;
        if held == Held::Text {
            if is_geojson(&text) {
                return Ok(Exact::Polygons(text));
            }
        } else {
            text = with_newlines(&text).into_owned();
        }
        options.check_form()?;
        if !matches!(held, Held::Harmonics(_)) {
            options.check_no_harmonics()?;
        }
        let form = match held {
            Held::Harmonics(layout) => {
                let read = read_harmonics(&text, place, layout, &options.harmonics, numbers)?;
                let surface = read.surface.clone();
                let file = place.to_owned();
                work.remark(Remark::HarmonicFile { file, read });
                Form::Harmonic(surface)
            }
            Held::Coefficients => read_coefficients_csv(&text, place, numbers)?,
            Held::Fourier => Form::Fourier(read_fourier_csv(&text, place, numbers)?),
            Held::Elliptic => {
                let series = read_elliptic_csv(&text, place, numbers)?;
                Form::PlaneCurve(series.to_plane_curve())
            }
            Held::Outline(_) | Held::Text => remarked(read_written(&text, place, numbers)?, work),
        };
        Ok(Exact::Form(form))
    }
}

/// The form that was read, with remarks on how it differs from what is written.
fn remarked(written: Written, work: &Work) -> Form {
    if let Some(form) = written.comment {
        work.remark(Remark::FormOfComment(form));
    }
    if written.adds_origin {
        work.remark(Remark::OriginAdded);
    }
    written.form
}

/// What a text turned out to be.
#[expect(
    clippy::large_enum_variant,
    reason = "there is one of these for each form that is handed in"
)]
enum Exact {
    Form(Form),
    Polygons(String),
}

fn file_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}

/// The error for a text that is not a form but is the name of a folder: the user meant a file.
fn folder_instead(path: &Path, error: Error) -> Error {
    if path.is_dir() {
        is_a_folder(path)
    } else {
        error
    }
}
