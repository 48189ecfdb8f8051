//! Reports of checks: as text, as JSON, and as a table with a row for every comparison.

use std::io::Write;

use serde::Serialize;

use super::json::{Number, write_value};
use super::{Format, Kind, SCHEMA};
use crate::check::{Comparison, DOUBLE_DIGITS, Diagnosis, GivenNumber, Meaning, Row, Scale};
use crate::error::Result;
use crate::exact::Rational;
use crate::notation::Notation;
use crate::verb::DIGITS;

/// The number of significant decimals of exact numbers, three more than a double has.
const SHOWN_DIGITS: u32 = 20;

/// The number of rows in the table of the worst comparisons.
const WORST: usize = 10;

/// The length of the longest bar of the histogram.
const BAR: usize = 40;

#[derive(Serialize)]
struct CheckDocument<'a> {
    schema: &'static str,
    kind: &'static str,
    what: &'static str,
    compared: usize,
    worst: Option<Entry>,
    median_digits: Option<Number>,
    digits_lost: Option<Number>,
    mark: Option<u32>,
    below: usize,
    passes: Option<bool>,
    missing: Vec<Entry>,
    extra: Vec<Entry>,
    scale: Option<String>,
    scale_meaning: Option<String>,
    mistakes: Vec<MistakeEntry<'a>>,
    histogram: Vec<usize>,
    failures: Vec<Entry>,
    worst_rows: Vec<Entry>,
}

/// A number of the float program, the exact number, and the distance between them.
#[derive(Serialize)]
struct Entry {
    digits: Number,
    ulps: Number,
    r#where: String,
    got: String,
    exact: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    residual: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    first_order: Option<Number>,
}

#[derive(Serialize)]
struct MistakeEntry<'a> {
    name: &'a str,
    explanation: &'a str,
    digits: u32,
    faults: usize,
    faults_left: usize,
    compared: usize,
}

/// Writes the result of a check, judged by `mark` if it is given: as text, as JSON of kind `check`, or as CSV with a row for
/// every comparison.
///
/// The fields of the JSON document are: `what` (`coefficients`, `points` or `radii`); `compared`; the `worst` row (`digits`,
/// `ulps`, `where`, `got`, `exact`; for points also `residual` and `first_order`); `median_digits`; `digits_lost` (of the worst
/// row, from the 15.95 of a double); `mark`; `below` (the number of failures); `passes` (null without a mark); the terms that
/// are `missing` and `extra`; the common factor as `scale` and `scale_meaning`; `mistakes`; `histogram` (for 0, 1, …, 17 the
/// count of numbers with so many whole digits); and `worst_rows`. A mistake has `name` and `explanation`; `faults` is the
/// number of values that miss `digits` digits, and `faults_left` is the number of values that still miss them after the mistake
/// is taken into account. Exact numbers are strings: p/q for coefficients, decimals for irrational numbers. An infinite number
/// is "inf", and an absent value is null.
///
/// ```
/// use stellate::check::compare_coefficients;
/// use stellate::document::{Format, write_check};
/// use stellate::poly::SparsePolynomial;
/// let f = SparsePolynomial::from_terms([([2, 0, 0], 1.into()), ([0, 0, 0], (-2).into())]);
/// let mut out = Vec::new();
/// write_check(&compare_coefficients(&f, &f), Some(15), Format::Text, &mut out).unwrap();
/// assert!(String::from_utf8(out).unwrap().ends_with("passes: everything has 15 digits\n"));
/// ```
///
/// # Errors
/// Those of `out`, and those of [`Kind::check`].
pub fn write_check(
    found: &Comparison,
    mark: Option<u32>,
    format: Format,
    out: &mut dyn Write,
) -> Result<()> {
    if let Some(mark) = mark {
        DIGITS.check(mark)?;
    }
    match format {
        Format::Text => write_text(found, mark, out),
        Format::Csv => write_table(found, out),
        Format::Json => {
            write_value(&document(found, mark), out)?;
            Ok(writeln!(out)?)
        }
        _ => Err(Kind::Check.refused(format)),
    }
}

