//! Prime factors of integers, as far as they are not too hard to find.

use malachite::base::num::arithmetic::traits::{CheckedSqrt, DivRem, Parity};
use malachite::base::num::factorization::traits::Factor;
use malachite::{Integer, Natural};

/// Primes below this number are divided out. The rest must be below 2⁶⁴, or the square of such a number.
const TRIAL_DIVISORS: u64 = 1 << 14;

/// An integer in factored form, sign · ∏ p^e.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Factored {
    /// Whether it is negative.
    pub(super) negative: bool,
    /// The primes with their exponents, ascending.
    pub(super) primes: Vec<(u64, u32)>,
}

impl Factored {
    /// The factors of n ≠ 0; `None` if the rest without small primes is too large (see [`TRIAL_DIVISORS`]).
    pub(super) fn of(n: &Integer) -> Option<Self> {
        let mut rest = n.unsigned_abs_ref().clone();
        if rest == 0u32 {
            return None;
        }
        let mut primes: Vec<(u64, u32)> = Vec::new();
        for p in (2..TRIAL_DIVISORS).filter(|p| *p == 2 || p.odd()) {
            if u64::try_from(&rest).is_ok() {
                break;
            }
            let prime = Natural::from(p);
            let mut exponent = 0;
            loop {
                let (quotient, remainder) = (&rest).div_rem(&prime);
                if remainder != 0u32 {
                    break;
                }
                rest = quotient;
                exponent += 1;
            }
            if exponent > 0 {
                primes.push((p, exponent));
            }
        }
        let (rest, times) = match u64::try_from(&rest) {
            Ok(small) => (small, 1),
            Err(_) => (u64::try_from(&(&rest).checked_sqrt()?).ok()?, 2),
        };
        if rest > 1 {
            for (p, e) in rest.factor() {
                match primes.iter_mut().find(|(q, _)| *q == p) {
                    Some((_, exponent)) => *exponent += times * u32::from(e),
                    None => primes.push((p, times * u32::from(e))),
                }
            }
        }
        primes.sort_unstable();
        Some(Self {
            negative: *n < 0,
            primes,
        })
    }

    /// The factors of a product of numbers that are not 0. The error is the number that is too large to be factored.
    pub(super) fn of_product(numbers: &[Integer]) -> Result<Self, Integer> {
        let mut product = Self {
            negative: false,
            primes: Vec::new(),
        };
        for number in numbers {
            let factors = Self::of(number).ok_or_else(|| number.clone())?;
            product.negative ^= factors.negative;
            for (p, e) in factors.primes {
                match product.primes.iter_mut().find(|(q, _)| *q == p) {
                    Some((_, exponent)) => *exponent += e,
                    None => product.primes.push((p, e)),
                }
            }
        }
        product.primes.sort_unstable();
        Ok(product)
    }

    /// (root, rest) with n = root² · rest and rest squarefree.
    pub(super) fn square_part(&self) -> (Integer, Self) {
        let mut root = Integer::from(1);
        for &(p, e) in &self.primes {
            for _ in 0..e / 2 {
                root *= Integer::from(p);
            }
        }
        let odd = self.primes.iter().filter(|(_, e)| e % 2 == 1);
        let rest = Self {
            negative: self.negative,
            primes: odd.map(|&(p, _)| (p, 1)).collect(),
        };
        (root, rest)
    }

    /// The integer.
    pub(super) fn value(&self) -> Integer {
        let mut value = Integer::from(if self.negative { -1 } else { 1 });
        for &(p, e) in &self.primes {
            for _ in 0..e {
                value *= Integer::from(p);
            }
        }
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn factors_multiply_back(a in any::<i64>(), b in 1u32..16_000, k in 0u32..4) {
            prop_assume!(a != 0);
            let mut n = Integer::from(a);
            for _ in 0..k {
                n *= Integer::from(b);
            }
            // Without small primes a number of 63 bits is left.
            let found = Factored::of(&n).unwrap();
            prop_assert_eq!(found.value(), n.clone());
            let (root, rest) = found.square_part();
            prop_assert_eq!(&root * &root * rest.value(), n);
            prop_assert!(rest.primes.iter().all(|(_, e)| *e == 1));
        }
    }

    #[test]
    fn a_product_of_two_large_primes_is_beyond_the_limit() {
        let p = Integer::from((1u64 << 61) - 1);
        let q = Integer::from(1_000_000_007u64) * Integer::from(1_000_000_009u64);
        assert_eq!(Factored::of(&(&p * q)), None);
        let square = Factored::of(&(&p * &p)).unwrap();
        assert_eq!(square.primes, [((1 << 61) - 1, 2)]);
    }
}
