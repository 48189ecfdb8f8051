//! Definition 1: Fourier coefficients of a radius from its samples.

use rustfft::FftPlannerScalar;
use rustfft::num_complex::Complex;

use super::as_f64;
use crate::error::{Error, Result};

/// The coefficients `([a0, …, aN], [0, b1, …, bN])` of Definition 1 from the samples r(k) at the
/// angles 2πk/Ns, k = 0 … Ns − 1:
///
/// a0 = 1/Ns Σ r(k), an = 2/Ns Σ r(k) cos(2πkn/Ns), bn = 2/Ns Σ r(k) sin(2πkn/Ns).
///
/// DIFFERENCE (erratum Definition 1): the paper prints 1/(2 Ns) for a0 and 1/Ns for an and bn. With
/// these the series gives r/2: a circle of radius 1 comes back with radius 1/2.
///
/// If r(θ) is a trigonometric polynomial with at most N harmonics, these are its coefficients, up to rounding.
/// Cost: one FFT, O(Ns log Ns) for every Ns. The FFT uses no instructions that differ between processors; its cosines and sines
/// are those of the platform.
///
/// ```
/// use stellate::fit::fourier_coefficients;
/// let samples: Vec<f64> = (0..8)
///     .map(|k| 2.0 + 0.5 * (std::f64::consts::TAU * f64::from(k) / 8.0).sin())
///     .collect();
/// let (cos, sin) = fourier_coefficients(&samples, 1).unwrap();
/// assert!((cos[0] - 2.0).abs() < 1e-15 && cos[1].abs() < 1e-15 && (sin[1] - 0.5).abs() < 1e-15);
/// ```
///
/// # Errors
/// [`Error::Usage`] if Ns < 2N + 1: fewer samples do not determine N harmonics.
pub fn fourier_coefficients(samples: &[f64], harmonics: usize) -> Result<(Vec<f64>, Vec<f64>)> {
    enough_samples(samples.len(), harmonics)?;
    let mut buffer: Vec<Complex<f64>> = samples.iter().map(|&r| Complex::new(r, 0.0)).collect();
    FftPlannerScalar::new()
        .plan_fft_forward(buffer.len())
        .process(&mut buffer);
    let count = as_f64(samples.len());
    let mut cos = vec![buffer[0].re / count];
    let mut sin = vec![0.0];
    // The transform is Σ r(k) (cos(2πkn/Ns) − i sin(2πkn/Ns)).
    for term in &buffer[1..=harmonics] {
        cos.push(2.0 * term.re / count);
        sin.push(-2.0 * term.im / count);
    }
    Ok((cos, sin))
}

/// An error if `samples` samples do not determine `harmonics` harmonics.
pub(super) fn enough_samples(samples: usize, harmonics: usize) -> Result<()> {
    let needed = harmonics.saturating_mul(2).saturating_add(1);
    if samples >= needed {
        return Ok(());
    }
    Err(Error::Usage(format!(
        "N = {harmonics} harmonics need at least {needed} samples; there are {samples}"
    )))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    fn series(cos: &[f64], sin: &[f64], theta: f64) -> f64 {
        (0..cos.len())
            .map(|n| {
                let angle = as_f64(n) * theta;
                cos[n] * angle.cos() + sin[n] * angle.sin()
            })
            .sum()
    }

    fn sampled(cos: &[f64], sin: &[f64], count: usize) -> Vec<f64> {
        (0..count)
            .map(|k| series(cos, sin, TAU * as_f64(k) / as_f64(count)))
            .collect()
    }

    /// The sums of Definition 1 with the two factors left open.
    fn plain_sums(samples: &[f64], harmonics: usize, of_a0: f64, of_an: f64) -> [Vec<f64>; 2] {
        let count = as_f64(samples.len());
        let sum = |n: usize, wave: fn(f64) -> f64| -> f64 {
            let angle = |k| TAU * as_f64(k) * as_f64(n) / count;
            (0..samples.len())
                .map(|k| samples[k] * wave(angle(k)))
                .sum()
        };
        let factor = |n: usize| if n == 0 { of_a0 } else { of_an } / count;
        [f64::cos as fn(f64) -> f64, f64::sin]
            .map(|wave| (0..=harmonics).map(|n| factor(n) * sum(n, wave)).collect())
    }

    #[test]
    fn definition_1_as_printed_gives_half_the_radius() {
        let circle = vec![1.0; 16];
        let [cos, sin] = plain_sums(&circle, 3, 0.5, 1.0);
        assert!((series(&cos, &sin, 0.7) - 0.5).abs() < 1e-15);
        let (cos, sin) = fourier_coefficients(&circle, 3).unwrap();
        assert!((series(&cos, &sin, 0.7) - 1.0).abs() < 1e-15);
        // Half the radius comes back for a curve with harmonics, too.
        let (a, b) = ([2.0, 0.3, -0.1], [0.0, 0.2, 0.25]);
        let [cos, sin] = plain_sums(&sampled(&a, &b, 16), 3, 0.5, 1.0);
        for theta in [0.0, 1.0, 2.5, 4.0] {
            let (printed, true_radius) = (series(&cos, &sin, theta), series(&a, &b, theta));
            assert!((printed - true_radius / 2.0).abs() < 1e-14);
        }
    }

    #[test]
    fn too_few_samples_are_refused() {
        let error = fourier_coefficients(&vec![1.0; 1000], 600).unwrap_err();
        assert_eq!(
            error.to_string(),
            "N = 600 harmonics need at least 1201 samples; there are 1000"
        );
        assert!(fourier_coefficients(&[], 0).is_err());
        assert!(fourier_coefficients(&[1.0; 7], 3).is_ok());
        assert!(fourier_coefficients(&[1.0; 7], usize::MAX).is_err());
    }

    proptest! {
        #[test]
        fn a_series_gives_back_its_coefficients(
            pairs in prop::collection::vec((-1.0..1.0, -1.0..1.0), 1..12),
            extra in 0usize..20,
        ) {
            let (a, mut b): (Vec<f64>, Vec<f64>) = pairs.into_iter().unzip();
            b[0] = 0.0;
            let harmonics = a.len() - 1;
            let samples = sampled(&a, &b, 2 * harmonics + 1 + extra);
            let (cos, sin) = fourier_coefficients(&samples, harmonics).unwrap();
            let [slow_cos, slow_sin] = plain_sums(&samples, harmonics, 1.0, 2.0);
            for n in 0..=harmonics {
                prop_assert!((cos[n] - a[n]).abs() < 1e-13 && (sin[n] - b[n]).abs() < 1e-13);
                prop_assert!((cos[n] - slow_cos[n]).abs() < 1e-13);
                prop_assert!((sin[n] - slow_sin[n]).abs() < 1e-13);
            }
        }
    }
}
