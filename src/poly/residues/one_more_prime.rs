//! Whether what was lifted from residues has the right value at one more point modulo one more prime, 2^61 − 1.
//!
//! Lemma 1. A polynomial of degree d that is not 0 modulo p has at most d zeros modulo p. So a wrong result is noticed unless all its
//! errors are multiples of p, or the point, which was fixed before, is one of d among 2^61.
//! This guards against defects; the result itself rests on the bounds of [`lifting`](super::lifting).
//! Laws: `values_are_those_of_the_integers`, `one_wrong_bit_is_noticed`.
//!
//! Cost: 0.4 ns for each limb, and some ns for each coefficient.

use malachite::Integer;

use crate::poly::FlatPolynomial;
use crate::poly::limbs::is_negative;

/// The prime, 2^61 − 1.
const P: u64 = (1 << BITS) - 1;
const BITS: u32 = 61;

/// Where values are compared, `T`: any residue but 0, 1 and −1.
const POINT: Extra = Extra(0x0e37_79b9_7f4a_7c15);

/// A residue modulo the prime, in [0, 2^61 − 1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Extra(u64);

impl Extra {
    /// Of a number below 2^64: 2^61 is 1.
    #[inline]
    fn new(a: u64) -> Self {
        let sum = (a & P) + (a >> BITS);
        Self(if sum >= P { sum - P } else { sum })
    }

    #[inline]
    pub(crate) fn plus(self, other: Self) -> Self {
        Self::new(self.0 + other.0)
    }

    #[inline]
    pub(crate) fn minus(self, other: Self) -> Self {
        Self::new(self.0 + P - other.0)
    }

    #[inline]
    pub(crate) fn times(self, other: Self) -> Self {
        let product = u128::from(self.0) * u128::from(other.0);
        #[expect(
            clippy::cast_possible_truncation,
            reason = "the product is below 2^122: both parts are below 2^64"
        )]
        let (low, high) = (product as u64 & P, (product >> BITS) as u64);
        Self::new(low + high)
    }

    pub(crate) fn power(self, mut exponent: usize) -> Self {
        let (mut power, mut square) = (Self(1), self);
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = power.times(square);
            }
            square = square.times(square);
            exponent >>= 1;
        }
        power
    }

    /// 1/self, for a residue that is not 0.
    fn inverse(self) -> Self {
        let (mut power, mut square) = (Self(1), self);
        // p − 2 = 2^61 − 3: all bits but the second.
        for bit in 0..BITS {
            if bit != 1 {
                power = power.times(square);
            }
            square = square.times(square);
        }
        power
    }

    /// Of a natural number by its limbs, those of every fourth side by side: 2^256 is 2^12.
    fn of_natural(limbs: &[u64]) -> Self {
        let (fours, top) = limbs.as_chunks::<4>();
        let folded = |limb: u64| (limb & P) + (limb >> BITS);
        let mut sums = [0; 4];
        for (sum, limb) in sums.iter_mut().zip(top) {
            *sum = folded(*limb);
        }
        for four in fours.iter().rev() {
            for (sum, limb) in sums.iter_mut().zip(four) {
                // Sums are below 2^61 + 2^4: all terms are below 2^63 together.
                let raised = ((*sum << 12) & P) + (*sum >> (BITS - 12));
                *sum = folded(raised + folded(*limb));
            }
        }
        // 2^64 is 2^3.
        let terms = sums.into_iter().enumerate();
        terms.fold(Self(0), |value, (i, sum)| {
            value.plus(Self::new(sum).times(Self(1 << (3 * i))))
        })
    }

    /// Of an integer by its limbs in two's complement.
    fn of_limbs(limbs: &[u64]) -> Self {
        let value = Self::of_natural(limbs);
        if is_negative(limbs) {
            value.minus(Self(8).power(limbs.len()))
        } else {
            value
        }
    }

    fn of_integer(c: &Integer) -> Self {
        let value = Self::of_natural(c.unsigned_abs_ref().as_limbs_asc());
        if *c < 0 { Self(0).minus(value) } else { value }
    }
}

/// Σ c_k T^k.
fn value(coefficients: impl Iterator<Item = Extra>) -> Extra {
    // Four sums side by side: one would wait for each product.
    let fourth = POINT.power(4);
    let mut sums = [Extra(0); 4];
    let mut power = Extra(1);
    for (k, c) in coefficients.enumerate() {
        sums[k % 4] = sums[k % 4].plus(c.times(power));
        if k % 4 == 3 {
            power = power.times(fourth);
        }
    }
    let [a, b, c, d] = sums;
    let (low, high) = (a.plus(b.times(POINT)), c.plus(d.times(POINT)));
    low.plus(high.times(POINT.times(POINT)))
}

