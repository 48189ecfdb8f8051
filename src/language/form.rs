//! Decides which kind of form the equations of a text give, and builds it.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Lcm};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial as _;

use super::UNDERSTOOD;
use super::budget::{MAX_BITS, MAX_COEFFICIENTS, MAX_TERMS};
use super::coordinates;
use super::evaluate::{Algebra, Context, evaluate};
use super::fraction;
use super::name::{Name, PARAMETERS};
use super::number::WrittenCenter;
use super::polar;
use super::polynomial::Implicit;
use super::radius::TrigAlgebra;
use super::source::Span;
use super::syntax::{Equation, Expr};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::poly::{BinaryForm, IntegerPolynomial, PlanePolynomial, SparsePolynomial, total_degree};
use crate::shape::{Form, FourierRadius, ImplicitCurve, ImplicitSurface};

/// The error for a center of another form.
const CENTERED: &str = "a center belongs to an equation of a curve or a surface, a Fourier radius or a harmonic surface";

/// The form that the equations give, with the given center if there is one.
pub(super) fn form(
    cx: &mut Context<'_>,
    equations: &[Equation],
    center: Option<(Span, WrittenCenter)>,
) -> Result<Form> {
    let Some(equation) = equations.first() else {
        let end = u32::try_from(cx.source.text.len()).invariant("a text is shorter than 4 GiB");
        let at = Span { start: end, end };
        return Err(cx
            .source
            .error(at, format!("there is no equation; {UNDERSTOOD}")));
    };
    if coordinates::are_parametric(equations) {
        if let Some((at, _)) = center {
            let message = CENTERED;
            return Err(cx.source.error(at, message));
        }
        return coordinates::parametric(cx, equations);
    }
    if equations.len() == 3 && coordinates::are_coordinates(equations) {
        return Err(coordinates::a_point(cx, equations));
    }
    let in_space = |e: &Equation| e.names.first(Name::Z).is_some();
    if equations.len() > 1 && equations.iter().any(in_space) {
        return intersection(cx, equations, center);
    }
    if equations.len() > 1 && coordinates::are_coordinates(equations) {
        return Err(coordinates::a_point(cx, equations));
    }
    if let Some(second) = equations.get(1) {
        let message = "a second equation: two equations in x and y have common points and no curve; plot takes several forms, \
                       and with z they are an intersection of surfaces";
        return Err(cx.source.error(second.left.span, message));
    }
    let polynomial = match radius_formula(cx, equation)? {
        None => difference(cx, equation)?,
        Some((k, formula)) => {
            let angle = angle(cx, equation)?;
            if k > 1 {
                polar::equation(cx, equations, formula, k, angle)?
            } else if polar::is_beyond_series(cx, formula)? {
                if let Some((at, _)) = center {
                    let message = CENTERED;
                    return Err(cx.source.error(at, message));
                }
                return polar::curve(cx, equations, formula, angle);
            } else {
                let (cos, sin) = evaluate(cx, &TrigAlgebra, formula)?.coefficients();
                let radius = FourierRadius::new(cos, sin);
                return Ok(Form::Fourier(match center {
                    Some((at, center)) => {
                        let center = center.in_plane();
                        radius.with_center(center.map_err(|message| cx.source.error(at, message))?)
                    }
                    None => radius,
                }));
            }
        }
    };
    let in_space = equation.names.first(Name::Z).is_some();
    implicit(
        polynomial,
        in_space,
        center,
        cx.source.name,
        |at, message| cx.source.error(at, message),
    )
}

/// The polynomial left − right, or its numerator; it is an error if it is constant.
fn difference(cx: &mut Context<'_>, equation: &Equation) -> Result<SparsePolynomial<3>> {
    let sides = || {
        [Some(&equation.left), equation.right.as_ref()]
            .into_iter()
            .flatten()
    };
    let polynomial = if sides().any(fraction::divides) {
        fraction::numerator(cx, equation)?
    } else {
        let mut difference = evaluate(cx, &Implicit, &equation.left)?;
        if let Some(right) = &equation.right {
            let value = evaluate(cx, &Implicit, right)?;
            Implicit.add(cx, &mut difference, true, value, right.span)?;
        }
        difference.into_polynomial()
    };
    match polynomial.as_constant() {
        Some(value) => Err(cx
            .source
            .error(equation.left.span, constant_message(&value))),
        None => Ok(polynomial),
    }
}

/// The common points of several surfaces.
fn intersection(
    cx: &mut Context<'_>,
    equations: &[Equation],
    center: Option<(Span, WrittenCenter)>,
) -> Result<Form> {
    if let Some((at, _)) = center {
        let message =
            "a center belongs to one curve or surface, this is an intersection of surfaces";
        return Err(cx.source.error(at, message));
    }
    let mut surfaces = Vec::new();
    for equation in equations {
        let polynomial = difference(cx, equation)?;
        surfaces.push(implicit_surface(polynomial, None, cx.source.name)?);
    }
    Ok(Form::Intersection(surfaces))
}

/// The message for an equation whose polynomial is constant.
pub(crate) fn constant_message(value: &Rational) -> &'static str {
    if value.is_zero() {
        "the equation is 0 = 0: every point satisfies it, so it describes no curve"
    } else {
        "the equation is a constant = 0: no point satisfies it, so it describes no curve"
    }
}

