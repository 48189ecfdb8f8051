//! Inspection (Theorem 8): verdicts and certified distances against distances that are known exactly.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use stellate::exact::Rational;
use stellate::inspect::{Inspection, Inspector, InspectorOptions, Verdict};
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::shape::Form;

fn inspector_within(text: &str, tolerance: &Rational, reach: f64) -> Inspector {
    let options = InspectorOptions::new(tolerance.clone())
        .reach(Some(reach))
        .cubes(20_000);
    match parse_form(text, "<form>", Numbers::Exact).unwrap() {
        Form::Surface(surface) => Inspector::surface(&surface, &options, &Limits::none()),
        Form::Curve(curve) => Inspector::plane(&curve, &options, &Limits::none()),
        other => panic!("{other:?}"),
    }
    .unwrap()
}

fn inspector(text: &str, tolerance: &str) -> Inspector {
    inspector_within(text, &tolerance.parse().unwrap(), 0.0)
}

fn exact(p: [f64; 3]) -> [Rational; 3] {
    p.map(|x| Rational::try_from(x).unwrap())
}

fn point(text: &str) -> [Rational; 3] {
    let all: Vec<Rational> = text.split(',').map(|q| q.trim().parse().unwrap()).collect();
    all.try_into().unwrap()
}

/// (inside, curve), or what is undecided.
fn answer(found: &Inspection) -> (Verdict, Option<bool>) {
    (found.verdict, found.curve)
}

const INSIDE: (Verdict, Option<bool>) = (Verdict::Inside, Some(true));
const OUTSIDE: (Verdict, Option<bool>) = (Verdict::Outside, Some(false));

/// The distance is known to about 1e-14.
fn holds(found: &Inspection, distance: f64) -> bool {
    let slack = 1e-13 * distance.max(1.0);
    let bounds = found.distance;
    bounds.low <= distance + slack
        && distance - slack <= bounds.high
        && bounds.high - bounds.low <= 1.01e-6 * bounds.high + slack
}

