//! What may be reported with the statements, and writes itself.

use std::io::Write;

use crate::error::Result;

/// Something that stands at the end of a report on the paper: the field `comparison` of its document, a text, a section of its
/// page.
pub trait Appendix {
    /// The value of the field, as JSON.
    fn json(&self) -> String;

    /// The text below the statements.
    ///
    /// # Errors
    /// Those of `out`.
    fn write_text(&self, out: &mut dyn Write) -> Result<()>;

    /// The section of the page, with the id `comparison`.
    ///
    /// # Errors
    /// Those of `out`.
    fn write_section(&self, out: &mut dyn Write) -> Result<()>;
}
