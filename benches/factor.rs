//! Factorization over Q: Example 8, and ladders over the degree, the number of factors and the length of the
//! coefficients, beside Kronecker's substitution, which makes everything univariate.
//!
//! `cargo bench --bench factor`. Every answer is verified before it is timed.

#![expect(clippy::unwrap_used, reason = "a bench fails by panicking")]

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, SamplingMode, criterion_group, criterion_main};
use malachite::Integer;
use malachite::base::polynomial::Polynomial;
use stellate::exact::{Rational, integer_from_num, integer_to_num};
use stellate::factor::{factor_plane, factor_univariate};
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::poly::{IntegerPolynomial, PlanePolynomial};
use stellate::shape::Form;

#[path = "../tests/common/mod.rs"]
mod common;
use common::dense::{integral, rational};
use common::random::SplitMix;

fn product(count: usize, degree: usize, bits: u64) -> PlanePolynomial {
    let mut random = SplitMix((count * 1000 + degree) as u64);
    let factors: Vec<_> = (0..count).map(|_| random.dense(degree, bits)).collect();
    let f = factors[1..].iter().fold(factors[0].clone(), |f, g| &f * g);
    // As many as were multiplied: all irreducible.
    let found = factor_plane(&f, &Limits::none()).unwrap();
    assert_eq!(found.factors.len(), count);
    for g in &factors {
        assert!(found.factors.iter().any(|h| h.polynomial == g.primitive()));
    }
    f
}

/// The factors of `f(x, x^D)`, D above the degree in x, put together again.
fn by_kronecker(f: &PlanePolynomial) -> Vec<PlanePolynomial> {
    let f = f.primitive();
    let stride = f.terms().map(|((i, _), _)| i).max().unwrap_or(0) + 1;
    let mut packed = vec![Integer::from(0); stride * stride];
    for ((i, j), c) in f.terms() {
        packed[i + j * stride] = integer_from_num(&c.numer());
    }
    let packed = IntegerPolynomial::from_coefficients_asc(packed);
    let found = factor_univariate(&rational(&packed), &Limits::none()).unwrap();
    let mut local: Vec<IntegerPolynomial> = found
        .factors
        .iter()
        .flat_map(|g| std::iter::repeat_n(integral(&g.polynomial), g.multiplicity))
        .collect();
    let unpacked = |chosen: &[&IntegerPolynomial]| {
        let product = chosen.iter().fold(IntegerPolynomial::one(), |p, g| p * *g);
        let terms = product.coefficients_asc().iter().enumerate();
        let terms =
            terms.map(|(k, c)| ((k % stride, k / stride), Rational::from(integer_to_num(c))));
        PlanePolynomial::from_terms(terms).primitive()
    };
    let mut factors = Vec::new();
    let mut size = 1;
    while 2 * size <= local.len() {
        let masks = (1u64..1 << local.len()).filter(|m| m.count_ones() as usize == size);
        let accepted = masks.into_iter().find_map(|mask| {
            let is_in = |k: usize| mask >> k & 1 == 1;
            let part = |wanted: bool| -> PlanePolynomial {
                let some = local.iter().enumerate();
                let some = some.filter(|(k, _)| is_in(*k) == wanted).map(|(_, g)| g);
                unpacked(&some.collect::<Vec<_>>())
            };
            let (factor, rest) = (part(true), part(false));
            let whole = unpacked(&local.iter().collect::<Vec<_>>());
            ((&factor * &rest).primitive() == whole).then_some((mask, factor))
        });
        match accepted {
            Some((mask, factor)) => {
                factors.push(factor);
                let mut k = 0;
                local.retain(|_| {
                    k += 1;
                    mask >> (k - 1) & 1 == 0
                });
            }
            None => size += 1,
        }
    }
    factors.push(unpacked(&local.iter().collect::<Vec<_>>()));
    factors
}

