//! Stated limits end with exit code 3, and a run that fails leaves everything as it was.

use std::fs;

use tempfile::TempDir;

use super::bad_input::{EGG, circle, refused_in};

#[test]
fn stated_limits_end_with_code_3() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("c.csv"), circle().join("\n")).unwrap();
    let deep = format!("{}x{}", "(".repeat(20_000), ")".repeat(20_000));
    for (arguments, expected) in [
        (
            &["implicitize", EGG, "--max-degree", "3"][..],
            "degree 4 is above --max-degree 3",
        ),
        (
            &["implicitize", "x^4 + y", "--max-degree", "3"],
            "--max-degree 3",
        ),
        (
            &[
                "implicitize",
                "c.csv",
                "--harmonics",
                "9",
                "--max-degree",
                "19",
            ],
            "degree 20",
        ),
        (&["fit", "c.csv", "--harmonics", "100000"], "--max-degree"),
        (
            &["fit", "c.csv", "--harmonics", "18446744073709551615"],
            "--max-degree",
        ),
        (&["fit", "c.csv", "--tolerance", "1e-30"], "the best found"),
        (
            &["implicitize", EGG, "--time-limit", "0", "-o", "f.json"],
            "--time-limit 0",
        ),
        (
            &["fit", "c.csv", "--harmonics", "3", "--time-limit", "0"],
            "--time-limit 0",
        ),
        (&["sample", EGG, "--time-limit", "0"], "--time-limit 0"),
        (
            &["plot", EGG, "-o", "f.svg", "--time-limit", "0"],
            "--time-limit 0",
        ),
        (
            &["implicitize", EGG, "--threads", "100000"],
            "--threads 100000",
        ),
        (
            &["sample", EGG, "--directions", "999999999"],
            "--directions 999999999",
        ),
        (
            &["implicitize", "x^99999999999999999999 + y"],
            "<form>:1:3: an exponent beyond",
        ),
        (
            &["implicitize", "r = cos(999999999*t)"],
            "a harmonic beyond",
        ),
        (
            &["implicitize", "(x + y + 1)^9999"],
            "terms after expansion",
        ),
        (&["implicitize", "((9^9999)^9999)^9999*x + y"], "digits"),
        (&["implicitize", &deep], "nested more than"),
    ] {
        let said = refused_in(folder.path(), arguments, b"", 3);
        let shown = &said[..said.len().min(500)];
        assert!(said.contains(expected), "{shown}");
        assert!(
            said.len() < 2000,
            "a message repeats at most a piece of its input"
        );
    }
}

#[test]
fn an_existing_file_survives_a_failure() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("out.json"), "precious").unwrap();
    refused_in(
        folder.path(),
        &["implicitize", "r = 1/0", "-o", "out.json"],
        b"",
        2,
    );
    refused_in(
        folder.path(),
        &["implicitize", EGG, "-o", "out.json", "--time-limit", "0"],
        b"",
        3,
    );
    refused_in(
        folder.path(),
        &["implicitize", EGG, "-o", "out.json", "--max-degree", "3"],
        b"",
        3,
    );
    assert_eq!(
        fs::read(folder.path().join("out.json")).unwrap(),
        b"precious"
    );
}

#[test]
fn a_reader_who_has_read_enough_is_no_error() {
    let program = assert_cmd::cargo::cargo_bin("stellate");
    let mut child = std::process::Command::new(program)
        .args(["sample", EGG, "--directions", "3000"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
}
