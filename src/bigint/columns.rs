//! Sums Σ y C of large numbers C with words y as factors, digit by digit, in doubles.
//!
//! Lemma 1 (halves of a product). Let a, b ≥ 0 be integers that are doubles, with a b ≤ 2^100 − 2^47. Let h = fl(2^100 + a b),
//! where fl rounds once, and l = fl(a b + (2^100 + 2^52 + 2^51 − h)). Let `high` be the bits of h, as an integer, minus those
//! of 2^100, and `low` the bits of l minus those of 2^52 + 2^51. Then `a b = 2^48 high + low`, and |low| ≤ 2^47.
//! Proof. From 2^100 to 2^101 the doubles are the multiples of 2^48, and their bits count them: h = 2^100 + 2^48 high with |a b
//! − 2^48 high| ≤ 2^47. So 2^100 + 2^52 + 2^51 − h is a multiple of 2^48 below 2^101, hence a double. And a b − 2^48 high +
//! 2^52 + 2^51 is an integer between 2^52 and 2^53, hence a double, whose last bits count the integers.
//! Laws: `products_are_their_halves`, `sums_are_those_of_products`.
//!
//! Lemma 2 (sums). The sums of `high` and of `low` over n ≤ 2^12 products below 2^98 are at most 2^50 n ≤ 2^62 and 2^47 n ≤
//! 2^59. So they fit in 64 bits, in two's complement, and the bits of the products and those of the constants may be added and
//! subtracted in any order.
//! Proof. Lemma 1 holds for each product, and additions modulo 2^64 are exact if the final result is between −2^63 and 2^63.
//! Law: `the_largest_sums`.
//!
//! Lemma 3 (carrying). If high · 2^(48 − bits) ≤ 2^62 for all sums, no step of [`Sums::carried`] exceeds 64 bits.
//! Proof. A carry is at most (2^62 + 2^59 + carry) / 2^bits, hence below 2^31 for bits ≥ 32. So the sum of `low`, `above` and
//! the carry is below 2^59 + 2^62 + 2^31 < 2^63.
//! Laws: `the_largest_sums` (48 bits), `sums_are_those_of_products` (40 bits).

use pulp::{Simd, WithSimd};

use super::{Machine, f64_from};

/// The number of bits of the lower part of a sum, and of digits in base 2^48.
pub(crate) const DIGIT_BITS: u32 = 48;

/// The number 2^100. The last bit of it, and of all doubles up to 2^101, is worth 2^48.
const HIGH: f64 = f64::from_bits((100 + 1023) << 52);

/// The number 2^52 + 2^51. The last bit of it, and of all doubles that differ from it by less than 2^51, is worth 1.
const LOW: f64 = f64::from_bits((52 + 1023) << 52 | 1 << 51);

/// The largest number of products in a sum.
const MOST_PRODUCTS: usize = 1 << 12;

/// Some natural numbers C, by their digits in any base, the least significant first.
#[derive(Clone, Debug)]
pub(crate) struct Columns {
    machine: Machine,
    /// The number of the numbers C.
    count: usize,
    /// The number of digits that are processed together: as many as fit in two registers of the machine.
    across: usize,
    panels: Vec<Panel>,
}

/// The digits of all numbers at `across` consecutive positions.
#[derive(Clone, Debug)]
struct Panel {
    /// The index of the first number that has a digit there.
    first: usize,
    /// The digits of this number, then those of the next one, and so on.
    digits: Vec<f64>,
}

/// The sums at one position after the other. Each is `Σ y c = 2^48 high + low`, where |low| is at most 2^47 times the number of
/// products.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sums {
    pub(crate) high: Vec<u64>,
    pub(crate) low: Vec<u64>,
}

impl Columns {
    /// Numbers by their digits. A number must have at least as many digits as the one before. `machine` names the instructions
    /// that compute the sums.
    pub(crate) fn new(machine: Machine, numbers: &[Vec<f64>]) -> Self {
        let across = machine.dispatch(Across);
        let len = numbers.iter().map(Vec::len).max().unwrap_or(0);
        let panel = |start: usize| {
            let is_short = |number: &&Vec<f64>| number.len() <= start;
            let first = numbers.iter().take_while(is_short).count();
            let digits = numbers[first..].iter().flat_map(|number| {
                let digits = number.iter().skip(start).copied();
                digits.chain(std::iter::repeat(0.0)).take(across)
            });
            Panel {
                first,
                digits: digits.collect(),
            }
        };
        Self {
            machine,
            count: numbers.len(),
            across,
            panels: (0..len).step_by(across).map(panel).collect(),
        }
    }

