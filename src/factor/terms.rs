//! Integer polynomials in three variables as sorted terms: what multivariate factoring works on.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivAssignRem, DivExact, Gcd, Pow, UnsignedAbs};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use crate::error::Invariant;
use crate::poly::IntegerPolynomial;

/// Exponents of x, y, z.
pub(super) type Exponents = [u32; 3];

/// A dense table is used while it has at most this many cells per product of two terms.
const SPARSE_FACTOR: usize = 4;

/// A polynomial in x, y, z with integer coefficients; its non-zero terms in descending lexicographic
/// order of exponents. Variables are told by index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Terms(Vec<(Exponents, Integer)>);

impl Terms {
    /// The sum of the given terms.
    pub(super) fn new(mut terms: Vec<(Exponents, Integer)>) -> Self {
        terms.sort_by_key(|(e, _)| Reverse(*e));
        let mut merged: Vec<(Exponents, Integer)> = Vec::with_capacity(terms.len());
        for (e, c) in terms {
            match merged.last_mut() {
                Some((last, sum)) if *last == e => *sum += c,
                _ => merged.push((e, c)),
            }
        }
        merged.retain(|(_, c)| *c != 0);
        Self(merged)
    }

    pub(super) fn constant(value: Integer) -> Self {
        Self::new(vec![([0; 3], value)])
    }

