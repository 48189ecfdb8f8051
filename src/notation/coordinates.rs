//! Parametric curves and patches as formulas: functions of s = tan(g·t/2) are written with cosines and sines of t.

use std::collections::BTreeMap;

use malachite::Integer;

use super::Format;
use super::powers::{in_powers, units};
use super::terms::Notation;
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, RationalFunction, SparsePolynomial};
use crate::shape::{Basis, Expansion, Parameter, ParametricCurve, Patch, quotient_in_harmonics};

/// The names of coordinates.
pub(crate) const NAMES: [&str; 3] = ["x", "y", "z"];

/// The coordinates of a parametric form, ready to be written in every format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coordinates {
    parameters: Vec<Parameter>,
    /// The numerator and the denominator of each coordinate, as polynomials in s1 and s2.
    functions: Vec<[SparsePolynomial<2>; 2]>,
}

impl<const N: usize> From<&ParametricCurve<N>> for Coordinates {
    fn from(curve: &ParametricCurve<N>) -> Self {
        let sparse = |f: &IntegerPolynomial| {
            let terms = f.coefficients_asc().iter().enumerate();
            let power = |k: usize| u32::try_from(k).invariant("a degree is below 2^32");
            SparsePolynomial::from_terms(terms.map(|(k, c)| ([power(k), 0], Rational::whole(c))))
        };
        let both = |f: &RationalFunction| [sparse(f.numerator()), sparse(f.denominator())];
        Self {
            parameters: vec![curve.parameter().clone()],
            functions: curve.coordinates().iter().map(both).collect(),
        }
    }
}

impl From<&Patch> for Coordinates {
    fn from(patch: &Patch) -> Self {
        let functions = patch.coordinates().iter();
        Self {
            parameters: patch.parameters().to_vec(),
            functions: functions
                .map(|f| [f.numerator().clone(), f.denominator().clone()])
                .collect(),
        }
    }
}

impl Coordinates {
    /// The formulas of the coordinates, in order.
    ///
    /// ```
    /// use stellate::document::{Coordinates, Format};
    /// use stellate::language::{Numbers, parse_form};
    /// use stellate::shape::Form;
    ///
    /// let text = "x = tan(t/2); y = cos(t)^2";
    /// let Form::PlaneCurve(curve) = parse_form(text, "<form>", Numbers::Exact)? else { panic!() };
    /// let formulas = Coordinates::from(&curve).formulas(Format::Text);
    /// assert_eq!(formulas, ["sin(t/2)/cos(t/2)", "cos(t)^2"]);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    #[must_use]
    pub fn formulas(&self, format: Format) -> Vec<String> {
        let formula = |f: &[SparsePolynomial<2>; 2]| self.quotient(f, format);
        self.functions.iter().map(formula).collect()
    }

    /// The names of the parameters.
    #[must_use]
    pub fn parameters(&self) -> Vec<&str> {
        self.parameters.iter().map(Parameter::name).collect()
    }

