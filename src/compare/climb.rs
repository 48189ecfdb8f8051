//! The time comparison: every method converts radii with more and more harmonics until it is too slow.
//!
//! The *ladder* is a list of radii r(θ), the *rung* N the one with N harmonics. A method climbs until one run fails.

use std::thread::available_parallelism;
use std::time::Duration;

use super::answer::outcome;
use super::program::{PROGRAMS, Presence, Program, Script};
use super::radius::{RUNGS, ladder_radius};
use super::{AbsentProgram, MethodTimes, Run, RunOutcome, TimeComparison, ours};
use crate::error::{Error, Result};
use crate::limits::Limits;
use crate::shape::{FourierRadius, ImplicitCurve};

/// The least time that a program gets to print its version.
const TO_START: Duration = Duration::from_secs(10);

/// The method that computes a run.
enum By {
    Theorem2,
    Resultant,
    Other(&'static Program, &'static Script),
}

/// Measures how long Theorem 2 and elimination take to convert a radius with N harmonics to its equation, for the rungs N of the
/// ladder up to `largest`.
///
/// Elimination is done by stellate's own resultant and by every other program that is installed. A method makes no further run
/// after one that takes longer than `limit`, fails or gives a wrong equation; the time of another program counts from its start to
/// its end. There are at most 14 runs for each method, one after the other, on one thread. `progress` is called with the number of
/// runs that are done or omitted, and with the number of all runs.
///
/// ```
/// use std::time::Duration;
/// use stellate::limits::Limits;
/// use stellate::compare::compare;
/// // With a time limit of 0 every elimination fails; Theorem 2 has no limit.
/// let found = compare(Duration::ZERO, 39, &Limits::none(), &|_, _| ())?;
/// let theorem_2 = &found.methods[0];
/// assert!(theorem_2.seconds(39).is_some());
/// assert_eq!(found.methods[1].seconds(1), None);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of `limits`.
pub fn compare(
    limit: Duration,
    largest: usize,
    limits: &Limits,
    progress: &dyn Fn(usize, usize),
) -> Result<TimeComparison> {
    let this = format!("stellate {}", env!("CARGO_PKG_VERSION"));
    let times = |program: String, what| MethodTimes {
        program,
        what,
        runs: Vec::new(),
    };
    let mut climbers = vec![
        (By::Theorem2, times(this.clone(), "Theorem 2")),
        (
            By::Resultant,
            times(
                this,
                "resultant over tan(θ/2), with its proof by substitution",
            ),
        ),
    ];
    let mut absent = Vec::new();
    for program in &PROGRAMS {
        let reason = match program.presence(limit.max(TO_START), limits)? {
            Presence::Version(version) => {
                climbers.extend(program.methods.iter().map(|script| {
                    let name = format!("{} {version}", program.name);
                    (By::Other(program, script), times(name, script.what))
                }));
                continue;
            }
            Presence::Absent => None,
            Presence::Useless(reason) => Some(reason),
        };
        absent.push(AbsentProgram {
            name: program.name,
            command: program.command,
            reason,
        });
    }
    let rungs = &RUNGS[..RUNGS.partition_point(|n| *n <= largest)];
    for (index, &harmonics) in rungs.iter().enumerate() {
        let done = |error| match error {
            Error::Limit { limit, .. } if index > 0 => Error::Limit {
                limit,
                finished: format!("the times up to N = {} were measured", rungs[index - 1]),
            },
            other => other,
        };
        let radius = ladder_radius(harmonics);
        let (expected, seconds) = ours::theorem_2(&radius)?;
        let count = climbers.len();
        for (place, (by, times)) in climbers.iter_mut().enumerate() {
            limits.check().map_err(done)?;
            if times.failure().is_none() {
                let outcome = match by {
                    By::Theorem2 => RunOutcome::Right(seconds),
                    By::Resultant => {
                        ours::resultant(&radius, &expected, limit, limits).map_err(done)?
                    }
                    By::Other(program, script) => {
                        of_other(program, script, &radius, &expected, limit, limits)
                            .map_err(done)?
                    }
                };
                times.runs.push(Run { harmonics, outcome });
            }
            progress(index * count + place + 1, rungs.len() * count);
        }
    }
    Ok(TimeComparison {
        limit,
        cores: available_parallelism().map_or(1, usize::from),
        methods: climbers.into_iter().map(|(_, times)| times).collect(),
        absent,
    })
}

fn of_other(
    program: &Program,
    script: &Script,
    radius: &FourierRadius,
    expected: &ImplicitCurve,
    limit: Duration,
    limits: &Limits,
) -> Result<RunOutcome> {
    let ended = program.answer(&program.script(script, radius), limit, limits)?;
    Ok(outcome(ended, expected, limit))
}
