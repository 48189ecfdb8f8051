//! The change from powers to the Bernstein basis on [0, 1] for midpoints, and the table that it needs.

use std::any::Any;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

use super::fixed::{Fixed, Fraction};
use crate::bigint::{FlatPolynomial, ShiftByOne, binomials, form_bits, widen};
use crate::error::Invariant;

/// The table of 1 / C(d, 0), …, 1 / C(d, d).
#[derive(Debug)]
pub(super) struct BernsteinTable<const W: usize>(Vec<InverseBinomial<W>>);

/// 1 / C(d, k) = 2^(−shift) · factor with a factor in [1/2, 1), rounded down by less than 2^(−64W).
#[derive(Debug)]
struct InverseBinomial<const W: usize> {
    shift: u32,
    factor: Fraction<W>,
    /// The whole number 1 / C(d, k) as a double, after at most 3W + 1 roundings.
    double: f64,
}

impl<const W: usize> InverseBinomial<W> {
    fn of(binomial: &Integer) -> Self {
        let bits = binomial.significant_bits() - 1;
        let shift = u32::try_from(bits).invariant("a binomial coefficient has few bits");
        let factor = Fraction::quotient(&(Integer::from(1) << bits), binomial);
        // Division by 2 is exact.
        let double = (0..shift).fold(factor.to_f64(), |value, _| value / 2.0);
        Self {
            shift,
            factor,
            double,
        }
    }
}

impl<const W: usize> BernsteinTable<W> {
    /// The table of degree d, which is computed once.
    pub(super) fn of_degree(degree: usize) -> Arc<Self> {
        type Tables = BTreeMap<(usize, usize), Arc<dyn Any + Send + Sync>>;
        static TABLES: Mutex<Tables> = Mutex::new(BTreeMap::new());
        let compute = || {
            let row = binomials(degree);
            Arc::new(Self(row.iter().map(InverseBinomial::of).collect()))
        };
        let mut tables = TABLES.lock().unwrap_or_else(PoisonError::into_inner);
        let table = tables
            .entry((W, degree))
            .or_insert_with(|| compute() as Arc<dyn Any + Send + Sync>);
        let table = Arc::clone(table);
        drop(tables);
        table
            .downcast()
            .invariant("a table has the width of its key")
    }

    /// The numbers 1 / C(d, k) as doubles, with a relative error of at most 2^(−47).
    pub(super) fn inverses(&self) -> impl Iterator<Item = f64> {
        self.0.iter().map(|inverse| inverse.double)
    }
}

/// The Bernstein coefficients b_k = Σ_{i ≤ k} C(k, i)/C(d, i) c_i of Σ c_i y^i, each wrong by less than W + 2 ulps. The sizes of
/// the c_i must add up to at most 64.
///
/// The numbers C(d, k) b_k are the coefficients of `Σ c_i X^i (1 + X)^(d−i)`, a Taylor shift of the reversed c_i, which is
/// exact in integers that are d bits longer. A product with a fraction then divides by C(d, k) = 2^shift / factor. The shift
/// cuts less than 1 ulp. The factor has an error of less than 2^(−64W); times a number below 128 that is half an ulp. The
/// product is cut by less than W. Cost: d²/2 additions and d products.
pub(super) fn scaled_to_bernstein<const W: usize>(
    c: &[Fixed<W>],
    table: &BernsteinTable<W>,
) -> Vec<Fixed<W>> {
    // Σ |c_i| is below 2^(64W − 1) ulps.
    let bits = form_bits(c.len().saturating_sub(1), 64 * W as u64 - 1);
    let mut shifted = FlatPolynomial::zero(c.len(), bits);
    for (target, c) in shifted.coefficients_mut().zip(c.iter().rev()) {
        widen(target, c.limbs());
    }
    shifted.run(ShiftByOne);
    let pairs = shifted.coefficients().rev().zip(&table.0);
    pairs
        .map(|(c, by)| Fixed::from_wide(c, by.shift).times(&by.factor))
        .collect()
}
