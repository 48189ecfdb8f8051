//! Polar curves whose radius is not a finite Fourier series: `r = 1/(1 + cos(t)/2)`, `r = cos(2t/3)`, `r^2 = cos(2t)`.
//!
//! If the radius is a rational function of cosines and sines of rational multiples of the angle, the curve is the parametric
//! curve (r cos θ, r sin θ). If a power of the radius is given, there is an equation: let r^k Q(θ) = P(θ) with trigonometric
//! polynomials P and Q. Multiplied by a power of r, this is U + rV = 0 with polynomials U and V in x and y. So U² = (x² + y²)
//! V², or U = 0 if V = 0.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Lcm};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial as _;

use super::angle::Angle;
use super::coordinates;
use super::evaluate::{Algebra, Context, constant, evaluate};
use super::fraction::{Fraction, Fractions, RatioAlgebra};
use super::name::Name;
use super::quotient::half_angle;
use super::radius::TrigAlgebra;
use super::source::Span;
use super::syntax::{Equation, Expr, ExprKind};
use crate::error::Result;
use crate::exact::Rational;
use crate::poly::{
    IntegerPolynomial, PlanePolynomial, SparsePolynomial, TrigPolynomial,
    doubled_form_from_harmonics, polynomial_gcd,
};
use crate::roots::real_roots;
use crate::shape::Form;

/// The largest power of the radius, and the largest harmonic in its formula.
const MAX_POWER: u32 = 500;
const MAX_POLAR_HARMONIC: u32 = 60;
/// The largest number of bits of all coefficients of the numerator and the denominator together.
const MAX_POLAR_BITS: u64 = 100_000;

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
        ExprKind::Call(Name::Cos | Name::Sin, arguments) => match arguments.as_slice() {
            [argument] => {
                let angle = Angle::of(cx, argument)?;
                angle.slopes.iter().any(|slope| !slope.is_integer())
            }
            _ => false,
        },
        ExprKind::Call(name, _) => Name::OF_ANGLES.contains(name),
    })
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
    formula: &Expr,
    k: u32,
) -> Result<SparsePolynomial<3>> {
    let fraction = evaluate(cx, &Fractions(TrigAlgebra), formula)?;
    let Fraction { above, below } = fraction;
    let refuse = |message: &str| Err(cx.source.error(formula.span, message));
    if above.len() == 0 {
        return refuse("this is 0: the curve is only the origin");
    }
    let degrees = [&above, &below].map(|f| f.degree().unwrap_or(0));
    let most = degrees[0].max(degrees[1]);
    let numbers = [&above, &below].into_iter().flat_map(|f| f.harmonics());
    let bits: u64 = numbers.map(|(_, [a, b])| a.bits() + b.bits()).sum();
    let limit = if k > MAX_POWER {
        Some(format!("a power of r beyond {MAX_POWER}"))
    } else if most > MAX_POLAR_HARMONIC {
        Some(format!(
            "a harmonic beyond {MAX_POLAR_HARMONIC} beside a power of r"
        ))
    } else if bits > MAX_POLAR_BITS {
        Some(format!(
            "coefficients of more than {MAX_POLAR_BITS} bits beside a power of r"
        ))
    } else {
        None
    };
    if let Some(limit) = limit {
        return Err(cx.source.limit(formula.span, limit));
    }
    let [zeros, poles] = [&above, &below].map(in_half_angle);
    let common = polynomial_gcd(&zeros.polynomial, &poles.polynomial);
    if !real_roots(&common).is_empty() || zeros.at_infinity && poles.at_infinity {
        return refuse(
            "numerator and denominator are 0 at the same angle; divide both by their common factor",
        );
    }
    let scale = common_denominator(&[&above, &below]);
    let top = in_coordinates(&above, &scale, most - degrees[0]);
    let bottom = in_coordinates(&below, &scale, most - degrees[1] + k);
    let [even, odd] = [0, 1].map(|i| &bottom[i] - &top[i]);
    let rho = PlanePolynomial::from_terms([((2, 0), Rational::one()), ((0, 2), Rational::one())]);
    let mut f = if odd.is_zero() {
        even
    } else {
        &(&even * &even) - &(&rho * &(&odd * &odd))
    };
    while let Some(quotient) = divided_by_rho(&f) {
        f = quotient;
    }
    let meets_the_origin = zeros.at_infinity || !real_roots(&zeros.polynomial).is_empty();
    let vanishes_there = f.lowest_degree() != Some(0);
    if vanishes_there && !meets_the_origin {
        let has_poles = poles.at_infinity || !real_roots(&poles.polynomial).is_empty();
        let at_zero = |f: &TrigPolynomial| f.harmonics().map(|(_, [cos, _])| cos.clone()).sum();
        let [p, q]: [Rational; 2] = [&above, &below].map(at_zero);
        let is_negative = !has_poles && p.signum() * q.signum() < 0;
        if is_negative && k.is_multiple_of(2) {
            return refuse("this is negative at every angle, so no r has it as its even power");
        }
        return refuse(
            "this curve does not meet the origin, but every polynomial that is 0 on it is 0 there, too; where that does \
             no harm, give the equation in x and y",
        );
    }
    Ok(SparsePolynomial::from(&f.into_primitive()))
}

