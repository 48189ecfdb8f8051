//! Charts of a comparison: the correct digits of every number, and the digits that doubles keep for growing N.

use crate::check::{Comparison, DigitsKept, GivenNumber, MOST_DIGITS, Row, Rung};
use crate::picture::{Chart, Series};

/// The chart of the correct digits of every number over its place: the place of a coefficient is its term, that of a point or a
/// radius its angle.
#[must_use]
pub fn digits_chart(found: &Comparison, mark: Option<u32>, name: &str) -> Chart {
    let is_term = matches!(
        found.all().next().map(|row| &row.place),
        None | Some(GivenNumber::Term(_) | GivenNumber::Harmonic { .. })
    );
    let series = |label: &str, rows: &[Row]| Series {
        label: format!("{label}: {}", rows.len()),
        points: rows
            .iter()
            .enumerate()
            .map(|(k, row)| [across(k, row), row.deviation.digits()])
            .collect(),
        joined: false,
        ..Series::default()
    };
    let mut all = vec![series("compared", &found.rows)];
    for (label, rows) in [("missing", &found.missing), ("extra", &found.extra)] {
        if !rows.is_empty() {
            all.push(series(label, rows));
        }
    }
    if let (Some(mark), Some([low, high])) = (mark, extent(&all)) {
        let digits = f64::from(mark);
        all.push(Series {
            label: format!("{mark} digits asked for"),
            points: vec![[low, digits], [high, digits]],
            joined: true,
            ..Series::default()
        });
    }
    Chart {
        title: format!("Correct digits, {name}"),
        labels: [
            if is_term { "term" } else { "angle" }.into(),
            "correct digits".into(),
        ],
        y: [0.0, MOST_DIGITS + 0.5],
        logarithmic: false,
        series: all,
    }
}

#[expect(
    clippy::cast_precision_loss,
    reason = "the place of a term on the axis of a picture"
)]
fn across(index: usize, row: &Row) -> f64 {
    match &row.place {
        GivenNumber::Term(_) | GivenNumber::Harmonic { .. } => index as f64 + 1.0,
        GivenNumber::Point { position, .. } => position[1].atan2(position[0]),
        GivenNumber::Radius { theta, .. } | GivenNumber::SpaceRadius { theta, .. } => *theta,
    }
}

fn extent(series: &[Series]) -> Option<[f64; 2]> {
    let x = || series.iter().flat_map(|s| s.points.iter().map(|p| p[0]));
    Some([x().reduce(f64::min)?, x().reduce(f64::max)?])
}

/// The chart of the digits that doubles keep over N, see [`check_doubles`](super::check_doubles).
#[must_use]
pub fn ladder_chart(rungs: &[Rung], name: &str) -> Chart {
    let series = |label: &str, digits: &dyn Fn(&Rung) -> f64| Series {
        label: label.into(),
        points: rungs
            .iter()
            .map(|rung| [across_harmonics(rung), digits(rung)])
            .collect(),
        joined: true,
        ..Series::default()
    };
    let worst = |kept: DigitsKept| kept.worst;
    Chart {
        title: format!("Theorem 2 in doubles, {name}"),
        labels: ["N".into(), "correct digits".into()],
        y: [0.0, MOST_DIGITS + 0.5],
        logarithmic: false,
        series: vec![
            series("coefficients, the worst", &|rung| worst(rung.coefficients)),
            series("radii, the worst", &|rung| worst(rung.radii)),
            series(
                "F at points 1 % outside, from its monomials, the worst",
                &|rung| worst(rung.near),
            ),
            series("the same, the median", &|rung| rung.near.median),
        ],
    }
}

#[expect(clippy::cast_precision_loss, reason = "a number of harmonics is small")]
fn across_harmonics(rung: &Rung) -> f64 {
    rung.harmonics as f64
}
