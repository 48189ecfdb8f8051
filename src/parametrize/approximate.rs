//! The Fourier fit of a branch that has no closed form (Lemma 6), with a certified error.

use malachite::Integer;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

use super::angle::ExactAngle;
use super::parametrization::{BranchRadius, Parametrization};
use super::series_error::Evaluator;
use super::traced::RootBranch;
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::fit::{FitSize, MAX_HARMONICS, MAX_SAMPLES, fourier_coefficients};
use crate::limits::Limits;
use crate::options::options;
use crate::parallel;
use crate::sample::Direction;
use crate::shape::FourierRadius;

/// The default number of harmonics of a fit.
pub const DEFAULT_HARMONICS: usize = 20;

/// The number of directions for each sample, itself among them, in which the error is measured.
const CHECKS_PER_SAMPLE: usize = 4;
/// For a tolerance and the default numbers of samples, the largest number of harmonics that is tried.
const MOST_TRIED: usize = 1024;

options! {
    /// The options of the fit of a branch.
    BranchFitOptions {
        /// The index of the branch; by default the outermost positive branch that covers the circle or, if there is none, the
        /// outermost positive radius, provided that there is one in every direction.
        branch: Option<usize> = None,
        /// The number of harmonics N, or the tolerance that determines it: the fewest harmonics with which both errors of
        /// [`BranchFit`] are within the tolerance.
        size: FitSize = FitSize::Harmonics(DEFAULT_HARMONICS),
        /// The number of samples Ns; by default max(8N, 256), rounded up to a power of two.
        samples: Option<usize> = None,
        /// The number of decimals to which the coefficients are rounded; by default as many as make rounding add about 1 % to
        /// the error.
        decimals: Option<u32> = None,
    }
}

/// A Fourier radius that approximates a branch.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct BranchFit {
    /// The index of the branch; `None` for the outermost positive radius in every direction.
    pub branch: Option<usize>,
    /// The fit, with exact coefficients.
    pub radius: FourierRadius,
    /// The number of samples Ns.
    pub samples: usize,
    /// A certified bound of |fit − r| at all samples.
    pub error_at_samples: Rational,
    /// The largest |fit − r| in directions between the samples; each value is certified, and the largest is an estimate of the
    /// error everywhere.
    pub error_between: Rational,
    /// The number of directions between the samples in which the error was measured.
    pub checks: usize,
    /// The angles at which the outermost radius jumps from one branch to another. A Fourier series cannot follow it there.
    pub jumps: Vec<ExactAngle>,
}

/// The radius that is fitted.
enum Target<'a> {
    Branch(&'a RootBranch),
    Outermost(&'a RootBranch),
}

impl Target<'_> {
    fn radius(&self, direction: &Direction) -> Option<f64> {
        match self {
            Self::Branch(branch) => branch.radius(direction),
            Self::Outermost(any) => any.outermost_radius(direction),
        }
    }
}

/// Fits a Fourier series to one branch of a curve, by Definition 1 from certified radii.
///
/// The error at a sample is |fit − r| in the exact direction, for the exact coefficients and the nearest double of r, plus half
/// an ulp of r; so it is a bound. The result is `None` if no branch was requested, and no positive radius without a closed form
/// covers the circle. For a tolerance, the numbers of harmonics are tried from 0 upwards, each with its own default number of
/// samples; at most 1024 harmonics are tried unless the number of samples is given.
///
/// Cost: the roots of 4 Ns polynomials.
///
/// # Errors
/// [`Error::Usage`] if the branch does not exist, has a closed form, or does not cover the circle, if Ns < 2N + 1, or if the
/// tolerance is not positive; [`Error::Limit`] beyond the limits of fits, and if no number of harmonics that is tried meets the
/// tolerance; those of `limits`.
pub fn fit_branch(
    curve: &Parametrization,
    options: &BranchFitOptions,
    limits: &Limits,
) -> Result<Option<BranchFit>> {
    options.check()?;
    let Some((branch, target, jumps)) = choose(curve, options.branch)? else {
        return Ok(None);
    };
    let (sampled, series) = match options.size {
        FitSize::Harmonics(n) => {
            let samples = options.samples.unwrap_or_else(|| default_samples(n));
            let sampled = Sampled::new(&target, samples, n, limits)?;
            let series = sampled.series(n, options.decimals)?;
            (sampled, series)
        }
        FitSize::Tolerance(e) => fewest(&target, e, options, limits)?,
        FitSize::Distance(_) | FitSize::Power(_) => {
            return Err(Error::internal(
                "the size of the fit of a branch",
                "it is that of a contour, and was refused",
            ));
        }
    };
    Ok(Some(BranchFit {
        branch,
        radius: series.radius.with_center(curve.center.clone()),
        samples: sampled.samples,
        error_at_samples: series.error_at_samples,
        error_between: series.error_between,
        checks: sampled.samples * (CHECKS_PER_SAMPLE - 1),
        jumps,
    }))
}

