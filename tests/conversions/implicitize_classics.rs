//! Parametric → implicit: Theorems 1, 3 and 4 on the paper's examples and on classics with known equations.

use crate::common::forms::{patch, plane, plane_curve, space, space_curve};
use stellate::exact::Rational;
use stellate::implicitize::{
    Coverage, IsolatedPoint, PolarInverse, Role, implicitize_patch, implicitize_plane,
    implicitize_space_curve, point_beyond, polar_patch, polar_plane, polar_space_curve, real_image,
};
use stellate::limits::Limits;
use stellate::poly::RationalFunction;
use stellate::shape::{Parameter, PlaneCurve};

#[test]
fn plane_classics_by_both_methods() {
    // name, form, equation, tracing index, whether the slope is inverted by substitution
    let classics = [
        (
            "circle",
            "x = 2cos(t); y = 2sin(t)",
            "x^2 + y^2 - 4",
            1,
            true,
        ),
        (
            "ellipse",
            "x = 3cos(t); y = 2sin(t)",
            "x^2/9 + y^2/4 - 1",
            1,
            true,
        ),
        (
            "cardioid",
            "x = (1+cos(t))cos(t); y = (1+cos(t))sin(t)",
            "(x^2 + y^2 - x)^2 - x^2 - y^2",
            1,
            false,
        ),
        (
            "folium of Descartes",
            "x = 3t/(1+t^3); y = 3t^2/(1+t^3)",
            "x^3 + y^3 - 3x*y",
            1,
            true,
        ),
        (
            "lemniscate",
            "x = cos(t)/(1+sin(t)^2); y = sin(t)cos(t)/(1+sin(t)^2)",
            "(x^2 + y^2)^2 - x^2 + y^2",
            1,
            true,
        ),
        (
            "Example 1",
            "x = sin(t); y = sin(t)cos(t)",
            "x^4 - x^2 + y^2",
            1,
            true,
        ),
        // r^(k+1) = Re (x+iy)^k for odd k, traced twice; r^(2k+2) = (Re (x+iy)^k)² for even k.
        (
            "rose 2",
            "x = cos(2t)cos(t); y = cos(2t)sin(t)",
            "(x^2 + y^2)^3 - (x^2 - y^2)^2",
            1,
            true,
        ),
        (
            "rose 3",
            "x = cos(3t)cos(t); y = cos(3t)sin(t)",
            "(x^2 + y^2)^2 - x^3 + 3x*y^2",
            2,
            true,
        ),
        (
            "rose 4",
            "x = cos(4t)cos(t); y = cos(4t)sin(t)",
            "(x^2 + y^2)^5 - (x^4 - 6x^2*y^2 + y^4)^2",
            1,
            true,
        ),
        (
            "rose 5",
            "x = cos(5t)cos(t); y = cos(5t)sin(t)",
            "(x^2 + y^2)^3 - (x^5 - 10x^3*y^2 + 5x*y^4)",
            2,
            true,
        ),
        (
            "rose 6",
            "x = cos(6t)cos(t); y = cos(6t)sin(t)",
            "(x^2 + y^2)^7 - (x^6 - 15x^4*y^2 + 15x^2*y^4 - y^6)^2",
            1,
            true,
        ),
        (
            "rose 7",
            "x = cos(7t)cos(t); y = cos(7t)sin(t)",
            "(x^2 + y^2)^4 - (x^7 - 21x^5*y^2 + 35x^3*y^4 - 7x*y^6)",
            2,
            true,
        ),
        // T4(x)² + T5(y)² = cos² 20t + sin² 20t = 1, with Chebyshev's polynomials, and so on.
        (
            "Lissajous 3:2",
            "x = cos(3t); y = sin(2t)",
            "(2x^2 - 1)^2 + (4y^3 - 3y)^2 - 1",
            1,
            false,
        ),
        (
            "Lissajous 5:4",
            "x = cos(5t); y = sin(4t)",
            "(16y^5 - 20y^3 + 5y)^2 + (8x^4 - 8x^2 + 1)^2 - 1",
            1,
            false,
        ),
        (
            "nephroid",
            "x = 3cos(t) - cos(3t); y = 3sin(t) - sin(3t)",
            "(x^2 + y^2 - 4)^3 - 108y^2",
            1,
            false,
        ),
        (
            "deltoid",
            "x = 2cos(t) + cos(2t); y = 2sin(t) - sin(2t)",
            "(x^2+y^2)^2 + 18(x^2+y^2) - 27 - 8(x^3 - 3x*y^2)",
            1,
            false,
        ),
        (
            "astroid",
            "x = cos(t)^3; y = sin(t)^3",
            "(x^2 + y^2 - 1)^3 + 27x^2*y^2",
            1,
            false,
        ),
        (
            "cubic with an isolated origin",
            "x = 1 + t^2; y = t + t^3",
            "x^3 - x^2 - y^2",
            1,
            true,
        ),
        ("half a parabola", "x = t^2; y = t^4", "x^2 - y", 2, true),
        ("vertical line", "x = 3; y = tan(t)", "x - 3", 2, true),
        (
            "semicubical parabola",
            "x = t^2; y = t^3",
            "x^3 - y^2",
            1,
            true,
        ),
    ];
    for (name, form, equation, index, invertible) in classics {
        let (curve, expected) = (plane_curve(form), plane(equation));
        let found = implicitize_plane(&curve, &Limits::none()).unwrap();
        assert_eq!(found.curve.polynomial(), &expected, "{name}");
        assert_eq!(found.tracing_index, index, "{name}");
        let polar = polar_plane(&curve, &Limits::none()).unwrap();
        assert_eq!(polar.curve.polynomial(), &expected, "{name}");
        assert_eq!(
            matches!(polar.inverse, PolarInverse::Function(_)),
            invertible,
            "{name}"
        );
        // Nothing is left without a name, and the curve is there once.
        let of = |role: Role| polar.factors.iter().filter(|f| f.role == role).count();
        assert_eq!((of(Role::Form), of(Role::Other)), (1, 0), "{name}");
    }
}

