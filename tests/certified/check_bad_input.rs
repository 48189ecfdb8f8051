//! Whatever is wrong with the input of `check` and `vectors`: where, and what would be right.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;

use tempfile::TempDir;

use crate::common::program::{Run, run_in};

/// Runs with a file `data.csv`, and checks that no other file is left.
fn with_data(text: &str, arguments: &[&str]) -> Run {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("data.csv"), text).unwrap();
    let run = run_in(folder.path(), arguments, "");
    assert_eq!(
        fs::read_dir(folder.path()).unwrap().count(),
        1,
        "{arguments:?}"
    );
    run
}

/// What is refused, with code 2, one diagnosis, and nothing written.
#[test]
fn wrong_input_is_said_in_its_place() {
    let coefficients = [
        "check",
        "x^2 + y^2 = 1",
        "--coefficients",
        "data.csv",
        "-o",
        "out.txt",
    ];
    let points = [
        "check",
        "x^2 + y^2 = 1",
        "--points",
        "data.csv",
        "-o",
        "out.txt",
    ];
    let radii = [
        "check",
        "x^2 + y^2 = 1",
        "--radii",
        "data.csv",
        "-o",
        "out.txt",
    ];
    let cases: [(&[&str], &str, &str); 18] = [
        (
            &coefficients,
            "2,0,1\n# note\n0,2,nan\n",
            "data.csv, line 3: expected a number",
        ),
        (
            &coefficients,
            "2,0,1\n0,2\n",
            "data.csv, line 2: expected 3 columns, found 2",
        ),
        (
            &coefficients,
            "2,0,1\n2,0,1\n",
            "data.csv, line 2: this term was given before",
        ),
        (
            &coefficients,
            "2,0,0,1\n0,0,2,1\n",
            "the coefficients of a surface in x, y, z, the reference is a curve in x, y",
        ),
        (&coefficients, "0,0,1\n", "data.csv: "),
        (
            &coefficients,
            "2,0,1e999\n",
            "data.csv, line 1: too large for a double",
        ),
        (
            &points,
            "x,y\n4,1/0x1p-1074\n",
            "data.csv, line 2: 1/0x1p-1074 is too large for a double",
        ),
        (
            &radii,
            "0,1\n1/0x1p-1074,1.25\n",
            "data.csv, line 2: 1/0x1p-1074 is too large for a double",
        ),
        (
            &coefficients,
            "{\"schema\":\"stellate/1\",\"kind\":\"fourier\",\"cos\":[\"1\"],\"sin\":[\"0\"]}",
            "expected the coefficients of a polynomial",
        ),
        (&coefficients, "", "data.csv: there are no rows"),
        (
            &points,
            "x,y,z\n1,2,3\n",
            "data.csv, line 1: expected the columns x,y",
        ),
        (
            &points,
            "x,y\n\n1,two\n",
            "data.csv, line 3: expected a number",
        ),
        (
            &points,
            "a,b\n1,2\n",
            "data.csv, line 1: expected the columns x,y",
        ),
        (
            &radii,
            "theta,r\n1,inf\n",
            "data.csv, line 2: expected a number",
        ),
        (&radii, "1,2,3\n", "data.csv: expected the columns theta,r"),
        (
            &["check", "x^2 + y^2 + z^2 = 1", "--radii", "data.csv"],
            "1,1\n",
            "this is a surface, whose radius has two angles",
        ),
        (
            &["check", "x^2 + y^2 + z^2 = 1", "--radii", "data.csv"],
            "theta,phi,r\n0,1,1\n",
            "this is a surface, whose radius has two angles",
        ),
        (
            &["check", "x = t; y = t^2; z = t^3", "--points", "data.csv"],
            "1,1,1\n",
            "this is a curve in space",
        ),
    ];
    for (arguments, data, expected) in cases {
        let run = with_data(data, arguments);
        assert_eq!(run.code, 2, "{arguments:?} {data}: {}{}", run.out, run.err);
        assert!(
            run.err.contains(expected),
            "{arguments:?} {data}: {}",
            run.err
        );
        assert_eq!(run.out, "");
        assert_eq!(
            run.err
                .lines()
                .filter(|l| l.starts_with("stellate: "))
                .count(),
            1,
            "{}",
            run.err
        );
    }
    for (arguments, expected) in [
        (&["check", "x^2 + y^2 = 1"][..], "--coefficients"),
        (
            &["check", "x^2 + y^2 = 1", "--points", "a", "--radii", "b"],
            "cannot be used with",
        ),
        (
            &["check", "x^2 + y^2 = 1", "--self"],
            "takes a Fourier radius",
        ),
        (
            &["check", "r = 1", "--points", "missing.csv"],
            "missing.csv",
        ),
        (
            &[
                "check", "r = 1", "--points", "data.csv", "--format", "latex",
            ],
            "written as text, json or csv",
        ),
        (
            &["check", "r = 1", "--points", "data.csv", "--plot", "a.txt"],
            "a figure is a .svg or a .png",
        ),
        (
            &[
                "check", "r = 1", "--points", "data.csv", "--plot", "no/a.svg",
            ],
            "there is no folder no",
        ),
        (
            &["check", "r = 1", "--harmonics", "3", "--points", "data.csv"],
            "--harmonics is for contours",
        ),
        (&["vectors", "r = 1", "--format", "csv"], "written as json"),
        (&["vectors", "r = 1", "--directions", "0"], "at least one"),
        (
            &["vectors", "x^2 + 1e400y^2 = 1"],
            "beyond the largest double",
        ),
        (
            &["vectors", "r = 1e-400"],
            "1e-400 is below the smallest double",
        ),
        (
            &["check", "r = 1", "--self", "--digits", "9"],
            "--self says what doubles keep",
        ),
    ] {
        let run = with_data("1,0\n", arguments);
        assert_eq!(run.code, 2, "{arguments:?}: {}", run.err);
        assert!(run.err.contains(expected), "{arguments:?}: {}", run.err);
        assert_eq!(run.out, "");
    }
}
