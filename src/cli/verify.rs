//! `stellate verify`: checks proof files.

use std::io::Read;

use stellate::error::{Error, Result};
use stellate::proof::{LONGEST_DOCUMENT, PYTHON_CHECKER, check};

use super::arguments::Verify;
use super::input::refuse_output;
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(flags: &Verify, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let Some(name) = &flags.file else {
        return write_result(session, |out| Ok(out.write_all(PYTHON_CHECKER.as_bytes())?));
    };
    refuse_output(name, session)?;
    let text = session.work.stage("read", || read(name))?;
    let report = session
        .work
        .stage("check", || Ok(check(&text, flags.complete)))?
        .map_err(|refusal| Error::Usage(format!("{name}: no proof: {refusal}")))?;
    if !report.holds() {
        session.answer_no();
    }
    write_result(session, |out| Ok(writeln!(out, "{report}")?))
}

/// The text of a file, or of standard input, which may be a little longer than the longest document.
fn read(name: &str) -> Result<String> {
    let failed = |source| Error::Io {
        path: name.into(),
        source,
    };
    let source: Box<dyn Read> = match name {
        "-" => Box::new(std::io::stdin()),
        _ => Box::new(std::fs::File::open(name).map_err(failed)?),
    };
    let mut bytes = Vec::new();
    let mut limited = source.take(LONGEST_DOCUMENT as u64 + 1);
    limited.read_to_end(&mut bytes).map_err(failed)?;
    String::from_utf8(bytes)
        .map_err(|_| Error::Usage(format!("{name}: no proof: this is not UTF-8 text")))
}
