//! The tables that `check` reads: those that other verbs write, columns among others, and centers.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use tempfile::TempDir;

use crate::common::program::{done, done_in, run_in, with_data};

const ABOUT: &str = "# center: 1, 2\nx^2 + 2*y^2 = 1\n";
const ABOUT_IN_SPACE: &str = "# center: 1, 2, -1/2\nx^4 + 2*y^4 + z^4 + x*z^2 = 1\n";

fn folder_of(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

#[test]
fn what_sample_writes_is_right() {
    let forms = [
        ("curve.txt", "x^2 + 2*y^2 = 1\n"),
        ("surface.txt", "x^2 + 2*y^2 + z^4 = 1\n"),
        ("about.txt", ABOUT),
        ("about_in_space.txt", ABOUT_IN_SPACE),
    ];
    let folder = folder_of(&forms);
    for (form, _) in forms {
        let sample = ["sample", form, "--directions", "9", "--quiet"];
        let table = done_in(folder.path(), &sample, "");
        let check = ["check", form, "--digits", "15", "--points", "-"];
        let found = run_in(folder.path(), &check, &table);
        assert_eq!(found.code, 0, "{form}: {}{}", found.out, found.err);
    }
    // The equation of a radius has the points behind the center, too: they belong to the radius half a turn farther.
    let radius = "r = 2 + cos(t)";
    let sample = ["sample", radius, "--directions", "9", "--quiet"];
    let all = done(&sample);
    let rows = all.lines().filter(|row| !row.starts_with("1,"));
    let table = rows.collect::<Vec<_>>().join("\n");
    let found = with_data(
        &table,
        &["check", radius, "--digits", "15", "--radii", "data.csv"],
    );
    assert_eq!(found.code, 0, "{}{}", found.out, found.err);
}

#[test]
fn columns_are_found_by_name() {
    let expected = "expected the columns x,y, or a first row that names them among others";
    // The point (1/3, 2/3) is on the ellipse, and (2/3, 1/3) is not.
    for (points, code, said) in [
        (
            "name,Y,x\nA,0.6666666666666666,0.3333333333333333\nB,0,1\n",
            0,
            "",
        ),
        ("y,x\n0.6666666666666666,0.3333333333333333\n", 0, ""),
        ("x,y\n0.6666666666666666,0.3333333333333333\n", 1, ""),
        // Not by name, there must be no others.
        ("0.6,0.8,1\n", 2, expected),
        ("u,v\n0.6,0.8\n", 2, expected),
        ("x,z\n0.6,0.8\n", 2, expected),
        // These are points in space.
        (
            "x,y,z\n0.6,0.8,0\n",
            2,
            "line 1: expected the columns x,y without z",
        ),
    ] {
        let found = with_data(
            points,
            &["check", "x^2 + 2*y^2 = 1", "--points", "data.csv"],
        );
        assert_eq!(found.code, code, "{points}: {}{}", found.out, found.err);
        assert!(found.err.contains(said), "{}", found.err);
    }
}

#[test]
fn numbers_about_another_center_are_refused() {
    let folder = folder_of(&[("about.txt", ABOUT), ("plain.txt", "x^2 + 2*y^2 = 1\n")]);
    for (form, center, ours) in [
        ("about.txt", "1 3", "1, 2"),
        ("plain.txt", "1 3", "0, 0"),
        ("about.txt", "1 2 3", "1, 2"),
        // The origin is a center, too, if it is stated.
        ("about.txt", "0 0", "1, 2"),
    ] {
        let table = format!("# center {center}\nx,y\n1,0\n");
        let check = ["check", form, "--points", "-"];
        let found = run_in(folder.path(), &check, &table);
        assert_eq!(found.code, 2, "{center}: {}", found.out);
        let theirs = center.replace(' ', ", ");
        let said = format!("these numbers are relative to ({theirs}), the reference to ({ours})");
        assert!(found.err.contains(&said), "{}", found.err);
    }
}

#[test]
fn coefficients_in_original_coordinates_are_recognised() {
    let folder = folder_of(&[("plane.txt", ABOUT), ("space.txt", ABOUT_IN_SPACE)]);
    for form in ["plane.txt", "space.txt"] {
        for (coordinates, code) in [("center", 0), ("original", 1)] {
            let implicitize = [
                "implicitize",
                form,
                "--format",
                "csv",
                "--quiet",
                "--coordinates",
                coordinates,
            ];
            let table = done_in(folder.path(), &implicitize, "");
            let check = ["check", form, "--coefficients", "-"];
            let found = run_in(folder.path(), &check, &table);
            assert_eq!(found.code, code, "{form}: {}{}", found.out, found.err);
            let is_named = found.out.contains("looks like: center forgotten");
            assert_eq!(is_named, code == 1, "{form}: {}", found.out);
        }
    }
}

#[test]
fn harmonics_need_no_header() {
    let folder = folder_of(&[("surface.txt", "R = 2 + Y(1,0)/4 + Y(2,-1)/8\n")]);
    let check = ["check", "surface.txt", "--coefficients", "-"];
    let rows = ["l,m,value", "0,0,2", "1,0,0.25", "2,-1,0.125"];
    for table in [rows.join("\n"), rows[1..].join("\n")] {
        let found = run_in(folder.path(), &check, &table);
        assert_eq!(found.code, 0, "{table}: {}{}", found.out, found.err);
    }
}
