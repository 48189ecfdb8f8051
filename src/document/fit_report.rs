//! What is reported of a fit, as fields of JSON documents and as comments.

use super::json::Number;
use crate::error::Invariant;
use crate::fit::LeastSquares;
use crate::verb::FitReport;

/// A number as JSON writes it.
fn number(value: f64) -> String {
    serde_json::to_string(&Number(value)).invariant("a number is written as JSON")
}

/// The fields of a document about a fit, as JSON.
pub(super) fn report_fields(report: &FitReport) -> Vec<(&'static str, String)> {
    let mut fields = plain_fields(report);
    fields.extend(
        report
            .least_squares
            .as_ref()
            .map(|found| ("least_squares", least_squares_text(found))),
    );
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
    comments.extend(report.least_squares.as_ref().map(least_squares_sentence));
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

/// What least squares say of the coefficients, as JSON.
fn least_squares_text(found: &LeastSquares) -> String {
    let numbers = |list: &[f64]| {
        let texts: Vec<String> = list.iter().map(|&value| number(value)).collect();
        format!("[{}]", texts.join(","))
    };
    let mut text = format!(
        "{{\"points\":{},\"weighted\":{}",
        found.points, found.is_weighted
    );
    if let Some(robust) = &found.robust {
        text.push_str(&format!(
            ",\"robust\":{{\"loss\":\"huber\",\"constant\":{},\"reduced\":{}}}",
            number(robust.constant),
            robust.reduced
        ));
    }
    if let Some(errors) = &found.errors {
        let names: &[[&str; 2]] = match errors.cos.len() {
            1 => &[["cos", "sin"]],
            _ => &[["x_cos", "x_sin"], ["y_cos", "y_sin"]],
        };
        let lists = names.iter().zip(errors.cos.iter().zip(&errors.sin));
        let lists = lists.map(|([cos, sin], (of_cos, of_sin))| {
            let (of_cos, of_sin) = (numbers(of_cos), numbers(of_sin));
            format!("\"{cos}\":{of_cos},\"{sin}\":{of_sin}")
        });
        let lists: Vec<String> = lists.collect();
        text.push_str(&format!(
            ",\"deviation\":{},\"standard_errors\":{{{}}}",
            numbers(&errors.deviation),
            lists.join(",")
        ));
    }
    text.push('}');
    text
}

/// What least squares say of the coefficients, in a sentence.
pub(super) fn least_squares_sentence(found: &LeastSquares) -> String {
    let weights = if found.is_weighted { ", weighted" } else { "" };
    let mut text = format!("least squares: {} points{weights}", found.points);
    if let Some(errors) = &found.errors {
        let deviations: Vec<String> = errors
            .deviation
            .iter()
            .map(|d| format!("≈ {d:.3e}"))
            .collect();
        let lists = errors.cos.iter().chain(&errors.sin).flatten();
        let largest = lists.copied().fold(0.0, f64::max);
        text.push_str(&format!(
            "; standard deviation of their errors {}, standard errors of the coefficients ≈ {largest:.3e} at most",
            deviations.join(" in x and ") + if deviations.len() > 1 { " in y" } else { "" }
        ));
    }
    if let Some(robust) = &found.robust {
        text.push_str(&format!(
            "; Huber's loss with the constant {}: less weight for {} of them",
            robust.constant, robust.reduced
        ));
    }
    text
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
        let seen = radial.outline;
        fields.extend(seen.map(|seen| ("outline_star_shaped", seen.star_shaped.to_string())));
        fields.push(("samples", radial.samples.to_string()));
        fields.extend(seen.map(|seen| ("hidden_share", number(seen.hidden_share))));
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
