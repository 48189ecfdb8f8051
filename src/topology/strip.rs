//! A polynomial P(t, R) as a polynomial in R for fixed t, and in t for fixed R. Either t is the slope of a direction and R a power
//! of the radius, or t and R are sheared coordinates of the plane.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{BinomialCoefficient, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{BinaryForm, IntegerPolynomial, PlanePolynomial};
use crate::roots::constant_sign;

/// P(t, R) = Σ a_i(t) R^i.
#[derive(Clone, Debug)]
pub(crate) struct Strip {
    coefficients: Vec<IntegerPolynomial>,
}

impl Strip {
    /// The polynomial Σ f_i(1, t) R^i.
    pub(crate) fn of_slope(forms: &[BinaryForm]) -> Self {
        let coefficients = forms.iter().map(|f| f.dehomogenized().clone()).collect();
        Self { coefficients }
    }

    /// The polynomial Σ f_i(t, 1) R^i.
    pub(crate) fn of_cotangent(forms: &[BinaryForm]) -> Self {
        let turned = forms.iter().map(|f| {
            let row = (0..=f.degree()).rev().map(|k| f.coefficient(k));
            IntegerPolynomial::from_coefficients_asc(row.collect())
        });
        Self {
            coefficients: turned.collect(),
        }
    }

    /// D·f(t + shear·R, R), where D is the denominator of f. The degree of a_i is at most deg f − i.
    pub(crate) fn of_plane(f: &PlanePolynomial, shear: i64) -> Self {
        let degree = f.degree().unwrap_or(0);
        let mut rows: Vec<Vec<Integer>> = (0..=degree)
            .map(|i| vec![Integer::ZERO; degree + 1 - i])
            .collect();
        let shear = Integer::from(shear);
        for ((a, b), c) in f.integer_terms() {
            for k in 0..=a {
                let binomial = Integer::binomial_coefficient(Integer::from(a), Integer::from(k));
                rows[b + k][a - k] += c * binomial * (&shear).pow(k as u64);
                if shear == 0 {
                    break;
                }
            }
        }
        let polynomials = rows.into_iter();
        let mut coefficients: Vec<IntegerPolynomial> = polynomials
            .map(IntegerPolynomial::from_coefficients_asc)
            .collect();
        while coefficients.last() == Some(&IntegerPolynomial::ZERO) {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// The coefficients a_i, ascending in i.
    pub(crate) fn coefficients(&self) -> &[IntegerPolynomial] {
        &self.coefficients
    }

    /// The polynomial P(t, ·) in R, up to a positive factor.
    pub(crate) fn along(&self, t: &Rational) -> IntegerPolynomial {
        let (p, q) = (t.numerator(), t.denominator());
        let length = |a: &IntegerPolynomial| a.coefficients_asc().len();
        let longest = self.coefficients.iter().map(length).max().unwrap_or(0);
        let value = |a: &IntegerPolynomial| {
            // The value is Σ c_k p^k q^(longest − 1 − k), by Horner's rule from the highest possible power.
            let mut value = Integer::ZERO;
            let mut q_power = Integer::ONE;
            for k in (0..longest).rev() {
                value *= &p;
                if let Some(c) = a.coefficients_asc().get(k) {
                    value += c * &q_power;
                }
                q_power *= &q;
            }
            value
        };
        IntegerPolynomial::from_coefficients_asc(self.coefficients.iter().map(value).collect())
    }

    /// The polynomial P(·, r) in t, up to a positive factor.
    pub(crate) fn across(&self, r: &Rational) -> IntegerPolynomial {
        let (p, q) = (r.numerator(), r.denominator());
        let mut value = IntegerPolynomial::ZERO;
        let mut q_power = Integer::ONE;
        let constant = |c: &Integer| IntegerPolynomial::from_coefficients_asc(vec![c.clone()]);
        for a in self.coefficients.iter().rev() {
            value = value * constant(&p) + a * constant(&q_power);
            q_power *= &q;
        }
        value
    }

    /// Whether P(·, r) is proved to have no zero in [low, high].
    pub(crate) fn is_free(&self, r: &Rational, low: &Rational, high: &Rational) -> bool {
        constant_sign(&self.across(r), low, high).is_some()
    }
}

/// Bounds of g on [low, high], by Horner's rule.
pub(crate) fn range(
    g: &IntegerPolynomial,
    low: &Rational,
    high: &Rational,
) -> (Rational, Rational) {
    let mut value = (Rational::zero(), Rational::zero());
    for c in g.coefficients_asc().iter().rev() {
        let products = [
            &value.0 * low,
            &value.0 * high,
            &value.1 * low,
            &value.1 * high,
        ];
        let c = Rational::whole(c);
        let least = products.iter().min().invariant("there are products");
        let most = products.iter().max().invariant("there are products");
        value = (least + &c, most + &c);
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn poly(c: &[i64]) -> IntegerPolynomial {
        IntegerPolynomial::from_coefficients_asc(c.iter().map(|&c| Integer::from(c)).collect())
    }

    fn fraction(p: i64, q: i64) -> Rational {
        Rational::from(p) / Rational::from(q)
    }

    proptest! {
        #[test]
        fn along_and_across_are_one_polynomial(
            rows in prop::collection::vec(prop::collection::vec(-9i64..9, 3), 2..5),
            p in -9i64..9, q in 1i64..9, r in -9i64..9, s in 1i64..9,
        ) {
            let forms: Vec<BinaryForm> = rows.iter().map(|c| BinaryForm::from_coefficients(c.iter().map(|&c| Integer::from(c)).collect())).collect();
            let (t, r) = (fraction(p, q), fraction(r, s));
            let mut expected = Rational::zero();
            for (i, row) in rows.iter().enumerate() {
                let a = Rational::from(row[0]) + Rational::from(row[1]) * &t + Rational::from(row[2]) * &t * &t;
                expected = expected + a * r.pow(i64::try_from(i).unwrap()).unwrap();
            }
            let strip = Strip::of_slope(&forms);
            prop_assert_eq!(crate::poly::sign_at_rational(&strip.along(&t), &r), expected.signum());
            prop_assert_eq!(crate::poly::sign_at_rational(&strip.across(&r), &t), expected.signum());
            if p != 0 {
                // The direction is the same, because (1, t) = t (1/t, 1).
                let turned = Strip::of_cotangent(&forms).along(&fraction(q * p.signum(), p.abs()));
                prop_assert_eq!(crate::poly::sign_at_rational(&turned, &r), expected.signum());
            }
            let (low, high) = range(&poly(&rows[0]), &t, &(&t + &Rational::one()));
            let middle = Rational::from(rows[0][0]) + Rational::from(rows[0][1]) * &t + Rational::from(rows[0][2]) * &t * &t;
            prop_assert!(low <= middle && middle <= high);
        }
    }
}
