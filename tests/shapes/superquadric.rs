//! Superquadrics in the plane (Example 6): the language, the verbs, and points against the exact equation.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::cmp::Ordering;
use std::path::Path;

use proptest::prelude::*;
use stellate::document::{Format, write_form};
use stellate::exact::Rational;
use stellate::language::{Numbers, parse_form};
use stellate::reading::read_text;
use stellate::sample::{Direction, Ray, RaySolver, Sample, solve_radial};
use stellate::shape::{Form, Radial, Superquadric};

use crate::common::forms::refusal;
use crate::common::program::{Run, done, json, piped, run_in};

fn rational(p: i64, q: i64) -> Rational {
    Rational::from(p) / Rational::from(q)
}

fn shape(text: &str) -> Superquadric {
    match parse_form(text, "<form>", Numbers::Exact) {
        Ok(Form::Superquadric(shape)) => shape,
        other => panic!("{text}: {other:?}"),
    }
}

fn run(arguments: &[&str]) -> Run {
    run_in(Path::new("."), arguments, "")
}

fn positive() -> impl Strategy<Value = Rational> {
    (1i64..40, 1i64..40).prop_map(|(p, q)| rational(p, q))
}

fn superquadrics() -> impl Strategy<Value = Superquadric> {
    let epsilon = (1i64..9, 1i64..9).prop_map(|(p, q)| rational(p, q));
    ([positive(), positive()], epsilon, positive())
        .prop_map(|(a, e, c)| Superquadric::new(a, e, c).unwrap())
}

fn points(shape: &Superquadric, direction: &Direction) -> Vec<Sample> {
    match solve_radial(shape, direction).unwrap() {
        Ray::Points(points) => points,
        Ray::Line => panic!("no lines"),
    }
}

#[test]
fn the_parameters_may_come_in_any_order_and_notation() {
    let expected = shape("superquadric 2d a=1,2 e=1/2");
    assert_eq!(expected.exponent(), Rational::from(4));
    assert_eq!(expected.level(), &Rational::one());
    for text in [
        "superquadric 2d e=0.5 a=1,2",
        "# Example 6\nsuperquadric 2d\n  a = 1, 2   # semi-axes\n  e = 2/4;",
        " superquadric 2D level=1 a=1,20e-1 e=1/2",
    ] {
        assert_eq!(shape(text), expected, "{text}");
    }
    assert_eq!(
        shape("superquadric 2d a=1,1 e=3 level=0.3").level(),
        &rational(3, 10)
    );
}

