//! Products and powers of polynomials. They are refused before they are computed if they are too large.
//!
//! A product is computed term by term or packed. A packed polynomial is univariate, by Kronecker's substitution: x, y and z
//! become powers of one variable, with strides that keep the exponents of the answer apart. A fast univariate product then
//! multiplies two such polynomials.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, Lcm, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::polynomial::Polynomial as _;

use super::budget::{MAX_DEGREE, MAX_TERMS};
use super::evaluate::Context;
use super::source::Span;
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, Ring, SparsePolynomial, total_degree};

type Polynomial = SparsePolynomial<3>;

/// Packed powers of polynomials with at most this many terms are computed coefficient by coefficient.
const FEW_TERMS: usize = 32;

/// The error for a degree beyond [`MAX_DEGREE`].
pub(super) fn degree_limit(cx: &Context<'_>, at: Span) -> Error {
    let limit = format!("a degree beyond {MAX_DEGREE} after expansion");
    cx.source.limit(at, limit)
}

/// The product `c x^e f`.
pub(super) fn times_term(
    cx: &mut Context<'_>,
    f: Polynomial,
    e: [u32; 3],
    c: &Rational,
    at: Span,
) -> Result<Polynomial> {
    if e == [0; 3] && *c == Rational::one() {
        return Ok(f);
    }
    if total_degree(&e) + f.degree().unwrap_or(0) > u64::from(MAX_DEGREE) {
        return Err(degree_limit(cx, at));
    }
    let count = f.len() as u64;
    let bits = coefficient_bits(&f) + c.bits();
    cx.budget.spend_products(count, bits, cx.source, at)?;
    cx.budget.spend_bits(count, bits, cx.source, at)?;
    Ok(Polynomial::from_terms(f.terms().map(|(g, d)| {
        ([e[0] + g[0], e[1] + g[1], e[2] + g[2]], c * d)
    })))
}

/// The product f·g.
pub(super) fn product(
    cx: &mut Context<'_>,
    f: &Polynomial,
    g: &Polynomial,
    at: Span,
) -> Result<Polynomial> {
    let (Some(df), Some(dg)) = (f.degree(), g.degree()) else {
        return Ok(Polynomial::zero());
    };
    if df + dg > u64::from(MAX_DEGREE) {
        return Err(degree_limit(cx, at));
    }
    let homogeneous = is_homogeneous(f) && is_homogeneous(g);
    let (mf, mg) = (largest_exponents(f), largest_exponents(g));
    let largest = std::array::from_fn(|i| mf[i] + mg[i]);
    let packing = Packing::new(largest, homogeneous.then_some(df + dg));
    let pairs = (f.len() as u64).saturating_mul(g.len() as u64);
    let terms = packing.terms(df + dg).min(pairs);
    let bits = coefficient_bits(f) + coefficient_bits(g) + 16;
    account(cx, terms, bits, at)?;
    if packing.is_better_than(pairs) {
        let (pf, pg) = (packing.pack(cx, f, at)?, packing.pack(cx, g, at)?);
        account(cx, packing.length, pf.bits() + pg.bits() + 64, at)?;
        let denominator = pf.denominator * pg.denominator;
        return Ok(packing.unpack(&(&pf.polynomial * &pg.polynomial), &denominator));
    }
    cx.budget.spend_products(pairs, bits, cx.source, at)?;
    Ok(f.times(g))
}

/// The power f^n for n ≥ 2.
pub(super) fn power(cx: &mut Context<'_>, f: &Polynomial, n: u32, at: Span) -> Result<Polynomial> {
    let Some(degree) = f.degree().map(|d| d * u64::from(n)) else {
        return Ok(Polynomial::zero());
    };
    if degree > u64::from(MAX_DEGREE) {
        return Err(degree_limit(cx, at));
    }
    let largest = largest_exponents(f).map(|e| e * n);
    let packing = Packing::new(largest, is_homogeneous(f).then_some(degree));
    let terms = packing.terms(degree).min(multisets(f.len(), n));
    let per_factor = coefficient_bits(f) + u64::from(f.len().ilog2()) + 1;
    account(cx, terms, per_factor * u64::from(n), at)?;
    // Term by term, the last squaring takes most of the time.
    let half = multisets(f.len(), n / 2).min(packing.terms(degree));
    if packing.is_better_than(half.saturating_mul(half)) {
        let packed = packing.pack(cx, f, at)?;
        let per_factor = packed.bits() + u64::from(f.len().ilog2()) + 1;
        account(
            cx,
            packing.length,
            per_factor.saturating_mul(u64::from(n)),
            at,
        )?;
        let powered = if f.len() <= FEW_TERMS {
            power_of_few_terms(&packed.polynomial, n)
        } else {
            (&packed.polynomial).pow(u64::from(n))
        };
        return Ok(packing.unpack(&powered, &packed.denominator.pow(u64::from(n))));
    }
    let mut result = f.clone();
    // For every bit of n after the highest one, the result is squared, and multiplied by f if the bit is set.
    for bit in (0..n.ilog2()).rev() {
        account_pairs(cx, &result, &result, at)?;
        result = result.squared();
        if n >> bit & 1 == 1 {
            account_pairs(cx, &result, f, at)?;
            result = result.times(f);
        }
    }
    Ok(result)
}

