//! Polynomials modulo a prime, Chinese remainders and the way back to the rational numbers: just enough for
//! gcds, resultants and kernels.

use malachite::base::num::arithmetic::traits::Mod;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::factorization::traits::IsPrime;
use malachite::base::polynomial::Polynomial;
use malachite::integer_polynomial::IntegerPolynomial;
use malachite::{Integer, Natural};

use crate::error::Invariant;

/// For primes below this, products of residues fit 62 bits.
pub(crate) const ABOVE_PRIMES: u64 = (1 << 31) + 1;

/// a·b mod p, for residues a and b.
pub(crate) fn mul_mod(a: u64, b: u64, p: u64) -> u64 {
    // Division of 64 bits is several times faster than that of 128.
    if p >> 32 == 0 {
        return a * b % p;
    }
    let product = u128::from(a) * u128::from(b) % u128::from(p);
    u64::try_from(product).invariant("a residue is less than its prime")
}

/// base^exponent mod p.
pub(crate) fn power_mod(base: u64, mut exponent: u64, p: u64) -> u64 {
    let (mut result, mut square) = (1, base % p);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = mul_mod(result, square, p);
        }
        square = mul_mod(square, square, p);
        exponent >>= 1;
    }
    result
}

/// 1/a mod the prime p, for a residue a ≠ 0, by Euclid.
pub(crate) fn inverse_mod(a: u64, p: u64) -> u64 {
    let (mut r, mut next) = (p, a);
    // The cofactors of a, whose signs alternate.
    let (mut t, mut cofactor) = (0, 1);
    let mut negative = false;
    while next > 1 {
        let quotient = r / next;
        (r, next) = (next, r - quotient * next);
        (t, cofactor) = (cofactor, t + quotient * cofactor);
        negative = !negative;
    }
    if negative { p - cofactor } else { cofactor }
}

/// 1, a, a², …: so many powers of a residue modulo a prime below 2³¹.
pub(crate) fn powers_mod(a: u64, count: usize, p: u64) -> Vec<u64> {
    let mut powers = vec![1; count];
    if let Some(first) = powers.get_mut(1) {
        *first = a;
    }
    for k in 2..count {
        // Shorter chains of products that wait for each other than one by one.
        powers[k] = powers[k / 2] * powers[k - k / 2] % p;
    }
    powers
}

/// Σ f_i g_i of residues modulo a prime below 2³¹, as far as both go.
pub(crate) fn dot_mod(f: &[u64], g: &[u64], p: u64) -> u64 {
    const HALF: u64 = (1 << 32) - 1;
    // Two sums of halves cannot overflow, and the processor takes several products at once.
    let (mut low, mut high) = (0, 0);
    for (a, b) in f.iter().zip(g) {
        let product = (a & HALF) * (b & HALF);
        low += product & HALF;
        high += product >> 32;
    }
    (high % p * ((1 << 32) % p) + low) % p
}

/// The monic gcd of two non-zero polynomials (ascending, trimmed), by Euclid.
pub(crate) fn gcd_mod(mut f: Vec<u64>, mut g: Vec<u64>, p: u64) -> Vec<u64> {
    while !g.is_empty() {
        remainder(&mut f, &g, p);
        std::mem::swap(&mut f, &mut g);
    }
    let inverse = inverse_mod(f[f.len() - 1], p);
    for c in &mut f {
        *c = mul_mod(*c, inverse, p);
    }
    f
}

/// f mod g, in place.
fn remainder(f: &mut Vec<u64>, g: &[u64], p: u64) {
    let inverse = inverse_mod(g[g.len() - 1], p);
    while f.len() >= g.len() {
        let top = f
            .pop()
            .invariant("the dividend is no shorter than the divisor");
        if top != 0 {
            let factor = p - mul_mod(top, inverse, p);
            let start = f.len() + 1 - g.len();
            for (i, &c) in g[..g.len() - 1].iter().enumerate() {
                let sum = u128::from(f[start + i]) + u128::from(mul_mod(factor, c, p));
                f[start + i] = u64::try_from(sum % u128::from(p))
                    .invariant("a residue is less than its prime");
            }
        }
    }
    while f.last() == Some(&0) {
        f.pop();
    }
}

/// Residues of one polynomial modulo a growing product of primes.
pub(crate) struct Images {
    pub(crate) residues: Vec<Natural>,
    pub(crate) modulus: Natural,
}

impl Images {
    /// Of `len` coefficients, modulo 1: nothing is known of them.
    pub(crate) fn unknown(len: usize) -> Self {
        Self {
            residues: vec![Natural::ZERO; len],
            modulus: Natural::ONE,
        }
    }

    /// Modulo one prime.
    pub(crate) fn new(image: &[u64], prime: u64) -> Self {
        Self {
            residues: image.iter().map(|&c| Natural::from(c)).collect(),
            modulus: Natural::from(prime),
        }
    }

    /// One more prime; whether the balanced value stayed the same.
    pub(crate) fn add(&mut self, image: &[u64], prime: u64) -> bool {
        let before = self.balanced();
        self.push(image, prime);
        self.balanced() == before
    }

