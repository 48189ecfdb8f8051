//! Laws and known families of the factorization over Q.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::str::FromStr;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::polynomial::Polynomial;
use proptest::prelude::*;
use stellate::error::Error;
use stellate::exact::Rational;
use stellate::factor::{
    Factor, Factorization, Irreducibility, factor_plane, factor_space, factor_univariate,
};
use stellate::limits::Limits;
use stellate::poly::{IntegerPolynomial, PlanePolynomial, Ring, SparsePolynomial};

use crate::common::dense::{integral, rational};

fn in_x(text: &str) -> IntegerPolynomial {
    IntegerPolynomial::from_str(text).unwrap()
}

fn univariate(f: &IntegerPolynomial) -> Factorization<IntegerPolynomial> {
    let found = factor_univariate(&rational(f), &Limits::none()).unwrap();
    let factors = found.factors.into_iter().map(|g| Factor {
        polynomial: integral(&g.polynomial),
        multiplicity: g.multiplicity,
        proof: g.proof,
    });
    Factorization {
        content: found.content,
        factors: factors.collect(),
    }
}

fn plane(f: &PlanePolynomial) -> Factorization<PlanePolynomial> {
    let result = factor_plane(f, &Limits::none()).unwrap();
    let mut product = PlanePolynomial::from_terms([((0, 0), result.content.clone())]);
    for factor in &result.factors {
        assert!(factor.polynomial.check_invariants());
        assert_eq!(factor.polynomial.primitive(), factor.polynomial);
        for _ in 0..factor.multiplicity {
            product = &product * &factor.polynomial;
        }
    }
    assert_eq!(&product, f, "the factors multiply back");
    result
}

fn space(f: &SparsePolynomial<3>) -> Factorization<SparsePolynomial<3>> {
    let result = factor_space(f, &Limits::none()).unwrap();
    let mut product = SparsePolynomial::constant(result.content.clone());
    for factor in &result.factors {
        assert_eq!(factor.polynomial.primitive(), factor.polynomial);
        for _ in 0..factor.multiplicity {
            product = product.times(&factor.polynomial);
        }
    }
    assert_eq!(&product, f, "the factors multiply back");
    result
}

/// Terms as (coefficient, i, j).
fn xy(terms: &[(i64, usize, usize)]) -> PlanePolynomial {
    PlanePolynomial::from_terms(terms.iter().map(|&(c, i, j)| ((i, j), c.into())))
}

fn degrees(result: &Factorization<IntegerPolynomial>) -> Vec<(usize, usize)> {
    let pairs = result
        .factors
        .iter()
        .map(|g| (g.polynomial.coefficients_asc().len() - 1, g.multiplicity));
    pairs.collect()
}

/// ∏ (x ± √p1 ± √p2 …), by f(x) → f(x + √p) f(x − √p) with pairs a + b√p of coefficients.
fn swinnerton_dyer(primes: &[i64]) -> IntegerPolynomial {
    let mut f = in_x("x");
    for &p in primes {
        // f(x + s) = Σ_k f^(k)(x)/k! s^k, split by the parity of k; s² = p.
        let shifted = |sign: i64| {
            let mut sum = [IntegerPolynomial::default(), IntegerPolynomial::default()];
            for (n, c) in f.coefficients_asc().iter().enumerate() {
                // (x + s)^n = a + b s.
                let (mut a, mut b) = (IntegerPolynomial::one(), IntegerPolynomial::default());
                let x = in_x("x");
                let number =
                    |v: i64| IntegerPolynomial::from_coefficients_asc(vec![Integer::from(v)]);
                for _ in 0..n {
                    let next_a = &a * &x + &b * number(p * sign);
                    b = &b * &x + &a * number(sign);
                    a = next_a;
                }
                let c = IntegerPolynomial::from_coefficients_asc(vec![c.clone()]);
                sum[0] += &a * &c;
                sum[1] += &b * &c;
            }
            sum
        };
        let [a, b] = shifted(1);
        // (a + b√p)(a − b√p).
        f = &a * &a - &b * &b * IntegerPolynomial::from_coefficients_asc(vec![Integer::from(p)]);
    }
    f
}

