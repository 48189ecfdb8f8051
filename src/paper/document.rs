//! Writes the outcomes of the statements as a table, in full, or as JSON.

use std::io::Write;

use serde::Serialize;

use super::appendix::Appendix;
use super::entry::{Entry, EntryVerdict, Outcome};
use crate::document::{Format, Kind, SCHEMA};
use crate::error::{Invariant, Result};

#[derive(Serialize)]
struct PaperDocument<'a> {
    schema: &'static str,
    kind: &'static str,
    entries: Vec<EntryDocument<'a>>,
}

#[derive(Serialize)]
struct EntryDocument<'a> {
    id: &'a str,
    title: &'a str,
    section: &'a str,
    printed: String,
    correct: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    note: String,
    verdict: &'static str,
    evidence: String,
    expected: bool,
    seconds: f64,
}

/// Writes the outcomes as a table by sections or as the JSON document of kind `paper`, with the appendix if there is one.
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub fn write_entries(
    entries: &[(Entry<'_>, Outcome)],
    appendix: Option<&dyn Appendix>,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    match format {
        Format::Text => {
            write_table(entries, out)?;
            write_appendix(appendix, out)
        }
        Format::Json => {
            let document = PaperDocument {
                schema: SCHEMA,
                kind: "paper",
                entries: entries.iter().map(|(e, o)| document(e, o)).collect(),
            };
            let document = serde_json::to_string(&document);
            let mut text = document.invariant("what a document holds has a form in JSON");
            if let Some(appendix) = appendix {
                text.truncate(text.len() - 1);
                text.push_str(&format!(",\"comparison\":{}}}", appendix.json()));
            }
            Ok(writeln!(out, "{text}")?)
        }
        _ => Err(Kind::Statements.refused(format)),
    }
}

/// Writes these entries in full, one below the other, or as the JSON document of kind `paper`, with the appendix if there is
/// one.
///
/// # Errors
/// As [`write_entries`].
pub fn write_in_full(
    entries: &[(Entry<'_>, Outcome)],
    appendix: Option<&dyn Appendix>,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    if format != Format::Text {
        return write_entries(entries, appendix, format, out);
    }
    for (index, (entry, outcome)) in entries.iter().enumerate() {
        if index > 0 {
            writeln!(out)?;
        }
        write_entry(entry, outcome, out)?;
    }
    write_appendix(appendix, out)
}

fn write_entry(entry: &Entry<'_>, outcome: &Outcome, out: &mut dyn Write) -> Result<()> {
    writeln!(out, "{}: {}", entry.id, entry.title)?;
    writeln!(out, "section: {}", entry.section)?;
    writeln!(out, "printed: {}", entry.printed)?;
    if entry.correct != entry.printed {
        writeln!(out, "correct: {}", entry.correct)?;
    }
    if !entry.note.is_empty() {
        writeln!(out, "note: {}", entry.note)?;
    }
    for (what, text) in [("where", entry.definitions), ("with", entry.squares)] {
        if !text.is_empty() {
            writeln!(out, "{what}: {text}")?;
        }
    }
    for finding in &outcome.findings {
        writeln!(out, "{}", finding.sentences())?;
    }
    writeln!(
        out,
        "verdict: {}{}",
        outcome.verdict,
        unexpected(entry, outcome)
    )?;
    Ok(writeln!(out, "meaning: {}", outcome.verdict.meaning())?)
}

/// Writes a blank line and the appendix, if there is one.
fn write_appendix(appendix: Option<&dyn Appendix>, out: &mut dyn Write) -> Result<()> {
    match appendix {
        None => Ok(()),
        Some(appendix) => {
            writeln!(out)?;
            appendix.write_text(out)
        }
    }
}

fn document<'a>(entry: &Entry<'a>, outcome: &Outcome) -> EntryDocument<'a> {
    let lines = outcome.findings.iter().map(|f| f.sentences().to_string());
    EntryDocument {
        id: entry.id,
        title: entry.title,
        section: entry.section,
        printed: entry.printed.to_string(),
        correct: entry.correct.to_string(),
        note: entry.note.to_string(),
        verdict: outcome.verdict.name(),
        evidence: lines.collect::<Vec<_>>().join("\n"),
        expected: outcome.expected,
        seconds: outcome.time.as_secs_f64(),
    }
}

/// The remark behind a verdict that is not the recorded one; empty for the recorded verdict.
pub(super) fn unexpected(entry: &Entry<'_>, outcome: &Outcome) -> String {
    if outcome.expected {
        String::new()
    } else {
        format!(" (UNEXPECTED: recorded is \"{}\")", entry.expected)
    }
}

fn write_table(entries: &[(Entry<'_>, Outcome)], out: &mut dyn Write) -> Result<()> {
    let width = |text: &str| text.chars().count();
    let of_id = entries.iter().map(|(e, _)| width(e.id)).max().unwrap_or(0);
    let verdicts = entries.iter().map(|(_, o)| width(o.verdict.name()));
    let of_verdict = verdicts.max().unwrap_or(0);
    let mut section = "";
    for (entry, outcome) in entries {
        if entry.section != section {
            section = entry.section;
            writeln!(out, "{section}")?;
        }
        writeln!(
            out,
            "  {:of_id$}  {:of_verdict$}  {}{}",
            entry.id,
            outcome.verdict.name(),
            entry.title,
            unexpected(entry, outcome)
        )?;
    }
    let count = |verdict| entries.iter().filter(|(_, o)| o.verdict == verdict).count();
    let unexpected = entries.iter().filter(|(_, o)| !o.expected).count();
    let parts = EntryVerdict::EXPECTED.map(|v| format!("{} {v}", count(v)));
    Ok(writeln!(
        out,
        "{} statements: {}; {unexpected} not as expected",
        entries.len(),
        parts.join(", ")
    )?)
}
