//! Recognises the heads of functions, which stand before a formula in other programs: `f(x, y) =`, `@(x, y)`, `lambda x, y:`,
//! `(x, y) ->`, `c(t) =`.

use super::name::{COORDINATES, Name};
use super::source::Source;
use super::token::{Kind, Token};

/// The head of a function: its variables, and the number of tokens before the formula.
pub(super) struct Head {
    pub(super) variables: Vec<Name>,
    pub(super) length: usize,
}

impl Head {
    /// Whether the variables are these.
    pub(super) fn is_of(&self, variables: &[Name]) -> bool {
        self.variables == variables
    }

    /// Whether the variables are one or two parameters.
    pub(super) fn is_of_parameters(&self) -> bool {
        self.variables.len() <= 2 && self.variables.iter().all(|name| name.is_parameter())
    }
}

/// The head with which the tokens begin, if there is one.
pub(super) fn head(source: Source<'_>, tokens: &[Token]) -> Option<Head> {
    let text = |i: usize| tokens.get(i).map(|t: &Token| source.slice(t.span));
    let kind = |i: usize| tokens.get(i).map(|t| t.kind);
    // `lambda x, y: …`
    if text(0) == Some("lambda") {
        let (variables, length) = listed(source, &tokens[1..])?;
        let head = Head {
            variables,
            length: length + 2,
        };
        return (text(length + 1) == Some(":")).then_some(head);
    }
    // `@(x, y) …`
    if text(0) == Some("@") {
        let (variables, length) = in_parentheses(source, &tokens[1..])?;
        return Some(Head {
            variables,
            length: length + 1,
        });
    }
    // `(x, y) -> …`, also after `f :=`
    let start = if kind(0) == Some(Kind::Unknown) && kind(1) == Some(Kind::Equals) {
        2
    } else {
        0
    };
    if let Some((variables, length)) = in_parentheses(source, &tokens[start..]) {
        let end = start + length;
        if kind(end) == Some(Kind::Minus) && text(end + 1) == Some(">") {
            return Some(Head {
                variables,
                length: end + 2,
            });
        }
    }
    // `f(x, y) = …`, for r and for any unknown name of at most two letters
    let is_name = match kind(0)? {
        Kind::Unknown => text(0)?.chars().count() <= 2,
        Kind::Name(name) => matches!(name, Name::R | Name::SpaceRadius),
        _ => false,
    };
    if !is_name {
        return None;
    }
    let (variables, length) = in_parentheses(source, &tokens[1..])?;
    let head = Head {
        variables,
        length: length + 2,
    };
    (kind(length + 1) == Some(Kind::Equals)).then_some(head)
}

/// Different variables between parentheses, and the number of tokens with the parentheses.
pub(super) fn in_parentheses(source: Source<'_>, tokens: &[Token]) -> Option<(Vec<Name>, usize)> {
    let (open, rest) = tokens.split_first()?;
    let (variables, length) = listed(source, rest)?;
    let is_closed = rest
        .get(length)
        .is_some_and(|token| token.kind == Kind::Close);
    (open.kind == Kind::Open && is_closed).then_some((variables, length + 2))
}

/// Different variables with commas between them, and the number of tokens. `_` may follow a variable, as in Mathematica.
fn listed(source: Source<'_>, tokens: &[Token]) -> Option<(Vec<Name>, usize)> {
    let (mut variables, mut length) = (Vec::new(), 0);
    loop {
        let Kind::Name(name) = tokens.get(length)?.kind else {
            return None;
        };
        if !(name.is_parameter() || COORDINATES.contains(&name)) || variables.contains(&name) {
            return None;
        }
        variables.push(name);
        length += 1;
        let next = tokens.get(length)?;
        length += usize::from(source.slice(next.span) == "_");
        match tokens.get(length)?.kind {
            Kind::Comma => length += 1,
            _ => return Some((variables, length)),
        }
    }
}
