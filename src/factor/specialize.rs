//! Values of the other variables at which a polynomial is factored in one variable.

use malachite::Integer;

use super::gcd::QUICK_PRIME;
use super::recombine::{degrees_of_products, intersect};
use super::univariate::irreducible_factors;
use super::{Irreducibility, Variable};
use crate::error::{Invariant, Result};
use crate::limits::Limits;
use crate::modular::{PrimeField, trimmed};
use crate::poly::{IntegerPolynomial, IntegerTerms};

/// Two points are enough where the better one leaves at most this many factors; otherwise [`POINTS`] points are compared.
const FEW_FACTORS: usize = 3;
/// The number of points that are compared where every one leaves more than [`FEW_FACTORS`] factors.
const POINTS: usize = 4;

/// The result of the univariate factorizations at a few points.
pub(super) enum Specialized {
    /// The polynomial is irreducible: one image is irreducible, or the degrees of the factors at several points exclude
    /// every proper factor.
    Irreducible(Irreducibility),
    /// The polynomial may be reducible, and the factors at the best point are to be lifted.
    Factors(Best),
}

/// The point with the fewest factors.
pub(super) struct Best {
    /// The values of the variables; 0 for the main variable.
    pub(super) point: [i64; 3],
    pub(super) factors: Vec<IntegerPolynomial>,
    /// For each degree in the main variable, whether a factor may have it, after all the points.
    pub(super) allowed: Vec<bool>,
}

/// Factors f, which is squarefree and primitive in v, at a few small integer points that keep its degree in v and leave it
/// squarefree. At nearly all points there are as many factors as f has (Hilbert).
///
/// # Errors
/// Those of the univariate factorization.
pub(super) fn specialize(f: &IntegerTerms<3>, v: usize, limits: &Limits) -> Result<Specialized> {
    let degree = f.degrees()[v] as usize;
    let others: Vec<usize> = f.used().into_iter().filter(|&w| w != v).collect();
    let field = PrimeField::new(QUICK_PRIME);
    let mut allowed = vec![true; degree + 1];
    let mut tried = Vec::new();
    let mut best: Option<([i64; 3], Vec<IntegerPolynomial>)> = None;
    for point in points(&others) {
        limits.check()?;
        let residues = point.map(|a| field.reduce_integer(&Integer::from(a)));
        let image = trimmed(f.image(v, &residues, &field));
        if image.len() != degree + 1 || !field.is_squarefree(&image) {
            continue;
        }
        let value = others
            .iter()
            .fold(f.clone(), |g, &w| g.evaluated(w, &Integer::from(point[w])));
        let variable = Variable::from_index(v);
        let factors = irreducible_factors(&value.to_univariate(v), variable, limits)?;
        let named = others.iter().map(|&w| (Variable::from_index(w), point[w]));
        let named: Vec<_> = named.collect();
        if factors.len() == 1 {
            return Ok(Specialized::Irreducible(Irreducibility::Specialization {
                points: vec![named],
            }));
        }
        tried.push(named);
        let degrees = factors.iter().map(|(g, _)| g.coefficients_asc().len() - 1);
        if !intersect(&mut allowed, &degrees_of_products(degrees)) {
            return Ok(Specialized::Irreducible(Irreducibility::Specialization {
                points: tried,
            }));
        }
        if best.as_ref().is_none_or(|(_, b)| factors.len() < b.len()) {
            best = Some((point, factors.into_iter().map(|(g, _)| g).collect()));
        }
        if let Some((_, factors)) = &best
            && (tried.len() >= POINTS || (tried.len() >= 2 && factors.len() <= FEW_FACTORS))
        {
            break;
        }
    }
    let (point, factors) = best.invariant("the points never end, so there is a best one");
    Ok(Specialized::Factors(Best {
        point,
        factors,
        allowed,
    }))
}

/// Points with small coordinates in the given variables and 0 in the others, with coordinates 0, 1, −1, 2, … of growing size.
fn points(variables: &[usize]) -> impl Iterator<Item = [i64; 3]> {
    let (first, second) = (
        variables
            .first()
            .copied()
            .invariant("some variable is given a value"),
        variables.get(1).copied(),
    );
    (0i64..).flat_map(move |size| {
        let side = (-size..=size).rev();
        let pairs = side.flat_map(move |a| (-size..=size).rev().map(move |b| (a, b)));
        pairs
            .filter(move |(a, b)| match second {
                Some(_) => a.abs().max(b.abs()) == size,
                None => a.abs() == size && *b == 0,
            })
            .map(move |(a, b)| {
                let mut point = [0; 3];
                point[first] = a;
                if let Some(second) = second {
                    point[second] = b;
                }
                point
            })
    })
}
