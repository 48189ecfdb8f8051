//! Polynomials as sorted terms over num-bigint: schoolbook products, values, texts.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use stellate::exact::Rational;
use stellate::poly::{PlanePolynomial, SparsePolynomial};

use super::draw::Draw;
use super::exact::Q;

/// Exponents and coefficients, none of them 0.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Terms<const V: usize>(pub(crate) BTreeMap<[u32; V], BigInt>);

impl<const V: usize> Terms<V> {
    pub(crate) fn new(terms: impl IntoIterator<Item = ([u32; V], BigInt)>) -> Self {
        let mut sum = Self(BTreeMap::new());
        for (exponents, c) in terms {
            *sum.0.entry(exponents).or_default() += c;
        }
        sum.0.retain(|_, c| !c.is_zero());
        sum
    }

    pub(crate) fn constant(c: BigInt) -> Self {
        Self::new([([0; V], c)])
    }

    pub(crate) fn variable(v: usize) -> Self {
        let mut exponents = [0; V];
        exponents[v] = 1;
        Self::new([(exponents, BigInt::one())])
    }

    /// Σ c_v x_v + c
    pub(crate) fn linear(coefficients: &[BigInt; V], constant: BigInt) -> Self {
        let variables = coefficients.iter().enumerate().map(|(v, c)| {
            let mut exponents = [0; V];
            exponents[v] = 1;
            (exponents, c.clone())
        });
        Self::new(variables.chain([([0; V], constant)]))
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut product = BTreeMap::<[u32; V], BigInt>::new();
        for (e, a) in &self.0 {
            for (f, b) in &other.0 {
                let exponents = std::array::from_fn(|v| e[v] + f[v]);
                *product.entry(exponents).or_default() += a * b;
            }
        }
        product.retain(|_, c| !c.is_zero());
        Self(product)
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        let terms = self.0.iter().chain(&other.0);
        Self::new(terms.map(|(e, c)| (*e, c.clone())))
    }

    pub(crate) fn scaled(&self, factor: &BigInt) -> Self {
        Self::new(self.0.iter().map(|(e, c)| (*e, c * factor)))
    }

    pub(crate) fn power(&self, exponent: usize) -> Self {
        let one = Self::constant(BigInt::one());
        (0..exponent).fold(one, |power, _| power.times(self))
    }

    pub(crate) fn degree(&self) -> u32 {
        let degrees = self.0.keys().map(|e| e.iter().sum());
        degrees.max().unwrap_or(0)
    }

    pub(crate) fn value_at(&self, at: &[Q; V]) -> Q {
        value_of(
            self.0.iter().map(|(e, c)| (*e, Q::from_integer(c.clone()))),
            at,
        )
    }

    /// Every variable replaced by a polynomial.
    pub(crate) fn substituted(&self, variables: &[Self; V]) -> Self {
        let mut sum = Self::default();
        for (e, c) in &self.0 {
            let mut term = Self::constant(c.clone());
            for (variable, &exponent) in variables.iter().zip(e) {
                term = term.times(&variable.power(exponent as usize));
            }
            sum = sum.plus(&term);
        }
        sum
    }

    /// The first term positive in the order of total degrees, no common divisor.
    pub(crate) fn canonical(&self) -> Self {
        let content = self
            .0
            .values()
            .fold(BigInt::zero(), |g, c| super::exact::gcd(&g, c));
        let first = self.0.iter().max_by(|(e, _), (f, _)| {
            let degree = |e: &[u32; V]| e.iter().sum::<u32>();
            degree(e).cmp(&degree(f)).then(e.cmp(f))
        });
        let negative = first.is_some_and(|(_, c)| c.is_negative());
        let content = if negative { -content } else { content };
        Self(self.0.iter().map(|(e, c)| (*e, c / &content)).collect())
    }

    pub(crate) fn text(&self) -> String {
        let mut text = String::new();
        for (e, c) in &self.0 {
            let _ = write!(
                text,
                "{}{}",
                if c.is_negative() { " - " } else { " + " },
                c.abs()
            );
            for (v, k) in e.iter().enumerate() {
                if *k > 0 {
                    let _ = write!(text, "*{}^{k}", ["x", "y", "z"][v]);
                }
            }
        }
        if text.is_empty() { "0".into() } else { text }
    }
}

impl Terms<2> {
    pub(crate) fn to_plane(&self) -> PlanePolynomial {
        PlanePolynomial::from_terms(
            self.0
                .iter()
                .map(|(e, c)| ((e[0] as usize, e[1] as usize), Rational::from(c))),
        )
    }
}

impl Terms<3> {
    pub(crate) fn to_sparse(&self) -> SparsePolynomial<3> {
        SparsePolynomial::from_terms(self.0.iter().map(|(e, c)| (*e, Rational::from(c))))
    }
}

/// The value of a sum of terms.
pub(crate) fn value_of<const V: usize>(
    terms: impl IntoIterator<Item = ([u32; V], BigRational)>,
    at: &[Q; V],
) -> Q {
    let mut powers: Vec<Vec<Q>> = vec![vec![Q::one()]; V];
    let mut sum = Q::zero();
    for (e, c) in terms {
        let mut term = c;
        for v in 0..V {
            let known = &mut powers[v];
            while known.len() <= e[v] as usize {
                let next = &known[known.len() - 1] * &at[v];
                known.push(next);
            }
            term *= &known[e[v] as usize];
        }
        sum += term;
    }
    sum
}

/// The terms of a plane polynomial of the program, over num-rational.
pub(crate) fn plane_terms(f: &PlanePolynomial) -> Vec<([u32; 2], Q)> {
    f.terms()
        .map(|((i, j), c)| ([i as u32, j as u32], Q::from(&c)))
        .collect()
}

/// Likewise in space.
pub(crate) fn space_terms(f: &SparsePolynomial<3>) -> Vec<([u32; 3], Q)> {
    f.terms().map(|(e, c)| (*e, Q::from(c))).collect()
}

/// A few terms up to a degree, with coefficients of up to so many bits; never constant.
pub(crate) fn random<const V: usize>(draw: &mut Draw, degree: u32, bits: u64) -> Terms<V> {
    loop {
        let count = 2 + draw.below(6);
        let mut terms = Vec::new();
        for _ in 0..count {
            let mut left = draw.below(u64::from(degree) + 1) as u32;
            let mut exponents = [0; V];
            for e in &mut exponents {
                *e = draw.below(u64::from(left) + 1) as u32;
                left -= *e;
            }
            let length = 1 + draw.below(bits);
            terms.push((exponents, draw.integer(length)));
        }
        let f = Terms::new(terms);
        if f.degree() > 0 {
            return f;
        }
    }
}
