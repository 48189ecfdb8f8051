//! Oracle: how many real roots there are, by Sturm's theorem, done naively with num-rational.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use stellate::exact::Rational;
use stellate::poly::SparsePolynomial;

type Ascending = Vec<BigRational>;

fn num(q: &Rational) -> BigRational {
    BigRational::from(q)
}

fn trimmed<T: Zero>(mut p: Vec<T>) -> Vec<T> {
    while p.last().is_some_and(Zero::is_zero) {
        p.pop();
    }
    p
}

/// f(u r, v r, w r) in ascending powers of r, without the powers of r that divide it.
fn along(f: &SparsePolynomial<3>, direction: &[Rational; 3]) -> Ascending {
    let direction = direction.each_ref().map(num);
    let mut sums: Ascending = Vec::new();
    for (exponents, c) in f.terms() {
        let degree: usize = exponents.iter().map(|&e| e as usize).sum();
        let mut value = num(c);
        for (u, &e) in direction.iter().zip(exponents) {
            for _ in 0..e {
                value *= u;
            }
        }
        if sums.len() <= degree {
            sums.resize(degree + 1, BigRational::zero());
        }
        sums[degree] += value;
    }
    let lowest = sums.iter().position(|c| !c.is_zero()).unwrap_or(0);
    trimmed(sums.split_off(lowest))
}

/// The number of distinct real roots r ≠ 0 of f along a direction; `None` if f vanishes identically there.
pub(crate) fn count_along(f: &SparsePolynomial<3>, direction: &[Rational; 3]) -> Option<usize> {
    let f = along(f, direction);
    if f.is_empty() {
        return None;
    }
    // A positive factor changes no sign.
    let scale = f.iter().fold(BigInt::one(), |d, c| {
        let missing = BigRational::new(c.denom().clone(), d.clone());
        d * missing.numer()
    });
    let f: Vec<BigInt> = f.iter().map(|c| c.numer() * (&scale / c.denom())).collect();
    let df = f
        .iter()
        .enumerate()
        .skip(1)
        .map(|(i, c)| c * BigInt::from(i));
    let mut chain = vec![f.clone(), trimmed(df.collect())];
    while !chain[chain.len() - 1].is_empty() {
        let (mut a, b) = (chain[chain.len() - 2].clone(), &chain[chain.len() - 1]);
        let last = &b[b.len() - 1];
        while a.len() >= b.len() {
            // The next remainder of a |last|, so that the quotient is an integer.
            let q = &a[a.len() - 1] * last.signum();
            let start = a.len() - b.len();
            for c in &mut a {
                *c *= last.abs();
            }
            for (i, v) in b.iter().enumerate() {
                a[start + i] -= &q * v;
            }
            a.pop();
            a = trimmed(a);
        }
        chain.push(a.into_iter().map(|v| -v).collect());
    }
    chain.pop();
    let changes = |at_minus: bool| {
        let signs = chain
            .iter()
            .map(|p| p[p.len() - 1].is_positive() ^ (at_minus && p.len().is_multiple_of(2)));
        let signs: Vec<bool> = signs.collect();
        signs.windows(2).filter(|w| w[0] != w[1]).count()
    };
    Some(changes(true) - changes(false))
}
