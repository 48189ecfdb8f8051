//! Implicit curves and surfaces: zero sets of exact polynomials.

use std::sync::OnceLock;

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::intervals::Interval;
use crate::poly::{PlanePolynomial, SpacePolynomial, SparsePolynomial};

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

/// The surface `f(x, y, z) = 0`, with f by its homogeneous parts, and by its terms if they are asked for.
#[derive(Clone, Debug)]
pub struct ImplicitSurface {
    polynomial: OnceLock<SparsePolynomial<3>>,
    by_degree: SpacePolynomial,
}

impl PartialEq for ImplicitSurface {
    /// Whether the polynomials are equal.
    fn eq(&self, other: &Self) -> bool {
        self.by_degree == other.by_degree
    }
}

impl Eq for ImplicitSurface {}

impl ImplicitSurface {
    /// The zero set of `polynomial`.
    #[must_use]
    pub fn new(polynomial: SparsePolynomial<3>) -> Self {
        let by_degree = SpacePolynomial::from(&polynomial);
        Self {
            polynomial: polynomial.into(),
            by_degree,
        }
    }

    /// The zero set of a polynomial that is given by its homogeneous parts.
    #[must_use]
    pub fn of_parts(by_degree: SpacePolynomial) -> Self {
        Self {
            polynomial: OnceLock::new(),
            by_degree,
        }
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

    /// Certified bounds of f at a point of doubles; see [`ImplicitCurve::bounds_at`].
    ///
    /// # Errors
    /// [`Error::Usage`] for a point that is not finite.
    pub fn bounds_at(&self, point: [f64; 3]) -> Result<[f64; 2]> {
        let [x, y, z] = point.map(finite);
        Ok(bounds(&self.polynomial().evaluate(&[x?, y?, z?])))
    }
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