fn document(found: &Comparison, mark: Option<u32>) -> CheckDocument<'_> {
    let entries = |rows: Vec<&Row>| {
        rows.into_iter()
            .map(|row| entry(row, found.in_space))
            .collect::<Vec<_>>()
    };
    CheckDocument {
        schema: SCHEMA,
        kind: "check",
        what: what(found),
        compared: found.rows.len(),
        worst: found.worst(1).first().map(|row| entry(row, found.in_space)),
        median_digits: found.median_digits().map(Number),
        digits_lost: found.digits_lost().map(Number),
        mark,
        below: found.failures(mark).len(),
        passes: mark.map(|_| found.passes(mark)),
        missing: entries(found.missing.iter().collect()),
        extra: entries(found.extra.iter().collect()),
        scale: found.scale.as_ref().map(|s| s.factor.to_string()),
        scale_meaning: found.scale.as_ref().and_then(meaning),
        mistakes: found.diagnoses.iter().map(mistake_entry).collect(),
        histogram: found.histogram(),
        failures: entries(found.failures(mark)),
        worst_rows: entries(found.worst(WORST)),
    }
}

fn entry(row: &Row, in_space: bool) -> Entry {
    Entry {
        digits: Number(row.deviation.digits()),
        ulps: Number(row.deviation.ulps),
        r#where: place(row, in_space),
        got: format!("{:?}", row.got),
        exact: row.exact.as_ref().map(|q| match row.place {
            GivenNumber::Term(_) | GivenNumber::Harmonic { .. } => q.to_string(),
            _ => shown(q),
        }),
        residual: row.residual.map(|r| Number(r.value)),
        first_order: row.residual.map(|r| Number(r.first_order)),
    }
}

fn mistake_entry(diagnosis: &Diagnosis) -> MistakeEntry<'_> {
    MistakeEntry {
        name: &diagnosis.name,
        explanation: &diagnosis.explanation,
        digits: diagnosis.mark,
        faults: diagnosis.faults,
        faults_left: diagnosis.faults_left,
        compared: diagnosis.compared,
    }
}

fn what(found: &Comparison) -> &'static str {
    match found.all().next().map(|row| &row.place) {
        Some(GivenNumber::Point { .. }) => "points",
        Some(GivenNumber::Radius { .. } | GivenNumber::SpaceRadius { .. }) => "radii",
        _ => "coefficients",
    }
}

/// Whether the numbers are coefficients of spherical harmonics.
fn is_harmonic(found: &Comparison) -> bool {
    let first = found.all().next().map(|row| &row.place);
    matches!(first, Some(GivenNumber::Harmonic { .. }))
}

fn place(row: &Row, in_space: bool) -> String {
    match &row.place {
        GivenNumber::Term(exponents) => match Notation::Text.monomial(exponents) {
            constant if constant.is_empty() => "1".into(),
            monomial => monomial,
        },
        GivenNumber::Point { line, position } => {
            let [x, y, z] = position;
            if in_space {
                format!("line {line}: ({x:?}, {y:?}, {z:?})")
            } else {
                format!("line {line}: ({x:?}, {y:?})")
            }
        }
        GivenNumber::Radius { line, theta } => format!("line {line}: theta = {theta:?}"),
        GivenNumber::Harmonic { l, m } => format!("Y({l},{m})"),
        GivenNumber::SpaceRadius { line, theta, phi } => {
            format!("line {line}: theta = {theta:?}, phi = {phi:?}")
        }
    }
}

/// The meaning of the common factor, in words.
fn meaning(scale: &Scale) -> Option<String> {
    let factor = &scale.factor;
    Some(match scale.meaning.as_ref()? {
        Meaning::PowerOfTwo(0) if factor.signum() > 0 => "none is needed".into(),
        Meaning::PowerOfTwo(0) => "the sign alone".into(),
        Meaning::PowerOfTwo(k) => format!("a power of two, 2^{k}"),
        Meaning::Fraction => "a simple fraction".into(),
        Meaning::FirstCoefficient(value) => {
            format!("it makes the first coefficient {value}")
        }
        Meaning::LargestIsOne => "it makes the largest coefficient 1".into(),
    })
}

