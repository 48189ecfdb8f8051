//! A reader of times.

use std::time::Duration;

use super::Read;
use super::number::number;

/// The names of units, and how many seconds they have.
const UNITS: [(&[&str], f64); 4] = [
    (&["ms", "milliseconds", "millisecond"], 0.001),
    (&["", "s", "sec", "secs", "second", "seconds"], 1.0),
    (&["m", "min", "mins", "minute", "minutes"], 60.0),
    (&["h", "hr", "hrs", "hour", "hours"], 3600.0),
];

/// A reader of times; a number without a unit is in seconds.
pub(crate) fn time(example: u64) -> impl Fn(&str) -> Read<Duration> + Clone + Send + Sync {
    move |text| {
        let text = text.trim();
        let digits = text.trim_end_matches(char::is_alphabetic);
        let unit = text[digits.len()..].to_lowercase();
        let seconds = UNITS.iter().find(|(names, _)| names.contains(&&*unit));
        let found = seconds
            .zip(number(digits))
            .and_then(|((_, seconds), count)| {
                Duration::try_from_secs_f64(count.to_f64() * seconds).ok()
            });
        found.ok_or_else(|| {
            format!("expected a number of seconds, such as {example}, or with a unit, such as 5min")
        })
    }
}
