//! Exact square roots of polynomials.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{CheckedSqrt, DivRem, Square};
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::IntegerPolynomial;

/// The polynomial q with `q² = f` and a positive leading coefficient; `None` if f is not the square of a polynomial with
/// integer coefficients.
///
/// The coefficients are computed from the highest one down, and the result is verified by squaring. Cost: d²/8 products of
/// coefficients for degree d.
#[must_use]
pub(crate) fn polynomial_sqrt(f: &IntegerPolynomial) -> Option<IntegerPolynomial> {
    let p = f.coefficients_asc();
    let Some(top) = p.last() else {
        return Some(IntegerPolynomial::ZERO);
    };
    let degree = p.len() - 1;
    if !degree.is_multiple_of(2) {
        return None;
    }
    let n = degree / 2;
    if *top < 0 {
        return None;
    }
    let lead = top.checked_sqrt()?;
    let twice = &lead * Integer::from(2);
    let mut q = vec![Integer::ZERO; n + 1];
    q[n] = lead;
    for k in 1..=n {
        // p_(2n−k) = 2 q_n q_(n−k) + Σ q_i q_j over n−k < i, j < n with i + j = 2n−k.
        let mut rest = p[2 * n - k].clone();
        for i in n - k + 1..n {
            let j = 2 * n - k - i;
            match i.cmp(&j) {
                std::cmp::Ordering::Less => rest -= (&q[i] * &q[j]) << 1u64,
                std::cmp::Ordering::Equal => rest -= (&q[i]).square(),
                std::cmp::Ordering::Greater => break,
            }
        }
        let (value, remainder) = rest.div_rem(&twice);
        if remainder != 0 {
            return None;
        }
        q[n - k] = value;
    }
    let root = IntegerPolynomial::from_coefficients_asc(q);
    ((&root).square() == *f).then_some(root)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn what_is_no_square_has_no_root() {
        let f =
            |c: [i64; 3]| IntegerPolynomial::from_coefficients_asc(c.map(Integer::from).to_vec());
        let root = polynomial_sqrt(&f([9, 12, 4])).unwrap();
        assert_eq!(root, f([3, 2, 0]));
        assert_eq!(polynomial_sqrt(&f([1, 0, 1])), None);
    }

    proptest! {
        #[test]
        fn the_root_of_a_square(c in prop::collection::vec(any::<i64>(), 0..30), other in 1..100i64) {
            let q = IntegerPolynomial::from_coefficients_asc(c.into_iter().map(Integer::from).collect());
            let square = (&q).square();
            let root = polynomial_sqrt(&square).unwrap();
            prop_assert!(root == q || root == -&q);
            let one_more = square + IntegerPolynomial::from_coefficients_asc(vec![Integer::from(other)]);
            if let Some(root) = polynomial_sqrt(&one_more) {
                prop_assert_eq!(root.square(), one_more);
            }
        }
    }
}
