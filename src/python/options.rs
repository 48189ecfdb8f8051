//! The keyword options of the package's functions. Exact numbers are texts.

use std::time::Duration;

use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::fit::{
    CenterChoice, Estimator, FitModel, FitOptions, FitSize, MeshFitOptions, MeshFitSize,
    OutlineOptions,
};
use crate::language::Numbers;
use crate::limits::Limits;
use crate::picture::Window;
use crate::reading::{HarmonicConvention, Normalization};
use crate::sample::Direction;
use crate::verb::{
    ArcSearch, BoxSides, CoefficientScale, CoordinatesFrom, Frame, ImplicitizeMethod,
    ImplicitizeOptions, InspectionOptions, MeshingOptions, PlotOptions, ReadOptions,
};

/// The number of significant digits of distances.
const DIGITS: u32 = 6;

/// All options of the verbs; every function of the package has some of them.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct Options {
    pub(super) model: Option<String>,
    pub(super) harmonics: Option<usize>,
    pub(super) degree: Option<usize>,
    pub(super) tolerance: Option<String>,
    pub(super) lower: Option<String>,
    pub(super) uncertainty: Option<String>,
    pub(super) distance: Option<String>,
    pub(super) power: Option<String>,
    pub(super) center: Option<Vec<String>>,
    pub(super) center_choice: Option<String>,
    pub(super) samples: Option<usize>,
    pub(super) estimator: Option<String>,
    pub(super) robust: bool,
    pub(super) decimals: Option<u32>,
    pub(super) normal_form: bool,
    pub(super) topology: bool,
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
    pub(super) budget: Option<usize>,
    pub(super) kind: Option<String>,
    pub(super) format: Option<String>,
    pub(super) window: Option<Vec<f64>>,
    pub(super) ranges: Vec<(String, [f64; 2])>,
    pub(super) view: Option<[f64; 2]>,
    pub(super) title: Option<String>,
    pub(super) width: Option<u32>,
    pub(super) cells: Option<u32>,
    pub(super) points: Vec<[f64; 3]>,
    pub(super) resolution: Option<u32>,
    pub(super) angle: Option<f64>,
    pub(super) solid: bool,
    pub(super) complete: bool,
    pub(super) proof: bool,
    pub(super) time_limit: Option<f64>,
    pub(super) max_degree: Option<usize>,
    pub(super) threads: Option<usize>,
}

/// How a form is read.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Reading {
    numbers: Option<String>,
    cloud: bool,
    columns: Option<String>,
    weights: Option<String>,
    blob: Option<usize>,
    threshold: Option<u8>,
    invert: bool,
    repair: bool,
    normalization: Option<String>,
    condon_shortley: Option<bool>,
}

/// Reads the options of how a form is read, a JSON object.
pub(super) fn reading(text: &str) -> Result<ReadOptions> {
    let given: Reading = object(text)?;
    let normalization = match given.normalization.as_deref() {
        None => None,
        Some("unnormalized") => Some(Normalization::Unnormalized),
        Some("4pi") => Some(Normalization::FourPi),
        Some("orthonormal") => Some(Normalization::Orthonormal),
        Some("schmidt") => Some(Normalization::Schmidt),
        Some(other) => {
            let names = "unnormalized, 4pi, orthonormal, schmidt";
            return Err(none_of("normalization", other, names));
        }
    };
    let mut outline = OutlineOptions::default()
        .threshold(given.threshold)
        .invert(given.invert)
        .columns(given.columns.map(|text| text.parse()).transpose()?)
        .weights(given.weights.map(|text| text.parse()).transpose()?)
        .repair(given.repair);
    match given.blob {
        None => {}
        Some(0) => return Err(Error::Usage("blob: outlines are counted from 1".into())),
        Some(blob) => outline = outline.blob(blob),
    }
    Ok(ReadOptions::default()
        .numbers(numbers(given.numbers.as_deref())?)
        .cloud(given.cloud)
        .outline(outline)
        .harmonics(
            HarmonicConvention::default()
                .normalization(normalization)
                .condon_shortley(given.condon_shortley),
        ))
}

fn numbers(name: Option<&str>) -> Result<Numbers> {
    match name {
        None | Some("exact") => Ok(Numbers::Exact),
        Some("f64") => Ok(Numbers::F64),
        Some(other) => Err(none_of("numbers", other, "exact, f64")),
    }
}

