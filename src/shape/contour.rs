//! [`Contour`]: a closed simple outline given by its vertices.

use std::cmp::Ordering;

use super::crossing::find_crossing;
use super::orientation::{SMALLEST, coordinate_fault, on_segment, orientation, same};
use super::points::GivenPoints;
use crate::error::{Error, Invariant, Result};

/// A closed outline that does not touch itself: a simple polygon, its vertices counter-clockwise.
///
/// It has at least three vertices, not all on one line; consecutive vertices differ and the last is
/// joined to the first. Every non-zero coordinate is between 1e-120 and 1e120 in size, so that the
/// signs of all turns are exact.
///
/// ```
/// use stellate::shape::Contour;
///
/// // Given clockwise and closed by hand; kept counter-clockwise and open.
/// let square = [[0.0, 0.0], [0.0, 2.0], [2.0, 2.0], [2.0, 0.0], [0.0, 0.0]];
/// let contour = Contour::new(square.to_vec(), "square").unwrap();
/// assert_eq!(contour.points(), [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
/// assert_eq!((contour.area(), contour.centroid()), (4.0, [1.0, 1.0]));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    points: Vec<[f64; 2]>,
    /// Whether the points were given clockwise.
    is_reversed: bool,
    /// The weight of each vertex; empty if every weight is 1.
    weights: Vec<f64>,
    /// The size of a pixel if the outline was traced in a picture, else 0.
    resolution: f64,
    place: String,
}

impl Contour {
    /// The outline through `points`, in either sense. Repeated consecutive points are dropped, and so is a last point that is
    /// equal to the first. `place` names the source of the points in messages.
    ///
    /// Cost: O(n log n).
    ///
    /// # Errors
    /// [`Error::Data`], naming the points (counted from 1), if a coordinate is not finite or outside
    /// the range above, if fewer than three distinct points remain, if all are on one line, or if
    /// the outline crosses or touches itself.
    pub fn new(points: Vec<[f64; 2]>, place: &str) -> Result<Self> {
        Self::build(&points.into(), place, |i| format!("point {}", i + 1))
    }

    /// The outline through points that were read from a file, each with its weight. Messages name rows. Of repeated points, the
    /// weight of the first one counts.
    ///
    /// # Errors
    /// As [`Contour::new`]; [`Error::Data`] for a weight that is negative or no number.
    pub fn from_rows(given: GivenPoints, place: &str) -> Result<Self> {
        Self::build(&given, place, |i| given.name(i))
    }

    fn build(given: &GivenPoints, place: &str, name: impl Fn(usize) -> String) -> Result<Self> {
        given.check(place, &name)?;
        let points = &given.points;
        // `origin[k]` is the index, among the given points, of the vertex with the number k.
        let mut origin: Vec<usize> = Vec::with_capacity(points.len());
        for i in 0..points.len() {
            if origin.last().is_none_or(|&k| !same(points[k], points[i])) {
                origin.push(i);
            }
        }
        while origin.len() > 1 && same(points[origin[0]], points[origin[origin.len() - 1]]) {
            origin.pop();
        }
        // Adding 0.0 turns −0.0 into 0.0.
        let mut points: Vec<[f64; 2]> =
            origin.iter().map(|&i| points[i].map(|c| c + 0.0)).collect();
        let mut weights = given.weights_of(origin.iter().copied());
        let n = points.len();
        if n < 3 {
            let given = match n {
                0 => "there are none",
                1 => "there is one",
                _ => "there are two",
            };
            return Err(Error::data(
                place,
                format!("an outline needs at least three points; {given}"),
            ));
        }
        if (2..n).all(|k| orientation(points[0], points[1], points[k]) == Ordering::Equal) {
            return Err(Error::data(
                place,
                "all points lie on one line; an outline must enclose an area",
            ));
        }
        if let Some(crossing) = find_crossing(&points) {
            let edge = |k: usize| {
                let (from, to) = (origin[k], origin[(k + 1) % n]);
                format!("the edge from {} to {}", name(from), name(to))
            };
            return Err(Error::data(
                place,
                format!(
                    "the outline crosses or touches itself: {} meets {} near ({:.6}, {:.6}); --repair cuts such loops off",
                    edge(crossing.first),
                    edge(crossing.second),
                    crossing.near[0],
                    crossing.near[1],
                ),
            ));
        }
        let is_reversed = is_clockwise(&points);
        if is_reversed {
            points[1..].reverse();
            if let Some((_, others)) = weights.split_first_mut() {
                others.reverse();
            }
        }
        Ok(Self {
            points,
            is_reversed,
            weights,
            resolution: 0.0,
            place: place.into(),
        })
    }

    /// The same outline, traced in a picture whose pixels have this size.
    #[must_use]
    pub fn with_resolution(self, resolution: f64) -> Self {
        Self { resolution, ..self }
    }

    /// The size of a pixel if the outline was traced in a picture, else 0.
    #[must_use]
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// Where the points came from, as it was given.
    #[must_use]
    pub fn place(&self) -> &str {
        &self.place
    }

