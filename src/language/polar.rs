//! Polar curves whose radius is not a finite Fourier series: `r = 1/(1 + cos(t)/2)`, `r = cos(2t/3)`, `r^2 = cos(2t)`.
//!
//! If the radius is a rational function of cosines and sines of rational multiples of the angle, the curve is the parametric
//! curve (r cos θ, r sin θ). If a power of the radius is given, there is an equation, which the origin may satisfy although the
//! radius is never 0.

use super::angle::Angle;
use super::evaluate::{Context, constant};
use super::name::Name;
use super::syntax::{Equation, Expr, ExprKind};
use super::{coordinates, divided_angle, whole_angle};
use crate::error::Result;
use crate::poly::SparsePolynomial;
use crate::shape::Form;

/// The largest power of the radius.
const MAX_POWER: u32 = 500;

/// The exponent k if the left side of an equation is r^k; `None` if it is anything else.
pub(super) fn power_of_radius(cx: &mut Context<'_>, left: &Expr) -> Result<Option<u32>> {
    match &left.kind {
        ExprKind::Name(Name::R) => Ok(Some(1)),
        ExprKind::Power(base, exponent) if base.is_name(Name::R) => {
            let value = constant(cx, exponent)?;
            let k = u32::try_from(&value.numerator()).ok();
            match k.filter(|k| *k > 0 && value.is_integer()) {
                Some(k) => Ok(Some(k)),
                None => {
                    let message = "a power of the radius has a natural exponent, as r^2";
                    Err(cx.source.error(exponent.span, message))
                }
            }
        }
        _ => Ok(None),
    }
}

/// Whether the formula contains something that no finite Fourier series has: a quotient by a function of the angle, a function
/// of the angle other than cos and sin, or a multiple of the angle that is not an integer.
pub(super) fn is_beyond_series(cx: &mut Context<'_>, formula: &Expr) -> Result<bool> {
    Ok(match &formula.kind {
        ExprKind::Number | ExprKind::Integer(_) | ExprKind::Name(_) => false,
        ExprKind::Negative(inner) => is_beyond_series(cx, inner)?,
        ExprKind::Sum(parts) => any(cx, parts.iter().map(|(_, part)| part))?,
        ExprKind::Product(parts) => {
            let divides = parts.iter().any(|(divides, part)| *divides && varies(part));
            divides || any(cx, parts.iter().map(|(_, part)| part))?
        }
        ExprKind::Power(base, exponent) => {
            let is_inverse = varies(base) && constant(cx, exponent)?.signum() < 0;
            is_inverse || is_beyond_series(cx, base)?
        }
        ExprKind::Call(Name::Cos | Name::Sin, _) => divides_the_angle(cx, formula)?,
        ExprKind::Call(name, _) => Name::OF_ANGLES.contains(name),
    })
}

/// Whether a multiple of the angle occurs that is not an integer.
fn divides_the_angle(cx: &mut Context<'_>, formula: &Expr) -> Result<bool> {
    if let (ExprKind::Call(name, _), [argument]) = (&formula.kind, &formula.children()[..])
        && Name::OF_ANGLES.contains(name)
    {
        let angle = Angle::of(cx, argument)?;
        return Ok(angle.slopes.iter().any(|slope| !slope.is_integer()));
    }
    for part in formula.children() {
        if divides_the_angle(cx, part)? {
            return Ok(true);
        }
    }
    Ok(false)
}

fn any<'e>(cx: &mut Context<'_>, parts: impl Iterator<Item = &'e Expr>) -> Result<bool> {
    for part in parts {
        if is_beyond_series(cx, part)? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Whether a parameter occurs in the expression.
fn varies(expr: &Expr) -> bool {
    expr.mentions(Name::is_parameter)
}

/// `r = formula` as the parametric curve (r cos θ, r sin θ).
pub(super) fn curve(
    cx: &mut Context<'_>,
    equations: &[Equation],
    formula: &Expr,
    angle: Name,
) -> Result<Form> {
    let at = formula.span;
    let times = |function| {
        let expr = |kind| Expr { kind, span: at };
        let argument = vec![expr(ExprKind::Name(angle))];
        let factor = expr(ExprKind::Call(function, argument));
        expr(ExprKind::Product(vec![
            (false, formula.clone()),
            (false, factor),
        ]))
    };
    let [x, y] = [Name::Cos, Name::Sin].map(times);
    coordinates::of_formulas(cx, equations, [Some(&x), Some(&y), None])
}

/// `r^k = formula` as an equation.
pub(super) fn equation(
    cx: &mut Context<'_>,
    equations: &[Equation],
    formula: &Expr,
    k: u32,
    angle: Name,
) -> Result<SparsePolynomial<3>> {
    if k > MAX_POWER {
        let limit = format!("a power of r beyond {MAX_POWER}");
        return Err(cx.source.limit(formula.span, limit));
    }
    let found = if divides_the_angle(cx, formula)? {
        divided_angle::equation(cx, equations, formula, k, angle)?
    } else {
        whole_angle::equation(cx, formula, k)?
    };
    if !found.has_zero && !found.has_pole && found.sign < 0 && k.is_multiple_of(2) {
        let message = "this is negative at every angle, so no r has it as its even power";
        return Err(cx.source.error(formula.span, message));
    }
    // Where the radius is never 0, the equation may have the origin besides, as an isolated point.
    cx.adds_origin = !found.has_zero && found.polynomial.lowest_degree() != Some(0);
    Ok(SparsePolynomial::from(&found.polynomial.into_primitive()))
}
