//! The greatest common divisor of many integers.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExactAssign, Gcd};
use malachite::base::num::basic::traits::Zero;

/// The greatest common divisor of integers, as a power of 2 times an odd number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Content {
    twos: u64,
    odd: Integer,
}

/// The greatest common divisor of integers; 1 if all are 0. The odd part is that of the first few if it is 1 already, and the
/// powers of 2 are counted.
pub(crate) fn content<'a>(integers: impl IntoIterator<Item = &'a Integer>) -> Content {
    let mut twos: Option<u64> = None;
    let mut odd = Integer::ZERO;
    for c in integers {
        // 0 is divisible by everything.
        let Some(own) = c.trailing_zeros() else {
            continue;
        };
        twos = Some(twos.map_or(own, |twos| twos.min(own)));
        if odd != 1 {
            let rest = c >> own;
            odd = Integer::from(odd.unsigned_abs_ref().gcd(rest.unsigned_abs_ref()));
        }
    }
    match twos {
        Some(twos) => Content { twos, odd },
        None => Content {
            twos: 0,
            odd: Integer::from(1),
        },
    }
}

impl Content {
    /// Divides one of the integers.
    pub(crate) fn divide(&self, c: &mut Integer) {
        if self.twos > 0 {
            *c >>= self.twos;
        }
        if self.odd != 1 {
            c.div_exact_assign(&self.odd);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;
    use proptest::prelude::*;

    use crate::exact::{integer_from_num, integer_to_num};

    fn euclid(a: BigInt, b: BigInt) -> BigInt {
        if b == BigInt::from(0) {
            return a;
        }
        let rest = &a % &b;
        euclid(b, rest)
    }

    proptest! {
        #[test]
        fn quotients_are_those_of_num(
            list in prop::collection::vec(any::<i64>(), 0..6), shift in 0usize..70, odd in 1u32..50,
        ) {
            let numbers: Vec<BigInt> = list.iter().map(|&c| (BigInt::from(c) << shift) * odd).collect();
            let gcd = numbers.iter().cloned().fold(BigInt::from(0), euclid);
            let gcd = BigInt::from(gcd.magnitude().clone());
            let integers: Vec<Integer> = numbers.iter().map(integer_from_num).collect();
            let found = content(&integers);
            for (number, mut integer) in numbers.into_iter().zip(integers) {
                found.divide(&mut integer);
                let quotient = if gcd == BigInt::from(0) { number } else { number / &gcd };
                prop_assert_eq!(integer_to_num(&integer), quotient);
            }
        }
    }
}
