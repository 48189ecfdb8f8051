//! Theorem 3, Eqs. (10) and (11): the paper's two surfaces through a space curve, and the other components of their
//! intersection.

use super::{PolarFactor, Role, squared_radius};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::factor::factor_space;
use crate::implicitize::inverse::{Inverse, Quotient, invert};
use crate::implicitize::map::RationalMap;
use crate::limits::Limits;
use crate::poly::{RationalFunction, Ring, SparsePolynomial, resultant};
use crate::shape::SpaceCurve;

/// The result of Theorem 3.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct PolarSpaceCurve {
    /// The surface of Eq. (10), or the reason why it does not exist.
    pub first: std::result::Result<PolarSurface, String>,
    /// The surface of Eq. (11), or the reason why it does not exist.
    pub second: std::result::Result<PolarSurface, String>,
    /// The components of the intersection besides the curve, after the spurious factors are removed. Each is the common zero
    /// set of a factor of the first surface and a polynomial in two variables.
    pub components: Vec<[SparsePolynomial<3>; 2]>,
}

/// One of the paper's surfaces.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct PolarSurface {
    /// The equation, cleared of denominators.
    pub equation: SparsePolynomial<3>,
    /// Its irreducible factors; those of [`Role::Form`] contain the curve.
    pub factors: Vec<PolarFactor>,
}

impl PolarSurface {
    /// The product of the factors that contain the curve.
    #[must_use]
    pub fn reduced(&self) -> SparsePolynomial<3> {
        let one = SparsePolynomial::constant(Rational::one());
        self.through_the_curve()
            .fold(one, |product, g| product.times(g))
    }

    fn through_the_curve(&self) -> impl Iterator<Item = &SparsePolynomial<3>> {
        let factors = self.factors.iter().filter(|f| f.role == Role::Form);
        factors.map(|f| &f.polynomial)
    }
}

/// Theorem 3: with α = (h, g, k),
///
/// - (10) `A(y/x) + B(z²/(x²+y²)) = x² + y² + z²`,
/// - (11) `A(y/x) + C(z/y) = x² + y² + z²`,
///
/// where `h² + g² = A(g/h)`, `k² = B(k²/(g²+h²))` and `k² = C(k/g)`, if these rational functions exist (the paper's f2 is the
/// square root of the argument of B). Each equation is cleared of denominators and factored. A resultant gives the components
/// of the intersection besides the curve.
///
/// DIFFERENCE: the paper simplifies the second surface of Example 3 to z = ±y² modulo the first; as derived, the
/// two surfaces also meet in z = 0 and in z = −y².
///
/// # Errors
/// [`Error::Hypothesis`] if neither surface exists, with the reasons; those of the factorization and of `limits`.
pub fn polar_space_curve(curve: &SpaceCurve, limits: &Limits) -> Result<PolarSpaceCurve> {
    let [h, g, k] = curve.coordinates();
    let (plane, k2) = (h.squared().plus(&g.squared()), k.squared());
    let squares = |e: u32, f: u32| {
        let terms = [([0, 0, 2], Rational::one())];
        SparsePolynomial::from_terms(terms)
            .pow(e)
            .times(&squared_radius(false).pow(f))
    };
    let by_slope = |y: u32, x: u32| SparsePolynomial::from_terms([([x, y, 0], Rational::one())]);
    let by_height = |z: u32, y: u32| SparsePolynomial::from_terms([([0, y, z], Rational::one())]);
    let in_plane = inverse(&plane, ratio(g, h), ["x^2 + y^2", "y/x"], limits)?;
    let first = inverse(&k2, ratio(&k2, &plane), ["z^2", "z^2/(x^2 + y^2)"], limits)?;
    let second = inverse(&k2, ratio(k, g), ["z^2", "z/y"], limits)?;
    let map = RationalMap::of_curve(curve);
    let surface = |upper: &std::result::Result<Quotient, String>,
                   power: &dyn Fn(u32, u32) -> SparsePolynomial<3>|
     -> Result<std::result::Result<PolarSurface, String>> {
        match (&in_plane, upper) {
            (Ok(a), Ok(b)) => {
                let (a, b) = (a.cleared(by_slope), b.cleared(power));
                through(&map, a, b, limits).map(Ok)
            }
            (Err(reason), _) | (_, Err(reason)) => Ok(Err(reason.clone())),
        }
    };
    let first = surface(&first, &squares)?;
    let second = surface(&second, &by_height)?;
    if let (Err(a), Err(b)) = (&first, &second) {
        let witness = if a == b {
            a.clone()
        } else {
            format!("{a}; {b}")
        };
        return Err(Error::Hypothesis {
            statement: "Theorem 3",
            witness,
        });
    }
    let mut components = Vec::new();
    if let (Ok(first), Ok(second)) = (&first, &second) {
        for a in first.through_the_curve() {
            for b in second.through_the_curve().filter(|b| *b != a) {
                components.extend(common_components(a, b, &map, limits)?);
            }
        }
    }
    Ok(PolarSpaceCurve {
        first,
        second,
        components,
    })
}

