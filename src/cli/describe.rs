//! `stellate describe`: says what a form is.

use stellate::document::{Format, Kind, write_described};
use stellate::error::Result;
use stellate::verb::{self, DescribeOptions};

use super::arguments::Describe;
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(flags: &Describe, session: &Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Text);
    Kind::Description.check(format)?;
    let options = DescribeOptions::default()
        .fit(input::fit_options(&flags.fit))
        .topology(flags.topology);
    let given = input::read_with(&flags.form, &flags.fit, session)?;
    let found = verb::describe(given, &options, &session.work)?;
    write_result(session, |out| {
        write_described(&found, session.decimals(), format, out)
    })
}