#[test]
fn patches_by_both_methods() {
    let classics = [
        (
            "Example 4",
            "x = cos(theta)*sin(phi); y = cos(theta); z = cos(phi)",
            "y^2*z^2 + x^2 - y^2",
            2,
        ),
        (
            "torus",
            "x = (2+cos(v))cos(u); y = (2+cos(v))sin(u); z = sin(v)",
            "(x^2 + y^2 + z^2 + 3)^2 - 16x^2 - 16y^2",
            1,
        ),
        (
            "Whitney umbrella",
            "x = u*v; y = u; z = v^2",
            "y^2*z - x^2",
            1,
        ),
        (
            "Steiner's Roman surface",
            "x = cos(u)cos(v)sin(v); y = sin(u)cos(v)sin(v); z = cos(u)sin(u)cos(v)^2",
            "x^2*y^2 + x^2*z^2 + y^2*z^2 - x*y*z",
            4,
        ),
        (
            "monkey saddle",
            "x = u; y = v; z = u^3 - 3u*v^2",
            "x^3 - 3x*y^2 - z",
            1,
        ),
        (
            "sphere",
            "x = cos(theta)sin(phi); y = sin(theta)sin(phi); z = cos(phi)",
            "x^2 + y^2 + z^2 - 1",
            2,
        ),
        (
            "plane",
            "x = u + v; y = u - v; z = 3u + 1",
            "3x + 3y - 2z + 2",
            1,
        ),
        (
            "hyperboloid",
            "x = cos(u) - v*sin(u); y = sin(u) + v*cos(u); z = v",
            "x^2 + y^2 - z^2 - 1",
            1,
        ),
    ];
    for (name, form, equation, index) in classics {
        let (patch, expected) = (patch(form), space(equation));
        let found = implicitize_patch(&patch, &Limits::none()).unwrap();
        assert_eq!(found.surface.polynomial(), &expected, "{name}");
        assert_eq!(found.tracing_index, Some(index), "{name}");
        let polar = polar_patch(&patch, &Limits::none()).unwrap();
        assert_eq!(polar.surface.polynomial(), &expected, "{name}");
        let of = |role: Role| polar.factors.iter().filter(|f| f.role == role).count();
        assert_eq!((of(Role::Form), of(Role::Other)), (1, 0), "{name}");
    }
}

