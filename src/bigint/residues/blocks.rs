//! Sums of long Chinese remainders by transforms.
//!
//! The sum is Σ y P/p − qP, with the y and q of Lemma 1 of chinese.rs; P is the product of all primes p. The primes are divided
//! into *groups* of 48, and P_G is the product of the primes of the group G. The digits of each P/P_G are divided into *blocks*. A
//! block is multiplied by the sum of a group, Σ y P_G/p, by transforms modulo two primes p1 and p2.
//!
//! Lemma 1 (digits of groups). The sum Σ y P_G/p over the 48 primes of a group has at most [`GROUP_LEN`] digits of 40 bits.
//! Proof. y < p, so the sum is below 48 P_G < 2^5.6 · 2^2400 ≤ 2^(40 · 61). [`set_digits`] stops the program if there are more
//! digits.
//!
//! Lemma 2 (digits of the product). Consider a digit of the product of a group's sum and a block, summed over all groups and
//! over the two blocks that overlap there. It is a natural number below p1 p2.
//! Proof. A group's sum has 61 digits and a block has 68, so their product has 128, and the products of two neighbouring blocks
//! overlap. A digit of both products together is a sum of at most 61 products of digits, each below 2^80, so it is below 2^86.
//! There are fewer than 2^10 groups ([`MOST_PRIMES`]), so the sum is below 2^97 < 2^99.98 < p1 p2.
//!
//! Lemma 3 (unreduced sums). The sum of [`UNREDUCED`] products of values of at most 3p and p/2, and of a value of at most p/2 +
//! 1, is below 8p.
//! Proof. A product is at most (1/2 + 3/8 · 3/2) p = 17/16 p (Lemma 2 of lanes.rs), and 6 · 17/16 + 1/2 < 7.
//!
//! Lemma 4 (carrying). No sum in [`Blocks::put_together`] exceeds 64 bits.
//! Proof. `first` < 2^50, |low| ≤ 2^47, and `high` ≤ 2^52 (Lemma 1 of columns.rs, because p1 p2 < 2^100), which is 2^60 after a
//! shift by 8 bits. q is at most the number of primes, below 2^16, so its product with a digit of 40 bits is below 2^56. The
//! carry is then below 2^22.
//!
//! The law of all lemmas is `remainders_are_right_up_to_a_quarter_of_the_product` of chinese.rs, with y and digits as large as
//! possible.

use malachite::Natural;
use malachite::base::num::arithmetic::traits::DivExact;
use pulp::NullaryFnOnce;

use super::lanes::{LaneFields, Lanes, minus, plus};
use super::quartet::Quartet;
use super::transform::Transform;
use crate::bigint::{
    Columns, DIGIT_BITS, Machine, Sums, digits_of_bits, f64_from, halves_of_product, u64_from,
};

/// The number of quartets in a group.
const GROUP: usize = 12;
/// The length of transforms.
const LEN: usize = 128;
/// The number of bits of a digit that is transformed.
const SHORT_BITS: u32 = 40;
/// The number of digits of a group's sum. Lemma 1.
const GROUP_LEN: usize = 61;
/// The number of digits of a block: the product of a group's sum and a block has `LEN` digits. Lemma 2.
const BLOCK_LEN: usize = LEN + 1 - GROUP_LEN;
/// The largest number of primes, with which there are fewer than 2^10 groups. Lemma 2.
pub(super) const MOST_PRIMES: usize = 1023 * 4 * GROUP;
/// The number of sums that are formed together.
pub(super) const LANES: usize = 4;

/// The number of products that are added before the sum is reduced. Lemma 3.
const UNREDUCED: usize = 6;

/// The sum `Σ y P/p` over all primes is `Σ (P/P_G) Σ y P_G/p` over groups G of primes. The inner sums are computed directly.
/// The outer products are products of values at roots of unity: the values of P/P_G are known, and only the sum over all groups
/// is transformed back, once for each block. Four sums are computed at once, modulo two primes.
///
/// Cost, for n primes: products of n words with a group's length, n/24 + n/27 transforms, and (n/36)² products of `LEN` values.
pub(super) struct Blocks {
    fields: [LaneFields; 2],
    transforms: [Transform; 2],
    /// The inverse of the first prime modulo the second prime, of at most p/2.
    inverse: Lanes,
    /// The numbers P_G/p of each group.
    groups: Vec<Columns>,
    /// For each of the two primes, for each [`UNREDUCED`] groups and for each block, the values of all P/P_G, scaled for the
    /// backward transform, of at most p/2.
    tables: [Vec<f64>; 2],
    /// The digits of −P in two's complement.
    minus_p: Vec<u64>,
}

