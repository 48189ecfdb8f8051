//! Claims about the errors of a fit (T8).

use serde_json::json;

use super::forms::{radius_form, texts};
use super::proof::Proof;
use crate::exact::Rational;
use crate::shape::{FourierRadius, series};

/// Square roots are enclosed to this many bits after the point.
const BITS: u32 = 100;
/// The interval that is claimed is this much wider on each side, in units of the number or of the largest radius.
const ROOM: f64 = 1e-9;
/// No more products of points and harmonics than this are written down with a witness.
const MOST: usize = 400_000;

/// Claims the largest and the mean error at points, up to rounding: `fit-error`. If the numbers are `stated`, they are claimed;
/// otherwise they are computed here. Without points, or with too many of them, there is no claim.
pub(crate) fn fit_error(
    proof: &mut Proof,
    radius: &FourierRadius,
    points: &[[f64; 2]],
    stated: Option<[f64; 2]>,
) {
    let size = points.len().saturating_mul(radius.harmonics() + 1);
    let center = radius.center().each_ref().map(Rational::to_f64);
    let offsets = || points.iter().map(|p| [p[0] - center[0], p[1] - center[1]]);
    if points.is_empty() || size > MOST || offsets().any(|v| v == [0.0, 0.0]) {
        return;
    }
    let (mut max, mut squares, mut largest) = (0.0_f64, 0.0, 0.0_f64);
    let (cos, sin) = radius.to_doubles();
    for [x, y] in offsets() {
        let rho = x.hypot(y);
        let error = (series(&cos, &sin, y.atan2(x)) - rho).abs();
        max = max.max(error);
        squares += error * error;
        largest = largest.max(rho);
    }
    #[expect(clippy::cast_precision_loss, reason = "a number of points")]
    let rms = (squares / points.len() as f64).sqrt();
    let bounds = |value: f64| -> Option<[Rational; 2]> {
        let room = ROOM * value.max(largest);
        let [low, a, b, high] = [
            (value - room).max(0.0),
            (value - room / 2.0).max(0.0),
            value + room / 2.0,
            value + room,
        ]
        .map(|end| Rational::try_from(end).ok());
        Some([
            Rational::simplest_between(&low?, &a?),
            Rational::simplest_between(&b?, &high?),
        ])
    };
    let [max, rms] = stated.unwrap_or([max, rms]);
    let (Some(form), Some(max), Some(rms)) = (radius_form(proof, radius), bounds(max), bounds(rms))
    else {
        return;
    };
    let samples = points.iter().map(|point| point.map(Rational::try_from));
    let samples: Option<Vec<_>> = samples
        .map(|[x, y]| Some(texts(&[x.ok()?, y.ok()?])))
        .collect();
    let Some(samples) = samples else {
        return;
    };
    let statement =
        json!({ "form": form, "samples": samples, "max": texts(&max), "rms": texts(&rms) });
    proof.claim("fit-error", &statement, Some(json!({ "bits": BITS })));
}
