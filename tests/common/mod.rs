//! Shared inputs and oracles.
#![allow(dead_code, reason = "every test file uses its own part of this")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

pub(crate) mod dense;
pub(crate) mod documentation;
pub(crate) mod float_program;
pub(crate) mod forms;
pub(crate) mod oracle_theorem_2;
#[path = "../../src/fit/reading/encoded.rs"]
pub(crate) mod pictures;
pub(crate) mod program;
pub(crate) mod proofs;
pub(crate) mod random;
pub(crate) mod schemas;
pub(crate) mod sturm;
pub(crate) mod wrong_proofs;

use proptest::prelude::*;
use stellate::exact::Rational;
use stellate::poly::PlanePolynomial;
use stellate::shape::FourierRadius;

/// Small rationals, zero among them.
pub(crate) fn rational() -> impl Strategy<Value = Rational> {
    prop_oneof![
        1 => Just(Rational::zero()),
        6 => (-60i64..60, 1i64..12).prop_map(|(p, q)| Rational::from(p) / Rational::from(q)),
        1 => any::<f64>().prop_filter_map("finite", |v| Rational::try_from(v % 8.0).ok()),
    ]
}

/// 2^k
pub(crate) fn power_of_two(k: i64) -> Rational {
    Rational::from(2).pow(k).unwrap()
}

/// Fourier radii with up to `harmonics` harmonics, many coefficients zero, never all of them.
pub(crate) fn radii(harmonics: usize) -> impl Strategy<Value = FourierRadius> {
    prop::collection::vec((rational(), rational()), 1..=harmonics + 1)
        .prop_map(|c| {
            let (cos, sin) = c.into_iter().unzip();
            FourierRadius::new(cos, sin)
        })
        .prop_filter("a curve", |r| !r.is_zero())
}

/// r at the point (c, s) of the unit circle, exactly, by the addition theorems.
pub(crate) fn value_at(r: &FourierRadius, c: &Rational, s: &Rational) -> Rational {
    let (mut re, mut im) = (Rational::one(), Rational::zero());
    let mut sum = Rational::zero();
    for n in 0..=r.harmonics() {
        sum = sum + r.cos(n) * &re + r.sin(n) * &im;
        (re, im) = (&re * c - &im * s, &re * s + &im * c);
    }
    sum
}

/// Plane polynomials of degree up to 10 with a few terms; sometimes 0.
pub(crate) fn plane_polynomials() -> impl Strategy<Value = PlanePolynomial> {
    prop::collection::vec(((0usize..6, 0usize..6), rational()), 0..8)
        .prop_map(PlanePolynomial::from_terms)
}