impl BranchFitOptions {
    fn check(&self) -> Result<()> {
        let samples = |n: usize| self.samples.unwrap_or_else(|| default_samples(n));
        let (harmonics, samples) = match self.size {
            FitSize::Harmonics(n) => (n, samples(n)),
            FitSize::Tolerance(e) if e.is_finite() && e > 0.0 => (0, samples(0)),
            FitSize::Distance(_) | FitSize::Power(_) => {
                return Err(Error::Usage(
                    "--distance and --power are for contours; the fit of a branch has --harmonics or --tolerance".into(),
                ));
            }
            FitSize::Tolerance(e) => {
                return Err(Error::Usage(format!(
                    "the tolerance is {e}; it must be a number greater than 0"
                )));
            }
        };
        if harmonics > MAX_HARMONICS || samples > MAX_SAMPLES {
            return Err(Error::limit(format!(
                "a fit has at most {MAX_HARMONICS} harmonics and {MAX_SAMPLES} samples; {harmonics} and {samples} were asked for"
            )));
        }
        Ok(())
    }
}

/// The default number of samples of a fit with this many harmonics.
fn default_samples(harmonics: usize) -> usize {
    harmonics
        .saturating_mul(8)
        .clamp(256, MAX_SAMPLES)
        .next_power_of_two()
}

/// The fit with the fewest harmonics whose errors are within the tolerance.
fn fewest(
    target: &Target<'_>,
    tolerance: f64,
    options: &BranchFitOptions,
    limits: &Limits,
) -> Result<(Sampled, Series)> {
    let mut first = 0;
    let mut best = (f64::INFINITY, 0);
    loop {
        let samples = options.samples.unwrap_or_else(|| default_samples(first));
        // The numbers of harmonics that have this number of samples.
        let last = match options.samples {
            Some(samples) => (samples.saturating_sub(1) / 2).min(MAX_HARMONICS),
            None => samples / 8,
        };
        let sampled = Sampled::new(target, samples, last, limits)?;
        let found = sampled.fewest(first, tolerance, options.decimals, &mut best, limits)?;
        if let Some(series) = found {
            return Ok((sampled, series));
        }
        if options.samples.is_some() || last >= MOST_TRIED {
            let (error, harmonics) = best;
            return Err(Error::Limit {
                limit: format!(
                    "no number of harmonics up to {last} has an error of at most {tolerance}"
                ),
                finished: format!("the best found is ≈ {error:.3e} with {harmonics} harmonics"),
            });
        }
        first = last + 1;
    }
}

/// The radii of a branch in uniform directions, and the coefficients that Definition 1 gives for them.
struct Sampled {
    /// The number of samples Ns.
    samples: usize,
    /// The radii at the samples and, between any two, at the angles at which the error is measured.
    radii: Vec<(Direction, f64)>,
    cos: Vec<f64>,
    sin: Vec<f64>,
}

