//! Polynomials in x and y, as lists of homogeneous parts.

use std::collections::BTreeMap;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Abs, DivExact, Gcd, Lcm};
use malachite::base::num::basic::traits::{One, Zero};

use malachite::base::polynomial::Polynomial;
use num_bigint::BigInt;

use super::{BinaryForm, IntegerPolynomial, Ring, SparsePolynomial};
use crate::error::Invariant;
use crate::exact::{Rational, integer_to_num};

/// A polynomial in x and y, stored as its non-zero homogeneous parts over one common denominator: `f = (1/D) Σ_d f_d`. So the
/// split into homogeneous parts, which is the first step of everything in §3 of the paper, costs nothing.
///
/// Invariants: no part is zero; D > 0 has no common factor with all the coefficients.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanePolynomial {
    parts: BTreeMap<usize, BinaryForm>,
    denominator: Integer,
}

impl PlanePolynomial {
    /// The polynomial `(1/denominator) Σ parts`; parts of equal degree are added.
    ///
    /// # Panics
    /// If the denominator is 0.
    pub(crate) fn from_parts(
        parts: impl IntoIterator<Item = BinaryForm>,
        denominator: Integer,
    ) -> Self {
        assert!(denominator != 0, "the denominator is not 0");
        let mut by_degree: BTreeMap<usize, BinaryForm> = BTreeMap::new();
        for part in parts {
            let sum = match by_degree.remove(&part.degree()) {
                Some(other) => other.plus(&part),
                None => part,
            };
            by_degree.insert(sum.degree(), sum);
        }
        by_degree.retain(|_, part| !part.is_zero());
        let mut result = Self {
            parts: by_degree,
            denominator,
        };
        result.reduce();
        result
    }

    /// The polynomial with the terms `((i, j), c)`, each of which means `c x^i y^j`; terms with equal exponents are added.
    #[must_use]
    pub fn from_terms(terms: impl IntoIterator<Item = ((usize, usize), Rational)>) -> Self {
        let terms: Vec<_> = terms.into_iter().collect();
        let denominator = terms
            .iter()
            .fold(Integer::ONE, |d, (_, c)| lcm(d, &c.denominator()));
        let mut rows: BTreeMap<usize, Vec<Integer>> = BTreeMap::new();
        for ((i, j), c) in terms {
            let degree = i
                .checked_add(j)
                .invariant("a form of this degree fits in memory");
            let row = rows
                .entry(degree)
                .or_insert_with(|| vec![Integer::ZERO; degree + 1]);
            row[j] += c.numerator() * (&denominator).div_exact(c.denominator());
        }
        Self::from_parts(
            rows.into_values().map(BinaryForm::from_coefficients),
            denominator,
        )
    }

    fn reduce(&mut self) {
        if self.denominator < 0 {
            self.denominator = -std::mem::take(&mut self.denominator);
            for part in self.parts.values_mut() {
                *part = part.scaled(&Integer::from(-1));
            }
        }
        if self.parts.is_empty() {
            self.denominator = Integer::ONE;
        }
        if self.denominator == 1 {
            return;
        }
        let mut common = self.denominator.clone();
        for part in self.parts.values() {
            common = gcd(common, &part.content());
            if common == 1 {
                return;
            }
        }
        for part in self.parts.values_mut() {
            *part = part.div_exact(&common);
        }
        self.denominator = (&self.denominator).div_exact(&common);
    }

