//! An equation of a surface that states a center keeps it: what is asked of it is answered about that point, and it has the same
//! points as the equation in original coordinates.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::Path;

use tempfile::TempDir;

use crate::common::program::{done_in, json, run_in, strings};

/// R = 2 + cos(phi)/2 about (1, 2, 3).
const HARMONIC: &str = "# center: 1, 2, 3\nR = 2 + cos(phi)/2\n";
/// A closed form by Lemma 7.
const QUARTIC: &str = "# center: 1, 2, -3/2\nx^4 + y^4 + z^4 = 1\n";

/// A folder with the harmonic surface, with its equation about the center, and with that in original coordinates.
fn harmonic() -> TempDir {
    let folder = TempDir::new().unwrap();
    std::fs::write(folder.path().join("surface.txt"), HARMONIC).unwrap();
    let write = |more: &[&str]| {
        let command = [&["implicitize", "surface.txt", "--quiet", "-o"], more].concat();
        done_in(folder.path(), &command, "");
    };
    write(&["about.json"]);
    write(&["original.json", "--coordinates", "original"]);
    folder
}

/// A folder with the quartic.
fn quartic() -> TempDir {
    let folder = TempDir::new().unwrap();
    std::fs::write(folder.path().join("quartic.txt"), QUARTIC).unwrap();
    folder
}

fn text_of(folder: &Path, command: &str) -> String {
    let words: Vec<&str> = command.split(' ').collect();
    done_in(folder, &words, "")
}

#[test]
fn rays_begin_at_the_center_or_are_moved() {
    let folder = harmonic();
    for coordinates in ["center", "original"] {
        let of = |name: &str| {
            let command =
                format!("sample {name} --directions 7 --quiet --coordinates {coordinates}");
            text_of(folder.path(), &command)
        };
        assert_eq!(of("about.json"), of("surface.txt"), "{coordinates}");
    }
    let from_origin = text_of(folder.path(), "sample original.json --directions 7 --quiet");
    let about = text_of(folder.path(), "sample about.json --directions 7 --quiet");
    assert!(about.starts_with("# center 1 2 3\n"), "{about}");
    assert_ne!(from_origin, about);
}

#[test]
fn the_equation_in_original_coordinates_is_that_of_the_form() {
    let folder = harmonic();
    let moved = text_of(
        folder.path(),
        "implicitize about.json --coordinates original --quiet",
    );
    let original = text_of(folder.path(), "implicitize original.json --quiet");
    assert_eq!(moved, original);
    let about = text_of(
        folder.path(),
        "implicitize about.json --scale monic --quiet",
    );
    assert!(about.starts_with("# center: 1, 2, 3\n"), "{about}");
}

#[test]
fn the_radii_of_the_equation_have_its_center() {
    let folder = harmonic();
    let found = text_of(folder.path(), "parametrize about.json");
    assert!(
        found.starts_with("# center: 1, 2, 3\nR = 2 + 1/2*Y(1,0)\n"),
        "{found}"
    );
}

#[test]
fn all_verbs_find_the_same_surface() {
    let folder = harmonic();
    for name in ["about.json", "original.json"] {
        let command = format!("inspect {name} --tolerance 3 --point 1,2,5.5 --point 0,0,0");
        let found = text_of(folder.path(), &command);
        let rows: Vec<&str> = found.lines().collect();
        assert_eq!(rows[1], "1,2,5.5,inside,true,0.0,0.0,0", "{name}");
        assert!(
            rows[2].starts_with("0,0,0,inside,true,2.1"),
            "{name}: {found}"
        );
    }
    let mesh = |name: &str| {
        text_of(
            folder.path(),
            &format!("mesh {name} --resolution 8 -o mesh.obj"),
        );
        std::fs::read_to_string(folder.path().join("mesh.obj")).unwrap()
    };
    let vertices = |mesh: &str| -> Vec<String> {
        let lines = mesh.lines().filter(|line| line.starts_with("v "));
        lines.map(str::to_owned).collect()
    };
    let about = vertices(&mesh("about.json"));
    assert!(about.len() > 100);
    assert_eq!(about, vertices(&mesh("original.json")));
    // In the plane z = 3 are a circle and the isolated zero of the equation, the center.
    let document = std::fs::read_to_string(folder.path().join("about.json")).unwrap();
    let plane = text_of(folder.path(), "implicitize z=3 --format json");
    let both = format!(
        r#"{{"schema":"stellate/1","kind":"intersection","surfaces":[{document},{plane}]}}"#
    );
    std::fs::write(folder.path().join("both.json"), both).unwrap();
    let curve = text_of(folder.path(), "parametrize both.json");
    assert!(
        curve.contains("# common point (x, y, z) = (1, 2, 3)\n"),
        "{curve}"
    );
    assert!(curve.ends_with("\nz = 3\n"), "{curve}");
}

