//! The laws of the isolation of real roots: bounds of errors, polynomials with known roots, and Sturm's theorem.

use super::*;
use crate::exact::Rational;
use crate::roots::{RealRoot, real_roots};
use malachite::base::num::arithmetic::traits::Pow;
use proptest::prelude::*;

fn poly(c: &[i64]) -> IntegerPolynomial {
    IntegerPolynomial::from_coefficients_asc(c.iter().map(|&c| Integer::from(c)).collect())
}

fn check(roots: &[RealRoot], expected: &[f64]) {
    let got: Vec<f64> = roots.iter().map(RealRoot::to_f64).collect();
    assert_eq!(got, expected);
}

#[test]
fn roots_at_dyadic_points_and_beside_them() {
    check(&real_roots(&poly(&[-1, 0, 1])), &[-1.0, 1.0]);
    check(&real_roots(&poly(&[1, 0, 1])), &[]);
    check(&real_roots(&poly(&[0, -1, 3])), &[0.0, 1.0 / 3.0]);
    let five: Vec<f64> = (1..=20).map(f64::from).collect();
    let wilkinson = (1..=20).fold(poly(&[1]), |f, k| f * poly(&[-k, 1]));
    check(&real_roots(&wilkinson), &five);
}

/// If some signs are unknown, a number of changes is certain if it is the same for all choices of these signs.
#[test]
fn changes_are_counted_for_all_unknown_signs() {
    let changes = |signs: &[i8]| {
        let signs: Vec<_> = signs.iter().filter(|sign| **sign != 0).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    };
    for length in 0..7u32 {
        for code in 0..3u32.pow(length) {
            let known: Vec<_> = (0..length)
                .map(|k| [None, Some(-1), Some(1)][(code / 3u32.pow(k) % 3) as usize])
                .collect();
            let unknown = known.iter().filter(|sign| sign.is_none()).count();
            let counts = (0..3usize.pow(u32::try_from(unknown).unwrap())).map(|mut choice| {
                let signs: Vec<i8> = known
                    .iter()
                    .map(|sign| {
                        sign.unwrap_or_else(|| {
                            let any = [-1, 0, 1][choice % 3];
                            choice /= 3;
                            any
                        })
                    })
                    .collect();
                changes(&signs)
            });
            let counts: Vec<_> = counts.collect();
            let all = |n: usize| counts.iter().all(|count| *count == n);
            match Changes::count(known.iter().copied()) {
                Changes::None => assert!(all(0), "{known:?}"),
                Changes::One => assert!(all(1), "{known:?}"),
                // `More` is not returned without a reason: some sign is unknown, or there is more than one change.
                Changes::More => assert!(unknown > 0 || counts[0] > 1, "{known:?}"),
            }
        }
    }
}

#[test]
fn mignotte_pairs_are_told_apart() {
    // x^d − 2 (a x − 1)² has two roots near 1/a, at a distance of about a^(−(d+2)/2).
    for (d, a) in [(12, 50), (30, 9), (80, 3)] {
        let mut c = vec![Integer::ZERO; d + 1];
        c[d] = Integer::ONE;
        c[0] = Integer::from(-2);
        c[1] = Integer::from(4 * a);
        c[2] = Integer::from(-2 * a * a);
        let roots = real_roots(&IntegerPolynomial::from_coefficients_asc(c));
        let positive = roots.iter().filter(|r| r.signum() > 0).count();
        assert_eq!(positive, 3, "degree {d}");
    }
}

#[test]
fn tiny_and_huge_roots() {
    // The polynomial (x − 10^−30)(x − 10^30)(x + 7).
    let ten = Integer::from(10).pow(30);
    let f = IntegerPolynomial::from_coefficients_asc(vec![-Integer::ONE, ten.clone()])
        * IntegerPolynomial::from_coefficients_asc(vec![-ten, Integer::ONE])
        * poly(&[7, 1]);
    check(&real_roots(&f), &[-7.0, 1e-30, 1e30]);
}

/// The halves, by de Casteljau's means without rounding, of the distances of exact and rounded coefficients, times 2^degree.
/// The distances are given doubled.
fn halved_exactly(coefficients: &[Integer]) -> [Vec<Integer>; 2] {
    // The coefficients of level k are multiplied by 2^k.
    let degree = coefficients.len() - 1;
    let mut level = coefficients.to_vec();
    let (mut left, mut right) = (Vec::new(), Vec::new());
    for step in 0..=degree {
        let up = (degree - step) as u64;
        left.push(&level[0] << up);
        right.push(&level[degree - step] << up);
        level = level.windows(2).map(|w| &w[0] + &w[1]).collect();
    }
    right.reverse();
    [left, right]
}

/// Coefficients for which every mean of de Casteljau's scheme ends in 1/2, if `is_worst`. They are computed level by level,
/// beginning with the last mean, from the given free numbers.
fn coefficients_to_halve(free: &[i64], is_worst: bool) -> Vec<Integer> {
    if !is_worst {
        return free.iter().map(|c| Integer::from(*c)).collect();
    }
    let mut level: Vec<Integer> = Vec::new();
    for c in free {
        let mut above = vec![Integer::from(*c)];
        for mean in &level {
            let next = (mean << 1u64) + Integer::ONE - &above[above.len() - 1];
            above.push(next);
        }
        level = above;
    }
    level
}

