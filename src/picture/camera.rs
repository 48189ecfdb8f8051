//! The perspective view of a box.

use nalgebra::{Isometry3, Point3, Vector3};

/// The distance of the eye in units of the box's half diagonal. It is short enough to show depth.
const DISTANCE: f64 = 3.4;

/// Sides of the box that are shorter than this part of the longest side are drawn longer.
const THINNEST: f64 = 1.0 / 6.0;

/// A view of a box.
pub(super) struct Camera {
    /// The box, which has some thickness in every direction.
    pub(super) bounds: [[f64; 2]; 3],
    /// Whether the three axes have the same unit of length.
    pub(super) equal: bool,
    /// For each axis, which side of the box is nearer to the eye.
    pub(super) front: [usize; 3],
    scale: [f64; 3],
    view: Isometry3<f64>,
    unit: f64,
    origin: [f64; 2],
    /// The size of the picture of the box.
    pub(super) size: [f64; 2],
}

/// A point on the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub(super) x: f64,
    /// The coordinate that grows downwards.
    pub(super) y: f64,
}

impl Camera {
    /// The view, from the given direction in degrees, of a box. Its picture is at most `width` wide and `height` high.
    pub(super) fn new(
        bounds: [[f64; 2]; 3],
        [azimuth, elevation]: [f64; 2],
        [width, height]: [f64; 2],
    ) -> Self {
        let longest = bounds.iter().map(|[a, b]| b - a).fold(0.0, f64::max);
        let longest = if longest > 0.0 { longest } else { 1.0 };
        // A flat box is made thicker.
        let bounds = bounds.map(|[a, b]| {
            let missing = (0.2 * longest - (b - a)).max(0.0) / 2.0;
            if b - a < 1e-9 * longest {
                [a - missing, b + missing]
            } else {
                [a, b]
            }
        });
        let equal = bounds.iter().all(|[a, b]| (b - a) / longest >= THINNEST);
        let scale = bounds.map(|[a, b]| {
            let share = (b - a) / longest;
            let shown = if equal {
                share
            } else {
                share.max(2.0 * THINNEST)
            };
            2.0 * shown / (b - a)
        });
        let half = [0, 1, 2].map(|k| (bounds[k][1] - bounds[k][0]) * scale[k] / 2.0);
        let radius = half.iter().map(|h| h * h).sum::<f64>().sqrt();
        let (azimuth, elevation) = (azimuth.to_radians(), elevation.to_radians());
        let direction = Vector3::new(
            elevation.cos() * azimuth.cos(),
            elevation.cos() * azimuth.sin(),
            elevation.sin(),
        );
        let eye = Point3::from(direction * (DISTANCE * radius));
        let view = Isometry3::look_at_rh(&eye, &Point3::origin(), &Vector3::z());
        let front = [0, 1, 2].map(|k| usize::from(direction[k] > 0.0));
        let mut camera = Self {
            bounds,
            equal,
            front,
            scale,
            view,
            unit: 1.0,
            origin: [0.0, 0.0],
            size: [0.0, 0.0],
        };
        let mut low = [f64::INFINITY; 2];
        let mut high = [f64::NEG_INFINITY; 2];
        for corner in 0..8 {
            let seen = camera.see(camera.corner([corner & 1, corner >> 1 & 1, corner >> 2]));
            for (k, v) in [seen.x, seen.y].into_iter().enumerate() {
                low[k] = low[k].min(v);
                high[k] = high[k].max(v);
            }
        }
        camera.unit = (width / (high[0] - low[0])).min(height / (high[1] - low[1]));
        camera.origin = low;
        camera.size = [0, 1].map(|k| (high[k] - low[k]) * camera.unit);
        camera
    }

    /// A corner of the box; 0 stands for the low side, 1 for the high side.
    pub(super) fn corner(&self, sides: [usize; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| self.bounds[k][sides[k]])
    }

    /// The length of the box's diagonal.
    pub(super) fn diagonal(&self) -> f64 {
        let side = |k: usize| (self.bounds[k][1] - self.bounds[k][0]) * self.scale[k];
        (0..3).map(|k| side(k).powi(2)).sum::<f64>().sqrt()
    }

    /// The position of the eye.
    pub(super) fn eye(&self) -> [f64; 3] {
        let eye = self.view.inverse() * Point3::origin();
        [0, 1, 2].map(|k| {
            let [low, high] = self.bounds[k];
            f64::midpoint(low, high) + eye[k] / self.scale[k]
        })
    }