/// Reads a JSON object of options.
fn object<T: DeserializeOwned>(text: &str) -> Result<T> {
    serde_json::from_str(text).map_err(|error| wrong_option::<T>(text, &error))
}

/// The error for options that cannot be read: the first one that cannot be read alone is named.
fn wrong_option<T: DeserializeOwned>(text: &str, error: &serde_json::Error) -> Error {
    let all: serde_json::Map<String, Value> = serde_json::from_str(text).unwrap_or_default();
    let wrong = all.into_iter().find_map(|(name, value)| {
        let shown = value.to_string();
        let alone = json!({ name.as_str(): value }).to_string();
        let fault = serde_json::from_str::<T>(&alone).err()?.to_string();
        let fault = fault.split(" at line").next().unwrap_or_default();
        let expected = match fault
            .split_once("expected ")
            .map_or(fault, |(_, kind)| kind)
        {
            "u8" => "a whole number from 0 to 254",
            "u32" | "usize" => "a whole number that is not negative, and not too large",
            "f64" => "a number",
            "fewer elements in array" | "trailing characters" => "fewer numbers",
            other => other,
        };
        Some(format!("{name}: expected {expected}, not {shown}"))
    });
    Error::Usage(wrong.unwrap_or_else(|| format!("options: {error}")))
}

impl Options {
    pub(super) fn read(text: &str) -> Result<Self> {
        object(text)
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
        let model = match self.model.as_deref() {
            None | Some("radius") => FitModel::Radius,
            Some("elliptic") => FitModel::Elliptic,
            Some(other) => return Err(none_of("model", other, "radius, elliptic")),
        };
        Ok(FitOptions::default()
            .model(model)
            .size(sizes.into_iter().next())
            .center(self.center()?)
            .samples(self.samples)
            .estimator(self.estimator()?)
            .robust(self.robust)
            .decimals(self.decimals))
    }

    fn center(&self) -> Result<CenterChoice> {
        let names = "auto, centroid, kernel, best, (x, y), (x, y, z)";
        Ok(
            match (self.center.as_deref(), self.center_choice.as_deref()) {
                (Some([x, y]), _) => CenterChoice::Point([x.parse()?, y.parse()?]),
                (Some([x, y, z]), _) => CenterChoice::InSpace([x.parse()?, y.parse()?, z.parse()?]),
                (Some(other), _) => {
                    let count = format!("{} numbers", other.len());
                    return Err(none_of("center", &count, names));
                }
                (None, None | Some("auto")) => CenterChoice::Auto,
                (None, Some("centroid")) => CenterChoice::Centroid,
                (None, Some("kernel")) => CenterChoice::Kernel,
                (None, Some("best")) => CenterChoice::Best,
                (None, Some(other)) => return Err(none_of("center", other, names)),
            },
        )
    }

    fn estimator(&self) -> Result<Option<Estimator>> {
        match self.estimator.as_deref() {
            None => Ok(None),
            Some("quadrature") => Ok(Some(Estimator::Quadrature)),
            Some("least-squares") => Ok(Some(Estimator::LeastSquares)),
            Some(other) => Err(none_of("estimator", other, "quadrature, least-squares")),
        }
    }

    /// How a mesh becomes a sum of spherical harmonics.
    pub(super) fn mesh_fit(&self) -> Result<MeshFitOptions> {
        let contours_alone = [
            ("harmonics", self.harmonics.is_some()),
            (
                "model",
                !matches!(self.model.as_deref(), None | Some("radius")),
            ),
            ("distance", self.distance.is_some()),
            ("power", self.power.is_some()),
            ("decimals", self.decimals.is_some()),
            ("robust", self.robust),
            ("normal_form", self.normal_form),
            ("proof", self.proof),
        ];
        if let Some((name, _)) = contours_alone.iter().find(|(_, given)| *given) {
            return Err(Error::Usage(format!(
                "{name} is for contours; the fit of a mesh has degree or tolerance, center, samples and estimator"
            )));
        }
        let size = match (self.degree, number("tolerance", self.tolerance.as_deref())?) {
            (Some(degree), None) => MeshFitSize::Degree(degree),
            (None, Some(tolerance)) => MeshFitSize::Tolerance(tolerance.to_f64()),
            _ => {
                let message = "the fit of a mesh needs one of degree and tolerance";
                return Err(Error::Usage(message.into()));
            }
        };
        Ok(MeshFitOptions::new(size)
            .center(self.center()?)
            .estimator(self.estimator()?.unwrap_or(Estimator::Quadrature))
            .samples(self.samples))
    }

