//! Inspected points as Parquet and Arrow files, which store their rows by columns.

use std::io::Write;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use arrow::array::{ArrayRef, BooleanArray, RecordBatch, StringArray};
use arrow::csv::ReaderBuilder;
use arrow::csv::reader::Decoder;
use arrow::datatypes::{DataType, Field, Schema, SchemaRef};
use arrow::ipc::writer::FileWriter;
use parquet::arrow::ArrowWriter;
use parquet::basic::Compression;
use parquet::file::properties::WriterProperties;

use crate::error::{Invariant, Result};
use crate::verb::{ColumnFormat, ColumnTypes};

/// The number of rows that are written at a time.
const ROWS: usize = 8192;

/// Bytes on their way from the writer of a file to its destination.
#[derive(Clone, Default)]
struct Passing(Arc<Mutex<Vec<u8>>>);

impl Passing {
    fn bytes(&self) -> MutexGuard<'_, Vec<u8>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Write for Passing {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.bytes().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// The writer of the file.
enum Inner {
    Parquet(Box<ArrowWriter<Passing>>),
    Arrow(Box<FileWriter<Passing>>),
}

/// The file, after the names of its columns are known.
struct Open {
    decoder: Decoder,
    /// The columns as they are written.
    schema: SchemaRef,
    inner: Inner,
}

/// Takes the verdicts of an inspection as CSV, as [`InspectionWriter`](super::InspectionWriter) writes them, and writes them as columns:
/// coordinates, distances and other numbers as doubles, `sign` as a small integer, `curve` as true, false or null, and the columns that
/// are carried along in the type that they have in their file, or as text.
///
/// Coordinates are rounded to doubles. The distances remain those of the exact points.
pub struct ColumnWriter<'w> {
    format: ColumnFormat,
    types: Option<ColumnTypes>,
    out: &'w mut dyn Write,
    passing: Passing,
    /// The first line, until it is complete.
    head: Vec<u8>,
    open: Option<Open>,
}

impl std::fmt::Debug for ColumnWriter<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ColumnWriter")
            .field("format", &self.format)
            .field("types", &self.types)
            .finish_non_exhaustive()
    }
}

impl<'w> ColumnWriter<'w> {
    /// A writer to `out`; `types` are those of the file that the points come from.
    pub fn new(format: ColumnFormat, types: Option<ColumnTypes>, out: &'w mut dyn Write) -> Self {
        Self {
            format,
            types,
            out,
            passing: Passing::default(),
            head: Vec::new(),
            open: None,
        }
    }

    /// Writes what is left.
    ///
    /// # Errors
    /// [`Error::Io`](crate::error::Error::Io) if the destination does not take the bytes.
    ///
    /// # Panics
    /// If the CSV has no line of names.
    pub fn finish(mut self) -> Result<()> {
        self.write_batch()?;
        let open = self.open.take();
        match open.invariant("the names of the columns come first").inner {
            Inner::Parquet(writer) => {
                writer.close().map_err(std::io::Error::other)?;
            }
            Inner::Arrow(mut writer) => writer.finish().map_err(std::io::Error::other)?,
        }
        self.pass_on()?;
        Ok(())
    }

    /// Opens the file when the names of its columns are known.
    fn begin(&mut self) -> std::io::Result<()> {
        let head = String::from_utf8_lossy(&self.head);
        let mut rows = csv::ReaderBuilder::new()
            .has_headers(false)
            .from_reader(head.as_bytes());
        let names = rows.records().next().transpose()?;
        let names = names.invariant("the first line has names");
        let own = names.iter().position(|name| name == "sign");
        let fields: Vec<Field> = names
            .iter()
            .enumerate()
            .map(|(k, name)| {
                let is_own = own.is_some_and(|last| k <= last) || is_of_a_foot(name);
                let of = if is_own {
                    own_type(name)
                } else {
                    self.type_of(name)
                };
                Field::new(name, of, true)
            })
            .collect();
        let read = Arc::new(Schema::new(
            fields
                .iter()
                .map(|field| match field.data_type() {
                    DataType::Boolean if field.name() == CURVE => {
                        Field::new(CURVE, DataType::Utf8, true)
                    }
                    _ => field.clone(),
                })
                .collect::<Vec<_>>(),
        ));
        let schema = Arc::new(Schema::new(fields));
        let decoder = ReaderBuilder::new(read)
            .with_header(false)
            .with_batch_size(ROWS)
            .build_decoder();
        let passing = self.passing.clone();
        let inner = match self.format {
            ColumnFormat::Parquet => {
                let properties = WriterProperties::builder()
                    .set_compression(Compression::SNAPPY)
                    .build();
                let writer = ArrowWriter::try_new(passing, schema.clone(), Some(properties))
                    .map_err(std::io::Error::other)?;
                Inner::Parquet(Box::new(writer))
            }
            ColumnFormat::Arrow => {
                let writer = FileWriter::try_new(passing, &schema);
                Inner::Arrow(Box::new(writer.map_err(std::io::Error::other)?))
            }
        };
        self.open = Some(Open {
            decoder,
            schema,
            inner,
        });
        Ok(())
    }

