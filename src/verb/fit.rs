//! Fits of contours by Fourier series, for the verb `fit` and for every verb that takes a contour.

use super::claims::{FittedRadius, claim_fit};
use super::{Content, Given, Remark, Work};
use crate::error::{Error, Result};
use crate::fit::{
    CenterChoice, CenterOrigin, Distances, EllipticFit, Fit, FitModel, FitOptions, FitSize,
    LeastSquares, NormalForm, Visibility, distances, fit_cloud, fit_elliptic, fit_within,
    is_positive_by_values, normal_form,
};
use crate::parametrize::is_positive;
use crate::shape::{Contour, EllipticSeries, Form, FourierRadius, ImplicitSurface, PointCloud};

/// A series that was fitted to an outline, and how far it is from the outline.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct OutlineFit {
    /// The series.
    pub series: OutlineSeries,
    /// What is reported of the fit.
    pub report: FitReport,
}

/// One of several outlines and its fit.
#[derive(Clone, Debug)]
pub struct FittedOutline {
    /// The name of the file.
    pub file: String,
    /// Which outline of the file it is, from 1 by its size.
    pub blob: usize,
    /// The fit.
    pub fit: OutlineFit,
}

/// A series that was fitted to an outline.
#[expect(
    clippy::large_enum_variant,
    reason = "there is one of these for each outline"
)]
#[derive(Clone, Debug)]
pub enum OutlineSeries {
    /// The Fourier series of the radius.
    Radius(Fit),
    /// The elliptic Fourier series of the coordinates.
    Elliptic(EllipticFit),
}

/// What is reported of a fit.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FitReport {
    /// The deviations of a radius along rays.
    pub radial: Option<RadialReport>,
    /// [`EllipticFit::power`] of an elliptic series.
    pub harmonic_power: Option<f64>,
    /// What a fit by least squares says of the coefficients.
    pub least_squares: Option<LeastSquares>,
    /// How far the curve is from the outline, certified. The verb [`fit`] always measures it; `None` from the verbs that fit on the way to
    /// something else, and where it would take more than the stated cost.
    pub distances: Option<Distances>,
    /// What was taken out of an elliptic series in normal form.
    pub normal_form: Option<TakenOut>,
}

/// What was taken out of an elliptic series in normal form, as in [`NormalForm`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TakenOut {
    /// As [`NormalForm::size`].
    pub size: f64,
    /// As [`NormalForm::rotation`].
    pub rotation: f64,
    /// As [`NormalForm::start`].
    pub start: f64,
    /// As [`NormalForm::reversed`].
    pub reversed: bool,
}

impl OutlineFit {
    /// The fit with its elliptic series in normal form. What is reported still speaks of the fit to the outline.
    ///
    /// # Errors
    /// [`Error::Usage`] for a radius; those of [`normal_form`].
    pub fn into_normal_form(self, decimals: Option<u32>) -> Result<Self> {
        let OutlineSeries::Elliptic(fit) = self.series else {
            return Err(Error::Usage(
                "--normal-form is for elliptic series; it needs --model elliptic".into(),
            ));
        };
        let NormalForm {
            series,
            size,
            rotation,
            start,
            reversed,
            ..
        } = normal_form(&fit.series, decimals)?;
        let taken = TakenOut {
            size,
            rotation,
            start,
            reversed,
        };
        Ok(Self {
            series: OutlineSeries::Elliptic(EllipticFit { series, ..fit }),
            report: FitReport {
                normal_form: Some(taken),
                // The standard errors are those of other coefficients.
                least_squares: None,
                ..self.report
            },
        })
    }
}

/// What is reported of the fit of a radius.
#[derive(Clone, Debug, PartialEq)]
pub struct RadialReport {
    /// As [`Fit::max_radial_error`].
    pub max_error: f64,
    /// As [`Fit::rms_radial_error`].
    pub rms_error: f64,
    /// As [`Fit::samples`].
    pub samples: usize,
    /// As [`Fit::outline`].
    pub outline: Option<Visibility>,
    /// Whether r > 0 for every angle of the fit, certified. [`Visibility`] says the same of the outline. `None` from the verbs that fit on
    /// the way to something else, and if it is not decided.
    pub star_shaped: Option<bool>,
}

impl OutlineSeries {
    /// The series as a form.
    #[must_use]
    pub fn form(&self) -> Form {
        match self {
            Self::Radius(fit) => Form::Fourier(fit.radius.clone()),
            Self::Elliptic(fit) => Form::PlaneCurve(fit.series.to_plane_curve()),
        }
    }

