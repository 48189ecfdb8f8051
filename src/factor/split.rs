//! The steps of a factorization in order: monomials, forms, powers of variables, contents, squarefree parts, factors.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Parity;

use super::gcd::{content_in, form_content, squarefree_parts};
use super::multivariate::irreducible_factors;
use super::univariate::is_power;
use super::{Irreducibility, Variable};
use crate::error::{Error, Invariant, Result};
use crate::limits::Limits;
use crate::poly::IntegerTerms;

/// The largest number of coefficients of a dense table.
pub(super) const CELLS_AT_MOST: usize = 1 << 21;

/// The largest degree of a univariate polynomial that is factored modulo primes.
pub(super) const DEGREE_AT_MOST: usize = 1 << 12;

/// The largest total degree of an input, before anything is divided out.
pub(super) const EXPONENTS_AT_MOST: u64 = 1 << 20;

/// An irreducible factor, its multiplicity and the proof.
pub(super) struct Found {
    pub(super) polynomial: IntegerTerms<3>,
    pub(super) multiplicity: usize,
    pub(super) proof: Irreducibility,
}

/// All irreducible factors of a primitive f.
///
/// # Errors
/// [`Error::Limit`] beyond [`EXPONENTS_AT_MOST`], [`CELLS_AT_MOST`] or [`DEGREE_AT_MOST`], or for too many subsets; those of
/// `limits`.
pub(super) fn factors(f: &IntegerTerms<3>, limits: &Limits) -> Result<Vec<Found>> {
    let total = f
        .iter()
        .map(|(e, _)| e.iter().map(|&k| u64::from(k)).sum::<u64>());
    if total.max().is_some_and(|d| d > EXPONENTS_AT_MOST) {
        return Err(Error::limit(format!(
            "total degree {EXPONENTS_AT_MOST} of a polynomial to factor"
        )));
    }
    let mut found = Vec::new();
    let monomial = f.monomial_content();
    for v in (0..3).filter(|&v| monomial[v] > 0) {
        found.push(Found {
            polynomial: IntegerTerms::variable(v),
            multiplicity: monomial[v] as usize,
            proof: Irreducibility::Linear {
                variable: Variable::from_index(v),
            },
        });
    }
    let f = f.map_exponents(|e| std::array::from_fn(|v| e[v] - monomial[v]));
    let used = f.used();
    if used.len() >= 2 && f.is_homogeneous() {
        found.extend(of_form(&f, limits)?);
    } else if let [u, v] = used[..]
        && f.degrees()
            .into_iter()
            .all(|d| d as usize <= DEGREE_AT_MOST)
    {
        let form = form_content(&f, u, v);
        match f.divided_by(&form) {
            Some(rest) if !form.is_constant() => {
                found.extend(of_form(&form, limits)?);
                found.extend(deflated(&rest, limits)?);
            }
            _ => found.extend(deflated(&f, limits)?),
        }
    } else if !used.is_empty() {
        found.extend(deflated(&f, limits)?);
    }
    Ok(found)
}

/// The factors of a form that no variable divides; they are found at `last variable = 1`.
fn of_form(form: &IntegerTerms<3>, limits: &Limits) -> Result<Vec<Found>> {
    let Some(&last) = form.used().last() else {
        return Ok(Vec::new());
    };
    let mut found = deflated(&form.evaluated(last, &Integer::from(1)).primitive(), limits)?;
    for factor in &mut found {
        let g = &factor.polynomial;
        let total = g.iter().map(|(e, _)| e.iter().sum::<u32>()).max();
        let total = total.invariant("a factor is not 0");
        factor.polynomial = g
            .map_exponents(|e| {
                let mut full = *e;
                full[last] = total - e.iter().sum::<u32>();
                full
            })
            .primitive();
    }
    Ok(found)
}

/// The factors of a polynomial f that no variable divides; f is factored first as a polynomial in powers of the variables.
fn deflated(f: &IntegerTerms<3>, limits: &Limits) -> Result<Vec<Found>> {
    let powers = f.exponent_gcds().map(|k| k.max(1));
    let small = f.map_exponents(|e| std::array::from_fn(|v| e[v] / powers[v]));
    let mut found = Vec::new();
    for (multiplicity, part, v) in squarefree(&small, limits)? {
        within_limits(&part)?;
        for (polynomial, proof) in irreducible_factors(&part, v, limits)? {
            found.push(Found {
                polynomial,
                multiplicity,
                proof,
            });
        }
    }
    for (v, power) in powers.into_iter().enumerate() {
        for q in prime_factors(power) {
            let mut inflated = Vec::new();
            for factor in found {
                inflated.extend(inflate(factor, v, q, limits)?);
            }
            found = inflated;
        }
    }
    Ok(found)
}