proptest! {
    /// The largest loss is half of the degree; the bound of the lemma is the degree.
    #[test]
    fn halving_loses_less_than_the_error_says(
        free in prop::collection::vec(any::<i64>(), 2..70), is_worst in any::<bool>(), error in 1u64..100,
    ) {
        let coefficients = coefficients_to_halve(&free, is_worst);
        let degree = coefficients.len() - 1;
        // The exact coefficients are as far above the rounded ones as allowed, except for 2^-20.
        let most = (Integer::from(error) << 20u64) - Integer::ONE;
        let exact: Vec<Integer> = coefficients.iter().map(|c| (c << 20u64) + &most).collect();
        let node = Node { index: Integer::from(3), depth: 7, coefficients, error: Integer::from(error) };
        let (left, right) = halve(node);
        prop_assert_eq!((&left.index, &right.index), (&Integer::from(6), &Integer::from(7)));
        let mut largest = Integer::ZERO;
        let scale = degree as u64 + 20;
        for (half, exact) in [left, right].into_iter().zip(halved_exactly(&exact)) {
            prop_assert_eq!(half.depth, 8);
            for (found, exact) in half.coefficients.iter().zip(exact) {
                let below = exact - (found << scale);
                prop_assert!(below >= 0 && below < &half.error << scale);
                largest = largest.max(below);
            }
        }
        // The loss is not much smaller than the bound, at least the part that is lost in this step.
        let lost = largest - (most << degree as u64);
        if is_worst {
            prop_assert_eq!(lost << 1u64, Integer::from(degree) << scale);
        } else if degree > 20 {
            prop_assert!(lost << 3u64 >= Integer::from(degree) << scale);
        }
    }

    /// Second differences of exact coefficients, which are at both ends of the ranges that the rounded ones allow.
    #[test]
    fn a_certain_second_derivative_is_right(
        slopes in prop::collection::vec(-4i64..5, 2..12), curve in -9i64..10, error in 1u64..4,
        ends in prop::collection::vec(any::<bool>(), 14),
    ) {
        let mut b = vec![Integer::ZERO];
        let mut slope = Integer::ZERO;
        for s in &slopes {
            slope += Integer::from(curve + s);
            b.push(&b[b.len() - 1] + &slope);
        }
        let node = Node { index: Integer::ZERO, depth: 99, coefficients: b.clone(), error: Integer::from(error) };
        let most = (Integer::from(error) << 20u64) - Integer::ONE;
        let exact: Vec<Integer> = b.iter().zip(&ends)
            .map(|(b, end)| (b << 20u64) + if *end { most.clone() } else { Integer::ZERO }).collect();
        if let Some(sign_found) = convexity(&node) {
            for w in exact.windows(3) {
                prop_assert_eq!(sign(&(&w[0] + &w[2] - (&w[1] << 1u64))), sign_found);
            }
        }
    }

    /// Polynomials with known rational roots and multiplicities, times a factor without real roots.
    #[test]
    fn known_roots_are_found_with_their_multiplicities(
        roots in prop::collection::btree_map((-60i64..60, 1i64..12), 1usize..4, 0..6),
        positive in prop::collection::vec((1i64..9, -4i64..4), 0..3),
    ) {
        let mut distinct = std::collections::BTreeMap::new();
        let mut f = poly(&[1]);
        for ((p, q), m) in roots {
            let r = crate::exact::Rational::from(p) / crate::exact::Rational::from(q);
            let factor = IntegerPolynomial::from_coefficients_asc(vec![-r.numerator(), r.denominator()]);
            for _ in 0..m {
                f *= &factor;
            }
            *distinct.entry(r).or_insert(0) += m;
        }
        for (a, b) in positive {
            // The factor (x − b)² + a.
            f *= poly(&[b * b + a, -2 * b, 1]);
        }
        let found: Vec<(f64, usize)> = real_roots(&f).iter().map(|r| (r.to_f64(), r.multiplicity())).collect();
        let expected: Vec<(f64, usize)> = distinct.iter().map(|(r, m)| (r.to_f64(), *m)).collect();
        prop_assert_eq!(found, expected);
    }

    /// Polynomials with rational roots 0, 1, 2, … ulps apart, at midpoints between doubles, and at distances of 2^-60 and
    /// 2^-200 ulps from them. The order of the roots, their doubles and their multiplicities are known.
    #[test]
    fn roots_that_are_ulps_apart_are_told_apart_and_rounded(
        bits in prop_oneof![0x3FE0_u64 << 48..0x4010_u64 << 48, 0x0010_u64 << 48..0x7FD0_u64 << 48, 1_u64..1 << 54],
        places in prop::collection::btree_set((0_i64..4, 0_usize..9), 2..6), negative in any::<bool>(), twice in any::<bool>(),
    ) {
        let exactly = |x: f64| Rational::try_from(x).unwrap();
        let start = f64::from_bits(bits);
        let ulp = exactly(start.next_up()) - exactly(start);
        let part = |k: u64| Rational::from_dyadic(Integer::ONE, -k.cast_signed());
        let half = part(1);
        let offsets = [
            Rational::zero(), part(60), part(200), &half - part(200), &half - part(60), half.clone(), &half + part(200),
            &half + part(60), Rational::one() - part(60),
        ];
        let mut f = poly(&[1]);
        let mut expected = Vec::new();
        for (k, (ulps, offset)) in places.iter().enumerate() {
            let size = exactly(start) + &ulp * (Rational::from(*ulps) + &offsets[*offset]);
            let root = if negative { -size } else { size };
            let m = if twice && k == 0 { 2 } else { 1 };
            let factor = IntegerPolynomial::from_coefficients_asc(vec![-root.numerator(), root.denominator()]);
            for _ in 0..m {
                f *= &factor;
            }
            expected.push((root, m));
        }
        expected.sort();
        let found: Vec<(f64, usize)> = real_roots(&f).iter().map(|r| (r.to_f64(), r.multiplicity())).collect();
        let expected: Vec<(f64, usize)> = expected.iter().map(|(r, m)| (r.to_f64(), *m)).collect();
        prop_assert_eq!(found, expected);
    }

    /// Polynomials (x − r)² ± 2^-k times another one, which have no real root near r or a close pair of roots.
    #[test]
    fn close_pairs_are_roots_on_one_side_only(
        mantissa in 1_i64..1 << 53, exponent in -60_i64..10, k in prop_oneof![1_u64..80, 80_u64..700], other in 1_i64..9,
    ) {
        let root = Rational::from_dyadic(Integer::from(mantissa), exponent);
        let (p, q) = (root.numerator(), root.denominator());
        let square = IntegerPolynomial::from_coefficients_asc(vec![-p, q]).pow(2);
        let quadratic = poly(&[other, 1, 1]);
        for (sign, count) in [(-1, 2), (1, 0)] {
            let small = IntegerPolynomial::from_coefficients_asc(vec![Integer::from(sign)]);
            let f = ((&square << k) + small) * &quadratic;
            prop_assert_eq!(real_roots(&f).len(), count);
        }
    }

    /// The number of roots is that of Sturm's theorem, computed naively with num-rational.
    #[test]
    fn the_count_is_sturms(c in prop::collection::vec(-30i64..30, 2..14)) {
        let f = poly(&c);
        prop_assume!(f.coefficients_asc().len() > 1);
        prop_assert_eq!(real_roots(&f).len(), sturm(&f));
    }

    /// Long coefficients near powers of two, which do not fit in a bounded number of bits.
    #[test]
    fn the_count_of_long_polynomials_is_sturms(
        c in prop::collection::vec((-8_i64..9, 0_u64..400, -1_i64..2), 2..9),
    ) {
        let long = |&(c, bits, more): &(i64, u64, i64)| (Integer::from(c) << bits) + Integer::from(more);
        let f = IntegerPolynomial::from_coefficients_asc(c.iter().map(long).collect());
        prop_assume!(f.coefficients_asc().len() > 1);
        prop_assert_eq!(real_roots(&f).len(), sturm(&f));
    }
}

