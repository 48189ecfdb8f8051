//! The keyword options of the package's functions. Exact numbers are texts.

use std::time::Duration;

use serde::Deserialize;

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::fit::{CenterChoice, Estimator, FitModel, FitOptions, FitSize};
use crate::limits::Limits;
use crate::sample::Direction;
use crate::verb::{CoordinatesFrom, Work};

/// All options; every function of the package has some of them.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct Options {
    pub(super) model: Option<String>,
    pub(super) harmonics: Option<usize>,
    pub(super) tolerance: Option<String>,
    pub(super) distance: Option<String>,
    pub(super) power: Option<String>,
    pub(super) center: Option<[String; 2]>,
    pub(super) center_choice: Option<String>,
    pub(super) samples: Option<usize>,
    pub(super) estimator: Option<String>,
    pub(super) robust: bool,
    pub(super) decimals: Option<u32>,
    pub(super) normal_form: bool,
    pub(super) method: Option<String>,
    pub(super) scale: Option<String>,
    pub(super) coordinates: Option<String>,
    pub(super) directions: Option<usize>,
    pub(super) thetas: Vec<String>,
    pub(super) phis: Vec<String>,
    pub(super) positive: bool,
    pub(super) branch: Option<usize>,
    pub(super) digits: Option<u32>,
    pub(super) reach: Option<f64>,
    pub(super) dimension: Option<usize>,
    pub(super) kind: Option<String>,
    pub(super) format: Option<String>,
    pub(super) window: Option<Vec<f64>>,
    pub(super) title: Option<String>,
    pub(super) resolution: Option<u32>,
    pub(super) complete: bool,
    pub(super) time_limit: Option<f64>,
    pub(super) max_degree: Option<usize>,
}

impl Options {
    pub(super) fn read(text: &str) -> Result<Self> {
        serde_json::from_str(text).map_err(|error| Error::Usage(format!("options: {error}")))
    }

    /// How a contour becomes a series.
    pub(super) fn fit(&self) -> Result<FitOptions> {
        let size = |text: &Option<String>, name: &str| -> Result<Option<f64>> {
            Ok(number(name, text.as_deref())?.map(|n| n.to_f64()))
        };
        let sizes = [
            self.harmonics.map(FitSize::Harmonics),
            size(&self.tolerance, "tolerance")?.map(FitSize::Tolerance),
            size(&self.distance, "distance")?.map(FitSize::Distance),
            size(&self.power, "power")?.map(FitSize::Power),
        ];
        let sizes: Vec<FitSize> = sizes.into_iter().flatten().collect();
        if sizes.len() > 1 {
            let message = "one of harmonics, tolerance, distance and power can be given";
            return Err(Error::Usage(message.into()));
        }
        let center = match (&self.center, self.center_choice.as_deref()) {
            (Some([x, y]), _) => CenterChoice::Point([x.parse()?, y.parse()?]),
            (None, None | Some("auto")) => CenterChoice::Auto,
            (None, Some("centroid")) => CenterChoice::Centroid,
            (None, Some("kernel")) => CenterChoice::Kernel,
            (None, Some("best")) => CenterChoice::Best,
            (None, Some(other)) => {
                return Err(none_of(
                    "center",
                    other,
                    "auto, centroid, kernel, best, (x, y)",
                ));
            }
        };
        let model = match self.model.as_deref() {
            None | Some("radius") => FitModel::Radius,
            Some("elliptic") => FitModel::Elliptic,
            Some(other) => return Err(none_of("model", other, "radius, elliptic")),
        };
        let estimator = match self.estimator.as_deref() {
            None => None,
            Some("quadrature") => Some(Estimator::Quadrature),
            Some("least-squares") => Some(Estimator::LeastSquares),
            Some(other) => return Err(none_of("estimator", other, "quadrature, least-squares")),
        };
        Ok(FitOptions::default()
            .model(model)
            .size(sizes.into_iter().next())
            .center(center)
            .samples(self.samples)
            .estimator(estimator)
            .robust(self.robust)
            .decimals(self.decimals))
    }

    /// The origin of coordinates.
    pub(super) fn coordinates(&self) -> Result<CoordinatesFrom> {
        match self.coordinates.as_deref() {
            None | Some("center") => Ok(CoordinatesFrom::Center),
            Some("original") => Ok(CoordinatesFrom::Original),
            Some(other) => Err(none_of("coordinates", other, "center, original")),
        }
    }

    /// The limits of the work.
    pub(super) fn work(&self) -> Result<Work> {
        let mut limits = Limits::none();
        if let Some(seconds) = self.time_limit {
            let time = Duration::try_from_secs_f64(seconds);
            let wrong = |_| Error::Usage(format!("time_limit: {seconds} is no number of seconds"));
            limits = limits.with_time_limit(time.map_err(wrong)?);
        }
        let work = Work::default().limits(limits);
        Ok(match self.max_degree {
            Some(degree) => work.max_degree(degree),
            None => work,
        })
    }
}

/// The number that a text is, if there is one.
pub(super) fn number(name: &str, text: Option<&str>) -> Result<Option<Rational>> {
    let read = |text: &str| -> Result<Rational> { text.parse() };
    text.map(read)
        .transpose()
        .map_err(|error| Error::Usage(format!("{name}: {error}")))
}

/// The directions of angles such as `0.5`, `pi/4` and `30deg`.
pub(super) fn directions(texts: &[String]) -> Result<Vec<Direction>> {
    texts.iter().map(|text| text.parse()).collect()
}

pub(super) fn none_of(name: &str, got: &str, names: &str) -> Error {
    Error::Usage(format!("{name}: {got} is none of {names}"))
}
