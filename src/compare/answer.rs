//! Checks of answers: an answer is read by stellate's own reader and compared exactly, up to a constant factor.

use std::time::Duration;

use super::RunOutcome;
use super::ours::timed;
use super::process::{Ended, Output};
use super::program::field;
use crate::language::{Numbers, parse_form};
use crate::shape::{Form, ImplicitCurve};

/// The outcome of a run of another program.
pub(super) fn outcome(ended: Ended, expected: &ImplicitCurve, limit: Duration) -> RunOutcome {
    match ended {
        Ended::Done(output) => read(&output, expected, limit).unwrap_or_else(RunOutcome::Failed),
        Ended::OverTime => RunOutcome::OverLimit,
        Ended::Absent => RunOutcome::Failed("it has vanished".into()),
        Ended::Failed(reason) => RunOutcome::Failed(reason),
    }
}

fn read(output: &Output, expected: &ImplicitCurve, limit: Duration) -> Result<RunOutcome, String> {
    let (times, polynomial) = field(&output.text, "TIME")
        .ok_or_else(|| format!("it printed no time, and said {}", output.said()))?;
    let seconds = seconds(times).ok_or_else(|| format!("it printed `{times}` as its time"))?;
    let form = parse_form(polynomial, "answer", Numbers::Exact);
    let form = form.map_err(|error| {
        let error = error.to_string();
        let line = error.lines().next().unwrap_or_default();
        format!("its answer cannot be read: {line}")
    })?;
    let Form::Curve(curve) = form else {
        return Err("its answer is no polynomial in x and y".into());
    };
    let agrees = curve.polynomial().primitive() == expected.polynomial().primitive();
    Ok(if agrees {
        timed(seconds, limit)
    } else {
        RunOutcome::Wrong
    })
}

/// The seconds of one run, from the milliseconds of several runs and their number.
fn seconds(text: &str) -> Option<f64> {
    let (milliseconds, runs) = text.split_once(' ')?;
    let (milliseconds, runs): (f64, u32) = (milliseconds.parse().ok()?, runs.trim().parse().ok()?);
    let seconds = milliseconds / 1000.0 / f64::from(runs);
    (seconds.is_finite() && seconds >= 0.0).then_some(seconds)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_milliseconds_and_runs() {
        assert_eq!(seconds("30 4"), Some(0.0075));
        assert_eq!(seconds("20.5 1"), Some(0.0205));
        for wrong in ["", "3", "3 0", "x 1", "1 x", "-3 1", "nan 1", "0 0"] {
            assert_eq!(seconds(wrong), None, "{wrong}");
        }
    }
}
