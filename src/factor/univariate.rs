//! The irreducible factors of a squarefree univariate polynomial, by Zassenhaus' algorithm.

use malachite::base::num::arithmetic::traits::{CeilingLogBase2, DivisibleBy, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::factorization::traits::IsPrime;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial;
use malachite::{Integer, Natural};

use super::recombine::{Sieve, degrees_of_products, intersect, recombine};
use super::{Irreducibility, Variable};
use crate::error::{Invariant, Result};
use crate::limits::Limits;
use crate::modular::{PrimeField, TruncatedRing, balanced, distinct_degrees, equal_degree, lift};
use crate::poly::{IntegerPolynomial, divide_exactly, primitive_part};

/// Primes are tried from this number on.
const FIRST_PRIME: u64 = 13;

/// The number of good primes that are compared, the number of primes if all of them have many factors, and this number of factors.
const PRIMES: usize = 4;
const MORE_PRIMES: usize = 9;
const MANY_FACTORS: usize = 10;

/// The irreducible factors, with proofs, of a primitive squarefree polynomial of positive degree in `variable`. Each is
/// primitive with a positive leading coefficient.
///
/// Method: von zur Gathen & Gerhard, *Modern Computer Algebra*, Algorithm 15.19 with the recombination of 15.22. It uses the
/// factors modulo the best of a few small primes, Hensel lifting above the Landau–Mignotte bound, products of subsets, and
/// trial division. Before that, the degrees that are possible modulo all the primes are intersected, which proves that most
/// irreducible polynomials are so.
///
/// # Errors
/// [`crate::error::Error::Limit`] if too many subsets would have to be tried; those of `limits`.
pub(super) fn irreducible_factors(
    f: &IntegerPolynomial,
    variable: Variable,
    limits: &Limits,
) -> Result<Vec<(IntegerPolynomial, Irreducibility)>> {
    let f = primitive_part(f);
    let degree = f.coefficients_asc().len().saturating_sub(1);
    if degree <= 1 {
        return Ok(vec![(f, Irreducibility::Linear { variable })]);
    }
    let local = match best_prime(&f, limits)? {
        Modular::Irreducible(primes) => {
            return Ok(vec![(f, Irreducibility::Degrees { primes })]);
        }
        Modular::Factors(local) => local,
    };
    let field = local.field;
    let mut factors = Vec::new();
    for (d, part) in local.parts {
        limits.check()?;
        factors.extend(equal_degree(&field, part, d));
    }
    factors.sort_unstable();

    let (exponent, modulus) = precision(&f, &field);
    let ring = TruncatedRing {
        modulus,
        y: 1,
        z: 1,
    };
    let target = ring.monic(&ring.normalize(f.clone()), &field);
    let lifted = lift(&target, &factors, &field, exponent, &ring, limits)?;
    let sieve = trace_sieve(&f, &lifted, local.allowed, &ring.modulus);

    let mut rest = f;
    let mut found = Vec::new();
    recombine(&sieve, limits, |subset| {
        let chosen: Vec<&IntegerPolynomial> = subset.iter().map(|&i| &lifted[i]).collect();
        if let Some((factor, quotient)) = try_product(&rest, &chosen, &ring) {
            found.push(factor);
            rest = quotient;
            return Ok(true);
        }
        Ok(false)
    })?;
    found.push(rest);
    let proof = Irreducibility::Recombination {
        local: lifted.len(),
    };
    let with_proof = found.into_iter().map(|g| {
        let linear = g.coefficients_asc().len() == 2;
        let proof = if linear {
            Irreducibility::Linear { variable }
        } else {
            proof.clone()
        };
        (g, proof)
    });
    Ok(with_proof.collect())
}

/// The result of the factorizations modulo a few primes.
enum Modular {
    /// The polynomial is irreducible: no proper factor has a degree that is possible modulo all these primes.
    Irreducible(Vec<u64>),
    Factors(Local),
}

/// The prime with the fewest factors, and the products of factors of equal degree.
struct Local {
    field: PrimeField,
    parts: Vec<(usize, Vec<u64>)>,
    allowed: Vec<bool>,
}

fn best_prime(f: &IntegerPolynomial, limits: &Limits) -> Result<Modular> {
    let degree = f.coefficients_asc().len() - 1;
    let mut allowed = vec![true; degree + 1];
    let mut primes = Vec::new();
    let mut best: Option<(usize, Local)> = None;
    let mut prime = FIRST_PRIME - 2;
    loop {
        limits.check()?;
        prime += 2;
        if !prime.is_prime() {
            continue;
        }
        let field = PrimeField::new(prime);
        let image = field.reduce(f);
        if image.len() != degree + 1 || !field.is_squarefree(&image) {
            continue;
        }
        primes.push(prime);
        let parts = distinct_degrees(&field, &field.monic(image), limits)?;
        let degrees = parts
            .iter()
            .flat_map(|(d, part)| std::iter::repeat_n(*d, (part.len() - 1) / d));
        let count = degrees.clone().count();
        if count == 1 {
            return Ok(Modular::Irreducible(vec![prime]));
        }
        if !intersect(&mut allowed, &degrees_of_products(degrees)) {
            return Ok(Modular::Irreducible(primes));
        }
        if best.as_ref().is_none_or(|(least, _)| count < *least) {
            let allowed = Vec::new();
            let local = Local {
                field,
                parts,
                allowed,
            };
            best = Some((count, local));
        }
        best = match best {
            Some((least, local)) if primes.len() >= primes_for(least) => {
                return Ok(Modular::Factors(Local { allowed, ..local }));
            }
            other => other,
        };
    }
}

fn primes_for(factors: usize) -> usize {
    if factors < MANY_FACTORS {
        PRIMES
    } else {
        MORE_PRIMES
    }
}

/// The pair (k, p^k), where p^k is more than twice the coefficients of `lc(f)/lc(g) · g` for every factor g of f, which are at
/// most 2^n ‖f‖ (Landau–Mignotte), and also much larger than the trace.
fn precision(f: &IntegerPolynomial, field: &PrimeField) -> (u64, Integer) {
    let bound =
        (norm_squared(f).significant_bits()).div_ceil(2) + f.coefficients_asc().len() as u64 + 2;
    let bits = bound.max(trace_bits(f) + 24);
    power_above(field.prime(), bits)
}

/// The pair (k, p^k) with the least k for which p^k > 2^bits.
pub(super) fn power_above(prime: u64, bits: u64) -> (u64, Integer) {
    let (mut exponent, mut power) = (1, Integer::from(prime));
    while power.significant_bits() <= bits {
        power *= Integer::from(prime);
        exponent += 1;
    }
    (exponent, power)
}

/// The sum of the squares of the coefficients.
fn norm_squared(f: &IntegerPolynomial) -> Integer {
    f.coefficients_asc()
        .iter()
        .fold(Integer::ZERO, |sum, c| sum + c.square())
}

/// The exponent of a power of 2 that bounds |lc(f)| times the sum of the absolute values of the roots. For each root it uses
/// Fujiwara's bound `2 max |a_(n−k)/a_n|^(1/k)`.
fn trace_bits(f: &IntegerPolynomial) -> u64 {
    let c = f.coefficients_asc();
    let n = c.len() - 1;
    let lead = c[n].significant_bits();
    let root = (1..=n)
        .filter(|&k| c[n - k] != 0)
        .map(|k| {
            let ratio = (c[n - k].significant_bits() + 1).saturating_sub(lead);
            ratio.div_ceil(k as u64)
        })
        .max()
        .unwrap_or(0);
    lead + root + 1 + (n as u64).ceiling_log_base_2() + 1
}

/// The sieve by the second coefficients of lc(f) g_i over p^k, in units of 2^−64.
fn trace_sieve(
    f: &IntegerPolynomial,
    lifted: &[IntegerPolynomial],
    allowed: Vec<bool>,
    modulus: &Integer,
) -> Sieve {
    let lead = f.coefficients_asc().last().cloned();
    let lead = lead.invariant("the polynomial is not 0");
    let ring = TruncatedRing {
        modulus: modulus.clone(),
        y: 1,
        z: 1,
    };
    let weights = lifted.iter().map(|g| {
        let c = g.coefficients_asc();
        fraction(&ring.reduced(&lead * &c[c.len() - 2]), modulus)
    });
    // The tolerance is bits of the trace over bits of the modulus, plus one unit of rounding for each summand.
    let room = modulus.significant_bits() - 1;
    let shift = (64 + trace_bits(f)).saturating_sub(room);
    Sieve {
        weights: weights.collect(),
        tolerance: (1u64 << shift.min(62)) + lifted.len() as u64,
        degrees: lifted
            .iter()
            .map(|g| g.coefficients_asc().len() - 1)
            .collect(),
        allowed,
    }
}

/// The number ⌊2^64 residue/modulus⌋.
pub(super) fn fraction(residue: &Integer, modulus: &Integer) -> u64 {
    u64::try_from(&((residue << 64u64) / modulus)).invariant("a residue is less than its modulus")
}

/// The candidate factor of `rest`, which is lc(rest) times the chosen local factors, and the quotient, if it divides.
fn try_product(
    rest: &IntegerPolynomial,
    chosen: &[&IntegerPolynomial],
    ring: &TruncatedRing,
) -> Option<(IntegerPolynomial, IntegerPolynomial)> {
    let c = rest.coefficients_asc();
    let (lead, constant) = (c.last()?, c.first()?);
    // The constant terms are tested first: that of lc(rest)/lc(g) · g must divide lc(rest) rest(0).
    let mut product = lead.clone();
    for g in chosen {
        product = ring.reduced(product * g.coefficients_asc().first()?);
    }
    let value = balanced(&product, &ring.modulus);
    if *constant != 0 && (value == 0 || !(lead * constant).divisible_by(&value)) {
        return None;
    }
    let start = IntegerPolynomial::from_coefficients_asc(vec![lead.clone()]);
    let product = chosen
        .iter()
        .fold(start, |product, g| ring.product(&product, g));
    let candidate = IntegerPolynomial::from_coefficients_asc(
        product
            .coefficients_asc()
            .iter()
            .map(|c| balanced(c, &ring.modulus))
            .collect(),
    );
    let candidate = primitive_part(&candidate);
    let quotient = divide_exactly(rest, &candidate)?;
    Some((candidate, quotient))
}

/// Whether the rational number a/b ≠ 0 is the q-th power of a rational number.
pub(super) fn is_power(a: &Integer, b: &Integer, q: u64) -> bool {
    use malachite::base::num::arithmetic::traits::{CheckedRoot, DivExact, Gcd};
    if q.is_multiple_of(2) && (*a < 0) != (*b < 0) {
        return false;
    }
    let common = a.unsigned_abs_ref().gcd(b.unsigned_abs_ref());
    [a, b].into_iter().all(|n| {
        let n = n.unsigned_abs_ref().div_exact(&common);
        n == Natural::ONE || n.checked_root(q).is_some()
    })
}
