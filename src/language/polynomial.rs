//! Implicit equations: polynomials in x, y and z.

use super::budget::MAX_DEGREE;
use super::evaluate::{Algebra, Context, times};
use super::expand;
use super::name::Name;
use super::radius::{not_a_series, not_rational};
use super::source::Span;
use super::syntax::Expr;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::poly::{SparsePolynomial, total_degree};

/// The ring of polynomials in x, y and z.
pub(super) struct Implicit;

/// A polynomial. A single term has a variant of its own, because most values in a long text are single terms.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Term([u32; 3], Rational),
    Sum(SparsePolynomial<3>),
}

impl PartialEq for Value {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Value::Term(e, p), Value::Term(f, q)) => (e, p) == (f, q),
            (Value::Sum(f), Value::Sum(g)) => f == g,
            (Value::Term(e, c), Value::Sum(sum)) | (Value::Sum(sum), Value::Term(e, c)) => {
                *sum == SparsePolynomial::from_terms([(*e, c.clone())])
            }
        }
    }
}

impl Value {
    pub(super) fn into_polynomial(self) -> SparsePolynomial<3> {
        match self {
            Value::Term(exponents, c) => SparsePolynomial::from_terms([(exponents, c)]),
            Value::Sum(sum) => sum,
        }
    }
}

impl Algebra for Implicit {
    type Value = Value;

    const DIVISOR: &'static str = "division by a polynomial does not give a polynomial; \
         multiply the equation by it, or divide by constants";

    fn constant(value: Rational) -> Value {
        Value::Term([0; 3], value)
    }

    fn to_constant(value: &Value) -> Option<Rational> {
        match value {
            Value::Term(exponents, c) => (*exponents == [0; 3] || c.is_zero()).then(|| c.clone()),
            Value::Sum(sum) => sum.as_constant(),
        }
    }

    fn name(&self, cx: &mut Context<'_>, name: Name, at: Span) -> Result<Value> {
        let exponents = match name {
            Name::X => [1, 0, 0],
            Name::Y => [0, 1, 0],
            Name::Z => [0, 0, 1],
            Name::R => {
                let message = "r stands only on the left of a Fourier radius `r = …`; \
                               a polynomial has x, y, z";
                return Err(cx.source.error(at, message));
            }
            Name::Pi => return Err(cx.source.error(at, not_rational(cx.source.quoted(at)))),
            _ => {
                let message = format!(
                    "{} in a polynomial, whose variables are x, y, z; \
                     the angle t or theta belongs to a Fourier radius `r = …`",
                    cx.source.quoted(at)
                );
                return Err(cx.source.error(at, message));
            }
        };
        Ok(Value::Term(exponents, Rational::one()))
    }

    fn call(&self, cx: &mut Context<'_>, name: Name, _: &Expr, at: Span) -> Result<Value> {
        if !matches!(name, Name::Cos | Name::Sin) {
            return Err(cx.source.error(at, not_a_series(cx.source.slice(at))));
        }
        let message = "cos and sin do not occur in a polynomial; \
                       they belong to a Fourier radius `r = …` in the angle t or theta";
        Err(cx.source.error(at, message))
    }

    fn add(
        &self,
        _: &mut Context<'_>,
        sum: &mut Value,
        negative: bool,
        term: Value,
        _: Span,
    ) -> Result<()> {
        let mut accumulator = match std::mem::replace(sum, Self::constant(Rational::zero())) {
            // The first part of a sum takes the place of 0.
            Value::Term(_, c) if c.is_zero() && !negative => {
                *sum = term;
                return Ok(());
            }
            Value::Term(exponents, c) => SparsePolynomial::from_terms([(exponents, c)]),
            Value::Sum(accumulator) => accumulator,
        };
        match term {
            Value::Term(exponents, c) => {
                accumulator.add_term(exponents, if negative { -c } else { c });
            }
            Value::Sum(other) => {
                let sign = if negative { -1 } else { 1 };
                accumulator.add_multiple(&other, &Rational::from(sign));
            }
        }
        *sum = Value::Sum(accumulator);
        Ok(())
    }

    fn multiply(&self, cx: &mut Context<'_>, a: Value, b: Value, at: Span) -> Result<Value> {
        match (a, b) {
            (Value::Term(e, p), Value::Term(f, q)) => {
                let exponents = [e[0] + f[0], e[1] + f[1], e[2] + f[2]];
                if total_degree(&exponents) > u64::from(MAX_DEGREE) {
                    return Err(expand::degree_limit(cx, at));
                }
                Ok(Value::Term(exponents, times(cx, p, q, at)?))
            }
            (Value::Term(e, c), Value::Sum(sum)) | (Value::Sum(sum), Value::Term(e, c)) => {
                expand::times_term(cx, sum, e, &c, at).map(Value::Sum)
            }
            (Value::Sum(f), Value::Sum(g)) => expand::product(cx, &f, &g, at).map(Value::Sum),
        }
    }

    fn power(&self, cx: &mut Context<'_>, base: Value, exponent: u32, at: Span) -> Result<Value> {
        match base {
            Value::Term(e, c) => {
                if total_degree(&e) * u64::from(exponent) > u64::from(MAX_DEGREE) {
                    return Err(expand::degree_limit(cx, at));
                }
                let bits = c.bits().saturating_mul(u64::from(exponent));
                if bits > u64::from(exponent) {
                    cx.budget.spend_bits(1, bits, cx.source, at)?;
                }
                let power = c
                    .pow(i64::from(exponent))
                    .invariant("a power with a natural exponent exists");
                Ok(Value::Term(e.map(|k| k * exponent), power))
            }
            Value::Sum(f) => expand::power(cx, &f, exponent, at).map(Value::Sum),
        }
    }
}