#[test]
fn closed_forms_are_about_the_center() {
    let folder = quartic();
    let folder = folder.path();
    let found = json(&text_of(folder, "parametrize quartic.txt --format json"));
    assert_eq!(strings(&found["center"]), ["1", "2", "-3/2"]);
    let z = found["branches"][0]["coordinates"]["z"].as_str().unwrap();
    assert!(z.starts_with("Rational(-3, 2) + (root("), "{z}");
    for format in ["text", "json", "sympy", "maple"] {
        let name = format!("radii.{format}");
        text_of(
            folder,
            &format!("parametrize quartic.txt --format {format} -o {name}"),
        );
        let back = text_of(folder, &format!("implicitize {name}"));
        assert_eq!(
            back, "# center: 1, 2, -3/2\nx^4 + y^4 + z^4 - 1 = 0\n",
            "{format}"
        );
    }
    let described = json(&text_of(folder, "describe quartic.txt --format json"));
    let factor = &described["factors"][0]["polynomial"];
    assert_eq!(strings(&factor["center"]), ["1", "2", "-3/2"]);
}

#[test]
fn claims_about_a_center_are_proved() {
    let folder = quartic();
    let folder = folder.path();
    for command in [
        "sample quartic.txt --directions 5",
        "sample quartic.txt --directions 5 --coordinates original",
        "inspect quartic.txt --tolerance 2 --point 1,2,-0.5 --point 0,0,0",
        "describe quartic.txt",
    ] {
        text_of(folder, &format!("{command} --proof proof.json --quiet"));
        let verified = text_of(folder, "verify proof.json");
        assert!(
            verified.contains(" claims, 0 without a witness, 0 refused"),
            "{command}: {verified}"
        );
    }
}

#[test]
fn float_numbers_are_compared_about_the_center() {
    let folder = quartic();
    let folder = folder.path();
    let rows = "i,j,k,coefficient\n4,0,0,1\n0,4,0,1\n0,0,4,1\n0,0,0,-1\n";
    for (center, code, expected) in [
        ("", 0, ""),
        ("# center: 1, 2, -3/2\n", 0, ""),
        (
            "# center: 1, 2, 0\n",
            2,
            "the coefficients are relative to (1, 2, 0), the reference to (1, 2, -3/2)",
        ),
    ] {
        std::fs::write(folder.join("rows.csv"), format!("{center}{rows}")).unwrap();
        let command = ["check", "quartic.txt", "--coefficients", "rows.csv"];
        let found = run_in(folder, &command, "");
        assert_eq!(found.code, code, "{center}: {}", found.err);
        assert!(found.err.contains(expected), "{center}: {}", found.err);
    }
    // Points whose center was forgotten are recognised, in space as in the plane.
    let points = |coordinates: &str| {
        let command =
            format!("sample quartic.txt --directions 6 --quiet --coordinates {coordinates}");
        let table = text_of(folder, &command);
        let rows = table.lines().filter(|line| !line.starts_with('#'));
        let columns = rows.map(|row| row.split(',').skip(7).take(3).collect::<Vec<_>>().join(","));
        columns.collect::<Vec<_>>().join("\n")
    };
    for (coordinates, code) in [("center", 0), ("original", 1)] {
        std::fs::write(folder.join("points.csv"), points(coordinates)).unwrap();
        let found = run_in(
            folder,
            &["check", "quartic.txt", "--points", "points.csv"],
            "",
        );
        assert_eq!(found.code, code, "{coordinates}: {}", found.err);
        assert_eq!(
            found.out.contains("looks like: center forgotten"),
            code == 1,
            "{coordinates}: {}",
            found.out
        );
    }
}

#[test]
fn a_latex_file_has_a_center() {
    let folder = quartic();
    let folder = folder.path();
    text_of(folder, "implicitize quartic.txt -o quartic.tex");
    let back = text_of(folder, "implicitize quartic.tex");
    assert_eq!(back, text_of(folder, "implicitize quartic.txt"));
}

#[test]
fn a_description_states_its_center() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    for (text, center) in [
        (QUARTIC, "1, 2, -3/2"),
        ("# center: 1, 2\nx^2/4 + y^2 = 1\n", "1, 2"),
        ("# center: 1, 2\nr = 2 + cos(3t)\n", "1, 2"),
        (HARMONIC, "1, 2, 3"),
    ] {
        std::fs::write(folder.join("form.txt"), text).unwrap();
        let described = text_of(folder, "describe form.txt");
        let first = format!("center: {center}\n");
        assert!(described.starts_with(&first), "{described}");
        let described = json(&text_of(folder, "describe form.txt --format json"));
        let of_radius = &described["spherical"]["center"];
        let found = if of_radius.is_null() {
            &described["center"]
        } else {
            of_radius
        };
        assert_eq!(strings(found).join(", "), center);
    }
    std::fs::write(folder.join("form.txt"), "# center: 0, 0\nx^2/4 + y^2 = 1\n").unwrap();
    assert!(text_of(folder, "describe form.txt").starts_with("degree: 2\n"));
}

