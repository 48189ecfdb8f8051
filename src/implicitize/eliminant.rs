//! Exact subresultants of two polynomials in two variables, with respect to the second variable.

use malachite::Integer;
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial;

use super::symmetric::{Rows, modulo};
use crate::error::{Error, Result};
use crate::limits::Limits;
use crate::modular::{Images, PrimeField, determinant, large_primes};
use crate::parallel;
use crate::poly::{IntegerPolynomial, polynomial_gcd, squarefree_decomposition};

/// The largest number of products of residues; that many take some tenths of a second.
const MAX_WORK: u64 = 100_000_000;

/// The limits are checked after this many primes.
const GROUP: usize = 16;

/// Primes are at least 2^30.
const BITS_OF_A_PRIME: u64 = 30;

/// The coefficients, ascending, of the j-th subresultant of f and g with respect to the second variable Y, for
/// j at most both degrees m, n in Y and less than one of them: of Σ_l s_l Y^l, l ≤ j, where s_l is the determinant of the
/// first m + n − 2j − 1 columns and the column of Y^l in the matrix of the rows Y^(n−j−1) f, …, f, Y^(m−j−1) g, …, g. For
/// j = 0 that is the resultant.
///
/// Method: evaluation at numbers, Gauss or Euclid modulo 31-bit primes, interpolation and Chinese remainders.
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
/// [`Error::Limit`] if the computation takes too much work; those of `limits`.
pub(super) fn subresultant(
    [f, g]: [&Rows; 2],
    j: usize,
    limits: &Limits,
) -> Result<Vec<IntegerPolynomial>> {
    (0..=j)
        .map(|l| Minor { f, g, j, l }.divided_by(&IntegerPolynomial::one(), limits))
        .collect()
}

/// The resultant of f and g with respect to the second variable, divided by a primitive polynomial that divides it.
///
/// # Errors
/// As [`subresultant`]; [`Error::Internal`] if the polynomial does not divide the resultant.
pub(super) fn deflated_resultant(
    [f, g]: [&Rows; 2],
    divisor: &IntegerPolynomial,
    limits: &Limits,
) -> Result<IntegerPolynomial> {
    let minor = Minor { f, g, j: 0, l: 0 };
    minor.divided_by(divisor, limits)
}

/// The product of S − s_i − s_j over the pairs i < j of the roots s_i of a squarefree g, primitive up to sign.
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

/// A primitive divisor of the resultant with respect to P of the symmetric polynomials a and b of two functions p/q, in S = s +
/// σ and P = sσ. The divisor belongs to common poles: the two functions have denominators with these common roots, and it takes
/// out the pairs at which both s and σ are such poles.
///
/// Lemma. If the denominators have `g^k` in common, g squarefree, the resultant is divisible by the k²-th power of
/// [`sums_of_pairs`] of g, by the k(k−1)/2-th power of g(S/2), and by the product of all of these for coprime g.
/// Proof. The multiplicity of a zero S of the resultant is at least the sum of those with which a and b meet above it.
/// At (s_i, s_j), two different roots of g, `p(s) q(σ) − q(s) p(σ)` is in the k-th power of the maximal ideal, and
/// (s, σ) ↦ (S, P) is invertible there; so they meet at least k² times (Fulton, *Algebraic Curves*, §3.3).
/// At (s_i, s_i), with local parameters u^k = q1/p1, a is (u^l − v^l)/(u − v) up to a unit, l ≥ k the multiplicity in q1: a
/// union of ⌊(l−1)/2⌋ smooth branches e2 = c e1² + O(e1³) in e1 = u + v, e2 = uv, of different c that depend on l only, and
/// for even l a branch transversal to them. Branches with the same c meet at least 3 times, with different c twice, all
/// others once; that adds up to at least k(k−1)/2. By Gauss's lemma the quotient has integer coefficients.
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
        // g(S/2) 2^deg g
        let degree = g.coefficients_asc().len() - 1;
        let coefficients = g.coefficients_asc().iter().enumerate();
        let doubled = coefficients.map(|(i, c)| c << (degree - i)).collect();
        let doubled =
            crate::poly::primitive_part(&IntegerPolynomial::from_coefficients_asc(doubled));
        for _ in 0..k * (k - 1) / 2 {
            divisor *= &doubled;
        }
    }
    Ok(divisor)
}

