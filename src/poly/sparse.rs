//! Sparse polynomials in a fixed number of variables.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::{PlanePolynomial, Ring};
use crate::error::Invariant;
use crate::exact::Rational;

/// A polynomial in `V` variables with exact rational coefficients, as a map from exponents.
///
/// This type is for polynomials that come from text or have symbols as coefficients. Computations with curves use
/// [`PlanePolynomial`].
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct SparsePolynomial<const V: usize> {
    terms: BTreeMap<Exponents<V>, Rational>,
}

/// Exponents in canonical order: [`term_order`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Exponents<const V: usize>([u32; V]);

/// The order of terms in everything that is written: by total degree, then by exponents, both descending. `Less` comes first.
#[must_use]
pub(crate) fn term_order<const V: usize>(a: &[u32; V], b: &[u32; V]) -> Ordering {
    total_degree(b).cmp(&total_degree(a)).then_with(|| b.cmp(a))
}

/// The sum of the exponents of a monomial.
#[must_use]
pub(crate) fn total_degree<const V: usize>(exponents: &[u32; V]) -> u64 {
    exponents.iter().map(|&e| u64::from(e)).sum()
}

impl<const V: usize> PartialOrd for Exponents<V> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const V: usize> Ord for Exponents<V> {
    fn cmp(&self, other: &Self) -> Ordering {
        term_order(&self.0, &other.0)
    }
}

impl<const V: usize> SparsePolynomial<V> {
    /// The zero polynomial.
    #[must_use]
    pub fn zero() -> Self {
        Self {
            terms: BTreeMap::new(),
        }
    }

    /// The constant polynomial with this value.
    #[must_use]
    pub fn constant(value: Rational) -> Self {
        Self::from_terms([([0; V], value)])
    }

    /// The variable with the given index.
    ///
    /// # Panics
    /// If there is no such variable.
    #[must_use]
    pub fn variable(index: usize) -> Self {
        let mut exponents = [0; V];
        exponents[index] = 1;
        Self::from_terms([(exponents, Rational::one())])
    }

    /// The sum of the given terms.
    #[must_use]
    pub fn from_terms(terms: impl IntoIterator<Item = ([u32; V], Rational)>) -> Self {
        let mut sum = Self::zero();
        for (exponents, coefficient) in terms {
            sum.add_term(exponents, coefficient);
        }
        sum
    }

    /// Adds `coefficient · x^exponents` in place.
    pub fn add_term(&mut self, exponents: [u32; V], coefficient: Rational) {
        use std::collections::btree_map::Entry;
        match self.terms.entry(Exponents(exponents)) {
            Entry::Vacant(slot) => {
                if !coefficient.is_zero() {
                    slot.insert(coefficient);
                }
            }
            Entry::Occupied(mut slot) => {
                let sum = slot.get() + &coefficient;
                if sum.is_zero() {
                    slot.remove();
                } else {
                    slot.insert(sum);
                }
            }
        }
    }

    /// Adds `factor · other` in place. Cost: linear in the length of `other`, so that long sums stay cheap.
    pub fn add_multiple(&mut self, other: &Self, factor: &Rational) {
        for (exponents, coefficient) in &other.terms {
            self.add_term(exponents.0, coefficient * factor);
        }
    }

    /// The non-zero terms in canonical order.
    pub fn terms(&self) -> impl Iterator<Item = (&[u32; V], &Rational)> {
        self.terms.iter().map(|(e, c)| (&e.0, c))
    }

    /// The number of non-zero terms.
    #[must_use]
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether this is the zero polynomial.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// The largest total degree; `None` for the zero polynomial.
    #[must_use]
    pub fn degree(&self) -> Option<u64> {
        self.terms.keys().next().map(|e| total_degree(&e.0))
    }

    /// The degree in one variable; 0 for the zero polynomial.
    #[must_use]
    pub fn degree_in(&self, variable: usize) -> u32 {
        self.terms().map(|(e, _)| e[variable]).max().unwrap_or(0)
    }

