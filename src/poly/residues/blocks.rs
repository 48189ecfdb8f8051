//! The sums of long Chinese remainders by transforms: primes in groups, the rest of their product in blocks.

use malachite::Natural;
use malachite::base::num::arithmetic::traits::DivExact;
use pulp::{Arch, NullaryFnOnce};

use super::quad::{Quad, QuadField, plus};
use super::quartet::Quartet;
use super::transform::Transform;
use crate::exact::{Columns, Sums, digits, f64_from, u64_from};

/// Quartets in a group: Σ y P_G/p over their 56 primes is below 56 P_G.
const GROUP: usize = 14;
/// The length of transforms.
const LEN: usize = 384;
/// Short digits, of 16 bits, of such a sum, which has at most 2806 bits.
const GROUP_LEN: usize = 176;
/// Short digits of a block. The product of a group's sum and a block has `LEN` digits, which are sums of at most 176
/// products below 2^32; and all groups together, which are less than 2^9, stay below 2^49.
const BLOCK_LEN: usize = LEN + 1 - GROUP_LEN;
/// So many primes are less than 2^9 groups.
pub(super) const MOST_PRIMES: usize = 511 * 4 * GROUP;
/// Sums that are formed side by side.
pub(super) const LANES: usize = 4;

/// So many products of at most 17/16 p, and p/2, are below 2^53.
const UNREDUCED: usize = 6;

/// `Σ y P/p` over all primes is `Σ (P/P_G) Σ y P_G/p` over groups G of primes: the inner sums are formed as they stand, the
/// outer products as products of values at roots of unity, of which those of P/P_G are known and only the sum over all
/// groups is transformed back, once for each block. Four sums at once, modulo one prime.
///
/// Cost: for n primes n words times a group's length, n/56 + n/65 transforms and (n/60)² products of `LEN` values.
pub(super) struct Blocks {
    field: QuadField,
    transform: Transform,
    /// For each group P_G/p.
    groups: Vec<Columns>,
    /// For each [`UNREDUCED`] groups, block after block of all P/P_G, their values, scaled for the way back, of at most
    /// p/2.
    tables: Vec<f64>,
    /// −P in two's complement, in short digits, as many as there are limbs.
    minus_p: Vec<f64>,
}

impl Blocks {
    /// For the primes of these quartets, with this product, and the negative of it in limbs.
    pub(super) fn new(quartets: &[Quartet], product: &Natural, minus_p: &[u64]) -> Self {
        let one = quartets[0].first_prime();
        let groups = quartets.chunks(GROUP).map(|quartets| {
            let primes = quartets.iter().flat_map(Quartet::primes);
            primes.map(Natural::from).collect::<Vec<_>>()
        });
        let groups: Vec<_> = groups.collect();
        let products: Vec<Natural> = groups
            .iter()
            .map(|primes| primes.iter().product())
            .collect();
        let minus_p: Vec<f64> = minus_p.iter().copied().flat_map(short_digits).collect();
        let others: Vec<Natural> = products
            .iter()
            .map(|group| product.div_exact(group))
            .collect();
        let (transform, tables) = Arch::new().dispatch(Tables {
            prime: &one,
            others,
            blocks: minus_p.len().div_ceil(BLOCK_LEN),
        });
        let columns = |(primes, product): (&Vec<Natural>, &Natural)| {
            let others = primes.iter().map(|p| digits(product.div_exact(p).limbs()));
            Columns::new(&others.collect::<Vec<_>>())
        };
        Self {
            field: one.field,
            transform,
            groups: groups.iter().zip(&products).map(columns).collect(),
            tables,
            minus_p,
        }
    }

    /// Σ y P/p − qP for at most four lists of y, each followed by q, modulo 2^64 to the number of limbs of −P: limb by
    /// limb.
    #[inline(always)]
    pub(super) fn sum(&self, y: &[&[f64]], sums: &mut [Sums], target: &mut [[u64; LANES]]) {
        let Self {
            field,
            transform,
            groups,
            tables,
            minus_p,
        } = self;
        let blocks = minus_p.len().div_ceil(BLOCK_LEN);
        let mut values: Vec<Quad> = vec![[0.0; 4]; blocks * LEN];
        let mut of_groups = vec![[[0.0; 4]; LEN]; UNREDUCED];
        let mut start = 0;
        let tables = tables.chunks(UNREDUCED * values.len());
        for (groups, tables) in groups.chunks(UNREDUCED).zip(tables) {
            for (group, of_group) in groups.iter().zip(&mut of_groups) {
                let mut here: [&[f64]; LANES] = [&[]; LANES];
                for (here, y) in here.iter_mut().zip(y) {
                    *here = &y[start..start + group.count()];
                }
                start += group.count();
                group.sums(&here[..y.len()], usize::MAX, sums);
                set_short_digits(sums, of_group);
                transform.forward(of_group);
            }
            let of_groups = &of_groups[..groups.len()];
            let tables = tables.chunks_exact(LEN * groups.len());
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
        for block in values.chunks_exact_mut(LEN) {
            transform.backward(block);
            for value in block.iter_mut() {
                *value = field.canonical(*value);
            }
        }
        let mut q = [0.0; LANES];
        for (q, y) in q.iter_mut().zip(y) {
            *q = y[y.len() - 1];
        }
        put_together(&values, minus_p, q, target);
    }
}

/// The short digits of sums, which have no more than there is room for.
#[inline(always)]
fn set_short_digits(sums: &[Sums], digits: &mut [Quad; LEN]) {
    *digits = [[0.0; 4]; LEN];
    for (lane, sums) in sums.iter().enumerate() {
        let mut at = 0;
        sums.carried(|digit| {
            for digit in &short_digits(digit)[..3] {
                digits[at][lane] = *digit;
                at += 1;
            }
        });
    }
}

/// Digits of blocks, which overlap, and q times −P, as limbs.
#[inline(always)]
fn put_together(values: &[Quad], minus_p: &[f64], q: Quad, target: &mut [[u64; LANES]]) {
    let mut carry = [0; LANES];
    for ((k, limb), minus_p) in target
        .iter_mut()
        .enumerate()
        .zip(minus_p.as_chunks::<4>().0)
    {
        *limb = [0; LANES];
        for (d, minus_p) in minus_p.iter().enumerate() {
            let (block, at) = ((4 * k + d) / BLOCK_LEN, (4 * k + d) % BLOCK_LEN);
            let mut digit = values[block * LEN + at];
            if block > 0 && at < LEN - BLOCK_LEN {
                digit = plus(digit, values[(block - 1) * LEN + BLOCK_LEN + at]);
            }
            for lane in 0..LANES {
                let sum = u64_from(q[lane].mul_add(*minus_p, digit[lane])) + carry[lane];
                limb[lane] |= (sum & 0xFFFF) << (16 * d);
                carry[lane] = sum >> 16;
            }
        }
    }
}

/// The digits of 16 bits.
#[inline(always)]
fn short_digits(limb: u64) -> [f64; 4] {
    let digit = |shift: u32| f64_from(limb >> shift & 0xFFFF);
    [digit(0), digit(16), digit(32), digit(48)]
}

/// The transform and the values of the blocks of all P/P_G.
struct Tables<'a> {
    prime: &'a Quartet,
    others: Vec<Natural>,
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
                for other in others {
                    let digits = other.limbs().flat_map(short_digits);
                    let mut values = [[0.0; 4]; LEN];
                    for (value, digit) in values[..BLOCK_LEN]
                        .iter_mut()
                        .zip(digits.skip(block * BLOCK_LEN))
                    {
                        *value = [digit; 4];
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
