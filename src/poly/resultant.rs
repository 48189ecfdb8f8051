//! Resultants of polynomials in three variables.

use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::polynomial::Polynomial;

use super::eliminate::{as_f64, bits_of};
use super::{IntegerTerms, SparsePolynomial};
use crate::error::{Error, Invariant, Result};
use crate::limits::Limits;
use crate::modular::{Images, PrimeField, large_primes};

/// The largest number of products of residues; that many take some seconds.
const MAX_WORK: f64 = 3e9;

/// The resultant of the primitive parts of f and g with respect to the variable v, exactly.
///
/// Method: evaluation on a grid, Euclid's algorithm modulo 31-bit primes, interpolation, and Chinese remainders up to the bound
/// of Lemma 1. At the end the result is checked at one more point modulo one more prime.
///
/// Cost, for degrees m and n in v and degrees k and l of the result: k l m n products of residues for each prime, and one prime
/// for every 31 bits of the bound.
///
/// Lemma 1. Let ‖f‖ be the sum of the absolute values of all coefficients of f. The absolute values of the coefficients of the
/// resultant add up to at most ‖f‖^n ‖g‖^m.
/// Proof. ‖fg‖ ≤ ‖f‖ ‖g‖ and ‖f + g‖ ≤ ‖f‖ + ‖g‖. By these the norm of a determinant is at most the product over its
/// rows of the sum of the norms in the row, which is ‖f‖ in n rows of Sylvester's matrix, and ‖g‖ in m of them.
/// Law: `the_bound_is_reached_at_half_the_modulus`.
///
/// # Errors
/// [`Error::Limit`] if the computation takes too much work; those of `limits`; [`Error::Internal`] if the result is wrong.
pub(crate) fn resultant(
    f: &SparsePolynomial<3>,
    g: &SparsePolynomial<3>,
    v: usize,
    limits: &Limits,
) -> Result<SparsePolynomial<3>> {
    let [f, g] = [f, g].map(|f| IntegerTerms::of_numerators(&f.primitive()));
    let [u, w] = [(v + 1) % 3, (v + 2) % 3];
    let Size {
        powers: [m, n],
        degrees: [in_u, in_w],
        work,
    } = size([&f, &g], v);
    let norms = [f.norm(), g.norm()];
    if work > MAX_WORK {
        return Err(Error::limit(format!(
            "a resultant of degrees {in_u} and {in_w}, about {work:.0e} operations (at most {MAX_WORK:.0e} are made)"
        )));
    }
    let bound = (&norms[0]).pow(n as u64) * (&norms[1]).pow(m as u64);
    let point_of = |[a, b]: [u64; 2]| {
        let mut point = [0; 3];
        (point[u], point[w]) = (a, b);
        point
    };
    let at = |[a, b]: [u64; 2], field: &PrimeField| {
        let [f, g] = [&f, &g].map(|p| p.image(v, &point_of([a, b]), field));
        field.resultant(f, g)
    };
    let mut combined = Images::unknown((in_u + 1) * (in_w + 1));
    let mut primes = large_primes();
    while !combined.determine(&bound) {
        limits.check()?;
        let prime = primes.following();
        let field = PrimeField::new(prime);
        let mut columns = Vec::new();
        for a in 0..=in_u as u64 {
            let values = (0..=in_w as u64).map(|b| at([a, b], &field));
            columns.push(field.interpolate(values.collect()));
        }
        let rows = (0..=in_w).map(|j| columns.iter().map(|c| c[j]).collect());
        let image: Vec<u64> = rows.flat_map(|row| field.interpolate(row)).collect();
        combined.push(&image, prime);
    }
    let narrow = |e: usize| u32::try_from(e).invariant("degrees are below 2^32");
    let flat = combined.balanced().into_coefficients_asc();
    let terms = flat.into_iter().enumerate().map(|(index, c)| {
        let mut e = [0; 3];
        e[u] = narrow(index % (in_u + 1));
        e[w] = narrow(index / (in_u + 1));
        (e, c)
    });
    let found = IntegerTerms::new(terms.collect());
    let field = PrimeField::new(primes.following());
    let point = ANY_POINT.map(|c| c % field.prime());
    if found.image(v, &point_of(point), &field)[0] != at(point, &field) {
        return Err(Error::internal(
            "a resultant",
            "the resultant has the value of Sylvester's determinant modulo one more prime",
        ));
    }
    Ok(found.to_sparse())
}

/// The approximate number of operations of [`resultant`].
pub(crate) fn resultant_work(f: &SparsePolynomial<3>, g: &SparsePolynomial<3>, v: usize) -> f64 {
    let [f, g] = [f, g].map(|f| IntegerTerms::of_numerators(&f.primitive()));
    size([&f, &g], v).work
}

/// The size of a resultant.
struct Size {
    /// The degrees of both polynomials in the eliminated variable.
    powers: [usize; 2],
    /// The largest degrees of the resultant in the next variable and in the one after it.
    degrees: [usize; 2],
    /// The approximate number of operations.
    work: f64,
}

