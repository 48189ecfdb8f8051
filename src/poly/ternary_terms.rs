//! Values of ternary forms that are given as terms, in descending lexicographic order of the exponents of x, y, z.

use std::borrow::Borrow;
use std::collections::BTreeMap;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Zero};

use super::BinaryForm;

/// Multiplies value by base^exponent, in place.
pub(super) fn multiply_by_power(value: &mut Integer, base: &Integer, exponent: usize) {
    match exponent {
        0 => {}
        1 => *value *= base,
        _ => *value *= base.pow(exponent as u64),
    }
}

/// The value Σ c u^i v^j w^k, by Horner's rule in u, and in v for every power of u.
pub(super) fn value(
    terms: &[([usize; 3], impl Borrow<Integer>)],
    [u, v, w]: [&Integer; 3],
) -> Integer {
    let mut sum = Integer::ZERO;
    let mut above = terms.first().map_or(0, |([i, ..], _)| *i);
    for row in terms.chunk_by(|([i, ..], _), ([next, ..], _)| i == next) {
        let ([i, mut j_above, mut k_above], _) = row[0];
        multiply_by_power(&mut sum, u, above - i);
        above = i;
        let (mut inner, mut w_power) = (Integer::ZERO, Integer::ONE);
        multiply_by_power(&mut w_power, w, k_above);
        for ([_, j, k], c) in row {
            multiply_by_power(&mut inner, v, j_above - j);
            multiply_by_power(&mut w_power, w, k - k_above);
            (j_above, k_above) = (*j, *k);
            inner += c.borrow() * &w_power;
        }
        multiply_by_power(&mut inner, v, j_above);
        sum += inner;
    }
    multiply_by_power(&mut sum, u, above);
    sum
}

/// The form on the plane through the z axis and (a, b, 0), where a² + b² = c²: the binary form `c^d f(aY/c, bY/c, X)` in (X,
/// Y).
pub(super) fn on_meridian(
    degree: usize,
    terms: &[([usize; 3], impl Borrow<Integer>)],
    [a, b, c]: [&Integer; 3],
) -> BinaryForm {
    let mut beside_z: BTreeMap<usize, Vec<([usize; 3], &Integer)>> = BTreeMap::new();
    for ([i, j, k], coefficient) in terms {
        let row = beside_z.entry(*k).or_default();
        row.push(([*i, *j, 0], coefficient.borrow()));
    }
    let (mut below, mut power) = (0, Integer::ONE);
    // The coefficients of X^k Y^(d−k).
    let mut coefficients = vec![Integer::ZERO; degree + 1];
    for (k, row) in beside_z {
        multiply_by_power(&mut power, c, k - below);
        below = k;
        coefficients[degree - k] = value(&row, [a, b, &Integer::ONE]) * &power;
    }
    BinaryForm::from_coefficients(coefficients)
}
