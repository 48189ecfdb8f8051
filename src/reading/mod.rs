//! Forms as they come in files: JSON documents, tables of coefficients, and formulas.

mod document;
mod node;
mod superquadric;
mod table;

pub use document::read_document;
pub(crate) use table::Table;
pub use table::{read_coefficients_csv, read_fourier_csv};

use crate::error::Result;
use crate::language::{Numbers, parse_form};
use crate::shape::Form;

/// The value of the field `schema` of every JSON document.
pub const SCHEMA: &str = "stellate/1";

/// Reads a form from text that is a JSON document (if it starts with `{`) or a formula.
///
/// ```
/// use stellate::reading::read_text;
/// use stellate::language::Numbers;
/// let document = r#"{"schema":"stellate/1","kind":"fourier","cos":["1","1/5"],"sin":["0","0"]}"#;
/// let formula = "r = 1 + 1/5*cos(t)";
/// let read = |text| read_text(text, "<form>", Numbers::Exact).unwrap();
/// assert_eq!(read(document), read(formula));
/// ```
///
/// # Errors
/// Those of [`read_document`] or of [`parse_form`].
pub fn read_text(text: &str, source_name: &str, numbers: Numbers) -> Result<Form> {
    if text
        .trim_start_matches('\u{feff}')
        .trim_start()
        .starts_with('{')
    {
        read_document(text, source_name, numbers)
    } else {
        parse_form(text, source_name, numbers)
    }
}
