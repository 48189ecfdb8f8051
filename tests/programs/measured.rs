//! Measured outlines: noise, many points, and data that must not be lost.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use super::outlines::{file, mean_and_center};
use crate::common::program::run_in;

/// Noisy points in order, which touch themselves: what is cut off is said.
#[test]
fn an_outline_that_touches_itself_is_mended() {
    let noisy = file("noisy_circle.csv");
    let refused = run_in(Path::new("."), &["fit", &noisy, "-n", "3"], "");
    assert_eq!(refused.code, 2);
    assert!(refused.err.contains("--repair"), "{}", refused.err);
    let run = run_in(
        Path::new("."),
        &["fit", &noisy, "-n", "3", "--repair", "--format", "json"],
        "",
    );
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(
        run.err.contains("leaves out") && run.err.contains("of its length (--repair)"),
        "{}",
        run.err
    );
    let points: usize = run
        .err
        .split("leaves out ")
        .nth(1)
        .unwrap()
        .split(' ')
        .next()
        .unwrap()
        .parse()
        .unwrap();
    assert!((1..200).contains(&points), "{}", run.err);
    let (a0, _) = mean_and_center(&[&noisy, "--repair"]);
    let (_, [x, y]) = mean_and_center(&[&noisy, "--repair", "--model", "radius"]);
    assert!(a0 > 0.0 && x.hypot(y) < 0.1 * a0, "{a0} ({x}, {y})");
    // Nothing is said of an outline that needs no repair.
    let run = run_in(
        Path::new("."),
        &["fit", &file("plain.txt"), "-n", "3", "--repair"],
        "",
    );
    assert!(
        run.code == 0 && !run.err.contains("--repair"),
        "{}",
        run.err
    );
    let run = run_in(
        Path::new("."),
        &["describe", "x^2 + y^2 = 1", "--repair"],
        "",
    );
    assert!(
        run.code == 2 && run.err.contains("--repair is for outlines"),
        "{}",
        run.err
    );
}

/// The samples of the radius follow the data: a wave of 1024 periods is not read at one place of each.
#[test]
fn samples_are_at_least_twice_as_many_as_vertices() {
    let rows: String = (0..40_000)
        .map(|k| {
            let t = std::f64::consts::TAU * f64::from(k) / 40_000.0;
            let r = 10.0 + 0.5 * (1024.0 * t).cos();
            format!("{},{}\n", r * t.cos(), r * t.sin())
        })
        .collect();
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("wave.csv");
    fs::write(&path, rows).unwrap();
    let (a0, _) = mean_and_center(&[path.to_str().unwrap(), "--center", "0,0"]);
    assert!((a0 - 10.0).abs() < 0.01, "{a0}");
}

/// Runs a command that is wrong use.
fn refused(folder: &Path, command: &[&str], message: &str) {
    let run = run_in(folder, command, "");
    assert_eq!(run.code, 2, "{command:?}");
    assert!(run.err.contains(message), "{}", run.err);
}

/// A slip of the hand does not destroy the data.
#[test]
fn the_output_is_never_the_input() {
    let folder = TempDir::new().unwrap();
    let rows = "x,y\n0,0\n2,0\n2,2\n0,2\n";
    fs::write(folder.path().join("a.csv"), rows).unwrap();
    for arguments in [
        &["fit", "a.csv", "-n", "3", "-o", "a.csv"][..],
        &["fit", "a.csv", "--all", "-n", "3", "-o", "./a.csv"],
        &["implicitize", "./a.csv", "-n", "3", "-o", "a.csv"],
        &["fit", "a.csv", "-n", "3", "--proof", "./a.csv"],
        &[
            "inspect",
            "r = 1",
            "--tolerance",
            "1",
            "--points",
            "a.csv",
            "-o",
            "a.csv",
        ],
        &[
            "inspect",
            "r = 1",
            "--tolerance",
            "1",
            "--points",
            "a.csv",
            "--proof",
            "a.csv",
        ],
        &["check", "r = 1", "--points", "a.csv", "-o", "./a.csv"],
        &["check", "r = 1", "--radii", "a.csv", "-o", "a.csv"],
        &["verify", "a.csv", "-o", "a.csv"],
        &["check", "r = 1", "--coefficients", "a.csv", "-o", "a.csv"],
    ] {
        refused(folder.path(), arguments, "this file is read");
        assert_eq!(
            fs::read_to_string(folder.path().join("a.csv")).unwrap(),
            rows
        );
    }
}

/// A proof is not lost among the answer, and has a file.
#[test]
fn a_proof_has_a_file_of_its_own() {
    let folder = TempDir::new().unwrap();
    for (arguments, message) in [
        (
            ["-o", "a.txt", "--proof", "a.txt"],
            "-o writes to this file",
        ),
        (["-o", "a.txt", "--proof", "-"], "a file of its own"),
    ] {
        let command = [&["implicitize", "r = 2"], &arguments[..]].concat();
        refused(folder.path(), &command, message);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
