//! Implicit curves and surfaces: zero sets of exact polynomials.

use std::borrow::Cow;
use std::sync::OnceLock;

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::intervals::Interval;
use crate::limits::Limits;
use crate::poly::{PlanePolynomial, SpacePolynomial, SparsePolynomial};

/// The largest number of terms that a polynomial in space may have in original coordinates.
const MAX_MOVED_TERMS: usize = 5_000_000;

/// The plane curve `f(x, y) = 0`, in coordinates relative to `center`.
///
/// The curve of a contour's fit has the center of the fit, because F has its three homogeneous parts only about that point.
/// [`ImplicitCurve::in_original_coordinates`] expands F about the origin of the contour's own coordinates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImplicitCurve {
    polynomial: PlanePolynomial,
    center: [Rational; 2],
}

impl ImplicitCurve {
    /// The zero set of `polynomial`, about the origin.
    #[must_use]
    pub fn new(polynomial: PlanePolynomial) -> Self {
        Self {
            polynomial,
            center: [Rational::zero(), Rational::zero()],
        }
    }

    /// The curve of the same polynomial, in coordinates relative to `center`.
    #[must_use]
    pub fn with_center(mut self, center: [Rational; 2]) -> Self {
        self.center = center;
        self
    }

    /// The polynomial f.
    #[must_use]
    pub fn polynomial(&self) -> &PlanePolynomial {
        &self.polynomial
    }

    /// The same curve, with its polynomial replaced by a multiple of it.
    #[must_use]
    pub fn map_polynomial(
        mut self,
        multiple: impl FnOnce(PlanePolynomial) -> PlanePolynomial,
    ) -> Self {
        self.polynomial = multiple(self.polynomial);
        self
    }

    /// The point x = y = 0, in the contour's coordinates.
    #[must_use]
    pub fn center(&self) -> &[Rational; 2] {
        &self.center
    }

    /// Whether the center is the origin.
    #[must_use]
    pub fn is_centered(&self) -> bool {
        self.center.iter().all(Rational::is_zero)
    }

