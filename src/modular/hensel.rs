//! Hensel lifting of all factors at once: first p-adically, then in y, then in z.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::polynomial::Polynomial;
use malachite::integer_polynomial::IntegerPolynomial;

use super::PrimeField;
use super::power_series::TruncatedRing;
use crate::error::{Invariant, Result};
use crate::limits::Limits;

/// Lifts the factorization `target = ∏ factors` (monic in x) from Z/p to `ring` = (Z/p^k)[y, z]/(y^K, z^L).
///
/// `target` must be packed as in `ring`. The factors must be monic, and pairwise coprime modulo p and (y, z). Each round
/// doubles the precision: with `Σ s_i ∏_{j≠i} g_j = 1` and `e = target − ∏ g_j` it adds `s_i e mod g_i` to g_i, and then
/// corrects the s_i in the same way (*Modern Computer Algebra*, §15.4, for many factors at once). There are log2 k + log2 K +
/// log2 L rounds, each with at most O(n²) products in the ring of the round.
///
/// # Errors
/// Those of `limits`.
pub(crate) fn lift(
    target: &IntegerPolynomial,
    factors: &[Vec<u64>],
    field: &PrimeField,
    exponent: u64,
    ring: &TruncatedRing,
    limits: &Limits,
) -> Result<Vec<IntegerPolynomial>> {
    let prime = Integer::from(field.prime());
    let mut schedule = Vec::new();
    for l in halvings(ring.z) {
        schedule.push((exponent, ring.y, l));
    }
    for k in halvings(ring.y) {
        schedule.push((exponent, k, 1));
    }
    let bits = usize::try_from(exponent).invariant("a modulus fits in memory");
    for e in halvings(bits) {
        schedule.push((e as u64, 1, 1));
    }
    let mut lifted = Lifted::start(factors, field);
    while let Some((e, y, z)) = schedule.pop() {
        limits.check()?;
        let modulus = (&prime).pow(e);
        let next = TruncatedRing { modulus, y, z };
        let round_target = next.convert(ring, target);
        lifted.improve(&round_target, next, !schedule.is_empty());
    }
    Ok(lifted.factors)
}

/// The numbers n, ⌈n/2⌉, ⌈n/4⌉, … down to 2.
fn halvings(n: usize) -> impl Iterator<Item = usize> {
    std::iter::successors(Some(n), |k| Some(k.div_ceil(2))).take_while(|k| *k > 1)
}

/// The factors of a target, and the cofactors with which they make a partition of unity, in one ring.
struct Lifted {
    ring: TruncatedRing,
    factors: Vec<IntegerPolynomial>,
    cofactors: Vec<IntegerPolynomial>,
}

impl Lifted {
    /// The factors and cofactors modulo p.
    fn start(factors: &[Vec<u64>], field: &PrimeField) -> Self {
        let integers = |f: &[u64]| {
            IntegerPolynomial::from_coefficients_asc(f.iter().map(|&c| Integer::from(c)).collect())
        };
        let product = factors
            .iter()
            .fold(vec![1], |product, g| field.product(&product, g));
        let cofactors = factors.iter().map(|g| {
            let others = field.quotient(product.clone(), g);
            let inverse = field.inverse_modulo(&others, g);
            integers(&inverse.invariant("factors of a squarefree polynomial are coprime"))
        });
        Self {
            ring: TruncatedRing {
                modulus: Integer::from(field.prime()),
                y: 1,
                z: 1,
            },
            factors: factors.iter().map(|g| integers(g)).collect(),
            cofactors: cofactors.collect(),
        }
    }

    /// One round, after which the factors have the precision of `ring`.
    fn improve(&mut self, target: &IntegerPolynomial, ring: TruncatedRing, go_on: bool) {
        for f in self.factors.iter_mut().chain(&mut self.cofactors) {
            *f = ring.convert(&self.ring, f);
        }
        let error = ring.difference(target, &ring.product_of(&self.factors));
        for (g, s) in self.factors.iter_mut().zip(&self.cofactors) {
            *g = ring.sum(g, &correction(&ring, &error, s, g));
        }
        if go_on {
            let (_, unity) = partition(&ring, &self.factors, &self.cofactors);
            let error = ring.difference(&IntegerPolynomial::one(), &unity);
            for (g, s) in self.factors.iter().zip(&mut self.cofactors) {
                *s = ring.sum(s, &correction(&ring, &error, s, g));
            }
        }
        self.ring = ring;
    }
}

/// The correction `error · s mod g`.
fn correction(
    ring: &TruncatedRing,
    error: &IntegerPolynomial,
    s: &IntegerPolynomial,
    g: &IntegerPolynomial,
) -> IntegerPolynomial {
    ring.remainder(&ring.product(&ring.remainder(error, g), s), g)
}

/// The product `∏ g_i` and the sum `Σ s_i ∏_{j≠i} g_j`.
fn partition(
    ring: &TruncatedRing,
    factors: &[IntegerPolynomial],
    cofactors: &[IntegerPolynomial],
) -> (IntegerPolynomial, IntegerPolynomial) {
    if let ([g], [s]) = (factors, cofactors) {
        return (g.clone(), s.clone());
    }
    let middle = factors.len() / 2;
    let (p, s) = partition(ring, &factors[..middle], &cofactors[..middle]);
    let (q, t) = partition(ring, &factors[middle..], &cofactors[middle..]);
    let sum = ring.sum(&ring.product(&p, &t), &ring.product(&q, &s));
    (ring.product(&p, &q), sum)
}