    /// The formulas by the names of the coordinates: `{"x": "…", "y": "…"}`.
    pub(crate) fn fields(&self) -> BTreeMap<&'static str, String> {
        NAMES.into_iter().zip(self.formulas(Format::Text)).collect()
    }

    fn quotient(&self, [above, below]: &[SparsePolynomial<2>; 2], format: Format) -> String {
        let [mut above, mut below] = quotient_in_harmonics([above, below], &self.parameters);
        let constant = [Basis::Power(0), Basis::Power(0)];
        let divisor = match below.get(&constant) {
            Some(value) if below.len() == 1 => value.clone(),
            _ => content(&above, &below),
        };
        for value in above.values_mut().chain(below.values_mut()) {
            *value = &*value / &divisor;
        }
        let whole = below.len() == 1 && below.contains_key(&constant);
        let text = |f: &Expansion| self.sum(f, format);
        if whole {
            let harmonics = text(&above);
            let others = self.in_powers(&above, format);
            // The shortest formula is taken; among equally short ones, that with harmonics.
            let all = std::iter::once(harmonics).chain(others);
            let shortest = all.min_by_key(String::len);
            return shortest.invariant("the harmonics are one of the texts");
        }
        let (p, q) = (text(&above), text(&below));
        if format == Format::Latex {
            return format!("\\frac{{{p}}}{{{q}}}");
        }
        let grouped = |text: String, f: &Expansion, single: bool| {
            if f.len() <= 1 && single {
                text
            } else {
                format!("({text})")
            }
        };
        let is_atom = below.len() == 1
            && below
                .iter()
                .all(|(b, c)| *c == Rational::one() && b.contains(&Basis::Power(0)));
        format!(
            "{}/{}",
            grouped(p, &above, true),
            grouped(q, &below, is_atom)
        )
    }

    /// A sum of harmonics of a single angle, written with powers of its cosine and sine in two ways.
    fn in_powers(&self, f: &Expansion, format: Format) -> Vec<String> {
        let [parameter] = &self.parameters[..] else {
            return Vec::new();
        };
        let ways = units(f).into_iter().flat_map(|unit| {
            let ways = in_powers(f, unit).into_iter().flatten();
            ways.map(move |way| (unit, way))
        });
        ways.map(|(unit, way)| {
            let terms = way.terms().map(|([i, j], c)| {
                let factors = [(Basis::Cos(unit), *i), (Basis::Sin(unit), *j)];
                let factors = factors.into_iter().filter(|(_, e)| *e > 0);
                let factors: Vec<String> = factors
                    .map(|(basis, e)| raised(&factor_text(basis, parameter, format), e, format))
                    .collect();
                let times = if format == Format::Latex { " " } else { "*" };
                (c.clone(), factors.join(times))
            });
            written_sum(terms, format)
        })
        .collect()
    }

    fn sum(&self, f: &Expansion, format: Format) -> String {
        let times = if format == Format::Latex { " " } else { "*" };
        let terms = f.iter().map(|(basis, c)| {
            let factors = basis.iter().zip(&self.parameters);
            let factors: Vec<String> = factors
                .map(|(basis, parameter)| factor_text(*basis, parameter, format))
                .filter(|text| !text.is_empty())
                .collect();
            (c.clone(), factors.join(times))
        });
        written_sum(terms, format)
    }
}

fn written_sum(terms: impl Iterator<Item = (Rational, String)>, format: Format) -> String {
    let notation = match format {
        Format::Sympy => Notation::Python,
        Format::Latex => Notation::LatexInline,
        _ => Notation::Explicit,
    };
    let mut text = Vec::new();
    let written = notation.write_sum(terms, &mut text);
    debug_assert!(written.is_ok(), "writing into memory succeeds");
    String::from_utf8_lossy(&text).into_owned()
}

/// A power of a function, such as `sin(t)^5`, or in LaTeX `{\sin t}^{5}`.
fn raised(function: &str, exponent: u32, format: Format) -> String {
    match (exponent, format) {
        (1, _) => function.to_owned(),
        (_, Format::Latex) => format!("{{{function}}}^{{{exponent}}}"),
        (_, Format::Sympy) => format!("{function}**{exponent}"),
        _ => format!("{function}^{exponent}"),
    }
}

/// The text of a factor of a term.
fn factor_text(basis: Basis, parameter: &Parameter, format: Format) -> String {
    let name = parameter.name();
    let latex = format == Format::Latex;
    let shown = match name {
        "theta" | "phi" if latex => format!("\\{name}"),
        _ => name.to_owned(),
    };
    let (function, n) = match basis {
        Basis::Power(0) => return String::new(),
        Basis::Power(1) => return shown,
        Basis::Power(k) if latex => return format!("{shown}^{{{k}}}"),
        Basis::Power(k) if format == Format::Sympy => return format!("{shown}**{k}"),
        Basis::Power(k) => return format!("{shown}^{k}"),
        Basis::Cos(n) => ("cos", n),
        Basis::Sin(n) => ("sin", n),
    };
    let step = parameter.step().cloned().unwrap_or_else(Rational::one);
    let multiple = step * Rational::whole(Integer::from(n));
    let (p, q) = (multiple.numerator(), multiple.denominator());
    if latex {
        let factor = match (p == 1, q == 1) {
            (true, true) => String::new(),
            (false, true) => format!("{p}"),
            _ => format!("\\tfrac{{{p}}}{{{q}}}"),
        };
        return format!("\\{function} {factor}{shown}");
    }
    let factor = if p == 1 {
        String::new()
    } else {
        format!("{p}*")
    };
    let divisor = if q == 1 {
        String::new()
    } else {
        format!("/{q}")
    };
    format!("{function}({factor}{shown}{divisor})")
}

