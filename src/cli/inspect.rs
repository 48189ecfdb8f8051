//! `stellate inspect`: decides whether points are within a tolerance of a form (Theorem 8).

use std::io::BufReader;
use std::path::Path;

#[cfg(feature = "columnar")]
use stellate::document::ColumnWriter;
use stellate::document::{
    Format, InspectionWriter, ReportHead, summary_text, write_inspection_cloud,
    write_inspection_report,
};
use stellate::error::{Error, Result};
use stellate::exact::Rational;
use stellate::inspect::InspectionSummary;
use stellate::verb::{
    self, ColumnFormat, FigureFormat, InspectionOptions, InspectionTask, KeptPoint, PointRows,
    PointSource, ReadingOptions,
};

use super::flags::FitFlags;
use super::input;
use super::inspect_arguments::Inspect;
use super::output::{
    check_destination, check_folder, check_place, today, write_beside, write_page, write_result,
};
use super::session::Session;

/// The number of significant digits of distances without `--digits`.
const DIGITS: u32 = 6;

pub(crate) fn run(flags: &Inspect, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let plot = flags.plot.as_deref();
    for (option, path) in [("--plot", plot), ("--cloud", flags.cloud.as_deref())] {
        if let Some(path) = path {
            check_place(option, path)?;
        }
    }
    let figure = plot
        .map(|path| FigureFormat::of("--plot", path))
        .transpose()?;
    check_cloud(flags)?;
    if let Some(folder) = &flags.report {
        check_folder("--report", folder)?;
    }
    let columns = column_format(session)?;
    let options = options(flags, session);
    if let Some(name) = &flags.points {
        input::refuse_output(name, session)?;
    }
    let points = points(flags)?;
    let dimension = points.dimension()?;
    let given = input::read_outline(&flags.form, &flags.outline, session)?;
    let form = given.whole_name();
    let task = verb::inspect(given, dimension, &options, &session.work)?;
    let format = session.format_or(Format::Csv);
    let mut writer = InspectionWriter::new(format, dimension, session.decimals())?;
    if flags.keep {
        writer = writer.keeping(points.other_names());
    }
    if flags.feet {
        writer = writer.with_feet();
    }
    let reading = ReadingOptions::default()
        .numbers(session.numbers())
        .skip_bad(flags.skip_bad)
        .keep(figure.is_some() || flags.cloud.is_some() || flags.report.is_some())
        .feet(flags.feet)
        .with_ranges(format != Format::Csv)
        .streamed(session.common.output.is_none());
    let (summary, kept) = write_all(&task, points, &reading, &writer, columns, session)?;
    let number = match flags.points {
        Some(_) => "row",
        None => "point",
    };
    session.note(&summary_text(&summary, number));
    if let Some(path) = &flags.cloud {
        let mut bytes = Vec::new();
        write_inspection_cloud(&kept, task.zone(), &mut bytes)?;
        write_beside(path, &bytes, session)?;
    }
    if let (Some(path), Some(figure)) = (plot, figure) {
        let svg = task.picture(&kept, flags.window, &session.work)?;
        let bytes = session.work.stage("draw", || figure.bytes(svg))?;
        write_beside(path, &bytes, session)?;
    }
    if let Some(folder) = &flags.report {
        let map = task.picture(&kept, flags.window, &session.work)?;
        let mut head = ReportHead::new(form, task.zone().clone());
        head.number = number;
        head.command = command();
        head.date = today();
        let mut page = Vec::new();
        write_inspection_report(&head, &summary, &kept, &map, &mut page)?;
        write_page(folder, &page, session)?;
    }
    finish(&summary, flags, session)
}

/// The command, as it can be typed again.
fn command() -> String {
    let words = std::env::args().skip(1).map(|word| {
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./,=".contains(c);
        match word.chars().all(is_plain) && !word.is_empty() {
            true => word,
            false => format!("'{}'", word.replace('\'', r"'\''")),
        }
    });
    std::iter::once("stellate".to_owned())
        .chain(words)
        .collect::<Vec<_>>()
        .join(" ")
}

