//! Whole numbers in decimal: sums of powers of two in base 10^15, and divisions only where numbers are very long.
//!
//! Lemma 1 (places). Numbers below 2^(48 n), 1 ≤ n ≤ [`LONGEST_TABLE`], have at most ⌊9633 n / 10 000⌋ + 1 places in base 10^15.
//! Proof. They have fewer than 48 n log 2 / 15 + 1 < 0.963297 n + 1 places; the number of places is an integer.
//! Laws: `places_are_enough_and_not_many_more`, `powers_and_the_numbers_before_them`.
//!
//! Lemma 2 (parts). Numbers of at most [`BITS_OF_PART`] bits have at most [`PLACES_OF_PART`] places, and numbers of so many
//! places are below 2^48 to the power [`LONGEST_TABLE`].
//! Proof. With P places, 10^(15 P) has more than 49.8289 P − 1 bits, as log2 10^15 = 49.82892…, and 49.828 P ≤ 49.8289 P − 0.8
//! for P = 986; and 49.829 · 986 < 49 152 = 48 · 1024.
//! Law: `places_are_enough_and_not_many_more`.
//!
//! Lemma 3 (carrying). The sums of at most [`LONGEST_TABLE`] products of digits below 2^48 and places below 10^15 have
//! `high` < 2^60 and |low| ≤ 2^57. With a carry of at least −146 and below 2^59, [`carried`] returns the rest and the quotient by
//! 10^15 of 2^48 high + low + carry, and the quotient is again at least −146 and below 2^59.
//! Proof. 2^47.99 10^15 / 2^48 < 2^49.83, 1024 times that is below 2^60; 1024 · 2^47 = 2^57. The quotient of 2^48 high by 10^15, which is
//! high · 2^33/5^15, is taken less than 1 + 2^-4 too small: 2^97/5^15 cut to an integer, times high/2^64 < 2^-4, and cut itself. So
//! what is left with low, the carry and 256 · 10^15 is above −2^57 − 146 + 2^57.8 > 0 and below
//! (1 + 2^-4 + 256) · 10^15 + 2^57 + 2^59 < 2^60. The next carry is at least (−2^57 − 146)/10^15 − 1 > −147, an integer, and below
//! 2^60 · 2^48/10^15 + 1000 < 2^59.
//! Law: `carries_are_quotients_and_places_are_rests`.
//!
//! Lemma 4 (the first seven digits). For a place below 10^15, [`seven_and_eight`] returns its quotient and its rest by 10^8.
//! Proof. The place is 2^18 t and less than 2^18 more, t < 2^32. The product of t with ⌊2^58/10^8⌋, over 2^40, is below the quotient
//! by less than 2^18/10^8 + t/2^40 < 1/100, so that it may be one too small, with a rest below 1.01 · 10^8 < 2^27.
//! Law: `places_are_cut_in_fours`.
//!
//! Lemma 5 (fours). 109 951 163 v / 2^40, cut, is ⌊v/10^4⌋ for v < 10^8; 5243 v / 2^19 is ⌊v/100⌋ for v < 10^4; 103 v / 2^10 is ⌊v/10⌋ for
//! v < 100.
//! Proof. The factors are larger than 10^-4, 10^-2 and 10^-1 by less than 10^-12, 10^-6 · 0.5 and 10^-3 · 0.6 each: times v that is less
//! than the distance of v/10^k from the next integer, 10^-k at least.
//! Laws: `places_are_cut_in_fours`, `all_fours_are_written_digit_by_digit` (all of them).

use std::fmt;
use std::sync::{LazyLock, OnceLock};

use malachite::Natural;
use malachite::base::num::arithmetic::traits::{DivModPrecomputed, ModPowerOf2, Pow, Square};
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;
use pulp::NullaryFnOnce;

use super::Machine;
use super::columns::{Columns, DIGIT_BITS, Sums, digits};
use crate::error::Invariant;

/// Decimal digits of a place.
const DIGITS: usize = 15;

/// What a place counts to. 2^48 times a place is below 2^98, as [`Columns::sums`] asks, and [`LONGEST_TABLE`] is below 2^12.
const BASE: u64 = 10_u64.pow(15);

/// The powers of 2^48 in the tables of places: so many are in the first one, twice as many in each of the others. With half
/// as many in the last one 400 limbs take 1.15 times as long and 800 limbs 1.3 times, with divisions.
const SHORTEST_TABLE: usize = 32;
const TABLES: usize = 6;
const LONGEST_TABLE: usize = SHORTEST_TABLE << (TABLES - 1);

