//! Proofs in which one thing was changed so that the claim is false, or its witness proves nothing: all are refused.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::Command;

use stellate::proof::check;
use tempfile::TempDir;

use crate::common::program::done;
use crate::common::proofs::{drawn_command, proof_of};
use crate::common::random::SplitMix;
use crate::common::wrong_proofs::wrong_proofs;

/// At least `count` wrong proofs from drawn commands, `most` of each.
fn drawn(count: usize, most: usize, words: &mut SplitMix) -> Vec<String> {
    let folder = TempDir::new().unwrap();
    let mut made = Vec::new();
    while made.len() < count {
        let text = proof_of(&drawn_command(words), folder.path());
        made.extend(wrong_proofs(&text, most, words));
    }
    made.truncate(count);
    made
}

/// Whether the verifier accepts the document.
fn is_accepted(text: &str) -> bool {
    check(text, false).is_ok_and(|report| report.refused.is_empty())
}

fn refused_by_the_verifier(proofs: &[String]) {
    for text in proofs {
        assert!(!is_accepted(text), "{text}");
    }
}

#[test]
fn wrong_proofs_are_refused() {
    let mut words = SplitMix(28);
    refused_by_the_verifier(&drawn(600, 12, &mut words));
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/proofs");
    for name in ["example-8", "example-9", "identities", "multiplicities"] {
        let text = fs::read_to_string(folder.join(format!("{name}.json"))).unwrap();
        let made = wrong_proofs(&text, 40, &mut words);
        assert!(made.len() > 10, "{name}");
        refused_by_the_verifier(&made);
    }
}

/// Prints the names of the files of a folder that the checker accepts.
const ACCEPTED: &str = "
import contextlib, io, os, sys
sys.path.insert(0, sys.argv[1])
import checker
for name in sorted(os.listdir(sys.argv[2])):
    with contextlib.redirect_stdout(io.StringIO()):
        code = checker.main([os.path.join(sys.argv[2], name)])
    if code == 0: print(name)
    assert code in (0, 1, 2), name
";

#[test]
fn ten_thousand_wrong_proofs_are_refused_by_both_checkers() {
    if std::env::var_os("STELLATE_SYSTEMS").is_none() {
        let skipped = "skipped: Python checks wrong proofs with STELLATE_SYSTEMS=1";
        writeln!(std::io::stderr(), "{skipped}").unwrap();
        return;
    }
    let made = drawn(10_000, 20, &mut SplitMix(10_000));
    refused_by_the_verifier(&made);
    let folder = TempDir::new().unwrap();
    let wrong = folder.path().join("wrong");
    fs::create_dir(&wrong).unwrap();
    fs::write(
        folder.path().join("checker.py"),
        done(&["verify", "--checker"]),
    )
    .unwrap();
    for (number, text) in made.iter().enumerate() {
        fs::write(wrong.join(format!("{number}.json")), text).unwrap();
    }
    let run = Command::new("python3")
        .args(["-c", ACCEPTED])
        .args([folder.path(), &wrong])
        .output()
        .unwrap();
    let (out, err) = [run.stdout, run.stderr]
        .map(|bytes| String::from_utf8(bytes).unwrap())
        .into();
    assert!(run.status.success(), "{err}");
    assert_eq!(out, "");
}
