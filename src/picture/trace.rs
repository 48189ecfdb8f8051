//! Traces the zero set of a plane polynomial in a window by its exact crossings with a grid.
//!
//! At degree 80, f cannot be evaluated in doubles, because the monomials cancel. So f is restricted exactly to every line of a
//! grid, and its real roots there are isolated exactly and then rounded. Only the decision how neighbouring crossings inside a
//! cell are joined is for drawing. Cells with more than two crossings are divided, and so are cells into which the curve turns.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet, HashMap};

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use crate::error::Result;
use crate::exact::Dyadic;
use crate::limits::Limits;
use crate::parallel;
use crate::poly::{IntegerPolynomial, PlanePolynomial, numerator_at};
use crate::roots::real_roots;

/// An ambiguous cell is halved at most this often; then its crossings are joined in its middle.
const HALVINGS: u32 = 3;

/// The precision of crossings, as a power of two of a cell.
const CROSSING_BITS: i64 = 12;

/// A rectangle of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// The smallest and the largest x.
    pub x: [f64; 2],
    /// The smallest and the largest y.
    pub y: [f64; 2],
}

impl Window {
    /// The smallest window around points; `None` without points.
    #[must_use]
    pub fn around(points: impl IntoIterator<Item = [f64; 2]>) -> Option<Self> {
        points
            .into_iter()
            .fold(None, |window: Option<Self>, [x, y]| {
                let w = window.unwrap_or(Self {
                    x: [x, x],
                    y: [y, y],
                });
                Some(Self {
                    x: [w.x[0].min(x), w.x[1].max(x)],
                    y: [w.y[0].min(y), w.y[1].max(y)],
                })
            })
    }

    /// The length of the larger side.
    #[must_use]
    pub fn size(&self) -> f64 {
        (self.x[1] - self.x[0]).max(self.y[1] - self.y[0])
    }

    /// The window with a margin on all sides, which is `margin` times the larger side.
    #[must_use]
    pub fn padded(&self, margin: f64) -> Self {
        let add = self.size().max(f64::MIN_POSITIVE) * margin;
        Self {
            x: [self.x[0] - add, self.x[1] + add],
            y: [self.y[0] - add, self.y[1] + add],
        }
    }
}

type Point = [f64; 2];

/// Polylines along `f = 0` within the window, from a grid of about `cells` cells along the larger side. Every vertex is a
/// crossing of the curve with a grid line, with an error of at most 1/4096 of a cell. An oval inside a single cell is not
/// found.
///
/// Cost: the real roots of 2·`cells` univariate polynomials of the degree of f.
///
/// # Errors
/// [`crate::error::Error::Limit`] or `Interrupted` when the limits are reached.
pub(crate) fn trace_zero_set(
    f: &PlanePolynomial,
    window: &Window,
    cells: u32,
    limits: &Limits,
) -> Result<Vec<Vec<Point>>> {
    let grid = Grid::new(window, cells);
    let restrict = Restriction::new(f);
    let mut lines: BTreeMap<Line, Vec<f64>> = BTreeMap::new();
    let step = 1 << HALVINGS;
    let mut pending: Vec<Cell> = Vec::new();
    for i in 0..grid.columns {
        for j in 0..grid.rows {
            pending.push(Cell {
                i: i * step,
                j: j * step,
                size: step,
            });
        }
    }
    let mut segments: Vec<[Point; 2]> = Vec::new();
    while !pending.is_empty() {
        let needed: BTreeSet<Line> = pending.iter().flat_map(Cell::lines).collect();
        let missing: Vec<Line> = needed
            .into_iter()
            .filter(|l| !lines.contains_key(l))
            .collect();
        let computed =
            parallel::try_map(
                &missing,
                limits,
                |&line| Ok(restrict.crossings(&grid, line)),
            )?;
        lines.extend(missing.into_iter().zip(computed));
        let mut divided = Vec::new();
        for cell in pending {
            let crossings = cell.crossings(&grid, &lines);
            match crossings[..] {
                [] => {}
                // A curve that enters and leaves through one edge turns inside the cell; there may be a sharp tip.
                [(one, a), (other, b)] if one != other || cell.size == 1 => segments.push([a, b]),
                _ if cell.size > 1 => divided.extend(cell.quarters()),
                _ => {
                    let middle = mean(&crossings);
                    segments.extend(crossings.iter().map(|&(_, p)| [p, middle]));
                }
            }
        }
        pending = divided;
    }
    Ok(chain(&segments))
}

