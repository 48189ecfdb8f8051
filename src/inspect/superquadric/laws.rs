//! Laws of the inspection of superquadrics.

use proptest::prelude::*;

use super::*;
use crate::inspect::Inspector;
use crate::intervals::{distance, dot, rationals};
use crate::shape::{ImplicitCurve, ImplicitSurface};

fn rational(n: i64, d: i64) -> Rational {
    Rational::from(n) / Rational::from(d)
}

fn options(tolerance: &str) -> InspectorOptions {
    InspectorOptions::new(tolerance.parse().unwrap())
}

fn plane(axes: [i64; 2], epsilon: Rational, level: i64) -> Superquadric {
    Superquadric::new(axes.map(Rational::from), epsilon, Rational::from(level)).unwrap()
}

fn space(axes: [i64; 3], epsilon: [Rational; 2], level: i64) -> SpaceSuperquadric {
    SpaceSuperquadric::new(axes.map(Rational::from), epsilon, Rational::from(level)).unwrap()
}

fn in_plane(shape: &Superquadric, tolerance: &str) -> SuperquadricInspector {
    SuperquadricInspector::plane(shape, false, &options(tolerance), &Limits::none()).unwrap()
}

fn in_space(shape: &SpaceSuperquadric, tolerance: &str) -> SuperquadricInspector {
    SuperquadricInspector::space(shape, &options(tolerance), &Limits::none()).unwrap()
}

fn at(point: [&str; 3]) -> [Rational; 3] {
    point.map(|q| q.parse().unwrap())
}

/// The least and the largest distance of a point from many points in doubles, and the largest gap between neighbours.
fn extremes(points: &[[f64; 3]], p: [f64; 3]) -> [f64; 2] {
    let distances = points.iter().map(|q| distance(*q, p));
    distances.fold([f64::INFINITY, 0.0], |[least, most], d| {
        [least.min(d), most.max(d)]
    })
}

/// What was found agrees with the points of a dense sample; `gap` is how much farther the nearest sample may be.
fn agrees(found: &Inspection, [least, most]: [f64; 2], gap: f64, tolerance: f64) {
    let DistanceBounds { low, high } = found.distance;
    assert!(low <= least * (1.0 + 1e-12), "{found:?} {least}");
    assert!(high >= least - gap, "{found:?} {least} {gap}");
    assert!(high - low <= 1e-6 * high + 1e-12, "{found:?}");
    if least <= tolerance {
        assert_eq!(found.verdict, Verdict::Inside, "{least}");
        if most > tolerance * (1.0 + 1e-12) {
            assert_eq!(found.curve, Some(true));
        } else if most + gap < tolerance {
            assert_eq!(found.curve, Some(false));
        }
    } else if least - gap > tolerance {
        assert_eq!(found.verdict, Verdict::Outside, "{least}");
    }
}

