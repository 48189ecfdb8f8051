//! Long lists of pieces of text, made in parallel and written in their order.

use std::io::{self, Write};

use rayon::prelude::*;

/// Text of about so many bytes is made before it is written: memory is bounded by it and by one piece.
const WINDOW: u64 = 1 << 22;

/// Shorter text is made without other threads.
const PARALLEL_FROM: u64 = 1 << 16;

/// Writes what `append` makes of each item. `size` is about the bytes of it; the bytes written do not depend on it, nor
/// on the number of threads.
///
/// # Errors
/// Those of `out` and of `append`.
pub(super) fn write_in_order<T: Sync>(
    items: impl Iterator<Item = T>,
    size: impl Fn(&T) -> u64,
    append: impl Fn(&T, &mut Vec<u8>) -> io::Result<()> + Sync,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut items = items.peekable();
    let (mut window, mut text) = (Vec::new(), Vec::new());
    while items.peek().is_some() {
        window.clear();
        let mut bytes = 0;
        while bytes < WINDOW
            && let Some(item) = items.next()
        {
            bytes += size(&item);
            window.push(item);
        }
        if bytes < PARALLEL_FROM {
            for item in &window {
                text.clear();
                append(item, &mut text)?;
                out.write_all(&text)?;
            }
            continue;
        }
        let pieces = window.par_iter().map(|item| {
            let mut text = Vec::new();
            append(item, &mut text)?;
            Ok(text)
        });
        for piece in pieces.collect::<io::Result<Vec<_>>>()? {
            out.write_all(&piece)?;
        }
    }
    Ok(())
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
                Ok(())
            };
            let items = || lengths.iter().copied().enumerate();
            let mut expected = Vec::new();
            for item in items() {
                append(&item, &mut expected)?;
            }
            let mut found = Vec::new();
            write_in_order(items(), |&(_, length)| length as u64 * factor, append, &mut found)?;
            prop_assert!(found == expected);
        }
    }
}
