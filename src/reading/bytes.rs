//! The bytes of a source that may be too long.

use std::io::Read;

use crate::error::{Error, Result};

/// All bytes of a source, which `place` names in messages; `None` if there are more than `most`.
///
/// # Errors
/// [`Error::Io`] if reading fails.
pub(crate) fn bytes_within(source: impl Read, most: u64, place: &str) -> Result<Option<Vec<u8>>> {
    let mut bytes = Vec::new();
    let mut limited = source.take(most + 1);
    let read = limited.read_to_end(&mut bytes);
    read.map_err(|source| Error::Io {
        path: place.into(),
        source,
    })?;
    Ok((limited.limit() > 0).then_some(bytes))
}
