//! The irreducible factors of a squarefree polynomial in two or three variables.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::DivisibleBy;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::factorization::traits::IsPrime;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial;

use super::gcd::{QUICK_PRIME, content_in};
use super::recombine::{Sieve, recombine};
use super::specialize::{Best, Specialized, specialize};
use super::univariate::{fraction, power_above};
use super::{Irreducibility, Variable, univariate};
use crate::error::{Invariant, Result};
use crate::limits::Limits;
use crate::modular::{PrimeField, SplitMix, TruncatedRing, balanced, lift};
use crate::poly::{IntegerPolynomial, IntegerTerms};

/// The irreducible factors, with proofs, of a polynomial f that is squarefree and primitive in v, so that v occurs in every
/// factor.
///
/// The factors at a point of the other variables are lifted to power series there (Musser; Wang; *Modern Computer Algebra*,
/// §15.6). The precision in each variable is one more than the degree of f, and the coefficients are computed modulo a prime
/// power that is larger than those of a factor. No guess of leading coefficients is necessary: f is divided by its leading
/// coefficient as a power series, and a factor g appears as lc(f)/lc(g) · g.
///
/// # Errors
/// [`crate::error::Error::Limit`] if too many subsets would have to be tried; those of `limits`.
pub(super) fn irreducible_factors(
    f: &IntegerTerms<3>,
    v: usize,
    limits: &Limits,
) -> Result<Vec<(IntegerTerms<3>, Irreducibility)>> {
    if let [only] = f.used()[..] {
        let variable = Variable::from_index(only);
        let factors = univariate::irreducible_factors(&f.to_univariate(only), variable, limits)?;
        return Ok(factors
            .into_iter()
            .map(|(g, proof)| (IntegerTerms::from_univariate(&g, only), proof))
            .collect());
    }
    let linear = Irreducibility::Linear {
        variable: Variable::from_index(v),
    };
    if f.degrees()[v] == 1 {
        return Ok(vec![(f.clone(), linear)]);
    }
    let best = match specialize(f, v, limits)? {
        Specialized::Irreducible(proof) => return Ok(vec![(f.clone(), proof)]),
        Specialized::Factors(best) => best,
    };
    let local = Local::lift(f, v, &best, limits)?;
    let sieve = local.sieve(best.allowed);
    let mut rest = local.f.clone();
    let mut found = Vec::new();
    recombine(&sieve, limits, |subset| {
        if let Some((factor, quotient)) = local.try_product(&rest, subset, limits)? {
            found.push(factor);
            rest = quotient;
            return Ok(true);
        }
        Ok(false)
    })?;
    found.push(rest);
    let with_proof = found.into_iter().map(|g| {
        let proof = if g.degrees()[v] == 1 {
            linear.clone()
        } else {
            Irreducibility::Recombination {
                local: local.factors.len(),
            }
        };
        let back = (0..3).fold(g, |g, w| g.shifted(w, &Integer::from(-best.point[w])));
        (back.primitive(), proof)
    });
    Ok(with_proof.collect())
}

/// The polynomial f, moved so that the chosen point is the origin, and its monic factors as power series there.
struct Local {
    f: IntegerTerms<3>,
    variables: Roles,
    ring: TruncatedRing,
    factors: Vec<IntegerPolynomial>,
}

/// The variables that play the parts of x, y, z in a [`TruncatedRing`].
struct Roles {
    main: usize,
    y: usize,
    z: usize,
}

impl Roles {
    fn new(f: &IntegerTerms<3>, main: usize) -> Self {
        let degrees = f.degrees();
        let mut others: Vec<usize> = (0..3).filter(|&w| w != main).collect();
        // An unused variable plays the part of z.
        others.sort_unstable_by_key(|&w| (std::cmp::Reverse(degrees[w]), w));
        Self {
            main,
            y: others[0],
            z: others[1],
        }
    }
}

impl Local {
    fn lift(f: &IntegerTerms<3>, v: usize, best: &Best, limits: &Limits) -> Result<Self> {
        let f = (0..3).fold(f.clone(), |g, w| {
            g.shifted(w, &Integer::from(best.point[w]))
        });
        let variables = Roles::new(&f, v);
        let degrees = f.degrees();
        // Mahler's measure is multiplicative and at most ‖f‖. A coefficient of lc(f)/lc(g) · g is at most 2^(sum of the
        // degrees) times its measure.
        let bits = f.norm_squared().significant_bits().div_ceil(2)
            + degrees.iter().map(|&d| u64::from(d)).sum::<u64>()
            + 2;
        let field = good_prime(&best.factors);
        let (exponent, modulus) = power_above(field.prime(), bits);
        let ring = TruncatedRing {
            modulus,
            y: degrees[variables.y] as usize + 2,
            z: degrees[variables.z] as usize + 1,
        };
        let residues: Vec<Vec<u64>> = best
            .factors
            .iter()
            .map(|g| field.monic(field.reduce(g)))
            .collect();
        let target = ring.monic(&pack(&ring, &variables, &f), &field);
        let factors = lift(&target, &residues, &field, exponent, &ring, limits)?;
        Ok(Self {
            f,
            variables,
            ring,
            factors,
        })
    }

