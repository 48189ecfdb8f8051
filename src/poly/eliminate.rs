//! The implicit equation of x = p1/q1, y = p2/q2 by a resultant.

use malachite::Natural;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial;

use super::{IntegerPolynomial, PlanePolynomial, RationalFunction};
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::modular::{Images, PrimeField, Reconstruction, large_primes};
use crate::parallel;

/// The largest number of products of residues; that many take about ten seconds.
const MAX_WORK: f64 = 3e10;

/// Computes the resultant of `q1(s) x − p1(s)` and `q2(s) y − p2(s)` with respect to s, for two functions in lowest terms that
/// are not both constant. It is a constant times a power of the irreducible equation of the curve; its degree in x is the
/// degree of y(s), and its degree in y is the degree of x(s).
///
/// Method: for values of y and modulo 31-bit primes, the resultant is a characteristic polynomial in x; then interpolation and
/// Chinese remainders. The constant factor is often much longer than the equation, so two polynomials are reconstructed: the
/// resultant itself, and its multiple in which one coefficient is 1, with fractions as coefficients. As soon as more primes do
/// not change one of them, the polynomial is passed to `prove`; the first result of `prove` is returned.
///
/// Cost, for degrees m and n: m n³ products of residues for each prime; the primes must be as long together as (m + n)
/// coefficients.
///
/// # Errors
/// [`Error::Limit`] if the computation takes too much work; those of `limits` and of `prove`.
pub(crate) fn eliminate<T>(
    x: &RationalFunction,
    y: &RationalFunction,
    limits: &Limits,
    mut prove: impl FnMut(&PlanePolynomial) -> Result<Option<T>>,
) -> Result<T> {
    let (m, n) = (x.degree(), y.degree());
    let lengths = [length(x), length(y)];
    let bits = as_f64(n) * bits_of(&lengths[0]) + as_f64(m) * bits_of(&lengths[1]);
    let pairs = as_f64((m + 1) * (n + 1));
    let work = bits / 30.9 * pairs * pairs;
    if work > MAX_WORK {
        return Err(Error::limit(format!(
            "a resultant of degrees {n} and {m} with coefficients of up to {bits:.0} bits, about {work:.0e} operations (at most {MAX_WORK:.0e} are made)"
        )));
    }
    // The bound is Lemma 1 of resultant.rs, with n rows of the first polynomial and m rows of the second.
    let bound = (&lengths[0]).pow(n as u64) * (&lengths[1]).pow(m as u64);
    let mut combined = Images::unknown((m + 1) * (n + 1));
    let mut monic = Reconstruction::new();
    let mut last = IntegerPolynomial::default();
    let mut pivot = None;
    let mut primes = large_primes();
    let (mut tried, mut next_try) = (0, 2);
    loop {
        limits.check()?;
        let prime = primes.following();
        let image = image([x, y], [m, n], prime);
        if pivot.is_none() {
            pivot = image.iter().rposition(|&c| c != 0);
        }
        if let Some(pivot) = pivot
            && image[pivot] != 0
        {
            let field = PrimeField::new(prime);
            let inverse = field.inverse(image[pivot]);
            let scaled: Vec<u64> = image.iter().map(|&c| field.mul(c, inverse)).collect();
            monic.push(&scaled, prime);
        }
        combined.push(&image, prime);
        tried += 1;
        let complete = combined.determine(&bound);
        if tried < next_try && !complete {
            continue;
        }
        // The number of primes between two trials grows by a quarter, because a trial is not much cheaper than another prime.
        next_try = tried + 1 + tried / 4;
        if let Some(found) = monic.attempt() {
            let found = IntegerPolynomial::from_coefficients_asc(found);
            if let Some(result) = prove(&polynomial(&found, m))? {
                return Ok(result);
            }
        }
        let found = combined.balanced();
        if (complete || found == last)
            && let Some(result) = prove(&polynomial(&found, m))?
        {
            return Ok(result);
        }
        last = found;
        if complete {
            return Err(Error::internal(
                "implicitization by a resultant",
                "the resultant does not pass its own proof",
            ));
        }
    }
}

/// The polynomial whose coefficient of x^i y^j is at the index i (m + 1) + j.
fn polynomial(flat: &IntegerPolynomial, m: usize) -> PlanePolynomial {
    let terms = flat.coefficients_asc().iter().enumerate();
    let terms = terms.filter(|(_, c)| **c != 0);
    PlanePolynomial::from_terms(
        terms.map(|(index, c)| ((index / (m + 1), index % (m + 1)), Rational::whole(c))),
    )
}

/// The coefficients of the resultant modulo a prime, in the order of [`polynomial`].
fn image([x, y]: [&RationalFunction; 2], [m, n]: [usize; 2], prime: u64) -> Vec<u64> {
    let field = PrimeField::new(prime);
    let reduce = |f: &IntegerPolynomial, degree: usize| {
        let mut residues = field.residues(f);
        residues.resize(degree + 1, 0);
        residues
    };
    let both = |f: &RationalFunction, degree: usize| {
        [f.numerator(), f.denominator()].map(|p| reduce(p, degree))
    };
    let (in_x, in_y) = (both(x, m), both(y, n));
    let inverses = field.inverses(n + 1);
    // First the coefficients of the powers of x for each value of y, then for each of them the coefficients of the powers of y.
    let rows = parallel::map_numbers(m + 1, |y| {
        let g = pencil(&in_y, y as u64, &field);
        let row = in_traces(&in_x, &g, &inverses, &field);
        row.unwrap_or_else(|| on_grid(&in_x, &g, &field))
    });
    (0..=n)
        .flat_map(|i| field.interpolate(rows.iter().map(|row| row[i]).collect()))
        .collect()
}