impl Blocks {
    /// The blocks for the primes of these quartets; their product is given, and its negative in limbs.
    pub(super) fn new(
        machine: Machine,
        quartets: &[Quartet],
        product: &Natural,
        minus_p: &[u64],
    ) -> Self {
        let groups = quartets.chunks(GROUP).map(|quartets| {
            let primes = quartets.iter().flat_map(Quartet::primes);
            primes.map(Natural::from).collect::<Vec<_>>()
        });
        let groups: Vec<_> = groups.collect();
        let products: Vec<Natural> = groups
            .iter()
            .map(|primes| primes.iter().product())
            .collect();
        let others: Vec<Natural> = products
            .iter()
            .map(|group| product.div_exact(group))
            .collect();
        let short = |number: &Natural| digits_of_bits(SHORT_BITS, number.limbs());
        let columns = |(primes, product): (&Vec<Natural>, &Natural)| {
            let others = primes.iter().map(|p| short(&product.div_exact(p)));
            Columns::new(machine, &others.collect::<Vec<_>>())
        };
        let minus_p = digits_of_bits(SHORT_BITS, minus_p.iter().copied());
        let blocks = minus_p.len().div_ceil(BLOCK_LEN);
        let others: Vec<_> = others.iter().map(short).collect();
        let primes = [0, 1].map(|i| quartets[0].of_one_prime(i));
        let tables = primes.each_ref().map(|prime| {
            machine.dispatch_fused(Tables {
                prime,
                others: &others,
                blocks,
            })
        });
        let [(first, in_first), (second, in_second)] = tables;
        let fields = primes.map(|prime| prime.field);
        Self {
            fields,
            transforms: [first, second],
            inverse: machine.dispatch_fused(Inverse { fields }),
            groups: groups.iter().zip(&products).map(columns).collect(),
            tables: [in_first, in_second],
            minus_p: minus_p.into_iter().map(u64_from).collect(),
        }
    }

    /// The sums Σ y P/p − qP for at most four lists of y, each followed by q, modulo 2^64 to the number of limbs of −P. The
    /// target has the limbs of the four sums side by side.
    #[inline(always)]
    pub(super) fn sum(&self, y: &[&[f64]], sums: &mut [Sums], target: &mut [[u64; LANES]]) {
        let blocks = self.minus_p.len().div_ceil(BLOCK_LEN);
        let mut values = [vec![[0.0; 4]; blocks * LEN], vec![[0.0; 4]; blocks * LEN]];
        let mut of_groups = [[[[0.0; 4]; LEN]; UNREDUCED]; 2];
        let mut start = 0;
        for (g, groups) in self.groups.chunks(UNREDUCED).enumerate() {
            for (k, group) in groups.iter().enumerate() {
                let mut here: [&[f64]; LANES] = [&[]; LANES];
                for (here, y) in here.iter_mut().zip(y) {
                    *here = &y[start..start + group.count()];
                }
                start += group.count();
                group.sums(&here[..y.len()], usize::MAX, sums);
                let [first, second] = &mut of_groups;
                set_digits(sums, &mut first[k]);
                second[k] = first[k];
                self.transforms[0].forward(&mut first[k]);
                self.transforms[1].forward(&mut second[k]);
            }
            for i in 0..2 {
                let tables = &self.tables[i][g * UNREDUCED * blocks * LEN..];
                let of_groups = &of_groups[i][..groups.len()];
                add_products(&self.fields[i], &mut values[i], of_groups, tables);
            }
        }
        for (values, transform) in values.iter_mut().zip(&self.transforms) {
            for block in values.chunks_exact_mut(LEN) {
                transform.backward(block);
            }
        }
        let mut q = [0; LANES];
        for (q, y) in q.iter_mut().zip(y) {
            *q = u64_from(y[y.len() - 1]);
        }
        self.put_together(&values, q, target);
    }

