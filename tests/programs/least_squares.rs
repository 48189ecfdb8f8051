//! Measured points: least squares, weights, robust fits and clouds, from end to end.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::f64::consts::TAU;
use std::fs;

use serde_json::Value;
use tempfile::TempDir;

use super::outlines::file;
use crate::common::program::{done, done_in, json, outline, piped, rational, run_in, with_data};

/// Numbers between −1 and 1, from a generator of Knuth.
fn noise() -> impl FnMut() -> f64 {
    let mut state = 1_u64;
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 32).unwrap()) / f64::from(1_u32 << 31) - 1.0
    }
}

/// Points of r = 50 + 3 cos 3t − 2 sin 5t about (100, −20), each with an error of the radius.
fn points(count: u32, mut error: impl FnMut(u32) -> f64) -> Vec<[f64; 2]> {
    let point = |k: u32| {
        let t = TAU * f64::from(k) / f64::from(count);
        let r = 50.0 + 3.0 * (3.0 * t).cos() - 2.0 * (5.0 * t).sin() + error(k);
        [100.0 + r * t.cos(), r * t.sin() - 20.0]
    };
    (0..count).map(point).collect()
}

fn rows(points: &[[f64; 2]]) -> String {
    points.iter().map(|[x, y]| format!("{x},{y}\n")).collect()
}

fn fitted(text: &str, arguments: &[&str]) -> Value {
    let all = [
        &["fit", "data.csv", "--format", "json", "--quiet"],
        arguments,
    ]
    .concat();
    let run = with_data(text, &all);
    assert_eq!(run.code, 0, "{arguments:?}: {}", run.err);
    json(&run.out)
}

/// The coefficients of cos 3t and of sin 5t.
fn waves(document: &Value) -> [f64; 2] {
    let coefficient = |list: &str, n: usize| rational(document[list][n].as_str().unwrap());
    [coefficient("cos", 3), coefficient("sin", 5)].map(|q| {
        let [p, q] = [q.numer(), q.denom()].map(|n| n.to_string().parse::<f64>().unwrap());
        p / q
    })
}

/// 200 000 points with an error of at most 1: the coefficients have standard errors of 0.0018, and those of quadrature, which
/// would see the outermost of these points alone, do not matter.
#[test]
fn many_noisy_points_give_what_they_allow() {
    let mut next = noise();
    let text = rows(&points(200_000, |_| next()));
    let fit = fitted(&text, &["-n", "8", "--cloud"]);
    let [cos, sin] = waves(&fit);
    assert!(
        (cos - 3.0).abs() < 0.008 && (sin + 2.0).abs() < 0.008,
        "{cos} {sin}"
    );
    let errors = &fit["least_squares"]["standard_errors"];
    let error = errors["cos"][3].as_f64().unwrap();
    // The standard deviation of such an error is 1/√3.
    let expected = (2.0 / 3.0 / 200_000.0_f64).sqrt();
    assert!((error / expected - 1.0).abs() < 0.01, "{error}");
    assert_eq!(fit["samples"], 200_000);
    assert_eq!(fit["star_shaped"], true);
    assert!(fit.get("outline_star_shaped").is_none() && fit.get("distance").is_none());
}