/// A Fourier series with rounded coefficients, and its errors as in [`BranchFit`].
struct Series {
    radius: FourierRadius,
    error_at_samples: Rational,
    error_between: Rational,
}

impl Sampled {
    fn new(target: &Target<'_>, samples: usize, harmonics: usize, limits: &Limits) -> Result<Self> {
        let count = samples * CHECKS_PER_SAMPLE;
        let radii = parallel::try_map_numbers(count, limits, |k| radius_near(target, k, count))?;
        let at_samples: Vec<f64> = radii
            .iter()
            .step_by(CHECKS_PER_SAMPLE)
            .map(|(_, r)| *r)
            .collect();
        let (cos, sin) = fourier_coefficients(&at_samples, harmonics)?;
        Ok(Self {
            samples,
            radii,
            cos,
            sin,
        })
    }

    /// The series with this many harmonics, its coefficients rounded, and its errors.
    fn series(&self, harmonics: usize, decimals: Option<u32>) -> Result<Series> {
        let (cos, sin) = (&self.cos[..=harmonics], &self.sin[..=harmonics]);
        let decimals = decimals.unwrap_or_else(|| enough_decimals(&self.radii, cos, sin));
        let rounded = |list: &[f64]| -> Result<Vec<Rational>> {
            let exact = list.iter().map(|&c| {
                Rational::try_from(c).map_err(|_| Error::Hypothesis {
                    statement: "Lemma 6",
                    witness: "the radius is beyond the doubles in some directions".into(),
                })
            });
            exact.map(|c| Ok(c?.round_decimals(decimals))).collect()
        };
        let radius = FourierRadius::new(rounded(cos)?, rounded(sin)?);
        let evaluator = Evaluator::new(&radius);
        let errors = parallel::map(&self.radii, |(direction, r)| evaluator.error(direction, *r));
        let largest = |wanted: bool| {
            let chosen = errors
                .iter()
                .enumerate()
                .filter(|(k, _)| k.is_multiple_of(CHECKS_PER_SAMPLE) == wanted);
            let largest = chosen.map(|(_, e)| e).max();
            let largest = largest.invariant("there are samples and checks between them");
            largest.clone()
        };
        Ok(Series {
            error_at_samples: largest(true),
            error_between: largest(false),
            radius,
        })
    }

    /// The series with the fewest harmonics, at least `first`, whose errors are within the tolerance.
    ///
    /// The error does not decrease steadily, so each number is tried. The error in doubles rejects most of them; the exact one
    /// decides. `best` holds the smallest error in doubles so far, and its number of harmonics.
    fn fewest(
        &self,
        first: usize,
        tolerance: f64,
        decimals: Option<u32>,
        best: &mut (f64, usize),
        limits: &Limits,
    ) -> Result<Option<Series>> {
        let bound = Rational::try_from(tolerance).invariant("the tolerance is finite");
        let largest_radius = self
            .radii
            .iter()
            .fold(0.0, |most: f64, (_, r)| most.max(r.abs()));
        let mut values = vec![0.0; self.radii.len()];
        for n in 0..self.cos.len() {
            limits.check()?;
            let (a, b, order) = (self.cos[n], self.sin[n], nearest(n));
            values = parallel::map_numbers(values.len(), |k| {
                let (s, c) = (order * self.radii[k].0.theta()).sin_cos();
                values[k] + (a * c + b * s)
            });
            if n < first {
                continue;
            }
            let errors = values
                .iter()
                .zip(&self.radii)
                .map(|(v, (_, r))| (v - r).abs());
            let error = errors.fold(0.0, f64::max);
            if error < best.0 {
                *best = (error, n);
            }
            // The rounding of the coefficients changes the error by a hundredth, or by at most half a unit of the last
            // requested decimal for each of them; that of these doubles is far smaller than 1e-11 of the radius.
            let terms = nearest(2 * n + 1);
            let rounding = decimals.map_or(tolerance / 50.0, |d| {
                terms * 0.5 * 0.1_f64.powf(f64::from(d))
            });
            if error > tolerance + rounding + 1e-11 * largest_radius {
                continue;
            }
            let series = self.series(n, decimals)?;
            if series.error_at_samples <= bound && series.error_between <= bound {
                return Ok(Some(series));
            }
        }
        Ok(None)
    }
}

