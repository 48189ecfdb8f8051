//! Winding numbers of curves that are given by Fourier series, by polygons near them.

use std::cmp::Ordering;

use super::polygon::Frame;
use super::traced::{Traced, Tracer};
use crate::error::Result;
use crate::limits::Limits;
use crate::shape::{EllipticSeries, orientation};

/// The polygon is within this part of the curve's size of the curve, if that takes at most [`MOST_VERTICES`].
const ENOUGH: f64 = 1e-5;
const MOST_VERTICES: usize = 1 << 14;

/// A closed polygon near a curve.
#[derive(Debug)]
pub(crate) struct NearPolygon {
    frame: Frame,
    traced: Traced,
}

impl NearPolygon {
    /// The polygon near a curve; `None` if the curve has very many harmonics.
    ///
    /// # Errors
    /// Those of `limits`.
    pub(crate) fn new(series: &EllipticSeries, limits: &Limits) -> Result<Option<Self>> {
        let middle = [series.x_cos(), series.y_cos()].map(|list| list[0].to_f64());
        let others = series.lists().iter().flat_map(|list| list.iter().skip(1));
        let size: f64 = others.map(|c| c.to_f64().abs()).sum();
        if !size.is_normal() {
            return Ok(None);
        }
        let frame = Frame::new(middle, size);
        let tracer = Tracer::new(series, &frame);
        let mut count = tracer.first_count();
        loop {
            let Some(traced) = tracer.polygon(count, limits)? else {
                return Ok(None);
            };
            let next = tracer.enough_count(count, traced.error, ENOUGH);
            if traced.error <= ENOUGH || count >= MOST_VERTICES {
                return Ok(Some(Self { frame, traced }));
            }
            count = next.min(MOST_VERTICES);
        }
    }

    /// Whether the curve winds an odd number of times around a point whose distance from it is at least `distance`; `None` if that
    /// is too small to tell.
    ///
    /// **Lemma.** If every point of the curve is within e of the point of the polygon with the same parameter, and p is farther
    /// than e from the curve, then both wind equally often around p. For the segments between these points, which are at most e
    /// long, do not meet p, so the curve can be moved to the polygon without passing p. The number of edges that cross a ray from p
    /// has the parity of the winding number. The point is moved by at most 2^(−52) of its size in the frame by rounding.
    pub(crate) fn winds_oddly(&self, point: [f64; 2], distance: f64) -> Option<bool> {
        let p = self.frame.inside(point);
        let rounding = f64::EPSILON * (p[0].abs() + p[1].abs());
        let is_far = distance / self.frame.scale() > (self.traced.error + rounding) * (1.0 + 1e-9);
        if !is_far {
            return None;
        }
        let points = &self.traced.points;
        let is_crossed = |a: [f64; 2], b: [f64; 2]| {
            if (a[1] <= p[1]) == (b[1] <= p[1]) {
                return false;
            }
            let side = orientation(a, b, p);
            side == if a[1] <= p[1] {
                Ordering::Greater
            } else {
                Ordering::Less
            }
        };
        let edges = points.windows(2).map(|edge| (edge[0], edge[1]));
        let closing = points.last().copied().zip(points.first().copied());
        let crossed = edges.chain(closing).filter(|&(a, b)| is_crossed(a, b));
        Some(crossed.count() % 2 == 1)
    }
}
