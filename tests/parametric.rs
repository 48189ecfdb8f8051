//! Parametric → implicit in general: Theorems 1, 3 and 4, resultants and linear algebra; classics, laws and oracles.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use std::collections::BTreeMap;

use common::radii;
use malachite::Integer;
use malachite::base::polynomial::Polynomial;
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use stellate::exact::Rational;
use stellate::factor::factor_plane;
use stellate::implicitize::{
    Coverage, IsolatedPoint, PolarInverse, Role, SquaredForm, implicitize_patch, implicitize_plane,
    implicitize_space_curve, point_beyond, polar_patch, polar_plane, polar_space_curve, real_image,
};
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::poly::{
    IntegerPolynomial, PlanePolynomial, RationalFunction, Ring, SparsePolynomial,
};
use stellate::shape::{Form, Parameter, Patch, PlaneCurve, SpaceCurve};

fn read(text: &str) -> Form {
    parse_form(text, "<form>", Numbers::Exact).unwrap_or_else(|e| panic!("{e}"))
}

fn plane_curve(text: &str) -> PlaneCurve {
    match read(text) {
        Form::PlaneCurve(curve) => curve,
        other => panic!("{text}: {other:?}"),
    }
}

fn space_curve(text: &str) -> SpaceCurve {
    match read(text) {
        Form::SpaceCurve(curve) => curve,
        other => panic!("{text}: {other:?}"),
    }
}

fn patch(text: &str) -> Patch {
    match read(text) {
        Form::Patch(patch) => patch,
        other => panic!("{text}: {other:?}"),
    }
}

fn plane(text: &str) -> PlanePolynomial {
    match read(text) {
        Form::Curve(curve) => curve.polynomial().primitive(),
        other => panic!("{text}: {other:?}"),
    }
}

/// `+ 0z` makes it a surface.
fn space(text: &str) -> SparsePolynomial<3> {
    match read(&format!("{text} + 0z")) {
        Form::Surface(surface) => surface.polynomial().primitive(),
        other => panic!("{text}: {other:?}"),
    }
}

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
        [IsolatedPoint::Exact(point("-1", "0"))]
    );
    assert!(image("x = t^2; y = t^3 - t").isolated.points.is_empty());
    // A limaçon without loop has the origin, one with a loop passes through it.
    let limacon = image("x = (3 + cos(t))cos(t); y = (3 + cos(t))sin(t)");
    assert_eq!(
        limacon.isolated.points,
        [IsolatedPoint::Exact(point("0", "0"))]
    );
    let with_loop = image("x = (1/3 + cos(t))cos(t); y = (1/3 + cos(t))sin(t)");
    assert!(with_loop.isolated.points.is_empty() && with_loop.isolated.complete);

    // t⁴ + 8t² + 25 = (t² − √2 t + 5)(t² + √2 t + 5): two conjugate pairs with irrational sums.
    let quintic = image("x = t^4 + 8t^2 + 25; y = t*(t^4 + 8t^2 + 25)");
    assert_eq!(
        quintic.isolated.points,
        [IsolatedPoint::Exact(point("0", "0"))]
    );
    assert!(quintic.isolated.complete);
    let moved = image("x = t^4 + 8t^2 + 26; y = t*(t^4 + 8t^2 + 25)");
    assert_eq!(
        moved.isolated.points,
        [IsolatedPoint::Exact(point("1", "0"))]
    );
    // t² = −2 ± √2
    let two = image("x = t^2; y = t*(t^4 + 4t^2 + 2)");
    let mut found: Vec<f64> = Vec::new();
    for point in &two.isolated.points {
        let IsolatedPoint::Near([x, y]) = point else {
            panic!("{point:?}");
        };
        assert!(y.abs() < 1e-30);
        found.push(*x);
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
    let point = implicitize_plane(&plane_curve("x = 1; y = cos(t)^2 + sin(t)^2"), &limits);
    assert!(message(point.map(|_| ())).contains("a point, not a curve"));
    let thin = implicitize_patch(&patch("x = u + v; y = (u + v)^2; z = u + v"), &limits);
    assert!(message(thin.map(|_| ())).contains("move along a curve only"));
    let ray = polar_plane(&plane_curve("x = t; y = 2t"), &limits);
    assert!(message(ray.map(|_| ())).contains("on a line through the origin"));
    let cone = polar_patch(&patch("x = u; y = u*cos(v); z = u*sin(v)"), &limits);
    assert!(message(cone.map(|_| ())).contains("a cone"));
}

fn polynomial(coefficients: &[i64]) -> IntegerPolynomial {
    let coefficients = coefficients.iter().map(|&c| Integer::from(c));
    IntegerPolynomial::from_coefficients_asc(coefficients.collect())
}

