//! The direct formula of Theorem 2 with num-rational and schoolbook multiplication: an arithmetic
//! and an algorithm of its own.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{One, Zero};
use stellate::shape::FourierRadius;

type Poly = BTreeMap<(usize, usize), BigRational>;

fn add(a: &Poly, b: &Poly, sign: i64) -> Poly {
    let mut sum = a.clone();
    let sign = BigRational::from_integer(sign.into());
    for (e, c) in b {
        let value = sum.remove(e).unwrap_or_else(BigRational::zero) + &sign * c;
        if !value.is_zero() {
            sum.insert(*e, value);
        }
    }
    sum
}

fn mul(a: &Poly, b: &Poly) -> Poly {
    let mut product = Poly::new();
    for ((i, j), p) in a {
        for ((k, l), q) in b {
            *product
                .entry((i + k, j + l))
                .or_insert_with(BigRational::zero) += p * q;
        }
    }
    product.retain(|_, c| !c.is_zero());
    product
}

fn pow(a: &Poly, n: usize) -> Poly {
    (0..n).fold(term((0, 0), BigRational::one()), |p, _| mul(&p, a))
}

fn term(e: (usize, usize), c: BigRational) -> Poly {
    if c.is_zero() {
        Poly::new()
    } else {
        Poly::from([(e, c)])
    }
}

/// F by Eqs. (7) and (8) as printed, monic, in canonical term order.
pub(crate) fn theorem_2(r: &FourierRadius) -> Vec<((usize, usize), BigRational)> {
    let n = r.harmonics();
    let (x, y) = (
        term((1, 0), BigRational::one()),
        term((0, 1), BigRational::one()),
    );
    let rho = add(&mul(&x, &x), &mul(&y, &y), 1);
    // K_m = a_m Re (x+iy)^m + b_m Im (x+iy)^m
    let mut k = Vec::new();
    let (mut re, mut im) = (pow(&x, 0), Poly::new());
    for m in 0..=n {
        let a = term((0, 0), BigRational::from(r.cos(m)));
        let b = term((0, 0), BigRational::from(r.sin(m)));
        k.push(add(&mul(&a, &re), &mul(&b, &im), 1));
        (re, im) = (
            add(&mul(&re, &x), &mul(&im, &y), -1),
            add(&mul(&re, &y), &mul(&im, &x), 1),
        );
    }
    let sum = |parity: usize, top: usize| {
        (parity..=n).step_by(2).fold(Poly::new(), |s, m| {
            add(&s, &mul(&k[m], &pow(&rho, (top - m) / 2)), 1)
        })
    };
    let f = if n.is_multiple_of(2) {
        let odd = if n == 0 { Poly::new() } else { sum(1, n - 1) };
        let left = add(&pow(&rho, n / 2), &odd, -1);
        let right = sum(0, n);
        add(&mul(&rho, &mul(&left, &left)), &mul(&right, &right), -1)
    } else {
        let left = add(&pow(&rho, n.div_ceil(2)), &sum(1, n), -1);
        let right = sum(0, n - 1);
        add(&mul(&left, &left), &mul(&rho, &mul(&right, &right)), -1)
    };
    let mut terms: Vec<_> = f.into_iter().collect();
    terms.sort_by(|((i, j), _), ((k, l), _)| (k + l, k).cmp(&(i + j, i)));
    terms
}
