//! Theorem 1, Eq. (1): plane curves whose slope function is inverted by substitution.

use super::{PolarFactor, PolarInverse, Role, squared_radius};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::factor::factor_plane;
use crate::implicitize::inverse::{Inverse, invert};
use crate::implicitize::map::RationalMap;
use crate::implicitize::resultant::implicitize_plane;
use crate::limits::Limits;
use crate::poly::{Ring, SparsePolynomial};
use crate::shape::{ImplicitCurve, ParametricCurve, PlaneCurve};

/// The result of Theorem 1.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct PolarPlane {
    /// The irreducible equation of the curve.
    pub curve: ImplicitCurve,
    /// Eq. (1), or the reason why substitution cannot invert the slope function.
    pub inverse: PolarInverse,
    /// The irreducible factors of the polar equation, cleared of denominators.
    pub factors: Vec<PolarFactor>,
}

/// Theorem 1: the polar equation of a plane curve, its irreducible factors, and the factor that is the curve.
///
/// With the slope m = y/x of the curve (h, g), `h² + g²` is a rational function H of m exactly if the numerator of m(s) − m(σ)
/// divides that of the difference of `h² + g²` at s and σ; then Eq. (1) says `x² + y² = H(y/x)`. Otherwise a resultant
/// eliminates the parameter between m and w = h² + g², and the polar equation is `P(y/x, x² + y²) = 0`. Cleared of
/// denominators, the equation is factored over Q. The factor that vanishes on the curve is its equation; the others are
/// spurious.
///
/// DIFFERENCE: the paper calls Eq. (1) free of spurious parts. It contains the reflection −α of every curve
/// that is not its own reflection.
///
/// ```
/// use stellate::implicitize::{Role, polar_plane};
/// use stellate::language::{Numbers, parse_form};
/// use stellate::limits::Limits;
/// use stellate::shape::Form;
///
/// let form = parse_form("x = 1 + t^2; y = t + t^3", "<form>", Numbers::Exact)?;
/// let Form::PlaneCurve(curve) = form else { panic!("a plane curve") };
/// let polar = polar_plane(&curve, &Limits::none())?;
/// let roles: Vec<_> = polar.factors.iter().map(|f| f.role).collect();
/// // (x² + y²) (x³ − x² − y²) (x³ + x² + y²)
/// assert_eq!(roles, [Role::SquaredRadius, Role::Form, Role::Reflection]);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// Cost: linear algebra with 2(deg H + 1) columns, and a factorization in degree deg H + 2.
///
/// # Errors
/// [`Error::Hypothesis`] if the slope is constant, or x = 0; those of the resultant, the factorization and of
/// `limits`.
pub fn polar_plane(curve: &PlaneCurve, limits: &Limits) -> Result<PolarPlane> {
    let [h, g] = curve.coordinates();
    let refused = |witness: String| Error::Hypothesis {
        statement: "Theorem 1",
        witness,
    };
    let Some(over_h) = h.recip() else {
        return Err(refused(
            "x = 0 on the whole curve, so the slope y/x is not a function".into(),
        ));
    };
    let (slope, radius) = (g.times(&over_h), h.squared().plus(&g.squared()));
    let rho = squared_radius(false);
    let monomial = |y: u32, x: u32| SparsePolynomial::from_terms([([x, y, 0], Rational::one())]);
    let (inverse, cleared, below) = match invert(&radius, &slope, limits)? {
        Inverse::Function(fraction) => {
            let [above, below] = fraction.cleared(monomial);
            let cleared = rho.times(&below).minus(&above);
            let inverse = PolarInverse::Function([above, below.clone()]);
            (inverse, cleared, below)
        }
        Inverse::Constant => {
            return Err(refused(
                "the slope y/x is constant: the curve lies on a line through the origin".into(),
            ));
        }
        Inverse::Values(count) => {
            let pair = ParametricCurve::new(curve.parameter().clone(), [slope, radius]);
            let relation = implicitize_plane(&pair, limits)?.curve;
            let relation = SparsePolynomial::<3>::from(relation.polynomial());
            let degree = relation.terms().map(|(e, _)| e[0]).max();
            let degree = degree.invariant("a relation has a term");
            let mut cleared = SparsePolynomial::zero();
            for (e, c) in relation.terms() {
                let term = monomial(e[0], degree - e[0]).times(&rho.pow(e[1]));
                cleared.add_multiple(&term, c);
            }
            let reason = format!(
                "the slope y/x cannot be inverted by substitution: a general line through the origin meets the \
                 curve at {count} different values of x^2 + y^2 (complex ones included)"
            );
            (PolarInverse::Relation(reason), cleared, monomial(0, degree))
        }
    };
    let plane = cleared.to_plane();
    let plane = plane.invariant("there is no z in the equation of a plane curve");
    let factors = factor_plane(&plane, limits)?.factors;
    let map = RationalMap::of_curve(curve);
    let denominators = [below];
    let factors: Vec<PolarFactor> = factors
        .into_iter()
        .map(|factor| {
            let polynomial = SparsePolynomial::<3>::from(&factor.polynomial);
            PolarFactor {
                role: Role::of(&polynomial, &map, &rho, &denominators),
                polynomial,
                multiplicity: factor.multiplicity,
            }
        })
        .collect();
    let found = factors.iter().find(|f| f.role == Role::Form);
    let found = found
        .and_then(|f| f.polynomial.to_plane())
        .ok_or_else(|| Error::internal("Theorem 1", "a factor of Eq. (1) vanishes on the curve"))?;
    Ok(PolarPlane {
        curve: ImplicitCurve::new(found),
        inverse,
        factors,
    })
}
