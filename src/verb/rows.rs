//! The points of an inspection, read one by one or from a table of any length, in bounded memory and in parallel.

use std::io::Write;

use super::against::AskedPoint;
use super::inspect::InspectionTask;
use super::point_layout::{PointLayout, Row};
use super::point_source::{PointRows, PointSource};
use super::{Progress, Work};
use crate::error::{Error, Result};
use crate::inspect::{
    DecidedDistance, HistogramRange, InspectedPoint, Inspection, InspectionSummary, Section,
    ToleranceZone,
};
use crate::language::Numbers;
use crate::options::options;
use crate::parallel;
use crate::rows::{RowReader, row_error};
use crate::witness::{ClaimedPoint, InspectedForm, inspected_point};

/// The number of rows that are in memory at a time.
const CHUNK: usize = 1 << 15;
/// The number of rows that one thread takes at a time.
const SHARE: usize = 64;
/// The largest number of points that are kept.
const MAX_KEPT: usize = 10_000_000;

/// A point that is kept, and its inspection.
#[derive(Clone, Copy, Debug)]
pub struct KeptPoint {
    /// Its row, or its number, counted from 1.
    pub row: usize,
    /// The doubles nearest to its coordinates; z is 0 in the plane.
    pub point: [f64; 3],
    /// Its inspection.
    pub inspection: Inspection,
}

options! {
    /// How points are read.
    ReadingOptions {
        /// How numbers are read.
        numbers: Numbers = Numbers::Exact,
        /// Whether rows that are no points are skipped and only counted.
        skip_bad: bool = false,
        /// Whether the points are kept for a picture or a point cloud.
        keep: bool = false,
        /// Whether the angle ranges of the sections are computed, if there are only a few points that are given one by one.
        with_ranges: bool = false,
        /// Whether the nearest point of the form is found for every point.
        feet: bool = false,
        /// Whether the output before a row that is not a point remains; the message then says how many points that are.
        streamed: bool = false,
    }
}

/// A format in which inspected points are written, one after the other.
pub trait PointWriter: Sync {
    /// Writes the part before the first point.
    ///
    /// # Errors
    /// Those of `out`.
    fn begin(&self, zone: &ToleranceZone, out: &mut dyn Write) -> Result<()>;

    /// The text between two points.
    fn between(&self) -> &[u8];

    /// Writes one point.
    ///
    /// # Errors
    /// Those of `out`.
    fn point(&self, point: &InspectedPoint<'_>, out: &mut dyn Write) -> Result<()>;

    /// Writes the part after the last point.
    ///
    /// # Errors
    /// Those of `out`.
    fn end(&self, summary: &InspectionSummary, out: &mut dyn Write) -> Result<()>;
}

impl InspectionTask {
    fn inspected<'r>(
        &self,
        row: &'r Row<'r>,
        [written, others]: [&'r [&'r str]; 2],
        with_ranges: bool,
        reading: &ReadingOptions,
        decided: Option<&mut Vec<DecidedDistance>>,
    ) -> Result<InspectedPoint<'r>> {
        let asked = AskedPoint {
            near: row.near,
            exactly: &|| row.exactly(),
        };
        let inspection = self.point_near(asked, decided);
        let foot = match reading.feet {
            true => self.foot(&row.exactly(), &inspection),
            false => None,
        };
        let section = match with_ranges {
            true => self.section_of(&row.exactly(), &inspection)?,
            false => Section::NotAsked,
        };
        Ok(InspectedPoint {
            written,
            others,
            inspection,
            foot,
            section,
        })
    }
}

