//! A supplement to the report on the statements, which writes itself.

use std::io::Write;

use crate::error::Result;

/// A supplement at the end of a report on the paper. It is the field `comparison` of a JSON document, a text below a table, or
/// a section of a page.
pub trait Appendix {
    /// The value of the field, as JSON.
    fn json(&self) -> String;

    /// Writes the text below the statements.
    ///
    /// # Errors
    /// Those of `out`.
    fn write_text(&self, out: &mut dyn Write) -> Result<()>;

    /// Writes the section of the page; its heading has the id `comparison`.
    ///
    /// # Errors
    /// Those of `out`.
    fn write_section(&self, out: &mut dyn Write) -> Result<()>;
}
