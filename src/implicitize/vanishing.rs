//! All polynomials with given monomials that vanish on a rational map, by certified linear algebra.

use malachite::Integer;

use super::map::RationalMap;
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::modular::{Kernel, PrimeField, Reconstruction, SplitMix, kernel, large_primes};
use crate::poly::{SparsePolynomial, term_order};

/// More rows than columns: each one more makes an accidental kernel 2³¹ times less likely.
const MORE_ROWS: usize = 8;

/// Primes after which the lifting is given up: coefficients of about a million bits.
const MAX_PRIMES: usize = 30_000;

/// The largest number of monomials: those of degree at most [`LARGEST_DEGREE`] in three variables.
const MAX_MONOMIALS: usize = 1330;

/// The largest degree of an equation in three variables.
pub(super) const LARGEST_DEGREE: usize = 18;

/// The monomials of degree at most `degree` in the given ones of x, y, z, ascending in the order of terms.
pub(super) fn monomials(degree: u32, variables: [bool; 3]) -> Vec<[u32; 3]> {
    let most = |v: usize| if variables[v] { degree } else { 0 };
    let mut all = Vec::new();
    for i in 0..=most(0) {
        for j in 0..=most(1).min(degree - i) {
            for k in 0..=most(2).min(degree - i - j) {
                all.push([i, j, k]);
            }
        }
    }
    all.sort_by(|a, b| term_order(b, a));
    all
}

/// The kernel modulo a prime of the values of the monomials at random points of the map.
///
/// A polynomial over Q that vanishes on the map, made primitive, is a vector of this kernel; so the kernel's
/// dimension bounds theirs.
///
/// # Errors
/// [`Error::Limit`] for more than [`MAX_MONOMIALS`] monomials; those of `limits`.
pub(super) fn kernel_modulo(
    map: &RationalMap,
    monomials: &[[u32; 3]],
    prime: u64,
    limits: &Limits,
) -> Result<Kernel> {
    limits.check()?;
    if monomials.len() > MAX_MONOMIALS {
        return Err(Error::limit(format!(
            "equations of a degree with {} monomials (at most {MAX_MONOMIALS}: degree 18 in x, y and z)",
            monomials.len()
        )));
    }
    let (map, field) = (map.modulo(prime), PrimeField::new(prime));
    let mut random = SplitMix(prime);
    let mut rows = Vec::with_capacity(monomials.len() + MORE_ROWS);
    while rows.len() < monomials.len() + MORE_ROWS {
        let s = [random.next() % prime, random.next() % prime];
        if let Some(point) = map.at(s) {
            rows.push(values(&point, monomials, &field));
        }
    }
    limits.check()?;
    Ok(kernel(rows, monomials.len(), prime))
}

/// The monomials at a point.
fn values(point: &[u64], monomials: &[[u32; 3]], field: &PrimeField) -> Vec<u64> {
    let degree = monomials.iter().flatten().max();
    let degree = *degree.invariant("there are monomials");
    let powers: Vec<Vec<u64>> = (0..3)
        .map(|v| {
            // A coordinate that the curve does not have does not occur in the monomials, either.
            let value = point.get(v).copied().unwrap_or(0);
            field.powers(value, degree as usize + 1)
        })
        .collect();
    let value = |e: &[u32; 3]| {
        let [x, y, z] = [0, 1, 2].map(|v| powers[v][e[v] as usize]);
        field.mul(field.mul(x, y), z)
    };
    monomials.iter().map(value).collect()
}

/// The polynomials that vanish on the map, as many as the kernel modulo the first prime has dimensions, each with
/// its last monomial in no other one; primitive, with positive first term.
///
/// Each is proved by exact substitution; that there are no others is proved by the dimension. Empty if there is
/// none.
///
/// # Errors
/// As [`kernel_modulo`].
pub(super) fn vanishing(
    map: &RationalMap,
    monomials: &[[u32; 3]],
    limits: &Limits,
) -> Result<Vec<SparsePolynomial<3>>> {
    let prime = large_primes().next();
    let prime = prime.invariant("there are primes below 2^31");
    let first = kernel_modulo(map, monomials, prime, limits)?;
    let lifted = first.vectors.iter();
    lifted
        .map(|vector| lift(map, monomials, vector, limits))
        .collect()
}

/// The polynomial over Q of which a vector of the kernel is the image.
///
/// Only its own monomials are looked at: modulo every prime they have a kernel of dimension 1.
///
/// # Errors
/// As [`kernel_modulo`]; [`Error::Limit`] if nothing is found.
pub(super) fn lift(
    map: &RationalMap,
    monomials: &[[u32; 3]],
    vector: &[u64],
    limits: &Limits,
) -> Result<SparsePolynomial<3>> {
    let with_values = monomials.iter().zip(vector);
    let support: Vec<[u32; 3]> = with_values
        .filter(|(_, c)| **c != 0)
        .map(|(e, _)| *e)
        .collect();
    let mut reconstruction = Reconstruction::new();
    for prime in large_primes().take(MAX_PRIMES) {
        let found = kernel_modulo(map, &support, prime, limits)?;
        let [image] = &found.vectors[..] else {
            continue;
        };
        if let Some(integers) = reconstruction.add(image, prime) {
            let f = polynomial(&support, &integers);
            if map.annihilates(&f, limits)? {
                return Ok(f);
            }
        }
    }
    Err(Error::limit(format!(
        "an equation whose coefficients need more than {MAX_PRIMES} primes of 31 bits"
    )))
}

fn polynomial(monomials: &[[u32; 3]], coefficients: &[Integer]) -> SparsePolynomial<3> {
    let terms = monomials.iter().zip(coefficients);
    SparsePolynomial::from_terms(terms.map(|(e, c)| (*e, Rational::whole(c)))).primitive()
}