/// Whether the origin is an isolated real point of `f = 0`, because the lowest homogeneous part has no real zero.
#[must_use]
pub(crate) fn isolated_origin(f: &PlanePolynomial) -> bool {
    let Some(lowest) = f.parts().last() else {
        return false;
    };
    let full_degree = lowest.dehomogenized().coefficients_asc().len() == lowest.degree() + 1;
    lowest.degree() > 0 && full_degree && real_roots(lowest.dehomogenized()).is_empty()
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Line {
    /// The line y = row.
    Horizontal(u32),
    /// The line x = column.
    Vertical(u32),
}

/// A grid of equal square cells whose corners are doubles of few bits. The unit of indices is the finest division.
struct Grid {
    corner: [f64; 2],
    unit: f64,
    columns: u32,
    rows: u32,
}

impl Grid {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "cell counts are small and positive"
    )]
    fn new(window: &Window, cells: u32) -> Self {
        // The unit is an odd number near the wished size times a power of two. So coordinates are short, and grid lines rarely
        // meet special points of the curve.
        let wished = window.size() / f64::from(cells.max(1));
        let scale = wished.log2().floor().exp2() / 64.0;
        let cell = (wished / scale / 2.0).floor() * 2.0 * scale + scale;
        let unit = cell / f64::from(1u32 << HALVINGS);
        let below = |v: f64, shift: f64| ((v / cell).floor() - 0.5) * cell + unit * shift;
        // The two shifts are different, so that a diagonal through the origin meets no corner.
        let corner = [below(window.x[0], 0.40625), below(window.y[0], 0.71875)];
        let count = |low: f64, high: f64| ((high - low) / cell).ceil().clamp(1.0, 1e6) as u32;
        Self {
            corner,
            unit,
            columns: count(corner[0], window.x[1]),
            rows: count(corner[1], window.y[1]),
        }
    }

    fn x(&self, column: u32) -> f64 {
        self.corner[0] + f64::from(column) * self.unit
    }

    fn y(&self, row: u32) -> f64 {
        self.corner[1] + f64::from(row) * self.unit
    }
}

#[derive(Clone, Copy)]
struct Cell {
    i: u32,
    j: u32,
    size: u32,
}

impl Cell {
    fn lines(&self) -> [Line; 4] {
        [
            Line::Horizontal(self.j),
            Line::Horizontal(self.j + self.size),
            Line::Vertical(self.i),
            Line::Vertical(self.i + self.size),
        ]
    }

    fn quarters(self) -> [Self; 4] {
        let size = self.size / 2;
        [(0, 0), (size, 0), (0, size), (size, size)].map(|(a, b)| Self {
            i: self.i + a,
            j: self.j + b,
            size,
        })
    }

    /// The crossings of the curve with the four edges of the cell, each with its edge.
    fn crossings(&self, grid: &Grid, lines: &BTreeMap<Line, Vec<f64>>) -> Vec<(Line, Point)> {
        let mut points = Vec::new();
        for line in self.lines() {
            let (low, high) = match line {
                Line::Horizontal(_) => (grid.x(self.i), grid.x(self.i + self.size)),
                Line::Vertical(_) => (grid.y(self.j), grid.y(self.j + self.size)),
            };
            let roots = &lines[&line];
            let from = roots.partition_point(|&v| v < low);
            let to = roots.partition_point(|&v| v < high);
            points.extend(roots[from..to].iter().map(|&v| match line {
                Line::Horizontal(row) => (line, [v, grid.y(row)]),
                Line::Vertical(column) => (line, [grid.x(column), v]),
            }));
        }
        points
    }
}