#[test]
fn ennepers_surface_has_degree_nine() {
    let text = "x = u - u^3/3 + u*v^2; y = v - v^3/3 + v*u^2; z = u^2 - v^2";
    let found = implicitize_patch(&patch(text), &Limits::none()).unwrap();
    let f = found.surface.polynomial();
    // As printed in many places for a surface three times smaller.
    let smaller = "64z^9 - 128z^7 + 64z^5 - 702x^2*y^2*z^3 - 18x^2*y^2*z + 144(y^2*z^6 - x^2*z^6) \
        + 162(y^4*z^2 - x^4*z^2) + 27(y^6 - x^6) + 9(x^4*z + y^4*z) + 48(x^2*z^3 + y^2*z^3) \
        - 432(x^2*z^5 + y^2*z^5) + 81(x^4*y^2 - x^2*y^4) + 240(y^2*z^4 - x^2*z^4) - 135(x^4*z^3 + y^4*z^3)";
    let third = |name: &str| format!("({name}/3)");
    let printed = space(
        &["x", "y", "z"]
            .iter()
            .fold(smaller.to_owned(), |t, n| t.replace(n, &third(n))),
    );
    assert_eq!((f.degree(), printed.degree()), (Some(9), Some(9)));
    assert_eq!(f, &printed);
}

#[test]
fn space_curves_are_cut_out_alone() {
    let classics = [
        (
            "Example 3",
            "x = sin(t); y = cos(t); z = cos(t)^2",
            vec!["x^2 + y^2 - 1", "z + x^2 - 1"],
            4,
            1,
        ),
        (
            "twisted cubic",
            "x = t; y = t^2; z = t^3",
            vec!["x^2 - y", "x*z - y^2", "x*y - z"],
            3,
            1,
        ),
        (
            "Viviani's curve",
            "x = cos(t)^2; y = cos(t)sin(t); z = sin(t)",
            vec!["x^2 + y^2 - x", "x + z^2 - 1"],
            4,
            1,
        ),
        (
            "circle in a plane",
            "x = cos(t); y = sin(t); z = 2cos(t) + 1",
            vec!["2x - z + 1", "x^2 + y^2 - 1"],
            2,
            1,
        ),
        (
            "line",
            "x = t; y = 2t; z = 3t + 1",
            vec!["2x - y", "3x - z + 1"],
            1,
            1,
        ),
        (
            "cubic, run over twice",
            "x = t^2; y = t^4; z = t^6 + 1",
            vec!["x^2 - y", "x*z - y^2 - x", "x*y - z + 1"],
            3,
            2,
        ),
        (
            "Example 11",
            "x = cos(t); y = sin(t); z = sin(t)^5",
            vec!["x^2 + y^2 - 1"],
            10,
            1,
        ),
    ];
    for (name, form, equations, degree, index) in classics {
        let found = implicitize_space_curve(&space_curve(form), &Limits::none()).unwrap();
        let surfaces: Vec<_> = found
            .surfaces
            .iter()
            .map(|s| s.polynomial().clone())
            .collect();
        for (surface, text) in surfaces.iter().zip(&equations) {
            assert_eq!(surface, &space(text), "{name}");
        }
        if name != "Example 11" {
            assert_eq!(surfaces.len(), equations.len(), "{name}");
        }
        assert_eq!(
            (found.degree, found.tracing_index),
            (degree, index),
            "{name}"
        );
    }
}