/// The power f^n for f ≠ 0, computed coefficient by coefficient in the memory of the answer.
///
/// Let f = x^s S with S = Σ_j c_j x^(e_j) and e_0 = 0. The power P = S^n has P_0 = c_0^n. The coefficient of x^(m − 1) in S
/// P' = n S' P gives `m c_0 P_m = Σ_(j ≥ 1) ((n + 1) e_j − m) c_j P_(m − e_j)` (Euler). The division by m c_0 is exact, because
/// S^n has integer coefficients.
///
/// Cost: one product for every pair of a coefficient of the answer and a term of f; coefficients that are 0 cost almost
/// nothing.
fn power_of_few_terms(f: &IntegerPolynomial, n: u32) -> IntegerPolynomial {
    let coefficients = f.coefficients_asc();
    let mut terms = coefficients.iter().enumerate().filter(|(_, c)| **c != 0);
    let (shift, first) = terms
        .next()
        .invariant("a polynomial that is not 0 has a term");
    let rest: Vec<(usize, &Integer)> = terms.map(|(e, c)| (e - shift, c)).collect();
    let times = n as usize;
    let length = (coefficients.len() - 1 - shift) * times + 1;
    let mut power = vec![Integer::ZERO; shift * times + length];
    let answer = &mut power[shift * times..];
    answer[0] = first.pow(u64::from(n));
    for m in 1..length {
        let mut sum = Integer::ZERO;
        for (e, c) in rest.iter().take_while(|(e, _)| *e <= m) {
            let before = &answer[m - e];
            if *before != 0 {
                let weight = Integer::from((times + 1) * e) - Integer::from(m);
                sum += *c * before * weight;
            }
        }
        if sum != 0 {
            answer[m] = sum.div_exact(first * Integer::from(m));
        }
    }
    IntegerPolynomial::from_coefficients_asc(power)
}

/// Accounts for a result of at most `terms` terms of about `bits` bits each, before it is computed.
fn account(cx: &mut Context<'_>, terms: u64, bits: u64, at: Span) -> Result<()> {
    if terms > MAX_TERMS as u64 {
        let limit = format!("more than {MAX_TERMS} terms after expansion");
        return Err(cx.source.limit(at, limit));
    }
    cx.budget.spend_bits(terms, bits, cx.source, at)
}

/// Accounts for a product that is computed term by term.
fn account_pairs(cx: &mut Context<'_>, f: &Polynomial, g: &Polynomial, at: Span) -> Result<()> {
    let pairs = (f.len() as u64).saturating_mul(g.len() as u64);
    let bits = coefficient_bits(f) + coefficient_bits(g);
    cx.budget.spend_products(pairs, bits, cx.source, at)
}

fn is_homogeneous(f: &Polynomial) -> bool {
    let degree = f.degree().unwrap_or(0);
    f.terms().all(|(e, _)| total_degree(e) == degree)
}

fn largest_exponents(f: &Polynomial) -> [u32; 3] {
    f.terms().fold([0; 3], |largest, (e, _)| {
        std::array::from_fn(|i| largest[i].max(e[i]))
    })
}

fn coefficient_bits(f: &Polynomial) -> u64 {
    f.terms().map(|(_, c)| c.bits()).max().unwrap_or(0)
}

/// The number C(n + k − 1, n) of ways to choose n of k elements with repetition; `u64::MAX` if it is above 2⁴⁰.
fn multisets(k: usize, n: u32) -> u64 {
    let (k, n) = (k as u64, u64::from(n));
    let (small, large) = (n.min(k - 1), n.max(k - 1));
    let mut count: u64 = 1;
    for i in 1..=small {
        // C(large + i, i) = C(large + i − 1, i − 1) (large + i)/i, exactly.
        let Some(next) = count.checked_mul(large + i) else {
            return u64::MAX;
        };
        count = next / i;
        if count > 1 << 40 {
            return u64::MAX;
        }
    }
    count
}

