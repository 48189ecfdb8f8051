//! [`ContourRadius`]: the radius function r(θ) of an outline about a center.

use std::cmp::Ordering;
use std::f64::consts::TAU;

use super::as_f64;
use super::sweep::outermost;
use crate::error::{Error, Result};
use crate::shape::{Contour, coordinate_fault, orientation};

/// The outermost radius r(θ) of an outline about an interior point: the distance to the last point
/// of the outline in direction θ (`x = r cos θ`, `y = r sin θ` from the center, Lemma 1).
///
/// If the outline is star-shaped about the center, this is the outline itself. If not, some parts are hidden behind others,
/// r(θ) jumps, and [`ContourRadius::hidden_share`] is the hidden part of the length. The decision which edge is outermost is
/// exact; the radii are rounded.
///
/// ```
/// use stellate::fit::ContourRadius;
/// use stellate::shape::Contour;
///
/// let square = vec![[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]];
/// let square = Contour::new(square, "square").unwrap();
/// let radius = ContourRadius::new(&square, [0.5, 0.0]).unwrap();
/// assert!(radius.is_star_shaped());
/// assert_eq!(radius.samples(4), [0.5, 1.0, 1.5, 1.0]);
/// ```
#[derive(Clone, Debug)]
pub struct ContourRadius {
    /// The arcs, in the order of `start`. Directions before the first start belong to the last arc.
    arcs: Vec<Arc>,
    star_shaped: bool,
    hidden_share: f64,
}

/// A range of directions in which one edge is the outermost; vectors are relative to the center.
#[derive(Clone, Copy, Debug)]
struct Arc {
    ends: [[f64; 2]; 2],
    from: [f64; 2],
    to: [f64; 2],
    /// The angle of `from`, in [0, 2π].
    start: f64,
}

/// A direction in which the outermost edge changes: r just before it and just after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    pub(super) theta: f64,
    pub(super) before: f64,
    pub(super) after: f64,
}

impl ContourRadius {
    /// The radius of `contour` about `center`. Cost: O(n log n).
    ///
    /// # Errors
    /// [`Error::Usage`] if the center is not strictly inside the outline.
    pub fn new(contour: &Contour, center: [f64; 2]) -> Result<Self> {
        if !contour.contains(center) {
            return Err(outside(contour, center));
        }
        let points = contour.points();
        let next = |i: usize| (i + 1) % points.len();
        let relative = |i: usize| [points[i][0] - center[0], points[i][1] - center[1]];
        let mut arcs: Vec<Arc> = outermost(points, center)
            .into_iter()
            .map(|visible| {
                let from = relative(visible.from);
                Arc {
                    ends: [relative(visible.edge), relative(next(visible.edge))],
                    from,
                    to: relative(visible.to),
                    start: angle(from),
                }
            })
            .collect();
        // The first arc may begin before direction 0; then its start is more than π larger than that of the second one.
        if arcs.len() > 1 && arcs[0].start - arcs[1].start > 1.0 {
            arcs.rotate_left(1);
        }
        // The angles of neighbouring directions may be in the wrong order by one unit in the last place.
        let mut last = 0.0;
        for arc in &mut arcs {
            last = arc.start.max(last);
            arc.start = last;
        }
        let star_shaped = star_shaped_about(contour, center);
        let hidden_share = if star_shaped {
            0.0
        } else {
            let visible: f64 = arcs.iter().map(Arc::length).sum();
            let all: f64 = contour.edges().map(|(p, q)| distance(p, q)).sum();
            (1.0 - visible / all).clamp(0.0, 1.0)
        };
        Ok(Self {
            arcs,
            star_shaped,
            hidden_share,
        })
    }

    /// Whether every ray from the center meets the outline in exactly one point; this is decided exactly.
    #[must_use]
    pub fn is_star_shaped(&self) -> bool {
        self.star_shaped
    }

    /// The share (0 to 1) of the outline's length that is hidden from the center; exactly 0 for a star-shaped outline.
    #[must_use]
    pub fn hidden_share(&self) -> f64 {
        self.hidden_share
    }

    /// The radius r(θ); where r jumps, the larger value. Cost: O(log n).
    #[must_use]
    pub fn at(&self, theta: f64) -> f64 {
        let theta = theta.rem_euclid(TAU);
        let begun = self.arcs.partition_point(|arc| arc.start <= theta);
        self.value(theta, begun)
    }

