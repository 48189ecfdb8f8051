//! Parametric surfaces.

use super::Parameter;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::factor::coprime_parts;
use crate::limits::Limits;
use crate::poly::SparsePolynomial;

/// The quotient of two polynomials in two variables. They are coprime with coprime integer coefficients, and the first
/// coefficient of the denominator is positive; so equal functions are equal values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PatchFunction {
    numerator: SparsePolynomial<2>,
    denominator: SparsePolynomial<2>,
}

impl PatchFunction {
    /// The quotient in lowest terms; `None` if the denominator is 0. Cost: a gcd in two variables.
    ///
    /// # Errors
    /// Those of `limits`.
    pub fn new(
        numerator: &SparsePolynomial<2>,
        denominator: &SparsePolynomial<2>,
        limits: &Limits,
    ) -> Result<Option<Self>> {
        if denominator.is_empty() {
            return Ok(None);
        }
        if numerator.is_empty() {
            return Ok(Some(Self {
                numerator: SparsePolynomial::zero(),
                denominator: SparsePolynomial::constant(Rational::one()),
            }));
        }
        let content = |f: &SparsePolynomial<2>| ratio(f, &f.primitive());
        let ratio = content(numerator) / content(denominator);
        let [p, q] = coprime_parts([numerator, denominator], limits)?;
        Ok(Some(Self {
            numerator: p.scaled(&Rational::whole(ratio.numerator())),
            denominator: q.scaled(&Rational::whole(ratio.denominator())),
        }))
    }

    /// The numerator.
    #[must_use]
    pub fn numerator(&self) -> &SparsePolynomial<2> {
        &self.numerator
    }

    /// The denominator.
    #[must_use]
    pub fn denominator(&self) -> &SparsePolynomial<2> {
        &self.denominator
    }

    /// The larger of the degrees of numerator and denominator in the given variable.
    #[must_use]
    pub fn degree_in(&self, variable: usize) -> u32 {
        let terms = self.numerator.terms().chain(self.denominator.terms());
        let degree = terms.map(|(e, _)| e[variable]).max();
        degree.invariant("a denominator has a term")
    }

    /// The value at rational numbers; `None` if the denominator is 0 there.
    #[must_use]
    pub fn evaluate(&self, at: &[Rational; 2]) -> Option<Rational> {
        let below = self.denominator.evaluate(at);
        Some(self.numerator.evaluate(at) * below.recip()?)
    }
}

/// The rational number f / g, where f is a multiple of g.
fn ratio(f: &SparsePolynomial<2>, g: &SparsePolynomial<2>) -> Rational {
    let first = |h: &SparsePolynomial<2>| h.terms().next().map(|(_, c)| c.clone());
    match (first(f), first(g)) {
        (Some(a), Some(b)) => a / b,
        _ => Rational::one(),
    }
}

/// A surface whose coordinates are rational functions of two parameters, or of the cosines and sines of angles (Theorem 4).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Patch {
    parameters: [Parameter; 2],
    coordinates: [PatchFunction; 3],
}

impl Patch {
    /// The patch whose coordinates are these functions of s1 and s2; the [`Parameter`]s say how s1 and s2 depend on them.
    #[must_use]
    pub fn new(parameters: [Parameter; 2], coordinates: [PatchFunction; 3]) -> Self {
        Self {
            parameters,
            coordinates,
        }
    }

    /// The two parameters.
    #[must_use]
    pub fn parameters(&self) -> &[Parameter; 2] {
        &self.parameters
    }

    /// The coordinates as functions of s1 and s2.
    #[must_use]
    pub fn coordinates(&self) -> &[PatchFunction; 3] {
        &self.coordinates
    }

    /// The point at (s1, s2); `None` if a coordinate has a pole there.
    #[must_use]
    pub fn point(&self, at: &[Rational; 2]) -> Option<[Rational; 3]> {
        let [x, y, z] = &self.coordinates;
        Some([x.evaluate(at)?, y.evaluate(at)?, z.evaluate(at)?])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(terms: &[([u32; 2], i64)]) -> SparsePolynomial<2> {
        SparsePolynomial::from_terms(terms.iter().map(|&(e, c)| (e, Rational::from(c))))
    }

    #[test]
    fn a_quotient_is_in_lowest_terms() {
        // (2u² − 2v²) / (−4u + 4v) = −(u + v)/2.
        let f = PatchFunction::new(
            &polynomial(&[([2, 0], 2), ([0, 2], -2)]),
            &polynomial(&[([1, 0], -4), ([0, 1], 4)]),
            &Limits::none(),
        );
        let f = f.unwrap().unwrap();
        assert_eq!(*f.numerator(), polynomial(&[([1, 0], -1), ([0, 1], -1)]));
        assert_eq!(*f.denominator(), polynomial(&[([0, 0], 2)]));
        assert_eq!(
            f.evaluate(&[3.into(), 4.into()]).unwrap().to_string(),
            "-7/2"
        );
        let zero = polynomial(&[]);
        let by_zero = PatchFunction::new(&polynomial(&[([0, 0], 1)]), &zero, &Limits::none());
        assert_eq!(by_zero.unwrap(), None);
    }
}
