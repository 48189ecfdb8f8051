//! The ticks of axes: round numbers, and short labels for them.
//!
//! The numbers along an axis are differences from an offset if they share many leading digits, and they are multiples of a
//! power of ten if they are very small or very large. The title of the axis says so: `(x − 500 000.12) / 10⁻³`.

use crate::exact::Rational;

/// An offset is worth its place in the title if it makes the labels shorter by this many digits.
const SAVED: usize = 4;

/// Labels of at most this many characters (without a sign) are written without an exponent.
const SHORT: usize = 6;

/// A tick may be beyond the end of its axis by this part of the axis, because ends are rounded.
const SLACK: f64 = 1e-9;

/// An offset with at most this many digits before the decimal point, and this many zeros after it, is written without an
/// exponent.
const DIGITS_BEFORE: i32 = 15;
const ZEROS_AFTER: i32 = 3;

/// The number `digits` · 10^`exponent`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Decimal {
    digits: i128,
    exponent: i32,
}

/// The ticks of an axis. The number at a tick is offset + label · 10^exponent.
#[derive(Clone, Debug)]
pub(super) struct Ticks {
    values: Vec<f64>,
    labels: Vec<String>,
    offset: Decimal,
    exponent: i32,
}

impl Ticks {
    /// The numbers at the ticks, ascending.
    pub(super) fn values(&self) -> &[f64] {
        &self.values
    }

    /// The labels of the ticks.
    pub(super) fn labels(&self) -> &[String] {
        &self.labels
    }

    /// The label of the tick at a number; it is empty if there is no tick.
    pub(super) fn label(&self, value: f64) -> String {
        let index = self.values.iter().position(|v| v.total_cmp(&value).is_eq());
        let label = index.and_then(|index| self.labels.get(index));
        label.cloned().unwrap_or_default()
    }

    /// What the labels are, for an axis of this name.
    pub(super) fn title(&self, name: &str) -> String {
        let Decimal { digits, .. } = self.offset;
        let sign = if digits < 0 { '+' } else { '−' };
        let difference = match digits {
            0 => name.to_owned(),
            _ => format!("{name} {sign} {}", self.offset.in_words()),
        };
        match (digits, self.exponent) {
            (_, 0) => difference,
            (0, exponent) => format!("{difference} / {}", power_of_ten(exponent)),
            (_, exponent) => format!("({difference}) / {}", power_of_ten(exponent)),
        }
    }

    /// Whether the labels are something other than the numbers at the ticks.
    pub(super) fn has_note(&self) -> bool {
        self.offset.digits != 0 || self.exponent != 0
    }

    /// The ticks of a logarithmic axis: powers of ten and, if they are few, 2 and 5 times these.
    pub(super) fn of_decades([low, high]: [f64; 2]) -> Self {
        /// With at most this many decades there is room for further ticks; with more than `MANY`, some powers are left out.
        const FEW: i32 = 4;
        const MANY: i32 = 10;
        let (first, last) = (floor_log10(low), floor_log10(high));
        let multiples: &[i128] = if last - first < FEW { &[1, 2, 5] } else { &[1] };
        let stride = (last - first) / MANY + 1;
        let (mut values, mut labels) = (Vec::new(), Vec::new());
        let mut exponent = first;
        while exponent <= last {
            for &digits in multiples {
                let value = Decimal { digits, exponent }.to_f64();
                if (low..=high).contains(&value) {
                    values.push(value);
                    labels.push(if (1e-3..1e5).contains(&value) {
                        format!("{value}")
                    } else {
                        format!("{digits}e{exponent}")
                    });
                }
            }
            exponent += stride;
        }
        let offset = Decimal {
            digits: 0,
            exponent: 0,
        };
        Self {
            values,
            labels,
            offset,
            exponent: 0,
        }
    }
}

/// The ticks of axes, at most `most` for each, and so few that `fits` is true for the number of each axis and its ticks, or that
/// there are two. Axes with one unit of length have one exponent.
pub(super) fn fitting<const N: usize>(
    ranges: [[f64; 2]; N],
    most: usize,
    one_unit: bool,
    fits: impl Fn(usize, &Ticks) -> bool,
) -> [Ticks; N] {
    let mut limits = [most; N];
    loop {
        let ticks = of_ranges(ranges, limits, one_unit);
        let mut all_fit = true;
        for (k, limit) in limits.iter_mut().enumerate() {
            let count = ticks[k].values.len();
            if count > 2 && !fits(k, &ticks[k]) {
                *limit = count - 1;
                all_fit = false;
            }
        }
        if all_fit {
            return ticks;
        }
    }
}

