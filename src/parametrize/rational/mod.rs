//! Rational parametrizations: the factors of a curve that have genus 0, and x(t), y(t) for those that have a parametrization
//! over Q.
//!
//! With y = t x a factor becomes a polynomial in R = x over the line of slopes (t0 : t1), by its homogeneous parts:
//!
//! - parts of degrees n, n−1: `s R + p = 0`, rational at once;
//! - parts of degrees n, n−1, n−2: `s R² + p R + q = 0`, the double cover `w² = p² − 4sq` of that line ([`quadratic`]);
//! - parts of degrees n, n−k with k ≥ 3: `R^k = −q/s`, a cyclic cover ([`power`]).
//!
//! Nothing is claimed about other factors. The paper ends with r(θ); this module finds what the square roots in r(θ) imply: a
//! curve of genus g ≥ 1 has no rational parametrization over any field.

mod conic;
mod integers;
mod legendre;
mod polynomials;
mod power;
mod quadratic;

use malachite::base::polynomial::Polynomial;
use num_bigint::BigInt;

pub use legendre::Place;

use crate::poly::{BinaryForm, IntegerPolynomial, PlanePolynomial, RationalFunction};
use polynomials::{constant, form_at};

/// Factors of a higher degree n are not examined: the substitution of x(t), y(t) into the factor has degree 2n² in t.
const LARGEST_DEGREE: usize = 40;

/// A curve whose coordinates x(t), y(t) are rational functions that satisfy its equation identically.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RationalCurve {
    /// The coordinate x(t).
    pub x: RationalFunction,
    /// The coordinate y(t).
    pub y: RationalFunction,
}

impl RationalCurve {
    /// The length of the curve when it is written.
    fn length(&self) -> usize {
        self.x.to_string().len() + self.y.to_string().len()
    }
}

/// The proved result about rational parametrizations of an irreducible curve.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Rationality {
    /// The genus is 0, and this is a parametrization over Q, verified by substitution.
    Parametrized(RationalCurve),
    /// The genus is 0: r(θ) is a trigonometric polynomial, so x and y are rational functions of tan(θ/2).
    HalfAngle,
    /// The genus is 0, but there is no parametrization over Q.
    NoRationalPoint {
        /// The form of the conic `w² = conic(1, t)`, which has no rational point.
        conic: BinaryForm,
        /// A completion of Q over which the conic has no point.
        place: Place,
        /// The number d for which the curve has a parametrization over Q(√d).
        field: BigInt,
    },
    /// The genus is 0, but it was not decided whether there is a rational point.
    NotDecided {
        /// The form of the conic `w² = conic(1, t)`.
        conic: BinaryForm,
        /// The number that was not factored.
        number: BigInt,
    },
    /// The genus is at least 1, so there is no rational parametrization over any field.
    PositiveGenus {
        /// The genus.
        genus: usize,
        /// The cover of the line of slopes that proves the genus.
        cover: Cover,
    },
    /// The curve is irreducible over Q, but consists of several conjugate curves over a larger field, so it has no
    /// parametrization over Q.
    Conjugates {
        /// The number of conjugate curves.
        count: usize,
    },
}

/// A cover of the line of slopes.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Cover {
    /// The double cover `w² = kernel(1, t)`, where the squarefree form has degree 2g + 2 (a zero at infinity counts).
    Double(BinaryForm),
    /// The cyclic cover `R^degree = −low/top`.
    Cyclic {
        /// The degree k of the cover.
        degree: usize,
        /// The number of geometric points of the line over which it is branched.
        branch_points: usize,
    },
}

/// The findings about rational parametrizations of one factor of a curve.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct FactorRationality {
    /// The index of the factor of the polynomial, from 0.
    pub factor: usize,
    /// The proved result.
    pub rationality: Rationality,
}

/// Decides what it can about the rational parametrizations of an irreducible curve. The result is `None` if nothing is claimed:
/// for forms, for other homogeneous parts than those above, and for degrees above 40.
///
/// Cost: a squarefree decomposition of a form of degree 2n, for genus 0 the factors of two integers
/// (Legendre's theorem on the conic), and the substitution into the curve.
///
/// ```
/// use stellate::language::{Numbers, parse_form};
/// use stellate::parametrize::{Rationality, rational_parametrization};
/// use stellate::shape::Form;
///
/// let read = |text| parse_form(text, "<form>", Numbers::Exact);
/// let Form::Curve(folium) = read("x^3 + y^3 = 3x*y")? else { unreachable!() };
/// let Some(Rationality::Parametrized(curve)) = rational_parametrization(folium.polynomial()) else { panic!() };
/// assert_eq!(curve.x.to_string(), "(3*t)/(t^3+1)");
/// assert_eq!(curve.y.to_string(), "(3*t^2)/(t^3+1)");
///
/// let Form::Curve(elliptic) = read("x^3 + y^3 = 1 + x^2")? else { unreachable!() };
/// assert_eq!(rational_parametrization(elliptic.polynomial()), None);
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[must_use]
pub fn rational_parametrization(f: &PlanePolynomial) -> Option<Rationality> {
    let degrees = f.homogeneous_degrees();
    let (&n, &low) = (degrees.first()?, degrees.last()?);
    if n > LARGEST_DEGREE {
        return None;
    }
    let part = |d: usize| f.part(d).cloned().unwrap_or_else(|| BinaryForm::zero(d));
    let found = match (n - low, degrees.len()) {
        (0, _) => return None,
        (1, _) => Rationality::Parametrized(linear(&part(n), &part(low))?),
        (2, _) => quadratic::rationality(&part(n), &part(n - 1), &part(low))?,
        (k, 2) => power::rationality(&part(n), &part(low), k)?,
        _ => return None,
    };
    match &found {
        // This is a proof that does not depend on the way in which the curve was found.
        Rationality::Parametrized(curve) => curve.satisfies(f).then_some(found),
        _ => Some(found),
    }
}

/// The curve x = −p/s, y = t x.
fn linear(s: &BinaryForm, p: &BinaryForm) -> Option<RationalCurve> {
    let slope = [
        constant(1),
        IntegerPolynomial::from_coefficients_asc(vec![0.into(), 1.into()]),
    ];
    RationalCurve::along(&slope, &-form_at(p, &slope), &form_at(s, &slope))
}

impl RationalCurve {
    /// The curve (x, y) = (t0, t1) · numerator / denominator.
    fn along(
        [t0, t1]: &[IntegerPolynomial; 2],
        numerator: &IntegerPolynomial,
        denominator: &IntegerPolynomial,
    ) -> Option<Self> {
        Some(Self {
            x: RationalFunction::from_integers(numerator * t0, denominator.clone())?,
            y: RationalFunction::from_integers(numerator * t1, denominator.clone())?,
        })
    }

    /// Whether f(x(t), y(t)) = 0 identically, by exact polynomial arithmetic.
    ///
    /// With x = X/D and y = Y/D this is `Σ_d f_d(X, Y) D^(n−d) = 0`.
    #[must_use]
    pub fn satisfies(&self, f: &PlanePolynomial) -> bool {
        let (dx, dy) = (self.x.denominator(), self.y.denominator());
        let common = dx * dy;
        let point = [self.x.numerator() * dy, self.y.numerator() * dx];
        let mut sum = constant(0);
        let mut power = constant(1);
        let mut degree = f.degree().unwrap_or(0);
        for part in f.parts() {
            for _ in part.degree()..degree {
                power *= &common;
            }
            degree = part.degree();
            sum += form_at(part, &point) * &power;
        }
        sum == constant(0)
    }
}
