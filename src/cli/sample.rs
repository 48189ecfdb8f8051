//! `stellate sample`: computes certified points.

use stellate::document::{Format, Kind, sampled_text, write_sampled};
use stellate::error::Result;
use stellate::sample::StageCounts;
use stellate::verb::{self, SampleOptions};

use super::arguments::Sample;
use super::input;
use super::output::{check_destination, write_result};
use super::session::Session;

pub(crate) fn run(flags: &Sample, session: &Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Csv);
    Kind::Points.check(format)?;
    let options = SampleOptions::default()
        .fit(input::fit_options(&flags.fit))
        .directions(flags.directions)
        .thetas(input::directions(&flags.theta, session))
        .phis(input::directions(&flags.phi, session))
        .coordinates(flags.coordinates.into())
        .positive(flags.positive)
        .arcs(input::arc_search(&flags.arcs));
    let given = input::read_with(&flags.form, &flags.fit, session)?;
    let found = verb::sample(given, &options, &session.work)?;
    if let Some(counts) = found.counts {
        record_counts(counts, session);
    }
    for line in sampled_text(&found) {
        session.note(&line);
    }
    write_result(session, |out| write_sampled(&found, format, out))
}

/// Records, for each number of bits, how many directions were decided with it.
fn record_counts(counts: StageCounts, session: &Session) {
    let bounded = StageCounts::BITS.iter().zip(counts.bounded);
    let mut rays: serde_json::Map<String, serde_json::Value> = bounded
        .map(|(bits, count)| (format!("{bits}_bits"), count.into()))
        .collect();
    rays.insert("exact".into(), counts.exact.into());
    session.record("rays", rays.into());
}
