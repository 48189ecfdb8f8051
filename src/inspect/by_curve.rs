//! Points against a factor whose real zeros are a curve: the common zeros of two polynomials.

use super::DistanceBounds;
use super::common_zeros::CommonZeros;
use super::distance::Goal;
use super::exact::{exact_difference, squared_length};
use super::far::{GROWTHS, SHARE};
use super::inspector::Inspector;
use super::known::{PartialInspection, Point};
use crate::arcs::CommonZero;
use crate::intervals::{Field, Interval};

/// Bounds in doubles do not become much closer than this part of the distance.
const FINEST: f64 = 1e-14;

impl Inspector {
    /// Decides a point by the curve of common zeros; `None` if it does not decide the point.
    pub(super) fn by_curve(
        &self,
        curve: &CommonZeros,
        field: &Field,
        p: &Point,
    ) -> Option<PartialInspection> {
        let mut known = PartialInspection::NOTHING;
        if self.is_coarse(p.near) {
            known.is_blurred = true;
            return Some(known);
        }
        let mut foot = self.nearest_on_curve(curve, field, p, self.goal.relative, &mut known);
        if known.inside.is_none() {
            let better = self.nearest_on_curve(curve, field, p, FINEST, &mut known);
            foot = better.or(foot);
        }
        if known.bounds.low <= 0.0 && curve.is_zero(p.exactly()) {
            known.bounds = DistanceBounds::ZERO;
            known.inside = Some(true);
        }
        if known.inside.is_none()
            && let Some(foot) = &foot
        {
            // The nearest common zero may have simple coordinates.
            let simple = curve.simple(foot)?;
            let square = squared_length(&exact_difference(p.exactly(), &simple));
            let touches = square == &self.tolerance * &self.tolerance;
            let is_inside = square <= &self.tolerance * &self.tolerance;
            if !is_inside {
                return None;
            }
            known.has_zero(simple, touches, &square, self.around[1]);
        }
        known.inside?;
        known.foot = foot.map(|foot| foot.position);
        known.curve = match (known.inside, &foot) {
            (Some(false), _) => Some(false),
            _ if known.curve.is_some() => known.curve,
            (_, Some(foot)) if curve.leaves(foot, p.around(), self.around()) => Some(true),
            _ => self.sphere_meets(field, p, &known),
        };
        Some(known)
    }

    fn around(&self) -> Interval {
        Interval::between(self.around[0], self.around[1])
    }

