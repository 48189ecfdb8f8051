//! The right sides of `R = …` that are polynomials on the unit sphere: sums of spherical harmonics.

use super::angle::Angle;
use super::evaluate::{Algebra, Context, constant, evaluate, multiplied};
use super::name::{Name, PARAMETERS};
use super::number::written_center;
use super::radius::{not_a_series, not_rational};
use super::source::Span;
use super::syntax::{Equation, Expr};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::poly::{NotOnSphere, SphericalPolynomial};
use crate::shape::{Form, HarmonicSurface, MAX_HARMONIC_DEGREE};

/// The harmonic surface of an equation `R = …`, with the center if a comment gives one.
pub(super) fn surface(
    cx: &mut Context<'_>,
    equations: &[Equation],
    center: Option<Span>,
) -> Result<Form> {
    let first = |name| equations.iter().find_map(|e| e.names.first(name));
    if first(Name::SpaceRadius).is_none() {
        let message = "Y(l, m) is a spherical harmonic, which stands on the right of R = …, as in R = 1 + Y(2,0)/5; \
                       a multiple of the coordinate y is written 2*y";
        let at = first(Name::Harmonic).invariant("R or a harmonic occurs");
        return Err(cx.source.error(at, message));
    }
    let [equation] = equations else {
        let second = equations.get(1).map(|second| second.left.span);
        let message = "a second equation: R = … is a surface by itself";
        return Err(cx
            .source
            .error(second.invariant("there are several equations"), message));
    };
    let formula = match &equation.right {
        Some(right) if equation.left.is_name(Name::SpaceRadius) => right,
        _ => {
            let at = first(Name::SpaceRadius);
            let message = "R is the radius of a surface and stands alone on the left, as in R = 1 + Y(2,0)/5; \
                           the radius of a plane curve is r";
            return Err(cx.source.error(at.invariant("R occurs"), message));
        }
    };
    if let Some(at) = equation.names.first(Name::T) {
        let message = "the angles of R are theta and phi; the radius of a plane curve is r, as in r = 1 + cos(t)/3";
        return Err(cx.source.error(at, message));
    }
    let value = evaluate(cx, &SphereAlgebra, formula)?;
    let terms = value
        .harmonics()
        .map_err(|refused| cx.source.error(formula.span, reason(refused)))?;
    let terms = terms.into_iter().map(|(l, m, c)| {
        let m = isize::try_from(m).invariant("an order fits in a word");
        ((l as usize, m), c)
    });
    let surface = HarmonicSurface::new(terms)?;
    Ok(Form::Harmonic(match center {
        None => surface,
        Some(at) => {
            let numbers = cx.numbers;
            let center = written_center(cx.source.slice(at), numbers);
            let center = center.and_then(|center| Ok(center.in_space()?));
            surface.with_center(center.map_err(|message| cx.source.error(at, message))?)
        }
    }))
}

fn reason(NotOnSphere { m, sine }: NotOnSphere) -> String {
    let part = match (m, sine) {
        (0, _) => "the part without theta is no polynomial in cos(phi)".to_owned(),
        (1, _) => format!(
            "the part with {}(theta) is not sin(phi) times a polynomial in cos(phi)",
            if sine { "sin" } else { "cos" }
        ),
        _ => format!(
            "the part with {}({m}*theta) is not sin(phi)^{m} times a polynomial in cos(phi)",
            if sine { "sin" } else { "cos" }
        ),
    };
    format!(
        "R is not a polynomial on the sphere, that is, in sin(phi)*cos(theta), sin(phi)*sin(theta) and cos(phi): {part}"
    )
}

/// The ring of polynomials in the cosines and sines of the two angles.
struct SphereAlgebra;

impl Algebra for SphereAlgebra {
    type Value = SphericalPolynomial;

    const DIVISOR: &'static str =
        "division by a function of the angles is no polynomial on the sphere; divide by constants";

    fn constant(value: Rational) -> SphericalPolynomial {
        SphericalPolynomial::constant(value)
    }

    fn to_constant(value: &SphericalPolynomial) -> Option<Rational> {
        value.as_constant()
    }

    fn name(&self, cx: &mut Context<'_>, name: Name, at: Span) -> Result<SphericalPolynomial> {
        let shown = cx.source.quoted(at);
        let message = match name {
            _ if name.is_parameter() => {
                format!(
                    "the angle {shown} outside cos( ) and sin( ) is no polynomial on the sphere"
                )
            }
            Name::Pi => not_rational(shown),
            Name::SpaceRadius => "R stands only on the left of `R = …`".into(),
            Name::Y => "Y(l, m) has a degree and an order, as in Y(2, 0)".into(),
            _ => format!("{shown} in a radius R, whose variables are the angles theta and phi"),
        };
        Err(cx.source.error(at, message))
    }

