//! `stellate paper`: every statement of the paper, checked.

use std::time::Duration;

use stellate::compare::{TimeComparison, compare};
use stellate::document::{Format, Kind};
use stellate::error::{Error, Result};
use stellate::paper::{Appendix, Entry, entries, write_entries, write_in_full, write_report};

use super::arguments::Paper;
use super::output::{check_destination, check_folder, today, write_page, write_result};
use super::paper_figures;
use super::session::Session;

pub(crate) fn run(verb: &Paper, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    Kind::Statements.check(format)?;
    if let Some(folder) = &verb.out {
        check_folder("--out", folder)?;
    }
    let all = entries()?;
    let chosen = match &verb.only {
        None => all,
        Some(wanted) => find(all, wanted)?,
    };
    let evaluated = session.work.stage("evaluate", || {
        // The statements are tested one after another, so that each time is that of one statement.
        let total = chosen.len() as u64;
        let outcomes = (1..).zip(chosen).map(|(done, entry)| {
            let outcome = entry.evaluate(&session.limits)?;
            session.progress("checking the paper", done, total);
            Ok((entry, outcome))
        });
        outcomes.collect::<Result<Vec<_>>>()
    })?;
    if evaluated.iter().any(|(_, outcome)| !outcome.expected) {
        session.answer_no();
    }
    let comparison = match verb.compare {
        true => Some(measure(verb.compare_limit, verb.compare_up_to, session)?),
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
        write_report(&evaluated, &figures, appendix, &today(), &mut page)?;
        write_page(folder, &page, session)?;
    }
    let write = match verb.only {
        Some(_) => write_in_full,
        None => write_entries,
    };
    write_result(session, |out| write(&evaluated, appendix, format, out))
}

/// Measures times. Only this work ends the other programs that it runs, at its checkpoints, so the process must not be ended
/// from outside.
fn measure(limit: Duration, largest: usize, session: &Session) -> Result<TimeComparison> {
    session.work.stage("compare", || {
        session.ended_at_checkpoints(|| {
            compare(limit, largest, &session.limits, &|done, total| {
                session.progress("measuring", done as u64, total as u64);
            })
        })
    })
}

/// The statement with this id, in any case of letters; if there is none, all statements with these words in their titles; if
/// there are none, all statements with this text in their titles, also within words.
fn find(entries: Vec<Entry<'static>>, wanted: &str) -> Result<Vec<Entry<'static>>> {
    let found = |fits: &dyn Fn(&Entry<'_>) -> bool| {
        let found: Vec<_> = entries.iter().filter(|entry| fits(entry)).collect();
        (!found.is_empty()).then(|| found.into_iter().cloned().collect())
    };
    let whole = words(wanted);
    let part = wanted.trim().to_lowercase();
    let chosen = found(&|entry| entry.id.eq_ignore_ascii_case(wanted.trim()))
        .or_else(|| found(&|entry| whole.len() > 1 && words(entry.title).contains(&whole)))
        .or_else(|| found(&|entry| !part.is_empty() && entry.title.to_lowercase().contains(&part)));
    chosen.ok_or_else(|| {
        let ids: Vec<&str> = entries.iter().map(|e| e.id).collect();
        Error::Usage(format!(
            "--only {wanted}: no statement has this id, or this in its title, as Theorem 2 or cubic; the ids are {}",
            ids.join(", ")
        ))
    })
}

/// The words of a text in lower case, without the characters between them, and with one blank before and after each word.
fn words(text: &str) -> String {
    let text = text.to_lowercase();
    let words = text.split(|c: char| !c.is_alphanumeric());
    let words = words.filter(|word| !word.is_empty());
    words.fold(" ".into(), |all, word| all + word + " ")
}
