//! Subresultants of a polynomial and its derivative, where the coefficients are polynomials in t.

use malachite::Natural;
use malachite::base::num::arithmetic::traits::{CeilingSqrt, Pow, Square};
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;

use super::IntegerPolynomial;
use crate::error::{Error, Invariant, Result};
use crate::limits::Limits;
use crate::modular::{Images, PrimeField, determinant, large_primes};

/// The largest number of products of residues; that many take about a minute.
const MAX_WORK: f64 = 3e10;

/// The degrees of the coefficients: the i-th coefficient has at most the degree `lowest + i·step`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weights {
    pub(crate) lowest: usize,
    pub(crate) step: isize,
}

/// The j-th signed principal subresultant coefficient sRes_j(P, P′) in Z[t] of `P = Σ a_i(t) R^i`, where m = deg P ≥ 1 and 0 ≤
/// j < m: the determinant of the Sylvester–Habicht matrix (Basu, Pollack, Roy, *Algorithms in Real Algebraic Geometry*,
/// Notation 8.55). sRes_0 is a_m times the discriminant, up to a sign that depends on m only.
///
/// Method: evaluation at integers, Gaussian elimination modulo 31-bit primes, interpolation, and Chinese remainders up to the
/// bound of Lemma 1. At the end the result is checked at one more point modulo one more prime. Cost: (degree · primes)
/// determinants of size 2m − 1 − 2j.
///
/// Lemma 1. Let ‖a‖ be the sum of the absolute values of all coefficients of a. No coefficient of the determinant is larger
/// than √(Σ ‖a_i‖²)^(m−1−j) √(Σ i² ‖a_i‖²)^(m−j).
/// Proof. For |t| = 1, |a_i(t)| ≤ ‖a_i‖, and by Hadamard the determinant is at most the product of the lengths of its rows, of
/// which m − 1 − j belong to P and m − j to P′. A coefficient is a mean of values times powers of t over this circle (Cauchy).
/// Law: `the_bound_is_reached_at_half_the_modulus`.
///
/// # Errors
/// [`Error::Limit`] if the computation takes too much work; those of `limits`; [`Error::Internal`] if the result is wrong.
pub(crate) fn signed_subresultant(
    p: &[IntegerPolynomial],
    j: usize,
    weights: Weights,
    limits: &Limits,
) -> Result<IntegerPolynomial> {
    let matrix = Matrix::new(p.len() - 1, j);
    let degree = matrix.degree_bound(weights);
    let bits = matrix.coefficient_bits(p);
    let primes = bits / 30.9 + 2.0;
    let work = primes * as_f64(degree + 1) * as_f64(matrix.size).powi(3) / 3.0;
    if work > MAX_WORK {
        return Err(Error::limit(format!(
            "a discriminant of degree {degree} with coefficients of up to {bits:.0} bits, about {work:.0e} operations (at most {MAX_WORK:.0e} are made)"
        )));
    }
    let bound = matrix.bound(p);
    let mut combined = Images::unknown(degree + 1);
    let mut primes = large_primes();
    while !combined.determine(&bound) {
        limits.check()?;
        let prime = primes.following();
        let field = PrimeField::new(prime);
        let residues = residues(p, &field);
        let values = (0..=degree as u64).map(|t| matrix.value(&residues, t, &field));
        combined.push(&field.interpolate(values.collect()), prime);
    }
    let found = combined.balanced();
    let field = PrimeField::new(primes.following());
    let point = ANY_POINT % field.prime();
    if field.value(&field.residues(&found), point)
        != matrix.value(&residues(p, &field), point, &field)
    {
        return Err(Error::internal(
            "a subresultant",
            "the subresultant has the value of its determinant modulo one more prime",
        ));
    }
    Ok(found)
}

/// The point of the check, which is not one of the small integers. A polynomial of degree d other than 0 vanishes at less than
/// one in 2^30/d points.
const ANY_POINT: u64 = 0x9e37_79b9_7f4a_7c15;

/// The coefficients of polynomials modulo a prime.
fn residues(p: &[IntegerPolynomial], field: &PrimeField) -> Vec<Vec<u64>> {
    p.iter().map(|a| field.residues(a)).collect()
}

#[expect(clippy::cast_precision_loss, reason = "sizes are far below 2^53")]
fn as_f64(n: usize) -> f64 {
    n as f64
}

/// The Sylvester–Habicht matrix: m − 1 − j rows R^k P with k descending, then m − j rows R^k P′ with k
/// ascending, and columns for the powers 2m − 2 − j down to j.
struct Matrix {
    m: usize,
    j: usize,
    size: usize,
}

impl Matrix {
    fn new(m: usize, j: usize) -> Self {
        let size = 2 * m - 1 - 2 * j;
        Self { m, j, size }
    }

    /// The row with this index: the exponent k, and whether the row is R^k P′.
    fn row(&self, index: usize) -> (usize, bool) {
        let of_p = self.m - 1 - self.j;
        if index < of_p {
            (of_p - 1 - index, false)
        } else {
            (index - of_p, true)
        }
    }

