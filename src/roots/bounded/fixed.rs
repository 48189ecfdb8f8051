//! Numbers of W limbs without errors: fixed-point numbers with a sign, and fractions between 0 and 1. Each operation states how
//! it rounds; `ball.rs` states the effect on an error.

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

use crate::bigint::sign_limb;
use crate::error::Invariant;

/// The number of bits of a [`Fixed`] before the point, including the sign.
const WHOLE_BITS: i64 = 8;

/// A number in (−128, 128), a multiple of the *ulp* 2^(8 − 64W), in two's complement: the lowest limb first.
///
/// Sums are exact. The caller must ensure that they stay in range; out-of-range sums wrap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Fixed<const W: usize>([u64; W]);

/// A multiple of 2^(−64W) in [0, 1), the lowest limb first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Fraction<const W: usize>([u64; W]);

/// The low half of a double word.
#[expect(clippy::cast_possible_truncation, reason = "that is what it is for")]
#[inline]
fn low(wide: u128) -> u64 {
    wide as u64
}

/// The high half of a double word.
#[inline]
fn high(wide: u128) -> u64 {
    low(wide >> 64)
}

/// The sum a + b + carry, wrapping, and its carry.
#[inline]
fn sum<const W: usize>(a: &[u64; W], b: &[u64; W], carry: bool) -> ([u64; W], bool) {
    let mut result = [0; W];
    let mut carry = u128::from(carry);
    for ((r, a), b) in result.iter_mut().zip(a).zip(b) {
        let wide = u128::from(*a) + u128::from(*b) + carry;
        *r = low(wide);
        carry = wide >> 64;
    }
    (result, carry != 0)
}

fn complement<const W: usize>(a: &[u64; W]) -> [u64; W] {
    a.map(|limb| !limb)
}

/// The product a b / 2^(64W), rounded down by less than W. The columns of the product that are entirely below the result are
/// left out: they are W(W−1)/2 products of limbs, together less than W − 1.
#[inline]
fn high_product<const W: usize>(a: &[u64; W], b: &[u64; W]) -> [u64; W] {
    // The columns from 2^(64(W−1)) on, except the last one.
    let mut columns = [0; W];
    let mut last = 0;
    for (i, a) in a.iter().enumerate() {
        let mut carry = 0;
        for (column, b) in columns.iter_mut().zip(&b[W - 1 - i..]) {
            let wide = u128::from(*a) * u128::from(*b) + u128::from(*column) + u128::from(carry);
            (*column, carry) = (low(wide), high(wide));
        }
        if i + 1 < W {
            columns[i + 1] = carry;
        } else {
            last = carry;
        }
    }
    std::array::from_fn(|k| if k + 1 < W { columns[k + 1] } else { last })
}

/// The number a · 2^(−shift), rounded down; for a negative shift modulo 2^(64W).
fn shifted<const W: usize>(a: &[u64; W], shift: i64) -> [u64; W] {
    let bits = shift.unsigned_abs();
    // A shift by W limbs or more leaves nothing.
    let limbs = usize::try_from((bits / 64).min(W as u64)).invariant("a number has few limbs");
    let bits = bits % 64;
    // The limbs beyond both ends are zeros.
    let at = |k: Option<usize>| u128::from(k.and_then(|k| a.get(k)).copied().unwrap_or(0));
    let mut result = [0; W];
    for (k, r) in result.iter_mut().enumerate() {
        let pair = if shift >= 0 {
            at(Some(k + limbs + 1)) << 64 | at(Some(k + limbs))
        } else {
            at(k.checked_sub(limbs)) << 64 | at(k.checked_sub(limbs + 1))
        };
        *r = if shift >= 0 {
            low(pair >> bits)
        } else {
            high(pair << bits)
        };
    }
    result
}

/// A number of bits as a signed integer; it is far below 2^63.
fn signed(bits: u64) -> i64 {
    i64::try_from(bits).invariant("the bits of a number that fits in memory fit in an i64")
}

fn significant_bits<const W: usize>(a: &[u64; W]) -> i64 {
    let top = a.iter().enumerate().rev().find(|(_, limb)| **limb != 0);
    top.map_or(0, |(k, limb)| {
        signed(64 * k as u64 + limb.significant_bits())
    })
}

/// `limbs` · 2^(−64W) as the nearest double or one of its neighbours.
#[expect(clippy::cast_precision_loss, reason = "an approximation")]
fn approximate<const W: usize>(limbs: &[u64; W]) -> f64 {
    let mut value = 0.0;
    for limb in limbs {
        value = (value + *limb as f64) * (-64f64).exp2();
    }
    value
}

impl<const W: usize> Fixed<W> {
    /// The number 0.
    pub(crate) const ZERO: Self = Self([0; W]);

    /// The binary logarithm of the number of ulps in 1.
    pub(crate) const FRACTION_BITS: i64 = 64 * W as i64 - WHOLE_BITS;

