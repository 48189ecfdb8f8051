//! The tracing index: how often a parametrization traces its curve.

use malachite::base::num::basic::traits::Zero;

use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::factor::greatest_common_divisor;
use crate::limits::Limits;
use crate::modular::{PrimeField, large_primes, trimmed};
use crate::poly::{IntegerPolynomial, RationalFunction, SparsePolynomial};

/// The number of values of the parameter that are tried.
const TRIES: u64 = 4;

/// An upper bound of the tracing index, which is the degree `[Q(s) : Q(x, y, …)]`. The bound is larger than the index only with
/// a probability of about (degree²/2³¹)⁴.
///
/// The index is the degree in s of the gcd of the numerators of x(s) − x(σ), y(s) − y(σ), …; modulo a prime and
/// at a number σ the gcd of these binary forms in s, infinity counted, can only become larger.
pub(super) fn tracing_index_bound(functions: &[RationalFunction]) -> usize {
    let moving: Vec<&RationalFunction> = functions.iter().filter(|f| !f.is_constant()).collect();
    // The bound for a point is 0.
    let mut least = moving.iter().map(|f| f.degree()).min().unwrap_or(0);
    let mut primes = large_primes();
    for k in 0..TRIES {
        let prime = primes.next().invariant("there are primes below 2^31");
        // Any numbers are good; these have no pattern.
        let sigma = (k + 1) * 0x1234_5677 % prime;
        if let Some(degree) = common_degree(&moving, sigma, prime) {
            least = least.min(degree);
        }
    }
    least
}

/// The exact tracing index of functions that are not all constant. The upper bound proves the value 1; a gcd proves a larger value.
///
/// # Errors
/// Those of `limits`.
pub(crate) fn tracing_index(functions: &[RationalFunction], limits: &Limits) -> Result<usize> {
    if tracing_index_bound(functions) == 1 {
        return Ok(1);
    }
    let common = common_numerator(functions, limits)?;
    let degree = common.terms().map(|(e, _)| e[0] as usize).max();
    Ok(degree.invariant("a curve has a coordinate that is not constant"))
}

/// The degree of the gcd of the forms p(s) q(σ) − q(s) p(σ); `None` if all of them vanish.
fn common_degree(functions: &[&RationalFunction], sigma: u64, prime: u64) -> Option<usize> {
    let field = PrimeField::new(prime);
    let mut common: Option<Vec<u64>> = None;
    let mut at_infinity = usize::MAX;
    for f in functions {
        let reduce = |p: &IntegerPolynomial| {
            let mut residues = field.residues(p);
            residues.resize(f.degree() + 1, 0);
            residues
        };
        let (p, q) = (reduce(f.numerator()), reduce(f.denominator()));
        let (p_value, q_value) = (field.value(&p, sigma), field.value(&q, sigma));
        let terms = p.iter().zip(&q);
        let form = terms.map(|(p, q)| (p * q_value + (prime - q) * p_value) % prime);
        let form = trimmed(form.collect());
        if form.is_empty() {
            continue;
        }
        at_infinity = at_infinity.min(f.degree() + 1 - form.len());
        common = Some(match common {
            Some(other) => field.gcd(other, form),
            None => form,
        });
    }
    common.map(|g| g.len() - 1 + at_infinity)
}

/// The gcd over Q of the numerators of x(s) − x(σ), y(s) − y(σ), …, a polynomial in s and σ.
///
/// Its degree in s is the tracing index. The quotients of its coefficients as a polynomial in s, as far as they are not
/// constant, generate the field of all functions of the point (Lüroth).
///
/// # Errors
/// Those of `limits`.
pub(super) fn common_numerator(
    functions: &[RationalFunction],
    limits: &Limits,
) -> Result<SparsePolynomial<2>> {
    let mut common = SparsePolynomial::zero();
    for f in functions.iter().filter(|f| !f.is_constant()) {
        limits.check()?;
        common = greatest_common_divisor(&common, &difference(f), limits)?;
    }
    Ok(common)
}

/// p(s) q(σ) − q(s) p(σ)
pub(super) fn difference(f: &RationalFunction) -> SparsePolynomial<2> {
    let (p, q) = (
        f.numerator().coefficients_asc(),
        f.denominator().coefficients_asc(),
    );
    let mut terms = Vec::new();
    let index = |k: usize| u32::try_from(k).invariant("a degree is below 2^32");
    for (i, p) in p
        .iter()
        .enumerate()
        .filter(|(_, c)| **c != malachite::Integer::ZERO)
    {
        for (j, q) in q
            .iter()
            .enumerate()
            .filter(|(_, c)| **c != malachite::Integer::ZERO)
        {
            let product = Rational::whole(p * q);
            terms.push(([index(i), index(j)], product.clone()));
            terms.push(([index(j), index(i)], -product));
        }
    }
    SparsePolynomial::from_terms(terms)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::str::FromStr;

    fn function(p: &str, q: &str) -> RationalFunction {
        let polynomial = |text: &str| IntegerPolynomial::from_str(text).unwrap();
        RationalFunction::from_integers(polynomial(p), polynomial(q)).unwrap()
    }

    #[test]
    fn the_index_counts_how_often_a_curve_is_run_over() {
        let cases = [
            (vec![function("x^2+1", "1"), function("x^3+x", "1")], 1),
            (vec![function("x^2", "1"), function("x^4+1", "x^2")], 2),
            // The functions 1/s³ and s³ have poles and zeros at infinity.
            (vec![function("1", "x^3"), function("x^6", "1")], 3),
            (vec![function("5", "1"), function("x^3", "1")], 3),
        ];
        for (functions, index) in cases {
            assert_eq!(tracing_index_bound(&functions), index);
            let common = common_numerator(&functions, &Limits::none()).unwrap();
            let degree = common.terms().map(|(e, _)| e[0]).max();
            assert_eq!(degree, u32::try_from(index).ok());
        }
    }
}
