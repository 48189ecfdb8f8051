//! Closed forms of r(θ) and R(θ, φ), as exact expression trees.

use malachite::Integer;

use crate::exact::Rational;
use crate::poly::{BinaryForm, HomogeneousPolynomial};

/// An expression in the components of a unit vector with exact coefficients, in θ for binary forms and in θ and φ for ternary
/// ones.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Expression<F = BinaryForm> {
    /// The value of a form at (cos θ, sin θ) or (sin φ cos θ, sin φ sin θ, cos φ).
    Form(F),
    /// a + b
    Sum(Box<Self>, Box<Self>),
    /// a − b
    Difference(Box<Self>, Box<Self>),
    /// a · b
    Product(Box<Self>, Box<Self>),
    /// a / b
    Quotient(Box<Self>, Box<Self>),
    /// −a
    Negative(Box<Self>),
    /// A multiple of π.
    Pi(Rational),
    /// cos a
    Cosine(Box<Self>),
    /// arccos a, in [0, π]
    Arccosine(Box<Self>),
    /// The real k-th root; for even k it is the root of a non-negative number that is not negative.
    Root(u32, Box<Self>),
    /// A positive rational number.
    Constant(Rational),
    /// |a|
    Absolute(Box<Self>),
    /// a^q of a non-negative a, q > 0
    Power(Box<Self>, Rational),
}

impl<F: HomogeneousPolynomial> Expression<F> {
    /// The value at a unit vector in doubles, without a bound of its error, for drawing and comparing. In the plane the vector
    /// is [cos θ, sin θ, 0]. The value is NaN if an even root of a negative number occurs.
    #[must_use]
    #[expect(
        clippy::cast_precision_loss,
        reason = "an approximate value; degrees are small"
    )]
    pub fn approximate(&self, at: [f64; 3]) -> f64 {
        match self {
            Self::Form(form) => {
                let terms = form.monomials();
                let terms = terms.into_iter().map(|(exponents, a)| {
                    let powers = exponents.iter().zip(at);
                    powers.fold(Rational::whole(a).to_f64(), |product, (&e, x)| {
                        product * x.powf(e as f64)
                    })
                });
                terms.sum()
            }
            Self::Sum(a, b) => a.approximate(at) + b.approximate(at),
            Self::Difference(a, b) => a.approximate(at) - b.approximate(at),
            Self::Product(a, b) => a.approximate(at) * b.approximate(at),
            Self::Quotient(a, b) => a.approximate(at) / b.approximate(at),
            Self::Negative(a) => -a.approximate(at),
            Self::Pi(q) => q.to_f64() * std::f64::consts::PI,
            Self::Cosine(a) => a.approximate(at).cos(),
            // Rounding may have moved the argument slightly beyond ±1.
            Self::Arccosine(a) => a.approximate(at).clamp(-1.0, 1.0).acos(),
            Self::Root(k, a) => {
                let value = a.approximate(at);
                let root = value.abs().powf(1.0 / f64::from(*k));
                match (value < 0.0, k.is_multiple_of(2)) {
                    (true, true) => f64::NAN,
                    (true, false) => -root,
                    (false, _) => root,
                }
            }
            Self::Constant(q) => q.to_f64(),
            Self::Absolute(a) => a.approximate(at).abs(),
            Self::Power(a, q) => a.approximate(at).powf(q.to_f64()),
        }
    }

    pub(super) fn form(form: F) -> Self {
        Self::Form(form)
    }

    pub(super) fn root(self, k: u32) -> Self {
        let one = || Self::Form(F::constant(Integer::from(1)));
        if k == 1 || self == one() {
            self
        } else {
            Self::Root(k, Box::new(self))
        }
    }

    pub(super) fn negated(self) -> Self {
        match self {
            Self::Negative(inner) => *inner,
            other => Self::Negative(Box::new(other)),
        }
    }

    /// The quotient a / b, or a if b is 1.
    pub(super) fn over(self, denominator: F) -> Self {
        if denominator == F::constant(Integer::from(1)) {
            return self;
        }
        Self::Quotient(Box::new(self), Box::new(Self::Form(denominator)))
    }

    /// The product a · b, or a if b is 1.
    pub(super) fn times(self, factor: F) -> Self {
        if factor == F::constant(Integer::from(1)) {
            return self;
        }
        Self::Product(Box::new(Self::Form(factor)), Box::new(self))
    }
}