/// A trigonometric polynomial P of degree N as a polynomial in s = tan(θ/2): (1 + s²)^N P with integer coefficients, up to a
/// constant factor, and whether P is 0 at θ = π, where s is infinite.
struct InHalfAngle {
    polynomial: IntegerPolynomial,
    at_infinity: bool,
}

fn in_half_angle(f: &TrigPolynomial) -> InHalfAngle {
    let degree = f.degree().unwrap_or(0);
    let scale = common_denominator(&[f]);
    let mut coefficients = vec![Integer::ZERO; 2 * degree as usize + 1];
    for (n, pair) in f.harmonics() {
        for (part, c) in half_angle(n, degree).iter().zip(pair) {
            let factor = (c * &Rational::whole(&scale)).numerator();
            for (power, value) in part {
                coefficients[*power] += value * &factor;
            }
        }
    }
    let at_infinity = coefficients.last().is_some_and(|c| *c == 0);
    InHalfAngle {
        polynomial: IntegerPolynomial::from_coefficients_asc(coefficients),
        at_infinity,
    }
}

fn common_denominator(functions: &[&TrigPolynomial]) -> Integer {
    let numbers = functions.iter().flat_map(|f| f.harmonics());
    numbers
        .flat_map(|(_, pair)| pair)
        .fold(Integer::ONE, |d, c| {
            Integer::from(d.unsigned_abs_ref().lcm(c.denominator_ref()))
        })
}

/// The polynomials [U, V] with U + rV = 2 scale r^(N + more) P, for a trigonometric polynomial P of degree N. `scale` must be a
/// multiple of its denominators.
fn in_coordinates(f: &TrigPolynomial, scale: &Integer, more: u32) -> [PlanePolynomial; 2] {
    let degree = (f.degree().unwrap_or(0) + more) as usize;
    [0, 1].map(|parity| {
        // The harmonics in U have the same parity as the degree. Those in V have the other parity, and the degree of V is lower
        // by one because of the factor r.
        let Some(degree) = degree.checked_sub(parity) else {
            return PlanePolynomial::from_terms([]);
        };
        let harmonics = f.harmonics().filter(|(n, _)| *n as usize % 2 == degree % 2);
        let scaled = |c: &Rational| c.numerator() * scale.div_exact(c.denominator());
        let harmonics: Vec<_> = harmonics
            .map(|(n, [a, b])| (n as usize, scaled(a), scaled(b)))
            .collect();
        let lent = harmonics.iter().map(|(n, a, b)| (*n, a, b));
        std::iter::once(doubled_form_from_harmonics(degree, lent)).collect()
    })
}

/// The quotient f/(x² + y²), if it is a polynomial.
fn divided_by_rho(f: &PlanePolynomial) -> Option<PlanePolynomial> {
    f.parts().map(|part| part.divided_by_rho()).collect()
}

impl RatioAlgebra for TrigAlgebra {
    fn ratio(
        &self,
        cx: &mut Context<'_>,
        name: Name,
        argument: &Expr,
        at: Span,
    ) -> Result<[TrigPolynomial; 2]> {
        let one = TrigPolynomial::constant(Rational::one());
        let cos = self.call(cx, Name::Cos, argument, at)?;
        let sin = self.call(cx, Name::Sin, argument, at)?;
        let [above, below] = match name {
            Name::Cos => [cos, one],
            Name::Sin => [sin, one],
            Name::Tan => [sin, cos],
            Name::Cot => [cos, sin],
            Name::Sec => [one, cos],
            _ => [one, sin],
        };
        if below.len() == 0 {
            return Err(cx.source.error(at, "division by zero: it has a pole here"));
        }
        Ok([above, below])
    }
}
