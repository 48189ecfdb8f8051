//! The smallest number of harmonics that meets a tolerance.

use rustfft::num_complex::Complex;

use super::as_f64;
use super::residual::{Assessment, CheckAngle, CheckAngles, error};
use crate::error::Result;
use crate::limits::Limits;

/// The outcome of [`smallest`].
#[derive(Debug)]
pub(super) enum HarmonicsSearch {
    /// N harmonics are the fewest that meet the tolerance.
    Found(usize, Assessment),
    /// No N does; the best one looked at, and its largest error.
    Missed(usize, f64),
}

/// Angles watched harmonic by harmonic.
const WATCHED: usize = 2048;
/// After a failed search, candidates for the best N that are assessed in full.
const BEST_CANDIDATES: usize = 16;

/// The smallest N for which the series cut after N harmonics is within `tolerance` of the radius at
/// every check angle.
///
/// The error does not fall steadily with N, so every N is tried, upwards. One angle is enough to
/// refuse an N: about two thousand angles are watched, each harmonic is added to their values as it
/// comes, and only an N that they all accept is assessed at all check angles. If it then fails, its
/// worst angles are watched from there on. Cost: O(N) per watched angle, and few full assessments.
pub(super) fn smallest(
    check: &CheckAngles,
    cos: &[f64],
    sin: &[f64],
    tolerance: f64,
    limits: &Limits,
) -> Result<HarmonicsSearch> {
    // The watched values are rounded differently from the full assessment, which decides.
    let refuse = tolerance + 1e-11 * check.largest_radius();
    let mut watched: Vec<Watch> = check
        .selection(WATCHED)
        .into_iter()
        .map(|angle| Watch::new(angle, &cos[..1], &sin[..1]))
        .collect();
    // A lower bound of the error for each N tried.
    let mut bounds = Vec::with_capacity(cos.len());
    for n in 0..cos.len() {
        limits.check()?;
        let is_zero = cos[n].abs().max(sin[n].abs()) <= 0.0;
        if n > 0 {
            if is_zero {
                // The same series as before: refused already.
                bounds.push(f64::INFINITY);
                for watch in &mut watched {
                    watch.wave *= watch.step;
                }
                continue;
            }
            for watch in &mut watched {
                watch.add(cos[n], sin[n]);
            }
        }
        let seen = watched.iter().map(Watch::error).fold(0.0, f64::max);
        if seen > refuse {
            bounds.push(seen);
            continue;
        }
        let (cos, sin) = (&cos[..=n], &sin[..=n]);
        let assessment = check.assess(cos, sin);
        if assessment.max <= tolerance {
            return Ok(HarmonicsSearch::Found(n, assessment));
        }
        bounds.push(assessment.max);
        watched.extend(
            assessment
                .worst
                .iter()
                .map(|&angle| Watch::new(angle, cos, sin)),
        );
    }
    let mut order: Vec<usize> = (0..bounds.len()).collect();
    order.sort_by(|&i, &j| bounds[i].total_cmp(&bounds[j]));
    let mut best = (0, f64::INFINITY);
    for &n in order.iter().take(BEST_CANDIDATES) {
        limits.check()?;
        if bounds[n] < best.1 {
            let max = check.assess(&cos[..=n], &sin[..=n]).max;
            if max < best.1 {
                best = (n, max);
            }
        }
    }
    Ok(HarmonicsSearch::Missed(best.0, best.1))
}

/// A check angle and the value there of the series so far.
#[derive(Debug)]
struct Watch {
    radii: [f64; 2],
    /// e^{iθ}.
    step: Complex<f64>,
    /// e^{inθ}.
    wave: Complex<f64>,
    value: f64,
}

impl Watch {
    fn new(angle: CheckAngle, cos: &[f64], sin: &[f64]) -> Self {
        let mut watch = Self {
            radii: angle.radii,
            step: Complex::from_polar(1.0, angle.theta),
            wave: Complex::new(1.0, 0.0),
            value: cos[0],
        };
        for n in 1..cos.len() {
            watch.add(cos[n], sin[n]);
        }
        // Start the next rotations without the rounding of the ones so far.
        watch.wave = Complex::from_polar(1.0, as_f64(cos.len() - 1) * angle.theta);
        watch
    }

    fn add(&mut self, a: f64, b: f64) {
        self.wave *= self.step;
        self.value += a * self.wave.re + b * self.wave.im;
    }

    fn error(&self) -> f64 {
        error(self.value, self.radii)
    }
}
