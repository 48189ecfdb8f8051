//! Inspection is of the form that was given: not of the zero set of its equation, which can have more points.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]
#![expect(clippy::float_cmp, reason = "exact zeros are compared")]

use proptest::prelude::*;
use stellate::exact::Rational;
use stellate::inspect::{Inspection, Verdict};
use stellate::language::Numbers;
use stellate::shape::{Form, FourierRadius};
use stellate::verb::{self, Given, InspectionOptions, InspectionTask, Work};

fn rational(text: &str) -> Rational {
    text.parse().unwrap()
}

fn task(form: &str, dimension: usize, tolerance: &str) -> InspectionTask {
    let given = Given::read(form, Numbers::Exact).unwrap();
    let options = InspectionOptions::default().tolerance(rational(tolerance));
    verb::inspect(given, dimension, &options, &Work::default()).unwrap()
}

fn inspect(form: &str, tolerance: &str, point: &str) -> Inspection {
    let coordinates: Vec<&str> = point.split(',').collect();
    let mut at = [Rational::zero(), Rational::zero(), Rational::zero()];
    for (value, text) in at.iter_mut().zip(&coordinates) {
        *value = rational(text);
    }
    task(form, coordinates.len(), tolerance).point(&at)
}

fn assert_distance(found: &Inspection, distance: f64) {
    let [low, high] = [found.distance.low, found.distance.high];
    assert!(
        low <= distance * (1.0 + 1e-12) && distance <= high * (1.0 + 1e-12),
        "{found:?}"
    );
    assert!(high - low <= 1e-6 * high, "{found:?}");
}

#[test]
fn what_only_the_equation_has_is_not_accepted() {
    // The origin is an isolated zero of the polynomial; the curve is 0.8 away.
    let found = inspect("r = 1 + 1/5*cos(3*t)", "0.1", "0,0");
    assert_eq!(found.verdict, Verdict::Outside);
    assert_distance(&found, 0.8);
    // The line x = y, of which the curve is a half.
    let found = inspect("x = t^2; y = t^2", "0.1", "-5,-5");
    assert_eq!(found.verdict, Verdict::Outside);
    assert_distance(&found, 50f64.sqrt());
    // (−1, 0) is an isolated zero of the equation, of t = ±i; the nearest point of the curve is the origin.
    let found = inspect("x = t^2; y = t^3 + t", "0.1", "-1,0");
    assert_eq!(found.verdict, Verdict::Outside);
    assert_distance(&found, 1.0);
    // The plane x = z, of which the patch is a half.
    let found = inspect("x = u^2; y = v; z = u^2", "0.1", "-5,0,-5");
    assert_eq!(found.verdict, Verdict::Outside);
    assert!(
        found.distance.low >= 0.1 && found.distance.high >= 7.07,
        "{found:?}"
    );
    // The equations themselves are answered as what they are.
    assert_eq!(
        inspect("x - y = 0", "0.1", "-5,-5").verdict,
        Verdict::Inside
    );
}

#[test]
fn distances_at_the_tolerance_are_decided_exactly() {
    for (form, point, distance) in [
        ("r = 1", "3,4", "4"),
        ("r = 1", "3/10,4/10", "1/2"),
        ("x = 3*cos(t); y = 3*sin(t)", "5,0", "2"),
        ("x = t; y = 2", "7,1/3", "5/3"),
        ("x = cos(t); y = sin(t); z = 1", "3,4,1", "4"),
        ("r = 2*cos(t)", "1,2", "1"),
    ] {
        let found = inspect(form, distance, point);
        assert_eq!(
            (found.verdict, found.curve),
            (Verdict::Inside, Some(true)),
            "{form}"
        );
        let d = rational(distance);
        let less = &d - &rational("1e-60");
        let found = inspect(form, &less.to_string(), point);
        assert_eq!(
            (found.verdict, found.curve),
            (Verdict::Outside, Some(false)),
            "{form}"
        );
        let more = &d + &rational("1e-60");
        let found = inspect(form, &more.to_string(), point);
        assert_eq!(
            (found.verdict, found.curve),
            (Verdict::Inside, Some(true)),
            "{form}"
        );
        assert_distance(&found, d.to_f64());
    }
}

#[test]
fn a_form_inside_the_ball_does_not_meet_the_sphere() {
    for form in ["r = 1 + cos(3t)/5", "x = cos(t); y = sin(t)*cos(t)"] {
        let found = inspect(form, "10", "1/3,1/7");
        assert_eq!(
            (found.verdict, found.curve),
            (Verdict::Inside, Some(false)),
            "{form}"
        );
    }
    // What goes to infinity meets every sphere around one of its points.
    for form in ["x = t; y = t^2", "x = 1/cos(t); y = sin(t)/cos(t)"] {
        let found = inspect(form, "10", "1,0");
        assert_eq!(
            (found.verdict, found.curve),
            (Verdict::Inside, Some(true)),
            "{form}"
        );
    }
}

#[test]
fn points_of_a_curve_are_at_distance_0() {
    // (3/5, 4/5) times r there: cos 2t = −7/25.
    let found = inspect("r = 1 + cos(2t)/2", "1/100", "129/250,172/250");
    assert_eq!((found.verdict, found.curve), (Verdict::Inside, Some(true)));
    assert_eq!([found.distance.low, found.distance.high], [0.0, 0.0]);
    let found = inspect("x = t^2; y = t^3", "1/100", "1/4,-1/8");
    assert_eq!([found.distance.low, found.distance.high], [0.0, 0.0]);
}

