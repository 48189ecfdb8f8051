//! Products, greatest common divisors and factorizations, from polynomials multiplied out by schoolbook.

use std::collections::BTreeMap;
use std::time::Duration;

use malachite::base::polynomial::Polynomial;
use num_bigint::BigInt;
use num_traits::{One, Zero};
use stellate::factor::{factor_plane, factor_space, factor_univariate};
use stellate::limits::Limits;
use stellate::poly::{
    IntegerPolynomial, PlanePolynomial, SparsePolynomial, divide_exactly, polynomial_gcd,
};

use super::draw::Draw;
use super::exact::{Poly, Q, num, our};
use super::harness::Outcome;
use super::terms::{Terms, plane_terms, random, space_terms, value_of};

/// Long and short, dense and sparse products, translations and powers.
pub(crate) fn products(draw: &mut Draw) -> Outcome {
    let dense = |draw: &mut Draw, degree: u32, bits: u64| {
        let all = (0..=degree).flat_map(|i| (0..=degree - i).map(move |j| [i, j]));
        let terms: Vec<_> = all.map(|e| (e, draw.integer(bits))).collect();
        Terms::<2>::new(terms)
    };
    let bits = draw.pick(&[5, 30, 31, 61, 62, 64, 128, 500, 2000]);
    let factor = |draw: &mut Draw| {
        if draw.once_in(2) {
            let degree = 1 + draw.below(12) as u32;
            dense(draw, degree, bits)
        } else {
            random::<2>(draw, 30, bits)
        }
    };
    let (f, g) = (factor(draw), factor(draw));
    draw.input = format!("({}) * ({})", f.text(), g.text());
    let same = |ours: &PlanePolynomial, expected: &Terms<2>| {
        let found = plane_terms(ours)
            .into_iter()
            .map(|(e, c)| (e, c.to_integer()));
        assert_eq!(Terms::new(found), *expected);
        assert!(ours.check_invariants());
    };
    same(&(&f.to_plane() * &g.to_plane()), &f.times(&g));
    let small = random::<2>(draw, 6, 60);
    let [a, b] = [0; 2].map(|_: i32| draw.rational());
    let moved = small.to_plane().translated(&our(&a), &our(&b));
    let at = [draw.rational(), draw.rational()];
    let before = [&at[0] - &a, &at[1] - &b];
    let value = value_of(plane_terms(&moved), &at);
    assert_eq!(value, small.value_at(&before), "translated by {a}, {b}");
    let value = num(&small.to_plane().evaluate(&our(&at[0]), &our(&at[1])));
    assert_eq!(value, small.value_at(&at), "evaluated at {at:?}");
    let space = random::<3>(draw, 3, 80);
    let exponent = draw.below(5) as u32;
    let power = space_terms(&space.to_sparse().pow(exponent)).into_iter();
    let power = Terms::new(power.map(|(e, c)| (e, c.to_integer())));
    assert_eq!(power, space.power(exponent as usize));
    Outcome::Checked
}

fn univariate(draw: &mut Draw, degree: usize, bits: u64) -> Poly {
    let mut coefficients: Vec<_> = (0..degree).map(|_| draw.integer(bits)).collect();
    coefficients.push(draw.natural(bits));
    Poly::new(coefficients)
}

/// gcd(f h, g h) against Euclid's algorithm, and exact division.
pub(crate) fn gcds(draw: &mut Draw) -> Outcome {
    let bits = draw.pick(&[3, 20, 61, 62, 200, 700]);
    let [f, g, h] = [0; 3].map(|_: i32| {
        let degree = draw.index(7);
        univariate(draw, degree, bits)
    });
    let (a, b) = (f.times(&h), g.times(&h));
    draw.input = format!("gcd of {:?} and {:?}", a.0, b.0);
    let found = Poly::of_integers(&polynomial_gcd(&a.to_integers(), &b.to_integers()));
    assert_eq!(found, a.gcd(&b));
    let quotient = divide_exactly(&a.to_integers(), &h.to_integers()).unwrap();
    assert_eq!(Poly::of_integers(&quotient), f);
    let zero = IntegerPolynomial::from_coefficients_asc(vec![]);
    let alone = polynomial_gcd(&a.to_integers(), &zero);
    assert_eq!(Poly::of_integers(&alone), a.gcd(&Poly::of(&[])));
    // With 1 more at a root of h nothing divides exactly.
    if h.degree() > 0 {
        let more = a.plus(&Poly::of(&[1]));
        assert!(divide_exactly(&more.to_integers(), &h.to_integers()).is_none());
    }
    Outcome::Checked
}

