//! Whole numbers are written in decimal as sums of powers of two in base 10^15. Only very long numbers need divisions.
//!
//! A *digit* is a digit in base 2^48, a *place* is a digit in base 10^15, which 15 decimal digits write. A long number is divided
//! into *parts* of [`PLACES_OF_PART`] places each.
//!
//! Lemma 1 (places). Numbers below 2^(48 n), 1 ≤ n ≤ [`LONGEST_TABLE`], have at most ⌊9633 n / 10 000⌋ + 1 places.
//! Proof. They have fewer than 48 n log10(2) / 15 + 1 < 0.963297 n + 1 places; the number of places is an integer.
//! Laws: `places_are_enough_and_not_many_more`, `powers_and_the_numbers_before_them`.
//!
//! Lemma 2 (parts). A number of at most [`BITS_OF_PART`] bits has at most [`PLACES_OF_PART`] places, and a number of
//! [`PLACES_OF_PART`] places is below 2^(48 n) with n = [`LONGEST_TABLE`].
//! Proof. With P = 986 places and log2(10^15) = 49.82892…, a number of at most 49.828 P bits is below 2^(49.828 P) < 10^(15 P). And
//! 10^(15 P) < 2^(49.829 · 986) < 2^49 152, where 49 152 = 48 · 1024.
//! Law: `places_are_enough_and_not_many_more`.
//!
//! Lemma 3 (carrying). The sums of at most [`LONGEST_TABLE`] products of digits and places have `high` < 2^60 and |low| ≤ 2^57.
//! With a carry of at least −146 and below 2^59, [`carried`] returns the remainder of 2^48 high + low + carry modulo 10^15, and
//! makes the quotient the next carry, which is again at least −146 and below 2^59.
//! Proof. A product is below 2^48 · 10^15, so its `high` is at most 10^15 < 2^49.83, and 1024 of them are below 2^60; 1024 · 2^47 =
//! 2^57 bounds |low|. The quotient of 2^48 high by 10^15 is high · 2^33/5^15. Its computed value is less than 1 + 2^-4 too small:
//! cutting 2^97/5^15 to an integer loses less than high/2^64 < 2^-4, and cutting the product loses less than 1. So the remainder of
//! 2^48 high, with low, the carry and 256 · 10^15 added, is above −2^57 − 146 + 2^57.8 > 0 and below
//! (1 + 2^-4 + 256) · 10^15 + 2^57 + 2^59 < 2^60. The next carry is an integer above (−2^57 − 146)/10^15 − 1 > −147, and below
//! 2^60 · 2^48/10^15 + 1000 < 2^59.
//! Law: `carries_are_quotients_and_places_are_rests`.
//!
//! Lemma 4 (the first seven decimal digits). For a place, [`seven_and_eight`] returns the quotient and the remainder by 10^8.
//! Proof. The place is 2^18 t + s with s < 2^18 and t < 2^32. The product of t with ⌊2^58/10^8⌋, divided by 2^40, is less than
//! place/10^8 by less than 2^18/10^8 + t/2^40 < 1/100. So the computed quotient may be one too small, and then the remainder is
//! below 1.01 · 10^8 < 2^27.
//! Law: `places_are_cut_in_fours`.
//!
//! Lemma 5 (groups of four decimal digits). ⌊109 951 163 v / 2^40⌋ = ⌊v/10^4⌋ for v < 10^8, ⌊5243 v / 2^19⌋ = ⌊v/100⌋ for v < 10^4, and
//! ⌊103 v / 2^10⌋ = ⌊v/10⌋ for v < 100.
//! Proof. The factors exceed 10^-4, 10^-2 and 10^-1 by less than 10^-12, 0.5 · 10^-6 and 0.6 · 10^-3. So the products exceed v/10^k by
//! less than 10^-k, and the next integer above v/10^k is at least 10^-k away.
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

/// The base of the places. [`Columns::sums`] requires that 2^48 times a place is below 2^98, and that [`LONGEST_TABLE`] is at most
/// 2^12.
const BASE: u64 = 10_u64.pow(15);

/// The number of powers of 2^48 in the first table of places; each further table has twice as many as the one before. If the
/// last table had half as many, more numbers would be divided: 400 limbs would take 1.15 times as long, 800 limbs 1.3 times.
const SHORTEST_TABLE: usize = 32;
const TABLES: usize = 6;
const LONGEST_TABLE: usize = SHORTEST_TABLE << (TABLES - 1);

/// Numbers of at most this many limbs need no division. Three limbs are four digits.
const LIMBS_WITHOUT_DIVISION: usize = LONGEST_TABLE / 4 * 3;

/// The number of places of a part; a digit is worth 48 log10(2) / 15 = 0.963296 places. Lemma 2.
const PLACES_OF_PART: usize = LONGEST_TABLE * 9632 / 10_000;

/// A number of at most this many bits fits in one part. Lemma 2.
const BITS_OF_PART: u64 = PLACES_OF_PART as u64 * 49_828 / 1000;

/// Appends the decimal digits of a number, without a sign and without leading zeros; 0 is `0`.
///
/// With the digits y_i the number is Σ y_i 2^(48 i), and a table holds the places of each power of two. The places of this sum are
/// computed in doubles ([`Columns`]), and a carry goes from each place to the next.
///
/// Cost: for n ≤ 49 152 bits, n²/4800 products of doubles by fused multiply-adds, four at a time. Longer numbers are
/// divided by powers of ten until their parts are as short as that. The tables and these powers are computed when they are first
/// needed, and kept: the longest table takes 4 MB, and the powers are about as long as the longest number. On a machine without
/// fused multiply-adds malachite's own conversion is used.
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

