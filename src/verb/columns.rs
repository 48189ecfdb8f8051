//! Points from Parquet and Arrow files.

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek};
use std::sync::Arc;

use arrow::array::RecordBatch;
use arrow::csv::WriterBuilder;
use arrow::datatypes::{Schema, SchemaRef};
use arrow::error::ArrowError;
use arrow::ipc::reader::{FileReader, StreamReader};
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;

use super::column_format::ColumnFormat;
use crate::error::{Error, Result};

/// The number of rows that are read at a time.
const ROWS: usize = 8192;
/// The first bytes of an Arrow file that is no stream.
const ARROW_FILE: &[u8] = b"ARROW1";

/// The names and the types of the columns of a file that stores its rows by columns.
#[derive(Clone, Debug)]
pub struct ColumnTypes(pub(crate) SchemaRef);

/// The batches of rows of a file.
type Batches = Box<dyn Iterator<Item = std::result::Result<RecordBatch, ArrowError>>>;

/// The rows of a file as text, batch by batch: first the names of the columns, then their values, separated by commas.
struct TextOfRows {
    batches: Batches,
    /// The columns that are not lists or structures of values.
    plain: Vec<usize>,
    is_first: bool,
    text: Vec<u8>,
    done: usize,
}

/// The rows of a file as text, and the types of their columns. Columns of lists and of structures are left out. Each number is written as
/// the shortest decimal that is its double.
///
/// # Errors
/// [`Error::Data`] for a file that is damaged or packed in a way that is not known.
pub(super) fn rows_of_columns(
    mut file: File,
    format: ColumnFormat,
    place: &str,
) -> Result<(Box<dyn BufRead>, ColumnTypes)> {
    let wrong = |error: String| Error::data(place, error);
    let (schema, batches): (SchemaRef, Batches) = match format {
        ColumnFormat::Parquet => {
            let builder = ParquetRecordBatchReaderBuilder::try_new(file)
                .map_err(|error| wrong(error.to_string()))?;
            let schema = builder.schema().clone();
            let reader = builder
                .with_batch_size(ROWS)
                .build()
                .map_err(|error| wrong(error.to_string()))?;
            (schema, Box::new(reader))
        }
        ColumnFormat::Arrow => {
            let mut first = Vec::new();
            let failed = |source| Error::Io {
                path: place.into(),
                source,
            };
            let length = ARROW_FILE.len() as u64;
            (&mut file)
                .take(length)
                .read_to_end(&mut first)
                .map_err(failed)?;
            file.rewind().map_err(failed)?;
            if first == ARROW_FILE {
                let reader = FileReader::try_new(BufReader::new(file), None)
                    .map_err(|error| wrong(error.to_string()))?;
                (reader.schema(), Box::new(reader))
            } else {
                let reader = StreamReader::try_new(BufReader::new(file), None)
                    .map_err(|error| wrong(error.to_string()))?;
                (reader.schema(), Box::new(reader))
            }
        }
    };
    let is_plain = |k: &usize| !schema.field(*k).data_type().is_nested();
    let plain: Vec<usize> = (0..schema.fields().len()).filter(is_plain).collect();
    let fields: Vec<_> = plain.iter().map(|k| schema.fields()[*k].clone()).collect();
    let types = ColumnTypes(Arc::new(Schema::new(fields)));
    let rows = TextOfRows {
        batches,
        plain,
        is_first: true,
        text: Vec::new(),
        done: 0,
    };
    Ok((Box::new(BufReader::with_capacity(1 << 16, rows)), types))
}

impl TextOfRows {
    /// Writes the next batch as text; `false` after the last one.
    fn advance(&mut self) -> std::io::Result<bool> {
        self.text.clear();
        self.done = 0;
        let Some(batch) = self.batches.next() else {
            return Ok(false);
        };
        let written = batch.and_then(|batch| {
            let batch = batch.project(&self.plain)?;
            let builder = WriterBuilder::new().with_header(self.is_first);
            builder.build(&mut self.text).write(&batch)
        });
        written.map_err(std::io::Error::other)?;
        self.is_first = false;
        Ok(true)
    }
}

impl Read for TextOfRows {
    fn read(&mut self, bytes: &mut [u8]) -> std::io::Result<usize> {
        while self.done == self.text.len() {
            if !self.advance()? {
                return Ok(0);
            }
        }
        let count = (&self.text[self.done..]).read(bytes)?;
        self.done += count;
        Ok(count)
    }
}
