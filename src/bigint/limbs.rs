//! Integers of a fixed width, in place: slices of 64-bit limbs in two's complement, the least significant first.
//!
//! Results that do not fit wrap around. So sums, differences and left shifts are right if the final result fits, however large
//! the intermediate ones are.

use crate::error::Invariant;
use malachite::{Integer, Natural};

/// The number of bits of a limb.
pub(crate) const LIMB_BITS: u64 = 64;

/// The number of limbs that hold every integer of absolute value below 2^`bits`, and every such integer minus 1.
pub(crate) fn width_for(bits: u64) -> usize {
    usize::try_from((bits + 1).div_ceil(LIMB_BITS)).invariant("a number fits in memory")
}

/// Performs `a += b`.
#[inline]
pub(crate) fn add(a: &mut [u64], b: &[u64]) {
    let mut carry = false;
    for (x, &y) in a.iter_mut().zip(b) {
        let (sum, first) = x.overflowing_add(y);
        let (sum, second) = sum.overflowing_add(u64::from(carry));
        (*x, carry) = (sum, first | second);
    }
}

/// Performs `a -= b`.
#[inline]
pub(crate) fn subtract(a: &mut [u64], b: &[u64]) {
    let mut borrow = false;
    for (x, &y) in a.iter_mut().zip(b) {
        let (difference, first) = x.overflowing_sub(y);
        let (difference, second) = difference.overflowing_sub(u64::from(borrow));
        (*x, borrow) = (difference, first | second);
    }
}

/// Performs `a += 1`.
pub(crate) fn increment(a: &mut [u64]) {
    for x in a {
        let (sum, carry) = x.overflowing_add(1);
        *x = sum;
        if !carry {
            return;
        }
    }
}

/// Performs `a -= 1`.
pub(crate) fn decrement(a: &mut [u64]) {
    for x in a {
        let (difference, borrow) = x.overflowing_sub(1);
        *x = difference;
        if !borrow {
            return;
        }
    }
}

/// Performs `a = −a`.
pub(crate) fn negate(a: &mut [u64]) {
    let mut carry = true;
    for x in a {
        (*x, carry) = (!*x).overflowing_add(u64::from(carry));
    }
}

/// Whether the number is negative.
#[inline]
pub(crate) fn is_negative(a: &[u64]) -> bool {
    a.last().is_some_and(|&top| top >> (LIMB_BITS - 1) != 0)
}

/// The limb that all limbs beyond the width would be: all ones for a negative number, else 0.
#[inline]
pub(crate) fn sign_limb(a: &[u64]) -> u64 {
    if is_negative(a) { u64::MAX } else { 0 }
}

/// Performs `target = a`, where the target is at least as wide.
#[inline]
pub(crate) fn widen(target: &mut [u64], a: &[u64]) {
    let (low, high) = target.split_at_mut(a.len());
    low.copy_from_slice(a);
    high.fill(sign_limb(a));
}

/// Performs `a <<= bits`; more bits than the number has give 0.
pub(crate) fn shift_left(a: &mut [u64], bits: u64) {
    let whole = usize::try_from(bits / LIMB_BITS)
        .unwrap_or(usize::MAX)
        .min(a.len());
    a.copy_within(..a.len() - whole, whole);
    a[..whole].fill(0);
    let part = bits % LIMB_BITS;
    if part > 0 {
        let mut carried = 0;
        for x in &mut a[whole..] {
            (*x, carried) = (*x << part | carried, *x >> (LIMB_BITS - part));
        }
    }
}

/// Performs `a >>= bits` for a number that is not negative; more bits than the number has give 0.
fn shift_right(a: &mut [u64], bits: u64) {
    let whole = usize::try_from(bits / LIMB_BITS)
        .unwrap_or(usize::MAX)
        .min(a.len());
    a.copy_within(whole.., 0);
    let kept = a.len() - whole;
    a[kept..].fill(0);
    let part = bits % LIMB_BITS;
    if part > 0 {
        let mut carried = 0;
        for x in a[..kept].iter_mut().rev() {
            (*x, carried) = (*x >> part | carried, *x << (LIMB_BITS - part));
        }
    }
}

/// The number of zero bits at the low end; `None` for 0.
pub(crate) fn trailing_zeros(a: &[u64]) -> Option<u64> {
    let k = a.iter().position(|&x| x != 0)?;
    Some(k as u64 * LIMB_BITS + u64::from(a[k].trailing_zeros()))
}