/// The polynomial f as a list of polynomials in y (for the powers of x), and as a list of polynomials in x (for the powers of
/// y).
struct Restriction {
    by_x: Vec<IntegerPolynomial>,
    by_y: Vec<IntegerPolynomial>,
    degree: usize,
}

impl Restriction {
    fn new(f: &PlanePolynomial) -> Self {
        // The table of the polynomial 0 has one entry, which is 0.
        let degree = f.degree().unwrap_or(0);
        let mut table = vec![vec![Integer::ZERO; degree + 1]; degree + 1];
        for part in f.parts() {
            for (j, c) in part.terms() {
                table[part.degree() - j][j] = c.clone();
            }
        }
        let transposed = (0..=degree)
            .map(|j| table.iter().map(|row| row[j].clone()).collect())
            .map(IntegerPolynomial::from_coefficients_asc)
            .collect();
        Self {
            by_y: transposed,
            by_x: table
                .into_iter()
                .map(IntegerPolynomial::from_coefficients_asc)
                .collect(),
            degree,
        }
    }

    /// The real roots of f on a line, rounded, ascending.
    #[expect(clippy::cast_possible_truncation, reason = "a binary exponent")]
    fn crossings(&self, grid: &Grid, line: Line) -> Vec<f64> {
        let (rows, at) = match line {
            Line::Horizontal(row) => (&self.by_x, grid.y(row)),
            Line::Vertical(column) => (&self.by_y, grid.x(column)),
        };
        let Some(point) = Dyadic::from_f64(at) else {
            return Vec::new();
        };
        // Each value is an integer over 2^(e · degree of the row). All values are brought to one power of two.
        let e = point.exponent().min(0).unsigned_abs();
        let coefficients = rows
            .iter()
            .map(|row| {
                let degree = row.coefficients_asc().len().saturating_sub(1);
                numerator_at(row, &point) << (e * (self.degree - degree) as u64)
            })
            .collect();
        let width = grid.unit.log2().floor() as i64 + i64::from(HALVINGS) - CROSSING_BITS;
        let restricted = IntegerPolynomial::from_coefficients_asc(coefficients);
        let corners = match line {
            Line::Horizontal(_) => grid.corner[0],
            Line::Vertical(_) => grid.corner[1],
        };
        let roots = real_roots(&restricted).into_iter().map(|mut root| {
            root.refine_to_width(width);
            let (low, high) = root.enclosure();
            let value = low.midpoint(high).to_f64();
            // Near a corner of the grid, exact comparisons decide to which cell the crossing belongs, so that the lines through
            // the corner agree.
            let corner = corners + ((value - corners) / grid.unit).round() * grid.unit;
            match Dyadic::from_f64(corner).map(|c| root.cmp_dyadic(&c)) {
                Some(Ordering::Less) => value.min(corner.next_down()),
                Some(_) => value.max(corner),
                None => value,
            }
        });
        roots.collect()
    }
}

fn mean(crossings: &[(Line, Point)]) -> Point {
    let weight = 1.0 / crossings.iter().map(|_| 1.0).sum::<f64>();
    let sum = |k: usize| crossings.iter().map(|(_, p)| p[k]).sum::<f64>() * weight;
    [sum(0), sum(1)]
}

/// Joins segments with common ends into polylines; closed ones end where they begin.
fn chain(segments: &[[Point; 2]]) -> Vec<Vec<Point>> {
    let mut ends: HashMap<Key, Vec<usize>> = HashMap::new();
    for (index, segment) in segments.iter().enumerate() {
        for point in segment {
            ends.entry(key(*point)).or_default().push(index);
        }
    }
    let mut used = vec![false; segments.len()];
    let mut lines = Vec::new();
    // Open polylines are followed first, from their ends; the segments that are left form closed ones.
    for from_ends in [true, false] {
        for index in 0..segments.len() {
            for start in segments[index] {
                if !used[index] && (!from_ends || ends[&key(start)].len() != 2) {
                    lines.push(follow(segments, &ends, &mut used, index, start));
                }
            }
        }
    }
    lines
}

