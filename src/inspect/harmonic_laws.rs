//! Distances from harmonic surfaces against exact points and against the equation.

use proptest::prelude::*;

use super::super::Inspector;
use super::super::cells::surface_of_test as surface;

use super::*;
use crate::implicitize::SquaredHarmonics;
use crate::sphere::{Positivity, positivity};

fn is_positive(surface: &HarmonicSurface) -> bool {
    let found = positivity(surface, &HarmonicPair::new(surface), &Limits::none()).unwrap();
    matches!(found, Positivity::Positive { .. })
}

fn inspector(surface: &HarmonicSurface, tolerance: &Rational) -> HarmonicInspector {
    let options = InspectorOptions::new(tolerance.clone());
    HarmonicInspector::new(surface, is_positive(surface), &options, &Limits::none()).unwrap()
}

fn q(text: &str) -> Rational {
    text.parse().unwrap()
}

fn unit(p: i64, q: i64) -> [Rational; 3] {
    let n = Rational::from(p * p + q * q + 400);
    [40 * p, 40 * q, p * p + q * q - 400].map(|x| Rational::from(x) / &n)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Where R > 0 the zero set of the equation is the surface and the origin.
    #[test]
    fn refined_distances_are_those_of_the_equation(
        list in prop::collection::vec((1usize..4, 0usize..7, -6i64..7), 1..5),
        p in [-300i64..300, -300i64..300, -300i64..300], tolerance in 1i64..90,
    ) {
        let surface = surface(2, &list);
        prop_assume!(surface.degree() > 0 && is_positive(&surface));
        let tolerance = Rational::from(tolerance) / Rational::from(100);
        let ours = inspector(&surface, &tolerance);
        let equation = SquaredHarmonics::new(&surface).unwrap().expand();
        let options = InspectorOptions::new(tolerance);
        let theirs = Inspector::surface(&equation, &options, &Limits::none()).unwrap();
        let p = p.map(|x| Rational::from(x) / Rational::from(100));
        let found = ours.inspect(&p);
        let other = theirs.inspect(&p);
        let rho = p.iter().map(|x| x.to_f64() * x.to_f64()).sum::<f64>().sqrt();
        prop_assume!(found.distance.high < rho);
        prop_assert!(found.verdict != Verdict::Undecided && found.curve.is_some());
        prop_assert!(found.distance.low <= other.distance.high);
        prop_assert!(other.distance.low <= found.distance.high);
        prop_assert!(found.distance.high - found.distance.low <= 1e-6 * found.distance.high);
        if other.verdict != Verdict::Undecided {
            prop_assert_eq!(found.verdict, other.verdict);
        }
        if let (Some(curve), Some(theirs)) = (found.curve, other.curve) {
            // The origin may be on the sphere, too; then the surface goes beyond it.
            prop_assert_eq!(curve, theirs);
        }
    }

    /// Points whose exact distance along the ray bounds the distance, on both sides and very near.
    #[test]
    fn points_near_the_surface_have_a_side(
        list in prop::collection::vec((1usize..12, 0usize..23, -6i64..7), 1..7),
        a in -40i64..40, b in -40i64..40,
        exponent in prop::sample::select(vec![-1i64, -4, -12, -18, -25, -40]), is_outer in any::<bool>(),
        center in [-9i64..9, -9i64..9, -9i64..9],
    ) {
        let center = center.map(|x| Rational::from(x) / Rational::from(7));
        let surface = surface(3, &list).with_center(center.clone());
        prop_assume!(surface.degree() > 0 && is_positive(&surface));
        let d = unit(a, b);
        let r = HarmonicPair::new(&surface).value(&d);
        let off = Rational::from(10).pow(exponent).unwrap();
        let off = if is_outer { off } else { -off };
        let point = |off: &Rational| std::array::from_fn(|i| &d[i] * (&r + off) + &center[i]);
        let inspector = inspector(&surface, &q("1/1000"));
        let found = inspector.inspect(&point(&off));
        prop_assert_eq!(found.sign, Some(off.signum()));
        prop_assert!(found.verdict != Verdict::Undecided);
        prop_assert!(rational(found.distance.low) <= off.abs());
        prop_assert!(found.distance.low > 0.0);
        prop_assert!(found.distance.high - found.distance.low <= 1e-6 * found.distance.high);
        let on = inspector.inspect(&point(&Rational::zero()));
        prop_assert_eq!((on.verdict, on.sign, on.curve), (Verdict::Inside, Some(0), Some(true)));
        prop_assert_eq!(on.distance, DistanceBounds::ZERO);
    }

    /// No exact point of the surface is nearer than the lower bound.
    #[test]
    fn no_point_is_nearer(
        list in prop::collection::vec((1usize..21, 0usize..41, -6i64..7), 1..7),
        p in [-300i64..300, -300i64..300, -300i64..300],
        directions in prop::collection::vec([-60i64..60, -60i64..60], 8),
    ) {
        let surface = surface(2, &list);
        let p = p.map(|x| Rational::from(x) / Rational::from(100));
        let found = inspector(&surface, &q("1/10")).inspect(&p);
        let pair = HarmonicPair::new(&surface);
        let low = rational(found.distance.low);
        let mut farthest = Rational::zero();
        for [a, b] in directions {
            let d = unit(a, b);
            let r = pair.value(&d);
            let square: Rational = (0..3)
                .map(|i| (&d[i] * &r - &p[i]) * (&d[i] * &r - &p[i]))
                .sum();
            prop_assert!(square >= &low * &low);
            farthest = farthest.max(square);
        }
        prop_assert!(found.distance.high.is_finite());
        let inside = found.verdict == Verdict::Inside;
        if inside && farthest >= q("1/100") {
            prop_assert_eq!(found.curve, Some(true));
        }
    }
}

#[test]
fn exact_answers_at_the_tolerance() {
    let limacon = surface(2, &[(1, 1, 5)]);
    assert_eq!(limacon.coefficient(1, 0).to_string(), "1/2");
    let inspector = inspector(&limacon, &q("1/10"));
    let at = |z: &str| inspector.inspect(&[q("0"), q("0"), q(z)]);
    let found = at("2.6");
    assert_eq!(
        (found.verdict, found.curve, found.sign),
        (Verdict::Inside, Some(true), Some(1))
    );
    assert_eq!(
        at("2.60000000000000000000000000001").verdict,
        Verdict::Outside
    );
    assert_eq!(
        at("2.59999999999999999999999999999").verdict,
        Verdict::Inside
    );
    assert_eq!(at("0").sign, Some(-1));
    assert_eq!(at("0").verdict, Verdict::Outside);
    assert!(at("1e40").distance.low > 0.99e40);
}

#[test]
fn spheres_are_exact() {
    let sphere = surface(2, &[]);
    let inspector = inspector(&sphere, &q("1"));
    let at = |x: &str| inspector.inspect(&[q(x), q("0"), q("0")]);
    assert_eq!(at("3").verdict, Verdict::Inside);
    assert_eq!(at("3.0000000000000000000001").verdict, Verdict::Outside);
    assert_eq!(at("1").verdict, Verdict::Inside);
    assert_eq!(at("0.9999999999999999999999").verdict, Verdict::Outside);
    assert_eq!(
        (at("2").sign, at("2").distance),
        (Some(0), DistanceBounds::ZERO)
    );
    let near = at("2.000000000000000000000000000001").distance;
    assert!(near.low > 0.999e-30 && near.high < 1.001e-30);
    assert_eq!(at("0").sign, Some(-1));
}
