//! Values of a Fourier series at many angles.

use std::f64::consts::{PI, TAU};

use rustfft::FftPlannerScalar;
use rustfft::num_complex::Complex;

use super::as_f64;

/// The number of terms of the Taylor series in [`at_angles`].
const TAYLOR_TERMS: usize = 13;

/// Σ (a_n cos nθ + b_n sin nθ) at θ = 2πk/`count`, k = 0 … `count` − 1; `count` must exceed the number
/// of harmonics. Cost: one FFT.
pub(super) fn at_uniform(cos: &[f64], sin: &[f64], count: usize) -> Vec<f64> {
    let terms = cos.iter().zip(sin).map(|(&a, &b)| Complex::new(a, -b));
    transform(terms, count).into_iter().map(|z| z.re).collect()
}

/// The values of the series at any angles in [0, 2π]. Each is computed by the Taylor series about the nearest of G ≥ 8(N+1)
/// uniform angles; FFTs give the derivatives there.
///
/// The distance δ from the nearest uniform angle has n|δ| ≤ π/8, so 13 terms leave an error of at most
/// Cost: 13 FFTs of length G and O(13) per angle, whatever N.
pub(super) fn at_angles(cos: &[f64], sin: &[f64], angles: &[f64]) -> Vec<f64> {
    if angles.is_empty() {
        return Vec::new();
    }
    let grid = (8 * cos.len()).next_power_of_two();
    let half_step = PI / as_f64(grid);
    // Each angle is node·2π/G + offset·(half a step), |offset| ≤ 1. This is computed anew for every term, because a million
    // angles have no room to keep it.
    let split = |theta: f64| {
        let steps = theta / TAU * as_f64(grid);
        let node = steps.round();
        (node_index(node, grid), 2.0 * (steps - node))
    };
    // The k-th derivative, times (half a step)^k/k!.
    let mut terms: Vec<Complex<f64>> = cos
        .iter()
        .zip(sin)
        .map(|(&a, &b)| Complex::new(a, -b))
        .collect();
    let mut values = vec![0.0; angles.len()];
    let mut powers = vec![1.0; angles.len()];
    for k in 0..TAYLOR_TERMS {
        let derivative = transform(terms.iter().copied(), grid);
        for ((value, power), &theta) in values.iter_mut().zip(&mut powers).zip(angles) {
            let (node, offset) = split(theta);
            *value += *power * derivative[node].re;
            *power *= offset;
        }
        for (n, term) in terms.iter_mut().enumerate() {
            *term *= Complex::new(0.0, as_f64(n) * half_step / as_f64(k + 1));
        }
    }
    values
}

/// The sums Σ_n c_n e^{2πi nk/count} for k = 0 … count − 1.
fn transform(terms: impl Iterator<Item = Complex<f64>>, count: usize) -> Vec<Complex<f64>> {
    let mut buffer: Vec<Complex<f64>> = terms.collect();
    buffer.resize(count, Complex::default());
    FftPlannerScalar::new()
        .plan_fft_inverse(count)
        .process(&mut buffer);
    buffer
}

/// The number `node` as an index modulo `grid`.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "node is an integer in 0..=grid, and a cast from float saturates"
)]
fn node_index(node: f64, grid: usize) -> usize {
    node as usize % grid
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_fast_values_are_the_plain_sums(
            pairs in prop::collection::vec((-1.0..1.0, -1.0..1.0), 1..70),
            mut angles in prop::collection::vec(0.0..TAU, 1..20),
        ) {
            let (cos, mut sin): (Vec<f64>, Vec<f64>) = pairs.into_iter().unzip();
            sin[0] = 0.0;
            angles.extend([0.0, TAU, PI]);
            let plain = |theta: f64| -> f64 {
                (0..cos.len())
                    .map(|n| {
                        let angle = as_f64(n) * theta;
                        cos[n] * angle.cos() + sin[n] * angle.sin()
                    })
                    .sum()
            };
            let weight: f64 = cos.iter().chain(&sin).map(|c| c.abs()).sum();
            for (value, &theta) in at_angles(&cos, &sin, &angles).iter().zip(&angles) {
                prop_assert!((value - plain(theta)).abs() < 1e-13 * weight);
            }
            let count = cos.len() + 3;
            for (k, value) in at_uniform(&cos, &sin, count).iter().enumerate() {
                let theta = TAU * as_f64(k) / as_f64(count);
                prop_assert!((value - plain(theta)).abs() < 1e-13 * weight);
            }
        }
    }
}
