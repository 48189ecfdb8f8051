//! Resultants of polynomials in three variables.

use malachite::Integer;

use super::SparsePolynomial;
use super::eliminate::{as_f64, resultant_mod};
use super::modular::{
    ABOVE_PRIMES, Images, interpolate, power_mod, previous_prime, reduce_integer,
};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;

/// Products of residues beyond which the work is refused: some seconds.
const MAX_WORK: f64 = 3e9;

/// The resultant of the primitive parts of f and g with respect to the variable v, exactly.
///
/// By evaluation on a grid, Euclid modulo 31-bit primes, interpolation, and Chinese remainders up to the product
/// of the 1-norms of the rows of Sylvester's matrix.
///
/// # Errors
/// [`Error::Limit`] if that is too much work; those of `limits`.
pub(crate) fn resultant(
    f: &SparsePolynomial<3>,
    g: &SparsePolynomial<3>,
    v: usize,
    limits: &Limits,
) -> Result<SparsePolynomial<3>> {
    let [f, g] = [f, g].map(Integers::new);
    let [u, w] = [(v + 1) % 3, (v + 2) % 3];
    let (m, n) = (f.degrees[v], g.degrees[v]);
    let [in_u, in_w] = [u, w].map(|k| n * f.degrees[k] + m * g.degrees[k]);
    let bits = as_f64(n) * f.norm_bits() + as_f64(m) * g.norm_bits();
    let cost = (m + 1) * (n + 1) + f.terms.len() + g.terms.len();
    let work = (bits / 30.9 + 1.0) * as_f64((in_u + 1) * (in_w + 1)) * as_f64(cost);
    if work > MAX_WORK {
        return Err(Error::limit(format!(
            "a resultant of degrees {in_u} and {in_w}, about {work:.0e} operations (at most {MAX_WORK:.0e} are made)"
        )));
    }
    let mut combined: Option<Images> = None;
    let mut prime = ABOVE_PRIMES;
    let mut known_bits = 0.0;
    while known_bits < bits + 2.0 {
        limits.check()?;
        prime = previous_prime(prime);
        let mut columns = Vec::new();
        for a in 0..=in_u as u64 {
            let values = (0..=in_w as u64).map(|b| {
                let [f, g] = [&f, &g].map(|p| p.in_v(v, [(u, a), (w, b)], prime));
                resultant_mod(f, g, prime)
            });
            columns.push(interpolate(values.collect(), prime));
        }
        let rows = (0..=in_w).map(|j| columns.iter().map(|c| c[j]).collect());
        let image: Vec<u64> = rows.flat_map(|row| interpolate(row, prime)).collect();
        match &mut combined {
            Some(images) => {
                images.add(&image, prime);
            }
            None => combined = Some(Images::new(&image, prime)),
        }
        known_bits += as_f64(usize::try_from(prime).unwrap_or(2)).log2();
    }
    let flat = combined.map(|images| images.balanced()).unwrap_or_default();
    let narrow = |e: usize| u32::try_from(e).unwrap_or(u32::MAX);
    let terms = flat
        .coefficients_asc()
        .iter()
        .enumerate()
        .map(|(index, c)| {
            let mut e = [0; 3];
            e[u] = narrow(index % (in_u + 1));
            e[w] = narrow(index / (in_u + 1));
            (e, Rational::from(c))
        });
    Ok(SparsePolynomial::from_terms(terms))
}

struct Integers {
    terms: Vec<([u32; 3], Integer)>,
    degrees: [usize; 3],
}

impl Integers {
    fn new(f: &SparsePolynomial<3>) -> Self {
        let primitive = f.primitive();
        let terms = primitive.terms().map(|(e, c)| (*e, c.numerator()));
        let degrees = f.terms().fold([0; 3], |d: [usize; 3], (e, _)| {
            std::array::from_fn(|v| d[v].max(e[v] as usize))
        });
        Self {
            terms: terms.collect(),
            degrees,
        }
    }

    /// log₂ of the sum of the absolute values, rounded up.
    fn norm_bits(&self) -> f64 {
        use malachite::base::num::logic::traits::SignificantBits;
        let magnitudes = self.terms.iter().map(|(_, c)| c.unsigned_abs_ref());
        let sum = magnitudes.sum::<malachite::Natural>();
        as_f64(usize::try_from(sum.significant_bits()).unwrap_or(usize::MAX))
    }

    /// As a polynomial in v of its full formal degree, the other variables having values.
    fn in_v(&self, v: usize, [(u, a), (w, b)]: [(usize, u64); 2], prime: u64) -> Vec<u64> {
        let mut coefficients = vec![0; self.degrees[v] + 1];
        for (e, c) in &self.terms {
            let monomial = power_mod(a, e[u].into(), prime) * power_mod(b, e[w].into(), prime);
            let value = &mut coefficients[e[v] as usize];
            *value = (*value + reduce_integer(c, prime) * (monomial % prime)) % prime;
        }
        coefficients
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::Ring;
    use proptest::prelude::*;

    fn polynomial() -> impl Strategy<Value = SparsePolynomial<3>> {
        let term = ([0u32..3, 0u32..3, 0u32..2], -9i64..9);
        prop::collection::vec(term, 1..5).prop_map(|terms| {
            SparsePolynomial::from_terms(terms.into_iter().map(|(e, c)| (e, Rational::from(c))))
        })
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
            // Primitive parts have positive first terms: up to sign.
            prop_assert_eq!(found.primitive(), at(&p).times(&at(&q)).primitive());
        }
    }
}
