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
use stellate::implicitize::{SquaredForm, SquaredHarmonics, implicitize_plane, square_away};
use stellate::limits::Limits;
use stellate::poly::{
    BinaryForm, PlanePolynomial, Ring, SparsePolynomial, doubled_form_from_harmonics,
};
use stellate::shape::{FourierRadius, HarmonicSurface};

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

/// A radius of degree L whose coefficients are doubles of all 53 bits; harmonics have sizes of about 0.3/l².
fn particle(degree: usize) -> HarmonicSurface {
    let mut random = SplitMix(0x9E37_79B9_7F4A_7C15);
    let mut terms = vec![((0, 0), Rational::one())];
    for l in 1..=degree {
        for m in 0..=l {
            let size = (1..=m).fold(0.3 / as_f64(l * l), |size, k| size / as_f64(l + k));
            for order in [m.cast_signed(), -m.cast_signed()]
                .into_iter()
                .take(1 + m.min(1))
            {
                terms.push(((l, order), Rational::try_from(random.double(size)).unwrap()));
            }
        }
    }
    HarmonicSurface::new(terms).unwrap()
}

fn as_f64(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap())
}

/// The naive twin: solid harmonics by their recurrence, and the formula of Theorem 2, on polynomials as sums of terms.
fn by_terms(surface: &HarmonicSurface) -> SparsePolynomial<3> {
    let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
    let rho = x.squared().plus(&y.squared()).plus(&z.squared());
    let power = |k: usize| {
        (0..k).fold(SparsePolynomial::constant(Rational::one()), |p, _| {
            p.times(&rho)
        })
    };
    let degree = surface.degree();
    let whole = |n: usize| Rational::from(i64::try_from(n).unwrap());
    let mut sums = [SparsePolynomial::zero(), SparsePolynomial::zero()];
    let mut flat = [
        SparsePolynomial::constant(Rational::one()),
        SparsePolynomial::zero(),
    ];
    for m in 0..=degree {
        for (start, order) in flat
            .iter()
            .zip([m.cast_signed(), -m.cast_signed()])
            .take(1 + m.min(1))
        {
            let (mut before, mut last) = (SparsePolynomial::zero(), start.clone());
            for l in m..=degree {
                let parity = (degree - l) % 2;
                let lifted = last.times(&power((degree - parity - l) / 2));
                sums[parity].add_multiple(&lifted, surface.coefficient(l, order));
                // (l − m + 1) S_(l+1) = (2l + 1) z S_l − (l + m) ρ S_(l−1)
                let up = z.times(&last).scaled(&whole(2 * l + 1));
                let down = rho.times(&before).scaled(&whole(l + m));
                let next = up.minus(&down).scaled(&whole(l - m + 1).recip().unwrap());
                before = std::mem::replace(&mut last, next);
            }
        }
        // (2m + 1) (x + iy) times the last
        let [re, im] = &flat;
        let factor = whole(2 * m + 1);
        flat = [
            x.times(re).minus(&y.times(im)).scaled(&factor),
            x.times(im).plus(&y.times(re)).scaled(&factor),
        ];
    }
    let [a, b] = sums;
    let f = if degree.is_multiple_of(2) {
        rho.times(&power(degree / 2).minus(&b).squared())
            .minus(&a.squared())
    } else {
        power(degree.div_ceil(2))
            .minus(&a)
            .squared()
            .minus(&rho.times(&b.squared()))
    };
    f.primitive()
}

fn in_space(c: &mut Criterion) {
    let mut group = c.benchmark_group("harmonics_to_implicit");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    for degree in [4, 8, 12, 26, 60] {
        let surface = particle(degree);
        let ours = SquaredHarmonics::new(&surface).unwrap().expand();
        // The sum of terms takes minutes for the largest degrees; there F vanishes at an exact point.
        let point: [Rational; 3] = ["2/3", "1/3", "-2/3"].map(|x| x.parse().unwrap());
        let form = SquaredHarmonics::new(&surface).unwrap();
        let r = form.pair().value(&point);
        let at = point.map(|x| &x * &r);
        assert!(ours.polynomial().evaluate(&at).is_zero());
        group.bench_with_input(BenchmarkId::new("stellate", degree), &surface, |b, s| {
            b.iter(|| SquaredHarmonics::new(black_box(s)).unwrap().expand());
        });
        if degree <= 12 {
            assert!(ours.polynomial().primitive() == by_terms(&surface));
            group.bench_with_input(BenchmarkId::new("by_terms", degree), &surface, |b, s| {
                b.iter(|| by_terms(black_box(s)));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, theorem2, in_space, writing, elimination);
criterion_main!(benches);