/// Surfaces with their distances from p.
fn known_distances([x, y, z]: [f64; 3]) -> [(&'static str, f64); 5] {
    let ring = x.hypot(y) - 2.0;
    [
        ("x^2 + y^2 + z^2 = 1", (x.hypot(y).hypot(z) - 1.0).abs()),
        ("x^2 + y^2 + 0z = 1", (x.hypot(y) - 1.0).abs()),
        (
            "(x + 2*y - 2*z - 1)^3*(x^2 + y^2 + z^2 + 1)",
            (x + 2.0 * y - 2.0 * z - 1.0).abs() / 3.0,
        ),
        (
            "(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)",
            (ring.hypot(z) - 1.0).abs(),
        ),
        (
            "(x - 1)^2*(z + 1) = 0*y",
            (x - 1.0).abs().min((z + 1.0).abs()),
        ),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    /// Bounds of the distance, wherever the point is, but not where all points of a circle are equally near.
    #[test]
    fn distances_to_known_surfaces(p in prop::array::uniform3(-2.5f64..2.5)) {
        let [x, y, z] = p;
        let ring = x.hypot(y) - 2.0;
        prop_assume!(x.hypot(y) > 0.3 && x.hypot(z) > 0.3 && ring.hypot(z) > 0.3);
        for (text, distance) in known_distances(p) {
            let found = inspector_within(text, &Rational::from(1), 6.0).inspect(&exact(p));
            prop_assert!(holds(&found, distance), "{} {:?}: {:?} {}", text, p, found, distance);
        }
    }

    /// The verdict a little to either side of the distance.
    #[test]
    fn verdicts_beside_the_distance(p in prop::array::uniform3(-2.5f64..2.5), off in prop::sample::select(vec![1e-3, 1e-7, 1e-12])) {
        for (text, distance) in known_distances(p) {
            prop_assume!(distance > 1e-2 && distance < 0.9);
            for (d, expected) in [(distance * (1.0 + off), INSIDE), (distance * (1.0 - off), OUTSIDE)] {
                let tolerance = Rational::try_from(d).unwrap();
                let found = inspector_within(text, &tolerance, 0.0).inspect(&exact(p));
                prop_assert_eq!(answer(&found), expected, "{} {:?} {}: {:?}", text, p, d, found);
            }
        }
    }

    /// Out along the normal of an ellipsoid the foot is the nearest point.
    #[test]
    fn ellipsoids(theta in 0.0f64..6.3, phi in 0.0f64..3.1, t in 0.001f64..1.0) {
        let q = [2.0 * phi.sin() * theta.cos(), phi.sin() * theta.sin(), 0.5 * phi.cos()];
        let n = [q[0] / 4.0, q[1], 4.0 * q[2]];
        let length = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
        let p = [0, 1, 2].map(|i| q[i] + t * n[i] / length);
        let found = inspector_within("x^2/4 + y^2 + 4*z^2 = 1", &Rational::from(1), 4.0).inspect(&exact(p));
        prop_assert!(holds(&found, t), "{:?} {}", found, t);
    }
}

/// (a, b, c)/e with a² + b² + c² = e², from a quaternion.
fn unit_vector([m, n, p, q]: [i64; 4]) -> Option<[Rational; 3]> {
    let norm = Rational::from(m * m + n * n + p * p + q * q).recip()?;
    let all = [
        m * m + n * n - p * p - q * q,
        2 * (m * q + n * p),
        2 * (n * q - m * p),
    ];
    Some(all.map(|k: i64| Rational::from(k) * &norm))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, ..ProptestConfig::default() })]

    /// Points at an exactly known distance, and tolerances that differ from it by at most 2^−60: every verdict is the exact
    /// comparison, and the bounds hold the exact distance. Planes and doubles; spheres and cylinders and points at a rational distance
    /// from their middle.
    #[test]
    fn verdicts_within_2_to_the_minus_60_of_the_tolerance(quaternion in prop::array::uniform4(-9i64..10), p in prop::array::uniform3(-2.0f64..2.0), radius in (100i64..1900, 900i64..1100), part in -64i64..65) {
        let Some(unit) = unit_vector(quaternion) else { return Ok(()); };
        let small = Rational::from(part) * Rational::from(2).pow(-66).unwrap();
        let [a, b, c] = &unit;
        let plane = format!("({a})*x + ({b})*y + ({c})*z = 2");
        let on_plane = unit.iter().zip(exact(p)).map(|(u, x)| u * &x).sum::<Rational>() - Rational::from(2);
        let length = Rational::from(radius.0) / Rational::from(radius.1);
        let on_sphere = unit.each_ref().map(|u| u * &length);
        let from_sphere = (length - Rational::from(1)).abs();
        let on_cylinder = [&on_sphere[0] * &Rational::from(1), on_sphere[1].clone(), Rational::from(7)];
        let mut cases = vec![
            (plane.as_str(), exact(p), on_plane.abs()),
            ("x^2 + y^2 + z^2 = 1", on_sphere.clone(), from_sphere.clone()),
        ];
        if unit[2].is_zero() {
            cases.push(("x^2 + y^2 = 1", on_cylinder, from_sphere));
        }
        for (text, p, distance) in cases {
            let tolerance = &distance + &small;
            // Within 1 of the sphere's middle the ball may hold all of it.
            if !(1e-3..0.9).contains(&tolerance.to_f64()) {
                continue;
            }
            let found = inspector_within(text, &tolerance, 4.0).inspect(&p);
            let expected = if part >= 0 { INSIDE } else { OUTSIDE };
            prop_assert_eq!(answer(&found), expected, "{} {:?} {}: {:?}", text, p, tolerance, found);
            let bound = |x: f64| Rational::try_from(x).unwrap();
            prop_assert!(bound(found.distance.low) <= distance, "{} {:?} {:?}", text, p, found);
            prop_assert!(distance <= bound(found.distance.high), "{} {:?} {:?}", text, p, found);
        }
    }
}

