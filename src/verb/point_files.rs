//! Files of points: tables as text, the vertices of PLY files, and NumPy arrays.

use std::fs::File;
use std::io::{BufRead, BufReader, Cursor};
use std::path::Path;

use super::column_format::ColumnFormat;
use super::point_source::PointRows;
use crate::error::{Error, Result};
use crate::fit::rows_of_array;
use crate::reading::{MAX_MESH_BYTES, bytes_within, rows_of_ply};

impl PointRows {
    /// The points of a file: of a PLY file its vertices, of a NumPy array (`.npy`) of the shape (n, 2) or (n, 3) its rows, and otherwise the
    /// rows of a table. A PLY file is read like a table whose first row has the names of the properties of its vertices, and so are Parquet
    /// and Arrow files (with the feature `columnar`). Tables and files of columns are read piece by piece, so they may be longer than the
    /// memory; the other files are read at once.
    ///
    /// # Errors
    /// [`Error::Io`] for a file that cannot be read; [`Error::Usage`] for a folder; [`Error::Limit`] for a PLY file or an array of more than
    /// [`MAX_MESH_BYTES`]; [`Error::Data`] for a damaged file, and for one of which the coordinates are not known.
    pub fn open(path: &Path) -> Result<Self> {
        let place = path.display().to_string();
        if path.is_dir() {
            return Err(Error::Usage(format!("--points {place}: that is a folder")));
        }
        #[cfg_attr(
            not(feature = "columnar"),
            expect(unused_variables, reason = "an error without the feature")
        )]
        let format = ColumnFormat::of(path)?;
        let failed = |source| Error::Io {
            path: path.to_owned(),
            source,
        };
        let file = File::open(path).map_err(failed)?;
        let size = file.metadata().map_err(failed)?.len();
        #[cfg(feature = "columnar")]
        if let Some(format) = format {
            let (reader, types) = super::columns::rows_of_columns(file, format, &place)?;
            return Ok(Self::new(reader, &place, 0)?.with_types(types));
        }
        let extension = path.extension().and_then(|e| e.to_str());
        let convert = match extension.map(str::to_ascii_lowercase).as_deref() {
            Some("ply") => rows_of_ply,
            Some("npy") => rows_of_array,
            _ => {
                let reader = BufReader::with_capacity(1 << 16, file);
                return Self::new(Box::new(reader), &place, size);
            }
        };
        let bytes = bytes_within(file, MAX_MESH_BYTES as u64, &place)?
            .ok_or_else(|| Error::limit(format!("{place} has more than {MAX_MESH_BYTES} bytes")))?;
        let text = convert(&bytes, &place)?;
        let size = text.len() as u64;
        let reader: Box<dyn BufRead> = Box::new(Cursor::new(text));
        Self::new(reader, &place, size)
    }
}