/// The order of the points of a cloud does not matter, and its center is that of the points.
#[test]
fn a_cloud_has_no_order() {
    let exact = points(360, |_| 0.0);
    let mixed: Vec<[f64; 2]> = (0..360).map(|k| exact[k * 77 % 360]).collect();
    for points in [&exact, &mixed] {
        let fit = fitted(
            &rows(points),
            &["-n", "8", "--cloud", "--center", "100,-20"],
        );
        let [cos, sin] = waves(&fit);
        assert!((cos - 3.0).abs() < 1e-12 && (sin + 2.0).abs() < 1e-12);
        assert!(fit["max_radial_error"].as_f64().unwrap() < 1e-12);
        let found = fitted(&rows(points), &["--tolerance", "0.01", "--cloud"]);
        let center = [0, 1].map(|i| rational(found["center"][i].as_str().unwrap()));
        let near = |i: usize, c: i64| (&center[i] - rational(&c.to_string())) < rational("1/10");
        assert!(near(0, 100) && near(1, -20));
        assert!(found["max_radial_error"].as_f64().unwrap() <= 0.01);
    }
    // Every verb that takes a contour takes a cloud.
    let text = rows(&mixed);
    let verb = |name: &str, more: &[&str]| {
        let all = [
            &[
                name,
                "data.csv",
                "--cloud",
                "-n",
                "6",
                "--decimals",
                "3",
                "--quiet",
            ],
            more,
        ]
        .concat();
        let run = with_data(&text, &all);
        assert_eq!(run.code, 0, "{name}: {}", run.err);
        run.out
    };
    let equation = json(&verb("implicitize", &["--format", "json"]));
    assert_eq!(equation["degree"], 12);
    assert!(verb("describe", &[]).contains("least squares: 360 points"));
    assert!(verb("sample", &["--directions", "4"]).lines().count() >= 5);
    let folder = TempDir::new().unwrap();
    let [data, figure] = ["data.csv", "figure.svg"].map(|name| folder.path().join(name));
    fs::write(&data, &text).unwrap();
    done_in(
        folder.path(),
        &["plot", "data.csv", "--cloud", "-n", "6", "-o", "figure.svg"],
        "",
    );
    assert!(
        fs::read_to_string(figure)
            .unwrap()
            .contains("points, data.csv")
    );
}

/// Points that are far off count less, and those with small weights, too.
#[test]
fn weights_and_huber_resist_what_is_wrong() {
    let mut next = noise();
    let wrong = |k: u32| k % 200 < 14;
    let measured = points(600, |k| if wrong(k) { 20.0 } else { 0.01 * next() });
    let off = |fit: &Value| {
        let [cos, sin] = waves(fit);
        (cos - 3.0).abs().max((sin + 2.0).abs())
    };
    let center = ["-n", "6", "--center", "100,-20", "--cloud"];
    let plain = fitted(&rows(&measured), &center);
    assert!(off(&plain) > 0.02, "{}", off(&plain));
    let robust = fitted(&rows(&measured), &[&center[..], &["--robust"]].concat());
    assert!(off(&robust) < 0.003, "{}", off(&robust));
    let huber = &robust["least_squares"]["robust"];
    assert_eq!(
        (&huber["loss"], &huber["constant"]),
        (&Value::from("huber"), &Value::from(1.345))
    );
    assert!(huber["reduced"].as_u64().unwrap() >= 40);
    let weight = |k: u32| if wrong(k) { "1e-8" } else { "4" };
    let weighted = measured.iter().zip(0..);
    let weighted: String = weighted
        .map(|([x, y], k)| format!("{},{x},{y}\n", weight(k)))
        .collect();
    let text = format!("w,x,y\n{weighted}");
    let fit = fitted(&text, &[&center[..], &["--weights", "w"]].concat());
    assert!(off(&fit) < 0.003, "{}", off(&fit));
    assert_eq!(fit["least_squares"]["weighted"], true);
}

/// The vertices of an outline, in order, by both models.
#[test]
fn outlines_are_fitted_by_least_squares() {
    let jet = outline("jet");
    let squares = ["--estimator", "least-squares", "--harmonics", "8"];
    let arguments = [&["fit", &jet, "--format", "json", "--quiet"], &squares[..]].concat();
    let fit = json(&done(&arguments));
    assert_eq!(fit["least_squares"]["points"], fit["samples"]);
    assert!(
        fit["hidden_share"].as_f64().unwrap() > 0.1
            && fit["distance"]["high"].as_f64().unwrap() > 1.0
    );
    let fit = json(&done(&[&arguments[..], &["--model", "elliptic"]].concat()));
    let errors = &fit["least_squares"]["standard_errors"];
    for name in ["x_cos", "x_sin", "y_cos", "y_sin"] {
        assert_eq!(errors[name].as_array().unwrap().len(), 9);
    }
    assert_eq!(
        fit["least_squares"]["deviation"].as_array().unwrap().len(),
        2
    );
    let text = piped(
        &["fit", "-", "--robust", "-n", "8"],
        &rows(&points(100, |_| 0.0)),
    );
    assert!(
        text.contains("Huber's loss with the constant 1.345"),
        "{text}"
    );
}

