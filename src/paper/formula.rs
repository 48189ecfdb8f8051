//! Formulas in any symbols. The paper's numbered equations are stored as such formulas.
//!
//! A formula consists of sums, products, quotients, natural powers, exact numbers and parentheses. A symbol is a letter and the
//! letters and digits that follow it. Products are written with `*`.

use crate::error::{Error, Result};
use crate::exact::{Rational, exact_literal};

/// A formula as it is written.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Formula {
    /// An exact number.
    Number(Rational),
    /// A symbol.
    Symbol(String),
    /// A sum of parts; `true` marks a part that is subtracted.
    Sum(Vec<(bool, Formula)>),
    /// The product of two factors.
    Product(Box<Formula>, Box<Formula>),
    /// A quotient.
    Quotient(Box<Formula>, Box<Formula>),
    /// A power with a natural exponent.
    Power(Box<Formula>, u32),
}

impl Formula {
    /// Reads a formula.
    ///
    /// ```
    /// use stellate::paper::Formula;
    /// assert!(Formula::parse("A + B - p/(3*s)").is_ok());
    /// let error = Formula::parse("A + (B").unwrap_err();
    /// assert!(error.to_string().contains("expected `)`"));
    /// ```
    ///
    /// # Errors
    /// [`Error::Syntax`] at the first character that does not fit.
    pub fn parse(text: &str) -> Result<Self> {
        let mut reader = Reader { text, at: 0 };
        let formula = reader.sum()?;
        match reader.peek() {
            None => Ok(formula),
            Some(_) => Err(reader.expected("an operator or the end")),
        }
    }

    /// The two sides of `left = right`.
    ///
    /// # Errors
    /// As [`Formula::parse`]; [`Error::Usage`] if there is not exactly one `=`.
    pub fn parse_equation(text: &str) -> Result<[Self; 2]> {
        match text.split('=').collect::<Vec<_>>()[..] {
            [left, right] => Ok([Self::parse(left)?, Self::parse(right)?]),
            _ => Err(Error::Usage(format!(
                "`{text}`: expected one equation `left = right`"
            ))),
        }
    }
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
}

impl Reader<'_> {
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.text[self.at..].chars().next()
    }

    fn take(&mut self, wanted: char) -> bool {
        let there = self.peek() == Some(wanted);
        if there {
            self.at += wanted.len_utf8();
        }
        there
    }

    fn expected(&self, what: &str) -> Error {
        Error::Syntax {
            message: format!("expected {what}"),
            source_name: "<formula>".into(),
            text: self.text.into(),
            at: self.at,
        }
    }

    /// Reads the longest run of characters that `belongs` accepts.
    fn run(&mut self, belongs: impl Fn(char) -> bool) -> &str {
        let rest = &self.text[self.at..];
        let length = rest.find(|c| !belongs(c)).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    fn sum(&mut self) -> Result<Formula> {
        let mut parts = vec![(self.take('-'), self.product()?)];
        loop {
            let subtracted = match self.peek() {
                Some('+') => false,
                Some('-') => true,
                _ => break,
            };
            self.at += 1;
            parts.push((subtracted, self.product()?));
        }
        Ok(match parts.pop() {
            Some((false, only)) if parts.is_empty() => only,
            Some(last) => {
                parts.push(last);
                Formula::Sum(parts)
            }
            None => Formula::Sum(parts),
        })
    }

    fn product(&mut self) -> Result<Formula> {
        let mut result = self.power()?;
        loop {
            if self.take('*') {
                result = Formula::Product(Box::new(result), Box::new(self.power()?));
            } else if self.take('/') {
                result = Formula::Quotient(Box::new(result), Box::new(self.power()?));
            } else {
                return Ok(result);
            }
        }
    }

    fn power(&mut self) -> Result<Formula> {
        let base = self.atom()?;
        if !self.take('^') {
            return Ok(base);
        }
        self.peek();
        let start = self.at;
        match self.run(|c| c.is_ascii_digit()).parse() {
            Ok(exponent) => Ok(Formula::Power(Box::new(base), exponent)),
            Err(_) => {
                self.at = start;
                Err(self.expected("an exponent, a whole number"))
            }
        }
    }

    fn atom(&mut self) -> Result<Formula> {
        match self.peek() {
            Some('(') => {
                self.at += 1;
                let inner = self.sum()?;
                if self.take(')') {
                    Ok(inner)
                } else {
                    Err(self.expected("`)`"))
                }
            }
            Some(c) if c.is_ascii_digit() => {
                let number = self.run(|c| c.is_ascii_digit() || c == '.');
                Ok(Formula::Number(exact_literal(number)?))
            }
            Some(c) if c.is_alphabetic() => {
                Ok(Formula::Symbol(self.run(char::is_alphanumeric).to_owned()))
            }
            _ => Err(self.expected("a number, a symbol or `(`")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn precedence() {
        let read = |text| Formula::parse(text).ok();
        assert_eq!(read("a - b*c^2/d"), read("a - (((b)*(c^2))/d)"));
        assert_eq!(read("-a + b"), read("(-a + b)"));
        assert_ne!(read("a/b*c"), read("a/(b*c)"));
        assert_eq!(read("0.1*x1"), read("1/10*x1").and(read("0.1 * x1")));
    }

    #[test]
    fn errors_point_at_the_place() {
        for (text, at) in [("a + ", 4), ("a^b", 2), ("(a", 2), ("a b", 2), ("", 0)] {
            match Formula::parse(text) {
                Err(Error::Syntax { at: found, .. }) => assert_eq!(found, at, "{text}"),
                other => panic!("{other:?}"),
            }
        }
    }
}
