//! Feet on the command line.

use std::path::Path;

use serde_json::{Value, json};
use tempfile::TempDir;

use super::inspect_options::{FORMS, inspect};
use crate::common::program::{Run, json, run_in};

/// The document about a point with its foot, and the run that printed it.
fn document(form: &str, tolerance: &str, point: &str) -> (Value, Run) {
    let mut arguments = vec!["inspect", form, "--tolerance", tolerance, "--point", point];
    arguments.extend(["--feet", "--format", "json"]);
    let run = run_in(Path::new("."), &arguments, "");
    (json(&run.out), run)
}

#[test]
fn feet_stand_behind_the_sign_and_before_kept_columns() {
    let folder = TempDir::new().unwrap();
    for form in FORMS {
        let run = inspect(folder.path(), form, "--tolerance 1 --feet --keep");
        let mut rows = run
            .out
            .lines()
            .map(|row| row.split(',').collect::<Vec<_>>());
        assert_eq!(
            rows.next().unwrap().join(","),
            "x,y,verdict,curve,distance_low,distance_high,sign,foot_x,foot_y,normal_x,normal_y,signed_low,signed_high,id"
        );
        for (row, (id, signed)) in rows.zip([
            ("a", -2.0),
            ("b", -1.0),
            ("c", -0.02),
            ("d", 0.0),
            ("e", 0.05),
            ("f", 0.06),
            ("g", 1.0),
        ]) {
            let numbers: Vec<f64> = row[7..13].iter().map(|x| x.parse().unwrap()).collect();
            for (found, expected) in numbers.iter().zip([3.0, 4.0, 0.6, 0.8]) {
                assert!((found - expected).abs() < 4e-15, "{row:?}");
            }
            assert!(
                numbers[4] <= signed && signed <= numbers[5] && numbers[5] - numbers[4] < 1e-5,
                "{row:?}"
            );
            assert_eq!(row[13], id);
        }
    }
    // Without sides there is no sign, and in space a curve has no normal.
    let run = run_in(
        folder.path(),
        &[
            "inspect",
            "x = 3*cos(t); y = 3*sin(t); z = 0",
            "--tolerance",
            "1",
            "--point",
            "4,0,0",
            "--feet",
        ],
        "",
    );
    let row = run.out.lines().nth(1).unwrap();
    let fields: Vec<&str> = row.split(',').collect();
    assert_eq!(
        (fields.len(), &fields[8..9], &fields[11..]),
        (16, &["3.0"][..], &["", "", "", "", ""][..]),
        "{row}"
    );
    let arguments = [
        "inspect",
        "R = 3",
        "--tolerance",
        "1",
        "--point",
        "0,0,4",
        "--feet",
    ];
    let document = run_in(
        folder.path(),
        &[&arguments[..], &["--format", "json"]].concat(),
        "",
    );
    let document = json(&document.out);
    assert_eq!(
        document["points"][0]["foot"]["point"],
        json!([0.0, 0.0, 3.0])
    );
    assert_eq!(
        document["points"][0]["foot"]["normal"],
        json!([0.0, 0.0, 1.0])
    );
    let text = run_in(
        folder.path(),
        &[&arguments[..], &["--format", "text"]].concat(),
        "",
    );
    assert!(
        text.out
            .contains("its foot is about (0.0, 0.0, 3.0), with the normal (0.0, 0.0, 1.0)"),
        "{}",
        text.out
    );
}

/// At the origin the smallest error of a coordinate is large, in parts of it.
#[test]
fn a_point_of_the_form_is_its_own_foot_at_the_origin() {
    for form in ["r = cos(3*t)", "r = 1 + cos(t)", "x = t^2; y = t^3"] {
        let (found, run) = document(form, "1", "0,0");
        assert_eq!(run.code, 0, "{form}: {}", run.err);
        let point = &found["points"][0];
        assert_eq!(point["foot"]["point"], json!([0.0, 0.0]), "{form}");
    }
}

/// Far away all of a form is near a foot, compared with the coordinates; the foot must be on the form all the same.
#[test]
fn feet_of_far_points_are_on_the_form() {
    for (form, point, foot) in [
        ("x^2 + y^2 = 1", "1e9,0", [1.0, 0.0, 0.0]),
        ("y = x^2", "3,1e12", [1e6, 1e12, 0.0]),
        ("x^2 + y^2 + z^2 = 1", "0,0,-1e12", [0.0, 0.0, -1.0]),
        ("x = 1", "1,1e30,7e40", [1.0, 1e30, 7e40]),
        (
            "x^2/9 + y^2/4 + 10000*z^2 = 1",
            "4,1,0.5",
            [2.890_066_6, 0.536_447_6, 1.446_5e-5],
        ),
    ] {
        let (document, run) = document(form, "0.1", point);
        let found = &document["points"][0]["foot"]["point"];
        for (i, exact) in foot.iter().enumerate() {
            let off = found[i].as_f64().map_or(0.0, |x| (x - exact).abs());
            assert!(
                off <= 1e-7 * exact.abs().max(1.0),
                "{form} {point}: {found}"
            );
        }
        assert!(found.is_array(), "{form} {point}: {}", run.err);
    }
}

#[test]
fn a_foot_that_is_not_found_is_counted() {
    let folder = TempDir::new().unwrap();
    let run = inspect(
        folder.path(),
        "r = 5",
        "--tolerance 0.01 --reach 1.5 --feet",
    );
    // The bounds of the distance of the first point are not known either, but its side is.
    let first = run.out.lines().nth(1).unwrap();
    assert!(run.code == 1 && !first.contains("NaN"), "{first}");
    let run = inspect(
        folder.path(),
        "x^2 + y^2 = 25",
        "--tolerance 0.01 --reach 1.5 --feet",
    );
    let first = run.out.lines().nth(1).unwrap();
    assert!(first.contains(",-1,,,,,-inf,-1.9999"), "{first}");
    assert!(
        run.err
            .contains("of 1 point no foot was found that passes the check"),
        "{}",
        run.err
    );
}

/// Moving a form and a point changes neither the distance nor the normal.
#[test]
fn normals_are_known_far_from_the_origin() {
    for (at_origin, moved, [near, far]) in [
        (
            "r = 2 + cos(3t)/5",
            "# center: 500000, 5400000\nr = 2 + cos(3t)/5",
            ["1.5,2.5", "500001.5,5400002.5"],
        ),
        (
            "x = cos(t); y = sin(t)",
            "x = 20000000 + cos(t); y = sin(t)",
            ["0.75,1.5", "20000000.75,1.5"],
        ),
        (
            "x = (2 + cos(v))*cos(u); y = (2 + cos(v))*sin(u); z = sin(v)",
            "x = 200000 + (2 + cos(v))*cos(u); y = (2 + cos(v))*sin(u); z = sin(v)",
            ["2,2.5,0.25", "200002,2.5,0.25"],
        ),
    ] {
        let [here, there] = [(at_origin, near), (moved, far)]
            .map(|(form, point)| document(form, "1", point).0["points"][0]["foot"].clone());
        let normals = [&here, &there].map(|foot| {
            let list = foot["normal"].as_array().unwrap().iter();
            list.map(|x| x.as_f64().unwrap()).collect::<Vec<_>>()
        });
        for (a, b) in normals[0].iter().zip(&normals[1]) {
            assert!((a - b).abs() < 1e-8, "{moved}: {normals:?}");
        }
    }
}
