//! What is reported of a fit, as fields of JSON documents and as comments.

use super::json::Number;
use crate::error::Invariant;
use crate::verb::FitReport;

/// A number as JSON writes it.
fn number(value: f64) -> String {
    serde_json::to_string(&Number(value)).invariant("a number is written as JSON")
}

/// The fields of a document about a fit, as JSON.
pub(super) fn report_fields(report: &FitReport) -> Vec<(&'static str, String)> {
    let mut fields = plain_fields(report);
    if let Some(found) = &report.distances {
        let bounds = [found.hausdorff.low, found.hausdorff.high].map(number);
        fields.extend([
            (
                "distance",
                format!("{{\"low\":{},\"high\":{}}}", bounds[0], bounds[1]),
            ),
            ("mean_distance", number(found.mean)),
            ("overlap", number(found.overlap)),
        ]);
    }
    fields
}

/// The comments of a document about a fit.
pub(super) fn report_comments(report: &FitReport) -> Vec<String> {
    let plain = plain_fields(report).into_iter();
    let mut comments: Vec<String> = plain
        .map(|(name, value)| format!("{name}: {value}"))
        .collect();
    if let Some(found) = &report.distances {
        comments.extend([
            format!(
                "distance: {} to {} (certified bounds of the Hausdorff distance)",
                number(found.hausdorff.low),
                number(found.hausdorff.high)
            ),
            format!("mean_distance: ≈ {}", number(found.mean)),
            format!("overlap: ≈ {}", number(found.overlap)),
        ]);
    }
    comments
}

/// The fields whose values are numbers or truth values.
fn plain_fields(report: &FitReport) -> Vec<(&'static str, String)> {
    let mut fields = Vec::new();
    if let Some(radial) = &report.radial {
        fields.extend([
            ("max_radial_error", number(radial.max_error)),
            ("rms_radial_error", number(radial.rms_error)),
        ]);
        fields.extend(
            radial
                .star_shaped
                .map(|yes| ("star_shaped", yes.to_string())),
        );
        fields.extend([
            (
                "outline_star_shaped",
                radial.outline_star_shaped.to_string(),
            ),
            ("samples", radial.samples.to_string()),
            ("hidden_share", number(radial.hidden_share)),
        ]);
    }
    fields.extend(
        report
            .harmonic_power
            .map(|power| ("harmonic_power", number(power))),
    );
    if let Some(taken) = &report.normal_form {
        let text = format!(
            "{{\"size\":{},\"rotation\":{},\"start\":{},\"reversed\":{}}}",
            number(taken.size),
            number(taken.rotation),
            number(taken.start),
            taken.reversed
        );
        fields.push(("normal_form", text));
    }
    fields
}