    fn call(
        &self,
        cx: &mut Context<'_>,
        name: Name,
        argument: &Expr,
        at: Span,
    ) -> Result<SphericalPolynomial> {
        if !matches!(name, Name::Cos | Name::Sin) {
            return Err(cx.source.error(at, not_a_series(cx.source.slice(at))));
        }
        let angle = Angle::of(cx, argument)?;
        let wrong = "the argument of cos and sin in a radius R is a sum of integer multiples of theta and phi, \
                     as in cos(2*theta)";
        let mut slopes = [0; 2];
        for (name, slope) in PARAMETERS.iter().zip(&angle.slopes) {
            let place = [Name::Theta, Name::Phi].iter().position(|n| n == name);
            if slope.is_zero() {
                continue;
            }
            let Some(place) = place.filter(|_| slope.is_integer()) else {
                return Err(cx.source.error(argument.span, wrong));
            };
            let limit = Rational::from(2 * MAX_HARMONIC_DEGREE as i64);
            if slope.abs() > limit {
                let limit = format!("a multiple of an angle beyond {limit}");
                return Err(cx.source.limit(argument.span, limit));
            }
            let slope = i32::try_from(&slope.numerator());
            slopes[place] = slope.invariant("the slope is within the limit");
        }
        let phase = angle.phase(name);
        let (sine, sign) = phase.ok_or_else(|| cx.source.error(argument.span, wrong))?;
        let [theta, phi] = slopes;
        // cos(a + b) = cos a cos b − sin a sin b, and sin(a + b) = sin a cos b + cos a sin b
        let product = |first: bool, second: bool| {
            SphericalPolynomial::of_theta(theta, first)
                .times(&SphericalPolynomial::of_phi(phi, second))
        };
        let mut sum = product(sine, false);
        let second = if sine { 1 } else { -1 };
        sum.add_multiple(&product(!sine, true), &Rational::from(second));
        Ok(sum.scaled(&Rational::from(sign)))
    }

    fn harmonic(
        &self,
        cx: &mut Context<'_>,
        degree: &Expr,
        order: &Expr,
    ) -> Result<SphericalPolynomial> {
        let mut index = |expr: &Expr, limit: usize, message: String| -> Result<i32> {
            let value = constant(cx, expr)?;
            let small = i32::try_from(&value.numerator());
            let small = small.ok().filter(|_| value.is_integer());
            let within = small.filter(|n| n.unsigned_abs() as usize <= limit);
            within.ok_or_else(|| cx.source.error(expr.span, message))
        };
        let message =
            format!("the degree l of Y(l, m) is an integer from 0 to {MAX_HARMONIC_DEGREE}");
        let l = index(degree, MAX_HARMONIC_DEGREE, message.clone())?;
        let Ok(l) = u32::try_from(l) else {
            return Err(cx.source.error(degree.span, message));
        };
        let message = format!("the order m of Y({l}, m) is an integer from -{l} to {l}");
        let m = index(order, l as usize, message)?;
        Ok(SphericalPolynomial::harmonic(l, m))
    }

    fn add(
        &self,
        _: &mut Context<'_>,
        sum: &mut SphericalPolynomial,
        negative: bool,
        term: SphericalPolynomial,
        _: Span,
    ) -> Result<()> {
        let sign = if negative { -1 } else { 1 };
        sum.add_multiple(&term, &Rational::from(sign));
        Ok(())
    }

    fn multiply(
        &self,
        cx: &mut Context<'_>,
        a: SphericalPolynomial,
        b: SphericalPolynomial,
        at: Span,
    ) -> Result<SphericalPolynomial> {
        multiplied::<Self>(cx, [a, b], at, scaled, product)
    }

    fn power(
        &self,
        cx: &mut Context<'_>,
        base: SphericalPolynomial,
        exponent: u32,
        at: Span,
    ) -> Result<SphericalPolynomial> {
        let mut result = Self::constant(Rational::one());
        for _ in 0..exponent {
            result = product(cx, &result, &base, at)?;
        }
        Ok(result)
    }
}

fn scaled(
    cx: &mut Context<'_>,
    f: &SphericalPolynomial,
    factor: &Rational,
    at: Span,
) -> Result<SphericalPolynomial> {
    let (count, bits) = (f.len() as u64, f.bits() + factor.bits());
    cx.budget.spend_products(count, bits, cx.source, at)?;
    Ok(f.scaled(factor))
}