/// The number by which both are divided, so that they have coprime integer coefficients and the first coefficient of the
/// denominator is positive.
fn content(above: &Expansion, below: &Expansion) -> Rational {
    let values = below.values().chain(above.values());
    // Descending numbers keep the order of the coefficients.
    let indexed = values.zip((0..u32::MAX).rev());
    let polynomial = SparsePolynomial::from_terms(indexed.map(|(c, n)| ([n], c.clone())));
    let first = |p: &SparsePolynomial<1>| p.terms().next().map(|(_, c)| c.clone());
    match (first(&polynomial), first(&polynomial.primitive())) {
        (Some(a), Some(b)) => a / b,
        _ => Rational::one(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::{Numbers, parse_form};
    use crate::shape::Form;

    fn formulas(text: &str) -> Vec<String> {
        let coordinates = match parse_form(text, "<form>", Numbers::Exact) {
            Ok(Form::PlaneCurve(curve)) => Coordinates::from(&curve),
            Ok(Form::SpaceCurve(curve)) => Coordinates::from(&curve),
            Ok(Form::Patch(patch)) => Coordinates::from(&patch),
            other => panic!("{text}: {other:?}"),
        };
        coordinates.formulas(Format::Text)
    }

    #[test]
    fn formulas_are_canonical_and_are_read_back() {
        let cases = [
            ("x = sin(t); y = sin(t)*cos(t)", "sin(t) ; 1/2*sin(2*t)"),
            ("x = 1 + t^2; y = (t + t^3)/2", "t^2 + 1 ; 1/2*t^3 + 1/2*t"),
            (
                "x = (1-t^2)/(1+t^2); y = 2t/(1+t**2)",
                "(-t^2 + 1)/(t^2 + 1) ; 2*t/(t^2 + 1)",
            ),
            ("x = sin(t/2); y = sin(t/3)", "sin(t/2) ; sin(t/3)"),
            (
                "x = sin(2theta+pi/2)+sin(theta)^2+cos(theta)^2; y = sec(theta)",
                "2*cos(theta)^2 ; 1/cos(theta)",
            ),
            ("x = tan(t); y = cot(t)", "sin(t)/cos(t) ; cos(t)/sin(t)"),
            ("x = 0.1/t; y = t^-2; z = 3", "1/(10*t) ; 1/t^2 ; 3"),
            (
                "x = (2+cos(v))*cos(u); y = (2+cos(v))sin(u); z = sin(v)",
                "2*cos(u) + cos(u)*cos(v) ; 2*sin(u) + sin(u)*cos(v) ; sin(v)",
            ),
            ("x = u*v; y = u; z = v^2", "u*v ; u ; v^2"),
            ("x = sin(2t + u); y = u - u + cos(t); z = cos(u)", ""),
            (
                "x = u*cos(v)/(1+u^2); y = u; z = sin(v)",
                "u*cos(v)/(u^2 + 1) ; u ; sin(v)",
            ),
        ];
        for (text, expected) in cases {
            if expected.is_empty() {
                assert!(parse_form(text, "<form>", Numbers::Exact).is_err());
                continue;
            }
            let found = formulas(text);
            assert_eq!(found.join(" ; "), expected, "{text}");
            let rows: Vec<String> = NAMES
                .iter()
                .zip(&found)
                .map(|(n, f)| format!("{n} = {f}"))
                .collect();
            assert_eq!(formulas(&rows.join("\n")), found, "{text}");
        }
    }
}