    /// A number r such that `count` numbers below 2^r have sums of at most 64; it is the largest one or one less.
    pub(crate) fn room_for(count: usize) -> i64 {
        6 - i64::from(count.max(1).ilog2()) - 1
    }

    /// The number of bits of |value|.
    pub(crate) fn bits_of(value: &Integer) -> i64 {
        signed(value.unsigned_abs_ref().significant_bits())
    }

    /// value · 2^(−exponent), cut towards 0 to a multiple of the ulp, and whether bits were cut off.
    ///
    /// # Panics
    /// If that is not in (−128, 128).
    pub(super) fn of_integer(value: &Integer, exponent: i64) -> (Self, bool) {
        let magnitude = value.unsigned_abs_ref();
        assert!(
            Self::bits_of(value) < exponent + WHOLE_BITS,
            "a number fits in its limbs"
        );
        let shift = exponent - Self::FRACTION_BITS;
        let mut limbs = [0; W];
        let mut fill = |n: &malachite::Natural| {
            for (limb, value) in limbs.iter_mut().zip(n.limbs()) {
                *limb = value;
            }
        };
        let mut is_cut = false;
        if shift > 0 {
            let shift = shift.unsigned_abs();
            fill(&(magnitude >> shift));
            is_cut = magnitude
                .trailing_zeros()
                .is_some_and(|zeros| zeros < shift);
        } else {
            fill(magnitude);
            limbs = shifted(&limbs, shift);
        }
        let size = Self(limbs);
        let value = if *value < 0 { size.negated() } else { size };
        (value, is_cut)
    }

    /// ⌊a / 2^shift⌋ ulps, for a number a in two's complement whose size is less than 2^(64W − 1 + shift).
    pub(super) fn from_wide(a: &[u64], shift: u32) -> Self {
        let (limbs, bits) = (shift as usize / 64, shift % 64);
        let sign = sign_limb(a);
        let at = |k: usize| u128::from(a.get(k).copied().unwrap_or(sign));
        Self(std::array::from_fn(|k| {
            low((at(k + limbs + 1) << 64 | at(k + limbs)) >> bits)
        }))
    }

    /// The number in ulps, in two's complement, the lowest limb first.
    pub(super) fn limbs(&self) -> &[u64; W] {
        &self.0
    }

    pub(crate) fn is_negative(self) -> bool {
        self.0[W - 1] >> 63 != 0
    }

    /// The absolute value, in ulps.
    pub(super) fn magnitude(self) -> [u64; W] {
        if self.is_negative() {
            self.negated().0
        } else {
            self.0
        }
    }

    /// The absolute value, in units of 2^8.
    pub(super) fn size(self) -> Fraction<W> {
        Fraction(self.magnitude())
    }

    /// The number of bits of the absolute value in ulps.
    pub(crate) fn bits(self) -> i64 {
        significant_bits(&self.magnitude())
    }

    pub(crate) fn plus(self, other: Self) -> Self {
        Self(sum(&self.0, &other.0, false).0)
    }

    pub(crate) fn minus(self, other: Self) -> Self {
        Self(sum(&self.0, &complement(&other.0), true).0)
    }

    pub(crate) fn negated(self) -> Self {
        Self::ZERO.minus(self)
    }

    /// The mean (self + other) / 2, rounded down to a multiple of the ulp.
    pub(crate) fn mean(self, other: Self) -> Self {
        let total = sum(&self.0, &other.0, false).0;
        let mut result = [0; W];
        for k in 0..W - 1 {
            result[k] = (total[k] >> 1) | (total[k + 1] << 63);
        }
        // The sum is in range, so its top bit is its sign.
        result[W - 1] = (total[W - 1] >> 1) | (total[W - 1] & (1 << 63));
        Self(result)
    }

    /// The product self · fraction, rounded towards 0 by less than W ulps.
    pub(crate) fn times(self, fraction: &Fraction<W>) -> Self {
        let product = Self(high_product(&self.magnitude(), &fraction.0));
        if self.is_negative() {
            product.negated()
        } else {
            product
        }
    }

    /// The number self ± 2^8 a b, with an error of less than W ulps.
    #[inline]
    pub(super) fn plus_or_minus_product(
        self,
        a: &Fraction<W>,
        b: &Fraction<W>,
        is_negative: bool,
    ) -> Self {
        let mask = if is_negative { u64::MAX } else { 0 };
        let product = high_product(&a.0, &b.0).map(|limb| limb ^ mask);
        Self(sum(&self.0, &product, is_negative).0)
    }

    /// The number self · 2^(−shift), rounded towards 0.
    pub(crate) fn shifted_down(self, shift: i64) -> Self {
        let magnitude = Self(shifted(&self.magnitude(), shift));
        if self.is_negative() {
            magnitude.negated()
        } else {
            magnitude
        }
    }

