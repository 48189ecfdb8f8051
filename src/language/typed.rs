//! Translates spellings of other programs and of textbooks into the tokens of the grammar.
//!
//! | typed | read as |
//! | --- | --- |
//! | `(t^2, t^3)`, `[t^2, t^3]` | `x = t^2; y = t^3`; a third formula is `z = …` |
//! | `x = t^2, y = t^3` | `x = t^2; y = t^3` |
//! | `x(t) = …`, `r(theta) = …`, `y(x) = …` | `x = …`, `r = …`, `y = …` |
//! | `[x = t^2, y = t^3]`, `c(t) = (t^2, t^3)`, `<t^2, t^3>` | `x = t^2; y = t^3` |
//! | `(x^2 + y^2 - 1, z - y^5)` | `x^2 + y^2 - 1; z - y^5`, because x, y or z occurs in it |
//! | `f(x, y) = …`, `@(x, y) …`, `lambda x, y: …`, `(x, y) -> …` | the polynomial; if z is among the variables, a surface |
//! | `f(x) = …` | `y = …` |
//! | `Eq(a, b)`, `a == b`, `a := b` | `a = b` |
//! | `x.^2`, `Cos[t]`, `{t, t^2}` | as in MATLAB and Mathematica |
//! | `cos t`, `sin 3t` | `cos(t)`, `sin(3t)`, unless what follows could belong to the argument, as in `cos t^2` or `cos t/2` |
//! | `cos^2(t)`, `sin²(t)` | `cos(t)^2`, `sin(t)^2` |

use super::heads::{head, in_parentheses};
use super::name::{COORDINATES, Name};
use super::source::{Source, Span};
use super::token::{Kind, Token};
use crate::error::Result;

/// The tokens of the grammar that mean the same as the given ones; the last one stays [`Kind::End`].
///
/// # Errors
/// [`crate::error::Error::Syntax`] for a tuple of more than three coordinates.
pub(super) fn understood(source: Source<'_>, tokens: &[Token]) -> Result<Vec<Token>> {
    let tokens = with_commas(tokens);
    let mut result = Vec::with_capacity(tokens.len());
    for equation in tokens.split_inclusive(|t| ends_an_equation(t.kind)) {
        translate_equation(source, equation, &mut result)?;
    }
    Ok(with_arguments(&result))
}

fn ends_an_equation(kind: Kind) -> bool {
    matches!(kind, Kind::Semicolon | Kind::Newline | Kind::End)
}

/// The tokens with commas in place of semicolons within parentheses, as in `[cos(t); sin(t)]`. If a parenthesis is not closed,
/// nothing is changed.
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

/// Translates one equation with the token that ends it. It may be several equations with commas between them.
fn translate_equation(source: Source<'_>, tokens: &[Token], result: &mut Vec<Token>) -> Result<()> {
    let Some((end, body)) = tokens.split_last() else {
        return Ok(());
    };
    let body = without_final_mark(source, body);
    if let Some([left, right]) = sympy_equation(source, body) {
        result.extend_from_slice(left);
        result.push(Token {
            kind: Kind::Equals,
            span: body[1].span,
        });
        result.extend_from_slice(right);
    } else if !translate_function(source, body, result)? && !translate_list(source, body, result)? {
        translate_separated(source, body, result);
    }
    result.push(*end);
    Ok(())
}

/// The tokens without a comma or a colon at their end. A comma may end a line, and in Maple a colon ends a statement.
fn without_final_mark<'t>(source: Source<'_>, body: &'t [Token]) -> &'t [Token] {
    match body.split_last() {
        Some((last, rest)) if last.kind == Kind::Comma || source.slice(last.span) == ":" => rest,
        _ => body,
    }
}

/// Translates a function, if the tokens are one, and returns whether they are. `f(x, y) = …` becomes the polynomial, `f(x) = …`
/// the graph, and `c(t) = (…)` or `(x, y) = (…)` the curve.
fn translate_function(source: Source<'_>, body: &[Token], result: &mut Vec<Token>) -> Result<bool> {
    let [x, y, z] = COORDINATES;
    if let Some((variables, length)) = in_parentheses(source, body)
        && (variables == [x, y] || variables == COORDINATES)
        && body.get(length).is_some_and(|t| t.kind == Kind::Equals)
    {
        return translate_list(source, &body[length + 1..], result);
    }
    let Some(head) = head(source, body) else {
        return Ok(false);
    };
    let (before, formula) = body.split_at(head.length);
    let at = before[0].span;
    let token = |kind| Token { kind, span: at };
    if head.is_of_parameters() {
        return translate_list(source, formula, result);
    } else if head.is_of(&[x]) {
        result.extend([token(Kind::Name(y)), token(Kind::Equals)]);
        result.extend_from_slice(formula);
    } else if head.is_of(&[x, y]) {
        result.extend_from_slice(formula);
    } else if head.is_of(&COORDINATES) {
        // z must occur in an equation of a surface.
        result.extend_from_slice(formula);
        result.extend([Kind::Plus, Kind::Name(z), Kind::Minus, Kind::Name(z)].map(token));
    } else {
        return Ok(false);
    }
    Ok(true)
}

/// Translates a list of coordinates, of polynomials or of equations, with commas between them in one pair of parentheses or
/// brackets. Returns whether the tokens are such a list.
fn translate_list(source: Source<'_>, body: &[Token], result: &mut Vec<Token>) -> Result<bool> {
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
            translate_separated(source, part, result);
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

/// The two sides of `Eq(left, right)`.
fn sympy_equation<'t>(source: Source<'_>, body: &'t [Token]) -> Option<[&'t [Token]; 2]> {
    let (first, rest) = body.split_first()?;
    let is_equation = first.kind == Kind::Unknown && source.slice(first.span) == "Eq";
    if !is_equation {
        return None;
    }
    parts(source, rest)?.try_into().ok()
}

/// The parts between the commas in the parentheses, brackets or angle brackets that enclose all the tokens; `None` if there are
/// no such parentheses.
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
            // If this fails, the first parenthesis is closed before the last token.
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

/// Translates equations with commas between them: the commas become semicolons, and the arguments on the left sides are
/// removed.
fn translate_separated(source: Source<'_>, body: &[Token], result: &mut Vec<Token>) {
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

/// The number of tokens before the `=`, if the tokens begin with `x =`, `x(t) =`, `x(u, v) =` or `y(x) =`.
fn left_side(source: Source<'_>, tokens: &[Token]) -> Option<usize> {
    let Kind::Name(coordinate) = tokens.first()?.kind else {
        return None;
    };
    if ![Name::R, Name::SpaceRadius].contains(&coordinate) && !COORDINATES.contains(&coordinate) {
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

/// The tokens in which functions of angles have parentheses around their arguments, and their exponents behind these.
fn with_arguments(tokens: &[Token]) -> Vec<Token> {
    let mut result: Vec<Token> = Vec::with_capacity(tokens.len());
    // For each open parenthesis, the exponent that must follow it when it is closed.
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

/// The number of tokens of a natural exponent, `^2` or `²`; 0 if there is none.
fn exponent(tokens: &[Token]) -> usize {
    match tokens {
        [caret, number, ..] if caret.kind == Kind::Caret && number.kind == Kind::Number => 2,
        [superscript, ..] if superscript.kind == Kind::Superscript => 1,
        _ => 0,
    }
}

/// The number of tokens of an argument `t`, `3t` or `3*t`, if it is clear from the next token that the argument ends there.
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