/// Linear, or Eisenstein at a prime.
fn irreducible_univariate(draw: &mut Draw) -> Poly {
    let p = draw.pick(&[2i64, 3, 5, 7, 101, 65_537]);
    if draw.once_in(2) {
        let root = draw.nonzero();
        return Poly::new(vec![-root.numer(), root.denom().clone()]);
    }
    let degree = 2 + draw.index(5);
    let bits = draw.pick(&[2u64, 8, 40]);
    let prime = BigInt::from(p);
    let without = |draw: &mut Draw| loop {
        let c = draw.integer(bits);
        if !(&c % &prime).is_zero() {
            return c;
        }
    };
    let mut coefficients = vec![without(draw) * &prime];
    coefficients.extend((1..degree).map(|_| draw.integer(bits) * &prime * draw.small(1)));
    coefficients.push(without(draw));
    if draw.once_in(3) {
        coefficients.reverse();
    }
    Poly::new(coefficients).primitive()
}

/// Linear, or Eisenstein in the last variable at a prime that is linear in the others, or at a prime number in one of them.
fn irreducible<const V: usize>(draw: &mut Draw) -> Terms<V> {
    let linear = |draw: &mut Draw| {
        let coefficients = std::array::from_fn(|_| BigInt::from(draw.small(9)));
        Terms::<V>::linear(&coefficients, draw.small(9).into())
    };
    match draw.below(4) {
        0 => loop {
            let f = linear(draw);
            if f.degree() > 0 {
                return f;
            }
        },
        1 => {
            let f = irreducible_univariate(draw);
            let v = draw.index(V);
            Terms::new(f.0.into_iter().enumerate().map(|(k, c)| {
                let mut e = [0; V];
                e[v] = k as u32;
                (e, c)
            }))
        }
        _ => {
            // w^n + P g_{n−1} w^{n−1} + … + P h with a prime P = x − a (− b y) that does not divide h.
            let n = 1 + draw.below(4) as u32;
            let last = V - 1;
            let x = Terms::<V>::variable(0);
            let mut prime = x.plus(&Terms::constant(draw.small(5).into()));
            if V > 2 {
                prime = prime.plus(&Terms::variable(1).scaled(&draw.small(3).into()));
            }
            let w = Terms::<V>::variable(last);
            let mut f = w.power(n as usize);
            for k in 1..n {
                let degree = draw.below(3) as u32;
                let g = if degree == 0 {
                    Terms::constant(draw.small(5).into())
                } else {
                    let g = random::<V>(draw, degree, 4);
                    Terms::new(g.0.into_iter().map(|(mut e, c)| {
                        e[last] = 0;
                        (e, c)
                    }))
                };
                f = f.plus(&g.times(&prime).times(&w.power(k as usize)));
            }
            let h = BigInt::from(1 + draw.below(9)) * if draw.once_in(2) { 1 } else { -1 };
            let more = prime.times(&Terms::constant(draw.small(3).into()));
            f = f.plus(&prime.times(&more.plus(&Terms::constant(h))));
            // An invertible substitution keeps it irreducible.
            if draw.once_in(2) {
                let k = BigInt::from(draw.small(3));
                let mut variables: [Terms<V>; V] = std::array::from_fn(Terms::variable);
                variables[0] = variables[0].plus(&Terms::variable(last).scaled(&k));
                if draw.once_in(2) {
                    variables.swap(0, last);
                }
                f = f.substituted(&variables);
            }
            f
        }
    }
}

