//! Surfaces on the command line: parametrize, sample and plot in space.

use std::path::Path;

use crate::common::program::{done, done_in, json, number, piped, run_in, strings};
use tempfile::tempdir;

const SPHERE: &str = "x^2 + y^2 + z^2 = 4x - 3";
const TORUS: &str = "(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)";
const HEART: &str = "(x^2+9/4*y^2+z^2-1)^3 - x^2*z^3 - 9/80*y^2*z^3";

#[test]
fn parametrize_writes_closed_forms() {
    let text = done(&["parametrize", TORUS, "--theta", "0.5"]);
    assert!(text.starts_with("# lemma-8 in R^2\n"), "{text}");
    assert!(text.contains("discriminant D = 64*sin(phi)^4 - 192*sin(phi)^2*cos(phi)^2"));
    assert!(
        text.contains("branch 0: R real for phi in [pi/3, 2*pi/3]"),
        "{text}"
    );
    let formulas = done(&["parametrize", SPHERE, "--format", "sympy"]);
    let first = formulas.lines().next().unwrap();
    let root = "sqrt(sin(phi)**2*cos(theta)**2 - 3*sin(phi)**2*sin(theta)**2 - 3*cos(phi)**2)";
    let both = ["+", "-"].map(|sign| format!("2*sin(phi)*cos(theta) {sign} {root}"));
    assert_eq!(first, format!("[{}]", both.join(", ")));
    let maple = done(&["parametrize", "x^2+y^2+z^2=4x", "--format", "maple"]);
    assert_eq!(
        maple,
        "R = 4*sin(phi)*cos(theta);\n# parametrizes: x^2 + y^2 + z^2 - 4x = 0\n"
    );
    let latex = done(&["parametrize", "x^2+y^2+z^2=4x", "--format", "latex"]);
    assert_eq!(latex, "R = 4 \\sin \\phi \\cos \\theta\n");
}

/// What a formula is real for is not lost in the formats for other programs.
#[test]
fn formulas_for_other_programs_say_where_they_hold() {
    for (form, expected) in [
        (
            "x^4 + y^4 = 1 + x",
            "branch 4: r real for theta in [pi/2, pi/2] and [3*pi/2, 3*pi/2]; r > 0 for theta in [pi/2, pi/2] and [3*pi/2, 3*pi/2]; the formula holds there only",
        ),
        (
            "x^6 + y^6 + x*y^3 = 1 + x",
            "Fourier fit of branch 1: N = 20, 256 samples; |error| <= ",
        ),
        (SPHERE, "branch 0: real where D >= 0"),
        (SPHERE, "factor 0: discriminant D = "),
    ] {
        for (format, comment) in [("latex", "%"), ("sympy", "#"), ("maple", "#")] {
            let found = done(&["parametrize", form, "--format", format]);
            let line = format!("{comment} {expected}");
            assert!(
                found.lines().any(|l| l.starts_with(&line)),
                "{form}, {format}: {found}"
            );
        }
    }
    // Formulas that hold everywhere need no comment.
    let ellipse = done(&["parametrize", "x^2/4 + y^2 = 1", "--format", "latex"]);
    assert!(!ellipse.contains("branch"), "{ellipse}");
}

/// An angle such as 45° stands for a rational vector near it, whose answers can be others.
#[test]
fn the_exact_vector_of_a_meridian_is_told() {
    let arguments = ["parametrize", SPHERE, "--theta", "45deg", "--phi", "1"];
    let document = json(&done(&[&arguments[..], &["--format", "json"]].concat()));
    let vector = strings(&document["directions"][0]["direction"]);
    let numbers: Vec<f64> = vector.iter().map(|u| number(u)).collect();
    let length: f64 = numbers.iter().map(|u| u * u).sum();
    assert!((length - 1.0).abs() < 1e-15 && (numbers[2] - 1f64.cos()).abs() < 1e-15);
    let text = done(&arguments);
    let line = format!("that of the exact vector ({}):", vector.join(", "));
    assert!(text.contains(&line), "{text}");
    let meridian = done(&["parametrize", SPHERE, "--theta", "90deg"]);
    assert!(
        meridian.contains("theta = 1.5707963267948966, that of the exact vector (0, 1):"),
        "{meridian}"
    );
}

#[test]
fn parametric_documents_are_complete_and_read_back() {
    let arguments = ["parametrize", SPHERE, "--format", "json", "--theta", "0"];
    let document = done(&arguments);
    let value = json(&document);
    assert_eq!(value["method"], "lemma-8");
    assert_eq!(value["parameters"], serde_json::json!(["theta", "phi"]));
    assert_eq!(value["branches"].as_array().unwrap().len(), 2);
    assert!(
        value["branches"][0]["coordinates"]["z"]
            .as_str()
            .unwrap()
            .ends_with("*cos(phi)")
    );
    // D = 16 α² − 12 (α² + β² + γ²)
    assert_eq!(value["discriminants"][0]["terms"][0]["coefficient"], "4");
    // Tangents from the origin at 30° from the x axis.
    let range = &value["meridians"][0]["branches"][0]["ranges"][0];
    assert_eq!(range["exact_from"], "pi/3");
    assert_eq!(range["exact_to"], "2*pi/3");
    assert_eq!(
        piped(
            &["sample", "-", "--theta", "0", "--phi", "90deg"],
            &document
        ),
        done(&["sample", SPHERE, "--theta", "0", "--phi", "90deg"])
    );
    let superquadric = "superquadric 3d a=1,1,2 e=3,1/2";
    let document = done(&["parametrize", superquadric, "--format", "json"]);
    assert_eq!(
        piped(&["describe", "-"], &document),
        done(&["describe", superquadric])
    );
}