    /// Adds the digits of blocks, which overlap, and q times −P, and writes the sums as limbs. Lemmas 2 and 4.
    ///
    /// The digit with the remainders r1 modulo p1 and r2 modulo p2 is `r1 + p1 ((r2 − r1) / p1 mod p2)`.
    #[inline(always)]
    fn put_together(&self, values: &[Vec<Lanes>; 2], q: [u64; LANES], target: &mut [[u64; LANES]]) {
        const MASK: u64 = (1 << SHORT_BITS) - 1;
        let [field, second_field] = &self.fields;
        let (mut above, mut carry) = ([0_u64; LANES], [0_i64; LANES]);
        let (mut kept, mut bits) = ([0; LANES], 0);
        let mut targets = target.iter_mut();
        for (k, minus_p) in self.minus_p.iter().enumerate() {
            let (block, at) = (k / BLOCK_LEN, k % BLOCK_LEN);
            let here = block * LEN + at;
            let (mut first, mut second) = (values[0][here], values[1][here]);
            if block > 0 && BLOCK_LEN + at < LEN {
                let before = here - LEN + BLOCK_LEN;
                first = plus(first, values[0][before]);
                second = plus(second, values[1][before]);
            }
            let first = field.canonical(first);
            let times =
                second_field.times(second_field.reduced(minus(second, first)), self.inverse);
            let times = second_field.canonical(times);
            let mut digit = [0; LANES];
            for lane in 0..LANES {
                let [high, low] = halves_of_product(field.p[lane], times[lane]);
                let sum = low
                    .wrapping_add(u64_from(first[lane]))
                    .wrapping_add(q[lane] * minus_p)
                    .wrapping_add(above[lane])
                    .cast_signed()
                    + carry[lane];
                digit[lane] = sum.cast_unsigned() & MASK;
                carry[lane] = sum >> SHORT_BITS;
                above[lane] = high << (DIGIT_BITS - SHORT_BITS);
            }
            for lane in 0..LANES {
                kept[lane] |= digit[lane] << bits;
            }
            bits += SHORT_BITS;
            if bits >= u64::BITS {
                if let Some(target) = targets.next() {
                    *target = kept;
                }
                bits -= u64::BITS;
                for lane in 0..LANES {
                    kept[lane] = digit[lane] >> (SHORT_BITS - bits);
                }
            }
        }
        if let Some(target) = targets.next() {
            *target = kept;
        }
    }
}

/// Sets the digits of sums. The program stops if a sum has more digits than fit. Lemma 1.
#[inline(always)]
fn set_digits(sums: &[Sums], digits: &mut [Lanes; LEN]) {
    *digits = [[0.0; 4]; LEN];
    for (lane, sums) in sums.iter().enumerate() {
        let mut at = 0;
        sums.carried(SHORT_BITS, |digit| {
            digits[at][lane] = f64_from(digit);
            at += 1;
        });
    }
}

/// Adds, for all blocks, the products of the values of some groups and those in the tables. The values are at most p/2 + 1
/// before and after. Lemma 3.
#[inline(always)]
fn add_products(
    field: &LaneFields,
    values: &mut [Lanes],
    of_groups: &[[Lanes; LEN]],
    tables: &[f64],
) {
    let tables = tables.chunks_exact(LEN * of_groups.len());
    for (values, tables) in values.chunks_exact_mut(LEN).zip(tables) {
        for (k, value) in values.iter_mut().enumerate() {
            let mut sum = *value;
            for (of_group, table) in of_groups.iter().zip(tables.chunks_exact(LEN)) {
                sum = plus(sum, field.times(of_group[k], [table[k]; 4]));
            }
            *value = field.reduced(sum);
        }
    }
}

/// The transform, and the values of the blocks of all P/P_G, which are given by their digits.
struct Tables<'a> {
    prime: &'a Quartet,
    others: &'a [Vec<f64>],
    blocks: usize,
}

impl NullaryFnOnce for Tables<'_> {
    type Output = (Transform, Vec<f64>);

    #[inline(always)]
    fn call(self) -> Self::Output {
        let field = self.prime.field;
        let transform = self.prime.transform(LEN);
        let scale = field.factor(transform.scale());
        let mut tables = Vec::with_capacity(self.others.len() * self.blocks * LEN);
        for others in self.others.chunks(UNREDUCED) {
            for block in 0..self.blocks {
                for digits in others {
                    let mut values = [[0.0; 4]; LEN];
                    let digits = digits.iter().skip(block * BLOCK_LEN);
                    for (value, digit) in values[..BLOCK_LEN].iter_mut().zip(digits) {
                        *value = [*digit; 4];
                    }
                    transform.forward(&mut values);
                    for value in values {
                        tables.push(field.reduced(field.times_factor(value, scale))[0]);
                    }
                }
            }
        }
        (transform, tables)
    }
}

/// The inverse of the first prime modulo the second one.
struct Inverse {
    fields: [LaneFields; 2],
}

impl NullaryFnOnce for Inverse {
    type Output = Lanes;

    #[inline(always)]
    fn call(self) -> Lanes {
        let [first, second] = self.fields;
        second.reduced(second.inverse_of(second.reduced(first.p)))
    }
}
