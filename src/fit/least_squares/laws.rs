//! Laws of least squares: they are compared with a dense solution, and with the equations that define them.

use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use std::f64::consts::TAU;

use super::{Observations, as_f64, widest_gap};
use crate::limits::Limits;

/// Uniform angles, each moved by less than half a step, so that they determine the coefficients well.
fn angles(offsets: &[f64]) -> Vec<f64> {
    let step = TAU / as_f64(offsets.len());
    let moved = offsets.iter().enumerate();
    moved
        .map(|(k, o)| step * (as_f64(k) + 0.45 * o).rem_euclid(as_f64(offsets.len())))
        .collect()
}

/// The functions 1, cos θ, sin θ, … at every angle.
fn functions(angles: &[f64], harmonics: usize) -> DMatrix<f64> {
    DMatrix::from_fn(angles.len(), 2 * harmonics + 1, |row, column| {
        let angle = as_f64(column.div_ceil(2)) * angles[row];
        match column {
            0 => 1.0,
            odd if odd % 2 == 1 => angle.cos(),
            _ => angle.sin(),
        }
    })
}

fn one_coordinate(angles: &[f64], values: &[f64]) -> Vec<(f64, [f64; 1])> {
    angles.iter().zip(values).map(|(&a, &v)| (a, [v])).collect()
}

/// The coefficients and their standard errors, in the order of [`functions`].
fn estimate(
    angles: &[f64],
    values: &[f64],
    weights: &[f64],
    harmonics: usize,
    robust: bool,
) -> (DVector<f64>, DVector<f64>, f64) {
    let points = Observations::new(one_coordinate(angles, values), weights).unwrap();
    let found = points.estimate(harmonics, robust, &Limits::none()).unwrap();
    let series = found.series.iter().flat_map(|c| [c[0].re, c[0].im]);
    let errors = found.report.errors.unwrap();
    let pairs = errors.cos[0].iter().zip(&errors.sin[0]);
    let errors_in_order = pairs.flat_map(|(a, b)| [*a, *b]);
    let list = |all: Vec<f64>| {
        let all = all.into_iter().enumerate().filter(|(place, _)| *place != 1);
        DVector::from_iterator(2 * harmonics + 1, all.map(|(_, v)| v))
    };
    (
        list(series.collect()),
        list(errors_in_order.collect()),
        errors.deviation[0],
    )
}

