//! Theorem 4, Eq. (15): patches on which x² + y² + z² is a function of the direction.

use super::{PolarFactor, PolarInverse, Role, squared_radius};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::factor::factor_space;
use crate::implicitize::map::RationalMap;
use crate::implicitize::patch::implicitize_patch;
use crate::implicitize::vanishing::{monomials, vanishing};
use crate::limits::Limits;
use crate::poly::{Ring, SparsePolynomial, total_degree};
use crate::shape::{ImplicitSurface, Patch, PatchFunction};

/// The result of Theorem 4.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct PolarPatch {
    /// The irreducible equation of the surface.
    pub surface: ImplicitSurface,
    /// Eq. (15), or the reason why substitution cannot eliminate the angles.
    pub inverse: PolarInverse,
    /// The irreducible factors of the polar equation, cleared of denominators.
    pub factors: Vec<PolarFactor>,
}

/// Theorem 4: the polar equation of a patch, its irreducible factors, and the factor that is the surface.
///
/// Eq. (15) says that w = x² + y² + z² is a function of the direction, `w = H(y/x, z/x)`. A rational H exists exactly if the
/// irreducible equation of the surface has two homogeneous parts whose degrees differ by 1 or 2: only then does a general line
/// through the origin meet the surface and its reflection at a single distance. Certified linear algebra finds H as a relation
/// between the products `(y/x)^i (z/x)^j` and `(y/x)^i (z/x)^j w`, by increasing degree. If there is no H, the polynomial
/// relation of least degree between y/x, z/x and w is taken instead. The polar equation is H, or this relation, cleared of
/// denominators.
///
/// # Errors
/// [`Error::Hypothesis`] for a cone with its apex at the origin, or x = 0; [`Error::Limit`] for relations of a
/// degree above 18; those of [`implicitize_patch`], of the factorization and of `limits`.
pub fn polar_patch(patch: &Patch, limits: &Limits) -> Result<PolarPatch> {
    let refused = |witness: &str| Error::Hypothesis {
        statement: "Theorem 4",
        witness: witness.into(),
    };
    // The irreducible equation says whether H exists and bounds its degree; it must be a factor of the polar equation below.
    let known = implicitize_patch(patch, limits)?.surface;
    let degrees = part_degrees(known.polynomial());
    let Some(functions) = directions(patch, limits)? else {
        return Err(refused("x = 0 on the whole surface"));
    };
    let directions = RationalMap::of_patch_functions(&functions);
    let largest = match degrees[..] {
        // With ρ = x² + y² + z² and the homogeneous parts f_d, w = −ρ f_(n−2)/f_n or w = ρ (f_(n−1)/f_n)², so numerator and
        // denominator of H have at most the degree n or 2n.
        [n, low] if n - low == 2 => Some(n),
        [n, low] if n - low == 1 => Some(2 * n),
        [_] => {
            return Err(refused(
                "the surface is a cone with its apex at the origin: the direction does not determine the point",
            ));
        }
        _ => None,
    };
    let relation = match largest {
        Some(largest) => function_of_direction(&directions, largest, limits)?,
        None => Some(
            least_relation(&directions, limits).map_err(|error| match error {
                Error::Limit { limit, .. } => Error::Limit {
                    limit,
                    finished: different_distances(&degrees),
                },
                other => other,
            })?,
        ),
    };
    let relation = relation.ok_or_else(|| {
        Error::internal(
            "Theorem 4",
            "an equation of two homogeneous parts gives a function of the direction",
        )
    })?;
    let degree = relation
        .terms()
        .map(|(e, _)| e[0] + e[1])
        .max()
        .invariant("a relation has a term");
    let rho = squared_radius(true);
    let form = |k: u32| {
        let terms = relation.terms().filter(move |(e, _)| e[2] == k);
        let terms = terms.map(|(e, c)| ([degree - e[0] - e[1], e[0], e[1]], c.clone()));
        SparsePolynomial::from_terms(terms)
    };
    let highest = relation.terms().map(|(e, _)| e[2]).max();
    let highest = highest.invariant("a relation has a term");
    let mut cleared = SparsePolynomial::zero();
    for k in 0..=highest {
        cleared = cleared.plus(&form(k).times(&rho.pow(k)));
    }
    let inverse = if largest.is_some() {
        let (above, below) = (form(0).scaled(&Rational::from(-1)), form(1));
        let sign = below
            .terms()
            .next()
            .map_or(1, |(_, c)| i64::from(c.signum()));
        let signed = |f: &SparsePolynomial<3>| f.scaled(&Rational::from(sign));
        PolarInverse::Function([signed(&above), signed(&below)])
    } else {
        PolarInverse::Relation(different_distances(&degrees))
    };
    let map = RationalMap::of_patch(patch);
    let x_power = SparsePolynomial::from_terms([([degree, 0, 0], Rational::one())]);
    let denominators = [form(highest), x_power];
    let factors = factor_space(&cleared, limits)?.factors.into_iter();
    let factors: Vec<PolarFactor> = factors
        .map(|factor| PolarFactor {
            role: Role::of(&factor.polynomial, &map, &rho, &denominators),
            polynomial: factor.polynomial,
            multiplicity: factor.multiplicity,
        })
        .collect();
    let surface = factors.iter().find(|f| f.role == Role::Form);
    let surface = surface.map(|f| ImplicitSurface::new(f.polynomial.clone()));
    Ok(PolarPatch {
        surface: surface.ok_or_else(|| {
            Error::internal("Theorem 4", "a factor of Eq. (15) vanishes on the surface")
        })?,
        inverse,
        factors,
    })
}

/// The relation of least degree that is linear in w, with coefficients of at most the degree `largest` in y/x and z/x.
fn function_of_direction(
    directions: &RationalMap,
    largest: u64,
    limits: &Limits,
) -> Result<Option<SparsePolynomial<3>>> {
    for degree in 0..=u32::try_from(largest).invariant("a degree is below 2^32") {
        let mut monomials = Vec::new();
        for k in [0, 1] {
            for i in 0..=degree {
                monomials.extend((0..=degree - i).map(|j| [i, j, k]));
            }
        }
        if let Some(relation) = vanishing(directions, &monomials, limits)?
            .into_iter()
            .next()
        {
            return Ok(Some(relation));
        }
    }
    Ok(None)
}

/// The polynomial relation of least degree between y/x, z/x and w, which is irreducible.
fn least_relation(directions: &RationalMap, limits: &Limits) -> Result<SparsePolynomial<3>> {
    for degree in 1.. {
        let monomials = monomials(degree, [true; 3]);
        if let Some(relation) = vanishing(directions, &monomials, limits)?
            .into_iter()
            .next()
        {
            return Ok(relation);
        }
    }
    unreachable!("the number of monomials is limited")
}

/// The reason why there is no function H, from the degrees of the homogeneous parts.
fn different_distances(degrees: &[u64]) -> String {
    let listed: Vec<String> = degrees.iter().map(ToString::to_string).collect();
    format!(
        "the angles cannot be found by substitution: the equation has homogeneous parts of degrees {}, so a general \
         line through the origin meets the surface at different distances",
        listed.join(", ")
    )
}

/// The degrees of the homogeneous parts, descending.
fn part_degrees(f: &SparsePolynomial<3>) -> Vec<u64> {
    let mut degrees: Vec<u64> = f.terms().map(|(e, _)| total_degree(e)).collect();
    degrees.dedup();
    degrees
}

/// y/x, z/x and x² + y² + z² as functions of the parameters; `None` if x is 0 on the whole patch.
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