    /// One more prime.
    pub(crate) fn push(&mut self, image: &[u64], prime: u64) {
        let modulus_mod = u64::try_from(&(&self.modulus % Natural::from(prime)))
            .invariant("a residue is less than its prime");
        let inverse = inverse_mod(modulus_mod, prime);
        for (residue, &c) in self.residues.iter_mut().zip(image) {
            let current = u64::try_from(&(&*residue % Natural::from(prime)))
                .invariant("a residue is less than its prime");
            let difference = if c >= current {
                c - current
            } else {
                c + prime - current
            };
            *residue += &self.modulus * Natural::from(mul_mod(difference, inverse, prime));
        }
        self.modulus *= Natural::from(prime);
    }

    /// Whether these images determine integers of absolute value up to `bound`.
    ///
    /// Lemma 1. If |c| ≤ B and the modulus M is greater than 2B, then [`Images::balanced`] is c.
    /// Proof. It is congruent to c modulo M and at most M/2 in absolute value, so that the two differ by less than M.
    /// Laws: `the_bound_is_reached_at_half_the_modulus` in resultant.rs and in subresultant.rs.
    pub(crate) fn determine(&self, bound: &Natural) -> bool {
        self.modulus > bound << 1u64
    }

    /// The representatives of least absolute value.
    pub(crate) fn balanced(&self) -> IntegerPolynomial {
        let half = &self.modulus >> 1u64;
        let coefficients = self.residues.iter().map(|r| {
            if *r > half {
                Integer::from(r) - Integer::from(&self.modulus)
            } else {
                Integer::from(r)
            }
        });
        IntegerPolynomial::from_coefficients_asc(coefficients.collect())
    }
}

/// The residue of an integer, in [0, p).
pub(crate) fn reduce_integer(value: &Integer, prime: u64) -> u64 {
    u64::try_from(&value.mod_op(Integer::from(prime))).invariant("a residue is less than its prime")
}

/// The next prime below an odd number.
pub(crate) fn previous_prime(from: u64) -> u64 {
    let mut candidate = from - 2;
    while !candidate.is_prime() {
        candidate -= 2;
    }
    candidate
}

/// Coefficients, ascending, of the polynomial with the given values at 0, 1, 2, … modulo a prime
/// (Newton).
pub(crate) fn interpolate(mut values: Vec<u64>, p: u64) -> Vec<u64> {
    let n = values.len();
    let inverses = inverses_mod(n, p);
    for (gap, inverse) in inverses.iter().enumerate().skip(1) {
        for i in (gap..n).rev() {
            values[i] = (values[i] + p - values[i - 1]) * inverse % p;
        }
    }
    // Horner over (t − k), from the last difference down.
    let mut coefficients = vec![0; n];
    for k in (0..n).rev() {
        let minus = p - k as u64 % p;
        for i in (1..n - k).rev() {
            coefficients[i] = (coefficients[i - 1] + minus * coefficients[i]) % p;
        }
        coefficients[0] = (minus * coefficients[0] + values[k]) % p;
    }
    coefficients
}

/// The inverses of the numbers below n modulo a prime p ≥ n, with 0 for 0.
pub(crate) fn inverses_mod(n: usize, p: u64) -> Vec<u64> {
    let mut inverses = vec![0; n];
    if let Some(one) = inverses.get_mut(1) {
        *one = 1;
    }
    for k in 2..n {
        // p = qk + r, so 1/k = −q/r.
        let (quotient, rest) = (
            p / k as u64,
            usize::try_from(p % k as u64).invariant("a rest is less than its divisor"),
        );
        inverses[k] = (p - quotient) * inverses[rest] % p;
    }
    inverses
}

/// A small generator of well-mixed numbers (Steele, Lea & Flood's SplitMix64).
pub(crate) struct SplitMix(pub(crate) u64);

impl SplitMix {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const P: u64 = 2_147_483_647;

    proptest! {
        #[test]
        fn inverses_are_those_of_fermat(a in 1..P, big in 1u64..(1 << 61) - 1) {
            for (a, p) in [(a, P), (big, (1 << 61) - 1), (1, P), (P - 1, P)] {
                prop_assert_eq!(inverse_mod(a, p), power_mod(a, p - 2, p));
            }
            let n = usize::try_from(a % 100).unwrap() + 2;
            prop_assert_eq!(inverses_mod(n, 101)[n - 1], power_mod(n as u64 - 1, 99, 101));
        }

        #[test]
        fn sums_and_powers_are_those_made_one_by_one(
            f in prop::collection::vec(0..P, 0..20), g in prop::collection::vec(0..P, 0..20), a in 0..P,
        ) {
            let sum = f.iter().zip(&g).fold(0, |sum, (a, b)| (sum + mul_mod(*a, *b, P)) % P);
            prop_assert_eq!(dot_mod(&f, &g, P), sum);
            prop_assert_eq!(dot_mod(&[P - 1; 4000], &[P - 1; 4000], P), 4000);
            for (k, power) in powers_mod(a, f.len(), P).into_iter().enumerate() {
                prop_assert_eq!(power, power_mod(a, k as u64, P));
            }
        }

        #[test]
        fn interpolation_takes_values_back_to_coefficients(f in prop::collection::vec(0..P, 0..12)) {
            let at = |t: u64| f.iter().rev().fold(0, |v, c| (v * t + c) % P);
            prop_assert_eq!(interpolate((0..f.len() as u64).map(at).collect(), P), f);
        }
    }
}
