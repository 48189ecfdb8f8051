//! Greatest common divisors, contents and squarefree parts in several variables.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Gcd, Mod};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use crate::error::{Invariant, Result};
use crate::limits::Limits;
use crate::modular::{PrimeField, SplitMix, trimmed};
use crate::poly::{IntegerPolynomial, IntegerTerms, polynomial_gcd};

/// The prime of quick tests, 2³¹ − 1.
pub(super) const QUICK_PRIME: u64 = (1 << 31) - 1;

/// The greatest common divisor, including the integer content, with a positive first coefficient.
///
/// First, images in one variable modulo a prime may prove that the polynomials are coprime. If they do not, the heuristic gcd
/// of Char, Geddes & Gonnet is used (*Algorithms for Computer Algebra*, Theorem 7.7): one variable is evaluated at a large
/// integer, the gcd is computed there, its digits in this base are taken as coefficients, and division proves the result. After
/// a failure a larger integer is tried.
///
/// # Errors
/// Those of `limits`.
pub(super) fn gcd(
    f: &IntegerTerms<3>,
    g: &IntegerTerms<3>,
    limits: &Limits,
) -> Result<IntegerTerms<3>> {
    if f.is_zero() || g.is_zero() {
        let other = if f.is_zero() { g } else { f };
        let sign = Integer::from(if other.signed_content() < 0 { -1 } else { 1 });
        return Ok(other.clone().scaled(&sign));
    }
    let (a, b) = (f.signed_content(), g.signed_content());
    let content = Integer::from(a.unsigned_abs_ref().gcd(b.unsigned_abs_ref()));
    let (f, g) = (f.clone().primitive(), g.clone().primitive());
    Ok(primitive_gcd(&f, &g, limits)?.scaled(&content))
}

fn primitive_gcd(
    f: &IntegerTerms<3>,
    g: &IntegerTerms<3>,
    limits: &Limits,
) -> Result<IntegerTerms<3>> {
    let (df, dg) = (f.degrees(), g.degrees());
    let shared: Vec<usize> = (0..3).filter(|&v| df[v] > 0 && dg[v] > 0).collect();
    if shared.iter().all(|&v| image_is_coprime(f, g, v)) {
        return Ok(IntegerTerms::constant(Integer::ONE));
    }
    if f == g {
        return Ok(f.clone());
    }
    let used: Vec<usize> = (0..3).filter(|&v| df[v] > 0 || dg[v] > 0).collect();
    if let [v] = used[..] {
        let common = polynomial_gcd(&f.to_univariate(v), &g.to_univariate(v));
        return Ok(IntegerTerms::from_univariate(&common, v));
    }
    let Some(&v) = used.iter().min_by_key(|&&v| df[v].max(dg[v])) else {
        return Ok(IntegerTerms::constant(Integer::ONE));
    };
    let mut point = f.height().min(g.height()) * Integer::from(2) + Integer::from(29);
    let mut failures = 0;
    loop {
        limits.check()?;
        let image = gcd(&f.evaluated(v, &point), &g.evaluated(v, &point), limits)?;
        let candidate = from_digits(&image, v, &point).primitive();
        if f.divided_by(&candidate).is_some() && g.divided_by(&candidate).is_some() {
            return Ok(candidate);
        }
        failures += 1;
        // The integer grows by a ratio without special properties. After several failures it is squared, so that the search
        // ends soon.
        point = if failures < 6 {
            point * Integer::from(73_794) / Integer::from(27_011)
        } else {
            &point * &point + Integer::from(1)
        };
    }
}

/// The polynomial in v whose value at `v = base` is `image`, with coefficients of absolute value at most base/2.
fn from_digits(image: &IntegerTerms<3>, v: usize, base: &Integer) -> IntegerTerms<3> {
    let mut terms = Vec::new();
    for (e, c) in image.iter() {
        let mut rest = c.clone();
        let mut k = 0;
        while rest != 0 {
            let mut digit = (&rest).mod_op(base);
            if &digit << 1u64 > *base {
                digit -= base;
            }
            rest = (rest - &digit) / base;
            let mut exponents = *e;
            exponents[v] = k;
            terms.push((exponents, digit));
            k += 1;
        }
    }
    IntegerTerms::new(terms)
}

fn random_point() -> [u64; 3] {
    let mut random = SplitMix(0xacc0);
    std::array::from_fn(|_| random.next() % QUICK_PRIME)
}

/// Whether an image modulo a prime proves that v does not occur in the gcd.
fn image_is_coprime(f: &IntegerTerms<3>, g: &IntegerTerms<3>, v: usize) -> bool {
    let field = PrimeField::new(QUICK_PRIME);
    let point = random_point();
    let (a, b) = (
        trimmed(f.image(v, &point, &field)),
        trimmed(g.image(v, &point, &field)),
    );
    let full = |image: &[u64], f: &IntegerTerms<3>| image.len() == f.degrees()[v] as usize + 1;
    // The leading coefficient of the gcd divides both leading coefficients, so it is enough that one of them is not 0.
    (full(&a, f) || full(&b, g)) && field.gcd(a, b).len() == 1
}

