//! Rational parameters → implicit: curves and patches, ladders over the degree and over the length of the coefficients,
//! beside linear algebra with the rational numbers of another crate: the polynomial that vanishes at enough points. Elliptic
//! Fourier series, beside PARI's resultant if the program gp is there.
//!
//! `cargo bench --bench implicitize`. Every answer is verified before it is timed.

#![expect(clippy::unwrap_used, reason = "a bench fails by panicking")]

use std::hint::black_box;
use std::io::{Read, Write};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use criterion::{BenchmarkId, Criterion, SamplingMode, criterion_group, criterion_main};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use stellate::implicitize::{implicitize_patch, implicitize_plane};
use stellate::limits::Limits;

#[path = "../tests/common/mod.rs"]
mod common;
use common::forms::{patch, plane, plane_curve};
use common::random::SplitMix;

/// Coordinates over a common denominator, polynomials Σ c u^i v^j of all degrees up to the given one.
struct Parametrization {
    /// (i, j) of each coefficient.
    exponents: Vec<[u32; 2]>,
    /// The numerators, then the denominator.
    coefficients: Vec<Vec<BigInt>>,
}

impl Parametrization {
    /// A curve in v, with coefficients of so many bits.
    fn curve(degree: u32, bits: u64) -> Self {
        Self::random((0..=degree).map(|j| [0, j]).collect(), 3, bits)
    }

    /// A patch in u and v.
    fn patch(degree: u32, bits: u64) -> Self {
        let exponents = (0..=degree).flat_map(|i| (0..=degree - i).map(move |j| [i, j]));
        Self::random(exponents.collect(), 4, bits)
    }

    fn random(exponents: Vec<[u32; 2]>, count: usize, bits: u64) -> Self {
        let mut random = SplitMix(exponents.len() as u64);
        let mut polynomial = || -> Vec<BigInt> {
            let integers = exponents.iter().map(|_| random.integer(bits));
            integers.map(|c| c.to_string().parse().unwrap()).collect()
        };
        let coefficients = (0..count).map(|_| polynomial()).collect();
        Self {
            exponents,
            coefficients,
        }
    }

    /// As it is typed.
    fn text(&self) -> String {
        let polynomial = |c: &Vec<BigInt>| {
            let terms = self.exponents.iter().zip(c);
            let terms = terms.map(|([i, j], c)| format!("({c})*u^{i}*v^{j}"));
            terms.collect::<Vec<_>>().join(" + ")
        };
        let (below, above) = self.coefficients.split_last().unwrap();
        let coordinates = ["x", "y", "z"].iter().zip(above);
        let coordinates = coordinates
            .map(|(name, c)| format!("{name} = ({})/({})", polynomial(c), polynomial(below)));
        coordinates
            .collect::<Vec<_>>()
            .join("; ")
            .replace("u^0*", "")
    }

    fn at(&self, u: i64, v: i64) -> Vec<BigRational> {
        let power = |exponent: &[u32; 2]| {
            BigInt::from(u).pow(exponent[0]) * BigInt::from(v).pow(exponent[1])
        };
        let value = |c: &Vec<BigInt>| -> BigInt {
            self.exponents
                .iter()
                .map(power)
                .zip(c)
                .map(|(x, c)| x * c)
                .sum()
        };
        let (below, above) = self.coefficients.split_last().unwrap();
        let below = value(below);
        above
            .iter()
            .map(|c| BigRational::new(value(c), below.clone()))
            .collect()
    }

    /// The monomials of degree at most d in x, y (and z) and the coefficients of their sum that vanishes at all points, the
    /// last one that is not 0 being 1: the first dependent column of Gauss's elimination.
    fn vanishing(&self, degree: u32) -> Vec<(Vec<u32>, BigRational)> {
        let monomials = monomials(self.coefficients.len() - 1, degree);
        let mut rows: Vec<Vec<BigRational>> = Vec::new();
        let mut pivots: Vec<usize> = Vec::new();
        // More points than monomials, on no curve of low degree.
        for k in 1..=i64::try_from(monomials.len()).unwrap() + 2 {
            let point = self.at((17 * k * k * k + 5 * k) % 31 - 15, k);
            let monomial = |e: &Vec<u32>| -> BigRational {
                e.iter()
                    .zip(&point)
                    .map(|(e, x)| num_traits::pow(x.clone(), *e as usize))
                    .product()
            };
            let mut row: Vec<BigRational> = monomials.iter().map(monomial).collect();
            for (above, pivot) in rows.iter().zip(&pivots) {
                let factor = row[*pivot].clone();
                subtract(&mut row, above, &factor);
            }
            if let Some(pivot) = row.iter().position(|c| !c.is_zero()) {
                let inverse = row[pivot].recip();
                row.iter_mut().for_each(|c| *c *= &inverse);
                for above in &mut rows {
                    let factor = above[pivot].clone();
                    subtract(above, &row, &factor);
                }
                rows.push(row);
                pivots.push(pivot);
            }
        }
        let free = (0..monomials.len()).find(|k| !pivots.contains(k)).unwrap();
        let dependent = rows
            .iter()
            .zip(&pivots)
            .map(|(row, pivot)| (*pivot, -row[free].clone()));
        let coefficients = dependent.chain([(free, BigRational::one())]);
        let coefficients = coefficients.filter(|(_, c)| !c.is_zero());
        coefficients
            .map(|(k, c)| (monomials[k].clone(), c))
            .collect()
    }
}