#[test]
fn the_trefoil_lies_on_its_torus_and_no_quadric() {
    let text = "x = (2+cos(3t))cos(2t); y = (2+cos(3t))sin(2t); z = sin(3t)";
    let found = implicitize_space_curve(&space_curve(text), &Limits::none()).unwrap();
    assert_eq!((found.degree, found.tracing_index), (10, 1));
    let degrees: Vec<_> = found
        .surfaces
        .iter()
        .map(|s| s.polynomial().degree().unwrap())
        .collect();
    // By Riemann and Roch 35 − 41 < 0 quartics would be expected; there are three, the torus among them.
    assert_eq!(degrees, [4, 4, 4, 5]);
    // A generator may be changed by the others: on points of the torus off the curve one of them is not 0.
    let off = [Rational::from(3), Rational::from(0), Rational::from(0)];
    let on = found
        .surfaces
        .iter()
        .all(|s| s.polynomial().evaluate(&off).is_zero());
    assert!(on, "t = 0 is the point (3, 0, 0)");
    let off = [Rational::from(0), Rational::from(3), Rational::from(0)];
    assert!(
        found
            .surfaces
            .iter()
            .any(|s| !s.polynomial().evaluate(&off).is_zero())
    );
}

#[test]
fn theorem_3_names_the_spurious_components_of_example_3() {
    let curve = space_curve("x = sin(t); y = cos(t); z = cos(t)^2");
    let polar = polar_space_curve(&curve, &Limits::none()).unwrap();
    let (first, second) = (polar.first.unwrap(), polar.second.unwrap());
    // x² + y² + z² = 1 + z²/(x² + y²), and x² + y² + z² = 1 + z⁴/y⁴
    assert_eq!(
        first.equation,
        space("(x^2+y^2)*(x^2+y^2+z^2) - (x^2+y^2) - z^2")
    );
    assert_eq!(second.equation, space("y^4*(x^2+y^2+z^2) - y^4 - z^4"));
    assert_eq!(first.reduced(), space("x^2 + y^2 - 1"));
    let cylinder = space("x^2 + y^2 - 1");
    let found: Vec<_> = polar.components.iter().map(|[on, _]| on.clone()).collect();
    assert_eq!(found, [cylinder.clone(), cylinder]);
    let also: Vec<_> = polar
        .components
        .iter()
        .map(|[_, also]| also.clone())
        .collect();
    assert_eq!(also, [space("0x + z"), space("y^2 + z")]);
}

