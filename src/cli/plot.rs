//! `stellate plot`: draws forms over each other.

use stellate::error::{Error, Result};
use stellate::verb::{self, FigureFormat, Given, PlotOptions};

use super::arguments::Plot;
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

/// The message for `--format`.
pub(crate) const NO_FORMAT: &str = "plot has no --format: the name after -o says .svg or .png";

pub(crate) fn run(flags: &Plot, session: &Session) -> Result<()> {
    if session.common.format.is_some() {
        return Err(Error::Usage(NO_FORMAT.into()));
    }
    let path = session.common.output.as_ref().ok_or_else(|| {
        Error::Usage("plot writes a file: give -o FIGURE.svg or -o FIGURE.png".into())
    })?;
    let format = FigureFormat::of("-o", path)?;
    check_destination(session)?;
    let svg = svg(flags, session, |form| {
        input::read_with(form, &flags.fit, session)
    })?;
    let bytes = session.work.stage("draw", || format.bytes(svg))?;
    write_result(session, |out| Ok(out.write_all(&bytes)?))
}

/// The figure as SVG. The function `read` reads each form.
pub(super) fn svg(
    flags: &Plot,
    session: &Session,
    read: impl Fn(&str) -> Result<Given>,
) -> Result<String> {
    let options = PlotOptions::default()
        .fit(input::fit_options(&flags.fit))
        .window(flags.window)
        .ranges(flags.range.clone())
        .view(flags.view)
        .title(flags.title.clone())
        .width(flags.width)
        .cells(flags.cells)
        .points(flags.point.clone());
    let forms = flags.forms.iter().map(|form| read(form));
    verb::plot(forms.collect::<Result<_>>()?, &options, &session.work)
}