    fn degree_bound(&self, weights: Weights) -> usize {
        let columns: usize = (self.j..self.j + self.size).sum();
        let rows = (0..self.size).map(|index| self.row(index));
        // The coefficient of R^i in P′ is that of R^(i+1) in P.
        let (mut shifts, mut raised) = (0, 0);
        for (shift, derivative) in rows {
            shifts += shift;
            raised += usize::from(derivative);
        }
        let steps = (columns + raised - shifts).cast_signed();
        let degree = (self.size * weights.lowest).cast_signed() + weights.step * steps;
        usize::try_from(degree).invariant("a coefficient has no negative degree")
    }

    /// The bound of Lemma 1 of [`signed_subresultant`], rounded up.
    fn bound(&self, p: &[IntegerPolynomial]) -> Natural {
        let mut squares = [Natural::ZERO, Natural::ZERO];
        for (i, a) in p.iter().enumerate() {
            let square = one_norm(a).square();
            squares[1] += &square * Natural::from(i).square();
            squares[0] += square;
        }
        let of_p = (&squares[0]).pow((self.m - 1 - self.j) as u64);
        let of_derivative = (&squares[1]).pow((self.m - self.j) as u64);
        (of_p * of_derivative).ceiling_sqrt()
    }

    /// About the binary logarithm of the bound, to estimate the work.
    fn coefficient_bits(&self, p: &[IntegerPolynomial]) -> f64 {
        let mut norms = [0.0f64; 2];
        // The norms are divided by the largest one, so that no square overflows.
        let scale = p.iter().map(one_norm_bits).fold(0.0, f64::max);
        for (i, a) in p.iter().enumerate() {
            let norm = (one_norm_bits(a) - scale).exp2();
            norms[0] += norm * norm;
            norms[1] += (as_f64(i) * norm).powi(2);
        }
        let of_p = as_f64(self.m - 1 - self.j);
        let of_derivative = as_f64(self.m - self.j);
        let bits = |square: f64| square.log2() / 2.0 + scale + 0.01;
        of_p * bits(norms[0]) + of_derivative * bits(norms[1]).max(1.0)
    }

    /// The determinant at a point modulo a prime.
    fn value(&self, residues: &[Vec<u64>], t: u64, field: &PrimeField) -> u64 {
        let p: Vec<u64> = residues.iter().map(|a| field.value(a, t)).collect();
        let derivative: Vec<u64> = p
            .iter()
            .enumerate()
            .skip(1)
            .map(|(i, &c)| field.mul(c, i as u64))
            .collect();
        let mut rows = Vec::with_capacity(self.size);
        for index in 0..self.size {
            let (shift, of_derivative) = self.row(index);
            let source = if of_derivative { &derivative } else { &p };
            // The coefficients of negative powers and of powers beyond the degree are 0.
            let column = |c: usize| {
                let power = self.j + self.size - 1 - c;
                power
                    .checked_sub(shift)
                    .and_then(|i| source.get(i))
                    .copied()
                    .unwrap_or(0)
            };
            rows.push((0..self.size).map(column).collect());
        }
        determinant(rows, field.prime())
    }
}

/// The sum of the absolute values of the coefficients.
fn one_norm(a: &IntegerPolynomial) -> Natural {
    let coefficients = a.coefficients_asc().iter();
    coefficients.map(|c| c.unsigned_abs_ref()).sum()
}

