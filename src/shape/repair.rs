//! Outlines that touch themselves are mended: the loops are cut off.

use super::contour::Contour;
use super::crossing::{doubles_back, find_crossing, share_a_point};
use super::orientation::same;
use super::points::GivenPoints;
use crate::error::{Error, Result};

/// Each new edge is compared with this many edges before it.
const WINDOW: usize = 64;
/// Loops that are found along the way have at most this share of the length; longer ones are weighed against the rest.
const SHORT: f64 = 0.02;
/// The largest number of other loops.
const MOST_LOOPS: usize = 1000;
/// The largest share of the length that is cut off.
const MOST_REMOVED: f64 = 0.5;

/// What was cut off an outline.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Removed {
    /// The number of points.
    pub points: usize,
    /// The share (0 to 1) of the length of the closed polygon through all points.
    pub share: f64,
    /// The loops, and spurs, which go back along themselves; each from the last point before it to the first one behind it.
    pub ways: Vec<Vec<[f64; 2]>>,
}

/// Points that are handed in, with their indices.
type Indexed = (usize, [f64; 2]);

impl Contour {
    /// The outline through points where that touches or crosses itself: of the two ways between two edges that meet, the shorter
    /// one is cut off, until no two edges meet.
    ///
    /// Loops of up to 64 edges are cut off in one pass; for every other one the whole outline is searched.
    ///
    /// ```
    /// use stellate::shape::Contour;
    /// // A square with a spur at its first side and a small loop at its third one.
    /// let points = vec![[0., 0.], [5., 0.], [5., -1.], [5., 0.], [9., 0.], [9., 9.], [5., 9.], [4., 8.], [4., 9.5], [5., 8.5], [0., 9.]];
    /// assert!(Contour::new(points.clone(), "square").is_err());
    /// let (mended, removed) = Contour::repaired(points.into(), "square")?;
    /// assert_eq!((removed.ways.len(), removed.points), (2, 5));
    /// assert!(mended.area() > 75.0);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Contour::new`] that are no meeting of edges; [`Error::Data`] if more than half of the length would be cut off;
    /// [`Error::Limit`] for more than 1000 loops of more than 64 edges.
    pub fn repaired(given: GivenPoints, place: &str) -> Result<(Self, Removed)> {
        let total = length(&given.points);
        let is_usual = total > 0.0 && total.is_finite();
        if !is_usual {
            // The usual message names the fault.
            return Ok((Self::from_rows(given, place)?, Removed::default()));
        }
        let mut ways = Vec::new();
        let mut kept = without_short_loops(&given.points, SHORT * total, &mut ways);
        let mut found = 0;
        loop {
            kept.dedup_by(|a, b| same(a.1, b.1));
            while kept.len() > 1 && same(kept[0].1, kept[kept.len() - 1].1) {
                kept.pop();
            }
            let points = places(&kept);
            if points.len() < 3 {
                break;
            }
            let Some(crossing) = find_crossing(&points) else {
                break;
            };
            found += 1;
            if found > MOST_LOOPS {
                return Err(Error::limit(format!(
                    "{place}: more than {MOST_LOOPS} large loops would have to be cut off; are the points in order?"
                )));
            }
            let (i, j) = (crossing.first, crossing.second);
            let inner = &points[i..=(j + 1).min(points.len() - 1)];
            if 2.0 * length_of_way(inner) <= length(&points) {
                ways.push(inner.to_vec());
                kept.drain(i + 1..=j);
            } else {
                ways.push([&points[j..], &points[..=i + 1]].concat());
                kept.truncate(j + 1);
                kept.drain(..=i);
            }
        }
        let points = places(&kept);
        let removed = Removed {
            points: given.points.len() - points.len(),
            share: (1.0 - length(&points) / total).max(0.0),
            ways,
        };
        if removed.share > MOST_REMOVED {
            return Err(Error::data(
                place,
                format!(
                    "to mend it, {:.0} % of the length of the outline would be cut off; are the points in order? Points in no order are fitted with --cloud",
                    100.0 * removed.share
                ),
            ));
        }
        let kept = kept.iter().map(|&(index, _)| index);
        let mended = GivenPoints {
            points,
            weights: given.weights_of(kept.clone()),
            rows: kept.map(|index| given.row(index)).collect(),
        };
        Ok((Self::from_rows(mended, place)?, removed))
    }
}

fn places(kept: &[Indexed]) -> Vec<[f64; 2]> {
    kept.iter().map(|(_, p)| *p).collect()
}

