//! The comparison as tables of text and as JSON.

use std::io::{self, Write};

use serde::Serialize;

use super::growth::{FITTED, exponent, letter, ratio};
use super::radius::RADIUS_TEXT;
use super::{AbsentProgram, MethodTimes, RunOutcome, TimeComparison};

/// The field `comparison` of the JSON document.
#[derive(Serialize)]
pub(super) struct ComparisonDocument<'a> {
    radius: &'static str,
    limit_seconds: f64,
    cores: usize,
    methods: Vec<MethodDocument<'a>>,
    absent: Vec<AbsentDocument<'a>>,
}

#[derive(Serialize)]
struct MethodDocument<'a> {
    program: &'a str,
    what: &'a str,
    growth_exponent: Option<f64>,
    runs: Vec<RunDocument<'a>>,
}

#[derive(Serialize)]
struct RunDocument<'a> {
    harmonics: usize,
    degree: usize,
    outcome: &'static str,
    seconds: Option<f64>,
    times_theorem_2: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<&'a str>,
}

#[derive(Serialize)]
struct AbsentDocument<'a> {
    program: &'a str,
    command: &'a str,
    reason: Option<&'a str>,
}

impl<'a> ComparisonDocument<'a> {
    pub(super) fn new(comparison: &'a TimeComparison) -> Self {
        let runs = |method: &'a MethodTimes| {
            let document = |run: &'a super::Run| RunDocument {
                harmonics: run.harmonics,
                degree: degree(run.harmonics),
                outcome: name(&run.outcome),
                seconds: method.seconds(run.harmonics),
                times_theorem_2: ratio(comparison, method, run.harmonics),
                reason: match &run.outcome {
                    RunOutcome::Failed(reason) => Some(reason),
                    _ => None,
                },
            };
            method.runs.iter().map(document).collect()
        };
        let method = |method: &'a MethodTimes| MethodDocument {
            program: &method.program,
            what: method.what,
            growth_exponent: exponent(method),
            runs: runs(method),
        };
        let absent = |program: &'a AbsentProgram| AbsentDocument {
            program: program.name,
            command: program.command,
            reason: program.reason.as_deref(),
        };
        Self {
            radius: RADIUS_TEXT,
            limit_seconds: comparison.limit.as_secs_f64(),
            cores: comparison.cores,
            methods: comparison.methods.iter().map(method).collect(),
            absent: comparison.absent.iter().map(absent).collect(),
        }
    }
}

fn name(outcome: &RunOutcome) -> &'static str {
    match outcome {
        RunOutcome::Right(_) => "right",
        RunOutcome::Wrong => "wrong",
        RunOutcome::OverLimit => "over the limit",
        RunOutcome::Failed(_) => "failed",
    }
}

/// The degree 2(N + 1) of Eq. (9).
pub(super) fn degree(harmonics: usize) -> usize {
    2 * (harmonics + 1)
}

/// The width of a cell, which is enough for `2.34e-6` and for `> 10 s`.
const WIDTH: usize = 8;

/// Writes two tables: seconds, and multiples of the time of Theorem 2.
///
/// # Errors
/// Those of `out`.
pub(super) fn write_text(comparison: &TimeComparison, out: &mut dyn Write) -> io::Result<()> {
    writeln!(
        out,
        "The time comparison: from a radius with N harmonics to its equation"
    )?;
    writeln!(out, "  radius: {RADIUS_TEXT}")?;
    for (index, method) in comparison.methods.iter().enumerate() {
        let MethodTimes { program, what, .. } = method;
        writeln!(out, "  {}: {program}, {what}", letter(index))?;
    }
    for program in &comparison.absent {
        writeln!(out, "  {}", absence(program))?;
    }
    writeln!(out, "≈ seconds, {}", measured(comparison))?;
    write_table(comparison, out, |method, harmonics| {
        cell(comparison, method, harmonics)
    })?;
    for line in failures(comparison) {
        writeln!(out, "{line}")?;
    }
    writeln!(out, "≈ times as long as A")?;
    write_table(comparison, out, |method, harmonics| {
        ratio(comparison, method, harmonics).map_or_else(String::new, shown)
    })?;
    writeln!(out, "{}", growth(comparison))
}