/// Σ c_k T^k.
pub(crate) fn value_of_integers(coefficients: &[Integer]) -> Extra {
    value(coefficients.iter().map(Extra::of_integer))
}

/// Σ c_k T^k.
pub(crate) fn value_of_flat(f: &FlatPolynomial) -> Extra {
    value(f.coefficients().map(Extra::of_limbs))
}

/// `ρ = 1 + T²`.
pub(crate) fn value_of_rho() -> Extra {
    Extra(1).plus(POINT.times(POINT))
}

/// h(T) for `h = Σ g_j (1+T)^j (1−T)^(d−j)`.
pub(crate) fn value_after_change(g: &FlatPolynomial) -> Extra {
    let (above, below) = (Extra(1).plus(POINT), Extra(1).minus(POINT));
    let ratio = above.times(below.inverse());
    let coefficients = g.coefficients().rev().map(Extra::of_limbs);
    let sum = coefficients.fold(Extra(0), |sum, c| sum.times(ratio).plus(c));
    sum.times(below.power(g.len() - 1))
}

/// f(1, T) for the form f(1, t), the real part of h(it) and its imaginary one together.
///
/// With S = (1 + iT)/(1 − iT) it is (1 − iT)^d Σ g_j S^j, and as S² = 2cS − 1, S = c + is, the sum is u_0 − c u_1 + i s u_1 with
/// `u_j = g_j + 2c u_(j+1) − u_(j+2)` (Clenshaw).
pub(crate) fn value_of_form(g: &FlatPolynomial) -> Extra {
    let square = POINT.times(POINT);
    let below = value_of_rho().inverse();
    let c = Extra(1).minus(square).times(below);
    let s = POINT.plus(POINT).times(below);
    let twice = c.plus(c);
    let (mut u, mut before) = (Extra(0), Extra(0));
    for g in g.coefficients().rev().map(Extra::of_limbs) {
        (u, before) = (twice.times(u).minus(before).plus(g), u);
    }
    let sum = [u.minus(c.times(before)), s.times(before)];
    let power = complex_power([Extra(1), Extra(0).minus(POINT)], g.len() - 1);
    let [re, im] = complex_product(sum, power);
    re.plus(im)
}

fn complex_product([a, b]: [Extra; 2], [c, d]: [Extra; 2]) -> [Extra; 2] {
    [a.times(c).minus(b.times(d)), a.times(d).plus(b.times(c))]
}

fn complex_power(base: [Extra; 2], mut exponent: usize) -> [Extra; 2] {
    let (mut power, mut square) = ([Extra(1), Extra(0)], base);
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
    use crate::poly::{IntegerPolynomial, bounded_integer};
    use malachite::base::num::arithmetic::traits::{Mod, Pow};
    use malachite::base::polynomial::Polynomial;
    use proptest::prelude::*;

    fn residue(c: Integer) -> Extra {
        Extra(u64::try_from(&c.mod_op(Integer::from(P))).unwrap())
    }

    /// The value of a polynomial, with integers of any size.
    fn exactly(f: &[Integer]) -> Extra {
        let point = Integer::from(POINT.0);
        residue(f.iter().rev().fold(Integer::from(0), |v, c| v * &point + c))
    }

    /// Long runs of equal bits, and any.
    fn integers() -> impl Strategy<Value = Vec<Integer>> {
        let limb = prop_oneof![Just(0), Just(u64::MAX), Just(1), Just(P), any::<u64>()];
        let integer =
            (prop::collection::vec(limb, 0..12), any::<bool>()).prop_map(|(limbs, negative)| {
                let size = Integer::from(malachite::Natural::from_owned_limbs_asc(limbs));
                if negative { -size } else { size }
            });
        prop::collection::vec(integer, 1..30)
    }

    proptest! {
        #[test]
        fn values_are_those_of_the_integers(f in integers(), spare in 0u64..200) {
            let expected = exactly(&f);
            prop_assert_eq!(value_of_integers(&f), expected);
            let flat = FlatPolynomial::from_integers(f.iter(), 12 * 64 + spare);
            prop_assert_eq!(value_of_flat(&flat), expected);
            let a = Extra::of_integer(&f[0]);
            if a != Extra(0) {
                prop_assert_eq!(a.times(a.inverse()), Extra(1));
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
            // i^k leaves the signs + + − −.
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