/// Limbs up to which no division is needed: three of them are four digits in base 2^48.
const LIMBS_WITHOUT_DIVISION: usize = LONGEST_TABLE / 4 * 3;

/// Longer numbers are divided into parts of so many places: 48 log 2 / 15 = 0.963296 for each digit in base 2^48. Lemma 2.
const PLACES_OF_PART: usize = LONGEST_TABLE * 9632 / 10_000;

/// Numbers of so many bits have no more places than [`PLACES_OF_PART`]. Lemma 2.
const BITS_OF_PART: u64 = PLACES_OF_PART as u64 * 49_828 / 1000;

/// Appends the decimal digits of a number: no sign, no zero in front, `0` for 0.
///
/// With y the digits of the number in base 2^48, it is Σ y 2^(48 i), and each power of two is in a table in base 10^15. The
/// places of that sum are formed in doubles ([`Columns`]), and what is beyond 10^15 is carried from each to the next.
///
/// Cost: for n bits, up to 49 152 of them, n²/4800 fused products of doubles, four at a time; the numbers beyond are
/// divided by powers of ten until their parts are as short as that. The tables and these powers are made when they are
/// needed first, and kept: 4 MB for the longest table, and powers as long as the longest number. Where the machine has no
/// fused products malachite's own way is taken.
pub(crate) fn append_decimal(number: &Natural, text: &mut Vec<u8>) {
    static PRINTER: LazyLock<Printer> = LazyLock::new(|| Printer::new(Machine::this()));
    let limbs = number.as_limbs_asc();
    let mut words = itoa::Buffer::new();
    match *limbs {
        [] => text.push(b'0'),
        [limb] => text.extend_from_slice(words.format(limb).as_bytes()),
        [low, high] => {
            let value = u128::from(high) << u64::BITS | u128::from(low);
            text.extend_from_slice(words.format(value).as_bytes());
        }
        _ if !PRINTER.machine.has_fused_products() => {
            text.extend_from_slice(number.to_string().as_bytes());
        }
        _ => PRINTER.append(number, text),
    }
}

/// The tables that have been needed on a machine.
struct Printer {
    machine: Machine,
    tables: [OnceLock<Columns>; TABLES],
}

impl Printer {
    fn new(machine: Machine) -> Self {
        Self {
            machine,
            tables: [const { OnceLock::new() }; TABLES],
        }
    }

    /// Appends the digits of a number that is not 0, by places.
    fn append(&self, number: &Natural, text: &mut Vec<u8>) {
        let limbs = number.as_limbs_asc();
        if limbs.len() <= LIMBS_WITHOUT_DIVISION {
            self.append_places(limbs, None, text);
        } else {
            let fits = |level: &u32| number.significant_bits() <= BITS_OF_PART << level;
            let level = (1..).find(fits).invariant("enough parts hold any number");
            self.append_parts(number, level, false, text);
        }
    }

    /// A number of at most 2^`level` parts, with all its zeros in front or with none.
    fn append_parts(&self, number: &Natural, level: u32, padded: bool, text: &mut Vec<u8>) {
        if level == 0 {
            return self.append_places(
                number.as_limbs_asc(),
                padded.then_some(PLACES_OF_PART),
                text,
            );
        }
        // Half of the places are below 10^k = 2^k 5^k.
        let k = digits_of_parts(level - 1);
        let Divisor { five, inverse } = power_of_five(level - 1);
        let (above, rest) = (&(number >> k)).div_mod_precomputed(five, inverse);
        let below = (rest << k) + number.mod_power_of_2(k);
        let padded_below = padded || above != Natural::ZERO;
        if padded_below {
            self.append_parts(&above, level - 1, padded, text);
        }
        self.append_parts(&below, level - 1, padded_below, text);
    }

    /// A number of at most [`LIMBS_WITHOUT_DIVISION`] limbs, in so many places or without zeros in front.
    fn append_places(&self, limbs: &[u64], padded_to: Option<usize>, text: &mut Vec<u8>) {
        let y = digits(limbs.iter().copied());
        let places = padded_to.unwrap_or(places_for(y.len()));
        let mut sums = [Sums::default()];
        self.table(y.len()).sums(&[&y], places, &mut sums);
        let [mut sums] = sums;
        let start = text.len();
        text.resize(start + DIGITS * places, b'0');
        self.machine.dispatch(Places {
            sums: &mut sums,
            text: &mut text[start..],
        });
        if padded_to.is_none() {
            let zeros = text[start..]
                .iter()
                .take_while(|digit| **digit == b'0')
                .count();
            text.copy_within(start + zeros.., start);
            text.truncate(text.len() - zeros);
        }
    }