    /// The point, moved towards the eye by this part of the box's size.
    pub(super) fn lifted(&self, point: [f64; 3], part: f64) -> [f64; 3] {
        let eye = self.eye();
        let towards = (self.scaled(eye) - self.scaled(point)).norm();
        let share = part * self.diagonal() / towards;
        [0, 1, 2].map(|k| point[k] + share * (eye[k] - point[k]))
    }

    /// The point of the picture at which a point is seen.
    pub(super) fn see(&self, point: [f64; 3]) -> Seen {
        let p = self.view * self.scaled(point);
        Seen {
            x: (p.x / -p.z - self.origin[0]) * self.unit,
            y: (-p.y / -p.z - self.origin[1]) * self.unit,
        }
    }

    /// The cosine of the angle between the normal of a facet and the line to the eye. It is positive if the corners are
    /// counterclockwise as seen from the eye.
    pub(super) fn facing(&self, corners: &[[f64; 3]]) -> f64 {
        let seen: Vec<Point3<f64>> = corners
            .iter()
            .map(|&p| self.view * self.scaled(p))
            .collect();
        let center = seen.iter().map(|p| p.coords).sum::<Vector3<f64>>();
        // Newell's rule is right for quadrilaterals that are not quite plane.
        let normal: Vector3<f64> = (0..seen.len())
            .map(|i| seen[i].coords.cross(&seen[(i + 1) % seen.len()].coords))
            .sum();
        let length = normal.norm() * center.norm();
        if length > 0.0 {
            -normal.dot(&center) / length
        } else {
            0.0
        }
    }

    /// The cosine for a point with a given normal.
    pub(super) fn facing_normal(&self, at: [f64; 3], normal: [f64; 3]) -> f64 {
        let center = (self.view * self.scaled(at)).coords;
        let scaled = Vector3::from([0, 1, 2].map(|k| normal[k] / self.scale[k]));
        let normal = self.view * scaled;
        let length = normal.norm() * center.norm();
        if length > 0.0 {
            -normal.dot(&center) / length
        } else {
            0.0
        }
    }

    fn scaled(&self, point: [f64; 3]) -> Point3<f64> {
        let [x, y, z] = [0, 1, 2].map(|k| {
            let [low, high] = self.bounds[k];
            (point[k] - f64::midpoint(low, high)) * self.scale[k]
        });
        Point3::new(x, y, z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn camera(bounds: [[f64; 2]; 3]) -> Camera {
        Camera::new(bounds, [30.0, 25.0], [700.0, 700.0])
    }

    proptest! {
        #[test]
        fn the_box_fills_the_picture(
            low in prop::array::uniform3(-9.0f64..9.0),
            sides in prop::array::uniform3(0.0f64..20.0),
            part in prop::array::uniform3(0.0f64..1.0),
        ) {
            let bounds = [0, 1, 2].map(|k| [low[k], low[k] + sides[k]]);
            let camera = camera(bounds);
            let inside = [0, 1, 2].map(|k| {
                let [a, b] = camera.bounds[k];
                a + part[k] * (b - a)
            });
            let seen = camera.see(inside);
            prop_assert!(seen.x >= -1e-6 && seen.x <= camera.size[0] + 1e-6);
            prop_assert!(seen.y >= -1e-6 && seen.y <= camera.size[1] + 1e-6);
        }

        #[test]
        fn a_segment_stays_straight_and_nearer_is_larger(t in 0.1f64..0.9) {
            let camera = camera([[-1.0, 1.0]; 3]);
            let (a, b) = (camera.see([-1.0, 0.5, 0.0]), camera.see([1.0, 0.5, 0.0]));
            let middle = camera.see([-1.0 + 2.0 * t, 0.5, 0.0]);
            let cross = (b.x - a.x) * (middle.y - a.y) - (b.y - a.y) * (middle.x - a.x);
            prop_assert!(cross.abs() < 1e-6);
            // Of two equal rods the one near the eye (with the larger x) looks longer.
            let rod = |x: f64| {
                let (low, high) = (camera.see([x, 0.0, 0.0]), camera.see([x, 0.0, 0.1]));
                (high.x - low.x).hypot(high.y - low.y)
            };
            prop_assert!(rod(1.0) > rod(-1.0));
        }
    }

    #[test]
    fn units_are_equal_unless_the_box_is_thin() {
        assert!(camera([[0.0, 1.0], [0.0, 2.0], [0.0, 4.0]]).equal);
        assert!(!camera([[0.0, 1.0], [0.0, 1.0], [0.0, 40.0]]).equal);
        let flat = camera([[0.0, 1.0], [0.0, 1.0], [3.0, 3.0]]);
        assert!(flat.equal && flat.bounds[2][0] < 3.0 && flat.bounds[2][1] > 3.0);
    }
}
