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
    /// No number of harmonics meets the tolerance; this is the best number that was assessed, and its largest error.
    Missed(usize, f64),
}

/// The number of angles at which every number of harmonics is tested.
const WATCHED: usize = 2048;
/// After a failed search, this many candidates for the best number are assessed at all angles.
const BEST_CANDIDATES: usize = 16;

/// The smallest N for which the series cut after N harmonics is within `tolerance` of the radius at
/// every check angle.
///
/// The error does not decrease steadily with N, so every N is tried, in ascending order. One angle is enough to reject an N.
/// About two thousand angles are watched: each new harmonic is added to their values, and only an N that none of them rejects
/// is assessed at all check angles. If it fails there, its worst angles are watched from then on. Cost: O(N) for each watched
/// angle, and few full assessments.
pub(super) fn smallest(
    check: &CheckAngles,
    cos: &[f64],
    sin: &[f64],
    tolerance: f64,
    limits: &Limits,
) -> Result<HarmonicsSearch> {
    // The watched values have other rounding errors than the full assessment, which decides.
    let refuse = tolerance + 1e-11 * check.largest_radius();
    let mut watched: Vec<Watch> = check
        .selection(WATCHED)
        .into_iter()
        .map(|angle| Watch::new(angle, &cos[..1], &sin[..1]))
        .collect();
    // A lower bound of the error for each N that was tried.
    let mut bounds = Vec::with_capacity(cos.len());
    for n in 0..cos.len() {
        limits.check()?;
        let is_zero = cos[n].abs().max(sin[n].abs()) <= 0.0;
        if n > 0 {
            if is_zero {
                // The harmonic is 0, so the series is the one that was rejected before.
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
    order.sort_unstable_by(|&i, &j| bounds[i].total_cmp(&bounds[j]).then(i.cmp(&j)));
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

/// A check angle, and the value of the series so far at this angle.
#[derive(Debug)]
struct Watch {
    radii: [f64; 2],
    /// The number e^{iθ}.
    step: Complex<f64>,
    /// The number e^{inθ}.
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
        // The next rotations start without the rounding errors of those before.
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