fn product(
    cx: &mut Context<'_>,
    a: &SphericalPolynomial,
    b: &SphericalPolynomial,
    at: Span,
) -> Result<SphericalPolynomial> {
    account(cx, a, b, at)?;
    Ok(a.times(b))
}

/// Accounts for a product and checks its degrees, before it is computed.
fn account(
    cx: &mut Context<'_>,
    a: &SphericalPolynomial,
    b: &SphericalPolynomial,
    at: Span,
) -> Result<()> {
    let [of_theta, of_phi] = [0, 1].map(|k| a.degrees()[k] + b.degrees()[k]);
    if of_theta.max(of_phi) > 2 * MAX_HARMONIC_DEGREE {
        let limit = format!(
            "a product with multiples of an angle beyond {}",
            2 * MAX_HARMONIC_DEGREE
        );
        return Err(cx.source.limit(at, limit));
    }
    let count = (a.len() as u64).saturating_mul(b.len() as u64);
    let bits = a.bits() + b.bits();
    cx.budget.spend_products(2 * count, bits, cx.source, at)
}

#[cfg(test)]
mod tests {
    use crate::language::{Numbers, parse_form};
    use crate::shape::{Form, HarmonicSurface};

    fn read(text: &str) -> HarmonicSurface {
        match parse_form(text, "<form>", Numbers::Exact) {
            Ok(Form::Harmonic(surface)) => surface,
            other => panic!("{text}: {other:?}"),
        }
    }

    fn terms(text: &str) -> Vec<(usize, isize, String)> {
        let surface = read(text);
        let terms = surface.terms();
        terms.map(|(l, m, c)| (l, m, c.to_string())).collect()
    }

    #[test]
    fn harmonics_are_read_exactly() {
        assert_eq!(
            terms("R = 10 + Y(2,0)/3 - 0.1*Y(3,-2)"),
            [
                (0, 0, "10".into()),
                (2, 0, "1/3".into()),
                (3, -2, "-1/10".into())
            ]
        );
        assert_eq!(
            terms("R = 1 + sin(phi)^2*cos(2*theta)/5"),
            [(0, 0, "1".into()), (2, 2, "1/15".into())]
        );
        // cos² φ = (1 + 2 P_2)/3
        assert_eq!(
            terms("R(theta, phi) = cos(phi)^2"),
            [(0, 0, "1/3".into()), (2, 0, "2/3".into())]
        );
        assert_eq!(terms("R = Y(1,0)*Y(1,0)"), terms("R = cos(phi)^2"));
        assert_eq!(terms("R = Y(1, 1)^2 + Y(1, -1)^2"), terms("R = sin(φ)^2"));
        assert_eq!(
            terms("R = cos(theta + phi) - cos(theta)*cos(phi)"),
            [(1, -1, "-1".into())]
        );
        assert_eq!(terms("3 + cos(phi) = R"), terms("R = 3 + Y(1,0)"));
        assert_eq!(
            read("# center: 1, 2, -1/2\nR = 2").center()[2].to_string(),
            "-1/2"
        );
    }

    #[test]
    fn what_is_no_sum_of_harmonics_is_refused_with_the_reason() {
        for (text, part) in [
            (
                "R = 1 + sin(phi)",
                "the part without theta is no polynomial in cos(phi)",
            ),
            (
                "R = 1 + sin(phi)*cos(2*theta)",
                "cos(2*theta) is not sin(phi)^2 times",
            ),
            (
                "R = 1 + cos(theta)",
                "the part with cos(theta) is not sin(phi) times",
            ),
            ("R = 1 + Y(2,3)", "from -2 to 2"),
            ("R = Y(1/2, 0)", "the degree l"),
            ("R = Y(2)", "a degree and an order"),
            ("R = 1 + cos(t)", "are theta and phi"),
            ("R = 1/(2 + cos(phi))", "divide by constants"),
            ("R = 1 + theta", "outside cos"),
            ("R^2 = 1 + cos(phi)", "stands alone on the left"),
            ("R = 1; x = 2", "a second equation"),
            ("# center: 1, 2\nR = 2", "a center of two coordinates"),
            ("R = tan(phi)", "tan"),
        ] {
            let error = parse_form(text, "<form>", Numbers::Exact).expect_err(text);
            assert!(error.to_string().contains(part), "{text}: {error}");
        }
    }
}
