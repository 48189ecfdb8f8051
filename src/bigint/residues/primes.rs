//! The primes for residues. They are 1 modulo 3 · 2^22, so that there are roots of unity.

use std::sync::{Mutex, PoisonError};

use malachite::base::num::factorization::traits::IsPrime;

use super::lanes::{Lanes, PRIME_BITS};
use crate::bigint::f64_from;
use crate::error::Invariant;

/// There are roots of unity of all orders that divide 3 · 2^ORDER_BITS.
pub(super) const ORDER_BITS: u32 = 22;

const ORDER: u64 = 3 << ORDER_BITS;

/// The number ⌈2^49.99⌉.
pub(super) const LEAST: u64 = 1_118_122_748_098_670;

/// A prime and a root of unity of order 3 · 2^[`ORDER_BITS`].
#[derive(Clone, Copy, Debug)]
struct Prime {
    p: u64,
    root: u64,
}

/// The largest primes below 2^[`PRIME_BITS`], descending, as far as they have been needed; to find one takes 10 µs.
static KNOWN: Mutex<Vec<Prime>> = Mutex::new(Vec::new());

/// `count` times four primes, descending, with roots of unity of order 3 · 2^[`ORDER_BITS`], which are at most p/2.
///
/// Lemma 1. All primes are above 2^49.99.
/// Proof. Each is compared with [`LEAST`] when it is found. (Of the numbers that are 1 modulo [`ORDER`] about one in twelve is
/// a prime, so [`MOST_PRIMES`](super::blocks::MOST_PRIMES) primes reach down from 2^50 by about 0.65 % of it, and 2^49.99 is
/// 0.69 % below 2^50.) Law: `roots_have_the_order_that_is_said`.
pub(super) fn fours_of_primes(count: usize) -> Vec<[Lanes; 2]> {
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    while known.len() < 4 * count {
        let above = known.last().map_or(1 << PRIME_BITS, |prime| prime.p);
        known.push(next_prime(above));
    }
    let fours = known.as_chunks::<4>().0.iter().take(count);
    let lanes = fours.map(|four| [four.map(|prime| f64_from(prime.p)), four.map(balanced_root)]);
    lanes.collect()
}

fn balanced_root(Prime { p, root }: Prime) -> f64 {
    if root > p / 2 {
        -f64_from(p - root)
    } else {
        f64_from(root)
    }
}

/// The largest prime below `above` that is 1 modulo [`ORDER`].
fn next_prime(above: u64) -> Prime {
    let mut p = (above - 2) / ORDER * ORDER + 1;
    while !p.is_prime() {
        p -= ORDER;
    }
    assert!(p > LEAST, "there are enough primes above 2^49.99");
    // The order of g^((p − 1)/ORDER) divides ORDER. It is ORDER if the powers with a half and with a third of this exponent are
    // not 1.
    let mut roots = (2..p).map(|g| power(g, (p - 1) / ORDER, p));
    let is_primitive = |root: &u64| {
        [ORDER / 2, ORDER / 3]
            .iter()
            .all(|&e| power(*root, e, p) != 1)
    };
    let root = roots
        .find(is_primitive)
        .invariant("the units modulo a prime are a cyclic group");
    Prime { p, root }
}

/// The power base^exponent modulo a prime of 50 bits.
fn power(base: u64, mut exponent: u64, p: u64) -> u64 {
    let mul = |a: u64, b: u64| {
        let product = u128::from(a) * u128::from(b) % u128::from(p);
        u64::try_from(product).invariant("a residue is less than its prime")
    };
    let (mut result, mut square) = (1, base % p);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = mul(result, square);
        }
        square = mul(square, square);
        exponent >>= 1;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bigint::u64_from;

    #[test]
    fn roots_have_the_order_that_is_said() {
        let fours = fours_of_primes(30);
        let primes: Vec<f64> = fours.iter().flat_map(|[p, _]| *p).collect();
        assert!(primes.is_sorted_by(|a, b| a > b) && primes[119] > 49.99_f64.exp2());
        for [p, root] in fours {
            for (p, root) in p.into_iter().zip(root) {
                let (p, size) = (u64_from(p), u64_from(root.abs()));
                assert!(p.is_prime() && size <= p / 2);
                let root = if root < 0.0 { p - size } else { size };
                assert_eq!(power(root, ORDER, p), 1);
                assert_eq!(power(root, ORDER / 2, p), p - 1);
                assert_ne!(power(root, ORDER / 3, p), 1);
            }
        }
    }
}