    /// The places of the powers of 2^48, of at least `len` and one more, so that there are places for all numbers below it.
    fn table(&self, len: usize) -> &Columns {
        let is_enough = |k: &usize| len <= SHORTEST_TABLE << k;
        let k = (0..TABLES)
            .find(is_enough)
            .invariant("numbers beyond the longest table are divided first");
        self.tables[k].get_or_init(|| {
            let mut power = vec![1_u64];
            let mut powers = Vec::new();
            for _ in 0..=SHORTEST_TABLE << k {
                #[expect(clippy::cast_precision_loss, reason = "places are below 2^53")]
                powers.push(power.iter().map(|place| *place as f64).collect());
                let mut carry = 0;
                for place in &mut power {
                    *place = carried(&mut carry, *place, 0);
                }
                if carry > 0 {
                    power.push(carry);
                }
            }
            Columns::new(self.machine, &powers)
        })
    }
}

/// A number that is displayed as malachite does it.
pub(crate) struct Decimal<'a>(pub(crate) &'a Natural);

impl fmt::Display for Decimal<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.as_limbs_asc().len() < 2 {
            return fmt::Display::fmt(self.0, f);
        }
        let mut text = Vec::new();
        append_decimal(self.0, &mut text);
        let digits = std::str::from_utf8(&text).map_err(|_| fmt::Error)?;
        f.pad_integral(true, "", digits)
    }
}

/// Decimal digits of 2^`level` parts.
fn digits_of_parts(level: u32) -> u64 {
    ((DIGITS * PLACES_OF_PART) as u64) << level
}

/// 5 to the power [`digits_of_parts`], and what makes it quick to divide by.
struct Divisor {
    five: Natural,
    inverse: <Natural as DivModPrecomputed>::Data,
}

fn power_of_five(level: u32) -> &'static Divisor {
    // More levels than any memory has bits.
    static POWERS: [OnceLock<Divisor>; 64] = [const { OnceLock::new() }; 64];
    POWERS[level as usize].get_or_init(|| {
        let five = match level {
            0 => Natural::from(5_u32).pow(digits_of_parts(0)),
            _ => (&power_of_five(level - 1).five).square(),
        };
        let inverse = Natural::precompute_div_mod_data(&five);
        Divisor { five, inverse }
    })
}

/// At least as many places as numbers below 2^(48 `len`) have. Lemma 1.
fn places_for(len: usize) -> usize {
    len * 9633 / 10_000 + 1
}

/// The next place, where so much is carried and 2^48 `high` + `low` is added; the rest is carried on. `low` and `carry` may
/// be negative, in two's complement. Lemma 3.
#[inline(always)]
fn carried(carry: &mut u64, high: u64, low: u64) -> u64 {
    const RATIO: u128 = (1 << 97) / 5_u128.pow(15);
    const MORE: u64 = 256;
    let quotient = ((u128::from(high) * RATIO) >> u64::BITS) as u64;
    let rest = (high << DIGIT_BITS).wrapping_sub(quotient.wrapping_mul(BASE));
    let rest = rest
        .wrapping_add(low)
        .wrapping_add(MORE * BASE)
        .wrapping_add(*carry);
    *carry = quotient.wrapping_sub(MORE).wrapping_add(rest / BASE);
    rest % BASE
}

/// The digits of sums of places, as many as there is text for.
struct Places<'a> {
    sums: &'a mut Sums,
    text: &'a mut [u8],
}

impl NullaryFnOnce for Places<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Sums { high, low } = self.sums;
        let places = self.text.as_rchunks_mut::<DIGITS>().1;
        let count = places.len().min(high.len());
        let (high, low) = (&mut high[..count], &mut low[..count]);
        let mut carry = 0;
        for (high, low) in high.iter_mut().zip(&*low) {
            *high = carried(&mut carry, *high, *low);
        }
        assert_eq!(carry, 0, "there are enough places");
        // Apart, as both are done for several places at once.
        for (high, low) in high.iter_mut().zip(&mut *low) {
            [*high, *low] = seven_and_eight(*high).map(two_fours);
        }
        for words in [&mut *high, &mut *low] {
            for four in pulp::bytemuck::cast_slice_mut(words) {
                *four = four_digits(*four);
            }
        }
        for (place, (high, low)) in places.iter_mut().rev().zip(high.iter().zip(&*low)) {
            place[..7].copy_from_slice(&high.to_le_bytes()[1..]);
            place[7..].copy_from_slice(&low.to_le_bytes());
        }
    }
}

