//! The exact form that a float program is measured against.

use super::coefficients::compare_coefficients;
use super::comparison::{Comparison, GivenNumber};
use super::condition::coefficient_conditions;
use super::mistakes::{Mistaken, diagnose, mistaken_polynomials};
use super::unexplained::unexplained;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::implicitize::SquaredForm;
use crate::limits::Limits;
use crate::parametrize::born_of_radius;
use crate::poly::SparsePolynomial;
use crate::sample::RealParameters;
use crate::shape::{FourierRadius, ImplicitCurve, ImplicitSurface};

/// Up to these degrees the coefficients of a program are compared with those in original coordinates, too.
const MOST_IN_THE_PLANE: u64 = 100;
const MOST_IN_SPACE: u64 = 30;

/// A curve or a surface with its exact polynomial, and with its radius where it has one.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    polynomial: SparsePolynomial<3>,
    /// The polynomial F of Theorem 2 if `polynomial` is its square root.
    square: Option<SparsePolynomial<3>>,
    in_space: bool,
    /// The Fourier radius of the curve; if only a polynomial was given, it is found from the polynomial.
    radius: Option<FourierRadius>,
    radius_is_given: bool,
    /// For a contour, the fit with one harmonic more.
    next: Option<FourierRadius>,
    /// Of a curve its third coordinate is 0.
    center: [Rational; 3],
    /// Which real zeros of `polynomial` are points of a parametric curve.
    parameters: Option<RealParameters>,
}

impl Reference {
    /// The reference for a Fourier radius. Its polynomial is that of Theorem 2 with first coefficient 1. If that is a perfect
    /// square (only odd harmonics), the polynomial is its root, and given coefficients are compared with the one of their
    /// degree.
    ///
    /// # Errors
    /// As [`SquaredForm::new`].
    pub fn of_radius(radius: &FourierRadius) -> Result<Self> {
        let form = SquaredForm::new(radius)?;
        let monic = |curve: ImplicitCurve| SparsePolynomial::from(&curve.polynomial().monic());
        let square = form
            .is_perfect_square()
            .then(|| monic(form.expand_unreduced()));
        Ok(Self {
            polynomial: monic(form.expand()),
            square,
            in_space: false,
            radius: Some(radius.clone()),
            radius_is_given: true,
            next: None,
            center: in_space(radius.center()),
            parameters: None,
        })
    }

    /// The reference for a plane curve, with its polynomial as it is given.
    #[must_use]
    pub fn of_curve(curve: &ImplicitCurve) -> Self {
        let radius = born_of_radius(curve).and_then(|found| found.radii.into_iter().next());
        Self {
            polynomial: SparsePolynomial::from(curve.polynomial()),
            square: None,
            in_space: false,
            radius,
            radius_is_given: false,
            next: None,
            center: in_space(curve.center()),
            parameters: None,
        }
    }

    /// The reference for a surface.
    #[must_use]
    pub fn of_surface(surface: &ImplicitSurface) -> Self {
        Self {
            polynomial: surface.polynomial().clone(),
            square: None,
            in_space: true,
            radius: None,
            radius_is_given: false,
            next: None,
            center: surface.center().clone(),
            parameters: None,
        }
    }

    /// Says which real zeros of the polynomial are points of the reference. It has no radius in every direction if they are not
    /// almost all.
    pub(crate) fn with_parameters(mut self, parameters: RealParameters) -> Self {
        self.radius = self.radius.filter(|_| parameters.have_general_points());
        self.parameters = Some(parameters);
        self
    }

    /// Adds the fit with one harmonic more, for a contour, so that a degree that is too high by two is recognised.
    #[must_use]
    pub fn with_next(mut self, next: FourierRadius) -> Self {
        self.next = Some(next);
        self
    }

    /// The exact polynomial; for a plane curve it has only x and y.
    #[must_use]
    pub fn polynomial(&self) -> &SparsePolynomial<3> {
        &self.polynomial
    }

