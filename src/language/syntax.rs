//! The results of the parser: equations between expressions, in which every part has its place in the text.

use super::name::{COORDINATES, NAMES, Name, PARAMETERS};
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
    /// A literal, which is the text of the span.
    Number,
    /// The value of a superscript.
    Integer(u32),
    Name(Name),
    Negative(Box<Expr>),
    /// The parts of a sum; `true` marks a part that is subtracted.
    Sum(Vec<(bool, Expr)>),
    /// The parts of a product; `true` marks a part that divides the product of those before it.
    Product(Vec<(bool, Expr)>),
    Power(Box<Expr>, Box<Expr>),
    Call(Name, Vec<Expr>),
}

/// An equation `left = right`, or a single expression `left`.
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

impl Equation {
    /// Exchanges the sides of `1 + cos(t) = r`, so that the coordinate or the radius stands on the left.
    pub(super) fn turn(&mut self) {
        let Some(right) = &mut self.right else { return };
        let is_given = |expr: &Expr| {
            COORDINATES
                .iter()
                .chain([&Name::R, &Name::SpaceRadius])
                .any(|name| expr.is_name(*name))
        };
        let varies = self.names.any(&PARAMETERS) || self.names.any(&Name::OF_ANGLES);
        if varies && is_given(right) && !is_given(&self.left) {
            std::mem::swap(&mut self.left, right);
        }
    }
}

impl Expr {
    /// The expressions of which this one consists.
    pub(super) fn children(&self) -> Vec<&Expr> {
        match &self.kind {
            ExprKind::Number | ExprKind::Integer(_) | ExprKind::Name(_) => Vec::new(),
            ExprKind::Negative(inner) => vec![inner],
            ExprKind::Sum(parts) | ExprKind::Product(parts) => {
                parts.iter().map(|(_, part)| part).collect()
            }
            ExprKind::Power(base, exponent) => vec![base, exponent],
            ExprKind::Call(_, arguments) => arguments.iter().collect(),
        }
    }

    /// Whether a name occurs for which `is_one` holds.
    pub(super) fn mentions(&self, is_one: impl Fn(Name) -> bool + Copy) -> bool {
        let is_named = matches!(self.kind, ExprKind::Name(name) if is_one(name));
        is_named || self.children().iter().any(|part| part.mentions(is_one))
    }

    /// Whether no name occurs, so that the expression is a number.
    pub(super) fn is_number(&self) -> bool {
        !self.mentions(|_| true)
    }

    /// Whether the expression is this name and nothing else.
    pub(super) fn is_name(&self, name: Name) -> bool {
        matches!(self.kind, ExprKind::Name(n) if n == name)
    }
}