/// Points about a center are not taken for points in original coordinates.
#[test]
fn points_about_a_center_are_not_inspected() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    for form in [QUARTIC, "# center: 1, 2\nx^2/4 + y^2 = 1\n"] {
        std::fs::write(folder.join("form.txt"), form).unwrap();
        let inspect = [
            "inspect",
            "form.txt",
            "--tolerance",
            "1e-9",
            "--points",
            "points.csv",
        ];
        text_of(
            folder,
            "sample form.txt --directions 5 -o points.csv --quiet",
        );
        let refused = run_in(folder, &inspect, "");
        assert_eq!(refused.code, 2, "{}", refused.out);
        let said = "points.csv, row 1: these points are relative to the center (1, 2";
        assert!(refused.err.contains(said), "{}", refused.err);
        let original =
            "sample form.txt --directions 5 -o points.csv --quiet --coordinates original";
        text_of(folder, original);
        let found = run_in(folder, &inspect, "");
        assert_eq!(found.code, 0, "{}{}", found.out, found.err);
    }
    for points in [
        "# center 1 2\nx,y\n1,0\n0,1\n-1,0\n0,-1\n",
        "x,y\n#\tcenter:\t1,2\n1,0\n0,1\n-1,0\n",
    ] {
        std::fs::write(folder.join("points.csv"), points).unwrap();
        let inspect = [
            "inspect",
            "form.txt",
            "--tolerance",
            "1",
            "--points",
            "points.csv",
        ];
        for command in [&["fit", "points.csv", "-n", "1"][..], &inspect] {
            let refused = run_in(folder, command, "");
            assert_eq!(refused.code, 2, "{points}: {}", refused.out);
            assert!(
                refused.err.contains("relative to the center (1, 2)"),
                "{}",
                refused.err
            );
        }
    }
    // Another comment about a center has no meaning.
    let points = "# center of mass: 3 g\n# center 0 0\nx,y\n3,2\n";
    std::fs::write(folder.join("points.csv"), points).unwrap();
    let inspect = [
        "inspect",
        "form.txt",
        "--tolerance",
        "1e-9",
        "--points",
        "points.csv",
    ];
    assert_eq!(run_in(folder, &inspect, "").code, 0);
}

/// How much the terms cancel depends on the form.
#[test]
fn a_remark_about_original_coordinates_is_true() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    for (text, expected) in [
        ("# center: 1, 2, 3\nx^2 + y^2 + z^2 = 4\n", None),
        ("# center: 1, 0, 3\nx - 2z = 0\n", None),
        (
            "# center: 1000000, 0\nx^2 + y^2 = 1\n",
            Some("doubles lose ≈ 12 of their 16 digits near its zeros"),
        ),
        (
            "# center: 100, 0\nr = 2 + cos(9t)\n",
            Some("doubles will mostly fail to evaluate it"),
        ),
    ] {
        std::fs::write(folder.join("form.txt"), text).unwrap();
        let command = ["implicitize", "form.txt", "--coordinates", "original"];
        let found = run_in(folder, &command, "");
        match expected {
            Some(expected) => assert!(found.err.contains(expected), "{text}: {}", found.err),
            None => assert_eq!(found.err, "", "{text}"),
        }
    }
}

#[test]
fn a_center_of_an_intersection_is_refused() {
    let folder = harmonic();
    let document = std::fs::read_to_string(folder.path().join("about.json")).unwrap();
    let both = format!(
        r#"{{"schema":"stellate/1","kind":"intersection","center":["1","2","3"],"surfaces":[{document},{document}]}}"#
    );
    let found = run_in(folder.path(), &["parametrize", "-"], &both);
    assert_eq!(found.code, 2, "{}", found.out);
    assert!(
        found
            .err
            .contains("a center belongs to each of the surfaces"),
        "{}",
        found.err
    );
}

#[test]
fn a_rational_parametrization_is_in_original_coordinates() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    std::fs::write(
        folder.join("node.txt"),
        "# center: 1, 2\ny^2 = x^2*(x + 1)\n",
    )
    .unwrap();
    let found = text_of(folder, "parametrize node.txt");
    let line = "# factor 0 is rational, in original coordinates: x = t^2, y = t^3 - t + 2\n";
    assert!(found.contains(line), "{found}");
}
