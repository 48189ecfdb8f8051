//! Reads parametric curves and patches: `x = …; y = …[; z = …]`.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Gcd, Lcm};
use malachite::base::num::basic::traits::One;
use malachite::base::polynomial::Polynomial as _;

use super::angle::Angle;
use super::evaluate::{Context, evaluate};
use super::name::{COORDINATES, Name, PARAMETERS};
use super::quotient::{MAX_MULTIPLE, ParameterUse, Quotients};
use super::source::Span;
use super::syntax::{Equation, Expr, ExprKind};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, RationalFunction, SparsePolynomial};
use crate::shape::{Form, Parameter, ParametricCurve, Patch, PatchFunction};

/// Whether the equations give coordinates as functions of parameters: one of them is `x = …`, `y = …` or `z = …` with a
/// parameter or a function of an angle.
pub(super) fn are_parametric(equations: &[Equation]) -> bool {
    let varies = |equation: &Equation| {
        equation.names.any(&PARAMETERS) || equation.names.any(&Name::OF_ANGLES)
    };
    equations
        .iter()
        .any(|equation| coordinate(equation).is_some() && varies(equation))
}

/// Whether the equations give coordinates: each one is `x = …`, `y = …` or `z = …`, no coordinate is given twice, and none
/// occurs in the formula of another one.
pub(super) fn are_coordinates(equations: &[Equation]) -> bool {
    let mut given = [false; 3];
    equations.iter().all(|equation| {
        let named = COORDINATES
            .iter()
            .filter(|name| equation.names.any(&[**name]));
        let is_alone = named.count() == 1;
        let index = coordinate(equation).map(|(index, _)| index);
        index.is_some_and(|index| is_alone && !std::mem::replace(&mut given[index], true))
    })
}

/// The index of the coordinate that the equation gives, and its formula.
fn coordinate(equation: &Equation) -> Option<(usize, &Expr)> {
    let formula = equation.right.as_ref()?;
    let index = COORDINATES
        .iter()
        .position(|&name| equation.left.is_name(name))?;
    Some((index, formula))
}

/// The curve or patch that the equations give.
pub(super) fn parametric(cx: &mut Context<'_>, equations: &[Equation]) -> Result<Form> {
    let formulas = formulas(cx, equations)?;
    of_formulas(cx, equations, formulas)
}

/// The curve or patch with these formulas of the coordinates; messages point to the equations.
pub(super) fn of_formulas(
    cx: &mut Context<'_>,
    equations: &[Equation],
    formulas: [Option<&Expr>; 3],
) -> Result<Form> {
    let (parameters, in_space) = parameters(cx, &formulas)?;
    let mut values = Vec::new();
    for formula in formulas.iter().flatten() {
        values.push((
            evaluate(cx, &Quotients(&parameters), formula)?,
            formula.span,
        ));
    }
    let limits = Limits::none();
    let names: Vec<Parameter> = parameters.iter().map(ParameterUse::parameter).collect();
    let no_function = |at| {
        cx.source
            .error(at, "division by zero: this is 0/0 everywhere")
    };
    if let [first, second] = &names[..] {
        let mut coordinates = Vec::new();
        for (value, at) in &values {
            let (above, below) = value.over_one_denominator();
            let function = PatchFunction::new(&above, &below, &limits)?;
            coordinates.push(function.ok_or_else(|| no_function(*at))?);
        }
        let coordinates: [PatchFunction; 3] = coordinates
            .try_into()
            .map_err(|_| missing(cx, equations, "z"))?;
        for (v, parameter) in names.iter().enumerate() {
            for (f, (_, at)) in coordinates.iter().zip(&values) {
                check_multiples(cx, parameter, f.degree_in(v), *at)?;
            }
        }
        // A parameter that no longer occurs in the reduced coordinates does not count.
        let occurs = |v: usize| coordinates.iter().any(|f| f.degree_in(v) > 0);
        let (v, parameter) = match (occurs(0), occurs(1)) {
            (false, false) => return Err(a_point(cx, equations)),
            (true, true) => {
                let parameters = [first.clone(), second.clone()];
                return Ok(Form::Patch(Patch::new(parameters, coordinates)));
            }
            (true, false) => (0, first),
            (false, true) => (1, second),
        };
        let functions = coordinates.each_ref().map(|f| {
            let quotient = univariate(v, f.numerator(), f.denominator());
            quotient.invariant("a denominator is not 0")
        });
        let curve = ParametricCurve::new(parameter.clone(), functions);
        return Ok(Form::SpaceCurve(curve));
    }
    let Some(parameter) = names.into_iter().next() else {
        let at = equations[0].left.span;
        return Err(cx
            .source
            .error(at, "the coordinates do not depend on a parameter"));
    };
    let mut coordinates = Vec::new();
    for (value, at) in &values {
        let (above, below) = value.over_one_denominator();
        let function = univariate(0, &above, &below).ok_or_else(|| no_function(*at))?;
        let degree = u32::try_from(function.degree()).invariant("a degree is below 2^32");
        check_multiples(cx, &parameter, degree, *at)?;
        coordinates.push(function);
    }
    if coordinates.iter().all(RationalFunction::is_constant) {
        return Err(a_point(cx, equations));
    }
    if in_space {
        let coordinates: [RationalFunction; 3] = coordinates
            .try_into()
            .map_err(|_| missing(cx, equations, "z"))?;
        return Ok(Form::SpaceCurve(ParametricCurve::new(
            parameter,
            coordinates,
        )));
    }
    let coordinates: [RationalFunction; 2] = coordinates
        .try_into()
        .map_err(|_| missing(cx, equations, "y"))?;
    Ok(Form::PlaneCurve(ParametricCurve::new(
        parameter,
        coordinates,
    )))
}

