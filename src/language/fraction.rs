//! Equations between rational functions of x, y and z: `y = 1/x` is x y − 1 = 0.

use super::evaluate::{Algebra, Context, evaluate};
use super::expand;
use super::name::Name;
use super::polynomial::Implicit;
use super::source::Span;
use super::syntax::{Equation, Expr, ExprKind};
use crate::error::Result;
use crate::exact::Rational;
use crate::factor::greatest_common_divisor;
use crate::limits::Limits;
use crate::poly::{SparsePolynomial, total_degree};

/// The highest degree of numerator and denominator, and the most terms of both.
const MAX_DEGREE: u64 = 100;
const MAX_FRACTION_TERMS: usize = 10_000;

/// Whether something with a coordinate in it divides.
pub(super) fn divides(expr: &Expr) -> bool {
    let parts = |parts: &[(bool, Expr)]| parts.iter().any(|(_, part)| divides(part));
    match &expr.kind {
        ExprKind::Number | ExprKind::Integer(_) | ExprKind::Name(_) => false,
        ExprKind::Negative(inner) => divides(inner),
        ExprKind::Sum(terms) => parts(terms),
        ExprKind::Product(factors) => {
            factors
                .iter()
                .any(|(divides, part)| *divides && !part.is_number())
                || parts(factors)
        }
        ExprKind::Power(base, exponent) => {
            let is_negative = matches!(exponent.kind, ExprKind::Negative(_));
            is_negative && !base.is_number() || divides(base)
        }
        ExprKind::Call(_, arguments) => arguments.iter().any(divides),
    }
}

/// The numerator of left − right in lowest terms, and without the factors that it shares with a divisor: they are 0 where
/// the equation says nothing. It is 0 exactly where the equation holds, and at points where numerator and denominator vanish.
pub(super) fn numerator(cx: &mut Context<'_>, equation: &Equation) -> Result<SparsePolynomial<3>> {
    let mut difference = evaluate(cx, &Fractions, &equation.left)?;
    if let Some(right) = &equation.right {
        let value = evaluate(cx, &Fractions, right)?;
        Fractions.add(cx, &mut difference, true, value, right.span)?;
    }
    let Fraction { mut above, below } = difference;
    let degree =
        |f: &SparsePolynomial<3>| f.terms().map(|(e, _)| total_degree(e)).max().unwrap_or(0);
    if degree(&above).max(degree(&below)) > MAX_DEGREE
        || above.len() + below.len() > MAX_FRACTION_TERMS
    {
        let limit = format!(
            "an equation between quotients of a degree beyond {MAX_DEGREE} or with more than {MAX_FRACTION_TERMS} terms"
        );
        return Err(cx.source.limit(equation.left.span, limit));
    }
    let limits = Limits::none();
    while !above.is_empty() {
        let common = greatest_common_divisor(&above, &below, &limits)?;
        if common.as_constant().is_some() {
            break;
        }
        above = crate::factor::coprime_parts([&above, &common], &limits)?[0].clone();
    }
    Ok(above)
}

/// Quotients of polynomials, not in lowest terms.
struct Fractions;

struct Fraction {
    above: SparsePolynomial<3>,
    below: SparsePolynomial<3>,
}

impl Fraction {
    fn polynomial(above: SparsePolynomial<3>) -> Self {
        Self {
            above,
            below: SparsePolynomial::constant(Rational::one()),
        }
    }
}

impl Algebra for Fractions {
    type Value = Fraction;

    const DIVISOR: &'static str = "division by zero";

    fn constant(value: Rational) -> Fraction {
        Fraction::polynomial(SparsePolynomial::constant(value))
    }

    fn to_constant(value: &Fraction) -> Option<Rational> {
        let above = value.above.as_constant()?;
        if above.is_zero() {
            return Some(above);
        }
        Some(above * value.below.as_constant()?.recip()?)
    }

    fn name(&self, cx: &mut Context<'_>, name: Name, at: Span) -> Result<Fraction> {
        let value = Implicit.name(cx, name, at)?;
        Ok(Fraction::polynomial(value.into_polynomial()))
    }

    fn call(
        &self,
        cx: &mut Context<'_>,
        name: Name,
        argument: &Expr,
        at: Span,
    ) -> Result<Fraction> {
        let value = Implicit.call(cx, name, argument, at)?;
        Ok(Fraction::polynomial(value.into_polynomial()))
    }

    fn reciprocal(&self, value: Fraction) -> Option<Fraction> {
        Some(Fraction {
            above: value.below,
            below: value.above,
        })
    }

    fn add(
        &self,
        cx: &mut Context<'_>,
        sum: &mut Fraction,
        negative: bool,
        mut term: Fraction,
        at: Span,
    ) -> Result<()> {
        if sum.below != term.below {
            sum.above = expand::product(cx, &sum.above, &term.below, at)?;
            term.above = expand::product(cx, &term.above, &sum.below, at)?;
            sum.below = expand::product(cx, &sum.below, &term.below, at)?;
        }
        let sign = if negative { -1 } else { 1 };
        sum.above.add_multiple(&term.above, &Rational::from(sign));
        Ok(())
    }

    fn multiply(
        &self,
        cx: &mut Context<'_>,
        a: Fraction,
        b: Fraction,
        at: Span,
    ) -> Result<Fraction> {
        Ok(Fraction {
            above: expand::product(cx, &a.above, &b.above, at)?,
            below: expand::product(cx, &a.below, &b.below, at)?,
        })
    }

    fn power(
        &self,
        cx: &mut Context<'_>,
        base: Fraction,
        exponent: u32,
        at: Span,
    ) -> Result<Fraction> {
        Ok(Fraction {
            above: expand::power(cx, &base.above, exponent, at)?,
            below: expand::power(cx, &base.below, exponent, at)?,
        })
    }
}
