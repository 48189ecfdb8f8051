//! The evaluation of the times: ratios, growth, and the chart.

use super::{MethodTimes, TimeComparison};
use crate::picture::{Chart, Series};

/// The growth is fitted to this number of last rungs; on earlier rungs fixed costs are too large.
pub(super) const FITTED: usize = 4;

/// The letter of a method in tables and in the chart.
pub(super) fn letter(index: usize) -> char {
    u8::try_from(index).map_or('?', |index| char::from(b'A' + index % 26))
}

/// The time of a method with N harmonics, divided by that of Theorem 2.
pub(super) fn ratio(
    comparison: &TimeComparison,
    method: &MethodTimes,
    harmonics: usize,
) -> Option<f64> {
    let theorem_2 = comparison.methods.first()?.seconds(harmonics)?;
    let ratio = method.seconds(harmonics)? / theorem_2;
    ratio.is_finite().then_some(ratio)
}

/// The exponent p of the power N^p that fits the last four times best, by least squares of logarithms; `None` if there are
/// fewer than four times.
pub(super) fn exponent(method: &MethodTimes) -> Option<f64> {
    let points = method.runs.iter().filter_map(|run| {
        let seconds = method.seconds(run.harmonics)?;
        (seconds > 0.0).then(|| [count(run.harmonics).ln(), seconds.ln()])
    });
    let points: Vec<[f64; 2]> = points.collect();
    let points = points.last_chunk::<FITTED>()?;
    let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / count(points.len());
    let [x, y] = [mean(0), mean(1)];
    let sum = |f: &dyn Fn(&[f64; 2]) -> f64| points.iter().map(f).sum::<f64>();
    Some(sum(&|p| (p[0] - x) * (p[1] - y)) / sum(&|p| (p[0] - x).powi(2)))
}

#[expect(clippy::cast_precision_loss, reason = "small numbers are counted")]
fn count(number: usize) -> f64 {
    number as f64
}

/// The chart of seconds over N, with two logarithmic axes.
pub(super) fn chart(comparison: &TimeComparison) -> Chart {
    let methods = comparison.methods.iter().enumerate();
    let series = methods.map(|(index, method)| Series {
        label: format!("{}: {}, {}", letter(index), method.program, method.what),
        points: method
            .runs
            .iter()
            .filter_map(|run| Some([count(run.harmonics), method.seconds(run.harmonics)?]))
            .filter(|point| point[1] > 0.0)
            .collect(),
        joined: true,
        mark: letter(index).to_string(),
    });
    let series: Vec<Series> = series.collect();
    let seconds = || series.iter().flat_map(|s| s.points.iter().map(|p| p[1]));
    let lowest = seconds().fold(1.0, f64::min);
    let highest = seconds().fold(comparison.limit.as_secs_f64().max(1.0), f64::max);
    Chart {
        title: String::new(),
        labels: ["N, harmonics".into(), "seconds".into()],
        y: [lowest / 2.0, highest * 2.0],
        logarithmic: true,
        series,
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::super::{Run, RunOutcome};
    use super::*;

    fn method(times: &[(usize, f64)]) -> MethodTimes {
        let run = |&(harmonics, seconds)| Run {
            harmonics,
            outcome: RunOutcome::Right(seconds),
        };
        MethodTimes {
            program: "p".into(),
            what: "w",
            runs: times.iter().map(run).collect(),
        }
    }

    #[test]
    fn a_power_law_is_found_again() {
        let law = |n: usize| (n, 3e-6 * count(n).powi(5));
        let found = exponent(&method(&[1, 2, 4, 6, 10, 20].map(law))).unwrap();
        assert!((found - 5.0).abs() < 1e-9, "{found}");
        // Times before the last four do not count, and three times are too few.
        let found = exponent(&method(&[(1, 1.0), law(2), law(4), law(8), law(14)])).unwrap();
        assert!((found - 5.0).abs() < 1e-9, "{found}");
        assert_eq!(exponent(&method(&[law(1), law(2), law(4)])), None);
    }

    #[test]
    fn ratios_are_to_the_first_method() {
        let [a, b] = [
            method(&[(1, 0.5), (2, 0.5), (3, 0.0)]),
            method(&[(1, 2.0), (3, 1.0)]),
        ];
        let comparison = TimeComparison {
            limit: Duration::from_secs(10),
            cores: 1,
            methods: vec![a, b.clone()],
            absent: Vec::new(),
        };
        let ratios = [1, 2, 3].map(|n| ratio(&comparison, &b, n));
        assert_eq!(ratios, [Some(4.0), None, None]);
        assert!(chart(&comparison).to_svg().is_ok());
    }
}
