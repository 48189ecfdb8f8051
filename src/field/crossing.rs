//! A certified zero between two points of opposite sign.

use super::{Field, between, distance};

/// A crossing is enclosed to this part of the segment's length.
const CROSSING: f64 = 1.0 / 1_073_741_824.0;

/// A point with a zero of f within `radius` of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    pub(crate) point: [f64; 3],
    pub(crate) radius: f64,
}

impl Field {
    /// A certified zero on the segment from a, where f < 0, to b, where f ≥ 0.
    pub(crate) fn crossing(&self, mut a: [f64; 3], mut b: [f64; 3]) -> Crossing {
        let length = distance(a, b);
        let goal = length * CROSSING;
        let (mut fa, mut fb) = (self.sums(a).0, self.sums(b).0);
        // Illinois' method on doubles says where to look; the signs that it goes on with are exact.
        let mut side = 0;
        while distance(a, b) > goal {
            let weight = fa / (fa - fb);
            let weight = if weight.is_finite() {
                weight.clamp(0.0, 1.0)
            } else {
                0.5
            };
            // Stepping over the zero on purpose shuts the bracket from the other side, too.
            let nudge = 0.4 * goal / distance(a, b);
            let weight = if side.cmp(&0).is_le() {
                weight + nudge
            } else {
                weight - nudge
            };
            let weight = if weight > 0.0 && weight < 1.0 {
                weight
            } else {
                0.5
            };
            let mut p = between(a, b, weight);
            let is_end = |p: [f64; 3]| distance(p, a) <= 0.0 || distance(p, b) <= 0.0;
            if is_end(p) {
                p = between(a, b, 0.5);
                if is_end(p) {
                    break;
                }
            }
            let value = self.sums(p).0;
            if self.sign(p) < 0 {
                if side < 0 {
                    fb /= 2.0;
                }
                side = -1;
                (a, fa) = (p, value.min(-f64::MIN_POSITIVE));
            } else {
                if side > 0 {
                    fa /= 2.0;
                }
                side = 1;
                (b, fb) = (p, value.max(f64::MIN_POSITIVE));
            }
        }
        let point = between(a, b, 0.5);
        Crossing {
            point,
            radius: distance(a, point).max(distance(b, point)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::tests::sphere;
    use proptest::prelude::*;

    proptest! {
        /// A crossing of the unit sphere lies within its radius of it.
        #[test]
        fn crossings_are_enclosed(b in prop::array::uniform3(1.0f64..2.0)) {
            let f = Field::new(&sphere(1));
            let found = f.crossing([0.1, 0.0, -0.2], b);
            let r = distance(found.point, [0.0; 3]);
            prop_assert!((r - 1.0).abs() <= found.radius + 1e-15);
            prop_assert!(found.radius < 1e-8);
        }
    }
}