/// Vectors (a, b, c)/e with a² + b² + c² = e².
fn rational_unit_vectors() -> Vec<[Rational; 3]> {
    let mut found = Vec::new();
    for (m, n, p, q) in [
        (1, 0, 2, 1),
        (2, 1, 1, 3),
        (3, 1, 0, 2),
        (5, 2, 3, 1),
        (1, 4, 2, 7),
    ] {
        let norm = m * m + n * n + p * p + q * q;
        let all = [
            m * m + n * n - p * p - q * q,
            2 * (m * q + n * p),
            2 * (n * q - m * p),
        ];
        found.push(all.map(|k: i64| Rational::from(k) / Rational::from(norm)));
    }
    found
}

/// Points exactly at the distance d, and 10⁻³⁰ to either side of it: what doubles cannot tell.
#[test]
fn exactly_at_the_tolerance() {
    let d: Rational = "3/17".parse().unwrap();
    let tiny: Rational = "1e-30".parse().unwrap();
    for unit in rational_unit_vectors() {
        for side in [1, -1] {
            for (off, expected) in [(0, INSIDE), (1, OUTSIDE), (-1, INSIDE)] {
                let distance = &d + &(&tiny * &Rational::from(off));
                let signed = &distance * &Rational::from(side);
                // The unit sphere: p = (1 ± distance) u
                let p = unit.each_ref().map(|u| u * &(Rational::one() + &signed));
                let found = inspector_within("x^2 + y^2 + z^2 = 1", &d, 0.0).inspect(&p);
                assert_eq!(answer(&found), expected, "sphere {unit:?} {off}");
                // A plane with this normal
                let [a, b, c] = &unit;
                let plane = format!("({a})*x + ({b})*y + ({c})*z = 2");
                let p = unit.each_ref().map(|u| u * &(Rational::from(2) + &signed));
                let found = inspector_within(&plane, &d, 0.0).inspect(&p);
                assert_eq!(answer(&found), expected, "plane {unit:?} {off}");
                // The torus about (2, 0, 0) in the plane y = 0 and about 2(3/5, 4/5, 0)
                let out = Rational::from(2) + &unit[0] * &(Rational::one() + &signed);
                let z = &unit[2] * &(Rational::one() + &signed);
                let in_plane = &unit[1];
                if in_plane.is_zero() {
                    let three: Rational = "3/5".parse().unwrap();
                    let four: Rational = "4/5".parse().unwrap();
                    let p = [&out * &three, &out * &four, z];
                    let torus = "(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)";
                    let found = inspector_within(torus, &d, 0.0).inspect(&p);
                    assert_eq!(answer(&found), expected, "torus {unit:?} {off}");
                }
            }
        }
    }
}

/// An ellipsoid with a rational foot and a rational normal.
#[test]
fn an_ellipsoid_touched_exactly() {
    // x²/4 + y² + 4z² = 1 at (6/5, 4/5, 0): the gradient is (3/5, 8/5, 0), of length √73/5; at (2, 0, 0) it is (1, 0, 0).
    for (p, expected) in [
        ("2.125, 0, 0", INSIDE),
        ("2.1250000000000000001, 0, 0", OUTSIDE),
        ("2.1249999999999999999, 0, 0", INSIDE),
        ("0, 0, 0.625", INSIDE),
        ("0, 0, 0.62500000000000000000001", OUTSIDE),
    ] {
        let found = inspector("x^2/4 + y^2 + 4z^2 = 1", "1/8").inspect(&point(p));
        assert_eq!(answer(&found), expected, "{p}");
    }
}

/// Two feet with irrational coordinates, and a circle of them, exactly at the distance: from (0, 0, 5/4) to the parabola
/// z = x² it is 1, at x² = 3/4.
#[test]
fn irrational_feet() {
    for surface in ["z = x^2 + 0*y", "z = x^2 + y^2", "z = x^2 + 1/3*y^2"] {
        // The third one is farther away along y.
        for (p, expected) in [
            ("0, 0, 1.25", INSIDE),
            ("0, 0, 1.2501", OUTSIDE),
            ("0, 0, 1.2499", INSIDE),
            ("0, 0, 1.25000000000001", OUTSIDE),
            ("0, 0, 1.24999999999999", INSIDE),
        ] {
            let found = inspector(surface, "1").inspect(&point(p));
            assert_eq!(answer(&found), expected, "{surface} {p}: {found:?}");
        }
    }
    let found = inspector("z = x^2 + 2*y^2", "3/4").inspect(&point("0, 0, 1.25"));
    assert_eq!(answer(&found), INSIDE);
}

