//! Binary forms: homogeneous polynomials in x and y.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Content, DivExact, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::{MulPowerOfX, Polynomial};
use num_bigint::BigInt;

use super::{IntegerPolynomial, Ring};
use crate::bigint::binomials;
use crate::error::Invariant;
use crate::exact::{integer_from_num, integer_to_num};

/// A homogeneous polynomial `f(x, y) = Σ_k f_k x^(d−k) y^k` with integer coefficients.
///
/// The form is stored as the univariate polynomial `f(1, t)` with the degree d, so a product of forms is one fast product of
/// univariate polynomials.
///
/// ```
/// use stellate::poly::PlanePolynomial;
/// // x² + 3/2 xy + y: two homogeneous parts over the denominator 2.
/// let terms = [((2, 0), 1.into()), ((1, 1), "3/2".parse()?), ((0, 1), 1.into())];
/// let f = PlanePolynomial::from_terms(terms);
/// assert_eq!(f.common_denominator(), 2.into());
/// assert_eq!(f.part(2).unwrap().coefficients(), [2.into(), 3.into(), 0.into()]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BinaryForm {
    degree: usize,
    in_t: IntegerPolynomial,
}

impl BinaryForm {
    /// The form of degree `coefficients.len() − 1` in which the k-th number is the coefficient of `x^(d−k) y^k`. Without
    /// coefficients it is the zero form of degree 0.
    #[must_use]
    pub fn new(coefficients: impl IntoIterator<Item = impl Into<BigInt>>) -> Self {
        let coefficients = coefficients.into_iter();
        let mut integers: Vec<Integer> =
            coefficients.map(|c| integer_from_num(&c.into())).collect();
        if integers.is_empty() {
            integers.push(Integer::ZERO);
        }
        Self::from_coefficients(integers)
    }

    /// As [`Self::new`], from malachite's integers.
    ///
    /// # Panics
    /// If there are no coefficients: even the zero form has a degree.
    #[doc(hidden)]
    #[must_use]
    pub fn from_coefficients(coefficients: Vec<Integer>) -> Self {
        assert!(!coefficients.is_empty(), "a form has a degree");
        Self {
            degree: coefficients.len() - 1,
            in_t: IntegerPolynomial::from_coefficients_asc(coefficients),
        }
    }

    /// The form of degree `degree` with `f(1, t) = in_t`.
    ///
    /// # Panics
    /// If `in_t` has a larger degree than that.
    pub(crate) fn from_dehomogenized(degree: usize, in_t: IntegerPolynomial) -> Self {
        assert!(
            in_t.coefficients_asc().len().saturating_sub(1) <= degree,
            "the degree is too small"
        );
        Self { degree, in_t }
    }

    /// The zero form of degree `degree`.
    pub(crate) fn zero(degree: usize) -> Self {
        Self {
            degree,
            in_t: IntegerPolynomial::ZERO,
        }
    }

    /// `(x² + y²)^power`.
    #[doc(hidden)]
    #[must_use]
    pub fn rho_power(power: usize) -> Self {
        let mut row = vec![Integer::ZERO; 2 * power + 1];
        for (k, binomial) in binomials(power).into_iter().enumerate() {
            row[2 * k] = binomial;
        }
        Self::from_coefficients(row)
    }

