//! Theorem 7: intersections of surfaces as parametric space curves.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::common::program::{done, json, piped, run_in};
use proptest::prelude::*;
use stellate::document::{Coordinates, Format};
use stellate::exact::Rational;
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::parametrize::{CommonPoint, IntersectionParametrization, parametrize_intersection};
use stellate::shape::{Form, ImplicitSurface};

fn surfaces(text: &str) -> Vec<ImplicitSurface> {
    match parse_form(text, "<form>", Numbers::Exact).unwrap() {
        Form::Intersection(surfaces) => surfaces,
        other => panic!("{other:?}"),
    }
}

/// The curves, each checked at rational parameters in all the equations.
fn curves(text: &str) -> (Vec<String>, IntersectionParametrization) {
    let surfaces = surfaces(text);
    let found = parametrize_intersection(&surfaces, &Limits::none()).unwrap();
    for curve in &found.curves {
        for s in -3i64..4 {
            let s = Rational::from(s) / Rational::from(2);
            let Some(point) = curve.point(&s) else {
                continue;
            };
            for surface in &surfaces {
                assert!(surface.polynomial().evaluate(&point).is_zero(), "{text}");
            }
        }
    }
    let formulas = found.curves.iter().map(|curve| {
        let formulas = Coordinates::from(curve).formulas(Format::Text);
        formulas.join(", ")
    });
    (formulas.collect(), found)
}

#[test]
fn known_curves() {
    for (text, expected) in [
        // Example 11
        ("x^2 + y^2 = 1; z = y^5", &["cos(t), sin(t), sin(t)^5"][..]),
        // Viviani's curve, once
        (
            "x^2 + y^2 + z^2 = 4; (x-1)^2 + y^2 = 1",
            &["2*cos(t)^2, sin(2*t), 2*sin(t)"],
        ),
        // The twisted cubic, in any order of the equations
        ("z = x^3; y = x^2", &["t, t^2, t^3"]),
        ("x^2 = y; x*y = z", &["t, t^2, t^3"]),
        // Two circles: Steinmetz
        (
            "x^2 + y^2 = 1; y^2 + z^2 = 1",
            &["cos(t), sin(t), -cos(t)", "cos(t), sin(t), cos(t)"],
        ),
        // Projected along x
        ("y^2 + z^2 = 1; x = y*z", &["1/2*sin(2*t), cos(t), sin(t)"]),
        // Parallel lines: two cylinders along one axis
        ("x^2 = 1 + 0z; y = 0*z", &["1, 0, t", "-1, 0, t"]),
        // A line parallel to the axis of projection
        ("x*z = y; y*z = x^2", &["0, 0, t", "t^2, t^3, t"]),
        (
            "(x-1)*z = y-1/2; (y-1/2)*z = (x-1)^2",
            &["1, 1/2, t", "t^2 + 1, t^3 + 1/2, t"],
        ),
        // A real component beside a complex one over the same projection
        ("x^2+y^2 = 1+0z; z^3+z = x^2+y^2-1", &["cos(t), sin(t), 0"]),
        // A torus touches a cylinder along its inner equator, and a plane along its uppermost circle.
        (
            "(x^2+y^2+z^2+91/4)^2 = 100*(x^2+y^2); x^2+y^2 = 49/4",
            &["7/2*cos(t), 7/2*sin(t), 0"],
        ),
        (
            "(x^2+y^2+z^2+91/4)^2 = 100*(x^2+y^2); z = 3/2",
            &["5*cos(t), 5*sin(t), 3/2"],
        ),
        // A third surface takes a component away
        (
            "x^2 + y^2 = 1; y^2 + z^2 = 1; x = z",
            &["cos(t), sin(t), cos(t)"],
        ),
    ] {
        let (found, all) = curves(text);
        assert_eq!(found, expected, "{text}");
        assert!(all.others.is_empty(), "{text}");
    }
}

#[test]
fn what_has_no_parametrization_says_why() {
    for (text, reason) in [
        (
            "x^2 + y^2 + z^2 = 1; x^2 + y^2 = z^2",
            "no rational function of the parameter",
        ),
        ("x^2 + y^2 = 3; z = x", "no rational parametrization over Q"),
        ("x^4 + y^4 = 1; z = x", "genus 3"),
    ] {
        let (found, all) = curves(text);
        assert_eq!(found, [""; 0], "{text}");
        assert!(
            all.others[0].reason.contains(reason),
            "{}",
            all.others[0].reason
        );
    }
}

/// Points where surfaces touch, and components without real points, are named.
#[test]
fn what_has_few_real_points_is_named() {
    for (text, expected, finite) in [
        ("x^2+y^2+z^2 = 1; z = 1", &["0, 0, 1"][..], 1),
        ("x^2+y^2+z^2 = 1; (x-2)^2+y^2+z^2 = 1", &["1, 0, 0"], 1),
        ("z^2 = x^2+y^2; z = 0", &["0, 0, 0"], 1),
        ("x^2+y^2+z^2 = 1; z = 2", &[], 1),
        ("x^2+y^2+z^2 = 1; x^2+y^2+z^2 = 4", &[], 0),
        // A cylinder touches a sphere in two points, at the parameters 0 and ∞ of its base circle.
        ("x^2+y^2 = 1+0z; z^2 = -y^2", &["1, 0, 0", "-1, 0, 0"], 1),
    ] {
        let (found, all) = curves(text);
        assert_eq!((found.len(), all.others.len()), (0, 0), "{text}");
        let points = all.points.iter().map(|point| match point {
            CommonPoint::Exact(point) => {
                for surface in surfaces(text) {
                    assert!(surface.polynomial().evaluate(point).is_zero(), "{text}");
                }
                point.each_ref().map(Rational::to_string).join(", ")
            }
            near => panic!("{near:?}"),
        });
        assert_eq!(points.collect::<Vec<_>>(), expected, "{text}");
        assert_eq!(all.finite.len(), finite, "{text}");
    }
    let text = done(&["parametrize", "x^2+y^2+z^2 = 1; z = 1"]);
    assert!(
        text.contains("# common point (x, y, z) = (0, 0, 1)\n"),
        "{text}"
    );
    let document = done(&["parametrize", "x^2+y^2+z^2 = 1; z = 1", "--format", "json"]);
    assert_eq!(json(&document)["points"][0][2], "1");
}

