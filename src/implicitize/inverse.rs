//! Inversion by substitution: one function of s is written as a rational function of another.

use malachite::Integer;
use malachite::base::polynomial::Polynomial;

use super::map::RationalMap;
use super::tracing::common_numerator;
use super::vanishing::vanishing;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, RationalFunction, SparsePolynomial};

/// The answer to the question whether w is a rational function of m.
pub(super) enum Inverse {
    /// It is: `w = above(m)/below(m)`, by the coefficients of the powers of m.
    Function(Quotient),
    /// It is undetermined, because m is constant.
    Constant,
    /// It is not: w has this number of values, complex ones included, for a general value of m.
    Values(usize),
}

/// `Σ above_k m^k / Σ below_k m^k` with integer coefficients.
pub(super) struct Quotient {
    pub(super) above: Vec<(u32, Rational)>,
    pub(super) below: Vec<(u32, Rational)>,
    /// The larger of the two degrees.
    pub(super) degree: u32,
}

impl Quotient {
    /// The quotient as a rational function of m.
    pub(super) fn to_function(&self) -> Option<RationalFunction> {
        let [p, q] = [&self.above, &self.below].map(|terms| {
            let mut coefficients = vec![Integer::from(0); self.degree as usize + 1];
            for (k, c) in terms {
                coefficients[*k as usize] = c.numerator();
            }
            IntegerPolynomial::from_coefficients_asc(coefficients)
        });
        RationalFunction::from_integers(p, q)
    }

    /// Numerator and denominator as polynomials; `power(k)` must be m^k times the `degree`-th power of the denominator of m.
    pub(super) fn cleared(
        &self,
        power: impl Fn(u32, u32) -> SparsePolynomial<3>,
    ) -> [SparsePolynomial<3>; 2] {
        [&self.above, &self.below].map(|terms| {
            let mut sum = SparsePolynomial::zero();
            for (k, c) in terms {
                sum.add_multiple(&power(*k, self.degree - k), c);
            }
            sum
        })
    }
}

/// Decides whether `w = H(m)` with a rational function H.
///
/// If there is H, its degree is deg w / deg m, and certified linear algebra in 1, m, m², …, w, mw, m²w, … finds it. If not, the
/// gcd of the numerators of m(s) − m(σ) and w(s) − w(σ) gives the number of values that w has for one value of m.
///
/// # Errors
/// Those of `limits`, and of the linear algebra.
pub(super) fn invert(
    w: &RationalFunction,
    m: &RationalFunction,
    limits: &Limits,
) -> Result<Inverse> {
    if m.is_constant() {
        return Ok(Inverse::Constant);
    }
    let functions = [m.clone(), w.clone()];
    if w.degree().is_multiple_of(m.degree()) {
        let degree = u32::try_from(w.degree() / m.degree()).invariant("a degree is below 2^32");
        let powers = |y: u32| (0..=degree).map(move |k| [k, y, 0]);
        let monomials: Vec<[u32; 3]> = powers(0).chain(powers(1)).collect();
        let map = RationalMap::of_functions(&functions);
        if let Some(f) = vanishing(&map, &monomials, limits)?.first() {
            let part = |y: u32| f.terms().filter(move |(e, _)| e[1] == y);
            // The sign is chosen so that the first coefficient of the denominator is positive.
            let negative = part(1).next().is_some_and(|(_, c)| c.signum() < 0);
            let signed = |c: &Rational, flip: bool| if flip { -c.clone() } else { c.clone() };
            return Ok(Inverse::Function(Quotient {
                above: part(0).map(|(e, c)| (e[0], signed(c, !negative))).collect(),
                below: part(1).map(|(e, c)| (e[0], signed(c, negative))).collect(),
                degree,
            }));
        }
    }
    let common = common_numerator(&functions, limits)?;
    let shared = common.terms().map(|(e, _)| e[0] as usize).max();
    let shared = shared.invariant("what m(s) - m(t) has in common with another is not 0");
    Ok(Inverse::Values(m.degree() / shared))
}
