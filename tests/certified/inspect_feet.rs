//! The feet of inspected points: known ones, and laws that hold for every form.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use stellate::exact::Rational;
use stellate::inspect::Foot;
use stellate::language::Numbers;
use stellate::verb::{self, Given, InspectionOptions, InspectionTask, Work};

fn task(form: &str, dimension: usize) -> InspectionTask {
    let given = Given::read(form, Numbers::Exact).unwrap();
    let options = InspectionOptions::default().tolerance("1/10".parse().unwrap());
    verb::inspect(given, dimension, &options, &Work::default()).unwrap()
}

fn foot_of(task: &InspectionTask, p: [f64; 3]) -> Option<Foot> {
    let p = p.map(|x| Rational::try_from(x).unwrap());
    task.foot(&p, &task.point(&p))
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn along(a: [f64; 3], t: f64, b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + t * b[i])
}

fn length(a: [f64; 3]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn assert_near(found: [f64; 3], expected: [f64; 3], what: &str) {
    assert!(
        length(minus(found, expected)) <= 4e-14 * length(expected).max(1.0),
        "{what}: {found:?}, not {expected:?}"
    );
}

/// The foot and its normal; the normal is compared without its sign if `is_signed` is false.
fn assert_foot(
    form: &str,
    dimension: usize,
    p: [f64; 3],
    point: [f64; 3],
    normal: Option<[f64; 3]>,
    is_signed: bool,
) {
    let found = foot_of(&task(form, dimension), p);
    let found = found.unwrap_or_else(|| panic!("{form} {p:?}: no foot"));
    assert_near(found.point, point, form);
    match (found.normal, normal) {
        (Some(a), Some(b)) => {
            let turned = !is_signed && a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>() < 0.0;
            assert_near(if turned { a.map(|x| -x) } else { a }, b, form);
        }
        (a, b) => assert_eq!(a, b, "{form} {p:?}"),
    }
}

#[test]
fn feet_on_circles_and_spheres_are_radial() {
    let plane = [
        "x^2 + y^2 = 25",
        "r = 5",
        "x = 5*cos(t); y = 5*sin(t)",
        "x = 5*sin(t); y = 5*cos(t)",
        "(x^2 + y^2 - 25)*(x^2 + y^2 - 400)^2",
    ];
    for form in plane {
        // Outside, inside, and exactly on the circle.
        for size in [2.0, 1.2, 1.0, 0.8, 0.1] {
            let p = [3.0 * size, 4.0 * size, 0.0];
            assert_foot(form, 2, p, [3.0, 4.0, 0.0], Some([0.6, 0.8, 0.0]), true);
            let above = [p[0], p[1], 7.0];
            assert_foot(form, 3, above, [3.0, 4.0, 7.0], Some([0.6, 0.8, 0.0]), true);
        }
    }
    let space = [
        "x^2 + y^2 + z^2 = 9",
        "R = 3",
        "superquadric 3d a=3,3,3 e=1,1",
    ];
    for form in space {
        for size in [3.0, 1.5, 1.0, 0.25] {
            let normal = [1.0 / 3.0, -2.0 / 3.0, 2.0 / 3.0];
            let p = [size, -2.0 * size, 2.0 * size];
            assert_foot(form, 3, p, [1.0, -2.0, 2.0], Some(normal), true);
        }
    }
    let patch = "x = 3*cos(u)*sin(v); y = 3*sin(u)*sin(v); z = 3*cos(v)";
    let normal = [1.0 / 3.0, -2.0 / 3.0, 2.0 / 3.0];
    let found = foot_of(&task(patch, 3), [2.0, -4.0, 4.0]).unwrap();
    assert!(length(minus(found.point, [1.0, -2.0, 2.0])) < 1e-11);
    assert!(
        length(minus(found.normal.unwrap(), normal)) < 1e-11
            || length(along(found.normal.unwrap(), 1.0, normal)) < 1e-11
    );
    // A circle in space has no normal.
    let circle = "x = 5*cos(t); y = 5*sin(t); z = 1";
    assert_foot(circle, 3, [6.0, 8.0, -4.0], [3.0, 4.0, 1.0], None, true);
}

#[test]
fn feet_are_in_original_coordinates() {
    let form = "# center: 10, -3\nx^2 + y^2 = 25";
    assert_foot(
        form,
        2,
        [16.0, 5.0, 0.0],
        [13.0, 1.0, 0.0],
        Some([0.6, 0.8, 0.0]),
        true,
    );
}

#[test]
fn curves_without_sides_have_feet() {
    // The foot of (0, 3.5) on y = x²: x² = 3, one of the two.
    let found = foot_of(&task("x = t; y = t^2", 2), [0.1, 3.5, 0.0]).unwrap();
    let t = found.point[0];
    assert!((found.point[1] - t * t).abs() < 1e-14 * t * t && t > 1.7);
    // (t − 0.1) + 2t(t² − 3.5) = 0
    assert!((t - 0.1 + 2.0 * t * (t * t - 3.5)).abs() < 1e-13);
    let n = found.normal.unwrap();
    assert!((n[0] + n[1] * 2.0 * t).abs() < 1e-14, "{n:?}");
    // The end of the half line x = y, where the curve turns back.
    let found = foot_of(&task("x = t^2; y = t^2", 2), [-5.0, -5.0, 0.0]).unwrap();
    assert!(length(found.point) < 1e-15, "{found:?}");
    assert_eq!(found.normal, None);
}

#[test]
fn singular_points_have_no_normal() {
    for (form, p) in [
        // A cusp, an isolated point, and a node from itself.
        ("x^3 = y^2", [-1.0, 0.0, 0.0]),
        ("x^2 + y^2 = x^3", [-1.0, 0.0, 0.0]),
        ("x^2*(x + 1) = y^2", [0.0, 0.0, 0.0]),
        // An isolated point at which all second derivatives are 0, from itself and from beside it.
        ("(x^2 + y^2)^2 = x^5", [0.0, 0.0, 0.0]),
        ("(x^2 + y^2)^2 = x^5", [0.01, 0.0, 0.0]),
        ("x = t^2; y = t^3", [-1.0, 0.0, 0.0]),
    ] {
        assert_foot(form, 2, p, [0.0; 3], None, true);
    }
    // The tip of a cone, from above in its axis' polar cone.
    assert_foot("x^2 + y^2 = z^3", 3, [0.0, 0.0, -2.0], [0.0; 3], None, true);
    // The polynomial does not grow to either side.
    assert_foot(
        "(x^2 + y^2 - 25)^2",
        2,
        [6.0, 8.0, 0.0],
        [3.0, 4.0, 0.0],
        None,
        true,
    );
}

#[test]
fn normals_of_equations_point_to_where_the_polynomial_grows() {
    let form = "(x^2 + y^2 - 1)*(x^2 + y^2 - 25)";
    assert_foot(
        form,
        2,
        [6.0, 8.0, 0.0],
        [3.0, 4.0, 0.0],
        Some([0.6, 0.8, 0.0]),
        true,
    );
    assert_foot(
        form,
        2,
        [1.2, 1.6, 0.0],
        [0.6, 0.8, 0.0],
        Some([-0.6, -0.8, 0.0]),
        true,
    );
}

#[test]
fn doubles_need_not_keep_a_digit_of_the_polynomial() {
    let form = "(x - 1000000)^2 + (y - 2000000)^2 = 25";
    for size in [2.0, 1.25, 0.5] {
        let p = [1e6 + 3.0 * size, 2e6 + 4.0 * size, 0.0];
        let found = foot_of(&task(form, 2), p).unwrap();
        assert!(
            length(minus(found.point, [1_000_003.0, 2_000_004.0, 0.0])) < 1e-9,
            "{found:?}"
        );
        assert!(
            length(minus(found.normal.unwrap(), [0.6, 0.8, 0.0])) < 1e-9,
            "{found:?}"
        );
    }
    // The same ellipse there and about the origin, where doubles are good enough.
    let far = task("((x - 1000000)/2)^2 + (y - 2000000)^2 = 4", 2);
    let near = task("x^2/4 + y^2 = 4", 2);
    for p in [[6.0, 5.0, 0.0], [1.0, -0.5, 0.0], [-3.0, 9.0, 0.0]] {
        let expected = foot_of(&near, p).unwrap();
        let moved = [1e6, 2e6, 0.0];
        let found = foot_of(&far, along(p, 1.0, moved)).unwrap();
        assert!(
            length(minus(minus(found.point, moved), expected.point)) < 2e-9,
            "{p:?} {found:?}"
        );
        assert!(
            length(minus(found.normal.unwrap(), expected.normal.unwrap())) < 2e-9,
            "{p:?}"
        );
    }
}

#[test]
fn where_two_factors_meet_there_is_no_normal() {
    assert_foot("x*y = 0", 2, [0.0; 3], [0.0; 3], None, true);
    assert_foot(
        "x*y = 0",
        2,
        [3.0, 1.0, 0.0],
        [3.0, 0.0, 0.0],
        Some([0.0, 1.0, 0.0]),
        true,
    );
    assert_foot(
        "x*y = 0",
        2,
        [-3.0, 1.0, 0.0],
        [-3.0, 0.0, 0.0],
        Some([0.0, -1.0, 0.0]),
        true,
    );
}

#[test]
fn a_point_beyond_the_reach_has_no_foot() {
    let given = Given::read("x^2 + y^2 = 1", Numbers::Exact).unwrap();
    let options = InspectionOptions::default()
        .tolerance("1/10".parse().unwrap())
        .reach(Some(1.0));
    let task = verb::inspect(given, 2, &options, &Work::default()).unwrap();
    assert_eq!(foot_of(&task, [5.0, 0.0, 0.0]), None);
    assert!(foot_of(&task, [1.5, 0.0, 0.0]).is_some());
}

/// Forms with sides, with the number of coordinates and a size of the points.
const SIDED: [(&str, usize, f64); 14] = [
    ("x^2/4 + y^2 = 1", 2, 2.0),
    ("x^4 + y^4 = x*y/2 + 1", 2, 1.5),
    ("r = 1 + 1/5*cos(3t) - 1/9*sin(5t)", 2, 1.5),
    ("x = 3*cos(t) + cos(3t)/4; y = sin(t) + sin(2t)/3", 2, 3.0),
    ("x = sin(t); y = sin(2t)", 2, 1.5),
    ("superquadric 2d a=1,2 e=1/2", 2, 2.0),
    ("x^4 + y^4 + z^4 = 1", 3, 1.5),
    ("(x^2 + y^2 + z^2 + 3)^2 = 16*(x^2 + y^2)", 3, 3.0),
    ("R = 10 + Y(2,0)/3", 3, 12.0),
    ("R = 2 + Y(3,2)/40 - Y(1,-1)/5", 3, 3.0),
    ("superquadric 3d a=1,2,1 e=1/2,1", 3, 2.0),
    ("superquadric 2d a=1,2 e=0.7", 2, 2.0),
    ("superquadric 3d a=1,2,1 e=0.7,1.3", 3, 2.0),
    ("x^2 + 2*y^2 + 3*z^2 + x*y*z/3 = 2", 3, 1.2),
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    /// A foot is on the form, at the certified distance, in the direction of its normal; and beside it, along the normal, are the
    /// two sides.
    #[test]
    fn feet_are_the_nearest_points(which in 0..SIDED.len(), v in prop::array::uniform3(-1.0f64..1.0)) {
        let (form, dimension, size) = SIDED[which];
        let task = task(form, dimension);
        let mut p = v.map(|x| size * x);
        if dimension == 2 {
            p[2] = 0.0;
        }
        let inspection = task.of_doubles(p);
        let found = foot_of(&task, p);
        prop_assert!(found.is_some(), "{form} {p:?} {inspection:?}");
        let found = found.unwrap();
        let away = minus(p, found.point);
        let d = length(away);
        let [low, high] = [inspection.distance.low, inspection.distance.high];
        prop_assert!(low - 1e-12 * size <= d && d <= high + 1e-12 * size, "{form} {p:?} {found:?} {inspection:?}");
        prop_assert!(task.of_doubles(found.point).distance.high <= 1e-14 * size, "{form} {p:?} {found:?}");
        prop_assert!(found.normal.is_some(), "{form} {p:?} {found:?}");
        let n = found.normal.unwrap();
        prop_assert!((length(n) - 1.0).abs() < 1e-14);
        let dot: f64 = (0..3).map(|i| n[i] * away[i]).sum();
        let across = length(along(away, -dot, n));
        prop_assert!(across <= 1e-12 * size, "{form} {p:?} {found:?} {across}");
        let sign = f64::from(inspection.sign.unwrap());
        prop_assert!((dot - sign * d).abs() <= 1e-12 * size, "{form} {p:?} {found:?}");
        let beside = [1.0, -1.0].map(|s| task.side_of_doubles(along(found.point, s * 1e-7 * size, n)));
        prop_assert_eq!(beside, [Some(1), Some(-1)], "{} {:?} {:?}", form, p, found);
        let signed = inspection.signed_distance().unwrap();
        prop_assert!(signed[0] <= signed[1] && signed[0] - 1e-12 * size <= sign * d && sign * d <= signed[1] + 1e-12 * size);
    }
}
