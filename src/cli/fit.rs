//! `stellate fit`: fits Fourier series to contours.

use stellate::document::{Format, Kind, certified_bounds, write_fit, write_fit_table};
use stellate::error::{Error, Result};
use stellate::verb::{self, FittedOutline, Given, OutlineFit, OutlineSeries};

use super::arguments::Fit;
use super::fit_mesh;
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(flags: &Fit, session: &Session) -> Result<()> {
    check_destination(session)?;
    if let [argument] = &flags.contours[..]
        && verb::is_mesh_name(argument)
    {
        return fit_mesh::run(argument, flags, session);
    }
    if flags.degree.is_some() {
        return Err(Error::Usage(
            "--degree is for a closed mesh, one .obj, .ply or .stl file; a contour has --harmonics"
                .into(),
        ));
    }
    let [argument] = &flags.contours[..] else {
        return table(flags, session);
    };
    if flags.all {
        return table(flags, session);
    }
    let format = session.format_or(Format::Text);
    Kind::Fit.check(format)?;
    let given = input::read_with(argument, &flags.fit, session)?;
    let fit = fit_of(given, flags, session)?;
    session.note(&summary(&fit));
    write_result(session, |out| write_fit(&fit, format, out))
}

/// One row for each outline. Those that reach a limit have none and are named; the others are written first.
fn table(flags: &Fit, session: &Session) -> Result<()> {
    Kind::FitTable.check(session.format_or(Format::Csv))?;
    let mut rows = Vec::new();
    let mut without_row = Vec::new();
    for argument in &flags.contours {
        let outlines = if flags.all {
            all_outlines(argument, flags, session)?
        } else {
            let given = input::read_with(argument, &flags.fit, session)?;
            vec![(flags.fit.outline.blob, given)]
        };
        for (blob, given) in outlines {
            let name = given.whole_name();
            match fit_of(given, flags, session) {
                Ok(fit) => rows.push(FittedOutline {
                    file: argument.clone(),
                    blob,
                    fit,
                }),
                Err(Error::Limit { limit, .. }) => without_row.push(format!("{name}: {limit}")),
                Err(error) => return Err(error),
            }
        }
    }
    if !rows.is_empty() {
        write_result(session, |out| write_fit_table(&rows, out))?;
    }
    match without_row[..] {
        [] => Ok(()),
        _ => Err(Error::Limit {
            limit: without_row.join("; "),
            finished: format!("rows of other outlines: {}", rows.len()),
        }),
    }
}

/// All outlines of a file that can be fitted, each with its number; a note names the others.
fn all_outlines(argument: &str, flags: &Fit, session: &Session) -> Result<Vec<(usize, Given)>> {
    let mut outlines = Vec::new();
    for (k, found) in input::read_all(argument, &flags.fit, session)?
        .into_iter()
        .enumerate()
    {
        match found {
            Ok(given) => outlines.push((k + 1, given)),
            Err(error) => session.note(&format!("outline {} is left out: {error}", k + 1)),
        }
    }
    if outlines.is_empty() {
        return Err(Error::Usage(format!(
            "{argument}: no outline of this file can be fitted"
        )));
    }
    Ok(outlines)
}

fn fit_of(given: Given, flags: &Fit, session: &Session) -> Result<OutlineFit> {
    let options = input::fit_options(&flags.fit);
    // Of a normal form, what is rounded is the normal form.
    let unrounded = options.clone().decimals(None);
    let options = if flags.normal_form {
        unrounded
    } else {
        options
    };
    let fit = verb::fit(given, &options, &session.work)?;
    if flags.normal_form {
        return fit.into_normal_form(flags.fit.decimals);
    }
    Ok(fit)
}

/// A fit in a sentence.
fn summary(fit: &OutlineFit) -> String {
    let mut text = match &fit.series {
        OutlineSeries::Radius(fit) => format!(
            "N = {}, {} {}, radial error ≈ {:.3e} at most, ≈ {:.3e} rms",
            fit.radius.harmonics(),
            fit.samples,
            if fit.least_squares.is_some() {
                "points"
            } else {
                "samples"
            },
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
    let errors = fit
        .report
        .least_squares
        .as_ref()
        .and_then(|found| found.errors.as_ref());
    if let Some(errors) = errors {
        let largest = errors.deviation.iter().copied().fold(0.0, f64::max);
        text.push_str(&format!(
            "; points deviate by ≈ {largest:.3e} (standard deviation)"
        ));
    }
    if let Some(found) = &fit.report.distances {
        text.push_str(&format!(
            "; distance {} (Hausdorff, certified), ≈ {:.3e} on average, overlap ≈ {:.4}",
            certified_bounds(found.hausdorff.low, found.hausdorff.high),
            found.mean,
            found.overlap
        ));
    }
    text
}
