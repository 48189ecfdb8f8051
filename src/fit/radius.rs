//! [`ContourRadius`]: the radius function r(θ) of an outline about a center.

use std::cmp::Ordering;
use std::f64::consts::TAU;

use super::sweep::outermost;
use super::{Visibility, as_f64};
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
    /// The vertices of the outline, relative to the center.
    points: Vec<[f64; 2]>,
    /// The arcs, in the order of `start`. Directions before the first start belong to the last arc.
    arcs: Vec<Arc>,
    star_shaped: bool,
    hidden_share: f64,
}

/// A range of directions in which one edge is the outermost. There is one for each of perhaps a million vertices, so vertices are
/// small numbers.
#[derive(Clone, Copy, Debug)]
struct Arc {
    /// The edge, by its first vertex.
    edge: u32,
    /// The vertices in the directions of which it begins and ends.
    from: u32,
    to: u32,
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
        let relative = |p: &[f64; 2]| [p[0] - center[0], p[1] - center[1]];
        let points: Vec<[f64; 2]> = contour.points().iter().map(relative).collect();
        let mut arcs: Vec<Arc> = outermost(contour.points(), center)
            .into_iter()
            .map(|visible| Arc {
                edge: visible.edge,
                from: visible.from,
                to: visible.to,
                start: angle(points[visible.from as usize]),
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
        let mut radius = Self {
            points,
            arcs,
            star_shaped,
            hidden_share: 0.0,
        };
        if !star_shaped {
            let visible: f64 = radius.arcs.iter().map(|arc| radius.length_of(arc)).sum();
            let all: f64 = contour.edges().map(|(p, q)| distance(p, q)).sum();
            radius.hidden_share = (1.0 - visible / all).clamp(0.0, 1.0);
        }
        Ok(radius)
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

    /// How the outline is seen from the center.
    pub(super) fn visibility(&self) -> Visibility {
        Visibility {
            star_shaped: self.star_shaped,
            hidden_share: self.hidden_share,
        }
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
                before: length(self.point(previous, self.vertex(arc.from))),
                after: length(self.point(arc, self.vertex(arc.from))),
            }
        })
    }

    /// The radius r(θ), if `begun` arcs begin at or before θ.
    fn value(&self, theta: f64, begun: usize) -> f64 {
        let direction = [theta.cos(), theta.sin()];
        let count = self.arcs.len();
        let arc = |back: usize| &self.arcs[(begun + count - back) % count];
        let mut radius = length(self.point(arc(1), direction));
        // In a direction in which arcs begin, the ray also meets the arcs before them.
        let mut back = 1;
        while back < count && arc(back).start >= theta && back <= begun {
            back += 1;
            radius = radius.max(length(self.point(arc(back), direction)));
        }
        radius
    }

    /// A vertex, by its number in an arc.
    fn vertex(&self, number: u32) -> [f64; 2] {
        self.points[number as usize]
    }

    /// The point of an arc's edge in `direction`, or the nearer end of the edge if rounding puts the point outside.
    fn point(&self, arc: &Arc, direction: [f64; 2]) -> [f64; 2] {
        let edge = arc.edge as usize;
        let (p, q) = (
            self.points[edge],
            self.points[(edge + 1) % self.points.len()],
        );
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

    /// The visible length of an arc.
    fn length_of(&self, arc: &Arc) -> f64 {
        let end = |vertex| self.point(arc, self.vertex(vertex));
        distance(end(arc.from), end(arc.to))
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
