//! The laws of `inspector.rs`.

use super::*;
use crate::poly::Ring;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, ..ProptestConfig::default() })]

    /// Points whose coordinates are no doubles are compared with a plane x = c, at a tolerance near their distance. The verdict
    /// is the exact one and the bounds hold the exact distance, however the point is given.
    #[test]
    fn points_between_doubles_are_judged_exactly(x in (-4000i64..4000, 1i64..1000), c in -3.0f64..3.0, ulps in -3i64..4) {
        let x = Rational::from(x.0) / Rational::from(x.1);
        let p = [x.clone(), Rational::from(1) / Rational::from(3), Rational::zero()];
        let distance = (&x - &rational(c)).abs();
        let near = distance.to_f64();
        prop_assume!(near > 1e-6);
        let tolerance = (0..ulps.abs()).fold(near, |d, _| if ulps > 0 { d.next_up() } else { d.next_down() });
        let plane = SparsePolynomial::<3>::variable(0).minus(&SparsePolynomial::constant(rational(c)));
        let options = InspectorOptions::new(rational(tolerance)).reach(Some(8.0)).digits(14).cubes(1000);
        let inspector = Inspector::new(Kind::Surface, &plane,vec![(plane.clone(), 1)], &options, &Limits::none()).unwrap();
        let doubles = p.each_ref().map(Rational::to_f64);
        for found in [inspector.inspect(&p), inspector.inspect_near(doubles, &|| p.clone())] {
            let is_inside = distance <= rational(tolerance);
            prop_assert_eq!(found.verdict, if is_inside { Verdict::Inside } else { Verdict::Outside });
            prop_assert_eq!(found.curve, Some(is_inside));
            // Beyond the reach there is no upper bound.
            let bounds = Interval::between(found.distance.low, found.distance.high);
            prop_assert!(bounds.contains(&distance), "{found:?}");
        }
    }
}

/// A point beyond the largest double is undecided, and an infinite reach or tolerance is refused.
#[test]
fn what_is_no_double_is_undecided() {
    let plane = SparsePolynomial::<3>::variable(0);
    let options = InspectorOptions::new(Rational::one()).reach(Some(1.0));
    let inspector = Inspector::new(
        Kind::Surface,
        &plane,
        vec![(plane.clone(), 1)],
        &options,
        &Limits::none(),
    )
    .unwrap();
    let far = Rational::from(10).pow(400).unwrap();
    let found = inspector.inspect(&[far, Rational::zero(), Rational::zero()]);
    assert_eq!(found, Inspection::UNKNOWN);
    let options = options.reach(Some(f64::INFINITY));
    let refused = Inspector::new(
        Kind::Surface,
        &plane,
        vec![(plane.clone(), 1)],
        &options,
        &Limits::none(),
    );
    assert!(matches!(refused, Err(Error::Usage(_))));
}
