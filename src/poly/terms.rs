//! Integer polynomials in a few variables as sorted lists of terms, for factoring, elimination and evaluation modulo primes.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use malachite::base::num::arithmetic::traits::{
    DivAssignRem, DivExact, Gcd, Mod, Pow, UnsignedAbs,
};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;
use malachite::{Integer, Natural};

use super::{IntegerPolynomial, SparsePolynomial};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::modular::PrimeField;

/// A product uses a dense table if the table has at most this many cells for each product of two terms.
const SPARSE_FACTOR: usize = 4;

/// A polynomial in V variables with integer coefficients, as the list of its non-zero terms in descending lexicographic order
/// of exponents. A variable is named by its index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct IntegerTerms<const V: usize>(Vec<([u32; V], Integer)>);

impl<const V: usize> IntegerTerms<V> {
    /// The sum of the given terms.
    pub(crate) fn new(mut terms: Vec<([u32; V], Integer)>) -> Self {
        terms.sort_unstable_by_key(|(e, _)| Reverse(*e));
        let mut merged: Vec<([u32; V], Integer)> = Vec::with_capacity(terms.len());
        for (e, c) in terms {
            match merged.last_mut() {
                Some((last, sum)) if *last == e => *sum += c,
                _ => merged.push((e, c)),
            }
        }
        merged.retain(|(_, c)| *c != 0);
        Self(merged)
    }

    pub(crate) fn constant(value: Integer) -> Self {
        Self::new(vec![([0; V], value)])
    }

    /// The variable with index v.
    pub(crate) fn variable(v: usize) -> Self {
        let mut exponents = [0; V];
        exponents[v] = 1;
        Self::new(vec![(exponents, Integer::ONE)])
    }

    /// The polynomial with the numerators as coefficients; all denominators must be 1.
    pub(crate) fn of_numerators(f: &SparsePolynomial<V>) -> Self {
        Self::new(f.terms().map(|(e, c)| (*e, c.numerator())).collect())
    }

    /// The same polynomial as a [`SparsePolynomial`].
    pub(crate) fn to_sparse(&self) -> SparsePolynomial<V> {
        SparsePolynomial::from_terms(self.0.iter().map(|(e, c)| (*e, Rational::whole(c))))
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &([u32; V], Integer)> {
        self.0.iter()
    }

    /// The number of terms.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn is_constant(&self) -> bool {
        self.degrees() == [0; V]
    }

    /// The degree in each variable; 0 for the zero polynomial.
    pub(crate) fn degrees(&self) -> [u32; V] {
        self.0
            .iter()
            .fold([0; V], |d, (e, _)| std::array::from_fn(|v| d[v].max(e[v])))
    }

    /// The variables that occur.
    pub(crate) fn used(&self) -> Vec<usize> {
        let degrees = self.degrees();
        (0..V).filter(|&v| degrees[v] > 0).collect()
    }

    /// The sum of the squares of the coefficients.
    pub(crate) fn norm_squared(&self) -> Integer {
        use malachite::base::num::arithmetic::traits::Square;
        self.0
            .iter()
            .fold(Integer::ZERO, |sum, (_, c)| sum + c.square())
    }

    /// The sum of the absolute values of the coefficients.
    pub(crate) fn norm(&self) -> Natural {
        let magnitudes = self.0.iter().map(|(_, c)| c.unsigned_abs_ref());
        magnitudes.sum()
    }

    /// The largest absolute value of a coefficient.
    pub(crate) fn height(&self) -> Integer {
        let abs = self.0.iter().map(|(_, c)| c.unsigned_abs());
        abs.max().map_or(Integer::ZERO, Integer::from)
    }

    /// The gcd of the coefficients, with the sign of the first one.
    pub(crate) fn signed_content(&self) -> Integer {
        let mut content = Integer::ZERO;
        for (_, c) in &self.0 {
            content = Integer::from(content.unsigned_abs_ref().gcd(c.unsigned_abs_ref()));
            if content == 1 {
                break;
            }
        }
        if self.0.first().is_some_and(|(_, c)| *c < 0) {
            -content
        } else {
            content
        }
    }

