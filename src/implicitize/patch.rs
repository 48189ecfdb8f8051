//! Patches: the equation of a parametric surface, by certified linear algebra.

use super::fibre::{generic_fibre, sweeps_a_surface};
use super::map::RationalMap;
use super::vanishing::{kernel_modulo, lift, monomials};
use crate::error::{Error, Result};
use crate::limits::Limits;
use crate::poly::kernel_primes;
use crate::shape::{ImplicitSurface, Patch};

/// The equation of a parametric surface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SurfaceEquation {
    /// The irreducible equation, primitive with positive first term.
    pub surface: ImplicitSurface,
    /// How many parameter values, complex ones included, a general point of the surface has.
    ///
    /// Counted at random points modulo a prime: not proved, but wrong with a probability below 10⁻⁶. `None` if
    /// the counts do not agree with the degree of the equation.
    pub tracing_index: Option<usize>,
}

/// The implicit equation of a patch.
///
/// For d = 1, 2, … the values of all monomials of degree at most d at random points modulo a prime: full rank
/// proves that no equation of degree d exists; the first kernel vector is lifted to Q by Chinese remainders
/// and proved by exact substitution. The polynomials that vanish on a surface are the multiples of one
/// irreducible polynomial, so an equation of least degree is that one.
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
/// Cost: Gauss on C(d+3, 3) columns for every d up to the degree of the answer, once modulo each of the primes
/// that its coefficients need.
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
    let prime = kernel_primes().next().unwrap_or(2);
    for degree in 1.. {
        let monomials = monomials(degree, [true; 3]);
        let kernel =
            kernel_modulo(&map, &monomials, prime, limits).map_err(|error| match error {
                Error::Limit { limit, .. } => Error::Limit {
                    limit,
                    finished: format!("there is no equation of degree {} or less", degree - 1),
                },
                other => other,
            })?;
        if let Some(vector) = kernel.vectors.first() {
            let f = lift(&map, &monomials, vector, limits)?;
            let degree = f.degree().and_then(|d| usize::try_from(d).ok());
            let fibre = generic_fibre(patch, limits)?;
            let tracing_index = degree
                .filter(|d| fibre.is_multiple_of(*d))
                .map(|d| fibre / d);
            return Ok(SurfaceEquation {
                surface: ImplicitSurface::new(f),
                tracing_index,
            });
        }
    }
    unreachable!("the number of monomials is limited")
}