    /// The largest total degree; `None` for the zero polynomial.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.parts.keys().next_back().copied()
    }

    /// The smallest total degree of a term, which is the multiplicity of the origin; `None` for 0.
    #[must_use]
    pub fn lowest_degree(&self) -> Option<usize> {
        self.parts.keys().next().copied()
    }

    /// Whether this is the zero polynomial.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.parts.is_empty()
    }

    /// The degrees of the homogeneous parts, descending.
    #[must_use]
    pub fn homogeneous_degrees(&self) -> Vec<usize> {
        self.parts.keys().rev().copied().collect()
    }

    /// D times the homogeneous part of the given degree; `None` if it is zero.
    #[must_use]
    pub fn part(&self, degree: usize) -> Option<&BinaryForm> {
        self.parts.get(&degree)
    }

    /// The homogeneous parts, times D, descending in degree.
    pub fn parts(&self) -> impl DoubleEndedIterator<Item = &BinaryForm> {
        self.parts.values().rev()
    }

    /// The common denominator D of the parts.
    #[must_use]
    pub fn common_denominator(&self) -> BigInt {
        integer_to_num(&self.denominator)
    }

    /// A reference to the denominator D.
    pub(crate) fn denominator(&self) -> &Integer {
        &self.denominator
    }

    /// The non-zero terms `((i, j), c)` in canonical order: by total degree, then by the exponent
    /// of x, both descending.
    pub fn terms(&self) -> impl Iterator<Item = ((usize, usize), Rational)> {
        self.integer_terms().map(|(exponents, c)| {
            let coefficient = Rational::whole(c) / Rational::whole(&self.denominator);
            (exponents, coefficient)
        })
    }

    /// The terms of D·f, by reference, in the same order.
    pub(crate) fn integer_terms(&self) -> impl Iterator<Item = ((usize, usize), &Integer)> {
        self.parts()
            .flat_map(|part| part.terms().map(|(k, c)| ((part.degree() - k, k), c)))
    }

    /// The number of non-zero terms.
    #[must_use]
    pub fn term_count(&self) -> usize {
        self.parts.values().map(|p| p.terms().count()).sum()
    }

    /// The first coefficient in canonical order; `None` for 0.
    #[must_use]
    pub fn first_coefficient(&self) -> Option<Rational> {
        self.terms().next().map(|(_, c)| c)
    }

    /// The primitive part: the multiple with coprime integer coefficients whose first coefficient is positive.
    #[must_use]
    pub fn primitive(&self) -> Self {
        self.clone().into_primitive()
    }

    /// The primitive part, in place. A polynomial that is primitive is returned unchanged.
    #[must_use]
    pub fn into_primitive(mut self) -> Self {
        let mut content = Integer::ZERO;
        for part in self.parts.values() {
            content = gcd(content, &part.content());
            if content == 1 {
                break;
            }
        }
        if self.integer_terms().next().is_some_and(|(_, c)| *c < 0) {
            content = -content;
        }
        if content != 0 && content != 1 {
            for part in self.parts.values_mut() {
                *part = part.div_exact(&content);
            }
        }
        self.denominator = Integer::ONE;
        self
    }

    /// The multiple whose first coefficient is 1.
    #[must_use]
    pub fn monic(&self) -> Self {
        let primitive = self.primitive();
        match primitive.first_coefficient() {
            Some(first) => Self::from_parts(primitive.parts.into_values(), first.numerator()),
            None => primitive,
        }
    }

    /// The exact value at a rational point.
    #[must_use]
    pub fn evaluate(&self, x: &Rational, y: &Rational) -> Rational {
        // x = u/w, y = v/w: f_d(x, y) = f_d(u, v) / w^d.
        let w = lcm(x.denominator(), &y.denominator());
        let scale = Rational::whole(&w);
        let u = (x * &scale).numerator();
        let v = (y * &scale).numerator();
        let mut value = Rational::zero();
        let mut above = None;
        for part in self.parts() {
            if let Some(d) = above {
                value = value / power(&scale, d - part.degree());
            }
            value = value + Rational::whole(part.evaluate(&u, &v));
            above = Some(part.degree());
        }
        value / power(&scale, above.unwrap_or(0)) / Rational::whole(&self.denominator)
    }

    /// The polynomial `f(x − a, y − b)`, whose curve is moved by (a, b). It is dense, with about d²/2 terms.
    ///
    /// Cost: two passes of Taylor shifts, which take O(d³) additions of growing numbers (d² log d products for large d).
    #[must_use]
    pub fn translated(&self, a: &Rational, b: &Rational) -> Self {
        let Some(degree) = self.degree() else {
            return self.clone();
        };
        // rows[j][i] is the coefficient of x^i y^j.
        let mut rows = vec![Vec::new(); degree + 1];
        for ((i, j), c) in self.terms() {
            let row: &mut Vec<Rational> = &mut rows[j];
            row.resize(row.len().max(i + 1), Rational::zero());
            row[i] = c;
        }
        for row in &mut rows {
            shift_rational(row, &-a.clone());
        }
        let mut terms = Vec::new();
        for i in 0..=degree {
            let mut column: Vec<Rational> = rows
                .iter()
                .map(|row| row.get(i).cloned().unwrap_or_default())
                .collect();
            shift_rational(&mut column, &-b.clone());
            terms.extend(
                column
                    .into_iter()
                    .enumerate()
                    .filter(|(_, c)| !c.is_zero())
                    .map(|(j, c)| ((i, j), c)),
            );
        }
        Self::from_terms(terms)
    }

    /// The largest bit length of a coefficient of the primitive part.
    #[must_use]
    pub fn coefficient_bits(&self) -> u64 {
        use malachite::base::num::logic::traits::SignificantBits;
        self.primitive()
            .parts
            .values()
            .flat_map(|p| {
                p.terms()
                    .map(|(_, c)| c.significant_bits())
                    .collect::<Vec<_>>()
            })
            .max()
            .unwrap_or(0)
    }

    /// Checks the invariants of the type; every property test calls it.
    #[doc(hidden)]
    #[must_use]
    pub fn check_invariants(&self) -> bool {
        let content = self
            .parts
            .values()
            .fold(self.denominator.clone(), |g, p| gcd(g, &p.content()));
        self.denominator > 0
            && content == 1
            && self
                .parts
                .iter()
                .all(|(d, p)| *d == p.degree() && !p.is_zero())
    }
}