/// The foot has the certified distance, is on the surface, and is the foot of a perpendicular where the surface is smooth.
fn has_foot(inspector: &SuperquadricInspector, p: [f64; 3], found: &Inspection) {
    let candidate = inspector.foot(&rationals(p));
    let foot = candidate.checked(p, &found.distance).expect("a foot");
    let about = inspector.octant(foot.point.map(|x| Interval::around(x, 1e-12)));
    assert_eq!(
        (inspector.body.norm(about) - Interval::from(1.0)).sign(),
        None
    );
    if let Some(normal) = foot.normal {
        let away: [f64; 3] = std::array::from_fn(|i| p[i] - foot.point[i]);
        let along = dot(away, normal);
        let aside: [f64; 3] = std::array::from_fn(|i| away[i] - along * normal[i]);
        let size = distance(p, [0.0; 3]) + distance(foot.point, [0.0; 3]) + 1.0;
        assert!(dot(aside, aside).sqrt() < 1e-6 * size, "{p:?} {foot:?}");
        if let Some(sign) = found.sign
            && found.distance.low > 1e-9
        {
            assert!(along * f64::from(sign) > 0.0, "{p:?} {foot:?} {found:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    /// The bounds and verdicts of plane superquadrics agree with a dense polyline.
    #[test]
    fn plane_distances_are_those_of_a_polyline(n in 1i64..40, d in 1i64..16, a in 1i64..4, b in 1i64..4, level in 1i64..4, p in prop::array::uniform2(-5.0f64..5.0), tolerance in 1i64..40) {
        let shape = plane([a, b], rational(n, d), level);
        let tolerance = rational(tolerance, 8);
        let inspector = in_plane(&shape, &tolerance.to_string());
        let p = [p[0], p[1], 0.0];
        let found = inspector.inspect(&rationals(p));
        let points: Vec<[f64; 3]> = shape.polyline(4000).iter().map(|[x, y]| [*x, *y, 0.0]).collect();
        let gap = points.windows(2).map(|w| distance(w[0], w[1])).fold(0.0, f64::max);
        agrees(&found, extremes(&points, p), gap, tolerance.to_f64());
        has_foot(&inspector, p, &found);
        let exact = shape.compare(&[p[0], p[1]].map(|x| Rational::try_from(x).unwrap())).unwrap();
        prop_assert_eq!(found.sign, Some(exact as i8));
    }

    /// The bounds and verdicts in space agree with dense points.
    #[test]
    fn distances_in_space_are_those_of_dense_points(e in prop::array::uniform2(2i64..40), d in 8i64..16, axes in prop::array::uniform3(1i64..4), level in 1i64..3, p in prop::array::uniform3(-5.0f64..5.0), tolerance in 1i64..40) {
        let shape = space(axes, e.map(|n| rational(n, d)), level);
        let tolerance = rational(tolerance, 8);
        let inspector = in_space(&shape, &tolerance.to_string());
        let found = inspector.inspect(&rationals(p));
        let [thetas, phis] = shape.angles(60);
        let mut points = Vec::new();
        let mut gap = 0.0f64;
        let mut above: Vec<[f64; 3]> = Vec::new();
        for phi in &phis {
            let row: Vec<[f64; 3]> = thetas.iter().map(|theta| {
                let direction = [phi.sin() * theta.cos(), phi.sin() * theta.sin(), phi.cos()];
                let r = shape.approximate_along(direction);
                direction.map(|x| r * x)
            }).collect();
            let beside = row.windows(2).map(|w| distance(w[0], w[1]));
            let upward = row.iter().zip(&above).map(|(p, q)| distance(*p, *q));
            gap = beside.chain(upward).fold(gap, f64::max);
            points.extend(&row);
            above = row;
        }
        agrees(&found, extremes(&points, p), 2.0 * gap, tolerance.to_f64());
        has_foot(&inspector, p, &found);
        let exact = shape.compare(&rationals(p)).unwrap();
        prop_assert_eq!(found.sign, Some(exact as i8));
    }

    /// Where there is an equation, it gives the same answers.
    #[test]
    fn the_equation_agrees(k in 1i64..4, axes in prop::array::uniform3(1i64..4), p in prop::array::uniform3(-48i64..49), tolerance in 1i64..24) {
        let epsilon = rational(1, k);
        let tolerance = rational(tolerance, 8).to_string();
        let p = p.map(|x| rational(x, 16));
        let shape = plane([axes[0], axes[1]], epsilon.clone(), 1);
        let curve = ImplicitCurve::new(shape.polynomial().unwrap());
        let flat = [p[0].clone(), p[1].clone(), Rational::zero()];
        let pairs = [
            (in_plane(&shape, &tolerance).inspect(&flat), Inspector::plane(&curve, &options(&tolerance), &Limits::none()).unwrap().inspect(&flat)),
            {
                let shape = space(axes, [epsilon.clone(), epsilon], 1);
                let surface = ImplicitSurface::new(shape.polynomial().unwrap());
                (in_space(&shape, &tolerance).inspect(&p), Inspector::surface(&surface, &options(&tolerance), &Limits::none()).unwrap().inspect(&p))
            },
        ];
        for (own, other) in pairs {
            if own.verdict != Verdict::Undecided {
                prop_assert_eq!(own.verdict, other.verdict);
                prop_assert_eq!(own.curve, other.curve);
            }
            prop_assert_eq!(own.sign, other.sign);
            prop_assert!(own.distance.low <= other.distance.high && other.distance.low <= own.distance.high, "{:?} {:?}", own, other);
        }
    }
}

/// Points at the tolerance from a vertex, an edge and a face are inside; those farther by 10^−30 are not.
#[test]
fn points_at_the_tolerance_are_decided_exactly() {
    let face = space([4, 3, 12], [2, 2].map(Rational::from), 1);
    // The distance of the center is 1/√(1/16 + 1/9 + 1/144) = 12/√26.
    let inspector = in_space(&face, "1");
    let found = inspector.inspect(&at(["0", "0", "0"])).distance;
    let exact = 12.0 / 26f64.sqrt();
    assert!(found.low <= exact && exact <= found.high);
    // The cylinder of |x/4| + |y/3| = 1 has the unit normal (3/5, 4/5).
    let diamond = plane([4, 3], Rational::from(2), 1);
    let inspector = in_plane(&diamond, "1/10");
    let on_edge = inspector.inspect(&at(["2.06", "-1.58", "0"]));
    assert_eq!(
        (on_edge.verdict, on_edge.curve),
        (Verdict::Inside, Some(true))
    );
    let vertex = inspector.inspect(&at(["-4.1", "0", "0"]));
    assert_eq!((vertex.verdict, vertex.sign), (Verdict::Inside, Some(1)));
    let farther = inspector.inspect(&at(["-4.100000000001", "0", "0"]));
    assert_eq!(farther.verdict, Verdict::Outside);
    // c^(ε/2) = 8^(1/3) = 2 is rational.
    let scaled = plane([1, 1], rational(2, 3), 8);
    assert_eq!(
        in_plane(&scaled, "1/3")
            .inspect(&at(["7/3", "0", "0"]))
            .verdict,
        Verdict::Inside
    );
    assert_eq!(
        in_plane(&scaled, "1/3").inspect(&at(["0", "2", "0"])).sign,
        Some(0)
    );
}

/// A superquadric that is all inside of the ball does not meet its sphere; if its farthest vertex is at the tolerance, it does.
#[test]
fn the_sphere_is_met_up_to_the_farthest_point() {
    let shape = space([1, 2, 3], [rational(3, 2), rational(5, 2)], 1);
    let curve = |tolerance: &str| {
        in_space(&shape, tolerance)
            .inspect(&at(["0", "0", "-1"]))
            .curve
    };
    assert_eq!(curve("4"), Some(true));
    assert_eq!(curve("3.99"), Some(true));
    assert_eq!(curve("4.01"), Some(false));
}

/// The cylinder over a superquadric.
#[test]
fn a_cylinder_ignores_the_height() {
    let shape = plane([1, 1], rational(7, 10), 1);
    let inspector =
        SuperquadricInspector::plane(&shape, true, &options("1/4"), &Limits::none()).unwrap();
    let point = at(["1.25", "0", "77"]);
    let found = inspector.inspect(&point);
    assert_eq!((found.verdict, found.curve), (Verdict::Inside, Some(true)));
    let foot = inspector.foot(&point).foot;
    assert!(distance(foot.point, [1.0, 0.0, 77.0]) < 1e-9);
    assert!(distance(foot.normal.unwrap(), [1.0, 0.0, 0.0]) < 1e-9);
}

/// Exponents near 0 and large ones: the distance from nearly a square, and from nearly a cross.
#[test]
fn extreme_exponents_are_near_squares_and_crosses() {
    let nearly = |found: Inspection, exact: f64, off: f64| {
        let DistanceBounds { low, high } = found.distance;
        assert!(
            low <= exact + off && exact - off <= high && high - low < 1e-6 * high,
            "{found:?}"
        );
    };
    let square = plane([1, 1], rational(1, 1000), 1);
    nearly(
        in_plane(&square, "1").inspect(&at(["3", "3", "0"])),
        8f64.sqrt(),
        2e-3,
    );
    nearly(
        in_plane(&square, "1").inspect(&at(["0.5", "0", "0"])),
        0.5,
        1e-9,
    );
    let cross = plane([1, 1], Rational::from(1000), 1);
    nearly(
        in_plane(&cross, "1").inspect(&at(["0.5", "0.25", "0"])),
        0.25,
        1e-9,
    );
    nearly(
        in_plane(&cross, "1").inspect(&at(["0", "-3", "0"])),
        2.0,
        1e-9,
    );
    let star = space([1, 1, 1], [1000, 1000].map(Rational::from), 1);
    nearly(
        in_space(&star, "1").inspect(&at(["0.5", "0.25", "0.125"])),
        (0.0625f64 + 0.015_625).sqrt(),
        1e-9,
    );
}
