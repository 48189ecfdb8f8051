//! The report of an inspection: one page of HTML that needs no network and no script.

use std::io::Write;

use super::inspection::zone_text;
use super::json::{Number, text_of};
use super::remark::counted;
use crate::error::Result;
use crate::exact::Rational;
use crate::html::{begin_page, end_page, escaped, write_picture};
use crate::inspect::{CLASSES, InspectionSummary, RowDistance, ToleranceZone};
use crate::verb::KeptPoint;

/// The number of points in the table of the worst ones.
const WORST: usize = 20;

/// What a report says besides the points.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ReportHead {
    /// The form, as it was given.
    pub form: String,
    /// The tolerance zone.
    pub zone: ToleranceZone,
    /// The name of a point's number, such as `row`.
    pub number: &'static str,
    /// The command that makes the report.
    pub command: String,
    /// The day of the report, such as `2001-12-31`.
    pub date: String,
}

impl ReportHead {
    /// A report about this form with this tolerance zone, without a command and a day.
    #[must_use]
    pub fn new(form: impl Into<String>, zone: ToleranceZone) -> Self {
        Self {
            form: form.into(),
            zone,
            number: "point",
            command: String::new(),
            date: String::new(),
        }
    }
}

/// Writes the report: the numbers, the map of the points as SVG, the histogram, the worst points, what is certified, and how to
/// repeat it.
///
/// ```
/// use stellate::document::{ReportHead, write_inspection_report};
/// use stellate::inspect::InspectionSummary;
/// let head = ReportHead::new("x^2 + y^2 = 1", "1/10".parse()?);
/// let mut page = Vec::new();
/// write_inspection_report(&head, &InspectionSummary::default(), &[], "<svg/>", &mut page)?;
/// assert!(String::from_utf8_lossy(&page).contains("<h2 id=\"summary\">Summary</h2>"));
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of `out`.
pub fn write_inspection_report(
    head: &ReportHead,
    summary: &InspectionSummary,
    points: &[KeptPoint],
    map: &str,
    out: &mut dyn Write,
) -> Result<()> {
    let form = escaped(&head.form);
    begin_page("Report of an inspection", "To the summary", out)?;
    writeln!(
        out,
        "<header>\n<h1>Report of an inspection</h1>\n<p>{} compared with <code>{form}</code>, {}; computed by stellate {}\
         {}.</p>\n</header>\n<main id=\"content\">",
        counted(summary.points(), "point", "points"),
        escaped(&zone_text(&head.zone)),
        env!("CARGO_PKG_VERSION"),
        match head.date.as_str() {
            "" => String::new(),
            date => format!(" on <time datetime=\"{date}\">{date}</time>"),
        }
    )?;
    write_summary(head, summary, out)?;
    section("map", "The points by verdict", out)?;
    write_picture(
        "The form and the points: those inside in one colour, those outside in another one.",
        map,
        out,
    )?;
    writeln!(out, "</figure>\n</section>")?;
    write_histogram(&head.zone, summary, out)?;
    write_worst(head, points, out)?;
    section("certified", "What is certified", out)?;
    writeln!(
        out,
        "<ul>\n<li>Every verdict is exact: a point is inside if {}, for the coordinates as they \
         are written and the exact numbers of the form. {}</li>\n\
         <li>Every distance is enclosed by proved bounds. The sign is exact: −1 inside the form, 1 outside, 0 on it.</li>\n\
         <li>Means and the classes of the histogram are computed from the middles of these bounds, in doubles: they are \
         approximate.</li>\n</ul>\n</section>",
        meaning(&head.zone),
        match summary.undecided {
            0 => "No point is undecided.".to_owned(),
            n => format!(
                "Of {} neither was proved; they are called undecided.",
                counted(n, "point", "points")
            ),
        }
    )?;
    if !head.command.is_empty() {
        section("repeat", "How to repeat it", out)?;
        writeln!(
            out,
            "<p><code>{}</code></p>\n</section>",
            escaped(&head.command)
        )?;
    }
    writeln!(out, "</main>")?;
    Ok(end_page(out)?)
}

/// What it means that a point is inside.
fn meaning(zone: &ToleranceZone) -> String {
    let mut meaning = match zone.tolerance() {
        Some(_) => "its distance is at most the tolerance".to_owned(),
        None => format!("its signed distance is from {zone}"),
    };
    if zone.is_uncertain() {
        meaning += &format!(
            " wherever the true point is within the uncertainty {} of the measured one; it is outside if that is so nowhere, and \
             otherwise uncertain",
            zone.uncertainty()
        );
    }
    escaped(&meaning)
}

fn section(id: &str, title: &str, out: &mut dyn Write) -> Result<()> {
    Ok(writeln!(
        out,
        "<section aria-labelledby=\"{id}\">\n<h2 id=\"{id}\">{title}</h2>"
    )?)
}

