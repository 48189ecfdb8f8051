//! Factorization modulo a prime: first by distinct degrees, then within equal degrees.

use super::{PrimeField, SplitMix};
use crate::error::Result;
use crate::limits::Limits;

/// The distinct-degree factorization of a monic squarefree f: pairs of d and the product of the monic irreducible factors of
/// degree d, ascending in d.
///
/// von zur Gathen & Gerhard, *Modern Computer Algebra*, Algorithm 14.3: `gcd(x^(p^d) − x, f)`. Cost
/// O(n³ log p) operations modulo p at worst.
///
/// # Errors
/// Those of `limits`.
pub(crate) fn distinct_degrees(
    field: &PrimeField,
    f: &[u64],
    limits: &Limits,
) -> Result<Vec<(usize, Vec<u64>)>> {
    let mut parts = Vec::new();
    let mut rest = f.to_vec();
    let x = vec![0, 1];
    let mut power = x.clone(); // x^(p^d) modulo rest
    let mut degree = 0;
    while rest.len() > 2 * (degree + 1) {
        limits.check()?;
        degree += 1;
        if degree == 1 {
            field.divide(&mut power, &rest);
        }
        power = field.power_modulo(&power, field.prime(), &rest);
        let part = field.gcd(rest.clone(), field.difference(&power, &x));
        if part.len() > 1 {
            rest = field.quotient(rest, &part);
            field.divide(&mut power, &rest);
            parts.push((degree, part));
        }
    }
    if rest.len() > 1 {
        parts.push((rest.len() - 1, rest));
    }
    Ok(parts)
}

/// Whether a monic polynomial of degree n is irreducible: gcd(x^(p^d) − x, f) = 1 for all d ≤ n/2. Most others are recognized by
/// a small d, without the whole of [`distinct_degrees`].
pub(crate) fn is_irreducible(field: &PrimeField, f: &[u64]) -> bool {
    let x = vec![0, 1];
    let mut power = x.clone();
    (0..(f.len() - 1) / 2).all(|_| {
        power = field.power_modulo(&power, field.prime(), f);
        field.gcd(f.to_vec(), field.difference(&power, &x)).len() == 1
    })
}

/// The monic irreducible factors of f, all of which have the given degree, for an odd prime.
///
/// Method: Cantor–Zassenhaus (*Modern Computer Algebra*, Algorithm 14.8), by which half of the elements of each residue field
/// are squares. The random choices come from a fixed seed.
pub(crate) fn equal_degree(field: &PrimeField, f: Vec<u64>, degree: usize) -> Vec<Vec<u64>> {
    let mut random = SplitMix(0x5eed);
    let mut done = Vec::new();
    let mut open = vec![f];
    while let Some(f) = open.pop() {
        if f.len() <= degree + 1 {
            done.push(f);
            continue;
        }
        let mut a: Vec<u64> = (1..f.len())
            .map(|_| random.next() % field.prime())
            .collect();
        while a.last() == Some(&0) {
            a.pop();
        }
        // a^((p^d − 1)/2) = (a · a^p ⋯ a^(p^(d−1)))^((p − 1)/2).
        let (mut norm, mut conjugate) = (a.clone(), a);
        for _ in 1..degree {
            conjugate = field.power_modulo(&conjugate, field.prime(), &f);
            norm = field.product(&norm, &conjugate);
            field.divide(&mut norm, &f);
        }
        let sign = field.power_modulo(&norm, (field.prime() - 1) / 2, &f);
        let part = field.gcd(f.clone(), field.difference(&sign, &[1]));
        if part.len() > 1 && part.len() < f.len() {
            open.push(field.quotient(f, &part));
            open.push(part);
        } else {
            open.push(f);
        }
    }
    done
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_modulo_a_prime_multiply_back() {
        let (field, limits) = (PrimeField::new(13), Limits::none());
        let mut random = SplitMix(7);
        for n in 2..40 {
            let mut f: Vec<u64> = (0..n).map(|_| random.next() % 13).collect();
            f.push(1);
            if !field.is_squarefree(&f) {
                continue;
            }
            let mut product = vec![1];
            for (d, part) in distinct_degrees(&field, &f, &limits).unwrap() {
                for factor in equal_degree(&field, part, d) {
                    assert_eq!(factor.len(), d + 1);
                    assert_eq!(
                        distinct_degrees(&field, &factor, &limits).unwrap(),
                        [(d, factor.clone())]
                    );
                    product = field.product(&product, &factor);
                }
            }
            assert_eq!(product, f);
        }
    }
}
