//! The common interface of binary and ternary forms.

use std::fmt::Debug;

use malachite::Integer;

use super::{BinaryForm, Ring, TernaryForm};

/// A homogeneous polynomial with integer coefficients, in x and y or in x, y and z.
///
/// The lemmas of §3 of the paper are the same in the plane and in space: Lemmas 7 to 10 are Lemmas 2 to 5 with forms in (α, β,
/// γ) instead of forms in (cos θ, sin θ). So the program has them once, for both kinds of forms.
pub trait HomogeneousPolynomial: Ring + PartialEq + Debug {
    /// The number of variables, 2 or 3.
    const VARIABLES: usize;

    /// A constant, as a form of degree 0.
    fn constant(value: Integer) -> Self;

    /// The degree, which the zero form has as well.
    fn degree(&self) -> usize;

    /// Whether every coefficient is 0.
    fn is_zero(&self) -> bool;

    /// The gcd of the coefficients; 0 for the zero form.
    fn content(&self) -> Integer;

    /// The product `factor · f`.
    #[must_use]
    fn scaled(&self, factor: &Integer) -> Self;

    /// The quotient `f / divisor`; the divisor must divide the content.
    #[must_use]
    fn div_exact(&self, divisor: &Integer) -> Self;

    /// The form, divided by all powers of the squared length (`x² + y²` or `x² + y² + z²`), which is 1 on unit vectors.
    #[must_use]
    fn on_unit_vectors(&self) -> Self;

    /// The terms (e, k, c) of the form as `Σ c (x² + y²)^e z^k`; `None` unless it is a ternary form of this shape, which
    /// belongs to a surface of revolution about the z axis.
    fn of_revolution(&self) -> Option<Vec<(usize, usize, Integer)>> {
        None
    }

    /// The non-zero terms, each with the exponents of x, y, z and the coefficient.
    fn monomials(&self) -> Vec<([usize; 3], &Integer)>;
}

impl HomogeneousPolynomial for BinaryForm {
    const VARIABLES: usize = 2;

    fn constant(value: Integer) -> Self {
        Self::from_coefficients(vec![value])
    }

    fn degree(&self) -> usize {
        self.degree()
    }

    fn is_zero(&self) -> bool {
        self.is_zero()
    }

    fn content(&self) -> Integer {
        self.content()
    }

    fn scaled(&self, factor: &Integer) -> Self {
        self.scaled(factor)
    }

    fn div_exact(&self, divisor: &Integer) -> Self {
        self.div_exact(divisor)
    }

    fn on_unit_vectors(&self) -> Self {
        self.strip_rho()
            .map_or_else(|| self.clone(), |(_, rest)| rest)
    }

    fn monomials(&self) -> Vec<([usize; 3], &Integer)> {
        let degree = self.degree();
        self.terms().map(|(k, c)| ([degree - k, k, 0], c)).collect()
    }
}

impl HomogeneousPolynomial for TernaryForm {
    const VARIABLES: usize = 3;

    fn constant(value: Integer) -> Self {
        Self::from_rows(vec![BinaryForm::from_coefficients(vec![value])])
    }

    fn degree(&self) -> usize {
        self.degree()
    }

    fn is_zero(&self) -> bool {
        self.is_zero()
    }

    fn content(&self) -> Integer {
        self.content()
    }

    fn scaled(&self, factor: &Integer) -> Self {
        self.scaled(factor)
    }

    fn div_exact(&self, divisor: &Integer) -> Self {
        self.div_exact(divisor)
    }

    fn on_unit_vectors(&self) -> Self {
        self.strip_rho()
            .map_or_else(|| self.clone(), |(_, rest)| rest)
    }

    fn of_revolution(&self) -> Option<Vec<(usize, usize, Integer)>> {
        let rows = self.rows().iter().enumerate();
        let terms = rows.filter_map(|(k, row)| {
            let (e, rest) = row.strip_rho()?;
            let constant = rest.degree() == 0;
            Some(constant.then(|| (e, k, rest.coefficient(0))))
        });
        terms.collect()
    }

    fn monomials(&self) -> Vec<([usize; 3], &Integer)> {
        self.terms().collect()
    }
}