/// The error for coordinates that are all constant.
pub(super) fn a_point(cx: &Context<'_>, equations: &[Equation]) -> crate::error::Error {
    let message =
        "all coordinates are constant, whatever the parameter is: this is a point, not a curve";
    cx.source.error(equations[0].left.span, message)
}

/// Refuses a coordinate whose degree in s = tan(step·t/2) is so high that its formula may contain multiples of the angle beyond
/// [`MAX_MULTIPLE`]. So every form that is accepted can be written, and be read again.
fn check_multiples(cx: &Context<'_>, parameter: &Parameter, degree: u32, at: Span) -> Result<()> {
    // A function of even degree d in s has multiples of the angle up to d/2. For odd d, the degree itself is the bound.
    let is_whole = degree.is_multiple_of(2);
    let multiple = if is_whole { degree / 2 } else { degree };
    if parameter.is_angle() && multiple > MAX_MULTIPLE {
        let limit = format!("a multiple beyond {MAX_MULTIPLE} of the smallest angle");
        return Err(cx.source.limit(at, limit));
    }
    Ok(())
}

fn missing(cx: &Context<'_>, equations: &[Equation], name: &str) -> crate::error::Error {
    let end = equations
        .last()
        .map_or(Span { start: 0, end: 0 }, |e| e.left.span);
    let message = format!(
        "`{name} = …` is missing: a plane curve has x and y, a space curve or a patch x, y and z"
    );
    cx.source.error(end, message)
}

/// The error for an equation in which a coordinate stands beside a function of an angle or a parameter, as in `y = sin(x)`, if
/// there is one.
fn beside_a_coordinate(cx: &Context<'_>, equations: &[Equation]) -> Option<crate::error::Error> {
    equations.iter().find_map(|equation| {
        let own = coordinate(equation).map(|(index, _)| COORDINATES[index]);
        let mut others = COORDINATES.into_iter().filter(|name| Some(*name) != own);
        let at = others.find_map(|name| equation.names.first(name))?;
        let message = "a coordinate beside cos, sin or a parameter: a curve with them is given by a parameter, as in \
                       `x = cos(t); y = sin(2*t)`; without them an equation is a polynomial in x, y, z";
        Some(cx.source.error(at, message))
    })
}

/// The formulas of x, y and z; that of z may be missing.
fn formulas<'e>(cx: &Context<'_>, equations: &'e [Equation]) -> Result<[Option<&'e Expr>; 3]> {
    let mut formulas = [None; 3];
    for equation in equations {
        let Some((index, formula)) = coordinate(equation) else {
            let message = "expected `x = …`, `y = …` or `z = …` as a function of the parameter";
            return Err(cx.source.error(equation.left.span, message));
        };
        if formulas[index].replace(formula).is_some() {
            let message = format!("a second `{} = …`", cx.source.slice(equation.left.span));
            return Err(cx.source.error(equation.left.span, message));
        }
    }
    for (name, formula) in ["x", "y"].iter().zip(&formulas) {
        if formula.is_none() {
            return Err(
                beside_a_coordinate(cx, equations).unwrap_or_else(|| missing(cx, equations, name))
            );
        }
    }
    Ok(formulas)
}

/// The places where a parameter occurs first by itself and first in an angle, and the largest step of which all its slopes in
/// angles are integer multiples.
#[derive(Default)]
struct Occurrence {
    by_itself: Option<Span>,
    in_angle: Option<Span>,
    step: Option<Rational>,
}

