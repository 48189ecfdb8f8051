//! Closed forms in θ, or in θ and φ, as text of the input language, LaTeX, SymPy or Maple.

use std::fmt::Write;

use malachite::Integer;

use super::Format;
use crate::exact::Rational;
use crate::parametrize::{Condition, Expression, Relation};
use crate::poly::{BinaryForm, HomogeneousPolynomial};

/// The strength with which the text of an expression binds. An expression needs parentheses if it is weaker than its place
/// requires.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Strength {
    Sum,
    Product,
    Atom,
}

/// The expression in the given format: text (the input language's notation), LaTeX, SymPy or Maple.
pub(super) fn expression_text<F: HomogeneousPolynomial>(
    expression: &Expression<F>,
    format: Format,
) -> String {
    written(expression, format).0
}

/// Σ forms[i](cos θ, sin θ) r^(i·step) from the highest power down.
pub(super) fn equation_text(forms: &[BinaryForm], step: usize, format: Format) -> String {
    let times = if format == Format::Latex { " " } else { "*" };
    let terms = forms
        .iter()
        .enumerate()
        .rev()
        .filter(|(_, form)| !form.is_zero());
    let terms = terms.map(|(i, form)| {
        let (text, _) = form_text(form, format);
        let power = match (i * step, format) {
            (0, _) => return parenthesized(&text, format),
            (1, _) => "r".into(),
            (e, Format::Latex) => format!("r^{{{e}}}"),
            (e, Format::Sympy) => format!("r**{e}"),
            (e, _) => format!("r^{e}"),
        };
        format!("{}{times}{power}", parenthesized(&text, format))
    });
    terms.collect::<Vec<_>>().join(" + ")
}

/// A condition as a SymPy expression that is true or false in every direction.
///
/// The condition that a formula is not negative is written for its real part, because SymPy cannot compare a number that is not
/// real.
pub(super) fn condition_text(condition: &Condition) -> String {
    let all = |name: &str, parts: &[Condition]| {
        let parts: Vec<String> = parts.iter().map(condition_text).collect();
        format!("{name}({})", parts.join(", "))
    };
    match condition {
        Condition::All(parts) if parts.is_empty() => "true".into(),
        Condition::Any(parts) if parts.is_empty() => "false".into(),
        Condition::All(parts) => all("And", parts),
        Condition::Any(parts) => all("Or", parts),
        Condition::Not(part) => format!("Not({})", condition_text(part)),
        Condition::Form(form, relation) => {
            let name = match relation {
                Relation::Zero => "Eq",
                Relation::NotZero => "Ne",
                Relation::Positive => "Gt",
                Relation::Negative => "Lt",
                Relation::AtLeastZero => "Ge",
                Relation::AtMostZero => "Le",
            };
            format!("{name}({}, 0)", form_text(form, Format::Sympy).0)
        }
        Condition::NotNegative(expression) => {
            format!("Ge(re({}), 0)", expression_text(expression, Format::Sympy))
        }
    }
}

/// The text of an expression, and the strength with which that text binds.
fn written<F: HomogeneousPolynomial>(
    expression: &Expression<F>,
    format: Format,
) -> (String, Strength) {
    let inner = |e: &Expression<F>, least: Strength| {
        let (text, strength) = written(e, format);
        if strength >= least {
            text
        } else {
            parenthesized(&text, format)
        }
    };
    match expression {
        Expression::Form(form) => form_text(form, format),
        Expression::Sum(a, b) => {
            let text = format!(
                "{} + {}",
                inner(a, Strength::Sum),
                inner(b, Strength::Product)
            );
            (text, Strength::Sum)
        }
        Expression::Difference(a, b) => {
            let text = format!(
                "{} - {}",
                inner(a, Strength::Sum),
                inner(b, Strength::Product)
            );
            (text, Strength::Sum)
        }
        Expression::Product(a, b) => {
            let times = if format == Format::Latex { " " } else { "*" };
            let text = format!(
                "{}{times}{}",
                inner(a, Strength::Product),
                inner(b, Strength::Product)
            );
            (text, Strength::Product)
        }
        Expression::Quotient(a, b) if format == Format::Latex => {
            let (a, b) = (written(a, format).0, written(b, format).0);
            (format!("\\frac{{{a}}}{{{b}}}"), Strength::Product)
        }
        Expression::Quotient(a, b) => {
            let text = format!(
                "{}/{}",
                inner(a, Strength::Product),
                inner(b, Strength::Atom)
            );
            (text, Strength::Product)
        }
        Expression::Negative(a) => (format!("-{}", inner(a, Strength::Product)), Strength::Sum),
        Expression::Pi(q) => (pi_text(q, format), Strength::Product),
        Expression::Cosine(a) => (call("cos", a, format), Strength::Atom),
        Expression::Arccosine(a) => (call("arccos", a, format), Strength::Atom),
        Expression::Constant(q) => constant_text(q, format),
        Expression::Absolute(a) => (absolute_text(&written(a, format).0, format), Strength::Atom),
        Expression::Power(a, q) => (
            power_text(&inner(a, Strength::Atom), q, format),
            Strength::Product,
        ),
        Expression::Root(k, a) => (root_text(*k, &written(a, format).0, format), Strength::Atom),
    }
}

/// The text of a number. A fraction counts as a sum, so that it gets parentheses in every product, quotient and power.
fn constant_text(q: &Rational, format: Format) -> (String, Strength) {
    let (p, over) = (q.numerator(), q.denominator());
    match (q.is_integer(), format) {
        (true, _) => (p.to_string(), Strength::Atom),
        (_, Format::Latex) => (format!("\\frac{{{p}}}{{{over}}}"), Strength::Product),
        (_, Format::Sympy) => (format!("Rational({p}, {over})"), Strength::Atom),
        _ => (format!("{p}/{over}"), Strength::Sum),
    }
}

