//! Theorem 2 in NumPy: how many digits it loses, checked by hand at N = 3; and the scripts themselves.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::Path;

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};
use serde_json::Value;
use stellate::exact::Rational;
use stellate::shape::FourierRadius;
use tempfile::TempDir;

use crate::common::oracle_theorem_2::theorem_2;
use crate::common::program::{Run, done, json, outline, rational, rationals, run_in, with_data};

fn numpy_rows(harmonics: usize) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let file = root.join(format!("tests/numpy/butterfly-{harmonics}.csv"));
    fs::read_to_string(file).unwrap()
}

/// `tests/numpy/theorem2.py` on the fit of the butterfly, as NumPy 2 computed it.
fn check_numpy(harmonics: usize, more: &[&str]) -> Run {
    let (butterfly, n) = (outline("butterfly"), harmonics.to_string());
    let arguments = [
        &[
            "check",
            &butterfly,
            "--harmonics",
            &n,
            "--coefficients",
            "data.csv",
            "--quiet",
        ],
        more,
    ]
    .concat();
    with_data(&numpy_rows(harmonics), &arguments)
}

#[test]
fn a_correct_numpy_program_is_believed() {
    // (N, the most digits that may be lost at worst, and the fewest that are)
    for (n, most, fewest) in [
        (3, 1.3, 0.5),
        (10, 2.3, 1.5),
        (20, 3.0, 1.8),
        (39, 5.0, 3.5),
    ] {
        let run = check_numpy(n, &["--format", "json"]);
        assert_eq!(run.code, 0, "{}", run.out);
        let found = json(&run.out);
        assert_eq!(found["kind"], "check");
        assert_eq!(found["scale"], "1");
        assert_eq!(found["missing"], json("[]"));
        assert_eq!(found["extra"], json("[]"));
        assert_eq!(found["mistakes"], json("[]"));
        assert_eq!(
            found["compared"],
            serde_json::json!(numpy_rows(n).lines().count())
        );
        let lost = found["digits_lost"].as_f64().unwrap();
        assert!((fewest..=most).contains(&lost), "N = {n}: {lost}");
        assert!(found["median_digits"].as_f64().unwrap() > 15.0);
    }
}

/// The check by hand, at N = 3: the printed formula over num-rational, and every relative error from it.
#[test]
fn at_3_harmonics_the_report_is_that_of_an_independent_computation() {
    let fit = json(&done(&[
        "fit",
        &outline("butterfly"),
        "--harmonics",
        "3",
        "--format",
        "json",
        "--quiet",
    ]));
    let exact = |name: &str| {
        rationals(&fit[name])
            .into_iter()
            .map(Rational::from)
            .collect()
    };
    let terms = theorem_2(&FourierRadius::new(exact("cos"), exact("sin")));
    let rows = numpy_rows(3);
    let got: BTreeMap<(usize, usize), BigRational> = rows
        .lines()
        .map(|row| {
            let fields: Vec<&str> = row.split(',').collect();
            let value: f64 = fields[2].parse().unwrap();
            let value = BigRational::from_float(value).unwrap();
            (
                (fields[0].parse().unwrap(), fields[1].parse().unwrap()),
                value,
            )
        })
        .collect();
    assert_eq!(got.len(), terms.len());
    let mut digits: Vec<(f64, (usize, usize))> = terms
        .iter()
        .map(|(e, exact)| {
            let off = (&got[e] - exact).abs() / exact.abs();
            let digits = if off.is_zero() {
                17.0
            } else {
                -off.to_f64().unwrap().log10()
            };
            (digits.min(17.0), *e)
        })
        .collect();
    digits.sort_by(|a, b| a.0.total_cmp(&b.0));
    let found = json(&check_numpy(3, &["--format", "json"]).out);
    assert_eq!(digits[0].1, (5, 1));
    assert_eq!(found["worst"]["where"], "x^5y");
    let close = |value: &Value, expected: f64| (value.as_f64().unwrap() - expected).abs() < 1e-9;
    assert!(close(&found["worst"]["digits"], digits[0].0));
    assert!(close(
        &found["median_digits"],
        digits[(digits.len() - 1) / 2].0
    ));
    let e = digits[0].1;
    let exact = &terms.iter().find(|(f, _)| *f == e).unwrap().1;
    assert_eq!(&rational(found["worst"]["exact"].as_str().unwrap()), exact);
    // 6.58 units of 2⁻⁴⁸: 19.58 lies between 16 and 32.
    let unit = BigRational::from_float(2f64.powi(-48)).unwrap();
    let ulps = ((&got[&e] - exact).abs() / unit).to_f64().unwrap();
    assert!(close(&found["worst"]["ulps"], ulps));
}