/// A determinant s_l of the lemma of [`subresultant`].
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

    /// The size bound: no coefficient is larger than 2^bits.
    fn bits(&self) -> u64 {
        let [of_f, of_g] = self.counts();
        of_f as u64 * norm_bits(self.f) + of_g as u64 * norm_bits(self.g)
    }

    /// The quotient of the determinant and a primitive polynomial that divides it over the rational numbers.
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
            return Err(Error::internal(
                "an eliminant",
                "a divisor is not larger than what it divides",
            ));
        };
        let known = if places.len() == 1 {
            0
        } else {
            degree as u64 + 1
        };
        let bits = (self.bits() + known).saturating_sub(lead.significant_bits() - 1);
        // There are enough primes for twice the largest coefficient, and one more, which must not change the result.
        let count = usize::try_from((bits + 2).div_ceil(BITS_OF_A_PRIME)).unwrap_or(usize::MAX);
        let size = (self.f.degree() + self.g.degree() + 2) as u64;
        let work = (count as u64 + 1)
            .saturating_mul(degree as u64 + 1)
            .saturating_mul(size * size + degree as u64);
        if work > MAX_WORK {
            return Err(Error::limit(format!(
                "an eliminant of degree {degree} with coefficients of up to {bits} bits, about {work:.1e} operations (at most {MAX_WORK:.1e} are made)",
                work = as_f64(work),
                MAX_WORK = as_f64(MAX_WORK)
            )));
        }
        let primes: Vec<u64> = large_primes()
            .filter(|&p| PrimeField::new(p).reduce_integer(lead) != 0)
            .take(count + 1)
            .collect();
        let mut images: Option<Images> = None;
        let (check, primes) = match primes.split_last() {
            Some(parts) => parts,
            None => return Err(Error::internal("an eliminant", "there is a prime")),
        };
        for group in primes.chunks(GROUP) {
            limits.check()?;
            let found = parallel::map(group, |&p| self.image(divisor, degree, p));
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
        let check_field = PrimeField::new(*check);
        let image = self.image(divisor, degree, *check);
        let agrees = image.iter().enumerate().all(|(k, &c)| {
            let found = quotient.coefficients_asc().get(k);
            found.map_or(0, |c| check_field.reduce_integer(c)) == c
        });
        if agrees {
            Ok(quotient)
        } else {
            Err(Error::internal("an eliminant", "one more prime changes it"))
        }
    }

    /// The coefficients of the quotient modulo a prime.
    fn image(&self, divisor: &IntegerPolynomial, degree: usize, p: u64) -> Vec<u64> {
        let field = PrimeField::new(p);
        let reduce = |f: &IntegerPolynomial| field.residues(f);
        let [f, g] = [self.f, self.g].map(|f| f.rows().iter().map(reduce).collect::<Vec<_>>());
        let divisor = reduce(divisor);
        // The evaluation uses the first consecutive numbers at which the divisor is not 0.
        let mut start = 0;
        let mut below = Vec::with_capacity(degree + 1);
        while below.len() <= degree {
            match field.value(&divisor, (start + below.len() as u64) % p) {
                0 => {
                    start += below.len() as u64 + 1;
                    below.clear();
                }
                value => below.push(value),
            }
        }
        let values = below.iter().zip(start..).map(|(&below, x)| {
            let x = x % p;
            let [f, g] = [&f, &g].map(|f| {
                f.iter()
                    .map(|row| field.value(row, x))
                    .collect::<Vec<u64>>()
            });
            let value = self.value(f, g, &field);
            if below == 1 {
                value
            } else {
                field.mul(value, field.inverse(below))
            }
        });
        let mut image = field.interpolate(values.collect());
        // Shifts the variable from x − start to x.
        let minus = (p - start % p) % p;
        for k in 0..image.len() {
            for i in (k..image.len() - 1).rev() {
                image[i] = (image[i] + minus * image[i + 1]) % p;
            }
        }
        image
    }

    /// The determinant modulo a prime for two polynomials in Y.
    fn value(&self, f: Vec<u64>, g: Vec<u64>, field: &PrimeField) -> u64 {
        if self.j == 0 {
            return field.resultant(f, g);
        }
        let [of_f, of_g] = self.counts();
        let size = of_f + of_g;
        let top = size + self.j - 1;
        let row = |f: &[u64], shift: usize| -> Vec<u64> {
            let columns = (0..size).map(|c| if c + 1 < size { top - c } else { self.l });
            let entry = |power: usize| power.checked_sub(shift).and_then(|i| f.get(i)).copied();
            // The row has zeros beyond both ends of the polynomial.
            columns.map(|power| entry(power).unwrap_or(0)).collect()
        };
        let rows = (0..of_f).rev().map(|r| row(&f, r));
        let rows = rows.chain((0..of_g).rev().map(|r| row(&g, r)));
        determinant(rows.collect(), field.prime())
    }
}

