//! The cover of a cube by cells, each of which is left out or has its zeros excluded: the rule of theorems T5 and T6.

use num_bigint::{BigInt, BigUint};

use super::clock;
use super::json::{Claim, Fields};
use super::numbers::power_of_two;
use super::one_sign::sign_on_cube;
use super::refusal::{Checked, Refusal, need};
use super::sparse::Sparse;
use super::univariate::{Coefficients, shift, shrink};

/// The largest number of halvings one after another.
const DEEPEST: u32 = 200;
/// The largest number of cells or arcs of one cover.
const MOST_CELLS: usize = 100_000;
/// The largest number of coefficients of a polynomial on a cube: the product of the degrees plus 1.
const MOST_COEFFICIENTS: usize = 300_000;

/// Counts the cells of a cover, and refuses when there are too many or they are too deep.
#[derive(Debug)]
pub(super) struct Budget {
    depth: u32,
    cells: usize,
}

impl Budget {
    /// Reads the witness `{"depth": n}`.
    pub(super) fn read(claim: &Claim<'_>) -> Checked<Self> {
        Self::of(&claim.witness(&["depth"], &[])?)
    }

    /// Reads the field `depth` of a witness.
    pub(super) fn of(witness: &Fields<'_>) -> Checked<Self> {
        let depth = witness.get("depth", |value| value.count(DEEPEST))?;
        Ok(Self { depth, cells: 0 })
    }

    pub(super) fn enter_cell(&mut self) -> Checked<()> {
        self.cells += 1;
        clock::need_time()?;
        need(
            self.cells <= MOST_CELLS,
            "the cover has more than 100 000 cells",
        )
    }

    /// Asked before an undecided cell of this level is halved.
    pub(super) fn may_halve(&self, level: u32) -> Checked<()> {
        need(level < self.depth, "a cell of the cover is undecided")
    }
}

/// A polynomial on [−1, 1]^n with all coefficients up to a degree in each variable; the last variable's exponent varies fastest.
#[derive(Clone, Debug)]
pub(super) struct Dense {
    coefficients: Coefficients,
    lengths: Vec<usize>,
}

impl Dense {
    /// Refuses a polynomial that is too large for a cover.
    pub(super) fn need_small(f: &Sparse, dimension: usize) -> Checked<()> {
        let sizes = (0..dimension).map(|axis| f.degree_in(axis).max(2) as usize + 1);
        need(
            sizes.product::<usize>() <= MOST_COEFFICIENTS,
            "a polynomial on a cube has more than 300 000 coefficients",
        )
    }

    /// The polynomial with formal degrees one less than the lengths, which are at least the degrees.
    pub(super) fn new(f: &Sparse, lengths: &[usize]) -> Checked<Self> {
        let size = lengths
            .iter()
            .try_fold(1_usize, |size, length| size.checked_mul(*length));
        let size = size
            .filter(|size| *size <= MOST_COEFFICIENTS)
            .ok_or_else(|| {
                Refusal::new("a polynomial on a cube has more than 300 000 coefficients")
            })?;
        let mut coefficients = vec![BigInt::ZERO; size];
        for (exponents, c) in f.terms() {
            let index = lengths
                .iter()
                .zip(exponents)
                .fold(0, |index, (length, exponent)| {
                    index * length + *exponent as usize
                });
            coefficients[index].clone_from(c);
        }
        Ok(Self {
            coefficients,
            lengths: lengths.to_vec(),
        })
    }

    /// The polynomial on the half of the cube in which the sign of the variable is given, moved to the cube, times a power of 2
    /// that depends only on the formal degree: the variable v becomes (sign + v)/2.
    fn half(&self, axis: usize, sign: i64) -> Self {
        let mut result = self.clone();
        let (length, two, side) = (self.lengths[axis], BigInt::from(2), BigInt::from(sign));
        let stride: usize = self.lengths[axis + 1..].iter().product();
        for block in result.coefficients.chunks_mut(length * stride) {
            for offset in 0..stride {
                let mut line: Vec<_> = block[offset..]
                    .iter_mut()
                    .step_by(stride)
                    .map(std::mem::take)
                    .collect();
                shrink(&mut line, &two);
                shift(&mut line, &side);
                for (slot, c) in block[offset..].iter_mut().step_by(stride).zip(line) {
                    *slot = c;
                }
            }
        }
        result
    }

