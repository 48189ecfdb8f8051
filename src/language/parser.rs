//! Builds equations from tokens, by operator precedence after Pratt.

use super::budget::MAX_NESTING;
use super::name::{Name, similar_name};
use super::source::Source;
use super::syntax::{Equation, Expr, ExprKind, Occurrences};
use super::token::{Kind, SUPERSCRIPTS, Token};
use crate::error::{Invariant, Result};

// How tightly each operator binds its left and its right side.
const SUM: (u8, u8) = (1, 2);
const PRODUCT: (u8, u8) = (3, 4);
/// A sign binds less tightly than a power: −x² is −(x²).
const SIGN: u8 = 6;
/// Powers associate to the right: 2^3^2 is 2^9.
const POWER: (u8, u8) = (8, 7);

/// The equations of a text.
pub(super) fn parse(source: Source<'_>, tokens: &[Token]) -> Result<Vec<Equation>> {
    let mut parser = Parser {
        source,
        tokens,
        next: 0,
        names: Occurrences::default(),
    };
    let mut equations = Vec::new();
    while let Some(equation) = parser.equation()? {
        equations.push(equation);
    }
    Ok(equations)
}

struct Parser<'a> {
    source: Source<'a>,
    tokens: &'a [Token],
    next: usize,
    names: Occurrences,
}

