//! Residues modulo four primes at once, in doubles. They are exact, and one instruction processes four of them if the machine
//! has vectors.
//!
//! In all lemmas p is a prime between 2^49 and 2^50, so that integers up to 8p are doubles, and r = fl(1/p).
//!
//! Lemma 1 (reduction). For an integer |a| ≤ 8p and q = ⌊a r⌉, rounded to even, a − qp is an integer of at most p/2 + 1,
//! computed exactly.
//! Proof. |a/p| ≤ 8, and the computed a r has two relative errors of 2^-53, together below 2^-48, so |a/p − q| ≤ 1/2 + 2^-48.
//! The fused a − qp is an integer of at most p/2 + 2^-48 p, which is below 2^53, so it is not rounded.
//!
//! Lemma 2 (products). For integers |a| ≤ Ap, |b| ≤ Bp with AB ≤ 4, let h = fl(ab), l = ab − h, q = ⌊h r⌉. Then (h − qp) + l is
//! congruent to ab, computed exactly, and at most (1/2 + 3/8 AB) p.
//! Proof. ab/p ≤ AB p < AB 2^50, and h r has three relative errors of 2^-53, so h r differs from ab/p by less than 3/8 AB, and
//! q differs by less than 1/2 + 3/8 AB. The fused l is exact (Dekker). h − qp = (ab − qp) − l is a multiple of the last bit of
//! h and has at most (1/2 + 3/8 AB) p + |l| < 2^53 such bits, or it is an integer below 2^53; so it is exact. So is the sum, an
//! integer of at most 2p.
//!
//! Lemma 3 (products with a factor). For |a| ≤ Ap, A ≤ 8, |w| ≤ p/2 and q = ⌊a fl(w r)⌉ the statement of Lemma 2 holds with
//! (1/2 + 3/16 A) p.
//! Proof. This is Lemma 2 with B = 1/2, because a fl(w r) has three relative errors of 2^-53 as well.
//!
//! Lemma 4 (powers). Products of two residues of at most p are at most 7/8 p, and so are all powers.
//! Proof. This is Lemma 2 with AB = 1.
//!
//! The law of all lemmas is `products_are_congruent_and_as_small_as_is_said`, at the ends of the ranges and at multiples of
//! p/2.

use crate::bigint::limbs::is_negative;
use crate::bigint::{f64_from, u64_from};

/// Four numbers, one for each prime of [`LaneFields`]. They are integers below 2^53, which doubles hold exactly.
pub(crate) type Lanes = [f64; 4];

/// The primes are between 2^(PRIME_BITS − 1) and 2^PRIME_BITS.
pub(super) const PRIME_BITS: u64 = 50;

/// The integers modulo four primes. A residue is represented by any integer of its class; bounds on representatives are stated
/// as multiples of p.
///
/// All functions are compiled into their callers, with the instructions that are allowed there.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LaneFields {
    pub(super) p: Lanes,
    /// The rounded inverses 1/p.
    inverse: Lanes,
}

#[inline(always)]
fn each(a: Lanes, f: impl Fn(f64) -> f64) -> Lanes {
    [f(a[0]), f(a[1]), f(a[2]), f(a[3])]
}

#[inline(always)]
fn pairwise(a: Lanes, b: Lanes, f: impl Fn(f64, f64) -> f64) -> Lanes {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])]
}

/// The number `a b + c`, rounded once.
#[inline(always)]
fn fused(a: Lanes, b: Lanes, c: Lanes) -> Lanes {
    let one = |i: usize| a[i].mul_add(b[i], c[i]);
    [one(0), one(1), one(2), one(3)]
}

/// The sum, which is exact up to 2^53.
#[inline(always)]
pub(crate) fn plus(a: Lanes, b: Lanes) -> Lanes {
    pairwise(a, b, |a, b| a + b)
}

/// The difference, which is exact up to 2^53.
#[inline(always)]
pub(crate) fn minus(a: Lanes, b: Lanes) -> Lanes {
    pairwise(a, b, |a, b| a - b)
}

#[inline(always)]
pub(crate) fn negated(a: Lanes) -> Lanes {
    each(a, |a| -a)
}

#[inline(always)]
fn product(a: Lanes, b: Lanes) -> Lanes {
    pairwise(a, b, |a, b| a * b)
}

#[inline(always)]
fn rounded(a: Lanes) -> Lanes {
    each(a, f64::round_ties_even)
}

/// A factor w of many products, with |w| ≤ p/2, and the rounded quotient w/p.
#[derive(Clone, Copy, Debug)]
pub(super) struct Factor {
    w: Lanes,
    quotient: Lanes,
}

