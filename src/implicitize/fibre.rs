//! The number of parameter values of a patch whose points lie on a general line.

use super::map::RationalMap;
use crate::error::{Invariant, Result};
use crate::limits::Limits;
use crate::modular::{PrimeField, SplitMix, large_primes, trimmed};
use crate::poly::SparsePolynomial;
use crate::shape::{Patch, PatchFunction};

/// The number of random points at which the tangent vectors are tested.
const TRIES: usize = 5;

/// Whether the tangent vectors are independent at some point. `true` is proved; `false` is wrong with a probability below
/// 10⁻⁴⁰.
pub(super) fn sweeps_a_surface(patch: &Patch) -> bool {
    let prime = large_primes()
        .next()
        .invariant("there are primes below 2^31");
    let mut random = SplitMix(1);
    let map = RationalMap::of_patch(patch).modulo(prime);
    let field = PrimeField::new(prime);
    let mut tries = 0;
    while tries < TRIES {
        let s = [random.next() % prime, random.next() % prime];
        if map.at(s).is_none() {
            continue;
        }
        tries += 1;
        // The derivatives are multiplied by the squares of the denominators, which does not change the independence.
        let tangents: Vec<[u64; 2]> = patch
            .coordinates()
            .iter()
            .map(|f| gradient(f, s, &field))
            .collect();
        let independent = |i: usize, j: usize| {
            let [a, b] = [tangents[i], tangents[j]];
            a[0] * b[1] % prime != a[1] * b[0] % prime
        };
        if independent(0, 1) || independent(0, 2) || independent(1, 2) {
            return true;
        }
    }
    false
}

/// The numbers p_v q − p q_v for v = s1 and v = s2.
fn gradient(f: &PatchFunction, s: [u64; 2], field: &PrimeField) -> [u64; 2] {
    let value = |p: &SparsePolynomial<2>, derivative: Option<usize>| {
        p.terms().fold(0, |sum, (e, c)| {
            let mut e = *e;
            let mut factor = field.reduce_integer(&c.numerator());
            if let Some(v) = derivative {
                factor = field.mul(factor, u64::from(e[v]) % field.prime());
                e[v] = e[v].saturating_sub(1);
            }
            let [a, b] = [0, 1].map(|v| field.power(s[v], e[v].into()));
            field.sum(sum, field.mul(factor, field.mul(a, b)))
        })
    };
    let (p, q) = (f.numerator(), f.denominator());
    [0, 1].map(|v| {
        let (plus, minus) = (
            field.mul(value(p, Some(v)), value(q, None)),
            field.mul(value(p, None), value(q, Some(v))),
        );
        field.minus(plus, minus)
    })
}

/// The number of parameter values (s1, s2), complex ones included, whose points lie on a general line: the degree
/// of the surface times the tracing index.
///
/// Two random planes meet in a line. The resultant of their equations in s1 and s2 has two kinds of roots: the s1 of the
/// parameter values on the line, and those of base points, which do not depend on the planes. The common factor with the
/// resultant of other random planes is divided out. The computation is modulo a prime, so it is wrong with a small probability.
///
/// # Errors
/// Those of `limits`.
pub(super) fn generic_fibre(patch: &Patch, limits: &Limits) -> Result<usize> {
    let prime = large_primes()
        .next()
        .invariant("there are primes below 2^31");
    let field = PrimeField::new(prime);
    let mut random = SplitMix(2);
    let functions = over_one_denominator(patch, limits)?;
    let [second, first]: [Vec<u64>; 2] = std::array::from_fn(|_| {
        let planes: [Dense; 2] = std::array::from_fn(|_| {
            let weights: Vec<u64> = functions.iter().map(|_| random.next() % prime).collect();
            Dense::combination(&functions, &weights, &field)
        });
        eliminant(&planes, &field)
    });
    if first.is_empty() || second.is_empty() {
        return Ok(0);
    }
    let fixed = field.gcd(first.clone(), second);
    Ok(first.len() - fixed.len())
}

/// The coordinates x, y, z and 1, all multiplied by the least common denominator.
fn over_one_denominator(patch: &Patch, limits: &Limits) -> Result<Vec<SparsePolynomial<2>>> {
    use crate::factor::coprime_parts;
    use crate::poly::Ring;
    let mut common = SparsePolynomial::constant(crate::exact::Rational::one());
    for f in patch.coordinates() {
        let [_, missing] = coprime_parts([&common, f.denominator()], limits)?;
        common = common.times(&missing);
    }
    let mut functions = Vec::new();
    for f in patch.coordinates() {
        // The denominator is only known up to a constant factor, which does not change random combinations.
        let [factor, _] = coprime_parts([&common, f.denominator()], limits)?;
        functions.push(f.numerator().times(&factor).primitive());
    }
    functions.push(common);
    Ok(functions)
}

/// A polynomial in s1 and s2 modulo a prime: for each power of s2 its coefficient in s1.
struct Dense {
    rows: Vec<Vec<u64>>,
}

impl Dense {
    fn combination(functions: &[SparsePolynomial<2>], weights: &[u64], field: &PrimeField) -> Self {
        let degree = |v: usize| {
            let terms = functions.iter().flat_map(SparsePolynomial::terms);
            let degree = terms.map(|(e, _)| e[v] as usize).max();
            degree.invariant("a denominator has a term")
        };
        let mut rows = vec![vec![0; degree(0) + 1]; degree(1) + 1];
        for (f, &weight) in functions.iter().zip(weights) {
            for (e, c) in f.terms() {
                let value = &mut rows[e[1] as usize][e[0] as usize];
                let more = field.mul(weight, field.reduce_integer(&c.numerator()));
                *value = field.sum(*value, more);
            }
        }
        Self { rows }
    }

    /// The polynomial in s2 for a given s1.
    fn at(&self, s1: u64, field: &PrimeField) -> Vec<u64> {
        self.rows.iter().map(|row| field.value(row, s1)).collect()
    }
}

/// The resultant with respect to s2, monic and trimmed; empty if it is 0.
fn eliminant([f, g]: &[Dense; 2], field: &PrimeField) -> Vec<u64> {
    let degree = 2 * (f.rows.len() - 1) * (f.rows[0].len() - 1);
    let values = (0..=degree as u64).map(|s| field.resultant(f.at(s, field), g.at(s, field)));
    field.monic(trimmed(field.interpolate(values.collect())))
}
