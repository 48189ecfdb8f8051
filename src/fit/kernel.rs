//! The kernel of an outline: the points from which all of the outline is visible.

use crate::shape::Contour;

/// The kernel of `contour` as a convex contour, in floating point: the intersection of the
/// half-planes to the left of its edges, by sorting them by direction (O(n log n)).
///
/// The result is `None` if the kernel is empty or too thin for rounding. Callers must verify exactly what they use of it.
pub(super) fn kernel(contour: &Contour) -> Option<Contour> {
    let (middle, scale) = contour.frame();
    let unit = |p: [f64; 2]| [(p[0] - middle[0]) / scale, (p[1] - middle[1]) / scale];
    let mut planes: Vec<HalfPlane> = contour
        .edges()
        .filter_map(|(p, q)| HalfPlane::new(unit(p), unit(q)))
        .collect();
    // A box around everything bounds all intermediate intersections.
    let corners = [[-2.0, -2.0], [2.0, -2.0], [2.0, 2.0], [-2.0, 2.0]];
    planes.extend((0..4).filter_map(|i| HalfPlane::new(corners[i], corners[(i + 1) % 4])));
    planes.sort_unstable_by(|a, b| a.angle.total_cmp(&b.angle));
    let vertices = intersect(&planes)?
        .into_iter()
        .map(|v| [middle[0] + scale * v[0], middle[1] + scale * v[1]])
        .collect();
    Contour::new(vertices, "kernel").ok()
}

/// The points to the left of a line.
#[derive(Clone, Copy, Debug)]
struct HalfPlane {
    point: [f64; 2],
    /// The direction of the line, a unit vector.
    direction: [f64; 2],
    angle: f64,
}

impl HalfPlane {
    fn new(p: [f64; 2], q: [f64; 2]) -> Option<Self> {
        let (x, y) = (q[0] - p[0], q[1] - p[1]);
        let length = x.hypot(y);
        (length > 0.0).then(|| Self {
            point: p,
            direction: [x / length, y / length],
            angle: y.atan2(x),
        })
    }

    /// The distance of `v` from the line, positive to the left.
    fn depth(&self, v: [f64; 2]) -> f64 {
        cross(self.direction, [v[0] - self.point[0], v[1] - self.point[1]])
    }

    /// The point in which the two lines meet.
    fn meet(&self, other: &Self) -> [f64; 2] {
        let t = other.depth(self.point) / cross(self.direction, other.direction);
        [
            self.point[0] + t * self.direction[0],
            self.point[1] + t * self.direction[1],
        ]
    }
}

fn cross(u: [f64; 2], v: [f64; 2]) -> f64 {
    u[0] * v[1] - u[1] * v[0]
}

/// Lines whose directions differ by less than this count as parallel.
const PARALLEL: f64 = 1e-14;

/// The vertices of the intersection of half-planes sorted by angle; `None` if it is empty.
fn intersect(planes: &[HalfPlane]) -> Option<Vec<[f64; 2]>> {
    // The border of the intersection so far, as a queue: `kept[first..]`.
    let mut kept: Vec<HalfPlane> = Vec::new();
    let mut first = 0;
    for plane in planes {
        while kept.len() > first + 1 && cuts_last(&kept, plane) {
            kept.pop();
        }
        while kept.len() > first + 1 && plane.depth(kept[first].meet(&kept[first + 1])) <= 0.0 {
            first += 1;
        }
        if kept.len() > first {
            let last = kept[kept.len() - 1];
            let turn = cross(last.direction, plane.direction);
            let dot =
                last.direction[0] * plane.direction[0] + last.direction[1] * plane.direction[1];
            if turn.abs() < PARALLEL && dot > 0.0 {
                // If two lines have the same direction, the one farther left is kept.
                if plane.depth(last.point) >= 0.0 {
                    continue;
                }
                kept.pop();
                // The end of the queue is now an older line, which the replacement may cut off.
                while kept.len() > first + 1 && cuts_last(&kept, plane) {
                    kept.pop();
                }
            } else if turn <= 0.0 {
                return None;
            }
        }
        kept.push(*plane);
    }
    while kept.len() > first + 2 && cuts_last(&kept, &kept[first]) {
        kept.pop();
    }
    while kept.len() > first + 2
        && kept[kept.len() - 1].depth(kept[first].meet(&kept[first + 1])) <= 0.0
    {
        first += 1;
    }
    let border = &kept[first..];
    (border.len() >= 3).then(|| {
        (0..border.len())
            .map(|i| border[i].meet(&border[(i + 1) % border.len()]))
            .collect()
    })
}

/// Whether the corner of the last two lines kept is outside `plane`.
fn cuts_last(kept: &[HalfPlane], plane: &HalfPlane) -> bool {
    match kept {
        [.., before, last] => plane.depth(before.meet(last)) <= 0.0,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::super::radius::star_shaped_about;
    use super::*;
    use proptest::prelude::*;

    fn area_of_kernel(points: &[[f64; 2]]) -> Option<f64> {
        kernel(&Contour::new(points.to_vec(), "outline").unwrap()).map(|k| k.area())
    }

    #[test]
    fn a_convex_outline_is_its_own_kernel() {
        let hexagon = [
            [2., 0.],
            [1., 2.],
            [-1., 2.],
            [-2., 0.],
            [-1., -2.],
            [1., -2.],
        ];
        assert!((area_of_kernel(&hexagon).unwrap() - 12.0).abs() < 1e-12);
    }

    #[test]
    fn the_kernel_of_an_l_is_its_corner_and_a_u_has_none() {
        let l = [[0., 0.], [9., 0.], [9., 1.], [1., 1.], [1., 9.], [0., 9.]];
        assert!((area_of_kernel(&l).unwrap() - 1.0).abs() < 1e-12);
        let u = [
            [0., 0.],
            [9., 0.],
            [9., 9.],
            [8., 9.],
            [8., 1.],
            [1., 1.],
            [1., 9.],
            [0., 9.],
        ];
        assert_eq!(area_of_kernel(&u), None);
    }

    proptest! {
        /// A star polygon that is built about a point has this point in its kernel.
        #[test]
        fn a_star_has_a_kernel_with_the_point_it_was_built_about(
            radii in prop::collection::vec(1.0f64..2.0, 5..30),
            x in -100.0f64..100.0,
        ) {
            let n = u32::try_from(radii.len()).unwrap();
            let points: Vec<[f64; 2]> = (0..n)
                .zip(&radii)
                .map(|(k, r)| {
                    let angle = std::f64::consts::TAU * f64::from(k) / f64::from(n);
                    [x + r * angle.cos(), r * angle.sin()]
                })
                .collect();
            let contour = Contour::new(points, "star").unwrap();
            let region = kernel(&contour).unwrap();
            region.check_invariants();
            prop_assert!(region.contains([x, 0.0]));
            prop_assert!(star_shaped_about(&contour, region.centroid()));
            // The points half way to each corner are still inside the kernel.
            let middle = region.centroid();
            for v in region.points() {
                let half_way = [
                    f64::midpoint(v[0], middle[0]),
                    f64::midpoint(v[1], middle[1]),
                ];
                prop_assert!(star_shaped_about(&contour, half_way));
            }
        }
    }
}