/// The points without the loops of at most [`WINDOW`] edges that are at most `longest` long.
fn without_short_loops(
    points: &[[f64; 2]],
    longest: f64,
    ways: &mut Vec<Vec<[f64; 2]>>,
) -> Vec<Indexed> {
    let mut kept: Vec<Indexed> = Vec::with_capacity(points.len());
    for (index, &point) in points.iter().enumerate() {
        while let Some(last) = kept.last().map(|(_, p)| *p) {
            if same(last, point) {
                kept.pop();
                continue;
            }
            let Some(start) = first_met(&kept, point, longest) else {
                break;
            };
            ways.push([&places(&kept[start..])[..], &[point]].concat());
            kept.truncate(start + 1);
        }
        kept.push((index, point));
    }
    kept
}

/// The first of the last edges that the edge to the next point meets, if the loop between the two is short.
fn first_met(kept: &[Indexed], next: [f64; 2], longest: f64) -> Option<usize> {
    let last = kept.len() - 1;
    let at = |k: usize| kept[k].1;
    if last >= 1 && doubles_back(at(last - 1), at(last), next) {
        return short(&kept[last - 1..], next, longest).then_some(last - 1);
    }
    let start = last.saturating_sub(WINDOW);
    let met = (start..last.saturating_sub(1))
        .find(|&k| share_a_point(at(k), at(k + 1), at(last), next))?;
    short(&kept[met + 1..], next, longest).then_some(met)
}

fn short(way: &[Indexed], next: [f64; 2], longest: f64) -> bool {
    length_of_way(&[&places(way)[..], &[next]].concat()) <= longest
}

fn length_of_way(points: &[[f64; 2]]) -> f64 {
    let edges = points.windows(2);
    edges
        .map(|pair| f64::hypot(pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]))
        .sum()
}

/// The length of the closed polygon.
fn length(points: &[[f64; 2]]) -> f64 {
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return 0.0;
    };
    length_of_way(points) + f64::hypot(last[0] - first[0], last[1] - first[1])
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_figure_eight_is_no_outline() {
        // More than half of its length would be cut off.
        let eight = vec![[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
        let message = Contour::repaired(eight.into(), "eight")
            .unwrap_err()
            .to_string();
        assert!(message.contains("59 % of the length"), "{message}");
    }

    #[test]
    fn an_outline_without_loops_stays_as_it_is() {
        let square = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        let (mended, removed) = Contour::repaired(square.clone().into(), "square").unwrap();
        assert_eq!(
            (mended.points(), removed),
            (&square[..], Removed::default())
        );
        let message = Contour::repaired(vec![[1.0, 1.0]; 5].into(), "one")
            .unwrap_err()
            .to_string();
        assert!(message.contains("at least three points"), "{message}");
        let message = Contour::repaired(vec![[1.0, f64::NAN]; 5].into(), "one")
            .unwrap_err()
            .to_string();
        assert!(message.contains("not finite"), "{message}");
    }

    proptest! {
        /// Whatever is mended is an outline, and its points are among those that were given, in their order.
        #[test]
        fn what_is_mended_is_an_outline(points in prop::collection::vec((0i8..12, 0i8..12), 3..60)) {
            let points: Vec<[f64; 2]> = points.iter().map(|&(x, y)| [f64::from(x), f64::from(y)]).collect();
            if let Ok((mended, removed)) = Contour::repaired(points.clone().into(), "p") {
                mended.check_invariants();
                let kept = mended.given_points();
                let mut rest = points.iter();
                prop_assert!(kept.iter().all(|p| rest.any(|q| same(*q, *p))));
                prop_assert_eq!(points.len() - kept.len(), removed.points);
            }
        }

        /// Noise that makes neighbours change places is cut off, and little else.
        #[test]
        fn a_noisy_circle_is_a_circle(offsets in prop::collection::vec((-1.0f64..1.0, -1.0f64..1.0), 400)) {
            let points = (0u16..).zip(&offsets).map(|(k, (a, b))| {
                let angle = std::f64::consts::TAU * f64::from(k) / 400.0 + 0.012 * a;
                let radius = 1.0 + 0.01 * b;
                [radius * angle.cos(), radius * angle.sin()]
            });
            let (mended, removed) = Contour::repaired(points.collect::<Vec<_>>().into(), "circle").unwrap();
            prop_assert!((mended.area() / std::f64::consts::PI - 1.0).abs() < 0.03);
            prop_assert!(removed.share < 0.5);
        }
    }
}
