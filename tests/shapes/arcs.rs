//! Certified arcs of intersections that have no rational or trigonometric parametrization.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::common::program::{done, json, run_in};
use num_rational::BigRational;
use num_traits::Zero;
use proptest::prelude::*;
use stellate::arcs::{ArcEnd, ArcOptions, IntersectionArcs, trace_intersection};
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::poly::SparsePolynomial;
use stellate::shape::{Form, ImplicitSurface};

const TWO_CIRCLES: &str = "x^2+y^2+z^2 = 1; x^2+y^2 = z^2";

fn surfaces(text: &str) -> [ImplicitSurface; 2] {
    match parse_form(text, "<form>", Numbers::Exact).unwrap() {
        Form::Intersection(surfaces) => surfaces.try_into().unwrap(),
        other => panic!("{other:?}"),
    }
}

fn traced(text: &str, half: f64, resolution: u32) -> IntersectionArcs {
    let [f, g] = surfaces(text);
    let options = ArcOptions::new([[-half, half]; 3]).resolution(resolution);
    trace_intersection([&f, &g], &options, &Limits::none(), &|_| {}).unwrap()
}

/// f at a point, over num-rational, term by term: the coordinates are integers over one power of 2.
fn value(f: &SparsePolynomial<3>, p: [f64; 3]) -> BigRational {
    let p = p.map(|x| BigRational::from_float(x).unwrap());
    let below = p.iter().map(|x| x.denom()).max().unwrap();
    let above = p.each_ref().map(|x| x.numer() * (below / x.denom()));
    let degree = f
        .terms()
        .map(|(e, _)| e.iter().sum::<u32>())
        .max()
        .unwrap_or(0);
    let sum = f.terms().fold(BigRational::zero(), |sum, (e, c)| {
        let mut term = below.pow(degree - e.iter().sum::<u32>());
        for (x, k) in above.iter().zip(e) {
            term *= x.pow(*k);
        }
        sum + BigRational::from(c) * term
    });
    sum / below.pow(degree)
}

/// What holds of every answer: residuals, bounds, steps, the box.
fn check(text: &str, half: f64, resolution: u32) -> IntersectionArcs {
    let found = traced(text, half, resolution);
    let pair = surfaces(text);
    for arc in &found.arcs {
        for p in &arc.points {
            for (surface, residual) in pair.iter().zip(&p.residuals) {
                let residual = BigRational::from(residual);
                assert_eq!(value(surface.polynomial(), p.position), residual);
            }
            assert!(p.radius < 1e-14, "{text}: {p:?}");
            assert!(p.position.iter().all(|x| x.abs() <= half), "{text}: {p:?}");
        }
        let line = arc.polyline();
        let longest = 3.0 * 2.0 * half / f64::from(resolution);
        assert!(line.len() >= 3, "{text}");
        for pair in line.windows(2) {
            let squares = pair[0].iter().zip(pair[1]).map(|(a, b)| (a - b) * (a - b));
            let length = squares.sum::<f64>().sqrt();
            assert!(length > 0.0 && length < longest, "{text}: {pair:?}");
        }
    }
    found
}

/// (closed arcs, arcs from side to side of the box, other arcs, places that are not resolved)
fn counts(found: &IntersectionArcs) -> [usize; 4] {
    let count = |ends: Option<[ArcEnd; 2]>| found.arcs.iter().filter(|a| a.ends == ends).count();
    let (closed, through) = (count(None), count(Some([ArcEnd::Window; 2])));
    let other = found.arcs.len() - closed - through;
    [closed, through, other, found.unresolved.len()]
}

