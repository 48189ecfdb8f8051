//! The paper, statement by statement: what is printed, what is true, and the evidence, computed each time.
//!
//! The statements are data: text files beside this one, read by [`entries`]. Each test of a statement is about one of three
//! parts:
//!
//! - `test printed:` is about what the paper prints; it may fail, and then it must fail as recorded;
//! - `test corrected:` is about the corrected statement; it must hold;
//! - `test:` must hold in any case.
//!
//! A test is an identity between two formulas in any symbols, which expansion over Q proves, or a question to the library with
//! a claimed answer. The same code evaluates the printed and the corrected part, and the verdict follows from the results:
//! [`EntryVerdict`].
//!
//! What the paper says about speed is measured by another module, and its results are reported as an [`Appendix`].

mod appendix;
mod data;
mod document;
mod entry;
mod formula;
mod identity;
mod mathml;
mod question;
mod report;
mod statements;
mod text;
mod typeset;

pub use appendix::Appendix;
pub use data::EXAMPLE_DATA;
pub use document::{write_entries, write_in_full};
pub use entry::{Entry, EntryVerdict, Finding, Outcome, Test, TestPart};
pub use formula::Formula;
pub use report::{ReportFigure, write_report};
pub use statements::{entries, read_entries};
pub use text::Text;
