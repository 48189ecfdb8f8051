//! The points of an inspection: given one by one, or rows of any number, in bounded memory and in parallel.

use std::fs::File;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;

use indicatif::ProgressBar;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSlice;
use stellate::document::InspectionSummary;
use stellate::error::{Error, Result};
use stellate::exact::{Rational, double_literal, exact_literal};
use stellate::inspect::Inspection;
use stellate::language::Numbers;
use stellate::rows::{RowReader, double, fields, fields_of, row_error};

use super::arguments::Inspect;
use super::inspect::Task;

/// Rows that are in memory at a time.
const CHUNK: usize = 1 << 15;
/// Rows that one thread takes at a time.
const SHARE: usize = 64;
/// Of so few points the section is shown, too.
const FEW: usize = 16;
/// At most so many points are kept for a picture or a cloud.
const MAX_KEPT: usize = 10_000_000;

/// A point that is kept, as doubles.
pub(super) type Kept = ([f64; 3], Inspection);

/// Where the points come from.
pub(super) enum Points {
    /// From the command line.
    Given(Vec<String>),
    /// From rows: the name of the source, its first lines, and all of it.
    Rows {
        place: String,
        size: usize,
        dimension: usize,
        reader: Box<dyn BufRead>,
    },
}

/// How rows are read.
pub(super) struct Reading {
    pub(super) numbers: Numbers,
    /// Rows that are no points are counted only.
    pub(super) skip_bad: bool,
    /// Points are kept for a picture or a cloud.
    pub(super) keep: bool,
}

/// A row with its fields as written.
pub(super) struct Row<'a> {
    fields: [&'a str; 3],
    dimension: usize,
    numbers: Numbers,
    /// Nearest doubles; z is 0 in the plane.
    pub(super) near: [f64; 3],
}

impl<'a> Row<'a> {
    fn new(text: &'a str, dimension: usize, numbers: Numbers) -> std::result::Result<Self, String> {
        let expected = columns(dimension);
        let found = if dimension == 2 {
            let [x, y] = fields_of(text, expected)?;
            [x, y, ""]
        } else {
            fields_of(text, expected)?
        };
        let mut near = [0.0; 3];
        for (value, field) in near.iter_mut().zip(found).take(dimension) {
            *value = double(field).map_err(|m| format!("{m}; each row must be {expected}"))?;
        }
        Ok(Self {
            fields: found,
            dimension,
            numbers,
            near,
        })
    }

    /// The fields as written.
    pub(super) fn written(&self) -> &[&'a str] {
        &self.fields[..self.dimension]
    }

    /// The point as written, or as doubles.
    pub(super) fn exactly(&self) -> [Rational; 3] {
        std::array::from_fn(|i| {
            let read = match self.numbers {
                _ if i >= self.dimension => return Rational::zero(),
                Numbers::Exact => exact_literal(self.fields[i]),
                Numbers::F64 => double_literal(self.fields[i]),
            };
            // The field has been read as a double already.
            read.unwrap_or_default()
        })
    }
}

fn columns(dimension: usize) -> &'static str {
    if dimension == 2 { "x,y" } else { "x,y,z" }
}

impl Points {
    /// From the arguments; rows are looked at up to the first.
    pub(super) fn of(verb: &Inspect) -> Result<Self> {
        let Some(name) = &verb.points else {
            return Ok(Self::Given(verb.point.clone()));
        };
        let (place, size, source): (String, usize, Box<dyn BufRead>) = if name == "-" {
            (
                "standard input".into(),
                0,
                Box::new(BufReader::new(std::io::stdin())),
            )
        } else {
            let failed = |source| Error::Io {
                path: name.into(),
                source,
            };
            if Path::new(name).is_dir() {
                return Err(Error::Usage(format!("--points {name}: that is a folder")));
            }
            let file = File::open(name).map_err(failed)?;
            let size = file.metadata().map_err(failed)?.len();
            let size = usize::try_from(size).unwrap_or(usize::MAX);
            (
                name.clone(),
                size,
                Box::new(BufReader::with_capacity(1 << 16, file)),
            )
        };
        let mut reader = source;
        let dimension = first_width(&mut reader, &place)?;
        Ok(Self::Rows {
            place,
            size,
            dimension,
            reader,
        })
    }

    /// 2 or 3.
    pub(super) fn dimension(&self) -> Result<usize> {
        match self {
            Self::Given(points) => {
                let count = points.first().map_or(3, |text| fields(text).count());
                let wrong = points
                    .iter()
                    .find(|text| fields(text).count() != count || !(2..=3).contains(&count));
                match wrong {
                    Some(text) => Err(Error::Usage(format!(
                        "--point {text}: expected X,Y,Z, such as 0.8,0.6,0, or X,Y for a plane curve, the same for all points"
                    ))),
                    None => Ok(count),
                }
            }
            Self::Rows { dimension, .. } => Ok(*dimension),
        }
    }