    /// The variable with index v.
    pub(super) fn variable(v: usize) -> Self {
        let mut exponents = [0; 3];
        exponents[v] = 1;
        Self::new(vec![(exponents, Integer::ONE)])
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &(Exponents, Integer)> {
        self.0.iter()
    }

    pub(super) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn is_constant(&self) -> bool {
        self.degrees() == [0; 3]
    }

    /// The degree in each variable, 0 for the zero polynomial.
    pub(super) fn degrees(&self) -> Exponents {
        self.0
            .iter()
            .fold([0; 3], |d, (e, _)| std::array::from_fn(|v| d[v].max(e[v])))
    }

    /// The variables that occur.
    pub(super) fn used(&self) -> Vec<usize> {
        let degrees = self.degrees();
        (0..3).filter(|&v| degrees[v] > 0).collect()
    }

    /// Σ c² .
    pub(super) fn norm_squared(&self) -> Integer {
        use malachite::base::num::arithmetic::traits::Square;
        self.0
            .iter()
            .fold(Integer::ZERO, |sum, (_, c)| sum + c.square())
    }

    /// The largest absolute value of a coefficient.
    pub(super) fn height(&self) -> Integer {
        let abs = self.0.iter().map(|(_, c)| c.unsigned_abs());
        abs.max().map_or(Integer::ZERO, Integer::from)
    }

    /// The gcd of the coefficients, with the sign of the first one.
    pub(super) fn signed_content(&self) -> Integer {
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

    /// Coprime coefficients, the first one positive.
    pub(super) fn primitive(mut self) -> Self {
        let content = self.signed_content();
        if content != 0 && content != 1 {
            for (_, c) in &mut self.0 {
                *c = std::mem::take(c).div_exact(&content);
            }
        }
        self
    }

    pub(super) fn scaled(mut self, factor: &Integer) -> Self {
        for (_, c) in &mut self.0 {
            *c *= factor;
        }
        self.0.retain(|(_, c)| *c != 0);
        self
    }

    /// The same coefficients at other exponents.
    pub(super) fn map_exponents(&self, map: impl Fn(&Exponents) -> Exponents) -> Self {
        Self::new(self.0.iter().map(|(e, c)| (map(e), c.clone())).collect())
    }

    /// The largest monomial that divides every term; 1 for the zero polynomial.
    pub(super) fn monomial_content(&self) -> Exponents {
        let mut terms = self.0.iter().map(|(e, _)| *e);
        let first = terms.next().unwrap_or_default();
        terms.fold(first, |d, e| std::array::from_fn(|v| d[v].min(e[v])))
    }

    /// For each variable the gcd of its exponents.
    pub(super) fn exponent_gcds(&self) -> Exponents {
        self.0
            .iter()
            .fold([0; 3], |d, (e, _)| std::array::from_fn(|v| d[v].gcd(e[v])))
    }

    /// Whether all the terms have the same total degree.
    pub(super) fn is_homogeneous(&self) -> bool {
        let mut totals = self.0.iter().map(|(e, _)| e.iter().sum::<u32>());
        let first = totals.next();
        totals.all(|d| Some(d) == first)
    }

    /// The non-zero coefficients of the powers of variable v, ascending in the power.
    pub(super) fn coefficients_in(&self, v: usize) -> BTreeMap<u32, Terms> {
        let mut rows: BTreeMap<u32, Vec<(Exponents, Integer)>> = BTreeMap::new();
        for (e, c) in &self.0 {
            let mut rest = *e;
            rest[v] = 0;
            rows.entry(e[v]).or_default().push((rest, c.clone()));
        }
        // Within a row the order is kept.
        rows.into_iter().map(|(k, row)| (k, Self(row))).collect()
    }

    /// The value at `v = a`, free of v.
    pub(super) fn evaluated(&self, v: usize, a: &Integer) -> Self {
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

    /// f(…, v + a, …), by synthetic division in every row.
    pub(super) fn shifted(&self, v: usize, a: &Integer) -> Self {
        if *a == 0 {
            return self.clone();
        }
        let degree = self.degrees()[v] as usize;
        let mut rows: BTreeMap<Exponents, Vec<Integer>> = BTreeMap::new();
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

    pub(super) fn derivative(&self, v: usize) -> Self {
        let terms = self.0.iter().filter(|(e, _)| e[v] > 0).map(|(e, c)| {
            let mut lower = *e;
            lower[v] -= 1;
            (lower, c * Integer::from(e[v]))
        });
        Self::new(terms.collect())
    }

    pub(super) fn difference(&self, other: &Self) -> Self {
        let minus = other.0.iter().map(|(e, c)| (*e, -c));
        Self::new(self.0.iter().cloned().chain(minus).collect())
    }

    /// The product: into a dense table, or into a map when that would be mostly empty.
    pub(super) fn product(&self, other: &Self) -> Self {
        let (a, b) = (self.degrees(), other.degrees());
        let table = Table::for_degrees(std::array::from_fn(|v| {
            a[v].checked_add(b[v]).invariant("exponents are below 2^32")
        }));
        let work = self.0.len().saturating_mul(other.0.len());
        if table.cells > work.saturating_mul(SPARSE_FACTOR) {
            let mut sum: BTreeMap<Exponents, Integer> = BTreeMap::new();
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

    /// `self / divisor` if the divisor divides it over the integers. The remainder is a dense table of
    /// the size of self; a wrong divisor is refused as soon as a degree or a coefficient does not fit.
    pub(super) fn divided_by(&self, divisor: &Self) -> Option<Self> {
        let (lead_exponents, lead) = divisor.0.first()?;
        let (degrees, lower) = (self.degrees(), divisor.degrees());
        if (0..3).any(|v| lower[v] > degrees[v]) {
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
            let mut q = [0; 3];
            for v in 0..3 {
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

    /// By repeated squaring.
    pub(super) fn pow(&self, exponent: usize) -> Self {
        let mut result = Self::constant(Integer::ONE);
        for bit in (0..usize::BITS - exponent.leading_zeros()).rev() {
            result = result.product(&result);
            if exponent >> bit & 1 == 1 {
                result = result.product(self);
            }
        }
        result
    }

    /// As a polynomial in v; the other variables must not occur.
    pub(super) fn to_univariate(&self, v: usize) -> IntegerPolynomial {
        let mut coefficients = vec![Integer::ZERO; self.degrees()[v] as usize + 1];
        for (e, c) in &self.0 {
            coefficients[e[v] as usize] = c.clone();
        }
        IntegerPolynomial::from_coefficients_asc(coefficients)
    }

    pub(super) fn from_univariate(f: &IntegerPolynomial, v: usize) -> Self {
        let terms = (0u32..).zip(f.coefficients_asc()).map(|(k, c)| {
            let mut e = [0; 3];
            e[v] = k;
            (e, c.clone())
        });
        Self::new(terms.collect())
    }

    /// The number of cells of a dense table for this polynomial.
    pub(super) fn cells(&self) -> usize {
        Table::for_degrees(self.degrees()).cells
    }

    /// The value at a point.
    pub(super) fn value(&self, point: &[Integer; 3]) -> Integer {
        self.0.iter().fold(Integer::ZERO, |sum, (e, c)| {
            let monomial = (0..3).fold(c.clone(), |m, v| m * (&point[v]).pow(u64::from(e[v])));
            sum + monomial
        })
    }
}

/// A dense table of the monomials up to given degrees; ascending index is ascending lexicographic order.
struct Table {
    strides: [usize; 3],
    cells: usize,
}

impl Table {
    fn for_degrees(degrees: Exponents) -> Self {
        let [x, y, z] = degrees.map(|d| d as usize + 1);
        let row = y.saturating_mul(z);
        Self {
            strides: [row, z, 1],
            cells: x.saturating_mul(row),
        }
    }

    fn index(&self, e: &Exponents) -> usize {
        (0..3).map(|v| e[v] as usize * self.strides[v]).sum()
    }

    fn exponents(&self, index: usize) -> Exponents {
        let narrow = |k: usize| u32::try_from(k).invariant("exponents are below 2^32");
        [
            narrow(index / self.strides[0]),
            narrow(index % self.strides[0] / self.strides[1]),
            narrow(index % self.strides[1]),
        ]
    }

    fn terms(&self, cells: Vec<Integer>) -> Terms {
        let terms = cells.into_iter().enumerate().rev();
        Terms(
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

    pub(in crate::factor) fn terms() -> impl Strategy<Value = Terms> {
        // Small ones, and ones next to multiples of a power of two.
        let coefficient = prop_oneof![
            (-9i64..9).prop_map(Integer::from),
            (-3i64..4, 20u64..300, -1i64..2)
                .prop_map(|(c, bits, more)| (Integer::from(c) << bits) + Integer::from(more)),
        ];
        prop::collection::vec((prop::array::uniform3(0u32..4), coefficient), 1..6)
            .prop_map(Terms::new)
    }

    proptest! {
        #[test]
        fn a_product_divides_back(f in terms(), g in terms(), k in 0usize..4) {
            prop_assume!(!f.is_zero() && !g.is_zero());
            prop_assert_eq!(f.product(&g).divided_by(&g), Some(f.clone()));
            let power = (0..k).fold(Terms::constant(Integer::ONE), |p, _| p.product(&f));
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
