//! `stellate vectors`: writes test vectors for float programs.

use stellate::document::{Format, Kind, write_vectors};
use stellate::error::Result;
use stellate::verb::{self, VectorOptions};

use super::check_arguments::Vectors;
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(flags: &Vectors, session: &Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Json);
    Kind::Vectors.check(format)?;
    let options = VectorOptions::default()
        .fit(input::fit_options(&flags.fit))
        .directions(flags.directions);
    let given = input::read_with(&flags.reference, &flags.fit, session)?;
    let vectors = verb::vectors(given, &options, &session.work)?;
    write_result(session, |out| write_vectors(&vectors, out))
}
