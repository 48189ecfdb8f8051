//! Long lists of pieces of text, made in parallel and written in their order.

use std::io::{self, Write};

use rayon::prelude::*;

/// Text of about so many bytes is made while as much is written: memory is bounded by both, and by a piece of each.
const WINDOW: u64 = 1 << 20;

/// Pieces of about so many bytes together are made by one thread.
const TASK: usize = 1 << 15;

/// Shorter text is made without other threads.
const PARALLEL_FROM: u64 = 1 << 16;

/// Writes what `append` makes of each item. `size` is about the bytes of it; the bytes written do not depend on it, nor
/// on the number of threads.
///
/// # Errors
/// Those of `out`.
pub(super) fn write_in_order<T: Send>(
    mut items: impl Iterator<Item = T>,
    size: impl Fn(&T) -> u64,
    append: impl Fn(&T, &mut Vec<u8>) + Sync,
    out: &mut dyn Write,
) -> io::Result<()> {
    let (mut next, mut made) = (Window::new(), Window::new());
    next.take(&mut items, &size);
    while next.bytes > 0 {
        if next.bytes < PARALLEL_FROM || rayon::current_num_threads() == 1 {
            made.write(out)?;
            for task in next.tasks() {
                task.make(&append);
                task.write(out)?;
            }
            made.take(&mut items, &size);
        } else {
            rayon::in_place_scope(|scope| {
                scope.spawn(|_| next.make(&append));
                made.write(out)?;
                made.take(&mut items, &size);
                io::Result::Ok(())
            })?;
        }
        (next, made) = (made, next);
    }
    made.write(out)
}

/// Items and their text, one after the other; the memory of it is used again.
struct Window<T> {
    tasks: Vec<Task<T>>,
    /// As many of them have items.
    count: usize,
    /// About as long is the text of all items; not 0 if there are any.
    bytes: u64,
}

struct Task<T> {
    items: Vec<T>,
    /// What is made of the items, and not written.
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

    /// The next items in place of those that are there.
    fn take(&mut self, items: &mut impl Iterator<Item = T>, size: impl Fn(&T) -> u64) {
        (self.count, self.bytes) = (0, 0);
        let mut bytes = TASK as u64;
        while self.bytes < WINDOW
            && let Some(item) = items.next()
        {
            if bytes >= TASK as u64 {
                bytes = 0;
                if self.count == self.tasks.len() {
                    self.tasks.push(Task {
                        items: Vec::new(),
                        text: Vec::new(),
                    });
                }
                self.tasks[self.count].items.clear();
                self.count += 1;
            }
            let more = size(&item).max(1);
            bytes += more;
            self.bytes += more;
            self.tasks[self.count - 1].items.push(item);
        }
    }

    /// Makes the text of all items, on all threads.
    fn make(&mut self, append: impl Fn(&T, &mut Vec<u8>) + Sync) {
        let tasks = self.tasks().par_iter_mut();
        tasks.for_each(|task| task.make(&append));
    }

    fn write(&mut self, out: &mut dyn Write) -> io::Result<()> {
        self.tasks().iter_mut().try_for_each(|task| task.write(out))
    }
}

impl<T> Task<T> {
    fn make(&mut self, append: impl Fn(&T, &mut Vec<u8>)) {
        for item in &self.items {
            append(item, &mut self.text);
        }
    }

    /// Writes the text that is made, and forgets it.
    fn write(&mut self, out: &mut dyn Write) -> io::Result<()> {
        out.write_all(&self.text)?;
        self.text.clear();
        // That of a long piece.
        self.text.shrink_to(4 * TASK);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        /// Sizes around both limits, right or wrong.
        #[test]
        fn all_pieces_come_in_their_order(
            lengths in prop::collection::vec(prop_oneof![0usize..9, 30_000usize..90_000], 0..300),
            factor in prop_oneof![Just(0), Just(1), Just(1000)],
        ) {
            let append = |&(n, length): &(usize, usize), text: &mut Vec<u8>| {
                text.extend_from_slice(format!("{n}:").as_bytes());
                text.resize(text.len() + length, b'.');
            };
            let items = || lengths.iter().copied().enumerate();
            let mut expected = Vec::new();
            for item in items() {
                append(&item, &mut expected);
            }
            let mut found = Vec::new();
            write_in_order(items(), |&(_, length)| length as u64 * factor, append, &mut found)?;
            prop_assert!(found == expected);
        }
    }
}