#[test]
fn a_center_is_where_the_curve_is() {
    let found = inspect("# center: 10, 0\nr = 1 + cos(2t)/2", "1/10", "11.5,0");
    assert_eq!(found.verdict, Verdict::Inside);
    let found = inspect("# center: 10, 0\nr = 1 + cos(2t)/2", "1/10", "1.5,0");
    assert_eq!(found.verdict, Verdict::Outside);
    assert_distance(&found, 7.0);
}

#[test]
fn a_plane_curve_is_a_cylinder_for_points_in_space() {
    let found = inspect("r = 1 + cos(3t)/5", "1/10", "1.25,0,77");
    assert_eq!((found.verdict, found.curve), (Verdict::Inside, Some(true)));
    assert_distance(&found, 0.05);
    // The sphere about the point meets the cylinder even where it holds the whole curve.
    let found = inspect("r = 1 + cos(3t)/5", "10", "1/4,0,77");
    assert_eq!((found.verdict, found.curve), (Verdict::Inside, Some(true)));
}

#[test]
fn patches_agree_with_their_equations_where_these_have_no_more() {
    let torus = "x = (2 + cos(v))*cos(u); y = (2 + cos(v))*sin(u); z = sin(v)";
    let equation = "(x^2 + y^2 + z^2 + 3)^2 = 16*(x^2 + y^2)";
    let (patch, surface) = (task(torus, 3, "1/10"), task(equation, 3, "1/10"));
    for text in [
        "3.05,0,0",
        "3.2,0,0",
        "0,0,0",
        "2,0,1.0999",
        "-1.5,1.5,0.9",
        "1,1,1",
    ] {
        let point: Vec<Rational> = text.split(',').map(rational).collect();
        let point: [Rational; 3] = point.try_into().unwrap();
        let (a, b) = (patch.point(&point), surface.point(&point));
        assert_eq!((a.verdict, a.curve), (b.verdict, b.curve), "{text}");
        assert!(
            a.distance.low <= b.distance.high && b.distance.low <= a.distance.high,
            "{text}"
        );
    }
}

fn radius() -> impl Strategy<Value = FourierRadius> {
    let coefficient = || (-9i64..10).prop_map(|n| Rational::from(n) / Rational::from(40));
    let list = || prop::collection::vec(coefficient(), 1..6);
    (list(), list()).prop_map(|(mut cos, mut sin)| {
        cos[0] = Rational::one();
        sin[0] = Rational::zero();
        let count = cos.len().max(sin.len());
        cos.resize_with(count, Rational::zero);
        sin.resize_with(count, Rational::zero);
        FourierRadius::new(cos, sin)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Against points close together along the curve: the distance lies between the least one, less half of the longest step,
    /// and the least one.
    #[test]
    fn distances_are_those_of_a_fine_polygon(
        radius in radius(), points in prop::collection::vec([-200i64..200, -200i64..200], 6),
    ) {
        let line = radius.polyline(4000);
        let length = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let step = line.windows(2).map(|w| length(&w[0], &w[1])).fold(0.0, f64::max);
        let options = InspectionOptions::default().tolerance(rational("1/10"));
        let given: Given = Form::Fourier(radius).into();
        let task = verb::inspect(given, 2, &options, &Work::default()).unwrap();
        for [x, y] in points {
            let point = [x, y, 0].map(|n| Rational::from(n) / Rational::from(100));
            let near = point.each_ref().map(Rational::to_f64);
            let least = line.iter().map(|q| length(q, &[near[0], near[1]])).fold(f64::INFINITY, f64::min);
            let found = task.point(&point);
            let [low, high] = [found.distance.low, found.distance.high];
            prop_assert!(low <= least + 1e-9 && least - step / 2.0 - 1e-9 <= high, "{:?} {}", found, least);
            prop_assert!(high - low <= 1e-5 * high + 1e-12, "{:?}", found);
            prop_assert_ne!(found.verdict, Verdict::Undecided);
            if least - step > 0.1 {
                prop_assert_eq!(found.verdict, Verdict::Outside);
            }
            if least < 0.1 - 1e-9 {
                prop_assert_eq!(found.verdict, Verdict::Inside);
            }
        }
    }
}

/// Forms with sides, and the numbers of coordinates of their points.
const SIDED: [(&str, usize); 12] = [
    ("r = 2 + cos(5*t)/3", 2),
    ("r = 2 + cos(5*t)/3", 3),
    ("r = 1/2 + cos(3*t)", 2),
    ("x = cos(t); y = sin(2*t)", 2),
    ("x = (1-t^2)/(1+t^2); y = 2*t/(1+t^2)", 2),
    ("y^2 = x^3 - x", 2),
    ("(x^2 + y^2 - 1)^2*(x - y)", 3),
    ("superquadric 2d a=1,2 e=1/2", 2),
    ("superquadric 2d a=1,2 e=0.2345", 2),
    ("superquadric 3d a=1,2,1 e=3,0.7 level=2", 3),
    ("R = 2 + Y(3,1)/9", 3),
    ("x^2 + y^2*z + z^3 = 1", 3),
];

proptest! {
    #[test]
    fn sides_are_those_of_inspections(k in 0..SIDED.len(), at in prop::array::uniform3(-24i32..=24)) {
        let (form, dimension) = SIDED[k];
        let task = task(form, dimension, "1");
        let mut point = at.map(|n| f64::from(n) / 8.0);
        point[2] *= f64::from(dimension == 3);
        let side = task.side_of_doubles(point);
        prop_assert!(side.is_some());
        prop_assert_eq!(side, task.of_doubles(point).sign);
    }
}