/// The binary logarithm of the sum of the absolute values, rounded up a little; 0 for the polynomial 0.
fn one_norm_bits(a: &IntegerPolynomial) -> f64 {
    let sum = one_norm(a);
    let bits = sum.significant_bits();
    let shift = bits.saturating_sub(60);
    let top = u64::try_from(&(sum >> shift)).invariant("the leading 60 bits fit in a word") + 1;
    #[expect(clippy::cast_precision_loss, reason = "a bound, rounded up elsewhere")]
    let value = (top as f64).log2() + shift as f64;
    value.max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::Integer;
    use malachite::base::polynomial::Polynomial;
    use num_bigint::BigInt;
    use num_rational::BigRational;
    use proptest::prelude::*;

    fn poly(c: &[i64]) -> IntegerPolynomial {
        IntegerPolynomial::from_coefficients_asc(c.iter().map(|&c| Integer::from(c)).collect())
    }

    const FLAT: Weights = Weights { lowest: 3, step: 0 };

    #[test]
    fn the_discriminant_of_a_quadratic() {
        // a R² + b R + c with a = t, b = 1 + t, c = 2 − t has sRes_0 = a (b² − 4ac).
        let p = [poly(&[2, -1]), poly(&[1, 1]), poly(&[0, 1])];
        let found =
            signed_subresultant(&p, 0, Weights { lowest: 1, step: 0 }, &Limits::none()).unwrap();
        assert_eq!(found, poly(&[0, 1]) * poly(&[1, -6, 5]));
        let first =
            signed_subresultant(&p, 1, Weights { lowest: 1, step: 0 }, &Limits::none()).unwrap();
        assert_eq!(first, poly(&[0, 2]));
    }

    #[test]
    fn the_bound_is_reached_at_half_the_modulus() {
        // For c t R the determinant is the derivative.
        let (mut all, mut modulus) = (large_primes(), Integer::from(1));
        for primes in 1..6 {
            modulus *= Integer::from(all.following());
            for more in -3..4 {
                for sign in [1, -1] {
                    let c = ((&modulus >> 1u64) + Integer::from(more)) * Integer::from(sign);
                    let in_t = IntegerPolynomial::from_coefficients_asc(vec![Integer::from(0), c]);
                    let p = [poly(&[]), in_t.clone()];
                    let weights = Weights { lowest: 1, step: 0 };
                    let found = signed_subresultant(&p, 0, weights, &Limits::none()).unwrap();
                    assert_eq!(found, in_t, "{primes} primes, {more}");
                }
            }
        }
    }

    #[test]
    fn weights_that_are_too_small_are_noticed() {
        let p = [poly(&[2, -1]), poly(&[1, 1]), poly(&[0, 1])];
        let weights = Weights { lowest: 0, step: 0 };
        let error = signed_subresultant(&p, 0, weights, &Limits::none()).unwrap_err();
        assert!(matches!(error, Error::Internal { .. }), "{error}");
    }

    #[test]
    fn too_much_work_is_refused() {
        let huge = vec![poly(&[1; 101]); 101];
        let weights = Weights {
            lowest: 100,
            step: 0,
        };
        let error = signed_subresultant(&huge, 0, weights, &Limits::none()).unwrap_err();
        assert!(
            error.to_string().contains("a discriminant of degree"),
            "{error}"
        );
    }

    /// The slow twin: Gaussian elimination over fractions of num-rational, for one t.
    fn naive(p: &[IntegerPolynomial], j: usize, t: i64) -> BigRational {
        let value = |a: &IntegerPolynomial| {
            a.coefficients_asc()
                .iter()
                .rev()
                .fold(BigRational::from(BigInt::from(0)), |v, c| {
                    let c: BigInt = c.to_string().parse().unwrap();
                    v * BigInt::from(t) + c
                })
        };
        let p: Vec<BigRational> = p.iter().map(value).collect();
        let m = p.len() - 1;
        let derivative: Vec<BigRational> = (1..=m).map(|i| &p[i] * BigInt::from(i)).collect();
        let zero = BigRational::from(BigInt::from(0));
        let size = 2 * m - 1 - 2 * j;
        let row = |source: &[BigRational], shift: usize| -> Vec<BigRational> {
            (0..size)
                .map(|c| {
                    let power = j + size - 1 - c;
                    power
                        .checked_sub(shift)
                        .and_then(|i| source.get(i))
                        .unwrap_or(&zero)
                        .clone()
                })
                .collect()
        };
        let mut rows: Vec<Vec<BigRational>> = (0..m - 1 - j).rev().map(|k| row(&p, k)).collect();
        rows.extend((0..m - j).map(|k| row(&derivative, k)));
        let mut det = BigRational::from(BigInt::from(1));
        for k in 0..size {
            let Some(pivot) = (k..size).find(|&i| rows[i][k] != zero) else {
                return zero;
            };
            if pivot != k {
                rows.swap(pivot, k);
                det = -det;
            }
            det *= rows[k][k].clone();
            let top = rows[k].clone();
            for row in &mut rows[k + 1..] {
                let factor = &row[k] / &top[k];
                for (c, t) in row[k..].iter_mut().zip(&top[k..]) {
                    *c -= &factor * t;
                }
            }
        }
        det
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]
        #[test]
        fn agrees_with_gauss_over_the_rationals(
            c in prop::collection::vec(prop::collection::vec(-9i64..9, 1..5), 2..6),
            lead in prop_oneof![-5i64..0, 1i64..5],
            t in -6i64..7,
            pick in 0usize..4,
            bits in prop_oneof![Just(0u64), 20u64..40, 100u64..400],
            low in -1i64..2,
        ) {
            // Coefficients near multiples of a power of two.
            let long = |f: IntegerPolynomial| {
                let c = f.into_coefficients_asc().into_iter();
                IntegerPolynomial::from_coefficients_asc(c.map(|c| (c << bits) + Integer::from(low)).collect())
            };
            let mut p: Vec<IntegerPolynomial> = c.iter().map(|c| long(poly(c))).collect();
            p.push(long(poly(&[lead, 1])));
            let j = pick % (p.len() - 1);
            let found = signed_subresultant(&p, j, FLAT, &Limits::none()).unwrap();
            let value = found.coefficients_asc().iter().rev().fold(BigInt::from(0), |v, c| v * t + c.to_string().parse::<BigInt>().unwrap());
            prop_assert_eq!(BigRational::from(value), naive(&p, j, t));
        }
    }
}