/// The squarefree, pairwise coprime parts of f with their multiplicities, each with a variable in which it is primitive.
fn squarefree(
    f: &IntegerTerms<3>,
    limits: &Limits,
) -> Result<Vec<(usize, IntegerTerms<3>, usize)>> {
    let degrees = f.degrees();
    let Some(v) = f.used().into_iter().min_by_key(|&v| degrees[v]) else {
        return Ok(Vec::new());
    };
    within_limits(f)?;
    let (content, rest) = content_in(f, v, limits)?;
    let mut parts = squarefree(&content, limits)?;
    for (multiplicity, part) in squarefree_parts(&rest, v, limits)? {
        parts.push((multiplicity, part, v));
    }
    Ok(parts)
}

fn within_limits(f: &IntegerTerms<3>) -> Result<()> {
    if f.cells() > CELLS_AT_MOST {
        return Err(Error::limit(format!(
            "a polynomial with {:?} as degrees in x, y, z has room for more than {CELLS_AT_MOST} terms",
            f.degrees()
        )));
    }
    let least = f.degrees().into_iter().filter(|&d| d > 0).min();
    if least.is_some_and(|d| d as usize > DEGREE_AT_MOST) {
        return Err(Error::limit(format!(
            "degree {DEGREE_AT_MOST} in the variable to factor in"
        )));
    }
    Ok(())
}

/// The factors of g(…, v^q, …), for an irreducible g that v does not divide and a prime q.
fn inflate(g: Found, v: usize, q: u32, limits: &Limits) -> Result<Vec<Found>> {
    if g.polynomial.degrees()[v] == 0 {
        return Ok(vec![g]);
    }
    let stays = stays_irreducible(&g.polynomial, v, q);
    let inflated = g.polynomial.map_exponents(|e| {
        let mut e = *e;
        e[v] = e[v].checked_mul(q).invariant("exponents are below 2^32");
        e
    });
    if stays {
        return Ok(vec![Found {
            polynomial: inflated,
            multiplicity: g.multiplicity,
            proof: Irreducibility::Capelli {
                variable: Variable::from_index(v),
                exponent: q,
            },
        }]);
    }
    within_limits(&inflated)?;
    let degrees = inflated.degrees();
    let main = inflated.used().into_iter().min_by_key(|&w| degrees[w]);
    let factors = irreducible_factors(
        &inflated,
        main.invariant("the polynomial is not constant"),
        limits,
    )?;
    Ok(factors
        .into_iter()
        .map(|(polynomial, proof)| Found {
            polynomial,
            multiplicity: g.multiplicity,
            proof,
        })
        .collect())
}

/// Capelli's theorem: let g be irreducible of degree n in v, with a root α over K = Q(other variables), and let q be a prime.
/// g(v^q) is reducible only if α is a q-th power in K(α). Then the norm (−1)^n g(0)/lc(g) of α is a q-th power in K, and so are
/// its values at points, in Q.
fn stays_irreducible(g: &IntegerTerms<3>, v: usize, q: u32) -> bool {
    let rows = g.coefficients_in(v);
    let (Some((_, constant)), Some((&n, lead))) = (rows.first_key_value(), rows.last_key_value())
    else {
        return false;
    };
    let univariate = constant.is_constant() && lead.is_constant();
    let points = if univariate { 1 } else { 6 };
    (1..=points).any(|k: i64| {
        let point = [1, 2, -3].map(|c| Integer::from(c * (k / 2 + 1) + k % 2));
        let (mut a, b) = (constant.value(&point), lead.value(&point));
        if n.odd() {
            a = -a;
        }
        a != 0 && b != 0 && !is_power(&a, &b, u64::from(q))
    })
}

fn prime_factors(mut n: u32) -> Vec<u32> {
    let mut primes = Vec::new();
    let mut q = 2;
    while n > 1 {
        if q * q > n {
            q = n;
        }
        while n.is_multiple_of(q) {
            primes.push(q);
            n /= q;
        }
        q += 1;
    }
    primes
}
