//! Theorem 4, Eq. (15): patches on which x² + y² + z² is a function of the direction.

use super::{PolarFactor, Role, squared_radius};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::factor::factor_space;
use crate::implicitize::map::RationalMap;
use crate::implicitize::patch::implicitize_patch;
use crate::implicitize::vanishing::vanishing;
use crate::limits::Limits;
use crate::poly::{Ring, SparsePolynomial, total_degree};
use crate::shape::{ImplicitSurface, Patch, PatchFunction};

/// What Eq. (15) gives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PolarPatch {
    /// The irreducible equation of the surface.
    pub surface: ImplicitSurface,
    /// `x² + y² + z² = above/below`, forms of the same degree.
    pub squared_radius: [SparsePolynomial<3>; 2],
    /// The irreducible factors of `(x² + y² + z²) below − above`.
    pub factors: Vec<PolarFactor>,
}

/// Theorem 4 with its spurious factors removed.
///
/// Eq. (15) expresses `x² + y² + z²` by the direction, `H(y/x, z/x)`. H is found by certified linear algebra in
/// the products `(y/x)^i (z/x)^j` and `(y/x)^i (z/x)^j (x² + y² + z²)`, by increasing degree. It exists exactly
/// if the irreducible equation has two homogeneous parts whose degrees differ by 1 or 2: only then does a
/// line through the origin meet the surface and its reflection at one distance.
///
/// # Errors
/// [`Error::Hypothesis`] if H does not exist, with the reason; those of [`implicitize_patch`], of the
/// factorization and of `limits`.
pub fn polar_patch(patch: &Patch, limits: &Limits) -> Result<PolarPatch> {
    let refused = |witness: String| Error::Hypothesis {
        statement: "Theorem 4",
        witness,
    };
    // What is possible is read off the equation, which the linear algebra below then finds again.
    let known = implicitize_patch(patch, limits)?.surface;
    let degrees = part_degrees(known.polynomial());
    let largest = match degrees[..] {
        // x² + y² + z² = −ρ f_(n−2)/f_n, or ρ (f_(n−1)/f_n)², in the direction on the unit sphere.
        [n, low] if n - low == 2 => n,
        [n, low] if n - low == 1 => 2 * n,
        [_] => {
            return Err(refused(
                "the surface is a cone with its apex at the origin: the direction does not determine the point"
                    .into(),
            ));
        }
        _ => {
            let listed: Vec<String> = degrees.iter().map(ToString::to_string).collect();
            return Err(refused(format!(
                "the angles cannot be found by substitution: the equation has homogeneous parts of degrees {}, \
                 so a general line through the origin meets the surface at different distances, and x^2 + y^2 + \
                 z^2 is not a rational function of y/x and z/x",
                listed.join(", ")
            )));
        }
    };
    let Some(functions) = directions(patch, limits)? else {
        return Err(refused("x = 0 on the whole surface".into()));
    };
    let direction_map = RationalMap::of_patch_functions(&functions);
    let largest = u32::try_from(largest).unwrap_or(u32::MAX);
    for degree in 0..=largest {
        let mut monomials = Vec::new();
        for k in [0, 1] {
            for i in 0..=degree {
                monomials.extend((0..=degree - i).map(|j| [i, j, k]));
            }
        }
        let found = vanishing(&direction_map, &monomials, limits)?;
        let Some(relation) = found.first() else {
            continue;
        };
        let part = |k: u32, sign: i64| {
            let terms = relation.terms().filter(|(e, _)| e[2] == k);
            let sign = Rational::from(sign);
            SparsePolynomial::from_terms(
                terms.map(|(e, c)| ([degree - e[0] - e[1], e[0], e[1]], c * &sign)),
            )
        };
        let first = part(1, 1)
            .terms()
            .next()
            .map_or(1, |(_, c)| i64::from(c.signum()));
        let (above, below) = (part(0, -first), part(1, first));
        let rho = squared_radius(true);
        let cleared = rho.times(&below).minus(&above);
        let map = RationalMap::of_patch(patch);
        let denominators = [below.clone()];
        let factors = factor_space(&cleared, limits)?.factors;
        let factors: Vec<PolarFactor> = factors
            .into_iter()
            .map(|factor| PolarFactor {
                role: Role::of(&factor.polynomial, &map, &rho, &denominators),
                polynomial: factor.polynomial,
                multiplicity: factor.multiplicity,
            })
            .collect();
        let surface = factors.iter().find(|f| f.role == Role::Form);
        let surface = surface.map(|f| ImplicitSurface::new(f.polynomial.clone()));
        return Ok(PolarPatch {
            surface: surface.ok_or_else(|| {
                refused("no factor vanishes on the surface; please report the input".into())
            })?,
            squared_radius: [above, below],
            factors,
        });
    }
    Err(refused(
        "x^2 + y^2 + z^2 was not found as a function of y/x and z/x; please report the input"
            .into(),
    ))
}

/// The degrees of the homogeneous parts, descending.
fn part_degrees(f: &SparsePolynomial<3>) -> Vec<u64> {
    let mut degrees: Vec<u64> = f.terms().map(|(e, _)| total_degree(e)).collect();
    degrees.dedup();
    degrees
}

/// y/x, z/x and x² + y² + z²; `None` if x is 0.
fn directions(patch: &Patch, limits: &Limits) -> Result<Option<[PatchFunction; 3]>> {
    let [[xp, xq], [yp, yq], [zp, zq]] = patch
        .coordinates()
        .each_ref()
        .map(|f| [f.numerator(), f.denominator()]);
    let quotient =
        |p: SparsePolynomial<2>, q: SparsePolynomial<2>| PatchFunction::new(&p, &q, limits);
    let (Some(a), Some(b)) = (
        quotient(yp.times(xq), yq.times(xp))?,
        quotient(zp.times(xq), zq.times(xp))?,
    ) else {
        return Ok(None);
    };
    let square = |p: &SparsePolynomial<2>, q1: &SparsePolynomial<2>, q2: &SparsePolynomial<2>| {
        p.times(q1).times(q2).squared()
    };
    let sum = square(xp, yq, zq)
        .plus(&square(yp, xq, zq))
        .plus(&square(zp, xq, yq));
    let radius = quotient(sum, xq.times(yq).times(zq).squared())?;
    Ok(radius.map(|w| [a, b, w]))
}