#[test]
fn directions_are_answered_with_certainty() {
    let there = [
        "parametrize",
        SPHERE,
        "--theta",
        "0",
        "--phi",
        "90deg",
        "--format",
        "json",
    ];
    let value = json(&done(&there));
    let direction = &value["directions"][0];
    assert_eq!(direction["discriminants"], serde_json::json!([1]));
    assert_eq!(direction["signs"], serde_json::json!([1, 1]));
    assert_eq!(direction["radii"], serde_json::json!([[3.0, 1.0]]));
    let text = done(&["parametrize", SPHERE, "--theta", "90deg", "--phi", "1"]);
    assert!(text.contains("#   factor 0: D < 0\n"), "{text}");
    assert!(text.contains("no real root"), "{text}");
    // No closed form: degree 6. The meridian is the problem of the plane.
    let heart = done(&["parametrize", HEART, "--theta", "0"]);
    assert!(heart.starts_with("# numeric\n"), "{heart}");
    assert_eq!(
        heart.matches("R real for phi in [0, pi]").count(),
        2,
        "{heart}"
    );
    // A cone and a plane through the origin
    let cones = done(&["parametrize", "(x^2+y^2-z^2)*(x-y)"]);
    assert!(cones.starts_with("# cones\n"), "{cones}");
    assert_eq!(cones.matches("is a cone").count(), 2);
}

#[test]
fn samples_are_exact_directions_with_all_points() {
    let rows = done(&["sample", SPHERE, "--theta", "0", "--phi", "90deg"]);
    assert_eq!(
        rows,
        "branch,theta,phi,u,v,w,r,x,y,z,multiplicity\n\
         0,0.0,1.5707963267948966,1,0,0,3.0,3.0,0.0,0.0,1\n\
         1,0.0,1.5707963267948966,1,0,0,1.0,1.0,0.0,0.0,1\n"
    );
    let count = |arguments: &[&str]| {
        let mut all = vec!["sample", TORUS, "--positive"];
        all.extend(arguments);
        done(&all).lines().count() - 1
    };
    // On the equator there are two sheets in every direction.
    assert_eq!(count(&["--phi", "90deg", "--directions", "10"]), 20);
    assert_eq!(count(&["--phi", "0"]), 0);
    assert_eq!(
        count(&["--theta", "10deg", "--phi", "90deg", "--phi", "80deg"]),
        4
    );
    let threads =
        ["1", "2"].map(|n| done(&["sample", HEART, "--directions", "50", "--threads", n]));
    assert_eq!(threads[0], threads[1]);
    // A whole line is said, not lost.
    let run = run_in(
        Path::new("."),
        &["sample", "x*y + z*x", "--theta", "90deg", "--phi", "1"],
        "",
    );
    assert_eq!(run.code, 0);
    assert!(run.err.contains("the whole line at theta"), "{}", run.err);
    let lines = done(&[
        "sample",
        "x*y + z*x",
        "--theta",
        "90deg",
        "--phi",
        "1",
        "--format",
        "json",
    ]);
    assert_eq!(json(&lines)["lines"][0]["u"], "0");
}

#[test]
fn plots_show_surfaces_curves_and_points() {
    let folder = tempdir().unwrap();
    let svg = |arguments: &[&str]| {
        let mut all = vec!["plot"];
        all.extend(arguments);
        all.extend(["--cells", "12", "-o", "f.svg"]);
        assert_eq!(done_in(folder.path(), &all, ""), "");
        std::fs::read_to_string(folder.path().join("f.svg")).unwrap()
    };
    let sphere = svg(&[SPHERE]);
    assert!(sphere.matches("<polygon").count() > 200);
    // Fig. 13: two surfaces and the curve that Theorem 7 finds
    let both = svg(&["x^2 + y^2 = 1; z = y^5"]);
    assert!(both.contains("sin(t)^5"), "the legend");
    // Fig. 14: a point beside a pipe
    let pipe = svg(&[
        "x^2 + y^2 = 1",
        "z = x",
        "--point",
        "0.8,0.6,0",
        "--window=-2,2,-2,2,-1,1",
    ]);
    assert!(pipe.contains("cylinder") && pipe.contains("<circle"));
    let body = svg(&["superquadric 3d a=1,1,1 e=3,1/2"]);
    assert!(body.contains("2/e1 = 2/3"));
}

#[test]
fn mistakes_are_said_once() {
    let folder = tempdir().unwrap();
    for (arguments, said) in [
        (
            &["sample", "x^2 + y^2 = 1", "--phi", "1"][..],
            "this is a plane curve",
        ),
        (
            &["sample", SPHERE, "--phi", "x"],
            "--phi x: expected radians",
        ),
        (&["sample", SPHERE, "--directions", "0"], "at least one"),
        (&["parametrize", SPHERE, "--phi", "1"], "--theta"),
        (
            &["parametrize", SPHERE, "--harmonics", "3"],
            "this is a surface",
        ),
        (
            &["parametrize", "x^2 + y^2 = 1", "--theta", "1"],
            "are for surfaces",
        ),
        (
            &["parametrize", SPHERE, "--format", "csv"],
            "stellate sample writes points",
        ),
        (&["parametrize", HEART, "--format", "latex"], "no formula"),
        (
            &[
                "parametrize",
                "superquadric 3d a=1,1,1 e=1,1",
                "--theta",
                "1",
            ],
            "in every direction",
        ),
        (
            &["plot", "x^2 + y^2 = 1", "--point", "1,2,3", "-o", "f.svg"],
            "in the plane",
        ),
    ] {
        let run = run_in(folder.path(), arguments, "");
        assert_eq!(
            (run.code, run.out.as_str()),
            (2, ""),
            "{arguments:?}: {}",
            run.err
        );
        assert!(run.err.contains(said), "{arguments:?}: {}", run.err);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