fn ratio(p: &RationalFunction, q: &RationalFunction) -> Option<RationalFunction> {
    Some(p.times(&q.recip()?))
}

/// w as a rational function of m, or the reason why it is not one.
fn inverse(
    w: &RationalFunction,
    m: Option<RationalFunction>,
    [w_name, m_name]: [&str; 2],
    limits: &Limits,
) -> Result<std::result::Result<Quotient, String>> {
    let Some(m) = m else {
        return Ok(Err(format!(
            "{m_name} has the denominator 0 on the whole curve"
        )));
    };
    Ok(match invert(w, &m, limits)? {
        Inverse::Function(fraction) => Ok(fraction),
        Inverse::Constant => Err(format!("{m_name} is constant on the curve")),
        Inverse::Values(count) => Err(format!(
            "{m_name} cannot be inverted by substitution: where it has a general value there are {count} values of \
             {w_name} (complex ones included)"
        )),
    })
}

/// The surface `above_a/below_a + above_b/below_b = x² + y² + z²`.
fn through(
    map: &RationalMap,
    [above_a, below_a]: [SparsePolynomial<3>; 2],
    [above_b, below_b]: [SparsePolynomial<3>; 2],
    limits: &Limits,
) -> Result<PolarSurface> {
    let radius = squared_radius(true);
    let equation = radius
        .times(&below_a)
        .times(&below_b)
        .minus(&above_a.times(&below_b))
        .minus(&above_b.times(&below_a))
        .primitive();
    let denominators = [below_a, below_b];
    let factors = factor_space(&equation, limits)?.factors.into_iter();
    let factors = factors.map(|factor| PolarFactor {
        role: Role::of(&factor.polynomial, map, &radius, &denominators),
        polynomial: factor.polynomial,
        multiplicity: factor.multiplicity,
    });
    Ok(PolarSurface {
        factors: factors.collect(),
        equation,
    })
}

/// The components of a = b = 0 besides the curve: a, and an irreducible factor of the resultant.
fn common_components(
    a: &SparsePolynomial<3>,
    b: &SparsePolynomial<3>,
    map: &RationalMap,
    limits: &Limits,
) -> Result<Vec<[SparsePolynomial<3>; 2]>> {
    let eliminated = (0..3)
        .filter(|&v| a.degree_in(v) > 0 && b.degree_in(v) > 0)
        .min_by_key(|&v| a.degree_in(v));
    let projected = match eliminated {
        Some(v) => resultant(a, b, v, limits)?,
        // If there is no common variable to eliminate, b itself cuts out the component.
        None => b.clone(),
    };
    let factors = factor_space(&projected, limits)?.factors.into_iter();
    let mut others = Vec::new();
    for factor in factors {
        if !map.annihilates(&factor.polynomial, limits)? {
            others.push([a.clone(), factor.polynomial]);
        }
    }
    Ok(others)
}