#[test]
fn curves_with_known_components() {
    for (text, half, expected) in [
        (TWO_CIRCLES, 1.25, [2, 0, 0, 0]),
        // An elliptic curve with an oval and a branch to infinity, one without the oval.
        ("y^2 = x^3 - x + 0z; z = x", 3.0, [1, 1, 0, 0]),
        ("y^2 = x^3 + x + 0z; z = x*y/4", 3.0, [0, 1, 0, 0]),
        // Two quadrics whose curve has genus 1, in two ovals and in one.
        (
            "x^2 + y^2 + z^2 = 4; x^2 + 2*y^2 = 1 + z/8",
            2.5,
            [2, 0, 0, 0],
        ),
        (
            "x^2 + y^2 + z^2 = 4; (x-3/2)^2 + 2*y^2 = 1",
            2.5,
            [1, 0, 0, 0],
        ),
        // Conjugate planes: two circles through two points, which are no nodes of the third circle.
        (
            "x^2 + y^2 + z^2 = 3; (x^2-2*y^2)*(z-1) = 0",
            2.0,
            [1, 0, 4, 2],
        ),
        // No common points; a common point only; a curve along which they touch.
        ("x^2 + y^2 + z^2 = 1; z = x^2 + 2", 1.5, [0, 0, 0, 0]),
        (
            "x^2 + y^2 + z^2 = 1; (x-3)^2 + y^2 + z^2 = 4",
            1.5,
            [0, 0, 0, 1],
        ),
        ("x^2 + y^2 + z^2 = 1; x^2 + y^2 = 1", 1.5, [0, 0, 0, 1]),
        // An oval of less than a hundredth of the box, which no seed hits by chance.
        (
            "(x-1/3)^2 + (y-1/7)^2 + (z-1/5)^2 = 1/10000; x + y + z = 71/105",
            1.5,
            [1, 0, 0, 0],
        ),
    ] {
        let found = check(text, half, 48);
        assert_eq!(counts(&found), expected, "{text}: {:?}", found.unresolved);
    }
}

/// Viviani's curve has one.
#[test]
fn nodes_are_enclosed() {
    let found = check("x^2+y^2+z^2 = 4; (x-1)^2+y^2 = 1", 2.5, 64);
    assert_eq!(counts(&found), [0, 0, 2, 1]);
    let [x, y, z] = found.unresolved[0];
    assert!(x[0] < 2.0 && x[1] > 2.0 && y[0] < 0.0 && y[1] > 0.0 && z[0] < 0.0 && z[1] > 0.0);
    assert!([x, y, z].iter().all(|[a, b]| b - a < 0.05));
}

/// √(1/2) between the exact bounds of every height, and every point on its circle.
#[test]
fn irrational_circles_are_met() {
    let found = check(TWO_CIRCLES, 1.25, 64);
    for p in found.arcs.iter().flat_map(|arc| &arc.points) {
        let [x, y, z] = p.position;
        assert!((z.abs() - 0.5f64.sqrt()).abs() <= p.radius + 2e-16);
        assert!((x.hypot(y) - 0.5f64.sqrt()).abs() <= p.radius + 3e-16);
    }
}

/// On z = x the curve is a plane one: its polynomial changes sign, exactly, across every point within the bound.
#[test]
fn bounds_hold_by_exact_sign_changes() {
    let text = "x^3 + y^3 = 1 + x; z = x";
    let [f, _] = surfaces(text);
    let found = check(text, 3.0, 64);
    assert_eq!(counts(&found), [0, 1, 0, 0]);
    for p in &found.arcs[0].points {
        // The bounds are below an ulp, so two ulps to each side.
        let signs = |axis: usize, sense: f64| {
            let mut q = p.position;
            for i in if axis == 0 { vec![0, 2] } else { vec![1] } {
                q[i] += sense * (2.0 * p.radius + 4e-16 * q[i].abs());
            }
            value(f.polynomial(), q) > BigRational::zero()
        };
        let changes = |axis| signs(axis, 1.0) != signs(axis, -1.0);
        assert!(changes(0) || changes(1), "{p:?}");
    }
}