    /// The multiple with coprime coefficients whose first coefficient is positive.
    pub(crate) fn primitive(mut self) -> Self {
        let content = self.signed_content();
        if content != 0 && content != 1 {
            for (_, c) in &mut self.0 {
                *c = std::mem::take(c).div_exact(&content);
            }
        }
        self
    }

    pub(crate) fn scaled(mut self, factor: &Integer) -> Self {
        for (_, c) in &mut self.0 {
            *c *= factor;
        }
        self.0.retain(|(_, c)| *c != 0);
        self
    }

    /// The polynomial with every coefficient reduced modulo a number.
    pub(crate) fn modulo(&self, modulus: &Integer) -> Self {
        let terms = self.0.iter().map(|(e, c)| (*e, c.mod_op(modulus)));
        Self(terms.filter(|(_, c)| *c != 0).collect())
    }

    /// The polynomial with the same coefficients and other exponents.
    pub(crate) fn map_exponents(&self, map: impl Fn(&[u32; V]) -> [u32; V]) -> Self {
        Self::new(self.0.iter().map(|(e, c)| (map(e), c.clone())).collect())
    }

    /// The largest monomial that divides every term; 1 for the zero polynomial.
    pub(crate) fn monomial_content(&self) -> [u32; V] {
        let mut terms = self.0.iter().map(|(e, _)| *e);
        let first = terms.next().unwrap_or([0; V]);
        terms.fold(first, |d, e| std::array::from_fn(|v| d[v].min(e[v])))
    }

    /// For each variable the gcd of its exponents.
    pub(crate) fn exponent_gcds(&self) -> [u32; V] {
        self.0
            .iter()
            .fold([0; V], |d, (e, _)| std::array::from_fn(|v| d[v].gcd(e[v])))
    }

    /// Whether all the terms have the same total degree.
    pub(crate) fn is_homogeneous(&self) -> bool {
        let mut totals = self.0.iter().map(|(e, _)| e.iter().sum::<u32>());
        let first = totals.next();
        totals.all(|d| Some(d) == first)
    }

    /// The non-zero coefficients of the powers of variable v, ascending in the power.
    pub(crate) fn coefficients_in(&self, v: usize) -> BTreeMap<u32, Self> {
        let mut rows: BTreeMap<u32, Vec<([u32; V], Integer)>> = BTreeMap::new();
        for (e, c) in &self.0 {
            let mut rest = *e;
            rest[v] = 0;
            rows.entry(e[v]).or_default().push((rest, c.clone()));
        }
        // The terms of one power remain in order.
        rows.into_iter().map(|(k, row)| (k, Self(row))).collect()
    }

    /// The polynomial for `v = a`, in which v does not occur.
    pub(crate) fn evaluated(&self, v: usize, a: &Integer) -> Self {
        let degree = self.degrees()[v];
        let mut powers = vec![Integer::ONE];
        for _ in 0..degree {
            let next = powers.last().map_or(Integer::ONE, |p| p * a);
            powers.push(next);
        }
        Self::new(
            self.0
                .iter()
                .map(|(e, c)| {
                    let mut rest = *e;
                    rest[v] = 0;
                    (rest, c * &powers[e[v] as usize])
                })
                .collect(),
        )
    }

    /// The polynomial f(…, v + a, …), by synthetic division in every row.
    pub(crate) fn shifted(&self, v: usize, a: &Integer) -> Self {
        if *a == 0 {
            return self.clone();
        }
        let degree = self.degrees()[v] as usize;
        let mut rows: BTreeMap<[u32; V], Vec<Integer>> = BTreeMap::new();
        for (e, c) in &self.0 {
            let mut key = *e;
            key[v] = 0;
            let row = rows
                .entry(key)
                .or_insert_with(|| vec![Integer::ZERO; degree + 1]);
            row[e[v] as usize] = c.clone();
        }
        let mut terms = Vec::new();
        for (key, mut row) in rows {
            for start in 0..degree {
                for k in (start..degree).rev() {
                    let (low, high) = row.split_at_mut(k + 1);
                    low[k] += &high[0] * a;
                }
            }
            for (k, c) in (0..).zip(row) {
                let mut e = key;
                e[v] = k;
                terms.push((e, c));
            }
        }
        Self::new(terms)
    }

