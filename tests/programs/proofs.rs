//! Proof files, from end to end.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

use crate::common::program::{done, run_in};

/// The proofs beside the tests.
fn proofs() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/proofs");
    let files = fs::read_dir(folder)
        .unwrap()
        .map(|file| file.unwrap().path());
    let mut files: Vec<PathBuf> = files.collect();
    files.sort();
    assert!(files.len() >= 7);
    files
}

/// Proofs with something wrong: the text, what is changed in it, and what the checkers say.
const WRONG: [[&str; 3]; 3] = [
    [
        "mignotte-200.json",
        "\"multiplicity\":1,",
        "\"multiplicity\":2,",
    ],
    [
        "example-8.json",
        "\"coefficient\":\"1\"",
        "\"coefficient\":\"7\"",
    ],
    [
        "wrong-count.json",
        "\"order_at_zero\":1",
        "\"order_at_zero\":2",
    ],
];

fn wrong(folder: &Path) -> Vec<PathBuf> {
    let made = WRONG.map(|[name, from, to]| {
        let file = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tests/proofs")
            .join(name);
        let text = fs::read_to_string(file).unwrap().replace("\": ", "\":");
        assert!(text.contains(from), "{name}");
        let path = folder.join(name);
        fs::write(&path, text.replacen(from, to, 1)).unwrap();
        path
    });
    made.to_vec()
}

#[test]
fn proofs_are_accepted_and_wrong_ones_are_refused() {
    for file in proofs() {
        let run = run_in(Path::new("."), &["verify", file.to_str().unwrap()], "");
        assert_eq!(run.code, 0, "{}: {} {}", file.display(), run.out, run.err);
        assert!(
            run.out.contains(" claim") && run.out.contains(", 0 refused"),
            "{}",
            run.out
        );
    }
    let folder = TempDir::new().unwrap();
    for file in wrong(folder.path()) {
        let run = run_in(Path::new("."), &["verify", file.to_str().unwrap()], "");
        assert_eq!(run.code, 1, "{}: {} {}", file.display(), run.out, run.err);
        assert!(run.out.starts_with("refused: claim "), "{}", run.out);
    }
    for (text, part) in [("{}", "no proof"), ("r = 1", "no proof"), ("", "no proof")] {
        let run = run_in(Path::new("."), &["verify", "-"], text);
        assert!(run.code == 2 && run.err.contains(part), "{}", run.err);
    }
}

/// The checker in Python says the same; only where the variable says that Python is there.
#[test]
fn the_checker_in_python_says_the_same() {
    let checker = done(&["verify", "--checker"]);
    assert!(checker.lines().count() <= 500);
    assert!(checker.contains("import"));
    if std::env::var_os("STELLATE_SYSTEMS").is_none() {
        let skipped = "skipped: Python checks proofs with STELLATE_SYSTEMS=1";
        writeln!(std::io::stderr(), "{skipped}").unwrap();
        return;
    }
    let folder = TempDir::new().unwrap();
    let program = folder.path().join("checker.py");
    fs::write(&program, checker).unwrap();
    let code = |file: &Path| {
        let run = Command::new("python3")
            .arg(&program)
            .arg(file)
            .output()
            .unwrap();
        run.status.code().unwrap()
    };
    assert!(proofs().iter().all(|file| code(file) == 0));
    assert!(wrong(folder.path()).iter().all(|file| code(file) == 1));
}
