//! Decides whether two formulas are the same rational function. Expansion proves it, or values at a point refute it.

use std::collections::BTreeMap;

use super::formula::Formula;
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::poly::{Ring, SparsePolynomial};

/// The largest number of symbols in one entry.
const SYMBOLS: usize = 16;

/// A polynomial in the symbols of one entry.
pub(super) type Polynomial = SparsePolynomial<SYMBOLS>;

/// A quotient of two polynomials, not in lowest terms.
#[derive(Clone, Debug)]
struct Quotient {
    above: Polynomial,
    below: Polynomial,
}

impl Quotient {
    fn polynomial(above: Polynomial) -> Self {
        let below = Polynomial::constant(Rational::one());
        Self { above, below }
    }

    fn plus(&self, other: &Self, sign: i64) -> Self {
        let sign = Rational::from(sign);
        if self.below == other.below {
            let mut above = self.above.clone();
            above.add_multiple(&other.above, &sign);
            return Self {
                above,
                below: self.below.clone(),
            };
        }
        let mut above = self.above.times(&other.below);
        above.add_multiple(&other.above.times(&self.below), &sign);
        Self {
            above,
            below: self.below.times(&other.below),
        }
        .without_common_monomial()
    }

    fn times(&self, other: &Self) -> Self {
        Self {
            above: self.above.times(&other.above),
            below: self.below.times(&other.below),
        }
        .without_common_monomial()
    }

    fn recip(&self) -> Option<Self> {
        (!self.above.is_empty()).then(|| Self {
            above: self.below.clone(),
            below: self.above.clone(),
        })
    }

    /// The quotient after division of numerator and denominator by their largest common monomial, so that powers of one symbol
    /// do not accumulate.
    fn without_common_monomial(self) -> Self {
        let common: [u32; SYMBOLS] = std::array::from_fn(|i| {
            let terms = self.above.terms().chain(self.below.terms());
            let least = terms.map(|(e, _)| e[i]).min();
            least.invariant("a denominator has a term")
        });
        if common == [0; SYMBOLS] {
            return self;
        }
        let divided = |f: &Polynomial| {
            Polynomial::from_terms(
                f.terms()
                    .map(|(e, c)| (std::array::from_fn(|i| e[i] - common[i]), c.clone())),
            )
        };
        Self {
            above: divided(&self.above),
            below: divided(&self.below),
        }
    }
}

/// The definitions of symbols, and known squares such as `s^2 = 1 - c^2`.
#[derive(Debug, Default)]
pub(super) struct Meanings {
    symbols: Vec<String>,
    values: BTreeMap<String, Quotient>,
    squares: Vec<(usize, Polynomial)>,
    /// Whether a formula that was evaluated so far divides by zero.
    divides_by_zero: bool,
}

/// The result of a comparison of two formulas.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Comparison {
    /// The sides are equal identically.
    Equal,
    /// The sides are not equal. The text says why, without a full stop: it gives a point with the different values of both
    /// sides or, if no point was found or squares are known, the size of the numerator of their difference.
    Different(String),
}

impl Meanings {
    /// Reads definitions `p = -s*(a + b); …`, each in terms of the symbols before it, and known squares `w^2 = -3; …`.
    ///
    /// # Errors
    /// Those of [`Formula::parse_equation`]; [`Error::Usage`] if the left side of a definition is not a symbol or has a meaning
    /// already, or if a square is not that of a symbol or not a polynomial.
    pub(super) fn new(definitions: &str, squares: &str) -> Result<Self> {
        let mut meanings = Self::default();
        let equations = |text: &str| {
            let parts = text.split(';').map(str::trim).filter(|t| !t.is_empty());
            parts
                .map(Formula::parse_equation)
                .collect::<Result<Vec<_>>>()
        };
        for [left, right] in equations(squares)? {
            let (Formula::Power(base, 2), square) = (left, meanings.value(&right)?) else {
                return Err(Error::Usage(format!("`{squares}`: expected `w^2 = …`")));
            };
            let Formula::Symbol(name) = *base else {
                return Err(Error::Usage(format!("`{squares}`: expected `w^2 = …`")));
            };
            if square.below.as_constant() != Some(Rational::one()) {
                return Err(Error::Usage(format!("`{squares}`: expected a polynomial")));
            }
            let index = meanings.index(&name)?;
            meanings.squares.push((index, square.above));
        }
        for [left, right] in equations(definitions)? {
            let Formula::Symbol(name) = left else {
                return Err(Error::Usage(format!("`{definitions}`: expected `p = …`")));
            };
            let value = meanings.value(&right)?;
            if meanings.symbols.contains(&name) || meanings.values.contains_key(&name) {
                return Err(Error::Usage(format!(
                    "`{definitions}`: {name} is defined after it has a meaning"
                )));
            }
            meanings.values.insert(name, value);
        }
        Ok(meanings)
    }