    /// The vertices, counter-clockwise.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The vertices in the sense in which they were given.
    pub(crate) fn given_points(&self) -> Vec<[f64; 2]> {
        let mut points = self.points.clone();
        if self.is_reversed {
            points[1..].reverse();
        }
        points
    }

    /// The weight of each vertex, in the order of [`Contour::points`] and as in [`GivenPoints`]; empty if every weight is 1.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The weights in the sense in which the vertices were given.
    pub(crate) fn given_weights(&self) -> Vec<f64> {
        let mut weights = self.weights.clone();
        if let (true, Some((_, others))) = (self.is_reversed, weights.split_first_mut()) {
            others.reverse();
        }
        weights
    }

    /// The number of vertices, at least 3.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a contour is never empty")]
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// The edges as pairs of vertices, in order; the last one ends at the first vertex.
    pub(crate) fn edges(&self) -> impl ExactSizeIterator<Item = ([f64; 2], [f64; 2])> + '_ {
        let n = self.points.len();
        (0..n).map(move |i| (self.points[i], self.points[(i + 1) % n]))
    }

    /// The lower left and the upper right corner of the smallest box around the outline.
    #[must_use]
    pub fn bounding_box(&self) -> [[f64; 2]; 2] {
        let mut corners = [self.points[0]; 2];
        for p in &self.points {
            for k in 0..2 {
                corners[0][k] = corners[0][k].min(p[k]);
                corners[1][k] = corners[1][k].max(p[k]);
            }
        }
        corners
    }

    /// The area enclosed, 1/2 Σ (x_i y_(i+1) − x_(i+1) y_i), measured from the middle of the bounding
    /// box so that an outline far from the origin loses no digits.
    #[must_use]
    pub fn area(&self) -> f64 {
        let (_, scale) = self.frame();
        self.unit_moments()[0] * scale * scale
    }

    /// The centroid of the area enclosed (not of the vertices), from the middle of the bounding box.
    ///
    /// Rounding is relative to the size of the box; the result is never outside it.
    #[must_use]
    pub fn centroid(&self) -> [f64; 2] {
        let (middle, scale) = self.frame();
        let [area, x, y] = self.unit_moments();
        let corners = self.bounding_box();
        let coordinate = |moment: f64, k: usize| {
            let offset = moment / area;
            let offset = if offset.is_finite() { offset } else { 0.0 };
            let value = (middle[k] + scale * offset).clamp(corners[0][k], corners[1][k]);
            if value.abs() < SMALLEST { 0.0 } else { value }
        };
        [coordinate(x, 0), coordinate(y, 1)]
    }

    /// The middle of the bounding box, and half its longer side.
    pub(crate) fn frame(&self) -> ([f64; 2], f64) {
        let [low, high] = self.bounding_box();
        let middle = [
            f64::midpoint(low[0], high[0]),
            f64::midpoint(low[1], high[1]),
        ];
        let scale = (high[0] - low[0]).max(high[1] - low[1]) / 2.0;
        (middle, scale)
    }

    /// The area and the first moments, after the bounding box is moved to the origin and scaled to ±1.
    fn unit_moments(&self) -> [f64; 3] {
        let (middle, scale) = self.frame();
        let unit = |p: [f64; 2]| [(p[0] - middle[0]) / scale, (p[1] - middle[1]) / scale];
        let mut sums = [0.0; 3];
        for (p, q) in self.edges() {
            let (p, q) = (unit(p), unit(q));
            let twice_area = p[0] * q[1] - p[1] * q[0];
            sums[0] += twice_area / 2.0;
            sums[1] += twice_area * (p[0] + q[0]) / 6.0;
            sums[2] += twice_area * (p[1] + q[1]) / 6.0;
        }
        sums
    }

    /// Whether `point` is strictly inside the outline, exactly. Cost: O(n).
    ///
    /// The answer is `false` if a coordinate is outside the range of those of a contour (see [`Contour`]).
    #[must_use]
    pub fn contains(&self, point: [f64; 2]) -> bool {
        if point.iter().any(|&c| coordinate_fault(c).is_some()) {
            return false;
        }
        let mut inside = false;
        for (p, q) in self.edges() {
            if on_segment(p, q, point) {
                return false;
            }
            // The ray to the right of the point, by the half-open rule.
            let upward = p[1] <= point[1] && point[1] < q[1];
            let downward = q[1] <= point[1] && point[1] < p[1];
            let side = orientation(p, q, point);
            if (upward && side == Ordering::Greater) || (downward && side == Ordering::Less) {
                inside = !inside;
            }
        }
        inside
    }

    /// Checks the properties of every contour; for tests.
    ///
    /// # Panics
    /// If one of them does not hold.
    #[cfg(test)]
    pub(crate) fn check_invariants(&self) {
        assert!(self.len() >= 3);
        assert!(self.points.iter().flatten().all(|c| c.is_finite()));
        assert!(self.edges().all(|(p, q)| !same(p, q)));
        assert!(!is_clockwise(&self.points));
        assert_eq!(find_crossing(&self.points), None);
        assert!(self.area() > 0.0);
    }
}