    pub(super) fn implicitize(&self) -> Result<ImplicitizeOptions> {
        let method = match self.method.as_deref() {
            None => None,
            Some("polar") => Some(ImplicitizeMethod::Polar),
            Some("resultant") => Some(ImplicitizeMethod::Resultant),
            Some(other) => return Err(none_of("method", other, "polar, resultant")),
        };
        let scale = match self.scale.as_deref() {
            None | Some("integer") => CoefficientScale::Integer,
            Some("monic") => CoefficientScale::Monic,
            Some(other) => return Err(none_of("scale", other, "integer, monic")),
        };
        Ok(ImplicitizeOptions::default()
            .fit(self.fit()?)
            .method(method)
            .scale(scale)
            .coordinates(self.coordinates()?))
    }

    /// How points are inspected; `tolerance` is that of the verdict, and none of the fit.
    pub(super) fn inspection(&self) -> Result<InspectionOptions> {
        let fit = Self {
            model: self.model.clone(),
            harmonics: self.harmonics,
            distance: self.distance.clone(),
            center: self.center.clone(),
            center_choice: self.center_choice.clone(),
            ..Self::default()
        };
        let mut asked = InspectionOptions::default()
            .reach(self.reach)
            .digits(self.digits.unwrap_or(DIGITS))
            .fit(fit.fit()?);
        if let Some(budget) = self.budget {
            asked = asked.budget(budget);
        }
        asked = asked.lower(number("tolerance", self.lower.as_deref())?);
        if let Some(uncertainty) = number("uncertainty", self.uncertainty.as_deref())? {
            asked = asked.uncertainty(uncertainty);
        }
        Ok(match number("tolerance", self.tolerance.as_deref())? {
            Some(tolerance) => asked.tolerance(tolerance),
            None => asked,
        })
    }

    pub(super) fn plot(&self) -> Result<PlotOptions> {
        Ok(PlotOptions::default()
            .fit(self.fit()?)
            .window(self.frame()?)
            .ranges(self.ranges.clone())
            .view(self.view)
            .title(self.title.clone().unwrap_or_default())
            .width(self.width)
            .cells(self.cells)
            .points(self.points.clone()))
    }

    pub(super) fn meshing(&self) -> Result<MeshingOptions> {
        let mut asked = MeshingOptions::default()
            .window(self.bounds()?)
            .solid(self.solid);
        if let Some(resolution) = self.resolution {
            asked = asked.resolution(resolution);
        }
        Ok(match self.angle {
            Some(angle) => asked.angle(angle),
            None => asked,
        })
    }

    pub(super) fn arcs(&self) -> Result<ArcSearch> {
        Ok(ArcSearch::default()
            .window(self.bounds()?)
            .resolution(self.resolution))
    }

    /// The part of the plane or of space that a picture shows.
    pub(super) fn frame(&self) -> Result<Option<Frame>> {
        match self.window.as_deref() {
            Some([a, b, c, d]) if a < b && c < d => Ok(Some(Frame::Plane(Window {
                x: [*a, *b],
                y: [*c, *d],
            }))),
            _ => Ok(self.bounds()?.map(Frame::Space)),
        }
    }

    fn bounds(&self) -> Result<Option<BoxSides>> {
        match self.window.as_deref() {
            None => Ok(None),
            Some([a, b, c, d, e, f]) if a < b && c < d && e < f => {
                Ok(Some([[*a, *b], [*c, *d], [*e, *f]]))
            }
            Some(_) => {
                let message = "window: four numbers x0 < x1, y0 < y1 in the plane, or six in space";
                Err(Error::Usage(message.into()))
            }
        }
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
    pub(super) fn limits(&self) -> Result<Limits> {
        let Some(seconds) = self.time_limit else {
            return Ok(Limits::none());
        };
        let time = Duration::try_from_secs_f64(seconds);
        let wrong = |_| Error::Usage(format!("time_limit: {seconds} is no number of seconds"));
        Ok(Limits::none().with_time_limit(time.map_err(wrong)?))
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
