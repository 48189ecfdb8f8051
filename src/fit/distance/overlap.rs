//! The overlap of two polygons, approximately.

use std::f64;

use super::super::as_f64;
use super::polygon::Polygon;

/// The number of horizontal lines on which the polygons are compared.
const LINES: usize = 4096;

/// The area of the intersection over that of the union, by the lengths on horizontal lines at equal distances: the rule of
/// midpoints, exact on each line. A point is inside a polygon if a ray from it crosses the polygon an odd number of times.
pub(super) fn overlap(first: &Polygon, second: &Polygon) -> f64 {
    let heights = first.points().iter().chain(second.points()).map(|p| p[1]);
    let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| {
        (low.min(y), high.max(y))
    });
    let step = (high - low) / as_f64(LINES);
    let crossings = [first, second].map(|polygon| crossings(polygon, low, step));
    let (mut both, mut either) = (0.0, 0.0);
    for (a, b) in crossings[0].iter().zip(&crossings[1]) {
        let mut marks: Vec<(f64, usize)> = a
            .iter()
            .map(|&x| (x, 0))
            .chain(b.iter().map(|&x| (x, 1)))
            .collect();
        marks.sort_unstable_by(|p, q| p.0.total_cmp(&q.0));
        let mut inside = [false; 2];
        let mut before = 0.0;
        for (x, which) in marks {
            let length = x - before;
            if inside[0] && inside[1] {
                both += length;
            }
            if inside[0] || inside[1] {
                either += length;
            }
            inside[which] = !inside[which];
            before = x;
        }
    }
    if either > 0.0 { both / either } else { 0.0 }
}

/// The places at which a polygon crosses each line.
fn crossings(polygon: &Polygon, low: f64, step: f64) -> Vec<Vec<f64>> {
    let mut lines = vec![Vec::new(); LINES];
    for k in 0..polygon.len() {
        let [p, q] = polygon.edge(k);
        let (lower, upper) = if p[1] <= q[1] { (p, q) } else { (q, p) };
        // The line k is at the height low + (k + 1/2) step.
        let first = line_above(lower[1], low, step);
        let end = line_above(upper[1], low, step);
        for (line, places) in lines.iter_mut().enumerate().take(end).skip(first) {
            let height = low + (as_f64(line) + 0.5) * step;
            let t = (height - lower[1]) / (upper[1] - lower[1]);
            places.push(lower[0] + t.clamp(0.0, 1.0) * (upper[0] - lower[0]));
        }
    }
    lines
}

/// The first line that is not below a height. Each vertex is on one side of each line, so every line is crossed an even number
/// of times.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a cast from a double saturates"
)]
fn line_above(height: f64, low: f64, step: f64) -> usize {
    (((height - low) / step - 0.5).ceil() as usize).min(LINES)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overlaps_of_squares() {
        let square = |x: f64, side: f64| {
            Polygon::new(vec![[x, 0.0], [x + side, 0.0], [x + side, side], [x, side]])
        };
        assert!((overlap(&square(0.0, 1.0), &square(0.0, 1.0)) - 1.0).abs() < 1e-12);
        assert!((overlap(&square(0.0, 1.0), &square(0.5, 1.0)) - 1.0 / 3.0).abs() < 1e-12);
        assert!((overlap(&square(0.0, 1.0), &square(0.0, 0.5)) - 0.25).abs() < 1e-3);
        assert!(overlap(&square(0.0, 1.0), &square(3.0, 1.0)).abs() < 1e-12);
    }
}