fn sturm(f: &IntegerPolynomial) -> usize {
    use num_bigint::BigInt;
    use num_rational::BigRational;
    use num_traits::{Signed, Zero};
    type P = Vec<BigRational>;
    let trim = |mut p: P| {
        while p.last().is_some_and(Zero::is_zero) {
            p.pop();
        }
        p
    };
    let f: P = trim(
        f.coefficients_asc()
            .iter()
            .map(|c| BigRational::from(c.to_string().parse::<BigInt>().unwrap()))
            .collect(),
    );
    let df: P = f
        .iter()
        .enumerate()
        .skip(1)
        .map(|(i, c)| c * BigRational::from(BigInt::from(i)))
        .collect();
    let mut chain = vec![f, trim(df)];
    while !chain[chain.len() - 1].is_empty() {
        let (a, b) = (chain[chain.len() - 2].clone(), &chain[chain.len() - 1]);
        let mut a = a;
        while a.len() >= b.len() {
            let q = &a[a.len() - 1] / &b[b.len() - 1];
            let start = a.len() - b.len();
            for (i, v) in b.iter().enumerate() {
                let s = &q * v;
                a[start + i] -= s;
            }
            a.pop();
            a = trim(a);
        }
        chain.push(a.into_iter().map(|v| -v).collect());
    }
    chain.pop();
    let changes = |at_minus: bool| {
        let signs: Vec<bool> = chain
            .iter()
            .map(|p| p[p.len() - 1].is_positive() ^ (at_minus && p.len().is_multiple_of(2)))
            .collect();
        signs.windows(2).filter(|w| w[0] != w[1]).count()
    };
    changes(true) - changes(false)
}