    pub(crate) fn derivative(&self, v: usize) -> Self {
        let terms = self.0.iter().filter(|(e, _)| e[v] > 0).map(|(e, c)| {
            let mut lower = *e;
            lower[v] -= 1;
            (lower, c * Integer::from(e[v]))
        });
        Self::new(terms.collect())
    }

    pub(crate) fn difference(&self, other: &Self) -> Self {
        let minus = other.0.iter().map(|(e, c)| (*e, -c));
        Self::new(self.0.iter().cloned().chain(minus).collect())
    }

    /// The product, computed in a dense table, or in a map if the table would be mostly empty.
    pub(crate) fn product(&self, other: &Self) -> Self {
        let (a, b) = (self.degrees(), other.degrees());
        let table = Table::for_degrees(std::array::from_fn(|v| {
            a[v].checked_add(b[v]).invariant("exponents are below 2^32")
        }));
        let work = self.0.len().saturating_mul(other.0.len());
        if table.cells > work.saturating_mul(SPARSE_FACTOR) {
            let mut sum: BTreeMap<[u32; V], Integer> = BTreeMap::new();
            for (e, c) in &self.0 {
                for (f, d) in &other.0 {
                    *sum.entry(std::array::from_fn(|v| e[v] + f[v])).or_default() += c * d;
                }
            }
            return Self::new(sum.into_iter().collect());
        }
        let mut cells = vec![Integer::ZERO; table.cells];
        for (e, c) in &self.0 {
            let at = table.index(e);
            for (f, d) in &other.0 {
                cells[at + table.index(f)] += c * d;
            }
        }
        table.terms(cells)
    }

    /// The quotient `self / divisor`; `None` if the divisor does not divide over the integers. The remainder is a dense table
    /// of the size of self. The division ends as soon as a degree or a coefficient does not fit.
    pub(crate) fn divided_by(&self, divisor: &Self) -> Option<Self> {
        let (lead_exponents, lead) = divisor.0.first()?;
        let (degrees, lower) = (self.degrees(), divisor.degrees());
        if (0..V).any(|v| lower[v] > degrees[v]) {
            return None;
        }
        let table = Table::for_degrees(degrees);
        let mut cells = vec![Integer::ZERO; table.cells];
        for (e, c) in &self.0 {
            cells[table.index(e)] = c.clone();
        }
        let tail: Vec<(usize, &Integer)> = divisor.0[1..]
            .iter()
            .map(|(e, c)| (table.index(e), c))
            .collect();
        let mut quotient = Vec::new();
        for at in (0..cells.len()).rev() {
            if cells[at] == 0 {
                continue;
            }
            let e = table.exponents(at);
            let mut q = [0; V];
            for v in 0..V {
                q[v] = e[v].checked_sub(lead_exponents[v])?;
                if q[v] + lower[v] > degrees[v] {
                    return None;
                }
            }
            let mut c = std::mem::take(&mut cells[at]);
            if c.div_assign_rem(lead) != 0 {
                return None;
            }
            let base = table.index(&q);
            for (offset, d) in &tail {
                cells[base + offset] -= *d * &c;
            }
            quotient.push((q, c));
        }
        Some(Self(quotient))
    }

    /// The power, by repeated squaring.
    pub(crate) fn pow(&self, exponent: usize) -> Self {
        let mut result = Self::constant(Integer::ONE);
        for bit in (0..usize::BITS - exponent.leading_zeros()).rev() {
            result = result.product(&result);
            if exponent >> bit & 1 == 1 {
                result = result.product(self);
            }
        }
        result
    }

    /// The polynomial in v; the other variables must not occur.
    pub(crate) fn to_univariate(&self, v: usize) -> IntegerPolynomial {
        let mut coefficients = vec![Integer::ZERO; self.degrees()[v] as usize + 1];
        for (e, c) in &self.0 {
            coefficients[e[v] as usize] = c.clone();
        }
        IntegerPolynomial::from_coefficients_asc(coefficients)
    }

    pub(crate) fn from_univariate(f: &IntegerPolynomial, v: usize) -> Self {
        let terms = (0u32..).zip(f.coefficients_asc()).map(|(k, c)| {
            let mut e = [0; V];
            e[v] = k;
            (e, c.clone())
        });
        Self::new(terms.collect())
    }

