//! A check of polynomials that were computed from residues: their value at one more point modulo one more prime, 2^64 − 2^32 +
//! 1.
//!
//! Lemma 1. A polynomial of degree d that is not 0 modulo p has at most d zeros modulo p. So a wrong result is noticed unless
//! all its errors are multiples of p, or the point, which is fixed, is one of d among 2^64.
//! The check guards against defects of the program; the correctness of the result rests on the bounds of
//! [`lifting`](super::lifting).
//! Laws: `values_are_those_of_the_integers`, `one_wrong_bit_is_noticed`.
//!
//! Modulo p, 2^64 is 2^32 − 1, 2^96 is −1 and 2^192 is 1: every third limb has the same weight.

use std::sync::LazyLock;

use malachite::Integer;

use crate::bigint::FlatPolynomial;
use crate::bigint::limbs::is_negative;
use crate::parallel;

/// The prime p.
const P: u64 = 0xFFFF_FFFF_0000_0001;

/// The residue of 2^64 modulo the prime.
const EPSILON: u64 = 0xFFFF_FFFF;

/// The point T of the check, which is a residue without special properties.
const POINT: Extra = Extra(0x9e37_79b9_7f4a_7c15);

/// A residue modulo the prime, in [0, p).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Extra(u64);

impl Extra {
    const ZERO: Self = Self(0);
    const ONE: Self = Self(1);

    /// The residue of a number below 2^128, which is x0 + x1 2^64 + x2 2^96 with x1, x2 < 2^32, so it is x0 − x2 + x1 (2^32 −
    /// 1).
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "its two halves")]
    fn new(x: u128) -> Self {
        let (low, high) = (x as u64, (x >> 64) as u64);
        let (mut sum, borrow) = low.overflowing_sub(high >> 32);
        if borrow {
            // The sum is 2^64 too large, and at least 2^64 − 2^32.
            sum -= EPSILON;
        }
        let (mut sum, carry) = sum.overflowing_add((high & EPSILON) * EPSILON);
        if carry {
            // The sum is 2^64 too small, and at most 2^64 − 2^33.
            sum += EPSILON;
        }
        Self(if sum >= P { sum - P } else { sum })
    }

    #[inline]
    pub(crate) fn plus(self, other: Self) -> Self {
        Self::new(u128::from(self.0) + u128::from(other.0))
    }

    #[inline]
    pub(crate) fn minus(self, other: Self) -> Self {
        Self::new(u128::from(self.0) + u128::from(P - other.0))
    }

    #[inline]
    pub(crate) fn times(self, other: Self) -> Self {
        Self::new(u128::from(self.0) * u128::from(other.0))
    }

    pub(crate) fn power(self, mut exponent: u64) -> Self {
        let (mut power, mut square) = (Self::ONE, self);
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = power.times(square);
            }
            square = square.times(square);
            exponent >>= 1;
        }
        power
    }

    /// The inverse 1/self of a residue that is not 0.
    fn inverse(self) -> Self {
        self.power(P - 2)
    }

    /// The residue of a natural number that is given by its limbs.
    #[inline]
    fn of_natural(limbs: &[u64]) -> Self {
        const LOW: u128 = (1 << 64) - 1;
        let (threes, top) = limbs.as_chunks::<3>();
        let mut sums = [0_u128; 3];
        for (sum, limb) in sums.iter_mut().zip(top) {
            *sum = u128::from(*limb);
        }
        for three in threes {
            for (sum, limb) in sums.iter_mut().zip(three) {
                *sum += u128::from(*limb);
            }
        }
        // The number a + b 2^64 + c 2^128 is a + b (2^32 − 1) − c 2^32 modulo p; each of the three is below 2^97 for fewer than
        // 2^64 limbs.
        let [a, b, c] = sums;
        let (a, b, c) = (
            (a & LOW) + (c >> 64),
            (b & LOW) + (a >> 64),
            (c & LOW) + (b >> 64),
        );
        Self::new(a + (b << 32) + (u128::from(P) << 34) - b - (c << 32))
    }

    /// The residue of an integer that is given by its limbs in two's complement.
    fn of_limbs(limbs: &[u64]) -> Self {
        let value = Self::of_natural(limbs);
        if is_negative(limbs) {
            value.minus(Self(EPSILON).power(limbs.len() as u64))
        } else {
            value
        }
    }

    fn of_integer(c: &Integer) -> Self {
        let value = Self::of_natural(c.unsigned_abs_ref().as_limbs_asc());
        if *c < 0 {
            Self::ZERO.minus(value)
        } else {
            value
        }
    }
}

/// The number of sums that are computed together, because a single sum would wait for each product.
const LANES: usize = 4;

