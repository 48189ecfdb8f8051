//! Quotients of elements of a ring, and equations between quotients of polynomials in x, y and z: `y = 1/x` is x y − 1 = 0.

use super::evaluate::{Algebra, Context, evaluate};
use super::name::Name;
use super::polynomial::Implicit;
use super::source::Span;
use super::syntax::{Equation, Expr, ExprKind};
use crate::error::Result;
use crate::exact::Rational;
use crate::factor::{coprime_parts, greatest_common_divisor};
use crate::limits::Limits;
use crate::poly::SparsePolynomial;

/// The highest degree of the numerator and of the denominator, and the largest number of terms of both.
const MAX_DEGREE: u64 = 100;
const MAX_FRACTION_TERMS: usize = 10_000;

/// Whether the expression contains a division by something that is not a number.
pub(super) fn divides(expr: &Expr) -> bool {
    let is_divisor = match &expr.kind {
        ExprKind::Product(factors) => {
            let mut factors = factors.iter();
            factors.any(|(divides, part)| *divides && !part.is_number())
        }
        ExprKind::Power(base, exponent) => subtracts(exponent) && !base.is_number(),
        _ => false,
    };
    is_divisor || expr.children().into_iter().any(divides)
}

/// Whether something is subtracted in an exponent, which can only then be negative.
fn subtracts(expr: &Expr) -> bool {
    let has_minus = match &expr.kind {
        ExprKind::Negative(_) => true,
        ExprKind::Sum(parts) => parts.iter().any(|(negative, _)| *negative),
        _ => false,
    };
    has_minus || expr.children().into_iter().any(subtracts)
}

/// The numerator of left − right in lowest terms, without the factors that it still shares with the denominator, because the
/// equation has no meaning where these are 0. The result is 0 exactly where the equation holds, and possibly at points where
/// the denominator is 0.
pub(super) fn numerator(cx: &mut Context<'_>, equation: &Equation) -> Result<SparsePolynomial<3>> {
    let mut difference = evaluate(cx, &Fractions(Implicit), &equation.left)?;
    if let Some(right) = &equation.right {
        let value = evaluate(cx, &Fractions(Implicit), right)?;
        Fractions(Implicit).add(cx, &mut difference, true, value, right.span)?;
    }
    let mut above = difference.above.into_polynomial();
    let below = difference.below.into_polynomial();
    let is_beyond = |f: &SparsePolynomial<3>| f.degree() > Some(MAX_DEGREE);
    let terms = above.len() + below.len();
    if is_beyond(&above) || is_beyond(&below) || terms > MAX_FRACTION_TERMS {
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
        [above, _] = coprime_parts([&above, &common], &limits)?;
    }
    Ok(above)
}

/// A ring over which quotients are formed, with the functions of angles as such quotients.
pub(super) trait RatioAlgebra: Algebra<Value: Clone + PartialEq> {
    /// The numerator and the denominator of a function of an angle in this ring.
    fn ratio(
        &self,
        cx: &mut Context<'_>,
        name: Name,
        argument: &Expr,
        at: Span,
    ) -> Result<[Self::Value; 2]>;
}

impl RatioAlgebra for Implicit {
    /// Always an error, that of [`Algebra::call`], because a polynomial has no angle.
    fn ratio(
        &self,
        cx: &mut Context<'_>,
        name: Name,
        argument: &Expr,
        at: Span,
    ) -> Result<[Self::Value; 2]> {
        let value = self.call(cx, name, argument, at)?;
        Ok([value, Self::constant(Rational::one())])
    }
}

/// The quotients of elements of a ring, not in lowest terms.
pub(super) struct Fractions<A>(pub(super) A);

#[derive(Clone)]
pub(super) struct Fraction<V> {
    pub(super) above: V,
    pub(super) below: V,
}

impl<A: RatioAlgebra> Fractions<A> {
    fn whole(above: A::Value) -> Fraction<A::Value> {
        Fraction {
            above,
            below: A::constant(Rational::one()),
        }
    }
}

impl<A: RatioAlgebra> Algebra for Fractions<A> {
    type Value = Fraction<A::Value>;

    const DIVISOR: &'static str = "division by zero";

    fn constant(value: Rational) -> Self::Value {
        Self::whole(A::constant(value))
    }

    fn to_constant(value: &Self::Value) -> Option<Rational> {
        let above = A::to_constant(&value.above)?;
        if above.is_zero() {
            return Some(above);
        }
        Some(above * A::to_constant(&value.below)?.recip()?)
    }

    fn name(&self, cx: &mut Context<'_>, name: Name, at: Span) -> Result<Self::Value> {
        self.0.name(cx, name, at).map(Self::whole)
    }

    fn call(
        &self,
        cx: &mut Context<'_>,
        name: Name,
        argument: &Expr,
        at: Span,
    ) -> Result<Self::Value> {
        let [above, below] = self.0.ratio(cx, name, argument, at)?;
        Ok(Fraction { above, below })
    }

    fn reciprocal(&self, value: Self::Value) -> Option<Self::Value> {
        Some(Fraction {
            above: value.below,
            below: value.above,
        })
    }

    fn add(
        &self,
        cx: &mut Context<'_>,
        sum: &mut Self::Value,
        negative: bool,
        mut term: Self::Value,
        at: Span,
    ) -> Result<()> {
        if sum.below != term.below {
            let (left, right) = (sum.below.clone(), term.below);
            term.above = self.0.multiply(cx, term.above, left.clone(), at)?;
            sum.above = self.0.multiply(cx, sum.above.clone(), right.clone(), at)?;
            sum.below = self.0.multiply(cx, left, right, at)?;
        }
        self.0.add(cx, &mut sum.above, negative, term.above, at)
    }

    fn multiply(
        &self,
        cx: &mut Context<'_>,
        a: Self::Value,
        b: Self::Value,
        at: Span,
    ) -> Result<Self::Value> {
        Ok(Fraction {
            above: self.0.multiply(cx, a.above, b.above, at)?,
            below: self.0.multiply(cx, a.below, b.below, at)?,
        })
    }

    fn power(
        &self,
        cx: &mut Context<'_>,
        base: Self::Value,
        exponent: u32,
        at: Span,
    ) -> Result<Self::Value> {
        Ok(Fraction {
            above: self.0.power(cx, base.above, exponent, at)?,
            below: self.0.power(cx, base.below, exponent, at)?,
        })
    }
}