fn write_text(found: &Comparison, mark: Option<u32>, out: &mut dyn Write) -> Result<()> {
    write!(out, "{}: {} compared", what(found), found.rows.len())?;
    if found.scale.is_some() || !found.missing.is_empty() || !found.extra.is_empty() {
        write!(
            out,
            ", {} missing, {} extra",
            found.missing.len(),
            found.extra.len()
        )?;
    }
    writeln!(out)?;
    if let Some(scale) = &found.scale {
        let value = match &scale.meaning {
            Some(Meaning::PowerOfTwo(_) | Meaning::Fraction) if scale.factor.bits() < 64 => {
                scale.factor.to_string()
            }
            _ => format!("≈ {}", shown(&scale.factor)),
        };
        let said = meaning(scale).map_or_else(String::new, |text| format!(" ({text})"));
        writeln!(out, "common factor: {value}{said}")?;
    }
    let digits = [
        found.worst(1).first().map(|row| row.deviation.digits()),
        found.median_digits(),
        found.digits_lost(),
    ];
    if let [Some(worst), Some(median), Some(lost)] = digits {
        writeln!(
            out,
            "correct digits: worst ≈ {}, median ≈ {}; lost at worst ≈ {lost:.1} of {DOUBLE_DIGITS}",
            tenths(worst),
            tenths(median)
        )?;
        write_worst(found, out)?;
        write_histogram(&found.histogram(), out)?;
    }
    for (title, rows) in [("missing", &found.missing), ("extra", &found.extra)] {
        for row in rows.iter().take(WORST) {
            let value = match &row.exact {
                Some(exact) => format!("exact {}", shown(exact)),
                None => format!(
                    "got {:?}, ≈ {} digits smaller than the coefficients of its degree",
                    row.got,
                    tenths(row.deviation.digits())
                ),
            };
            writeln!(out, "{title}: {}: {value}", place(row, found.in_space))?;
        }
        if rows.len() > WORST {
            writeln!(out, "{title}: and {} more", rows.len() - WORST)?;
        }
    }
    for diagnosis in &found.diagnoses {
        let Diagnosis {
            name,
            explanation,
            mark,
            faults,
            faults_left,
            compared,
        } = diagnosis;
        // Failures that no mistake explains are only counted by kind.
        if faults_left == faults {
            writeln!(out, "found: {name}: {explanation}")?;
            continue;
        }
        writeln!(
            out,
            "looks like: {name}: {explanation} (numbers that miss {mark} digits: {faults} beside the reference, {faults_left} beside what this mistake gives, of {compared} that were compared)"
        )?;
    }
    write_verdict(found, mark, out)
}

