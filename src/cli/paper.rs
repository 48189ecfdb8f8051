//! `stellate paper`: every statement of the paper, checked.

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use stellate::document::Format;
use stellate::error::{Error, Result};
use stellate::paper::{Entry, entries, write_entries, write_entry};

use super::arguments::Paper;
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(verb: &Paper, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    if !matches!(format, Format::Text | Format::Json) {
        return Err(Error::Usage(format!(
            "--format {format}: the statements of the paper are written as text or json"
        )));
    }
    let all = entries()?;
    let chosen = match &verb.only {
        None => all,
        Some(id) => vec![find(all, id)?],
    };
    let evaluated = session.stage("evaluate", |session| {
        let bar = session.progress(chosen.len(), "checking the paper");
        let outcomes: Result<Vec<_>> = chosen
            .par_iter()
            .map(|entry| {
                let outcome = entry.evaluate(&session.limits)?;
                bar.inc(1);
                Ok((entry.clone(), outcome))
            })
            .collect();
        bar.finish_and_clear();
        outcomes
    })?;
    if evaluated.iter().any(|(_, outcome)| !outcome.expected) {
        session.answer_no();
    }
    match (&verb.only, &evaluated[..]) {
        (Some(_), [(entry, outcome)]) => {
            write_result(session, |out| write_entry(entry, outcome, format, out))
        }
        _ => write_result(session, |out| write_entries(&evaluated, format, out)),
    }
}

/// The entry with this id, in capitals or not.
fn find(entries: Vec<Entry<'static>>, id: &str) -> Result<Entry<'static>> {
    let ids: Vec<&str> = entries.iter().map(|e| e.id).collect();
    let ids = ids.join(", ");
    let found = entries.into_iter().find(|e| e.id.eq_ignore_ascii_case(id));
    found.ok_or_else(|| {
        Error::Usage(format!(
            "--only {id}: there is no such statement; there are {ids}"
        ))
    })
}