/// The value Σ c_k T^k.
fn value(coefficients: impl Iterator<Item = Extra>) -> Extra {
    let step = POINT.power(LANES as u64);
    let mut sums = [Extra::ZERO; LANES];
    let mut power = Extra::ONE;
    let mut lane = 0;
    for c in coefficients {
        sums[lane] = sums[lane].plus(c.times(power));
        lane += 1;
        if lane == LANES {
            (lane, power) = (0, power.times(step));
        }
    }
    let sums = sums.into_iter().rev();
    sums.fold(Extra::ZERO, |value, sum| value.times(POINT).plus(sum))
}

/// The value Σ c_k T^k, on all threads if there are many coefficients.
///
/// Cost: 0.3 ns for each limb in the cache, and some ns for each coefficient.
pub(crate) fn value_of_integers(coefficients: &[Integer]) -> Extra {
    /// Below this number of coefficients one thread is faster.
    const FEW: usize = 1 << 11;
    let of_part = |part: &[Integer]| value(part.iter().map(Extra::of_integer));
    if coefficients.len() <= FEW {
        return of_part(coefficients);
    }
    let parts: Vec<&[Integer]> = coefficients.chunks(FEW).collect();
    let parts = parallel::map(&parts, |part| of_part(part));
    let step = POINT.power(FEW as u64);
    let parts = parts.into_iter().rev();
    parts.fold(Extra::ZERO, |value, part| value.times(step).plus(part))
}

/// The value Σ c_k T^k.
pub(crate) fn value_of_flat(f: &FlatPolynomial) -> Extra {
    value(f.coefficients().map(Extra::of_limbs))
}

/// The value `ρ = 1 + T²`.
pub(crate) fn value_of_rho() -> Extra {
    Extra::ONE.plus(POINT.times(POINT))
}

/// The value h(T) for `h = Σ g_j (1+T)^j (1−T)^(d−j)`.
pub(crate) fn value_after_change(g: &FlatPolynomial) -> Extra {
    let (above, below) = (Extra::ONE.plus(POINT), Extra::ONE.minus(POINT));
    let ratio = above.times(below.inverse());
    let coefficients = g.coefficients().rev().map(Extra::of_limbs);
    let sum = coefficients.fold(Extra::ZERO, |sum, c| sum.times(ratio).plus(c));
    sum.times(below.power(g.len() as u64 - 1))
}

/// The value f(1, T) for the form f(1, t), which is the sum of the real and the imaginary part of h(it).
///
/// With S = (1 + iT)/(1 − iT), h(iT) is (1 − iT)^d Σ g_j S^j. For Z = S^4 = c + is, Z² = 2cZ − 1, and Σ a_j Z^j is
/// u_0 − c u_1 + i s u_1 with `u_j = a_j + 2c u_(j+1) − u_(j+2)` (Clenshaw). This is done for each of the four sums over every fourth
/// coefficient.
pub(crate) fn value_of_form(g: &FlatPolynomial) -> Extra {
    static RATIO: LazyLock<[[Extra; 2]; 2]> = LazyLock::new(|| {
        let inverse = value_of_rho().inverse();
        let cosine = Extra::ONE.minus(POINT.times(POINT)).times(inverse);
        let ratio = [cosine, POINT.plus(POINT).times(inverse)];
        [ratio, complex_power(ratio, LANES)]
    });
    let [ratio, [c, s]] = *RATIO;
    let twice = c.plus(c);
    let residues: Vec<Extra> = g.coefficients().map(Extra::of_limbs).collect();
    let (mut u, mut before) = ([Extra::ZERO; LANES], [Extra::ZERO; LANES]);
    for coefficients in residues.chunks(LANES).rev() {
        for (k, (u, before)) in u.iter_mut().zip(&mut before).enumerate() {
            // A missing coefficient is 0.
            let a = coefficients.get(k).copied().unwrap_or(Extra::ZERO);
            (*u, *before) = (twice.times(*u).minus(*before).plus(a), *u);
        }
    }
    let lanes = u.into_iter().zip(before).rev();
    let sum = lanes.fold([Extra::ZERO; 2], |sum, (u, before)| {
        let [re, im] = complex_product(sum, ratio);
        [re.plus(u.minus(c.times(before))), im.plus(s.times(before))]
    });
    let power = complex_power([Extra::ONE, Extra::ZERO.minus(POINT)], g.len() - 1);
    let [re, im] = complex_product(sum, power);
    re.plus(im)
}

fn complex_product([a, b]: [Extra; 2], [c, d]: [Extra; 2]) -> [Extra; 2] {
    [a.times(c).minus(b.times(d)), a.times(d).plus(b.times(c))]
}

