//! Polar curves by a power of the radius with integer multiples of the angle: `r^2 = cos(2t)`.
//!
//! Let r^k Q(θ) = P(θ) with trigonometric polynomials P and Q. Multiplied by a power of r, this is U + rV = 0 with polynomials U and
//! V in x and y. So U² = (x² + y²) V², or U = 0 if V = 0.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Lcm};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial as _;

use super::evaluate::{Algebra, Context, evaluate};
use super::fraction::{Fraction, Fractions, RatioAlgebra};
use super::name::Name;
use super::polar_equation::{PolarEquation, divided_by_rho, rho};
use super::quotient::half_angle;
use super::radius::TrigAlgebra;
use super::source::Span;
use super::syntax::Expr;
use crate::error::Result;
use crate::exact::Rational;
use crate::poly::{
    IntegerPolynomial, PlanePolynomial, TrigPolynomial, doubled_form_from_harmonics, polynomial_gcd,
};
use crate::roots::real_roots;

/// The largest harmonic in the formula.
const MAX_POLAR_HARMONIC: u32 = 60;
/// The largest number of bits of all coefficients of the numerator and the denominator together.
const MAX_POLAR_BITS: u64 = 100_000;

/// The equation of `r^k = formula`.
///
/// # Errors
/// Those of the formula; [`crate::error::Error::Limit`] beyond the limits above.
pub(super) fn equation(cx: &mut Context<'_>, formula: &Expr, k: u32) -> Result<PolarEquation> {
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
    let limit = if most > MAX_POLAR_HARMONIC {
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
    let mut f = if odd.is_zero() {
        even
    } else {
        &(&even * &even) - &(&rho() * &(&odd * &odd))
    };
    while let Some(quotient) = divided_by_rho(&f) {
        f = quotient;
    }
    let has_zero = |f: &InHalfAngle| f.at_infinity || !real_roots(&f.polynomial).is_empty();
    let at_zero = |f: &TrigPolynomial| f.harmonics().map(|(_, [cos, _])| cos.clone()).sum();
    let [p, q]: [Rational; 2] = [&above, &below].map(at_zero);
    Ok(PolarEquation {
        polynomial: f,
        has_zero: has_zero(&zeros),
        has_pole: has_zero(&poles),
        sign: p.signum() * q.signum(),
    })
}

/// A trigonometric polynomial P of degree N as a polynomial in s = tan(θ/2): (1 + s²)^N P with integer coefficients, up to a
/// constant factor, and whether P is 0 at θ = π, where s is infinite.
struct InHalfAngle {
    polynomial: IntegerPolynomial,
    at_infinity: bool,
}

fn in_half_angle(f: &TrigPolynomial) -> InHalfAngle {
    let degree = f.degree().unwrap_or(0);
    let scale = f.common_denominator();
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
    let all = functions.iter().map(|f| f.common_denominator());
    all.fold(Integer::ONE, |d, e| {
        Integer::from(d.unsigned_abs_ref().lcm(e.unsigned_abs_ref()))
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