/// Performs `a += value`, or `a −= value` if `negated`.
pub(crate) fn add_integer(a: &mut [u64], value: &Integer, negated: bool) {
    let magnitude = value.unsigned_abs_ref();
    let mut carry = false;
    let minus = (*value < 0) != negated;
    let limbs = magnitude.limbs().chain(std::iter::repeat(0));
    for (x, y) in a.iter_mut().zip(limbs) {
        let (first, second);
        if minus {
            (*x, first) = x.overflowing_sub(y);
            (*x, second) = x.overflowing_sub(u64::from(carry));
        } else {
            (*x, first) = x.overflowing_add(y);
            (*x, second) = x.overflowing_add(u64::from(carry));
        }
        carry = first | second;
    }
}

/// The number `a · 2^shift` as an [`Integer`] that takes no more memory than it needs. The result must be an integer. `scratch`
/// is overwritten.
pub(crate) fn to_integer(a: &[u64], shift: i64, scratch: &mut Vec<u64>) -> Integer {
    scratch.clear();
    scratch.extend_from_slice(a);
    let negative = is_negative(a);
    if negative {
        negate(scratch);
    }
    let by = shift.unsigned_abs();
    if shift > 0 {
        let more = usize::try_from(by.div_ceil(LIMB_BITS)).invariant("a number fits in memory");
        scratch.resize(a.len() + more, 0);
        shift_left(scratch, by);
    } else if shift < 0 {
        shift_right(scratch, by);
    }
    Integer::from_sign_and_abs(!negative, Natural::from_limbs_asc(scratch))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn integer(a: &[u64]) -> Integer {
        Integer::from_twos_complement_limbs_asc(a)
    }

    /// Numbers with long runs of equal bits, so that carries go far.
    fn limbs(width: usize) -> impl Strategy<Value = Vec<u64>> {
        let limb = prop_oneof![
            Just(0),
            Just(u64::MAX),
            Just(1),
            Just(1 << 63),
            any::<u64>()
        ];
        prop::collection::vec(limb, width)
    }

    proptest! {
        /// The operations agree with malachite's, modulo 2^256.
        #[test]
        fn they_are_integers_modulo_a_power_of_two(a in limbs(4), b in limbs(4), by in 0u64..300, narrow in limbs(2)) {
            let wrapped = |value: Integer| {
                let mut expected = value.into_twos_complement_limbs_asc();
                let sign = if is_negative(&expected) { u64::MAX } else { 0 };
                expected.resize(expected.len().max(4), sign);
                expected.truncate(4);
                expected
            };
            let after = |change: &dyn Fn(&mut [u64])| {
                let mut changed = a.clone();
                change(&mut changed);
                changed
            };
            prop_assert_eq!(after(&|x| add(x, &b)), wrapped(integer(&a) + integer(&b)));
            prop_assert_eq!(after(&|x| subtract(x, &b)), wrapped(integer(&a) - integer(&b)));
            prop_assert_eq!(after(&increment), wrapped(integer(&a) + Integer::from(1)));
            prop_assert_eq!(after(&decrement), wrapped(integer(&a) - Integer::from(1)));
            prop_assert_eq!(after(&negate), wrapped(-integer(&a)));
            prop_assert_eq!(after(&|x| shift_left(x, by)), wrapped(integer(&a) << by));
            prop_assert_eq!(after(&|x| widen(x, &narrow)), wrapped(integer(&narrow)));
            for (negated, value) in [(false, integer(&a) + integer(&b)), (true, integer(&a) - integer(&b))] {
                prop_assert_eq!(after(&|x| add_integer(x, &integer(&b), negated)), wrapped(value));
            }
        }

        #[test]
        fn to_integers_and_back(a in limbs(3), by in 0i64..200) {
            use malachite::base::num::logic::traits::SignificantBits;
            let mut scratch = Vec::new();
            let value = integer(&a);
            prop_assert_eq!(&to_integer(&a, 0, &mut scratch), &value);
            let shifted = to_integer(&a, by, &mut scratch);
            prop_assert_eq!(&shifted, &(&value << by.unsigned_abs()));
            let zeros = value.trailing_zeros();
            prop_assert_eq!(trailing_zeros(&a), zeros);
            if let Some(zeros) = zeros {
                let least = to_integer(&a, -i64::try_from(zeros).unwrap_or(0), &mut scratch);
                prop_assert_eq!(least << zeros, value.clone());
            }
            let mut again = vec![0; width_for(value.significant_bits())];
            add_integer(&mut again, &value, false);
            prop_assert_eq!(integer(&again), value);
        }
    }
}