impl LaneFields {
    pub(super) fn new(p: Lanes) -> Self {
        let inverse = each(p, |p| 1.0 / p);
        Self { p, inverse }
    }

    /// The residue, of at most p/2 + 1, of an integer of at most 8p. Lemma 1.
    #[inline(always)]
    pub(crate) fn reduced(&self, a: Lanes) -> Lanes {
        let q = rounded(product(a, self.inverse));
        fused(negated(q), self.p, a)
    }

    /// The product, of at most (1/2 + 3/8 AB) p, of residues of at most Ap and Bp with AB ≤ 4. Lemma 2.
    #[inline(always)]
    pub(crate) fn times(&self, a: Lanes, b: Lanes) -> Lanes {
        let h = product(a, b);
        let l = fused(a, b, negated(h));
        let q = rounded(product(h, self.inverse));
        plus(fused(negated(q), self.p, h), l)
    }

    #[inline(always)]
    pub(super) fn factor(&self, w: Lanes) -> Factor {
        let quotient = product(w, self.inverse);
        Factor { w, quotient }
    }

    /// The product, of at most (1/2 + 3/16 A) p, of a residue of at most Ap, A ≤ 8, and a factor. The quotient does not depend
    /// on the product, so both are computed at the same time. Lemma 3.
    #[inline(always)]
    pub(super) fn times_factor(&self, a: Lanes, Factor { w, quotient }: Factor) -> Lanes {
        let h = product(a, w);
        let l = fused(a, w, negated(h));
        let q = rounded(product(a, quotient));
        plus(fused(negated(q), self.p, h), l)
    }

    /// The power a^exponent, of at most 7/8 p, for an a of at most p. Lemma 4.
    #[inline(always)]
    pub(super) fn power(&self, a: Lanes, exponent: u64) -> Lanes {
        let mut power = [a];
        self.raise(&mut power, exponent);
        power[0]
    }

    /// Replaces each a, of at most p, by a^exponent, of at most 7/8 p, or by a itself. Several powers are computed together,
    /// because a single chain of products would wait for each of them.
    #[inline(always)]
    pub(crate) fn raise(&self, values: &mut [Lanes], exponent: u64) {
        const TOGETHER: usize = 16;
        let mut bases = [[1.0; 4]; TOGETHER];
        for powers in values.chunks_mut(TOGETHER) {
            let bases = &mut bases[..powers.len()];
            bases.copy_from_slice(powers);
            if exponent == 0 {
                powers.fill([1.0; 4]);
            }
            for bit in (0..exponent.checked_ilog2().unwrap_or(0)).rev() {
                for power in &mut *powers {
                    *power = self.times(*power, *power);
                }
                if exponent >> bit & 1 == 1 {
                    for (power, base) in powers.iter_mut().zip(&*bases) {
                        *power = self.times(*power, *base);
                    }
                }
            }
        }
    }

    /// The inverse 1/a = a^(p − 2), of at most 7/8 p, for an a of at most p. The four exponents are different; where a bit is
    /// 0, the product is not used.
    #[inline(always)]
    pub(crate) fn inverse_of(&self, a: Lanes) -> Lanes {
        let exponents = each(self.p, |p| p - 2.0).map(u64_from);
        let (mut result, mut square) = ([1.0; 4], a);
        for bit in 0..PRIME_BITS {
            let product = self.times(result, square);
            let choice = |i: usize| {
                if exponents[i] >> bit & 1 == 1 {
                    product[i]
                } else {
                    result[i]
                }
            };
            result = [choice(0), choice(1), choice(2), choice(3)];
            square = self.times(square, square);
        }
        result
    }

    /// The inverse 1/n of a divisor n of p − 1, by n (p − 1)/n = −1.
    #[inline(always)]
    pub(super) fn inverse_of_divisor(&self, n: f64) -> Lanes {
        each(self.p, |p| -(p - 1.0) / n)
    }

    /// The residues in [0, p) of integers of at most 8p. Lemma 1.
    #[inline(always)]
    pub(super) fn canonical(&self, a: Lanes) -> Lanes {
        let a = self.reduced(a);
        pairwise(a, self.p, |a, p| if a < 0.0 { a + p } else { a })
    }