#[test]
fn swinnerton_dyer_polynomials_are_irreducible() {
    for count in 2..=5 {
        let f = swinnerton_dyer(&[2, 3, 5, 7, 11][..count]);
        assert_eq!(f.coefficients_asc().len() - 1, 1 << count);
        assert_eq!(degrees(&univariate(&f)), [(1 << count, 1)]);
    }
    let (f, g) = (swinnerton_dyer(&[2, 3, 5]), swinnerton_dyer(&[2, 3, 7]));
    assert_eq!(degrees(&univariate(&(f * g))), [(8, 1), (8, 1)]);
    // Shifted, so that it is no polynomial in x².
    let shifted = stellate::poly::shift_by_one(swinnerton_dyer(&[2, 3, 5, 7]));
    let result = univariate(&shifted);
    assert_eq!(degrees(&result), [(16, 1)]);
    assert!(matches!(
        result.factors[0].proof,
        Irreducibility::Recombination { local } if local >= 8
    ));
}

#[test]
fn the_factors_of_x_to_the_n_minus_1_belong_to_the_divisors_of_n() {
    let phi = |n: usize| (1..=n).filter(|&k| gcd(k, n) == 1).count();
    for n in (1..=40).chain([60, 64, 72, 97, 105]) {
        let mut coefficients = vec![Integer::from(0); n + 1];
        coefficients[0] = Integer::from(-1);
        coefficients[n] = Integer::from(1);
        let f = IntegerPolynomial::from_coefficients_asc(coefficients);
        let mut expected: Vec<_> = (1..=n).filter(|d| n % d == 0).map(phi).collect();
        expected.sort_unstable();
        let found: Vec<_> = degrees(&univariate(&f)).iter().map(|d| d.0).collect();
        assert_eq!(found, expected, "x^{n} − 1");
    }
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[test]
fn multiplicities_and_content_in_one_variable() {
    let f = (in_x("2*x+1").pow(7) * in_x("x^2+x+1").pow(3) * in_x("x").pow(5))
        * IntegerPolynomial::from_coefficients_asc(vec![Integer::from(-6)]);
    let result = univariate(&f);
    assert_eq!(result.content, Rational::from(-6));
    let found: Vec<_> = result
        .factors
        .iter()
        .map(|g| (g.polynomial.to_string(), g.multiplicity))
        .collect();
    let expected = [("x", 5), ("2*x+1", 7), ("x^2+x+1", 3)];
    assert_eq!(found, expected.map(|(g, m)| (g.to_string(), m)));
}

#[test]
fn constants_have_no_factors_and_zero_is_refused() {
    let seven = PlanePolynomial::from_terms([((0, 0), Rational::new(7, 3).unwrap())]);
    let result = plane(&seven);
    assert!(result.factors.is_empty());
    assert_eq!(result.content, Rational::new(7, 3).unwrap());
    let zero = PlanePolynomial::from_terms([]);
    assert!(matches!(
        factor_plane(&zero, &Limits::none()),
        Err(Error::Usage(_))
    ));
}

#[test]
fn example_8_of_the_paper() {
    let q = |n: i64, d: i64| Rational::new(n, d).unwrap();
    let rational = |terms: &[(Rational, usize, usize)]| {
        PlanePolynomial::from_terms(terms.iter().map(|(c, i, j)| ((*i, *j), c.clone())))
    };
    let inner = rational(&[
        (q(1, 1), 4, 0),
        (q(-19, 10), 2, 2),
        (q(1, 1), 0, 4),
        (q(-1, 2), 0, 0),
    ]);
    let outer = rational(&[(q(1, 1), 8, 0), (q(1, 1), 0, 8), (q(-1, 100_000), 0, 0)]);
    let axes = xy(&[(1, 10, 10)]);
    let result = plane(&(&(&inner * &outer) * &axes));
    let found: Vec<_> = result
        .factors
        .iter()
        .map(|g| (g.polynomial.clone(), g.multiplicity))
        .collect();
    assert_eq!(
        found,
        [
            (xy(&[(1, 1, 0)]), 10),
            (xy(&[(1, 0, 1)]), 10),
            (inner.primitive(), 1),
            (outer.primitive(), 1),
        ]
    );
}

#[test]
fn known_factorizations_in_the_plane() {
    // Four lines of a form, a conic twice, and a factor in y alone.
    let conic = xy(&[(1, 2, 0), (1, 0, 2), (-1, 0, 0)]);
    let form = xy(&[(1, 4, 0), (-5, 2, 2), (4, 0, 4)]);
    let in_y = xy(&[(1, 0, 2), (-2, 0, 0)]);
    let f = [&conic, &form, &in_y]
        .into_iter()
        .fold(conic.clone(), |f, g| &f * g);
    let multiplicities: Vec<_> = plane(&f).factors.iter().map(|g| g.multiplicity).collect();
    assert_eq!(multiplicities, [1, 1, 1, 1, 2, 1]);

    // Reducible at every small point looked at first, irreducible all the same: x² − (y² − 1)y²(y² − 4).
    let f = xy(&[(1, 2, 0), (-1, 0, 6), (5, 0, 4), (-4, 0, 2)]);
    assert_eq!(plane(&f).factors.len(), 1);

    // Leading coefficients in both variables: (xy − 1)(xy² + x + y)(x³y − y³ + 2).
    let f = &xy(&[(1, 1, 1), (-1, 0, 0)]) * &xy(&[(1, 1, 2), (1, 1, 0), (1, 0, 1)]);
    let f = &f * &xy(&[(1, 3, 1), (-1, 0, 3), (2, 0, 0)]);
    assert_eq!(plane(&f).factors.len(), 3);

    // x⁴ + 4y⁴ and x^12 − y^18.
    assert_eq!(plane(&xy(&[(1, 4, 0), (4, 0, 4)])).factors.len(), 2);
    assert_eq!(plane(&xy(&[(1, 12, 0), (-1, 0, 18)])).factors.len(), 4);
}

#[test]
fn irreducible_of_high_degree_by_capelli() {
    let f = xy(&[(1, 300, 0), (1, 0, 300), (-1, 0, 0)]);
    let result = plane(&f);
    assert_eq!(result.factors.len(), 1);
    assert!(matches!(
        result.factors[0].proof,
        Irreducibility::Capelli { .. }
    ));
}

/// A dense polynomial with coefficients between −7 and 8 from a linear congruence.
fn dense(degree: usize, seed: u64) -> PlanePolynomial {
    let mut state = seed;
    let mut terms = Vec::new();
    for i in 0..=degree {
        for j in 0..=degree - i {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let digit = i8::try_from(state >> 40 & 15).unwrap_or(0);
            terms.push((i64::from(digit) - 7, i, j));
        }
    }
    xy(&terms)
}

#[test]
fn two_dense_factors() {
    let (f, g) = (dense(8, 1), dense(8, 2));
    let result = plane(&(&f * &g));
    assert_eq!(result.factors.len(), 2);
    let result = plane(&(&(&f * &f) * &dense(3, 5)));
    assert_eq!(result.factors.len(), 2);
    assert_eq!(result.factors[1].multiplicity, 2);
}

#[test]
fn space_polynomials() {
    let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
    let one = SparsePolynomial::constant(Rational::one());
    let two = SparsePolynomial::constant(2.into());
    let sphere = x
        .squared()
        .plus(&y.squared())
        .plus(&z.squared())
        .minus(&one);
    let cubic = x.times(&y).times(&z).plus(&y.squared()).minus(&two);
    let cylinder = x.squared().minus(&two.times(&y.squared())).plus(&y);
    let f = sphere
        .squared()
        .times(&cubic)
        .times(&cylinder)
        .times(&z)
        .times(&two);
    let result = space(&f);
    let multiplicities: Vec<_> = result.factors.iter().map(|g| g.multiplicity).collect();
    assert_eq!(multiplicities, [1, 1, 2, 1]);
    assert_eq!(result.content, Rational::from(2));

    // A form: (x² + yz)(x + y + z).
    let form = x.squared().plus(&y.times(&z)).times(&x.plus(&y).plus(&z));
    assert_eq!(space(&form).factors.len(), 2);

    // (x² + y² + z² + 3)² − 16(x² + y²): a torus is irreducible.
    let rho = x.squared().plus(&y.squared());
    let torus = rho
        .plus(&z.squared())
        .plus(&SparsePolynomial::constant(3.into()))
        .squared()
        .minus(&rho.scaled(&16.into()));
    let result = space(&torus);
    assert_eq!(result.factors.len(), 1);
}

#[test]
fn what_is_too_large_is_refused_at_once() {
    for f in [
        xy(&[(1, 4_000_000, 0), (1, 0, 1)]),
        xy(&[(1, 100_001, 0), (1, 2, 0), (1, 0, 0)]),
        xy(&[
            (1, 5001, 5001),
            (3, 17, 16),
            (1, 0, 2),
            (1, 1, 0),
            (1, 0, 0),
        ]),
    ] {
        let error = factor_plane(&f, &Limits::none()).unwrap_err();
        assert!(matches!(error, Error::Limit { .. }));
    }
    let top = u32::MAX;
    let f = SparsePolynomial::from_terms([([top; 3], 1.into()), ([0; 3], 1.into())]);
    let error = factor_space(&f, &Limits::none()).unwrap_err();
    assert!(matches!(error, Error::Limit { .. }));
}

#[test]
fn a_time_limit_stops_the_work() {
    let limits = Limits::none().with_time_limit(std::time::Duration::ZERO);
    let error = factor_plane(&dense(8, 3), &limits).unwrap_err();
    assert!(matches!(error, Error::Limit { .. }));
}

fn small_plane() -> impl Strategy<Value = PlanePolynomial> {
    prop::collection::vec((-4i64..=4, 0usize..4, 0usize..4), 1..6).prop_map(|terms| xy(&terms))
}

fn small_space() -> impl Strategy<Value = SparsePolynomial<3>> {
    prop::collection::vec((-3i64..=3, prop::array::uniform3(0u32..3)), 1..5).prop_map(|terms| {
        SparsePolynomial::from_terms(terms.into_iter().map(|(c, e)| (e, c.into())))
    })
}

fn small_univariate() -> impl Strategy<Value = IntegerPolynomial> {
    prop::collection::vec(-9i64..=9, 1..7).prop_map(|c| {
        IntegerPolynomial::from_coefficients_asc(c.into_iter().map(Integer::from).collect())
    })
}

fn count<P>(result: &Factorization<P>) -> usize {
    result.factors.iter().map(|g| g.multiplicity).sum()
}

/// Whether a quadratic or cubic has a rational root: p/q with p | a0, q | an, by trying all.
fn has_rational_root(c: &[i64]) -> bool {
    c[0] == 0
        || (1..=c[c.len() - 1].abs()).any(|q| {
            // Horner, homogenised: c_n p^n + c_(n−1) p^(n−1) q + …
            (-c[0].abs()..=c[0].abs()).any(|p| {
                let step = |(value, power): (i64, i64), c: &i64| (value * p + c * power, power * q);
                c.iter().rev().fold((0, 1), step).0 == 0
            })
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn quadratics_and_cubics_are_reducible_iff_they_have_a_root(mut c in prop::collection::vec(-30i64..=30, 3..=4)) {
        if c.last() == Some(&0) {
            *c.last_mut().unwrap() = 1;
        }
        let f = IntegerPolynomial::from_coefficients_asc(c.iter().map(|&c| Integer::from(c)).collect());
        prop_assert_eq!(count(&univariate(&f)) > 1, has_rational_root(&c));
    }

    #[test]
    fn products_in_one_variable(f in small_univariate(), g in small_univariate()) {
        let product = &f * &g;
        prop_assume!(!product.coefficients_asc().is_empty());
        let (a, b, both) = (univariate(&f), univariate(&g), univariate(&product));
        prop_assert_eq!(count(&a) + count(&b), count(&both));
        prop_assert_eq!(&a.content * &b.content, both.content.clone());
        for factor in &both.factors {
            let again = univariate(&factor.polynomial);
            prop_assert_eq!(again.factors.len(), 1);
            prop_assert_eq!(&again.factors[0].polynomial, &factor.polynomial);
        }
        // f(x)g(x) and its reversal have as many factors.
        let mut reversed = product.clone().into_coefficients_asc();
        let zeros = reversed.iter().take_while(|c| **c == 0).count();
        reversed.reverse();
        let reversed = IntegerPolynomial::from_coefficients_asc(reversed);
        prop_assert_eq!(count(&univariate(&reversed)) + zeros, count(&both));
    }

    #[test]
    fn products_in_the_plane(f in small_plane(), g in small_plane()) {
        prop_assume!(!f.is_zero() && !g.is_zero());
        let both = plane(&(&f * &g));
        let (a, b) = (plane(&f), plane(&g));
        prop_assert_eq!(count(&a) + count(&b), count(&both));
        for factor in a.factors.iter().chain(&b.factors) {
            prop_assert!(both.factors.iter().any(|h| h.polynomial == factor.polynomial && h.multiplicity >= factor.multiplicity));
        }
        for factor in &both.factors {
            let again = plane(&factor.polynomial);
            prop_assert_eq!(again.factors.len(), 1);
            prop_assert_eq!(again.factors[0].multiplicity, 1);
        }
    }

    #[test]
    fn powers_in_the_plane(f in small_plane(), g in small_plane()) {
        prop_assume!(!f.is_zero() && !g.is_zero());
        let (a, b) = (plane(&f), plane(&(&(&f * &f) * &g)));
        for factor in &a.factors {
            prop_assert!(b.factors.iter().any(|h| h.polynomial == factor.polynomial && h.multiplicity >= 2 * factor.multiplicity));
        }
    }

    #[test]
    fn moving_a_curve_moves_its_factors(f in small_plane(), g in small_plane(), a in -3i64..=3, b in 1i64..=3) {
        prop_assume!(!f.is_zero() && !g.is_zero());
        let product = &f * &g;
        let moved = product.translated(&a.into(), &Rational::new(a, b).unwrap());
        prop_assert_eq!(count(&plane(&product)), count(&plane(&moved)));
    }

    #[test]
    fn one_variable_in_the_plane_is_one_variable(f in small_univariate(), g in small_univariate()) {
        let product = &f * &g;
        prop_assume!(!product.coefficients_asc().is_empty());
        let flat = PlanePolynomial::from_terms(
            rational(&product).into_iter().enumerate().map(|(k, c)| ((k, 0), c)),
        );
        let (one, two) = (univariate(&product), plane(&flat));
        prop_assert_eq!(&one.content, &two.content);
        prop_assert_eq!(one.factors.len(), two.factors.len());
        for (a, b) in one.factors.iter().zip(&two.factors) {
            let back = PlanePolynomial::from_terms(
                rational(&a.polynomial).into_iter().enumerate().map(|(k, c)| ((k, 0), c)),
            );
            prop_assert_eq!(&back, &b.polynomial);
            prop_assert_eq!(&a.proof, &b.proof);
        }
    }

    #[test]
    fn products_in_space(f in small_space(), g in small_space()) {
        prop_assume!(!f.is_empty() && !g.is_empty());
        let both = space(&f.times(&g));
        let (a, b) = (space(&f), space(&g));
        prop_assert_eq!(count(&a) + count(&b), count(&both));
    }

    #[test]
    fn the_plane_in_space_is_the_plane(f in small_plane(), g in small_plane()) {
        prop_assume!(!f.is_zero() && !g.is_zero());
        let product = &f * &g;
        let (two, three) = (plane(&product), space(&SparsePolynomial::from(&product)));
        prop_assert_eq!(&two.content, &three.content);
        let flat: Vec<_> = three.factors.iter().map(|g| (g.polynomial.to_plane().unwrap(), g.multiplicity)).collect();
        let direct: Vec<_> = two.factors.iter().map(|g| (g.polynomial.clone(), g.multiplicity)).collect();
        prop_assert_eq!(flat, direct);
    }
}
