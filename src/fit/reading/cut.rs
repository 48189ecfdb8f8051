//! Curves of drawings are cut into edges within a stated bound.

use kurbo::{Affine, Arc, Point, Vec2};

/// No point of a curve is farther from its edge than this part of the longer side of its path.
pub(super) const BOUND: f64 = 1e-4;
/// A curve is probed at this many steps for the size of its path.
const PROBES: u32 = 8;
/// The largest number of edges of one curve. Only curves whose control points are far outside the path need more.
const MOST: u32 = 1 << 16;

/// One piece of a path; it begins where the one before ends.
#[derive(Clone, Copy, Debug)]
pub(super) enum Piece {
    Line(Point),
    /// The control points of a Bézier curve of degree 3.
    Cubic([Point; 4]),
    /// The points c + u cos θ + v sin θ.
    Ellipse {
        center: Point,
        axes: [Vec2; 2],
        start: f64,
        sweep: f64,
        /// The end as it is written, free of rounding.
        end: Point,
    },
}

impl Piece {
    /// The Bézier curve of degree 2 with these control points, as one of degree 3.
    pub(super) fn quadratic([p, q, r]: [Point; 3]) -> Self {
        Self::Cubic([p, p.lerp(q, 2.0 / 3.0), r.lerp(q, 2.0 / 3.0), r])
    }

    /// A part of an ellipse that ends at `end`.
    pub(super) fn arc(arc: &Arc, end: Point) -> Self {
        let turn = Affine::rotate(arc.x_rotation);
        let axis = |x, y| (turn * Point::new(x, y)).to_vec2();
        Self::Ellipse {
            center: arc.center,
            axes: [axis(arc.radii.x, 0.0), axis(0.0, arc.radii.y)],
            start: arc.start_angle,
            sweep: arc.sweep_angle,
            end,
        }
    }

    pub(super) fn transformed(self, by: Affine) -> Self {
        let vector = |v: Vec2| (by * v.to_point()) - (by * Point::ORIGIN);
        match self {
            Self::Line(end) => Self::Line(by * end),
            Self::Cubic(points) => Self::Cubic(points.map(|p| by * p)),
            Self::Ellipse {
                center,
                axes,
                start,
                sweep,
                end,
            } => Self::Ellipse {
                center: by * center,
                axes: axes.map(vector),
                start,
                sweep,
                end: by * end,
            },
        }
    }

    pub(super) fn end(&self) -> Point {
        match self {
            Self::Line(end) | Self::Ellipse { end, .. } | Self::Cubic([_, _, _, end]) => *end,
        }
    }

    /// The point at the parameter t, from 0 to 1.
    fn at(&self, t: f64) -> Point {
        match self {
            Self::Line(end) => *end,
            Self::Cubic([a, b, c, d]) => {
                let (ab, bc, cd) = (a.lerp(*b, t), b.lerp(*c, t), c.lerp(*d, t));
                ab.lerp(bc, t).lerp(bc.lerp(cd, t), t)
            }
            Self::Ellipse {
                center,
                axes: [u, v],
                start,
                sweep,
                ..
            } => {
                let (sin, cos) = (start + t * sweep).sin_cos();
                *center + *u * cos + *v * sin
            }
        }
    }

    /// A bound of the second derivative by t.
    fn bend(&self) -> f64 {
        match self {
            Self::Line(_) => 0.0,
            Self::Cubic([a, b, c, d]) => {
                let second = |p: &Point, q: &Point, r: &Point| ((*p - *q) + (*r - *q)).hypot();
                6.0 * second(a, b, c).max(second(b, c, d))
            }
            // |u cos + v sin| is at most the root of |u|^2 + |v|^2.
            Self::Ellipse {
                axes: [u, v],
                sweep,
                ..
            } => sweep * sweep * u.hypot().hypot(v.hypot()),
        }
    }

