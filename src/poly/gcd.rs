//! Greatest common divisors, exact division and squarefree decomposition over the integers.

use std::borrow::Cow;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{CanonicalPrimitivePart, DivRem, Gcd, Mod};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::{Derivative, Polynomial};

use super::IntegerPolynomial;
use crate::error::Invariant;
use crate::modular::{Images, PrimeField, large_primes};

/// The number of primes by whose product the long coefficients are divided at once. With 24, the gcd of degree 10 of
/// polynomials of 5000 bits and degree 20 takes 2.7 ms; with 8 it takes 3.2 ms.
const GROUP: usize = 24;

/// The primitive part, with a positive leading coefficient; 0 for 0.
#[must_use]
pub(crate) fn primitive_part(f: &IntegerPolynomial) -> IntegerPolynomial {
    f.canonical_primitive_part()
}

/// The greatest common divisor of the primitive parts: primitive, with positive leading
/// coefficient; 1 if the two are coprime.
///
/// gcd(f, 0) is the primitive part of f, and gcd(0, 0) is 0.
///
/// Method: images modulo 31-bit primes are combined until one more prime changes nothing. Exact division of f and g then proves
/// the candidate.
///
/// Cost, for degrees ≤ d and coefficients of ≤ b bits: O(d² + d·b) word operations for each prime. Coprime inputs take one
/// prime, unless it is unlucky. Other inputs take about one prime for each half word of the product of leading coefficient and
/// gcd, one more prime, and two exact divisions.
///
/// ```
/// use std::str::FromStr;
/// use stellate::poly::{IntegerPolynomial, polynomial_gcd};
/// let f = IntegerPolynomial::from_str("x^2-1").unwrap();
/// let g = IntegerPolynomial::from_str("2*x^2+4*x+2").unwrap();
/// assert_eq!(polynomial_gcd(&f, &g).to_string(), "x+1");
/// let zero = IntegerPolynomial::default();
/// assert_eq!(polynomial_gcd(&g, &zero).to_string(), "x^2+2*x+1");
/// assert_eq!(polynomial_gcd(&zero, &zero), zero);
/// ```
#[must_use]
pub fn polynomial_gcd(f: &IntegerPolynomial, g: &IntegerPolynomial) -> IntegerPolynomial {
    let (f, g) = (primitive_part(f), primitive_part(g));
    let (Some(a), Some(b)) = (f.coefficients_asc().last(), g.coefficients_asc().last()) else {
        return if g.coefficients_asc().is_empty() {
            f
        } else {
            g
        };
    };
    let lead = Integer::from(a.unsigned_abs_ref().gcd(b.unsigned_abs_ref()));
    let mut combined: Option<Images> = None;
    let mut all = large_primes();
    // One prime is enough for coprime polynomials.
    let mut count = 1;
    loop {
        let primes: Vec<u64> = all.by_ref().take(count).collect();
        let (f_short, g_short) = (shortened(&f, &primes), shortened(&g, &primes));
        for prime in primes {
            let field = PrimeField::new(prime);
            let (fp, gp) = (field.reduce(&f_short), field.reduce(&g_short));
            // A prime that divides a leading coefficient may give too large a gcd.
            if fp.len() != f.coefficients_asc().len() || gp.len() != g.coefficients_asc().len() {
                continue;
            }
            let mut image = field.gcd(fp, gp);
            if image.len() <= 1 {
                return IntegerPolynomial::one();
            }
            let lead_mod = field.reduce_integer(&lead);
            for c in &mut image {
                *c = field.mul(*c, lead_mod);
            }
            let stable = match &mut combined {
                Some(images) if images.residues.len() < image.len() => false, // unlucky prime
                Some(images) if images.residues.len() == image.len() => images.add(&image, prime),
                _ => {
                    combined = Some(Images::new(&image, prime));
                    false
                }
            };
            if stable && let Some(images) = &combined {
                let candidate = primitive_part(&images.balanced());
                if divide_exactly(&f, &candidate).is_some()
                    && divide_exactly(&g, &candidate).is_some()
                {
                    return candidate;
                }
            }
        }
        count = GROUP;
    }
}