fn write_table(
    comparison: &TimeComparison,
    out: &mut dyn Write,
    cell: impl Fn(&MethodTimes, usize) -> String,
) -> io::Result<()> {
    write!(out, "  {:>4} {:>6}", "N", "degree")?;
    for index in 0..comparison.methods.len() {
        write!(out, " {:>WIDTH$}", letter(index))?;
    }
    writeln!(out)?;
    for harmonics in comparison.rungs() {
        let mut line = format!("  {harmonics:>4} {:>6}", degree(harmonics));
        for method in &comparison.methods {
            line.push_str(&format!(" {:>WIDTH$}", cell(method, harmonics)));
        }
        writeln!(out, "{}", line.trim_end())?;
    }
    Ok(())
}

/// The explanation of how the times were measured.
pub(super) fn measured(comparison: &TimeComparison) -> String {
    let answers = if comparison.has_wrong_answer() {
        "not every answer is that of A"
    } else {
        "every answer is that of A, exactly and up to a constant factor"
    };
    format!(
        "for the computation alone, on one thread of a machine with {} cores: A and B the median of several runs, the others \
         the mean of as many as fit into 20 ms, measured by themselves; {answers}; a run that takes longer than {} s is the last",
        comparison.cores,
        comparison.limit.as_secs_f64()
    )
}

/// The text of a cell: the time of a run, or its outcome if it failed; empty if the run was not made.
pub(super) fn cell(comparison: &TimeComparison, method: &MethodTimes, harmonics: usize) -> String {
    let run = method.runs.iter().find(|run| run.harmonics == harmonics);
    match run.map(|run| &run.outcome) {
        None => String::new(),
        Some(RunOutcome::Right(seconds)) => shown(*seconds),
        Some(RunOutcome::Wrong) => "wrong".into(),
        Some(RunOutcome::OverLimit) => format!("> {}", comparison.limit.as_secs_f64()),
        Some(RunOutcome::Failed(_)) => "failed".into(),
    }
}

/// A number with three significant digits.
pub(super) fn shown(value: f64) -> String {
    match value {
        v if v >= 1e6 || (v < 1e-3 && v > 0.0) => format!("{v:.2e}"),
        v if v >= 100.0 => format!("{v:.0}"),
        v if v >= 10.0 => format!("{v:.1}"),
        v if v >= 1.0 => format!("{v:.2}"),
        v if v >= 0.1 => format!("{v:.3}"),
        v if v >= 0.01 => format!("{v:.4}"),
        v => format!("{v:.5}"),
    }
}

/// The sentence about an absent program, such as `Singular is absent: there is no command Singular`.
pub(super) fn absence(program: &AbsentProgram) -> String {
    let AbsentProgram { name, command, .. } = program;
    match &program.reason {
        None => format!("{name} is absent: there is no command `{command}` on the PATH"),
        Some(reason) => format!("{name} takes no part: `{command}` is there, but {reason}"),
    }
}

/// The sentences about failures, one line for each.
pub(super) fn failures(comparison: &TimeComparison) -> Vec<String> {
    let methods = comparison.methods.iter().enumerate();
    let line = |(index, method): (usize, &MethodTimes)| {
        let run = method.failure()?;
        let what = match &run.outcome {
            RunOutcome::Wrong => "its answer is WRONG: another polynomial than that of A",
            RunOutcome::Failed(reason) => reason,
            RunOutcome::Right(_) | RunOutcome::OverLimit => return None,
        };
        Some(format!(
            "{} stopped at N = {}: {what}",
            letter(index),
            run.harmonics
        ))
    };
    methods.filter_map(line).collect()
}

/// The sentence about the growth of the times.
pub(super) fn growth(comparison: &TimeComparison) -> String {
    let methods = comparison.methods.iter().enumerate();
    let fitted = methods
        .filter_map(|(index, method)| Some(format!("{} {:.1}", letter(index), exponent(method)?)));
    let fitted: Vec<String> = fitted.collect();
    if fitted.is_empty() {
        return format!("growth: nothing has the {FITTED} times that a power of N is fitted to");
    }
    format!(
        "growth: ≈ N^p, fitted to the last {FITTED} times of each, with p = {}",
        fitted.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let values = [
            0.0, 2.346e-6, 1.2e-3, 0.0123, 0.456, 7.0, 12.34, 345.6, 98765.4, 3.21e7,
        ];
        let expected = [
            "0.00000", "2.35e-6", "0.00120", "0.0123", "0.456", "7.00", "12.3", "346", "98765",
            "3.21e7",
        ];
        assert_eq!(values.map(shown), expected);
        assert!(expected.iter().all(|text| text.len() <= WIDTH));
    }
}
