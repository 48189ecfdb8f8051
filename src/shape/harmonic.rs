//! [`HarmonicSurface`]: a surface that is given by a finite sum of spherical harmonics of its radius.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::poly::with_integers;

/// The largest degree L of a harmonic surface. Its equation has degree 2(L + 1) and about 6L² terms.
pub const MAX_HARMONIC_DEGREE: usize = 250;

/// The surface `R(θ, φ) = Σ_{l ≤ L} Σ_{|m| ≤ l} c_lm Y(l, m)` with exact rational coefficients, and the center, from which the
/// radius is measured.
///
/// The harmonics are unnormalised and without the Condon–Shortley phase, so that all products of them are rational: `Y(l, m)` is
/// `P_l^m(cos φ) cos mθ` for m ≥ 0 and `P_l^|m|(cos φ) sin |m|θ` for m < 0, with `P_l^m(cos φ) = (sin φ)^m P_l^(m)(cos φ)`, where
/// `P_l^(m)` is the m-th derivative of the Legendre polynomial. R is a polynomial on the unit sphere of degree L, the *true* degree:
/// trailing degrees without a harmonic are dropped on construction.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::shape::HarmonicSurface;
///
/// let limacon = HarmonicSurface::new([((0, 0), 2.into()), ((1, 0), "1/2".parse()?), ((3, 2), 0.into())])?;
/// assert_eq!(limacon.degree(), 1);
/// assert_eq!(limacon.coefficient(1, 0).to_string(), "1/2");
/// assert!(HarmonicSurface::new([((1, 2), Rational::one())]).is_err());
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HarmonicSurface {
    /// The coefficient of Y(l, m) is at l² + l + m.
    coefficients: Vec<Rational>,
    center: [Rational; 3],
    /// A bound of the difference between R and the radius that it stands for.
    rounding: Rational,
}

impl HarmonicSurface {
    /// The sum of the terms c Y(l, m), each given as ((l, m), c).
    ///
    /// # Errors
    /// [`Error::Usage`] for an order m with |m| > l; [`Error::Limit`] for a degree beyond [`MAX_HARMONIC_DEGREE`].
    pub fn new(terms: impl IntoIterator<Item = ((usize, isize), Rational)>) -> Result<Self> {
        let mut coefficients = vec![Rational::zero()];
        for ((l, m), c) in terms {
            if m.unsigned_abs() > l {
                let message = format!("the harmonic Y({l}, {m}): the order m is between -l and l");
                return Err(Error::Usage(message));
            }
            if l > MAX_HARMONIC_DEGREE {
                let limit = format!("a harmonic of a degree beyond {MAX_HARMONIC_DEGREE}");
                return Err(Error::limit(limit));
            }
            let needed = (l + 1) * (l + 1);
            if coefficients.len() < needed && !c.is_zero() {
                coefficients.resize(needed, Rational::zero());
            }
            if !c.is_zero() {
                let sum = &mut coefficients[Self::index(l, m)];
                *sum = &*sum + c;
            }
        }
        let mut degree = coefficients.len().isqrt() - 1;
        while degree > 0
            && coefficients[degree * degree..]
                .iter()
                .all(Rational::is_zero)
        {
            coefficients.truncate(degree * degree);
            degree -= 1;
        }
        Ok(Self {
            coefficients,
            center: std::array::from_fn(|_| Rational::zero()),
            rounding: Rational::zero(),
        })
    }

    /// The same radius measured from `center`.
    #[must_use]
    pub fn with_center(mut self, center: [Rational; 3]) -> Self {
        self.center = center;
        self
    }

    /// The same radius, as one whose coefficients were rounded: in every direction the rounded and the original radius differ by at
    /// most `bound`.
    #[must_use]
    pub fn with_rounding(mut self, bound: Rational) -> Self {
        self.rounding = bound;
        self
    }

    /// A bound of the difference between R and the radius that it stands for; 0 if nothing was rounded.
    #[must_use]
    pub fn rounding(&self) -> &Rational {
        &self.rounding
    }

    /// The center, in the coordinates of the mesh that the radius was fitted to.
    #[must_use]
    pub fn center(&self) -> &[Rational; 3] {
        &self.center
    }

    /// Whether the center is the origin.
    #[must_use]
    pub fn is_centered(&self) -> bool {
        self.center.iter().all(Rational::is_zero)
    }

    /// The degree L: the largest l with a coefficient that is not 0, or 0 for a constant.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.coefficients.len().isqrt() - 1
    }

    /// The coefficient of Y(l, m).
    ///
    /// # Panics
    /// If not |m| ≤ l ≤ L.
    #[must_use]
    pub fn coefficient(&self, l: usize, m: isize) -> &Rational {
        assert!(m.unsigned_abs() <= l, "an order is at most the degree");
        &self.coefficients[Self::index(l, m)]
    }

    /// The terms that are not 0 as (l, m, c), by ascending l, then m.
    pub fn terms(&self) -> impl Iterator<Item = (usize, isize, &Rational)> {
        let all = self.coefficients.iter().enumerate();
        all.filter(|(_, c)| !c.is_zero()).map(|(at, c)| {
            let l = at.isqrt();
            let m = at.cast_signed() - (l * l + l).cast_signed();
            (l, m, c)
        })
    }

    /// Whether R is the same function, whatever the center.
    #[must_use]
    pub fn has_same_radii(&self, other: &Self) -> bool {
        self.coefficients == other.coefficients
    }

    /// Whether R is identically 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.coefficients.iter().all(Rational::is_zero)
    }

    /// The least common denominator D of all coefficients, and the numbers D·c in the order of l² + l + m.
    pub(crate) fn over_common_denominator(&self) -> (Integer, Vec<Integer>) {
        let (scaled, common) = with_integers(&self.coefficients);
        let mut integers = scaled.into_coefficients_asc();
        integers.resize(self.coefficients.len(), Integer::ZERO);
        (common, integers)
    }

    /// The place of the coefficient of Y(l, m) in the order of all coefficients.
    pub(crate) fn index(l: usize, m: isize) -> usize {
        (l * l + l)
            .checked_add_signed(m)
            .invariant("an order is at most the degree")
    }
}
