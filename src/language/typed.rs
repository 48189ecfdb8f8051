//! Spellings of other programs and of paper, in the tokens of the grammar.
//!
//! | typed | read as |
//! | --- | --- |
//! | `(t^2, t^3)`, `[t^2, t^3]` | `x = t^2; y = t^3`; with a third one `z = …` |
//! | `x = t^2, y = t^3` | `x = t^2; y = t^3` |
//! | `x(t) = …`, `r(theta) = …`, `y(x) = …` | `x = …`, `r = …`, `y = …` |
//! | `[x = t^2, y = t^3]`, `c(t) = (t^2, t^3)`, `<t^2, t^3>` | `x = t^2; y = t^3` |
//! | `(x^2 + y^2 - 1, z - y^5)` | `x^2 + y^2 - 1; z - y^5`, because these are no coordinates |
//! | `f(x, y) = …`, `@(x, y) …`, `lambda x, y: …`, `(x, y) -> …` | the polynomial; with z a surface |
//! | `f(x) = …` | `y = …` |
//! | `Eq(a, b)`, `a == b`, `a := b` | `a = b` |
//! | `x.^2`, `Cos[t]`, `{t, t^2}` | as in MATLAB and Mathematica |
//! | `cos t`, `sin 3t` | `cos(t)`, `sin(3t)`, unless a power or a division follows |
//! | `cos^2(t)`, `sin²(t)` | `cos(t)^2`, `sin(t)^2` |

use super::heads::{head, in_parentheses};
use super::name::{COORDINATES, Name};
use super::source::{Source, Span};
use super::token::{Kind, Token};
use crate::error::Result;

/// The tokens of the grammar for what was typed; the last one stays [`Kind::End`].
///
/// # Errors
/// [`crate::error::Error::Syntax`] for a tuple of more than three coordinates.
pub(super) fn understood(source: Source<'_>, tokens: &[Token]) -> Result<Vec<Token>> {
    let tokens = with_commas(tokens);
    let mut result = Vec::with_capacity(tokens.len());
    for equation in tokens.split_inclusive(|t| ends_an_equation(t.kind)) {
        one_equation(source, equation, &mut result)?;
    }
    Ok(with_arguments(&result))
}

fn ends_an_equation(kind: Kind) -> bool {
    matches!(kind, Kind::Semicolon | Kind::Newline | Kind::End)
}

/// Commas instead of semicolons between parentheses, where all of them are closed: `[cos(t); sin(t)]`.
fn with_commas(tokens: &[Token]) -> Vec<Token> {
    let mut depth = 0_usize;
    let mut result = tokens.to_vec();
    for token in &mut result {
        match token.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            Kind::Semicolon if depth > 0 => token.kind = Kind::Comma,
            _ => {}
        }
    }
    if depth == 0 { result } else { tokens.to_vec() }
}

/// One equation with the token that ends it, or several with commas between them.
fn one_equation(source: Source<'_>, tokens: &[Token], result: &mut Vec<Token>) -> Result<()> {
    let Some((end, body)) = tokens.split_last() else {
        return Ok(());
    };
    let body = without_last(source, body);
    if let Some([left, right]) = sympy_equation(source, body) {
        result.extend_from_slice(left);
        result.push(Token {
            kind: Kind::Equals,
            span: body[1].span,
        });
        result.extend_from_slice(right);
    } else if !function(source, body, result)? && !list(source, body, result)? {
        separated(source, body, result);
    }
    result.push(*end);
    Ok(())
}

/// The tokens without a comma at the end of a line, and without the colon that ends a statement of Maple.
fn without_last<'t>(source: Source<'_>, body: &'t [Token]) -> &'t [Token] {
    match body.split_last() {
        Some((last, rest)) if last.kind == Kind::Comma || source.slice(last.span) == ":" => rest,
        _ => body,
    }
}

/// The formula of a function instead of the function: `f(x, y) = …` is the polynomial, `f(x) = …` the graph, and `c(t) = (…)`
/// or `(x, y) = (…)` the curve. Whether it is one.
fn function(source: Source<'_>, body: &[Token], result: &mut Vec<Token>) -> Result<bool> {
    let [x, y, z] = COORDINATES;
    if let Some((variables, length)) = in_parentheses(source, body)
        && (variables == [x, y] || variables == COORDINATES)
        && body.get(length).is_some_and(|t| t.kind == Kind::Equals)
    {
        return list(source, &body[length + 1..], result);
    }
    let Some(head) = head(source, body) else {
        return Ok(false);
    };
    let (before, formula) = body.split_at(head.length);
    let at = before[0].span;
    let token = |kind| Token { kind, span: at };
    if head.is_of_parameters() {
        return list(source, formula, result);
    } else if head.is_of(&[x]) {
        result.extend([token(Kind::Name(y)), token(Kind::Equals)]);
        result.extend_from_slice(formula);
    } else if head.is_of(&[x, y]) {
        result.extend_from_slice(formula);
    } else if head.is_of(&COORDINATES) {
        // z has to occur, so that it is a surface.
        result.extend_from_slice(formula);
        result.extend([Kind::Plus, Kind::Name(z), Kind::Minus, Kind::Name(z)].map(token));
    } else {
        return Ok(false);
    }
    Ok(true)
}

