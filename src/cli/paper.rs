//! `stellate paper`: every statement of the paper, checked.

use std::path::Path;
use std::time::Duration;

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use stellate::document::Format;
use stellate::error::{Error, Result};
use stellate::paper::{
    Entry, RUNGS, TimeComparison, compare, entries, write_entries, write_entry, write_report,
};

use super::arguments::Paper;
use super::output::{check_destination, check_place, write_beside, write_result};
use super::paper_figures;
use super::session::Session;

/// The report in its folder.
const PAGE: &str = "index.html";

pub(crate) fn run(verb: &Paper, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    if !matches!(format, Format::Text | Format::Json) {
        return Err(Error::Usage(format!(
            "--format {format}: the statements of the paper are written as text or json"
        )));
    }
    if let Some(folder) = &verb.out {
        check_folder(folder)?;
    }
    let limit = compare_limit(verb)?;
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
    let comparison = match verb.compare {
        true => Some(measure(limit, session)?),
        false => None,
    };
    let comparison = comparison.as_ref();
    if comparison.is_some_and(TimeComparison::has_wrong_answer) {
        session.answer_no();
    }
    if let Some(folder) = &verb.out {
        let figures = paper_figures::draw(session)?;
        let mut page = Vec::new();
        let written = write_report(&evaluated, &figures, comparison, &mut page);
        written
            .and_then(|()| std::fs::create_dir_all(folder))
            .map_err(|source| Error::Io {
                path: folder.clone(),
                source,
            })?;
        write_beside(&folder.join(PAGE), &page, session)?;
    }
    match (&verb.only, &evaluated[..]) {
        (Some(_), [(entry, outcome)]) => write_result(session, |out| {
            write_entry(entry, outcome, comparison, format, out)
        }),
        _ => write_result(session, |out| {
            write_entries(&evaluated, comparison, format, out)
        }),
    }
}

/// What `--compare-limit` says.
fn compare_limit(verb: &Paper) -> Result<Duration> {
    let seconds = verb.compare_limit;
    Duration::try_from_secs_f64(seconds).map_err(|_| {
        Error::Usage(format!(
            "--compare-limit {seconds}: expected a number of seconds, such as 10"
        ))
    })
}

/// The comparison of times; other programs that run for it end with it, whatever ends it.
fn measure(limit: Duration, session: &mut Session) -> Result<TimeComparison> {
    session.stage("compare", |session| {
        let bar = session.progress(RUNGS.len(), "measuring");
        let found = session.ended_at_checkpoints(|| {
            compare(limit, &session.limits, &|done, total| {
                bar.set_length(total as u64);
                bar.set_position(done as u64);
            })
        });
        bar.finish_and_clear();
        found
    })
}

/// Refuses a folder that cannot be made before any work is done.
fn check_folder(folder: &Path) -> Result<()> {
    if folder.exists() && !folder.is_dir() {
        return Err(Error::Usage(format!(
            "--out {}: that is a file; a folder is wanted, for the report {PAGE}",
            folder.display()
        )));
    }
    if folder.is_dir() {
        check_place("--out", &folder.join(PAGE))
    } else {
        check_place("--out", folder)
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