    /// Which real zeros of the polynomial are points of the reference; without parameters all of them.
    pub(super) fn parameters(&self) -> Option<&RealParameters> {
        self.parameters.as_ref()
    }

    /// Whether the reference is a surface.
    #[must_use]
    pub fn in_space(&self) -> bool {
        self.in_space
    }

    /// The Fourier radius of the curve, given or found from the polynomial.
    #[must_use]
    pub fn radius(&self) -> Option<&FourierRadius> {
        self.radius.as_ref()
    }

    /// The Fourier radius, if the reference was given by its radius.
    #[must_use]
    pub fn given_radius(&self) -> Option<&FourierRadius> {
        self.radius.as_ref().filter(|_| self.radius_is_given)
    }

    /// The point of the original coordinates that is the origin here, with as many coordinates as the form has.
    #[must_use]
    pub fn center(&self) -> &[Rational] {
        &self.center[..if self.in_space { 3 } else { 2 }]
    }

    /// Compares the coefficients of a float program with the exact ones, and looks for usual mistakes.
    #[must_use]
    pub fn check_coefficients(&self, got: &SparsePolynomial<3>) -> Comparison {
        let square = self.square.as_ref().filter(|f| f.degree() == got.degree());
        let exact = square.unwrap_or(&self.polynomial);
        let mut found = compare_coefficients(got, exact);
        found.in_space = self.in_space;
        let mistaken = std::iter::once_with(|| {
            let displaced = self.in_original_coordinates();
            self.mistaken().into_iter().chain(displaced)
        });
        found.diagnoses = diagnose(&found, mistaken.flatten(), |polynomial| {
            Some(compare_coefficients(got, polynomial))
        });
        if found.diagnoses.is_empty() {
            let conditions = self.given_radius().map(coefficient_conditions);
            found.diagnoses = unexplained(&found, |row| match (&conditions, &row.place) {
                (Some(known), GivenNumber::Term(exponents)) => {
                    let known = known.terms().find(|(e, _)| *e == exponents);
                    known.map_or_else(Rational::one, |(_, c)| c.clone().max(Rational::one()))
                }
                _ => Rational::one(),
            });
        }
        found
    }

    /// The polynomial of a program that forgot the center; `None` without a center, and if the expansion would take long.
    fn in_original_coordinates(&self) -> Option<Mistaken<SparsePolynomial<3>>> {
        let degree = self.polynomial.degree()?;
        let most = if self.in_space {
            MOST_IN_SPACE
        } else {
            MOST_IN_THE_PLANE
        };
        if self.center.iter().all(Rational::is_zero) || degree > most {
            return None;
        }
        let back = self.center.each_ref().map(|c| -c);
        let moved = self.polynomial.about(&back, &Limits::none());
        Some(Mistaken {
            name: "center forgotten".into(),
            explanation: "the coefficients are in the original coordinates; they are compared relative to the center".into(),
            form: moved.invariant("there is no limit"),
        })
    }

    /// The point of the original coordinates that is the origin here; of a curve its third coordinate is 0.
    pub(super) fn center_in_space(&self) -> &[Rational; 3] {
        &self.center
    }

    /// The polynomials that usual mistakes lead to.
    pub(super) fn mistaken(&self) -> Vec<Mistaken<SparsePolynomial<3>>> {
        let mut all = mistaken_polynomials(&self.polynomial, self.radius.as_ref(), self.in_space);
        let next = self.next.as_ref().and_then(|r| SquaredForm::new(r).ok());
        all.extend(next.map(|form| Mistaken {
            name: "one harmonic more".into(),
            explanation: "N is one too large, and the degree 2(N + 1) two".into(),
            form: SparsePolynomial::from(form.expand().polynomial()),
        }));
        all
    }
}

fn in_space([a, b]: &[Rational; 2]) -> [Rational; 3] {
    [a.clone(), b.clone(), Rational::zero()]
}
