//! Inspection (Theorem 8): points per second on surfaces of growing degree and on Fourier curves, beside the exact arithmetic that
//! doubles save.
//!
//! `cargo bench --bench inspect`. Every answer is verified before it is timed.

#![expect(clippy::unwrap_used, reason = "a bench fails by panicking")]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use stellate::exact::Rational;
use stellate::fit::{ContourKind, FitOptions, FitSize, contour_from_reader, fit, fit_elliptic};
use stellate::inspect::{
    CurveInspector, HarmonicInspector, Inspector, InspectorOptions, SphereSection, Verdict,
};
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::shape::{Form, HarmonicPair, HarmonicSurface, ImplicitSurface};

const POINTS: u32 = 1000;

fn surface(degree: u32) -> ImplicitSurface {
    let text = format!("x^{degree} + y^{degree} + z^{degree} = 1");
    let Form::Surface(surface) = parse_form(&text, "<form>", Numbers::Exact).unwrap() else {
        panic!("{text}")
    };
    surface
}

/// Points within 0.02 of the surface along rays.
fn points(degree: u32) -> Vec<[f64; 3]> {
    let power = f64::from(degree);
    let at = |k: u32| {
        let (height, turn) = (
            1.0 - (2.0 * f64::from(k) + 1.0) / f64::from(POINTS),
            2.4 * f64::from(k),
        );
        let flat = (1.0 - height * height).sqrt();
        let v = [flat * turn.cos(), flat * turn.sin(), height];
        let radius = v
            .iter()
            .map(|x| x.abs().powf(power))
            .sum::<f64>()
            .powf(-1.0 / power);
        let off = 0.02 * (7.3 * f64::from(k) + 1.0).sin();
        v.map(|x| x * (radius + off))
    };
    (0..POINTS).map(at).collect()
}

fn inspector(degree: u32) -> Inspector {
    let options = InspectorOptions::new("1/100".parse().unwrap());
    Inspector::surface(&surface(degree), &options, &Limits::none()).unwrap()
}

fn exactly(p: [f64; 3]) -> [Rational; 3] {
    p.map(|x| Rational::try_from(x).unwrap())
}

/// The verdict is that of the criterion, decided by exact arithmetic alone, for some of the points.
fn verify(degree: u32) {
    let (inspector, surface) = (inspector(degree), surface(degree));
    for p in points(degree).into_iter().step_by(100) {
        let found = inspector.inspect(&exactly(p));
        assert!(found.verdict != Verdict::Undecided);
        if degree <= 4 {
            let d = "1/100".parse().unwrap();
            let section = SphereSection::new(surface.polynomial(), &exactly(p), &d);
            assert_eq!(
                found.curve,
                Some(section.has_points(&Limits::none()).unwrap())
            );
        }
    }
}

fn inspect(c: &mut Criterion) {
    let mut group = c.benchmark_group("inspect");
    group.sample_size(20);
    for degree in [2, 4, 6, 8, 12] {
        verify(degree);
        let (inspector, points) = (inspector(degree), points(degree));
        group.throughput(Throughput::Elements(u64::from(POINTS)));
        group.bench_function(BenchmarkId::new("doubles_first", degree), |b| {
            b.iter(|| {
                let inside = points.iter().filter(|p| {
                    let found = inspector.inspect_near(black_box(**p), &|| exactly(**p));
                    found.verdict == Verdict::Inside
                });
                inside.count()
            });
        });
    }
    // The same question by exact arithmetic alone.
    group.sample_size(10).throughput(Throughput::Elements(1));
    for degree in [2, 4] {
        let (surface, d) = (surface(degree), "1/100".parse().unwrap());
        let p = exactly(points(degree)[10]);
        group.bench_function(BenchmarkId::new("exact_section", degree), |b| {
            b.iter(|| {
                SphereSection::new(surface.polynomial(), black_box(&p), &d)
                    .has_points(&Limits::none())
                    .unwrap()
            });
        });
    }
    group.finish();
}