impl Ring for PlanePolynomial {
    fn plus(&self, other: &Self) -> Self {
        Self::from_terms(self.terms().chain(other.terms()))
    }

    fn minus(&self, other: &Self) -> Self {
        let negated = other.terms().map(|(e, c)| (e, -c));
        Self::from_terms(self.terms().chain(negated))
    }

    fn times(&self, other: &Self) -> Self {
        let products = self
            .parts
            .values()
            .flat_map(|f| other.parts.values().map(|g| f.times(g)));
        Self::from_parts(products, &self.denominator * &other.denominator)
    }
}

impl FromIterator<BinaryForm> for PlanePolynomial {
    /// The sum of the forms.
    fn from_iter<I: IntoIterator<Item = BinaryForm>>(forms: I) -> Self {
        Self::from_parts(forms, Integer::ONE)
    }
}

impl From<&PlanePolynomial> for SparsePolynomial<3> {
    fn from(f: &PlanePolynomial) -> Self {
        let exponent = |e: usize| u32::try_from(e).invariant("degrees are below 2^32");
        SparsePolynomial::from_terms(
            f.terms()
                .map(|((i, j), c)| ([exponent(i), exponent(j), 0], c)),
        )
    }
}

fn gcd(a: Integer, b: &Integer) -> Integer {
    Integer::from(a.unsigned_abs_ref().gcd(b.unsigned_abs_ref()))
}

fn lcm(a: Integer, b: &Integer) -> Integer {
    Integer::from((&a).abs().unsigned_abs_ref().lcm(b.unsigned_abs_ref()))
}

fn power(base: &Rational, exponent: usize) -> Rational {
    let exponent = i64::try_from(exponent).invariant("degrees are below 2^63");
    base.pow(exponent)
        .invariant("a power with a natural exponent exists")
}

/// Replaces f(x) by f(x + h), over one common denominator. For h = p/q the polynomial g(X) = q^d f(X/q) has integer
/// coefficients, up to the denominator of f, and is shifted by p.
pub(crate) fn shift_rational(coefficients: &mut [Rational], h: &Rational) {
    if h.is_zero() || coefficients.len() < 2 {
        return;
    }
    let common = coefficients
        .iter()
        .fold(Integer::ONE, |d, c| lcm(d, &c.denominator()));
    let scale = Rational::whole(&common);
    let (p, q) = (h.numerator(), h.denominator());
    // f(p(X + 1)/q) with x = pX/q: the coefficients are multiplied by (p/q)^k, the polynomial is shifted by one, and the
    // coefficients are divided by (p/q)^k; all of them are over q^d.
    let degree = coefficients.len() - 1;
    let mut integers: Vec<Integer> = coefficients
        .iter()
        .map(|c| (c * &scale).numerator())
        .collect();
    let mut p_power = Integer::ONE;
    for c in &mut integers {
        *c *= &p_power;
        p_power *= &p;
    }
    let mut q_power = Integer::ONE;
    for c in integers.iter_mut().rev() {
        *c *= &q_power;
        q_power *= &q;
    }
    let shifted = super::shift_by_one(IntegerPolynomial::from_coefficients_asc(integers));
    let over = Rational::whole(&common) * power(&Rational::whole(&q), degree);
    let mut back = Rational::one();
    let step = Rational::whole(&q) / Rational::whole(&p);
    for (k, c) in coefficients.iter_mut().enumerate() {
        let value = shifted
            .coefficients_asc()
            .get(k)
            .cloned()
            .unwrap_or(Integer::ZERO);
        *c = Rational::whole(value) * &back / &over;
        back = back * &step;
    }
}
