//! Long lists of texts are made in parallel and written in order.

use std::io::{self, Write};

use rayon::prelude::*;

/// About this many bytes of text are made while as many are written. So the memory is bounded by two windows and two pieces of
/// text.
const WINDOW: u64 = 1 << 20;

/// Each thread makes pieces of about this many bytes together.
const TASK: usize = 1 << 16;

/// Shorter texts are made on one thread.
const PARALLEL_FROM: u64 = 1 << 16;

/// Writes the text that `append` makes of each item, in the order of the items. `size` is about the length of the text in
/// bytes; neither `size` nor the number of threads changes what is written.
///
/// # Errors
/// Those of `out`.
pub(crate) fn write_in_order<T: Send>(
    mut items: impl Iterator<Item = T>,
    size: impl Fn(&T) -> u64,
    append: impl Fn(&T, &mut Vec<u8>) + Sync,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut next = Window::new();
    next.take(&mut items, &size);
    if next.bytes < PARALLEL_FROM || rayon::current_num_threads() == 1 {
        return write_alone(next.into_items().chain(items), append, out);
    }
    let mut made = Window::new();
    while next.bytes > 0 {
        rayon::in_place_scope(|scope| {
            scope.spawn(|_| next.make(&append));
            made.write(out)?;
            made.take(&mut items, &size);
            io::Result::Ok(())
        })?;
        std::mem::swap(&mut next, &mut made);
    }
    made.write(out)
}

/// The same on the current thread alone.
fn write_alone<T>(
    items: impl Iterator<Item = T>,
    append: impl Fn(&T, &mut Vec<u8>),
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut text = Vec::new();
    for item in items {
        append(&item, &mut text);
        if text.len() >= TASK {
            out.write_all(&text)?;
            text.clear();
        }
    }
    out.write_all(&text)
}

/// Consecutive items, with their texts between the time they are made and the time they are written.
struct Window<T> {
    tasks: Vec<Task<T>>,
    /// The number of items; buffers of earlier items are used again.
    count: usize,
    /// The approximate length of the texts; 0 if there are no items.
    bytes: u64,
}

struct Task<T> {
    items: Vec<T>,
    text: Vec<u8>,
}

impl<T: Send> Window<T> {
    fn new() -> Self {
        Self {
            tasks: Vec::new(),
            count: 0,
            bytes: 0,
        }
    }

    fn tasks(&mut self) -> &mut [Task<T>] {
        &mut self.tasks[..self.count]
    }

    fn into_items(self) -> impl Iterator<Item = T> {
        self.tasks.into_iter().flat_map(|task| task.items)
    }

    /// Replaces the items by the next ones.
    fn take(&mut self, items: &mut impl Iterator<Item = T>, size: impl Fn(&T) -> u64) {
        (self.count, self.bytes) = (0, 0);
        let mut room = 0;
        while self.bytes < WINDOW
            && let Some(item) = items.next()
        {
            if room == 0 {
                room = TASK as u64;
                if self.count == self.tasks.len() {
                    self.tasks.push(Task {
                        items: Vec::new(),
                        text: Vec::new(),
                    });
                }
                self.tasks[self.count].items.clear();
                self.count += 1;
            }
            let bytes = size(&item).max(1);
            self.bytes += bytes;
            room = room.saturating_sub(bytes);
            self.tasks[self.count - 1].items.push(item);
        }
    }

    /// Makes the texts on all threads.
    fn make(&mut self, append: impl Fn(&T, &mut Vec<u8>) + Sync) {
        let tasks = self.tasks().par_iter_mut();
        tasks.for_each(|Task { items, text }| {
            text.reserve(TASK + TASK / 4);
            items.iter().for_each(|item| append(item, text));
        });
    }

    /// Writes the texts and clears them. The memory of unusually long texts is freed.
    fn write(&mut self, out: &mut dyn Write) -> io::Result<()> {
        for Task { text, .. } in self.tasks() {
            out.write_all(text)?;
            text.clear();
            text.shrink_to(4 * TASK);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        /// Lengths around all limits, with right and wrong sizes, called from a thread of a pool and from another thread.
        #[test]
        fn all_pieces_come_in_their_order(
            lengths in prop::collection::vec(prop_oneof![0usize..9, 30_000usize..90_000], 0..300),
            factor in prop_oneof![Just(0), Just(1), Just(1000)],
            threads in 1usize..4, from_outside in any::<bool>(),
        ) {
            let append = |&(n, length): &(usize, usize), text: &mut Vec<u8>| {
                text.extend_from_slice(format!("{n}:").as_bytes());
                text.resize(text.len() + length, b'.');
            };
            let items = || lengths.iter().copied().enumerate();
            let size = |&(_, length): &(usize, usize)| length as u64 * factor;
            let mut expected = Vec::new();
            for item in items() {
                append(&item, &mut expected);
            }
            let write = || {
                let mut found = Vec::new();
                write_in_order(items(), size, append, &mut found).map(|()| found)
            };
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let found = if from_outside { write()? } else { pool.install(write)? };
            prop_assert!(found == expected);
        }

        /// A full disk gives an error.
        #[test]
        fn what_cannot_be_written_is_an_error(lengths in prop::collection::vec(0usize..90_000, 1..90), part in 0usize..100) {
            struct Full(usize);
            impl Write for Full {
                fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
                    let taken = bytes.len().min(self.0);
                    self.0 -= taken;
                    Ok(taken)
                }
                fn flush(&mut self) -> io::Result<()> {
                    Ok(())
                }
            }
            let append = |length: &usize, text: &mut Vec<u8>| text.resize(text.len() + length, b'.');
            let write = |out: &mut Full| {
                write_in_order(lengths.iter().copied(), |length| *length as u64, append, out)
            };
            let whole: usize = lengths.iter().sum();
            prop_assert!(write(&mut Full(whole)).is_ok());
            let some = whole * part / 100;
            prop_assert_eq!(write(&mut Full(some)).is_err(), some < whole);
        }
    }
}
