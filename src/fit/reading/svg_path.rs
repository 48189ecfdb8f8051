//! The subpaths of an SVG path.

use kurbo::{Arc, Point, SvgArc, Vec2};
use svgtypes::{PathParser, PathSegment};

use super::cut::Piece;

/// A part of a path between two moves.
#[derive(Debug)]
pub(super) struct Subpath {
    pub(super) start: Point,
    pub(super) pieces: Vec<Piece>,
    /// Whether it is closed by a command; it may also end where it begins.
    pub(super) is_closed: bool,
}

impl Subpath {
    fn at(start: Point) -> Self {
        Self {
            start,
            pieces: Vec::new(),
            is_closed: false,
        }
    }

    /// Straight edges through these points.
    pub(super) fn polygon(points: impl IntoIterator<Item = (f64, f64)>, is_closed: bool) -> Self {
        let mut points = points.into_iter().map(Point::from);
        Self {
            start: points.next().unwrap_or_default(),
            pieces: points.map(Piece::Line).collect(),
            is_closed,
        }
    }

    fn end(&self) -> Point {
        self.pieces.last().map_or(self.start, Piece::end)
    }
}

/// What a path has been read into.
struct Reader {
    done: Vec<Subpath>,
    open: Subpath,
    /// The last control point of the curve before, and its degree: smooth curves go on from it.
    control: Option<(Point, u8)>,
}

/// The subpaths that the attribute `d` describes. Each has at least one piece.
///
/// # Errors
/// The parser's message. SVG draws what comes before an error, but an outline that ends there would be another one.
pub(super) fn subpaths(description: &str) -> Result<Vec<Subpath>, String> {
    let mut reader = Reader {
        done: Vec::new(),
        open: Subpath::at(Point::ORIGIN),
        control: None,
    };
    for segment in PathParser::from(description) {
        reader.take(segment.map_err(|error| error.to_string())?);
    }
    reader.finish(Point::ORIGIN);
    Ok(reader.done)
}

impl Reader {
    /// The open subpath is done; the next one begins at `start`.
    fn finish(&mut self, start: Point) {
        let done = std::mem::replace(&mut self.open, Subpath::at(start));
        if !done.pieces.is_empty() {
            self.done.push(done);
        }
    }

    fn take(&mut self, segment: PathSegment) {
        let from = self.open.end();
        let origin = if segment.is_abs() {
            Vec2::ZERO
        } else {
            from.to_vec2()
        };
        let point = |x: f64, y: f64| Point::new(x, y) + origin;
        let control = self.control.take();
        // The reflection of the last control point, if the curve before has the same degree.
        let smooth = |degree: u8| match control {
            Some((last, of)) if of == degree => from + (from - last),
            _ => from,
        };
        let mut curve_control = None;
        let piece = match segment {
            PathSegment::MoveTo { x, y, .. } => return self.finish(point(x, y)),
            PathSegment::ClosePath { .. } => {
                let start = self.open.start;
                self.open.is_closed = true;
                return self.finish(start);
            }
            PathSegment::LineTo { x, y, .. } => Piece::Line(point(x, y)),
            PathSegment::HorizontalLineTo { x, .. } => {
                Piece::Line(Point::new(x + origin.x, from.y))
            }
            PathSegment::VerticalLineTo { y, .. } => Piece::Line(Point::new(from.x, y + origin.y)),
            PathSegment::CurveTo {
                x1,
                y1,
                x2,
                y2,
                x,
                y,
                ..
            } => {
                curve_control = Some((point(x2, y2), 3));
                Piece::Cubic([from, point(x1, y1), point(x2, y2), point(x, y)])
            }
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                curve_control = Some((point(x2, y2), 3));
                Piece::Cubic([from, smooth(3), point(x2, y2), point(x, y)])
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => {
                curve_control = Some((point(x1, y1), 2));
                Piece::quadratic([from, point(x1, y1), point(x, y)])
            }
            PathSegment::SmoothQuadratic { x, y, .. } => {
                let middle = smooth(2);
                curve_control = Some((middle, 2));
                Piece::quadratic([from, middle, point(x, y)])
            }
            PathSegment::EllipticalArc {
                rx,
                ry,
                x_axis_rotation,
                large_arc,
                sweep,
                x,
                y,
                ..
            } => {
                let to = point(x, y);
                let arc = Arc::from_svg_arc(&SvgArc {
                    from,
                    to,
                    radii: Vec2::new(rx, ry),
                    x_rotation: x_axis_rotation.to_radians(),
                    large_arc,
                    sweep,
                });
                arc.map_or(Piece::Line(to), |arc| Piece::arc(&arc, to))
            }
        };
        self.control = curve_control;
        self.open.pieces.push(piece);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{BezPath, PathEl};

    #[test]
    fn paths_are_read_as_another_reader_reads_them() {
        for description in [
            "M1,2 3,4 L5,6 z m1,1 h2 v3 H0 V-1 Z l1 1",
            "m1 1c1 2 3 4 5 6s7 8 9 10S1 2 3 4C0 0 1 1 2 0",
            "M0 0Q1 1 2 0T4 0t2 1q1 1 2 2 t1 1 L0 0 T1 1",
            "M0 0 s1 1 2 2 q1 1 2 2 S0 0 1 1",
        ] {
            let expected = BezPath::from_svg(description).unwrap();
            let expected = expected
                .elements()
                .iter()
                .filter_map(|element| match element {
                    PathEl::LineTo(p) | PathEl::QuadTo(_, p) | PathEl::CurveTo(_, _, p) => Some(*p),
                    _ => None,
                });
            let found = subpaths(description).unwrap();
            let found = found
                .iter()
                .flat_map(|path| path.pieces.iter().map(Piece::end));
            assert_eq!(found.collect::<Vec<_>>(), expected.collect::<Vec<_>>());
        }
        assert!(subpaths("M0 0 L1").is_err());
        assert!(subpaths("L1 1").is_err());
        assert!(subpaths("M0 0 M1 1").unwrap().is_empty());
    }

    #[test]
    fn smooth_curves_go_on_from_the_control_point_before() {
        let cubic = |description: &str| {
            let paths = subpaths(description).unwrap();
            let Some(Piece::Cubic(points)) = paths[0].pieces.last().copied() else {
                panic!("{description} ends with no curve")
            };
            points[1]
        };
        assert_eq!(cubic("M0 0C0 1 1 1 2 0S4 0 5 5"), Point::new(3.0, -1.0));
        assert_eq!(cubic("M0 0Q0 1 2 0S4 0 5 5"), Point::new(2.0, 0.0));
        let third = 2.0 / 3.0;
        assert_eq!(
            cubic("M0 0Q1 3 3 0T6 0"),
            Point::new(3.0, 0.0).lerp(Point::new(5.0, -3.0), third)
        );
    }
}
