//! Forms are read from the contents of files: JSON documents, tables of coefficients, and formulas.

mod bytes;
mod document;
mod harmonics;
mod json;
mod matrix;
mod mesh;
mod node;
mod norm;
mod superquadric;
mod table;

pub(crate) use bytes::bytes_within;
pub use document::read_document;
pub(crate) use harmonics::layout_of_header;
pub use harmonics::{HarmonicConvention, HarmonicLayout, ReadHarmonics, read_harmonics};
pub use matrix::read_coefficients;
pub(crate) use mesh::rows_of_ply;
pub use mesh::{MAX_MESH_BYTES, SolidFormat, read_solid};
pub use norm::Normalization;
pub(crate) use table::{Table, is_elliptic_header};
pub use table::{read_coefficients_csv, read_elliptic_csv, read_fourier_csv};

use crate::error::{Error, Result};
use crate::language::{Numbers, parse, parse_form, with_newlines};
use crate::shape::Form;

/// The value of the field `schema` of every JSON document.
pub const SCHEMA: &str = "stellate/1";

/// The text before the form in the comment of a list of radii that names the form they parametrize.
pub(crate) const PARAMETRIZES: &str = "parametrizes:";

/// Reads a form from text that is a JSON document (if it starts with `{`) or a formula.
///
/// If a comment says `# parametrizes: FORM`, `parametrize` wrote the text for this form, and the form is read from the comment.
/// The radii themselves may have roots, which the input language does not have.
///
/// ```
/// use stellate::reading::read_text;
/// use stellate::language::Numbers;
/// let document = r#"{"schema":"stellate/1","kind":"fourier","cos":["1","1/5"],"sin":["0","0"]}"#;
/// let formula = "r = 1 + 1/5*cos(t)";
/// let read = |text| read_text(text, "<form>", Numbers::Exact).unwrap();
/// assert_eq!(read(document), read(formula));
///
/// let radii = "# parametrizes: x^4 + y^4 = 1\nr = root(1/(cos(theta)^4 + sin(theta)^4), 4)";
/// assert_eq!(read(radii), read("x^4 + y^4 = 1"));
/// ```
///
/// # Errors
/// Those of [`read_document`] or of [`parse_form`].
pub fn read_text(text: &str, source_name: &str, numbers: Numbers) -> Result<Form> {
    read_written(text, source_name, numbers).map(|written| written.form)
}

/// A form that was read from a text, and how it differs from what is written there.
pub(crate) struct Written {
    pub(crate) form: Form,
    /// The form as a comment names it, if the formula beside the comment is another form.
    pub(crate) comment: Option<String>,
    /// Whether the form has the origin besides the points of what is written.
    pub(crate) adds_origin: bool,
}

/// Reads a form as [`read_text`] does.
///
/// # Errors
/// Those of [`read_text`]; [`Error::Data`] if an equation of another form stands beside the comment, because `parametrize` writes
/// none.
pub(crate) fn read_written(text: &str, source_name: &str, numbers: Numbers) -> Result<Written> {
    let mut comment = None;
    let (form, adds_origin) = if is_document(text) {
        (read_document(text, source_name, numbers)?, false)
    } else if let Some(named) = parametrized_form(&with_newlines(text)) {
        let (form, adds_origin) = parse(&named, source_name, numbers)?;
        let beside = parse_form(text, source_name, numbers);
        match beside.ok().filter(|beside| *beside != form) {
            None => {}
            Some(Form::Curve(_) | Form::Surface(_) | Form::Intersection(_)) => {
                let message = format!(
                    "a comment names the form, with `{PARAMETRIZES}`, and beside it there is an equation of another form; \
                     delete one of them"
                );
                return Err(Error::data(source_name, message));
            }
            Some(_) => {
                let lines = named.lines().map(str::trim);
                let lines = lines.filter(|line| !line.is_empty() && !line.starts_with('#'));
                comment = Some(lines.collect());
            }
        }
        (form, adds_origin)
    } else {
        parse(text, source_name, numbers)?
    };
    Ok(Written {
        form,
        comment,
        adds_origin,
    })
}

/// Whether the text is a JSON document: an object has a name in quotes first, while `{t^2, t^3}` is a list of coordinates.
fn is_document(text: &str) -> bool {
    let body = text.trim_start_matches('\u{feff}').trim_start();
    let inner = body.strip_prefix('{').map(str::trim_start);
    inner.is_some_and(|inner| inner.is_empty() || inner.starts_with(['"', '}']))
}

/// The text behind `start` in the comment of a line. A comment may stand behind a formula.
fn comment<'a>(line: &'a str, start: &str) -> Option<&'a str> {
    let (_, comment) = line.split_once('#')?;
    comment.trim_start().strip_prefix(start)
}

/// The comment of a line that states the center, with its sign.
fn center_in(line: &str) -> Option<&str> {
    comment(line, "center:")?;
    line.find('#').map(|at| &line[at..])
}

/// The form that the text says it parametrizes, with its center, both at their places in the text; everything else is blank.
fn parametrized_form(text: &str) -> Option<String> {
    let at_its_place = |line: &str, end: &str| " ".repeat(line.len() - end.len()) + end;
    let mut found = false;
    let lines: Vec<String> = text
        .lines()
        .map(|line| match comment(line, PARAMETRIZES) {
            Some(form) if !found => {
                found = true;
                at_its_place(line, form)
            }
            Some(_) => String::new(),
            None => center_in(line).map_or_else(String::new, |center| at_its_place(line, center)),
        })
        .collect();
    found.then(|| lines.join("\n"))
}