    /// Whether the absolute value is more than this number of ulps.
    #[inline]
    pub(super) fn is_larger_than(self, ulps: u128) -> bool {
        let magnitude = self.magnitude();
        let low = u128::from(magnitude[1]) << 64 | u128::from(magnitude[0]);
        low > ulps || magnitude[2..].iter().any(|limb| *limb != 0)
    }

    pub(super) fn is_zero(self) -> bool {
        self == Self::ZERO
    }

    /// An approximation of the number.
    pub(crate) fn to_f64(self) -> f64 {
        let size = approximate(&self.magnitude()) * 256.0;
        if self.is_negative() { -size } else { size }
    }
}

impl<const W: usize> Fraction<W> {
    /// The number 0.
    pub(crate) const ZERO: Self = Self([0; W]);

    /// The largest fraction, 1 − 2^(−64W).
    pub(crate) const LARGEST: Self = Self([u64::MAX; W]);

    /// The number index · 2^(−depth), or [`Fraction::LARGEST`] if it is smaller, for depth < 64.
    pub(crate) fn dyadic(index: u64, depth: u32) -> Self {
        let mut result = Self::ZERO;
        if depth == 0 || index >> depth != 0 {
            return if index == 0 { result } else { Self::LARGEST };
        }
        result.0[W - 1] = index << (64 - depth);
        result
    }

    /// The quotient |p| / |q|, rounded down, for |p| ≤ |q| ≠ 0; [`Fraction::LARGEST`] if they are equal.
    pub(crate) fn quotient(p: &Integer, q: &Integer) -> Self {
        let (p, q) = (p.unsigned_abs_ref(), q.unsigned_abs_ref());
        if p >= q {
            return Self::LARGEST;
        }
        let mut limbs = [0; W];
        let quotient = (p << (64 * W as u64)) / q;
        for (limb, value) in limbs.iter_mut().zip(quotient.limbs()) {
            *limb = value;
        }
        Self(limbs)
    }

    /// The product self · other, rounded down by less than W 2^(−64W).
    pub(crate) fn times(&self, other: &Self) -> Self {
        Self(high_product(&self.0, &other.0))
    }

    /// The sum self + other; `None` if it is 1 or more.
    pub(crate) fn plus(&self, other: &Self) -> Option<Self> {
        let (total, carry) = sum(&self.0, &other.0, false);
        (!carry).then_some(Self(total))
    }

    /// The difference self − other; `None` if it is negative.
    pub(crate) fn minus(&self, other: &Self) -> Option<Self> {
        let (total, carry) = sum(&self.0, &complement(&other.0), true);
        carry.then_some(Self(total))
    }

    /// The number self · 2^(−shift), rounded down.
    pub(crate) fn shifted_down(&self, shift: u32) -> Self {
        Self(shifted(&self.0, i64::from(shift)))
    }

    /// The whole part and the rest of self · 2^bits, for bits < 64.
    pub(super) fn split(&self, bits: u32) -> (u64, Self) {
        let rest = Self(shifted(&self.0, -i64::from(bits)));
        let whole = low(u128::from(self.0[W - 1]) << bits >> 64);
        (whole, rest)
    }

    /// The number self · 2^shift, or [`Fraction::LARGEST`] if it is smaller.
    pub(crate) fn shifted_up(&self, shift: u32) -> Self {
        let shift = i64::from(shift);
        if significant_bits(&self.0) + shift > 64 * W as i64 {
            Self::LARGEST
        } else {
            Self(shifted(&self.0, -shift))
        }
    }

    /// The number closest to `value` in [0, 1).
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the parts of a double in [0, 1)"
    )]
    pub(crate) fn from_f64(value: f64) -> Self {
        let mut result = Self::ZERO;
        let mut rest = value;
        for limb in result.0.iter_mut().rev() {
            rest *= 64f64.exp2();
            *limb = rest as u64;
            rest -= rest.trunc();
        }
        result
    }

    /// An approximation of the number.
    pub(crate) fn to_f64(self) -> f64 {
        approximate(&self.0)
    }

    /// The integer self · 2^(64W).
    pub(crate) fn to_integer(self) -> Integer {
        Integer::from(malachite::Natural::from_limbs_asc(&self.0))
    }

    /// (m, e) with m in [2^127, 2^128) and m · 2^e ≤ self < (m + 1) · 2^e; (0, 0) for 0.
    pub(crate) fn leading(&self) -> (u128, i64) {
        let bits = significant_bits(&self.0);
        if bits == 0 {
            return (0, 0);
        }
        let whole = 64 * W as i64;
        let top = shifted(&self.0, bits - whole);
        let m = (u128::from(top[W - 1]) << 64) | u128::from(top[W - 2]);
        (m, bits - whole - 128)
    }
}

