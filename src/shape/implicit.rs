//! Implicit curves and surfaces: zero sets of exact polynomials.

use crate::exact::Rational;
use crate::poly::{PlanePolynomial, SpacePolynomial, SparsePolynomial};

/// The plane curve `f(x, y) = 0`, in coordinates relative to `center`.
///
/// For a contour the centre is the one of its fit: only there has F its three homogeneous parts.
/// [`ImplicitCurve::in_original_coordinates`] expands F about the contour's own origin.
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

    /// The same polynomial in coordinates relative to `center`.
    #[must_use]
    pub fn with_center(mut self, center: [Rational; 2]) -> Self {
        self.center = center;
        self
    }

    /// f.
    #[must_use]
    pub fn polynomial(&self) -> &PlanePolynomial {
        &self.polynomial
    }

    /// The same curve with a multiple of f.
    #[must_use]
    pub fn map_polynomial(
        mut self,
        multiple: impl FnOnce(PlanePolynomial) -> PlanePolynomial,
    ) -> Self {
        self.polynomial = multiple(self.polynomial);
        self
    }

    /// Where x = y = 0 lies in the contour's coordinates.
    #[must_use]
    pub fn center(&self) -> &[Rational; 2] {
        &self.center
    }

    /// The same curve with its polynomial expanded in the contour's own coordinates.
    #[must_use]
    pub fn in_original_coordinates(&self) -> Self {
        let [a, b] = &self.center;
        Self::new(self.polynomial.translated(a, b))
    }
}

/// The surface `f(x, y, z) = 0`, with f by its terms and by its homogeneous parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImplicitSurface {
    polynomial: SparsePolynomial<3>,
    by_degree: SpacePolynomial,
}

impl ImplicitSurface {
    /// The zero set of `polynomial`.
    #[must_use]
    pub fn new(polynomial: SparsePolynomial<3>) -> Self {
        let by_degree = SpacePolynomial::from(&polynomial);
        Self {
            polynomial,
            by_degree,
        }
    }

    /// f.
    #[must_use]
    pub fn polynomial(&self) -> &SparsePolynomial<3> {
        &self.polynomial
    }

    /// f by its homogeneous parts.
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
}
