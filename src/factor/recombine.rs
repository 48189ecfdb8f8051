//! Recombination: the products of local factors that are true factors are found.

use crate::error::{Error, Result};
use crate::limits::Limits;

/// The largest number of subsets of local factors that are tested.
pub(super) const SUBSETS_AT_MOST: u64 = 1 << 28;

/// Conditions that every true factor satisfies and that are cheap to test for a subset.
pub(super) struct Sieve {
    /// The degree of each local factor.
    pub(super) degrees: Vec<usize>,
    /// For each degree, whether a true factor may have it.
    pub(super) allowed: Vec<bool>,
    /// A number for each local factor, as a fraction of 2⁶⁴. The sum of these numbers over a true factor is almost an integer.
    /// The number is the trace, modulo a prime power or modulo a power of a variable.
    pub(super) weights: Vec<u64>,
    /// The largest distance of the sum from an integer, as a fraction of 2⁶⁴.
    pub(super) tolerance: u64,
}

/// Calls `accept` with the subsets of 0..n that pass the sieve, the smallest first. The members of an accepted subset are
/// removed. In the end no subset of the rest, and no complement of one, was accepted, so the rest is irreducible.
///
/// Method: Zassenhaus' recombination (*Modern Computer Algebra*, Algorithm 15.22). Cost: one addition for each of at most
/// 2^(n−1) subsets, of which at most [`SUBSETS_AT_MOST`] are allowed.
///
/// # Errors
/// [`Error::Limit`] if there are more subsets than that; those of `accept` and of `limits`.
pub(super) fn recombine(
    sieve: &Sieve,
    limits: &Limits,
    accept: impl FnMut(&[usize]) -> Result<bool>,
) -> Result<()> {
    let mut search = Recombination {
        sieve,
        limits,
        accept,
        left: (0..sieve.degrees.len()).collect(),
        chosen: Vec::new(),
        seen: 0,
    };
    let mut size = 1;
    while 2 * size <= search.left.len() {
        let mut first = 0;
        while first < search.left.len() {
            // If a subset has half the factors, either it or its complement is tested, not both.
            if 2 * size > search.left.len() || (2 * size == search.left.len() && first > 0) {
                break;
            }
            let head = search.left[first];
            search.chosen.push(head);
            let found = search.extend(first + 1, size - 1, sieve.weights[head])?;
            if found {
                let taken = std::mem::take(&mut search.chosen);
                search.left.retain(|i| !taken.contains(i));
            } else {
                search.chosen.clear();
                first += 1;
            }
        }
        size += 1;
    }
    Ok(())
}

struct Recombination<'a, F> {
    sieve: &'a Sieve,
    limits: &'a Limits,
    accept: F,
    left: Vec<usize>,
    chosen: Vec<usize>,
    seen: u64,
}

impl<F: FnMut(&[usize]) -> Result<bool>> Recombination<'_, F> {
    /// Chooses `more` of the factors `left[from..]`. Returns whether a true factor was found, which is then in `chosen`.
    fn extend(&mut self, from: usize, more: usize, sum: u64) -> Result<bool> {
        if more == 0 {
            return self.leaf(sum);
        }
        for k in from..(self.left.len() + 1).saturating_sub(more) {
            let i = self.left[k];
            self.chosen.push(i);
            if self.extend(k + 1, more - 1, sum.wrapping_add(self.sieve.weights[i]))? {
                return Ok(true);
            }
            self.chosen.pop();
        }
        Ok(false)
    }

    fn leaf(&mut self, sum: u64) -> Result<bool> {
        self.seen += 1;
        if self.seen.is_multiple_of(1 << 16) {
            self.limits.check()?;
            if self.seen > SUBSETS_AT_MOST {
                return Err(Error::limit(format!(
                    "{SUBSETS_AT_MOST} products of the {} local factors tried",
                    self.sieve.degrees.len()
                )));
            }
        }
        if sum.min(sum.wrapping_neg()) > self.sieve.tolerance {
            return Ok(false);
        }
        let degree: usize = self.chosen.iter().map(|&i| self.sieve.degrees[i]).sum();
        if !self.sieve.allowed.get(degree).copied().unwrap_or(false) {
            return Ok(false);
        }
        (self.accept)(&self.chosen)
    }
}

/// The degrees of products of some of the given factors: entry d says whether d is such a degree.
pub(super) fn degrees_of_products(degrees: impl IntoIterator<Item = usize>) -> Vec<bool> {
    let mut possible = vec![true];
    for d in degrees {
        let mut next = possible.clone();
        next.resize(possible.len() + d, false);
        for (k, _) in possible.iter().enumerate().filter(|(_, p)| **p) {
            next[k + d] = true;
        }
        possible = next;
    }
    possible
}

/// Keeps the degrees that are possible in both lists. Returns whether a proper factor is still possible.
pub(super) fn intersect(possible: &mut [bool], other: &[bool]) -> bool {
    for (slot, &o) in possible.iter_mut().zip(other) {
        *slot &= o;
    }
    possible.iter().filter(|p| **p).count() > 2
}