    /// Certified bounds of f at a point of doubles, given in the contour's own coordinates. They are the doubles next to the
    /// exact value, or twice the value if it is a double. Their signs are that of f, unless f is far below the smallest double.
    ///
    /// Cost: an exact evaluation. A bound is infinite if the value is beyond the largest double.
    ///
    /// ```
    /// use stellate::shape::ImplicitCurve;
    /// let circle: ImplicitCurve = "x^2 + y^2 = 1".parse()?;
    /// assert_eq!(circle.bounds_at([0.5, 0.0])?, [-0.75, -0.75]);
    /// let [low, high] = circle.bounds_at([0.1, 0.0])?;
    /// assert!(low < high && high == low.next_up());
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`] for a point that is not finite.
    pub fn bounds_at(&self, point: [f64; 2]) -> Result<[f64; 2]> {
        let [x, y] = point.map(finite);
        let [a, b] = &self.center;
        Ok(bounds(&self.polynomial.evaluate(&(x? - a), &(y? - b))))
    }

    /// The same curve, with its polynomial expanded in the contour's own coordinates.
    #[must_use]
    pub fn in_original_coordinates(&self) -> Self {
        let [a, b] = &self.center;
        Self::new(self.polynomial.translated(a, b))
    }
}

/// The surface `f(x, y, z) = 0`, in coordinates relative to `center`, with f by its homogeneous parts, and by its terms if they are
/// asked for.
///
/// The equation of a harmonic surface has the center of the surface, because F has its three homogeneous parts only about that
/// point. [`ImplicitSurface::in_original_coordinates`] expands F about the origin.
#[derive(Clone, Debug)]
pub struct ImplicitSurface {
    polynomial: OnceLock<SparsePolynomial<3>>,
    by_degree: SpacePolynomial,
    center: [Rational; 3],
}

impl PartialEq for ImplicitSurface {
    /// Whether the polynomials and the centers are equal.
    fn eq(&self, other: &Self) -> bool {
        self.by_degree == other.by_degree && self.center == other.center
    }
}

impl Eq for ImplicitSurface {}

impl ImplicitSurface {
    /// The zero set of `polynomial`, about the origin.
    #[must_use]
    pub fn new(polynomial: SparsePolynomial<3>) -> Self {
        Self {
            by_degree: SpacePolynomial::from(&polynomial),
            polynomial: polynomial.into(),
            center: origin(),
        }
    }

    /// The zero set of a polynomial that is given by its homogeneous parts, about the origin.
    #[must_use]
    pub fn of_parts(by_degree: SpacePolynomial) -> Self {
        Self {
            polynomial: OnceLock::new(),
            by_degree,
            center: origin(),
        }
    }

    /// The surface of the same polynomial, in coordinates relative to `center`.
    #[must_use]
    pub fn with_center(mut self, center: [Rational; 3]) -> Self {
        self.center = center;
        self
    }

    /// The point x = y = z = 0, in the original coordinates.
    #[must_use]
    pub fn center(&self) -> &[Rational; 3] {
        &self.center
    }

    /// Whether the center is the origin.
    #[must_use]
    pub fn is_centered(&self) -> bool {
        self.center.iter().all(Rational::is_zero)
    }

    /// The same surface, with its polynomial expanded in the original coordinates; the surface itself if its center is the origin.
    ///
    /// ```
    /// use stellate::limits::Limits;
    /// use stellate::shape::ImplicitSurface;
    ///
    /// let sphere: ImplicitSurface = "x^2 + y^2 + z^2 = 1".parse()?;
    /// let moved = sphere.with_center([0.into(), 0.into(), 3.into()]);
    /// assert_eq!(moved.bounds_at([0.0, 0.0, 4.0])?, [0.0, 0.0]);
    /// let expanded = moved.in_original_coordinates(&Limits::none())?;
    /// assert_eq!(expanded.into_owned(), "x^2 + y^2 + z^2 - 6z + 8 = 0".parse()?);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Limit`] if more than 5 000 000 terms are possible; those of `limits`.
    pub fn in_original_coordinates(&self, limits: &Limits) -> Result<Cow<'_, Self>> {
        if self.is_centered() {
            return Ok(Cow::Borrowed(self));
        }
        // Of a polynomial of degree d there are at most C(d + 3, 3) terms.
        let degree = self.by_degree.degree().unwrap_or(0);
        let product = [1, 2, 3].map(|k| degree.saturating_add(k));
        if product.into_iter().fold(1, usize::saturating_mul) / 6 > MAX_MOVED_TERMS {
            return Err(Error::limit(format!(
                "a polynomial of degree {degree} in original coordinates: it can have more than {MAX_MOVED_TERMS} terms"
            )));
        }
        let back = self.center.each_ref().map(|c| -c);
        let moved = self.polynomial().about(&back, limits)?;
        Ok(Cow::Owned(Self::new(moved)))
    }

    /// The polynomial f by its terms.
    #[must_use]
    pub fn polynomial(&self) -> &SparsePolynomial<3> {
        self.polynomial
            .get_or_init(|| SparsePolynomial::from(&self.by_degree))
    }

    /// The polynomial f by its homogeneous parts.
    ///
    /// ```
    /// use stellate::language::{Numbers, parse_form};
    /// use stellate::shape::Form;
    ///
    /// let form = parse_form("x^4 + y^4 + z^4 = x*y", "example", Numbers::Exact)?;
    /// let Form::Surface(surface) = form else { unreachable!() };
    /// assert_eq!(surface.by_degree().homogeneous_degrees(), [4, 2]);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    #[must_use]
    pub fn by_degree(&self) -> &SpacePolynomial {
        &self.by_degree
    }

    /// Surfaces that meet, all in original coordinates.
    ///
    /// # Errors
    /// Those of [`Self::in_original_coordinates`].
    pub(crate) fn all_in_original_coordinates(
        surfaces: &[Self],
        limits: &Limits,
    ) -> Result<Vec<Self>> {
        let moved = surfaces
            .iter()
            .map(|surface| Ok(surface.in_original_coordinates(limits)?.into_owned()));
        moved.collect()
    }

    /// Certified bounds of f at a point of doubles; see [`ImplicitCurve::bounds_at`].
    ///
    /// # Errors
    /// [`Error::Usage`] for a point that is not finite.
    pub fn bounds_at(&self, point: [f64; 3]) -> Result<[f64; 2]> {
        let [x, y, z] = point.map(finite);
        let [a, b, c] = &self.center;
        let point = [x? - a, y? - b, z? - c];
        Ok(bounds(&self.polynomial().evaluate(&point)))
    }
}

fn origin() -> [Rational; 3] {
    std::array::from_fn(|_| Rational::zero())
}

/// The exact value of a finite double.
fn finite(x: f64) -> Result<Rational> {
    Rational::try_from(x)
        .map_err(|_| Error::Usage(format!("a coordinate is {x}: expected a number")))
}

/// The doubles next to a value, below and above.
fn bounds(value: &Rational) -> [f64; 2] {
    let around = Interval::narrowest(value);
    [around.low(), around.high()]
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "bounds are compared bit by bit")]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_the_doubles_around_a_value() {
        let value = |text: &str| text.parse::<Rational>().expect("a number");
        assert_eq!(bounds(&value("3/4")), [0.75, 0.75]);
        for text in ["1/3", "-1/3", "1/10", "-7/3"] {
            let [low, high] = bounds(&value(text));
            assert_eq!(low.next_up().to_bits(), high.to_bits(), "{text}");
            let exact = |x: f64| Rational::try_from(x).expect("finite");
            assert!(
                exact(low) < value(text) && value(text) < exact(high),
                "{text}"
            );
        }
        let huge = Rational::try_from(f64::MAX).expect("finite") * Rational::from(2);
        assert_eq!(bounds(&huge), [f64::MAX, f64::INFINITY]);
        assert_eq!(bounds(&-&huge), [f64::NEG_INFINITY, f64::MIN]);
    }
}
