//! Work on many items on all cores, with the results in the order of the items.
//!
//! The loop over the cores is compiled once, because it calls the work through a pointer, for a part of the items each time.

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use crate::error::{Invariant, Result};
use crate::limits::Limits;

/// Each core gets about this many parts of the items, so that all are busy to the end even if some items take longer.
const PARTS: usize = 32;

/// The values of `work` at all items.
pub(crate) fn map<A: Sync, T: Send>(items: &[A], work: impl Fn(&A) -> T + Sync) -> Vec<T> {
    map_numbers(items.len(), |k| work(&items[k]))
}

/// The values of `work` at the numbers 0, 1, …, `count` − 1.
pub(crate) fn map_numbers<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let parts = in_parts(count, |numbers| numbers.map(&work).collect::<Vec<T>>());
    let mut all = Vec::with_capacity(count);
    parts.into_iter().for_each(|part| all.extend(part));
    all
}

/// The values of `work` at all items. The limits are checked before each.
///
/// # Errors
/// The error at the first of the items at which there is one. After it, work on later items is not begun.
pub(crate) fn try_map<A: Sync, T: Send>(
    items: &[A],
    limits: &Limits,
    work: impl Fn(&A) -> Result<T> + Sync,
) -> Result<Vec<T>> {
    try_map_numbers(items.len(), limits, |k| work(&items[k]))
}

/// The values of `work` at the numbers 0, 1, …, `count` − 1. The limits are checked before each.
///
/// # Errors
/// As [`try_map`].
pub(crate) fn try_map_numbers<T: Send>(
    count: usize,
    limits: &Limits,
    work: impl Fn(usize) -> Result<T> + Sync,
) -> Result<Vec<T>> {
    let failed = AtomicUsize::new(usize::MAX);
    let parts = in_parts(count, |numbers| {
        let start = numbers.start;
        // A part that ends early is behind the error, and is not looked at.
        let needed = |_: &usize| start <= failed.load(Ordering::Relaxed);
        let value = |k| limits.check().and_then(|()| work(k));
        let values = numbers.take_while(needed).map(value);
        let values = values.collect::<Result<Vec<T>>>();
        if values.is_err() {
            failed.fetch_min(start, Ordering::Relaxed);
        }
        values
    });
    let mut all = Vec::with_capacity(count);
    for part in parts {
        all.extend(part?);
    }
    Ok(all)
}

/// The values of `work` at the parts of the numbers below `count`, which are computed on all cores.
fn in_parts<R: Send>(count: usize, work: impl Fn(Range<usize>) -> R + Sync) -> Vec<R> {
    let parts = count.min(PARTS * rayon::current_num_threads());
    let start = |part: usize| part * count / parts;
    let slots: Vec<Mutex<Option<R>>> = (0..parts).map(|_| Mutex::default()).collect();
    on_all_cores(parts, &|part| {
        let value = work(start(part)..start(part + 1));
        *slots[part].lock().unwrap_or_else(PoisonError::into_inner) = Some(value);
    });
    let value = |slot: Mutex<Option<R>>| {
        let value = slot.into_inner().unwrap_or_else(PoisonError::into_inner);
        value.invariant("every part has been worked on")
    };
    slots.into_iter().map(value).collect()
}

/// Not generic, so that it is compiled once.
fn on_all_cores(count: usize, work: &(dyn Fn(usize) + Sync)) {
    let numbers = (0..count).into_par_iter().with_max_len(1);
    numbers.for_each(work);
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use proptest::prelude::*;

    use super::*;
    use crate::error::Error;

    proptest! {
        /// The results, and the error, are those of a loop on one core.
        #[test]
        fn all_cores_give_what_one_gives(
            items in prop::collection::vec(0u32..100, 0..500),
            wrong in prop_oneof![Just(100u32), 0u32..100],
        ) {
            let work = |x: &u32| x * x + 1;
            prop_assert_eq!(map(&items, work), items.iter().map(work).collect::<Vec<_>>());
            let at = |k: usize| match items[k] {
                x if x == wrong => Err(Error::Usage(format!("item {k}"))),
                x => Ok(work(&x)),
            };
            let text = |found: Result<Vec<u32>>| found.map_err(|error| error.to_string());
            let limits = Limits::none();
            prop_assert_eq!(
                text(try_map_numbers(items.len(), &limits, at)),
                text((0..items.len()).map(at).collect())
            );
        }
    }

    #[test]
    fn limits_are_checked_before_each_item() {
        let over = Limits::none().with_time_limit(Duration::ZERO);
        let never = |_: &u8| -> Result<u8> { panic!("the time is over") };
        assert!(matches!(
            try_map(&[1, 2, 3], &over, never),
            Err(Error::Limit { .. })
        ));
        assert!(try_map(&[], &over, never).is_ok());
    }
}
