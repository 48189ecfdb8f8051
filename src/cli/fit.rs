//! `stellate fit`: a contour to a Fourier radius.

use stellate::document::{Format, write_fourier};
use stellate::error::{Error, Result};

use super::arguments::Fit;
use super::input::{self, Content};
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(verb: &Fit, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    format.check_fourier()?;
    let argument = verb.contour.display().to_string();
    let Content::Contour(contour) = input::read(&argument, session)?.content else {
        return Err(Error::Usage(format!(
            "{argument}: fit needs a contour: a .csv with rows x,y, or a .png, .jpg or .bmp silhouette"
        )));
    };
    let fit = input::fit_contour(&contour, &verb.fit, session)?;
    let report = input::report(&fit);
    session.note(&format!(
        "N = {}, {} samples, radial error ≈ {:.3e} at most, ≈ {:.3e} rms",
        fit.radius.harmonics(),
        fit.samples,
        fit.max_radial_error,
        fit.rms_radial_error
    ));
    write_result(session, |out| {
        write_fourier(&fit.radius, Some(&report), format, out)
    })
}