/// Kronecker's substitution for an answer with known largest exponents.
struct Packing {
    /// The total degree of the answer, if it is homogeneous. Then one variable is omitted, because its exponent follows from
    /// the others.
    homogeneous: Option<u64>,
    omitted: Option<usize>,
    strides: [u64; 3],
    length: u64,
    variables: u64,
}

/// A packed polynomial with integer coefficients, and the common denominator by which they are divided.
struct Packed {
    polynomial: IntegerPolynomial,
    denominator: Integer,
}

impl Packed {
    fn bits(&self) -> u64 {
        let coefficients = self.polynomial.coefficients_asc().iter();
        coefficients
            .map(SignificantBits::significant_bits)
            .max()
            .unwrap_or(0)
    }
}

impl Packing {
    fn new(largest: [u32; 3], homogeneous: Option<u64>) -> Self {
        let omitted = homogeneous.and_then(|_| (0..3).max_by_key(|&i| largest[i]));
        let mut strides = [0; 3];
        let mut length: u64 = 1;
        let mut variables = 0;
        for i in 0..3 {
            if Some(i) != omitted && largest[i] > 0 {
                strides[i] = length;
                length = length.saturating_mul(u64::from(largest[i]) + 1);
                variables += 1;
            }
        }
        Self {
            homogeneous,
            omitted,
            strides,
            length,
            variables,
        }
    }

    /// The largest possible number of terms of the answer, which has the given degree.
    fn terms(&self, degree: u64) -> u64 {
        // There are C(degree + v, v) monomials in v free variables.
        let free = usize::try_from(self.variables).invariant("there are at most three variables");
        let dense = multisets(
            free + 1,
            u32::try_from(degree).invariant("the degree is within the limit"),
        );
        dense.min(self.length)
    }

    /// Whether a packed product is faster than this many products of terms.
    fn is_better_than(&self, pairs: u64) -> bool {
        self.length <= MAX_TERMS as u64 && self.length <= pairs
    }

    fn pack(&self, cx: &mut Context<'_>, f: &Polynomial, at: Span) -> Result<Packed> {
        let mut common = Integer::ONE;
        for (_, c) in f.terms() {
            if !c.is_integer() {
                let d = c.denominator();
                common = Integer::from(common.unsigned_abs_ref().lcm(d.unsigned_abs_ref()));
                cx.budget
                    .spend_bits(1, common.significant_bits(), cx.source, at)?;
            }
        }
        let scale = Rational::whole(&common);
        let mut coefficients = Vec::new();
        for (e, c) in f.terms() {
            let index = (0..3)
                .map(|i| u64::from(e[i]) * self.strides[i])
                .sum::<u64>();
            let index = usize::try_from(index).invariant("a packed polynomial fits in memory");
            if coefficients.len() <= index {
                coefficients.resize(index + 1, Integer::ZERO);
            }
            coefficients[index] = (c * &scale).numerator();
        }
        Ok(Packed {
            polynomial: IntegerPolynomial::from_coefficients_asc(coefficients),
            denominator: common,
        })
    }

    fn unpack(&self, packed: &IntegerPolynomial, denominator: &Integer) -> Polynomial {
        let inverse = Rational::whole(denominator)
            .recip()
            .invariant("a denominator is not 0");
        let coefficients = packed.coefficients_asc().iter().enumerate();
        Polynomial::from_terms(
            coefficients
                .filter(|(_, c)| **c != 0)
                .map(|(index, c)| (self.exponents(index as u64), Rational::whole(c) * &inverse)),
        )
    }

    fn exponents(&self, index: u64) -> [u32; 3] {
        let mut exponents = [0; 3];
        let mut rest = index;
        // The variable with the largest stride comes first.
        for i in (0..3).rev().filter(|&i| self.strides[i] > 0) {
            exponents[i] =
                u32::try_from(rest / self.strides[i]).invariant("exponents are below 2^32");
            rest %= self.strides[i];
        }
        if let (Some(degree), Some(i)) = (self.homogeneous, self.omitted) {
            let left = degree.saturating_sub(total_degree(&exponents));
            exponents[i] = u32::try_from(left).invariant("exponents are below 2^32");
        }
        exponents
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The power that is computed coefficient by coefficient equals the power by products; coefficients that cancel and
        /// gaps are included.
        #[test]
        fn powers_of_few_terms_are_powers(c in prop::collection::vec(prop_oneof![3 => Just(0i64), 2 => -9i64..10, 1 => any::<i64>()], 1..20), n in 2u32..12) {
            let f = IntegerPolynomial::from_coefficients_asc(c.into_iter().map(Integer::from).collect());
            prop_assume!(!f.coefficients_asc().is_empty());
            prop_assert_eq!(power_of_few_terms(&f, n), (&f).pow(u64::from(n)));
        }
    }
}
