//! Sums of terms in the notations of several systems.

use std::io::{self, Write};

use crate::exact::Rational;
use crate::poly::SparsePolynomial;

/// A notation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Notation {
    /// `1/3x^2y`
    Text,
    /// `1/3*x^2*y`, which Maple and Singular read as well.
    Explicit,
    /// `Rational(1, 3)*x**2*y`
    Python,
    /// `\frac{1}{3} x^{2} y`
    Latex,
    /// `\tfrac{1}{3} x^{2} y`
    LatexInline,
}

impl Notation {
    fn times(self) -> &'static str {
        match self {
            Notation::Text => "",
            Notation::Explicit | Notation::Python => "*",
            Notation::Latex | Notation::LatexInline => " ",
        }
    }

    /// `x^i y^j z^k`, empty for the constant monomial.
    pub(super) fn monomial(self, exponents: &[u32; 3]) -> String {
        let mut text = String::new();
        for (name, &exponent) in ['x', 'y', 'z'].iter().zip(exponents) {
            if exponent == 0 {
                continue;
            }
            if !text.is_empty() {
                text.push_str(self.times());
            }
            text.push(*name);
            if exponent > 1 {
                text.push_str(&match self {
                    Notation::Text | Notation::Explicit => format!("^{exponent}"),
                    Notation::Python => format!("**{exponent}"),
                    Notation::Latex | Notation::LatexInline => format!("^{{{exponent}}}"),
                });
            }
        }
        text
    }

    /// A polynomial in x, y, z.
    pub(crate) fn polynomial(self, f: &SparsePolynomial<3>) -> String {
        let terms = f.terms();
        let terms = terms.map(|(e, c)| (c.clone(), self.monomial(e)));
        let mut text = Vec::new();
        let written = self.write_sum(terms, &mut text);
        debug_assert!(written.is_ok(), "writing into memory succeeds");
        String::from_utf8_lossy(&text).into_owned()
    }

    /// A number that is not negative.
    fn number(self, value: &Rational, out: &mut dyn Write) -> io::Result<()> {
        if value.is_integer() {
            return write!(out, "{value}");
        }
        let (p, q) = (value.numerator(), value.denominator());
        match self {
            Notation::Text | Notation::Explicit => write!(out, "{p}/{q}"),
            Notation::Python => write!(out, "Rational({p}, {q})"),
            Notation::Latex => write!(out, "\\frac{{{p}}}{{{q}}}"),
            Notation::LatexInline => write!(out, "\\tfrac{{{p}}}{{{q}}}"),
        }
    }

    /// `c1 m1 + c2 m2 - …`; an empty m is the constant, the empty sum is 0.
    pub(super) fn write_sum(
        self,
        terms: impl Iterator<Item = (Rational, String)>,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let mut first = true;
        for (coefficient, monomial) in terms {
            let negative = coefficient.signum() < 0;
            out.write_all(match (first, negative) {
                (true, false) => b"",
                (true, true) => b"-",
                (false, false) => b" + ",
                (false, true) => b" - ",
            })?;
            first = false;
            let magnitude = coefficient.abs();
            if monomial.is_empty() {
                self.number(&magnitude, out)?;
                continue;
            }
            if magnitude != Rational::one() {
                self.number(&magnitude, out)?;
                out.write_all(self.times().as_bytes())?;
            }
            out.write_all(monomial.as_bytes())?;
        }
        if first {
            out.write_all(b"0")?;
        }
        Ok(())
    }
}
