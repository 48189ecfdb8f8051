//! The genus of a plane curve that is irreducible over Q.

use super::absolute::absolute_factors;
use super::resolution::Resolution;
use super::sweep::Sheared;
use crate::error::{Error, Result};
use crate::limits::Limits;
use crate::poly::PlanePolynomial;

/// The genus of the components over the complex numbers of a curve that is irreducible over Q.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Genus {
    /// The number of components over the complex numbers, which are conjugate and so have equal genus.
    pub components: usize,
    /// The genus of each of them.
    pub genus: usize,
}

impl Genus {
    /// The genus of an absolutely irreducible curve that has a parametrization by rational functions.
    #[must_use]
    pub fn rational() -> Self {
        Self {
            components: 1,
            genus: 0,
        }
    }

    /// The genus of the curve of a polynomial that is irreducible over Q; `None` if no prime was found modulo which all branches
    /// are rational.
    ///
    /// Formula: 2g − 2 = (−2n + Σ (e − 1))/r (Riemann–Hurwitz), for the projection of degree n, the ramification indices e of all
    /// places over all values, infinity included, and r conjugate components. The ramification indices come from Newton–Puiseux
    /// expansions modulo a prime of good reduction. For r = 1 the result is checked against
    /// (n − 1)(n − 2)/2 − Σ δ over all singular points, infinitely near ones and those at infinity included.
    ///
    /// ```
    /// use stellate::limits::Limits;
    /// use stellate::poly::PlanePolynomial;
    /// use stellate::topology::Genus;
    /// // y² = x³ − x is an elliptic curve.
    /// let f = [((3, 0), 1.into()), ((1, 0), (-1).into()), ((0, 2), (-1).into())];
    /// let found = Genus::of(&PlanePolynomial::from_terms(f), &Limits::none())?.unwrap();
    /// assert_eq!((found.genus, found.components), (1, 1));
    /// // x² − 2y² is a pair of conjugate lines.
    /// let f = [((2, 0), 1.into()), ((0, 2), (-2).into())];
    /// let found = Genus::of(&PlanePolynomial::from_terms(f), &Limits::none())?.unwrap();
    /// assert_eq!((found.genus, found.components), (0, 2));
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of the limits: a discriminant or its factors take too much work.
    pub fn of(f: &PlanePolynomial, limits: &Limits) -> Result<Option<Self>> {
        for shear in super::SHEARS {
            if let Some(curve) = Sheared::new(f, shear, limits)? {
                let resolution = Resolution::new(&curve, limits)?;
                if let Some(genus) = Self::from_resolution(&curve, &resolution)? {
                    return Ok(Some(genus));
                }
            }
        }
        Ok(None)
    }

    pub(super) fn from_resolution(
        curve: &Sheared,
        resolution: &Resolution,
    ) -> Result<Option<Self>> {
        let n = curve.degree;
        let (Some(infinity), Some(prime)) = (&resolution.infinity, resolution.prime) else {
            return Ok(None);
        };
        // Above a simple zero of the discriminant one place has e = 2, and there is no singular point.
        let simple = curve.parts.iter().filter(|(m, _)| *m == 1);
        let mut ramification: usize = simple.map(|(_, g)| degree(g)).sum();
        let mut delta = 0;
        for conjugates in &resolution.conjugates {
            let Some(types) = &conjugates.types else {
                return Ok(None);
            };
            let count = degree(&conjugates.polynomial);
            ramification += count * types.iter().map(|t| t.ramification()).sum::<usize>();
            delta += count * types.iter().map(|t| t.delta()).sum::<usize>();
        }
        ramification += infinity.iter().map(|t| t.ramification()).sum::<usize>();
        delta += infinity.iter().map(|t| t.delta()).sum::<usize>();
        let components = absolute_factors(curve, prime);
        let contradiction = |broken: &str| Error::internal("the genus of a curve", broken);
        // r (2g − 2) = −2n + Σ (e − 1)
        let euler = ramification.cast_signed() - 2 * n.cast_signed();
        let twice = euler + 2 * components.cast_signed();
        let parts = 2 * components.cast_signed();
        if components == 0 || twice < 0 || twice % parts != 0 {
            return Err(contradiction(
                "the Euler characteristic is that of conjugate curves",
            ));
        }
        let genus = (twice / parts).unsigned_abs();
        if components == 1 && genus + delta != (n - 1) * n.saturating_sub(2) / 2 {
            return Err(contradiction(
                "the genus by ramification is the one by singular points",
            ));
        }
        Ok(Some(Self { components, genus }))
    }
}

fn degree(g: &crate::poly::IntegerPolynomial) -> usize {
    g.coefficients_asc().len().saturating_sub(1)
}