    /// The sieve uses that lc(f)/lc(g) · g has at most the degree of f in y, which is one less than the precision. So in lc(f)
    /// times the sum of the second coefficients, the terms above that degree vanish; a random combination of them is the
    /// weight.
    fn sieve(&self, allowed: Vec<bool>) -> Sieve {
        let ring = &self.ring;
        let lead = ring.lead(&pack(ring, &self.variables, &self.f));
        let mut random = SplitMix(0x7ace);
        let multipliers: Vec<Integer> = (0..ring.z)
            .map(|_| Integer::from(random.next() >> 32))
            .collect();
        let weights = self.factors.iter().map(|g| {
            let at = (ring.degree(g) - 1) * ring.block();
            let second = g.coefficients_asc()[at..at + ring.block()].to_vec();
            let trace = ring.product(&lead, &IntegerPolynomial::from_coefficients_asc(second));
            let mut sum = Integer::ZERO;
            for (k, c) in trace.coefficients_asc().iter().enumerate() {
                if let Some((j, l)) = ring.exponents(k)
                    && j + 1 == ring.y
                {
                    sum += c * &multipliers[l];
                }
            }
            fraction(&ring.reduced(sum), &ring.modulus)
        });
        Sieve {
            weights: weights.collect(),
            tolerance: self.factors.len() as u64,
            degrees: self.factors.iter().map(|g| ring.degree(g)).collect(),
            allowed,
        }
    }

    /// The candidate factor of `rest`, which is lc(rest) times the chosen local factors, and the quotient, if it divides.
    fn try_product(
        &self,
        rest: &IntegerTerms<3>,
        subset: &[usize],
        limits: &Limits,
    ) -> Result<Option<(IntegerTerms<3>, IntegerTerms<3>)>> {
        limits.check()?;
        let ring = &self.ring;
        let start = ring.lead(&pack(ring, &self.variables, rest));
        let product = subset
            .iter()
            .fold(start, |p, &i| ring.product(&p, &self.factors[i]));
        let candidate = unpack(ring, &self.variables, &product);
        let (degrees, most) = (candidate.degrees(), rest.degrees());
        if (0..3).any(|w| degrees[w] > most[w]) {
            return Ok(None);
        }
        // The candidate must divide lc(rest) · rest; testing this at one point costs little.
        let point = [Integer::from(2), Integer::from(3), Integer::from(5)];
        let value = candidate.value(&point);
        let rows = rest.coefficients_in(self.variables.main);
        let lead = rows
            .last_key_value()
            .map_or(Integer::ZERO, |(_, row)| row.value(&point));
        let whole = lead * rest.value(&point);
        if value == 0 && whole != 0 || value != 0 && !whole.divisible_by(&value) {
            return Ok(None);
        }
        let (_, factor) = content_in(&candidate, self.variables.main, limits)?;
        let factor = factor.primitive();
        Ok(rest.divided_by(&factor).map(|quotient| (factor, quotient)))
    }
}

/// A large prime modulo which the factors keep their degrees and are coprime.
fn good_prime(factors: &[IntegerPolynomial]) -> PrimeField {
    let mut prime = QUICK_PRIME;
    loop {
        let field = PrimeField::new(prime);
        let images: Vec<Vec<u64>> = factors.iter().map(|g| field.reduce(g)).collect();
        let kept = images
            .iter()
            .zip(factors)
            .all(|(image, g)| image.len() == g.coefficients_asc().len());
        let product = images
            .iter()
            .fold(vec![1], |p, image| field.product(&p, image));
        if kept && field.is_squarefree(&product) {
            return field;
        }
        prime -= 2;
        while !prime.is_prime() {
            prime -= 2;
        }
    }
}

fn pack(ring: &TruncatedRing, roles: &Roles, f: &IntegerTerms<3>) -> IntegerPolynomial {
    let size = (f.degrees()[roles.main] as usize + 1) * ring.block();
    let mut coefficients = vec![Integer::ZERO; size];
    for (e, c) in f.iter() {
        let [i, j, l] = [roles.main, roles.y, roles.z].map(|w| e[w] as usize);
        coefficients[i * ring.block() + l * ring.row() + j] = c.clone();
    }
    ring.normalize(IntegerPolynomial::from_coefficients_asc(coefficients))
}

fn unpack(ring: &TruncatedRing, roles: &Roles, f: &IntegerPolynomial) -> IntegerTerms<3> {
    let narrow = |k: usize| u32::try_from(k).invariant("exponents are below 2^32");
    let terms = f.coefficients_asc().iter().enumerate();
    let terms = terms.filter(|(_, c)| **c != 0).filter_map(|(k, c)| {
        let (j, l) = ring.exponents(k)?;
        let mut e: [u32; 3] = [0; 3];
        e[roles.main] = narrow(k / ring.block());
        e[roles.y] = narrow(j);
        e[roles.z] = narrow(l);
        Some((e, balanced(c, &ring.modulus)))
    });
    IntegerTerms::new(terms.collect())
}
