//! Fourier → implicit (Theorem 2): the ladder over N, beside the formulas on forms with coefficients of any size, the
//! naive formula, and general elimination, the comparison that the paper did not make; and writing the result.
//!
//! `cargo bench --bench theorem2`. Every answer is verified before it is timed.

#![expect(clippy::unwrap_used, reason = "a bench fails by panicking")]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, SamplingMode, criterion_group, criterion_main};
use malachite::Integer;
use mimalloc::MiMalloc;
use stellate::document::{Format, write_implicit};
use stellate::exact::Rational;
use stellate::implicitize::{SquaredForm, implicitize_plane, square_away};
use stellate::limits::Limits;
use stellate::poly::{BinaryForm, PlanePolynomial, doubled_form_from_harmonics};
use stellate::shape::FourierRadius;

/// As in the program.
#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

#[path = "../tests/common/mod.rs"]
mod common;
use common::oracle_theorem_2::theorem_2 as theorem_2_oracle;
use common::random::SplitMix;
use common::value_at;

/// Coefficients that are doubles of all 53 bits, of size about 0.3/n, a0 = 1: reproducible.
fn spectrum(harmonics: u32) -> FourierRadius {
    let mut random = SplitMix(0x9E37_79B9_7F4A_7C15);
    let mut double = |size: f64| Rational::try_from(random.double(size)).unwrap();
    let (mut cos, mut sin) = (vec![Rational::one()], vec![Rational::zero()]);
    for n in 1..=harmonics {
        cos.push(double(0.3 / f64::from(n)));
        sin.push(double(0.3 / f64::from(n)));
    }
    FourierRadius::new(cos, sin)
}

/// F vanishes at r(θ)(c, s) for a rational point (c, s) of the circle.
fn verify(radius: &FourierRadius) {
    let f = SquaredForm::new(radius).unwrap().expand();
    let (c, s) = ("3/5".parse().unwrap(), "4/5".parse().unwrap());
    let r = value_at(radius, &c, &s);
    assert!(f.polynomial().evaluate(&(&r * &c), &(&r * &s)).is_zero());
}

/// The slow twin: the same formulas on forms with coefficients of any size, then the primitive part.
fn on_forms(radius: &FourierRadius) -> PlanePolynomial {
    let n = radius.harmonics();
    let (denominator, cos, sin) = radius.over_common_denominator();
    let sum = |parity: usize| {
        let degree = if n % 2 == parity { n } else { n - 1 };
        let harmonics = (parity..=degree).step_by(2).map(|m| (m, &cos[m], &sin[m]));
        doubled_form_from_harmonics(degree, harmonics)
    };
    let unit = BinaryForm::from_coefficients(vec![denominator << 1u64]);
    let parts = square_away(n, &unit, BinaryForm::rho_power, Some(&sum(1)), &sum(0));
    let minus_middle = parts.middle.map(|m| m.scaled(&Integer::from(-1)));
    let parts = [Some(parts.top), minus_middle, Some(parts.low)];
    parts
        .into_iter()
        .flatten()
        .collect::<PlanePolynomial>()
        .primitive()
}

fn theorem2(c: &mut Criterion) {
    let mut group = c.benchmark_group("fourier_to_implicit");
    group.sampling_mode(SamplingMode::Flat).sample_size(20);
    for n in [3, 10, 39, 100, 300, 1000, 3000] {
        let radius = spectrum(n);
        // A point with a coordinate of thousands of digits, to powers of thousands, is slow; the twin is quick.
        if n <= 300 {
            verify(&radius);
        } else {
            group.sample_size(10);
        }
        let ours = SquaredForm::new(&radius).unwrap().expand();
        assert!(*ours.polynomial() == on_forms(&radius));
        group.bench_with_input(BenchmarkId::new("stellate", n), &radius, |b, r| {
            b.iter(|| SquaredForm::new(black_box(r)).unwrap().expand());
        });
        group.bench_with_input(BenchmarkId::new("on_forms", n), &radius, |b, r| {
            b.iter(|| on_forms(black_box(r)));
        });
    }
    for n in [3, 10, 39] {
        let radius = spectrum(n);
        let ours = SquaredForm::new(&radius).unwrap().expand();
        let naive = theorem_2_oracle(&radius);
        assert_eq!(ours.polynomial().monic().terms().count(), naive.len());
        group.bench_with_input(BenchmarkId::new("naive", n), &radius, |b, r| {
            b.iter(|| theorem_2_oracle(black_box(r)));
        });
    }
    group.finish();
}

/// The result as text and as JSON: about as many bytes as bits of the coefficients times 0.3.
fn writing(c: &mut Criterion) {
    let mut group = c.benchmark_group("write_implicit");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    for n in [100, 300, 1000, 3000] {
        let curve = SquaredForm::new(&spectrum(n)).unwrap().expand();
        for format in [Format::Text, Format::Json] {
            let id = BenchmarkId::new(format.to_string(), n);
            group.bench_with_input(id, &curve, |b, curve| {
                b.iter(|| write_implicit(curve, &[], format, &mut std::io::sink()).unwrap());
            });
        }
    }
    group.finish();
}

/// Theorem 2 against the resultant of x(t) and y(t), N = 1 … 12.
fn elimination(c: &mut Criterion) {
    let mut group = c.benchmark_group("theorem_2_against_elimination");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    for n in 1..=12 {
        let radius = spectrum(n);
        let curve = radius.to_plane_curve();
        let ours = SquaredForm::new(&radius).unwrap().expand();
        let eliminated = implicitize_plane(&curve, &Limits::none()).unwrap();
        assert_eq!(ours, eliminated.curve);
        group.bench_with_input(BenchmarkId::new("theorem_2", n), &radius, |b, r| {
            b.iter(|| SquaredForm::new(black_box(r)).unwrap().expand());
        });
        group.bench_with_input(BenchmarkId::new("resultant", n), &curve, |b, curve| {
            b.iter(|| implicitize_plane(black_box(curve), &Limits::none()).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, theorem2, writing, elimination);
criterion_main!(benches);