impl InspectionTask {
    /// Inspects all points and writes them with `writer`, in their order, some thousands at a time; nothing is written before
    /// the first point has been read. Returns the summary, and the points if they are kept.
    ///
    /// ```
    /// use stellate::document::{Format, InspectionWriter};
    /// use stellate::language::Numbers;
    /// use stellate::verb::{self, Given, InspectionOptions, PointRows, PointSource, ReadingOptions, Work};
    /// let work = Work::default();
    /// let given = Given::read("x^2 + y^2 = 1", Numbers::Exact)?;
    /// let task = verb::inspect(given, 2, &InspectionOptions::default(), &work)?;
    /// let rows = PointRows::new(Box::new(&b"x,y\n1,0\n5,0\n"[..]), "points", 0)?;
    /// let mut out = Vec::new();
    /// let writer = InspectionWriter::new(Format::Csv, 2, 6)?;
    /// let reading = ReadingOptions::default();
    /// let (summary, _) = task.all(PointSource::Rows(rows), &reading, &writer, &mut out, &work)?;
    /// assert_eq!((summary.inside, summary.outside), (1, 1));
    /// assert!(out.starts_with(b"x,y,verdict,curve,distance_low,distance_high,sign\n1,0,inside,true,"));
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Data`] with the number of a row that is not a point, unless such rows are skipped; [`Error::Limit`] if too many
    /// points would be kept; those of `writer` and `out`.
    pub fn all(
        &self,
        points: PointSource,
        reading: &ReadingOptions,
        writer: &dyn PointWriter,
        out: &mut dyn Write,
        work: &Work,
    ) -> Result<(InspectionSummary, Vec<KeptPoint>)> {
        let progress = work.progress("inspecting", points.size());
        let mut batch = Batch {
            task: self,
            layout: points.layout()?,
            with_ranges: reading.with_ranges && points.are_few(),
            reading,
            writer,
            work,
            summary: InspectionSummary::default(),
            kept: Vec::new(),
            claimed: None,
        };
        work.claim(|proof| {
            batch.claimed = Some(self.claimed(proof));
            Ok(())
        })?;
        match points {
            PointSource::Texts(points) => {
                let rows: Vec<(usize, String)> = (1..).zip(points).collect();
                batch.chunk(&rows, "--point", out)?;
            }
            PointSource::Rows(rows) => batch.rows(rows, &progress, out)?,
        }
        if batch.summary.points() == 0 {
            writer.begin(self.zone(), out)?;
        }
        writer.end(&batch.summary, out)?;
        Ok((batch.summary, batch.kept))
    }
}

struct Batch<'a> {
    task: &'a InspectionTask,
    layout: PointLayout,
    with_ranges: bool,
    reading: &'a ReadingOptions,
    writer: &'a dyn PointWriter,
    work: &'a Work,
    summary: InspectionSummary,
    kept: Vec<KeptPoint>,
    /// The form for claims about points, if there are claims.
    claimed: Option<InspectedForm>,
}

/// The part of the answer that one thread has found.
#[derive(Default)]
struct Share {
    text: Vec<u8>,
    summary: InspectionSummary,
    kept: Vec<KeptPoint>,
    /// The answers about which claims are made.
    claimed: Vec<ClaimedPoint>,
    /// The first row that is not a point, with its number and the reason; the rows after it are not inspected.
    wrong: Option<(usize, String)>,
}

impl Batch<'_> {
    fn rows(
        &mut self,
        source: PointRows,
        progress: &Progress<'_>,
        out: &mut dyn Write,
    ) -> Result<()> {
        let place = &source.place;
        let mut rows = RowReader::new(source.reader, place, self.layout.expected());
        loop {
            let mut chunk = Vec::with_capacity(CHUNK);
            let mut bytes = 0;
            let mut failed = None;
            while chunk.len() < CHUNK && failed.is_none() {
                match rows.next_row() {
                    Ok(Some((number, row))) => {
                        bytes += row.len() as u64 + 1;
                        chunk.push((number, row.to_owned()));
                    }
                    Ok(None) => break,
                    Err(error) => failed = Some(error),
                }
            }
            self.chunk(&chunk, place, out)?;
            match failed {
                Some(Error::Data { place, message }) => {
                    return Err(Error::data(place, message + &self.what_stands()));
                }
                Some(error) => return Err(error),
                None if chunk.is_empty() && self.summary.points() == 0 => {
                    let skipped = match self.summary.bad {
                        0 => String::new(),
                        bad => {
                            format!("; rows that are no points: {bad}, all of which were skipped")
                        }
                    };
                    return Err(Error::data(
                        place,
                        format!("there are no points in it{skipped}"),
                    ));
                }
                None if chunk.is_empty() => return Ok(()),
                None => {}
            }
            progress.add(bytes);
        }
    }

    fn chunk(&mut self, rows: &[(usize, String)], place: &str, out: &mut dyn Write) -> Result<()> {
        let rows: Vec<_> = rows.chunks(SHARE).collect();
        let shares = parallel::map(&rows, |rows| self.share(rows));
        for share in shares {
            let share = share?;
            self.write(&share, out)?;
            self.summary.join(&share.summary);
            if let Some(form) = &self.claimed {
                self.work.claim(|proof| {
                    for claimed in &share.claimed {
                        self.work.bounds().check()?;
                        inspected_point(proof, form, claimed);
                    }
                    Ok(())
                })?;
            }
            if let Some((row, message)) = share.wrong {
                return Err(row_error(place, row, message + &self.what_stands()));
            }
            if self.reading.keep {
                if self.kept.len() + share.kept.len() > MAX_KEPT {
                    return Err(Error::limit(format!(
                        "{MAX_KEPT} points for --plot and --cloud"
                    )));
                }
                self.kept.extend(share.kept);
            }
        }
        Ok(())
    }

    /// Writes the points of a share behind those of the shares before it.
    fn write(&self, share: &Share, out: &mut dyn Write) -> Result<()> {
        if share.summary.points() == 0 {
            return Ok(());
        }
        match self.summary.points() {
            0 => self.writer.begin(self.task.zone(), out)?,
            _ => out.write_all(self.writer.between())?,
        }
        Ok(out.write_all(&share.text)?)
    }

    /// The part of the message about a wrong row that says what happened to the points before it.
    fn what_stands(&self) -> String {
        match self.summary.points() {
            _ if !self.reading.streamed => String::new(),
            0 => "; nothing is written".into(),
            1 => "; the point before it is written".into(),
            count => format!("; the {count} points before it are written"),
        }
    }

    fn share(&self, rows: &[(usize, String)]) -> Result<Share> {
        let mut share = Share::default();
        let zone = self.task.zone();
        let range = HistogramRange::of(zone);
        // Bounds are rounded outward.
        let known = 1.001 * 0.1f64.powi(self.task.digits());
        for (number, text) in rows {
            self.work.bounds().check()?;
            let row = match self.layout.row(text, self.reading.numbers) {
                Ok(row) => row,
                Err(_) if self.reading.skip_bad => {
                    share.summary.bad += 1;
                    continue;
                }
                Err(message) => {
                    share.wrong = Some((*number, message));
                    break;
                }
            };
            let written = row.fields.each_ref().map(|field| &**field);
            let others: Vec<&str> = row.others.iter().map(|field| &**field).collect();
            let texts = [&written[..self.layout.dimension()], &others];
            let mut decided = Vec::new();
            let asked = self.claimed.is_some().then_some(&mut decided);
            let point = self
                .task
                .inspected(&row, texts, self.with_ranges, self.reading, asked)?;
            // An inspection that a limit has ended has no verdict.
            self.work.bounds().check()?;
            if share.summary.points() > 0 {
                share.text.extend(self.writer.between());
            }
            self.writer.point(&point, &mut share.text)?;
            if self.reading.feet && point.foot.is_none() {
                share.summary.without_foot += 1;
            }
            share.summary.add(*number, &point.inspection, &range);
            let distance = point.inspection.distance;
            if distance.high.is_infinite() {
                share.summary.not_found += 1;
            } else if distance.high - distance.low > known * distance.high {
                share.summary.few_digits += 1;
            }
            if self.claimed.is_some() {
                share.claimed.push(ClaimedPoint {
                    point: row.exactly(),
                    tolerance: zone.tolerance_of_side(point.inspection.sign),
                    inspection: point.inspection,
                    decided,
                });
            }
            if self.reading.keep {
                share.kept.push(KeptPoint {
                    row: *number,
                    point: row.near,
                    inspection: point.inspection,
                });
            }
        }
        Ok(share)
    }
}