/// The polynomial, with its coefficients reduced modulo the product of the primes if they are longer than it.
fn shortened<'a>(f: &'a IntegerPolynomial, primes: &[u64]) -> Cow<'a, IntegerPolynomial> {
    let longest = f.coefficients_asc().iter().map(|c| c.significant_bits());
    if primes.len() == 1 || longest.max().unwrap_or(0) <= 32 * GROUP as u64 {
        return Cow::Borrowed(f);
    }
    let product = primes
        .iter()
        .fold(Integer::ONE, |m, &p| m * Integer::from(p));
    let coefficients = f.coefficients_asc().iter().map(|c| c.mod_op(&product));
    Cow::Owned(IntegerPolynomial::from_coefficients_asc(
        coefficients.collect(),
    ))
}

/// The quotient `f / g`; `None` if g does not divide f over the integers.
///
/// ```
/// use std::str::FromStr;
/// use stellate::poly::{IntegerPolynomial, divide_exactly};
/// let f = IntegerPolynomial::from_str("x^2-1").unwrap();
/// let g = IntegerPolynomial::from_str("x-1").unwrap();
/// assert_eq!(divide_exactly(&f, &g).unwrap().to_string(), "x+1");
/// assert_eq!(divide_exactly(&g, &f), None);
/// ```
#[must_use]
pub fn divide_exactly(f: &IntegerPolynomial, g: &IntegerPolynomial) -> Option<IntegerPolynomial> {
    let divisor = g.coefficients_asc();
    let lead = divisor.last()?;
    let mut rest = f.coefficients_asc().to_vec();
    if rest.is_empty() {
        return Some(IntegerPolynomial::ZERO);
    }
    let mut quotient = vec![Integer::ZERO; (rest.len() + 1).checked_sub(divisor.len())?];
    for k in (0..quotient.len()).rev() {
        let top = k + divisor.len() - 1;
        if rest[top] == 0 {
            continue;
        }
        let (q, r) = std::mem::take(&mut rest[top]).div_rem(lead);
        if r != 0 {
            return None;
        }
        for (i, d) in divisor[..divisor.len() - 1].iter().enumerate() {
            rest[k + i] -= d * &q;
        }
        quotient[k] = q;
    }
    rest.iter()
        .all(|c| *c == 0)
        .then(|| IntegerPolynomial::from_coefficients_asc(quotient))
}

