//! Polygons near closed curves that are given by Fourier series of their coordinates, with a proved bound of the difference.

use std::f64::consts::TAU;

use malachite::Integer;

use super::super::as_f64;
use super::super::turns::Turns;
use super::polygon::Frame;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::parallel;
use crate::roots::{UnitBall, rotations};
use crate::shape::EllipticSeries;

/// The largest number of vertices.
const MOST_VERTICES: usize = 1 << 22;
/// The largest number of terms that are summed for all vertices together.
const MOST_TERMS: usize = 1 << 33;

/// A polygon with vertices near a curve. Every point of the curve is within `error` of the polygon, and every point of the
/// polygon is within `error` of the curve.
#[derive(Debug)]
pub(super) struct Traced {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) error: f64,
}

/// A curve in the coordinates of a frame.
#[derive(Debug)]
pub(super) struct Tracer {
    lists: [Vec<f64>; 4],
    /// Σ of the sizes of all coefficients.
    size: f64,
    /// A bound of the size of the second derivative.
    bend: f64,
}

impl Tracer {
    pub(super) fn new(curve: &EllipticSeries, frame: &Frame) -> Self {
        let unit = Rational::from_dyadic(Integer::from(1), -frame.exponent());
        let middle = frame
            .middle
            .map(|c| Rational::try_from(c).invariant("the middle of an outline is finite"));
        let zero = Rational::zero();
        let from = [&middle[0], &zero, &middle[1], &zero];
        let mut lists: [Vec<f64>; 4] = Default::default();
        for ((list, exact), from) in lists.iter_mut().zip(curve.lists()).zip(from) {
            let first = exact.first().map(|c| c - from);
            let all = first.into_iter().chain(exact.iter().skip(1).cloned());
            *list = all.map(|c| (c * &unit).to_f64()).collect();
        }
        let size = lists.iter().flatten().map(|c| c.abs()).sum();
        let bend = (0..lists[0].len()).map(|n| {
            let square: f64 = lists.iter().map(|list| list[n] * list[n]).sum();
            as_f64(n) * as_f64(n) * square.sqrt()
        });
        // Less than 2^20 roundings one after another.
        let bend = bend.sum::<f64>() * (1.0 + 1e-9);
        Self { lists, size, bend }
    }

    /// A bound of the size of the coordinates.
    pub(super) fn size(&self) -> f64 {
        self.size
    }

    /// A number of vertices to begin with.
    pub(super) fn first_count(&self) -> usize {
        (8 * self.lists[0].len()).next_power_of_two().max(256)
    }

    /// A number of vertices with which the error is probably small enough; `error` is that of `vertices`.
    pub(super) fn enough_count(&self, vertices: usize, error: f64, wanted: f64) -> usize {
        let mut next = 2 * vertices;
        let mut error = error / 4.0;
        while error > wanted / 2.0 && next < MOST_VERTICES {
            next *= 2;
            error /= 4.0;
        }
        next
    }

    /// The polygon of a number of vertices, which is a power of two; `None` if that costs more than is allowed.
    ///
    /// **Lemma.** Let h = 2π/M for M vertices, |C''| ≤ b. On each arc the curve is within b h²/8 of the point that divides the
    /// chord in the same ratio as the parameter, so the arc and the chord are within that of each other. The vertices are sums of
    /// 2N + 2 products in doubles: each factor cos or sin is wrong by at most 2^(−52), each coefficient by half an ulp, or
    /// 2^(−1074), each product and each sum by half an ulp of at most the sum S of the coefficients' sizes. Together they are
    /// wrong by less than (2N + 6) 2^(−52) S in each coordinate.
    pub(super) fn polygon(&self, vertices: usize, limits: &Limits) -> Result<Option<Traced>> {
        let harmonics = self.lists[0].len();
        if vertices > MOST_VERTICES || vertices.saturating_mul(harmonics) > MOST_TERMS {
            return Ok(None);
        }
        let table = quarter_waves(vertices);
        let quarter = vertices / 4;
        // Divisions by powers of two are shifts.
        let bits = quarter.trailing_zeros();
        let all = vertices - 1;
        // cos 2πk/M, from the first quarter.
        let cosine = |k: usize| {
            let rest = k & (quarter - 1);
            match k >> bits {
                0 => table[rest][0],
                1 => -table[rest][1],
                2 => -table[rest][0],
                _ => table[rest][1],
            }
        };
        let points = parallel::try_map_numbers(vertices, limits, |j| {
            let (mut x, mut y, mut k) = (0.0, 0.0, 0);
            let [a, b, c, d] = &self.lists;
            for n in 0..harmonics {
                let (cos, sin) = (cosine(k), cosine((k + 3 * quarter) & all));
                x += a[n] * cos + b[n] * sin;
                y += c[n] * cos + d[n] * sin;
                k = (k + j) & all;
            }
            Ok([x, y])
        })?;
        let step = TAU / as_f64(vertices);
        let chord = self.bend * step * step / 8.0;
        let rounding = as_f64(2 * harmonics + 6) * f64::EPSILON * self.size * 2.0;
        Ok(Some(Traced {
            points,
            error: (chord + rounding) * (1.0 + 1e-9),
        }))
    }
}

/// cos 2πk/M and sin 2πk/M for 0 ≤ k < M/4, each within 2^(−52).
fn quarter_waves(vertices: usize) -> Vec<[f64; 2]> {
    let turn = UnitBall::<2>::quotient(&Integer::from(1), &Integer::from(vertices));
    let [cosines, sines] = rotations(Turns::new().at(turn, 0), vertices / 4 - 1);
    cosines
        .iter()
        .zip(&sines)
        .map(|(c, s)| [c.to_f64(), s.to_f64()])
        .collect()
}
