//! `stellate parametrize`: turns an implicit form into its radii r(θ).

use stellate::document::{Format, Kind, write_parametrized};
use stellate::error::Result;
use stellate::verb::{self, ParametrizeOptions};

use super::arguments::Parametrize;
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(flags: &Parametrize, session: &Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    Kind::Parametrization.check(format)?;
    let options = ParametrizeOptions::default()
        .fit(input::fit_options(&flags.fit))
        .branch(flags.branch)
        .thetas(input::directions(&flags.theta, session))
        .phis(input::directions(&flags.phi, session))
        .arcs(input::arc_search(&flags.arcs))
        .with_arcs(matches!(format, Format::Text | Format::Json | Format::Csv));
    let given = input::read_with(&flags.form, &flags.fit, session)?;
    let found = verb::parametrize(given, &options, &session.work)?;
    write_result(session, |out| {
        write_parametrized(&found, session.decimals(), format, out)
    })
}