/// The parameters, in canonical order, with their uses, and whether z is given.
fn parameters(
    cx: &mut Context<'_>,
    formulas: &[Option<&Expr>; 3],
) -> Result<(Vec<ParameterUse>, bool)> {
    let mut found: [Occurrence; PARAMETERS.len()] = Default::default();
    for formula in formulas.iter().flatten() {
        collect(cx, formula, &mut found)?;
    }
    let in_space = formulas[2].is_some();
    let mut uses = Vec::new();
    for (name, occurrence) in PARAMETERS.into_iter().zip(found) {
        let Some(at) = occurrence.by_itself.or(occurrence.in_angle) else {
            continue;
        };
        let shown = cx.source.slice(at).to_owned();
        if let (Some(at), Some(_)) = (occurrence.by_itself, occurrence.in_angle) {
            let message = format!(
                "`{shown}` itself beside cos or sin of it: {shown} and sin({shown}) satisfy no \
                 polynomial equation, so the form is not algebraic"
            );
            return Err(cx.source.error(at, message));
        }
        let most = if in_space { 2 } else { 1 };
        if uses.len() == most {
            let message = if in_space {
                "a third parameter; a space curve has one, a patch two"
            } else {
                "a second parameter; a plane curve has one, a patch has two and x, y and z"
            };
            return Err(cx.source.error(at, message));
        }
        let spelling = name.parameter_name().to_owned();
        uses.push(ParameterUse::new(name, spelling, occurrence.step));
    }
    Ok((uses, in_space))
}

fn collect(cx: &mut Context<'_>, expr: &Expr, found: &mut [Occurrence]) -> Result<()> {
    match &expr.kind {
        ExprKind::Number | ExprKind::Integer(_) => {}
        ExprKind::Name(name) => {
            if let Some(index) = PARAMETERS.iter().position(|p| p == name) {
                found[index].by_itself.get_or_insert(expr.span);
            }
        }
        ExprKind::Negative(inner) => collect(cx, inner, found)?,
        ExprKind::Sum(parts) | ExprKind::Product(parts) => {
            for (_, part) in parts {
                collect(cx, part, found)?;
            }
        }
        ExprKind::Power(base, exponent) => {
            collect(cx, base, found)?;
            collect(cx, exponent, found)?;
        }
        ExprKind::Call(name, arguments) if Name::OF_ANGLES.contains(name) => {
            if let [argument] = arguments.as_slice() {
                let angle = Angle::of(cx, argument)?;
                for (occurrence, slope) in found.iter_mut().zip(&angle.slopes) {
                    if !slope.is_zero() {
                        occurrence.in_angle.get_or_insert(name_in(argument));
                        let step = occurrence.step.take();
                        occurrence.step = Some(common_step(step, slope));
                    }
                }
            }
        }
        ExprKind::Call(_, arguments) => {
            for argument in arguments {
                collect(cx, argument, found)?;
            }
        }
    }
    Ok(())
}

/// The place of a parameter in an argument: that of the whole argument.
fn name_in(argument: &Expr) -> Span {
    argument.span
}

/// The largest rational number of which the step and the slope are integer multiples.
fn common_step(step: Option<Rational>, slope: &Rational) -> Rational {
    let slope = slope.abs();
    let Some(step) = step else {
        return slope;
    };
    // gcd(a/b, c/d) = gcd(ad, cb)/bd
    let (b, d) = (step.denominator(), slope.denominator());
    let (ad, cb) = (step.numerator() * &d, slope.numerator() * &b);
    let gcd = Integer::from(ad.unsigned_abs_ref().gcd(cb.unsigned_abs_ref()));
    Rational::from_integers(gcd, b * d).invariant("a denominator is not 0")
}

/// The quotient as a function of the only variable that occurs; `None` if its denominator is 0.
fn univariate(
    variable: usize,
    above: &SparsePolynomial<2>,
    below: &SparsePolynomial<2>,
) -> Option<RationalFunction> {
    let denominator = above
        .terms()
        .chain(below.terms())
        .fold(Integer::ONE, |d, (_, c)| {
            let lcm = d.unsigned_abs_ref().lcm(c.denominator().unsigned_abs_ref());
            Integer::from(lcm)
        });
    let integers = |f: &SparsePolynomial<2>| {
        let power = |e: &[u32; 2]| e[variable] as usize;
        let length = f.terms().map(|(e, _)| power(e) + 1).max().unwrap_or(0);
        let mut coefficients = vec![Integer::from(0); length];
        for (e, c) in f.terms() {
            coefficients[power(e)] = c.numerator() * (&denominator).div_exact(c.denominator());
        }
        IntegerPolynomial::from_coefficients_asc(coefficients)
    };
    RationalFunction::from_integers(integers(above), integers(below))
}
