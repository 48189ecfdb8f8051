//! `stellate check`: compares the numbers of a float program with the exact ones.

use std::path::Path;

use stellate::document::{Format, Kind, write_check, write_ladder};
use stellate::error::{Error, Result};
use stellate::picture::Chart;
use stellate::verb::{self, CheckOptions, FigureFormat, FloatKind, digits_chart, ladder_chart};

use super::check_arguments::{Check, CheckedData};
use super::input;
use super::output::{check_destination, check_place, write_beside, write_result};
use super::session::Session;

pub(crate) fn run(flags: &Check, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    Kind::Check.check(format)?;
    let mark = session.common.digits;
    if flags.plot.is_some() && flags.plot == session.common.output {
        return Err(Error::Usage(
            "--plot and -o name the same file: one is for the figure, the other for the report"
                .into(),
        ));
    }
    let figure = flags.plot.as_deref().map(Picture::named).transpose()?;
    let data = numbers(&flags.data);
    if flags.reference == "-" && data.is_some_and(|(_, file)| file == "-") {
        return Err(Error::Usage(
            "standard input (-) is either the reference or the file that is checked, not both"
                .into(),
        ));
    }
    if flags.data.itself && mark.is_some() {
        return Err(Error::Usage(
            "--digits is the mark for the numbers of a file; --self says what doubles keep".into(),
        ));
    }
    let options = CheckOptions::default().fit(input::fit_options(&flags.fit));
    let given = input::read_with(&flags.reference, &flags.fit, session)?;
    let name = given.short_name();
    let Some((kind, file)) = data else {
        let rungs = verb::check_doubles(given, &options, &session.work)?;
        if let Some(figure) = figure {
            figure.write(&ladder_chart(&rungs, &name), session)?;
        }
        return write_result(session, |out| write_ladder(&rungs, format, out));
    };
    let task = verb::check(given, &options, &session.work)?;
    let (text, source) = session
        .work
        .stage("read", || input::read_data(file, session))?;
    let numbers = task.read(kind, &text, &source)?;
    let found = task.compare(&numbers, &source, &session.work)?;
    if let Some(figure) = figure {
        figure.write(&digits_chart(&found, mark, &name), session)?;
    }
    write_result(session, |out| write_check(&found, mark, format, out))?;
    if !found.passes(mark) {
        session.answer_no();
    }
    Ok(())
}

/// The kind of numbers that are checked, and their file; `None` for `--self`.
fn numbers(data: &CheckedData) -> Option<(FloatKind, &str)> {
    let files = [
        (FloatKind::Coefficients, &data.coefficients),
        (FloatKind::Points, &data.points),
        (FloatKind::Radii, &data.radii),
    ];
    files
        .into_iter()
        .find_map(|(kind, file)| Some((kind, file.as_deref()?)))
}

/// A figure that will be written. Its path is checked before any work is done.
struct Picture<'a> {
    path: &'a Path,
    format: FigureFormat,
}

impl<'a> Picture<'a> {
    /// The figure that `--plot` names.
    fn named(path: &'a Path) -> Result<Self> {
        check_place("--plot", path)?;
        Ok(Self {
            path,
            format: FigureFormat::of("--plot", path)?,
        })
    }

    fn write(&self, chart: &Chart, session: &Session) -> Result<()> {
        let bytes = session
            .work
            .stage("draw", || self.format.bytes(chart.to_svg()?))?;
        write_beside(self.path, &bytes, session)
    }
}
