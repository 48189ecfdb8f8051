//! The local structure of a curve above the multiple zeros of its discriminant, and at infinity, from a prime of good reduction.
//!
//! Theorem (Poteaux & Rybowicz, *Good reduction of Puiseux series and applications*, Journal of Symbolic Computation 47, 2012). Let
//! F(u, v) have coefficients in a number field and a constant leading coefficient in v, let 𝔭 be a prime ideal that divides neither a
//! denominator nor that coefficient, and let its prime p be larger than the degree in v. If the lowest non-zero coefficient of the
//! discriminant of F, as a polynomial in u, is not divisible by 𝔭, then the Newton polygons, ramification indices and multiplicities
//! of the Puiseux series of F above u = 0 are those of F modulo 𝔭.
//!
//! For F(α + u, v), where α is a zero of a squarefree part g of the discriminant Δ of multiplicity m, the lowest coefficient is a
//! product of g′(α)^m, of powers of the other parts at α, and of a constant. So all α together are covered if p does not divide the
//! leading coefficient of Δ and the product of all parts stays squarefree and of the same degree modulo p. At infinity the lowest
//! coefficient is the leading coefficient of Δ.
//!
//! Conjugate zeros have the same structure, so one zero of each irreducible factor is enough, and a prime is taken for which that
//! zero, and the multiple roots that occur, are in the prime field.

use super::places::{LocalType, some_roots, types_above_zero};
use super::sweep::Sheared;
use crate::error::{Error, Result};
use crate::factor::factor_univariate;
use crate::limits::Limits;
use crate::modular::{PrimeField, large_primes};
use crate::poly::{IntegerPolynomial, coefficients, primitive_part, with_integers};
use crate::roots::RealRoot;
use malachite::Integer;
use malachite::base::num::basic::traits::One;
use malachite::base::polynomial::Polynomial;

/// How many primes are tried until every zero is in some prime field.
const MAX_PRIMES: usize = 3000;

/// The points with vertical or no tangents above the zeros of one irreducible factor of the discriminant.
#[derive(Clone, Debug)]
pub(super) struct Conjugates {
    /// The irreducible factor.
    pub(super) polynomial: IntegerPolynomial,
    /// The multiplicity of its zeros in the discriminant, which is at least 2.
    pub(super) multiplicity: usize,
    /// The types of the points with multiple roots above each of its zeros; `None` if no suitable prime was found.
    pub(super) types: Option<Vec<LocalType>>,
}

/// The local structure of a curve.
#[derive(Clone, Debug)]
pub(super) struct Resolution {
    pub(super) conjugates: Vec<Conjugates>,
    /// The types of the points at infinity at which the line at infinity is not transversal; `None` if no prime was found.
    pub(super) infinity: Option<Vec<LocalType>>,
    /// A prime of good reduction.
    pub(super) prime: Option<u64>,
}

impl Resolution {
    /// Finds the structure.
    ///
    /// # Errors
    /// Those of [`factor_univariate`]; [`Error::Internal`] if the multiplicity of a zero of the discriminant is not the sum of the
    /// local ones.
    pub(super) fn new(curve: &Sheared, limits: &Limits) -> Result<Self> {
        let mut conjugates = Vec::new();
        for (multiplicity, part) in curve.parts.iter().filter(|(m, _)| *m > 1) {
            for factor in factor_univariate(&coefficients(part), limits)?.factors {
                conjugates.push(Conjugates {
                    polynomial: primitive_part(&with_integers(&factor.polynomial).0),
                    multiplicity: *multiplicity,
                    types: None,
                });
            }
        }
        let at_infinity = curve.multiplicity_at_infinity();
        let mut resolution = Self {
            conjugates,
            infinity: (at_infinity == 0).then(Vec::new),
            prime: None,
        };
        let mut radical = IntegerPolynomial::from_coefficients_asc(vec![Integer::ONE]);
        for (_, part) in &curve.parts {
            radical *= part;
        }
        for prime in large_primes().take(MAX_PRIMES) {
            limits.check()?;
            let field = PrimeField::new(prime);
            if !is_good(curve, &radical, &field) {
                continue;
            }
            resolution.prime = resolution.prime.or(Some(prime));
            resolution.add(curve, &field, at_infinity)?;
            if resolution.is_complete() {
                break;
            }
        }
        Ok(resolution)
    }

    fn is_complete(&self) -> bool {
        self.infinity.is_some() && self.conjugates.iter().all(|c| c.types.is_some())
    }

    /// The types above a real zero of the discriminant; `None` if they are not known, and no types above a simple zero.
    pub(super) fn above(&self, value: &RealRoot) -> Option<&[LocalType]> {
        let all = self
            .conjugates
            .iter()
            .find(|c| value.is_root_of(&c.polynomial));
        match all {
            Some(conjugates) => conjugates.types.as_deref(),
            None => Some(&[]),
        }
    }

    /// Fills in what this prime shows.
    fn add(&mut self, curve: &Sheared, field: &PrimeField, at_infinity: usize) -> Result<()> {
        let rows = curve.modulo(field);
        for conjugates in self.conjugates.iter_mut().filter(|c| c.types.is_none()) {
            let reduced = field.monic(field.reduce(&conjugates.polynomial));
            for alpha in some_roots(field, reduced) {
                let moved: Vec<Vec<u64>> = rows
                    .iter()
                    .map(|row| field.shifted(row.clone(), alpha))
                    .collect();
                conjugates.types = checked(field, &moved, conjugates.multiplicity)?;
                if conjugates.types.is_some() {
                    break;
                }
            }
        }
        if self.infinity.is_none() {
            // u^n f(1/u, v/u): the coefficient of v^i is a_i reversed within degree n − i.
            let turned: Vec<Vec<u64>> = rows
                .iter()
                .enumerate()
                .map(|(i, row)| {
                    let mut row = row.clone();
                    row.resize(curve.degree - i + 1, 0);
                    row.reverse();
                    row
                })
                .collect();
            self.infinity = checked(field, &turned, at_infinity)?;
        }
        Ok(())
    }
}

impl Sheared {
    /// The multiplicity of the discriminant at t = ∞.
    pub(super) fn multiplicity_at_infinity(&self) -> usize {
        self.degree * (self.degree - 1) + 1 - self.discriminant.coefficients_asc().len()
    }
}

/// Whether reduction modulo the prime is good above all values.
fn is_good(curve: &Sheared, radical: &IntegerPolynomial, field: &PrimeField) -> bool {
    let keeps_degree = |g: &IntegerPolynomial| {
        g.coefficients_asc()
            .last()
            .is_none_or(|c| field.reduce_integer(c) != 0)
    };
    field.prime() > curve.degree as u64
        && keeps_degree(&curve.strip.coefficients()[curve.degree])
        && keeps_degree(&curve.discriminant)
        && keeps_degree(radical)
        && field.is_squarefree(&field.reduce(radical))
}

/// The types above 0, if their roots are in the field; their sum must be the multiplicity of the discriminant.
fn checked(
    field: &PrimeField,
    rows: &[Vec<u64>],
    multiplicity: usize,
) -> Result<Option<Vec<LocalType>>> {
    let Ok(types) = types_above_zero(field, rows, multiplicity + 1) else {
        return Ok(None);
    };
    let sum: usize = types.iter().map(|t| t.intersection).sum();
    if sum != multiplicity {
        return Err(Error::internal(
            "the places of a curve",
            format!(
                "the valuations of the local discriminants add up to {multiplicity}, not to {sum}"
            ),
        ));
    }
    Ok(Some(types))
}
