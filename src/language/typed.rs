//! Spellings of other programs and of paper, in the tokens of the grammar.
//!
//! | typed | read as |
//! | --- | --- |
//! | `(t^2, t^3)`, `[t^2, t^3]` | `x = t^2; y = t^3`; with a third one `z = …` |
//! | `x = t^2, y = t^3` | `x = t^2; y = t^3` |
//! | `x(t) = …`, `r(theta) = …` | `x = …`, `r = …` |
//! | `[x = t^2, y = t^3]` | `x = t^2; y = t^3` |
//! | `f(x, y) = …` | the polynomial |
//! | `Eq(a, b)`, `a == b`, `a := b` | `a = b` |
//! | `x.^2`, `Cos[t]`, `{t, t^2}` | as in MATLAB and Mathematica |
//! | `cos t`, `sin 3t` | `cos(t)`, `sin(3t)`, unless a power or a division follows |
//! | `cos^2(t)`, `sin²(t)` | `cos(t)^2`, `sin(t)^2` |

use super::name::{Name, PARAMETERS};
use super::source::{Source, Span};
use super::token::{Kind, Token};

/// The coordinates of a tuple.
const COORDINATES: [Name; 3] = [Name::X, Name::Y, Name::Z];

/// The tokens of the grammar for what was typed; the last one stays [`Kind::End`].
pub(super) fn understood(source: Source<'_>, tokens: &[Token]) -> Vec<Token> {
    let mut result = Vec::with_capacity(tokens.len());
    for equation in tokens.split_inclusive(|t| ends_an_equation(t.kind)) {
        one_equation(source, equation, &mut result);
    }
    with_arguments(&result)
}

fn ends_an_equation(kind: Kind) -> bool {
    matches!(kind, Kind::Semicolon | Kind::Newline | Kind::End)
}

/// One equation with the token that ends it, or several with commas between them.
fn one_equation(source: Source<'_>, tokens: &[Token], result: &mut Vec<Token>) {
    let Some((end, body)) = tokens.split_last() else {
        return;
    };
    if let Some(parts) = tuple(body) {
        for (name, part) in COORDINATES.into_iter().zip(&parts) {
            let at = body[0].span;
            let token = |kind| Token { kind, span: at };
            result.extend([token(Kind::Name(name)), token(Kind::Equals)]);
            result.extend_from_slice(part);
            result.push(token(Kind::Semicolon));
        }
        result.pop();
    } else if let Some(parts) = listed_equations(body) {
        for part in &parts {
            separated(part, result);
            result.push(Token {
                kind: Kind::Semicolon,
                span: body[0].span,
            });
        }
        result.pop();
    } else if let Some(length) = function_of_coordinates(source, body) {
        result.extend_from_slice(&body[length..]);
    } else if let Some([left, right]) = sympy_equation(source, body) {
        result.extend_from_slice(left);
        result.push(Token {
            kind: Kind::Equals,
            span: body[1].span,
        });
        result.extend_from_slice(right);
    } else {
        separated(body, result);
    }
    result.push(*end);
}

/// Two or three expressions in one pair of parentheses or brackets, with commas between them.
fn tuple(body: &[Token]) -> Option<Vec<&[Token]>> {
    let parts = arguments(body)?;
    let is_plain = parts.iter().all(|part| {
        let equals = |t: &Token| t.kind == Kind::Equals;
        !part.is_empty() && !part.iter().any(equals)
    });
    (matches!(parts.len(), 2 | 3) && is_plain).then_some(parts)
}

/// Equations `x = …` in one pair of parentheses or brackets, with commas between them.
fn listed_equations(body: &[Token]) -> Option<Vec<&[Token]>> {
    let parts = arguments(body)?;
    let are_equations = parts.iter().all(|part| left_side(part).is_some());
    are_equations.then_some(parts)
}

/// How many tokens `f(x, y) =` or `f(x, y, z) =` are, for any name: what follows is the polynomial.
fn function_of_coordinates(source: Source<'_>, body: &[Token]) -> Option<usize> {
    let kinds: Vec<Kind> = body.iter().take(9).map(|t| t.kind).collect();
    let [x, y, z] = COORDINATES.map(Kind::Name);
    let (open, comma, close) = (Kind::Open, Kind::Comma, Kind::Close);
    let plane = [open, x, comma, y, close, Kind::Equals];
    let space = [open, x, comma, y, comma, z, close, Kind::Equals];
    let is_name = source.slice(body.first()?.span).chars().count() <= 2;
    let rest = kinds
        .get(1..)
        .filter(|_| is_name && kinds[0] == Kind::Unknown)?;
    [&plane[..], &space[..]]
        .into_iter()
        .find(|left| rest.starts_with(left))
        .map(|left| 1 + left.len())
}

/// `Eq(left, right)`.
fn sympy_equation<'t>(source: Source<'_>, body: &'t [Token]) -> Option<[&'t [Token]; 2]> {
    let (first, rest) = body.split_first()?;
    let is_equation = first.kind == Kind::Unknown && source.slice(first.span) == "Eq";
    if !is_equation {
        return None;
    }
    arguments(rest)?.try_into().ok()
}