#[test]
fn arcs_on_a_component_are_kept() {
    let mut found = traced("x^2+y^2+z^2 = 4; (x-1)*(x^4+y^4-3) = 0", 2.5, 48);
    assert_eq!(counts(&found), [3, 0, 0, 0]);
    let [plane, _] = surfaces("x - 1 + 0*z = 0; z = 0");
    found.retain_on(&[plane.polynomial()]);
    assert_eq!(found.arcs.len(), 1);
    assert!(
        found.arcs[0]
            .points
            .iter()
            .all(|p| (p.position[0] - 1.0).abs() < 1e-15)
    );
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    /// A plane meets a sphere in one closed arc exactly if it is nearer to the middle than the radius.
    #[test]
    fn planes_cut_spheres(n in prop::array::uniform3(-9i64..10), d in -12i64..13) {
        let square: i64 = n.iter().map(|k| k * k).sum();
        prop_assume!(square > 0 && d * d != square);
        let [a, b, c] = n;
        let found = check(&format!("x^2 + y^2 + z^2 = 1; {a}*x + {b}*y + {c}*z = {d}"), 1.25, 24);
        let expected = usize::from(d * d < square);
        prop_assert_eq!(counts(&found), [expected, 0, 0, 0]);
    }

    /// The order of the surfaces, and of the coordinates, does not change how many arcs there are.
    #[test]
    fn pairs_of_quadrics(c in prop::array::uniform9(-5i64..6)) {
        let [a, b, d, e, f, g, h, i, j] = c;
        let first = |x: &str, y: &str, z: &str| format!("{x}^2 + 2*{y}^2 + 3*{z}^2 = 4 + 1/7*{x}*{z}");
        let second = |x: &str, y: &str, z: &str| format!(
            "{a}*{x}^2 + {b}*{y}^2 + {d}*{z}^2 + {e}*{x}*{y} + {f}*{y}*{z} + {g}*{x} + {h}*{y} + {i}*{z} = {j} + 1/11*{x}"
        );
        let one = check(&format!("{}; {}", first("x", "y", "z"), second("x", "y", "z")), 2.25, 32);
        let other = check(&format!("{}; {}", second("y", "z", "x"), first("y", "z", "x")), 2.25, 32);
        prop_assume!(one.unresolved.is_empty() && other.unresolved.is_empty());
        prop_assert_eq!(counts(&one), counts(&other));
    }
}

#[test]
fn on_the_command_line() {
    let text = done(&["parametrize", TWO_CIRCLES]);
    assert!(
        text.contains("no rational function of the parameter"),
        "{text}"
    );
    assert!(text.contains("# arc 1: closed, "), "{text}");
    assert!(
        text.ends_with("# every common point in the box lies on these arcs\n"),
        "{text}"
    );

    let value = json(&done(&["parametrize", TWO_CIRCLES, "--format", "json"]));
    assert_eq!(value["others"][0]["projection"], "2x^2 + 2y^2 - 1");
    assert_eq!(value["arcs"][1]["closed"], true);
    assert!(value["arcs"][0]["points"][0]["residuals"][0].is_string());

    let window = "--window=-1.1,1.1,-1.1,1.1,0,1.1";
    let rows = done(&["sample", TWO_CIRCLES, window, "--resolution", "16"]);
    let mut lines = rows.lines();
    assert_eq!(
        lines.next().unwrap(),
        "arc,point,x,y,z,bound,residual1,residual2"
    );
    for (n, line) in lines.enumerate() {
        assert!(line.starts_with(&format!("0,{n},")), "{line}");
        let fields: Vec<f64> = line.split(',').map(|f| f.parse().unwrap()).collect();
        assert!((fields[4] - 0.5f64.sqrt()).abs() < 1e-15);
        assert!(fields[6].abs() < 1e-15 && fields[7].abs() < 1e-15);
    }
    let value = json(&done(&["sample", TWO_CIRCLES, window, "--format", "json"]));
    assert_eq!(
        (value["kind"].as_str(), &value["unresolved"]),
        (Some("arcs"), &serde_json::json!([]))
    );

    for (arguments, said) in [
        (
            &["sample", TWO_CIRCLES, "--directions", "4"][..],
            "--resolution",
        ),
        (&["sample", TWO_CIRCLES, "--window=1,0,0,1,0,1"], "X0 < X1"),
        (&["sample", "x^2 + y^2 - 1", window], "two surfaces meet"),
        (
            &["parametrize", "x^2 + y^2 + z^2 - 1", window],
            "two surfaces meet",
        ),
        (&["sample", "x+y+z=1; x*y=z; x=y"], "here are 3"),
        (&["sample", "x*z = 1 + z; x*y*z = y + y*z"], "in common"),
        (
            &["parametrize", TWO_CIRCLES, "--format", "latex"],
            "does not apply",
        ),
    ] {
        let run = run_in(std::path::Path::new("."), arguments, "");
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{}", run.err);
        assert!(run.err.contains(said), "{}", run.err);
    }
}
