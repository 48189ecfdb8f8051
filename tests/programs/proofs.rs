//! Proof files, from end to end.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;
use stellate::proof::check;
use tempfile::TempDir;

use crate::common::program::{done, run_in};
use crate::common::schemas;

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

/// Commands that write proofs, with the numbers of their claims and of those without a witness.
const PROVED: [(&[&str], usize, usize); 25] = [
    // Forms that proof files cannot state, and arcs: nothing is left out.
    (
        &[
            "sample",
            "superquadric 3d a=1,1,2 e=0.7,0.3",
            "--directions",
            "5",
        ],
        5,
        5,
    ),
    (
        &["sample", "superquadric 2d a=1,2 e=0.3", "--theta", "1"],
        1,
        1,
    ),
    (&["sample", "x^2+y^2+z^2=1; z=1/2"], 1, 1),
    (&["describe", "(x^2 + y^2 - 1)*(x^3 - y^2)*(x - y)^2"], 4, 0),
    (&["describe", "r = 1 + 1/5*cos(3*t)"], 3, 0),
    (&["describe", "r = 1 + 6/5*cos(3*t) - 1/7*sin(t)"], 3, 0),
    (&["describe", "R = 10 + Y(2,0)/3 - 0.1*Y(3,-2)"], 3, 0),
    // Double lines, exact roots beside others, and a direction in the curve.
    (
        &[
            "sample",
            "(x^2 + y^2 - 1)*(x^3 - y^2)*(x - y)^2",
            "--directions",
            "24",
        ],
        24,
        0,
    ),
    (
        &[
            "sample",
            "(x^2 + y^2 - 4)^2*(x - 1)*(x^2 - 3*y^2)",
            "--theta",
            "0",
            "--theta",
            "30deg",
        ],
        2,
        0,
    ),
    (
        &["sample", "x^4 + y^4 + z^4 - 1", "--directions", "40"],
        40,
        0,
    ),
    (&["implicitize", "r = 3 + cos(t) - 1/7*sin(4*t)"], 2, 0),
    (&["implicitize", "x = sin(t); y = sin(t)*cos(t)"], 4, 2),
    (
        &[
            "implicitize",
            "x = cos(theta)*sin(phi); y = cos(theta); z = cos(phi)",
        ],
        4,
        2,
    ),
    (
        &[
            "inspect",
            "x^2/4 + y^2 = 1",
            "--tolerance",
            "1/10",
            "--point",
            "2,0",
            "--point",
            "1/3,1/4",
            "--point",
            "5,5",
        ],
        14,
        0,
    ),
    (
        &[
            "inspect",
            "r = 1 + 1/5*cos(3*t)",
            "--tolerance",
            "1/10",
            "--point",
            "0,0",
            "--point",
            "1.1,0",
            "--point",
            "-1,1",
        ],
        15,
        0,
    ),
    // Squares of Theorem 2: circles.
    (&["implicitize", "r = cos(t)"], 2, 0),
    (&["describe", "x^4 - x^2 + y^2", "--topology"], 4, 2),
    // The true ranges, which no scan finds; the formulas and the very ends have no witness.
    (&["parametrize", "x^3 + y^3 = 3*x*y"], 6, 2),
    (&["parametrize", "(x^2 + y^2 - 1)*(x^3 - y^2)"], 11, 2),
    // A radius of one sign is real everywhere, and so is its branch r < 0.
    (
        &[
            "parametrize",
            "x^4 + 2x^2y^2 + y^4 - 2x^3 - 2xy^2 - 3x^2 - 4y^2",
        ],
        6,
        0,
    ),
    // A branch without a formula: the sectors count the roots, and what happens within the cuts has no witness.
    (
        &["parametrize", "x^6 + y^6 + x^3*y + x^2 + 3*y = 7*x"],
        4,
        1,
    ),
    (&["parametrize", "R = 2 + Y(1,0)/3"], 3, 0),
    // The factors and their irreducibility; the formulas have no witness.
    (
        &["parametrize", "(x^2 + y^2 + z^2 - 1)*(x + 2*y + z - 1)^2"],
        6,
        3,
    ),
    (&["parametrize", "x^2 + y^2 = 1; z = y^5"], 2, 1),
    (
        &[
            "inspect",
            "R = 2 + Y(2,1)/5",
            "--tolerance",
            "1/10",
            "--point",
            "1,1,1",
        ],
        5,
        4,
    ),
];

