//! The cells of a grid that may hold zeros, found by an octree without the cubes that are proved empty.

use crate::error::Result;
use crate::intervals::{BoxProof, Field, largest};
use crate::limits::Limits;
use crate::parallel;

/// A grid of equal cubes.
pub(super) struct Grid {
    origin: [f64; 3],
    /// The side of a cell, which is a cube.
    pub(super) side: f64,
    /// The numbers of cells along each axis.
    counts: [u32; 3],
}

/// A cell that is not proved to be empty.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub(super) index: [u32; 3],
    /// Whether it is proved that the cell holds one sheet without singular points.
    pub(super) is_regular: bool,
}

/// The grid is moved from the corner of the box by these parts of a cell's side, because surfaces often touch points with round
/// coordinates.
const OFFSETS: [f64; 3] = [0.387, 0.206, 0.604];

/// A cell may be divided this often before it counts as one with a singular point, and all cells together this often, if the
/// expansion of the polynomial takes little work.
const PARTS_OF_A_CELL: usize = 600;
const PARTS_OF_ALL: usize = 100_000;
const LITTLE_WORK: usize = 600;
/// At a pinch point two sheets are nearer to each other than a cell up to a few cells beside the curve in which they cross.
const BESIDE: f64 = 4.0;

impl Grid {
    /// The grid that covers a box, with `resolution` cells along its longest side and one more cell on every side.
    pub(super) fn covering(bounds: &[[f64; 2]; 3], resolution: u32) -> Self {
        let longest = bounds.iter().fold(0.0, |l: f64, [a, b]| l.max(b - a));
        let side = longest / f64::from(resolution);
        let origin = std::array::from_fn(|i| bounds[i][0] - OFFSETS[i] * side);
        let counts = bounds.map(|[a, b]| {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "at most the resolution and two"
            )]
            let count = ((b - a) / side + 0.61).ceil() as u32;
            count.max(1)
        });
        Self {
            origin,
            side,
            counts,
        }
    }

    /// The grid point with these indices.
    pub(super) fn point(&self, index: [u32; 3]) -> [f64; 3] {
        std::array::from_fn(|i| self.origin[i] + self.side * f64::from(index[i]))
    }

    /// The cells that are not proved to be empty, in order. `done` is called with the number of finished parts, of 512.
    pub(super) fn cells(
        &self,
        field: &Field,
        limits: &Limits,
        done: &(dyn Fn() + Sync),
    ) -> Result<Vec<Cell>> {
        let most = self.counts.iter().fold(1, |m: u32, &c| m.max(c));
        let size = most.next_power_of_two().max(8);
        let block = size / 8;
        let blocks: Vec<[u32; 3]> = (0..512u32).map(|n| [n / 64, n / 8 % 8, n % 8]).collect();
        let found = parallel::try_map(&blocks, limits, |n| {
            let mut cells = Vec::new();
            self.visit(field, n.map(|k| k * block), block, limits, &mut cells)?;
            done();
            Ok(cells)
        });
        let mut cells: Vec<Cell> = found?.concat();
        cells.sort_unstable_by_key(|cell| cell.index);
        Ok(cells)
    }

    /// Whether a cell is beside one of the points: whether its middle is nearer than [`BESIDE`] cells along every axis.
    pub(super) fn is_beside(&self, cell: &Cell, points: &[[f64; 3]]) -> bool {
        let middle = self.point(cell.index).map(|x| x + self.side / 2.0);
        let reach = BESIDE * self.side;
        let is_near = |p: &[f64; 3]| p.iter().zip(middle).all(|(x, m)| (x - m).abs() < reach);
        points.iter().any(is_near)
    }

    /// The grid with each cell divided into this many along each axis.
    pub(super) fn divided(&self, parts: u32) -> Self {
        Self {
            origin: self.origin,
            side: self.side / f64::from(parts),
            counts: self.counts.map(|count| count * parts),
        }
    }

    /// The cells of this grid, which are not proved to be empty, in cells of the grid whose division into `parts` it is.
    pub(super) fn cells_within(
        &self,
        field: &Field,
        coarse: &[Cell],
        parts: u32,
        limits: &Limits,
    ) -> Result<Vec<Cell>> {
        let within = parallel::try_map(coarse, limits, |cell| {
            let mut cells = Vec::new();
            let first = cell.index.map(|k| k * parts);
            self.visit(field, first, parts, limits, &mut cells)?;
            Ok(cells)
        });
        Ok(within?.concat())
    }

    /// Whether it is proved that no cell has a singular point: each is divided into parts that are empty, or in which a component of
    /// the gradient is not 0. The result is `false` as soon as a cell is not resolved by little work.
    pub(super) fn is_smooth(&self, field: &Field, cells: &[Cell], limits: &Limits) -> Result<bool> {
        let mut left = PARTS_OF_ALL * LITTLE_WORK / field.work().max(LITTLE_WORK);
        for cell in cells.iter().filter(|cell| !cell.is_regular) {
            limits.check()?;
            let half = self.side / 2.0;
            let middle = self.point(cell.index).map(|x| x + half);
            let mut parts = vec![(middle, half.next_up())];
            let mut examined = 0;
            while let Some((middle, half)) = parts.pop() {
                let bounds = field.on_box(middle, [half; 3]);
                if bounds.is_empty() || (0..3).any(|axis| bounds.slope(axis).sign().is_some()) {
                    continue;
                }
                examined += 1;
                if examined > PARTS_OF_A_CELL.min(left) {
                    return Ok(false);
                }
                let quarter = half / 2.0;
                parts.extend((0..8u8).map(|bits| {
                    let part = std::array::from_fn(|i| {
                        let step = if bits >> i & 1 == 1 {
                            quarter
                        } else {
                            -quarter
                        };
                        middle[i] + step
                    });
                    // The middles are rounded, so the half sides are enlarged.
                    (
                        part,
                        quarter * (1.0 + 8.0 * f64::EPSILON) + 4.0 * f64::EPSILON * largest(&part),
                    )
                }));
            }
            left -= examined;
        }
        Ok(true)
    }

    fn visit(
        &self,
        field: &Field,
        first: [u32; 3],
        size: u32,
        limits: &Limits,
        cells: &mut Vec<Cell>,
    ) -> Result<()> {
        if first.iter().zip(self.counts).any(|(&k, count)| k >= count) {
            return Ok(());
        }
        let half = self.side * f64::from(size) / 2.0;
        let middle = self.point(first).map(|x| x + half);
        let verdict = field.on_box(middle, [half; 3]).verdict();
        if verdict == BoxProof::Empty {
            return Ok(());
        }
        if size == 1 {
            cells.push(Cell {
                index: first,
                is_regular: verdict == BoxProof::Regular,
            });
            return Ok(());
        }
        limits.check()?;
        let step = size / 2;
        for corner in 0..8u32 {
            let [i, j, k] = first;
            let next = [
                i + (corner & 1) * step,
                j + (corner >> 1 & 1) * step,
                k + (corner >> 2) * step,
            ];
            self.visit(field, next, step, limits, cells)?;
        }
        Ok(())
    }
}