impl Parser<'_> {
    /// The next token; the last one, [`Kind::End`], is never passed.
    fn peek(&self) -> Token {
        let last = self
            .tokens
            .last()
            .invariant("the tokens end with the end of the text");
        *self.tokens.get(self.next).unwrap_or(last)
    }

    fn advance(&mut self) -> Token {
        let token = self.peek();
        self.next += 1;
        token
    }

    fn take(&mut self, kind: Kind) -> Option<Token> {
        (self.peek().kind == kind).then(|| self.advance())
    }

    /// The name of a token in error messages.
    fn found(&self, token: Token) -> String {
        match token.kind {
            Kind::End => "the end of the text".into(),
            Kind::Newline => "the end of the line".into(),
            _ => self.source.quoted(token.span),
        }
    }

    /// Reads the next equation; `None` at the end of the text.
    fn equation(&mut self) -> Result<Option<Equation>> {
        loop {
            match self.peek().kind {
                Kind::Semicolon | Kind::Newline => {
                    self.advance();
                }
                // `ring R = 0, (x, y), dp;` adds nothing to the polynomial.
                Kind::Name(Name::Ring) => {
                    while !matches!(self.peek().kind, Kind::Semicolon | Kind::End) {
                        self.advance();
                    }
                }
                _ => break,
            }
        }
        if self.peek().kind == Kind::End {
            return Ok(None);
        }
        let polynomial_of_singular = self.take(Kind::Name(Name::Poly)).is_some();
        if polynomial_of_singular {
            self.advance();
            self.expect_equals()?;
        }
        self.names = Occurrences::default();
        let left = self.expression(0, 0)?;
        let right = match self.take(Kind::Equals) {
            Some(_) => Some(self.expression(0, 0)?),
            None => None,
        };
        let after = self.peek();
        if !matches!(after.kind, Kind::Semicolon | Kind::Newline | Kind::End) {
            return Err(self
                .source
                .error(after.span, self.not_after_an_equation(after)));
        }
        let names = std::mem::take(&mut self.names);
        Ok(Some(Equation { left, right, names }))
    }

    fn expect_equals(&mut self) -> Result<()> {
        let token = self.advance();
        if token.kind == Kind::Equals {
            return Ok(());
        }
        let message = format!(
            "expected `=` after the polynomial's name, found {}",
            self.found(token)
        );
        Err(self.source.error(token.span, message))
    }

    fn not_after_an_equation(&self, token: Token) -> String {
        match token.kind {
            Kind::Close => "`)` without a `(` before it".into(),
            Kind::Equals => "a second `=`; equations are separated by `;` or a new line".into(),
            Kind::Comma => {
                "a comma separates coordinates, as in `x = t^2, y = t^3` or `(t^2, t^3)`; \
                 decimals are written with a point, and a range of the parameter is left out"
                    .into()
            }
            Kind::Other => message_for_character(self.source.slice(token.span)),
            _ => format!(
                "expected an operator, `=` or the end, found {}",
                self.found(token)
            ),
        }
    }

    /// Reads an expression whose operators bind at least as tightly as `least`.
    fn expression(&mut self, least: u8, depth: u32) -> Result<Expr> {
        let mut left = self.operand(depth)?;
        loop {
            let token = self.peek();
            let (binds, right) = match token.kind {
                Kind::Plus | Kind::Minus => SUM,
                // Two factors side by side are a product, and bind like one written with `*`.
                Kind::Star | Kind::Slash | Kind::Name(_) | Kind::Unknown | Kind::Open => PRODUCT,
                Kind::Caret | Kind::Superscript => POWER,
                Kind::Number => {
                    let message = "a number after a factor; write `*` or `^` between them";
                    return Err(self.source.error(token.span, message));
                }
                _ => return Ok(left),
            };
            if binds < least {
                return Ok(left);
            }
            left = match token.kind {
                Kind::Plus | Kind::Minus => {
                    self.advance();
                    let part = self.expression(right, depth)?;
                    sum(left, token.kind == Kind::Minus, part)
                }
                Kind::Star | Kind::Slash => {
                    self.advance();
                    let part = self.expression(right, depth)?;
                    product(left, token.kind == Kind::Slash, part)
                }
                Kind::Caret => {
                    self.advance();
                    let next = self.peek();
                    if next.kind == Kind::Plus {
                        let message = "expected an exponent after `^`, such as 2";
                        return Err(self.source.error(next.span, message));
                    }
                    let exponent = self.expression(right, self.deeper(depth, token)?)?;
                    power(left, exponent)
                }
                Kind::Superscript => power(left, self.superscript()?),
                _ => {
                    let part = self.expression(right, depth)?;
                    product(left, false, part)
                }
            };
        }
    }

    /// Reads signs, then a number, a name, a call or an expression in parentheses.
    fn operand(&mut self, depth: u32) -> Result<Expr> {
        let first = self.peek();
        let (mut signs, mut negative) = (0, false);
        while let Kind::Plus | Kind::Minus = self.peek().kind {
            negative ^= self.advance().kind == Kind::Minus;
            signs += 1;
        }
        if signs > 0 {
            let inner = self.expression(SIGN, depth)?;
            if !negative {
                return Ok(inner);
            }
            return Ok(Expr {
                span: first.span.to(inner.span),
                kind: ExprKind::Negative(Box::new(inner)),
            });
        }
        let token = self.advance();
        let kind = match token.kind {
            Kind::Number => ExprKind::Number,
            Kind::Open => {
                let inner = self.expression(0, self.deeper(depth, token)?)?;
                self.expect_close(token)?;
                return Ok(inner);
            }
            Kind::Name(Name::Y) if self.is_harmonic(token) => {
                self.names.record(Name::Harmonic, token.span);
                return self.call(Name::Harmonic, token, depth);
            }
            Kind::Name(name) => {
                self.names.record(name, token.span);
                return self.named(name, token, depth);
            }
            Kind::Unknown => {
                let message = self.unknown_name(token);
                return Err(self.source.error(token.span, message));
            }
            Kind::Other => {
                let message = message_for_character(self.source.slice(token.span));
                return Err(self.source.error(token.span, message));
            }
            _ => {
                let message = format!(
                    "expected a number, a name or `(`, found {}",
                    self.found(token)
                );
                return Err(self.source.error(token.span, message));
            }
        };
        Ok(Expr {
            kind,
            span: token.span,
        })
    }

    /// Whether `Y` stands before parentheses with a comma in them, as in `Y(2, 0)`, or with one number.
    fn is_harmonic(&self, token: Token) -> bool {
        let rest = self.tokens.get(self.next..);
        let rest = rest.invariant("the next token is at most one behind the last");
        if self.source.slice(token.span) != "Y" || rest.first().map(|t| t.kind) != Some(Kind::Open)
        {
            return false;
        }
        let mut depth = 0_usize;
        for (i, token) in rest.iter().enumerate() {
            match token.kind {
                Kind::Open => depth += 1,
                Kind::Close if depth == 1 => return i == 2 && rest[1].kind == Kind::Number,
                Kind::Close => depth -= 1,
                Kind::Comma if depth == 1 => return true,
                _ => {}
            }
        }
        false
    }

    /// The message for a word that is not understood, with a similar name if there is one.
    fn unknown_name(&self, token: Token) -> String {
        let word = self.source.slice(token.span);
        let shown = self.source.quoted(token.span);
        let is_called = self.peek().kind == Kind::Open;
        if let Some(similar) = similar_name(word) {
            return format!("unknown name {shown}; a similar one is `{similar}`");
        }
        if is_called && word.len() > 1 {
            return format!(
                "unknown function {shown}: a formula stands alone, without the command that draws it; \
                 cos, sin, tan, cot, sec and csc are understood"
            );
        }
        format!(
            "unknown name {shown}; a Fourier radius uses the angle t or theta, a polynomial x, y, z, \
             parameters are t, theta, u, v, phi, s, w, and numbers stand in the place of other letters"
        )
    }

    fn named(&mut self, name: Name, token: Token, depth: u32) -> Result<Expr> {
        let shown = self.source.quoted(token.span);
        let refuse = |message: String| Err(self.source.error(token.span, message));
        match name {
            Name::Function => refuse(format!(
                "unknown function {shown}: it is not a finite Fourier series, not a polynomial and \
                 not algebraic in a parameter; cos, sin, tan, cot, sec and csc are understood"
            )),
            Name::Irrational if self.peek().kind == Kind::Open => self.call(name, token, depth),
            Name::Irrational => refuse(format!(
                "expected `(` after {shown}; only the square root of the square of a rational number is one"
            )),
            Name::Pow => self.call(name, token, depth),
            Name::Superquadric => refuse(format!("{shown} is not among {}", super::UNDERSTOOD)),
            Name::Ring | Name::Poly => refuse(format!("{shown} stands only before an equation")),
            Name::Rational => self.call(name, token, depth),
            _ if Name::OF_ANGLES.contains(&name) => self.call(name, token, depth),
            _ => Ok(Expr {
                kind: ExprKind::Name(name),
                span: token.span,
            }),
        }
    }

    fn call(&mut self, name: Name, function: Token, depth: u32) -> Result<Expr> {
        let open = self.advance();
        if open.kind != Kind::Open {
            let shown = self.source.slice(function.span);
            let message = format!(
                "expected `(` after `{shown}`, found {}; its argument stands in parentheses, as in {shown}(3*t)",
                self.found(open)
            );
            return Err(self.source.error(open.span, message));
        }
        let deeper = self.deeper(depth, open)?;
        let mut arguments = vec![self.expression(0, deeper)?];
        while self.take(Kind::Comma).is_some() {
            arguments.push(self.expression(0, deeper)?);
        }
        let close = self.expect_close(open)?;
        if name == Name::Pow {
            let [base, exponent]: [Expr; 2] = arguments.try_into().map_err(|_| {
                let message = "pow has a base and an exponent, as in pow(x, 2)";
                self.source.error(function.span, message)
            })?;
            return Ok(power(base, exponent));
        }
        Ok(Expr {
            kind: ExprKind::Call(name, arguments),
            span: function.span.to(close.span),
        })
    }

    fn expect_close(&mut self, open: Token) -> Result<Token> {
        let token = self.peek();
        match token.kind {
            Kind::Close if self.is_pair(open, token) => Ok(self.advance()),
            Kind::Close => {
                let message = format!(
                    "{} does not close {}",
                    self.source.quoted(token.span),
                    self.source.quoted(open.span)
                );
                Err(self.source.error(token.span, message))
            }
            Kind::End => Err(self.source.error(open.span, "this `(` is never closed")),
            Kind::Comma | Kind::Other => Err(self
                .source
                .error(token.span, self.not_after_an_equation(token))),
            _ => {
                let message = format!("expected an operator or `)`, found {}", self.found(token));
                Err(self.source.error(token.span, message))
            }
        }
    }

    /// Whether `close` closes `open`. Parentheses that were inserted around a bare argument have no text.
    fn is_pair(&self, open: Token, close: Token) -> bool {
        let texts = [open, close].map(|token| self.source.slice(token.span));
        matches!(texts, ["(", ")"] | ["[", "]"] | ["{", "}"] | ["", ""])
    }

    fn superscript(&mut self) -> Result<Expr> {
        let token = self.advance();
        let digits = self.source.slice(token.span).chars();
        let value = digits.fold(0_u32, |value, c| {
            let digit = (0..).zip(SUPERSCRIPTS).find(|&(_, s)| s == c);
            let (digit, _) = digit.invariant("a superscript is a digit");
            value.saturating_mul(10).saturating_add(digit)
        });
        self.no_second_exponent()?;
        Ok(Expr {
            kind: ExprKind::Integer(value),
            span: token.span,
        })
    }

    /// Refuses a second exponent: `x²³` is x^23, but `x² ³` and `x²^3` could each mean two things.
    fn no_second_exponent(&self) -> Result<()> {
        let after = self.peek();
        if matches!(after.kind, Kind::Caret | Kind::Superscript) {
            let message = "a second exponent; parentheses say what is meant";
            return Err(self.source.error(after.span, message));
        }
        Ok(())
    }

    fn deeper(&self, depth: u32, at: Token) -> Result<u32> {
        if depth < MAX_NESTING {
            return Ok(depth + 1);
        }
        let limit = format!("parentheses and powers nested more than {MAX_NESTING} deep");
        Err(self.source.limit(at.span, limit))
    }
}