fn options(flags: &Inspect, session: &Session) -> InspectionOptions {
    let fit = FitFlags {
        model: flags.model,
        harmonics: flags.harmonics,
        distance: flags.distance.clone(),
        center: flags.center.clone(),
        ..FitFlags::default()
    };
    let [lower, upper] = flags.tolerance.limits();
    InspectionOptions::default()
        .tolerance(upper.clone())
        .lower(Some(lower.clone()))
        .uncertainty(flags.uncertainty.clone().unwrap_or_else(Rational::zero))
        .reach(flags.reach.as_ref().map(Rational::to_f64))
        .digits(session.common.digits.unwrap_or(DIGITS))
        .budget(flags.budget)
        .fit(input::fit_options(&fit))
}

/// The points of the arguments. A table is read up to its first row.
fn points(flags: &Inspect) -> Result<PointSource> {
    let Some(name) = &flags.points else {
        if flags.point.is_empty() {
            return Err(Error::Usage(
                "inspect needs points: --point X,Y[,Z], which may be repeated, or --points FILE.csv with rows x,y[,z]".into(),
            ));
        }
        return Ok(PointSource::Texts(flags.point.clone()));
    };
    if name == "-" {
        let reader = Box::new(BufReader::new(std::io::stdin()));
        return Ok(PointSource::Rows(PointRows::new(
            reader,
            "standard input",
            0,
        )?));
    }
    Ok(PointSource::Rows(PointRows::open(Path::new(name))?))
}

/// Sets the exit code: 3 if a point is undecided, otherwise 1 if a point is outside or uncertain.
fn finish(summary: &InspectionSummary, flags: &Inspect, session: &mut Session) -> Result<()> {
    if summary.undecided > 0 {
        return Err(Error::Limit {
            limit: format!("--budget {} cubes", flags.budget),
            finished: format!(
                "{} of {} points are undecided; all others are decided and written",
                summary.undecided,
                summary.points()
            ),
        });
    }
    if summary.outside > 0 || summary.uncertain.is_some_and(|count| count > 0) {
        session.answer_no();
    }
    Ok(())
}

/// The kind of file of columns that the name of the output means.
fn column_format(session: &Session) -> Result<Option<ColumnFormat>> {
    let Some(path) = &session.common.output else {
        return Ok(None);
    };
    let columns = ColumnFormat::of(path)?;
    match session.common.format {
        Some(format) if columns.is_some() && format != Format::Csv => Err(Error::Usage(format!(
            "-o {} means a file of columns; leave --format out",
            path.display()
        ))),
        _ => Ok(columns),
    }
}

/// Writes the verdicts as they are found. Points are returned only if `reading` says that they are kept.
fn write_all(
    task: &InspectionTask,
    points: PointSource,
    reading: &ReadingOptions,
    writer: &InspectionWriter,
    columns: Option<ColumnFormat>,
    session: &Session,
) -> Result<(InspectionSummary, Vec<KeptPoint>)> {
    let mut found = (InspectionSummary::default(), Vec::new());
    write_result(session, |out| {
        found = match columns {
            #[cfg(feature = "columnar")]
            Some(format) => {
                let mut file = ColumnWriter::new(format, points.types(), out);
                let found = task.all(points, reading, writer, &mut file, &session.work)?;
                file.finish()?;
                found
            }
            _ => task.all(points, reading, writer, out, &session.work)?,
        };
        Ok(())
    })?;
    Ok(found)
}

fn check_cloud(flags: &Inspect) -> Result<()> {
    let is_ply = |path: &Path| {
        path.extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("ply"))
    };
    match &flags.cloud {
        Some(path) if !is_ply(path) => Err(Error::Usage(format!(
            "--cloud {}: a cloud of points is a .ply file",
            path.display()
        ))),
        _ => Ok(()),
    }
}
