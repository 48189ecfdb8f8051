//! Polar curves by powers of the radius, and what the polar method writes, from the command line.

use std::path::Path;

use crate::common::program::{done, json, run_in};

#[test]
fn powers_of_the_radius_have_equations_with_parts_of_the_angle() {
    for (form, equation) in [
        // r^4 = (1 + cos t)/2, for both signs of cos(t/2).
        (
            "r^2 = cos(t/2)",
            "4*(x^2 + y^2)^5 - 4*(x^2 + y^2)^3 + y^2 = 0",
        ),
        // The triple of 2t/3 is 2t, and 4c^3 - 3c is the cosine of the triple.
        (
            "r^2 = cos(2*t/3)",
            "4*(x^2 + y^2)^4 - 3*(x^2 + y^2)^2 - x^2 + y^2 = 0",
        ),
        // r^6 (1 + cos t) = 2 is r^7 + r^6 x = 2r.
        (
            "r^3 = 1/cos(t/2)",
            "(x^2 + y^2)^5*y^2 - 4*(x^2 + y^2)^3 + 4 = 0",
        ),
        ("r^2 = cos(2*t)", "(x^2 + y^2)^2 - x^2 + y^2 = 0"),
        ("r^2 = 4 - 3*sin(t)^2", "(x^2 + y^2)^2 - 4*x^2 - y^2 = 0"),
    ] {
        let [ours, expected] = [form, equation].map(|text| done(&["implicitize", text]));
        assert_eq!(ours, expected, "{form}");
    }
}

#[test]
fn an_origin_that_only_the_equation_has_is_remarked() {
    let here = Path::new(".");
    for (form, is_added) in [
        ("r^2 = 2 + cos(t)", true),
        ("r^3 = 2 + cos(t/2)", true),
        ("r^2 = cos(2t)", false),
        ("r^2 = 1/(2 + cos(2t))", false),
        ("r^2 = 1 + cos(t/2)", false),
    ] {
        let run = run_in(here, &["implicitize", form], "");
        assert_eq!(run.code, 0, "{form}: {}", run.err);
        let remark = "which has the origin as an isolated point";
        assert_eq!(run.err.contains(remark), is_added, "{form}: {}", run.err);
    }
    for form in ["r^2 = -1", "r^2 = -2 - cos(2t)", "r^4 = -3 + sin(t/2)"] {
        let run = run_in(here, &["implicitize", form], "");
        assert_eq!(run.code, 2, "{form}");
        assert!(run.err.contains("negative at every angle"), "{}", run.err);
    }
}

#[test]
fn documents_of_the_polar_method_fulfil_their_schema() {
    for (form, field, has_radius) in [
        ("x = cos(t); y = sin(2t)", "factors", true),
        ("x = t^2; y = t^3 + t", "reason", false),
        ("r = 1/(1 + cos(t)/2)", "reason", false),
        ("x = t; y = t^2; z = t^3", "surfaces", false),
        (
            "x = (2 + cos(u))*cos(v); y = (2 + cos(u))*sin(v); z = sin(u)",
            "reason",
            false,
        ),
    ] {
        let document = json(&done(&[
            "implicitize",
            form,
            "--method",
            "polar",
            "--format",
            "json",
        ]));
        let polar = &document["polar"];
        assert!(!polar[field].is_null(), "{form}: {polar}");
        assert_eq!(!polar["squared_radius"].is_null(), has_radius, "{form}");
    }
}