    /// The symbol as a polynomial.
    ///
    /// # Errors
    /// [`Error::Limit`] if there are more than [`SYMBOLS`] symbols.
    pub(super) fn symbol(&mut self, name: &str) -> Result<Polynomial> {
        self.index(name).map(Polynomial::variable)
    }

    fn index(&mut self, name: &str) -> Result<usize> {
        if let Some(index) = self.symbols.iter().position(|s| s == name) {
            return Ok(index);
        }
        if self.symbols.len() == SYMBOLS {
            return Err(Error::limit(format!("{SYMBOLS} symbols in one entry")));
        }
        self.symbols.push(name.into());
        Ok(self.symbols.len() - 1)
    }

    fn value(&mut self, formula: &Formula) -> Result<Quotient> {
        let constant = |c: Rational| Quotient::polynomial(Polynomial::constant(c));
        Ok(match formula {
            Formula::Number(c) => constant(c.clone()),
            Formula::Symbol(name) => match self.values.get(name) {
                Some(value) => value.clone(),
                None => Quotient::polynomial(Polynomial::variable(self.index(name)?)),
            },
            Formula::Sum(parts) => {
                let mut sum = constant(Rational::zero());
                for (subtracted, part) in parts {
                    sum = sum.plus(&self.value(part)?, if *subtracted { -1 } else { 1 });
                }
                sum
            }
            Formula::Product(a, b) => self.value(a)?.times(&self.value(b)?),
            Formula::Quotient(a, b) => {
                let divisor = self.value(b)?;
                let below = self.reduced(&divisor.above);
                let over = Quotient {
                    above: below,
                    below: divisor.below,
                };
                match over.recip() {
                    Some(inverse) => self.value(a)?.times(&inverse),
                    None => {
                        self.divides_by_zero = true;
                        constant(Rational::zero())
                    }
                }
            }
            Formula::Power(base, exponent) => {
                let base = self.value(base)?;
                Quotient {
                    above: base.above.pow(*exponent),
                    below: base.below.pow(*exponent),
                }
            }
        })
    }

    /// f with the known squares substituted, so that each of their symbols occurs to the power 0 or 1 only.
    fn reduced(&self, f: &Polynomial) -> Polynomial {
        let mut f = f.clone();
        // The square of one symbol may contain another one, so there are as many rounds as known squares.
        let rounds = self.squares.iter().cycle();
        for (index, square) in rounds.take(self.squares.len().pow(2)) {
            let mut sum = Polynomial::zero();
            for (exponents, c) in f.terms() {
                let mut rest = *exponents;
                rest[*index] %= 2;
                let term = Polynomial::from_terms([(rest, c.clone())]);
                sum = sum.plus(&term.times(&square.pow(exponents[*index] / 2)));
            }
            f = sum;
        }
        f
    }

    /// Whether `left = right` identically.
    ///
    /// The difference is brought over one denominator, its numerator is expanded, and the known squares are substituted. If the
    /// result is not 0 and no squares are known, a point with small coordinates shows it. A side that divides by zero equals
    /// nothing.
    ///
    /// # Errors
    /// [`Error::Limit`] for too many symbols.
    pub(super) fn compare(&mut self, left: &Formula, right: &Formula) -> Result<Comparison> {
        let left = self.value(left)?;
        self.difference(left, right)
    }

    /// Whether a polynomial in the symbols equals the formula.
    ///
    /// # Errors
    /// As [`Meanings::compare`].
    pub(super) fn compare_with(&mut self, left: Polynomial, right: &Formula) -> Result<Comparison> {
        self.difference(Quotient::polynomial(left), right)
    }

