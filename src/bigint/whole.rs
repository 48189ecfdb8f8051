//! Conversions between integers below 2^52 and the doubles that are equal to them, by two instructions each.

/// The number 2^52. For an integer a below 2^52, the last 52 bits of the double 2^52 + a are those of a.
const ABOVE: f64 = f64::from_bits((52 + 1023) << 52);

/// The integer that is equal to a double, which must be an integer in [0, 2^52).
#[inline(always)]
pub(crate) fn u64_from(a: f64) -> u64 {
    (a + ABOVE).to_bits() - ABOVE.to_bits()
}

/// The double that is equal to an integer below 2^52.
#[inline(always)]
pub(crate) fn f64_from(a: u64) -> f64 {
    f64::from_bits(a | ABOVE.to_bits()) - ABOVE
}

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::Integer;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn integers_are_doubles_and_back(a in 0u64..1 << 52) {
            prop_assert_eq!(u64_from(f64_from(a)), a);
            prop_assert_eq!(Integer::try_from(f64_from(a)), Ok(Integer::from(a)));
        }
    }
}
