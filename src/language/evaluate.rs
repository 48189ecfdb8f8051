//! Evaluates an expression in a ring, which the caller chooses as an [`Algebra`].

use super::budget::{Budget, MAX_DEGREE};
use super::name::Name;
use super::number::{Numbers, literal};
use super::source::{Source, Span};
use super::syntax::{Expr, ExprKind};
use crate::error::{Invariant, Result};
use crate::exact::Rational;

/// The data that an evaluation needs besides the ring.
#[derive(Debug)]
pub(super) struct Context<'a> {
    pub(super) source: Source<'a>,
    pub(super) numbers: Numbers,
    pub(super) budget: Budget,
    /// Whether the form has the origin besides the points of what is written.
    pub(super) adds_origin: bool,
}

/// A ring that contains the rational numbers, with the meanings of names and functions in it.
pub(super) trait Algebra {
    type Value;

    /// The message for a divisor that is not constant, in a ring that has no reciprocal of it.
    const DIVISOR: &'static str;

    fn constant(value: Rational) -> Self::Value;

    fn to_constant(value: &Self::Value) -> Option<Rational>;

    fn name(&self, cx: &mut Context<'_>, name: Name, at: Span) -> Result<Self::Value>;

    /// A function of an angle: cos, sin, tan, cot, sec or csc.
    fn call(
        &self,
        cx: &mut Context<'_>,
        name: Name,
        argument: &Expr,
        at: Span,
    ) -> Result<Self::Value>;

    /// The spherical harmonic Y(l, m).
    fn harmonic(&self, cx: &mut Context<'_>, degree: &Expr, _: &Expr) -> Result<Self::Value> {
        let message = "Y(l, m) belongs to the radius of a surface, R = 1 + Y(2, 0)/5";
        Err(cx.source.error(degree.span, message))
    }

    /// Adds the term to the sum, or subtracts it if `negative`. The sum changes in place, so that a long sum is not copied for
    /// every term.
    fn add(
        &self,
        cx: &mut Context<'_>,
        sum: &mut Self::Value,
        negative: bool,
        term: Self::Value,
        at: Span,
    ) -> Result<()>;

    /// 1/value for a value that is not constant; `None` if the ring has no quotients.
    fn reciprocal(&self, _: Self::Value) -> Option<Self::Value> {
        None
    }

    fn multiply(
        &self,
        cx: &mut Context<'_>,
        a: Self::Value,
        b: Self::Value,
        at: Span,
    ) -> Result<Self::Value>;

    /// base^exponent for a base that is not constant.
    fn power(
        &self,
        cx: &mut Context<'_>,
        base: Self::Value,
        exponent: u32,
        at: Span,
    ) -> Result<Self::Value>;
}

/// The product of two values of a ring in which a constant factor only scales. `scaled` and `product` account for their work.
pub(super) fn multiplied<A: Algebra>(
    cx: &mut Context<'_>,
    [a, b]: [A::Value; 2],
    at: Span,
    scaled: impl Fn(&mut Context<'_>, &A::Value, &Rational, Span) -> Result<A::Value>,
    product: impl Fn(&mut Context<'_>, &A::Value, &A::Value, Span) -> Result<A::Value>,
) -> Result<A::Value> {
    match (A::to_constant(&a), A::to_constant(&b)) {
        (Some(p), Some(q)) => Ok(A::constant(times(cx, p, q, at)?)),
        (Some(p), None) => scaled(cx, &b, &p, at),
        (None, Some(q)) => scaled(cx, &a, &q, at),
        (None, None) => product(cx, &a, &b, at),
    }
}

/// The value of `expr`.
pub(super) fn evaluate<A: Algebra>(
    cx: &mut Context<'_>,
    algebra: &A,
    expr: &Expr,
) -> Result<A::Value> {
    match &expr.kind {
        ExprKind::Number => number(cx, expr.span).map(A::constant),
        ExprKind::Integer(value) => Ok(A::constant(Rational::from(i64::from(*value)))),
        ExprKind::Name(name) => algebra.name(cx, *name, expr.span),
        ExprKind::Negative(inner) => {
            let value = evaluate(cx, algebra, inner)?;
            let mut zero = A::constant(Rational::zero());
            algebra.add(cx, &mut zero, true, value, expr.span)?;
            Ok(zero)
        }
        ExprKind::Sum(parts) => {
            let mut sum = A::constant(Rational::zero());
            for (negative, part) in parts {
                let term = evaluate(cx, algebra, part)?;
                algebra.add(cx, &mut sum, *negative, term, part.span)?;
            }
            Ok(sum)
        }
        ExprKind::Product(parts) => product(cx, algebra, parts),
        ExprKind::Power(base, exponent) => power(cx, algebra, base, exponent),
        ExprKind::Call(Name::Rational, arguments) => {
            rational(cx, arguments, expr.span).map(A::constant)
        }
        ExprKind::Call(Name::Irrational, arguments) => {
            square_root(cx, arguments, expr.span).map(A::constant)
        }
        ExprKind::Call(Name::Harmonic, arguments) => match arguments.as_slice() {
            [degree, order] => algebra.harmonic(cx, degree, order),
            _ => {
                let message = "Y(l, m) has a degree and an order, as in Y(2, 0)";
                Err(cx.source.error(expr.span, message))
            }
        },
        ExprKind::Call(name, arguments) => match arguments.as_slice() {
            [argument] => algebra.call(cx, *name, argument, expr.span),
            _ => {
                let at = arguments.get(1).map_or(expr.span, |a| a.span);
                let function = cx.source.slice(expr.span);
                let function = function
                    .split_once('(')
                    .map_or(function, |(name, _)| name)
                    .trim_end();
                let message = format!("{function} has one argument");
                Err(cx.source.error(at, message))
            }
        },
    }
}

/// The value of an expression that must be a constant.
pub(super) fn constant(cx: &mut Context<'_>, expr: &Expr) -> Result<Rational> {
    evaluate(cx, &Constants, expr)
}

fn number(cx: &mut Context<'_>, span: Span) -> Result<Rational> {
    let text = cx.source.slice(span);
    let value = literal(text, cx.numbers).map_err(|message| cx.source.error(span, message))?;
    // A number such as `1e99999` is much longer than its text, so its bits are accounted for.
    let (bits, written) = (value.bits(), 8 * text.len() as u64);
    if bits > written {
        cx.budget.spend_bits(1, bits, cx.source, span)?;
    }
    Ok(value)
}

fn product<A: Algebra>(
    cx: &mut Context<'_>,
    algebra: &A,
    parts: &[(bool, Expr)],
) -> Result<A::Value> {
    let mut result = A::constant(Rational::one());
    for (divides, part) in parts {
        let value = evaluate(cx, algebra, part)?;
        let factor = if *divides {
            match A::to_constant(&value) {
                Some(divisor) => divisor
                    .recip()
                    .map(A::constant)
                    .ok_or_else(|| cx.source.error(part.span, "division by zero"))?,
                None => algebra
                    .reciprocal(value)
                    .ok_or_else(|| cx.source.error(part.span, A::DIVISOR))?,
            }
        } else {
            value
        };
        result = algebra.multiply(cx, result, factor, part.span)?;
    }
    Ok(result)
}

fn power<A: Algebra>(
    cx: &mut Context<'_>,
    algebra: &A,
    base: &Expr,
    exponent: &Expr,
) -> Result<A::Value> {
    let value = evaluate(cx, algebra, base)?;
    let n = constant(cx, exponent)?;
    if !n.is_integer() {
        let message = "an exponent is an integer; instead of a root raise both sides to a power, as in y^2 = x for \
                       y = x^(1/2)";
        return Err(cx.source.error(exponent.span, message));
    }
    if n.abs() > Rational::from(i64::from(MAX_DEGREE)) {
        let limit = format!("an exponent beyond {MAX_DEGREE}");
        return Err(cx.source.limit(exponent.span, limit));
    }
    let magnitude =
        u32::try_from(&n.abs().numerator()).invariant("the exponent is within the limit");
    let negative = n.signum() < 0;
    if let Some(base_value) = A::to_constant(&value) {
        let bits = base_value.bits().saturating_mul(u64::from(magnitude));
        cx.budget.spend_bits(1, bits, cx.source, exponent.span)?;
        let signed = if negative {
            -i64::from(magnitude)
        } else {
            i64::from(magnitude)
        };
        let result = base_value.pow(signed);
        return result.map(A::constant).ok_or_else(|| {
            cx.source
                .error(base.span, "division by zero: a negative power of 0")
        });
    }
    let value = if negative {
        let message =
            "a negative exponent of what is no constant; write a quotient, such as 1/x for x^(-1)";
        let inverse = algebra.reciprocal(value);
        inverse.ok_or_else(|| cx.source.error(exponent.span, message))?
    } else {
        value
    };
    match magnitude {
        0 => Ok(A::constant(Rational::one())),
        1 => Ok(value),
        _ => algebra.power(cx, value, magnitude, base.span.to(exponent.span)),
    }
}

/// `Rational(p, q)`, or `Rational(p)`.
fn rational(cx: &mut Context<'_>, arguments: &[Expr], at: Span) -> Result<Rational> {
    match arguments {
        [p] => constant(cx, p),
        [p, q] => {
            let (numerator, denominator) = (constant(cx, p)?, constant(cx, q)?);
            let inverse = denominator.recip();
            let inverse = inverse.ok_or_else(|| cx.source.error(q.span, "division by zero"))?;
            times(cx, numerator, inverse, at)
        }
        _ => Err(cx
            .source
            .error(at, "Rational has two arguments, as in Rational(1, 3)")),
    }
}

/// `sqrt(q)` for a number q that is the square of a rational number.
fn square_root(cx: &mut Context<'_>, arguments: &[Expr], at: Span) -> Result<Rational> {
    let [argument] = arguments else {
        return Err(cx.source.error(at, "sqrt has one argument"));
    };
    if !argument.is_number() {
        let message = "a square root of an expression is no polynomial; square both sides, as in y^2 = 1 - x^2 for \
                       y = sqrt(1 - x^2), or r^2 = cos(2*t)";
        return Err(cx.source.error(at, message));
    }
    let root = constant(cx, argument)?.sqrt();
    root.ok_or_else(|| {
        let shown = cx.source.quoted(at);
        let message = format!(
            "{shown} is not rational; numbers are exact here: write a fraction or a decimal, or square both sides"
        );
        cx.source.error(at, message)
    })
}

/// a·b, with its bits accounted for.
pub(super) fn times(cx: &mut Context<'_>, a: Rational, b: Rational, at: Span) -> Result<Rational> {
    if is_one(&a) {
        return Ok(b);
    }
    if is_one(&b) {
        return Ok(a);
    }
    cx.budget
        .spend_bits(1, a.bits() + b.bits(), cx.source, at)?;
    Ok(a * b)
}

fn is_one(value: &Rational) -> bool {
    value.bits() == 1 && value.signum() > 0
}

/// The ring of the rational numbers, for exponents and for the arguments of `Rational` and `sqrt`.
struct Constants;

const CONSTANT: &str =
    "expected a number here: an exponent and the arguments of Rational are constants";

impl Algebra for Constants {
    type Value = Rational;

    const DIVISOR: &'static str = CONSTANT;

    fn constant(value: Rational) -> Rational {
        value
    }

    fn to_constant(value: &Rational) -> Option<Rational> {
        Some(value.clone())
    }

    fn name(&self, cx: &mut Context<'_>, _: Name, at: Span) -> Result<Rational> {
        Err(cx.source.error(at, CONSTANT))
    }

    fn call(&self, cx: &mut Context<'_>, _: Name, _: &Expr, at: Span) -> Result<Rational> {
        Err(cx.source.error(at, CONSTANT))
    }

    fn add(
        &self,
        _: &mut Context<'_>,
        sum: &mut Rational,
        negative: bool,
        term: Rational,
        _: Span,
    ) -> Result<()> {
        let before = std::mem::take(sum);
        *sum = if negative {
            before - term
        } else {
            before + term
        };
        Ok(())
    }

    fn multiply(
        &self,
        cx: &mut Context<'_>,
        a: Rational,
        b: Rational,
        at: Span,
    ) -> Result<Rational> {
        times(cx, a, b, at)
    }

    fn power(&self, cx: &mut Context<'_>, _: Rational, _: u32, at: Span) -> Result<Rational> {
        // Every value is constant here, and `power` raises constants itself, so this is never called.
        Err(cx.source.error(at, CONSTANT))
    }
}
