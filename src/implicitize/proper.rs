//! Proper reparametrization: a curve that is traced several times gets a parameter that traces it once.

use super::inverse::{Inverse, invert};
use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, RationalFunction, polynomial_gcd};

/// The largest number of values of the parameter whose fibres are computed; two of these must be in general position.
const TRIES: i64 = 12;

/// The coordinates as functions of another parameter. Their degrees are divided by `index`, the tracing index. `None` if none
/// of the values that are tried is in general position.
///
/// By Lüroth's theorem the field of all functions of the point is Q(s) for a function s(t) of degree `index`. At a general
/// number σ the numerator of s(t) − s(σ) is the gcd of those of x(t) − x(σ), y(t) − y(σ), …; the quotient of two such
/// numerators is a Möbius transform of s, which does as well (Sendra, Winkler & Pérez-Díaz, *Rational Algebraic Curves*,
/// §6.1).
///
/// Cost: two gcds of polynomials in t, then linear algebra in 2·degree/`index` + 2 unknowns for each coordinate.
///
/// # Errors
/// Those of `limits`.
pub(super) fn proper_parametrization<const N: usize>(
    functions: &[RationalFunction; N],
    index: usize,
    limits: &Limits,
) -> Result<Option<[RationalFunction; N]>> {
    for s in generators(functions, index) {
        if let Some(proper) = as_functions_of(&s, functions, limits)? {
            return Ok(Some(proper));
        }
    }
    Ok(None)
}

/// The functions of t as functions of s(t), if all of them are.
fn as_functions_of<const N: usize>(
    s: &RationalFunction,
    functions: &[RationalFunction; N],
    limits: &Limits,
) -> Result<Option<[RationalFunction; N]>> {
    let mut proper = Vec::new();
    for f in functions {
        let Inverse::Function(fraction) = invert(f, s, limits)? else {
            return Ok(None);
        };
        proper.extend(fraction.to_function());
    }
    Ok(proper.try_into().ok())
}

/// Functions of degree `index`. All coordinates are functions of such a function if its two fibres are in general position.
///
/// A fibre of the right degree need not be in general position: at a cusp of the curve, or for parameters at infinity, it has
/// fewer distinct points with higher multiplicities.
fn generators(
    functions: &[RationalFunction],
    index: usize,
) -> impl Iterator<Item = RationalFunction> {
    let general = move |f: &IntegerPolynomial| f.coefficients_asc().len() == index + 1;
    let fibres = (1..=TRIES)
        .filter_map(|sigma| fibre(functions, &Rational::from(sigma)))
        .filter(general);
    // Each fibre is combined with those before it, so that no more fibres are computed than needed.
    let mut before: Vec<IntegerPolynomial> = Vec::new();
    let quotients = fibres.flat_map(move |fibre| {
        let over = |other: &IntegerPolynomial| {
            RationalFunction::from_integers(fibre.clone(), other.clone())
        };
        let quotients: Vec<RationalFunction> = before.iter().filter_map(over).collect();
        before.push(fibre);
        quotients
    });
    // The degree is smaller if both fibres belong to the same point.
    quotients.filter(move |s| s.degree() == index)
}

/// The parameters of the point at σ: the gcd of the numerators of x(t) − x(σ), y(t) − y(σ), …; `None` at a pole.
fn fibre(functions: &[RationalFunction], sigma: &Rational) -> Option<IntegerPolynomial> {
    let mut common: Option<IntegerPolynomial> = None;
    for f in functions.iter().filter(|f| !f.is_constant()) {
        let difference = f.plus_constant(&-f.evaluate(sigma)?);
        common = Some(match common {
            Some(other) => polynomial_gcd(&other, difference.numerator()),
            None => difference.numerator().clone(),
        });
    }
    common
}

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::Integer;
    use malachite::base::polynomial::Polynomial;
    use proptest::prelude::*;

    /// Rational functions of degree up to 3.
    fn function() -> impl Strategy<Value = RationalFunction> {
        let polynomial = || {
            let coefficients = prop::collection::vec(-9i64..10, 1..5);
            coefficients.prop_map(|c| {
                IntegerPolynomial::from_coefficients_asc(c.into_iter().map(Integer::from).collect())
            })
        };
        (polynomial(), polynomial()).prop_filter_map("a pole everywhere", |(p, q)| {
            RationalFunction::from_integers(p, q)
        })
    }

    /// The function f(s(t)).
    fn composed(f: &RationalFunction, s: &RationalFunction) -> Option<RationalFunction> {
        let homogeneous = |p: &IntegerPolynomial| {
            let mut sum = IntegerPolynomial::from_coefficients_asc(Vec::new());
            for (k, c) in p.coefficients_asc().iter().enumerate() {
                let power = |p: &IntegerPolynomial, e: usize| {
                    (0..e).fold(IntegerPolynomial::one(), |power, _| power * p)
                };
                let term = power(s.numerator(), k) * power(s.denominator(), f.degree() - k);
                sum += term * IntegerPolynomial::from_coefficients_asc(vec![c.clone()]);
            }
            sum
        };
        RationalFunction::from_integers(homogeneous(f.numerator()), homogeneous(f.denominator()))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        /// Known functions of a parameter that traces the curve once are composed with s(t), and found again.
        #[test]
        fn the_new_parameter_runs_over_the_curve_once(x in function(), y in function(), s in function()) {
            prop_assume!(s.degree() > 1 && !(x.is_constant() && y.is_constant()));
            let once = [x, y];
            let index_of_once = super::super::tracing::tracing_index_bound(&once);
            let [Some(x), Some(y)] = once.each_ref().map(|f| composed(f, &s)) else {
                return Err(TestCaseError::reject("a pole everywhere"));
            };
            let functions = [x, y];
            let index = index_of_once * s.degree();
            let proper = proper_parametrization(&functions, index, &Limits::none()).unwrap();
            let proper = proper.ok_or_else(|| TestCaseError::fail("no number was general"))?;
            prop_assert_eq!(super::super::tracing::tracing_index_bound(&proper), 1);
            let is_of = |s: &RationalFunction| {
                let mut pairs = functions.iter().zip(&proper);
                pairs.all(|(f, proper)| composed(proper, s).as_ref() == Some(f))
            };
            prop_assert!(generators(&functions, index).any(|s| is_of(&s)));
            for (f, proper) in functions.iter().zip(&proper) {
                prop_assert_eq!(proper.degree() * index, f.degree());
            }
        }
    }
    /// s has a pole at t = 2 and at infinity, where the curve has a cusp: the fibre of 2 is 2 twice, and has the right degree.
    #[test]
    fn a_fibre_over_a_cusp_is_no_general_one() {
        let polynomial = |c: &[i64]| {
            IntegerPolynomial::from_coefficients_asc(c.iter().copied().map(Integer::from).collect())
        };
        let function = |p: &[i64], q: &[i64]| {
            RationalFunction::from_integers(polynomial(p), polynomial(q)).unwrap()
        };
        let s = function(&[0, 4, -1], &[-4, 2]);
        let once = [function(&[1], &[0, 0, 1]), function(&[-1], &[0, 1, 1])];
        let functions = once.each_ref().map(|f| composed(f, &s).unwrap());
        let proper = proper_parametrization(&functions, 2, &Limits::none()).unwrap();
        assert!(proper.is_some_and(|proper| proper.iter().all(|f| f.degree() == 2)));
    }
}
