//! Signs of polynomials at real roots, and on intervals without zeros.

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use super::RealRoot;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, integer_sign, shift_by_one, sign_at};

impl RealRoot {
    /// The exact sign of g at this root.
    ///
    /// A gcd decides whether g is 0 here. If it is not, the enclosure of the root is narrowed until [`constant_sign`] proves
    /// that g has one sign on all of it. That ends, because g has no zero on a sufficiently narrow enclosure.
    pub(crate) fn sign_of(&self, g: &IntegerPolynomial) -> i8 {
        if *g == IntegerPolynomial::ZERO || self.is_root_of(g) {
            return 0;
        }
        let mut root = self.clone();
        let mut bits = 16;
        loop {
            let (low, high) = root.enclosure();
            if low == high {
                return sign_at(g, low);
            }
            if let Some(sign) = constant_sign(g, &low.to_rational(), &high.to_rational()) {
                return sign;
            }
            root.refine(bits);
            bits *= 2;
        }
    }
}

/// The sign of g on [low, high], or `None` if it is not proved that g has one sign there.
///
/// Lemma. If no two Bernstein coefficients of g on [low, high] have opposite signs, and the first and the last one are not 0,
/// then g has their sign at every point of [low, high].
/// Proof. The first and the last coefficient are the values of g at the ends. Inside, every Bernstein polynomial is positive,
/// so g is a sum of terms of one sign, of which at least one is not 0.
/// Law: `a_sign_without_zeros_is_proved`.
///
/// If g has no zero on an interval, the hypothesis holds as soon as the interval is short enough: the coefficients tend to the
/// values of g.
pub(crate) fn constant_sign(g: &IntegerPolynomial, low: &Rational, high: &Rational) -> Option<i8> {
    let degree = g.coefficients_asc().len().checked_sub(1)?;
    // With low = p/q and high = (p + w)/q for q = `common`, this is q^degree g((p + w x)/q): x runs from 0 to 1.
    let common = low.denominator() * high.denominator();
    let whole = Rational::whole(&common);
    let p = (low * &whole).numerator();
    let w = ((high - low) * &whole).numerator();
    let line = IntegerPolynomial::from_coefficients_asc(vec![p, w]);
    let mut moved = IntegerPolynomial::ZERO;
    let mut power = Integer::ONE;
    for c in g.coefficients_asc().iter().rev() {
        let term = IntegerPolynomial::from_coefficients_asc(vec![c * &power]);
        moved = moved * &line + term;
        power *= &common;
    }
    // (1 + x)^degree g(low + (high − low)/(1 + x)) up to the same factor: its coefficients are those in the Bernstein basis from
    // `high` to `low`, each times a positive binomial coefficient.
    let mut coefficients = moved.into_coefficients_asc();
    coefficients.resize(degree + 1, Integer::ZERO);
    coefficients.reverse();
    let bernstein = shift_by_one(IntegerPolynomial::from_coefficients_asc(coefficients));
    let signs = bernstein.coefficients_asc().iter().map(integer_sign);
    let [first, last] = [
        bernstein.coefficients_asc().first()?,
        bernstein.coefficients_asc().get(degree)?,
    ]
    .map(integer_sign);
    (first != 0 && first == last && signs.into_iter().all(|s| s == 0 || s == first))
        .then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roots::real_roots;

    fn poly(c: &[i64]) -> IntegerPolynomial {
        IntegerPolynomial::from_coefficients_asc(c.iter().map(|&c| Integer::from(c)).collect())
    }

    fn fraction(p: i64, q: i64) -> Rational {
        Rational::from(p) / Rational::from(q)
    }

    #[test]
    fn a_sign_without_zeros_is_proved() {
        let g = poly(&[-2, 0, 1]); // t² − 2
        assert_eq!(constant_sign(&g, &fraction(3, 2), &fraction(2, 1)), Some(1));
        assert_eq!(
            constant_sign(&g, &fraction(-1, 1), &fraction(1, 1)),
            Some(-1)
        );
        assert_eq!(constant_sign(&g, &fraction(1, 1), &fraction(2, 1)), None);
        assert_eq!(
            constant_sign(&poly(&[0, 1]), &fraction(0, 1), &fraction(2, 1)),
            None
        );
        assert_eq!(
            constant_sign(&poly(&[-3]), &fraction(0, 1), &fraction(2, 1)),
            Some(-1)
        );
        assert_eq!(
            constant_sign(&poly(&[]), &fraction(0, 1), &fraction(2, 1)),
            None
        );
    }

    #[test]
    fn signs_at_the_square_root_of_two() {
        let root = &real_roots(&poly(&[-2, 0, 1]))[1];
        assert_eq!(root.sign_of(&poly(&[-2, 0, 1])), 0);
        assert_eq!(root.sign_of(&poly(&[-141_421_356, 100_000_000])), 1);
        assert_eq!(root.sign_of(&poly(&[-141_421_357, 100_000_000])), -1);
        assert_eq!(root.sign_of(&poly(&[])), 0);
    }
}
