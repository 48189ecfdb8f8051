//! Symmetric polynomials in two parameters s and σ, as polynomials in their sum S and their product P.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, RationalFunction};

/// A polynomial in two variables. For each power of the second variable, ascending, it has a coefficient, which is a polynomial
/// in the first variable. The last coefficient is not 0.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Rows(Vec<IntegerPolynomial>);

impl Rows {
    pub(super) fn new(mut rows: Vec<IntegerPolynomial>) -> Self {
        while rows.last() == Some(&IntegerPolynomial::ZERO) {
            rows.pop();
        }
        Self(rows)
    }

    pub(super) fn rows(&self) -> &[IntegerPolynomial] {
        &self.0
    }

    /// The degree in the second variable; 0 for the polynomial 0.
    pub(super) fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    /// The total degree; 0 for the polynomial 0.
    pub(super) fn total_degree(&self) -> usize {
        let degrees = self.0.iter().enumerate();
        let degrees =
            degrees.filter_map(|(k, row)| Some(k + row.coefficients_asc().len().checked_sub(1)?));
        degrees.max().unwrap_or(0)
    }

    /// The coefficient of the highest power of the second variable; 0 for the polynomial 0.
    pub(super) fn lead(&self) -> IntegerPolynomial {
        self.0.last().cloned().unwrap_or(IntegerPolynomial::ZERO)
    }

    /// The polynomial in the second variable for the value p/q of the first one, times q to the degree in the first variable.
    pub(super) fn at(&self, value: &Rational) -> IntegerPolynomial {
        let (p, q) = (value.numerator(), value.denominator());
        let length = |row: &IntegerPolynomial| row.coefficients_asc().len();
        let degree = self.0.iter().map(length).max().unwrap_or(0);
        let row = |row: &IntegerPolynomial| {
            let mut sum = Integer::ZERO;
            let mut power = Integer::from(1);
            for k in (0..degree).rev() {
                sum *= &p;
                if let Some(c) = row.coefficients_asc().get(k) {
                    sum += c * &power;
                }
                power *= &q;
            }
            sum
        };
        IntegerPolynomial::from_coefficients_asc(self.0.iter().map(row).collect())
    }

    /// The polynomial c·self − d·other.
    pub(super) fn combined(&self, c: &Integer, other: &Self, d: &Integer) -> Self {
        let scaled = |f: &Self, k: usize, c: &Integer| {
            let factor = IntegerPolynomial::from_coefficients_asc(vec![c.clone()]);
            f.0.get(k)
                .map_or(IntegerPolynomial::ZERO, |row| row * factor)
        };
        let rows = 0..self.0.len().max(other.0.len());
        Self::new(
            rows.map(|k| scaled(self, k, c) - scaled(other, k, d))
                .collect(),
        )
    }

    /// The polynomial `f(S, above/below)·below^degree`, where `above` and `below` are polynomials in S.
    pub(super) fn at_quotient(&self, [above, below]: [&IntegerPolynomial; 2]) -> IntegerPolynomial {
        let mut value = IntegerPolynomial::ZERO;
        let mut power = IntegerPolynomial::from_coefficients_asc(vec![Integer::from(1)]);
        for row in self.0.iter().rev() {
            value = value * above + row * &power;
            power *= below;
        }
        value
    }
}

/// Bézout's matrix of f = p/q: the coefficients of `(p(s) q(σ) − q(s) p(σ))/(s − σ)` by the powers of s and σ. It is symmetric,
/// and its size is the degree of f.
///
/// If D is the numerator and Q the quotient, `D[i][j] = Q[i−1][j] − Q[i][j−1]`.
pub(super) fn bezoutian(f: &RationalFunction) -> Vec<Vec<Integer>> {
    let degree = f.degree();
    let [p, q] = [f.numerator(), f.denominator()].map(IntegerPolynomial::coefficients_asc);
    let product = |p: &[Integer], i: usize, q: &[Integer], j: usize| match (p.get(i), q.get(j)) {
        (Some(p), Some(q)) => p * q,
        _ => Integer::ZERO,
    };
    let mut quotient = vec![vec![Integer::ZERO; degree]; degree];
    for i in (1..=degree).rev() {
        for j in 0..degree {
            let mut value = product(p, i, q, j) - product(q, i, p, j);
            if j > 0 && i < degree {
                value += &quotient[i][j - 1];
            }
            quotient[i - 1][j] = value;
        }
    }
    quotient
}

/// Bézout's matrix as a polynomial in s and σ.
pub(super) fn in_both(matrix: &[Vec<Integer>]) -> Rows {
    let rows = matrix.iter().cloned();
    Rows::new(rows.map(IntegerPolynomial::from_coefficients_asc).collect())
}