/// Factors with multiplicities.
type Factors<F> = BTreeMap<F, usize>;

fn limits() -> Limits {
    Limits::none().with_time_limit(Duration::from_secs(20))
}

fn multiplied<const V: usize>(factors: &Factors<Terms<V>>, content: BigInt) -> Terms<V> {
    let start = Terms::constant(content);
    factors
        .iter()
        .fold(start, |f, (g, k)| f.times(&g.power(*k)))
}

pub(crate) fn factors(draw: &mut Draw) -> Outcome {
    let content = BigInt::from(1 + draw.below(30)) * if draw.once_in(2) { 1 } else { -1 };
    let count = 1 + draw.below(4);
    let multiplicity = |draw: &mut Draw| 1 + draw.index(3).min(draw.index(3));
    match draw.below(3) {
        0 => {
            let mut expected = Factors::<Vec<BigInt>>::new();
            let mut f = Poly::new(vec![content]);
            for _ in 0..count {
                let mut g = irreducible_univariate(draw);
                if g.0[g.degree()] < BigInt::zero() {
                    g = g.scaled(&BigInt::from(-1));
                }
                let k = multiplicity(draw);
                f = f.times(&g.power(k));
                *expected.entry(g.0).or_default() += k;
            }
            draw.input = format!("factor_univariate of {:?}", f.0);
            let Ok(found) = factor_univariate(&f.to_coefficients(), &limits()) else {
                return Outcome::Open;
            };
            let factors = found.factors.iter();
            let factors = factors.map(|g| (Poly::of_coefficients(&g.polynomial).0, g.multiplicity));
            assert_eq!(factors.collect::<Factors<_>>(), expected);
            let product = expected.iter().fold(Poly::of(&[1]), |product, (g, k)| {
                product.times(&Poly(g.clone()).power(*k))
            });
            let content = num(&found.content);
            assert!(content.denom().is_one());
            assert_eq!(product.scaled(content.numer()), f);
        }
        1 => {
            let mut expected = Factors::<Terms<2>>::new();
            for _ in 0..count {
                *expected
                    .entry(irreducible::<2>(draw).canonical())
                    .or_default() += multiplicity(draw);
            }
            let f = multiplied(&expected, content);
            draw.input = format!("stellate describe '{}'", f.text());
            let Ok(found) = factor_plane(&f.to_plane(), &limits()) else {
                return Outcome::Open;
            };
            let factors = found.factors.iter().map(|g| {
                let terms = plane_terms(&g.polynomial).into_iter();
                (
                    Terms::new(terms.map(|(e, c)| (e, c.to_integer()))),
                    g.multiplicity,
                )
            });
            assert_eq!(factors.collect::<Factors<_>>(), expected);
            let content = num(&found.content).to_integer();
            assert_eq!(multiplied(&expected, content), f);
        }
        _ => {
            let mut expected = Factors::<Terms<3>>::new();
            for _ in 0..count.min(3) {
                *expected
                    .entry(irreducible::<3>(draw).canonical())
                    .or_default() += 1;
            }
            let f = multiplied(&expected, content);
            draw.input = format!("stellate describe '{} + 0z'", f.text());
            let ours: SparsePolynomial<3> = f.to_sparse();
            let Ok(found) = factor_space(&ours, &limits()) else {
                return Outcome::Open;
            };
            let factors = found.factors.iter().map(|g| {
                let terms = space_terms(&g.polynomial).into_iter();
                (
                    Terms::new(terms.map(|(e, c)| (e, c.to_integer()))),
                    g.multiplicity,
                )
            });
            assert_eq!(factors.collect::<Factors<_>>(), expected);
            let content: Q = num(&found.content);
            assert_eq!(multiplied(&expected, content.to_integer()), f);
        }
    }
    Outcome::Checked
}