    /// The degree of the implicit equation of a general series with so many harmonics.
    fn degree(model: FitModel, harmonics: usize) -> usize {
        match model {
            FitModel::Radius => harmonics.saturating_mul(2).saturating_add(2),
            FitModel::Elliptic => harmonics.saturating_mul(2),
        }
    }

    fn curve(&self) -> EllipticSeries {
        match self {
            Self::Radius(fit) => EllipticSeries::from_radius(&fit.radius),
            Self::Elliptic(fit) => fit.series.clone(),
        }
    }

    fn report(&self) -> FitReport {
        match self {
            Self::Radius(fit) => FitReport {
                radial: Some(RadialReport {
                    max_error: fit.max_radial_error,
                    rms_error: fit.rms_radial_error,
                    samples: fit.samples,
                    outline: fit.outline,
                    star_shaped: None,
                }),
                least_squares: fit.least_squares.clone(),
                ..FitReport::default()
            },
            Self::Elliptic(fit) => FitReport {
                harmonic_power: Some(fit.power),
                least_squares: fit.least_squares.clone(),
                ..FitReport::default()
            },
        }
    }
}

/// Fits a series to a contour, a Fourier radius (Definition 1) or an elliptic series, and measures how far it is from the contour. A
/// cloud is fitted by a radius; it has no outline from which a distance could be measured.
///
/// ```
/// use stellate::fit::{FitOptions, FitSize};
/// use stellate::shape::Contour;
/// use stellate::verb::{self, OutlineSeries, Work};
/// let square = Contour::new(vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]], "square")?;
/// let options = FitOptions::new(FitSize::Harmonics(8));
/// let found = verb::fit(square.into(), &options, &Work::default())?;
/// let OutlineSeries::Radius(fit) = found.series else { unreachable!() };
/// assert_eq!(fit.radius.harmonics(), 8);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Usage`] for an exact form; those of [`fit_within`], [`fit_elliptic`] and [`fit_cloud`]; [`Error::Limit`] if the
/// polynomial of the series has a degree above that which the work allows.
pub fn fit(given: Given, options: &FitOptions, work: &Work) -> Result<OutlineFit> {
    let name = given.short_name();
    let (series, mut report);
    // The points about which claims are made, and whether the errors in the report are theirs, each counting alike.
    let mut claimed = (Vec::new(), false);
    match given.into_content() {
        Content::Contour(contour) => {
            if work.proves() {
                claimed.0 = contour.points().to_vec();
            }
            series = fit_series(&contour, options, work)?;
            report = series.report();
            report.distances = work.stage("distance", || {
                distances(&contour, &series.curve(), work.bounds())
            })?;
            if report.distances.is_none() {
                work.remark(Remark::DistanceNotMeasured);
            }
        }
        Content::Cloud(cloud) => {
            if work.proves() {
                claimed = (cloud.points().to_vec(), cloud.weights().is_empty());
            }
            series = fit_cloud_series(&cloud, options, work)?;
            report = series.report();
        }
        Content::Exact(_) => {
            return Err(Error::Usage(format!(
                "{name}: fit needs a contour: a .csv with rows x,y, .npy, .geojson or .svg, or a .png, .jpg or .bmp silhouette"
            )));
        }
    }
    if let (OutlineSeries::Radius(fit), Some(radial)) = (&series, &mut report.radial) {
        radial.star_shaped = is_positive_radius(&fit.radius, work)?;
    }
    work.claim(|proof| {
        let fitted = match &series {
            OutlineSeries::Radius(fit) => Some(FittedRadius {
                radius: &fit.radius,
                is_positive: report.radial.as_ref().and_then(|radial| radial.star_shaped),
                points: &claimed.0,
                errors: [fit.max_radial_error, fit.rms_radial_error],
                is_at_points: claimed.1,
            }),
            OutlineSeries::Elliptic(_) => None,
        };
        claim_fit(proof, fitted.as_ref(), report.distances.as_ref());
        Ok(())
    })?;
    Ok(OutlineFit { series, report })
}

/// Whether r > 0 for every angle: by values if they decide it, else exactly if the radius has few harmonics.
pub(super) fn is_positive_radius(radius: &FourierRadius, work: &Work) -> Result<Option<bool>> {
    /// Roots of polynomials of higher degrees than twice this one take too long.
    const MOST_EXACT: usize = 256;
    let by_values = is_positive_by_values(radius, work.bounds())?;
    let is_short = radius.harmonics() <= MOST_EXACT;
    Ok(by_values.or_else(|| is_short.then(|| is_positive(radius))))
}