/// A symmetric matrix of the coefficients of s^i σ^j as a polynomial in S = s + σ and P = sσ.
///
/// `s^i σ^j + s^j σ^i = P^j (s^(i−j) + σ^(i−j))` for i > j, and Newton's `p_k = S p_(k−1) − P p_(k−2)` for these sums of
/// powers: p_k is `Σ_l c_(k,l) S^(k−2l) P^l`.
pub(super) fn in_sum_and_product(matrix: &[Vec<Integer>]) -> Rows {
    let size = matrix.len();
    // The coefficients c_(k,l).
    let mut powers: Vec<Vec<Integer>> = vec![vec![Integer::from(2)], vec![Integer::from(1)]];
    for k in 2..size {
        let mut next = powers[k - 1].clone();
        next.resize(k / 2 + 1, Integer::ZERO);
        for (l, c) in powers[k - 2].iter().enumerate() {
            next[l + 1] -= c;
        }
        powers.push(next);
    }
    let mut rows = vec![vec![Integer::ZERO; size]; size];
    for (i, line) in matrix.iter().enumerate() {
        rows[i][0] += &line[i];
        for (j, c) in line[..i].iter().enumerate() {
            for (l, power) in powers[i - j].iter().enumerate() {
                rows[j + l][i - j - 2 * l] += c * power;
            }
        }
    }
    let rows = rows.into_iter();
    Rows::new(rows.map(IntegerPolynomial::from_coefficients_asc).collect())
}

/// The remainder u + v s of f modulo s² − S s + P, where u and v are polynomials in S and P.
pub(super) fn modulo(f: &IntegerPolynomial) -> [Rows; 2] {
    let sum = IntegerPolynomial::from_coefficients_asc(vec![Integer::ZERO, Integer::from(1)]);
    let [mut u, mut v]: [Vec<IntegerPolynomial>; 2] = [Vec::new(), Vec::new()];
    for c in f.coefficients_asc().iter().rev() {
        // (u + v s) s + c = (c − v P) + (u + v S) s
        let mut constant = vec![IntegerPolynomial::from_coefficients_asc(vec![c.clone()])];
        constant.extend(v.iter().map(|row| IntegerPolynomial::ZERO - row));
        let mut linear: Vec<IntegerPolynomial> = v.iter().map(|row| row * &sum).collect();
        linear.resize(linear.len().max(u.len()), IntegerPolynomial::ZERO);
        for (row, other) in linear.iter_mut().zip(&u) {
            *row += other;
        }
        (u, v) = (constant, linear);
    }
    [Rows::new(u), Rows::new(v)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn value(f: &IntegerPolynomial, at: &Rational) -> Rational {
        let coefficients = f.coefficients_asc().iter().rev();
        coefficients.fold(Rational::zero(), |v, c| v * at + Rational::whole(c))
    }

    fn value_of_rows(f: &Rows, first: &Rational, second: &Rational) -> Rational {
        let rows = f.rows().iter().rev();
        rows.fold(Rational::zero(), |v, row| v * second + value(row, first))
    }

    fn polynomial() -> impl Strategy<Value = IntegerPolynomial> {
        prop::collection::vec(-20i64..20, 0..8).prop_map(|c| {
            IntegerPolynomial::from_coefficients_asc(c.into_iter().map(Integer::from).collect())
        })
    }

    proptest! {
        #[test]
        fn symmetric_polynomials_have_the_same_values(p in polynomial(), q in polynomial(), s in -9i64..9, t in -9i64..9) {
            let (s, t) = (Rational::from(s) / Rational::from(3), Rational::from(t) / Rational::from(2));
            let (sum, product) = (&s + &t, &s * &t);
            let [u, v] = modulo(&p);
            let rest = value_of_rows(&u, &sum, &product) + value_of_rows(&v, &sum, &product) * &s;
            prop_assert_eq!(rest, value(&p, &s));
            prop_assume!(s != t);
            if let Some(f) = RationalFunction::from_integers(p, q) {
                let (p, q) = (f.numerator(), f.denominator());
                let above = value(p, &s) * value(q, &t) - value(q, &s) * value(p, &t);
                let expected = above / (&s - &t);
                let matrix = bezoutian(&f);
                prop_assert_eq!(&value_of_rows(&in_both(&matrix), &s, &t), &expected);
                let symmetric = in_sum_and_product(&matrix);
                prop_assert_eq!(&value_of_rows(&symmetric, &sum, &product), &expected);
                prop_assert!(symmetric.total_degree() < f.degree().max(1));
                // The value of the first variable multiplies by a power of its denominator.
                let at = symmetric.at(&sum);
                let zero = value_of_rows(&symmetric, &sum, &product).is_zero();
                prop_assert_eq!(value(&at, &product).is_zero(), zero);
            }
        }
    }
}
