//! Proof files that are made to cost much: both checkers end soon, with one line that says why.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::common::program::{done, run_in};

fn proof(forms: &Value, claims: &Value) -> String {
    json!({ "schema": "stellate/1", "kind": "proof", "forms": forms, "claims": claims }).to_string()
}

fn plane(terms: &[([u64; 2], &str)]) -> Value {
    let terms: Vec<Value> = terms
        .iter()
        .map(|(e, c)| json!({ "exponents": e, "coefficient": c }))
        .collect();
    json!({ "kind": "implicit", "variables": ["x", "y"], "terms": terms })
}

fn claim(name: &str, statement: &Value, witness: &Value) -> Value {
    json!([{ "claim": name, "statement": statement, "witness": witness }])
}

/// Texts with the exit code that both checkers give, and a part of what the verifier says.
fn hostile() -> Vec<(String, i32, &'static str)> {
    let nines = "9".repeat(20_000);
    let ray = |breakpoint: &str| {
        let statement =
            json!({ "form": 0, "direction": ["3/5", "4/5"], "order_at_zero": 0, "roots": [] });
        claim(
            "root-count",
            &statement,
            &json!({ "breakpoints": [breakpoint] }),
        )
    };
    let high = plane(&[([60, 0], &nines), ([0, 60], "-7"), ([0, 0], "1")]);
    let number = format!(
        r#"{{"schema":"stellate/1","kind":"proof","forms":[],"claims":[{}]}}"#,
        "9".repeat(3_000_000)
    );
    let sphere = claim(
        "distance",
        &json!({ "form": 0, "point": ["1/3", "0"], "relation": "more-than", "bound": "1" }),
        &json!({ "depth": 200 }),
    );
    let curve = json!({
        "kind": "parametric", "parameters": ["rational"],
        "coordinates": (0..2).map(|k| json!({
            "numerator": (0..=500).map(|i| json!({ "exponents": [i], "coefficient": nines[..300 + k] })).collect::<Vec<_>>(),
            "denominator": [{ "exponents": [512], "coefficient": "1" }, { "exponents": [0], "coefficient": "3" }],
        })).collect::<Vec<_>>(),
    });
    let identity = claim(
        "identity",
        &json!({ "equations": [0], "curve": 1 }),
        &json!({ "method": "expansion" }),
    );
    let (circle, none) = (
        plane(&[([2, 0], "1"), ([0, 2], "1"), ([0, 0], "-1")]),
        json!([]),
    );
    vec![
        (
            proof(&json!([plane(&[([1_000_000_000, 0], "1")])]), &none),
            2,
            "no proof",
        ),
        (
            proof(&json!([plane(&[([513, 0], "1")])]), &none),
            2,
            "no proof",
        ),
        (
            proof(&json!([plane(&[([1, 0], &"1".repeat(3_000_000))])]), &none),
            2,
            "no proof",
        ),
        (
            format!("{}{}", "[".repeat(300_000), "]".repeat(300_000)),
            2,
            "no proof",
        ),
        (
            format!("{}1{}", r#"{"a":"#.repeat(300_000), "}".repeat(300_000)),
            2,
            "no proof",
        ),
        (number, 2, "no proof"),
        (
            format!(r#"{{"schema":[{}1]}}"#, "1,".repeat(2_000_000)),
            2,
            "no proof",
        ),
        (
            proof(&json!([high]), &ray(&format!("1/{}", &nines[..1990]))),
            1,
            "refused: claim 0 (root-count)",
        ),
        (
            proof(&json!([high]), &ray(&format!("1/{}", &nines[..1999]))),
            1,
            "2000 characters",
        ),
        (
            proof(&json!([circle]), &sphere),
            1,
            "refused: claim 0 (distance)",
        ),
        (
            proof(&json!([high, curve]), &identity),
            1,
            "longer than the limit",
        ),
    ]
}

#[test]
fn hostile_proofs_are_refused_in_one_line() {
    let folder = TempDir::new().unwrap();
    for (number, (text, code, part)) in hostile().into_iter().enumerate() {
        fs::write(folder.path().join("proof.json"), &text).unwrap();
        let run = run_in(folder.path(), &["verify", "proof.json"], "");
        assert_eq!(run.code, code, "{number}: {} {}", run.out, run.err);
        let said = if code == 2 { &run.err } else { &run.out };
        assert!(said.contains(part), "{number}: {said}");
        assert!(
            said.lines().all(|line| line.len() < 400),
            "{number}: {said}"
        );
        assert!(code == 1 || said.lines().count() == 1, "{number}: {said}");
    }
}

#[test]
fn python_refuses_hostile_proofs_too() {
    if std::env::var_os("STELLATE_SYSTEMS").is_none() {
        return;
    }
    let folder = TempDir::new().unwrap();
    let program = folder.path().join("checker.py");
    fs::write(&program, done(&["verify", "--checker"])).unwrap();
    for (number, (text, code, _)) in hostile().into_iter().enumerate() {
        let file: &Path = &folder.path().join("proof.json");
        fs::write(file, &text).unwrap();
        let run = Command::new("python3")
            .arg(&program)
            .arg(file)
            .output()
            .unwrap();
        let said = String::from_utf8(run.stdout).unwrap();
        assert_eq!(run.status.code(), Some(code), "{number}: {said}");
        assert!(
            run.stderr.is_empty() && said.lines().all(|line| line.len() < 400),
            "{number}"
        );
    }
}
