//! Writes the whole paper as one page of HTML.

use std::io::Write;

use super::appendix::Appendix;
use super::document::unexpected;
use super::entry::{Entry, EntryVerdict, Outcome};
use super::mathml;
use super::text::{Text, unbroken};
use crate::error::Result;
use crate::html::{begin_page, end_page, escaped, write_picture};

/// A figure of the report.
#[derive(Clone, Debug)]
pub struct ReportFigure {
    /// The id of the entry that the figure belongs to.
    pub id: &'static str,
    /// What the figure shows. The text stands below the figure and describes it to those who do not see it. Formulas stand
    /// between dollars.
    pub caption: &'static str,
    /// The command that draws the figure, as it is typed in the top folder of the repository.
    pub command: String,
    /// The figure as SVG.
    pub svg: String,
}

/// The digital object identifier of the paper.
const DOI: &str = "10.1006/cviu.2000.0881";

/// Writes the report, with the appendix if there is one. `date` is the day of the report, such as `2001-12-31`.
///
/// # Errors
/// Those of `out`.
pub fn write_report(
    entries: &[(Entry<'_>, Outcome)],
    figures: &[ReportFigure],
    appendix: Option<&dyn Appendix>,
    date: &str,
    out: &mut dyn Write,
) -> Result<()> {
    let title = "The paper, statement by statement";
    begin_page(title, "To the statements", out)?;
    write!(
        out,
        "<header>\n\
         <h1>The paper, statement by statement</h1>\n\
         <p>Ünsalan &amp; Erçil, <cite>Conversions between Parametric and Implicit Forms Using Polar/Spherical \
         Coordinate Representations</cite>, Computer Vision and Image Understanding 81, 1–25 (2001), \
         <a href=\"https://doi.org/{DOI}\">doi:{DOI}</a>: what is printed, what is true, and the evidence, computed in \
         exact arithmetic by stellate {} on <time datetime=\"{date}\">{date}</time>.</p>\n</header>\n",
        env!("CARGO_PKG_VERSION")
    )?;
    write_legend(entries, out)?;
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
    writeln!(out, "</main>")?;
    Ok(end_page(out)?)
}

/// Writes the number, the colour and the meaning of each verdict, and how to read the evidence.
fn write_legend(entries: &[(Entry<'_>, Outcome)], out: &mut dyn Write) -> Result<()> {
    let count = |verdict| entries.iter().filter(|(_, o)| o.verdict == verdict).count();
    let unexpected = entries.iter().filter(|(_, o)| !o.expected).count();
    let recorded = match unexpected {
        0 => "All of them come out as recorded.".to_owned(),
        1 => "One of them does not come out as recorded.".to_owned(),
        several => format!("{several} of them do not come out as recorded."),
    };
    writeln!(
        out,
        "<section aria-labelledby=\"legend\">\n<h2 id=\"legend\">How to read this</h2>\n\
         <p>There are {} statements. {recorded} The verdict on each has a colour:</p>\n<dl>",
        entries.len()
    )?;
    let fails = EntryVerdict::Fails;
    let all = EntryVerdict::EXPECTED.into_iter().chain([fails]);
    for verdict in all.filter(|&v| v != fails || count(v) > 0) {
        writeln!(
            out,
            "<dt><span class=\"{}\">{verdict}</span>, {} times</dt>\n<dd>{}</dd>",
            class(verdict),
            count(verdict),
            escaped(verdict.meaning())
        )?;
    }
    Ok(writeln!(
        out,
        "</dl>\n<p>In the evidence, <span class=\"holds\">✓</span> stands before what holds and \
         <span class=\"corrected\">✗</span> before what fails. The command below a figure draws it as an SVG file; it is \
         typed in the top folder of the repository of stellate.</p>\n</section>"
    )?)
}

/// Writes a list of the sections, with links to their statements.
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

/// Writes a table of all statements that are not true as printed.
fn write_errata(entries: &[(Entry<'_>, Outcome)], out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "<section aria-labelledby=\"errata\">\n<h2 id=\"errata\">Errata</h2>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" \
         aria-label=\"Table of errata\">\n<table class=\"errata\">\n<thead><tr><th scope=\"col\">Where</th><th scope=\"col\">Printed</th>\
         <th scope=\"col\">Correct</th></tr></thead>\n<tbody>"
    )?;
    for (entry, outcome) in entries
        .iter()
        .filter(|(_, o)| o.verdict != EntryVerdict::Holds)
    {
        writeln!(
            out,
            "<tr><th scope=\"row\"><a class=\"{}\" href=\"#{}\">{}</a> {}</th>\
             <td data-heading=\"Printed\">{}</td><td data-heading=\"Correct\">{}</td></tr>",
            class(outcome.verdict),
            entry.id,
            entry.id,
            escaped(entry.title),
            entry.printed.markup(),
            entry.correct.markup()
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
    let mut sides = vec![("Printed", &entry.printed)];
    if entry.correct != entry.printed {
        sides.push(("Correct", &entry.correct));
    }
    writeln!(out, "<div class=\"sides\">")?;
    for (heading, text) in sides {
        writeln!(
            out,
            "<div>\n<h4>{heading}</h4>\n<p class=\"formula\">{}</p>\n</div>",
            text.markup()
        )?;
    }
    writeln!(out, "</div>")?;
    if !entry.note.is_empty() {
        writeln!(out, "<p>{}</p>", entry.note.markup())?;
    }
    for figure in figures.iter().filter(|f| f.id == entry.id) {
        let caption = Text::marked(figure.caption);
        write_picture(&caption.to_string(), &figure.svg, out)?;
        writeln!(
            out,
            "<figcaption>{}<br/><code>{}</code></figcaption>\n</figure>",
            caption.markup(),
            unbroken(&figure.command)
        )?;
    }
    writeln!(out, "<details open=\"\">\n<summary>Evidence</summary>")?;
    write_meanings(entry, out)?;
    writeln!(out, "<ul>")?;
    for finding in &outcome.findings {
        let class = if finding.holds { "yes" } else { "no" };
        writeln!(
            out,
            "<li class=\"{class}\"><div class=\"formula\">{}</div></li>",
            finding.sentences().markup()
        )?;
    }
    Ok(writeln!(out, "</ul>\n</details>\n</article>")?)
}

/// Writes what the symbols of an entry stand for.
fn write_meanings(entry: &Entry<'_>, out: &mut dyn Write) -> Result<()> {
    let equations = entry.meanings();
    if equations.is_empty() {
        return Ok(());
    }
    let mut text = Text::default().words("In the formulas below ");
    for (index, [left, right]) in equations.iter().enumerate() {
        let before = match index {
            0 => "",
            _ if index + 1 == equations.len() => " and ",
            _ => ", ",
        };
        text = text
            .words(before)
            .formula(String::new(), mathml::equation(left, right));
    }
    Ok(writeln!(
        out,
        "<p class=\"formula\">{}</p>",
        text.words(".").markup()
    )?)
}

/// Writes the slowest statements and the time of all.
fn write_times(entries: &[(Entry<'_>, Outcome)], out: &mut dyn Write) -> Result<()> {
    /// The number of statements that are listed.
    const LISTED: usize = 10;
    let mut by_time: Vec<_> = entries.iter().collect();
    by_time.sort_unstable_by_key(|(_, outcome)| std::cmp::Reverse(outcome.time));
    let total: std::time::Duration = entries.iter().map(|(_, o)| o.time).sum();
    writeln!(
        out,
        "<section aria-labelledby=\"times\">\n<h2 id=\"times\">Times</h2>\n<p>Seconds by the clock: the statements were \
         tested one after another, each with up to {} threads. All of them together took {:.3} s, without the figures. The \
         slowest:</p>\n<table>\n<thead><tr><th scope=\"col\">Statement</th><th scope=\"col\">Seconds</th></tr></thead>\n<tbody>",
        rayon::current_num_threads(),
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

/// The id of a heading, for links: its ASCII letters and digits in lower case, and `-` for every other character.
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
    fn an_anchor_has_only_letters_digits_and_hyphens() {
        assert_eq!(anchor("Inspection (§4)"), "inspection---4-");
    }
}