/// What `--repair` cuts off is drawn.
#[test]
fn what_is_cut_off_is_drawn() {
    let folder = TempDir::new().unwrap();
    let noisy = file("noisy_circle.csv");
    done_in(
        folder.path(),
        &["plot", &noisy, "--repair", "-o", "a.svg", "--quiet"],
        "",
    );
    let svg = fs::read_to_string(folder.path().join("a.svg")).unwrap();
    assert!(svg.contains("cut off by --repair"));
}

#[test]
fn what_does_not_belong_together_is_refused() {
    let text = rows(&points(60, |_| 0.0));
    for (arguments, part) in [
        (
            &["--robust", "--estimator", "quadrature"][..],
            "--robust is for least squares",
        ),
        (&["--weights", "3"], "there is no column 3"),
        (&["--weights", "2"], "--columns says which are x and y"),
        (&["--cloud", "--estimator", "quadrature"], "have no order"),
        (&["--cloud", "--model", "elliptic"], "have no order"),
        (&["--cloud", "--center", "kernel"], "are for outlines"),
        (&["--cloud", "--repair"], "--repair is for outlines"),
        (
            &["--robust", "--samples", "1000"],
            "least squares take the given points",
        ),
        (&["--cloud", "--all"], "one cloud"),
    ] {
        let run = with_data(
            &text,
            &[&["fit", "data.csv", "-n", "3"], arguments].concat(),
        );
        assert_eq!(run.code, 2, "{arguments:?}: {}", run.err);
        assert!(run.err.contains(part), "{arguments:?}: {}", run.err);
    }
    for (arguments, part) in [
        (
            &["fit", "data.csv", "--cloud", "--distance", "1"][..],
            "is for outlines",
        ),
        (
            &["fit", "data.csv", "--cloud", "-n", "30"],
            "there are 60 points",
        ),
        (
            &["describe", "r = 1", "--cloud"],
            "--cloud is for tables of points",
        ),
        (
            &["describe", "r = 1", "--robust"],
            "--robust is for contours",
        ),
    ] {
        let run = with_data(&text, arguments);
        assert_eq!(run.code, 2, "{arguments:?}: {}", run.err);
        assert!(run.err.contains(part), "{arguments:?}: {}", run.err);
    }
    let bad = with_data(
        "x,y,w\n1,0,1\n0,1,-1\n-1,0,1\n",
        &["fit", "data.csv", "-n", "1", "--cloud", "--weights", "w"],
    );
    assert!(bad.err.contains("row 3: the weight -1"), "{}", bad.err);
    let picture = file("comb_hole.png");
    let run = run_in(
        std::path::Path::new("."),
        &["fit", &picture, "-n", "3", "--cloud"],
        "",
    );
    assert!(
        run.code == 2 && run.err.contains("tables of points"),
        "{}",
        run.err
    );
}

/// All outlines of a file that comes through a pipe.
#[test]
fn all_outlines_of_standard_input_are_fitted() {
    let text = fs::read_to_string(file("islands.geojson")).unwrap();
    let arguments = ["fit", "-", "--all", "-n", "2", "--quiet"];
    let table = piped(&arguments, &text);
    let of_file = done_in(
        std::path::Path::new("."),
        &[
            "fit",
            &file("islands.geojson"),
            "--all",
            "-n",
            "2",
            "--quiet",
        ],
        "",
    );
    let rows = |table: &str| {
        table
            .lines()
            .map(|l| l.split_once(',').unwrap().1.to_owned())
            .collect::<Vec<_>>()
    };
    assert_eq!(rows(&table), rows(&of_file));
    assert!(rows(&table).len() > 2);
}