    /// The nearest common zero that was found, with bounds of its distance.
    fn nearest_on_curve(
        &self,
        curve: &CommonZeros,
        field: &Field,
        p: &Point,
        relative: f64,
        known: &mut PartialInspection,
    ) -> Option<CommonZero> {
        let slack = Interval::from(p.slack);
        let mut reach = self.goal.reach;
        let mut foot = None;
        for _ in 0..=GROWTHS {
            let goal = Goal {
                reach: (Interval::from(reach) + slack).high(),
                tolerance: 0.0,
                relative,
                cubes: self.cubes_for(field) / SHARE,
            };
            let outer = DistanceBounds {
                low: (Interval::from(known.bounds.low) - slack).or_zero().low(),
                high: f64::INFINITY,
            };
            let found = curve.nearest(p.near, outer, goal, &self.limits);
            self.learn(known, found.bounds, p.slack);
            foot = found.foot.or(foot);
            let is_enough = self.asked.is_some() || known.bounds.high <= reach;
            if is_enough || self.limits.check().is_err() {
                break;
            }
            reach = match known.bounds.high {
                high if high.is_finite() => (Interval::from(high) * (1.0 + 1e-9)).high(),
                _ => 4.0 * reach,
            };
        }
        foot
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::exact::Rational;
    use crate::inspect::{Inspection, InspectorOptions, Verdict};
    use crate::intervals::{distance, rationals};
    use crate::language::{Numbers, parse_form};
    use crate::limits::Limits;
    use crate::shape::Form;

    fn inspector(form: &str, tolerance: &Rational) -> Inspector {
        let Ok(Form::Surface(surface)) = parse_form(form, "<form>", Numbers::Exact) else {
            panic!("{form} is a surface")
        };
        let options = InspectorOptions::new(tolerance.clone());
        Inspector::surface(&surface, &options, &Limits::none()).expect("a surface")
    }

    fn is_near(found: &Inspection, exact: f64) {
        let DistanceBounds { low, high } = found.distance;
        let off = 1e-15 * exact.max(1.0);
        assert!(
            low <= exact + off && exact - off <= high,
            "{found:?} {exact}"
        );
        assert!(high - low <= 1e-6 * high, "{found:?}");
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

        /// The circle of radius r as one equation: verdicts, distances and the sphere's criterion are those of elementary geometry.
        #[test]
        fn circles_in_space_have_their_distances(r in 1i32..5, weight in 1i32..9, p in prop::array::uniform3(-6.0f64..6.0), tolerance in 1i64..40) {
            let tolerance = Rational::from(tolerance) / Rational::from(8);
            let inspector = inspector(&format!("(x^2+y^2-{})^2 + {weight}*z^2 = 0", r * r), &tolerance);
            let found = inspector.inspect(&rationals(p));
            let rho = p[0].hypot(p[1]);
            let [least, most] = [-1.0, 1.0].map(|side| (rho + side * f64::from(r)).hypot(p[2]));
            is_near(&found, least);
            let d = tolerance.to_f64();
            let verdict = if least <= d { Verdict::Inside } else { Verdict::Outside };
            prop_assert_eq!(found.verdict, verdict);
            prop_assert_eq!(found.curve, Some(least <= d && d <= most));
            prop_assert_eq!(found.sign, Some(1));
            let foot = inspector.foot(&rationals(p), &found).unwrap_or_else(|| panic!("{found:?}"));
            prop_assert!((distance(foot.point, p) - least).abs() < 1e-6 * least);
            prop_assert!(foot.normal.is_none());
        }

        /// A twisted cubic in an equation of degree 6, against many of its points.
        #[test]
        fn twisted_cubics_have_their_distances(p in prop::array::uniform3(-2.0f64..2.0), slope in 1i32..4) {
            let inspector = inspector(&format!("(y-x^2)^2 + 3*(z-{slope}*x^3)^2 = 0"), &Rational::one());
            let found = inspector.inspect(&rationals(p));
            let points = (-200_000..=200_000).map(|k| {
                let t = f64::from(k) / 100_000.0;
                [t, t * t, f64::from(slope) * t * t * t]
            });
            let least = points.map(|q| distance(q, p)).fold(f64::INFINITY, f64::min);
            let DistanceBounds { low, high } = found.distance;
            prop_assert!(low <= least && least - 1e-3 <= high && high - low <= 1e-6 * high, "{:?} {}", found, least);
        }
    }

    /// Lines and isolated points, in which f is 0 without a change of its sign, have their distances.
    #[test]
    fn zeros_without_a_change_of_sign_have_distances() {
        let tolerance = Rational::one() / Rational::from(10);
        for (form, p, exact) in [
            ("x^2 + y^2 + 0*z = 0", [3.0, 4.0, 7.0], 5.0),
            ("(x-1)^2 + 2*y^2 + 0*z = 0", [1.0, 0.75, -2.0], 0.75),
            ("(x^2-2)^2 + y^2 + 0*z = 0", [0.0, 0.0, 1.0], 2f64.sqrt()),
            ("x^2 + y^2 + z^2 = 0", [2.0, 3.0, 6.0], 7.0),
            ("x^2*(x-1) = z^2 + y^2", [0.0, 0.25, 0.0], 0.25),
        ] {
            let inspector = inspector(form, &tolerance);
            let found = inspector.inspect(&rationals(p));
            assert_eq!(found.verdict, Verdict::Outside, "{form}");
            is_near(&found, exact);
            let foot = inspector.foot(&rationals(p), &found).expect(form);
            assert!(
                (distance(foot.point, p) - exact).abs() < 1e-6 * exact,
                "{form}: {foot:?}"
            );
        }
        let plane = |form: &str, p: [f64; 2]| {
            let Ok(Form::Curve(curve)) = parse_form(form, "<form>", Numbers::Exact) else {
                panic!("{form} is a curve")
            };
            let options = InspectorOptions::new(tolerance.clone());
            let inspector = Inspector::plane(&curve, &options, &Limits::none());
            inspector
                .expect("a curve")
                .inspect(&rationals([p[0], p[1], 0.0]))
        };
        is_near(&plane("x^2 + y^2 = 0", [3.0, 4.0]), 5.0);
        is_near(&plane("y^2 = (x-1)^2*(x-2)", [1.0, 0.25]), 0.25);
    }

    /// Rays from a point miss a thin ellipsoid; its distance is known all the same.
    #[test]
    fn thin_surfaces_have_distances() {
        let inspector = inspector("x^2/9 + y^2/4 + 10000*z^2 = 1", &Rational::one());
        let mut random = crate::modular::SplitMix(1);
        for _ in 0..100 {
            let p = [0; 3].map(|_| {
                f64::from(u16::try_from(random.next() >> 48).expect("16 bits")) / 8192.0 - 4.0
            });
            let found = inspector.inspect(&rationals(p));
            // The ellipsoid is within 1/100 of the disc in the plane z = 0.
            let points = (0..40_000).map(|k| {
                let (radius, angle) = (
                    f64::from(k / 400) / 99.0,
                    f64::from(k % 400) * std::f64::consts::TAU / 400.0,
                );
                [3.0 * radius * angle.cos(), 2.0 * radius * angle.sin(), 0.0]
            });
            let least = points.map(|q| distance(p, q)).fold(f64::INFINITY, f64::min);
            let DistanceBounds { low, high } = found.distance;
            assert!(
                low <= least && least <= high + 0.06 && high - low <= 1e-6 * high,
                "{p:?} {found:?} {least}"
            );
        }
    }

    /// Far out on a line, where doubles do not tell points within the tolerance apart, the distance is known, and at once.
    #[test]
    fn points_far_out_on_lines_are_decided() {
        for (form, tolerance, p, exact) in [
            ("x^2+y^2+0*z=0", "1/1000000000", ["0", "0", "4000000"], 0.0),
            (
                "x^2+y^2+0*z=0",
                "1/10",
                ["1/20", "0", "100000000000000000"],
                0.05,
            ),
            (
                "x^2+y^2+0*z=0",
                "1/10",
                ["1", "1", "490982691000000000"],
                2f64.sqrt(),
            ),
            (
                "(x-500000)^2+(y-4000000)^2+0*z=0",
                "1/10",
                ["500000", "4000000", "1000000000000000"],
                0.0,
            ),
            ("(x-y)^2+(z-x)^2=0", "1/10", ["100000000000000000"; 3], 0.0),
            (
                "(x-y)^2+(z-x)^2=0",
                "1/10",
                [
                    "100000000000000003",
                    "100000000000000000",
                    "100000000000000000",
                ],
                6f64.sqrt(),
            ),
        ] {
            let inspector = inspector(form, &tolerance.parse().expect("a number"));
            let point = p.map(|c| c.parse().expect("a number"));
            let start = std::time::Instant::now();
            let found = inspector.inspect(&point);
            assert!(start.elapsed().as_secs() < 10, "{form}: {p:?}");
            is_near(&found, exact);
            let foot = inspector.foot(&point, &found);
            assert!(exact > 0.0 || foot.is_some(), "{form}: {p:?}");
        }
    }

    /// A point exactly at the tolerance is inside, and so is one on the curve; one on the axis is as far from all points of the circle.
    #[test]
    fn degenerate_points_are_decided() {
        let tolerance = Rational::one() / Rational::from(10);
        let circle = inspector("(x^2+y^2-1)^2 + z^2 = 0", &tolerance);
        let at = |x: &str, y: &str, z: &str| {
            circle.inspect(&[x, y, z].map(|q| q.parse().expect("a number")))
        };
        assert_eq!(at("1.1", "0", "0").verdict, Verdict::Inside);
        assert_eq!(at("0.66", "0.88", "0").curve, Some(true));
        assert_eq!(at("0.66", "0.880000000001", "0").verdict, Verdict::Outside);
        let on = at("0.6", "-0.8", "0");
        assert_eq!(
            (on.verdict, on.sign, on.distance),
            (Verdict::Inside, Some(0), DistanceBounds::ZERO)
        );
        let middle = at("0", "0", "3/4");
        assert_eq!(middle.verdict, Verdict::Outside);
        let DistanceBounds { low, high } = middle.distance;
        assert!(
            low <= 1.25 && 1.25 <= high && high - low < 1e-2,
            "{middle:?}"
        );
        // With a plane beside it, the nearer one counts.
        let both = inspector("((x^2+y^2-1)^2 + z^2)*(x-3) = 0", &tolerance);
        is_near(&both.inspect(&rationals([2.5, 0.0, 0.0])), 0.5);
        is_near(&both.inspect(&rationals([1.5, 0.0, 0.0])), 0.5);
        is_near(&both.inspect(&rationals([1.25, 0.0, 0.0])), 0.25);
    }
}
