//! Arguments of cos and sin: sums of rational multiples of the parameters, rational multiples of π, and rational numbers.

use super::evaluate::{Algebra, Context, evaluate, times};
use super::name::{Name, PARAMETERS};
use super::source::Span;
use super::syntax::Expr;
use crate::error::Result;
use crate::exact::Rational;

pub(super) const ARGUMENT: &str = "the argument of cos and sin is an integer multiple of the angle, as in cos(3*t); the angle is t or theta";

/// The angle `Σ slope·parameter + half_turns·π + offset`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Angle {
    /// The slopes in the order of [`PARAMETERS`].
    pub(super) slopes: [Rational; PARAMETERS.len()],
    half_turns: Rational,
    offset: Rational,
}

impl Angle {
    /// The angle that an argument of a function of angles gives.
    pub(super) fn of(cx: &mut Context<'_>, argument: &Expr) -> Result<Self> {
        evaluate(cx, &Angles, argument)
    }

    fn constant(offset: Rational) -> Self {
        Self {
            slopes: std::array::from_fn(|_| Rational::zero()),
            half_turns: Rational::zero(),
            offset,
        }
    }

    /// The number of right angles that are added to the multiples of the parameters, modulo 4. `None` if something else is
    /// added: then its cosine and its sine are not both rational, by Niven's theorem for a rational multiple of π, and because
    /// e^(i·offset) is transcendental for an offset other than 0 (Lindemann).
    pub(super) fn quarter_turns(&self) -> Option<u8> {
        let quarters = &self.half_turns * Rational::from(2);
        if !self.offset.is_zero() || !quarters.is_integer() {
            return None;
        }
        let four = Rational::from(4);
        let rounds = (&quarters / &four).floor();
        u8::try_from(&(quarters - rounds * four).numerator()).ok()
    }

    /// Writes cos or sin of the angle as ± cos or sin of the multiples of the parameters: whether it is a sine, and the sign. `None` as
    /// for [`Angle::quarter_turns`].
    pub(super) fn phase(&self, name: Name) -> Option<(bool, i32)> {
        // sin a = cos(a − π/2)
        let quarters = self.quarter_turns()? + if name == Name::Cos { 0 } else { 3 };
        Some(match quarters % 4 {
            0 => (false, 1),
            1 => (true, -1),
            2 => (false, -1),
            _ => (true, 1),
        })
    }

    fn parts(self) -> impl Iterator<Item = Rational> {
        self.slopes
            .into_iter()
            .chain([self.half_turns, self.offset])
    }

    fn parts_mut(&mut self) -> impl Iterator<Item = &mut Rational> {
        let added = [&mut self.half_turns, &mut self.offset];
        self.slopes.iter_mut().chain(added)
    }
}

/// The linear functions of the parameters and π.
struct Angles;

impl Algebra for Angles {
    type Value = Angle;

    const DIVISOR: &'static str = ARGUMENT;

    fn constant(value: Rational) -> Angle {
        Angle::constant(value)
    }

    fn to_constant(value: &Angle) -> Option<Rational> {
        let varies = value.slopes.iter().any(|s| !s.is_zero()) || !value.half_turns.is_zero();
        (!varies).then(|| value.offset.clone())
    }

    fn name(&self, cx: &mut Context<'_>, name: Name, at: Span) -> Result<Angle> {
        let mut value = Angle::constant(Rational::zero());
        match PARAMETERS.iter().position(|&p| p == name) {
            Some(index) => value.slopes[index] = Rational::one(),
            None if name == Name::Pi => value.half_turns = Rational::one(),
            None => return Err(cx.source.error(at, ARGUMENT)),
        }
        Ok(value)
    }

    fn call(&self, cx: &mut Context<'_>, _: Name, _: &Expr, at: Span) -> Result<Angle> {
        Err(cx.source.error(at, ARGUMENT))
    }

    fn add(
        &self,
        _: &mut Context<'_>,
        sum: &mut Angle,
        negative: bool,
        term: Angle,
        _: Span,
    ) -> Result<()> {
        for (part, other) in sum.parts_mut().zip(term.parts()) {
            let before = std::mem::take(part);
            *part = if negative {
                before - other
            } else {
                before + other
            };
        }
        Ok(())
    }

    fn multiply(&self, cx: &mut Context<'_>, a: Angle, b: Angle, at: Span) -> Result<Angle> {
        let (mut angle, factor) = match (Self::to_constant(&a), Self::to_constant(&b)) {
            (_, Some(factor)) => (a, factor),
            (Some(factor), None) => (b, factor),
            (None, None) => {
                let has_pi = [&a, &b].iter().any(|angle| !angle.half_turns.is_zero());
                let message = match has_pi {
                    true => {
                        "pi times the parameter is no rational multiple of it; where every angle has the factor pi leave it out: cos(2*t) for cos(2*pi*t) is the same curve"
                    }
                    false => ARGUMENT,
                };
                return Err(cx.source.error(at, message));
            }
        };
        for part in angle.parts_mut() {
            *part = times(cx, std::mem::take(part), factor.clone(), at)?;
        }
        Ok(angle)
    }

    fn power(&self, cx: &mut Context<'_>, _: Angle, _: u32, at: Span) -> Result<Angle> {
        Err(cx.source.error(at, ARGUMENT))
    }
}
