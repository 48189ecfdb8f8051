//! Points whose distance doubles determine except for rounding: the exact expansion at the foot determines the rest.

use super::exact::{self, Answer};
use super::inspector::Inspector;
use super::known::{PartialInspection, Point};
use super::quadric::Quadric;
use crate::exact::Rational;
use crate::intervals::{Field, Interval, distance};

/// Points nearer to the surface than this part of the reach are not left to doubles,
const NEARLY_ON: f64 = 1e-6;
/// nor those nearer than this part of their coordinates, whose distances have few digits in doubles.
const FEW_DIGITS: f64 = 1e-9;

impl Inspector {
    /// The foot of a point whose distance doubles determine except for rounding: then the exact expansion determines the rest.
    pub(super) fn foot_of_nearly_known(
        &self,
        field: &Field,
        p: &Point,
        known: &PartialInspection,
    ) -> Option<[f64; 3]> {
        let bounds = known.bounds;
        let size = p.near.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let nearly_on = (NEARLY_ON * self.goal.reach).max(FEW_DIGITS * size);
        let is_on = |q: [f64; 3]| distance(q, p.near) < nearly_on;
        known.foot.filter(|q| {
            (bounds.low > 0.9 * bounds.high || is_on(*q)) && self.is_exact_possible(field)
        })
    }

    /// Improves bounds that rounding keeps apart, such as those of a distance of 10⁻¹² from a plane, by the exact expansion at the
    /// foot.
    pub(super) fn by_refined_foot(&self, field: &Field, p: &Point, known: &mut PartialInspection) {
        if self.is_close(&known.bounds) {
            return;
        }
        let Some(start) = self.foot_of_nearly_known(field, p, known) else {
            return;
        };
        let sign = field.polynomial().evaluate(p.exactly()).signum();
        let found = exact::enclose(field, p.exactly(), start, sign, &self.limits);
        if let Some([low, high]) = found {
            let root = |square: &Rational| Interval::from(square).or_zero().sqrt();
            known.bounds.low = known.bounds.low.max(root(&low).low());
            known.bounds.high = known.bounds.high.min(root(&high).high());
        }
    }

    /// Bounds of the distance of a point from a quadric or a conic, by exact arithmetic, to nearly all digits of a double.
    pub(super) fn by_quadric(&self, field: &Field, p: &Point, known: &mut PartialInspection) {
        let Some(quadric) = Quadric::of(field) else {
            return;
        };
        if let Some(found) = quadric.nearest(p.exactly()) {
            self.learn(known, found.bounds(), 0.0);
            known.foot = Some(found.foot);
        }
    }

    /// Decides by the exact expansion at the foot.
    pub(super) fn by_exact_foot(
        &self,
        field: &Field,
        p: &Point,
        start: [f64; 3],
        sign: i8,
        known: &mut PartialInspection,
    ) {
        let root = |square: &Rational| Interval::from(square).or_zero().sqrt().low();
        let found = exact::decide(
            field,
            p.exactly(),
            &self.tolerance,
            start,
            sign,
            None,
            &self.limits,
        );
        match found {
            Some(Answer::Outside { low }) => {
                known.inside = Some(false);
                known.bounds.low = known.bounds.low.max(root(&low).max(self.around[0]));
            }
            Some(Answer::Inside {
                low,
                high,
                touches,
                foot,
            }) => {
                known.has_zero(*foot, touches, &high, self.around[1]);
                known.bounds.low = known.bounds.low.max(root(&low));
            }
            None => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::exact::Rational;
    use crate::inspect::{Inspector, InspectorOptions, Verdict};
    use crate::limits::Limits;
    use crate::shape::ImplicitSurface;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100))]

        /// Points next to a plane and to a sphere, at known distances of some 10⁻¹²: six digits of the distance are known without a
        /// single cube, on both sides of the tolerance.
        #[test]
        fn tiny_distances_have_their_digits(
            x in -500i64..500, y in -500i64..500, off in -2000i64..2000, of_sphere: bool,
        ) {
            prop_assume!(off != 0);
            let tenth = |k: i64| Rational::from(10).pow(-k).unwrap();
            let off = Rational::from(off) * tenth(15);
            let (text, point): (&str, [Rational; 3]) = if of_sphere {
                // A rational direction.
                let [x, y] = [x, y].map(|s| Rational::from(s) / Rational::from(100));
                let square = &x * &x + &y * &y;
                let below = Rational::one() + &square;
                let two = Rational::from(2);
                let unit = [&x * &two / &below, &y * &two / &below, (Rational::one() - square) / &below];
                ("x^2 + y^2 + z^2 = 1", unit.map(|u| u * (Rational::one() + &off)))
            } else {
                let [x, y] = [x, y].map(|s| Rational::from(s) / Rational::from(100));
                let z = (Rational::from(13) - &x * Rational::from(3) - &y * Rational::from(4)) / Rational::from(12);
                let normal = [3, 4, 12].map(|n| Rational::from(n) / Rational::from(13));
                let foot = [x, y, z];
                ("3x + 4y + 12z = 13", std::array::from_fn(|i| &foot[i] + &normal[i] * &off))
            };
            let surface: ImplicitSurface = text.parse().unwrap();
            let options = InspectorOptions::new(tenth(12)).cubes(0);
            let inspector = Inspector::surface(&surface, &options, &Limits::none()).unwrap();
            let found = inspector.inspect(&point);
            let distance = off.abs();
            let is_inside = distance <= tenth(12);
            prop_assert_eq!(found.verdict, if is_inside { Verdict::Inside } else { Verdict::Outside });
            prop_assert_eq!(found.sign, Some(off.signum()));
            let [low, high] = [found.distance.low, found.distance.high].map(|x| Rational::try_from(x).unwrap());
            prop_assert!(low <= distance && distance <= high, "{found:?}");
            prop_assert!(high - &low <= distance * tenth(6), "{found:?}");
        }
    }
}