/// The exponent k and the formula of r^k, if the equation gives it: the formula is the right side of `r = …` or `r^k = …`, or a
/// single expression in the angle.
fn radius_formula<'e>(
    cx: &mut Context<'_>,
    equation: &'e Equation,
) -> Result<Option<(u32, &'e Expr)>> {
    let names = &equation.names;
    if let Some(k) = polar::power_of_radius(cx, &equation.left)? {
        return match &equation.right {
            Some(formula) => Ok(Some((k, formula))),
            None => Err(cx
                .source
                .error(equation.left.span, "expected `= …` after r")),
        };
    }
    let of_the_angle = names.any(&[Name::T, Name::Theta, Name::Cos, Name::Sin]);
    let of_a_point = names.any(&[Name::X, Name::Y, Name::Z, Name::R]);
    let is_alone = equation.right.is_none() && of_the_angle && !of_a_point;
    Ok(is_alone.then_some((1, &equation.left)))
}

/// The name of the angle, which is the parameter that occurs.
fn angle(cx: &Context<'_>, equation: &Equation) -> Result<Name> {
    let named = |name| equation.names.first(name).map(|at| (at.start, name, at));
    let mut angles: Vec<_> = PARAMETERS.into_iter().filter_map(named).collect();
    angles.sort_unstable_by_key(|(start, ..)| *start);
    match angles[..] {
        [] => Ok(Name::T),
        [(_, name, _)] => Ok(name),
        [_, (_, _, second), ..] => {
            let message = "a second name for the angle; use either t or theta";
            Err(cx.source.error(second, message))
        }
    }
}

/// The implicit curve or surface of a polynomial that is not constant, with the center that was given at some place; `wrong` makes
/// the error for a center that does not fit.
///
/// # Errors
/// That of `wrong`, and those of [`implicit_curve`] and [`implicit_surface`].
pub(crate) fn implicit<T>(
    polynomial: SparsePolynomial<3>,
    in_space: bool,
    center: Option<(T, WrittenCenter)>,
    source_name: &str,
    wrong: impl Fn(T, &'static str) -> Error,
) -> Result<Form> {
    if in_space {
        let center = center.map(|(at, center)| center.in_space().map_err(|m| wrong(at, m)));
        return Ok(Form::Surface(implicit_surface(
            polynomial,
            center.transpose()?,
            source_name,
        )?));
    }
    let center = center.map(|(at, center)| center.in_plane().map_err(|m| wrong(at, m)));
    let curve = implicit_curve(&polynomial, source_name)?;
    Ok(Form::Curve(match center.transpose()? {
        Some(center) => curve.with_center(center),
        None => curve,
    }))
}

/// The implicit curve of a polynomial in x and y that is not constant.
///
/// # Errors
/// [`Error::Limit`] if the polynomial has too many terms, coefficients or bits.
pub(crate) fn implicit_curve(
    polynomial: &SparsePolynomial<3>,
    source_name: &str,
) -> Result<ImplicitCurve> {
    check_terms(polynomial.len(), source_name)?;
    Ok(ImplicitCurve::new(plane(polynomial, source_name)?))
}

/// The implicit surface of a polynomial that is not constant, which is relative to the center if there is one.
///
/// # Errors
/// [`Error::Limit`] if the polynomial has too many terms.
fn implicit_surface(
    polynomial: SparsePolynomial<3>,
    center: Option<[Rational; 3]>,
    source_name: &str,
) -> Result<ImplicitSurface> {
    check_terms(polynomial.len(), source_name)?;
    let surface = ImplicitSurface::new(polynomial);
    Ok(match center {
        Some(center) => surface.with_center(center),
        None => surface,
    })
}

fn check_terms(terms: usize, source_name: &str) -> Result<()> {
    if terms > MAX_TERMS {
        return Err(Error::limit(format!(
            "{source_name}: more than {MAX_TERMS} terms"
        )));
    }
    Ok(())
}

/// The polynomial in x and y by its homogeneous parts; the list of each part ends at its highest power of y.
fn plane(polynomial: &SparsePolynomial<3>, source_name: &str) -> Result<PlanePolynomial> {
    let mut denominator = Integer::ONE;
    for (_, c) in polynomial.terms().filter(|(_, c)| !c.is_integer()) {
        let d = c.denominator();
        denominator = Integer::from(denominator.unsigned_abs_ref().lcm(d.unsigned_abs_ref()));
        let bits = denominator.significant_bits();
        if bits.saturating_mul(polynomial.len() as u64) > MAX_BITS {
            return Err(Error::limit(format!(
                "{source_name}: the coefficients over their common denominator have more than \
                 {MAX_BITS} bits in all"
            )));
        }
    }
    let mut parts = Vec::new();
    let mut part: Option<(usize, Vec<Integer>)> = None;
    let mut length = 0;
    // Terms are ordered by degree, and those of one degree by ascending powers of y.
    for (e, c) in polynomial.terms() {
        let degree = usize::try_from(total_degree(e)).invariant("a degree fits in a word");
        let y = e[1] as usize;
        let mut row = match part.take() {
            Some((d, row)) if d == degree => row,
            finished => {
                parts.extend(finished.map(binary_form));
                Vec::new()
            }
        };
        length += y + 1 - row.len();
        if length > MAX_COEFFICIENTS {
            return Err(Error::limit(format!(
                "{source_name}: the homogeneous parts have more than {MAX_COEFFICIENTS} \
                 coefficients, with the zeros between them"
            )));
        }
        row.resize(y, Integer::ZERO);
        row.push(if denominator == 1 {
            c.numerator()
        } else {
            c.numerator() * (&denominator).div_exact(c.denominator())
        });
        part = Some((degree, row));
    }
    parts.extend(part.map(binary_form));
    Ok(PlanePolynomial::from_parts(parts, denominator))
}

fn binary_form((degree, row): (usize, Vec<Integer>)) -> BinaryForm {
    BinaryForm::from_dehomogenized(degree, IntegerPolynomial::from_coefficients_asc(row))
}
