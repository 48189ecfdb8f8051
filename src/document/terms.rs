//! Sums of terms in the notations of several systems.

use std::borrow::Cow;
use std::fmt;
use std::io::{self, Write};

use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural};

use super::in_order::write_in_order;
use crate::exact::Rational;
use crate::poly::SparsePolynomial;

/// A coefficient, lent where it can be: it may be long.
#[derive(Clone, Debug)]
pub(super) enum Number<'a> {
    Integer(&'a Integer),
    Rational(Cow<'a, Rational>),
}

impl From<Rational> for Number<'_> {
    fn from(value: Rational) -> Self {
        Self::Rational(Cow::Owned(value))
    }
}

impl<'a> From<&'a Rational> for Number<'a> {
    fn from(value: &'a Rational) -> Self {
        Self::Rational(Cow::Borrowed(value))
    }
}

impl<'a> From<&'a Integer> for Number<'a> {
    fn from(value: &'a Integer) -> Self {
        Self::Integer(value)
    }
}

impl Number<'_> {
    fn is_negative(&self) -> bool {
        match self {
            Self::Integer(value) => **value < 0,
            Self::Rational(value) => value.signum() < 0,
        }
    }

    /// The sign aside: p and q, no q for an integer.
    fn magnitude(&self) -> (&Natural, Option<&Natural>) {
        match self {
            Self::Integer(value) => (value.unsigned_abs_ref(), None),
            Self::Rational(value) => {
                let below = (!value.is_integer()).then(|| value.denominator_ref());
                (value.magnitude_ref(), below)
            }
        }
    }

    /// About as many bytes as digits.
    pub(super) fn size(&self) -> u64 {
        let (above, below) = self.magnitude();
        let bits = above.significant_bits() + below.map_or(0, |q| q.significant_bits());
        // log 2 = 0.301
        bits * 3 / 10 + 1
    }
}

impl fmt::Display for Number<'_> {
    /// `-1/3`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_negative() {
            f.write_str("-")?;
        }
        match self.magnitude() {
            (p, None) => write!(f, "{p}"),
            (p, Some(q)) => write!(f, "{p}/{q}"),
        }
    }
}

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
        let terms = terms.map(|(e, c)| (c, self.monomial(e)));
        let mut text = Vec::new();
        let written = self.write_sum(terms, &mut text);
        debug_assert!(written.is_ok(), "writing into memory succeeds");
        String::from_utf8_lossy(&text).into_owned()
    }

    /// A number that is not negative.
    fn number(self, (p, q): (&Natural, Option<&Natural>), out: &mut Vec<u8>) -> io::Result<()> {
        let Some(q) = q else {
            return write!(out, "{p}");
        };
        match self {
            Notation::Text | Notation::Explicit => write!(out, "{p}/{q}"),
            Notation::Python => write!(out, "Rational({p}, {q})"),
            Notation::Latex => write!(out, "\\frac{{{p}}}{{{q}}}"),
            Notation::LatexInline => write!(out, "\\tfrac{{{p}}}{{{q}}}"),
        }
    }

    /// `c1 m1 + c2 m2 - …`; an empty m is the constant, the empty sum is 0.
    pub(super) fn write_sum<'a, N: Into<Number<'a>>>(
        self,
        terms: impl Iterator<Item = (N, String)>,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let terms = terms.map(|(c, monomial)| (c.into(), monomial));
        let mut terms = terms.enumerate().peekable();
        if terms.peek().is_none() {
            return out.write_all(b"0");
        }
        let size =
            |(_, (c, monomial)): &(usize, (Number<'a>, String))| c.size() + monomial.len() as u64;
        let append = |(n, (c, monomial)): &(usize, (Number<'a>, String)), text: &mut Vec<u8>| {
            self.append_term(*n == 0, c, monomial, text)
        };
        write_in_order(terms, size, append, out)
    }

    /// ` - c m`
    fn append_term(
        self,
        first: bool,
        coefficient: &Number<'_>,
        monomial: &str,
        text: &mut Vec<u8>,
    ) -> io::Result<()> {
        text.extend_from_slice(match (first, coefficient.is_negative()) {
            (true, false) => b"",
            (true, true) => b"-",
            (false, false) => b" + ",
            (false, true) => b" - ",
        });
        let magnitude = coefficient.magnitude();
        if monomial.is_empty() {
            return self.number(magnitude, text);
        }
        if magnitude != (&Natural::ONE, None) {
            self.number(magnitude, text)?;
            text.extend_from_slice(self.times().as_bytes());
        }
        text.extend_from_slice(monomial.as_bytes());
        Ok(())
    }
}
