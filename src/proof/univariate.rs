//! Polynomials in one variable with integer coefficients, in ascending order. A list may end with zeros where its length states
//! a formal degree.

use num_bigint::BigInt;

use super::numbers::{Exact, common_denominator, is_zero, powers, sign};

pub(super) type Coefficients = Vec<BigInt>;

/// The product; its formal degree is the sum of the formal degrees.
pub(super) fn product(p: &[BigInt], q: &[BigInt]) -> Coefficients {
    let mut result = vec![BigInt::ZERO; (p.len() + q.len()).saturating_sub(1)];
    for (i, a) in p.iter().enumerate().filter(|(_, a)| !is_zero(a)) {
        for (slot, b) in result[i..].iter_mut().zip(q) {
            *slot += a * b;
        }
    }
    result
}

/// p^exponent.
pub(super) fn power(p: &[BigInt], exponent: usize) -> Coefficients {
    (0..exponent).fold(vec![BigInt::from(1)], |result, _| product(&result, p))
}

/// Adds factor·q to p. The formal degree of p is raised to that of q if it is lower.
pub(super) fn add_multiple(p: &mut Coefficients, factor: &BigInt, q: &[BigInt]) {
    if p.len() < q.len() {
        p.resize(q.len(), BigInt::ZERO);
    }
    for (slot, c) in p.iter_mut().zip(q) {
        *slot += factor * c;
    }
}

/// The polynomial without zeros at the end.
pub(super) fn trimmed(mut p: Coefficients) -> Coefficients {
    while p.last().is_some_and(is_zero) {
        p.pop();
    }
    p
}

/// p(x + 1), by sums over the beginning of the list (Horner's scheme for the point 1).
pub(super) fn shift_by_one(p: &mut [BigInt]) {
    let n = p.len();
    for first in 0..n.saturating_sub(1) {
        for i in (first..n - 1).rev() {
            let (low, high) = p.split_at_mut(i + 1);
            low[i] += &high[0];
        }
    }
}

/// p(x + a): with x = a·y this is p(a·(y + 1)), so only a shift by 1 is needed.
pub(super) fn shift(p: &mut [BigInt], a: &BigInt) {
    if is_zero(a) {
        return;
    }
    let scales = powers(a, p.len().saturating_sub(1));
    for (c, scale) in p.iter_mut().zip(&scales) {
        *c *= scale;
    }
    shift_by_one(p);
    for (c, scale) in p.iter_mut().zip(&scales) {
        *c /= scale;
    }
}

/// p(s·x) for an integer s.
pub(super) fn stretch(p: &mut [BigInt], s: &BigInt) {
    let scales = powers(s, p.len().saturating_sub(1));
    for (c, scale) in p.iter_mut().zip(scales) {
        *c *= scale;
    }
}

/// d^n·p(x/d), where n is the formal degree.
pub(super) fn shrink(p: &mut [BigInt], d: &BigInt) {
    let scales = powers(d, p.len().saturating_sub(1));
    for (c, scale) in p.iter_mut().rev().zip(scales) {
        *c *= scale;
    }
}

/// p(−x).
pub(super) fn alternate(p: &mut [BigInt]) {
    for c in p.iter_mut().skip(1).step_by(2) {
        *c = -std::mem::take(c);
    }
}

/// p(a + b·x), times the n-th power of the common denominator of a and b, where n is the formal degree.
pub(super) fn substitute(p: &mut [BigInt], a: &Exact, b: &Exact) {
    let (integers, common) = common_denominator(&[a.clone(), b.clone()]);
    if let [a, b] = integers.as_slice() {
        shrink(p, &common);
        shift(p, a);
        stretch(p, b);
    }
}

/// An end of an interval of the real line.
#[derive(Clone, Debug)]
pub(super) enum End {
    MinusInfinity,
    At(Exact),
    Infinity,
}

/// The sign of p at a point, or close enough to infinity.
pub(super) fn sign_at(p: &[BigInt], point: &End) -> i64 {
    let leading = p.iter().rposition(|c| !is_zero(c));
    let Some(degree) = leading else { return 0 };
    match point {
        End::Infinity => sign(&p[degree]),
        End::MinusInfinity if degree % 2 == 0 => sign(&p[degree]),
        End::MinusInfinity => -sign(&p[degree]),
        End::At(point) => {
            let (mut value, mut scale) = (BigInt::ZERO, BigInt::from(1));
            for c in p[..=degree].iter().rev() {
                value = value * point.numerator() + c * &scale;
                scale *= point.denominator();
            }
            sign(&value)
        }
    }
}

/// The number of sign changes, zeros left out.
pub(super) fn variations(coefficients: &[BigInt]) -> usize {
    sign_changes(coefficients.iter().map(sign))
}

pub(super) fn sign_changes(signs: impl Iterator<Item = i64>) -> usize {
    let (mut last, mut changes) = (0, 0);
    for sign in signs.filter(|sign| *sign != 0) {
        changes += usize::from(sign == -last);
        last = sign;
    }
    changes
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;

    use super::{End, power, product, shift, sign_at, substitute, variations};
    use crate::proof::numbers::Exact;

    fn integers(values: &[i64]) -> Vec<BigInt> {
        values.iter().map(|value| BigInt::from(*value)).collect()
    }

    fn fraction(above: i64, below: i64) -> Exact {
        Exact::fraction(above.into(), below.into())
    }

    #[test]
    fn a_shift_is_a_substitution_of_a_sum() {
        let p = integers(&[5, -7, 0, 2, 1]);
        for a in [-3, -1, 0, 1, 12] {
            let mut shifted = p.clone();
            shift(&mut shifted, &BigInt::from(a));
            // Horner's scheme with the polynomial x + a.
            let mut expected = Vec::new();
            for c in p.iter().rev() {
                expected = product(&expected, &integers(&[a, 1]));
                expected.resize(expected.len().max(1), BigInt::ZERO);
                expected[0] += c;
            }
            assert_eq!(shifted, expected);
        }
    }

    #[test]
    fn a_substitution_is_that_of_a_linear_polynomial_up_to_a_factor() {
        // 1 + x² at 1/2 + x/3 is (45 + 12x + 4x²)/36.
        let mut p = integers(&[1, 0, 1]);
        substitute(&mut p, &fraction(1, 2), &fraction(1, 3));
        assert_eq!(p, integers(&[45, 12, 4]));
    }

    #[test]
    fn signs_far_out_are_those_of_the_leading_term() {
        let p = integers(&[1, 0, 5, -2, 0]);
        assert_eq!(sign_at(&p, &End::Infinity), -1);
        assert_eq!(sign_at(&p, &End::MinusInfinity), 1);
        assert_eq!(sign_at(&p, &End::At(fraction(5, 2))), 1);
        assert_eq!(sign_at(&p, &End::At(fraction(13, 5))), -1);
        assert_eq!(sign_at(&integers(&[-1, 2]), &End::At(fraction(3, 6))), 0);
    }

    #[test]
    fn zeros_do_not_count_as_sign_changes() {
        assert_eq!(variations(&integers(&[0, 1, 0, 0, -2, -3, 0, 4])), 2);
        assert_eq!(power(&integers(&[1, 1]), 3), integers(&[1, 3, 3, 1]));
    }
}