    /// The sign on the whole cube; 0 if the coefficients do not show it.
    pub(super) fn sign(&self) -> i64 {
        let lengths = &self.lengths;
        sign_on_cube(self.coefficients.iter().enumerate().map(|(mut index, c)| {
            let mut exponents = [0; 3];
            for (exponent, length) in exponents.iter_mut().zip(lengths).rev() {
                *exponent = index % length;
                index /= length;
            }
            (exponents, c)
        }))
    }

    /// The absolute value of the constant coefficient, and the sum of those of all others.
    pub(super) fn constant_and_rest(&self) -> (BigInt, BigInt) {
        let mut magnitudes = self.coefficients.iter().map(BigInt::magnitude);
        let constant = magnitudes.next().cloned().unwrap_or_default();
        let mut rest = BigUint::ZERO;
        for magnitude in magnitudes {
            rest += magnitude;
        }
        (constant.into(), rest.into())
    }
}

/// A cell: polynomials of equal formal degrees, restricted to it with the same positive factor and moved to [−1, 1]^n, and its
/// center in units of 2^−level, which is half of its side.
#[derive(Debug)]
pub(super) struct Cell {
    pub(super) polynomials: Vec<Dense>,
    center: Vec<BigInt>,
    level: u32,
}

impl Cell {
    pub(super) fn whole_cube(polynomials: Vec<Dense>, dimension: usize) -> Self {
        Self {
            polynomials,
            center: vec![BigInt::ZERO; dimension],
            level: 0,
        }
    }

    /// The square of the smallest distance of a point of the cell from the center of the cube, times [`Self::unit`].
    pub(super) fn nearest_square(&self) -> BigInt {
        self.center
            .iter()
            .filter(|c| **c != BigInt::ZERO)
            .map(|c| BigInt::from(c.magnitude() - 1_u32).pow(2))
            .sum()
    }

    /// The square of the largest distance of a point of the cell from the center of the cube, times [`Self::unit`].
    pub(super) fn farthest_square(&self) -> BigInt {
        self.center
            .iter()
            .map(|c| BigInt::from(c.magnitude() + 1_u32).pow(2))
            .sum()
    }

    /// 4^level.
    pub(super) fn unit(&self) -> BigInt {
        power_of_two(2 * self.level)
    }

    /// Whether the rule decides all cells, after as many divisions as the budget allows.
    pub(super) fn cover(
        &self,
        budget: &mut Budget,
        is_decided: &impl Fn(&Self) -> bool,
    ) -> Checked<()> {
        budget.enter_cell()?;
        if is_decided(self) {
            return Ok(());
        }
        budget.may_halve(self.level)?;
        self.cover_halves(0, budget, is_decided)
    }

    /// Covers the parts of a cell that has been halved along the axes before this one.
    fn cover_halves(
        &self,
        axis: usize,
        budget: &mut Budget,
        is_decided: &impl Fn(&Self) -> bool,
    ) -> Checked<()> {
        for sign in [-1, 1] {
            let mut center = self.center.clone();
            center[axis] = &center[axis] * 2 + sign;
            let polynomials = self
                .polynomials
                .iter()
                .map(|f| f.half(axis, sign))
                .collect();
            let last = axis + 1 == center.len();
            let part = Self {
                polynomials,
                center,
                level: self.level + u32::from(last),
            };
            if last {
                part.cover(budget, is_decided)?;
            } else {
                part.cover_halves(axis + 1, budget, is_decided)?;
            }
        }
        Ok(())
    }
}
