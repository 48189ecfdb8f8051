//! All methods up the ladder, rung by rung.

use std::thread::available_parallelism;
use std::time::Duration;

use super::answer::outcome;
use super::program::{PROGRAMS, Presence, Program, Script};
use super::radius::{RUNGS, ladder_radius};
use super::{AbsentProgram, MethodTimes, Run, RunOutcome, TimeComparison, ours};
use crate::error::{Error, Result};
use crate::limits::Limits;
use crate::shape::{FourierRadius, ImplicitCurve};

/// A program gets so long at least to say its version.
const TO_START: Duration = Duration::from_secs(10);

/// Who computes.
enum By {
    Theorem2,
    Resultant,
    Other(&'static Program, &'static Script),
}

/// Theorem 2 and elimination for one radius with N = 1, 2, … harmonics; a method stops climbing when a run takes longer than
/// `limit` (for other programs from their start to their end), fails or is wrong, or at N = `largest`. At most 14 runs a method,
/// one after the other, on one thread. `progress` is told how many of how many runs are done or will not be made.
///
/// ```
/// use std::time::Duration;
/// use stellate::limits::Limits;
/// use stellate::compare::compare;
/// // Elimination may take no time at all.
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