    /// The degree d, which the zero form has as well.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Whether every coefficient is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.in_t.coefficients_asc().is_empty()
    }

    /// The polynomial `f(1, t)`.
    pub(crate) fn dehomogenized(&self) -> &IntegerPolynomial {
        &self.in_t
    }

    /// The coefficient of `x^(d−k) y^k`.
    pub(crate) fn coefficient(&self, k: usize) -> Integer {
        self.in_t
            .coefficients_asc()
            .get(k)
            .cloned()
            .unwrap_or(Integer::ZERO)
    }

    /// The coefficients of y⁰, y¹, … up to the last one that is not 0.
    pub(crate) fn into_coefficients(self) -> Vec<Integer> {
        self.in_t.into_coefficients_asc()
    }

    /// The d + 1 coefficients; the k-th is that of `x^(d−k) y^k`.
    #[must_use]
    pub fn coefficients(&self) -> Vec<BigInt> {
        (0..=self.degree)
            .map(|k| integer_to_num(&self.coefficient(k)))
            .collect()
    }

    /// The non-zero terms as `(k, coefficient of x^(d−k) y^k)`, ascending in k.
    pub(crate) fn terms(&self) -> impl Iterator<Item = (usize, &Integer)> {
        self.in_t
            .coefficients_asc()
            .iter()
            .enumerate()
            .filter(|(_, c)| **c != 0)
    }

    /// The terms of [`Self::terms`], moved.
    pub(crate) fn into_terms(self) -> impl Iterator<Item = (usize, Integer)> {
        let coefficients = self.in_t.into_coefficients_asc().into_iter();
        coefficients.enumerate().filter(|(_, c)| *c != 0)
    }

    /// The gcd of the coefficients; 0 for the zero form.
    pub(crate) fn content(&self) -> Integer {
        Integer::from((&self.in_t).content())
    }

    /// The quotient `f / divisor`; the divisor must divide the content.
    pub(crate) fn div_exact(&self, divisor: &Integer) -> Self {
        if *divisor == 1 {
            return self.clone();
        }
        Self {
            degree: self.degree,
            in_t: (&self.in_t).div_exact(divisor),
        }
    }

    /// The product `factor · f`.
    #[doc(hidden)]
    #[must_use]
    pub fn scaled(&self, factor: &Integer) -> Self {
        let constant = IntegerPolynomial::from_coefficients_asc(vec![factor.clone()]);
        Self {
            degree: self.degree,
            in_t: &self.in_t * constant,
        }
    }

    /// The product `(x² + y²) f`, by one addition for each coefficient.
    pub(crate) fn times_rho(&self) -> Self {
        Self {
            degree: sum_of_degrees(self.degree, 2),
            in_t: &self.in_t + (&self.in_t).mul_power_of_x(2),
        }
    }

    /// The quotient `f / (x² + y²)`; `None` if it is not a form.
    pub(crate) fn divided_by_rho(&self) -> Option<Self> {
        if self.is_zero() {
            return (self.degree >= 2).then(|| Self::zero(self.degree - 2));
        }
        let mut rest = self.in_t.clone().into_coefficients_asc();
        if rest.len() < 3 {
            return None;
        }
        let quotient = rest.split_off(2).len();
        // The division begins with the lowest coefficient: q_k = f_k − q_(k−2).
        let coefficients = self.in_t.coefficients_asc();
        let mut q: Vec<Integer> = Vec::with_capacity(quotient);
        for (k, c) in coefficients.iter().enumerate() {
            let value = if k >= 2 { c - &q[k - 2] } else { c.clone() };
            if k < quotient {
                q.push(value);
            } else if value != 0 {
                return None;
            }
        }
        Some(Self {
            degree: self.degree - 2,
            in_t: IntegerPolynomial::from_coefficients_asc(q),
        })
    }

    /// The largest e such that `(x² + y²)^e` divides f, and the quotient; `None` for the zero form.
    pub(crate) fn strip_rho(&self) -> Option<(usize, Self)> {
        if self.is_zero() {
            return None;
        }
        let (mut power, mut rest) = (0, self.clone());
        while let Some(quotient) = rest.divided_by_rho() {
            rest = quotient;
            power += 1;
        }
        Some((power, rest))
    }

    /// The value `f(u, v)`. Cost: d products by u and v of a number that becomes longer and longer.
    pub(crate) fn evaluate(&self, u: &Integer, v: &Integer) -> Integer {
        // Horner's rule in y/x, homogenised: Σ f_k u^(d−k) v^k.
        let mut value = Integer::ZERO;
        let mut u_power = Integer::ONE;
        for k in (0..=self.degree).rev() {
            value *= v;
            if let Some(c) = self.in_t.coefficients_asc().get(k)
                && *c != 0
            {
                value += c * &u_power;
            }
            if k > 0 {
                u_power *= u;
            }
        }
        value
    }

    /// Whether f(−x, −y) = f, that is, whether the degree is even.
    pub(crate) fn is_even(&self) -> bool {
        self.degree.is_multiple_of(2)
    }

    fn assert_same_degree(&self, other: &Self) {
        assert_eq!(self.degree, other.degree, "forms of one degree are added");
    }
}

/// The degree of a product. A zero form can have any degree, so it may be larger than the memory allows.
fn sum_of_degrees(a: usize, b: usize) -> usize {
    a.checked_add(b)
        .invariant("the degree of a product fits in a word")
}

impl Ring for BinaryForm {
    fn plus(&self, other: &Self) -> Self {
        self.assert_same_degree(other);
        Self {
            degree: self.degree,
            in_t: &self.in_t + &other.in_t,
        }
    }

    fn minus(&self, other: &Self) -> Self {
        self.assert_same_degree(other);
        Self {
            degree: self.degree,
            in_t: &self.in_t - &other.in_t,
        }
    }

    /// # Panics
    /// If the degree of the product does not fit in a `usize`: only zero forms have such degrees.
    fn times(&self, other: &Self) -> Self {
        Self {
            degree: sum_of_degrees(self.degree, other.degree),
            in_t: &self.in_t * &other.in_t,
        }
    }

    fn squared(&self) -> Self {
        Self {
            degree: sum_of_degrees(self.degree, self.degree),
            in_t: (&self.in_t).square(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_product_with_rho_is_the_short_one(coefficients in prop::collection::vec(any::<i64>(), 1..12)) {
            let f = BinaryForm::new(coefficients);
            let product = f.times_rho();
            prop_assert_eq!(&product, &f.times(&BinaryForm::rho_power(1)));
            prop_assert_eq!(product.divided_by_rho(), Some(f));
        }
    }

    #[test]
    fn a_product_of_degrees_that_fit_has_their_sum() {
        let zero = BinaryForm::zero(usize::MAX - 5).times(&BinaryForm::zero(5));
        assert_eq!(zero.degree(), usize::MAX);
        let constant = BinaryForm::from_dehomogenized(usize::MAX, IntegerPolynomial::one());
        assert_eq!(constant.degree(), usize::MAX);
    }

    #[test]
    #[should_panic(expected = "the degree of a product fits in a word")]
    fn a_product_of_a_larger_degree_stops() {
        let _ = BinaryForm::zero(usize::MAX).times(&BinaryForm::zero(1));
    }

    #[test]
    #[should_panic(expected = "the degree of a product fits in a word")]
    fn a_square_of_a_larger_degree_stops() {
        let _ = BinaryForm::zero(usize::MAX / 2 + 1).squared();
    }
}