/// The tables of places for one machine, each computed when it is first needed.
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

    /// Appends the decimal digits of a number that is not 0.
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

    /// Appends a number of at most 2^`level` parts, with all the leading zeros of these parts if `padded`, else with none.
    fn append_parts(&self, number: &Natural, level: u32, padded: bool, text: &mut Vec<u8>) {
        if level == 0 {
            return self.append_places(
                number.as_limbs_asc(),
                padded.then_some(PLACES_OF_PART),
                text,
            );
        }
        // The number is cut in two halves at 10^k = 2^k 5^k.
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

    /// Appends a number of at most [`LIMBS_WITHOUT_DIVISION`] limbs, in `padded_to` places or without leading zeros.
    fn append_places(&self, limbs: &[u64], padded_to: Option<usize>, text: &mut Vec<u8>) {
        let y = digits(limbs.iter().copied());
        let places = padded_to.unwrap_or(places_for(y.len()));
        let mut sums = [Sums::default()];
        self.table(y.len()).sums(&[&y], places, &mut sums);
        let [mut sums] = sums;
        let start = text.len();
        text.resize(start + DIGITS * places, b'0');
        self.machine.dispatch_fused(Places {
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

    /// A table with the places of the first `len` powers of 2^48 and at least one more, so that it has enough columns for every
    /// number below the last of them.
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

/// A number whose `Display` gives the same text as malachite's, in less time.
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

/// The number of decimal digits of 2^`level` parts.
fn digits_of_parts(level: u32) -> u64 {
    ((DIGITS * PLACES_OF_PART) as u64) << level
}

/// 5 to the power [`digits_of_parts`], with the data that malachite precomputes for divisions by it.
struct Divisor {
    five: Natural,
    inverse: <Natural as DivModPrecomputed>::Data,
}

fn power_of_five(level: u32) -> &'static Divisor {
    // 64 levels are enough for any number that fits in memory.
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

/// A number of places that is enough for all numbers below 2^(48 `len`). Lemma 1.
fn places_for(len: usize) -> usize {
    len * 9633 / 10_000 + 1
}

/// The place of 2^48 `high` + `low` + `carry`, that is the remainder modulo 10^15; the quotient becomes the new `carry`. `low` and
/// `carry` may be negative, in two's complement. Lemma 3.
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

/// Writes the decimal digits of sums of places into `text`, which determines their number.
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
        // Two loops instead of one, so that the compiler vectorizes each of them.
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

/// The first seven and the last eight decimal digits of a place, by products of 32-bit factors. Lemma 4.
#[inline(always)]
fn seven_and_eight(place: u64) -> [u64; 2] {
    const HUNDRED_MILLION: u64 = 100_000_000;
    let quotient = (low_half(place >> 18) * ((1 << 58) / HUNDRED_MILLION)) >> 40;
    let rest = place - low_half(quotient) * HUNDRED_MILLION;
    let is_less = (rest + ((1 << 27) - HUNDRED_MILLION)) >> 27;
    [quotient + is_less, rest - is_less * HUNDRED_MILLION]
}

/// The same number, for numbers below 2^32; the mask tells the compiler that the number is that short.
#[inline(always)]
fn low_half(value: u64) -> u64 {
    value & 0xFFFF_FFFF
}

/// The first four decimal digits of a number below 10^8 in the lower 32 bits of a word, and the last four in the upper 32 bits.
/// Lemma 5.
#[inline(always)]
fn two_fours(value: u64) -> u64 {
    let value = low_half(value);
    let first = (value * 109_951_163) >> 40;
    first | (value - low_half(first) * 10_000) << 32
}

/// The four decimal digits of a number below 10^4 as the ASCII bytes of a word, the first in the lowest byte. Lemma 5, applied to
/// two numbers at once.
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

    /// Numbers of `limbs` limbs (fewer if the top ones are 0): random ones, and long runs of equal bits.
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
        /// The digits are those of `num-bigint`.
        #[test]
        fn all_lengths_have_the_digits_of_another_library(number in number(0usize..60)) {
            let other = BigUint::from_bytes_le(&number.as_limbs_asc().iter().flat_map(|limb| limb.to_le_bytes()).collect::<Vec<_>>());
            prop_assert_eq!(decimal(&number), other.to_string());
        }

        /// The digits are those of malachite, for numbers up to parts of parts and around the first division.
        #[test]
        fn long_numbers_have_the_digits_of_malachite(number in number(prop_oneof![60usize..700, 764usize..772, 700usize..4000])) {
            prop_assert_eq!(decimal(&number), number.to_string());
        }

        /// The digits are the same with all instructions, also without fused products, and with or without divisions.
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

        /// Carries and places are those of wider integers.
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
            // Multiples of powers of ten, and their neighbours.
            let unit = 10_u64.pow(zeros);
            for place in [place, (place / unit * unit).saturating_add_signed(edge).min(BASE - 1)] {
                let [above, below] = seven_and_eight(place);
                prop_assert_eq!([above, below], [place / 100_000_000, place % 100_000_000]);
                for part in [above, below] {
                    prop_assert_eq!(two_fours(part), part / 10_000 + ((part % 10_000) << 32));
                }
            }
        }

        /// Widths, leading zeros and signs are those of malachite.
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
            // 10^(15 places) ≥ 2^(48 len), by the bits of both, and by less than 100 bits: that is about two places.
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
        // All lengths up to the second table, and those near the limits of all tables and of parts.
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
