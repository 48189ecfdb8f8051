//! Readers of numbers and whole numbers.

use std::ops::RangeInclusive;

use stellate::exact::{Rational, exact_literal};
use stellate::verb::Allowed;

use super::Read;

/// The exact value of a number such as 0.01, 1e-3 or 1/100.
pub(super) fn number(text: &str) -> Option<Rational> {
    exact_literal(text).ok()
}

/// Reads a number greater than 0.
pub(crate) fn positive(text: &str) -> Read<Rational> {
    let found = number(text).filter(|value| value.signum() > 0);
    found.ok_or_else(|| {
        advice(text)
            .unwrap_or_else(|| "expected a number greater than 0, such as 0.1, 1e-3 or 1/10".into())
    })
}

/// A reader of whole numbers in a range. The range `n..=u64::MAX` has no upper bound.
pub(crate) fn whole<T: TryFrom<u64>>(
    range: RangeInclusive<u64>,
    example: u64,
) -> impl Fn(&str) -> Read<T> + Clone + Send + Sync {
    move |text| {
        let found = text.trim().parse().ok().filter(|n| range.contains(n));
        let found = found.and_then(|n| T::try_from(n).ok());
        found.ok_or_else(|| no_whole_number(text, &range, example))
    }
}

/// A reader of the whole numbers that an option takes.
pub(crate) fn within(allowed: Allowed) -> impl Fn(&str) -> Read<u32> + Clone + Send + Sync {
    let (least, most) = allowed.range().into_inner();
    whole(u64::from(least)..=u64::from(most), allowed.usual().into())
}

/// The message for a text that is not a whole number in the range.
fn no_whole_number(text: &str, range: &RangeInclusive<u64>, example: u64) -> String {
    let sign = number(text)
        .filter(Rational::is_integer)
        .map(|n| n.signum());
    let bounds = match (*range.start(), *range.end()) {
        (_, u64::MAX) if sign.is_some_and(|sign| sign > 0) => ", and not such a large one".into(),
        (0, u64::MAX) if sign.is_none() => String::new(),
        (first, u64::MAX) => format!(" from {first} on"),
        (first, last) => format!(" from {first} to {last}"),
    };
    format!("expected a whole number{bounds}, such as {example}")
}

/// The advice for a text that is written for a number elsewhere: what to write instead.
pub(super) fn advice(text: &str) -> Option<String> {
    let text = text.trim();
    if number(text).is_some() {
        return None;
    }
    let has_digits = text.contains(|c: char| c.is_ascii_digit());
    if has_digits && text.parse::<f64>().is_ok() {
        return Some("the exponent is too large to be read exactly".into());
    }
    let with_point = text.replacen(',', ".", 1);
    if with_point != text && number(&with_point).is_some() {
        return Some(format!("decimals are written with a point: {with_point}"));
    }
    if let Some(share) = text.strip_suffix('%').and_then(number) {
        let share = share / Rational::from(100);
        return Some(format!("a percentage is written as a number: {share}"));
    }
    let lower = text.to_lowercase();
    if ["pi", "π", "sqrt", "√"]
        .iter()
        .any(|name| lower.contains(name))
    {
        return Some("expected a decimal or a fraction; pi and roots are neither".into());
    }
    let bare = text.trim_end_matches(|c: char| c.is_alphabetic() || c.is_whitespace());
    let has_unit = bare != text && number(bare).is_some();
    has_unit.then(|| format!("a number stands here without a unit: {bare}"))
}
