//! The arcs against the exact counts of real roots, and against distances that are known.

use proptest::prelude::*;

use super::*;
use crate::inspect::arcs::series;

fn q(text: &str) -> Rational {
    text.parse().invariant("the test writes numbers")
}

fn ratio(p: i64, over: i64) -> Rational {
    Rational::from(p) / Rational::from(over)
}

fn inspector(curve: &EllipticSeries, tolerance: &Rational) -> CurveInspector<2> {
    let options = InspectorOptions::new(tolerance.clone());
    let made = CurveInspector::new(&curve.to_plane_curve(), &options, &Limits::none());
    made.invariant("the tolerance is positive")
}

fn elliptic(numbers: &[i64], scale: &Rational) -> EllipticSeries {
    let [[a, b], [c, d]] = series::<2>(numbers);
    EllipticSeries::new([a, b, c, d].map(|list| list.iter().map(|c| c * scale).collect()))
}

/// Both ways give the same answers; bounds hold the same distance. Whether the arcs alone were enough.
fn agree(inspector: &CurveInspector<2>, point: &[Rational; 2]) -> bool {
    let slow = inspector.inspect_by_counts(point);
    let fast = inspector.inspect(point);
    let near = point.each_ref().map(Rational::to_f64);
    let from_table = inspector.inspect_near(near, &|| point.clone());
    for found in [fast, from_table] {
        assert_eq!(
            (found.verdict, found.curve),
            (slow.verdict, slow.curve),
            "{point:?}: {found:?}, {slow:?}"
        );
        assert!(
            found.distance.low <= slow.distance.high && slow.distance.low <= found.distance.high,
            "{point:?}: {found:?}, {slow:?}"
        );
        let width = found.distance.high - found.distance.low;
        let slow_width = slow.distance.high - slow.distance.low;
        assert!(
            width <= slow_width.max(1e-6 * found.distance.high),
            "{found:?}, {slow:?}"
        );
    }
    let arcs = inspector
        .arcs
        .as_ref()
        .invariant("the curve is a Fourier series");
    inspector.by_arcs(arcs, near, 0.0).is_some()
}

/// The point of the curve at t = 0.
fn first_point(curve: &EllipticSeries) -> [Rational; 2] {
    [curve.x_cos(), curve.y_cos()].map(|list| list.iter().cloned().sum())
}

/// The series of t + φ, with cos φ = 3/5 and sin φ = 4/5.
fn turned(curve: &EllipticSeries) -> EllipticSeries {
    let (mut c, mut s) = (Rational::one(), Rational::zero());
    let (cos, sin) = (ratio(3, 5), ratio(4, 5));
    let mut lists: [Vec<Rational>; 4] = Default::default();
    for n in 0..=curve.harmonics() {
        for k in [0, 2] {
            let [a, b] = [k, k + 1].map(|k| &curve.lists()[k][n]);
            // cos(nt + nφ) and sin(nt + nφ)
            lists[k].push(a * &c + b * &s);
            lists[k + 1].push(b * &c - a * &s);
        }
        (c, s) = (&c * &cos - &s * &sin, &s * &cos + &c * &sin);
    }
    EllipticSeries::new(lists)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    #[test]
    fn elliptic_series_agree_with_counts(
        numbers in prop::collection::vec(-300i64..300, 1..24),
        points in prop::collection::vec([-400i64..400, -400i64..400], 3),
        tolerance in 1i64..400,
        power in prop::sample::select(vec!["1", "1e-100", "1e100", "1e-320", "1e6"]),
        reach in prop::sample::select(vec!["1/4", "1", "1000000"]),
    ) {
        let scale = q(power);
        let inspector = inspector(&elliptic(&numbers, &scale), &(ratio(tolerance, 10) * &scale));
        for point in points {
            let point = point.map(|x| ratio(x, 7) * q(reach) * &scale);
            if inspector.arcs.is_some() {
                agree(&inspector, &point);
            }
        }
    }

    #[test]
    fn radii_agree_with_counts(
        cos in prop::collection::vec(-30i64..30, 1..9),
        sin in prop::collection::vec(-30i64..30, 1..9),
        center in [-1000i64..1000, -1000i64..1000],
        points in prop::collection::vec([-100i64..100, -100i64..100], 3),
        tolerance in 1i64..60,
    ) {
        let list = |list: &[i64]| list.iter().map(|c| ratio(*c, 9)).collect();
        let center = center.map(|c| ratio(c, 3));
        let radius = FourierRadius::new(list(&cos), list(&sin)).with_center(center.clone());
        let options = InspectorOptions::new(ratio(tolerance, 10));
        let inspector = CurveInspector::radius(&radius, &options, &Limits::none())
            .invariant("the tolerance is positive");
        for point in points {
            let point = [0, 1].map(|i| ratio(point[i], 11) + &center[i]);
            agree(&inspector, &point);
        }
        agree(&inspector, &center);
    }

    /// Points at a known distance: p = C(0) + d n with the rational unit normal n.
    #[test]
    fn points_at_the_tolerance_are_inside(
        numbers in prop::collection::vec(-300i64..300, 1..16),
        tangent in 1i64..500,
        distance in 1i64..2000,
        side in prop::sample::select(vec![-1i64, 1]),
    ) {
        // The tangent at t = 0 becomes (3, 4) times a number.
        let mut lists = elliptic(&numbers, &Rational::one()).lists().clone();
        for (k, wanted) in [(1, 3 * tangent), (3, 4 * tangent)] {
            lists[k].resize(lists[k].len().max(2), Rational::zero());
            let others = (2..lists[k].len()).map(|n| &lists[k][n] * &Rational::from(n as i64));
            lists[k][1] = ratio(wanted, 10) - others.sum::<Rational>();
        }
        let curve = EllipticSeries::new(lists);
        let foot = first_point(&curve);
        let distance = ratio(distance, 1000);
        let away = [ratio(-4 * side, 5), ratio(3 * side, 5)].map(|n| n * &distance);
        let point = [0, 1].map(|i| &foot[i] + &away[i]);
        for curve in [turned(&curve), curve] {
            let at = inspector(&curve, &distance);
            prop_assert_eq!(at.inspect(&point).verdict, Verdict::Inside);
            agree(&at, &point);
            let less = &distance * (Rational::one() - Rational::from_dyadic(1.into(), -70));
            agree(&inspector(&curve, &less), &point);
            // On the curve itself.
            let on = at.inspect(&foot);
            prop_assert_eq!(on.verdict, Verdict::Inside);
            prop_assert!(on.distance.low <= 0.0);
            agree(&at, &foot);
        }
    }
}