#[expect(clippy::cast_precision_loss, reason = "an estimate in a message")]
fn as_f64(n: u64) -> f64 {
    n as f64
}

/// An upper bound of the binary logarithm of the sum of the absolute coefficients, as an integer.
fn norm_bits(f: &Rows) -> u64 {
    let coefficients = f.rows().iter().flat_map(|row| row.coefficients_asc());
    let norm = coefficients.fold(Integer::from(0), |sum, c| {
        sum + Integer::from(c.unsigned_abs_ref().clone())
    });
    (norm - Integer::ONE).significant_bits()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::implicitize::symmetric::{bezoutian, in_sum_and_product};
    use crate::poly::{RationalFunction, divide_exactly};
    use proptest::prelude::*;

    fn poly(c: &[i64]) -> IntegerPolynomial {
        IntegerPolynomial::from_coefficients_asc(c.iter().map(|&c| Integer::from(c)).collect())
    }

    /// The determinant over Z[x], by Laplace expansion along the first row.
    fn laplace(rows: &[Vec<IntegerPolynomial>]) -> IntegerPolynomial {
        let Some((first, rest)) = rows.split_first() else {
            return poly(&[1]);
        };
        let mut sum = poly(&[]);
        for (c, entry) in first.iter().enumerate() {
            let minor: Vec<Vec<_>> = rest
                .iter()
                .map(|row| {
                    let others = row.iter().enumerate().filter(|(k, _)| *k != c);
                    others.map(|(_, entry)| entry.clone()).collect()
                })
                .collect();
            let term = entry * laplace(&minor);
            if c % 2 == 0 { sum += term } else { sum -= term }
        }
        sum
    }

    fn exactly(f: &Rows, g: &Rows, j: usize, l: usize) -> IntegerPolynomial {
        let (of_f, of_g) = (g.degree() - j, f.degree() - j);
        let size = of_f + of_g;
        let row = |f: &Rows, shift: usize| -> Vec<IntegerPolynomial> {
            let powers = (0..size).map(|c| if c + 1 < size { size + j - 1 - c } else { l });
            let entry = |power: usize| {
                power
                    .checked_sub(shift)
                    .and_then(|i| f.rows().get(i))
                    .cloned()
            };
            powers
                .map(|power| entry(power).unwrap_or_else(|| poly(&[])))
                .collect()
        };
        let mut rows: Vec<Vec<_>> = (0..of_f).rev().map(|r| row(f, r)).collect();
        rows.extend((0..of_g).rev().map(|r| row(g, r)));
        laplace(&rows)
    }

    /// Polynomials of degree up to 3 in the second variable, with coefficients of up to 70 bits, some of which are all ones.
    fn rows() -> impl Strategy<Value = Rows> {
        let coefficient = prop_oneof![
            (-9i64..10).prop_map(Integer::from),
            (0u64..70, any::<bool>()).prop_map(|(bits, negative)| {
                let ones = (Integer::ONE << bits) - Integer::ONE;
                if negative { -ones } else { ones }
            }),
        ];
        let row = prop::collection::vec(coefficient, 1..4);
        prop::collection::vec(row, 2..5).prop_map(|rows| {
            let rows = rows.into_iter();
            Rows::new(rows.map(IntegerPolynomial::from_coefficients_asc).collect())
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        #[test]
        fn subresultants_are_those_over_the_rationals(f in rows(), g in rows()) {
            let (m, n) = (f.degree(), g.degree());
            prop_assume!(m > 0 && n > 0);
            let most = if m == n { m - 1 } else { m.min(n) };
            for j in 0..=most {
                let found = subresultant([&f, &g], j, &Limits::none()).unwrap();
                prop_assert_eq!(found.len(), j + 1);
                for (l, found) in found.iter().enumerate() {
                    let expected = exactly(&f, &g, j, l);
                    // Euclid and Gauss may differ in the sign of the resultant.
                    let minus = poly(&[]) - &expected;
                    prop_assert!(*found == expected || (j == 0 && *found == minus), "{} {}", j, l);
                }
            }
        }

        /// For y + c and y − c x^d with |c| = 2^k the resultant −c x^d − c has coefficients as large as the bound allows.
        #[test]
        fn the_bound_of_the_coefficients_is_enough_where_it_is_reached(k in 20u64..200, d in 0usize..4, below in any::<bool>()) {
            let c = (Integer::ONE << k) - if below { Integer::ONE } else { Integer::from(0) };
            let constant = |c: &Integer| IntegerPolynomial::from_coefficients_asc(vec![c.clone()]);
            let mut power = vec![0; d];
            power.push(1);
            let f = Rows::new(vec![constant(&c), poly(&[0, 1])]);
            let g = Rows::new(vec![poly(&power) * constant(&-&c), poly(&[1])]);
            let found = subresultant([&f, &g], 0, &Limits::none()).unwrap();
            let expected = exactly(&f, &g, 0, 0);
            prop_assert!(found[0] == expected || found[0] == poly(&[]) - expected);
        }

        #[test]
        fn the_pairs_of_poles_divide_the_resultant(
            p in prop::collection::vec(prop::collection::vec(-9i64..10, 1..7), 2),
            g in prop::collection::vec(-3i64..4, 2..4),
            k in 1usize..4, more in 0usize..2,
        ) {
            let g = poly(&g);
            prop_assume!(g.coefficients_asc().len() > 1);
            let power = |e: usize| (0..e).fold(poly(&[1]), |power, _| power * &g);
            let x = RationalFunction::from_integers(poly(&p[0]), power(k));
            let y = RationalFunction::from_integers(poly(&p[1]), power(k + more));
            let (Some(x), Some(y)) = (x, y) else {
                return Err(TestCaseError::reject("a pole everywhere"));
            };
            prop_assume!(x.degree() > 1 && y.degree() > 1);
            let [a, b] = [&x, &y].map(|f| in_sum_and_product(&bezoutian(f)));
            prop_assume!(a.degree() > 0 && b.degree() > 0);
            let limits = Limits::none();
            let whole = deflated_resultant([&a, &b], &poly(&[1]), &limits).unwrap();
            prop_assume!(whole != poly(&[]));
            let poles = pairs_of_poles([x.denominator(), y.denominator()], &limits).unwrap();
            let rest = deflated_resultant([&a, &b], &poles, &limits).unwrap();
            prop_assert_eq!(divide_exactly(&whole, &poles), Some(rest));
        }
    }

    #[test]
    fn sums_of_pairs_are_those_of_the_roots() {
        // The roots 1, 2, 4 have the sums 3, 5, 6.
        let g = poly(&[-1, 1]) * poly(&[-2, 1]) * poly(&[-4, 1]);
        let sums = poly(&[-3, 1]) * poly(&[-5, 1]) * poly(&[-6, 1]);
        assert_eq!(sums_of_pairs(&g, &Limits::none()).unwrap(), sums);
        assert_eq!(
            sums_of_pairs(&poly(&[1, 0, 1]), &Limits::none()).unwrap(),
            poly(&[0, 1])
        );
    }

    #[test]
    fn too_much_work_is_refused() {
        let f = Rows::new(vec![poly(&[7; 60]); 60]);
        let g = Rows::new(vec![poly(&[5; 60]); 60]);
        let error = deflated_resultant([&f, &g], &poly(&[1]), &Limits::none()).unwrap_err();
        assert!(
            error.to_string().contains("an eliminant of degree"),
            "{error}"
        );
    }

    #[test]
    fn what_is_no_divisor_is_noticed() {
        let f = Rows::new(vec![poly(&[1, 2]), poly(&[3, 4]), poly(&[5])]);
        let g = Rows::new(vec![poly(&[2, 7]), poly(&[1, 1, 1])]);
        let error = deflated_resultant([&f, &g], &poly(&[11, 1]), &Limits::none()).unwrap_err();
        assert!(matches!(error, Error::Internal { .. }), "{error}");
    }
}
