//! The program at the terminal: its help, completions and manual, its messages, and where it writes.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::process::Command;

use tempfile::TempDir;

use crate::common::program::{done, json, run_in};

const CIRCLE: &str = "x^2 + y^2 = 1";

fn refused(arguments: &[&str]) -> String {
    let run = run_in(TempDir::new().unwrap().path(), arguments, "");
    assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}");
    run.err
}

#[test]
fn options_of_every_verb_are_shown_once() {
    let help = done(&["--help"]);
    for line in [
        "Options of every verb:",
        "  -o, --output <FILE>",
        "--time-limit <SECONDS>",
        "[default: 20002]",
        "Exit codes:",
        "  4  the program contradicted itself",
    ] {
        assert!(help.contains(line), "{line}\n{help}");
    }
    assert!(help.lines().all(|line| line.chars().count() <= 104));
    for verb in ["describe", "sample", "inspect", "paper", "man"] {
        let help = done(&[verb, "--help"]);
        assert!(!help.contains("--max-degree"), "{verb}");
        assert!(help.contains("stellate --help"), "{verb}");
        // They are understood all the same.
        assert!(done(&[verb, "--max-degree", "3", "--help"]).contains("Usage:"));
    }
}

#[test]
fn completions_and_manual_know_every_verb() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let text = done(&["completions", shell]);
        assert!(
            text.contains("implicitize") && text.contains("time-limit"),
            "{shell}"
        );
    }
    let manual = done(&["man"]);
    assert!(manual.contains(".TH stellate 1") && manual.contains("implicitize"));
}

#[test]
fn errors_have_one_voice_or_are_json() {
    for (arguments, message) in [
        (
            &["describe", "x +"][..],
            "stellate: <form>:1:4: expected a number",
        ),
        (
            &["describe", "no-such.txt"],
            "stellate: no-such.txt: No such file or directory\n",
        ),
        (&["frobnicate"], "stellate: there is no verb frobnicate"),
        (
            &["fit", "a.csv", "-n", "3.5"],
            "expected a whole number, such as 39",
        ),
        (
            &["sample", CIRCLE, "--theta", "1e22"],
            "radians up to 1e9 such as 0.5 or pi/6",
        ),
        (
            &["describe", CIRCLE, "--time-limit", "soon"],
            "or with a unit, such as 5min",
        ),
        (
            &["inspect", CIRCLE, "--tolerance", "1"],
            "--point X,Y[,Z], which may be repeated",
        ),
        (
            &["mesh", "x^2+y^2+z^2=1", "--format", "latex"],
            "mesh has no --format",
        ),
        (
            &["plot", CIRCLE, "--view", "1,2", "-o", "a.svg"],
            "--view turns a picture of space",
        ),
        (
            &["plot", CIRCLE, "--width", "100", "-o", "a.svg"],
            "--width 100: a picture is from 300 to 4000 units wide",
        ),
    ] {
        let err = refused(arguments);
        assert!(
            err.starts_with("stellate: ") && err.contains(message),
            "{err}"
        );
    }
    let err = refused(&["describe", "x +", "--format", "json"]);
    let error = &json(&err)["error"];
    assert_eq!(error["exit_code"], 2);
    let message = error["message"].as_str().unwrap();
    assert!(
        message.starts_with("<form>:1:4: expected a number"),
        "{message}"
    );
}

#[test]
fn describe_obeys_the_largest_degree() {
    let folder = TempDir::new().unwrap();
    for form in ["x^40 = y", "x^40 + z = y"] {
        let run = run_in(folder.path(), &["describe", form, "--max-degree", "10"], "");
        assert_eq!((run.code, run.out.as_str()), (3, ""), "{}", run.err);
        assert!(run.err.contains("--max-degree 10"), "{}", run.err);
    }
}

#[test]
fn angles_are_read_as_they_are_printed() {
    let row = |theta: &str| {
        let rows = done(&["sample", CIRCLE, "--theta", theta, "--positive"]);
        let row = rows.lines().nth(1).unwrap().to_owned();
        row.split(',')
            .skip(2)
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    for (same, other) in [
        ("pi/6", "30deg"),
        ("30°", "30deg"),
        ("30 deg", "30deg"),
        ("-3pi/4", "-135deg"),
        ("3*pi/2", "270deg"),
        ("2π", "0"),
        ("pi", "180deg"),
        ("-pi", "180deg"),
        ("0.25pi", "45deg"),
        ("1/3*pi", "60deg"),
    ] {
        assert_eq!(row(same), row(other), "{same}");
    }
    for wrong in ["pi/0", "pi pi", "x", "", "30 degs", "pi/2/3", "1pi2"] {
        refused(&["sample", CIRCLE, "--theta", wrong]);
    }
}

#[test]
fn times_may_have_units() {
    for limit in ["5", "5s", "500ms", "2min", "2m", "1h", "0.5 s"] {
        assert!(done(&["describe", CIRCLE, "--time-limit", limit]).contains("degree: 2"));
    }
}

/// `-` is standard output, and what stands behind it is written to and not replaced.
#[cfg(unix)]
#[test]
fn standard_output_is_written_to_and_never_renamed_over() {
    let expected = done(&["describe", CIRCLE]);
    let folder = TempDir::new().unwrap();
    assert_eq!(done(&["describe", CIRCLE, "-o", "-"]), expected);
    for name in ["-", "/dev/stdout", "/dev/fd/1"] {
        let log = folder.path().join("log");
        fs::write(&log, "before\n").unwrap();
        let file = fs::OpenOptions::new().append(true).open(&log).unwrap();
        let status = Command::new(env!("CARGO_BIN_EXE_stellate"))
            .args(["describe", CIRCLE, "-o", name])
            .stdout(file)
            .status();
        assert!(status.unwrap().success(), "{name}");
        assert_eq!(
            fs::read_to_string(&log).unwrap(),
            format!("before\n{expected}"),
            "{name}"
        );
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// A point on which the work is long: the header of the table does not keep the time limit from ending it.
#[test]
fn a_point_that_takes_too_long_ends_at_the_time_limit() {
    let folder = TempDir::new().unwrap();
    let form = "(x^2 + y^2)^296 = x^2 - y^2";
    for more in [&[][..], &["-o", "out.csv"]] {
        let arguments = [
            &[
                "inspect",
                form,
                "--tolerance",
                "0.1",
                "--point",
                "0.5,0.5,1/3",
            ][..],
            &["--time-limit", "1"],
            more,
        ];
        let run = run_in(folder.path(), &arguments.concat(), "");
        assert_eq!((run.code, run.out.as_str()), (3, ""), "{}", run.err);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