#[test]
fn long_series_agree_with_counts() {
    let numbers: Vec<i64> = (0..244)
        .map(|k| (k * k * 37 + 11 * k) % 501 - 250)
        .collect();
    let curve = elliptic(&numbers, &Rational::one());
    assert_eq!(curve.harmonics(), 60);
    let inspector = inspector(&curve, &q("1/2"));
    for point in [["0", "0"], ["-3.5", "12.25"], ["1/3", "40"]] {
        assert!(agree(&inspector, &point.map(q)));
    }
}

#[test]
fn circles_about_their_centers() {
    let circle: FourierRadius = "r = 3/7".parse().invariant("this is a radius");
    let circle = circle.with_center([q("1/3"), q("-5")]);
    for (tolerance, verdict) in [
        ("3/7", Verdict::Inside),
        ("3/7 - 1e-40", Verdict::Outside),
        ("3/7 + 1e-40", Verdict::Inside),
    ] {
        let mut parts = tolerance.split(' ');
        let first = q(parts.next().invariant("there is a number"));
        let tolerance = match (parts.next(), parts.next()) {
            (Some("-"), Some(second)) => first - q(second),
            (Some(_), Some(second)) => first + q(second),
            _ => first,
        };
        let options = InspectorOptions::new(tolerance.clone());
        let inspector = CurveInspector::radius(&circle, &options, &Limits::none())
            .invariant("the tolerance is positive");
        let found = inspector.inspect(&[q("1/3"), q("-5")]);
        assert_eq!(found.verdict, verdict);
        assert_eq!(found.curve, Some(tolerance == q("3/7")));
        assert!(found.distance.high - found.distance.low <= 1e-6);
    }
}

#[test]
fn doubles_decide_nearly_all_points() {
    let radius: FourierRadius = "r = 1 + 1/5*cos(3t) - 1/7*sin(8t) + 1/30*cos(21t)"
        .parse()
        .invariant("this is a radius");
    let options = InspectorOptions::new(q("1/20"));
    let inspector = CurveInspector::radius(&radius, &options, &Limits::none())
        .invariant("the tolerance is positive");
    let arcs = inspector
        .arcs
        .as_ref()
        .invariant("a radius is a Fourier series");
    for k in 0..4000 {
        let (t, r) = (2.4 * part(k, 1), 0.02 + 1.5 * part(k, 4000));
        let near = [r * t.cos(), r * t.sin()];
        assert!(inspector.by_arcs(arcs, near, 1e-16).is_some(), "{near:?}");
    }
}

#[test]
fn a_space_curve_is_compared_by_arcs() {
    let [x, y, z] = series::<3>(&[5, 40, -70, 20, 31, 100, -11, 50, 77, 10, 25, -35]);
    let f = |[cos, sin]: &[Vec<Rational>; 2]| {
        let pair = EllipticSeries::new([cos.clone(), sin.clone(), vec![], vec![]]);
        let [x, _] = pair.to_plane_curve().coordinates().clone();
        x
    };
    let parameter = crate::shape::Parameter::angle("t", Rational::one());
    let curve = ParametricCurve::new(parameter, [&x, &y, &z].map(f));
    let options = InspectorOptions::new(q("2"));
    let inspector = CurveInspector::new(&curve, &options, &Limits::none())
        .invariant("the tolerance is positive");
    assert!(inspector.arcs.is_some());
    for k in 0..40 {
        let point = [3, 5, 7].map(|m| ratio((k * m * m) % 41 - 20, 3));
        let (slow, fast) = (
            inspector.inspect_by_counts(&point),
            inspector.inspect(&point),
        );
        assert_eq!((slow.verdict, slow.curve), (fast.verdict, fast.curve));
        assert!(fast.distance.low <= slow.distance.high);
        assert!(slow.distance.low <= fast.distance.high);
    }
}