#[test]
fn digits_set_the_mark_and_the_exit_code() {
    let run = check_numpy(39, &["--digits", "11"]);
    assert_eq!(run.code, 0, "{}", run.out);
    assert!(
        run.out.ends_with("passes: everything has 11 digits\n"),
        "{}",
        run.out
    );
    let run = check_numpy(39, &["--digits", "12"]);
    assert_eq!(run.code, 1);
    assert!(
        run.out
            .contains("fails: 1 below 12 digits:\n  x^46y^33: digits ≈ 11.7\n"),
        "{}",
        run.out
    );
    let found = json(&check_numpy(39, &["--digits", "13", "--format", "json"]).out);
    assert_eq!(
        (&found["mark"], &found["passes"]),
        (&json("13"), &json("false"))
    );
    let failures = found["failures"].as_array().unwrap();
    assert_eq!(found["below"], serde_json::json!(failures.len()));
    assert!(
        failures
            .iter()
            .all(|f| f["digits"].as_f64().unwrap() < 13.0)
    );
    let counts: Vec<usize> = serde_json::from_value(found["histogram"].clone()).unwrap();
    assert_eq!(counts.iter().sum::<usize>(), 200);
    assert_eq!(counts[..13].iter().sum::<usize>(), failures.len());
}

/// The script of the README, and the NumPy program behind the stored rows; only where the variable names a Python with
/// NumPy.
#[test]
fn the_numpy_scripts_do_what_is_said_of_them() {
    let Some(python) = std::env::var_os("STELLATE_PYTHON") else {
        // Past the capture of the test harness: whoever runs the tests is told.
        let skipped =
            "skipped: the NumPy scripts run with STELLATE_PYTHON=python3 (a Python that has NumPy)";
        writeln!(std::io::stderr(), "{skipped}").unwrap();
        return;
    };
    let folder = TempDir::new().unwrap();
    let python = |script: &Path, stdin: &str| {
        let output = assert_cmd::Command::new(&python)
            .arg(script)
            .current_dir(folder.path())
            .write_stdin(stdin)
            .output()
            .unwrap();
        let [out, err] = [output.stdout, output.stderr].map(|b| String::from_utf8(b).unwrap());
        assert!(output.status.success(), "{err}");
        out
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let readme = fs::read_to_string(root.join("src/guide/float-programs.md")).unwrap();
    let script = readme
        .split("```python\n")
        .nth(1)
        .unwrap()
        .split("```")
        .next()
        .unwrap();
    fs::write(folder.path().join("script.py"), script).unwrap();
    let vectors = done(&[
        "vectors",
        &outline("butterfly"),
        "--harmonics",
        "10",
        "--quiet",
    ]);
    fs::write(folder.path().join("vectors.json"), vectors).unwrap();
    let said = python(&folder.path().join("script.py"), "");
    assert!(
        said.contains("coefficients: ") && said.contains("radii: "),
        "{said}"
    );

    for n in [3, 39] {
        let count = n.to_string();
        let fit = done(&[
            "fit",
            &outline("butterfly"),
            "--harmonics",
            &count,
            "--format",
            "csv",
            "--quiet",
        ]);
        let rows = python(&root.join("tests/numpy/theorem2.py"), &fit);
        let check = [
            "check",
            &outline("butterfly"),
            "--harmonics",
            &count,
            "--coefficients",
            "-",
            "--digits",
            "11",
        ];
        let run = run_in(Path::new("."), &check, &rows);
        assert_eq!(run.code, 0, "{}", run.out);
    }
}