    /// The value, if the polynomial is a constant.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        match self.degree() {
            None => Some(Rational::zero()),
            Some(0) => self.terms.values().next().cloned(),
            Some(_) => None,
        }
    }

    /// The value at a point. Cost: a power of every coordinate for every term.
    #[must_use]
    pub fn evaluate(&self, at: &[Rational; V]) -> Rational {
        self.terms.iter().fold(Rational::zero(), |sum, (e, c)| {
            let powers = e.0.iter().zip(at);
            let monomial = powers.fold(c.clone(), |product, (&k, value)| {
                let power = value.pow(i64::from(k));
                product * power.invariant("a power with a natural exponent exists")
            });
            sum + monomial
        })
    }

    /// The derivative with respect to the variable with this index.
    #[must_use]
    pub fn derivative(&self, variable: usize) -> Self {
        let terms = self.terms.iter().filter(|(e, _)| e.0[variable] > 0);
        Self::from_terms(terms.map(|(e, c)| {
            let mut exponents = e.0;
            exponents[variable] -= 1;
            (exponents, c * &Rational::from(i64::from(e.0[variable])))
        }))
    }

    /// The product `factor · self`.
    #[must_use]
    pub fn scaled(&self, factor: &Rational) -> Self {
        let mut result = Self::zero();
        result.add_multiple(self, factor);
        result
    }

    /// The primitive part: the multiple with coprime integer coefficients whose first coefficient is positive.
    #[must_use]
    pub fn primitive(&self) -> Self {
        use malachite::base::num::arithmetic::traits::{Gcd, Lcm};
        use malachite::{Integer, Natural};
        let (mut numerator, mut denominator) = (Natural::from(0u32), Natural::from(1u32));
        for c in self.terms.values() {
            numerator = numerator.gcd(c.numerator().unsigned_abs_ref());
            denominator = denominator.lcm(c.denominator().unsigned_abs_ref());
        }
        let first_is_negative = self.terms.values().next().is_some_and(|c| c.signum() < 0);
        let content = Integer::from_sign_and_abs(!first_is_negative, numerator);
        match Rational::from_integers(Integer::from(denominator), content) {
            Some(factor) => self.scaled(&factor),
            None => self.clone(),
        }
    }

    /// The multiple whose first coefficient is 1.
    #[must_use]
    pub fn monic(&self) -> Self {
        let first = self.terms.values().next().and_then(Rational::recip);
        first.map_or_else(|| self.clone(), |factor| self.scaled(&factor))
    }

    /// The power `self^exponent`, by repeated squaring.
    ///
    /// # Panics
    /// If an exponent of the power is 2^32 or more.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Self {
        let mut result = Self::constant(Rational::one());
        let mut square = self.clone();
        let mut rest = exponent;
        while rest > 0 {
            if rest & 1 == 1 {
                result = result.times(&square);
            }
            rest >>= 1;
            if rest > 0 {
                square = square.squared();
            }
        }
        result
    }
}

impl<const V: usize> Ring for SparsePolynomial<V> {
    fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.add_multiple(other, &Rational::one());
        sum
    }

    fn minus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.add_multiple(other, &Rational::from(-1));
        sum
    }

    /// # Panics
    /// If an exponent of the product is 2^32 or more.
    fn times(&self, other: &Self) -> Self {
        let mut product = Self::zero();
        for (a, p) in &self.terms {
            for (b, q) in &other.terms {
                let sum = |i: usize| {
                    a.0[i]
                        .checked_add(b.0[i])
                        .invariant("exponents are below 2^32")
                };
                product.add_term(std::array::from_fn(sum), p * q);
            }
        }
        product
    }
}

impl SparsePolynomial<3> {
    /// The polynomial in x and y; `None` if z occurs.
    #[must_use]
    pub fn to_plane(&self) -> Option<PlanePolynomial> {
        if self.terms.keys().any(|e| e.0[2] != 0) {
            return None;
        }
        Some(PlanePolynomial::from_terms(self.terms.iter().map(
            |(e, c)| ((e.0[0] as usize, e.0[1] as usize), c.clone()),
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn monomial(exponents: [u32; 2]) -> SparsePolynomial<2> {
        SparsePolynomial::from_terms([(exponents, Rational::one())])
    }

    #[test]
    fn exponents_add_up_to_the_largest_there_is() {
        let product = monomial([u32::MAX - 3, 7]).times(&monomial([3, u32::MAX - 7]));
        assert_eq!(product, monomial([u32::MAX, u32::MAX]));
        assert_eq!(product.degree(), Some(2 * u64::from(u32::MAX)));
    }

    #[test]
    #[should_panic(expected = "exponents are below 2^32")]
    fn a_product_with_a_larger_exponent_stops() {
        let _ = monomial([u32::MAX, 0]).times(&monomial([1, 0]));
    }

    #[test]
    #[should_panic(expected = "exponents are below 2^32")]
    fn a_power_with_a_larger_exponent_stops() {
        let _ = monomial([0, 1 << 16]).pow(1 << 16);
    }
}
