//! Describes the faults that no usual mistake explains, by their kinds.

use std::borrow::Cow;

use malachite::base::num::logic::traits::SignificantBits;

use super::comparison::{Comparison, Diagnosis, GivenNumber, Row};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::total_degree;

/// A number with fewer correct digits than this counts as wrong.
const WRONG: u32 = 1;

/// An error of at most 2^ROUNDINGS times the condition is explained by rounding: it is that of 2^13 roundings by 2^−53 each.
const ROUNDINGS: i64 = -40;

/// The largest number of correct digits of a number in single precision.
const MOST_OF_SINGLE: f64 = 9.7;
/// The number of correct digits that at least half of the numbers in single precision have.
const HALF_OF_SINGLE: f64 = 6.0;
/// The smallest number of correct digits of a number in single precision.
const LEAST_OF_SINGLE: f64 = 3.0;
/// A number with at least this many correct digits is exact, as small integers are in any precision, and says nothing about the
/// precision.
const EXACT: f64 = 15.0;

/// The kinds of faults in a comparison: terms that one side lacks, single precision, and numbers without a correct digit that
/// their conditions do not explain. `condition` is the factor by which relative errors of the inputs may grow in a number, or 1
/// if it is not known.
pub(super) fn unexplained(
    found: &Comparison,
    condition: impl Fn(&Row) -> Rational,
) -> Vec<Diagnosis> {
    let mut all = Vec::new();
    let mut add = |name: &'static str, explanation: String, faults: usize| {
        all.push(Diagnosis {
            name: Cow::Borrowed(name),
            explanation: Cow::Owned(explanation),
            mark: WRONG,
            compared: found.all().count(),
            faults,
            faults_left: faults,
        });
    };
    if !found.missing.is_empty() {
        let text = format!(
            "{} of the exact form are not there",
            terms(found.missing.len())
        );
        add("missing terms", text, found.missing.len());
    }
    let extra = found.failures(None).len() - found.missing.len();
    if extra > 0 {
        let text = format!("{} that the exact form does not have", terms(extra));
        add("extra terms", text, extra);
    }
    if is_single(found) {
        let text = "the numbers are right to the 6 to 9 digits of single precision (float, float32), and no further";
        add("single precision", text.into(), found.rows.len());
        return all;
    }
    let unit = Rational::from_dyadic(1.into(), ROUNDINGS);
    let is_wrong = |row: &&Row| {
        !row.deviation.reaches(WRONG)
            && row
                .deviation
                .relative()
                .is_none_or(|off| *off > condition(row) * &unit)
    };
    let wrong: Vec<&Row> = found.rows.iter().filter(is_wrong).collect();
    if !wrong.is_empty() {
        let text = format!(
            "{} of {} have no correct digit{}",
            wrong.len(),
            found.rows.len(),
            kind(&wrong)
        );
        add("no correct digit", text, wrong.len());
    }
    all
}

fn terms(count: usize) -> String {
    if count == 1 {
        "1 term".into()
    } else {
        format!("{count} terms")
    }
}

/// Whether the numbers look like those of single precision.
fn is_single(found: &Comparison) -> bool {
    let digits = found.rows.iter().map(|row| row.deviation.digits());
    let mut off: Vec<f64> = digits.filter(|digits| *digits < EXACT).collect();
    off.sort_unstable_by(f64::total_cmp);
    // Some numbers may be exact by chance, but not most of them.
    let enough = 2 * off.len() >= found.rows.len() && off.len() > 1;
    let half = off.get(off.len() / 2);
    enough
        && off.first().is_some_and(|least| *least >= LEAST_OF_SINGLE)
        && off.last().is_some_and(|most| *most <= MOST_OF_SINGLE)
        && half.is_some_and(|half| *half >= HALF_OF_SINGLE)
}

/// What the wrong numbers have in common, in words.
fn kind(wrong: &[&Row]) -> String {
    let mut text = String::new();
    let degree = |row: &&Row| match row.place {
        GivenNumber::Term(exponents) => Some(total_degree(&exponents)),
        _ => None,
    };
    let first = wrong.first().and_then(degree);
    if let Some(first) = first
        && wrong.iter().all(|row| degree(row) == Some(first))
    {
        text += &format!(": all {} have degree {first}", terms(wrong.len()));
    }
    if wrong.len() > 1
        && let Some(ratio) = common_ratio(wrong)
    {
        text += &format!("; got/exact {ratio}");
    }
    text
}

/// The ratio of the given numbers to the exact ones, if it is the same for all of them up to a millionth: as an equality if it is a
/// fraction that is much simpler than any other number as near would be by chance, else as a decimal of the digits in which the ratios
/// agree.
fn common_ratio(wrong: &[&Row]) -> Option<String> {
    /// Ratios of numbers that are rounded to doubles differ by about this.
    const ROUNDED: i64 = -50;
    /// Ratios that agree less are not one.
    const LEAST: i64 = -20;
    /// The bits by which a fraction is simpler than those that are as near by chance.
    const SIMPLER: i64 = 12;
    let power = |k: i64| Rational::from_dyadic(1.into(), k);
    let ratios = wrong.iter().map(|row| {
        let exact = row.exact.as_ref().filter(|exact| !exact.is_zero())?;
        Some(Rational::try_from(row.got).ok()? / exact)
    });
    let ratios: Vec<Rational> = ratios.collect::<Option<_>>()?;
    let (least, largest) = (ratios.iter().min()?, ratios.iter().max()?);
    let size = least.abs().max(largest.abs());
    let spread = largest - least;
    // The exponent of the power of two that bounds the relative spread.
    let agreed = (ROUNDED..=LEAST).find(|&k| spread <= &size * power(k))?;
    let slack = &size * power(agreed);
    let simple = Rational::simplest_between(&(largest - &slack), &(least + &slack));
    let length = simple.numerator().significant_bits() + simple.denominator().significant_bits();
    if length.cast_signed() + SIMPLER <= -agreed {
        return Some(format!("= {simple}"));
    }
    // Ten bits are three digits; the last one may be rounded either way.
    let digits = u32::try_from(-agreed * 3 / 10 - 1).invariant("the bits of a double are few");
    Some(format!("≈ {}", ratios[0].to_significant(digits)))
}
