//! The kinds of files that store their rows by columns.

use std::path::Path;

use crate::error::{Error, Result};

/// The kinds of files that store their rows by columns. They need the feature `columnar`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ColumnFormat {
    /// Apache Parquet: `.parquet`.
    Parquet,
    /// Arrow's formats for files and for streams: `.arrow`, `.arrows`, `.feather` or `.ipc`.
    Arrow,
}

impl ColumnFormat {
    /// The format of a file by its name; `None` for any other file.
    ///
    /// # Errors
    /// [`Error::Usage`] without the feature `columnar`.
    pub fn of(path: &Path) -> Result<Option<Self>> {
        let extension = path.extension().and_then(|e| e.to_str());
        let format = match extension.map(str::to_ascii_lowercase).as_deref() {
            Some("parquet") => Self::Parquet,
            Some("arrow" | "arrows" | "feather" | "ipc") => Self::Arrow,
            _ => return Ok(None),
        };
        if cfg!(feature = "columnar") {
            return Ok(Some(format));
        }
        Err(Error::Usage(format!(
            "{}: this program was built without Parquet and Arrow; build it with --features columnar, or use a .csv file",
            path.display()
        )))
    }
}
