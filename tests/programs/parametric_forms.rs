//! Parametric forms are answered for themselves, or it is said that the answer is that of their equation where it has more points.

use std::path::Path;

use crate::common::program::{Run, done, json, run_in};

const PATCH: &str = "x = cos(u)*cos(v); y = sin(u)*cos(v); z = cos(v)^2";
/// y = x² between x = −1 and 1.
const FOLDED: &str = "x = cos(t); y = cos(t)^2";

fn run(command: &[&str], stdin: &str) -> Run {
    let run = run_in(Path::new("."), command, stdin);
    assert!(run.code < 2, "{command:?}: {}", run.err);
    run
}

#[test]
fn an_equation_with_more_points_is_named() {
    let note = |command: &[&str], stdin: &str| {
        run(command, stdin)
            .err
            .contains("points that are not on the")
    };
    assert!(note(&["parametrize", FOLDED], ""));
    let half = "x = (1-sin(t)^2)/(1+sin(t)^2); y = 2*sin(t)/(1+sin(t)^2)";
    assert!(note(&["check", half, "--radii=-"], "0,1\n"));
    assert!(note(&["sample", PATCH, "--directions=8"], ""));
    assert!(note(&["check", PATCH, "--points=-"], "3,0,9\n"));
    // These curves and this patch are all of their zero sets.
    assert!(!note(&["parametrize", "x = 2*cos(t); y = sin(t)"], ""));
    assert!(!note(&["parametrize", "x = cos(2*t); y = sin(2*t)"], ""));
    assert!(!note(
        &["sample", "x = u; y = v; z = u*v", "--directions=8"],
        ""
    ));
}

/// The rows of `sample` without the header and comments.
fn rows(form: &str, angle: &str) -> Vec<String> {
    let table = done(&["sample", form, "--theta", angle, "--format", "csv"]);
    let rows = table.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(str::to_owned).collect()
}

#[test]
fn sample_lists_points_of_the_curve_alone() {
    let all = |angle: &str| rows("y = x^2", angle).len();
    // The arc ends in (1, 1), beyond which only the equation has points.
    for (angle, count) in [("30deg", 1), ("44deg", 1), ("46deg", 0), ("120deg", 0)] {
        assert_eq!(all(angle), 1);
        assert_eq!(rows(FOLDED, angle).len(), count, "{angle}");
    }
    // The isolated point (1, 0) of (y/(x−1))² = x − 2 is left out, and the other point has the number 0.
    let isolated = "x = t^2 + 2; y = t*(t^2 + 1)";
    let found = rows(isolated, "0");
    assert_eq!(found, ["0,0.0,1,0,2.0,2.0,0.0,1"]);
    assert_eq!(rows("y^2 = (x-2)*(x-1)^2", "0").len(), 2);
    let note = run(&["sample", isolated, "--theta", "0"], "").err;
    assert!(
        note.contains("that no real parameter of the curve has are left out: 1"),
        "{note}"
    );
    // The limit at infinity closes the circle.
    let circle = "x = (1-t^2)/(1+t^2); y = 2*t/(1+t^2)";
    assert_eq!(rows(circle, "0").len(), 2);
    let line = run(&["sample", "x = cos(t); y = 0", "--theta", "0"], "").err;
    assert!(line.contains("may be only a part of it"), "{line}");
}

#[test]
fn check_measures_points_from_the_curve_itself() {
    let check = |form: &str, rows: &str| run(&["check", form, "--points=-"], rows);
    // (2, 4) is on the parabola and not on the arc, (0.5, 0.25) is on both.
    assert_eq!(check("y = x^2", "2,4\n0.5,0.25\n").code, 0);
    let found = check(FOLDED, "2,4\n0.5,0.25\n");
    assert_eq!(found.code, 1, "{}", found.out);
    assert!(
        found.out.contains("looks like: beyond the curve"),
        "{}",
        found.out
    );
    assert_eq!(found.out.matches("looks like").count(), 1, "{}", found.out);
    assert_eq!(check(FOLDED, "0.5,0.25\n0,0\n").code, 0);
    // The origin is an isolated point of this equation, which no real parameter has.
    let isolated = "x = t^2 + 1; y = t*(t^2 + 1)";
    assert_eq!(check("y^2 = (x-1)*x^2", "0,0\n").code, 0);
    assert_eq!(check(isolated, "0,0\n").code, 1);
    // A segment on the x axis, all of which is in a line through the origin.
    assert_eq!(check("x = cos(t); y = 0", "0.5,0\n-1,0\n0,0\n").code, 0);
    assert_eq!(check("x = cos(t); y = 0", "3,0\n").code, 1);
}

/// Of some curves real parameters reach only a part of the zero set, and of others an isolated point is missing.
#[test]
fn what_is_answered_for_the_equation_says_so() {
    let remark = "this is the answer for the equation, which has points that are not on the curve";
    let note = "are those of the equation, which has more real points than the curve";
    for (form, has_more) in [
        ("x = 3; y = cos(t)", true),
        ("x = t^2; y = t^3 + t", true),
        ("x = t^2 + 1; y = t^3 + t", true),
        ("x = cos(t); y = sin(2t)", false),
        ("x = t^2; y = t^3", false),
    ] {
        let run = run_in(Path::new("."), &["parametrize", form], "");
        assert_eq!(run.code, 0, "{form}: {}", run.err);
        assert_eq!(run.err.contains(remark), has_more, "{form}: {}", run.err);
        let text = done(&["describe", "--topology", form]);
        assert_eq!(text.contains(note), has_more, "{form}: {text}");
    }
}

#[test]
fn vectors_of_a_curve_are_points_of_the_curve() {
    for (form, within) in [
        ("x = 3; y = cos(t)", [[3.0, 3.0], [-1.0, 1.0]]),
        ("x = cos(t); y = cos(t)^2", [[-1.0, 1.0], [0.0, 1.0]]),
        // The equation has the isolated point (-1, 0).
        ("x = t^2; y = t^3 + t", [[0.0, 1e9], [-1e9, 1e9]]),
    ] {
        let document = json(&done(&["vectors", form, "--directions", "16"]));
        let points = document["points"].as_array().unwrap();
        assert!(!points.is_empty(), "{form}");
        for point in points {
            for (k, [low, high]) in within.into_iter().enumerate() {
                let value = point["position"][k]["double"].as_f64().unwrap();
                assert!((low..=high).contains(&value), "{form}: {point}");
            }
        }
    }
}

#[test]
fn turning_points_are_where_the_curve_goes_on() {
    for (form, points) in [
        // c^3 - c of a cosine c takes values between the extrema at 1/sqrt(3), and some of them several times.
        (
            "x = cos(t)^3 - cos(t); y = (cos(t)^3 - cos(t))^2",
            "turn back at ≈ (-0.3849001794597505, 0.14814814814814814) and ≈ (0.3849001794597505, 0.14814814814814814), the",
        ),
        (
            "x = 3; y = cos(t)",
            "turn back at ≈ (3, -1) and ≈ (3, 1), the",
        ),
        (
            "x = t^2; y = t^4",
            "turn back at infinity and ≈ (0, 0), the",
        ),
        (
            "x = 1/(1-cos(t)); y = 1",
            "turn back at infinity and ≈ (0.5, 1), the",
        ),
    ] {
        let text = done(&["implicitize", form]);
        assert!(text.contains(points), "{form}: {text}");
    }
}
