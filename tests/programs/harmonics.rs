//! Harmonic surfaces, from end to end.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use serde_json::Value;
use tempfile::TempDir;

use crate::common::program::{done, run_in};

fn json(arguments: &[&str]) -> Value {
    let mut all = arguments.to_vec();
    all.extend(["--format", "json", "--quiet"]);
    serde_json::from_str(&done(&all)).unwrap()
}

/// A radius of degree 10 with a coefficient for every harmonic.
fn particle() -> String {
    let mut text = String::from("R = 10");
    for l in 1..=10_i64 {
        for m in -l..=l {
            let c = (7 * l + 3 * m) % 5 - 2;
            if c != 0 {
                let sign = if c < 0 { '-' } else { '+' };
                let size = 10_i64.pow(m.unsigned_abs().try_into().unwrap());
                text += &format!(" {sign} {}/{}*Y({l},{m})", c.abs(), 10 * size);
            }
        }
    }
    text
}

#[test]
fn the_limacon_of_revolution_the_sphere_and_the_square() {
    // (ρ − z/2)² = 4ρ, times 4.
    assert_eq!(
        done(&["implicitize", "R = 2 + Y(1,0)/2", "--quiet"])
            .lines()
            .last(),
        Some(
            "4x^4 + 8x^2y^2 + 8x^2z^2 + 4y^4 + 8y^2z^2 + 4z^4 - 4x^2z - 4y^2z - 4z^3 - 16x^2 - 16y^2 - 15z^2 = 0"
        )
    );
    let sphere = json(&["implicitize", "R = 3"]);
    assert_eq!(sphere["degree"], 2);
    let odd = json(&["implicitize", "R = Y(1,0) + Y(3,1)/3"]);
    assert_eq!(odd["homogeneous_degrees"], serde_json::json!([4, 3]));
}

#[test]
fn the_equation_gives_the_coefficients_back() {
    let text = particle();
    let folder = TempDir::new().unwrap();
    let run = run_in(folder.path(), &["implicitize", &text, "-o", "f.json"], "");
    assert_eq!(run.code, 0, "{}", run.err);
    let document: Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("f.json")).unwrap()).unwrap();
    assert_eq!(document["degree"], 22);
    assert_eq!(
        document["homogeneous_degrees"],
        serde_json::json!([22, 21, 20])
    );
    let run = run_in(folder.path(), &["parametrize", "f.json", "--quiet"], "");
    let first = run
        .out
        .lines()
        .find(|line| line.starts_with("R = "))
        .unwrap();
    let again = json(&["implicitize", first]);
    assert_eq!(again["terms"], document["terms"]);
}

#[test]
fn powers_and_products_are_sums_of_harmonics() {
    let same = |a: &str, b: &str| {
        let [a, b] = [a, b].map(|text| json(&["implicitize", text]));
        assert_eq!(a["terms"], b["terms"]);
    };
    // Y(2,2) = 3 sin² φ cos 2θ and Y(2,0) = (3 cos² φ − 1)/2.
    same("R = 1 + sin(phi)^2*cos(2*theta)/5", "R = 1 + Y(2,2)/15");
    same("R = 5 + cos(phi)^2", "R = 16/3 + 2/3*Y(2,0)");
    let run = run_in(
        Path::new("."),
        &["describe", "R = 1 + sin(phi)*cos(2*theta)"],
        "",
    );
    assert_eq!(run.code, 2, "{}", run.out);
}

#[test]
fn radii_in_rational_directions_are_exact() {
    // In the direction (2/3, 1/3, 2/3)… R = 2 + z/2 at the pole and at the equator.
    let rows = done(&[
        "sample",
        "R = 2 + Y(1,0)/2",
        "--theta",
        "0",
        "--phi",
        "0",
        "--phi",
        "90deg",
        "--quiet",
    ]);
    let radii: Vec<&str> = rows
        .lines()
        .skip(1)
        .map(|row| row.split(',').nth(6).unwrap())
        .collect();
    assert_eq!(radii, ["2.5", "-1.5", "2.0", "-2.0"]);
}

#[test]
fn verbs_that_do_not_take_them_say_so() {
    for (arguments, part) in [
        (
            vec!["inspect", "R = 2", "--tolerance", "1", "--point", "1,0"],
            "this is a surface",
        ),
        (vec!["describe", "R = 2 + Y(1,2)"], "order"),
        (
            vec!["implicitize", "R = 2 + Y(1,0)", "--method", "polar"],
            "--method",
        ),
    ] {
        let run = run_in(Path::new("."), &arguments, "");
        assert!(
            run.code == 2 && run.err.contains(part),
            "{} {}",
            run.code,
            run.err
        );
        assert_eq!(
            run.err
                .lines()
                .filter(|line| line.starts_with("stellate:"))
                .count(),
            1
        );
    }
}

#[test]
fn coefficient_files_say_what_they_are_taken_for() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("table.csv");
    fs::write(&path, "l,m,value\n0,0,3\n2,1,1/4\n").unwrap();
    let run = run_in(folder.path(), &["implicitize", "table.csv"], "");
    assert_eq!(run.code, 0, "{}", run.err);
    let same = done(&["implicitize", "R = 3 + Y(2,1)/4"]);
    assert_eq!(run.out, same);
    fs::write(
        folder.path().join("cut.sh"),
        "0 0 1.0 0.0\n1 0 0.5 0.0\n1 2 0.1 0.1\n",
    )
    .unwrap();
    let run = run_in(folder.path(), &["describe", "cut.sh"], "");
    assert_eq!(run.code, 2, "{}", run.out);
    assert!(run.err.contains('3'), "the row is named: {}", run.err);
}

#[test]
fn a_mesh_beyond_the_largest_double_is_refused() {
    let folder = TempDir::new().unwrap();
    let far = "# center: 1e400,0,0\nR = 1\n";
    let run = run_in(folder.path(), &["mesh", "-", "-o", "far.obj"], far);
    assert_eq!(run.code, 2, "{}", run.err);
    assert!(run.err.contains("beyond the largest double"), "{}", run.err);
    assert!(!folder.path().join("far.obj").exists());
}

/// A harmonic without R is one clear error.
#[test]
fn harmonics_belong_to_a_radius() {
    for form in [
        "X + Y(2) = 1",
        "1 + Y(2,0)/5",
        "Y(2,0)",
        "x = Y(1,0); y = t",
        "r = 1 + Y(1,0)",
    ] {
        let run = run_in(Path::new("."), &["implicitize", form], "");
        assert_eq!(run.code, 2, "{form}: {}", run.err);
        assert!(
            run.err.contains("on the right of R = "),
            "{form}: {}",
            run.err
        );
    }
}
