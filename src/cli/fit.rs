//! `stellate fit`: fits a Fourier radius to a contour.

use stellate::document::{Format, Kind, write_fit};
use stellate::error::{Error, Result};
use stellate::verb::{self, Content, OutlineFit, OutlineSeries};

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
            "{argument}: fit needs a contour: a .csv with rows x,y, .npy, .geojson or .svg, or a .png, .jpg or .bmp silhouette"
        )));
    };
    let fit = verb::fit(&contour, &options, &session.work)?;
    session.note(&summary(&fit));
    write_result(session, |out| write_fit(&fit, format, out))
}

/// A fit in a sentence.
fn summary(fit: &OutlineFit) -> String {
    let mut text = match &fit.series {
        OutlineSeries::Radius(fit) => format!(
            "N = {}, {} samples, radial error ≈ {:.3e} at most, ≈ {:.3e} rms",
            fit.radius.harmonics(),
            fit.samples,
            fit.max_radial_error,
            fit.rms_radial_error
        ),
        OutlineSeries::Elliptic(fit) => {
            format!(
                "N = {}, degree {}",
                fit.series.harmonics(),
                2 * fit.series.harmonics()
            )
        }
    };
    if let Some(found) = &fit.report.distances {
        text.push_str(&format!(
            "; distance {:.3e} to {:.3e} (Hausdorff, certified), ≈ {:.3e} on average, overlap ≈ {:.4}",
            found.hausdorff.low, found.hausdorff.high, found.mean, found.overlap
        ));
    }
    text
}
