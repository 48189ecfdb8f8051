//! `stellate paper`: every statement of the paper, checked.

use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use stellate::compare::{TimeComparison, compare};
use stellate::document::{Format, Kind};
use stellate::error::{Error, Result};
use stellate::paper::{Appendix, Entry, entries, write_entries, write_entry, write_report};

use super::arguments::Paper;
use super::output::{check_destination, check_place, write_beside, write_result};
use super::paper_figures;
use super::session::Session;

/// The report in its folder.
const PAGE: &str = "index.html";

pub(crate) fn run(verb: &Paper, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    Kind::Statements.check(format)?;
    if let Some(folder) = &verb.out {
        check_folder(folder)?;
    }
    let limit = compare_limit(verb)?;
    let all = entries()?;
    let chosen = match &verb.only {
        None => all,
        Some(id) => vec![find(all, id)?],
    };
    let evaluated = session.work.stage("evaluate", || {
        let (done, total) = (AtomicU64::new(0), chosen.len() as u64);
        let outcomes = chosen.par_iter().map(|entry| {
            let outcome = entry.evaluate(&session.limits)?;
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            session.progress("checking the paper", done, total);
            Ok((entry.clone(), outcome))
        });
        outcomes.collect::<Result<Vec<_>>>()
    })?;
    if evaluated.iter().any(|(_, outcome)| !outcome.expected) {
        session.answer_no();
    }
    let comparison = match verb.compare {
        true => Some(measure(limit, verb.compare_up_to, session)?),
        false => None,
    };
    let comparison = comparison.as_ref();
    if comparison.is_some_and(TimeComparison::has_wrong_answer) {
        session.answer_no();
    }
    let appendix = comparison.map(|found| found as &dyn Appendix);
    if let Some(folder) = &verb.out {
        let figures = paper_figures::draw(session)?;
        let mut page = Vec::new();
        write_report(&evaluated, &figures, appendix, &mut page)?;
        std::fs::create_dir_all(folder).map_err(|source| Error::Io {
            path: folder.clone(),
            source,
        })?;
        write_beside(&folder.join(PAGE), &page, session)?;
    }
    match (&verb.only, &evaluated[..]) {
        (Some(_), [(entry, outcome)]) => write_result(session, |out| {
            write_entry(entry, outcome, appendix, format, out)
        }),
        _ => write_result(session, |out| {
            write_entries(&evaluated, appendix, format, out)
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
fn measure(limit: Duration, largest: usize, session: &Session) -> Result<TimeComparison> {
    session.work.stage("compare", || {
        session.ended_at_checkpoints(|| {
            compare(limit, largest, &session.limits, &|done, total| {
                session.progress("measuring", done as u64, total as u64);
            })
        })
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
