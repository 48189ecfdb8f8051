//! Superquadrics in space (Example 10, Eq. (77)).

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::common::program::{done, json, piped, run_in};
use proptest::prelude::*;
use stellate::document::{Format, write_form};
use stellate::exact::Rational;
use stellate::language::{Numbers, parse_form};
use stellate::parametrize::parametrize_space_superquadric;
use stellate::poly::SpacePolynomial;
use stellate::sample::{Ray, RaySolver, Sample, SpaceDirection, UnitVector, solve_radial};
use stellate::shape::{Form, Radial, SpaceSuperquadric};

fn shape(text: &str) -> SpaceSuperquadric {
    match parse_form(text, "<form>", Numbers::Exact).unwrap() {
        Form::SpaceSuperquadric(shape) => shape,
        other => panic!("{other:?}"),
    }
}

fn points(ray: Ray<3>) -> Vec<Sample<3>> {
    match ray {
        Ray::Points(points) => points,
        Ray::Line => panic!("a line"),
    }
}

/// Where there is a polynomial its certified roots are the same doubles, bit for bit.
#[test]
fn points_are_those_of_the_polynomial() {
    for text in [
        "superquadric 3d a=1,1,2 e=1/2,1",
        "superquadric 3d a=1,2/3,3 e=1/3,1",
        "superquadric 3d a=2,2,1 e=1,1",
        "superquadric 3d a=1,3,1 e=1/4,1/2 level=5",
        // ε2/ε1 = 1/3
        "superquadric 3d a=1,2,1 e=1,1/3",
    ] {
        let shape = shape(text);
        let polynomial = SpacePolynomial::from(&shape.polynomial().unwrap());
        let roots = RaySolver::new(&polynomial);
        let grid = SpaceDirection::grid(8, 4).into_iter();
        for direction in grid.chain(SpaceDirection::fibonacci(20)) {
            // Multiplicities differ: ε2/ε1 = 1/3 makes the poles triple roots of the polynomial.
            let places = |ray| -> Vec<(f64, [f64; 3])> {
                points(ray).iter().map(|p| (p.r, p.position)).collect()
            };
            let found = places(solve_radial(&shape, &direction).unwrap());
            assert_eq!(found, places(roots.solve(&direction)), "{text}");
        }
    }
}

/// |x| + |y| + |z| = 1 has exact rational radii, also ones that are doubles: ties of the comparison.
#[test]
fn the_octahedron_is_exact() {
    let octahedron = shape("superquadric 3d a=1,1,1 e=2,2");
    for direction in SpaceDirection::grid(12, 6) {
        let unit = direction.components();
        let sum = unit.iter().fold(Rational::zero(), |sum, u| sum + u.abs());
        let exact = sum.recip().unwrap();
        let found = points(solve_radial(&octahedron, &direction).unwrap());
        assert_eq!(found[0].r.to_bits(), exact.to_f64().to_bits());
        let on = unit.each_ref().map(|u| u * &exact);
        assert_eq!(octahedron.compare(&on).unwrap(), std::cmp::Ordering::Equal);
    }
}

fn small() -> impl Strategy<Value = Rational> {
    (1i64..6, 1i64..5).prop_map(|(p, q)| Rational::from(p) / Rational::from(q))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Any rational exponents: the certified radius is the closed form's, and that satisfies Eq. (77) as corrected.
    #[test]
    fn the_closed_form_is_the_certified_radius(a in prop::array::uniform3(small()), e in prop::array::uniform2(small()), level in small()) {
        let shape = SpaceSuperquadric::new(a.clone(), e.clone(), level.clone()).unwrap();
        let closed = parametrize_space_superquadric(&shape);
        for direction in SpaceDirection::fibonacci(5) {
            let found = points(solve_radial(&shape, &direction).unwrap());
            prop_assert_eq!(found.len(), 2);
            let unit = direction.components().map(|u| u.to_f64());
            let formula = closed.branches[0].radius.approximate(unit);
            prop_assert!((formula / found[0].r - 1.0).abs() < 1e-11);
            let [x, y, z] = found[0].position;
            let [a1, a2, a3] = a.each_ref().map(Rational::to_f64);
            let [e1, e2] = e.each_ref().map(Rational::to_f64);
            let around = (x / a1).abs().powf(2.0 / e2) + (y / a2).abs().powf(2.0 / e2);
            let left = around.powf(e2 / e1) + (z / a3).abs().powf(2.0 / e1);
            prop_assert!((left / level.to_f64() - 1.0).abs() < 1e-10);
        }
    }

    /// Text and JSON are read back.
    #[test]
    fn documents_are_read_back(a in prop::array::uniform3(small()), e in prop::array::uniform2(small()), level in small()) {
        let shape = SpaceSuperquadric::new(a, e, level).unwrap();
        for format in [Format::Text, Format::Json] {
            let mut out = Vec::new();
            write_form(&Form::SpaceSuperquadric(shape.clone()), &[], format, &mut out).unwrap();
            let text = String::from_utf8(out).unwrap();
            let form = match format {
                Format::Json => stellate::reading::read_document(&text, "<form>", Numbers::Exact).unwrap(),
                _ => parse_form(&text, "<form>", Numbers::Exact).unwrap(),
            };
            prop_assert_eq!(form, Form::SpaceSuperquadric(shape.clone()));
        }
    }
}

#[test]
fn on_the_command_line() {
    let text = "superquadric 3d a=1,1,2 e=1/2,1";
    assert_eq!(
        done(&["implicitize", text]),
        "16x^4 + 32x^2y^2 + 16y^4 + z^4 - 16 = 0\n"
    );
    let description = json(&done(&["describe", text, "--format", "json"]));
    assert_eq!(description["degree"], 4);
    assert_eq!(description["convex"], true);
    assert_eq!(description["superquadric"]["dimension"], 3);
    let parametric = json(&done(&["parametrize", text, "--format", "json"]));
    assert_eq!(parametric["method"], "lemma-7");
    assert_eq!(
        parametric["parameters"],
        serde_json::json!(["theta", "phi"])
    );
    let document = description["superquadric"].to_string();
    let rows = piped(
        &["sample", "-", "--phi", "0", "--theta", "0", "--positive"],
        &document,
    );
    assert!(
        rows.ends_with("0,0.0,0.0,0,0,1,2.0,0.0,0.0,2.0,1\n"),
        "{rows}"
    );
}

#[test]
fn what_cannot_be_done_says_why() {
    let here = std::path::Path::new(".");
    for (arguments, said) in [
        (
            ["implicitize", "superquadric 3d a=1,1,1 e=1,1/2"],
            "second sheet",
        ),
        (
            ["implicitize", "superquadric 3d a=1,1,1 e=3,3"],
            "must be even integers",
        ),
        (
            ["describe", "superquadric 3d a=1,1,1 e=1"],
            "expected two numbers, found 1",
        ),
        (
            ["describe", "superquadric 3d a=1,1,0 e=1,1"],
            "must be positive",
        ),
        (
            ["describe", "superquadric 3d a=1,1,1 e=1,99999"],
            "at most 10000",
        ),
        (
            ["implicitize", "superquadric 3d a=1,1,1 e=1/10000,1/9999"],
            "its numerator and denominator are at most 1000",
        ),
    ] {
        let run = run_in(here, &arguments, "");
        assert_ne!(run.code, 0);
        assert!(run.err.contains(said), "{arguments:?}: {}", run.err);
        assert!(run.out.is_empty());
    }
}