type Key = [u64; 2];

fn key(point: Point) -> Key {
    point.map(f64::to_bits)
}

/// The polyline that starts at one end of a segment and continues until it ends, forks or closes.
fn follow(
    segments: &[[Point; 2]],
    ends: &HashMap<Key, Vec<usize>>,
    used: &mut [bool],
    first: usize,
    start: Point,
) -> Vec<Point> {
    let mut line = vec![start];
    let (mut segment, mut at) = (first, start);
    loop {
        used[segment] = true;
        let [a, b] = segments[segment];
        at = if key(a) == key(at) { b } else { a };
        line.push(at);
        let here = &ends[&key(at)];
        match here.iter().find(|&&next| !used[next]) {
            Some(&next) if here.len() == 2 => segment = next,
            _ => return line,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;

    fn curve(terms: &[(usize, usize, i64)]) -> PlanePolynomial {
        PlanePolynomial::from_terms(terms.iter().map(|&(i, j, c)| ((i, j), Rational::from(c))))
    }

    fn trace(f: &PlanePolynomial) -> Vec<Vec<Point>> {
        let window = Window {
            x: [-2.0, 2.0],
            y: [-2.0, 2.0],
        };
        trace_zero_set(f, &window, 64, &Limits::none()).unwrap()
    }

    #[test]
    fn a_circle_is_one_closed_line_through_points_of_the_circle() {
        let lines = trace(&curve(&[(2, 0, 1), (0, 2, 1), (0, 0, -1)]));
        assert_eq!(lines.len(), 1);
        let line = &lines[0];
        assert_eq!(key(line[0]), key(line[line.len() - 1]));
        assert!(line.len() > 100);
        for [x, y] in line {
            assert!((x.hypot(*y) - 1.0).abs() < 1e-4, "{x} {y}");
        }
    }

    #[test]
    fn the_tip_of_a_cusp_is_not_cut() {
        // y^2 = (1 - x)^3 ends in the cusp (1, 0).
        let cusp = curve(&[(0, 2, -1), (0, 0, 1), (1, 0, -3), (2, 0, 3), (3, 0, -1)]);
        let lines = trace(&cusp);
        let tip = lines.iter().flatten().map(|p| p[0]);
        let tip = tip.fold(f64::NEG_INFINITY, f64::max);
        let cell = 4.0 / 64.0;
        assert!((1.0 - cell / 6.0..1.0 + 1e-4).contains(&tip), "{tip}");
    }

    #[test]
    fn a_square_and_its_root_have_the_same_picture() {
        let g = curve(&[(4, 0, 1), (2, 0, -1), (0, 2, 1)]);
        let (once, twice) = (trace(&g), trace(&(&g * &g)));
        let lengths = |lines: &[Vec<Point>]| lines.iter().map(Vec::len).collect::<Vec<_>>();
        assert_eq!(lengths(&once), lengths(&twice));
        for ([x, y], [u, v]) in once.iter().flatten().zip(twice.iter().flatten()) {
            assert!((x - u).hypot(y - v) < 1e-5, "({x}, {y}) ({u}, {v})");
        }
    }

    #[test]
    fn isolated_origins() {
        assert!(isolated_origin(&curve(&[(4, 0, 1), (2, 0, 1), (0, 2, 1)])));
        assert!(!isolated_origin(&curve(&[
            (4, 0, 1),
            (2, 0, -1),
            (0, 2, 1)
        ])));
        assert!(!isolated_origin(&curve(&[
            (2, 0, 1),
            (0, 2, 1),
            (0, 0, -1)
        ])));
        assert!(!isolated_origin(&curve(&[(4, 0, 1), (1, 1, 1), (0, 2, 1)])));
    }
}