/// The two predicates differ where a whole component is inside the ball.
#[test]
fn a_small_sphere_inside_the_ball() {
    let small = "(x - 1/10)^2 + y^2 + z^2 = 1/10000";
    let found = inspector(small, "0.2").inspect(&point("0, 0, 0"));
    assert_eq!(answer(&found), (Verdict::Inside, Some(false)));
    assert!(found.distance.low <= 0.09 && 0.09 <= found.distance.high);
    // Its last point is exactly on the sphere of radius 0.11.
    assert_eq!(
        answer(&inspector(small, "0.11").inspect(&point("0, 0, 0"))),
        INSIDE
    );
    let beyond = inspector(small, "0.1100000000000000000001").inspect(&point("0, 0, 0"));
    assert_eq!(answer(&beyond), (Verdict::Inside, Some(false)));
    // In the plane likewise.
    let circle = "(x - 1/10)^2 + y^2 = 1/10000";
    let found = inspector(circle, "0.2").inspect(&point("0, 0, 0"));
    assert_eq!(answer(&found), (Verdict::Inside, Some(false)));
}

#[test]
fn degenerate_surfaces() {
    let cases = [
        // An isolated point is the whole set.
        ("x^2 + y^2 + z^2", "1", "1, 0, 0", INSIDE),
        (
            "x^2 + y^2 + z^2",
            "1",
            "1.0000000000000000000001, 0, 0",
            OUTSIDE,
        ),
        (
            "x^2 + y^2 + z^2",
            "1",
            "0.5, 0, 0",
            (Verdict::Inside, Some(false)),
        ),
        (
            "x^2 + y^2 + z^2",
            "1",
            "0, 0, 0",
            (Verdict::Inside, Some(false)),
        ),
        // A line, and a circle, without a change of sign.
        ("x^2 + y^2 + 0z", "1/2", "0.3, 0.4, 7", INSIDE),
        ("x^2 + y^2 + 0z", "1/2", "0.3, 0.4000001, 7", OUTSIDE),
        ("(x^2 + y^2 - 1)^2 + z^2", "1/2", "1.25, 0, 0", INSIDE),
        ("(x^2 + y^2 - 1)^2 + z^2", "1/2", "1.75, 0, 0", OUTSIDE),
        // A pipe inside the ball: every sphere that reaches the disc meets it. And a plane curve in the disc of its points.
        ("x^2 + y^2 + 0z = 1/100", "1/2", "0.1, 0, 3", INSIDE),
        ("(x^2 + y^2 - 1/100)*(z - 5)", "1/2", "0.1, 0, 3", INSIDE),
        (
            "(x^2 + y^2 + z^2 - 1/100)*(y - 5)",
            "1/2",
            "0.1, 0, 0",
            (Verdict::Inside, Some(false)),
        ),
        // Isolated points with irrational coordinates.
        (
            "(x^2 - 2)^2 + y^2 + z^2",
            "1/10",
            "1.4, 0, 0",
            (Verdict::Inside, Some(false)),
        ),
        ("(x^2 - 2)^2 + y^2 + z^2", "1/100", "1.4, 0, 0", OUTSIDE),
        // No real points.
        ("x^2 + y^2 + z^2 + 1", "100", "3, 4, 5", OUTSIDE),
        ("x^4 + y^4 + z^4 + 1e-9", "1", "0, 0, 0.1", OUTSIDE),
        // Repeated factors, and a factor without points.
        (
            "(x^2 + y^2 + z^2 - 1)^4*(x^2 + y^2 + z^2 + 1)",
            "1/10",
            "0.66, 0.88, 0",
            INSIDE,
        ),
        (
            "(x^2 + y^2 + z^2 - 1)^4*(x^2 + y^2 + z^2 + 1)",
            "1/10",
            "0.66, 0.88000000000000001, 0",
            OUTSIDE,
        ),
        // On the surface, and at a singular point of it: the tip of a cone.
        ("x^2 + y^2 + z^2 = 1", "1/10", "0.6, 0.8, 0", INSIDE),
        ("x^2 + y^2 = z^2", "1/10", "0, 0, 0", INSIDE),
        // All points of the surface are equally near.
        ("x^2 + y^2 + z^2 = 1", "1", "0, 0, 0", INSIDE),
        (
            "x^2 + y^2 + z^2 = 1",
            "2",
            "0, 0, 0",
            (Verdict::Inside, Some(false)),
        ),
        ("x^2 + y^2 + z^2 = 1", "0.999999", "0, 0, 0", OUTSIDE),
        ("x^2 + y^2 + 0z = 1", "1", "0, 0, 5", INSIDE),
        ("x^2 + y^2 + 0z = 1", "0.999999", "0, 0, 5", OUTSIDE),
        ("(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)", "1", "0, 0, 0", INSIDE),
        (
            "(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)",
            "0.999",
            "0, 0, 0",
            OUTSIDE,
        ),
        (
            "(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)",
            "1.001",
            "0, 0, 0",
            INSIDE,
        ),
    ];
    for (surface, tolerance, p, expected) in cases {
        let found = inspector(surface, tolerance).inspect(&point(p));
        assert_eq!(
            answer(&found),
            expected,
            "{surface} {tolerance} {p}: {found:?}"
        );
    }
}

