//! The equation of a patch, by certified linear algebra.

use super::fibre::{generic_fibre, sweeps_a_surface};
use super::map::RationalMap;
use super::vanishing::{LARGEST_DEGREE, kernel_modulo, lift, monomials};
use crate::error::{Error, Invariant, Result};
use crate::limits::Limits;
use crate::modular::large_primes;
use crate::poly::SparsePolynomial;
use crate::shape::{ImplicitSurface, Patch};

/// The equation of a parametric surface.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct SurfaceEquation {
    /// The irreducible equation, primitive and with a positive first coefficient.
    pub surface: ImplicitSurface,
    /// The number of parameter values, complex ones included, of a general point of the surface.
    ///
    /// It is counted at random points modulo a prime, so it is not proved; it is wrong with a probability below 10⁻⁶. `None` if
    /// the counts do not agree with the degree of the equation.
    pub tracing_index: Option<usize>,
}

/// Finds the implicit equation of a patch.
///
/// The degree d of the equation divides the number of parameter values on a general line. For each such d in ascending order,
/// the values of all monomials of degree at most d at random points modulo a prime form a matrix. If it has full rank, this
/// proves that there is no equation of degree d or less. The first kernel vector is lifted to Q by Chinese remainders and
/// proved by substitution. All polynomials that vanish on a surface are multiples of one irreducible polynomial, so an equation
/// of least degree is that polynomial.
///
/// ```
/// use stellate::implicitize::implicitize_patch;
/// use stellate::language::{Numbers, parse_form};
/// use stellate::limits::Limits;
/// use stellate::shape::Form;
///
/// // Example 4
/// let text = "x = cos(theta)*sin(phi); y = cos(theta); z = cos(phi)";
/// let Form::Patch(patch) = parse_form(text, "<form>", Numbers::Exact)? else { panic!("a patch") };
/// let equation = implicitize_patch(&patch, &Limits::none())?;
/// let expected = parse_form("y^2*z^2 + x^2 - y^2", "<form>", Numbers::Exact)?;
/// assert_eq!(Form::Surface(equation.surface), expected);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// Cost: Gaussian elimination with C(d+3, 3) columns for each d up to the degree of the equation; and, once for each prime that
/// the coefficients need, with as many columns as the equation has terms.
///
/// # Errors
/// [`Error::Hypothesis`] if the patch is only a curve or a point; [`Error::Limit`] for degrees above 18; those of
/// `limits`.
pub fn implicitize_patch(patch: &Patch, limits: &Limits) -> Result<SurfaceEquation> {
    let map = RationalMap::of_patch(patch);
    if !sweeps_a_surface(patch) {
        return Err(Error::Hypothesis {
            statement: "implicitization of a patch",
            witness:
                "the two parameters move along a curve only (the tangent vectors are parallel \
                      everywhere), which has no single equation; give it with one parameter"
                    .into(),
        });
    }
    // The degree divides this number except with a tiny probability; if it does not, the largest degree still finds the
    // equation.
    let fibre = generic_fibre(patch, limits)?;
    let likely = (1..).filter(|&d| fibre.is_multiple_of(d) || d >= LARGEST_DEGREE);
    let f = least_equation(&map, likely, limits)?;
    let degree = f.degree().and_then(|d| usize::try_from(d).ok());
    let tracing_index = degree
        .filter(|d| fibre.is_multiple_of(*d))
        .map(|d| fibre / d);
    Ok(SurfaceEquation {
        surface: ImplicitSurface::new(f),
        tracing_index,
    })
}

/// The equation of least degree, which must be at most the last one of the ascending `degrees`.
///
/// The kernel for any sufficiently large degree shows the equation: its last monomial is the first one, in ascending order,
/// that depends on the monomials before it.
fn least_equation(
    map: &RationalMap,
    degrees: impl Iterator<Item = usize>,
    limits: &Limits,
) -> Result<SparsePolynomial<3>> {
    let prime = large_primes()
        .next()
        .invariant("there are primes below 2^31");
    let mut none_up_to = 0;
    for degree in degrees {
        let monomials = monomials(
            u32::try_from(degree).invariant("a degree is below 2^32"),
            [true; 3],
        );
        let kernel =
            kernel_modulo(map, &monomials, prime, limits).map_err(|error| match error {
                Error::Limit { limit, .. } => Error::Limit {
                    limit,
                    finished: format!("there is no equation of degree {none_up_to} or less"),
                },
                other => other,
            })?;
        if let Some(vector) = kernel.vectors.first() {
            return lift(map, &monomials, vector, limits);
        }
        none_up_to = degree;
    }
    unreachable!("the number of monomials is limited")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::{Numbers, parse_form};
    use crate::shape::Form;

    #[test]
    fn any_degree_that_is_large_enough_shows_the_least_one() {
        let limits = Limits::none();
        for (text, degree) in [
            ("x = cos(theta)*sin(phi); y = cos(theta); z = cos(phi)", 4),
            ("x = (2+cos(v))cos(u); y = (2+cos(v))sin(u); z = sin(v)", 4),
            ("x = u*v; y = u; z = v^2", 3),
            ("x = u + v; y = u - v; z = 3u + 1", 1),
            (
                "x = u - u^3/3 + u*v^2; y = v - v^3/3 + v*u^2; z = u^2 - v^2",
                9,
            ),
        ] {
            let Ok(Form::Patch(patch)) = parse_form(text, "<form>", Numbers::Exact) else {
                panic!("{text}")
            };
            let map = RationalMap::of_patch(&patch);
            let one_by_one = least_equation(&map, 1.., &limits).unwrap();
            assert_eq!(one_by_one.degree(), Some(degree as u64));
            for first in degree..degree + 3 {
                let found = least_equation(&map, first.., &limits).unwrap();
                assert_eq!(found, one_by_one, "{text} from {first}");
            }
            let found = implicitize_patch(&patch, &limits).unwrap();
            assert_eq!(found.surface.polynomial(), &one_by_one);
        }
    }
}
