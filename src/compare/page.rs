//! The time comparison as a section of the report.

use std::io::Write;

use super::document::{absence, cell, degree, failures, growth, measured, shown};
use super::growth::{chart, letter, ratio};
use super::radius::RADIUS_TEXT;
use super::{MethodTimes, TimeComparison};
use crate::error::Result;
use crate::html::{escaped, write_picture};

/// Writes the section: the question, the chart, the table, and their meaning.
///
/// # Errors
/// Those of `out`.
pub(super) fn write_section(comparison: &TimeComparison, out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "<section aria-labelledby=\"comparison\">\n<h2 id=\"comparison\">The time comparison</h2>\n\
         <p>The paper says of its technique, below Example 1, that “it is not iterative and hence is in general faster, although \
         no systematic time comparisons have been carried out”. Here is one: Theorem 2 beside elimination, for one radius, {}, with more and more \
         harmonics. It is about times, so it is no statement with a verdict.</p>\n<ul>",
        escaped(RADIUS_TEXT)
    )?;
    for (index, method) in comparison.methods.iter().enumerate() {
        let MethodTimes { program, what, .. } = method;
        writeln!(
            out,
            "<li><strong>{}</strong> {}, {}</li>",
            letter(index),
            escaped(program),
            escaped(what)
        )?;
    }
    for program in &comparison.absent {
        writeln!(out, "<li>{}</li>", escaped(&absence(program)))?;
    }
    writeln!(out, "</ul>")?;
    if let Ok(svg) = chart(comparison).to_svg() {
        write_picture(&alternative(comparison), &svg, out)?;
        writeln!(
            out,
            "<figcaption>Seconds over N, both axes logarithmic: a power of N is a straight line.</figcaption>\n</figure>"
        )?;
    }
    write_table(comparison, out)?;
    for line in failures(comparison) {
        writeln!(out, "<p>{}.</p>", escaped(&line))?;
    }
    for sentence in meaning(comparison) {
        writeln!(out, "<p>{}</p>", escaped(&sentence))?;
    }
    Ok(writeln!(out, "</section>")?)
}

fn write_table(comparison: &TimeComparison, out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "<p id=\"measured\">≈ seconds, {}. Below: how many times as long as A.</p>\n\
         <div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Table of times\">\n\
         <table class=\"grid\" aria-describedby=\"measured\">\n<thead><tr><th scope=\"col\">N</th>\
         <th scope=\"col\" class=\"number\">Degree</th>",
        escaped(&measured(comparison))
    )?;
    for index in 0..comparison.methods.len() {
        writeln!(
            out,
            "<th scope=\"col\" class=\"number\">{}</th>",
            letter(index)
        )?;
    }
    writeln!(out, "</tr></thead>\n<tbody>")?;
    for harmonics in comparison.rungs() {
        write!(
            out,
            "<tr><th scope=\"row\">{harmonics}</th><td class=\"number\">{}</td>",
            degree(harmonics)
        )?;
        for (index, method) in comparison.methods.iter().enumerate() {
            let ratio = ratio(comparison, method, harmonics).filter(|_| index > 0);
            let ratio = ratio.map_or_else(String::new, |r| {
                format!("<br/><small>× {}</small>", shown(r))
            });
            let time = cell(comparison, method, harmonics);
            write!(out, "<td class=\"number\">{}{ratio}</td>", escaped(&time))?;
        }
        writeln!(out, "</tr>")?;
    }
    Ok(writeln!(out, "</tbody>\n</table>\n</div>")?)
}

/// The description of the chart in words.
fn alternative(comparison: &TimeComparison) -> String {
    format!(
        "Seconds over N of {} methods. {} {}.",
        comparison.methods.len(),
        meaning(comparison).join(" "),
        growth(comparison)
    )
}

/// For each other method, the ratio of its time to that of Theorem 2, and then the growth of all times.
fn meaning(comparison: &TimeComparison) -> Vec<String> {
    let others = comparison.methods.iter().enumerate().skip(1);
    let mut sentences: Vec<String> = others
        .filter_map(|(index, method)| {
            let of = |n: usize| Some((n, ratio(comparison, method, n)?));
            let ratios: Vec<(usize, f64)> = comparison.rungs().into_iter().filter_map(of).collect();
            let (first, last) = (ratios.first()?, ratios.last()?);
            let times = |(n, ratio): &(usize, f64)| format!("{} at N = {n}", shown(*ratio));
            Some(format!(
                "{} takes ≈ {} times as long as Theorem 2, and {}.",
                letter(index),
                times(first),
                times(last)
            ))
        })
        .collect();
    sentences.push(format!("The {}.", growth(comparison)));
    sentences
}
