//! Closed forms of r(θ), as exact expression trees.

use crate::exact::Rational;
use crate::poly::BinaryForm;

/// An expression in θ with exact coefficients.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A form at (cos θ, sin θ).
    Form(BinaryForm),
    /// a + b
    Sum(Box<Expression>, Box<Expression>),
    /// a − b
    Difference(Box<Expression>, Box<Expression>),
    /// a · b
    Product(Box<Expression>, Box<Expression>),
    /// a / b
    Quotient(Box<Expression>, Box<Expression>),
    /// −a
    Negative(Box<Expression>),
    /// A multiple of π.
    Pi(Rational),
    /// cos a
    Cosine(Box<Expression>),
    /// arccos a, in [0, π]
    Arccosine(Box<Expression>),
    /// The real k-th root: for even k the non-negative one of a non-negative number.
    Root(u32, Box<Expression>),
    /// A positive rational number.
    Constant(Rational),
    /// |a|
    Absolute(Box<Expression>),
    /// a^q of a non-negative a, q > 0
    Power(Box<Expression>, Rational),
}

impl Expression {
    /// The value at θ in doubles, with no bound of its error: for drawing and comparing. NaN where an
    /// even root of a negative number is taken.
    #[must_use]
    #[expect(
        clippy::cast_precision_loss,
        reason = "an approximate value; degrees are small"
    )]
    pub fn approximate(&self, theta: f64) -> f64 {
        match self {
            Self::Form(form) => {
                let (s, c) = theta.sin_cos();
                let terms = form.terms().map(|(k, a)| {
                    let exponents = [form.degree() - k, k].map(|e| e as f64);
                    Rational::from(a).to_f64() * c.powf(exponents[0]) * s.powf(exponents[1])
                });
                terms.sum()
            }
            Self::Sum(a, b) => a.approximate(theta) + b.approximate(theta),
            Self::Difference(a, b) => a.approximate(theta) - b.approximate(theta),
            Self::Product(a, b) => a.approximate(theta) * b.approximate(theta),
            Self::Quotient(a, b) => a.approximate(theta) / b.approximate(theta),
            Self::Negative(a) => -a.approximate(theta),
            Self::Pi(q) => q.to_f64() * std::f64::consts::PI,
            Self::Cosine(a) => a.approximate(theta).cos(),
            // Rounding may carry the argument over the edge.
            Self::Arccosine(a) => a.approximate(theta).clamp(-1.0, 1.0).acos(),
            Self::Root(k, a) => {
                let value = a.approximate(theta);
                let root = value.abs().powf(1.0 / f64::from(*k));
                match (value < 0.0, k.is_multiple_of(2)) {
                    (true, true) => f64::NAN,
                    (true, false) => -root,
                    (false, _) => root,
                }
            }
            Self::Constant(q) => q.to_f64(),
            Self::Absolute(a) => a.approximate(theta).abs(),
            Self::Power(a, q) => a.approximate(theta).powf(q.to_f64()),
        }
    }

    pub(super) fn form(form: BinaryForm) -> Self {
        Self::Form(form)
    }

    pub(super) fn root(self, k: u32) -> Self {
        if k == 1 {
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

    /// a / b, without a denominator 1.
    pub(super) fn over(self, denominator: BinaryForm) -> Self {
        if denominator.degree() == 0 && denominator.coefficient(0) == 1 {
            return self;
        }
        Self::Quotient(Box::new(self), Box::new(Self::Form(denominator)))
    }

    /// a · b, without a factor 1.
    pub(super) fn times(self, factor: BinaryForm) -> Self {
        if factor.degree() == 0 && factor.coefficient(0) == 1 {
            return self;
        }
        Self::Product(Box::new(Self::Form(factor)), Box::new(self))
    }
}
