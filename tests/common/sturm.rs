//! Oracle: how many real roots there are, by Sturm's theorem, done naively with num-rational.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use stellate::exact::Rational;
use stellate::poly::SparsePolynomial;

type Ascending = Vec<BigRational>;

fn num(q: &Rational) -> BigRational {
    BigRational::from(q)
}

fn trimmed(mut p: Ascending) -> Ascending {
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
    let df: Ascending = f
        .iter()
        .enumerate()
        .skip(1)
        .map(|(i, c)| c * BigRational::from(BigInt::from(i)))
        .collect();
    let mut chain = vec![f, trimmed(df)];
    while !chain[chain.len() - 1].is_empty() {
        let (mut a, b) = (chain[chain.len() - 2].clone(), &chain[chain.len() - 1]);
        while a.len() >= b.len() {
            let q = &a[a.len() - 1] / &b[b.len() - 1];
            let start = a.len() - b.len();
            for (i, v) in b.iter().enumerate() {
                let s = &q * v;
                a[start + i] -= s;
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