/// Yun's squarefree decomposition: the non-constant `g_m` (primitive, pairwise coprime,
/// squarefree) with `f = c ∏ g_m^m`, as pairs `(m, g_m)`.
///
/// A squarefree f costs one modular gcd.
///
/// ```
/// use std::str::FromStr;
/// use stellate::poly::{IntegerPolynomial, squarefree_decomposition};
/// let f = IntegerPolynomial::from_str("x^4-2*x^3+2*x-1").unwrap(); // (x−1)³(x+1)
/// let parts = squarefree_decomposition(&f);
/// assert_eq!(format!("{parts:?}"), "[(1, x+1), (3, x-1)]");
/// ```
#[must_use]
pub fn squarefree_decomposition(f: &IntegerPolynomial) -> Vec<(usize, IntegerPolynomial)> {
    let f = primitive_part(f);
    if f.coefficients_asc().len() <= 1 {
        return Vec::new();
    }
    let derivative = (&f).derivative();
    let repeated = polynomial_gcd(&f, &derivative);
    if repeated.coefficients_asc().len() <= 1 {
        return vec![(1, f)];
    }
    let exact = |a: &IntegerPolynomial, b: &IntegerPolynomial| {
        divide_exactly(a, b).invariant("a gcd of primitive polynomials divides both")
    };
    let mut parts = Vec::new();
    let mut w = exact(&f, &repeated);
    let mut y = exact(&derivative, &repeated);
    let mut multiplicity = 1;
    while w.coefficients_asc().len() > 1 {
        let z = y - (&w).derivative();
        let part = if z.coefficients_asc().is_empty() {
            primitive_part(&w)
        } else {
            polynomial_gcd(&w, &z)
        };
        w = exact(&w, &part);
        y = if z.coefficients_asc().is_empty() {
            z
        } else {
            exact(&z, &part)
        };
        if part.coefficients_asc().len() > 1 {
            parts.push((multiplicity, part));
        }
        multiplicity += 1;
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn polynomial() -> impl Strategy<Value = IntegerPolynomial> {
        prop::collection::vec(-50i64..50, 1..7).prop_map(|c| {
            IntegerPolynomial::from_coefficients_asc(c.into_iter().map(Integer::from).collect())
        })
    }

    /// Coefficients of up to 700 bits: runs of equal bits, powers of two and their neighbours, primes that are used and their
    /// multiples, which make them unlucky, and random ones.
    fn long_polynomial(terms: std::ops::Range<usize>) -> impl Strategy<Value = IntegerPolynomial> {
        let limb = prop_oneof![Just(0), Just(u64::MAX), any::<u64>()];
        let runs = prop::collection::vec(limb, 0..12)
            .prop_map(|limbs| Integer::from(malachite::Natural::from_owned_limbs_asc(limbs)));
        let power = (0_u64..700, -1_i64..2)
            .prop_map(|(k, more)| (Integer::from(1) << k) + Integer::from(more));
        let unlucky = (0_usize..12, 1_i64..4).prop_map(|(k, c)| {
            let prime = large_primes().take(k + 1).last().expect("there are primes");
            Integer::from(prime) * Integer::from(c)
        });
        let size = prop_oneof![runs, power, unlucky, (0_i64..50).prop_map(Integer::from)];
        let signed = (size, any::<bool>()).prop_map(|(c, negative)| if negative { -c } else { c });
        prop::collection::vec(signed, terms).prop_map(IntegerPolynomial::from_coefficients_asc)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(128))]
        /// gcd(h·a, h·b) is the primitive part of h times gcd(a, b).
        #[test]
        fn the_gcd_of_multiples_is_the_multiple_of_the_gcd(
            f in long_polynomial(1..7), g in long_polynomial(1..7), h in long_polynomial(1..6),
        ) {
            let found = polynomial_gcd(&(&f * &h), &(&g * &h));
            prop_assert_eq!(found, primitive_part(&(polynomial_gcd(&f, &g) * h)));
        }

        /// Products of linear factors with long roots, so that the common factors are known.
        #[test]
        fn common_linear_factors_are_found(
            roots in prop::collection::btree_map(0_i64..400, (0_usize..3, 0_usize..3), 1..6), bits in 0_u64..500,
        ) {
            // The linear factors are pairwise coprime: their roots are consecutive integers with this number of bits.
            let linear = |root: &i64| {
                let c = (Integer::from(1) << bits) + Integer::from(*root);
                IntegerPolynomial::from_coefficients_asc(vec![-c, Integer::from(1)])
            };
            let product = |exponent: &dyn Fn((usize, usize)) -> usize| {
                roots.iter().fold(IntegerPolynomial::one(), |product, (root, both)| {
                    (0..exponent(*both)).fold(product, |product, _| product * linear(root))
                })
            };
            let (f, g) = (product(&|(a, _)| a), product(&|(_, b)| b));
            prop_assert_eq!(polynomial_gcd(&f, &g), product(&|(a, b)| a.min(b)));
            let parts = squarefree_decomposition(&f);
            for m in 1..3 {
                let expected = product(&|(a, _)| usize::from(a == m));
                let found = parts.iter().find(|(k, _)| *k == m).map_or_else(IntegerPolynomial::one, |(_, part)| part.clone());
                prop_assert_eq!(found, expected);
            }
        }
    }

    proptest! {
        #[test]
        fn the_gcd_is_a_common_divisor_that_holds_every_common_factor(f in polynomial(), g in polynomial(), h in polynomial()) {
            let (a, b) = (&f * &h, &g * &h);
            prop_assume!(!a.coefficients_asc().is_empty() && !b.coefficients_asc().is_empty());
            let d = polynomial_gcd(&a, &b);
            prop_assert!(divide_exactly(&primitive_part(&a), &d).is_some());
            prop_assert!(divide_exactly(&primitive_part(&b), &d).is_some());
            prop_assert!(divide_exactly(&d, &primitive_part(&h)).is_some());
        }

        #[test]
        fn the_squarefree_parts_multiply_back(f in polynomial(), g in polynomial(), h in polynomial()) {
            let product = &f * (&g * &g) * (&h * &h * &h);
            prop_assume!(!product.coefficients_asc().is_empty());
            let parts = squarefree_decomposition(&product);
            let mut back = IntegerPolynomial::one();
            for (m, part) in &parts {
                prop_assert_eq!(polynomial_gcd(part, &part.derivative()), IntegerPolynomial::one());
                for _ in 0..*m {
                    back *= part;
                }
            }
            prop_assert_eq!(back, primitive_part(&product));
        }
    }
}
