//! The paper, statement by statement: what is printed, what is true, and the evidence, computed each time.
//!
//! The statements are data: text files beside this one, read by [`entries`]. A statement has tests of three parts:
//!
//! - `test printed:` what the paper prints; it may fail, and then it must fail as stated;
//! - `test corrected:` the same once corrected; it must hold;
//! - `test:` what must hold in any case.
//!
//! A test is an identity between two formulas in any symbols (proved by expansion over Q), or a question to the engine with
//! the answer that is claimed. One code path evaluates the printed and the corrected part, and the verdict follows from what
//! comes out: [`EntryVerdict`].
//!
//! What the paper says of speed is measured elsewhere, and reported with it as an [`Appendix`].

mod appendix;
mod data;
mod document;
mod entry;
mod formula;
pub(crate) mod html;
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