fn nearest(count: usize) -> f64 {
    f64::rounding_from(count, RoundingMode::Nearest).0
}

type Chosen<'a> = (Option<usize>, Target<'a>, Vec<ExactAngle>);

fn choose(curve: &Parametrization, wanted: Option<usize>) -> Result<Option<Chosen<'_>>> {
    let roots = || {
        curve
            .branches
            .iter()
            .enumerate()
            .filter_map(|(index, branch)| match &branch.radius {
                BranchRadius::Root(root) => Some((index, root)),
                _ => None,
            })
    };
    if let Some(index) = wanted {
        let refuse = |why: String| Err(Error::Usage(format!("--branch {index}: {why}")));
        let Some(branch) = curve.branches.get(index) else {
            return refuse(format!(
                "there are {} branches, from 0 on",
                curve.branches.len()
            ));
        };
        return match &branch.radius {
            BranchRadius::Root(root) if root.covers_circle() => Ok(Some((Some(index), Target::Branch(root), Vec::new()))),
            BranchRadius::Root(_) => refuse("this branch is not positive in every direction, so a Fourier series cannot be fitted to it".into()),
            _ => refuse("this branch has a closed form".into()),
        };
    }
    let away_from_axes = Direction::from_radians(1.0);
    let covering = roots().filter(|(_, root)| root.covers_circle());
    let size = |root: &RootBranch| root.radius(&away_from_axes).unwrap_or(0.0);
    let outermost = covering.max_by(|a, b| size(a.1).total_cmp(&size(b.1)));
    if let Some((index, root)) = outermost {
        return Ok(Some((Some(index), Target::Branch(root), Vec::new())));
    }
    Ok(
        roots()
            .find_map(|(_, root)| Some((None, Target::Outermost(root), root.outermost_jumps()?))),
    )
}

/// The k-th of `count` uniform directions, or a direction near it if that one is critical, and the radius there.
fn radius_near(target: &Target<'_>, k: usize, count: usize) -> Result<(Direction, f64)> {
    let turn = Rational::whole(Integer::from(k)) / Rational::whole(Integer::from(count));
    let exact = Direction::from_degrees(&(turn * Rational::from(360)));
    if let Some(r) = target.radius(&exact) {
        return Ok((exact, r));
    }
    // Critical directions are isolated, so some direction near it is not critical.
    for step in 46..53 {
        let beside = Direction::from_radians(exact.theta() + f64::from(-step).exp2());
        if let Some(r) = target.radius(&beside) {
            return Ok((beside, r));
        }
    }
    Err(Error::Hypothesis {
        statement: "the Fourier fit of a branch (Lemma 6)",
        witness: format!(
            "the branch has no radius beside the angle {}",
            exact.theta()
        ),
    })
}

/// A number of decimals with which rounding adds about a hundredth of the error that the fit has anyway.
fn enough_decimals(radii: &[(Direction, f64)], cos: &[f64], sin: &[f64]) -> u32 {
    let error = |(direction, r): &(Direction, f64)| {
        let mut angle = 0.0;
        let terms = cos.iter().zip(sin).map(|(a, b)| {
            let (s, c) = f64::sin_cos(angle);
            angle += direction.theta();
            a * c + b * s
        });
        (terms.sum::<f64>() - r).abs()
    };
    let largest = radii
        .iter()
        .map(error)
        .fold(f64::EPSILON * cos[0].abs(), f64::max);
    let terms = nearest(2 * cos.len());
    let decimals = (terms * 50.0 / largest).log10().ceil();
    u32::rounding_from(decimals.clamp(0.0, 320.0), RoundingMode::Nearest).0
}