/// Fits a series to a cloud, with remarks.
pub(super) fn fit_cloud_series(
    cloud: &PointCloud,
    options: &FitOptions,
    work: &Work,
) -> Result<OutlineSeries> {
    if options.model == FitModel::Elliptic {
        return Err(Error::Usage(
            "an elliptic series goes along the outline, and the points of a cloud have no order; --model radius fits them".into(),
        ));
    }
    if let Some(n) = options.harmonics() {
        work.check_degree(OutlineSeries::degree(options.model, n))?;
    }
    let fit = work.stage("fit", || fit_cloud(cloud, options, work.bounds()))?;
    Ok(OutlineSeries::Radius(fit))
}

/// Fits a series to a contour, with remarks, and without measuring distances.
pub(super) fn fit_series(
    contour: &Contour,
    options: &FitOptions,
    work: &Work,
) -> Result<OutlineSeries> {
    if let Some(n) = options.harmonics() {
        work.check_degree(OutlineSeries::degree(options.model, n))?;
    }
    if options.model == FitModel::Elliptic {
        let fit = work.stage("fit", || fit_elliptic(contour, options, work.bounds()))?;
        return Ok(OutlineSeries::Elliptic(fit));
    }
    let fit = work.stage("fit", || fit_within(contour, options, work.bounds()))?;
    let point = fit.center.point;
    let outline = || contour.place().to_owned();
    match fit.center.origin {
        CenterOrigin::Centroid | CenterOrigin::Given => {}
        origin => work.remark(Remark::Center {
            outline: outline(),
            point,
            origin,
        }),
    }
    if let Some(seen) = fit.outline.filter(|seen| !seen.star_shaped) {
        let share = seen.hidden_share;
        work.remark(Remark::Hidden {
            outline: outline(),
            point,
            share,
        });
    }
    Ok(OutlineSeries::Radius(fit))
}

/// The radius of a contour with another number of harmonics. It makes no remarks; it is `None` if the contour has no such fit.
pub(super) fn fit_quietly(
    contour: &Contour,
    options: &FitOptions,
    harmonics: usize,
    work: &Work,
) -> Option<FourierRadius> {
    if options.model != FitModel::Radius {
        return None;
    }
    let options = options.clone().size(Some(FitSize::Harmonics(harmonics)));
    let fit = fit_within(contour, &options, work.bounds()).ok()?;
    Some(fit.radius)
}

/// An exact form and, if it was fitted to a contour, what is reported of that fit, without distances.
pub(super) struct Fitted {
    pub(super) form: Form,
    pub(super) report: Option<FitReport>,
}

/// The exact form of an input; a contour is fitted as the options say.
pub(super) fn exact_form(given: Given, options: &FitOptions, work: &Work) -> Result<Fitted> {
    match given.into_content() {
        Content::Exact(form) => {
            refuse_fit_options(options)?;
            let form = match form {
                Form::Intersection(surfaces) => {
                    let all =
                        ImplicitSurface::all_in_original_coordinates(&surfaces, work.bounds())?;
                    Form::Intersection(all)
                }
                other => other,
            };
            Ok(Fitted { form, report: None })
        }
        Content::Contour(contour) => {
            let series = fit_series(&contour, options, work)?;
            Ok(Fitted {
                report: Some(series.report()),
                form: series.form(),
            })
        }
        Content::Cloud(cloud) => {
            let series = fit_cloud_series(&cloud, options, work)?;
            Ok(Fitted {
                report: Some(series.report()),
                form: series.form(),
            })
        }
    }
}

/// Refuses the options of fits for a form that is not a contour.
pub(super) fn refuse_fit_options(options: &FitOptions) -> Result<()> {
    refuse(&[
        ("--harmonics", options.harmonics().is_some()),
        ("--samples", options.samples.is_some()),
        ("--decimals", options.decimals.is_some()),
        ("--tolerance", options.tolerance().is_some()),
    ])?;
    refuse_contour_options(options)
}

/// Refuses the options that only a contour has.
pub(super) fn refuse_contour_options(options: &FitOptions) -> Result<()> {
    refuse(&[
        ("--center", options.center != CenterChoice::Auto),
        ("--model", options.model != FitModel::Radius),
        (
            "--distance",
            matches!(options.size, Some(FitSize::Distance(_))),
        ),
        ("--power", matches!(options.size, Some(FitSize::Power(_)))),
        ("--estimator", options.estimator.is_some()),
        ("--robust", options.robust),
    ])
}

fn refuse(given: &[(&str, bool)]) -> Result<()> {
    match given.iter().find(|(_, given)| *given) {
        Some((name, _)) => Err(Error::Usage(format!(
            "{name} is for contours; this form is exact already"
        ))),
        None => Ok(()),
    }
}
