//! A certified zero between two points of opposite sign.

use super::interval::separation;
use super::{Field, between, distance};

/// The ends are brought together to this part of the length of the segment.
const CROSSING: f64 = 1.0 / 1_073_741_824.0;

/// A point with a zero of f within `radius` of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    pub(crate) point: [f64; 3],
    pub(crate) radius: f64,
}

impl Field {
    /// A certified zero near the segment from a to b. The caller must ensure that f(a) < 0 and f(b) ≥ 0.
    ///
    /// Lemma. f has a zero within `radius` of `point`.
    /// Proof. The loop keeps f(a) < 0 ≤ f(b), by exact signs, so f has a zero on the segment from a to b. Both ends are within
    /// `radius` of `point`, and a ball that holds two points holds the segment between them.
    /// Laws: `crossings_are_enclosed`, `a_crossing_of_neighbours_holds_both`.
    pub(crate) fn crossing(&self, mut a: [f64; 3], mut b: [f64; 3]) -> Crossing {
        let length = distance(a, b);
        let goal = length * CROSSING;
        let (mut fa, mut fb) = (self.value(a), self.value(b));
        // The Illinois method on doubles proposes the points; the signs of f at these points are exact. `side` is −1 if a was
        // replaced last, 1 if b was.
        let mut side = 0;
        while distance(a, b) > goal {
            let weight = fa / (fa - fb);
            let weight = if weight.is_finite() {
                weight.clamp(0.0, 1.0)
            } else {
                0.5
            };
            // A step slightly beyond the expected zero makes the next step replace the other end, so both ends approach it.
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
            let value = self.value(p);
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
            radius: separation(a, point).max(separation(b, point)).high(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::intervals::tests::sphere;
    use crate::intervals::{rational, rationals};
    use crate::poly::{Ring, SparsePolynomial};
    use proptest::prelude::*;

    proptest! {
        /// A crossing of the unit sphere lies within its radius of it, exactly.
        #[test]
        fn crossings_are_enclosed(b in prop::array::uniform3(1.0f64..2.0)) {
            let f = Field::new(&sphere(1));
            let found = f.crossing([0.1, 0.0, -0.2], b);
            prop_assert!(found.radius < 1e-8);
            let square: Rational = rationals(found.point).iter().map(|x| x * x).sum();
            let [inner, outer] = [-found.radius, found.radius].map(|r| Rational::one() + rational(r));
            prop_assert!(&inner * &inner <= square && square <= &outer * &outer);
        }
    }

    proptest! {
        /// If the ends are only a few units in the last place apart, the zero is still within the radius.
        #[test]
        fn a_crossing_of_neighbours_holds_both(x in 0.5f64..1.0, y in -1.0f64..1.0, ulps in 1u32..40) {
            // f = x − c, with c in the middle between the two ends.
            let a = [x, y, 0.1];
            let b = [x + f64::from(ulps) * f64::EPSILON, y + f64::from(ulps) * f64::EPSILON, 0.3];
            let c = (rational(a[0]) + rational(b[0])) / Rational::from(2);
            let f = SparsePolynomial::<3>::variable(0).minus(&SparsePolynomial::constant(c.clone()));
            let found = Field::new(&f).crossing(a, b);
            prop_assert!((rational(found.point[0]) - c).abs() <= rational(found.radius));
        }
    }
}