fn write_worst(found: &Comparison, out: &mut dyn Write) -> Result<()> {
    let rows = found.worst(WORST);
    let lines: Vec<[String; 3]> = rows
        .iter()
        .map(|row| {
            let exact = match (&row.exact, &row.place) {
                (Some(exact), _) => shown(exact),
                (None, GivenNumber::Point { position, .. })
                    if position.iter().all(|x| x.abs() == 0.0) =>
                {
                    "not on the form; every ray begins here".into()
                }
                (None, _) => "no r > 0 on this ray".into(),
            };
            [place(row, found.in_space), format!("{:?}", row.got), exact]
        })
        .collect();
    let width = |k: usize| {
        lines
            .iter()
            .map(|l| l[k].chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths = [0, 1, 2].map(width);
    let title = if rows.len() < found.rows.len() {
        "the worst"
    } else {
        "all"
    };
    writeln!(out, "{title}:")?;
    for (row, line) in rows.iter().zip(&lines) {
        write!(
            out,
            "  {:<a$}  got {:<b$}  exact {:<c$}  digits ≈ {}, ulps ≈ {}",
            line[0],
            line[1],
            line[2],
            tenths(row.deviation.digits()),
            short(row.deviation.ulps),
            a = widths[0],
            b = widths[1],
            c = widths[2],
        )?;
        if let Some(residual) = row.residual {
            write!(
                out,
                ", f ≈ {}, |f|/|grad f| ≈ {}",
                short(residual.value),
                short(residual.first_order)
            )?;
        }
        writeln!(out)?;
    }
    Ok(())
}

fn write_histogram(counts: &[usize], out: &mut dyn Write) -> Result<()> {
    let most = counts.iter().copied().max().unwrap_or(1).max(1);
    let lowest = counts.iter().position(|&n| n > 0).unwrap_or(0);
    let highest = counts.iter().rposition(|&n| n > 0).unwrap_or(0);
    writeln!(out, "whole digits:")?;
    let shown = counts.iter().enumerate().take(highest + 1).skip(lowest);
    let mut skipped = 0;
    for (digits, &count) in shown {
        if count == 0 {
            skipped += 1;
            continue;
        }
        if skipped > 0 {
            writeln!(out, "   .")?;
        }
        skipped = 0;
        let bar = "#".repeat((count * BAR).div_ceil(most));
        writeln!(out, "  {digits:>2} |{bar} {count}")?;
    }
    Ok(())
}

fn write_verdict(found: &Comparison, mark: Option<u32>, out: &mut dyn Write) -> Result<()> {
    let failures = found.failures(mark);
    match mark {
        Some(digits) if failures.is_empty() => {
            return Ok(writeln!(out, "passes: everything has {digits} digits")?);
        }
        Some(digits) => writeln!(out, "fails: {} below {digits} digits:", failures.len())?,
        None if found.passes(None) => return Ok(()),
        None => return Ok(writeln!(out, "fails: see above")?),
    }
    for row in failures {
        writeln!(
            out,
            "  {}: digits ≈ {}",
            place(row, found.in_space),
            tenths(row.deviation.digits())
        )?;
    }
    Ok(())
}

fn write_table(found: &Comparison, out: &mut dyn Write) -> Result<()> {
    let in_space = found.in_space;
    let [third, z] = if in_space { [",k", ",z"] } else { ["", ""] };
    match what(found) {
        "points" => writeln!(
            out,
            "line,x,y{z},r,exact_r,digits,ulps,residual,first_order"
        )?,
        "radii" if in_space => writeln!(out, "line,theta,phi,got,exact,digits,ulps")?,
        "radii" => writeln!(out, "line,theta,got,exact,digits,ulps")?,
        _ if is_harmonic(found) => writeln!(out, "l,m,got,exact,digits,ulps")?,
        _ => writeln!(out, "i,j{third},got,exact,digits,ulps")?,
    }
    let doubles = |v: &[f64]| {
        v.iter()
            .map(|v| format!("{v:?}"))
            .collect::<Vec<_>>()
            .join(",")
    };
    for row in found.all() {
        let axes = if in_space { 3 } else { 2 };
        let place = match &row.place {
            GivenNumber::Term(e) => e[..axes]
                .iter()
                .map(ToString::to_string)
                .collect::<Vec<_>>()
                .join(","),
            GivenNumber::Point { line, position } => {
                format!("{line},{}", doubles(&position[..axes]))
            }
            GivenNumber::Radius { line, theta } => format!("{line},{theta:?}"),
            GivenNumber::Harmonic { l, m } => format!("{l},{m}"),
            GivenNumber::SpaceRadius { line, theta, phi } => format!("{line},{theta:?},{phi:?}"),
        };
        let exact = match (&row.exact, &row.place) {
            (Some(exact), _) => shown(exact),
            (None, GivenNumber::Term(_) | GivenNumber::Harmonic { .. }) => "0".into(),
            (None, _) => "nan".into(),
        };
        let off = &row.deviation;
        write!(
            out,
            "{place},{:?},{exact},{:.2},{}",
            row.got,
            off.digits(),
            short(off.ulps)
        )?;
        match row.residual {
            Some(r) => writeln!(out, ",{:?},{:?}", r.value, r.first_order)?,
            None => writeln!(out)?,
        }
    }
    Ok(())
}

/// A number of digits, rounded down to tenths.
pub(super) fn tenths(digits: f64) -> String {
    format!("{:.1}", (digits * 10.0).floor() / 10.0)
}

/// A number with about three significant digits.
fn short(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".into();
    }
    if (1e-2..1e5).contains(&size) {
        let text = format!("{value:.2}");
        return text.trim_end_matches('0').trim_end_matches('.').into();
    }
    format!("{value:.2e}")
}

/// A number with [`SHOWN_DIGITS`] significant decimals, correctly rounded.
fn shown(value: &Rational) -> String {
    value.to_significant(SHOWN_DIGITS)
}
