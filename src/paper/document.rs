//! What came of the statements, as a table, in full, and as JSON.

use std::io::Write;

use serde::Serialize;

use super::appendix::Appendix;
use super::entry::{Entry, EntryVerdict, Finding, Outcome, TestPart};
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
    printed: &'a str,
    correct: &'a str,
    verdict: &'static str,
    evidence: String,
    expected: bool,
    seconds: f64,
}

/// Writes a table by sections, or the JSON document of kind `paper`; then the appendix, if there is one.
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

/// Writes one entry in full, or the JSON document of kind `paper` with this entry alone.
///
/// # Errors
/// As [`write_entries`].
pub fn write_entry(
    entry: &Entry<'_>,
    outcome: &Outcome,
    appendix: Option<&dyn Appendix>,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    if format != Format::Text {
        let one = [(entry.clone(), outcome.clone())];
        return write_entries(&one, appendix, format, out);
    }
    writeln!(out, "{}: {}", entry.id, entry.title)?;
    writeln!(out, "section: {}", entry.section)?;
    writeln!(out, "printed: {}", entry.printed)?;
    if entry.correct != entry.printed {
        writeln!(out, "correct: {}", entry.correct)?;
    }
    for (what, text) in [("where", entry.definitions), ("with", entry.squares)] {
        if !text.is_empty() {
            writeln!(out, "{what}: {text}")?;
        }
    }
    for finding in &outcome.findings {
        writeln!(out, "{}", line(finding))?;
    }
    writeln!(
        out,
        "verdict: {}{}",
        outcome.verdict,
        unexpected(entry, outcome)
    )?;
    write_appendix(appendix, out)
}

/// What stands below the statements.
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
    let lines: Vec<String> = outcome.findings.iter().map(line).collect();
    EntryDocument {
        id: entry.id,
        title: entry.title,
        section: entry.section,
        printed: entry.printed,
        correct: entry.correct,
        verdict: outcome.verdict.name(),
        evidence: lines.join("\n"),
        expected: outcome.expected,
        seconds: outcome.time.as_secs_f64(),
    }
}

/// `printed, fails: …`
pub(super) fn line(finding: &Finding) -> String {
    let part = match finding.part {
        TestPart::Printed => "printed, ",
        TestPart::Corrected => "corrected, ",
        TestPart::Always => "",
    };
    let holds = if finding.holds { "holds" } else { "fails" };
    format!("{part}{holds}: {}", finding.evidence)
}

/// What follows a verdict that is not the recorded one.
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
