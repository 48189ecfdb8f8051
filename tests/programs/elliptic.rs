//! Elliptic series and distances of fits, from end to end.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use tempfile::TempDir;

use crate::common::program::{done, done_in, json, number, outline, rational, run_in, strings};

fn cavity() -> String {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let path = root.join("tests/outlines/hidden_cavity.csv");
    path.to_str().unwrap().to_owned()
}

fn document(arguments: &[&str]) -> Value {
    json(&done(
        &[&["fit", "--format", "json", "--quiet"], arguments].concat(),
    ))
}

fn distance(document: &Value) -> [f64; 2] {
    ["low", "high"].map(|end| document["distance"][end].as_f64().unwrap())
}

/// The radial error of 0.116 hides a cavity that is 8.02 deep.
#[test]
fn the_distance_of_a_radius_counts_what_it_cannot_see() {
    let fit = document(&[&cavity(), "--tolerance", "0.12", "--center", "0.1,0"]);
    assert!(fit["max_radial_error"].as_f64().unwrap() <= 0.12);
    let [low, high] = distance(&fit);
    assert!(low <= 8.02 + 0.01 && 8.02 - 0.01 <= high, "{low} {high}");
    assert!(high - low <= 0.01 * low);
    assert!(fit["hidden_share"].as_f64().unwrap() > 0.01);
    let series = document(&[&cavity(), "--model", "elliptic", "--distance", "0.5"]);
    assert!(distance(&series)[1] <= 0.5);
}

#[test]
fn an_elliptic_fit_has_the_fields_of_the_contract() {
    let fit = document(&[&outline("jet"), "--model", "elliptic", "--harmonics", "5"]);
    assert_eq!(fit["kind"], "parametric");
    assert_eq!(fit["parameters"], json("[\"t\"]"));
    assert!(fit.get("center").is_none());
    for name in ["x_cos", "x_sin", "y_cos", "y_sin"] {
        assert_eq!(strings(&fit["elliptic"][name]).len(), 6, "{name}");
    }
    assert_eq!(fit["elliptic"]["x_sin"][0], "0");
    let [low, high] = distance(&fit);
    assert!(0.0 < low && low <= high && high <= 1.01 * low);
    let share = |name: &str| fit[name].as_f64().unwrap();
    assert!(0.5 < share("overlap") && share("overlap") < 1.0);
    assert!(share("mean_distance") < high);
    // The formulas are the same numbers.
    let x = fit["coordinates"]["x"].as_str().unwrap();
    assert!(x.contains(&*strings(&fit["elliptic"]["x_cos"])[0]), "{x}");
}

/// What is written in any format is read as the same curve.
#[test]
fn elliptic_series_come_back_in_every_format() {
    let folder = TempDir::new().unwrap();
    let jet = outline("jet");
    let fit = [
        "fit",
        &jet,
        "--model",
        "elliptic",
        "-n",
        "3",
        "--decimals",
        "2",
    ];
    let mut equations = Vec::new();
    for format in ["text", "json", "csv", "sympy"] {
        let name = if format == "csv" {
            "fit.csv"
        } else {
            "fit.txt"
        };
        let written = done(&[&fit[..], &["--format", format]].concat());
        fs::write(folder.path().join(name), written).unwrap();
        equations.push(done_in(
            folder.path(),
            &["implicitize", name, "--format", "csv"],
            "",
        ));
    }
    let direct = [&["implicitize"], &fit[1..], &["--format", "csv"]].concat();
    equations.push(done(&direct));
    for equation in &equations {
        let plain = |text: &str| -> Vec<String> {
            let rows = text.lines().filter(|line| !line.starts_with('#'));
            rows.map(str::to_owned).collect()
        };
        assert_eq!(plain(equation), plain(&equations[0]));
        assert!(equation.contains("6,0,"), "{equation}");
    }
}

/// A table of another program has no harmonic 0, and other names.
#[test]
fn tables_of_elliptic_coefficients_are_read() {
    let folder = TempDir::new().unwrap();
    for header in ["n,x_cos,x_sin,y_cos,y_sin", "n,a,b,c,d", "n,an,bn,cn,dn"] {
        fs::write(
            folder.path().join("e.csv"),
            format!("{header}\n1,3,0,0,2\n"),
        )
        .unwrap();
        let text = done_in(folder.path(), &["implicitize", "e.csv"], "");
        assert!(text.contains("4x^2 + 9y^2 - 36 = 0"), "{text}");
    }
    fs::write(folder.path().join("e.csv"), "n,a,b,c,d\n0,1,1,0,0\n").unwrap();
    let run = run_in(folder.path(), &["implicitize", "e.csv"], "");
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("line 2: the sine of harmonic 0 is 0"),
        "{}",
        run.err
    );
}