    /// The number of the numbers C.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// The first `len` digits of Σ y C for each list of y, and perhaps some more. A list may not be longer than the number of
    /// numbers, and the products y c must be below 2^98.
    ///
    /// # Panics
    /// If a list has more than 2^12 words, which Lemma 2 does not allow.
    pub(crate) fn sums(&self, y: &[&[f64]], len: usize, sums: &mut [Sums]) {
        assert!(
            y.iter().all(|y| y.len() <= MOST_PRODUCTS),
            "sums are of at most {MOST_PRODUCTS} products"
        );
        let panels = self.panels.len().min(len.div_ceil(self.across));
        let summation = Summation {
            across: self.across,
            panels: &self.panels[..panels],
            y,
            sums,
        };
        self.machine.dispatch_fused(summation);
    }
}

/// `a b = 2^48 high + low`, by Lemma 1; `low` is in two's complement.
#[inline(always)]
pub(crate) fn halves_of_product(a: f64, b: f64) -> [u64; 2] {
    let rounded = a.mul_add(b, HIGH);
    let left = a.mul_add(b, (HIGH + LOW) - rounded);
    let low = left.to_bits().wrapping_sub(LOW.to_bits());
    [rounded.to_bits() - HIGH.to_bits(), low]
}

impl Sums {
    /// Passes the digits of Σ y C in base 2^`bits`, at most 2^48, to `digit`, with all carries. The digits of the numbers C
    /// must be in that base. All digits are passed if there are sums for all digits of C. Lemma 3.
    #[inline(always)]
    pub(crate) fn carried(&self, bits: u32, mut digit: impl FnMut(u64)) {
        let mask = (1 << bits) - 1;
        let (mut above, mut carry) = (0_u64, 0_i64);
        for (high, low) in self.high.iter().zip(&self.low) {
            let sum = low.wrapping_add(above).cast_signed() + carry;
            digit(sum.cast_unsigned() & mask);
            carry = sum >> bits;
            above = *high << (DIGIT_BITS - bits);
        }
        let last = above.wrapping_add(carry.cast_unsigned());
        digit(last & mask);
        digit(last >> bits);
    }

    /// Writes the number as limbs, as many as the target has. This is right if there are sums for all of their digits.
    #[inline(always)]
    pub(crate) fn limbs(&self, target: &mut [u64]) {
        let mut targets = target.iter_mut();
        let (mut kept, mut bits) = (0, 0);
        self.carried(DIGIT_BITS, |digit| {
            let limb = kept | digit << bits;
            if bits + DIGIT_BITS < u64::BITS {
                (kept, bits) = (limb, bits + DIGIT_BITS);
                return;
            }
            if let Some(target) = targets.next() {
                *target = limb;
            }
            bits = bits + DIGIT_BITS - u64::BITS;
            kept = digit >> (DIGIT_BITS - bits);
        });
        for target in targets {
            *target = std::mem::take(&mut kept);
        }
    }
}

/// The number of digits in base 2^48 of a number with this many limbs.
pub(crate) fn digits_for(limbs: usize) -> usize {
    (limbs * 4).div_ceil(3)
}

/// The digits in base 2^48 of a number that is given by its limbs.
pub(crate) fn digits(limbs: impl IntoIterator<Item = u64>) -> Vec<f64> {
    digits_of_bits(DIGIT_BITS, limbs)
}

/// The digits in base 2^`bits` of a number that is given by its limbs; `bits` must be from 32 to 50.
#[inline]
pub(crate) fn digits_of_bits(bits: u32, limbs: impl IntoIterator<Item = u64>) -> Vec<f64> {
    let limbs = limbs.into_iter();
    let mut digits = Vec::with_capacity(limbs.size_hint().0 * 64 / bits as usize + 1);
    let mask = (1 << bits) - 1;
    let (mut kept, mut count) = (0_u64, 0);
    for limb in limbs {
        digits.push(f64_from((kept | limb << count) & mask));
        (kept, count) = (limb >> (bits - count), count + u64::BITS - bits);
        if count >= bits {
            digits.push(f64_from(kept & mask));
            (kept, count) = (kept >> bits, count - bits);
        }
    }
    if count > 0 {
        digits.push(f64_from(kept));
    }
    digits
}

struct Across;

impl WithSimd for Across {
    type Output = usize;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> usize {
        2 * S::F64_LANES
    }
}

struct Summation<'a> {
    across: usize,
    panels: &'a [Panel],
    y: &'a [&'a [f64]],
    sums: &'a mut [Sums],
}

