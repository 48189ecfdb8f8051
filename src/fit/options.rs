//! The options of fits.

use super::CenterChoice;
use crate::error::{Error, Result};

/// The largest number of harmonics of a fit.
pub const MAX_HARMONICS: usize = 100_000;
/// The largest number of samples of a fit.
pub const MAX_SAMPLES: usize = 1 << 22;
/// The largest number of decimals to which coefficients can be rounded (no double has more).
pub const MAX_DECIMALS: u32 = 1100;

/// The size of a fit: its number of harmonics, or the tolerance that determines it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum FitSize {
    /// This number of harmonics.
    Harmonics(usize),
    /// The smallest number of harmonics with which the error is at most this: the largest radial error of a radius, or the upper
    /// bound of the Hausdorff distance of an elliptic series.
    Tolerance(f64),
    /// The smallest number of harmonics with which the upper bound of the Hausdorff distance is at most this.
    Distance(f64),
    /// The smallest number of harmonics of an elliptic series whose powers add up to at least this share (0 to 1) of the power of
    /// all harmonics.
    Power(f64),
}

/// The series that is fitted to an outline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum FitModel {
    /// The Fourier series of the radius about a center (Definition 1).
    #[default]
    Radius,
    /// The elliptic Fourier series of the coordinates by arc length (Kuhl & Giardina), which any outline has.
    Elliptic,
}

/// The way in which the coefficients of a series are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Estimator {
    /// Integrals over the outline, all of whose points count: Definition 1 for a radius, and the sums of Kuhl and Giardina for an
    /// elliptic series.
    Quadrature,
    /// The least sum of weighted squares of the errors at the given points, which need not be exact.
    LeastSquares,
}

/// The options of a fit.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FitOptions {
    /// The series that is fitted.
    pub model: FitModel,
    /// The center, from which the radius is measured.
    pub center: CenterChoice,
    /// The number of samples Ns. By default it is twice the number of vertices, but at most 131072, and at least 8N and 1024
    /// for N harmonics or 4096 for a tolerance, rounded up to a power of two.
    pub samples: Option<usize>,
    /// The way in which the coefficients are found: by default least squares for a cloud, for points with weights and for a robust
    /// fit, and else quadrature.
    pub estimator: Option<Estimator>,
    /// Whether least squares give points that are far from the series less weight (Huber's loss).
    pub robust: bool,
    /// The size of the fit. It has no default; a fit without it is an error.
    pub size: Option<FitSize>,
    /// The number of decimals to which the center (before r is sampled) and the coefficients are rounded.
    pub decimals: Option<u32>,
}

impl FitOptions {
    /// Options for a fit of this size about the centroid, with the default number of samples and no rounding.
    #[must_use]
    pub fn new(size: FitSize) -> Self {
        Self::default().size(Some(size))
    }

    /// Sets the size of the fit.
    #[must_use]
    pub fn size(mut self, size: Option<FitSize>) -> Self {
        self.size = size;
        self
    }

    /// Sets the series that is fitted.
    #[must_use]
    pub fn model(mut self, model: FitModel) -> Self {
        self.model = model;
        self
    }

    /// Sets the way in which the coefficients are found.
    #[must_use]
    pub fn estimator(mut self, estimator: Option<Estimator>) -> Self {
        self.estimator = estimator;
        self
    }

    /// Sets whether points that are far from the series have less weight.
    #[must_use]
    pub fn robust(mut self, robust: bool) -> Self {
        self.robust = robust;
        self
    }

    /// Sets the center, from which the radius is measured.
    #[must_use]
    pub fn center(mut self, center: CenterChoice) -> Self {
        self.center = center;
        self
    }

    /// Sets the number of samples Ns.
    #[must_use]
    pub fn samples(mut self, samples: Option<usize>) -> Self {
        self.samples = samples;
        self
    }

    /// Sets the number of decimals to which the center and the coefficients are rounded.
    #[must_use]
    pub fn decimals(mut self, decimals: Option<u32>) -> Self {
        self.decimals = decimals;
        self
    }

    /// The number of harmonics, if the size is given as one.
    #[must_use]
    pub fn harmonics(&self) -> Option<usize> {
        match self.size {
            Some(FitSize::Harmonics(n)) => Some(n),
            _ => None,
        }
    }

