//! The right side of `r = …`: trigonometric polynomials in one angle.

use super::evaluate::{Algebra, Context, evaluate, times};
use super::limits::MAX_HARMONIC;
use super::name::Name;
use super::source::Span;
use super::syntax::Expr;
use crate::error::Result;
use crate::exact::Rational;
use crate::poly::{Ring, TrigPolynomial};

const ARGUMENT: &str =
    "the argument of cos and sin is an integer multiple of the angle, as in cos(3*t)";

/// Trigonometric polynomials.
pub(super) struct Radius;

impl Algebra for Radius {
    type Value = TrigPolynomial;

    const DIVISOR: &'static str =
        "division by a function of the angle is not a finite Fourier series; divide by constants";

    fn constant(value: Rational) -> TrigPolynomial {
        TrigPolynomial::constant(value)
    }

    fn to_constant(value: &TrigPolynomial) -> Option<Rational> {
        value.as_constant()
    }

    fn name(&self, cx: &mut Context<'_>, name: Name, at: Span) -> Result<TrigPolynomial> {
        let shown = cx.source.quoted(at);
        let message = match name {
            Name::T | Name::Theta => format!(
                "the angle {shown} outside cos( ) and sin( ) is not a finite Fourier series"
            ),
            Name::R => "r stands only on the left of `r = …`".into(),
            _ => {
                format!("{shown} in a Fourier radius, whose only variable is the angle t or theta")
            }
        };
        Err(cx.source.error(at, message))
    }

    fn call(
        &self,
        cx: &mut Context<'_>,
        name: Name,
        argument: &Expr,
        _: Span,
    ) -> Result<TrigPolynomial> {
        let [slope, offset] = evaluate(cx, &Angle, argument)?;
        if !slope.is_integer() || !offset.is_zero() {
            return Err(cx.source.error(argument.span, ARGUMENT));
        }
        if slope.abs() > Rational::from(i64::from(MAX_HARMONIC)) {
            let limit = format!("a harmonic beyond {MAX_HARMONIC}");
            return Err(cx.source.limit(argument.span, limit));
        }
        let n = i32::try_from(&slope.numerator()).unwrap_or(0);
        Ok(if name == Name::Cos {
            TrigPolynomial::cosine(n)
        } else {
            TrigPolynomial::sine(n)
        })
    }

    fn add(&self, sum: &mut TrigPolynomial, negative: bool, term: TrigPolynomial) {
        let sign = if negative { -1 } else { 1 };
        sum.add_multiple(&term, &Rational::from(sign));
    }

    fn multiply(
        &self,
        cx: &mut Context<'_>,
        a: TrigPolynomial,
        b: TrigPolynomial,
        at: Span,
    ) -> Result<TrigPolynomial> {
        match (a.as_constant(), b.as_constant()) {
            (Some(p), Some(q)) => Ok(Self::constant(times(cx, p, q, at)?)),
            (Some(p), None) => scaled(cx, &b, &p, at),
            (None, Some(q)) => scaled(cx, &a, &q, at),
            (None, None) => {
                account(cx, &a, &b, at)?;
                Ok(a.times(&b))
            }
        }
    }

    fn power(
        &self,
        cx: &mut Context<'_>,
        base: TrigPolynomial,
        exponent: u32,
        at: Span,
    ) -> Result<TrigPolynomial> {
        let mut result = TrigPolynomial::constant(Rational::one());
        let mut square = base;
        let mut rest = exponent;
        while rest > 0 {
            if rest & 1 == 1 {
                account(cx, &result, &square, at)?;
                result = result.times(&square);
            }
            rest >>= 1;
            if rest > 0 {
                account(cx, &square, &square, at)?;
                square = square.squared();
            }
        }
        Ok(result)
    }
}

fn bits(f: &TrigPolynomial) -> u64 {
    f.harmonics()
        .map(|(_, [a, b])| a.bits().max(b.bits()))
        .max()
        .unwrap_or(0)
}

fn scaled(
    cx: &mut Context<'_>,
    f: &TrigPolynomial,
    factor: &Rational,
    at: Span,
) -> Result<TrigPolynomial> {
    let count = f.len() as u64;
    let bits = bits(f) + factor.bits();
    cx.budget.spend_products(count, bits, cx.source, at)?;
    cx.budget
        .spend_bits(count.saturating_mul(bits), cx.source, at)?;
    Ok(f.scaled(factor))
}

/// Accounts for a product and checks its highest harmonic, before it is computed.
fn account(cx: &mut Context<'_>, a: &TrigPolynomial, b: &TrigPolynomial, at: Span) -> Result<()> {
    let top = a.degree().unwrap_or(0) + b.degree().unwrap_or(0);
    if top > MAX_HARMONIC {
        let limit = format!("a product with harmonics beyond {MAX_HARMONIC}");
        return Err(cx.source.limit(at, limit));
    }
    let count = (a.len() as u64).saturating_mul(b.len() as u64);
    let bits = bits(a) + bits(b);
    cx.budget.spend_products(count, bits, cx.source, at)?;
    let terms = count.min(u64::from(top) + 1);
    cx.budget
        .spend_bits(terms.saturating_mul(bits), cx.source, at)
}

/// slope·angle + offset: what may stand in cos( ) and sin( ).
struct Angle;

impl Algebra for Angle {
    type Value = [Rational; 2];

    const DIVISOR: &'static str = ARGUMENT;

    fn constant(value: Rational) -> [Rational; 2] {
        [Rational::zero(), value]
    }

    fn to_constant([slope, offset]: &[Rational; 2]) -> Option<Rational> {
        slope.is_zero().then(|| offset.clone())
    }

    fn name(&self, cx: &mut Context<'_>, name: Name, at: Span) -> Result<[Rational; 2]> {
        match name {
            Name::T | Name::Theta => Ok([Rational::one(), Rational::zero()]),
            _ => Err(cx.source.error(at, ARGUMENT)),
        }
    }

    fn call(&self, cx: &mut Context<'_>, _: Name, _: &Expr, at: Span) -> Result<[Rational; 2]> {
        Err(cx.source.error(at, ARGUMENT))
    }

    fn add(&self, sum: &mut [Rational; 2], negative: bool, term: [Rational; 2]) {
        for (part, other) in sum.iter_mut().zip(term) {
            let before = std::mem::take(part);
            *part = if negative {
                before - other
            } else {
                before + other
            };
        }
    }

    fn multiply(
        &self,
        cx: &mut Context<'_>,
        a: [Rational; 2],
        b: [Rational; 2],
        at: Span,
    ) -> Result<[Rational; 2]> {
        let (angle, factor) = match (Self::to_constant(&a), Self::to_constant(&b)) {
            (_, Some(factor)) => (a, factor),
            (Some(factor), None) => (b, factor),
            (None, None) => return Err(cx.source.error(at, ARGUMENT)),
        };
        let [slope, offset] = angle;
        Ok([
            times(cx, slope, factor.clone(), at)?,
            times(cx, offset, factor, at)?,
        ])
    }

    fn power(
        &self,
        cx: &mut Context<'_>,
        _: [Rational; 2],
        _: u32,
        at: Span,
    ) -> Result<[Rational; 2]> {
        Err(cx.source.error(at, ARGUMENT))
    }
}
