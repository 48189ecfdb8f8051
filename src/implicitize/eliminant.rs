//! Subresultants of two polynomials in two variables with respect to the second one, exactly.

use malachite::Integer;
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial;
use rayon::prelude::*;

use super::symmetric::{Rows, modulo};
use crate::error::{Error, Result};
use crate::limits::Limits;
use crate::poly::{
    Images, IntegerPolynomial, interpolate, inverse_mod, kernel_primes, polynomial_gcd,
    reduce_integer, resultant_mod, squarefree_decomposition,
};

/// Products of residues beyond which the work is refused: about a second.
const MAX_WORK: u64 = 1_000_000_000;

/// How many primes are taken before the limits are asked again.
const GROUP: usize = 16;

/// Primes are at least 2^30.
const BITS_OF_A_PRIME: u64 = 30;

/// The coefficients, ascending, of the j-th subresultant of f and g with respect to the second variable Y, for
/// j at most both degrees m, n in Y and less than one of them: of Σ_l s_l Y^l, l ≤ j, where s_l is the determinant of the
/// first m + n − 2j − 1 columns and the column of Y^l in the matrix of the rows Y^(n−j−1) f, …, f, Y^(m−j−1) g, …, g. For
/// j = 0 that is the resultant.
///
/// By evaluation at numbers, Gauss or Euclid modulo 31-bit primes, interpolation and Chinese remainders.
///
/// Lemma (size). With total degrees M and N, the degree of s_l is at most `(n−j) M + (m−j) N + Σ r − Σ c`, where r runs over
/// the exponents of Y before f and g in the rows and c over the powers of Y of the columns; its coefficients are at most
/// `‖f‖^(n−j) ‖g‖^(m−j)`, with sums of absolute values as norms.
/// Proof. The entry of the row Y^r f in the column c is the coefficient of Y^(c−r), of degree at most M − c + r; each product
/// of the determinant has one entry of every row and column. The norm of a determinant is at most the product of the sums of
/// the norms of the entries of its rows.
/// Law: `subresultants_are_those_over_the_rationals`, with coefficients for which the bound of the norm is reached.
///
/// # Errors
/// [`Error::Limit`] if that is too much work; those of `limits`.
pub(super) fn subresultant(
    [f, g]: [&Rows; 2],
    j: usize,
    limits: &Limits,
) -> Result<Vec<IntegerPolynomial>> {
    (0..=j)
        .map(|l| Minor { f, g, j, l }.divided_by(&IntegerPolynomial::one(), limits))
        .collect()
}

/// The resultant of f and g with respect to the second variable, divided by a primitive divisor of it.
///
/// # Errors
/// As [`subresultant`]; [`Error::Internal`] if it is no divisor.
pub(super) fn deflated_resultant(
    [f, g]: [&Rows; 2],
    divisor: &IntegerPolynomial,
    limits: &Limits,
) -> Result<IntegerPolynomial> {
    let minor = Minor { f, g, j: 0, l: 0 };
    minor.divided_by(divisor, limits)
}

/// The product of S − s_i − s_j over the pairs i < j of the roots of a squarefree g, primitive up to sign.
///
/// g modulo s² − S s + P is u + v s, and a pair of roots has the sum S and the product P where u = v = 0.
///
/// # Errors
/// As [`subresultant`].
pub(super) fn sums_of_pairs(g: &IntegerPolynomial, limits: &Limits) -> Result<IntegerPolynomial> {
    if g.coefficients_asc().len() <= 2 {
        return Ok(IntegerPolynomial::one());
    }
    let [u, v] = modulo(g);
    let sums = deflated_resultant([&u, &v], &IntegerPolynomial::one(), limits)?;
    Ok(crate::poly::primitive_part(&sums))
}

