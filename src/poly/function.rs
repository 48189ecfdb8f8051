//! Rational functions of one variable over Q, in lowest terms.

use std::fmt;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Content, DivExact, Gcd};
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::dense::{coefficients, scaled, with_integers};
use super::{IntegerPolynomial, Ring, divide_exactly, polynomial_gcd};
use crate::error::Invariant;
use crate::exact::Rational;

/// The quotient of two coprime polynomials. Their coefficients have no common factor, and the leading coefficient of the
/// denominator is positive; so equal functions are equal values.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::poly::RationalFunction;
///
/// // (2t² − 2)/(−4t − 4)
/// let [above, below] = [vec![-2, 0, 2], vec![-4, -4]].map(|f| f.into_iter().map(Rational::from).collect::<Vec<_>>());
/// let f = RationalFunction::new(&above, &below).unwrap();
/// assert_eq!(f.to_string(), "(-t+1)/2");
/// assert_eq!(f.evaluate(&Rational::from(5)), Some(Rational::from(-2)));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RationalFunction {
    numerator: IntegerPolynomial,
    denominator: IntegerPolynomial,
}

impl Default for RationalFunction {
    /// The function 0.
    fn default() -> Self {
        Self {
            numerator: IntegerPolynomial::ZERO,
            denominator: IntegerPolynomial::one(),
        }
    }
}

impl RationalFunction {
    /// The function in lowest terms, from the coefficients of numerator and denominator, ascending; `None` if the denominator
    /// is 0. Cost: a gcd.
    ///
    /// ```
    /// use stellate::poly::RationalFunction;
    /// // (1 − t²)/(1 + t²)
    /// let cosine = RationalFunction::new(&[1.into(), 0.into(), (-1).into()], &[1.into(), 0.into(), 1.into()]).unwrap();
    /// assert_eq!(cosine.evaluate(&2.into()), Some("-3/5".parse()?));
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    #[must_use]
    pub fn new(numerator: &[Rational], denominator: &[Rational]) -> Option<Self> {
        let (above, above_scale) = with_integers(numerator);
        let (below, below_scale) = with_integers(denominator);
        Self::from_integers(scaled(&above, &below_scale), scaled(&below, &above_scale))
    }

    /// The coefficients of the numerator and of the denominator, ascending. They are integers without a common factor.
    #[must_use]
    pub fn coefficients(&self) -> [Vec<Rational>; 2] {
        [&self.numerator, &self.denominator].map(coefficients)
    }

    /// As [`Self::new`], from polynomials with integer coefficients.
    pub(crate) fn from_integers(
        numerator: IntegerPolynomial,
        denominator: IntegerPolynomial,
    ) -> Option<Self> {
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
    pub(crate) fn numerator(&self) -> &IntegerPolynomial {
        &self.numerator
    }

    /// The denominator.
    pub(crate) fn denominator(&self) -> &IntegerPolynomial {
        &self.denominator
    }

    /// The value at a rational number; `None` at a pole.
    #[must_use]
    pub fn evaluate(&self, at: &Rational) -> Option<Rational> {
        let value = |f: &IntegerPolynomial| {
            let coefficients = f.coefficients_asc().iter().rev();
            coefficients.fold(Rational::zero(), |v, c| v * at + Rational::whole(c))
        };
        let below = value(&self.denominator);
        (!below.is_zero()).then(|| value(&self.numerator) / below)
    }

    /// The value at infinity; `None` if it is a pole.
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
                Rational::from_integers(above.last()?.clone(), below.last()?.clone())
            }
        }
    }

    /// The function 1/f; `None` for 0.
    #[must_use]
    pub fn recip(&self) -> Option<Self> {
        Self::from_integers(self.denominator.clone(), self.numerator.clone())
    }

    /// The sum of this function and a constant.
    #[must_use]
    pub fn plus_constant(&self, constant: &Rational) -> Self {
        let (above, below) = (constant.numerator(), constant.denominator());
        let numerator = scaled(&self.numerator, &below) + scaled(&self.denominator, &above);
        let denominator = scaled(&self.denominator, &below);
        Self::from_integers(numerator, denominator).invariant("a denominator is not 0")
    }

    /// Whether the function is a polynomial with integer coefficients.
    #[must_use]
    pub fn is_polynomial(&self) -> bool {
        self.denominator == IntegerPolynomial::one()
    }

    /// The degree of the map t ↦ f(t): the larger of the two degrees, 0 for a constant.
    #[must_use]
    pub fn degree(&self) -> usize {
        let length = |f: &IntegerPolynomial| f.coefficients_asc().len();
        length(&self.numerator).max(length(&self.denominator)) - 1
    }

    /// Whether the function does not depend on t.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.degree() == 0
    }
}

/// The results are in lowest terms; each operation costs a gcd.
impl Ring for RationalFunction {
    fn plus(&self, other: &Self) -> Self {
        let numerator = &self.numerator * &other.denominator + &other.numerator * &self.denominator;
        let denominator = &self.denominator * &other.denominator;
        Self::from_integers(numerator, denominator).invariant("no denominator is 0")
    }

    fn minus(&self, other: &Self) -> Self {
        let numerator = &self.numerator * &other.denominator - &other.numerator * &self.denominator;
        let denominator = &self.denominator * &other.denominator;
        Self::from_integers(numerator, denominator).invariant("no denominator is 0")
    }

    fn times(&self, other: &Self) -> Self {
        let numerator = &self.numerator * &other.numerator;
        let denominator = &self.denominator * &other.denominator;
        Self::from_integers(numerator, denominator).invariant("no denominator is 0")
    }
}

impl fmt::Display for RationalFunction {
    /// Writes the function with the parameter t, such as `(-t+1)/2`.
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
