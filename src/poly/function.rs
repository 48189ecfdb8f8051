//! Rational functions of one variable over Q, in lowest terms.

use std::fmt;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Content, DivExact, Gcd};
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::{IntegerPolynomial, Ring, divide_exactly, polynomial_gcd};
use crate::error::Invariant;
use crate::exact::Rational;

/// numerator / denominator: coprime polynomials whose coefficients have no common factor either, the
/// denominator with positive leading coefficient. So equal functions are equal values.
///
/// ```
/// use std::str::FromStr;
/// use stellate::exact::Rational;
/// use stellate::poly::{IntegerPolynomial, RationalFunction};
///
/// let polynomial = |text| IntegerPolynomial::from_str(text).unwrap();
/// let f = RationalFunction::new(polynomial("2*x^2-2"), polynomial("-4*x-4")).unwrap();
/// assert_eq!(f.to_string(), "(-t+1)/2");
/// assert_eq!(f.evaluate(&Rational::from(5)), Some(Rational::from(-2)));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RationalFunction {
    numerator: IntegerPolynomial,
    denominator: IntegerPolynomial,
}

impl Default for RationalFunction {
    /// 0.
    fn default() -> Self {
        Self {
            numerator: IntegerPolynomial::ZERO,
            denominator: IntegerPolynomial::one(),
        }
    }
}

impl RationalFunction {
    /// In lowest terms; `None` if the denominator is 0. Cost: a gcd.
    #[must_use]
    pub fn new(numerator: IntegerPolynomial, denominator: IntegerPolynomial) -> Option<Self> {
        let lead = denominator.coefficients_asc().last()?;
        if numerator == IntegerPolynomial::ZERO {
            return Some(Self {
                numerator,
                denominator: IntegerPolynomial::one(),
            });
        }
        let mut content = Integer::from((&numerator).content().gcd((&denominator).content()));
        if *lead < 0 {
            content = -content;
        }
        let common = polynomial_gcd(&numerator, &denominator);
        let reduced = |f: &IntegerPolynomial| Some(divide_exactly(f, &common)?.div_exact(&content));
        Some(Self {
            numerator: reduced(&numerator)?,
            denominator: reduced(&denominator)?,
        })
    }

    /// The numerator.
    #[must_use]
    pub fn numerator(&self) -> &IntegerPolynomial {
        &self.numerator
    }

    /// The denominator.
    #[must_use]
    pub fn denominator(&self) -> &IntegerPolynomial {
        &self.denominator
    }

    /// The value at a rational number, `None` at a pole.
    #[must_use]
    pub fn evaluate(&self, at: &Rational) -> Option<Rational> {
        let value = |f: &IntegerPolynomial| {
            let coefficients = f.coefficients_asc().iter().rev();
            coefficients.fold(Rational::zero(), |v, c| v * at + Rational::from(c))
        };
        let below = value(&self.denominator);
        (!below.is_zero()).then(|| value(&self.numerator) / below)
    }

    /// The value at infinity, `None` if there is a pole.
    #[must_use]
    pub fn evaluate_at_infinity(&self) -> Option<Rational> {
        let (above, below) = (
            self.numerator.coefficients_asc(),
            self.denominator.coefficients_asc(),
        );
        match above.len().cmp(&below.len()) {
            std::cmp::Ordering::Greater => None,
            std::cmp::Ordering::Less => Some(Rational::zero()),
            std::cmp::Ordering::Equal => {
                Rational::new(above.last()?.clone(), below.last()?.clone())
            }
        }
    }

    /// 1/f, `None` for 0.
    #[must_use]
    pub fn recip(&self) -> Option<Self> {
        Self::new(self.denominator.clone(), self.numerator.clone())
    }

    /// This function and a constant.
    #[must_use]
    pub fn plus_constant(&self, constant: &Rational) -> Self {
        let times = |f: &IntegerPolynomial, c: Integer| {
            f * IntegerPolynomial::from_coefficients_asc(vec![c])
        };
        let numerator = times(&self.numerator, constant.denominator())
            + times(&self.denominator, constant.numerator());
        let denominator = times(&self.denominator, constant.denominator());
        Self::new(numerator, denominator).invariant("a denominator is not 0")
    }

    /// Whether it is a polynomial with integer coefficients.
    #[must_use]
    pub fn is_polynomial(&self) -> bool {
        self.denominator == IntegerPolynomial::one()
    }

    /// The degree of the map t ↦ f(t): the larger one of the two degrees, 0 for a constant.
    #[must_use]
    pub fn degree(&self) -> usize {
        let length = |f: &IntegerPolynomial| f.coefficients_asc().len();
        length(&self.numerator).max(length(&self.denominator)) - 1
    }

    /// Whether it does not depend on t.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.degree() == 0
    }
}

/// Sums and products in lowest terms, at the cost of a gcd each.
impl Ring for RationalFunction {
    fn plus(&self, other: &Self) -> Self {
        let numerator = &self.numerator * &other.denominator + &other.numerator * &self.denominator;
        let denominator = &self.denominator * &other.denominator;
        Self::new(numerator, denominator).invariant("no denominator is 0")
    }

    fn minus(&self, other: &Self) -> Self {
        let numerator = &self.numerator * &other.denominator - &other.numerator * &self.denominator;
        let denominator = &self.denominator * &other.denominator;
        Self::new(numerator, denominator).invariant("no denominator is 0")
    }

    fn times(&self, other: &Self) -> Self {
        let numerator = &self.numerator * &other.numerator;
        let denominator = &self.denominator * &other.denominator;
        Self::new(numerator, denominator).invariant("no denominator is 0")
    }
}

impl fmt::Display for RationalFunction {
    /// In the parameter t, as `(-t+1)/2`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = |p: &IntegerPolynomial| {
            let text = p.to_string().replace('x', "t");
            let constant = p.coefficients_asc().len() <= 1;
            if constant { text } else { format!("({text})") }
        };
        if self.is_polynomial() {
            return f.write_str(&self.numerator.to_string().replace('x', "t"));
        }
        write!(f, "{}/{}", text(&self.numerator), text(&self.denominator))
    }
}
