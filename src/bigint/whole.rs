//! Whole numbers that are held as doubles.

/// 2^52: the last bits of 2^52 + a are a, for integers a below 2^52.
const ABOVE: f64 = f64::from_bits((52 + 1023) << 52);

/// An integer in [0, 2^52) that is held as a double.
#[inline(always)]
pub(crate) fn u64_from(a: f64) -> u64 {
    (a + ABOVE).to_bits() - ABOVE.to_bits()
}

/// An integer below 2^52 as a double.
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