    fn difference(&mut self, left: Quotient, right: &Formula) -> Result<Comparison> {
        let right = self.value(right)?;
        let difference = left.plus(&right, -1);
        if self.divides_by_zero {
            return Ok(Comparison::Different(
                "one of its sides divides by zero".into(),
            ));
        }
        let numerator = self.reduced(&difference.above);
        if numerator.is_empty() {
            return Ok(Comparison::Equal);
        }
        Ok(Comparison::Different(
            self.witness(&numerator, [&left, &right]),
        ))
    }

    /// The symbols without a definition.
    pub(super) fn symbols(&self) -> &[String] {
        &self.symbols
    }

    fn witness(&self, numerator: &Polynomial, sides: [&Quotient; 2]) -> String {
        for seed in 1..200_i64 {
            // Small numbers without a pattern. Known squares leave no free choice for their symbols, so then no point is tried.
            let at: [Rational; SYMBOLS] = std::array::from_fn(|i| {
                let step = i64::try_from(i).invariant("there are few symbols");
                Rational::from((seed * (step + 2) * (step + 3) / 2 + step) % 7 + 1)
            });
            if !self.squares.is_empty() {
                break;
            }
            let value = |q: &Quotient| Some(q.above.evaluate(&at) * q.below.evaluate(&at).recip()?);
            if numerator.evaluate(&at).is_zero() {
                continue;
            }
            let [Some(left), Some(right)] = sides.map(value) else {
                continue;
            };
            let place: Vec<String> = self
                .symbols
                .iter()
                .zip(&at)
                .map(|(name, value)| format!("{name} = {value}"))
                .collect();
            return format!(
                "at {} its left side is {left} and its right side is {right}",
                place.join(", ")
            );
        }
        format!(
            "the numerator of the difference of its sides has {} terms in {}",
            numerator.len(),
            self.symbols.join(", ")
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn compare(definitions: &str, squares: &str, equation: &str) -> Comparison {
        let mut meanings = Meanings::new(definitions, squares).unwrap();
        let [left, right] = Formula::parse_equation(equation).unwrap();
        meanings.compare(&left, &right).unwrap()
    }

    #[test]
    fn identities_are_proved_and_other_equations_refuted() {
        assert_eq!(
            compare("", "", "(a + b)^2 = a^2 + 2*a*b + b^2"),
            Comparison::Equal
        );
        assert_eq!(
            compare("t = s/c", "s^2 = 1 - c^2", "1 + t^2 = 1/c^2"),
            Comparison::Equal
        );
        assert_eq!(compare("", "w^2 = -3", "w^4 = 9"), Comparison::Equal);
        let Comparison::Different(place) = compare("", "", "a/b = b/a") else {
            panic!("they differ")
        };
        assert!(place.starts_with("at b = "), "{place}");
    }

    #[test]
    fn a_symbol_is_defined_once_and_before_it_is_used() {
        for (definitions, squares) in [
            ("x = r*c; r = a + b", ""),
            ("x = 1; x = 2", ""),
            ("s = 1", "s^2 = 1 - c^2"),
        ] {
            let error = Meanings::new(definitions, squares).unwrap_err();
            assert!(error.to_string().contains("after it has a meaning"));
        }
    }

    #[test]
    fn what_divides_by_zero_equals_nothing() {
        let zero = "1/(s^2 + c^2 - 1) = 1/(s^2 + c^2 - 1)";
        let found = compare("", "s^2 = 1 - c^2", zero);
        assert_eq!(
            found,
            Comparison::Different("one of its sides divides by zero".into())
        );
    }

    proptest! {
        /// Equal sides are recognised, and a planted difference is found.
        #[test]
        fn planted_differences_are_found(a in -9i64..10, b in -9i64..10, n in 1u32..5, off in 1i64..5) {
            let (a, b) = (a.unsigned_abs(), b.unsigned_abs());
            let left = format!("({a}*x + {b}*y)^{n}");
            let equal = format!("{left} = {left}*(x + y)/(y + x)");
            prop_assert_eq!(compare("", "", &equal), Comparison::Equal);
            let planted = format!("{left} = {left} + {off}*x*y^{n}");
            prop_assert!(matches!(compare("", "", &planted), Comparison::Different(_)));
        }
    }
}