/// Example 12: the pipe. The point is on it; the paper inspects it with the tolerance 0.1.
#[test]
fn example_12() {
    let pipe = inspector("x^2 + y^2 + 0z = 1", "0.1");
    let found = pipe.inspect(&point("0.8, 0.6, 0"));
    assert_eq!(answer(&found), INSIDE);
    assert_eq!((found.distance.low, found.distance.high), (0.0, 0.0));
    assert_eq!(answer(&pipe.inspect(&point("0.88, 0.66, 3"))), INSIDE);
    assert_eq!(
        answer(&pipe.inspect(&point("0.88, 0.6600000001, 3"))),
        OUTSIDE
    );
}

#[test]
fn beyond_reach_nothing_is_claimed() {
    let far = inspector("x^2 + y^2 + z^2 = 1", "3").inspect(&point("5, 0, 0"));
    assert_eq!(answer(&far), OUTSIDE);
    assert!(far.distance.low >= 3.0 && far.distance.low <= 4.0 && far.distance.high.is_infinite());
    let sphere = inspector_within("x^2 + y^2 + z^2 = 1", &"3".parse().unwrap(), 10.0);
    assert!(holds(&sphere.inspect(&point("5, 0, 0")), 4.0));
    let none = inspector("x^2 + y^2 + z^2 = -1", "2").inspect(&point("0, 0, 0"));
    assert!(none.distance.low >= 2.0 && none.distance.high.is_infinite());
}

/// The line 3x + 4y = 7 passes the point (3/2^k, 7/4) at a distance of 9/(5·2^k), far below what doubles resolve of cubes there.
#[test]
fn distances_far_below_the_coordinates_are_bounded_rightly() {
    let line = inspector("3x + 4y = 7", "0.1");
    for k in (1..1000).step_by(7) {
        let small = Rational::from(2).pow(-k).unwrap();
        let x = Rational::from(3) * &small;
        let found = line.inspect(&[x, "7/4".parse().unwrap(), Rational::zero()]);
        let distance = Rational::from(9) / Rational::from(5) * small;
        let [low, high] = [found.distance.low, found.distance.high];
        assert!(Rational::try_from(low).unwrap() <= distance, "{k}: {low}");
        if high.is_finite() {
            assert!(distance <= Rational::try_from(high).unwrap(), "{k}: {high}");
        }
        assert_eq!(
            found.verdict == Verdict::Inside,
            distance <= "1/10".parse().unwrap(),
            "{k}"
        );
    }
}