fn complex_power(base: [Extra; 2], mut exponent: usize) -> [Extra; 2] {
    let (mut power, mut square) = ([Extra::ONE, Extra::ZERO], base);
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = complex_product(power, square);
        }
        square = complex_product(square, square);
        exponent >>= 1;
    }
    power
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bigint::bounded_integer;
    use malachite::base::num::arithmetic::traits::{Mod, Pow};
    use malachite::base::polynomial::Polynomial;
    use malachite::integer_polynomial::IntegerPolynomial;
    use proptest::prelude::*;

    fn residue(c: Integer) -> Extra {
        Extra(u64::try_from(&c.mod_op(Integer::from(P))).unwrap())
    }

    /// The value of a polynomial, computed with integers of any size.
    fn exactly(f: &[Integer]) -> Extra {
        let (point, prime) = (Integer::from(POINT.0), Integer::from(P));
        let value = f.iter().rev();
        residue(value.fold(Integer::from(0), |v, c| (v * &point + c) % &prime))
    }

    /// Integers with long runs of equal bits, and random ones.
    fn integers() -> impl Strategy<Value = Vec<Integer>> {
        let limb = prop_oneof![
            Just(0),
            Just(u64::MAX),
            Just(1),
            Just(P),
            Just(P - 1),
            Just(EPSILON),
            any::<u64>()
        ];
        let integer =
            (prop::collection::vec(limb, 0..12), any::<bool>()).prop_map(|(limbs, negative)| {
                let size = Integer::from(malachite::Natural::from_owned_limbs_asc(limbs));
                if negative { -size } else { size }
            });
        prop::collection::vec(integer, 1..30)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        /// Numbers around every correction.
        #[test]
        fn sums_and_products_are_residues(
            a in prop_oneof![0..P, 0..5_u64, P - 5..P, EPSILON - 5..EPSILON + 5], b in prop_oneof![0..P, 0..5_u64, P - 5..P, EPSILON - 5..EPSILON + 5],
            x in prop_oneof![any::<u128>(), u128::MAX - 5..=u128::MAX, 0..5_u128],
        ) {
            let (long_a, long_b) = (Integer::from(a), Integer::from(b));
            prop_assert_eq!(Extra(a).plus(Extra(b)), residue(&long_a + &long_b));
            prop_assert_eq!(Extra(a).minus(Extra(b)), residue(&long_a - &long_b));
            prop_assert_eq!(Extra(a).times(Extra(b)), residue(long_a * long_b));
            prop_assert_eq!(Extra::new(x), residue(Integer::from(x)));
        }

        #[test]
        fn values_are_those_of_the_integers(f in integers(), spare in 0u64..200) {
            let expected = exactly(&f);
            prop_assert_eq!(value_of_integers(&f), expected);
            let many: Vec<Integer> = f.iter().cycle().take(5000).cloned().collect();
            prop_assert_eq!(value_of_integers(&many), exactly(&many));
            let flat = FlatPolynomial::from_integers(f.iter(), 12 * 64 + spare);
            prop_assert_eq!(value_of_flat(&flat), expected);
            let a = Extra::of_integer(&f[0]);
            if a != Extra::ZERO {
                prop_assert_eq!(a.times(a.inverse()), Extra::ONE);
            }
        }

        #[test]
        fn changes_of_basis_have_the_values_of_their_coefficients(seed in prop::collection::vec(any::<i64>(), 1..40), extreme in any::<bool>()) {
            let g: Vec<Integer> = seed.iter().map(|s| bounded_integer(*s, 130, extreme)).collect();
            let degree = g.len() - 1;
            let polynomial = |c: &[i64]| IntegerPolynomial::from_coefficients_asc(c.iter().map(|c| Integer::from(*c)).collect());
            let mut h = polynomial(&[]);
            for (j, c) in g.iter().enumerate() {
                let term = polynomial(&[1, 1]).pow(j as u64) * polynomial(&[1, -1]).pow((degree - j) as u64);
                h += term * IntegerPolynomial::from_coefficients_asc(vec![c.clone()]);
            }
            let flat = FlatPolynomial::from_integers(g.iter(), 130);
            let mut h = h.into_coefficients_asc();
            prop_assert_eq!(value_after_change(&flat), exactly(&h));
            // The factors i^k have the signs + + − −.
            for (k, c) in h.iter_mut().enumerate() {
                if k % 4 >= 2 {
                    *c = -std::mem::take(c);
                }
            }
            prop_assert_eq!(value_of_form(&flat), exactly(&h));
        }

        #[test]
        fn one_wrong_bit_is_noticed(f in integers(), k in any::<usize>(), bit in 0u64..1000) {
            let mut wrong = f.clone();
            wrong[k % f.len()] += Integer::from(1) << bit;
            prop_assert_ne!(value_of_integers(&f), value_of_integers(&wrong));
        }
    }
}
