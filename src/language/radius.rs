//! The right sides of `r = …` that are trigonometric polynomials in one angle.

use super::angle::{ARGUMENT, Angle};
use super::budget::MAX_HARMONIC;
use super::evaluate::{Algebra, Context, multiplied};
use super::name::Name;
use super::source::Span;
use super::syntax::Expr;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::poly::{Ring, TrigPolynomial};

/// The ring of trigonometric polynomials.
pub(super) struct TrigAlgebra;

/// The message for a function such as tan in a radius or in a polynomial; `call` is the text of its call.
pub(super) fn not_a_series(call: &str) -> String {
    let function = call
        .split_once('(')
        .map_or(call, |(name, _)| name)
        .trim_end();
    format!(
        "unknown function `{function}`: it is not a finite Fourier series and not a polynomial; \
         cos and sin of integer multiples of the angle are understood"
    )
}

/// The message for π outside of angles.
pub(super) fn not_rational(shown: String) -> String {
    format!("{shown} is not rational; numbers are exact here: write a fraction or a decimal")
}

impl Algebra for TrigAlgebra {
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
            _ if name.is_parameter() => format!(
                "the angle {shown} outside cos( ) and sin( ) is not a finite Fourier series"
            ),
            Name::Pi => not_rational(shown),
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
        at: Span,
    ) -> Result<TrigPolynomial> {
        if !matches!(name, Name::Cos | Name::Sin) {
            return Err(cx.source.error(at, not_a_series(cx.source.slice(at))));
        }
        let angle = Angle::of(cx, argument)?;
        let wrong = || cx.source.error(argument.span, ARGUMENT);
        let (sine, sign) = angle.phase(name).ok_or_else(wrong)?;
        // At most one parameter occurs in a formula, so at most one slope is not 0.
        let slope = angle.slopes.iter().fold(Rational::zero(), |sum, s| sum + s);
        if !slope.is_integer() {
            return Err(wrong());
        }
        if slope.abs() > Rational::from(i64::from(MAX_HARMONIC)) {
            let limit = format!("a harmonic beyond {MAX_HARMONIC}");
            return Err(cx.source.limit(argument.span, limit));
        }
        let n = i32::try_from(&slope.numerator()).invariant("the harmonic is within the limit");
        let wave = if sine {
            TrigPolynomial::sine(n)
        } else {
            TrigPolynomial::cosine(n)
        };
        Ok(wave.scaled(&Rational::from(sign)))
    }

    fn add(
        &self,
        _: &mut Context<'_>,
        sum: &mut TrigPolynomial,
        negative: bool,
        term: TrigPolynomial,
        _: Span,
    ) -> Result<()> {
        let sign = if negative { -1 } else { 1 };
        sum.add_multiple(&term, &Rational::from(sign));
        Ok(())
    }

    fn multiply(
        &self,
        cx: &mut Context<'_>,
        a: TrigPolynomial,
        b: TrigPolynomial,
        at: Span,
    ) -> Result<TrigPolynomial> {
        multiplied::<Self>(cx, [a, b], at, scaled, product)
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
                result = product(cx, &result, &square, at)?;
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
    cx.budget.spend_bits(count, bits, cx.source, at)?;
    Ok(f.scaled(factor))
}

fn product(
    cx: &mut Context<'_>,
    a: &TrigPolynomial,
    b: &TrigPolynomial,
    at: Span,
) -> Result<TrigPolynomial> {
    account(cx, a, b, at)?;
    Ok(a.times(b))
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
    cx.budget.spend_bits(terms, bits, cx.source, at)
}
