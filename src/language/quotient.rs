//! The field of rational functions of at most two parameters, or of cosines and sines of their multiples.

use malachite::Integer;
use malachite::base::num::basic::traits::One;

use super::angle::Angle;
use super::evaluate::{Algebra, Context};
use super::expand;
use super::name::Name;
use super::source::Span;
use super::syntax::Expr;
use crate::error::Result;
use crate::exact::Rational;
use crate::poly::{Ring, SparsePolynomial};
use crate::shape::Parameter;

/// The largest multiple of the smallest angle that is read.
pub(super) const MAX_MULTIPLE: u32 = 1000;

/// One parameter of a form, and how the variable s of the rational functions depends on it.
#[derive(Debug)]
pub(super) struct ParameterUse {
    name: Name,
    spelling: String,
    /// For an angle t, the number `step` such that all multiples of t that occur are integer multiples of step·t; `None` for a
    /// number.
    step: Option<Rational>,
}

impl ParameterUse {
    pub(super) fn new(name: Name, spelling: String, step: Option<Rational>) -> Self {
        Self {
            name,
            spelling,
            step,
        }
    }

    pub(super) fn parameter(&self) -> Parameter {
        match &self.step {
            None => Parameter::number(&self.spelling),
            Some(step) => Parameter::angle(&self.spelling, step.clone()),
        }
    }
}

/// Rational functions of s1 and s2. Each of these is a parameter itself, or tan(step·t/2) for an angle t.
pub(super) struct Quotients<'p>(pub(super) &'p [ParameterUse]);

/// The quotient `above / (below · (1 + s1²)^circles[0] · (1 + s2²)^circles[1])`. The third variable does not occur.
#[derive(Clone, Debug)]
pub(super) struct Quotient {
    above: SparsePolynomial<3>,
    below: SparsePolynomial<3>,
    circles: [u32; 2],
}

impl Quotient {
    fn polynomial(above: SparsePolynomial<3>) -> Self {
        Self {
            above,
            below: SparsePolynomial::constant(Rational::one()),
            circles: [0; 2],
        }
    }

    /// The numerator and the denominator, not in lowest terms.
    pub(super) fn over_one_denominator(&self) -> (SparsePolynomial<2>, SparsePolynomial<2>) {
        let [first, second] = [0, 1].map(|v| circle_power(v, self.circles[v]));
        let below = self.below.times(&first.times(&second));
        let two = |f: &SparsePolynomial<3>| {
            SparsePolynomial::from_terms(f.terms().map(|(e, c)| ([e[0], e[1]], c.clone())))
        };
        (two(&self.above), two(&below))
    }
}

/// The polynomial (1 + s²)^k.
fn circle_power(variable: usize, k: u32) -> SparsePolynomial<3> {
    let mut binomial = Integer::ONE;
    SparsePolynomial::from_terms((0..=k).map(|j| {
        let mut exponents = [0; 3];
        exponents[variable] = 2 * j;
        let term = (exponents, Rational::whole(&binomial));
        binomial = std::mem::take(&mut binomial) * Integer::from(k - j) / Integer::from(j + 1);
        term
    }))
}

/// The real and the imaginary part of (1 + is)^(2n), which are (1 + s²)^n times the cosine and the sine of the n-fold angle.
fn multiple_angle(variable: usize, n: u32) -> [SparsePolynomial<3>; 2] {
    let mut parts = [SparsePolynomial::zero(), SparsePolynomial::zero()];
    let mut binomial = Integer::ONE;
    for j in 0..=2 * n {
        let mut exponents = [0; 3];
        exponents[variable] = j;
        let value = Rational::whole(&binomial);
        let signed = if j % 4 >= 2 { -value } else { value };
        parts[(j % 2) as usize].add_term(exponents, signed);
        binomial = std::mem::take(&mut binomial) * Integer::from(2 * n - j) / Integer::from(j + 1);
    }
    parts
}

/// (1 + s²)^degree times the cosine and the sine of the n-fold angle, n ≤ degree, as powers of s with their coefficients.
pub(super) fn half_angle(n: u32, degree: u32) -> [Vec<(usize, Integer)>; 2] {
    let circle = circle_power(0, degree - n);
    multiple_angle(0, n).map(|part| {
        let product = part.times(&circle);
        let terms = product.terms();
        terms.map(|(e, c)| (e[0] as usize, c.numerator())).collect()
    })
}