#[test]
fn the_verbs_write_proofs_that_are_accepted() {
    let folder = TempDir::new().unwrap();
    for (k, (arguments, claims, without)) in PROVED.iter().enumerate() {
        let name = format!("{k}.json");
        let mut all = arguments.to_vec();
        all.extend(["--proof", &name, "-o", "out", "--format", "json"]);
        let run = run_in(folder.path(), &all, "");
        assert!(run.code <= 1, "{arguments:?}: {}", run.err);
        let said = format!("proof: {claims} claims, {without} of them without a witness");
        assert!(run.err.contains(&said), "{arguments:?}: {}", run.err);
        let run = run_in(folder.path(), &["verify", &name], "");
        assert_eq!(run.code, 0, "{arguments:?}: {}", run.out);
        // Another number of roots, another sign or another polynomial is refused.
        let text = fs::read_to_string(folder.path().join(&name)).unwrap();
        schemas::check(&serde_json::from_str(&text).unwrap());
        let (from, to) = match arguments[0] {
            "describe" => ("\"coefficient\":\"1\"", "\"coefficient\":\"2\""),
            "sample" => ("\"order_at_zero\":", "\"order_at_zero\":1"),
            "implicitize" => ("\"coefficient\":\"1\"", "\"coefficient\":\"2\""),
            _ => ("\"sign\":1", "\"sign\":-1"),
        };
        let changed = text.replacen(from, to, 1);
        if changed != text {
            fs::write(folder.path().join("wrong.json"), changed).unwrap();
            let run = run_in(folder.path(), &["verify", "wrong.json"], "");
            assert_eq!(run.code, 1, "{arguments:?}: {}", run.out);
        }
    }
    let missing = run_in(
        folder.path(),
        &["describe", "x^2 = y", "--proof", "no/p.json"],
        "",
    );
    assert_eq!(missing.code, 2, "{}", missing.err);
}

/// For the curve of a count that was wrong once: no number of roots but the true one, 2, has an accepted witness.
#[test]
fn a_wrong_count_has_no_accepted_witness() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/proofs/wrong-count.json");
    let proof: Value = serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap();
    let breakpoints: [&[&str]; 6] = [
        &[],
        &["0"],
        &["-1", "0", "1"],
        &["-100000", "-1", "0", "1", "100000"],
        &["-1/2", "1/2"],
        &["-48858", "-48857", "0", "1/1000000000", "48857", "48858"],
    ];
    let mut accepted = 0;
    for claim in proof["claims"].as_array().unwrap() {
        for (number, breakpoints) in (0..=9).flat_map(|n| breakpoints.map(|b| (n, b))) {
            for order in 0..=2 {
                let mut claim = claim.clone();
                let root = serde_json::json!({ "multiplicity": 1 });
                claim["statement"]["roots"] = vec![root; number].into();
                claim["statement"]["order_at_zero"] = order.into();
                claim["witness"]["breakpoints"] = breakpoints.into();
                let mut wrong = proof.clone();
                wrong["claims"] = vec![claim].into();
                let holds = check(&wrong.to_string(), false).unwrap().holds();
                assert!(!holds || (number, order) == (2, 1), "{wrong}");
                accepted += usize::from(holds);
            }
        }
    }
    // The true count has the witness 0 in both directions.
    assert!(accepted >= 2);
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
    for (arguments, ..) in PROVED {
        let mut all = arguments.to_vec();
        all.extend(["--proof", "made.json", "-o", "out", "--format", "json"]);
        run_in(folder.path(), &all, "");
        assert_eq!(code(&folder.path().join("made.json")), 0, "{arguments:?}");
    }
}
