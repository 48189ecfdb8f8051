//! The sums of long Chinese remainders by transforms: primes in groups, the rest of their product in blocks.

use malachite::Natural;
use malachite::base::num::arithmetic::traits::DivExact;
use pulp::{Arch, NullaryFnOnce};

use super::quad::{Quad, QuadField, f64_from, u64_from};
use super::quartet::Quartet;
use super::sums::{Columns, carried};
use super::transform::Transform;

/// Quartets in a group: Σ y P_G/p over their 28 primes is below 28 P_G.
const GROUP: usize = 7;
/// Limbs of such a sum, which has at most 1405 bits.
const GROUP_LIMBS: usize = 22;
/// Limbs of a block.
const BLOCK_LIMBS: usize = 26;
/// Digits of 16 bits of a block.
const BLOCK: usize = 4 * BLOCK_LIMBS;
/// The length of transforms: the product of a group's sum and a block has 4 · 22 + 4 · 26 − 1 digits, which are sums of at
/// most 88 products below 2^32; and all groups together, which are less than 2^10, stay below 2^49.
const LEN: usize = 192;

/// `Σ y P/p` over all primes is `Σ (P/P_G) Σ y P_G/p` over groups G of primes: the inner sums are formed as they stand, the
/// outer products as products of values at roots of unity, of which those of P/P_G are known and only the sum over all
/// groups is transformed back, once for each block. Four sums at once, modulo one prime.
///
/// Cost: for n primes n words times a group's length, n/28 + n/33 transforms and (n/30)² products of `LEN` values.
pub(super) struct Blocks {
    field: QuadField,
    transform: Transform,
    /// For each group P_G/p.
    groups: Vec<Columns>,
    /// For each group, block after block, the values of P/P_G, divided by `LEN`, of at most p/2.
    tables: Vec<f64>,
    /// How many blocks a sum has.
    blocks: usize,
}

impl Blocks {
    /// For the primes of these quartets, whose product this is, and sums of at most `width` limbs.
    pub(super) fn new(quartets: &[Quartet], product: &Natural, width: usize) -> Self {
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
        let blocks = width.div_ceil(BLOCK_LIMBS);
        let others: Vec<Natural> = products
            .iter()
            .map(|group| product.div_exact(group))
            .collect();
        let (transform, tables) = Arch::new().dispatch(Tables {
            prime: &one,
            others,
            blocks,
        });
        let columns = |(primes, product): (&Vec<Natural>, &Natural)| {
            let numbers: Vec<Natural> = primes.iter().map(|p| product.div_exact(p)).collect();
            Columns::new(&numbers, GROUP_LIMBS)
        };
        Self {
            field: one.field,
            transform,
            groups: groups.iter().zip(&products).map(columns).collect(),
            tables,
            blocks,
        }
    }

    /// Σ y P/p − qP into each of at most four targets of `width` limbs; y, then q, for one target after the other; −P is
    /// given in two's complement.
    #[inline(always)]
    pub(super) fn sum(&self, y: &[u64], minus_p: &[u64], targets: &mut [u64], width: usize) {
        /// So many products of at most 17/16 p, and p/2, are below 2^53.
        const UNREDUCED: usize = 6;
        let Self {
            field,
            transform,
            groups,
            tables,
            blocks,
        } = self;
        let across = groups.iter().map(Columns::count).sum::<usize>() + 1;
        let mut sums: Vec<Quad> = vec![[0.0; 4]; blocks * LEN];
        for ((g, group), table) in groups
            .iter()
            .enumerate()
            .zip(tables.chunks_exact(blocks * LEN))
        {
            let mut values = [[0.0; 4]; LEN];
            for (lane, y) in y.chunks_exact(across).enumerate() {
                let mut limbs = [0; GROUP_LIMBS];
                group.sum(&y[4 * GROUP * g..][..group.count()], &mut limbs);
                for (places, limb) in values.as_chunks_mut::<4>().0.iter_mut().zip(limbs) {
                    for (place, digit) in places.iter_mut().zip(digits(limb)) {
                        place[lane] = digit;
                    }
                }
            }
            transform.forward(&mut values);
            for (sums, table) in sums.chunks_exact_mut(LEN).zip(table.chunks_exact(LEN)) {
                field.add_products(sums, &values, table);
            }
            if g % UNREDUCED == UNREDUCED - 1 {
                for sum in &mut sums {
                    *sum = field.reduced(*sum);
                }
            }
        }
        for block in sums.chunks_exact_mut(LEN) {
            for sum in block.iter_mut() {
                *sum = field.reduced(*sum);
            }
            transform.backward(block);
            for sum in block.iter_mut() {
                *sum = field.canonical(*sum);
            }
        }
        let targets = targets.chunks_exact_mut(width);
        for ((lane, target), y) in targets.enumerate().zip(y.chunks_exact(across)) {
            put_together(&sums, lane, y[across - 1], minus_p, target);
        }
    }
}

/// The digits of 16 bits.
#[inline(always)]
fn digits(limb: u64) -> [f64; 4] {
    [0, 16, 32, 48].map(|shift| f64_from(limb >> shift & 0xFFFF))
}

/// Digits of blocks, which overlap, and q times −P, as limbs.
#[inline(always)]
fn put_together(sums: &[Quad], lane: usize, q: u64, minus_p: &[u64], target: &mut [u64]) {
    let mut carry = 0_u128;
    for (k, (limb, minus_p)) in target.iter_mut().zip(minus_p).enumerate() {
        let (block, at) = (k / BLOCK_LIMBS, 4 * (k % BLOCK_LIMBS));
        let here = &sums[block * LEN..][..LEN];
        let mut sum = u128::from(q) * u128::from(*minus_p);
        for d in 0..4 {
            let mut digit = u64_from(here[at + d][lane]);
            if block > 0 && BLOCK + at + d < LEN {
                digit += u64_from(sums[(block - 1) * LEN + BLOCK + at + d][lane]);
            }
            sum += u128::from(digit) << (16 * d);
        }
        *limb = carried(&mut carry, sum);
    }
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
        let scale = field.factor(field.inverse_of_divisor(f64_from(LEN as u64)));
        let mut tables = Vec::with_capacity(self.others.len() * self.blocks * LEN);
        for other in &self.others {
            let mut limbs = other.to_limbs_asc();
            limbs.resize(self.blocks * BLOCK_LIMBS, 0);
            for block in limbs.chunks_exact(BLOCK_LIMBS) {
                let mut values = [[0.0; 4]; LEN];
                for (places, limb) in values.as_chunks_mut::<4>().0.iter_mut().zip(block) {
                    *places = digits(*limb).map(|digit| [digit; 4]);
                }
                transform.forward(&mut values);
                for value in values {
                    tables.push(field.reduced(field.times_factor(value, scale))[0]);
                }
            }
        }
        (transform, tables)
    }
}