/// The butterfly with 39 harmonics, by its radius and by its coordinates.
fn butterflies(options: &InspectorOptions) -> [(&'static str, CurveInspector<2>); 2] {
    let file = std::fs::File::open("paper-examples/e02-butterfly/butterfly.csv").unwrap();
    let contour = contour_from_reader(file, ContourKind::Rows, "butterfly").unwrap();
    let size = FitOptions::new(FitSize::Harmonics(39));
    let limits = Limits::none();
    let radius = fit(&contour, &size).unwrap().radius;
    let elliptic = fit_elliptic(&contour, &size, &limits).unwrap().series;
    let radius = CurveInspector::radius(&radius, options, &limits).unwrap();
    let elliptic = CurveInspector::new(&elliptic.to_plane_curve(), options, &limits).unwrap();
    [("radius", radius), ("elliptic", elliptic)]
}

/// A butterfly is about 2000 by 1300 in size. Verdicts need no digits.
fn curves(c: &mut Criterion) {
    let mut group = c.benchmark_group("inspect_butterfly");
    let options = |digits: u32| InspectorOptions::new(5.into()).digits(digits);
    let points: Vec<[f64; 2]> = (0..POINTS)
        .map(|k| {
            let t = 2.4 * f64::from(k);
            let r = f64::from(k + 1) / f64::from(POINTS);
            [1050.0 + 1200.0 * r * t.cos(), 620.0 + 800.0 * r * t.sin()]
        })
        .collect();
    let exactly = |p: [f64; 2]| p.map(|x| Rational::try_from(x).unwrap());
    for digits in [0, 6] {
        for (name, inspector) in butterflies(&options(digits)) {
            for p in points.iter().step_by(50) {
                let found = inspector.inspect_near(*p, &|| exactly(*p));
                let counted = inspector.inspect_by_counts(&exactly(*p));
                assert_eq!(
                    (found.verdict, found.curve),
                    (counted.verdict, counted.curve)
                );
                assert!(found.distance.low <= counted.distance.high);
                assert!(counted.distance.low <= found.distance.high);
            }
            group.sample_size(20);
            group.throughput(Throughput::Elements(u64::from(POINTS)));
            group.bench_function(BenchmarkId::new(format!("{name}_by_arcs"), digits), |b| {
                b.iter(|| {
                    let inside = points.iter().filter(|p| {
                        let found = inspector.inspect_near(black_box(**p), &|| exactly(**p));
                        found.verdict == Verdict::Inside
                    });
                    inside.count()
                });
            });
            // The same question by exact counts of real roots.
            group.sample_size(10).throughput(Throughput::Elements(1));
            let p = exactly(points[400]);
            group.bench_function(BenchmarkId::new(format!("{name}_by_counts"), digits), |b| {
                b.iter(|| inspector.inspect_by_counts(black_box(&p)));
            });
        }
    }
    group.finish();
}

/// Points near a harmonic surface of degree L with a coefficient for every harmonic.
fn harmonics(c: &mut Criterion) {
    let mut group = c.benchmark_group("inspect_harmonics");
    group.throughput(Throughput::Elements(u64::from(POINTS)));
    for degree in [10usize, 20] {
        let mut terms = vec![((0, 0), Rational::from(10))];
        for l in 1..=degree {
            for m in -l.cast_signed()..=l.cast_signed() {
                let c = (7 * l.cast_signed() + 5 * m).rem_euclid(11) - 5;
                let size = (1..=m.unsigned_abs()).fold(Rational::from(10), |size, k| {
                    size * Rational::from(i64::try_from(l + k).unwrap())
                });
                let c = Rational::from(i64::try_from(c).unwrap());
                terms.push((
                    (l, m),
                    c / (size * Rational::from(i64::try_from(l).unwrap())),
                ));
            }
        }
        let surface = HarmonicSurface::new(terms).unwrap();
        let options = InspectorOptions::new("3/10".parse().unwrap());
        let inspector = HarmonicInspector::new(&surface, true, &options, &Limits::none()).unwrap();
        let pair = HarmonicPair::new(&surface);
        let points: Vec<[f64; 3]> = (0..POINTS)
            .map(|k| {
                let (p, q) = (i64::from(k % 40) - 20, i64::from(k / 40) - 12);
                let n = Rational::from(p * p + q * q + 100);
                let unit = [20 * p, 20 * q, p * p + q * q - 100].map(|x| Rational::from(x) / &n);
                let r = pair.value(&unit).to_f64() + (7.3 * f64::from(k)).sin();
                unit.map(|x| x.to_f64() * r)
            })
            .collect();
        let inspect = |p: &[f64; 3]| {
            inspector.inspect_near(*p, &|| p.map(|x| Rational::try_from(x).unwrap()))
        };
        for p in &points {
            let found = inspect(p);
            assert!(found.verdict != Verdict::Undecided && found.curve.is_some());
        }
        group.bench_with_input(
            BenchmarkId::new("stellate", degree),
            &points,
            |b, points| {
                b.iter(|| {
                    points
                        .iter()
                        .map(|p| inspect(black_box(p)))
                        .collect::<Vec<_>>()
                });
            },
        );
    }
    group.finish();
}

criterion_group!(benches, inspect, curves, harmonics);
criterion_main!(benches);
