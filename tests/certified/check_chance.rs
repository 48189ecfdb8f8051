//! What is alike by chance, and what has no answer: neither is named as a mistake, and nothing stops.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use stellate::check::{Comparison, GivenPoint, GivenRadius, Reference};
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::shape::{Form, FourierRadius};

use crate::common::float_program::{lopsided, names};

fn form(text: &str) -> Form {
    parse_form(text, "<form>", Numbers::Exact).unwrap()
}

fn radius(text: &str) -> FourierRadius {
    match form(text) {
        Form::Fourier(radius) => radius,
        _ => panic!("a radius"),
    }
}

fn reference(text: &str) -> Reference {
    match form(text) {
        Form::Fourier(radius) => Reference::of_radius(&radius).unwrap(),
        Form::Curve(curve) => Reference::of_curve(&curve),
        _ => panic!("a plane curve"),
    }
}

fn radii_of(right: &FourierRadius, changed: impl Fn(f64) -> f64) -> Comparison {
    let radii = (0..21).map(|k| {
        let theta = 0.3 * f64::from(k);
        let r = changed(right.approximate(theta));
        GivenRadius { line: 1, theta, r }
    });
    let radii: Vec<GivenRadius> = radii.collect();
    let reference = Reference::of_radius(right).unwrap();
    reference.check_radii(&radii, &Limits::none()).unwrap()
}

/// A common ratio is called equal to a fraction only if it is, as far as doubles can tell.
#[test]
fn ratios_are_fractions_only_if_they_are() {
    let right = radius("r = 1 + 1/5*cos(3t) - 1/10*sin(2t)");
    for (factor, expected) in [
        (1.5, "got/exact = 3/2"),
        (10.0 / 3.0, "got/exact = 10/3"),
        (-4.0, "got/exact = -4"),
        (std::f64::consts::PI, "got/exact ≈ 3.1415926535898"),
        (std::f64::consts::FRAC_1_PI, "got/exact ≈ 0.31830988618379"),
        (std::f64::consts::SQRT_2, "got/exact ≈ 1.4142135623731"),
        (1.732_050_8, "got/exact ≈ 1.7320508"),
        (std::f64::consts::E, "got/exact ≈ 2.718281828459"),
        (3.333_333_3, "got/exact ≈ 3.3333333"),
    ] {
        let found = radii_of(&right, |r| factor * r);
        assert_eq!(names(&found), ["no correct digit"], "{factor}");
        let said = &found.diagnoses[0].explanation;
        assert!(said.ends_with(expected), "{factor}: {said}");
    }
    // In single precision a ratio near 355/113 may be π.
    let found = radii_of(&right, |r| {
        #[expect(clippy::cast_possible_truncation, reason = "single precision is meant")]
        let single = (std::f64::consts::PI * r) as f32;
        f64::from(single)
    });
    let said = &found.diagnoses[0].explanation;
    assert!(said.ends_with("got/exact ≈ 3.1416"), "{said}");
}

/// Numbers that miss a mark by little pass it with many mistakes; that names none of them.
#[test]
fn a_nearly_constant_radius_is_not_one_in_degrees() {
    for (text, value) in [
        ("r = 1 + 1/500*sin(t) + 1/1000*cos(2t)", 1.002),
        ("r = 1 + 1/1000*sin(t) + 1/1000*cos(t)", 1.002),
        ("r = 1 + 1/1000*sin(t) + 1/1000*cos(t)", 0.9985),
    ] {
        let radii: Vec<GivenRadius> = (1..=6)
            .map(|k| GivenRadius {
                line: k,
                theta: f64::from(u32::try_from(k).unwrap()),
                r: value,
            })
            .collect();
        let found = reference(text)
            .check_radii(&radii, &Limits::none())
            .unwrap();
        let named = names(&found);
        assert!(
            named
                .iter()
                .all(|name| ["no correct digit", "single precision"].contains(name)),
            "{text}: {named:?}"
        );
    }
}

/// A factor is named once, whatever it is.
#[test]
fn a_scale_is_named_once() {
    let right = lopsided();
    let reference = Reference::of_radius(&right).unwrap();
    for factor in [1.5, 0.001, 25.4, 1.0001, 7.0 / 3.0] {
        let points: Vec<GivenPoint> = (0..60)
            .map(|k| {
                let t = f64::from(k) * 0.1;
                let r = factor * right.approximate(t);
                GivenPoint {
                    line: 1,
                    position: [r * t.cos(), r * t.sin(), 0.0],
                }
            })
            .collect();
        let found = reference.check_points(&points, &Limits::none()).unwrap();
        assert_eq!(names(&found), ["scale"], "{factor}");
    }
}

/// Rays on which the origin is the only point, and points near the largest double: the mistakes that lead nowhere are not tried.
#[test]
fn mistakes_that_lead_nowhere_are_not_tried() {
    for (text, points) in [
        ("x^2 + y^2 = 2*y", &[[5.0, 0.0]][..]),
        ("r = sin(t)", &[[0.3, 0.0]]),
        ("r = sin(2t)", &[[0.3, 0.0]]),
        (
            "(x^2 + y^2)^3 = 4*x^2*y^2",
            &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        ),
        ("r = 2 + cos(3t)", &[[1e307, 1.0]]),
        (
            "r = 2 + cos(3t) # center: 1e308, 0",
            &[[1.7e308, 1.0], [-1.7e308, 1.0]],
        ),
    ] {
        let given: Vec<GivenPoint> = points
            .iter()
            .map(|[x, y]| GivenPoint {
                line: 1,
                position: [*x, *y, 0.0],
            })
            .collect();
        let found = reference(text)
            .check_points(&given, &Limits::none())
            .unwrap();
        assert_eq!(found.rows.len(), points.len(), "{text}");
    }
}