/// `row −= factor · other`
fn subtract(row: &mut [BigRational], other: &[BigRational], factor: &BigRational) {
    if !factor.is_zero() {
        row.iter_mut()
            .zip(other)
            .for_each(|(a, b)| *a -= factor * b);
    }
}

fn monomials(variables: usize, degree: u32) -> Vec<Vec<u32>> {
    if variables == 0 {
        return vec![Vec::new()];
    }
    let with_first = |e: u32| {
        let rest = monomials(variables - 1, degree - e);
        rest.into_iter().map(move |rest| [vec![e], rest].concat())
    };
    (0..=degree).flat_map(with_first).collect()
}

/// Ours, of these terms with monic coefficients, is the one that vanishes at the points.
fn verify(ours: Vec<(Vec<u32>, String)>, naive: &[(Vec<u32>, BigRational)]) {
    let last = |terms: &[(Vec<u32>, BigRational)]| {
        terms
            .iter()
            .max_by_key(|(e, _)| e.clone())
            .unwrap()
            .1
            .clone()
    };
    let ours: Vec<_> = ours
        .into_iter()
        .map(|(e, c)| (e, c.parse::<BigRational>().unwrap()))
        .collect();
    let (one, other) = (last(&ours), last(naive));
    let scaled = |terms: &[(Vec<u32>, BigRational)], by: &BigRational| {
        let mut terms: Vec<_> = terms.iter().map(|(e, c)| (e.clone(), c / by)).collect();
        terms.sort();
        terms
    };
    assert_eq!(scaled(&ours, &one), scaled(naive, &other));
}

fn curves(c: &mut Criterion) {
    let mut group = c.benchmark_group("implicitize_curve");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    for (degree, bits) in [
        (2, 8),
        (4, 8),
        (6, 8),
        (8, 8),
        (12, 8),
        (16, 8),
        (6, 64),
        (6, 256),
    ] {
        let parametrization = Parametrization::curve(degree, bits);
        let curve = plane_curve(&parametrization.text().replace('v', "t"));
        let found = implicitize_plane(&curve, &Limits::none()).unwrap().curve;
        assert_eq!(found.polynomial().degree(), Some(degree as usize));
        let name = format!("degree {degree}, {bits} bits");
        if degree <= 6 && bits == 8 {
            let terms = found.polynomial().terms();
            let exponent = |e: usize| u32::try_from(e).unwrap();
            let terms = terms.map(|((i, j), c)| (vec![exponent(i), exponent(j)], c.to_string()));
            verify(terms.collect(), &parametrization.vanishing(degree));
            group.bench_with_input(
                BenchmarkId::new("linear_algebra", &name),
                &parametrization,
                |b, p| {
                    b.iter(|| black_box(p).vanishing(degree));
                },
            );
        }
        group.bench_with_input(BenchmarkId::new("stellate", &name), &curve, |b, curve| {
            b.iter(|| implicitize_plane(black_box(curve), &Limits::none()).unwrap());
        });
    }
    group.finish();
}

fn patches(c: &mut Criterion) {
    let mut group = c.benchmark_group("implicitize_patch");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    for (degree, bits) in [(1, 8), (2, 8), (3, 8), (2, 64)] {
        let parametrization = Parametrization::patch(degree, bits);
        let form = patch(&parametrization.text());
        let found = implicitize_patch(&form, &Limits::none()).unwrap().surface;
        // Steiner's surface for quadrics.
        let expected = degree * degree;
        assert_eq!(found.polynomial().degree(), Some(u64::from(expected)));
        let name = format!("degree {expected}, {bits} bits");
        if expected <= 4 && bits == 8 {
            let terms = found.polynomial().terms();
            let terms = terms.map(|(e, c)| (e.to_vec(), c.to_string()));
            verify(terms.collect(), &parametrization.vanishing(expected));
            group.bench_with_input(
                BenchmarkId::new("linear_algebra", &name),
                &parametrization,
                |b, p| {
                    b.iter(|| black_box(p).vanishing(expected));
                },
            );
        }
        group.bench_with_input(BenchmarkId::new("stellate", &name), &form, |b, form| {
            b.iter(|| implicitize_patch(black_box(form), &Limits::none()).unwrap());
        });
    }
    group.finish();
}

