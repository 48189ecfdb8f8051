//! Polynomials in x, y and z, as lists of homogeneous parts.

use std::collections::BTreeMap;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Lcm};
use malachite::base::num::basic::traits::One;

use super::ternary_terms::{multiply_by_power, on_meridian, value};
use super::{BinaryForm, PlanePolynomial, SparsePolynomial, TernaryForm};
use crate::bigint::content;
use crate::error::Invariant;
use crate::exact::Rational;

/// A polynomial in x, y and z, stored as its non-zero homogeneous parts over one common denominator: `f = (1/D) Σ_d f_d`. It
/// corresponds to [`PlanePolynomial`]. Its terms and values are those of the [`SparsePolynomial`] that it is made from.
///
/// A part is stored as its terms: a form of degree d has (d + 1)(d + 2)/2 coefficients, and most of them are 0 if the degree is
/// high.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpacePolynomial {
    /// The terms of every part in descending lexicographic order of their exponents.
    parts: BTreeMap<usize, Vec<([usize; 3], Integer)>>,
    denominator: Integer,
}

impl SpacePolynomial {
    /// The polynomial with coprime integer coefficients that is a positive multiple of the sum of forms of different degrees.
    ///
    /// # Panics
    /// If two forms have the same degree.
    pub(crate) fn primitive(forms: impl IntoIterator<Item = TernaryForm>) -> Self {
        let mut parts: BTreeMap<usize, Vec<([usize; 3], Integer)>> = BTreeMap::new();
        for form in forms.into_iter().filter(|form| !form.is_zero()) {
            let degree = form.degree();
            let before = parts.insert(degree, form.into_terms().collect());
            assert!(
                before.is_none(),
                "a polynomial has one part of degree {degree}"
            );
        }
        let coefficients = || parts.values().flatten().map(|(_, c)| c);
        let content = content(coefficients());
        for (_, c) in parts.values_mut().flatten() {
            content.divide(c);
        }
        Self {
            parts,
            denominator: Integer::ONE,
        }
    }

    /// The largest total degree; `None` for the zero polynomial.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.parts.keys().next_back().copied()
    }

    /// The degrees of the homogeneous parts, descending.
    #[must_use]
    pub fn homogeneous_degrees(&self) -> Vec<usize> {
        self.parts.keys().rev().copied().collect()
    }

    /// D times the homogeneous part of the given degree; the zero form if there is no such part.
    ///
    /// Memory: the rows of the [`TernaryForm`], each up to its largest power of y.
    pub(crate) fn part(&self, degree: usize) -> TernaryForm {
        let terms = self.parts.get(&degree).into_iter().flatten().cloned();
        TernaryForm::from_terms(degree, terms)
    }

    /// The degrees of the parts, descending, each with the terms (of D times the part) as exponents of x, y, z and coefficient,
    /// in descending lexicographic order of the exponents.
    pub(crate) fn parts(
        &self,
    ) -> impl DoubleEndedIterator<Item = (usize, &[([usize; 3], Integer)])> {
        let parts = self.parts.iter().rev();
        parts.map(|(degree, terms)| (*degree, terms.as_slice()))
    }

    /// The degrees of the parts, descending, each with the value of D times the part at an integer vector.
    pub(crate) fn values_at(
        &self,
        vector: &[Integer; 3],
    ) -> impl Iterator<Item = (usize, Integer)> {
        self.parts()
            .map(|(degree, terms)| (degree, value(terms, vector.each_ref())))
    }

    /// The common denominator D of the parts.
    pub(crate) fn denominator(&self) -> &Integer {
        &self.denominator
    }

    /// The polynomial on the half plane through the z axis and (a, b, 0), where a² + b² = c². It is `f(aY/c, bY/c, X)` in (X,
    /// Y), and the polar angle of (X, Y) is φ.
    pub(crate) fn on_meridian(&self, a: &Integer, b: &Integer, c: &Integer) -> PlanePolynomial {
        let Some(top) = self.degree() else {
            return PlanePolynomial::from_parts([], Integer::ONE);
        };
        let mut above = top;
        let mut power = Integer::ONE;
        let mut parts: Vec<BinaryForm> = Vec::new();
        for (degree, terms) in self.parts() {
            multiply_by_power(&mut power, c, above - degree);
            above = degree;
            parts.push(on_meridian(degree, terms, [a, b, c]).scaled(&power));
        }
        // Every part is multiplied by c^top, and so is the denominator.
        let mut scale = self.denominator.clone();
        multiply_by_power(&mut scale, c, top);
        PlanePolynomial::from_parts(parts, scale)
    }
}

