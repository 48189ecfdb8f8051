//! Polynomials in x, y and z as the list of their homogeneous parts.

use std::collections::BTreeMap;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Lcm};
use malachite::base::num::basic::traits::One;

use super::{BinaryForm, PlanePolynomial, SparsePolynomial, TernaryForm};

/// A polynomial in x, y and z by its non-zero homogeneous parts over one common denominator:
/// `f = (1/D) Σ_d f_d`. The three-dimensional sibling of [`PlanePolynomial`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpacePolynomial {
    parts: BTreeMap<usize, TernaryForm>,
    denominator: Integer,
}

impl SpacePolynomial {
    /// The largest total degree, `None` for the zero polynomial.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.parts.keys().next_back().copied()
    }

    /// The degrees of the homogeneous parts, descending.
    #[must_use]
    pub fn homogeneous_degrees(&self) -> Vec<usize> {
        self.parts.keys().rev().copied().collect()
    }

    /// D times the homogeneous part of the given degree, the zero form if there is none.
    #[must_use]
    pub fn part(&self, degree: usize) -> TernaryForm {
        let part = self.parts.get(&degree).cloned();
        part.unwrap_or_else(|| TernaryForm::zero(degree))
    }

    /// The parts (times D), descending in degree.
    pub fn parts(&self) -> impl DoubleEndedIterator<Item = &TernaryForm> {
        self.parts.values().rev()
    }

    /// D, the common denominator of the parts.
    #[must_use]
    pub fn denominator(&self) -> &Integer {
        &self.denominator
    }

    /// f on the half plane through the z axis and (a, b, 0), with a² + b² = c²: the polynomial
    /// `f(aY/c, bY/c, X)` in (X, Y), whose polar angle is φ.
    #[must_use]
    pub fn on_meridian(&self, a: &Integer, b: &Integer, c: &Integer) -> PlanePolynomial {
        let Some(top) = self.degree() else {
            return PlanePolynomial::from_parts([], Integer::ONE);
        };
        let mut above = top;
        let mut power = Integer::ONE;
        let mut parts: Vec<BinaryForm> = Vec::new();
        for part in self.parts() {
            for _ in part.degree()..above {
                power *= c;
            }
            above = part.degree();
            parts.push(part.on_meridian(a, b, c).scaled(&power));
        }
        // Every part is now c^top too large.
        let scale = (0..top).fold(self.denominator.clone(), |d, _| d * c);
        PlanePolynomial::from_parts(parts, scale)
    }
}

impl From<&SparsePolynomial<3>> for SpacePolynomial {
    fn from(f: &SparsePolynomial<3>) -> Self {
        let denominator = f.terms().fold(Integer::ONE, |d, (_, c)| {
            let other = c.denominator();
            Integer::from(d.unsigned_abs_ref().lcm(other.unsigned_abs_ref()))
        });
        let mut terms: BTreeMap<usize, Vec<([usize; 3], Integer)>> = BTreeMap::new();
        for (exponents, c) in f.terms() {
            let exponents = exponents.map(|e| e as usize);
            let numerator = c.numerator() * (&denominator).div_exact(c.denominator());
            let degree = exponents.iter().sum();
            terms
                .entry(degree)
                .or_default()
                .push((exponents, numerator));
        }
        let parts = terms
            .into_iter()
            .map(|(degree, terms)| (degree, TernaryForm::from_terms(degree, terms)))
            .collect();
        Self { parts, denominator }
    }
}
