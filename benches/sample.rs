//! Certified sampling: real roots and rays, by degree and by bits, beside exact arithmetic alone.
//!
//! `cargo bench --bench sample`. Every answer is verified before it is timed: bounded arithmetic finds what exact arithmetic finds.

#![expect(clippy::unwrap_used, reason = "a bench fails by panicking")]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, SamplingMode, criterion_group, criterion_main};
use malachite::Integer;
use malachite::base::polynomial::Polynomial;
use stellate::exact::Rational;
use stellate::implicitize::SquaredForm;
use stellate::poly::{IntegerPolynomial, PlanePolynomial};
use stellate::roots::RealRoot;
use stellate::sample::{Direction, Ray, RaySolver};
use stellate::shape::FourierRadius;

#[path = "../tests/common/mod.rs"]
mod common;
use common::dense::rational;
use common::random::SplitMix;

const POLYNOMIALS: usize = 20;
const DIRECTIONS: usize = 36;

/// Random polynomials of one variable: all real roots, as their nearest doubles.
fn roots(c: &mut Criterion) {
    let mut group = c.benchmark_group("real_roots_of_20_polynomials");
    group.sampling_mode(SamplingMode::Flat).sample_size(20);
    for bits in [50, 200] {
        for degree in [2, 6, 20, 40, 80] {
            let mut random = SplitMix(degree);
            let mut polynomial = || {
                let c = (0..=degree).map(|_| random.integer(bits)).collect();
                rational(&IntegerPolynomial::from_coefficients_asc(c))
            };
            let all: Vec<_> = (0..POLYNOMIALS).map(|_| polynomial()).collect();
            let id = BenchmarkId::new(format!("{bits}_bits"), degree);
            group.bench_with_input(id, &all, |b, all| {
                b.iter(|| -> f64 {
                    let roots = all.iter().flat_map(|f| RealRoot::all_of(black_box(f)));
                    roots.map(|root| root.to_f64()).sum()
                });
            });
        }
    }
    // x^80 − (a x − 1)²: two roots about a^(−41) apart.
    let mut c = vec![Integer::from(0); 81];
    let a = Integer::from(33_554_393);
    c[80] = Integer::from(1);
    c[0] = Integer::from(-1);
    c[1] = &a + &a;
    c[2] = -(&a * &a);
    let close = rational(&IntegerPolynomial::from_coefficients_asc(c));
    assert_eq!(RealRoot::all_of(&close).len(), 4);
    group.bench_function("one_close_pair/80", |b| {
        b.iter(|| RealRoot::all_of(black_box(&close)).len());
    });
    // 2^100 T_80 + noise: all roots real.
    let x = IntegerPolynomial::from_coefficients_asc(vec![Integer::from(0), Integer::from(2)]);
    let one = IntegerPolynomial::from_coefficients_asc(vec![Integer::from(1)]);
    let (mut before, mut chebyshev) = (one.clone(), &x * &one);
    chebyshev = IntegerPolynomial::from_coefficients_asc(
        chebyshev
            .coefficients_asc()
            .iter()
            .map(|c| c / Integer::from(2))
            .collect(),
    );
    for _ in 1..80 {
        let next = &x * &chebyshev - &before;
        before = std::mem::replace(&mut chebyshev, next);
    }
    let mut random = SplitMix(7);
    let noisy = chebyshev.coefficients_asc().iter();
    let noisy = noisy.map(|c| (c << 100u64) + random.integer(60)).collect();
    let real = rational(&IntegerPolynomial::from_coefficients_asc(noisy));
    assert_eq!(RealRoot::all_of(&real).len(), 80);
    group.bench_function("all_real/80", |b| {
        b.iter(|| -> f64 {
            RealRoot::all_of(black_box(&real))
                .iter()
                .map(|r| r.to_f64())
                .sum()
        });
    });
    group.finish();
}

/// The implicit curve of a radius with `harmonics` harmonics, moved by (1/10, 1/20).
fn moved(harmonics: u32) -> PlanePolynomial {
    let mut random = SplitMix(1);
    let (mut cos, mut sin) = (vec![Rational::one()], vec![Rational::zero()]);
    for n in 1..=harmonics {
        let size = 0.2 / f64::from(n).powf(1.5);
        cos.push(Rational::try_from(random.double(size)).unwrap());
        sin.push(Rational::try_from(random.double(size)).unwrap());
    }
    let radius =
        FourierRadius::new(cos, sin).with_center(["1/10", "1/20"].map(|c| c.parse().unwrap()));
    let curve = SquaredForm::new(&radius).unwrap().expand();
    curve.in_original_coordinates().polynomial().clone()
}

fn check(f: &PlanePolynomial, directions: &[Direction]) {
    let solver = RaySolver::new(f);
    for direction in directions {
        assert_eq!(solver.solve(direction), solver.solve_exactly(direction));
    }
}

/// All points in 36 directions, the value of every form included.
fn rays(c: &mut Criterion) {
    let mut group = c.benchmark_group("points_in_36_directions");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    let directions = Direction::around(DIRECTIONS);
    let mut run = |name: &str, degree: usize, f: &PlanePolynomial, twin: bool| {
        check(f, &directions);
        let points = |ray: &Ray| match ray {
            Ray::Points(points) => points.len(),
            Ray::Line => 0,
        };
        group.bench_with_input(BenchmarkId::new(name, degree), f, |b, f| {
            let solver = RaySolver::new(f);
            b.iter(|| -> usize {
                let rays = directions.iter().map(|d| solver.solve(black_box(d)));
                rays.map(|ray| points(&ray)).sum()
            });
        });
        if twin {
            let id = BenchmarkId::new(format!("{name}_exact_alone"), degree);
            group.bench_with_input(id, f, |b, f| {
                let solver = RaySolver::new(f);
                b.iter(|| -> usize {
                    let rays = directions
                        .iter()
                        .map(|d| solver.solve_exactly(black_box(d)));
                    rays.map(|ray| points(&ray)).sum()
                });
            });
        }
    };
    for bits in [50, 200] {
        for degree in [2, 6, 20, 40, 80] {
            let f = SplitMix(degree as u64).dense(degree, bits);
            run(&format!("dense_{bits}_bits"), degree, &f, bits == 200);
        }
    }
    for harmonics in [9, 19, 39] {
        let f = moved(harmonics);
        run("moved_radius", 2 * harmonics as usize + 2, &f, true);
    }
    group.finish();
}

criterion_group!(benches, roots, rays);
criterion_main!(benches);
