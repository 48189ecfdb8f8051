//! What is answered for the equation of a parametric form is said to be so where the equation has more points.

use crate::common::program::run_in;
use std::path::Path;

const PATCH: &str = "x = cos(u)*cos(v); y = sin(u)*cos(v); z = cos(v)^2";

#[test]
fn an_equation_with_more_points_is_named() {
    let note = |command: &[&str], stdin: &str| {
        let run = run_in(Path::new("."), command, stdin);
        assert!(run.code < 2, "{command:?}: {}", run.err);
        run.err.contains("points that are not on the")
    };
    let folded = "x = cos(t); y = cos(t)^2";
    assert!(note(&["sample", folded, "--directions=8"], ""));
    assert!(note(&["parametrize", folded], ""));
    assert!(note(&["check", folded, "--points=-"], "3,9\n"));
    assert!(note(&["sample", PATCH, "--directions=8"], ""));
    assert!(note(&["check", PATCH, "--points=-"], "3,0,9\n"));
    // These curves and this patch are all of their zero sets.
    let ellipse = "x = 2*cos(t); y = sin(t)";
    assert!(!note(&["sample", ellipse, "--directions=8"], ""));
    assert!(!note(
        &["sample", "x = cos(2*t); y = sin(2*t)", "--directions=8"],
        ""
    ));
    assert!(!note(
        &["sample", "x = u; y = v; z = u*v", "--directions=8"],
        ""
    ));
}
