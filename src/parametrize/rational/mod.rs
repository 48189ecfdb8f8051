//! Rational parametrizations: which factors of a curve have genus 0, and x(t), y(t) of those that have one over Q.
//!
//! With y = t x a factor becomes a polynomial in R = x over the line of slopes (t0 : t1), by its homogeneous parts:
//!
//! - parts of degrees n, n−1: `s R + p = 0`, rational at once;
//! - parts of degrees n, n−1, n−2: `s R² + p R + q = 0`, the double cover `w² = p² − 4sq` of that line ([`quadratic`]);
//! - parts of degrees n, n−k with k ≥ 3: `R^k = −q/s`, a cyclic cover ([`power`]).
//!
//! Of other factors nothing is claimed. The paper stops at r(θ); this goes on to what its square roots
//! mean: of genus g ≥ 1 no curve has a rational parametrization, over any field.

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

/// Factors of a higher degree are not looked at: substituting x(t), y(t) into one of degree n is a
/// polynomial of degree 2n² in t.
const LARGEST_DEGREE: usize = 40;

/// A curve x(t), y(t) of rational functions that satisfies the equation it comes with identically.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RationalCurve {
    /// x(t)
    pub x: RationalFunction,
    /// y(t)
    pub y: RationalFunction,
}

impl RationalCurve {
    /// How long it is when written.
    fn length(&self) -> usize {
        self.x.to_string().len() + self.y.to_string().len()
    }
}

/// What is proved of the rational parametrizations of an irreducible curve.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Rationality {
    /// Genus 0, with a parametrization over Q that was verified by substitution.
    Parametrized(RationalCurve),
    /// Genus 0: r(θ) is a trigonometric polynomial, so x and y are rational functions of tan(θ/2).
    HalfAngle,
    /// Genus 0, but no parametrization over Q.
    NoRationalPoint {
        /// `w² = conic(1, t)` has no rational point,
        conic: BinaryForm,
        /// since it has none here,
        place: Place,
        /// and it has one over Q(√field).
        field: BigInt,
    },
    /// Genus 0; whether there is a rational point was not found out.
    NotDecided {
        /// `w² = conic(1, t)`
        conic: BinaryForm,
        /// The number that was not factored.
        number: BigInt,
    },
    /// Genus at least 1: there is no rational parametrization, over any field.
    PositiveGenus {
        /// The genus.
        genus: usize,
        /// The cover of the line of slopes t that proves it.
        cover: Cover,
    },
    /// Irreducible over Q, but several conjugate curves over a larger field: no parametrization over Q.
    Conjugates {
        /// How many.
        count: usize,
    },
}

/// A cover of the line of slopes.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Cover {
    /// `w² = kernel(1, t)` with a squarefree form of degree 2g + 2 (infinity counts).
    Double(BinaryForm),
    /// `R^degree = −low/top`, branched over so many slopes.
    Cyclic {
        /// k
        degree: usize,
        /// The number of geometric points of the line over which it is branched.
        branch_points: usize,
    },
}

/// A factor of a curve, by its index, and what is known of its rational parametrizations.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct FactorRationality {
    /// Which factor of the polynomial, from 0.
    pub factor: usize,
    /// What is proved.
    pub rationality: Rationality,
}

/// Decides what it can about an irreducible curve; `None` where nothing is claimed: for forms, for other
/// homogeneous parts than those above, and for degrees above 40.
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
        // A proof of its own, whatever the way it was found.
        Rationality::Parametrized(curve) => curve.satisfies(f).then_some(found),
        _ => Some(found),
    }
}

/// x = −p/s, y = t x.
fn linear(s: &BinaryForm, p: &BinaryForm) -> Option<RationalCurve> {
    let slope = [
        constant(1),
        IntegerPolynomial::from_coefficients_asc(vec![0.into(), 1.into()]),
    ];
    RationalCurve::along(&slope, &-form_at(p, &slope), &form_at(s, &slope))
}

impl RationalCurve {
    /// (x, y) = (t0, t1) · numerator / denominator.
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