    /// The number of cells of a dense table for this polynomial.
    pub(crate) fn cells(&self) -> usize {
        Table::for_degrees(self.degrees()).cells
    }

    /// The polynomial in v modulo a prime, for given values of the other variables. It has as many coefficients as the degree
    /// in v requires; `point[v]` is not used.
    pub(crate) fn image(&self, v: usize, point: &[u64; V], field: &PrimeField) -> Vec<u64> {
        let degrees = self.degrees();
        let powers: [Vec<u64>; V] = std::array::from_fn(|w| {
            let count = if w == v { 0 } else { degrees[w] as usize + 1 };
            field.powers(point[w], count)
        });
        let mut image = vec![0; degrees[v] as usize + 1];
        for (e, c) in &self.0 {
            let mut value = field.reduce_integer(c);
            for w in (0..V).filter(|&w| w != v) {
                value = field.mul(value, powers[w][e[w] as usize]);
            }
            let slot = &mut image[e[v] as usize];
            *slot = field.sum(*slot, value);
        }
        image
    }

    /// The value at a point.
    pub(crate) fn value(&self, point: &[Integer; V]) -> Integer {
        self.0.iter().fold(Integer::ZERO, |sum, (e, c)| {
            let monomial = (0..V).fold(c.clone(), |m, v| m * (&point[v]).pow(u64::from(e[v])));
            sum + monomial
        })
    }
}

/// A dense table of the monomials up to given degrees; ascending index is ascending lexicographic order.
struct Table<const V: usize> {
    strides: [usize; V],
    cells: usize,
}

impl<const V: usize> Table<V> {
    fn for_degrees(degrees: [u32; V]) -> Self {
        let (mut strides, mut cells) = ([1; V], 1usize);
        for v in (0..V).rev() {
            strides[v] = cells;
            cells = cells.saturating_mul(degrees[v] as usize + 1);
        }
        Self { strides, cells }
    }

    fn index(&self, e: &[u32; V]) -> usize {
        (0..V).map(|v| e[v] as usize * self.strides[v]).sum()
    }

    fn exponents(&self, index: usize) -> [u32; V] {
        let mut rest = index;
        self.strides.map(|stride| {
            let k = rest / stride;
            rest %= stride;
            u32::try_from(k).invariant("exponents are below 2^32")
        })
    }

    fn terms(&self, cells: Vec<Integer>) -> IntegerTerms<V> {
        let terms = cells.into_iter().enumerate().rev();
        IntegerTerms(
            terms
                .filter(|(_, c)| *c != 0)
                .map(|(at, c)| (self.exponents(at), c))
                .collect(),
        )
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use proptest::prelude::*;

    pub(crate) fn terms() -> impl Strategy<Value = IntegerTerms<3>> {
        // Small coefficients, and coefficients near multiples of a power of two.
        let coefficient = prop_oneof![
            (-9i64..9).prop_map(Integer::from),
            (-3i64..4, 20u64..300, -1i64..2)
                .prop_map(|(c, bits, more)| (Integer::from(c) << bits) + Integer::from(more)),
        ];
        prop::collection::vec((prop::array::uniform3(0u32..4), coefficient), 1..6)
            .prop_map(IntegerTerms::new)
    }

    proptest! {
        #[test]
        fn a_product_divides_back(f in terms(), g in terms(), k in 0usize..4) {
            prop_assume!(!f.is_zero() && !g.is_zero());
            prop_assert_eq!(f.product(&g).divided_by(&g), Some(f.clone()));
            let power = (0..k).fold(IntegerTerms::constant(Integer::ONE), |p, _| p.product(&f));
            prop_assert_eq!(f.pow(k), power);
        }

        #[test]
        fn what_divides_multiplies_back(f in terms(), g in terms()) {
            prop_assume!(!g.is_zero());
            if let Some(q) = f.divided_by(&g) {
                prop_assert_eq!(q.product(&g), f);
            }
        }

        #[test]
        fn shifting_and_evaluating_agree(f in terms(), v in 0usize..3, a in -3i64..3, b in -3i64..3) {
            let (a, b) = (Integer::from(a), Integer::from(b));
            prop_assert_eq!(f.shifted(v, &a).evaluated(v, &b), f.evaluated(v, &(a + b)));
        }
    }
}
