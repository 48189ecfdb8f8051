//! Time measurements of the two methods of this crate.

use std::hint::black_box;
use std::time::{Duration, Instant};

use super::RunOutcome;
use crate::error::{Error, Result};
use crate::implicitize::{SquaredForm, implicitize_plane};
use crate::limits::Limits;
use crate::shape::{FourierRadius, ImplicitCurve};

/// A computation is repeated until its runs together take this long, but at most this number of times.
const REPEATED_FOR: Duration = Duration::from_millis(100);
const MOST_RUNS: usize = 1001;

/// A computation that takes less than this is repeated at least twice.
const IS_SHORT: Duration = Duration::from_secs(1);

/// The result of Theorem 2, and its time as the median of several runs.
///
/// # Errors
/// As [`SquaredForm::new`].
pub(super) fn theorem_2(radius: &FourierRadius) -> Result<(ImplicitCurve, f64)> {
    median(|| clocked(|| Ok(SquaredForm::new(black_box(radius))?.expand())))
}

/// Runs the resultant over tan(θ/2) with its proof, on one thread. The curve in this parameter is computed before the time is
/// measured.
///
/// # Errors
/// Those of `limits`.
pub(super) fn resultant(
    radius: &FourierRadius,
    expected: &ImplicitCurve,
    time: Duration,
    limits: &Limits,
) -> Result<RunOutcome> {
    let curve = radius.to_plane_curve();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = match pool {
        Ok(pool) => pool,
        Err(error) => return Ok(RunOutcome::Failed(error.to_string())),
    };
    // Each run has the whole time.
    let once = || {
        let within = limits.for_at_most(time);
        let found = implicitize_plane(black_box(&curve), &within);
        found.map(|found| found.curve).map_err(|error| Stopped {
            is_over_time: within.check().is_err(),
            error,
        })
    };
    match pool.install(|| median(|| clocked(once))) {
        Ok((found, _)) if found != *expected => Ok(RunOutcome::Wrong),
        Ok((_, seconds)) => Ok(timed(seconds, time)),
        Err(stopped) => {
            limits.check()?;
            Ok(if stopped.is_over_time {
                RunOutcome::OverLimit
            } else {
                RunOutcome::Failed(stopped.error.to_string())
            })
        }
    }
}

/// The reason why there is no result.
struct Stopped {
    is_over_time: bool,
    error: Error,
}

/// The outcome of a run with the right equation that took this time.
pub(super) fn timed(seconds: f64, limit: Duration) -> RunOutcome {
    if seconds > limit.as_secs_f64() {
        RunOutcome::OverLimit
    } else {
        RunOutcome::Right(seconds)
    }
}

/// The result of a computation, and the time that it took.
fn clocked<T, E>(
    compute: impl FnOnce() -> std::result::Result<T, E>,
) -> std::result::Result<(T, Duration), E> {
    let start = Instant::now();
    let result = black_box(compute()?);
    Ok((result, start.elapsed()))
}

/// The last result and the median of the seconds of a computation that measures its time.
fn median<T, E>(
    mut compute: impl FnMut() -> std::result::Result<(T, Duration), E>,
) -> std::result::Result<(T, f64), E> {
    let mut times = Vec::new();
    let mut spent = Duration::ZERO;
    loop {
        let (result, time) = compute()?;
        spent += time;
        times.push(time);
        let few = times.len() < 3 && time < IS_SHORT;
        if !few && (spent >= REPEATED_FOR || times.len() >= MOST_RUNS) {
            times.sort_unstable();
            return Ok((result, times[times.len() / 2].as_secs_f64()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_computation_is_repeated_and_a_long_one_is_not() {
        let counted = |milliseconds: &[u64]| {
            let mut runs = 0;
            let found = median(|| {
                runs += 1;
                let time = milliseconds[runs % milliseconds.len()];
                Ok::<_, Error>((runs, Duration::from_millis(time)))
            });
            found.unwrap()
        };
        assert_eq!(counted(&[5]), (20, 0.005));
        assert_eq!(counted(&[0, 90, 20]), (3, 0.02));
        assert_eq!(counted(&[600]), (3, 0.6));
        assert_eq!(counted(&[1100]), (1, 1.1));
        assert_eq!(counted(&[0]), (MOST_RUNS, 0.0));
    }

    #[test]
    fn the_time_limit_of_one_run_is_no_error() {
        let radius = super::super::ladder_radius(8);
        let (expected, _) = theorem_2(&radius).unwrap();
        let limits = Limits::none();
        let found = |time| resultant(&radius, &expected, time, &limits).unwrap();
        assert_eq!(found(Duration::ZERO), RunOutcome::OverLimit);
        assert!(matches!(
            found(Duration::from_secs(600)),
            RunOutcome::Right(_)
        ));
        let other = theorem_2(&super::super::ladder_radius(7)).unwrap().0;
        let wrong = resultant(&radius, &other, Duration::from_secs(600), &limits);
        assert_eq!(wrong.unwrap(), RunOutcome::Wrong);
        limits
            .cancellation()
            .store(true, std::sync::atomic::Ordering::SeqCst);
        let stopped = resultant(&radius, &expected, Duration::ZERO, &limits);
        assert!(matches!(stopped, Err(Error::Interrupted)));
    }
}