proptest! {
    /// The dense solution by singular values, and the textbook's standard errors.
    #[test]
    fn the_estimate_is_that_of_a_dense_solution(
        points in prop::collection::vec((-1.0..1.0, -5.0..5.0, 0.1..3.0), 25..60),
        harmonics in 0usize..8,
        is_weighted: bool,
    ) {
        let offsets: Vec<f64> = points.iter().map(|p| p.0).collect();
        let values: Vec<f64> = points.iter().map(|p| p.1).collect();
        let weights: Vec<f64> = points.iter().map(|p| if is_weighted { p.2 } else { 1.0 }).collect();
        let angles = angles(&offsets);
        let given = if is_weighted { &weights[..] } else { &[] };
        let (found, errors, deviation) = estimate(&angles, &values, given, harmonics, false);
        let roots = DMatrix::from_diagonal(&DVector::from_vec(weights.iter().map(|w: &f64| w.sqrt()).collect()));
        let matrix = &roots * functions(&angles, harmonics);
        let right = &roots * DVector::from_vec(values);
        let dense = matrix.clone().svd(true, true).solve(&right, 1e-14).unwrap();
        prop_assert!((&found - &dense).amax() < 1e-9);
        let freedom = as_f64(angles.len() - 2 * harmonics - 1);
        let sigma = (&right - &matrix * dense).norm() / freedom.sqrt();
        prop_assert!((deviation / sigma - 1.0).abs() < 1e-9);
        let covariance = (matrix.transpose() * matrix).try_inverse().unwrap();
        for (error, variance) in errors.iter().zip(covariance.diagonal().iter()) {
            prop_assert!((error / (sigma * variance.sqrt()) - 1.0).abs() < 1e-6);
        }
    }

    /// Of a series with exact points, some of which are replaced by anything, the robust fit finds the series.
    #[test]
    fn a_robust_fit_is_that_of_the_exact_points(
        offsets in prop::collection::vec(-1.0..1.0, 60..90),
        coefficients in prop::collection::vec(-1.0..1.0, 7),
        wrong in prop::collection::vec((0usize..60, 3.0..100.0), 0..8),
    ) {
        let angles = angles(&offsets);
        let truth = DVector::from_vec(coefficients);
        let mut values: Vec<f64> = (functions(&angles, 3) * &truth).iter().copied().collect();
        for (place, error) in wrong {
            values[place] += error;
        }
        let (found, _, _) = estimate(&angles, &values, &[], 3, true);
        prop_assert!((found - truth).amax() < 1e-8);
    }

    /// The equations of Huber's loss: Σ ψ(v − series) f = 0 for every function f, with the stated scale.
    #[test]
    fn a_robust_fit_satisfies_its_equations(
        points in prop::collection::vec((-1.0..1.0, -5.0..5.0), 40..60),
        harmonics in 0usize..5,
    ) {
        let (offsets, values): (Vec<f64>, Vec<f64>) = points.into_iter().unzip();
        let angles = angles(&offsets);
        let observed = Observations::new(one_coordinate(&angles, &values), &[]).unwrap();
        // Few data may have no settled scale; that is an error, and no wrong answer.
        if let Ok(found) = observed.estimate(harmonics, true, &Limits::none()) {
            let (series, _, deviation) = estimate(&angles, &values, &[], harmonics, true);
            let matrix = functions(&angles, harmonics);
            let errors = DVector::from_vec(values) - &matrix * series;
            let mut sizes: Vec<f64> = errors.iter().map(|e| e.abs()).collect();
            sizes.sort_by(f64::total_cmp);
            let half = sizes.len() / 2;
            let median = f64::midpoint(sizes[half], sizes[(sizes.len() - 1) / 2]);
            prop_assert!((deviation * 0.674_489_75 / median - 1.0).abs() < 1e-6);
            let constant = found.report.robust.unwrap().constant;
            let psi = errors.map(|e| e.clamp(-constant * deviation, constant * deviation));
            prop_assert!((matrix.transpose() * psi).amax() < 1e-6);
        }
    }

    /// A point of weight 3 counts as three points.
    #[test]
    fn weights_count_points(
        points in prop::collection::vec((-1.0..1.0, -5.0..5.0, 0u8..4), 30..50),
    ) {
        let offsets: Vec<f64> = points.iter().map(|p| p.0).collect();
        let values: Vec<f64> = points.iter().map(|p| p.1).collect();
        let angles = angles(&offsets);
        let weights: Vec<f64> = points.iter().map(|p| f64::from(p.2)).collect();
        let many: Vec<(f64, f64)> = (0..points.len())
            .flat_map(|i| (0..points[i].2).map(move |_| i))
            .map(|i| (angles[i], values[i]))
            .collect();
        prop_assume!(many.len() > 20 && weights.iter().filter(|w| **w > 0.0).count() > 15);
        let (repeated, values_of_all): (Vec<f64>, Vec<f64>) = many.into_iter().unzip();
        let (of_weights, _, _) = estimate(&angles, &values, &weights, 1, false);
        let (of_all, _, _) = estimate(&repeated, &values_of_all, &[], 1, false);
        prop_assert!((of_weights - of_all).amax() < 1e-10);
    }
}

/// On a uniform grid the standard errors are σ √(1/m) and σ √(2/m).
#[test]
fn standard_errors_on_a_grid_are_simple() {
    let angles: Vec<f64> = (0..400).map(|k| TAU * as_f64(k) / 400.0).collect();
    let noise = |k: usize| {
        if (k * k + k / 3).is_multiple_of(2) {
            0.01
        } else {
            -0.01
        }
    };
    let values: Vec<f64> = (0..400).map(|k| 2.0 + angles[k].cos() + noise(k)).collect();
    let (found, errors, deviation) = estimate(&angles, &values, &[], 2, false);
    assert!((found[0] - 2.0).abs() < 5e-3 && (found[1] - 1.0).abs() < 5e-3);
    assert!((deviation - 0.01).abs() < 1e-3);
    let expected = [1.0f64, 2.0, 2.0, 2.0, 2.0].map(|d| deviation * (d / 400.0).sqrt());
    for (error, expected) in errors.iter().zip(expected) {
        assert!((error / expected - 1.0).abs() < 1e-9, "{errors}");
    }
}

#[test]
fn what_is_not_determined_is_refused() {
    let message = |angles: &[f64], weights: &[f64], harmonics: usize| {
        let values = vec![1.0; angles.len()];
        let points = Observations::new(one_coordinate(angles, &values), weights);
        let found = points.and_then(|p| p.estimate(harmonics, false, &Limits::none()).map(|_| ()));
        found.unwrap_err().to_string()
    };
    let arc: Vec<f64> = (0..300).map(|k| as_f64(k) / 300.0).collect();
    let text = message(&arc, &[], 12);
    assert!(
        text.contains("no point for 84.1 % of a turn, from 57.1° to 360.0°"),
        "{text}"
    );
    assert!(message(&arc[..10], &[], 5).contains("11 coefficients; there are 10 points"));
    assert!(message(&arc, &[0.0; 300], 0).contains("all weights are 0"));
    // Points in a few directions only.
    let four: Vec<f64> = (0..300).map(|k| TAU / 4.0 * as_f64(k % 4)).collect();
    assert!(message(&four, &[], 3).contains("do not determine N = 3 harmonics"));
    assert_eq!(widest_gap(&[]), (0.0, TAU));
}