/// A divisor, primitive, of the resultant with respect to P of the symmetric polynomials a, b of two functions p/q, in
/// S = s + σ and P = sσ, for two functions whose denominators have these roots in common: where both parameters are poles.
///
/// Lemma. If the denominators have `g^k` in common, g squarefree, the resultant is divisible by the k²-th power of
/// [`sums_of_pairs`] of g, and by the product of these for coprime g.
/// Proof. At (s_i, s_j), two different roots of g, `p(s) q(σ) − q(s) p(σ)` is in the k-th power of the maximal ideal, and
/// (s, σ) ↦ (S, P) is invertible there; so a and b meet there at least k² times (Fulton, *Algebraic Curves*, §3.3), and the
/// multiplicity of a zero S of the resultant is at least the sum of those of the points above it. By Gauss's lemma the
/// quotient has integer coefficients.
/// Law: `the_pairs_of_poles_divide_the_resultant`.
///
/// # Errors
/// As [`subresultant`].
pub(super) fn pairs_of_poles(
    [q1, q2]: [&IntegerPolynomial; 2],
    limits: &Limits,
) -> Result<IntegerPolynomial> {
    let mut divisor = IntegerPolynomial::one();
    for (k, g) in squarefree_decomposition(&polynomial_gcd(q1, q2)) {
        let sums = sums_of_pairs(&g, limits)?;
        for _ in 0..k * k {
            divisor *= &sums;
        }
    }
    Ok(divisor)
}

/// One of the determinants s_l.
struct Minor<'a> {
    f: &'a Rows,
    g: &'a Rows,
    j: usize,
    l: usize,
}

impl Minor<'_> {
    /// The numbers of rows Y^r f and Y^r g.
    fn counts(&self) -> [usize; 2] {
        [self.g.degree() - self.j, self.f.degree() - self.j]
    }

    fn degree(&self) -> usize {
        let [of_f, of_g] = self.counts();
        let columns = self.j + 1..of_f + of_g + self.j;
        let columns = columns.sum::<usize>() + self.l;
        let shifts = (0..of_f).sum::<usize>() + (0..of_g).sum::<usize>();
        let whole = of_f * self.f.total_degree() + of_g * self.g.total_degree();
        (whole + shifts).saturating_sub(columns)
    }

    /// No coefficient is larger than 2 to this.
    fn bits(&self) -> u64 {
        let [of_f, of_g] = self.counts();
        of_f as u64 * norm_bits(self.f) + of_g as u64 * norm_bits(self.g)
    }

    /// The quotient by a primitive polynomial that divides it over the rational numbers.
    ///
    /// Lemma. The coefficients of a quotient h = R/D of integer polynomials, deg h = n, are at most `2^n ‖R‖/|lc D|`.
    /// Proof. Mahler's measure is multiplicative, at most the sum of the absolute coefficients, at least the absolute
    /// leading coefficient; and a coefficient of h is at most 2^n times the measure of h.
    /// Law: `the_pairs_of_poles_divide_the_resultant`.
    fn divided_by(
        &self,
        divisor: &IntegerPolynomial,
        limits: &Limits,
    ) -> Result<IntegerPolynomial> {
        let places = divisor.coefficients_asc();
        let Some(lead) = places.last() else {
            return Err(Error::internal("an eliminant", "0 is no divisor"));
        };
        let Some(degree) = self.degree().checked_sub(places.len() - 1) else {
            return Err(Error::internal("an eliminant", "a divisor is not larger than what it divides"));
        };
        let known = if places.len() == 1 { 0 } else { degree as u64 + 1 };
        let bits = (self.bits() + known).saturating_sub(lead.significant_bits() - 1);
        // Twice the largest coefficient, and one prime more than that: what is found must not change by it.
        let count = usize::try_from((bits + 2).div_ceil(BITS_OF_A_PRIME)).unwrap_or(usize::MAX);
        let size = (self.f.degree() + self.g.degree() + 2) as u64;
        let work = (count as u64 + 1)
            .saturating_mul(degree as u64 + 1)
            .saturating_mul(size * size + degree as u64);
        if work > MAX_WORK {
            return Err(Error::limit(format!(
                "an eliminant of degree {degree} with coefficients of up to {bits} bits, about {work:.1e} operations (at most {MAX_WORK:.1e} are made)",
                work = work as f64, MAX_WORK = MAX_WORK as f64
            )));
        }
        let primes: Vec<u64> = kernel_primes()
            .filter(|&p| reduce_integer(lead, p) != 0)
            .take(count + 1)
            .collect();
        let mut images: Option<Images> = None;
        let (check, primes) = match primes.split_last() {
            Some(parts) => parts,
            None => return Err(Error::internal("an eliminant", "there is a prime")),
        };
        for group in primes.chunks(GROUP) {
            limits.check()?;
            let found: Vec<Vec<u64>> = group
                .par_iter()
                .map(|&p| self.image(divisor, degree, p))
                .collect();
            for (image, &p) in found.iter().zip(group) {
                match &mut images {
                    Some(images) => images.push(image, p),
                    None => images = Some(Images::new(image, p)),
                }
            }
        }
        let Some(images) = images else {
            return Err(Error::internal("an eliminant", "a bound needs a prime"));
        };
        let quotient = images.balanced();
        let image = self.image(divisor, degree, *check);
        let agrees = image.iter().enumerate().all(|(k, &c)| {
            let found = quotient.coefficients_asc().get(k);
            found.map_or(0, |c| reduce_integer(c, *check)) == c
        });
        if agrees {
            Ok(quotient)
        } else {
            Err(Error::internal("an eliminant", "one more prime changes it"))
        }
    }

    /// The coefficients of the quotient modulo a prime.
    fn image(&self, divisor: &IntegerPolynomial, degree: usize, p: u64) -> Vec<u64> {
        let reduce = |f: &IntegerPolynomial| -> Vec<u64> {
            let coefficients = f.coefficients_asc().iter();
            coefficients.map(|c| reduce_integer(c, p)).collect()
        };
        let [f, g] = [self.f, self.g].map(|f| f.rows().iter().map(reduce).collect::<Vec<_>>());
        let divisor = reduce(divisor);
        let at = |f: &[u64], x: u64| f.iter().rev().fold(0, |v, c| (v * x + c) % p);
        // Where the divisor is not 0: the first places that follow one another.
        let mut start = 0;
        let mut below = Vec::with_capacity(degree + 1);
        while below.len() <= degree {
            match at(&divisor, (start + below.len() as u64) % p) {
                0 => {
                    start += below.len() as u64 + 1;
                    below.clear();
                }
                value => below.push(value),
            }
        }
        let values = below.iter().zip(start..).map(|(&below, x)| {
            let x = x % p;
            let [f, g] = [&f, &g].map(|f| f.iter().map(|row| at(row, x)).collect::<Vec<u64>>());
            let value = self.value(f, g, p);
            if below == 1 { value } else { value * inverse_mod(below, p) % p }
        });
        let mut image = interpolate(values.collect(), p);
        // From x − start to x.
        let minus = (p - start % p) % p;
        for k in 0..image.len() {
            for i in (k..image.len() - 1).rev() {
                image[i] = (image[i] + minus * image[i + 1]) % p;
            }
        }
        image
    }

    /// The determinant modulo a prime for two polynomials in Y.
    fn value(&self, f: Vec<u64>, g: Vec<u64>, p: u64) -> u64 {
        if self.j == 0 {
            return resultant_mod(f, g, p);
        }
        let [of_f, of_g] = self.counts();
        let size = of_f + of_g;
        let top = size + self.j - 1;
        let row = |f: &[u64], shift: usize| -> Vec<u64> {
            let columns = (0..size).map(|c| if c + 1 < size { top - c } else { self.l });
            let entry = |power: usize| power.checked_sub(shift).and_then(|i| f.get(i)).copied();
            // Beyond both ends of the polynomial the row has zeros.
            columns.map(|power| entry(power).unwrap_or(0)).collect()
        };
        let rows = (0..of_f).rev().map(|r| row(&f, r));
        let rows = rows.chain((0..of_g).rev().map(|r| row(&g, r)));
        determinant(rows.collect(), p)
    }
}

