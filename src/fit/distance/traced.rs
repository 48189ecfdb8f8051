//! Polygons near closed curves that are given by Fourier series of their coordinates, with a proved bound of the difference.

use std::f64::consts::TAU;

use malachite::Integer;

use super::super::as_f64;
use super::fourier_transform;
use super::polygon::Frame;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::shape::EllipticSeries;

/// The largest number of vertices.
const MOST_VERTICES: usize = 1 << 22;

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

    /// The polygon of a number of vertices, which is a power of two and at least [`Self::first_count`]; `None` if it is too large.
    ///
    /// With x + iy = Σ c_k e^(ikt), c_n = (a + d + i (c − b))/2 and c_(−n) = (a − d + i (c + b))/2 for the coefficients a and b of
    /// cos nt and sin nt in x, and c and d of those in y.
    ///
    /// **Lemma.** Let h = 2π/M for M vertices, |C''| ≤ b. On each arc the curve is within b h²/8 of the point that divides the
    /// chord in the same ratio as the parameter, so the arc and the chord are within that of each other. Each coefficient is
    /// rounded by at most 2^(−53) of its size, and so are the sums in c_n and c_(−n): together, these are wrong by at most
    /// 2^(−51) S for the sum S of the sizes of all coefficients, and their sizes are at most S together. The values of the
    /// transform are wrong by at most (4 log2(M) + 1) 2^(−52) S more, and by 2^(−1022).
    pub(super) fn polygon(&self, vertices: usize, limits: &Limits) -> Result<Option<Traced>> {
        if vertices > MOST_VERTICES {
            return Ok(None);
        }
        let [a, b, c, d] = &self.lists;
        let mut points = vec![[0.0; 2]; vertices];
        points[0] = [a[0], c[0]];
        for n in 1..a.len() {
            points[n] = [a[n] + d[n], c[n] - b[n]].map(|c| c / 2.0);
            points[vertices - n] = [a[n] - d[n], c[n] + b[n]].map(|c| c / 2.0);
        }
        fourier_transform::values(&mut points, limits)?;
        let step = TAU / as_f64(vertices);
        let chord = self.bend * step * step / 8.0;
        let stages = f64::from(vertices.trailing_zeros());
        let rounding = (4.0 * stages + 3.0) * f64::EPSILON * self.size + f64::MIN_POSITIVE;
        Ok(Some(Traced {
            points,
            error: (chord + rounding) * (1.0 + 1e-9),
        }))
    }
}
