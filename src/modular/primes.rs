//! The primes for computations with large numbers: those below 2³¹, descending.

use std::sync::LazyLock;

use malachite::base::num::factorization::traits::IsPrime;

/// The number of primes that are stored; most computations need no more.
const KEPT: usize = 64;

static FIRST: LazyLock<Vec<u64>> = LazyLock::new(|| {
    let all = std::iter::successors(Some(previous_prime((1 << 31) + 1)), |&p| {
        Some(previous_prime(p))
    });
    all.take(KEPT).collect()
});

/// The primes below 2³¹, descending. Products of two residues have at most 62 bits.
pub(crate) fn large_primes() -> LargePrimes {
    LargePrimes { taken: 0, last: 0 }
}

/// The iterator that [`large_primes`] returns.
pub(crate) struct LargePrimes {
    taken: usize,
    last: u64,
}

impl LargePrimes {
    /// The next prime. There are far more primes than any computation uses.
    pub(crate) fn following(&mut self) -> u64 {
        self.last = match FIRST.get(self.taken) {
            Some(prime) => *prime,
            None => previous_prime(self.last),
        };
        self.taken += 1;
        self.last
    }
}

impl Iterator for LargePrimes {
    type Item = u64;

    fn next(&mut self) -> Option<u64> {
        Some(self.following())
    }
}

/// The largest prime below an odd number.
fn previous_prime(from: u64) -> u64 {
    let mut candidate = from - 2;
    while !candidate.is_prime() {
        candidate -= 2;
    }
    candidate
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_go_on_where_the_kept_ones_end() {
        let found: Vec<u64> = large_primes().take(KEPT + 20).collect();
        let last = found[KEPT + 19];
        let expected = (last..1 << 31).rev().filter(IsPrime::is_prime);
        assert_eq!(found, expected.collect::<Vec<u64>>());
    }
}
