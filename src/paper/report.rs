//! The whole paper as one page of HTML: no network, no script, readable on a phone, on paper, light and dark. It is
//! well-formed XML, too.

use std::io::Write;

use super::appendix::Appendix;
use super::document::{line, unexpected};
use super::entry::{Entry, EntryVerdict, Outcome, Test, TestKind, TestPart};
use super::html::{escaped, write_picture};
use super::mathml;
use crate::error::Result;

/// A figure of the report.
#[derive(Clone, Debug)]
pub struct ReportFigure {
    /// The entry that it stands beside.
    pub id: &'static str,
    /// What it shows, in words: for those who do not see it, and below it.
    pub caption: &'static str,
    /// The command line that draws it.
    pub command: String,
    /// The drawing.
    pub svg: String,
}

const STYLE: &str = include_str!("report.css");

/// Writes the report, with the appendix if there is one.
///
/// # Errors
/// Those of `out`.
pub fn write_report(
    entries: &[(Entry<'_>, Outcome)],
    figures: &[ReportFigure],
    appendix: Option<&dyn Appendix>,
    out: &mut dyn Write,
) -> Result<()> {
    let count = |verdict| entries.iter().filter(|(_, o)| o.verdict == verdict).count();
    let counts = EntryVerdict::EXPECTED.map(|v| format!("{} {v}", count(v)));
    let unexpected = entries.iter().filter(|(_, o)| !o.expected).count();
    write!(
        out,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
         <meta name=\"color-scheme\" content=\"light dark\"/>\n\
         <title>The paper, statement by statement</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <a class=\"skip\" href=\"#content\">To the statements</a>\n<header>\n\
         <h1>The paper, statement by statement</h1>\n\
         <p>Ünsalan &amp; Erçil, <cite>Conversions between Parametric and Implicit Forms Using Polar/Spherical \
         Coordinate Representations</cite>, Computer Vision and Image Understanding 81, 1–25 (2001): what is printed, \
         what is true, and the evidence, computed by stellate in exact arithmetic.</p>\n\
         <p><strong>{} statements</strong>: {}; {unexpected} not as expected.</p>\n</header>\n",
        entries.len(),
        counts.join(", ")
    )?;
    write_contents(entries, appendix.is_some(), out)?;
    writeln!(out, "<main id=\"content\">")?;
    write_errata(entries, out)?;
    let mut section = "";
    for (entry, outcome) in entries {
        if entry.section != section {
            if !section.is_empty() {
                writeln!(out, "</section>")?;
            }
            section = entry.section;
            let anchor = anchor(section);
            writeln!(
                out,
                "<section aria-labelledby=\"{anchor}\">\n<h2 id=\"{anchor}\">{}</h2>",
                escaped(section)
            )?;
        }
        write_article(entry, outcome, figures, out)?;
    }
    if !section.is_empty() {
        writeln!(out, "</section>")?;
    }
    if let Some(appendix) = appendix {
        appendix.write_section(out)?;
    }
    write_times(entries, out)?;
    Ok(writeln!(out, "</main>\n</body>\n</html>")?)
}

/// The sections, each with links to its statements.
fn write_contents(
    entries: &[(Entry<'_>, Outcome)],
    has_comparison: bool,
    out: &mut dyn Write,
) -> Result<()> {
    writeln!(
        out,
        "<nav aria-label=\"Contents\">\n<ul>\n<li><a href=\"#errata\">Errata</a></li>"
    )?;
    for chunk in entries.chunk_by(|(a, _), (b, _)| a.section == b.section) {
        let Some((first, _)) = chunk.first() else {
            continue;
        };
        let links = chunk.iter().map(|(entry, outcome)| {
            format!(
                "<a class=\"{}\" href=\"#{}\">{}</a>",
                class(outcome.verdict),
                entry.id,
                entry.id
            )
        });
        writeln!(
            out,
            "<li><a href=\"#{}\">{}</a>: {}</li>",
            anchor(first.section),
            escaped(first.section),
            links.collect::<Vec<_>>().join(" ")
        )?;
    }
    if has_comparison {
        writeln!(
            out,
            "<li><a href=\"#comparison\">The time comparison</a></li>"
        )?;
    }
    Ok(writeln!(
        out,
        "<li><a href=\"#times\">Times</a></li>\n</ul>\n</nav>"
    )?)
}

/// Everything that is not true as printed.
fn write_errata(entries: &[(Entry<'_>, Outcome)], out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "<section aria-labelledby=\"errata\">\n<h2 id=\"errata\">Errata</h2>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" \
         aria-label=\"Table of errata\">\n<table>\n<thead><tr><th scope=\"col\">Where</th><th scope=\"col\">Printed</th>\
         <th scope=\"col\">Correct</th></tr></thead>\n<tbody>"
    )?;
    for (entry, _) in entries
        .iter()
        .filter(|(_, o)| o.verdict != EntryVerdict::Holds)
    {
        writeln!(
            out,
            "<tr><th scope=\"row\"><a href=\"#{}\">{}</a> {}</th><td>{}</td><td>{}</td></tr>",
            entry.id,
            entry.id,
            escaped(entry.title),
            escaped(entry.printed),
            escaped(entry.correct)
        )?;
    }
    Ok(writeln!(out, "</tbody>\n</table>\n</div>\n</section>")?)
}

fn write_article(
    entry: &Entry<'_>,
    outcome: &Outcome,
    figures: &[ReportFigure],
    out: &mut dyn Write,
) -> Result<()> {
    writeln!(
        out,
        "<article id=\"{id}\" aria-labelledby=\"title-{id}\">\n<h3 id=\"title-{id}\">{id}: {} <span class=\"verdict {}\">{}{}</span></h3>",
        escaped(entry.title),
        class(outcome.verdict),
        outcome.verdict,
        escaped(&unexpected(entry, outcome)),
        id = entry.id
    )?;
    let differs = entry.correct != entry.printed;
    writeln!(out, "<div class=\"sides\">")?;
    let mut sides = vec![("Printed", entry.printed, TestPart::Printed)];
    if differs {
        sides.push(("Correct", entry.correct, TestPart::Corrected));
    }
    for (heading, text, part) in sides {
        writeln!(out, "<div>\n<h4>{heading}</h4>\n<p>{}</p>", escaped(text))?;
        write_formulas(&entry.tests, part, out)?;
        writeln!(out, "</div>")?;
    }
    writeln!(out, "</div>")?;
    write_formulas(&entry.tests, TestPart::Always, out)?;
    write_meanings(entry, out)?;
    for figure in figures.iter().filter(|f| f.id == entry.id) {
        write_picture(figure.caption, &figure.svg, out)?;
        writeln!(
            out,
            "<figcaption>{} <code>{}</code></figcaption>\n</figure>",
            escaped(figure.caption),
            escaped(&figure.command)
        )?;
    }
    writeln!(
        out,
        "<details open=\"\">\n<summary>Evidence</summary>\n<ul>"
    )?;
    for finding in &outcome.findings {
        let class = if finding.holds { "yes" } else { "no" };
        writeln!(
            out,
            "<li class=\"{class}\">{}</li>",
            escaped(&line(finding))
        )?;
    }
    Ok(writeln!(out, "</ul>\n</details>\n</article>")?)
}

/// The identities of one part of an entry, typeset.
fn write_formulas(tests: &[Test<'_>], part: TestPart, out: &mut dyn Write) -> Result<()> {
    for test in tests.iter().filter(|t| t.part == part) {
        if let TestKind::Identity {
            sides: [left, right],
            ..
        } = &test.kind
        {
            let math = mathml::equation(left, right);
            writeln!(out, "<p class=\"formula\" tabindex=\"0\">{math}</p>")?;
        }
    }
    Ok(())
}

/// What the symbols of an entry stand for.
fn write_meanings(entry: &Entry<'_>, out: &mut dyn Write) -> Result<()> {
    let equations = entry.meanings();
    if equations.is_empty() {
        return Ok(());
    }
    let shown: Vec<String> = equations
        .iter()
        .map(|[left, right]| mathml::equation(left, right))
        .collect();
    Ok(writeln!(
        out,
        "<p class=\"formula\" tabindex=\"0\">where {}</p>",
        shown.join("; ")
    )?)
}

/// The slowest statements.
fn write_times(entries: &[(Entry<'_>, Outcome)], out: &mut dyn Write) -> Result<()> {
    /// So many are listed.
    const LISTED: usize = 10;
    let mut by_time: Vec<_> = entries.iter().collect();
    by_time.sort_by_key(|(_, outcome)| std::cmp::Reverse(outcome.time));
    let total: std::time::Duration = entries.iter().map(|(_, o)| o.time).sum();
    writeln!(
        out,
        "<section aria-labelledby=\"times\">\n<h2 id=\"times\">Times</h2>\n<p>All statements together took {:.3} s of one core. \
         The slowest:</p>\n<table>\n<thead><tr><th scope=\"col\">Statement</th><th scope=\"col\">Seconds</th></tr></thead>\n<tbody>",
        total.as_secs_f64()
    )?;
    for (entry, outcome) in by_time.into_iter().take(LISTED) {
        writeln!(
            out,
            "<tr><th scope=\"row\"><a href=\"#{id}\">{id}</a> {}</th><td class=\"number\">{:.3}</td></tr>",
            escaped(entry.title),
            outcome.time.as_secs_f64(),
            id = entry.id
        )?;
    }
    Ok(writeln!(out, "</tbody>\n</table>\n</section>")?)
}

fn class(verdict: EntryVerdict) -> &'static str {
    match verdict {
        EntryVerdict::Holds => "holds",
        EntryVerdict::HoldsOnceCorrected => "corrected",
        EntryVerdict::ClaimTooStrong => "strong",
        EntryVerdict::Fails => "fails",
    }
}

/// A name for links from a heading.
fn anchor(heading: &str) -> String {
    let letters = heading.chars().map(|c| {
        if c.is_ascii_alphanumeric() {
            c.to_ascii_lowercase()
        } else {
            '-'
        }
    });
    letters.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_anchor_is_made_of_letters() {
        assert_eq!(anchor("Inspection (§4)"), "inspection---4-");
    }
}