/// The polynomial q v − p.
fn pencil([p, q]: &[Vec<u64>; 2], v: u64, field: &PrimeField) -> Vec<u64> {
    let prime = field.prime();
    let terms = q.iter().zip(p);
    terms.map(|(q, p)| (q * v + prime - p) % prime).collect()
}

/// The coefficients of the powers of X in `Res(q X − p, g)`, by Euclid's algorithm for X = 0, 1, 2, ….
fn on_grid(x: &[Vec<u64>; 2], g: &[u64], field: &PrimeField) -> Vec<u64> {
    let values = (0..g.len() as u64).map(|v| field.resultant(pencil(x, v, field), g.to_vec()));
    field.interpolate(values.collect())
}

/// The same coefficients as [`on_grid`], without a grid. The leading coefficient of g and `Res(q, g)` must not be 0.
///
/// The resultant is Res(q, g) times the characteristic polynomial of h = p/q modulo g. Let L_k be the linear form that takes a
/// polynomial a to the sum of a h^k over the zeros of g. The values L_0(s^i) are the power sums of these zeros, and
/// L_k(s^i) = L_(k−1)(s^i h). So the power sums L_k(1) of the values of h follow step by step. Newton's identities give the power
/// sums of the zeros from the coefficients of g, and the characteristic polynomial from the power sums of the values (von zur
/// Gathen & Gerhard, *Modern Computer Algebra*, Exercise 6.5; Shoup 1999). Cost: n³ products for the degree n of g. The grid takes
/// n inverses more for each of n + 1 values of X.
fn in_traces(
    [p, q]: &[Vec<u64>; 2],
    g: &[u64],
    inverses: &[u64],
    field: &PrimeField,
) -> Option<Vec<u64>> {
    let (n, prime) = (g.len() - 1, field.prime());
    let resultant = field.resultant(q.clone(), g.to_vec());
    if g[n] == 0 || n == 0 || resultant == 0 {
        return None;
    }
    let g = field.monic(g.to_vec());
    let mut h = field.product(p, &field.inverse_modulo(q, &g)?);
    field.divide(&mut h, &g);
    h.resize(n, 0);
    // The polynomial s^i h modulo g.
    let mut shifted = vec![h];
    for i in 1..n {
        let mut next = vec![0];
        next.extend_from_slice(&shifted[i - 1]);
        let minus = (prime
            - next
                .pop()
                .invariant("a shifted remainder has a top coefficient"))
            % prime;
        for (c, d) in next.iter_mut().zip(&g) {
            *c = (*c + minus * d) % prime;
        }
        shifted.push(next);
    }
    // Converts the coefficients of a monic polynomial, descending, into the power sums of its zeros.
    let descending: Vec<u64> = g.iter().rev().copied().collect();
    let mut form = vec![n as u64];
    for k in 1..n {
        // Newton's identity: p_k + e_1 p_(k−1) + … + e_(k−1) p_1 + k e_k = 0.
        let earlier: Vec<u64> = form[1..].iter().rev().copied().collect();
        let sum = field.dot(&descending[1..], &earlier) + descending[k] * k as u64 % prime;
        form.push((2 * prime - sum) % prime);
    }
    let mut sums: Vec<u64> = Vec::with_capacity(n);
    for _ in 0..n {
        form = shifted.iter().map(|f| field.dot(f, &form)).collect();
        sums.push(form[0]);
    }
    let mut row = vec![1];
    for k in 1..=n {
        let later: Vec<u64> = sums[..k].iter().rev().copied().collect();
        let sum = field.dot(&row, &later);
        row.push((prime - sum) % prime * inverses[k] % prime);
    }
    row.reverse();
    Some(row.iter().map(|c| c * resultant % prime).collect())
}

/// The sum of the absolute values of all coefficients.
fn length(f: &RationalFunction) -> Natural {
    let coefficients = [f.numerator(), f.denominator()];
    coefficients
        .iter()
        .flat_map(|p| p.coefficients_asc())
        .map(|c| c.unsigned_abs_ref())
        .sum()
}

/// The length of a norm in bits, to estimate the work.
pub(super) fn bits_of(norm: &Natural) -> f64 {
    let bits = usize::try_from(norm.significant_bits());
    as_f64(bits.invariant("a number fits in memory"))
}

#[expect(clippy::cast_precision_loss, reason = "sizes are far below 2^53")]
pub(super) fn as_f64(n: usize) -> f64 {
    n as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const P: u64 = 2_147_483_647;

    proptest! {
        #[test]
        fn traces_and_the_grid_agree(
            p in prop::collection::vec(0..P, 0..9),
            q in prop::collection::vec(0..P, 1..9),
            g in prop::collection::vec(0..P, 1..9),
            small in prop::bool::ANY,
        ) {
            // Small coefficients often give common zeros and leading zeros.
            let reduce = |f: Vec<u64>| -> Vec<u64> { f.iter().map(|c| if small { c % 2 } else { *c }).collect() };
            let [mut p, mut q, g] = [p, q, g].map(reduce);
            let formal = p.len().max(q.len());
            p.resize(formal, 0);
            q.resize(formal, 0);
            let x = [p, q];
            let field = PrimeField::new(P);
            let inverses = field.inverses(g.len());
            match in_traces(&x, &g, &inverses, &field) {
                Some(row) => prop_assert_eq!(row, on_grid(&x, &g, &field)),
                None => prop_assert!(small || g.len() == 1),
            }
        }
    }
}