    /// The type of a column that is carried along.
    fn type_of(&self, name: &str) -> DataType {
        let field = self
            .types
            .as_ref()
            .and_then(|types| types.0.field_with_name(name).ok());
        match field.map(Field::data_type) {
            Some(of) if of.is_integer() || of.is_floating() && *of != DataType::Float16 => {
                of.clone()
            }
            Some(DataType::Boolean) => DataType::Boolean,
            _ => DataType::Utf8,
        }
    }

    /// Writes the rows that are decoded.
    fn write_batch(&mut self) -> std::io::Result<()> {
        let Some(open) = &mut self.open else {
            return Ok(());
        };
        let batch = open.decoder.flush().map_err(std::io::Error::other)?;
        if let Some(batch) = batch {
            let batch = with_truth_values(&batch, &open.schema).map_err(std::io::Error::other)?;
            match &mut open.inner {
                Inner::Parquet(writer) => writer.write(&batch).map_err(std::io::Error::other)?,
                Inner::Arrow(writer) => writer.write(&batch).map_err(std::io::Error::other)?,
            }
            self.pass_on()?;
        }
        Ok(())
    }

    fn pass_on(&mut self) -> std::io::Result<()> {
        let mut passing = self.passing.bytes();
        self.out.write_all(&passing)?;
        passing.clear();
        Ok(())
    }
}

impl Write for ColumnWriter<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if self.open.is_none() {
            let end = bytes.iter().position(|b| *b == b'\n');
            let taken = end.map_or(bytes.len(), |end| end + 1);
            self.head.extend_from_slice(&bytes[..taken]);
            if end.is_some() {
                self.begin()?;
            }
            return Ok(taken);
        }
        let mut done = 0;
        while done < bytes.len() {
            let open = self.open.as_mut().invariant("the file is open");
            let taken = open
                .decoder
                .decode(&bytes[done..])
                .map_err(std::io::Error::other)?;
            done += taken;
            if open.decoder.capacity() == 0 || taken == 0 {
                self.write_batch()?;
            }
        }
        Ok(done)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.out.flush()
    }
}

/// The column of the paper's criterion.
const CURVE: &str = "curve";

/// Whether a column is one of the foot of a point.
fn is_of_a_foot(name: &str) -> bool {
    ["foot_", "normal_", "signed_"]
        .iter()
        .any(|start| name.starts_with(start))
}

/// The type of a column that an inspection makes.
fn own_type(name: &str) -> DataType {
    match name {
        "verdict" => DataType::Utf8,
        CURVE => DataType::Boolean,
        "sign" => DataType::Int8,
        _ => DataType::Float64,
    }
}

/// The batch with `curve` as true, false or null instead of texts.
fn with_truth_values(
    batch: &RecordBatch,
    schema: &SchemaRef,
) -> std::result::Result<RecordBatch, arrow::error::ArrowError> {
    let columns = batch.columns().iter().zip(schema.fields());
    let columns = columns.map(|(column, field)| -> ArrayRef {
        let texts = column.as_any().downcast_ref::<StringArray>();
        match texts.filter(|_| *field.data_type() == DataType::Boolean) {
            Some(texts) => {
                let truth = |text: &str| match text {
                    "true" => Some(true),
                    "false" => Some(false),
                    _ => None,
                };
                let values = texts.iter().map(|text| text.and_then(truth));
                Arc::new(values.collect::<BooleanArray>())
            }
            None => column.clone(),
        }
    });
    RecordBatch::try_new(schema.clone(), columns.collect())
}