/// A list in one pair of parentheses or brackets, with commas: of coordinates, of polynomials, or of equations. Whether it
/// is one.
fn list(source: Source<'_>, body: &[Token], result: &mut Vec<Token>) -> Result<bool> {
    let Some(parts) = parts(source, body) else {
        return Ok(false);
    };
    let equals = |part: &&[Token]| part.iter().filter(|t| t.kind == Kind::Equals).count();
    let of_point = |part: &&[Token]| {
        part.iter()
            .any(|t| COORDINATES.iter().any(|c| t.kind == Kind::Name(*c)))
    };
    let at = body[0].span;
    let token = |kind| Token { kind, span: at };
    if parts.iter().all(|part| equals(part) == 1) {
        for part in &parts {
            separated(source, part, result);
            result.push(token(Kind::Semicolon));
        }
    } else if parts.len() < 2 || parts.iter().any(|part| part.is_empty() || equals(part) > 0) {
        return Ok(false);
    } else if parts.iter().any(of_point) {
        for part in &parts {
            result.extend_from_slice(part);
            result.push(token(Kind::Semicolon));
        }
    } else if parts.len() > COORDINATES.len() {
        let message = "a tuple has two coordinates in the plane or three in space, as in `(t^2, t^3)`; decimals are written \
                       with a point, and a range of the parameter is left out";
        return Err(source.error(parts[COORDINATES.len()][0].span, message));
    } else {
        for (name, part) in COORDINATES.into_iter().zip(&parts) {
            result.extend([token(Kind::Name(name)), token(Kind::Equals)]);
            result.extend_from_slice(part);
            result.push(token(Kind::Semicolon));
        }
    }
    result.pop();
    Ok(true)
}

/// `Eq(left, right)`.
fn sympy_equation<'t>(source: Source<'_>, body: &'t [Token]) -> Option<[&'t [Token]; 2]> {
    let (first, rest) = body.split_first()?;
    let is_equation = first.kind == Kind::Unknown && source.slice(first.span) == "Eq";
    if !is_equation {
        return None;
    }
    parts(source, rest)?.try_into().ok()
}

/// What stands between commas in the parentheses, brackets or angle brackets that enclose all the tokens.
fn parts<'t>(source: Source<'_>, tokens: &'t [Token]) -> Option<Vec<&'t [Token]>> {
    let [first, inner @ .., last] = tokens else {
        return None;
    };
    let pair = [first, last].map(|token| source.slice(token.span));
    let are_parentheses = first.kind == Kind::Open && last.kind == Kind::Close;
    if !are_parentheses && !matches!(pair, ["<", ">"] | ["⟨", "⟩"] | ["〈", "〉"]) {
        return None;
    }
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
fn separated(source: Source<'_>, body: &[Token], result: &mut Vec<Token>) {
    let (mut depth, mut equals, mut i) = (0_usize, false, 0);
    let mut is_start = true;
    while let Some(&token) = body.get(i) {
        if is_start && let Some(length) = left_side(source, &body[i..]) {
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
            Kind::Comma if depth == 0 && equals && left_side(source, &body[i + 1..]).is_some() => {
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

/// Whether the tokens begin with `x =`, `x(t) =`, `x(u, v) =` or `y(x) =`, and how many there are before the `=`.
fn left_side(source: Source<'_>, tokens: &[Token]) -> Option<usize> {
    let Kind::Name(coordinate) = tokens.first()?.kind else {
        return None;
    };
    if coordinate != Name::R && !COORDINATES.contains(&coordinate) {
        return None;
    }
    let arguments = in_parentheses(source, &tokens[1..]);
    let length = match arguments {
        Some((variables, _)) if variables.contains(&coordinate) => return None,
        Some((_, length)) => 1 + length,
        None => 1,
    };
    (tokens.get(length)?.kind == Kind::Equals).then_some(length)
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

fn is_parameter(kind: Kind) -> bool {
    matches!(kind, Kind::Name(name) if name.is_parameter())
}