    /// The tolerance, if the size is given as one.
    #[must_use]
    pub fn tolerance(&self) -> Option<f64> {
        match self.size {
            Some(FitSize::Tolerance(e)) => Some(e),
            _ => None,
        }
    }

    /// The size, or an error if it is not given.
    pub(super) fn given_size(&self) -> Result<FitSize> {
        self.size.ok_or_else(|| {
            Error::Usage(
                "a contour needs --harmonics N, --tolerance E or --distance E, such as --harmonics 39".into(),
            )
        })
    }

    /// Checks the limits of fits; the number of harmonics is at most `most`.
    pub(super) fn check(&self, size: FitSize, most: usize) -> Result<()> {
        let positive = |name: &str, e: f64| {
            if e.is_finite() && e > 0.0 {
                return Ok(());
            }
            Err(Error::Usage(format!(
                "the {name} is {e}; it must be a number greater than 0"
            )))
        };
        match size {
            FitSize::Harmonics(_) => {}
            FitSize::Tolerance(e) => positive("tolerance", e)?,
            FitSize::Distance(e) => positive("distance", e)?,
            FitSize::Power(p) if p > 0.0 && p < 1.0 => {}
            FitSize::Power(p) => {
                return Err(Error::Usage(format!(
                    "the share of the power is {p}; it must be a number between 0 and 1, such as 0.99"
                )));
            }
        }
        if let FitSize::Harmonics(n) = size
            && n > most
        {
            return Err(Error::limit(format!(
                "a fit has at most {most} harmonics; {n} were asked for"
            )));
        }
        if let Some(samples) = self.samples
            && samples > MAX_SAMPLES
        {
            return Err(Error::limit(format!(
                "a fit takes at most {MAX_SAMPLES} samples; {samples} were asked for"
            )));
        }
        if let Some(decimals) = self.decimals
            && decimals > MAX_DECIMALS
        {
            return Err(Error::limit(format!(
                "at most {MAX_DECIMALS} decimals are kept; {decimals} were asked for"
            )));
        }
        Ok(())
    }

    /// The way in which the coefficients are found, for points with or without weights.
    pub(super) fn chosen_estimator(&self, is_weighted: bool) -> Result<Estimator> {
        let needs = [("--robust", self.robust), ("--weights", is_weighted)];
        let needing = needs.iter().find(|(_, given)| *given);
        let chosen = match (self.estimator, needing) {
            (Some(Estimator::Quadrature), Some((name, _))) => {
                return Err(Error::Usage(format!(
                    "{name} is for least squares; leave --estimator quadrature out"
                )));
            }
            (Some(chosen), _) => chosen,
            (None, Some(_)) => Estimator::LeastSquares,
            (None, None) => Estimator::Quadrature,
        };
        if chosen == Estimator::LeastSquares && self.samples.is_some() {
            return Err(Error::Usage(
                "--samples is for quadrature; least squares take the given points".into(),
            ));
        }
        Ok(chosen)
    }

    /// Checks that all options belong to the fit of a radius.
    pub(super) fn is_for_a_radius(&self, size: FitSize) -> Result<()> {
        if let FitSize::Power(_) = size {
            return Err(Error::Usage(
                "--power chooses the harmonics of an elliptic series; it needs --model elliptic"
                    .into(),
            ));
        }
        Ok(())
    }

    /// Checks that all options belong to the fit of a cloud.
    pub(super) fn is_for_a_cloud(&self, size: FitSize) -> Result<()> {
        if let FitSize::Distance(_) = size {
            return Err(Error::Usage(
                "--distance is for outlines; of a cloud, --tolerance bounds the largest error of a point".into(),
            ));
        }
        if self.estimator == Some(Estimator::Quadrature) {
            return Err(Error::Usage(
                "--estimator quadrature is for outlines; the points of a cloud have no order"
                    .into(),
            ));
        }
        self.chosen_estimator(true).map(|_| ())
    }

    /// Checks that all options belong to the fit of an elliptic series.
    pub(super) fn is_for_an_elliptic_series(&self) -> Result<()> {
        let given = [
            ("--center", self.center != CenterChoice::Auto),
            ("--samples", self.samples.is_some()),
        ];
        match given.iter().find(|(_, given)| *given) {
            Some((name, _)) => Err(Error::Usage(format!(
                "{name} is for fits of the radius; an elliptic series has none"
            ))),
            None => Ok(()),
        }
    }
}