#[test]
fn what_real_parameters_do_not_reach() {
    let image = |text: &str| {
        let curve = plane_curve(text);
        let index = implicitize_plane(&curve, &Limits::none())
            .unwrap()
            .tracing_index;
        real_image(&curve, index, &Limits::none()).unwrap()
    };
    let point = |x: &str, y: &str| [x.parse().unwrap(), y.parse().unwrap()];
    let circle = image("x = (1-t^2)/(1+t^2); y = 2t/(1+t^2)");
    assert_eq!(circle.approached, Some(point("-1", "0")));
    assert!(circle.isolated.points.is_empty() && circle.isolated.complete);
    assert_eq!(image("x = cos(t); y = sin(t)").approached, None);

    // y² = x (x + 1)²: the origin of the loop is a point by itself.
    let cubic = image("x = t^2; y = t^3 + t");
    assert_eq!(
        cubic.isolated.points,
        [IsolatedPoint::Exact(point("-1", "0").to_vec())]
    );
    assert!(image("x = t^2; y = t^3 - t").isolated.points.is_empty());
    // A limaçon without loop has the origin, one with a loop passes through it.
    let limacon = image("x = (3 + cos(t))cos(t); y = (3 + cos(t))sin(t)");
    assert_eq!(
        limacon.isolated.points,
        [IsolatedPoint::Exact(point("0", "0").to_vec())]
    );
    let with_loop = image("x = (1/3 + cos(t))cos(t); y = (1/3 + cos(t))sin(t)");
    assert!(with_loop.isolated.points.is_empty() && with_loop.isolated.complete);

    // t⁴ + 8t² + 25 = (t² − √2 t + 5)(t² + √2 t + 5): two conjugate pairs with irrational sums.
    let quintic = image("x = t^4 + 8t^2 + 25; y = t*(t^4 + 8t^2 + 25)");
    assert_eq!(
        quintic.isolated.points,
        [IsolatedPoint::Exact(point("0", "0").to_vec())]
    );
    assert!(quintic.isolated.complete);
    let moved = image("x = t^4 + 8t^2 + 26; y = t*(t^4 + 8t^2 + 25)");
    assert_eq!(
        moved.isolated.points,
        [IsolatedPoint::Exact(point("1", "0").to_vec())]
    );
    // t² = −2 ± √2
    let two = image("x = t^2; y = t*(t^4 + 4t^2 + 2)");
    let mut found: Vec<f64> = Vec::new();
    for point in &two.isolated.points {
        let IsolatedPoint::Near(point) = point else {
            panic!("{point:?}");
        };
        assert!(point[1].abs() < 1e-30);
        found.push(point[0]);
    }
    found.sort_by(f64::total_cmp);
    // 2 − √2 is rounded once here and twice there.
    assert!((found[0] + (2f64.sqrt() + 2.0)).abs() < 1e-15);
    assert!((found[1] - (2f64.sqrt() - 2.0)).abs() < 2e-16 && found.len() == 2);
    // (t² − 1)² − 2 has four real zeros.
    let real = image("x = t^4 - 2t^2 - 1/2; y = t*(t^4 - 2t^2 - 1/2)");
    assert!(real.isolated.complete);

    assert!(
        matches!(image("x = t^2; y = t^4").coverage, Coverage::Part(turns) if turns == [0.0, f64::INFINITY])
    );
    assert_eq!(image("x = t^3; y = t^6 + 1").coverage, Coverage::Whole);
    assert_eq!(
        image("x = cos(3t)cos(t); y = cos(3t)sin(t)").coverage,
        Coverage::Whole
    );
    assert!(
        matches!(image("x = cos(t); y = cos(t)^2").coverage, Coverage::Part(turns) if turns.len() == 2)
    );
}

#[test]
fn example_4_has_more_than_the_patch() {
    let patch = patch("x = cos(theta)*sin(phi); y = cos(theta); z = cos(phi)");
    let surface = implicitize_patch(&patch, &Limits::none()).unwrap().surface;
    let beyond = point_beyond(&patch, &surface).unwrap();
    let value = beyond.point[beyond.coordinate];
    assert!(value.abs() > 1.0, "{beyond:?}");
    let at = beyond.point.map(|v| Rational::try_from(v).unwrap());
    assert!(surface.polynomial().evaluate(&at).is_zero(), "{beyond:?}");
    assert_eq!(
        beyond.bounds,
        [Some(Rational::from(-1)), Some(Rational::from(1))]
    );
}

#[test]
fn what_is_no_curve_or_surface_is_refused() {
    let limits = Limits::none();
    let message = |result: Result<(), stellate::error::Error>| result.unwrap_err().to_string();
    let constants = [RationalFunction::default(), RationalFunction::default()];
    let point = implicitize_plane(&PlaneCurve::new(Parameter::number("t"), constants), &limits);
    assert!(message(point.map(|_| ())).contains("a point, not a curve"));
    let thin = implicitize_patch(&patch("x = u + v; y = (u + v)^2; z = u + v"), &limits);
    assert!(message(thin.map(|_| ())).contains("move along a curve only"));
    let ray = polar_plane(&plane_curve("x = t; y = 2t"), &limits);
    assert!(message(ray.map(|_| ())).contains("on a line through the origin"));
    let cone = polar_patch(&patch("x = u; y = u*cos(v); z = u*sin(v)"), &limits);
    assert!(message(cone.map(|_| ())).contains("a cone"));
}
