//! Taylor shifts: f(x + 1) from f(x).

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::One;
use malachite::base::polynomial::Polynomial;

use super::IntegerPolynomial;

/// Below this length the classical d²/2 additions are faster than divide and conquer.
const CLASSICAL_BELOW: usize = 128;

/// The polynomial f(x + 1). Degrees up to 127 take classical additions; larger ones take divide and conquer with fast products,
/// which is quasi-linear in the size of the answer. The coefficients of the answer are about d bits longer than those of f.
///
/// ```
/// use std::str::FromStr;
/// use stellate::poly::{IntegerPolynomial, shift_by_one};
/// let f = IntegerPolynomial::from_str("x^2+3*x+2").unwrap();
/// assert_eq!(shift_by_one(f).to_string(), "x^2+5*x+6");
/// ```
#[must_use]
pub fn shift_by_one(f: IntegerPolynomial) -> IntegerPolynomial {
    shift(f.into_coefficients_asc())
}

/// Replaces f(x) by f(−x), in place.
pub(crate) fn negate_odd(coefficients: &mut [Integer]) {
    for c in coefficients.iter_mut().skip(1).step_by(2) {
        *c = -std::mem::take(c);
    }
}

/// Replaces f(x) by f(x + 1) by repeated synthetic division, in place, with d²/2 additions.
pub(crate) fn shift_classical(coefficients: &mut [Integer]) {
    let n = coefficients.len();
    for start in (0..n.saturating_sub(1)).rev() {
        for k in start..n - 1 {
            let (low, high) = coefficients.split_at_mut(k + 1);
            low[k] += &high[0];
        }
    }
}

/// Divide and conquer for f = f0 + x^m f1, where m is a power of two: f(x+1) = f0(x+1) + (x+1)^m f1(x+1).
fn shift(coefficients: Vec<Integer>) -> IntegerPolynomial {
    let levels = coefficients
        .len()
        .div_ceil(CLASSICAL_BELOW)
        .next_power_of_two();
    let mut powers = Vec::new();
    let base = IntegerPolynomial::from_coefficients_asc(vec![Integer::ONE, Integer::ONE]);
    let mut exponent = coefficients.len().div_ceil(levels).max(1);
    let block = exponent;
    while exponent < coefficients.len() {
        powers.push(match powers.last() {
            None => (&base).pow(exponent as u64),
            Some(p) => square(p),
        });
        exponent *= 2;
    }
    let mut blocks: Vec<IntegerPolynomial> = Vec::new();
    let mut rest = coefficients;
    while !rest.is_empty() {
        let tail = rest.split_off(block.min(rest.len()));
        shift_classical(&mut rest);
        blocks.push(IntegerPolynomial::from_coefficients_asc(rest));
        rest = tail;
    }
    for power in &powers {
        let mut joined = Vec::with_capacity(blocks.len().div_ceil(2));
        let mut blocks_in = blocks.into_iter();
        while let Some(low) = blocks_in.next() {
            joined.push(match blocks_in.next() {
                Some(high) => low + power * high,
                None => low,
            });
        }
        blocks = joined;
    }
    // There is no block if f is the zero polynomial.
    blocks.pop().unwrap_or_default()
}

fn square(p: &IntegerPolynomial) -> IntegerPolynomial {
    use malachite::base::num::arithmetic::traits::Square;
    p.square()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_fast_shift_is_the_classical_one(c in prop::collection::vec(any::<i64>(), 0..700)) {
            let coefficients: Vec<Integer> = c.into_iter().map(Integer::from).collect();
            let f = IntegerPolynomial::from_coefficients_asc(coefficients);
            let mut slow = f.clone().into_coefficients_asc();
            shift_classical(&mut slow);
            let fast = shift_by_one(f);
            prop_assert_eq!(&fast, &IntegerPolynomial::from_coefficients_asc(slow));
        }
    }
}