impl Quotients<'_> {
    /// The cosine and the sine of an angle, both multiplied by ∏ (1 + s²)^circles, and these exponents.
    fn cosine_and_sine(
        &self,
        cx: &mut Context<'_>,
        angle: &Angle,
        at: Span,
    ) -> Result<([SparsePolynomial<3>; 2], [u32; 2])> {
        let Some(quarters) = angle.quarter_turns() else {
            let message = "an angle plus a constant: only multiples of pi/2 may be added, other \
                           constants have cosines that are not rational";
            return Err(cx.source.error(at, message));
        };
        let constant = |value: i64| SparsePolynomial::constant(Rational::from(value));
        let [mut cos, mut sin] = match quarters {
            0 => [constant(1), constant(0)],
            1 => [constant(0), constant(1)],
            2 => [constant(-1), constant(0)],
            _ => [constant(0), constant(-1)],
        };
        let mut circles = [0; 2];
        for (variable, used) in self.0.iter().enumerate() {
            let slope = &angle.slopes[used.name.parameter_index()];
            let Some(multiple) = used.step.as_ref().map(|step| slope / step) else {
                continue;
            };
            let n = u32::try_from(&multiple.abs().numerator()).unwrap_or(u32::MAX);
            if n > MAX_MULTIPLE {
                let limit = format!("a multiple beyond {MAX_MULTIPLE} of the smallest angle");
                return Err(cx.source.limit(at, limit));
            }
            let [c, mut s] = multiple_angle(variable, n);
            if multiple.signum() < 0 {
                s = s.scaled(&Rational::from(-1));
            }
            let mut product = |f: &_, g: &_| expand::product(cx, f, g, at);
            let turned = [
                product(&cos, &c)?.minus(&product(&sin, &s)?),
                product(&sin, &c)?.plus(&product(&cos, &s)?),
            ];
            [cos, sin] = turned;
            circles[variable] = n;
        }
        Ok(([cos, sin], circles))
    }
}

impl Algebra for Quotients<'_> {
    type Value = Quotient;

    const DIVISOR: &'static str = "division by zero";

    fn constant(value: Rational) -> Quotient {
        Quotient::polynomial(SparsePolynomial::constant(value))
    }

    fn to_constant(value: &Quotient) -> Option<Rational> {
        if value.above.is_empty() {
            return Some(Rational::zero());
        }
        if value.circles != [0; 2] {
            return None;
        }
        Some(value.above.as_constant()? * value.below.as_constant()?.recip()?)
    }

    fn name(&self, cx: &mut Context<'_>, name: Name, at: Span) -> Result<Quotient> {
        if let Some(variable) = self.0.iter().position(|used| used.name == name) {
            return Ok(Quotient::polynomial(SparsePolynomial::variable(variable)));
        }
        let shown = cx.source.quoted(at);
        let message = match name {
            Name::Pi => format!("{shown} is not rational; it stands only in angles, as pi/2"),
            _ => format!("{shown} in a coordinate, which is a function of the parameters alone"),
        };
        Err(cx.source.error(at, message))
    }

    fn call(
        &self,
        cx: &mut Context<'_>,
        name: Name,
        argument: &Expr,
        at: Span,
    ) -> Result<Quotient> {
        let angle = Angle::of(cx, argument)?;
        let ([cos, sin], circles) = self.cosine_and_sine(cx, &angle, argument.span)?;
        let unit = || {
            let [first, second] = [0, 1].map(|v| circle_power(v, circles[v]));
            first.times(&second)
        };
        let one = || SparsePolynomial::constant(Rational::one());
        let (above, below, circles) = match name {
            Name::Cos => (cos, one(), circles),
            Name::Sin => (sin, one(), circles),
            Name::Tan => (sin, cos, [0; 2]),
            Name::Cot => (cos, sin, [0; 2]),
            Name::Sec => (unit(), cos, [0; 2]),
            _ => (unit(), sin, [0; 2]),
        };
        if below.is_empty() {
            return Err(cx.source.error(at, "division by zero: it has a pole here"));
        }
        Ok(Quotient {
            above,
            below,
            circles,
        })
    }

    fn reciprocal(&self, value: Quotient) -> Option<Quotient> {
        let [first, second] = [0, 1].map(|v| circle_power(v, value.circles[v]));
        Some(Quotient {
            above: value.below.times(&first.times(&second)),
            below: value.above,
            circles: [0; 2],
        })
    }

    fn add(
        &self,
        cx: &mut Context<'_>,
        sum: &mut Quotient,
        negative: bool,
        mut term: Quotient,
        at: Span,
    ) -> Result<()> {
        if sum.above.is_empty() && !negative {
            *sum = term;
            return Ok(());
        }
        for v in 0..2 {
            let (have, want) = (sum.circles[v], term.circles[v]);
            let (smaller, missing) = if have < want {
                (&mut *sum, want - have)
            } else {
                (&mut term, have - want)
            };
            if missing > 0 {
                let factor = circle_power(v, missing);
                smaller.above = expand::product(cx, &smaller.above, &factor, at)?;
                smaller.circles[v] += missing;
            }
        }
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
        a: Quotient,
        b: Quotient,
        at: Span,
    ) -> Result<Quotient> {
        Ok(Quotient {
            above: expand::product(cx, &a.above, &b.above, at)?,
            below: expand::product(cx, &a.below, &b.below, at)?,
            circles: [0, 1].map(|v| a.circles[v] + b.circles[v]),
        })
    }

    fn power(
        &self,
        cx: &mut Context<'_>,
        base: Quotient,
        exponent: u32,
        at: Span,
    ) -> Result<Quotient> {
        Ok(Quotient {
            above: expand::power(cx, &base.above, exponent, at)?,
            below: expand::power(cx, &base.below, exponent, at)?,
            circles: base.circles.map(|k| k.saturating_mul(exponent)),
        })
    }
}
