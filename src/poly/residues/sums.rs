//! Sums Σ y C of large numbers C with words y.

use malachite::Natural;

use crate::poly::limbs::LIMB_BITS;

/// Some numbers C, limb by limb.
pub(super) struct Columns {
    count: usize,
    /// Four limbs of all numbers, then the next four.
    limbs: Vec<[u64; 4]>,
}

impl Columns {
    /// The numbers modulo 2^(64 `width`).
    pub(super) fn new(numbers: &[Natural], width: usize) -> Self {
        let count = numbers.len();
        let mut limbs = vec![[0; 4]; width.div_ceil(4) * count];
        for (i, number) in numbers.iter().enumerate() {
            for (k, limb) in number.limbs().take(width).enumerate() {
                limbs[k / 4 * count + i][k % 4] = limb;
            }
        }
        Self { count, limbs }
    }

    /// How many numbers they are.
    #[inline(always)]
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// Σ y C, for as many y < 2^50 as there are numbers, less than 2^14, as far as the target has limbs.
    #[inline(always)]
    pub(super) fn sum(&self, y: &[u64], target: &mut [u64]) {
        let mut carry = 0_u128;
        for (limbs, columns) in target
            .chunks_mut(4)
            .zip(self.limbs.chunks_exact(self.count))
        {
            for (limb, sum) in limbs.iter_mut().zip(dot(y, columns)) {
                *limb = carried(&mut carry, sum);
            }
        }
    }
}

/// The next limb, where so much is carried and this is added; the rest is carried on.
#[inline(always)]
pub(super) fn carried(carry: &mut u128, sum: u128) -> u64 {
    let sum = sum + *carry;
    *carry = sum >> LIMB_BITS;
    #[expect(clippy::cast_possible_truncation, reason = "the low half is meant")]
    {
        sum as u64
    }
}

/// Σ y c for four c to each y.
#[inline(always)]
fn dot(y: &[u64], columns: &[[u64; 4]]) -> [u128; 4] {
    let [mut a, mut b, mut c, mut d] = [0_u128; 4];
    for (&y, column) in y.iter().zip(columns) {
        let times = |limb: u64| u128::from(y) * u128::from(limb);
        a += times(column[0]);
        b += times(column[1]);
        c += times(column[2]);
        d += times(column[3]);
    }
    [a, b, c, d]
}