fn of_ranges<const N: usize>(
    ranges: [[f64; 2]; N],
    limits: [usize; N],
    one_unit: bool,
) -> [Ticks; N] {
    let mut k = 0;
    let grids = ranges.map(|range| {
        k += 1;
        Grid::new(range, limits[k - 1])
    });
    let common = one_unit.then(|| exponent_of(&grids));
    grids.map(|grid| grid.ticks(common.unwrap_or_else(|| exponent_of(&[grid]))))
}

/// Equally spaced numbers: multiples of `step` · 10^`exponent`.
#[derive(Clone, Copy, Debug)]
struct Grid {
    /// The first and the last number and the offset, in units of 10^`exponent`.
    first: i128,
    last: i128,
    offset: i128,
    /// 1, 2 or 5.
    step: i128,
    exponent: i32,
}

impl Grid {
    /// No numbers.
    const EMPTY: Self = Self {
        first: 1,
        last: 0,
        offset: 0,
        step: 1,
        exponent: 0,
    };

    /// The finest grid with at most `most` numbers in a range.
    fn new([low, high]: [f64; 2], most: usize) -> Self {
        let span = high / 2.0 - low / 2.0;
        let ends = [low, high].map(|v| Rational::try_from(v).ok());
        let ([Some(low), Some(high)], true) = (ends, span > 0.0 && span.is_finite()) else {
            return Self::EMPTY;
        };
        let Ok(slack) = Rational::try_from(SLACK * span) else {
            return Self::EMPTY;
        };
        let (low, high) = (low - &slack, high + &slack);
        let most = i128::try_from(most.max(2)).unwrap_or(i128::MAX);
        let start = floor_log10(span) - 2;
        let exponents = (start..start + 8).flat_map(|e| [1, 2, 5].map(|step| (step, e)));
        for (step, exponent) in exponents {
            let Some(unit) = Rational::from(10).pow(i64::from(exponent)) else {
                continue;
            };
            let size = unit * Rational::from(step);
            let whole = |value: Rational| i128::try_from(&value.floor_integer()).ok();
            let first = whole(-(&low / &size)).map(|v| -v);
            let (Some(first), Some(last)) = (first, whole(&high / &size)) else {
                continue;
            };
            if last - first < most {
                let step = i128::from(step);
                let (first, last) = (first * step, last * step);
                let offset = offset(first, last);
                return Self {
                    first,
                    last,
                    offset,
                    step,
                    exponent,
                };
            }
        }
        Self::EMPTY
    }

    /// The largest size of a difference from the offset.
    fn largest(&self) -> i128 {
        let size = |end: i128| (end - self.offset).abs();
        size(self.first).max(size(self.last))
    }

    /// The differences from the offset, in units of 10^`exponent`.
    fn differences(&self) -> impl Iterator<Item = i128> {
        let Self {
            first,
            last,
            offset,
            step,
            ..
        } = *self;
        (0..)
            .map(move |k| first + k * step)
            .take_while(move |v| *v <= last)
            .map(move |v| v - offset)
    }

    /// The length of the longest label without its sign.
    fn longest(&self, exponent: i32) -> usize {
        let exponent = self.exponent - exponent;
        let labels = self.differences().map(|v| {
            Decimal {
                digits: v.abs(),
                exponent,
            }
            .plain()
        });
        labels.map(|label| label.len()).max().unwrap_or(0)
    }

    fn ticks(&self, exponent: i32) -> Ticks {
        let (mut values, mut labels): (Vec<f64>, Vec<String>) = (Vec::new(), Vec::new());
        for difference in self.differences() {
            let at = Decimal {
                digits: difference + self.offset,
                exponent: self.exponent,
            };
            let value = at.to_f64();
            // Neighbouring doubles have no ticks between them.
            if values.last().is_none_or(|last| *last < value) {
                values.push(value);
                labels.push(
                    Decimal {
                        digits: difference,
                        exponent: self.exponent - exponent,
                    }
                    .plain(),
                );
            }
        }
        let offset = Decimal {
            digits: self.offset,
            exponent: self.exponent,
        };
        Ticks {
            values,
            labels,
            offset,
            exponent,
        }
    }
}