/// ∏ (x ± √2 ± √3 ± √5 …) over the first primes: irreducible, and split into linear and quadratic factors modulo every one.
fn swinnerton_dyer(primes: &[i64]) -> IntegerPolynomial {
    // With f(x + √p) = u + v√p, f(x + √p) f(x − √p) = u² − p v².
    primes.iter().fold(
        IntegerPolynomial::from_coefficients_asc(vec![0.into(), 1.into()]),
        |f, p| {
            let integers = |c: &[i64]| {
                IntegerPolynomial::from_coefficients_asc(
                    c.iter().map(|&c| Integer::from(c)).collect(),
                )
            };
            let (mut u, mut v) = (integers(&[]), integers(&[]));
            for c in f.coefficients_asc().iter().rev() {
                // (u + v√p)(x + √p) + c
                let x = integers(&[0, 1]);
                let next = &u * &x
                    + &v * integers(&[*p])
                    + IntegerPolynomial::from_coefficients_asc(vec![c.clone()]);
                v = &v * &x + &u;
                u = next;
            }
            &u * &u - &v * &v * integers(&[*p])
        },
    )
}

fn factorization(c: &mut Criterion) {
    let limits = Limits::none();
    let mut group = c.benchmark_group("factor");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    group.warm_up_time(Duration::from_millis(500));
    group.measurement_time(Duration::from_secs(2));

    let text = "(x^4 - 19/10*x^2*y^2 + y^4 - 1/2)*(x^8 + y^8 - 1/100000)*x^10*y^10";
    let Form::Curve(curve) = parse_form(text, "<form>", Numbers::Exact).unwrap() else {
        panic!("{text}")
    };
    let f = curve.polynomial();
    let degrees: Vec<_> = factor_plane(f, &limits).unwrap().factors;
    let degrees: Vec<_> = degrees
        .iter()
        .map(|g| (g.polynomial.degree().unwrap(), g.multiplicity))
        .collect();
    assert_eq!(degrees, [(1, 10), (1, 10), (4, 1), (8, 1)]);
    group.bench_with_input(BenchmarkId::new("example_8", 32), f, |b, f| {
        b.iter(|| factor_plane(black_box(f), &limits).unwrap());
    });

    for (name, count, degree, bits) in [
        ("degree_of_two_factors", 2, 3, 8),
        ("degree_of_two_factors", 2, 5, 8),
        ("degree_of_two_factors", 2, 10, 8),
        ("degree_of_two_factors", 2, 20, 8),
        ("factors_of_degree_5", 4, 5, 8),
        ("factors_of_degree_5", 8, 5, 8),
        ("bits_in_degree_10", 2, 10, 100),
        ("bits_in_degree_10", 2, 10, 1000),
    ] {
        let f = product(count, degree, bits);
        let at = match name {
            "factors_of_degree_5" => count,
            "bits_in_degree_10" => usize::try_from(bits).unwrap(),
            _ => degree,
        };
        group.bench_with_input(BenchmarkId::new(name, at), &f, |b, f| {
            b.iter(|| factor_plane(black_box(f), &limits).unwrap());
        });
        // Slower and slower: from here on it takes seconds.
        if count == 2 && degree <= 5 {
            assert_eq!(by_kronecker(&f).len(), count);
            group.bench_with_input(BenchmarkId::new("naive_two_factors", at), &f, |b, f| {
                b.iter(|| by_kronecker(black_box(f)));
            });
        }
    }

    for count in [3, 4, 5] {
        let f = swinnerton_dyer(&[2, 3, 5, 7, 11][..count]);
        let f = rational(&f);
        assert_eq!(factor_univariate(&f, &limits).unwrap().factors.len(), 1);
        let degree = f.len() - 1;
        group.bench_with_input(BenchmarkId::new("swinnerton_dyer", degree), &f, |b, f| {
            b.iter(|| factor_univariate(black_box(f), &limits).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, factorization);
criterion_main!(benches);