/// Whether a simple polygon is clockwise, by the turn at the lowest of its leftmost vertices.
fn is_clockwise(points: &[[f64; 2]]) -> bool {
    let n = points.len();
    let lowest = (0..n)
        .min_by(|&i, &j| {
            points[i]
                .partial_cmp(&points[j])
                .invariant("coordinates are finite")
        })
        .invariant("a polygon has a vertex");
    let (before, after) = (points[(lowest + n - 1) % n], points[(lowest + 1) % n]);
    orientation(before, points[lowest], after) == Ordering::Less
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn message(points: &[[f64; 2]]) -> String {
        Contour::new(points.to_vec(), "outline.csv")
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn errors_name_the_points() {
        assert_eq!(
            message(&[[0.0, 0.0], [2.0, 2.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]]),
            "outline.csv: the outline crosses or touches itself: the edge from point 1 to point 2 \
             meets the edge from point 4 to point 5 near (1.000000, 1.000000); --repair cuts such loops off"
        );
        let bow_tie = GivenPoints {
            points: vec![[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]],
            rows: vec![3, 4, 9, 11],
            ..GivenPoints::default()
        };
        let error = Contour::from_rows(bow_tie, "a.csv").unwrap_err();
        assert!(
            error.to_string().contains("from row 9 to row 11"),
            "{error}"
        );
        assert_eq!(
            message(&[[0.0, 0.0], [1.0, f64::NAN]]),
            "outline.csv, point 2: the coordinate NaN is not finite"
        );
        assert!(message(&[[0.0, 1e-200], [1.0, 2.0], [2.0, 0.0]]).contains("out of range"));
        assert!(message(&[[0.0, 1e200], [1.0, 2.0], [2.0, 0.0]]).contains("out of range"));
    }

    #[test]
    fn an_outline_needs_three_points_and_an_area() {
        assert!(message(&[]).contains("at least three points; there are none"));
        assert!(message(&[[1.0, 1.0]; 4]).contains("at least three points; there is one"));
        let there_and_back = [[0.0, 0.0], [1.0, 1.0], [1.0, 1.0], [0.0, 0.0]];
        assert!(message(&there_and_back).contains("at least three points; there are two"));
        assert!(message(&[[0.0, 0.0], [3.0, 1.0], [6.0, 2.0]]).contains("on one line"));
    }

    #[test]
    fn the_centroid_of_a_far_outline_keeps_its_digits() {
        let far = 2f64.powi(40);
        let l_shape = [[0., 0.], [2., 0.], [2., 1.], [1., 1.], [1., 2.], [0., 2.]];
        let near = Contour::new(l_shape.to_vec(), "L").unwrap();
        let moved: Vec<[f64; 2]> = l_shape.iter().map(|p| [p[0] + far, p[1] - far]).collect();
        let moved = Contour::new(moved, "L").unwrap();
        assert_eq!((near.area(), moved.area()), (3.0, 3.0));
        assert!((near.centroid()[0] - 5.0 / 6.0).abs() < 1e-15);
        assert!((moved.centroid()[0] - far - 5.0 / 6.0).abs() < 2e-4);
        assert_eq!(moved.bounding_box(), [[far, -far], [far + 2.0, 2.0 - far]]);
    }

    #[test]
    fn sizes_at_the_limits_work() {
        for size in [1e-119, 1e119] {
            let square = vec![[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]];
            let contour = Contour::new(square, "square").unwrap();
            contour.check_invariants();
            assert!((contour.centroid()[0] / size - 0.5).abs() < 1e-15);
            assert!(contour.contains([size / 2.0, size / 3.0]));
        }
    }

    #[test]
    fn inside_is_strict() {
        let triangle = Contour::new(vec![[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]], "t").unwrap();
        assert!(triangle.contains([1.0, 1.0]));
        for outside in [
            [2.0, 2.0],
            [0.0, 0.0],
            [3.0, 3.0],
            [-1.0, 0.0],
            [f64::NAN, 0.0],
        ] {
            assert!(!triangle.contains(outside), "{outside:?}");
        }
    }

    proptest! {
        #[test]
        fn what_is_accepted_is_valid(points in prop::collection::vec((0i8..9, 0i8..9), 3..8)) {
            let points: Vec<[f64; 2]> =
                points.iter().map(|&(x, y)| [f64::from(x), f64::from(y)]).collect();
            let backwards: Vec<[f64; 2]> = points.iter().rev().copied().collect();
            match Contour::new(points, "p") {
                Ok(contour) => {
                    contour.check_invariants();
                    let other = Contour::new(backwards, "p").unwrap();
                    prop_assert!((contour.area() / other.area() - 1.0).abs() < 1e-12);
                }
                Err(_) => prop_assert!(Contour::new(backwards, "p").is_err()),
            }
        }
    }
}