impl WithSimd for Summation<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self {
            across,
            panels,
            y,
            sums,
        } = self;
        let len = panels.len() * across;
        for sums in sums.iter_mut() {
            sums.high.resize(len, 0);
            sums.low.resize(len, 0);
        }
        // Each panel is used for all lists while it is in the cache, and each digit that is read is used for two lists.
        for (panel, start) in panels.iter().zip((0..).step_by(across)) {
            let mut y = y.chunks_exact(2);
            let mut sums = sums.chunks_exact_mut(2);
            for (y, sums) in (&mut y).zip(&mut sums) {
                panel.sums(simd, [y[0], y[1]], sums, start);
            }
            for (y, sums) in y
                .remainder()
                .iter()
                .zip(sums.into_remainder().chunks_mut(1))
            {
                panel.sums(simd, [*y], sums, start);
            }
        }
    }
}

impl Panel {
    /// The sums at the positions from `start` on, for as many lists as there are sums.
    ///
    /// Lemmas 1 and 2 hold for fused products. `mul_add_e_f64s` would round twice on machines without them.
    #[inline(always)]
    fn sums<S: Simd, const B: usize>(
        &self,
        simd: S,
        y: [&[f64]; B],
        sums: &mut [Sums],
        start: usize,
    ) {
        let (both, above) = (simd.splat_f64s(HIGH + LOW), simd.splat_f64s(HIGH));
        let mut high = [[simd.splat_u64s(0); 2]; B];
        let mut low = [[simd.splat_u64s(0); 2]; B];
        let digits = S::as_simd_f64s(&self.digits).0.as_chunks::<2>().0;
        let count = y[0].len().saturating_sub(self.first).min(digits.len());
        for (i, digits) in digits[..count].iter().enumerate() {
            for b in 0..B {
                let y = simd.splat_f64s(y[b][self.first + i]);
                for half in 0..2 {
                    let rounded = simd.mul_add_f64s(y, digits[half], above);
                    let left = simd.sub_f64s(both, rounded);
                    let left = simd.mul_add_f64s(y, digits[half], left);
                    high[b][half] = simd.add_u64s(high[b][half], simd.transmute_u64s_f64s(rounded));
                    low[b][half] = simd.add_u64s(low[b][half], simd.transmute_u64s_f64s(left));
                }
            }
        }
        let constants =
            |constant: f64| simd.splat_u64s(constant.to_bits().wrapping_mul(count as u64));
        let constants = [constants(HIGH), constants(LOW)];
        for b in 0..B {
            let into_high = S::as_mut_simd_u64s(&mut sums[b].high[start..]).0;
            into_high[0] = simd.sub_u64s(high[b][0], constants[0]);
            into_high[1] = simd.sub_u64s(high[b][1], constants[0]);
            let into_low = S::as_mut_simd_u64s(&mut sums[b].low[start..]).0;
            into_low[0] = simd.sub_u64s(low[b][0], constants[1]);
            into_low[1] = simd.sub_u64s(low[b][1], constants[1]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bigint::u64_from;
    use malachite::Integer;
    use malachite::Natural;
    use proptest::prelude::*;

    /// Words up to `most`, more often at the ends of the range than between.
    fn word(most: u64) -> impl Strategy<Value = u64> {
        let middle = most / 2 + 1;
        prop_oneof![
            Just(0),
            Just(1),
            Just(most),
            Just(most - 1),
            Just(middle),
            Just(middle - 1),
            Just(middle + 1),
            0..=most
        ]
    }

    /// The number with these digits, some of which may be negative or too large.
    fn number(digits: impl DoubleEndedIterator<Item = Integer>) -> Integer {
        digits.rev().fold(Integer::from(0), |number, digit| {
            (number << DIGIT_BITS) + digit
        })
    }

    proptest! {
        #[test]
        fn sums_are_those_of_products(
            lens in prop::collection::vec(0usize..40, 1..30),
            lists in 1usize..6,
            words in prop_oneof![Just((1 << 48) - 1), Just((1 << 40) - 1)].prop_flat_map(|most| prop::collection::vec((word(most), word((1 << 50) - 1)), 1..200)),
            fewer in 0usize..4,
            machine in prop::sample::select(Machine::all().to_vec()),
        ) {
            let mut lens = lens;
            lens.sort_unstable();
            let mut words = words.iter().cycle();
            let numbers: Vec<Vec<u64>> = lens.iter().map(|len| words.by_ref().take(*len).map(|w| w.0).collect()).collect();
            let count = numbers.len().saturating_sub(fewer).max(1);
            let y: Vec<Vec<u64>> = (0..lists).map(|_| words.by_ref().take(count).map(|w| w.1).collect()).collect();
            let doubles = |words: &Vec<u64>| words.iter().copied().map(f64_from).collect::<Vec<f64>>();
            let columns = Columns::new(machine, &numbers.iter().map(doubles).collect::<Vec<_>>());
            prop_assert_eq!(columns.count(), numbers.len());
            let in_doubles: Vec<Vec<f64>> = y.iter().map(doubles).collect();
            let in_doubles: Vec<&[f64]> = in_doubles.iter().map(Vec::as_slice).collect();
            let mut sums = vec![Sums::default(); lists];
            columns.sums(&in_doubles, usize::MAX, &mut sums);
            for ((y, sums), in_doubles) in y.iter().zip(&sums).zip(in_doubles) {
                let terms = y.iter().zip(&numbers);
                let expected: Integer = terms.map(|(y, c)| Integer::from(*y) * number(c.iter().map(|c| Integer::from(*c)))).sum();
                let places = sums.high.iter().zip(&sums.low);
                let found = number(places.map(|(high, low)| (Integer::from(*high) << DIGIT_BITS) + Integer::from(low.cast_signed())));
                prop_assert_eq!(&found, &expected);
                // The same digits in another base are those of another number.
                let in_other_base = numbers.iter().map(|c| c.iter().rev().fold(Integer::from(0), |n, c| (n << 40_u32) + Integer::from(*c)));
                let other: Integer = y.iter().zip(in_other_base).map(|(y, c)| Integer::from(*y) * c).sum();
                let mut digits = Vec::new();
                if numbers.iter().flatten().all(|c| *c < 1 << 40) {
                    sums.carried(40, |digit| digits.push(digit));
                    let carried = digits.iter().rev().fold(Integer::from(0), |n, digit| (n << 40_u32) + Integer::from(*digit));
                    prop_assert_eq!(carried, other);
                }
                // The sums as limbs: all limbs, and fewer, for which fewer sums are enough.
                let all = expected.into_twos_complement_limbs_asc();
                let width = all.len();
                for width in [width + 1, width, width / 2] {
                    let mut limbs = vec![0; width];
                    sums.limbs(&mut limbs);
                    let (mut enough, mut again) = ([Sums::default()], vec![0; width]);
                    columns.sums(&[in_doubles], digits_for(width), &mut enough);
                    enough[0].limbs(&mut again);
                    prop_assert_eq!(&again, &limbs);
                    let mut expected = all.clone();
                    expected.resize(width, 0);
                    prop_assert_eq!(limbs, expected);
                }
            }
        }

        #[test]
        fn digits_are_those_of_the_number(limbs in prop::collection::vec(word(u64::MAX), 0..20), bits in 32u32..51) {
            let digits = digits_of_bits(bits, limbs.iter().copied());
            prop_assert_eq!(digits.len(), (64 * limbs.len()).div_ceil(bits as usize));
            let found = digits.into_iter().rev().fold(Natural::from(0_u32), |number, digit| {
                (number << bits) + Natural::from(u64_from(digit))
            });
            prop_assert_eq!(found, Natural::from_limbs_asc(&limbs));
        }

        #[test]
        fn products_are_their_halves(a in word((1 << 50) - 1), b in word((1 << 50) - 1)) {
            let [high, low] = halves_of_product(f64_from(a), f64_from(b));
            prop_assert!(low.cast_signed().unsigned_abs() <= 1 << 47);
            let found = (Integer::from(high) << DIGIT_BITS) + Integer::from(low.cast_signed());
            prop_assert_eq!(found, Integer::from(a) * Integer::from(b));
        }
    }

    /// The largest number of products with the largest factors, and with the largest low parts of both signs.
    #[test]
    fn the_largest_sums() {
        let count = u128::try_from(MOST_PRODUCTS).unwrap();
        for machine in Machine::all() {
            for (y, c) in [
                ((1 << 50) - 1, (1 << 48) - 1),
                (1, 1 << 47),
                ((1 << 50) - 1, 1 << 47),
                (3, 1 << 47),
                (1, (1 << 47) + 1),
            ] {
                let columns = Columns::new(machine, &vec![vec![f64_from(c)]; MOST_PRODUCTS]);
                let y_list = vec![f64_from(y); MOST_PRODUCTS];
                let mut sums = [Sums::default()];
                columns.sums(&[&y_list], 1, &mut sums);
                let mut limbs = [0; 2];
                sums[0].limbs(&mut limbs);
                let found = u128::from(limbs[0]) | u128::from(limbs[1]) << 64;
                assert_eq!(
                    found,
                    u128::from(y) * u128::from(c) * count,
                    "{machine:?}, {y} {c}"
                );
            }
        }
    }

    #[test]
    #[should_panic(expected = "sums are of at most 4096 products")]
    fn more_products_are_refused() {
        let columns = Columns::new(Machine::this(), &vec![vec![1.0]; MOST_PRODUCTS + 1]);
        columns.sums(&[&vec![1.0; MOST_PRODUCTS + 1]], 1, &mut [Sums::default()]);
    }
}