/// The determinant of a square matrix modulo a prime below 2³¹, by Gauss.
fn determinant(mut rows: Vec<Vec<u64>>, p: u64) -> u64 {
    let mut value = 1;
    for k in 0..rows.len() {
        let Some(pivot) = (k..rows.len()).find(|&i| rows[i][k] != 0) else {
            return 0;
        };
        if pivot != k {
            rows.swap(pivot, k);
            value = (p - value) % p;
        }
        value = value * rows[k][k] % p;
        let inverse = inverse_mod(rows[k][k], p);
        let (done, open) = rows.split_at_mut(k + 1);
        let top = &done[k];
        for row in open.iter_mut().filter(|row| row[k] != 0) {
            let factor = p - row[k] * inverse % p;
            for (c, t) in row[k..].iter_mut().zip(&top[k..]) {
                *c = (*c + factor * t) % p;
            }
        }
    }
    value
}

/// ⌈log₂⌉ of the sum of the absolute coefficients, at least.
fn norm_bits(f: &Rows) -> u64 {
    let coefficients = f.rows().iter().flat_map(|row| row.coefficients_asc());
    let norm = coefficients.fold(Integer::from(0), |sum, c| sum + Integer::from(c.unsigned_abs_ref().clone()));
    (norm - Integer::ONE).significant_bits()
}