#[test]
fn tolerances_distances_and_powers_choose_the_fewest_harmonics() {
    let jet = outline("jet");
    let harmonics = |document: &Value| match document.get("elliptic") {
        Some(series) => strings(&series["x_cos"]).len() - 1,
        None => strings(&document["cos"]).len() - 1,
    };
    for (model, size, bound) in [
        ("elliptic", "--tolerance", 60.0),
        ("elliptic", "--distance", 60.0),
        ("radius", "--distance", 330.0),
    ] {
        let found = document(&[&jet, "--model", model, size, &bound.to_string()]);
        let n = harmonics(&found);
        assert!(distance(&found)[1] <= bound, "{model} {size}");
        let samples: &[&str] = match model {
            "radius" => &["--samples", "4096"],
            _ => &[],
        };
        for fewer in 0..n {
            let fewer = fewer.to_string();
            let arguments = [&jet, "--model", model, "-n", &fewer];
            let less = document(&[&arguments[..], samples].concat());
            assert!(distance(&less)[1] > bound, "{model} {size}: {fewer}");
        }
    }
    let found = document(&[&jet, "--model", "elliptic", "--power", "0.9"]);
    assert!(found["harmonic_power"].as_f64().unwrap() >= 0.9);
    let n = harmonics(&found) - 1;
    let less = document(&[&jet, "--model", "elliptic", "-n", &n.to_string()]);
    assert!(less["harmonic_power"].as_f64().unwrap() < 0.9);
}

/// A distance that no number of harmonics reaches: the error names the best one, and its distance is that of the fit with so many.
#[test]
fn a_distance_out_of_reach_names_the_best_fit() {
    let text: String = (0..40)
        .map(|k| {
            let t = std::f64::consts::TAU * f64::from(k) / 40.0;
            let r = 2.0 + (2.0 * t).cos() / 2.0;
            format!("{},{}\n", r * t.cos(), r * t.sin())
        })
        .collect();
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("outline.csv"), text).unwrap();
    for model in ["radius", "elliptic"] {
        let fit = ["fit", "outline.csv", "--model", model];
        let far = run_in(
            folder.path(),
            &[&fit[..], &["--distance", "1e-5"]].concat(),
            "",
        );
        assert_eq!(far.code, 3, "{}", far.err);
        let (_, best) = far.err.split_once("of those measured is ≤ ").unwrap();
        let (distance_found, best) = best.split_once(", with ").unwrap();
        let (n, rest) = best.split_once(" harmonics").unwrap();
        assert_eq!(rest.contains("--samples"), model == "radius", "{rest}");
        let mut arguments = [&fit[..], &["-n", n, "--format", "json"]].concat();
        if model == "radius" {
            arguments.extend(["--samples", "4096"]);
        }
        let found = json(&done_in(folder.path(), &arguments, ""));
        let stated: f64 = distance_found.parse().unwrap();
        let [low, high] = distance(&found);
        assert!(low > 1e-5 && (high / stated - 1.0).abs() < 0.02, "{high}");
    }
    let small = run_in(
        folder.path(),
        &["fit", "outline.csv", "--distance", "1e-9"],
        "",
    );
    assert_eq!(small.code, 3);
    assert!(small.err.contains("is measured to 2e-6"), "{}", small.err);
}

