//! Outlines that touch themselves are mended: the loops are cut off.

use super::contour::Contour;
use super::crossing::{doubles_back, find_crossing, meeting_point, share_a_point};
use super::orientation::same;
use super::points::GivenPoints;
use crate::error::{Error, Result};

/// Each new edge is compared with this many edges before it.
const WINDOW: usize = 64;
/// Loops that are found along the way have at most this share of the length; longer ones are weighed against the rest.
const SHORT: f64 = 0.02;
/// The largest number of other loops.
const MOST_LOOPS: usize = 1000;
/// The largest share of the length that is cut off. Of two loops of one length, neither is the outline.
const MOST_REMOVED: f64 = 0.499;

/// What was cut off an outline.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Removed {
    /// The number of points.
    pub points: usize,
    /// The share (0 to 1) of the length of the closed polygon through all points.
    pub share: f64,
    /// The loops, each from the point where the outline meets itself and back to it, and spurs, which go back along themselves, from the
    /// last point before it to the first one behind it.
    pub ways: Vec<Vec<[f64; 2]>>,
}

/// A point of the mended outline.
#[derive(Clone, Copy)]
struct Kept {
    /// The index of the given point that this is, or that is before it.
    index: usize,
    point: [f64; 2],
    /// Whether two edges meet here, between given points.
    is_new: bool,
}

impl Contour {
    /// The outline through points where that touches or crosses itself: of the two loops from the point in which two edges meet, the
    /// shorter one is cut off, until no two edges meet. The point becomes one of the outline, as the double near it.
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
    /// Those of [`Contour::new`] that are no meeting of edges; [`Error::Data`] if half of the length or more would be cut off;
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
            kept.dedup_by(|a, b| same(a.point, b.point));
            while kept.len() > 1 && same(kept[0].point, kept[kept.len() - 1].point) {
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
            let (i, j, last) = (crossing.first, crossing.second, points.len() - 1);
            let are_neighbors = j == i + 1 || (i, j) == (0, last);
            let new = Kept {
                index: kept[i].index,
                point: crossing.near,
                is_new: true,
            };
            let inner = &points[i + 1..=j];
            let outer = [&points[j + 1..], &points[..=i]].concat();
            if length_of_loop(crossing.near, inner) <= length_of_loop(crossing.near, &outer) {
                ways.push(match are_neighbors {
                    true => points[i..=(j + 1).min(last)].to_vec(),
                    false => loop_from(crossing.near, inner),
                });
                kept.splice(i + 1..=j, (!are_neighbors).then_some(new));
            } else {
                ways.push(match are_neighbors {
                    true => [&points[j..], &points[..=i + 1]].concat(),
                    false => loop_from(crossing.near, &outer),
                });
                kept.truncate(j + 1);
                kept.drain(..=i);
                kept.extend((!are_neighbors).then_some(Kept {
                    index: kept.last().map_or(new.index, |last| last.index),
                    ..new
                }));
            }
        }
        let points = places(&kept);
        let removed = Removed {
            points: given.points.len() - kept.iter().filter(|kept| !kept.is_new).count(),
            share: (1.0 - length(&points) / total).max(0.0),
            ways,
        };
        if removed.share >= MOST_REMOVED {
            return Err(Error::data(
                place,
                format!(
                    "to mend it, {:.0} % of the length of the outline would be cut off; are the points in order? Points in no order are fitted with --cloud",
                    100.0 * removed.share
                ),
            ));
        }
        let kept = kept.iter().map(|kept| kept.index);
        let mended = GivenPoints {
            points,
            weights: given.weights_of(kept.clone()),
            rows: kept.map(|index| given.row(index)).collect(),
        };
        Ok((Self::from_rows(mended, place)?, removed))
    }
}

fn places(kept: &[Kept]) -> Vec<[f64; 2]> {
    kept.iter().map(|kept| kept.point).collect()
}

