//! `stellate fit`: fits a Fourier radius to a contour.

use stellate::document::{Format, Kind, write_fourier};
use stellate::error::{Error, Result};
use stellate::verb::{self, Content};

use super::arguments::Fit;
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(flags: &Fit, session: &Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    Kind::Radius.check(format)?;
    let options = input::fit_options(&flags.fit);
    let argument = flags.contour.display().to_string();
    let Content::Contour(contour) =
        input::read_with(&argument, &flags.fit, session)?.into_content()
    else {
        return Err(Error::Usage(format!(
            "{argument}: fit needs a contour: a .csv with rows x,y, or a .png, .jpg or .bmp silhouette"
        )));
    };
    let fit = verb::fit(&contour, &options, &session.work)?;
    session.note(&format!(
        "N = {}, {} samples, radial error ≈ {:.3e} at most, ≈ {:.3e} rms",
        fit.radius.harmonics(),
        fit.samples,
        fit.max_radial_error,
        fit.rms_radial_error
    ));
    write_result(session, |out| {
        write_fourier(&fit.radius, Some(&fit.report()), format, out)
    })
}