/// The first seven and the last eight digits of a place, in products of 32 bits. Lemma 4.
#[inline(always)]
fn seven_and_eight(place: u64) -> [u64; 2] {
    const HUNDRED_MILLION: u64 = 100_000_000;
    let quotient = (low_half(place >> 18) * ((1 << 58) / HUNDRED_MILLION)) >> 40;
    let rest = place - low_half(quotient) * HUNDRED_MILLION;
    let is_less = (rest + ((1 << 27) - HUNDRED_MILLION)) >> 27;
    [quotient + is_less, rest - is_less * HUNDRED_MILLION]
}

/// As it is, for a number below 2^32, of which the compiler is to know that.
#[inline(always)]
fn low_half(value: u64) -> u64 {
    value & 0xFFFF_FFFF
}

/// The first four digits of a number below 10^8, and above 2^32 the other four. Lemma 5.
#[inline(always)]
fn two_fours(value: u64) -> u64 {
    let value = low_half(value);
    let first = (value * 109_951_163) >> 40;
    first | (value - low_half(first) * 10_000) << 32
}

/// The four digits of a number below 10^4 as the bytes of a word, the first in the lowest. Lemma 5, for two numbers at once.
#[inline(always)]
fn four_digits(value: u32) -> u32 {
    let hundreds = (value * 5243) >> 19;
    let twos = hundreds | (value - hundreds * 100) << 16;
    let tens = ((twos * 103) >> 10) & 0x000F_000F;
    let ones = tens | (twos - tens * 10) << 8;
    ones | 0x3030_3030
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigUint;
    use proptest::prelude::*;

    static ALL_PRINTERS: LazyLock<[Printer; 5]> =
        LazyLock::new(|| Machine::all().map(Printer::new));

    fn decimal(number: &Natural) -> String {
        let mut text = b"= ".to_vec();
        append_decimal(number, &mut text);
        String::from_utf8(text).unwrap().split_off(2)
    }

    /// Numbers of so many limbs, or one less: any, the largest, and those that are long runs of equal bits.
    fn number(limbs: impl Strategy<Value = usize>) -> impl Strategy<Value = Natural> {
        let limb = prop_oneof![Just(0), Just(u64::MAX), any::<u64>()];
        let same = |(limb, len)| Natural::from_owned_limbs_asc(vec![limb; len]);
        limbs.prop_flat_map(move |len| {
            prop_oneof![
                prop::collection::vec(any::<u64>(), len).prop_map(Natural::from_owned_limbs_asc),
                prop::collection::vec(limb.clone(), len).prop_map(Natural::from_owned_limbs_asc),
                (limb.clone(), Just(len)).prop_map(same),
            ]
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(128))]
        /// Beside `num-bigint`.
        #[test]
        fn all_lengths_have_the_digits_of_another_library(number in number(0usize..60)) {
            let other = BigUint::from_bytes_le(&number.as_limbs_asc().iter().flat_map(|limb| limb.to_le_bytes()).collect::<Vec<_>>());
            prop_assert_eq!(decimal(&number), other.to_string());
        }

        /// Up to parts of parts, and around the first division.
        #[test]
        fn long_numbers_have_the_digits_of_malachite(number in number(prop_oneof![60usize..700, 764usize..772, 700usize..4000])) {
            prop_assert_eq!(decimal(&number), number.to_string());
        }

        /// By places with all instructions, with divisions or without: on machines without fused products, too.
        #[test]
        fn all_machines_give_the_same_digits(number in number(prop_oneof![4 => 1usize..40, 1 => 700usize..1600])) {
            prop_assume!(number != Natural::ZERO);
            let expected = number.to_string();
            for printer in ALL_PRINTERS.iter() {
                let mut text = Vec::new();
                printer.append(&number, &mut text);
                prop_assert_eq!(std::str::from_utf8(&text).unwrap(), &expected);
            }
        }

        /// Beside wider integers.
        #[test]
        fn carries_are_quotients_and_places_are_rests(
            high in 0..1_u64 << 60, low in -(1_i64 << 57)..=1 << 57, carry in -146_i64..1 << 59, extreme in 0..27_usize,
        ) {
            let high = [0, high, (1 << 60) - 1][extreme % 3];
            let low = [-(1 << 57), low, 1 << 57][extreme / 3 % 3];
            let carry = [-146, carry, (1 << 59) - 1][extreme / 9];
            let sum = (i128::from(high) << DIGIT_BITS) + i128::from(low) + i128::from(carry);
            let mut next = carry.cast_unsigned();
            let place = carried(&mut next, high, low.cast_unsigned());
            prop_assert_eq!(i128::from(place), sum.rem_euclid(i128::from(BASE)));
            prop_assert_eq!(i128::from(next.cast_signed()), sum.div_euclid(i128::from(BASE)));
            prop_assert!(next.cast_signed() >= -146);
        }

        #[test]
        fn places_are_cut_in_fours(place in 0..BASE, zeros in 0..15_u32, edge in -2..2_i64) {
            // Multiples of powers of ten, and what is next to them.
            let unit = 10_u64.pow(zeros);
            for place in [place, (place / unit * unit).saturating_add_signed(edge).min(BASE - 1)] {
                let [above, below] = seven_and_eight(place);
                prop_assert_eq!([above, below], [place / 100_000_000, place % 100_000_000]);
                for part in [above, below] {
                    prop_assert_eq!(two_fours(part), part / 10_000 + ((part % 10_000) << 32));
                }
            }
        }

        /// Width, zeros in front and signs are those of malachite.
        #[test]
        fn numbers_are_displayed_as_malachite_does(number in number(0usize..9), width in 0usize..200) {
            let ours = Decimal(&number);
            prop_assert_eq!(format!("{ours}"), format!("{number}"));
            prop_assert_eq!(format!("{ours:>width$}|{ours:<width$}"), format!("{number:>width$}|{number:<width$}"));
            prop_assert_eq!(format!("{ours:+0width$}"), format!("{number:+0width$}"));
        }
    }

    #[test]
    fn places_are_enough_and_not_many_more() {
        let place = Natural::from(BASE);
        for len in 1..=LONGEST_TABLE {
            let (bits, places) = (48 * len as u64, places_for(len) as u64);
            // 10^(15 places) ≥ 2^(48 len), by the bits of both; one place fewer and a half would do less often than not.
            let most = (&place).pow(places).significant_bits() - 1;
            assert!(most >= bits && most < bits + 100, "{len}");
        }
        let parts = place.pow(PLACES_OF_PART as u64).significant_bits();
        assert!(BITS_OF_PART < parts && BITS_OF_PART + 3 >= parts);
        assert!(parts <= 48 * LONGEST_TABLE as u64 && PLACES_OF_PART > LONGEST_TABLE * 9 / 10);
    }

    #[test]
    fn all_fours_are_written_digit_by_digit() {
        for value in 0..10_000 {
            let digits = four_digits(value).to_le_bytes();
            assert_eq!(std::str::from_utf8(&digits).unwrap(), format!("{value:04}"));
        }
    }

    #[test]
    fn powers_and_the_numbers_before_them() {
        // Every length up to the second table, and the limits of all tables and of parts.
        let near = |bits: u64| bits.saturating_sub(50)..bits + 50;
        let tables = (0..TABLES).flat_map(|k| near(48 * (SHORTEST_TABLE << k) as u64));
        let exponents = (0..3300)
            .chain(tables)
            .chain(near(BITS_OF_PART))
            .chain(near(2 * BITS_OF_PART));
        for exponent in exponents {
            let power = Natural::from(1_u32) << exponent;
            assert_eq!(decimal(&power), power.to_string(), "2^{exponent}");
            let before = power - Natural::from(1_u32);
            assert_eq!(decimal(&before), before.to_string(), "2^{exponent} - 1");
        }
        let digits = digits_of_parts(0);
        for exponent in
            (0..1000)
                .chain(digits - 20..digits + 20)
                .chain([2 * digits, 3 * digits, 4 * digits])
        {
            let power = Natural::from(10_u32).pow(exponent);
            let zeros = usize::try_from(exponent).unwrap();
            assert_eq!(
                decimal(&power),
                format!("1{}", "0".repeat(zeros)),
                "10^{exponent}"
            );
            let before = decimal(&(power - Natural::from(1_u32)));
            assert_eq!(
                before,
                if zeros == 0 {
                    "0".into()
                } else {
                    "9".repeat(zeros)
                },
                "10^{exponent} - 1"
            );
        }
    }
}