fn write_summary(
    head: &ReportHead,
    summary: &InspectionSummary,
    out: &mut dyn Write,
) -> Result<()> {
    section("summary", "Summary", out)?;
    writeln!(out, "<table>")?;
    let bounds = |at: &RowDistance| {
        format!(
            "{} {}: {} to {}",
            head.number,
            at.row,
            shown(at.distance.low),
            shown(at.distance.high)
        )
    };
    let mut rows = vec![
        ("inside", summary.inside.to_string()),
        ("outside", summary.outside.to_string()),
        ("undecided", summary.undecided.to_string()),
        ("rows that are no points", summary.bad.to_string()),
    ];
    if let Some(uncertain) = summary.uncertain {
        rows.insert(2, ("uncertain", uncertain.to_string()));
    }
    rows.extend(summary.nearest.as_ref().map(|at| ("nearest", bounds(at))));
    rows.extend(summary.farthest.as_ref().map(|at| ("farthest", bounds(at))));
    if let Some([mean, rms, signed]) = summary.means() {
        rows.extend([
            ("mean distance", format!("≈ {mean:.6e}")),
            ("mean signed distance", format!("≈ {signed:.6e}")),
            ("root of the mean square", format!("≈ {rms:.6e}")),
        ]);
    }
    for (name, value) in rows {
        writeln!(
            out,
            "<tr><th scope=\"row\">{name}</th><td>{value}</td></tr>"
        )?;
    }
    Ok(writeln!(out, "</table>\n</section>")?)
}

/// A bound as JSON writes it.
fn shown(value: f64) -> String {
    text_of(&Number(value)).trim_matches('"').to_owned()
}

/// Writes the classes of the signed distances as a table with bars.
fn write_histogram(
    zone: &ToleranceZone,
    summary: &InspectionSummary,
    out: &mut dyn Write,
) -> Result<()> {
    section("histogram", "Signed distances", out)?;
    writeln!(
        out,
        "<p>Negative is inside the form; {}.</p>\n<table class=\"bars\">",
        match zone.tolerance() {
            Some(_) => "the classes are parts of the tolerance D",
            None => "the classes are parts of the range between the limits",
        }
    )?;
    let histogram = &summary.histogram;
    let limits = zone.limits().map(Rational::to_f64);
    let is_single = zone.tolerance().is_some();
    let ends = |k: usize| match is_single {
        true => {
            let end = |k: usize| 2.0 * as_f64(k) / 10.0 - 1.0;
            format!("{:.1} D to {:.1} D", end(k), end(k + 1))
        }
        false => {
            let [low, high] = zone.limits();
            let end = |k: usize| {
                let part = Rational::whole(k) / Rational::whole(CLASSES);
                (low + &((high - low) * part)).to_f64()
            };
            format!("{} to {}", shown(end(k)), shown(end(k + 1)))
        }
    };
    let [below, above] = match is_single {
        true => ["below −D".to_owned(), "above D".to_owned()],
        false => [
            format!("below {}", shown(limits[0])),
            format!("above {}", shown(limits[1])),
        ],
    };
    let within = (0..CLASSES).map(|k| (ends(k), histogram.within[k]));
    let classes: Vec<(String, usize)> = std::iter::once((below, histogram.below))
        .chain(within)
        .chain([(above, histogram.above)])
        .collect();
    let most = classes.iter().fold(1, |most, (_, n)| most.max(*n));
    for (name, n) in classes {
        let share = 100 * n / most;
        writeln!(
            out,
            "<tr><th scope=\"row\">{}</th><td class=\"number\">{n}</td><td class=\"bar\"><span style=\"width:{share}%\"></span></td></tr>",
            name.replace('-', "−")
        )?;
    }
    Ok(writeln!(out, "</table>\n</section>")?)
}

#[expect(clippy::cast_precision_loss, reason = "the number of a class")]
fn as_f64(k: usize) -> f64 {
    k as f64
}

/// Writes the points that are farthest away, or beyond their limits by the most.
fn write_worst(head: &ReportHead, points: &[KeptPoint], out: &mut dyn Write) -> Result<()> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    let limits = head.zone.limits().map(Rational::to_f64);
    // The distance, or by how much it is more than the tolerance of the point's side.
    let excess = |k: usize| {
        let found = &points[k].inspection;
        let allowed = match (head.zone.tolerance(), found.sign) {
            (Some(_), _) => 0.0,
            (None, Some(-1)) => -limits[0],
            (None, _) => limits[1],
        };
        found.distance.low - allowed
    };
    order.sort_unstable_by(|&a, &b| excess(b).total_cmp(&excess(a)).then(a.cmp(&b)));
    order.truncate(WORST);
    if order.is_empty() {
        return Ok(());
    }
    section("worst", "The worst points", out)?;
    writeln!(
        out,
        "<div class=\"wide\" tabindex=\"0\">\n<table>\n<thead><tr><th>{}</th><th>x</th><th>y</th><th>z</th><th>verdict</th>\
         <th>sign</th><th>distance</th></tr></thead>",
        head.number
    )?;
    for k in order {
        let KeptPoint {
            row,
            point,
            inspection: found,
        } = &points[k];
        let [x, y, z] = point.map(shown);
        let sign = found.sign.map_or(String::new(), |sign| sign.to_string());
        writeln!(
            out,
            "<tr><td>{}</td><td class=\"number\">{x}</td><td class=\"number\">{y}</td><td class=\"number\">{z}</td><td>{}</td>\
             <td class=\"number\">{sign}</td><td class=\"number\">{} to {}</td></tr>",
            row,
            found.verdict,
            shown(found.distance.low),
            shown(found.distance.high)
        )?;
    }
    Ok(writeln!(out, "</table>\n</div>\n</section>")?)
}