    /// Whether there are so few that each is looked at closely.
    pub(super) fn are_few(&self) -> bool {
        matches!(self, Self::Given(points) if points.len() <= FEW)
    }

    /// What the progress is measured against: points, or bytes.
    pub(super) fn size(&self) -> usize {
        match self {
            Self::Given(points) => points.len(),
            Self::Rows { size, .. } => *size,
        }
    }
}

/// The number of columns of the first row that is not empty, which stays unread.
fn first_width(reader: &mut Box<dyn BufRead>, place: &str) -> Result<usize> {
    let buffer = reader.fill_buf().map_err(|source| Error::Io {
        path: place.into(),
        source,
    })?;
    let text = String::from_utf8_lossy(buffer);
    let mut rows = text.trim_start_matches('\u{feff}').lines().map(str::trim);
    let first = rows.find(|row| !row.is_empty() && !row.starts_with('#'));
    Ok(first.map_or(3, |row| if fields(row).count() == 2 { 2 } else { 3 }))
}

/// Inspects all points and writes what is found, in their order.
pub(super) fn all(
    task: &Task,
    points: Points,
    reading: &Reading,
    bar: &ProgressBar,
    out: &mut dyn Write,
) -> Result<(InspectionSummary, Vec<Kept>)> {
    let mut batch = Batch {
        task,
        dimension: points.dimension()?,
        reading,
        summary: InspectionSummary::default(),
        kept: Vec::new(),
    };
    match points {
        Points::Given(points) => {
            let rows: Vec<(usize, String)> = (1..).zip(points).collect();
            batch.chunk(
                &rows,
                &|_, message| Error::Usage(format!("--point: {message}")),
                out,
            )?;
        }
        Points::Rows { place, reader, .. } => {
            let mut rows = RowReader::new(reader, &place, columns(batch.dimension));
            loop {
                let mut chunk = Vec::with_capacity(CHUNK);
                let mut bytes = 0;
                while chunk.len() < CHUNK
                    && let Some((number, row)) = rows.next_row()?
                {
                    bytes += row.len() as u64 + 1;
                    chunk.push((number, row.to_owned()));
                }
                if chunk.is_empty() {
                    break;
                }
                batch.chunk(&chunk, &|row, message| row_error(&place, row, message), out)?;
                bar.inc(bytes);
            }
        }
    }
    Ok((batch.summary, batch.kept))
}

struct Batch<'a> {
    task: &'a Task,
    dimension: usize,
    reading: &'a Reading,
    summary: InspectionSummary,
    kept: Vec<Kept>,
}

/// What one thread has found.
#[derive(Default)]
struct Part {
    text: Vec<u8>,
    summary: InspectionSummary,
    kept: Vec<Kept>,
}

impl Batch<'_> {
    fn chunk(
        &mut self,
        rows: &[(usize, String)],
        error: &(dyn Fn(usize, String) -> Error + Sync),
        out: &mut dyn Write,
    ) -> Result<()> {
        let before = self.summary.points();
        let parts = rows.par_chunks(SHARE).enumerate();
        let parts = parts.map(|(n, rows)| self.part(rows, before + n == 0, error));
        // The first row that is wrong, not the first that is found.
        let parts: Vec<Result<Part>> = parts.collect();
        for part in parts {
            let part = part?;
            out.write_all(&part.text).map_err(|source| Error::Io {
                path: "output".into(),
                source,
            })?;
            self.summary.join(&part.summary);
            if self.reading.keep {
                if self.kept.len() + part.kept.len() > MAX_KEPT {
                    return Err(Error::Limit {
                        limit: format!("{MAX_KEPT} points for --plot and --cloud"),
                        finished: String::new(),
                    });
                }
                self.kept.extend(part.kept);
            }
        }
        Ok(())
    }

    fn part(
        &self,
        rows: &[(usize, String)],
        is_first: bool,
        error: &(dyn Fn(usize, String) -> Error + Sync),
    ) -> Result<Part> {
        let mut part = Part::default();
        for (number, text) in rows {
            self.task.limits.check()?;
            let row = match Row::new(text, self.dimension, self.reading.numbers) {
                Ok(row) => row,
                Err(_) if self.reading.skip_bad => {
                    part.summary.bad += 1;
                    continue;
                }
                Err(message) => return Err(error(*number, message)),
            };
            let point = self.task.inspect(&row)?;
            // What was cut short is no verdict.
            self.task.limits.check()?;
            let is_first = is_first && part.summary.points() == 0;
            let written = self.task.writer.point(&point, is_first, &mut part.text);
            written.map_err(|source| Error::Io {
                path: "output".into(),
                source,
            })?;
            part.summary.add(*number, &point.inspection);
            if self.reading.keep {
                part.kept.push((row.near, point.inspection));
            }
        }
        Ok(part)
    }
}
