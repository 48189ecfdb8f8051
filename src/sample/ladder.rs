//! A ladder of precisions: rays are solved at the precision that decided the last ones, and at the next higher one if that
//! proves nothing.

use std::fmt::Debug;
use std::sync::OnceLock;
use std::sync::atomic::Ordering::Relaxed;
use std::sync::atomic::{AtomicU64, AtomicUsize};

use super::parts::ExpandedParts;
use super::point::Sample;
use super::truncated::TruncatedForms;
use super::unit_vector::RationalLine;
use crate::roots::Unproved;

/// The number of precisions.
pub(super) const LEVELS: usize = 6;

/// If there are more failures of all levels than twice the number of successes and this, bounded arithmetic is no longer tried:
/// there are multiple roots in all directions.
const PATIENCE: u64 = 16;

/// The largest number of successes at one level before the cheaper level is retried.
const LONGEST_WAIT: u64 = 32;

/// The precisions, and the level that decided the last directions; the next direction starts there.
#[derive(Debug)]
pub(super) struct Ladder<const V: usize> {
    levels: [Box<dyn Level<V>>; LEVELS],
    counts: [AtomicU64; LEVELS],
    failures: AtomicU64,
    /// The level that is tried first.
    start: AtomicUsize,
    /// How many successes at this level before the cheaper one is retried. It is doubled each time that the cheaper one fails.
    wait: AtomicU64,
    /// The number of successes at this level since the cheaper one was retried.
    answers: AtomicU64,
}

impl<const V: usize> Default for Ladder<V> {
    fn default() -> Self {
        Self {
            levels: [
                Box::new(Forms::<2, V>::new()),
                Box::new(Forms::<3, V>::new()),
                Box::new(Forms::<4, V>::new()),
                Box::new(Forms::<6, V>::new()),
                Box::new(Forms::<8, V>::new()),
                Box::new(Forms::<12, V>::new()),
            ],
            counts: Default::default(),
            failures: AtomicU64::new(0),
            start: AtomicUsize::new(0),
            wait: AtomicU64::new(1),
            answers: AtomicU64::new(0),
        }
    }
}

impl<const V: usize> Ladder<V> {
    /// The points on a line, if one of the precisions proves them.
    pub(super) fn solve(
        &self,
        expansion: &ExpandedParts<'_, V>,
        line: &RationalLine<'_, V>,
    ) -> Result<Vec<Sample<V>>, Unproved> {
        let answers: u64 = self.counts().iter().sum();
        if self.failures.load(Relaxed) > 2 * answers + PATIENCE {
            return Err(Unproved::Close);
        }
        // Other threads may change the two numbers meanwhile; that can only cost time.
        let (start, wait) = (self.start.load(Relaxed), self.wait.load(Relaxed));
        let first = if self.answers.load(Relaxed) < wait {
            start
        } else {
            start.saturating_sub(1)
        };
        for (k, level) in self.levels.iter().enumerate().skip(first) {
            match level.solve(expansion, line) {
                Err(Unproved::Bits) => {}
                Err(Unproved::Close) => break,
                Ok(samples) => {
                    self.counts[k].fetch_add(1, Relaxed);
                    if k != start {
                        self.start.store(k, Relaxed);
                        self.wait.store(1, Relaxed);
                        self.answers.store(0, Relaxed);
                    } else if first < start {
                        self.wait.store((2 * wait).min(LONGEST_WAIT), Relaxed);
                        self.answers.store(0, Relaxed);
                    } else {
                        self.answers.fetch_add(1, Relaxed);
                    }
                    return Ok(samples);
                }
            }
        }
        self.failures.fetch_add(1, Relaxed);
        Err(Unproved::Close)
    }

    /// The number of directions that each level has decided.
    pub(super) fn counts(&self) -> [u64; LEVELS] {
        self.counts.each_ref().map(|count| count.load(Relaxed))
    }
}

/// One precision.
trait Level<const V: usize>: Debug + Send + Sync {
    fn solve(
        &self,
        expansion: &ExpandedParts<'_, V>,
        line: &RationalLine<'_, V>,
    ) -> Result<Vec<Sample<V>>, Unproved>;
}

/// The forms with W limbs, made when they are first needed.
#[derive(Debug)]
struct Forms<const W: usize, const V: usize>(OnceLock<TruncatedForms<W, V>>);

impl<const W: usize, const V: usize> Forms<W, V> {
    fn new() -> Self {
        Self(OnceLock::new())
    }
}

impl<const W: usize, const V: usize> Level<V> for Forms<W, V> {
    fn solve(
        &self,
        expansion: &ExpandedParts<'_, V>,
        line: &RationalLine<'_, V>,
    ) -> Result<Vec<Sample<V>>, Unproved> {
        let forms = self.0.get_or_init(|| TruncatedForms::new(expansion));
        forms.solve(line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::PlanePolynomial;
    use crate::sample::{Direction, IntegerVector, PartsByDegree};
    use malachite::Integer;

    fn ask(ladder: &Ladder<2>, f: &PlanePolynomial, direction: &Direction) -> bool {
        let (vector, w) = direction.over_common_denominator();
        let line = RationalLine {
            vector: &vector,
            w: &w,
            center: None,
        };
        ladder.solve(&f.expanded(), &line).is_ok()
    }

    /// (x − 1)² + y² to the power k, minus 2^(−shift).
    fn steep(k: usize, shift: u64) -> PlanePolynomial {
        let term = |e, c: i64| (e, c.into());
        let circle = [
            term((2, 0), 1),
            term((0, 2), 1),
            term((1, 0), -2),
            term((0, 0), 1),
        ];
        let circle = PlanePolynomial::from_terms(circle);
        let one = PlanePolynomial::from_terms([term((0, 0), 1)]);
        let power = (0..k).fold(one, |power, _| &power * &circle);
        let radius = crate::exact::Rational::from_dyadic(Integer::from(-1), -(shift as i64));
        PlanePolynomial::from_terms(power.terms().chain([((0, 0), radius)]))
    }

    #[test]
    fn neighbours_start_where_the_last_one_was_decided() {
        let f = steep(20, 100);
        let ladder = Ladder::default();
        let far = Direction::from_radians(2.0);
        assert!(ask(&ladder, &f, &far));
        assert_eq!(ladder.start.load(Relaxed), 0);
        // Directions through the circle, where values are as small as 2^(−100).
        let near = Direction::from_radians(0.0);
        assert!(ask(&ladder, &f, &near));
        let level = ladder.start.load(Relaxed);
        assert!(level > 0);
        // In directions where fewer bits suffice, the level falls again, by one level at a time.
        for _ in 0..2 * LEVELS {
            assert!(ask(&ladder, &f, &far));
        }
        assert_eq!(ladder.start.load(Relaxed), 0);
        assert_eq!(ladder.counts().iter().sum::<u64>(), 2 + 2 * LEVELS as u64);
        // Where fewer bits do not suffice, the cheaper level is retried less and less often.
        for _ in 0..20 {
            assert!(ask(&ladder, &f, &near));
        }
        assert_eq!(ladder.start.load(Relaxed), level);
        assert!(ladder.wait.load(Relaxed) >= 8);
    }

    #[test]
    fn multiple_roots_everywhere_are_left_to_exact_arithmetic() {
        let f = steep(3, 4);
        let ladder = Ladder::default();
        let east = Direction::from_radians(0.0);
        for k in 0..=PATIENCE + 5 {
            assert!(!ask(&ladder, &(&f * &f), &east));
            assert_eq!(ladder.failures.load(Relaxed), (k + 1).min(PATIENCE + 1));
        }
    }
}
