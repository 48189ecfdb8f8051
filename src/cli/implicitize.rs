//! `stellate implicitize`: applies Theorems 1 to 4, and writes implicit forms in canonical form.

use stellate::document::{Format, write_implicitization};
use stellate::error::Result;
use stellate::verb::{self, ImplicitizeOptions};

use super::arguments::{Implicitize, ImplicitizeMethod, ScaleFlag};
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(flags: &Implicitize, session: &Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    let options = ImplicitizeOptions::default()
        .fit(input::fit_options(&flags.fit))
        .method(flags.method.map(|method| match method {
            ImplicitizeMethod::Polar => verb::ImplicitizeMethod::Polar,
            ImplicitizeMethod::Resultant => verb::ImplicitizeMethod::Resultant,
        }))
        .scale(match flags.scale {
            ScaleFlag::Integer => verb::CoefficientScale::Integer,
            ScaleFlag::Monic => verb::CoefficientScale::Monic,
        })
        .coordinates(flags.coordinates.into());
    let given = input::read_with(&flags.form, &flags.fit, session)?;
    let found = verb::implicitize(given, &options, &session.work)?;
    write_result(session, |out| write_implicitization(&found, format, out))
}