#[test]
fn what_is_wrong_is_pointed_at() {
    for (text, message, at) in [
        (
            "superquadric",
            "expected `2d` or `3d` after `superquadric`",
            "",
        ),
        (
            "superquadric a=1,2 e=1",
            "expected `2d` or `3d` after `superquadric`",
            "a=1",
        ),
        (
            "superquadric 3d a=1,2 e=1/2,1",
            "expected three numbers in space, found 2",
            "1,2 e",
        ),
        (
            "superquadric 2d e=1/2",
            "missing `a=a1,a2`, the semi-axes",
            "",
        ),
        ("superquadric 2d a=1,2", "missing `e=…`", ""),
        ("superquadric 2d a=1,2 e=1 e=2", "a second `e=`", "e=2"),
        (
            "superquadric 2d a=1 e=1",
            "expected two numbers in the plane, found 1",
            "1 e",
        ),
        (
            "superquadric 2d a=1,2,3 e=1",
            "expected two numbers in the plane, found 3",
            "1,2,3",
        ),
        (
            "superquadric 2d a=1,2 e=1,2",
            "expected one number, found 2",
            "1,2",
        ),
        ("superquadric 2d a=0,2 e=1", "it must be positive", "0,2"),
        (
            "superquadric 2d a=1,2 e=-1/2",
            "it must be positive",
            "-1/2",
        ),
        ("superquadric 2d a=1,2 e=0", "it must be positive", "0"),
        (
            "superquadric 2d a=1,2 e=1 level=0",
            "it must be positive",
            "0",
        ),
        (
            "superquadric 2d a=1,sqrt(2) e=1",
            "expected a number",
            "sqrt",
        ),
        ("superquadric 2d a=1,2 e=1/0", "the denominator is 0", "1/0"),
        ("superquadric 2d a=1,2 e", "expected `=`", ""),
        ("superquadric 2d a 1,2 e=1", "expected `=`", "1,2"),
        (
            "superquadric 2d b=1,2 e=1",
            "expected a parameter a, e or level, found `b`",
            "b=",
        ),
        (
            "# center: 1, 2\nsuperquadric 2d a=1,2 e=1",
            "it has no center",
            "# center",
        ),
    ] {
        let (shown, rest) = refusal(text, parse_form(text, "<form>", Numbers::Exact));
        assert!(shown.contains(message), "{text}: {shown}");
        assert!(rest.starts_with(at), "{text}: at {rest}");
        assert!(!at.is_empty() || rest.is_empty(), "{text}: at {rest}");
    }
    let run = run(&["sample", "superquadric 2d a=1,2 e=1/10001"]);
    assert_eq!(run.code, 3, "{}", run.err);
    assert!(run.err.contains("at most 10000"), "{}", run.err);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

    #[test]
    fn a_superquadric_is_written_and_read_back(shape in superquadrics()) {
        for format in [Format::Text, Format::Json] {
            let mut out = Vec::new();
            write_form(&Form::Superquadric(shape.clone()), &[], format, &mut out).unwrap();
            let text = String::from_utf8(out).unwrap();
            prop_assert_eq!(read_text(&text, "<form>", Numbers::Exact).unwrap(), Form::Superquadric(shape.clone()));
        }
    }

    #[test]
    fn for_even_exponents_the_points_are_those_of_the_polynomial(
        a in [positive(), positive()], c in positive(), half in 1i64..8, theta in 0.0f64..6.3,
    ) {
        let shape = Superquadric::new(a, rational(1, half), c).unwrap();
        let polynomial = shape.polynomial().unwrap();
        prop_assert_eq!(polynomial.degree(), Some(usize::try_from(2 * half).unwrap()));
        let solver = RaySolver::new(&polynomial);
        let directions = [Direction::from_radians(theta), Direction::from_degrees(&Rational::from(180))];
        for direction in directions {
            prop_assert_eq!(Ray::Points(points(&shape, &direction)), solver.solve(&direction));
        }
    }

    #[test]
    fn the_exact_curve_is_between_the_neighbouring_doubles(shape in superquadrics(), theta in 0.0f64..6.3) {
        let direction = Direction::from_radians(theta);
        let at = |r: f64| {
            let r = Rational::try_from(r).unwrap();
            shape.compare(&[&r * &direction.u(), &r * &direction.v()]).unwrap()
        };
        let both = points(&shape, &direction);
        let [positive, negative] = &both[..] else { panic!("two points") };
        prop_assert!(positive.r > 0.0 && negative.r < 0.0);
        prop_assert!(at(positive.r.next_down()) == Ordering::Less);
        prop_assert!(at(positive.r.next_up()) == Ordering::Greater);
        let bits = |p: &Sample, sign: f64| [p.r, p.position[0], p.position[1]].map(|v| (sign * v).to_bits());
        prop_assert_eq!(bits(positive, -1.0), bits(negative, 1.0));
        // Doubles agree as far as they can.
        let about = shape.approximate(theta);
        prop_assert!((about - positive.r).abs() < 1e-5 * positive.r, "{} {}", about, positive.r);
    }

    #[test]
    fn points_with_rational_roots_are_exactly_on_the_curve(
        x in 1i64..30, y in 1i64..30, p in 1u32..5, q in 1u32..5, a in [positive(), positive()],
    ) {
        // α = (x^q)^p: its q-th root is x^p.
        let point = |n: i64, axis: &Rational| Rational::from(n).pow(i64::from(q)).unwrap() * axis;
        let level = Rational::from(x).pow(i64::from(p)).unwrap() + Rational::from(y).pow(i64::from(p)).unwrap();
        let epsilon = rational(2 * i64::from(q), i64::from(p));
        let [px, py] = [point(x, &a[0]), -point(y, &a[1])];
        let shape = Superquadric::new(a, epsilon.clone(), level.clone()).unwrap();
        prop_assert_eq!(shape.compare(&[px.clone(), py.clone()]).unwrap(), Ordering::Equal);
        let little = rational(1, 1 << 60);
        prop_assert_eq!(shape.compare(&[&px + &little, py.clone()]).unwrap(), Ordering::Greater);
        prop_assert_eq!(shape.compare(&[px.clone(), &py + &little]).unwrap(), Ordering::Less);
    }
}

#[test]
fn the_points_on_the_axes_are_exact() {
    // |x/3|^(2/3) + |y|^(2/3) = 4: x = 3·8, y = 8
    let out = done(&[
        "sample",
        "superquadric 2d a=3,1 e=3 level=4",
        "--directions",
        "4",
        "--positive",
    ]);
    assert_eq!(
        out,
        "branch,theta,u,v,r,x,y,multiplicity\n\
         0,0.0,1,0,24.0,24.0,0.0,1\n\
         0,1.5707963267948966,0,1,8.0,0.0,8.0,1\n\
         0,3.141592653589793,-1,0,24.0,-24.0,0.0,1\n\
         0,4.71238898038469,0,-1,8.0,0.0,-8.0,1\n"
    );
}

#[test]
fn points_beyond_the_doubles_are_infinite_and_roots_have_a_limit() {
    let out = done(&[
        "sample",
        "superquadric 2d a=1,1 e=1000 level=1e10",
        "--theta",
        "0",
        "--positive",
    ]);
    assert!(out.ends_with("0,0.0,1,0,inf,inf,0.0,1\n"), "{out}");
    let run = run(&[
        "sample",
        "superquadric 2d a=1e20000,1 e=1/500",
        "--theta",
        "0",
    ]);
    assert_eq!(run.code, 3);
    assert!(run.err.contains("bits"), "{}", run.err);
    assert!(run.out.is_empty());
}