fn size([f, g]: [&IntegerTerms<3>; 2], v: usize) -> Size {
    let [of_f, of_g] = [f, g].map(|f| f.degrees().map(|d| d as usize));
    let (m, n) = (of_f[v], of_g[v]);
    let degrees = [(v + 1) % 3, (v + 2) % 3].map(|k| n * of_f[k] + m * of_g[k]);
    let bits = as_f64(n) * bits_of(&f.norm()) + as_f64(m) * bits_of(&g.norm());
    let cost = (m + 1) * (n + 1) + f.len() + g.len();
    let pairs = as_f64((degrees[0] + 1) * (degrees[1] + 1));
    Size {
        powers: [m, n],
        degrees,
        work: (bits / 30.9 + 1.0) * pairs * as_f64(cost),
    }
}

/// The point of the check, which is not on the grid. A polynomial of degrees k and l other than 0 vanishes at less than one in
/// 2^31/(k + l) points.
const ANY_POINT: [u64; 2] = [0x9e37_79b9_7f4a_7c15, 0xbf58_476d_1ce4_e5b9];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::poly::Ring;
    use malachite::{Integer, Natural};
    use proptest::prelude::*;

    fn polynomial() -> impl Strategy<Value = SparsePolynomial<3>> {
        let term = ([0u32..3, 0u32..3, 0u32..2], -9i64..9);
        prop::collection::vec(term, 1..5).prop_map(|terms| {
            SparsePolynomial::from_terms(terms.into_iter().map(|(e, c)| (e, Rational::from(c))))
        })
    }

    /// The product of the first primes that are used.
    fn modulus(primes: usize) -> Integer {
        let primes = large_primes().take(primes);
        primes.fold(Integer::from(1), |product, p| product * Integer::from(p))
    }

    #[test]
    fn the_bound_is_reached_at_half_the_modulus() {
        // Res_x(x + y, c y + z) is ± (c y + z), and c + 1 is the bound of its coefficients.
        let f = SparsePolynomial::variable(0).plus(&SparsePolynomial::variable(1));
        for primes in 1..6 {
            for more in -3..4 {
                for sign in [1, -1] {
                    let c = ((modulus(primes) >> 1u64) + Integer::from(more)) * Integer::from(sign);
                    let g = SparsePolynomial::variable(1)
                        .scaled(&Rational::whole(c))
                        .plus(&SparsePolynomial::variable(2));
                    let found = resultant(&f, &g, 0, &Limits::none()).unwrap();
                    assert_eq!(found, g.primitive(), "{primes} primes, {more}");
                }
            }
        }
    }

    /// Integers of up to 600 bits, near a power of two or random.
    fn long_integer() -> impl Strategy<Value = Integer> {
        (0u64..600, -1i64..2, any::<[u64; 10]>(), 0..4).prop_map(|(bits, more, limbs, kind)| {
            let power = Integer::from(1) << bits;
            let any = Integer::from(Natural::from_limbs_asc(&limbs)) >> (640 - bits);
            let size = if kind < 2 {
                power + Integer::from(more)
            } else {
                any + Integer::from(1)
            };
            if kind % 2 == 0 { size } else { -size }
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]
        /// Coefficients up to the product of the norms: Res_x(f, x + c y) = ± f(−c y) for f = a x^m + y.
        #[test]
        fn long_coefficients_are_found(a in long_integer(), c in long_integer(), m in 1u32..6) {
            let term = |e: [u32; 3], c: &Integer| (e, Rational::whole(c));
            let one = Integer::from(1);
            let f = SparsePolynomial::from_terms([term([m, 0, 0], &a), term([0, 1, 0], &one)]);
            let g = SparsePolynomial::from_terms([term([1, 0, 0], &one), term([0, 1, 0], &c)]);
            let power = (-c).pow(u64::from(m)) * a;
            let expected = SparsePolynomial::from_terms([term([0, m, 0], &power), term([0, 1, 0], &one)]);
            let found = resultant(&f, &g, 0, &Limits::none()).unwrap();
            prop_assert_eq!(found.primitive(), expected.primitive());
            // All primitive polynomials have a positive first coefficient, so its size is compared.
            let first = |f: &SparsePolynomial<3>| f.terms().next().map(|(_, c)| c.abs());
            prop_assert_eq!(first(&found), first(&expected));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]
        #[test]
        fn it_is_a_product_over_linear_factors(p in polynomial(), q in polynomial(), g in polynomial()) {
            // Res_x(x − p, g) = g(p, y, z) for p without x.
            let without_x = |f: &SparsePolynomial<3>| {
                SparsePolynomial::<3>::from_terms(f.terms().map(|(e, c)| ([0, e[1], e[2]], c.clone())))
            };
            let [p, q] = [p, q].map(|f| without_x(&f.primitive()));
            let at = |p: &SparsePolynomial<3>| {
                let mut sum = SparsePolynomial::zero();
                for (e, c) in g.primitive().terms() {
                    let rest = SparsePolynomial::from_terms([([0, e[1], e[2]], c.clone())]);
                    sum = sum.plus(&rest.times(&p.pow(e[0])));
                }
                sum
            };
            let linear = |p: &SparsePolynomial<3>| SparsePolynomial::variable(0).minus(p);
            let f = linear(&p).times(&linear(&q));
            let found = resultant(&f, &g, 0, &Limits::none()).unwrap();
            // Primitive polynomials have a positive first coefficient, so the signs do not matter.
            prop_assert_eq!(found.primitive(), at(&p).times(&at(&q)).primitive());
        }
    }
}
