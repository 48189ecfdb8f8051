//! What the parser builds: equations between expressions, every piece with its place in the text.

use super::name::{NAMES, Name};
use super::source::Span;

/// An expression. Sums and products are flat, and [`super::budget::MAX_NESTING`] bounds the depth
/// of the rest, so walking or dropping one cannot overflow the stack.
#[derive(Clone, Debug)]
pub(super) struct Expr {
    pub(super) kind: ExprKind,
    pub(super) span: Span,
}

#[derive(Clone, Debug)]
pub(super) enum ExprKind {
    /// A literal: the text of the span.
    Number,
    /// A superscript.
    Integer(u32),
    Name(Name),
    Negative(Box<Expr>),
    /// Each part, and whether it is subtracted.
    Sum(Vec<(bool, Expr)>),
    /// Each part, and whether it divides what is to its left.
    Product(Vec<(bool, Expr)>),
    Power(Box<Expr>, Box<Expr>),
    Call(Name, Vec<Expr>),
}

/// `left = right`, or just `left`.
#[derive(Debug)]
pub(super) struct Equation {
    pub(super) left: Expr,
    pub(super) right: Option<Expr>,
    pub(super) names: Occurrences,
}

/// Where each name first occurs in an equation.
#[derive(Debug, Default)]
pub(super) struct Occurrences([Option<Span>; NAMES]);

impl Occurrences {
    pub(super) fn record(&mut self, name: Name, at: Span) {
        let slot = &mut self.0[name as usize];
        if slot.is_none() {
            *slot = Some(at);
        }
    }

    pub(super) fn first(&self, name: Name) -> Option<Span> {
        self.0[name as usize]
    }

    pub(super) fn any(&self, names: &[Name]) -> bool {
        names.iter().any(|&n| self.first(n).is_some())
    }
}

impl Expr {
    /// Whether this is the bare name.
    pub(super) fn is_name(&self, name: Name) -> bool {
        matches!(self.kind, ExprKind::Name(n) if n == name)
    }
}