/// The real points of a parametrized component that no parameter value reaches are named.
#[test]
fn what_no_parameter_reaches_is_named() {
    for (text, expected) in [
        // A cubic with an isolated point, which approaches (0, 0, 1).
        (
            "x^2+y^2 = z^3-z^2; y = 0",
            &["0, 0, 1 approached", "0, 0, 0 isolated"][..],
        ),
        ("x = y^2; x = z^3", &["0, 0, 0 approached"]),
        ("x^2 = y^3; z = y", &["0, 0, 0 approached"]),
        // The other curve reaches the point that the first one approaches.
        ("(x^2 - y^3)*(x - y) = 0*z; z = y", &[]),
        // A node, which real parameters reach, and a circle, whose angle reaches every point.
        ("x^2+y^2 = z^3+z^2+2*y^2; y = 0", &["0, 0, -1 approached"]),
        ("x^2+y^2 = 1; z = x*y", &[]),
    ] {
        let (_, all) = curves(text);
        assert!(all.others.is_empty(), "{text}");
        let points = all.unreached.iter().map(|unreached| {
            let CommonPoint::Exact(point) = &unreached.point else {
                panic!("{unreached:?}");
            };
            for surface in surfaces(text) {
                assert!(surface.polynomial().evaluate(point).is_zero(), "{text}");
            }
            let kind = if unreached.is_isolated {
                "isolated"
            } else {
                "approached"
            };
            format!(
                "{} {kind}",
                point.each_ref().map(Rational::to_string).join(", ")
            )
        });
        assert_eq!(points.collect::<Vec<_>>(), expected, "{text}");
    }
    let text = done(&["parametrize", "x^2+y^2 = z^3-z^2; y = 0"]);
    assert!(text.contains("# common point (x, y, z) = (0, 0, 0), an isolated real point of curve 0, of conjugate complex t\n"), "{text}");
    assert!(text.contains("# common point (x, y, z) = (0, 0, 1), which curve 0 only approaches, as t goes to infinity\n"), "{text}");
    let document = json(&done(&[
        "parametrize",
        "x^2+y^2 = z^3-z^2; y = 0",
        "--format",
        "json",
    ]));
    assert_eq!(document["beyond"][1]["kind"], "isolated");
    assert_eq!(document["beyond"][1]["point"][2], "0");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Built backwards: both surfaces hold the line over (a, b), whose coefficients vanish there.
    #[test]
    fn lines_parallel_to_an_axis_come_back(c in prop::array::uniform5(-4i64..5), axis in 0usize..3) {
        let [a, b, d, e, f] = c;
        let (u, w, v) = [("y", "z", "x"), ("x", "z", "y"), ("x", "y", "z")][axis];
        let p = format!("({u}-({a}))");
        let q = format!("({w}-({b}))");
        let text = format!("{p}*{v} + {q}*({d}*{u} + {e}*{v} + 7) = 0; {q}*{v}^2 + {p}*({f}*{w} + 5 + {p}) = 0");
        let (found, _) = curves(&text);
        let mut line = [a.to_string(), b.to_string()].to_vec();
        line.insert(axis, "t".into());
        prop_assert!(found.contains(&line.join(", ")), "{}: {:?}", text, found);
    }

    /// Built backwards: a graph over a circle, and a graph over a parabola, come back.
    #[test]
    fn graphs_over_known_curves_come_back(c in prop::array::uniform5(-4i64..5)) {
        let [a, b, d, e, f] = c;
        let graph = format!("{a}*x^2*y + {b}*y^3 + {d}*x + {e}*y + {f}");
        for (base, degree) in [("x^2 + y^2 = 1", 1), ("y = x^2 + x", 1), ("x^3 + y^3 = 3*x*y", 1)] {
            let (found, all) = curves(&format!("{base}; z = {graph}"));
            prop_assert_eq!(found.len(), degree);
            prop_assert!(all.others.is_empty());
        }
    }
}

#[test]
fn on_the_command_line() {
    let example_11 = "x^2 + y^2 = 1; z = y^5";
    let text = done(&["parametrize", example_11]);
    assert!(
        text.ends_with("x = cos(t)\ny = sin(t)\nz = sin(t)^5\n"),
        "{text}"
    );
    // And back: the equations of the curve.
    assert_eq!(
        piped(&["implicitize", "-"], &text),
        done(&["implicitize", "x = cos(t); y = sin(t); z = sin(t)^5"])
    );
    let document = done(&["parametrize", example_11, "--format", "json"]);
    let value = json(&document);
    assert_eq!(value["method"], "theorem-7");
    assert_eq!(value["curves"][0]["coordinates"]["z"], "sin(t)^5");
    assert_eq!(
        piped(&["implicitize", "-"], &document),
        piped(&["implicitize", "-"], &text)
    );
    let shared = ["parametrize", "x*y = z*y; y = x*y"];
    let run = run_in(std::path::Path::new("."), &shared, "");
    assert_eq!((run.code, run.out.as_str()), (2, ""), "{}", run.err);
    assert!(run.err.contains("a surface in common"), "{}", run.err);
}