/// The points without the loops of at most [`WINDOW`] edges that are at most `longest` long.
fn without_short_loops(
    points: &[[f64; 2]],
    longest: f64,
    ways: &mut Vec<Vec<[f64; 2]>>,
) -> Vec<Kept> {
    let mut kept: Vec<Kept> = Vec::with_capacity(points.len());
    for (index, &point) in points.iter().enumerate() {
        while let Some(last) = kept.last().map(|kept| kept.point) {
            if same(last, point) {
                kept.pop();
                continue;
            }
            let Some((start, met)) = first_met(&kept, point, longest) else {
                break;
            };
            let cut = places(&kept[start + 1..]);
            ways.push(match met {
                Some(met) => loop_from(met, &cut),
                None => [&[kept[start].point][..], &cut, &[point]].concat(),
            });
            kept.truncate(start + 1);
            let before = kept[start];
            kept.extend(
                met.filter(|met| !same(*met, before.point))
                    .map(|point| Kept {
                        index: before.index,
                        point,
                        is_new: true,
                    }),
            );
        }
        kept.push(Kept {
            index,
            point,
            is_new: false,
        });
    }
    kept
}

/// The first of the last edges that the edge to the next point meets, if the loop between the two is short, and the point in which
/// they meet; there is none for a spur.
fn first_met(kept: &[Kept], next: [f64; 2], longest: f64) -> Option<(usize, Option<[f64; 2]>)> {
    let last = kept.len() - 1;
    let at = |k: usize| kept[k].point;
    if last >= 1 && doubles_back(at(last - 1), at(last), next) {
        let spur = [at(last - 1), at(last), next];
        return (length_of_way(&spur) <= longest).then_some((last - 1, None));
    }
    let start = last.saturating_sub(WINDOW);
    let met = (start..last.saturating_sub(1))
        .find(|&k| share_a_point(at(k), at(k + 1), at(last), next))?;
    let point = meeting_point([at(met), at(met + 1)], [at(last), next]);
    let length = length_of_loop(point, &places(&kept[met + 1..]));
    (length <= longest).then_some((met, Some(point)))
}

/// The way from a point through others and back to it.
fn loop_from(start: [f64; 2], way: &[[f64; 2]]) -> Vec<[f64; 2]> {
    [&[start][..], way, &[start]].concat()
}

fn length_of_loop(start: [f64; 2], way: &[[f64; 2]]) -> f64 {
    length_of_way(&loop_from(start, way))
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
        assert!(message.contains("50 % of the length"), "{message}");
    }

    /// Edges that overshoot a corner are cut where they meet, whichever point is the first.
    #[test]
    fn corners_that_are_overshot_are_kept() {
        let one = [
            [10.0, 10.1],
            [10.1, 10.0],
            [0.0, 10.0],
            [0.0, 0.0],
            [10.0, 0.0],
        ];
        let all = [
            [-0.1, 0.0],
            [10.1, 0.0],
            [10.0, -0.1],
            [10.0, 10.1],
            [10.1, 10.0],
            [-0.1, 10.0],
            [0.0, 10.1],
            [0.0, -0.1],
        ];
        for (points, loops) in [(&one[..], 1), (&all, 4)] {
            for turned in 0..points.len() {
                let mut points = points.to_vec();
                points.rotate_left(turned);
                for _ in 0..2 {
                    points.reverse();
                    let (mended, removed) =
                        Contour::repaired(points.clone().into(), "square").unwrap();
                    assert_eq!((mended.points().len(), removed.ways.len()), (4, loops));
                    assert!((mended.area() - 100.0).abs() < 1e-12, "{turned}");
                    assert!(removed.share < 0.04, "{}", removed.share);
                    assert_eq!(removed.points, 2 * loops);
                }
            }
        }
        let crossed = vec![[0.0, 0.0], [10.0, 0.0], [4.0, 12.0], [6.0, 12.0]];
        let (mended, _) = Contour::repaired(crossed.into(), "triangle").unwrap();
        assert_eq!(mended.points(), [[0.0, 0.0], [10.0, 0.0], [5.0, 10.0]]);
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
        /// Whatever is mended is an outline, and its points are given ones or new ones, of which every loop has at most one.
        #[test]
        fn what_is_mended_is_an_outline(points in prop::collection::vec((0i8..12, 0i8..12), 3..60)) {
            let points: Vec<[f64; 2]> = points.iter().map(|&(x, y)| [f64::from(x), f64::from(y)]).collect();
            if let Ok((mended, removed)) = Contour::repaired(points.clone().into(), "p") {
                mended.check_invariants();
                let kept = mended.given_points();
                let is_given = |p: &[f64; 2]| points.iter().any(|q| same(*q, *p));
                let new = kept.iter().filter(|p| !is_given(p)).count();
                prop_assert!(new <= removed.ways.len());
                // A new point may be at the place of a given one.
                let fewer = points.len() - kept.len().min(points.len());
                prop_assert!((fewer..=fewer + removed.ways.len()).contains(&removed.points));
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
