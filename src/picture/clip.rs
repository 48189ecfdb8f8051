//! The parts of lines and areas that are inside the window. A plotter would draw the other parts along its edge.

use line_clipping::cohen_sutherland::clip_line;
use line_clipping::sutherland_hodgman::clip_polygon;
use line_clipping::{LineSegment, Point, Polygon, Window as Rectangle};

use super::Window;

/// The parts of a polyline inside the window.
pub(super) fn polyline(line: &[[f64; 2]], window: &Window) -> Vec<Vec<(f64, f64)>> {
    let mut parts: Vec<Vec<(f64, f64)>> = Vec::new();
    for pair in line.windows(2) {
        let segment = LineSegment::new(point(pair[0]), point(pair[1]));
        let Some(inside) = clip_line(segment, rectangle(window)) else {
            continue;
        };
        let (from, to) = ((inside.p1.x, inside.p1.y), (inside.p2.x, inside.p2.y));
        match parts.last_mut() {
            Some(part) if part.last() == Some(&from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
    }
    parts
}

/// The part of a polygon inside the window.
pub(super) fn polygon(corners: &[[f64; 2]], window: &Window) -> Vec<(f64, f64)> {
    let corners: Vec<Point> = corners.iter().map(|&p| point(p)).collect();
    let inside = clip_polygon(&Polygon::new(&corners), rectangle(window));
    inside.vertices.iter().map(|p| (p.x, p.y)).collect()
}

fn point([x, y]: [f64; 2]) -> Point {
    Point::new(x, y)
}

fn rectangle(window: &Window) -> Rectangle {
    let Window { x, y } = window;
    Rectangle::new(x[0], x[1], y[0], y[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Window = Window {
        x: [0.0, 1.0],
        y: [0.0, 1.0],
    };

    #[test]
    fn a_line_that_leaves_and_comes_back_has_two_parts() {
        let line = [[0.5, 0.5], [0.5, 2.0], [0.75, 2.0], [0.75, 0.25]];
        let parts = polyline(&line, &UNIT);
        assert_eq!(
            parts,
            [
                vec![(0.5, 0.5), (0.5, 1.0)],
                vec![(0.75, 1.0), (0.75, 0.25)]
            ]
        );
        assert!(polyline(&[[2.0, 2.0], [3.0, 3.0]], &UNIT).is_empty());
        let inside = [[0.1, 0.1], [0.2, 0.3], [0.4, 0.4]];
        assert_eq!(
            polyline(&inside, &UNIT),
            [inside.map(|[x, y]| (x, y)).to_vec()]
        );
    }

    #[test]
    fn an_area_is_cut_at_the_edge() {
        let corners = polygon(&[[-1.0, 0.25], [2.0, 0.25], [2.0, 0.5], [-1.0, 0.5]], &UNIT);
        let inside = |&(x, y): &(f64, f64)| (0.0..=1.0).contains(&x) && (0.25..=0.5).contains(&y);
        assert!(
            corners.len() >= 4 && corners.iter().all(inside),
            "{corners:?}"
        );
    }
}