fn absolute_text(a: &str, format: Format) -> String {
    match format {
        Format::Latex => format!("\\left|{a}\\right|"),
        Format::Sympy => format!("Abs({a})"),
        _ => format!("abs({a})"),
    }
}

fn power_text(a: &str, q: &Rational, format: Format) -> String {
    let (exponent, strength) = constant_text(q, format);
    match (format, strength) {
        (Format::Latex, _) => format!("{a}^{{{q}}}"),
        (Format::Sympy, _) => format!("{a}**{exponent}"),
        (_, Strength::Atom) => format!("{a}^{exponent}"),
        _ => format!("{a}^({exponent})"),
    }
}

fn pi_text(q: &Rational, format: Format) -> String {
    match format {
        Format::Latex => format!("{q} \\pi"),
        Format::Maple => format!("{q}*Pi"),
        _ => format!("{q}*pi"),
    }
}

fn call<F: HomogeneousPolynomial>(
    function: &str,
    argument: &Expression<F>,
    format: Format,
) -> String {
    let argument = written(argument, format).0;
    match (format, function) {
        (Format::Latex, _) => format!("\\{function}\\left({argument}\\right)"),
        (Format::Sympy | Format::Text, "arccos") => format!("acos({argument})"),
        _ => format!("{function}({argument})"),
    }
}

fn parenthesized(text: &str, format: Format) -> String {
    if format == Format::Latex {
        format!("\\left({text}\\right)")
    } else {
        format!("({text})")
    }
}

/// The text of the real k-th root of `a`. Odd roots use the functions of each system for real roots, because the power of a
/// negative number is complex in these systems.
fn root_text(k: u32, a: &str, format: Format) -> String {
    match (format, k) {
        (Format::Latex, 2) => format!("\\sqrt{{{a}}}"),
        (Format::Latex, _) => format!("\\sqrt[{k}]{{{a}}}"),
        (_, 2) => format!("sqrt({a})"),
        (Format::Sympy, _) if k.is_multiple_of(2) => format!("root({a}, {k})"),
        (Format::Sympy, _) => format!("real_root({a}, {k})"),
        (Format::Maple, _) => format!("surd({a}, {k})"),
        (_, 3) => format!("cbrt({a})"),
        _ => format!("root({a}, {k})"),
    }
}

/// The text of a form at (cos θ, sin θ) or (sin φ cos θ, sin φ sin θ, cos φ), expanded. A form of revolution is written without
/// θ, by cos² θ + sin² θ = 1.
pub(super) fn form_text<F: HomogeneousPolynomial>(form: &F, format: Format) -> (String, Strength) {
    if let Some(terms) = form.of_revolution() {
        let of_phi = |e: usize, k: usize| {
            let powers = [
                power("sin", "phi", 2 * e, format),
                power("cos", "phi", k, format),
            ];
            powers.into_iter().flatten().collect()
        };
        let terms = terms.iter().map(|(e, k, c)| (c, of_phi(*e, *k)));
        return sum_text(terms, format);
    }
    let terms = form.monomials().into_iter();
    sum_text(terms.map(|(e, c)| (c, monomial::<F>(e, format))), format)
}

/// The text of a sum of terms, each a coefficient and a list of factors.
fn sum_text<'a>(
    all: impl Iterator<Item = (&'a Integer, Vec<String>)>,
    format: Format,
) -> (String, Strength) {
    let mut text = String::new();
    let mut terms = 0;
    let mut factors = 0;
    for (coefficient, mut parts) in all {
        let negative = *coefficient < 0;
        text.push_str(match (terms, negative) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        });
        let magnitude = coefficient.unsigned_abs_ref();
        if parts.is_empty() || *magnitude != 1u32 {
            parts.insert(0, magnitude.to_string());
        }
        terms += 1;
        factors = parts.len() + usize::from(negative);
        let times = if format == Format::Latex { " " } else { "*" };
        let _ = write!(text, "{}", parts.join(times));
    }
    match (terms, factors) {
        (0, _) => ("0".into(), Strength::Atom),
        (1, 1) => (text, Strength::Atom),
        (1, _) if !text.starts_with('-') => (text, Strength::Product),
        _ => (text, Strength::Sum),
    }
}

/// The powers of cosines and sines of one term.
fn monomial<F: HomogeneousPolynomial>([i, j, k]: [usize; 3], format: Format) -> Vec<String> {
    let theta = [
        power("cos", "theta", i, format),
        power("sin", "theta", j, format),
    ];
    let phi = match F::VARIABLES {
        2 => [None, None],
        _ => [
            power("sin", "phi", i + j, format),
            power("cos", "phi", k, format),
        ],
    };
    phi.into_iter().chain(theta).flatten().collect()
}

fn power(function: &str, angle: &str, exponent: usize, format: Format) -> Option<String> {
    let power = match format {
        Format::Sympy => "**",
        _ => "^",
    };
    match (exponent, format) {
        (0, _) => None,
        (1, Format::Latex) => Some(format!("\\{function} \\{angle}")),
        (_, Format::Latex) => Some(format!("\\{function}^{{{exponent}}} \\{angle}")),
        (1, _) => Some(format!("{function}({angle})")),
        _ => Some(format!("{function}({angle}){power}{exponent}")),
    }
}
