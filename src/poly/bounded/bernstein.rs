//! From powers to the Bernstein basis on [0, 1], both halves of the axis at once.

use std::any::Any;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::fixed::{Fixed, Fraction};

/// The weights C(k, i) / C(d, i) for i = 0, …, d and k = i, …, d, each rounded down by less than (d + 1) 2^(−64W).
fn weights<const W: usize>(degree: usize) -> Arc<Vec<Fraction<W>>> {
    type Tables = BTreeMap<(usize, usize), Arc<dyn Any + Send + Sync>>;
    static TABLES: Mutex<Tables> = Mutex::new(BTreeMap::new());
    let mut tables = TABLES.lock().unwrap_or_else(PoisonError::into_inner);
    let table = tables
        .entry((W, degree))
        .or_insert_with(|| Arc::new(new_weights::<W>(degree)));
    let table = Arc::clone(table);
    drop(tables);
    table
        .downcast()
        .unwrap_or_else(|_| Arc::new(new_weights::<W>(degree)))
}

fn new_weights<const W: usize>(degree: usize) -> Vec<Fraction<W>> {
    let mut all = Vec::with_capacity((degree + 1) * (degree + 2) / 2);
    for i in 0..=degree {
        let start = all.len();
        let mut weight = Fraction::LARGEST;
        for k in (i..=degree).rev() {
            all.push(weight);
            // C(k−1, i) = C(k, i) (k − i)/k
            weight = weight.times_ratio((k - i) as u64, k.max(1) as u64);
        }
        all[start..].reverse();
    }
    all
}

/// The Bernstein coefficients on [0, 1] of Σ c_i y^i and of Σ c_i (−y)^i, each b_k = Σ_{i ≤ k} C(k, i)/C(d, i) (±1)^i c_i
/// with an error of less than `3(d + 1)` ulps beyond those of the c_i, whose weights are at most 1.
pub(super) fn to_bernstein<const W: usize>(coefficients: &[Fixed<W>]) -> [Vec<Fixed<W>>; 2] {
    let degree = coefficients.len().saturating_sub(1);
    let mut even = vec![Fixed::ZERO; degree + 1];
    let mut odd = even.clone();
    let weights = weights::<W>(degree);
    let mut rest = weights.as_slice();
    for (i, c) in coefficients.iter().enumerate() {
        let (row, others) = rest.split_at(degree + 1 - i);
        rest = others;
        let sums = if i.is_multiple_of(2) {
            &mut even
        } else {
            &mut odd
        };
        for (sum, weight) in sums[i..].iter_mut().zip(row) {
            *sum = sum.plus(c.times(weight));
        }
    }
    let pairs = || even.iter().zip(&odd);
    [
        pairs().map(|(e, o)| e.plus(*o)).collect(),
        pairs().map(|(e, o)| e.minus(*o)).collect(),
    ]
}