impl From<&SparsePolynomial<3>> for SpacePolynomial {
    fn from(f: &SparsePolynomial<3>) -> Self {
        let denominator = f.terms().fold(Integer::ONE, |d, (_, c)| {
            let other = c.denominator();
            Integer::from(d.unsigned_abs_ref().lcm(other.unsigned_abs_ref()))
        });
        let mut parts: BTreeMap<usize, Vec<([usize; 3], Integer)>> = BTreeMap::new();
        for (exponents, c) in f.terms() {
            let exponents = exponents.map(|e| e as usize);
            let numerator = c.numerator() * (&denominator).div_exact(c.denominator());
            let degree = exponents.iter().sum();
            parts
                .entry(degree)
                .or_default()
                .push((exponents, numerator));
        }
        for part in parts.values_mut() {
            part.sort_unstable_by(|(e, _), (next, _)| next.cmp(e));
        }
        Self { parts, denominator }
    }
}

impl From<&SpacePolynomial> for SparsePolynomial<3> {
    fn from(f: &SpacePolynomial) -> Self {
        let exponent = |e: usize| u32::try_from(e).invariant("degrees are below 2^32");
        let terms = f.parts().flat_map(|(_, terms)| terms);
        Self::from_terms(terms.map(|(e, c)| {
            let quotient = Rational::from_integers(c.clone(), f.denominator.clone());
            (
                e.map(exponent),
                quotient.invariant("a denominator is not 0"),
            )
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sparse() -> impl Strategy<Value = SparsePolynomial<3>> {
        let exponent = || prop_oneof![4 => 0u32..6, 1 => 6u32..40];
        let term = ([exponent(), exponent(), exponent()], -9i64..10, 1i64..5);
        prop::collection::vec(term, 1..12).prop_map(|terms| {
            let ratio = |n: i64, d: i64| Rational::from_integers(n.into(), d.into()).unwrap();
            SparsePolynomial::from_terms(terms.into_iter().map(|(e, n, d)| (e, ratio(n, d))))
        })
    }

    proptest! {
        /// The parts have the values of the polynomial, and are equal to dense forms.
        #[test]
        fn parts_have_the_values_of_the_polynomial(f in sparse(), at in prop::array::uniform3(-9i64..10)) {
            let parts = SpacePolynomial::from(&f);
            prop_assert_eq!(&SparsePolynomial::from(&parts), &f);
            let forms = parts.homogeneous_degrees().into_iter().map(|d| parts.part(d));
            let primitive = SpacePolynomial::primitive(forms);
            prop_assert_eq!(&primitive, &SpacePolynomial::from(&SparsePolynomial::from(&primitive)));
            prop_assert_eq!(SparsePolynomial::from(&primitive).primitive(), f.primitive());
            let at = at.map(Integer::from);
            let sum = parts.values_at(&at).map(|(_, value)| value).sum::<Integer>();
            let value = f.evaluate(&at.each_ref().map(Rational::whole));
            prop_assert_eq!(Rational::whole(sum), value * Rational::whole(parts.denominator()));
            for (degree, value) in parts.values_at(&at) {
                prop_assert_eq!(parts.part(degree).evaluate(&at), value);
            }
        }

        /// On a meridian a part is the binary form that the dense part has there, with the same values.
        #[test]
        fn meridians_are_those_of_dense_forms(f in sparse(), x in -9i64..10, y in -9i64..10) {
            let [a, b, c] = [3, 4, 5].map(Integer::from);
            for (degree, terms) in SpacePolynomial::from(&f).parts() {
                let dense = TernaryForm::from_terms(degree, terms.iter().cloned());
                let found = on_meridian(degree, terms, [&a, &b, &c]);
                prop_assert_eq!(&found, &dense.on_meridian(&a, &b, &c));
                let value = dense.evaluate(&[3 * y, 4 * y, 5 * x].map(Integer::from));
                prop_assert_eq!(found.evaluate(&x.into(), &y.into()), value);
            }
        }
    }

    #[test]
    fn high_powers_take_little_memory() {
        let z = SparsePolynomial::from_terms([([0, 0, 4_000_000_000], Rational::one())]);
        let parts = SpacePolynomial::from(&z);
        assert_eq!(parts.homogeneous_degrees(), [4_000_000_000]);
        assert_eq!(
            parts.values_at(&[5.into(), 7.into(), 1.into()]).next(),
            Some((4_000_000_000, Integer::ONE))
        );
    }
}
