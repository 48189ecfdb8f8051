//! The implicit equation of x = p1/q1, y = p2/q2 by a resultant.

use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial;
use malachite::{Integer, Natural};
use rayon::prelude::*;

use super::{BinaryForm, IntegerPolynomial, PlanePolynomial, RationalFunction};
use crate::error::{Error, Invariant, Result};
use crate::limits::Limits;
use crate::modular::{
    ABOVE_PRIMES, Images, PrimeField, Reconstruction, dot_mod, interpolate, inverse_mod,
    inverses_mod, power_mod, previous_prime, reduce_integer,
};

/// Products of residues beyond which the work is refused: some ten seconds.
const MAX_WORK: f64 = 3e10;

/// The resultant of `q1(s) x − p1(s)` and `q2(s) y − p2(s)` with respect to s, for two functions in lowest
/// terms of which one is not constant: a power of the irreducible equation of the curve, times a constant.
/// Its degree in x is the degree of y(s), and the other way round.
///
/// By evaluation at values of y, a characteristic polynomial in x for each modulo 31-bit primes, interpolation and
/// Chinese remainders: of the resultant itself, and of the multiple of it in which one coefficient is 1, over fractions, because the constant in front
/// is often much longer than the equation. As soon as more primes change nothing the polynomial is given to
/// `prove`; what that returns first is the result. Cost:
/// for degrees m and n, m n³ products of residues for each prime, of which (m + n) coefficients' lengths
/// are needed.
///
/// # Errors
/// [`Error::Limit`] if that is too much; those of `limits` and of `prove`.
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
    // Lemma 1 of resultant.rs: n rows of the first polynomial, m of the second.
    let bound = (&lengths[0]).pow(n as u64) * (&lengths[1]).pow(m as u64);
    let mut combined = Images::unknown((m + 1) * (n + 1));
    let mut monic = Reconstruction::new();
    let mut last = IntegerPolynomial::default();
    let mut pivot = None;
    let mut prime = ABOVE_PRIMES;
    let (mut primes, mut next_try) = (0, 2);
    loop {
        limits.check()?;
        prime = previous_prime(prime);
        let image = image([x, y], [m, n], prime);
        if pivot.is_none() {
            pivot = image.iter().rposition(|&c| c != 0);
        }
        if let Some(pivot) = pivot
            && image[pivot] != 0
        {
            let inverse = inverse_mod(image[pivot], prime);
            let scaled: Vec<u64> = image.iter().map(|c| c * inverse % prime).collect();
            monic.push(&scaled, prime);
        }
        combined.push(&image, prime);
        primes += 1;
        let complete = combined.determine(&bound);
        if primes < next_try && !complete {
            continue;
        }
        // A quarter more each time: trying is not much cheaper than one more prime.
        next_try = primes + 1 + primes / 4;
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

/// From the coefficients of x^i y^j at place i (m + 1) + j.
fn polynomial(flat: &IntegerPolynomial, m: usize) -> PlanePolynomial {
    let mut parts: Vec<Vec<Integer>> = Vec::new();
    for (index, c) in flat.coefficients_asc().iter().enumerate() {
        let (i, j) = (index / (m + 1), index % (m + 1));
        if *c == 0 {
            continue;
        }
        if parts.len() <= i + j {
            parts.resize(i + j + 1, Vec::new());
        }
        let part = &mut parts[i + j];
        part.resize(part.len().max(j + 1), Integer::from(0));
        part[j] = c.clone();
    }
    let forms = parts.into_iter().enumerate().map(|(degree, row)| {
        BinaryForm::from_dehomogenized(degree, IntegerPolynomial::from_coefficients_asc(row))
    });
    PlanePolynomial::from_parts(forms, Integer::ONE)
}

/// The coefficients modulo a prime, in the order of [`polynomial`].
fn image([x, y]: [&RationalFunction; 2], [m, n]: [usize; 2], prime: u64) -> Vec<u64> {
    let reduce = |f: &IntegerPolynomial, degree: usize| {
        let mut residues: Vec<u64> = f
            .coefficients_asc()
            .iter()
            .map(|c| reduce_integer(c, prime))
            .collect();
        residues.resize(degree + 1, 0);
        residues
    };
    let both = |f: &RationalFunction, degree: usize| {
        [f.numerator(), f.denominator()].map(|p| reduce(p, degree))
    };
    let (in_x, in_y) = (both(x, m), both(y, n));
    let inverses = inverses_mod(n + 1, prime);
    // For each y the coefficients of the powers of x, then for each of these the powers of y.
    let rows: Vec<Vec<u64>> = (0..=m as u64)
        .into_par_iter()
        .map(|y| {
            let g = pencil(&in_y, y, prime);
            let row = in_traces(&in_x, &g, &inverses, prime);
            row.unwrap_or_else(|| on_grid(&in_x, &g, prime))
        })
        .collect();
    (0..=n)
        .flat_map(|i| interpolate(rows.iter().map(|row| row[i]).collect(), prime))
        .collect()
}

/// q v − p
fn pencil([p, q]: &[Vec<u64>; 2], v: u64, prime: u64) -> Vec<u64> {
    let terms = q.iter().zip(p);
    terms.map(|(q, p)| (q * v + prime - p) % prime).collect()
}

/// The coefficients of the powers of X in `Res(q X − p, g)`, from its values at 0, 1, 2, …, by Euclid.
fn on_grid(x: &[Vec<u64>; 2], g: &[u64], prime: u64) -> Vec<u64> {
    let values = (0..g.len() as u64).map(|v| resultant_mod(pencil(x, v, prime), g.to_vec(), prime));
    interpolate(values.collect(), prime)
}

/// The same as [`on_grid`] for all X at once, if the leading coefficient of g and `Res(q, g)` are not 0.
///
/// It is Res(q, g) times the characteristic polynomial of h = p/q modulo g. The sums of the k-th powers of h at
/// the zeros of g are values of a linear form: of s^i it is the sum of the i-th powers of the zeros, and of
/// `s^i h^k` that of `(s^i h) h^(k−1)`. Coefficients from power sums, for g and back, by Newton's identities (von zur
/// Gathen & Gerhard, *Modern Computer Algebra*, Exercise 6.5; Shoup 1999). Cost: n³ products, n the degree of g,
/// where the grid takes n inverses for each of n + 1 values of X besides.
fn in_traces([p, q]: &[Vec<u64>; 2], g: &[u64], inverses: &[u64], prime: u64) -> Option<Vec<u64>> {
    let field = PrimeField::new(prime);
    let n = g.len() - 1;
    let resultant = resultant_mod(q.clone(), g.to_vec(), prime);
    if g[n] == 0 || n == 0 || resultant == 0 {
        return None;
    }
    let g = field.monic(g.to_vec());
    let mut h = field.product(p, &field.inverse_modulo(q, &g)?);
    field.divide(&mut h, &g);
    h.resize(n, 0);
    // s^i h modulo g
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
    // Of a monic polynomial the coefficients from above, and the power sums of its zeros.
    let descending: Vec<u64> = g.iter().rev().copied().collect();
    let mut form = vec![n as u64];
    for k in 1..n {
        // p_k + e_1 p_(k−1) + … + e_(k−1) p_1 + k e_k = 0
        let earlier: Vec<u64> = form[1..].iter().rev().copied().collect();
        let sum = dot_mod(&descending[1..], &earlier, prime) + descending[k] * k as u64 % prime;
        form.push((2 * prime - sum) % prime);
    }
    let mut sums: Vec<u64> = Vec::with_capacity(n);
    for _ in 0..n {
        form = shifted.iter().map(|f| dot_mod(f, &form, prime)).collect();
        sums.push(form[0]);
    }
    let mut row = vec![1];
    for k in 1..=n {
        let later: Vec<u64> = sums[..k].iter().rev().copied().collect();
        let sum = dot_mod(&row, &later, prime);
        row.push((prime - sum) % prime * inverses[k] % prime);
    }
    row.reverse();
    Some(row.iter().map(|c| c * resultant % prime).collect())
}

/// The resultant of two polynomials modulo a prime below 2³¹ whose formal degrees are their lengths less one.
pub(crate) fn resultant_mod(mut f: Vec<u64>, mut g: Vec<u64>, p: u64) -> u64 {
    let field = PrimeField::new(p);
    let odd = |f: &[u64], g: &[u64]| (f.len() - 1) * (g.len() - 1) % 2 == 1;
    let mut value = 1;
    if g.last() == Some(&0) {
        if f.last() == Some(&0) {
            return 0;
        }
        if odd(&f, &g) {
            value = p - 1;
        }
        std::mem::swap(&mut f, &mut g);
    }
    // From here on the leading coefficient of g is not 0.
    while g.len() > 1 {
        if odd(&f, &g) {
            value = (p - value) % p;
        }
        let formal = f.len() - 1;
        let lead = g[g.len() - 1];
        field.divide(&mut f, &g);
        let Some(degree) = f.len().checked_sub(1) else {
            return 0;
        };
        value = value * power_mod(lead, (formal - degree) as u64, p) % p;
        std::mem::swap(&mut f, &mut g);
    }
    value * power_mod(g[0], f.len() as u64 - 1, p) % p
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

/// The length in bits of a norm, for estimates of the work.
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

    /// c ∏ (s − r)
    fn with_roots(c: u64, roots: &[u64]) -> Vec<u64> {
        let mut f = vec![c];
        for r in roots {
            f.insert(0, 0);
            for i in 1..f.len() {
                f[i - 1] = (f[i - 1] + (P - r) * f[i]) % P;
            }
        }
        f
    }

    proptest! {
        #[test]
        fn a_resultant_is_the_product_of_differences(
            a in 1u64..100, b in 1u64..100,
            r in prop::collection::vec(0u64..1000, 0..6),
            q in prop::collection::vec(0u64..1000, 0..6),
            drop in 0usize..3,
        ) {
            // a^n b^m ∏ (r − q)
            let mut expected = power_mod(a, q.len() as u64, P) * power_mod(b, r.len() as u64, P) % P;
            for r in &r {
                for q in &q {
                    expected = expected * ((P + r - q) % P) % P;
                }
            }
            let (f, g) = (with_roots(a, &r), with_roots(b, &q));
            prop_assert_eq!(resultant_mod(f.clone(), g.clone(), P), expected);
            // Leading zeros of g: each is a root at infinity, the factor is lc(f) up to sign.
            let mut formal = g.clone();
            formal.extend(vec![0; drop]);
            let found = resultant_mod(f.clone(), formal.clone(), P);
            let factor = power_mod(a, drop as u64, P);
            prop_assert_eq!(found, expected * factor % P);
            // Res(g, f) = (−1)^(mn) Res(f, g)
            let swapped = resultant_mod(formal.clone(), f.clone(), P);
            let odd = (f.len() - 1) * (formal.len() - 1) % 2 == 1;
            prop_assert_eq!(swapped, if odd { (P - found) % P } else { found });
        }

        #[test]
        fn traces_and_the_grid_agree(
            p in prop::collection::vec(0..P, 0..9),
            q in prop::collection::vec(0..P, 1..9),
            g in prop::collection::vec(0..P, 1..9),
            small in prop::bool::ANY,
        ) {
            // Small coefficients have common zeros and leading zeros now and then.
            let reduce = |f: Vec<u64>| -> Vec<u64> { f.iter().map(|c| if small { c % 2 } else { *c }).collect() };
            let [mut p, mut q, g] = [p, q, g].map(reduce);
            let formal = p.len().max(q.len());
            p.resize(formal, 0);
            q.resize(formal, 0);
            let x = [p, q];
            let inverses = inverses_mod(g.len(), P);
            match in_traces(&x, &g, &inverses, P) {
                Some(row) => prop_assert_eq!(row, on_grid(&x, &g, P)),
                None => prop_assert!(small || g.len() == 1),
            }
        }
    }
}
