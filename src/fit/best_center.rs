//! The point that sees the most of an outline, by search.

use super::as_f64;
use super::radius::ContourRadius;
use crate::error::{Error, Result};
use crate::parallel;
use crate::shape::Contour;

/// The number of points of the grid times the number of vertices is about this, …
const GRID_WORK: usize = 4_000_000;
/// … but the grid has at least and at most so many points along each side.
const LEAST_SIDE: usize = 5;
const MOST_SIDE: usize = 24;
/// How often the steps around the best point are halved.
const HALVINGS: usize = 12;

/// A point inside the outline from which a small share of its length is hidden: the best of a grid over the box of the outline and
/// of `others`, improved by steps to its eight neighbours, which are halved when none is better. It need not be the best of all
/// points.
///
/// Cost: about 600 radii of the outline, or fewer for an outline of more than 7000 vertices.
pub(super) fn best_center(contour: &Contour, others: &[[f64; 2]]) -> Result<[f64; 2]> {
    let [low, high] = contour.bounding_box();
    let side = (GRID_WORK / contour.len())
        .isqrt()
        .clamp(LEAST_SIDE, MOST_SIDE);
    let step = [0, 1].map(|i| (high[i] - low[i]) / as_f64(side));
    let place = |i: usize, k: usize| low[i] + (as_f64(k) + 0.5) * step[i];
    let grid = (0..side * side).map(|k| [place(0, k % side), place(1, k / side)]);
    let points: Vec<[f64; 2]> = others.iter().copied().chain(grid).collect();
    let Some((mut share, mut best)) = least_hidden(contour, &points)? else {
        return Err(Error::Usage(
            "no point inside the outline was found from which to measure; give one with --center X,Y"
                .into(),
        ));
    };
    let mut size = 0.5;
    for _ in 0..HALVINGS {
        loop {
            let around: Vec<[f64; 2]> = (0..9)
                .filter(|k| *k != 4)
                .map(|k| {
                    let by = [as_f64(k % 3) - 1.0, as_f64(k / 3) - 1.0];
                    [0, 1].map(|i| best[i] + size * by[i] * step[i])
                })
                .collect();
            match least_hidden(contour, &around)? {
                Some((less, point)) if less < share => (share, best) = (less, point),
                _ => break,
            }
        }
        size /= 2.0;
    }
    Ok(best)
}

/// The first of the points inside the outline from which the least of it is hidden, with that share.
fn least_hidden(contour: &Contour, points: &[[f64; 2]]) -> Result<Option<(f64, [f64; 2])>> {
    let found = parallel::map(points, |&point| {
        if !contour.contains(point) {
            return Ok(None);
        }
        let share = ContourRadius::new(contour, point)?.hidden_share();
        Ok(Some((share, point)))
    });
    let found = found.into_iter().collect::<Result<Vec<_>>>()?;
    Ok(found
        .into_iter()
        .flatten()
        .min_by(|a, b| a.0.total_cmp(&b.0)))
}
