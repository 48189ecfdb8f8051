//! From an outline to its Fourier series: by points, by harmonics, by models, beside Definition 1 as it is printed.
//!
//! `cargo bench --bench fit`. Every answer is verified before it is timed.

#![expect(clippy::unwrap_used, reason = "a bench fails by panicking")]

use std::f64::consts::TAU;
use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, SamplingMode, criterion_group, criterion_main};
use stellate::fit::{FitOptions, FitSize, distances, fit, fit_elliptic, fourier_coefficients};
use stellate::limits::Limits;
use stellate::shape::Contour;

/// 2 + 0.3 cos 3θ + 0.2 sin 7θ + 0.01 sin 500θ
fn radius(theta: f64) -> f64 {
    2.0 + 0.3 * (3.0 * theta).cos() + 0.2 * (7.0 * theta).sin() + 0.01 * (500.0 * theta).sin()
}

fn outline(points: u32) -> Contour {
    let vertex = |k: u32| {
        let theta = TAU * f64::from(k) / f64::from(points);
        [radius(theta) * theta.cos(), radius(theta) * theta.sin()]
    };
    Contour::new((0..points).map(vertex).collect(), "outline").unwrap()
}

/// The whole fit with 1000 harmonics.
fn points(c: &mut Criterion) {
    let mut group = c.benchmark_group("fit_1000_harmonics");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    let options = FitOptions::new(FitSize::Harmonics(1000));
    for count in [10_000, 100_000, 1_000_000] {
        let contour = outline(count);
        let fitted = fit(&contour, &options).unwrap();
        assert!((fitted.radius.cos(3).to_f64() - 0.3).abs() < 1e-3);
        group.bench_with_input(BenchmarkId::new("points", count), &contour, |b, contour| {
            b.iter(|| fit(black_box(contour), &options).unwrap());
        });
    }
    group.finish();
}

/// Both models with 39 harmonics, of the same outlines: their ratio is what exact rounding of the elliptic series costs.
fn models(c: &mut Criterion) {
    let mut group = c.benchmark_group("fit_39_harmonics");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    let options = FitOptions::new(FitSize::Harmonics(39));
    for count in [1000, 100_000, 1_000_000] {
        let contour = outline(count);
        let series = fit_elliptic(&contour, &options, &Limits::none())
            .unwrap()
            .series;
        let found = distances(&contour, &series, &Limits::none())
            .unwrap()
            .unwrap();
        assert!(found.hausdorff.high < 0.1);
        group.bench_with_input(BenchmarkId::new("radius", count), &contour, |b, contour| {
            b.iter(|| fit(black_box(contour), &options).unwrap());
        });
        group.bench_with_input(
            BenchmarkId::new("elliptic", count),
            &contour,
            |b, contour| {
                b.iter(|| fit_elliptic(black_box(contour), &options, &Limits::none()).unwrap());
            },
        );
    }
    group.finish();
}

/// Definition 1: a_n = 2/Ns Σ r_k cos nθ_k, and so on.
#[expect(clippy::cast_precision_loss, reason = "counts are small")]
fn as_printed(samples: &[f64], harmonics: usize) -> (Vec<f64>, Vec<f64>) {
    let count = samples.len() as f64;
    let sum = |n: usize, wave: fn(f64) -> f64| -> f64 {
        let terms = samples.iter().enumerate();
        let sum: f64 = terms
            .map(|(k, r)| r * wave(TAU * (n * k) as f64 / count))
            .sum();
        sum / count * if n == 0 { 1.0 } else { 2.0 }
    };
    let wave = |wave| (0..=harmonics).map(|n| sum(n, wave)).collect();
    (wave(f64::cos), wave(f64::sin))
}

fn definition_1(c: &mut Criterion) {
    let mut group = c.benchmark_group("definition_1");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    for harmonics in [10_usize, 100, 1000] {
        let count = u32::try_from(8 * harmonics).unwrap();
        let samples: Vec<f64> = (0..count)
            .map(|k| radius(TAU * f64::from(k) / f64::from(count)))
            .collect();
        let (fast, slow) = (
            fourier_coefficients(&samples, harmonics).unwrap(),
            as_printed(&samples, harmonics),
        );
        let apart = fast.0.iter().zip(&slow.0).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f64::max) < 1e-9);
        group.bench_with_input(BenchmarkId::new("stellate", harmonics), &samples, |b, s| {
            b.iter(|| fourier_coefficients(black_box(s), harmonics).unwrap());
        });
        group.bench_with_input(
            BenchmarkId::new("as_printed", harmonics),
            &samples,
            |b, s| {
                b.iter(|| as_printed(black_box(s), harmonics));
            },
        );
    }
    group.finish();
}

criterion_group!(benches, points, models, definition_1);
criterion_main!(benches);