/// What stands between commas in the parentheses that enclose all the tokens.
fn arguments(tokens: &[Token]) -> Option<Vec<&[Token]>> {
    let inner = match tokens {
        [first, inner @ .., last] if first.kind == Kind::Open && last.kind == Kind::Close => inner,
        _ => return None,
    };
    let mut parts = Vec::new();
    let (mut depth, mut start) = (0_usize, 0);
    for (i, token) in inner.iter().enumerate() {
        match token.kind {
            Kind::Open => depth += 1,
            // The first parenthesis is closed before the end.
            Kind::Close => depth = depth.checked_sub(1)?,
            Kind::Comma if depth == 0 => {
                parts.push(&inner[start..i]);
                start = i + 1;
            }
            _ => {}
        }
    }
    parts.push(&inner[start..]);
    Some(parts)
}

/// Equations with commas between them, and without the arguments on their left sides.
fn separated(body: &[Token], result: &mut Vec<Token>) {
    let (mut depth, mut equals, mut i) = (0_usize, false, 0);
    let mut is_start = true;
    while let Some(&token) = body.get(i) {
        if is_start && let Some(length) = left_side(&body[i..]) {
            result.push(token);
            i += length;
            is_start = false;
            continue;
        }
        is_start = false;
        match token.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            Kind::Equals => equals = true,
            Kind::Comma if depth == 0 && equals && left_side(&body[i + 1..]).is_some() => {
                result.push(Token {
                    kind: Kind::Semicolon,
                    span: token.span,
                });
                (equals, is_start) = (false, true);
                i += 1;
                continue;
            }
            _ => {}
        }
        result.push(token);
        i += 1;
    }
}

/// Whether the tokens begin with `x =`, `x(t) =` or `x(u, v) =`, and how many there are before the `=`.
fn left_side(tokens: &[Token]) -> Option<usize> {
    let kinds: Vec<Kind> = tokens.iter().take(7).map(|t| t.kind).collect();
    let before = match &kinds[..] {
        [Kind::Name(_), Kind::Equals, ..] => 1,
        [_, Kind::Open, t, Kind::Close, Kind::Equals, ..] if is_parameter(*t) => 4,
        [_, Kind::Open, u, Kind::Comma, v, Kind::Close, Kind::Equals]
            if is_parameter(*u) && is_parameter(*v) =>
        {
            6
        }
        _ => return None,
    };
    let names = [Name::X, Name::Y, Name::Z, Name::R];
    let is_coordinate = |name: &Name| kinds[0] == Kind::Name(*name);
    names.iter().any(is_coordinate).then_some(before)
}

fn is_parameter(kind: Kind) -> bool {
    PARAMETERS.iter().any(|name| kind == Kind::Name(*name))
}

/// Functions of angles with parentheses about their arguments, and with their exponents behind them.
fn with_arguments(tokens: &[Token]) -> Vec<Token> {
    let mut result: Vec<Token> = Vec::with_capacity(tokens.len());
    // For each parenthesis that is open, the exponent that belongs behind it.
    let mut open: Vec<&[Token]> = Vec::new();
    let mut rest = tokens;
    while let Some((&token, after)) = rest.split_first() {
        result.push(token);
        rest = after;
        match token.kind {
            Kind::Open => open.push(&[]),
            Kind::Close => result.extend_from_slice(open.pop().unwrap_or(&[])),
            Kind::Name(name) if Name::OF_ANGLES.contains(&name) => {
                let (exponent, argument) = after.split_at(exponent(after));
                let parenthesis = |kind, at| Token {
                    kind,
                    span: Span { start: at, end: at },
                };
                if let Some(length) = bare_argument(argument) {
                    let (argument, after) = argument.split_at(length);
                    let (first, last) = (argument[0].span, argument[length - 1].span);
                    result.push(parenthesis(Kind::Open, first.start));
                    result.extend_from_slice(argument);
                    result.push(parenthesis(Kind::Close, last.end));
                    result.extend_from_slice(exponent);
                    rest = after;
                } else if let Some((opening, after)) = argument.split_first()
                    && opening.kind == Kind::Open
                {
                    result.push(*opening);
                    open.push(exponent);
                    rest = after;
                }
            }
            _ => {}
        }
    }
    result
}

/// How many tokens are a natural exponent: `^2`, or `²`.
fn exponent(tokens: &[Token]) -> usize {
    match tokens {
        [caret, number, ..] if caret.kind == Kind::Caret && number.kind == Kind::Number => 2,
        [superscript, ..] if superscript.kind == Kind::Superscript => 1,
        _ => 0,
    }
}

/// How many tokens are `t`, `3t` or `3*t`, where it is clear that no more belongs to the argument.
fn bare_argument(tokens: &[Token]) -> Option<usize> {
    let number = usize::from(tokens.first()?.kind == Kind::Number);
    let star = usize::from(number == 1 && tokens.get(1)?.kind == Kind::Star);
    let name = number + star;
    let (argument, next) = (tokens.get(name)?.kind, tokens.get(name + 1)?.kind);
    let is_clear = !matches!(
        next,
        Kind::Slash | Kind::Caret | Kind::Superscript | Kind::Number | Kind::Open
    );
    (is_parameter(argument) && is_clear && !is_parameter(next)).then_some(name + 1)
}
