//! Running the program and reading what it says.

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use num_rational::BigRational;
use serde_json::Value;
use tempfile::TempDir;

use super::schemas;

pub(crate) const EGG: &str = "r = 1 + 1/5*cos(t) + 0.1*sin(t)";

/// A run of the program.
pub(crate) struct Run {
    pub(crate) code: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

pub(crate) fn run_in(folder: &Path, arguments: &[&str], stdin: &str) -> Run {
    let output = Command::cargo_bin("stellate")
        .unwrap()
        .current_dir(folder)
        .args(arguments)
        .write_stdin(stdin)
        .output()
        .unwrap();
    let run = Run {
        code: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    };
    if run.out.starts_with("{\"schema\"") {
        json(&run.out);
    }
    run
}

/// Runs with a file `data.csv` of this text.
pub(crate) fn with_data(text: &str, arguments: &[&str]) -> Run {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("data.csv"), text).unwrap();
    run_in(folder.path(), arguments, "")
}

/// What a successful run prints.
pub(crate) fn done_in(folder: &Path, arguments: &[&str], stdin: &str) -> String {
    let run = run_in(folder, arguments, stdin);
    assert_eq!(run.code, 0, "{arguments:?}: {}", run.err);
    run.out
}

pub(crate) fn done(arguments: &[&str]) -> String {
    done_in(Path::new("."), arguments, "")
}

pub(crate) fn piped(arguments: &[&str], stdin: &str) -> String {
    done_in(Path::new("."), arguments, stdin)
}

/// The value of a text; documents fulfil their schema.
pub(crate) fn json(text: &str) -> Value {
    let value: Value = serde_json::from_str(text).unwrap();
    if value.get("schema").is_some() {
        schemas::check(&value);
    }
    value
}

pub(crate) fn outline(name: &str) -> String {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("paper-examples");
    let path = root.join(format!("e02-{name}/{name}.csv"));
    path.to_str().unwrap().to_owned()
}

pub(crate) fn strings(value: &Value) -> Vec<String> {
    let entries = value.as_array().unwrap().iter();
    entries.map(|v| v.as_str().unwrap().to_owned()).collect()
}

pub(crate) fn rational(text: &str) -> BigRational {
    text.parse().unwrap()
}

/// The double near an exact number.
pub(crate) fn number(text: &str) -> f64 {
    let exact = rational(text);
    let [above, below] =
        [exact.numer(), exact.denom()].map(|n| n.to_string().parse::<f64>().unwrap());
    above / below
}

pub(crate) fn rationals(value: &Value) -> Vec<BigRational> {
    strings(value).iter().map(|t| rational(t)).collect()
}
