//! The deviations of a Fourier series from the radius to which it was fitted.

use std::f64::consts::TAU;

use super::as_f64;
use super::radius::ContourRadius;
use super::series::{at_angles, at_uniform};

/// The angles at which a fit is compared with the outline: uniform angles, and the angles of all visible vertices (from both
/// sides, where r jumps).
#[derive(Debug)]
pub(super) struct CheckAngles {
    uniform: Vec<f64>,
    corner_angles: Vec<f64>,
    corner_radii: Vec<[f64; 2]>,
}

/// The radial error of a series at the check angles.
#[derive(Debug)]
pub(super) struct Assessment {
    /// The largest |series − r| at a check angle.
    pub(super) max: f64,
    /// The root of the mean square of |series − r| over the uniform angles.
    pub(super) rms: f64,
    /// The angle with the largest error in each of a few sectors.
    pub(super) worst: Vec<CheckAngle>,
}

/// A check angle: the radius of the outline there (from both sides), and the error of the series.
#[derive(Clone, Copy, Debug)]
pub(super) struct CheckAngle {
    pub(super) theta: f64,
    pub(super) radii: [f64; 2],
    error: f64,
}

/// The number of sectors of [`Assessment::worst`].
const SECTORS: usize = 16;

impl CheckAngles {
    pub(super) fn new(radius: &ContourRadius, uniform: usize) -> Self {
        let (corner_angles, corner_radii) = radius
            .corners()
            .map(|corner| (corner.theta, [corner.before, corner.after]))
            .unzip();
        Self {
            uniform: radius.samples(uniform),
            corner_angles,
            corner_radii,
        }
    }

    /// The error of the series `cos`, `sin`. Cost: O(M log M + V) for M uniform angles and V
    /// vertices, plus 13 FFTs of about 8N to 16N.
    pub(super) fn assess(&self, cos: &[f64], sin: &[f64]) -> Assessment {
        let mut sectors: [Option<CheckAngle>; SECTORS] = [None; SECTORS];
        let mut note = |part: usize, of: usize, found: CheckAngle| {
            let worst = &mut sectors[part * SECTORS / of.max(1)];
            if worst.is_none_or(|w| w.error < found.error) {
                *worst = Some(found);
            }
        };
        let count = self.uniform.len();
        let mut squares = 0.0;
        for (k, value) in at_uniform(cos, sin, count).into_iter().enumerate() {
            let radii = [self.uniform[k]; 2];
            let theta = TAU * (as_f64(k) / as_f64(count));
            let error = error(value, radii);
            squares += error * error;
            note(
                k,
                count,
                CheckAngle {
                    theta,
                    radii,
                    error,
                },
            );
        }
        let corners = self.corner_angles.len();
        for (k, value) in at_angles(cos, sin, &self.corner_angles)
            .into_iter()
            .enumerate()
        {
            let (theta, radii) = (self.corner_angles[k], self.corner_radii[k]);
            let error = error(value, radii);
            note(
                k,
                corners,
                CheckAngle {
                    theta,
                    radii,
                    error,
                },
            );
        }
        let worst: Vec<CheckAngle> = sectors.into_iter().flatten().collect();
        Assessment {
            max: worst.iter().map(|w| w.error).fold(0.0, f64::max),
            rms: (squares / as_f64(count)).sqrt(),
            worst,
        }
    }

    /// About `count` of the check angles, spread evenly over both kinds.
    pub(super) fn selection(&self, count: usize) -> Vec<CheckAngle> {
        let half = (count / 2).max(1);
        let uniform = self.uniform.len();
        let mut selected: Vec<CheckAngle> = (0..uniform)
            .step_by(uniform.div_ceil(half).max(1))
            .map(|k| CheckAngle {
                theta: TAU * (as_f64(k) / as_f64(uniform)),
                radii: [self.uniform[k]; 2],
                error: 0.0,
            })
            .collect();
        let corners = self.corner_angles.len();
        selected.extend(
            (0..corners)
                .step_by(corners.div_ceil(half).max(1))
                .map(|k| CheckAngle {
                    theta: self.corner_angles[k],
                    radii: self.corner_radii[k],
                    error: 0.0,
                }),
        );
        selected
    }

    /// The largest radius at a uniform angle.
    pub(super) fn largest_radius(&self) -> f64 {
        self.uniform.iter().copied().fold(0.0, f64::max)
    }
}

/// The larger of |value − r| for the radii from both sides.
pub(super) fn error(value: f64, radii: [f64; 2]) -> f64 {
    (value - radii[0]).abs().max((value - radii[1]).abs())
}