impl<const W: usize> PartialOrd for Fraction<W> {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl<const W: usize> Ord for Fraction<W> {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.iter().rev().cmp(other.0.iter().rev())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use malachite::base::num::arithmetic::traits::{Abs, DivRound, Pow, UnsignedAbs};
    use malachite::base::rounding_modes::RoundingMode;
    use proptest::prelude::*;

    const W: usize = 3;

    /// The number in ulps.
    fn integer(a: Fixed<W>) -> Integer {
        let magnitude = Integer::from(malachite::Natural::from_limbs_asc(&a.magnitude()));
        if a.is_negative() {
            -magnitude
        } else {
            magnitude
        }
    }

    fn fixed(limbs: [u64; W]) -> Fixed<W> {
        // Three bits of headroom.
        Fixed(limbs).shifted_down(3)
    }

    /// Numbers with this room have sums of at most 64, and the room is at most one bit too small.
    #[test]
    fn there_is_room_for_sums() {
        for count in 1..5000u32 {
            let largest =
                |room: i64| 2f64.powi(i32::try_from(room).expect("small")) * f64::from(count);
            let room = Fixed::<W>::room_for(count as usize);
            assert!(largest(room) <= 64.0 && largest(room + 2) > 64.0, "{count}");
        }
        assert_eq!(Fixed::<W>::room_for(0), Fixed::<W>::room_for(1));
    }

    proptest! {
        /// The operations agree with malachite's integers.
        #[test]
        fn arithmetic(a: [u64; W], b: [u64; W], p in 0u64..1000, shift in -300i64..300) {
            let (x, y, f) = (fixed(a), fixed(b), Fraction(b));
            let (i, j, g) = (integer(x), integer(y), f.to_integer());
            let one = Integer::from(2).pow(64 * W as u64);
            prop_assert_eq!(integer(x.plus(y)), &i + &j);
            prop_assert_eq!(integer(x.minus(y)), &i - &j);
            prop_assert_eq!(integer(x.mean(y)), (&i + &j).div_round(Integer::from(2), RoundingMode::Floor).0);
            let short = |product: Integer, cut: Integer| (product - cut).unsigned_abs() < W;
            prop_assert!(short(integer(x.times(&f)), &i * &g / &one));
            prop_assert!(short(f.times(&f).to_integer(), &g * &g / &one));
            let product = (&j).abs() * &g / &one;
            prop_assert!(short(integer(x.plus_or_minus_product(&y.size(), &f, false)), &i + &product));
            prop_assert!(short(integer(x.plus_or_minus_product(&y.size(), &f, true)), &i - &product));
            if let Some(bits) = u32::try_from(shift).ok().filter(|bits| *bits < 64) {
                let wide = [&[0], x.limbs().as_slice()].concat();
                let floor = (&i).div_round(Integer::from(2).pow(bits.into()), RoundingMode::Floor).0;
                prop_assert_eq!(integer(Fixed::from_wide(&wide, bits + 64)), floor);
            }
            if shift >= 0 {
                prop_assert_eq!(integer(x.shifted_down(shift)), &i / Integer::from(2).pow(shift.unsigned_abs()));
            }
            prop_assert_eq!(x.is_larger_than(p.into()), i.unsigned_abs_ref() > &malachite::Natural::from(p));
            let exponent = Fixed::<W>::bits_of(&i);
            let (m, is_cut) = Fixed::<W>::of_integer(&i, exponent);
            let cut = i.significant_bits().saturating_sub(64 * W as u64 - 8);
            let expected = &i / Integer::from(2).pow(cut);
            prop_assert_eq!((integer(m) << exponent.unsigned_abs()) >> (64 * W as u64 - 8), &expected << cut);
            prop_assert_eq!(is_cut, expected << cut != i);
            let (m, e) = f.leading();
            if g == 0 {
                prop_assert_eq!((m, e), (0, 0));
            } else {
                prop_assert!(m >> 127 == 1);
                prop_assert_eq!(g >> ((64 * W as i64) + e).unsigned_abs(), Integer::from(m));
            }
        }

        #[test]
        fn doubles(a in 0.0f64..1.0, down in 0i32..250, b: [u64; W]) {
            prop_assert!((Fraction::<W>::from_f64(a).to_f64() - a).abs() <= a * f64::EPSILON);
            // Also doubles that have bits in all limbs, or below them.
            let small = a * 2f64.powi(-down);
            let scaled = Rational::try_from(small).unwrap() * Rational::from_dyadic(Integer::from(1), 64 * W as i64);
            prop_assert_eq!(Fraction::<W>::from_f64(small).to_integer(), scaled.floor_integer());
            let x = fixed(b).to_f64();
            prop_assert!((x.abs() - fixed(b).negated().to_f64().abs()).abs() <= x.abs() * f64::EPSILON);
        }
    }
}