/// The message for a character that has no meaning, which says what to write instead.
fn message_for_character(text: &str) -> String {
    let first = text.chars().next();
    let first = first.invariant("a token has characters");
    match first {
        '&' => "equations are separated by `;` or a new line".into(),
        '\\' | '$' => {
            "this is LaTeX, which is not read: write \\frac{a}{b} as (a)/(b), \\cdot as *, \\cos\\theta as cos(theta), and \
             leave \\left, \\right and $ out"
                .into()
        }
        '<' | '>' | '≤' | '≥' | '∈' | '.' | '…' => format!(
            "`{text}` belongs to a range or an inequality: a curve or surface is the boundary, with `=`, and a range of the \
             parameter is left out (plot --range t=0,6.28 draws a part)"
        ),
        '!' => "an equation has `=`".into(),
        '|' | '∣' => "absolute values are not polynomials; a superquadric has them, as in `superquadric 2d a=1,2 e=1/2`".into(),
        '"' | '\'' | '`' | '“' | '”' => "a quote within a formula; it is written without quotes".into(),
        '⁻' => "a negative superscript; write ^(-1), or divide".into(),
        _ if first.is_control() => format!("unexpected character: U+{:04X}", u32::from(first)),
        _ => format!("unexpected character: `{text}`"),
    }
}

fn sum(left: Expr, negative: bool, right: Expr) -> Expr {
    let span = left.span.to(right.span);
    let kind = match left.kind {
        ExprKind::Sum(mut parts) => {
            parts.push((negative, right));
            ExprKind::Sum(parts)
        }
        kind => ExprKind::Sum(vec![
            (
                false,
                Expr {
                    kind,
                    span: left.span,
                },
            ),
            (negative, right),
        ]),
    };
    Expr { kind, span }
}

fn product(left: Expr, divides: bool, right: Expr) -> Expr {
    let span = left.span.to(right.span);
    let kind = match left.kind {
        ExprKind::Product(mut parts) => {
            parts.push((divides, right));
            ExprKind::Product(parts)
        }
        kind => ExprKind::Product(vec![
            (
                false,
                Expr {
                    kind,
                    span: left.span,
                },
            ),
            (divides, right),
        ]),
    };
    Expr { kind, span }
}

fn power(base: Expr, exponent: Expr) -> Expr {
    let span = base.span.to(exponent.span);
    Expr {
        kind: ExprKind::Power(Box::new(base), Box::new(exponent)),
        span,
    }
}