/// Elliptic series whose N-th harmonics have numbers of four decimals up to 1/N.
struct Series {
    /// The coefficients of x by cosines and sines, then of y, times 10 000.
    lists: [Vec<i64>; 4],
}

impl Series {
    fn new(harmonics: i64) -> Self {
        let mut random = SplitMix(7);
        let mut number = |k: i64| i64::try_from(&random.integer(13)).unwrap() / k;
        let lists = std::array::from_fn(|i| {
            let constant = if i % 2 == 0 { number(1) } else { 0 };
            let waves = (1..=harmonics).map(&mut number);
            [constant].into_iter().chain(waves).collect()
        });
        Self { lists }
    }

    /// As it is typed.
    fn text(&self) -> String {
        let coordinate = |cos: &[i64], sin: &[i64]| {
            let waves = cos.iter().zip(sin).enumerate();
            let waves =
                waves.map(|(k, (a, b))| format!("{a}/10000*cos({k}*t) + {b}/10000*sin({k}*t)"));
            waves.collect::<Vec<_>>().join(" + ").replace("+ -", "- ")
        };
        let [a, b, c, d] = &self.lists;
        format!("x = {}; y = {}", coordinate(a, b), coordinate(c, d))
    }

    /// A script for PARI/GP: the resultant with respect to s = tan(t/2), its time in milliseconds, and the primitive polynomial.
    fn script(&self) -> String {
        let [a, b, c, d] = &self.lists;
        let degree = a.len() - 1;
        format!(
            "default(nbthreads, 1);
            default(parisizemax, 4*10^9);
            n = {degree};
            form(a, b) = sum(k = 0, n, (a[k+1]*real((1+I*s)^(2*k)) + b[k+1]*imag((1+I*s)^(2*k)))*(1+s^2)^(n-k));
            first = 10000*x*(1+s^2)^n - form({a:?}, {b:?}); second = 10000*y*(1+s^2)^n - form({c:?}, {d:?});
            start = getwalltime(); found = polresultant(first, second, s); print(getwalltime() - start);
            print(found/content(found));"
        )
        .lines()
        .map(|line| line.trim().to_owned() + "\n")
        .collect()
    }
}

/// The longest time of one run of another program.
const PATIENCE: Duration = Duration::from_secs(30);

/// The milliseconds and the answer of PARI/GP; `None` if it takes too long or is not there.
fn run_gp(script: &str) -> Option<(f64, String)> {
    let mut program = Command::new("gp")
        .args(["-q", "-f"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .ok()?;
    program.stdin.take()?.write_all(script.as_bytes()).ok()?;
    let mut output = program.stdout.take()?;
    let reader = std::thread::spawn(move || {
        let mut text = String::new();
        output.read_to_string(&mut text).map(|_| text)
    });
    let start = Instant::now();
    while !reader.is_finished() && start.elapsed() < PATIENCE {
        std::thread::sleep(Duration::from_millis(5));
    }
    if !reader.is_finished() {
        program.kill().ok()?;
    }
    program.wait().ok()?;
    let text = reader.join().ok()?.ok()?;
    let (time, answer) = text.split_once('\n')?;
    Some((time.trim().parse().ok()?, answer.to_owned()))
}

/// Elliptic series → equation, and beside it PARI's resultant in the same run, both on one thread.
fn series(c: &mut Criterion) {
    let mut group = c.benchmark_group("implicitize_series");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    let is_there = Command::new("gp").arg("--version-short").output().is_ok();
    if !is_there {
        eprintln!("PARI is skipped: there is no program gp");
    }
    let mut is_patient = is_there;
    let single = rayon::ThreadPoolBuilder::new().num_threads(1);
    let single = single.build().unwrap();
    for harmonics in [4, 10, 16, 24] {
        let series = Series::new(harmonics);
        let curve = plane_curve(&series.text());
        let find = || implicitize_plane(black_box(&curve), &Limits::none()).unwrap();
        let start = Instant::now();
        let found = single.install(find).curve;
        let ours = start.elapsed().as_secs_f64();
        assert_eq!(
            found.polynomial().degree(),
            usize::try_from(2 * harmonics).ok()
        );
        if is_patient {
            let answer = run_gp(&series.script());
            is_patient = answer.is_some();
            match answer {
                Some((milliseconds, answer)) => {
                    assert_eq!(found.polynomial().primitive(), plane(&answer));
                    let theirs = milliseconds / 1000.0;
                    let ratio = theirs / ours;
                    eprintln!(
                        "N = {harmonics}: stellate {ours:.4} s, PARI {theirs:.3} s, ratio {ratio:.0}"
                    );
                }
                None => eprintln!("N = {harmonics}: PARI is stopped after {PATIENCE:?}"),
            }
        }
        let name = format!("{harmonics} harmonics");
        group.bench_function(BenchmarkId::new("stellate", name), |b| b.iter(find));
    }
    group.finish();
}

criterion_group!(benches, curves, patches, series);
criterion_main!(benches);
