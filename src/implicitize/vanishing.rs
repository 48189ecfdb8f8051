//! All polynomials with given monomials that vanish on a rational map, by certified linear algebra.

use malachite::Integer;

use super::map::RationalMap;
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::modular::{Kernel, PrimeField, Reconstruction, SplitMix, kernel, large_primes};
use crate::poly::{SparsePolynomial, term_order};

/// The number of rows beyond the number of columns. Each of them makes an accidental kernel 2³¹ times less likely.
const MORE_ROWS: usize = 8;

/// The lifting ends without a result after this many primes, which is enough for coefficients of about a million bits.
const MAX_PRIMES: usize = 30_000;

/// The largest number of monomials: those of degree at most [`LARGEST_DEGREE`] in three variables.
const MAX_MONOMIALS: usize = 1330;

/// The largest degree of an equation in three variables.
pub(super) const LARGEST_DEGREE: usize = 18;

/// The monomials of degree at most `degree` in the given variables among x, y and z, ascending in the order of terms.
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
    all.sort_unstable_by(|a, b| term_order(b, a));
    all
}

/// The kernel modulo a prime of the values of the monomials at random points of the map.
///
/// Every polynomial over Q that vanishes on the map gives a vector of this kernel once it is primitive. So the space of these
/// polynomials has at most the dimension of the kernel.
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

/// The values of the monomials at a point.
fn values(point: &[u64], monomials: &[[u32; 3]], field: &PrimeField) -> Vec<u64> {
    let degree = monomials.iter().flatten().max();
    let degree = *degree.invariant("there are monomials");
    let powers: Vec<Vec<u64>> = (0..3)
        .map(|v| {
            // A coordinate that the curve does not have does not occur in the monomials.
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

/// A basis of the polynomials with these monomials that vanish on the map. Each is primitive, with a positive first
/// coefficient, and its last monomial does not occur in the others.
///
/// Exact substitution proves each of them. Their number is the dimension of the kernel modulo the first prime, which proves
/// that there are no others. The list is empty if there are none.
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

/// The polynomial over Q whose image modulo the prime is the given vector of the kernel.
///
/// Only the monomials of the vector are used: modulo every prime they have a kernel of dimension 1.
///
/// # Errors
/// As [`kernel_modulo`]; [`Error::Limit`] if no polynomial is found.
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