    /// The residues, of at most p, of an integer in two's complement.
    ///
    /// Lemma 5. With w = 2^32 and |value| ≤ p, the next value is at most p.
    /// Proof. By Lemma 3 the product is at most 11/16 p, and 2^32 < 5/16 p. Law: `residues_of_long_integers_are_congruent`.
    #[inline(always)]
    pub(crate) fn residue(&self, limbs: &[u64]) -> Lanes {
        // Horner's rule in 2^32.
        let by = self.factor([f64_from(1 << 32); 4]);
        let mut value = [if is_negative(limbs) { -1.0 } else { 0.0 }; 4];
        for limb in limbs.iter().rev() {
            for half in [limb >> 32, limb & 0xFFFF_FFFF] {
                value = plus(self.times_factor(value, by), [f64_from(half); 4]);
            }
        }
        value
    }

    /// An approximation of a/p, for the sum of such fractions.
    #[inline(always)]
    pub(super) fn fraction(&self, a: Lanes) -> Lanes {
        product(a, self.inverse)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use crate::bigint::residues::Quartet;
    use malachite::Integer;
    use malachite::base::num::arithmetic::traits::Mod;
    use proptest::prelude::*;

    pub(in super::super) fn integer(a: f64) -> Integer {
        Integer::try_from(a).unwrap()
    }

    pub(in super::super) fn congruent(a: &Integer, b: &Integer, p: f64) -> bool {
        (a - b).mod_op(integer(p)) == 0
    }

    /// Numbers of absolute value up to 8p, more often at the ends and at multiples of p/2 than between.
    fn residue() -> impl Strategy<Value = (f64, i8)> {
        (
            prop_oneof![Just(0.0), Just(1.0), Just(0.5), -1.0..1.0],
            prop_oneof![Just(0), -2i8..3],
        )
    }

    proptest! {
        #[test]
        fn residues_of_long_integers_are_congruent(
            limbs in prop::collection::vec(prop_oneof![Just(0), Just(u64::MAX), any::<u64>()], 1..40),
        ) {
            let field = Quartet::enough_for(1).pop().unwrap().field;
            let value = Integer::from_twos_complement_limbs_asc(&limbs);
            let residues = field.residue(&limbs);
            for (residue, p) in residues.into_iter().zip(field.p) {
                prop_assert!(congruent(&integer(residue), &value, p));
                prop_assert!(residue.abs() <= p);
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn products_are_congruent_and_as_small_as_is_said(
            (a, up) in residue(), (b, down) in residue(), scale in prop_oneof![Just(1.0), Just(2.0), Just(8.0)], exponent in 0u64..9,
        ) {
            let field = Quartet::enough_for(1000).pop().unwrap().field;
            // A number of at most `of` times p.
            let at = |of: f64, by: f64, more: i8| field.p.map(|p| {
                let size = (of * p * by).trunc() + f64::from(more);
                if size.abs() <= of * p { size } else { (of * p * by).trunc() }
            });
            let (wide, short) = (at(scale, a, up), at(0.5, b, down));
            let (left, right) = (at(2.0, a, up), at(2.0, b, down));
            let one = at(1.0, a, up);
            let by_factor = field.times_factor(wide, field.factor(short));
            let (product, reduced, power) = (field.times(left, right), field.reduced(wide), field.power(one, exponent));
            let (canonical, inverse) = (field.canonical(one), field.inverse_of(one));
            for i in 0..4 {
                let p = field.p[i];
                prop_assert!(congruent(&(integer(wide[i]) * integer(short[i])), &integer(by_factor[i]), p));
                prop_assert!(by_factor[i].abs() <= (0.5 + scale * 3.0 / 16.0) * p);
                prop_assert!(congruent(&(integer(left[i]) * integer(right[i])), &integer(product[i]), p));
                prop_assert!(product[i].abs() <= 2.0 * p);
                prop_assert!(field.times(one, one)[i].abs() <= 7.0 / 8.0 * p);
                prop_assert!(congruent(&integer(wide[i]), &integer(reduced[i]), p));
                prop_assert!(reduced[i].abs() <= p / 2.0 + 1.0);
                let expected = (0..exponent).fold(Integer::from(1), |product, _| product * integer(one[i]));
                prop_assert!(congruent(&expected, &integer(power[i]), p));
                prop_assert!(congruent(&integer(one[i]), &integer(canonical[i]), p));
                prop_assert!((0.0..p).contains(&canonical[i]));
                if canonical[i] > 0.0 {
                    prop_assert!(congruent(&(integer(one[i]) * integer(inverse[i])), &Integer::from(1), p));
                }
                prop_assert!(congruent(&(integer(field.inverse_of_divisor(768.0)[i]) * Integer::from(768)), &Integer::from(1), p));
            }
        }
    }
}
