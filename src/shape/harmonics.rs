//! Rational functions of s = tan(g·t/2) are written as quotients of finite Fourier series.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Lcm};
use malachite::base::num::basic::traits::{One, Zero};

use super::Parameter;
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{BinaryForm, SparsePolynomial, harmonics_of_form};

/// A factor of a term: a power of a number, or a harmonic of an angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Basis {
    Power(usize),
    Cos(usize),
    Sin(usize),
}

impl Basis {
    /// Powers descend, harmonics ascend; 1 is `Power(0)` in both.
    fn key(self) -> (bool, usize, usize) {
        match self {
            Basis::Power(k) => (false, usize::MAX - k, 0),
            Basis::Cos(n) => (true, n, 0),
            Basis::Sin(n) => (true, n, 1),
        }
    }
}

impl Ord for Basis {
    fn cmp(&self, other: &Self) -> Ordering {
        self.key().cmp(&other.key())
    }
}

impl PartialOrd for Basis {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// A polynomial in at most two parameters, by its terms.
pub(crate) type Expansion = BTreeMap<[Basis; 2], Rational>;

/// The numerator and the denominator in powers of numbers and harmonics of angles. For angles both are divided by the same
/// power of 1 + s².
pub(crate) fn quotient_in_harmonics(
    [above, below]: [&SparsePolynomial<2>; 2],
    parameters: &[Parameter],
) -> [Expansion; 2] {
    let degree = |v: usize| {
        let terms = above.terms().chain(below.terms());
        let degree = terms.map(|(e, _)| e[v]).max();
        let degree = degree.invariant("a denominator has a term");
        // The forms must have an even degree, so that only harmonics of the whole angle occur.
        degree.next_multiple_of(2)
    };
    let degrees = [degree(0), degree(1)];
    [above, below].map(|f| expand(f, parameters, degrees))
}

/// The coefficients in powers of numbers and harmonics of angles; for angles, those of f/∏ (1 + s²)^(degree/2).
fn expand(f: &SparsePolynomial<2>, parameters: &[Parameter], degrees: [u32; 2]) -> Expansion {
    let power = |e: u32| Basis::Power(e as usize);
    let terms = f.terms().map(|(e, c)| (e.map(power), c.clone()));
    let mut table: BTreeMap<[Basis; 2], Rational> = terms.collect();
    for (v, parameter) in parameters.iter().enumerate() {
        if !parameter.is_angle() {
            continue;
        }
        let mut rows: BTreeMap<Basis, Vec<Rational>> = BTreeMap::new();
        for (basis, c) in table {
            let row = rows.entry(basis[1 - v]).or_default();
            let Basis::Power(k) = basis[v] else { continue };
            row.resize(row.len().max(k + 1), Rational::zero());
            row[k] = c;
        }
        table = BTreeMap::new();
        for (other, row) in rows {
            for (n, a, b) in harmonics(&row, degrees[v] as usize) {
                // All harmonics of the half angle are even.
                let n = n / 2;
                let cosine = if n == 0 {
                    Basis::Power(0)
                } else {
                    Basis::Cos(n)
                };
                for (basis, c) in [(cosine, a), (Basis::Sin(n), b)] {
                    let mut key = [other; 2];
                    key[v] = basis;
                    if !c.is_zero() {
                        table.insert(key, c);
                    }
                }
            }
        }
    }
    table
}

/// The harmonics of the form Σ c_k cos^(d−k) sin^k of the half angle.
fn harmonics(coefficients: &[Rational], degree: usize) -> Vec<(usize, Rational, Rational)> {
    let denominator = coefficients.iter().fold(Integer::ONE, |d, c| {
        Integer::from(d.unsigned_abs_ref().lcm(c.denominator().unsigned_abs_ref()))
    });
    let mut integers: Vec<Integer> = coefficients
        .iter()
        .map(|c| c.numerator() * (&denominator).div_exact(c.denominator()))
        .collect();
    integers.resize(degree + 1, Integer::ZERO);
    let scale = Rational::whole(&denominator);
    let form = BinaryForm::from_coefficients(integers);
    harmonics_of_form(&form)
        .into_iter()
        .map(|(n, a, b)| (n, a / &scale, b / &scale))
        .collect()
}