/// The same outline turned, larger, elsewhere, from another vertex and in the other sense has the same normal form.
#[test]
fn normal_forms_of_alike_outlines_are_alike() {
    let folder = TempDir::new().unwrap();
    let text = fs::read_to_string(outline("jet")).unwrap();
    let mut points: Vec<[f64; 2]> = text
        .lines()
        .filter_map(|line| {
            let (x, y) = line.split_once(',')?;
            Some([x.parse().ok()?, y.parse().ok()?])
        })
        .collect();
    points.dedup();
    if points.first() == points.last() {
        points.pop();
    }
    points.rotate_left(40);
    points.reverse();
    let rows = points
        .iter()
        .map(|[x, y]| format!("{},{}\n", 300.0 - 2.0 * y, 7.0 + 2.0 * x));
    fs::write(folder.path().join("moved.csv"), rows.collect::<String>()).unwrap();
    let jet = outline("jet");
    let normal = |file: &str| {
        let flags = [
            "--model",
            "elliptic",
            "-n",
            "6",
            "--normal-form",
            "--format",
            "json",
            "--quiet",
        ];
        json(&done_in(
            folder.path(),
            &[&["fit", file], &flags[..]].concat(),
            "",
        ))
    };
    let (plain, moved) = (normal(&jet), normal("moved.csv"));
    let taken = |document: &Value, name: &str| document["normal_form"][name].as_f64().unwrap();
    assert!((taken(&moved, "size") / taken(&plain, "size") - 2.0).abs() < 1e-9);
    assert_ne!(
        moved["normal_form"]["reversed"],
        plain["normal_form"]["reversed"]
    );
    let mut worst = [0.0f64; 2];
    for name in ["x_cos", "x_sin", "y_cos", "y_sin"] {
        let lists = [&plain, &moved].map(|d| strings(&d["elliptic"][name]));
        for (n, (a, b)) in lists[0].iter().zip(&lists[1]).enumerate() {
            // From the other end of the half axis, even harmonics have the other sign.
            for (sign, worst) in [1.0, -1.0].into_iter().zip(&mut worst) {
                let sign = if n % 2 == 0 { sign } else { 1.0 };
                *worst = worst.max((number(a) - sign * number(b)).abs());
            }
        }
    }
    assert!(worst[0].min(worst[1]) < 1e-9, "{worst:?}");
    let run = run_in(
        Path::new("."),
        &["fit", &jet, "-n", "3", "--normal-form"],
        "",
    );
    assert_eq!(run.code, 2);
    assert!(run.err.contains("it needs --model elliptic"), "{}", run.err);
}

/// All coefficients of the documents are decimals of so many digits.
#[test]
fn coefficients_are_rounded_to_decimals() {
    let fit = document(&[
        &outline("jet"),
        "--model",
        "elliptic",
        "-n",
        "4",
        "--decimals",
        "1",
    ]);
    for list in fit["elliptic"].as_object().unwrap().values() {
        for value in strings(list) {
            let ten = num_bigint::BigInt::from(10);
            assert!((rational(&value) * ten).is_integer(), "{value}");
        }
    }
}

#[test]
fn a_plot_shows_outline_series_and_zero_set() {
    let folder = TempDir::new().unwrap();
    let svg = folder.path().join("jet.svg");
    let svg = svg.to_str().unwrap();
    let jet = outline("jet");
    done(&["plot", &jet, "--model", "elliptic", "-n", "4", "-o", svg]);
    let drawn = fs::read_to_string(svg).unwrap();
    for label in [
        "outline, jet.csv",
        "elliptic series, N = 4",
        "zero set, degree 8",
    ] {
        assert!(drawn.contains(label), "{label}");
    }
}

#[test]
fn options_that_do_nothing_are_refused() {
    let jet = outline("jet");
    for (arguments, message) in [
        (
            vec![
                "fit", &jet, "--model", "elliptic", "-n", "3", "--center", "1,2",
            ],
            "--center is for fits of the radius",
        ),
        (
            vec![
                "fit",
                &jet,
                "--model",
                "elliptic",
                "-n",
                "3",
                "--samples",
                "100",
            ],
            "--samples is for fits of the radius",
        ),
        (
            vec!["fit", &jet, "--power", "0.9"],
            "--power chooses the harmonics of an elliptic series",
        ),
        (
            vec!["fit", &jet, "--model", "elliptic", "--power", "2"],
            "between 0 and 1",
        ),
        (
            vec!["fit", &jet, "--model", "elliptic", "-n", "5000"],
            "at most 4096 harmonics",
        ),
        (
            vec!["describe", "x^2 + y^2 = 1", "--model", "elliptic"],
            "--model is for contours",
        ),
        (
            vec!["sample", "x^2 + y^2 = 1", "--distance", "1"],
            "--distance is for contours",
        ),
    ] {
        let run = run_in(Path::new("."), &arguments, "");
        assert_ne!(run.code, 0, "{arguments:?}");
        assert!(run.err.contains(message), "{arguments:?}: {}", run.err);
        assert!(run.out.is_empty());
    }
}