fn function() -> impl Strategy<Value = RationalFunction> {
    let coefficients = || prop::collection::vec(-5i64..6, 1..5);
    let denominator = prop_oneof![Just(vec![1]), coefficients()];
    (coefficients(), denominator).prop_filter_map("a denominator", |(p, q)| {
        RationalFunction::new(polynomial(&p), polynomial(&q))
    })
}

fn curves() -> impl Strategy<Value = PlaneCurve> {
    (function(), function())
        .prop_map(|(x, y)| PlaneCurve::new(Parameter::number("t"), [x, y]))
        .prop_filter("not a point", |c| !c.is_point())
}

/// f at a point, in num-rational's arithmetic.
fn value(f: &SparsePolynomial<3>, point: &[Rational]) -> BigRational {
    let big = |q: &Rational| q.to_string().parse::<BigRational>().unwrap();
    let zero = BigRational::from(BigInt::from(0));
    f.terms().fold(zero, |sum, (e, c)| {
        let powers = point
            .iter()
            .zip(e)
            .map(|(x, &k)| big(x).pow(i32::try_from(k).unwrap()));
        sum + powers.fold(big(c), |product, power| product * power)
    })
}

/// The equation of least degree at most `degree` through many points of a curve, by Gauss over the fractions of
/// num-rational: monomials one by one until one depends on those before it.
fn naive_equation(curve: &PlaneCurve, degree: usize) -> Option<PlanePolynomial> {
    let points: Vec<[BigRational; 2]> = (2i64..)
        .filter_map(|s| curve.point(&Rational::from(s)))
        .take((degree + 1) * (degree + 2))
        .map(|p| p.map(|v| v.to_string().parse().unwrap()))
        .collect();
    let zero = BigRational::from(BigInt::from(0));
    // Each basis vector: its values at the points, and how it is made of monomials.
    type Row = (Vec<BigRational>, BTreeMap<(usize, usize), BigRational>);
    let mut rows: Vec<(usize, Row)> = Vec::new();
    for total in 0..=degree {
        for i in 0..=total {
            let j = total - i;
            let power = |x: &BigRational, k: usize| x.pow(i32::try_from(k).unwrap());
            let mut values: Vec<_> = points
                .iter()
                .map(|[x, y]| power(x, i) * power(y, j))
                .collect();
            let mut made = BTreeMap::from([((i, j), BigRational::from(BigInt::from(1)))]);
            for (pivot, (other, other_made)) in &rows {
                let factor = &values[*pivot] / &other[*pivot];
                for (v, o) in values.iter_mut().zip(other) {
                    *v -= &factor * o;
                }
                for (e, c) in other_made {
                    *made.entry(*e).or_insert_with(|| zero.clone()) -= &factor * c;
                }
            }
            match values.iter().position(|v| *v != zero) {
                Some(pivot) => rows.push((pivot, (values, made))),
                None => {
                    let terms = made.into_iter();
                    let terms = terms.map(|(e, c)| (e, c.to_string().parse().unwrap()));
                    return Some(PlanePolynomial::from_terms(terms).primitive());
                }
            }
        }
    }
    None
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn an_equation_vanishes_on_its_curve_and_is_irreducible(curve in curves()) {
        let limits = Limits::none();
        let found = implicitize_plane(&curve, &limits).unwrap();
        let f = SparsePolynomial::<3>::from(found.curve.polynomial());
        for s in [-7, 2, 11] {
            if let Some(point) = curve.point(&Rational::from(s)) {
                prop_assert_eq!(value(&f, &point), BigRational::from(BigInt::from(0)));
            }
        }
        let factors = factor_plane(found.curve.polynomial(), &limits).unwrap().factors;
        prop_assert_eq!((factors.len(), factors[0].multiplicity), (1, 1));
        // The degree in x is that of y(s) over the tracing index.
        let degree = |v: usize| f.terms().map(|(e, _)| e[v] as usize).max().unwrap();
        let [x, y] = curve.coordinates();
        prop_assert_eq!(degree(0) * found.tracing_index, y.degree());
        prop_assert_eq!(degree(1) * found.tracing_index, x.degree());
    }

    #[test]
    fn the_polar_way_gives_the_same(curve in curves()) {
        let limits = Limits::none();
        match polar_plane(&curve, &limits) {
            Ok(polar) => prop_assert_eq!(polar.curve, implicitize_plane(&curve, &limits).unwrap().curve),
            Err(error) => {
                let text = error.to_string();
                prop_assert!(text.contains("x = 0") || text.contains("line through the origin"), "{}", text);
            }
        }
    }

    #[test]
    fn running_twice_over_a_curve_doubles_the_index(curve in curves(), a in -4i64..5, b in 1i64..5) {
        // s → (s² + a)/(b s)
        let limits = Limits::none();
        let inner = RationalFunction::new(polynomial(&[a, 0, 1]), polynomial(&[0, b])).unwrap();
        prop_assume!(inner.degree() == 2);
        let composed = curve.coordinates().each_ref().map(|f| {
            let at = |p: &IntegerPolynomial| {
                let zero = RationalFunction::new(polynomial(&[]), polynomial(&[1])).unwrap();
                p.coefficients_asc().iter().rev().fold(zero, |v, c| {
                    v.times(&inner).plus_constant(&Rational::from(c))
                })
            };
            at(f.numerator()).times(&at(f.denominator()).recip().unwrap())
        });
        let twice = PlaneCurve::new(Parameter::number("t"), composed);
        let (once, twice) = (implicitize_plane(&curve, &limits).unwrap(), implicitize_plane(&twice, &limits).unwrap());
        prop_assert_eq!(twice.tracing_index, 2 * once.tracing_index);
        prop_assert_eq!(twice.curve, once.curve);
    }

    #[test]
    fn gauss_over_fractions_finds_the_same(curve in curves()) {
        let found = implicitize_plane(&curve, &Limits::none()).unwrap().curve;
        let degree = found.polynomial().degree().unwrap();
        prop_assume!(degree <= 4);
        let naive = naive_equation(&curve, degree);
        prop_assert_eq!(naive.as_ref(), Some(found.polynomial()));
    }

    #[test]
    fn a_patch_built_backwards_from_a_graph(
        terms in prop::collection::vec(([0u32..4, 0u32..4], -9i64..10), 1..5),
        shear in [-3i64..4, -3i64..4, -3i64..4],
    ) {
        // z = p(x, y) after x → x + a y, y → y + b z, z → z + c x of space.
        let p = SparsePolynomial::<2>::from_terms(terms.iter().map(|&(e, c)| (e, Rational::from(c))));
        prop_assume!(p.degree() > Some(0) && p.degree() <= Some(4));
        let [a, b, c] = shear;
        let formula = |p: &SparsePolynomial<2>, [x, y]: [&str; 2]| {
            let terms = p.terms().map(|(e, c)| format!("({c})*({x})^{}*({y})^{}", e[0], e[1]));
            terms.collect::<Vec<_>>().join(" + ")
        };
        let z = formula(&p, ["u", "v"]);
        let text = format!("x = u + ({a})*v; y = v + ({b})*({z}); z = {z} + ({c})*(u + ({a})*v)");
        // Backwards: z' = z − c x, y' = y − b z', x' = x − a y'.
        let (back_z, back_y) = (format!("(z - ({c})*x)"), format!("(y - ({b})*(z - ({c})*x))"));
        let back_x = format!("(x - ({a})*{back_y})");
        let expected = space(&format!("{back_z} - ({})", formula(&p, [&back_x, &back_y])));
        let found = implicitize_patch(&patch(&text), &Limits::none()).unwrap();
        prop_assert_eq!(found.surface.polynomial(), &expected, "{}", text);
        prop_assert_eq!(found.tracing_index, Some(1));
    }

    #[test]
    fn every_equation_of_a_space_curve_vanishes_on_it(x in function(), y in function(), z in function()) {
        let curve = SpaceCurve::new(Parameter::number("t"), [x, y, z]);
        prop_assume!(!curve.is_point());
        let found = implicitize_space_curve(&curve, &Limits::none()).unwrap();
        prop_assume!(found.degree <= 8);
        prop_assert!(found.surfaces.len() >= 2);
        let zero = BigRational::from(BigInt::from(0));
        for s in [-9, 4, 13] {
            if let Some(point) = curve.point(&Rational::from(s)) {
                for surface in &found.surfaces {
                    prop_assert_eq!(value(surface.polynomial(), &point), zero.clone());
                }
                // A point beside the curve, on a line that meets it once more at most seldom, is cut off.
                let beside = [&point[0] + &Rational::from(1), point[1].clone(), point[2].clone()];
                let all = found.surfaces.iter().all(|s| value(s.polynomial(), &beside) == zero);
                if all {
                    // Then it is on the curve: some parameter value gives it.
                    let common = curve.coordinates().iter().zip(&beside).fold(polynomial(&[]), |g, (f, v)| {
                        stellate::poly::polynomial_gcd(&g, f.plus_constant(&-v.clone()).numerator())
                    });
                    prop_assert!(common.coefficients_asc().len() != 1, "{:?}", beside);
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn a_radius_gives_the_polynomial_of_theorem_2(radius in radii(8)) {
        let form = SquaredForm::new(&radius).unwrap();
        let found = implicitize_plane(&radius.to_plane_curve(), &Limits::none()).unwrap();
        let expected = form.expand();
        prop_assert_eq!(found.curve.polynomial(), expected.polynomial());
        // Odd harmonics alone run over the curve twice.
        prop_assert_eq!(found.tracing_index, if form.is_perfect_square() { 2 } else { 1 });
    }
}
