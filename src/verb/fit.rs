//! Fits of contours by Fourier radii, for the verb `fit` and for every verb that takes a contour.

use super::{Content, Given, Remark, Work};
use crate::error::{Error, Result};
use crate::fit::{CenterChoice, CenterOrigin, Fit, FitOptions, FitReport, FitSize, fit_within};
use crate::shape::{Contour, Form, FourierRadius};

/// Fits a Fourier radius to a contour (Definition 1).
///
/// ```
/// use stellate::fit::{FitOptions, FitSize};
/// use stellate::shape::Contour;
/// use stellate::verb::{self, Work};
/// let square = Contour::new(vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]], "square")?;
/// let fit = verb::fit(&square, &FitOptions::new(FitSize::Harmonics(8)), &Work::default())?;
/// assert_eq!(fit.radius.harmonics(), 8);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// As [`fit_within`]; [`Error::Limit`] if the polynomial of the radius has a degree above that which the work allows.
pub fn fit(contour: &Contour, options: &FitOptions, work: &Work) -> Result<Fit> {
    if let Some(n) = options.harmonics() {
        work.check_degree(n.saturating_mul(2).saturating_add(2))?;
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
    if !fit.star_shaped {
        let share = fit.hidden_share;
        work.remark(Remark::Hidden {
            outline: outline(),
            point,
            share,
        });
    }
    Ok(fit)
}

/// The fit of a contour with another number of harmonics. It makes no remarks; it is `None` if the contour has no such fit.
pub(super) fn fit_quietly(
    contour: &Contour,
    options: &FitOptions,
    harmonics: usize,
    work: &Work,
) -> Option<FourierRadius> {
    let options = options.clone().size(Some(FitSize::Harmonics(harmonics)));
    let fit = fit_within(contour, &options, work.bounds()).ok()?;
    Some(fit.radius)
}

/// An exact form and, if it was fitted to a contour, the deviations of that fit.
pub(super) struct Fitted {
    pub(super) form: Form,
    pub(super) report: Option<FitReport>,
}

/// The exact form of an input; a contour is fitted as the options say.
pub(super) fn exact_form(given: Given, options: &FitOptions, work: &Work) -> Result<Fitted> {
    match given.into_content() {
        Content::Exact(form) => {
            refuse_fit_options(options)?;
            Ok(Fitted { form, report: None })
        }
        Content::Contour(contour) => {
            let fit = fit(&contour, options, work)?;
            Ok(Fitted {
                report: Some(fit.report()),
                form: Form::Fourier(fit.radius),
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
    ])?;
    refuse_contour_options(options)
}

/// Refuses the options that only a contour has: its center and the tolerance of its fit.
pub(super) fn refuse_contour_options(options: &FitOptions) -> Result<()> {
    refuse(&[
        (
            "--tolerance",
            matches!(options.size, Some(FitSize::Tolerance(_))),
        ),
        ("--center", options.center != CenterChoice::Centroid),
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