    /// The number of edges with which no point of the piece is farther than `bound` from its edge.
    ///
    /// Lemma. On a step h of the parameter, a curve p is at most h²/8 · max |p″| from its chord: the distance from a chord,
    /// c(t) = p(t) − p(a) − (t − a)/h · (p(a + h) − p(a)), is 0 at both ends, and linear interpolation has this error.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the number is from 1 to MOST"
    )]
    fn edges(&self, bound: f64) -> u32 {
        let steps = (self.bend() / (8.0 * bound)).sqrt().ceil();
        // A path without extent has no bound.
        match steps.is_finite() {
            true => steps.clamp(1.0, f64::from(MOST)) as u32,
            false => 1,
        }
    }

    fn steps(&self, count: u32) -> impl Iterator<Item = Point> + '_ {
        let inner = (1..count).map(move |k| self.at(f64::from(k) / f64::from(count)));
        inner.chain([self.end()])
    }
}

/// The vertices of a closed path that begins at `start`, its curves cut within [`BOUND`].
pub(super) fn cut(start: Point, pieces: &[Piece]) -> Vec<[f64; 2]> {
    let probes = pieces.iter().flat_map(|piece| {
        let count = if matches!(piece, Piece::Line(_)) {
            1
        } else {
            PROBES
        };
        piece.steps(count)
    });
    // All probes are on the path, so it is at least as large as their box.
    let (mut low, mut high) = (start, start);
    for p in probes {
        low = Point::new(low.x.min(p.x), low.y.min(p.y));
        high = Point::new(high.x.max(p.x), high.y.max(p.y));
    }
    let bound = BOUND * (high.x - low.x).max(high.y - low.y);
    let steps = pieces
        .iter()
        .flat_map(|piece| piece.steps(piece.edges(bound)));
    [start]
        .into_iter()
        .chain(steps)
        .map(|p| [p.x, p.y])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{BezPath, Ellipse, ParamCurveNearest, PathSeg, Shape};

    #[test]
    fn every_chord_is_within_the_bound() {
        let start = Point::new(0.0, 0.0);
        let cubic = [(0.0, 0.0), (3.0, 9.0), (-4.0, 7.0), (5.0, -1.0)].map(Point::from);
        let quadratic = [(5.0, -1.0), (9.0, -20.0), (0.0, 0.0)].map(Point::from);
        let pieces = [Piece::Cubic(cubic), Piece::quadratic(quadratic)];
        let points = cut(start, &pieces);
        let curves = [
            PathSeg::Cubic(kurbo::CubicBez::new(cubic[0], cubic[1], cubic[2], cubic[3])),
            PathSeg::Quad(kurbo::QuadBez::new(
                quadratic[0],
                quadratic[1],
                quadratic[2],
            )),
        ];
        let around = BezPath::from_path_segments(curves.into_iter()).bounding_box();
        let bound = BOUND * around.width().max(around.height());
        for pair in points.windows(2) {
            let middle = Point::new(
                f64::midpoint(pair[0][0], pair[1][0]),
                f64::midpoint(pair[0][1], pair[1][1]),
            );
            let near = curves.map(|curve| curve.nearest(middle, 1e-9).distance_sq.sqrt());
            assert!(near[0].min(near[1]) <= bound, "{pair:?}");
        }
        assert!(points.len() < 500, "{}", points.len());
    }

    #[test]
    fn an_ellipse_stays_one_under_a_transform() {
        let arc = Arc::new((1.0, 2.0), (3.0, 1.0), 0.5, std::f64::consts::TAU, 0.7);
        let by = Affine::new([2.0, 1.0, -1.0, 0.5, 3.0, 4.0]);
        let rotated = |v: Vec2, angle: f64| (Affine::rotate(angle) * v.to_point()).to_vec2();
        let radius = Vec2::new(3.0 * 0.5_f64.cos(), 0.5_f64.sin());
        let start = arc.center + rotated(radius, 0.7);
        let piece = Piece::arc(&arc, start).transformed(by);
        let points = cut(by * start, &[piece]);
        let shape = by * Ellipse::new((1.0, 2.0), (3.0, 1.0), 0.7);
        let area = super::super::rings::signed_area(&points[..points.len() - 1]).abs();
        assert!((area / shape.area() - 1.0).abs() < 1e-3, "{area}");
        for [x, y] in points {
            let p = rotated(by.inverse() * Point::new(x, y) - arc.center, -0.7);
            assert!((p.x * p.x / 9.0 + p.y * p.y - 1.0).abs() < 1e-9);
        }
    }
}