/// The gcd of the coefficients of the powers of v, primitive, and f divided by it.
pub(super) fn content_in(
    f: &IntegerTerms<3>,
    v: usize,
    limits: &Limits,
) -> Result<(IntegerTerms<3>, IntegerTerms<3>)> {
    let mut rows: Vec<IntegerTerms<3>> = f.coefficients_in(v).into_values().collect();
    rows.sort_unstable_by_key(IntegerTerms::cells);
    let mut content = IntegerTerms::constant(Integer::ZERO);
    for row in &rows {
        content = gcd(&content, row, limits)?;
        if content.is_constant() {
            return Ok((IntegerTerms::constant(Integer::ONE), f.clone()));
        }
    }
    let content = content.primitive();
    let rest = f
        .divided_by(&content)
        .invariant("a content divides its polynomial");
    Ok((content, rest))
}

/// Whether an image modulo a prime proves that f is squarefree; f must be primitive in v.
fn image_is_squarefree(f: &IntegerTerms<3>, v: usize) -> bool {
    let field = PrimeField::new(QUICK_PRIME);
    let image = trimmed(f.image(v, &random_point(), &field));
    image.len() == f.degrees()[v] as usize + 1 && field.is_squarefree(&image)
}

/// Yun's squarefree decomposition of an f that is primitive in v: its parts and their multiplicities.
///
/// # Errors
/// Those of `limits`.
pub(super) fn squarefree_parts(
    f: &IntegerTerms<3>,
    v: usize,
    limits: &Limits,
) -> Result<Vec<(usize, IntegerTerms<3>)>> {
    if image_is_squarefree(f, v) {
        return Ok(vec![(1, f.clone())]);
    }
    if let [only] = f.used()[..] {
        let parts = crate::poly::squarefree_decomposition(&f.to_univariate(only));
        return Ok(parts
            .into_iter()
            .map(|(m, part)| (m, IntegerTerms::from_univariate(&part, only)))
            .collect());
    }
    let derivative = f.derivative(v);
    let repeated = gcd(f, &derivative, limits)?;
    let exact =
        |a: &IntegerTerms<3>, b: &IntegerTerms<3>| a.divided_by(b).invariant("a gcd divides");
    let mut w = exact(f, &repeated);
    let mut y = exact(&derivative, &repeated);
    let mut parts = Vec::new();
    let mut multiplicity = 1;
    while w.degrees()[v] > 0 {
        limits.check()?;
        let z = y.difference(&w.derivative(v));
        let part = gcd(&w, &z, limits)?.primitive();
        w = exact(&w, &part);
        y = if z.is_zero() { z } else { exact(&z, &part) };
        if !part.is_constant() {
            parts.push((multiplicity, part));
        }
        multiplicity += 1;
    }
    Ok(parts)
}

/// The largest form in the two given variables that divides a polynomial: the gcd of its homogeneous parts, each of which is
/// treated as a univariate polynomial. Neither variable may divide f.
pub(super) fn form_content(f: &IntegerTerms<3>, u: usize, v: usize) -> IntegerTerms<3> {
    let mut parts = std::collections::BTreeMap::<u32, Vec<(u32, Integer)>>::new();
    for (e, c) in f.iter() {
        parts
            .entry(e[u] + e[v])
            .or_default()
            .push((e[u], c.clone()));
    }
    let mut common = IntegerPolynomial::ZERO;
    for part in parts.into_values() {
        let degree = part.iter().map(|(k, _)| *k).max();
        let degree = degree.invariant("a part has a term") as usize;
        let mut coefficients = vec![Integer::ZERO; degree + 1];
        for (k, c) in part {
            coefficients[k as usize] = c;
        }
        let part = IntegerPolynomial::from_coefficients_asc(coefficients);
        common = polynomial_gcd(&common, &part);
        if common.coefficients_asc().len() == 1 {
            break;
        }
    }
    let degree =
        u32::try_from(common.coefficients_asc().len() - 1).invariant("exponents are below 2^32");
    IntegerTerms::from_univariate(&common, u).map_exponents(|e| {
        let mut form: [u32; 3] = [0; 3];
        form[u] = e[u];
        form[v] = degree - e[u];
        form
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::any_integer_terms as terms;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_gcd_divides_and_holds_every_common_factor(f in terms(), g in terms(), h in terms()) {
            let limits = Limits::none();
            let (a, b) = (f.product(&h), g.product(&h));
            prop_assume!(!a.is_zero() && !b.is_zero());
            let d = gcd(&a, &b, &limits).unwrap();
            prop_assert!(d.divided_by(&h).is_some());
            let (p, q) = (a.divided_by(&d).unwrap(), b.divided_by(&d).unwrap());
            let rest = gcd(&p, &q, &limits).unwrap();
            prop_assert_eq!(rest, IntegerTerms::constant(Integer::ONE));
        }

        #[test]
        fn squarefree_parts_multiply_back(f in terms(), g in terms()) {
            let limits = Limits::none();
            let product = f.product(&f).product(&g).primitive();
            prop_assume!(!product.is_zero() && product.degrees()[0] > 0);
            let (_, rest) = content_in(&product, 0, &limits).unwrap();
            let parts = squarefree_parts(&rest, 0, &limits).unwrap();
            let back = parts
                .iter()
                .fold(IntegerTerms::constant(Integer::ONE), |p, (m, part)| p.product(&part.pow(*m)));
            prop_assert_eq!(back.primitive(), rest.primitive());
        }
    }
}