#[test]
fn describe_says_what_is_certain() {
    let out = done(&["describe", "superquadric 2d a=1,2 e=3"]);
    assert_eq!(
        out,
        "superquadric: |x|^(2/3) + |y/2|^(2/3) = 1\n\
         exponent 2/e: 2/3\n\
         degree: none (no polynomial as it stands: 2/e is not an even integer)\n\
         method: lemma-2\n\
         star-shaped (r > 0 everywhere, certified): yes\n\
         convex: no (2/e < 1)\n\
         note: four cusps, on the axes\n"
    );
    let document = json(&done(&[
        "describe",
        "superquadric 2d a=1,2 e=1/3",
        "--format",
        "json",
    ]));
    assert_eq!(document["kind"], "description");
    assert_eq!(document["degree"], json("6"));
    assert_eq!(document["convex"], true);
    assert_eq!(document["superquadric"]["e"], json(r#"["1/3"]"#));
}

#[test]
fn implicitize_gives_the_polynomial_or_the_reason() {
    assert_eq!(
        done(&["implicitize", "superquadric 2d a=1,2 e=1/2 level=3"]),
        "16x^4 + y^4 - 48 = 0\n"
    );
    for e in ["2", "3/2", "2/3"] {
        let run = run(&["implicitize", &format!("superquadric 2d a=1,2 e={e}")]);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "e = {e}");
        assert!(
            run.err.contains("only for an even integer n = 2/e"),
            "{}",
            run.err
        );
    }
}

#[test]
fn parametrize_writes_eq_20_in_every_format() {
    let written = |e: &str, format: &str| {
        let form = format!("superquadric 2d a=1,2 e={e} level=3");
        let out = done(&["parametrize", &form, "--format", format]);
        // The form stands in a comment.
        let radius = out.lines().rfind(|line| !line.starts_with('#'));
        radius.unwrap().to_owned()
    };
    assert_eq!(
        written("1/2", "text"),
        "r = root(3/(cos(theta)^4 + (sin(theta)/2)^4), 4)"
    );
    assert_eq!(
        written("3", "text"),
        "r = (3/(abs(cos(theta))^(2/3) + abs(sin(theta)/2)^(2/3)))^(3/2)"
    );
    assert_eq!(
        written("2", "text"),
        "r = 3/(abs(cos(theta)) + abs(sin(theta)/2))"
    );
    assert_eq!(
        written("3", "sympy"),
        "(3/(Abs(cos(theta))**Rational(2, 3) + Abs(sin(theta)/2)**Rational(2, 3)))**Rational(3, 2)"
    );
    assert_eq!(
        written("3", "maple"),
        "r = (3/(abs(cos(theta))^(2/3) + abs(sin(theta)/2)^(2/3)))^(3/2);"
    );
    assert_eq!(
        written("3", "latex"),
        "r = \\left(\\frac{3}{\\left|\\cos \\theta\\right|^{2/3} + \\left|\\frac{\\sin \\theta}{2}\\right|^{2/3}}\\right)^{3/2}"
    );
    let text = done(&["parametrize", "superquadric 2d a=1,2 e=1/2"]);
    assert!(text.starts_with("# lemma-2 in r^4\n"), "{text}");
    assert!(
        text.contains("# branch 0: r real for theta in [0, 2*pi]; r > 0 for theta in [0, 2*pi]\n")
    );
}

#[test]
fn a_parametric_document_is_read_back() {
    let form = "superquadric 2d a=1,2 e=3 level=1/2";
    let document = done(&["parametrize", form, "--format", "json"]);
    let again = piped(&["sample", "-", "--directions", "3"], &document);
    assert_eq!(again, done(&["sample", form, "--directions", "3"]));
    for (from, to, message) in [
        (
            r#""e":["3"]"#,
            r#""e":["-3"]"#,
            "superquadric.e[0]: it must be positive",
        ),
        (
            r#""dimension":2"#,
            r#""dimension":4"#,
            "superquadric.dimension: expected 2 or 3",
        ),
        (
            r#""a":["1","2"]"#,
            r#""a":["1"]"#,
            "superquadric.a: expected a list of 2, found 1",
        ),
    ] {
        let run = run_in(
            Path::new("."),
            &["sample", "-"],
            &document.replace(from, to),
        );
        assert_eq!(run.code, 2);
        assert!(run.err.contains(message), "{}", run.err);
    }
}

#[test]
fn the_printed_equation_20_does_not_give_the_printed_radius() {
    // Printed: [(x/a1)^(2/ε) + (y/a2)^(2/ε) − a]^(ε2/ε1) = 1, so the bracket is 1: level a + 1, not a.
    let printed = shape("superquadric 2d a=1,2 e=1/2 level=4");
    let correct = shape("superquadric 2d a=1,2 e=1/2 level=3");
    let radius = |theta: f64| {
        let (c, s) = (theta.cos(), (theta.sin() / 2.0));
        (3.0 / (c.powi(4) + s.powi(4))).powf(0.25)
    };
    for theta in [0.0, 0.4, 1.1, 2.0] {
        assert!((correct.approximate(theta) - radius(theta)).abs() < 1e-14);
        assert!((printed.approximate(theta) - radius(theta)).abs() > 1e-2);
    }
}
