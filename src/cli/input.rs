//! Reads FORM arguments and data files, and turns flags into the options of the library.

use std::path::Path;

use stellate::error::{Error, Result};
use stellate::fit::{FitOptions, FitSize, OutlineOptions};
use stellate::sample::Direction;
use stellate::verb::{ArcSearch, Given, ReadOptions, read_limited};

use super::flags::{ArcFlags, FitFlags, OutlineFlags};
use super::output::is_one_file;
use super::session::Session;
use super::values::Angle;

/// Reads a FORM argument.
pub(crate) fn read(argument: &str, session: &Session) -> Result<Given> {
    read_outline(argument, &OutlineFlags::default(), session)
}

/// Reads a FORM argument. If it has outlines, one is found as the flags of a fit say.
pub(crate) fn read_with(argument: &str, flags: &FitFlags, session: &Session) -> Result<Given> {
    read_one(argument, &options_of(flags, session), session)
}

/// Reads a FORM argument. If it has outlines, one is found as the flags say.
pub(crate) fn read_outline(
    argument: &str,
    flags: &OutlineFlags,
    session: &Session,
) -> Result<Given> {
    read_one(argument, &read_options(flags, session), session)
}

fn read_one(argument: &str, options: &ReadOptions, session: &Session) -> Result<Given> {
    refuse_output(argument, session)?;
    session.work.stage("read", || {
        if argument == "-" {
            let input = std::io::stdin().lock();
            return Given::from_reader_with(input, "standard input", options, &session.work);
        }
        Given::read_with(argument, options, &session.work)
    })
}

/// Reads all outlines of a file; each may have a fault of its own.
pub(crate) fn read_all(
    argument: &str,
    flags: &FitFlags,
    session: &Session,
) -> Result<Vec<Result<Given>>> {
    refuse_output(argument, session)?;
    session.work.stage("read", || {
        let options = options_of(flags, session);
        if argument == "-" {
            let input = std::io::stdin().lock();
            return Given::all_from_reader_with(input, "standard input", &options);
        }
        Given::read_all_with(argument, &options)
    })
}

/// Refuses to write over a file that is read: an outline would be lost.
pub(super) fn refuse_output(argument: &str, session: &Session) -> Result<()> {
    let read = Path::new(argument);
    let written = [("-o", &session.common.output), ("--proof", &session.proof)];
    let over = written.into_iter().find(|(_, path)| {
        let path = path.as_deref();
        path.is_some_and(|path| path.is_file() && is_one_file(path, read))
    });
    match over {
        Some((flag, _)) => Err(Error::Usage(format!(
            "{flag} {argument}: this file is read; write to another one"
        ))),
        None => Ok(()),
    }
}

fn options_of(flags: &FitFlags, session: &Session) -> ReadOptions {
    read_options(&flags.outline, session).cloud(flags.cloud)
}

fn read_options(flags: &OutlineFlags, session: &Session) -> ReadOptions {
    let outline = OutlineOptions::default()
        .blob(flags.blob)
        .threshold(flags.threshold)
        .invert(flags.invert)
        .columns(flags.columns.clone())
        .weights(flags.weights.clone())
        .repair(flags.repair);
    ReadOptions::default()
        .numbers(session.numbers())
        .harmonics(session.harmonics())
        .outline(outline)
}

/// Reads a data file of a verb, or standard input. Returns the text and the name of its source in messages.
pub(crate) fn read_data(argument: &str, session: &Session) -> Result<(String, String)> {
    refuse_output(argument, session)?;
    if argument == "-" {
        let name = "standard input";
        let text = read_limited(std::io::stdin().lock(), name)?;
        return Ok((text, name.into()));
    }
    let file = std::fs::File::open(argument).map_err(|source| Error::Io {
        path: argument.into(),
        source,
    })?;
    Ok((read_limited(file, argument)?, argument.into()))
}

/// The options of a fit, from the flags.
pub(crate) fn fit_options(flags: &FitFlags) -> FitOptions {
    let sizes = [
        flags.harmonics.map(FitSize::Harmonics),
        flags
            .tolerance
            .as_ref()
            .map(|e| FitSize::Tolerance(e.to_f64())),
        flags
            .distance
            .as_ref()
            .map(|e| FitSize::Distance(e.to_f64())),
        flags.power.as_ref().map(|p| FitSize::Power(p.to_f64())),
    ];
    FitOptions::default()
        .model(flags.model.into())
        .size(sizes.into_iter().flatten().next())
        .center(flags.center.clone())
        .samples(flags.samples)
        .estimator(flags.estimator.map(Into::into))
        .robust(flags.robust)
        .decimals(flags.decimals)
}

/// The options for the search of the arcs of an intersection, from the flags.
pub(crate) fn arc_search(flags: &ArcFlags) -> ArcSearch {
    ArcSearch::default()
        .window(flags.window)
        .resolution(flags.resolution)
}

/// The directions of these angles. A note is written if one of the angles may be meant in degrees.
pub(crate) fn directions(angles: &[Angle], session: &Session) -> Vec<Direction> {
    if let Some(text) = angles.iter().find_map(|angle| angle.doubtful.as_ref()) {
        session.note(&format!(
            "the angle {text} is in radians; degrees are written {text}deg"
        ));
    }
    angles.iter().map(|angle| angle.direction.clone()).collect()
}