/// A round number near all numbers of a grid if that saves many digits; otherwise 0. It is below all numbers, so that the
/// differences are positive, unless there is a much rounder one between them.
fn offset(first: i128, last: i128) -> i128 {
    if first <= 0 && last >= 0 {
        return 0;
    }
    let mut round = 1;
    while round <= last - first {
        round *= 10;
    }
    let below = |power: i128| last.div_euclid(power) * power;
    let mut offset = first.div_euclid(round) * round;
    let mut rounder = 10 * round;
    while below(rounder) >= first && below(rounder) != 0 {
        offset = below(rounder);
        rounder *= 10;
    }
    let longest = |offset: i128| {
        let sizes = [first, last].map(|end| count_digits((end - offset).abs()));
        sizes[0].max(sizes[1])
    };
    if longest(0) >= longest(offset) + SAVED {
        offset
    } else {
        0
    }
}

/// The exponent, a multiple of three, by which the labels of all grids become short; 0 if they are short already.
fn exponent_of(grids: &[Grid]) -> i32 {
    let longest = |exponent: i32| {
        grids
            .iter()
            .map(|grid| grid.longest(exponent))
            .max()
            .unwrap_or(0)
    };
    let magnitude = |grid: &Grid| {
        let digits = i32::try_from(count_digits(grid.largest())).unwrap_or(0);
        digits + grid.exponent - 1
    };
    let magnitudes = grids
        .iter()
        .filter(|grid| grid.largest() > 0)
        .map(magnitude);
    let exponent = magnitudes.max().unwrap_or(0).div_euclid(3) * 3;
    let plain = longest(0);
    if plain > SHORT && longest(exponent) < plain {
        exponent
    } else {
        0
    }
}

fn count_digits(value: i128) -> usize {
    value
        .unsigned_abs()
        .checked_ilog10()
        .map_or(1, |log| log as usize + 1)
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "a decimal exponent of a double"
)]
fn floor_log10(value: f64) -> i32 {
    value.log10().floor() as i32
}

impl Decimal {
    /// The nearest double.
    fn to_f64(self) -> f64 {
        let text = format!("{}e{}", self.digits, self.exponent);
        text.parse().unwrap_or(f64::NAN)
    }

    /// The number without an exponent and without zeros at the end of its fraction.
    fn plain(self) -> String {
        let sign = if self.digits < 0 { "-" } else { "" };
        let digits = self.digits.unsigned_abs().to_string();
        let places = usize::try_from(self.exponent.unsigned_abs()).unwrap_or(0);
        if self.digits == 0 {
            return digits;
        }
        if self.exponent >= 0 {
            return format!("{sign}{digits}{}", "0".repeat(places));
        }
        let digits = format!("{digits:0>width$}", width = places + 1);
        let (whole, fraction) = digits.split_at(digits.len() - places);
        match fraction.trim_end_matches('0') {
            "" => format!("{sign}{whole}"),
            fraction => format!("{sign}{whole}.{fraction}"),
        }
    }

    /// The size of the number for people: thousands are grouped, and a very small or large number has an exponent.
    fn in_words(self) -> String {
        let size = self.digits.unsigned_abs().to_string();
        let length = i32::try_from(size.len()).unwrap_or(0);
        let magnitude = length + self.exponent - 1;
        if (-ZEROS_AFTER - 1..DIGITS_BEFORE).contains(&magnitude) {
            let plain = Self {
                digits: self.digits.abs(),
                ..self
            }
            .plain();
            let (whole, fraction) = plain.split_once('.').unwrap_or((&plain, ""));
            let point = if fraction.is_empty() { "" } else { "." };
            return format!("{}{point}{fraction}", grouped(whole));
        }
        let power = power_of_ten(magnitude);
        match size.trim_end_matches('0') {
            "1" => power,
            size => match size.split_at(1) {
                (first, "") => format!("{first}·{power}"),
                (first, rest) => format!("{first}.{rest}·{power}"),
            },
        }
    }
}

/// The digits of a whole number in groups of three.
fn grouped(digits: &str) -> String {
    let mut text = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

fn power_of_ten(exponent: i32) -> String {
    let raised = exponent.to_string();
    let raised = raised.chars().map(|c| match c.to_digit(10) {
        Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
        None => '⁻',
    });
    format!("10{}", raised.collect::<String>())
}

#[cfg(test)]
#[path = "ticks_laws.rs"]
mod laws;
