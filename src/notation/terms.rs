//! Sums of terms, written in the notations of several systems.

use std::borrow::Cow;
use std::io::Write;

use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural};

use super::in_order::write_in_order;
use crate::bigint::append_decimal;
use crate::error::Result;
use crate::exact::Rational;
use crate::poly::SparsePolynomial;

/// A coefficient, by reference if possible, because it may be long.
#[derive(Clone, Debug)]
pub(crate) enum Number<'a> {
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

    /// The absolute value as p and q; q is `None` for an integer.
    fn magnitude(&self) -> (&Natural, Option<&Natural>) {
        match self {
            Self::Integer(value) => (value.unsigned_abs_ref(), None),
            Self::Rational(value) => {
                let below = (!value.is_integer()).then(|| value.denominator_ref());
                (value.magnitude_ref(), below)
            }
        }
    }

    /// About the number of digits.
    pub(crate) fn size(&self) -> u64 {
        let (above, below) = self.magnitude();
        let bits = above.significant_bits() + below.map_or(0, |q| q.significant_bits());
        // log10(2) = 0.301…
        bits * 3 / 10 + 1
    }

    /// Appends the number, such as `-1/3`.
    pub(crate) fn append(&self, text: &mut Vec<u8>) {
        if self.is_negative() {
            text.push(b'-');
        }
        append_fraction(["", "/", ""], self.magnitude(), text);
    }
}

/// The factor of a coefficient in a term.
#[derive(Clone, Debug)]
pub(crate) enum Monomial {
    /// The product `x^i y^j z^k`.
    Powers([u32; 3]),
    /// A product as text; empty for 1.
    Written(String),
}

impl From<[u32; 3]> for Monomial {
    fn from(exponents: [u32; 3]) -> Self {
        Self::Powers(exponents)
    }
}

impl From<String> for Monomial {
    fn from(text: String) -> Self {
        Self::Written(text)
    }
}

impl Monomial {
    /// A number of bytes that is enough for most monomials.
    fn size(&self) -> u64 {
        match self {
            Self::Powers(_) => 20,
            Self::Written(text) => text.len() as u64,
        }
    }

    fn is_one(&self) -> bool {
        match self {
            Self::Powers(exponents) => *exponents == [0; 3],
            Self::Written(text) => text.is_empty(),
        }
    }
}

/// Appends a small number in decimal.
pub(crate) fn append_word(word: u32, text: &mut Vec<u8>) {
    text.extend_from_slice(itoa::Buffer::new().format(word).as_bytes());
}

/// Appends p, or p and q, with the given texts before, between and after them.
fn append_fraction(around: [&str; 3], (p, q): (&Natural, Option<&Natural>), text: &mut Vec<u8>) {
    let Some(q) = q else {
        return append_decimal(p, text);
    };
    let [before, between, after] = around;
    text.extend_from_slice(before.as_bytes());
    append_decimal(p, text);
    text.extend_from_slice(between.as_bytes());
    append_decimal(q, text);
    text.extend_from_slice(after.as_bytes());
}

/// A notation of a system.
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

    /// The text of the product `x^i y^j z^k`; empty for the constant monomial.
    pub(crate) fn monomial(self, exponents: &[u32; 3]) -> String {
        let mut text = Vec::new();
        self.append_powers(exponents, &mut text);
        String::from_utf8_lossy(&text).into_owned()
    }

    fn append_powers(self, exponents: &[u32; 3], text: &mut Vec<u8>) {
        let mut times = "";
        let factors = b"xyz".iter().zip(exponents);
        for (name, &exponent) in factors.filter(|(_, exponent)| **exponent > 0) {
            text.extend_from_slice(times.as_bytes());
            times = self.times();
            text.push(*name);
            if exponent > 1 {
                let [before, after] = self.raised();
                text.extend_from_slice(before.as_bytes());
                append_word(exponent, text);
                text.extend_from_slice(after.as_bytes());
            }
        }
    }

    /// The texts before and after an exponent.
    fn raised(self) -> [&'static str; 2] {
        match self {
            Notation::Text | Notation::Explicit => ["^", ""],
            Notation::Python => ["**", ""],
            Notation::Latex | Notation::LatexInline => ["^{", "}"],
        }
    }

    /// The text of a polynomial in x, y, z.
    pub(crate) fn polynomial(self, f: &SparsePolynomial<3>) -> String {
        let terms = f.terms();
        let terms = terms.map(|(e, c)| (c, *e));
        let mut text = Vec::new();
        let written = self.write_sum(terms, &mut text);
        debug_assert!(written.is_ok(), "writing into memory succeeds");
        String::from_utf8_lossy(&text).into_owned()
    }

    /// Appends a number that is not negative.
    fn append_number(self, number: (&Natural, Option<&Natural>), text: &mut Vec<u8>) {
        let around = match self {
            Notation::Text | Notation::Explicit => ["", "/", ""],
            Notation::Python => ["Rational(", ", ", ")"],
            Notation::Latex => ["\\frac{", "}{", "}"],
            Notation::LatexInline => ["\\tfrac{", "}{", "}"],
        };
        append_fraction(around, number, text);
    }

    /// Writes the sum `c1 m1 + c2 m2 - …`; an empty sum is 0.
    pub(crate) fn write_sum<'a, N: Into<Number<'a>>, M: Into<Monomial>>(
        self,
        terms: impl Iterator<Item = (N, M)>,
        out: &mut dyn Write,
    ) -> Result<()> {
        let terms = terms.enumerate().map(|(n, (c, monomial))| Term {
            is_first: n == 0,
            coefficient: c.into(),
            monomial: monomial.into(),
        });
        let mut terms = terms.peekable();
        if terms.peek().is_none() {
            return Ok(out.write_all(b"0")?);
        }
        let size = |term: &Term| term.coefficient.size() + term.monomial.size();
        Ok(write_in_order(
            terms,
            size,
            |term, text| self.append_term(term, text),
            out,
        )?)
    }

    /// Appends a term that is not the first, such as ` - c m`.
    fn append_term(self, term: &Term<'_>, text: &mut Vec<u8>) {
        let Term {
            is_first,
            coefficient,
            monomial,
        } = term;
        text.extend_from_slice(match (is_first, coefficient.is_negative()) {
            (true, false) => b"",
            (true, true) => b"-",
            (false, false) => b" + ",
            (false, true) => b" - ",
        });
        let magnitude = coefficient.magnitude();
        if monomial.is_one() {
            return self.append_number(magnitude, text);
        }
        if magnitude != (&Natural::ONE, None) {
            self.append_number(magnitude, text);
            text.extend_from_slice(self.times().as_bytes());
        }
        match monomial {
            Monomial::Powers(exponents) => self.append_powers(exponents, text),
            Monomial::Written(written) => text.extend_from_slice(written.as_bytes()),
        }
    }
}

/// A term of a sum.
struct Term<'a> {
    is_first: bool,
    coefficient: Number<'a>,
    monomial: Monomial,
}

/// The text of a polynomial in x, y, z in the input language.
pub(crate) fn polynomial_text(f: &SparsePolynomial<3>) -> String {
    Notation::Text.polynomial(f)
}