    /// The radii r(2πk/`count`) for k = 0 … `count` − 1. Cost: O(count + n).
    #[must_use]
    pub fn samples(&self, count: usize) -> Vec<f64> {
        let mut begun = 0;
        (0..count)
            .map(|k| {
                let theta = TAU * (as_f64(k) / as_f64(count));
                while self.arcs.get(begun).is_some_and(|arc| arc.start <= theta) {
                    begun += 1;
                }
                self.value(theta, begun)
            })
            .collect()
    }

    /// The largest jump of r, and the angle at which it happens; 0 for a star-shaped outline.
    #[must_use]
    pub fn largest_jump(&self) -> (f64, f64) {
        if self.star_shaped {
            return (0.0, 0.0);
        }
        self.corners()
            .map(|corner| ((corner.after - corner.before).abs(), corner.theta))
            .max_by(|a, b| a.0.total_cmp(&b.0))
            .unwrap_or((0.0, 0.0))
    }

    /// All directions in which the outermost edge changes.
    pub(super) fn corners(&self) -> impl Iterator<Item = Corner> + '_ {
        let count = self.arcs.len();
        self.arcs.iter().enumerate().map(move |(i, arc)| {
            let previous = &self.arcs[(i + count - 1) % count];
            Corner {
                theta: arc.start,
                before: length(previous.point(arc.from)),
                after: length(arc.point(arc.from)),
            }
        })
    }

    /// The radius r(θ), if `begun` arcs begin at or before θ.
    fn value(&self, theta: f64, begun: usize) -> f64 {
        let direction = [theta.cos(), theta.sin()];
        let count = self.arcs.len();
        let arc = |back: usize| &self.arcs[(begun + count - back) % count];
        let mut radius = length(arc(1).point(direction));
        // In a direction in which arcs begin, the ray also meets the arcs before them.
        let mut back = 1;
        while back < count && arc(back).start >= theta && back <= begun {
            back += 1;
            radius = radius.max(length(arc(back).point(direction)));
        }
        radius
    }
}

impl Arc {
    /// The point of the edge in `direction`, or the nearer end of the edge if rounding puts the point outside.
    fn point(&self, direction: [f64; 2]) -> [f64; 2] {
        let [p, q] = self.ends;
        let weights = [cross(direction, q).max(0.0), cross(p, direction).max(0.0)];
        let sum = weights[0] + weights[1];
        if sum > 0.0 {
            let t = weights[1] / sum;
            [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]
        } else if length(p) > length(q) {
            p
        } else {
            q
        }
    }

    fn length(&self) -> f64 {
        distance(self.point(self.from), self.point(self.to))
    }
}

/// The error for a center that is not strictly inside the outline.
pub(super) fn outside(contour: &Contour, center: [f64; 2]) -> Error {
    let [low, high] = contour.bounding_box();
    Error::Usage(format!(
        "the center ({}, {}) is not inside the outline, which spans x from {} to {} and y from {} \
         to {}",
        center[0], center[1], low[0], high[0], low[1], high[1]
    ))
}

/// The angle of a vector, in [0, 2π].
fn angle(v: [f64; 2]) -> f64 {
    let angle = v[1].atan2(v[0]);
    if angle < 0.0 { angle + TAU } else { angle }
}

fn cross(u: [f64; 2], v: [f64; 2]) -> f64 {
    u[0] * v[1] - u[1] * v[0]
}

fn length(v: [f64; 2]) -> f64 {
    v[0].hypot(v[1])
}

fn distance(p: [f64; 2], q: [f64; 2]) -> f64 {
    (q[0] - p[0]).hypot(q[1] - p[1])
}
/// Whether `contour` is star-shaped about c in the strict sense, exactly: every edge is seen strictly counter-clockwise from c,
/// so that r(θ) is a continuous function. Cost: O(n).
///
/// An edge in line with c would make r jump, so it does not count as star-shaped.
#[must_use]
pub fn star_shaped_about(contour: &Contour, c: [f64; 2]) -> bool {
    c.iter().all(|&x| coordinate_fault(x).is_none())
        && contour
            .edges()
            .all(|(p, q)| orientation(c, p, q) == Ordering::Greater)
}
