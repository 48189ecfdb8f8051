//! `check` and `vectors` end to end: what they print, their exit codes, their files.

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

mod common;
use common::oracle_theorem_2::theorem_2;
use common::program::{Run, done, json, outline, rational, rationals, run_in, strings};

const LOPSIDED: &str =
    "r = 1 + 1/4*cos(t) + 1/8*sin(t) + 1/16*cos(2*t) - 3/32*sin(2*t) + 1/32*cos(3*t)";

/// Runs with a file `data.csv` of this text.
fn with_data(text: &str, arguments: &[&str]) -> Run {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("data.csv"), text).unwrap();
    run_in(folder.path(), arguments, "")
}

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

#[test]
fn the_polynomial_itself_passes_in_every_normalisation() {
    for (scale, factor) in [("integer", "1024"), ("monic", "1")] {
        let document = done(&[
            "implicitize",
            LOPSIDED,
            "--scale",
            scale,
            "--format",
            "json",
        ]);
        let run = run_in(
            Path::new("."),
            &[
                "check",
                LOPSIDED,
                "--coefficients",
                "-",
                "--format",
                "json",
                "--digits",
                "16",
            ],
            &document,
        );
        let found = json(&run.out);
        assert_eq!(found["scale"], factor);
        assert_eq!(found["worst"]["digits"], json("17.0"), "{}", run.out);
        assert_eq!(run.code, 0);
    }
}

#[test]
fn a_common_factor_is_found_and_said() {
    let reference = "3x^2 + 7y^2 - x*y = 11";
    for (text, factor, said) in [
        (
            "i,j,value\n2,0,3\n0,2,7\n1,1,-1\n0,0,-11\n",
            "1",
            "none is needed",
        ),
        (
            "i,j,value\n2,0,-3\n0,2,-7\n1,1,1\n0,0,11\n",
            "-1",
            "the sign alone",
        ),
        (
            "2,0,0x1.8p+3\n0,2,28\n1,1,-4\n0,0,-44\n",
            "4",
            "a power of two, 2^2",
        ),
        (
            "2,0,1\n0,2,2.3333333333333335\n1,1,-0.3333333333333333\n0,0,-3.6666666666666665\n",
            "1/3",
            "a simple fraction",
        ),
        // One of four is wrong: the factor is that of the others.
        ("2,0,3\n0,2,7.1\n1,1,-1\n0,0,-11\n", "1", "none is needed"),
    ] {
        let run = with_data(
            text,
            &[
                "check",
                reference,
                "--coefficients",
                "data.csv",
                "--format",
                "json",
            ],
        );
        let found = json(&run.out);
        assert_eq!(found["scale"], factor, "{text}");
        assert_eq!(found["scale_meaning"], said);
    }
    // Beside integers of 60 digits, with first coefficient 1.
    let big = "1000000000000000000000000000000000000000000000000000000000003x^2 + 2000000000000000000000000000000000000000000000000000000000009y^2 = 7000000000000000000000000000000000000000000000000000000000000";
    let run = with_data(
        "2,0,1\n0,2,2\n0,0,-7\n",
        &["check", big, "--coefficients", "data.csv", "--digits", "15"],
    );
    assert_eq!(run.code, 0, "{}", run.out);
    assert!(
        run.out.contains("it makes the first coefficient 1"),
        "{}",
        run.out
    );
}

#[test]
fn missing_terms_extra_terms_and_mistakes_answer_no() {
    let check = ["check", "x^2 + y^2 = 9", "--coefficients", "data.csv"];
    let run = with_data("2,0,1\n0,0,-9\n1,1,0.5\n", &check);
    assert_eq!(run.code, 1);
    assert!(
        run.out.contains("2 compared, 1 missing, 1 extra"),
        "{}",
        run.out
    );
    assert!(run.out.contains("missing: y^2: exact 1\n"), "{}", run.out);
    assert!(run.out.contains("extra: xy: got 0.5"), "{}", run.out);
    // a0 halved: one wrong coefficient of three.
    let run = with_data("2,0,1\n0,2,1\n0,0,-2.25\n", &check);
    assert_eq!(run.code, 1);
    assert!(run.out.contains("looks like: a0 halved: "), "{}", run.out);
    assert!(run.out.ends_with("fails: see above\n"));
    // A wrong number alone is reported, and only a mark makes it a fault.
    let wrong = "2,0,1\n0,2,1\n0,0,-9.01\n";
    assert_eq!(with_data(wrong, &check).code, 0);
    assert_eq!(
        with_data(wrong, &[&check[..], &["--digits", "2"]].concat()).code,
        0
    );
    assert_eq!(
        with_data(wrong, &[&check[..], &["--digits", "3"]].concat()).code,
        1
    );
}

#[test]
fn points_and_radii_are_tables_for_other_programs() {
    let run = with_data(
        "# from a float program\nx,y\n\n1.125,0\n0.6,0.8\n",
        &[
            "check",
            "x^2 + y^2 = 1",
            "--points",
            "data.csv",
            "--format",
            "csv",
        ],
    );
    // f(0.6, 0.8) of the doubles is 4.44e-17, by fractions in Python; the radius is exactly 1.
    assert_eq!(
        run.out,
        "line,x,y,r,exact_r,digits,ulps,residual,first_order\n\
         4,1.125,0.0,1.125,1,0.90,5.63e14,0.265625,0.11805555555555555\n\
         5,0.6,0.8,1.0,1,16.65,0.1,4.4408920985006264e-17,2.2204460492503132e-17\n"
    );
    let run = with_data(
        "theta,r\n1,0x1.8a513193f3f96p+0\n",
        &[
            "check",
            "r = 1 + cos(t)",
            "--radii",
            "data.csv",
            "--format",
            "json",
            "--digits",
            "15",
        ],
    );
    let found = json(&run.out);
    assert_eq!(run.code, i32::from(found["passes"] == false));
    assert_eq!(found["what"], "radii");
    assert_eq!(found["worst"]["where"], "line 2: theta = 1.0");
    assert_eq!(found["worst"]["exact"], "1.5403023058681397174");
    assert_eq!(found["scale"], Value::Null);
    // In space.
    let run = with_data(
        "x,y,z\n1,2,2\n0,0,-3.0000001\n",
        &[
            "check",
            "x^2 + y^2 + z^2 = 9",
            "--points",
            "data.csv",
            "--digits",
            "7",
        ],
    );
    assert_eq!(run.code, 0, "{}", run.out);
    assert!(
        run.out.contains("line 3: (0.0, 0.0, -3.0000001)"),
        "{}",
        run.out
    );
}

#[test]
fn references_of_every_kind() {
    let circle = "2,0,1\n0,2,1\n0,0,-1\n";
    let document = done(&["implicitize", "x^2 + y^2 = 1", "--format", "json"]);
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("f.json"), document).unwrap();
    fs::write(folder.path().join("data.csv"), circle).unwrap();
    for reference in [
        "r = 1",
        "x^2 + y^2 = 1",
        "x = cos(t); y = sin(t)",
        "x = (1-t^2)/(1+t^2); y = 2t/(1+t^2)",
        "superquadric 2d a=1,1 e=1",
        "f.json",
    ] {
        let arguments = [
            "check",
            reference,
            "--coefficients",
            "data.csv",
            "--digits",
            "16",
        ];
        let run = run_in(folder.path(), &arguments, "");
        assert_eq!(run.code, 0, "{reference}: {}{}", run.out, run.err);
    }
    let torus = "x = (2 + cos(v))*cos(u); y = (2 + cos(v))*sin(u); z = sin(v)";
    let point = with_data(
        "3,0,0\n0,2,1\n",
        &["check", torus, "--points", "data.csv", "--digits", "17"],
    );
    assert_eq!(point.code, 0, "{}", point.out);
}

#[test]
fn coefficients_of_a_surface_and_of_a_curve_about_a_centre() {
    let surface = "i,j,k,value\n2,0,0,0.5\n0,2,0,1\n0,0,1,-0.15\n";
    let check = [
        "check",
        "x^2 + 2y^2 = 0.3z",
        "--coefficients",
        "data.csv",
        "--digits",
        "15",
        "--format",
        "csv",
    ];
    let run = with_data(surface, &check);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(
        run.out
            .starts_with("i,j,k,got,exact,digits,ulps\n2,0,0,0.5,0.5,17.00,0\n"),
        "{}",
        run.out
    );
    // About the fit's centre, said or unsaid; not about another one.
    let butterfly = outline("butterfly");
    let document = done(&[
        "implicitize",
        &butterfly,
        "--harmonics",
        "2",
        "--format",
        "json",
        "--quiet",
        "--decimals",
        "1",
    ]);
    let check = [
        "check",
        &butterfly,
        "--harmonics",
        "2",
        "--decimals",
        "1",
        "--coefficients",
        "-",
        "--digits",
        "15",
        "--quiet",
    ];
    let center = json(&document)["center"].clone();
    assert_eq!(run_in(Path::new("."), &check, &document).code, 0);
    let elsewhere = document.replace(&center.to_string(), "[\"1\",\"2\"]");
    assert_ne!(elsewhere, document);
    let run = run_in(Path::new("."), &check, &elsewhere);
    assert_eq!(run.code, 2);
    assert!(
        run.err
            .contains("the coefficients are relative to (1, 2), the reference to"),
        "{}",
        run.err
    );
}

#[test]
fn the_algorithm_in_doubles_is_a_table_and_a_picture() {
    let folder = TempDir::new().unwrap();
    let butterfly = outline("butterfly");
    let arguments = [
        "check",
        &butterfly,
        "--harmonics",
        "39",
        "--self",
        "--plot",
        "self.svg",
        "--format",
        "json",
        "--quiet",
    ];
    let run = run_in(folder.path(), &arguments, "");
    assert_eq!(run.code, 0, "{}", run.err);
    let found = json(&run.out);
    let rungs = found["rungs"].as_array().unwrap();
    let last = rungs.last().unwrap();
    assert_eq!(
        (&last["harmonics"], &last["degree"]),
        (&json("39"), &json("80"))
    );
    // What is left near the curve of the degree-80 butterfly from its expanded monomials.
    let near = last["digits_near_the_curve"]["median"].as_f64().unwrap();
    assert!((9.0..13.0).contains(&near), "{near}");
    let first = rungs[0]["digits_near_the_curve"]["median"]
        .as_f64()
        .unwrap();
    assert!(first > 13.5, "{first}");
    let svg = fs::read_to_string(folder.path().join("self.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("correct digits"));
}

#[test]
fn a_plot_shows_every_number() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("data.csv"), "theta,r\n0,1\n1,1.1\n2,1\n").unwrap();
    for figure in ["digits.svg", "digits.png"] {
        let arguments = [
            "check",
            "r = 1",
            "--radii",
            "data.csv",
            "--plot",
            figure,
            "-o",
            "report.txt",
        ];
        let run = run_in(folder.path(), &arguments, "");
        assert_eq!((run.code, run.out.as_str()), (0, ""), "{}", run.err);
        assert!(fs::metadata(folder.path().join(figure)).unwrap().len() > 1000);
        assert!(
            fs::read_to_string(folder.path().join("report.txt"))
                .unwrap()
                .starts_with("radii: 3 compared\n")
        );
    }
}

#[test]
fn vectors_are_one_document() {
    let run = run_in(
        Path::new("."),
        &["vectors", "r = 1 + 0.2*cos(3*t)", "--directions", "4"],
        "",
    );
    assert_eq!(run.code, 0);
    assert!(
        run.err.contains("1 of 7 inputs were no doubles"),
        "{}",
        run.err
    );
    let v = json(&run.out);
    assert_eq!(
        (&v["schema"], &v["kind"]),
        (&json("\"stellate/1\""), &json("\"vectors\""))
    );
    let named = |name: &str| {
        let inputs = v["inputs"].as_array().unwrap();
        inputs.iter().find(|i| i["name"] == name).unwrap().clone()
    };
    assert_eq!(named("a3")["hex"], "0x1.999999999999ap-3");
    let first = &v["coefficients"][0];
    assert_eq!(first["exponents"], json("[8,0]"));
    assert_eq!(
        (&first["exact"], &first["condition"]),
        (&json("\"1\""), &json("0.0"))
    );
    // r(0) = 1.2 and r(pi/2) = 1, both to the last bit; the condition is 1 where all terms have one sign.
    assert_eq!(
        v["radii"][0]["r"]["double"].as_f64().unwrap().to_bits(),
        1.2f64.to_bits()
    );
    assert_eq!(v["radii"][0]["condition"], json("1.0"));
    assert_eq!(v["radii"].as_array().unwrap().len(), 4);
    // Two points in each direction.
    assert_eq!(v["points"].as_array().unwrap().len(), 8);
    assert_eq!(strings(&v["points"][0]["direction"]), ["1", "0"]);
    // A polynomial's inputs are its coefficients; a parametric form has none.
    let v = json(&done(&[
        "vectors",
        "x^2 + 3y^2 + z^2 = 4",
        "--directions",
        "3",
    ]));
    assert_eq!(v["inputs"][1]["name"], "y^2");
    assert_eq!(v["points"][0]["position"].as_array().unwrap().len(), 3);
    let v = json(&done(&[
        "vectors",
        "x = cos(t); y = sin(2*t)",
        "--directions",
        "3",
    ]));
    assert_eq!(v["inputs"], json("[]"));
    assert_eq!(v["coefficients"][0]["condition"], Value::Null);
}

/// What is refused, with code 2, one diagnosis, and nothing written.
#[test]
fn wrong_input_is_said_in_its_place() {
    let coefficients = [
        "check",
        "x^2 + y^2 = 1",
        "--coefficients",
        "data.csv",
        "-o",
        "out.txt",
    ];
    let points = [
        "check",
        "x^2 + y^2 = 1",
        "--points",
        "data.csv",
        "-o",
        "out.txt",
    ];
    let radii = [
        "check",
        "x^2 + y^2 = 1",
        "--radii",
        "data.csv",
        "-o",
        "out.txt",
    ];
    let cases: [(&[&str], &str, &str); 15] = [
        (
            &coefficients,
            "2,0,1\n# note\n0,2,nan\n",
            "data.csv, line 3: expected a number",
        ),
        (
            &coefficients,
            "2,0,1\n0,2\n",
            "data.csv, line 2: expected 3 columns, found 2",
        ),
        (
            &coefficients,
            "2,0,1\n2,0,1\n",
            "data.csv, line 2: this term was given before",
        ),
        (
            &coefficients,
            "2,0,0,1\n0,0,2,1\n",
            "the coefficients of a surface in x, y, z, the reference is a curve in x, y",
        ),
        (&coefficients, "0,0,1\n", "data.csv: "),
        (
            &coefficients,
            "2,0,1e999\n",
            "data.csv, line 1: too large for a double",
        ),
        (
            &coefficients,
            "{\"schema\":\"stellate/1\",\"kind\":\"fourier\",\"cos\":[\"1\"],\"sin\":[\"0\"]}",
            "expected the coefficients of a polynomial",
        ),
        (&coefficients, "", "data.csv: there are no rows"),
        (
            &points,
            "x,y,z\n1,2,3\n",
            "data.csv: expected the columns x,y",
        ),
        (
            &points,
            "x,y\n\n1,two\n",
            "data.csv, line 3: expected a number",
        ),
        (
            &points,
            "a,b\n1,2\n",
            "data.csv, line 1: expected the columns x,y",
        ),
        (
            &radii,
            "theta,r\n1,inf\n",
            "data.csv, line 2: expected a number",
        ),
        (&radii, "1,2,3\n", "data.csv: expected the columns theta,r"),
        (
            &["check", "x^2 + y^2 + z^2 = 1", "--radii", "data.csv"],
            "1,1\n",
            "this is a surface, whose radius has two angles",
        ),
        (
            &["check", "x = t; y = t^2; z = t^3", "--points", "data.csv"],
            "1,1,1\n",
            "this is a curve in space",
        ),
    ];
    for (arguments, data, expected) in cases {
        let run = with_data(data, arguments);
        assert_eq!(run.code, 2, "{arguments:?} {data}: {}{}", run.out, run.err);
        assert!(
            run.err.contains(expected),
            "{arguments:?} {data}: {}",
            run.err
        );
        assert_eq!(run.out, "");
        assert_eq!(
            run.err
                .lines()
                .filter(|l| l.starts_with("stellate: "))
                .count(),
            1,
            "{}",
            run.err
        );
    }
    for (arguments, expected) in [
        (&["check", "x^2 + y^2 = 1"][..], "--coefficients"),
        (
            &["check", "x^2 + y^2 = 1", "--points", "a", "--radii", "b"],
            "cannot be used with",
        ),
        (
            &["check", "x^2 + y^2 = 1", "--self"],
            "takes a Fourier radius",
        ),
        (
            &["check", "r = 1", "--points", "missing.csv"],
            "missing.csv",
        ),
        (
            &[
                "check", "r = 1", "--points", "data.csv", "--format", "latex",
            ],
            "written as text, json or csv",
        ),
        (
            &["check", "r = 1", "--points", "data.csv", "--plot", "a.txt"],
            "a figure is a .svg or a .png",
        ),
        (
            &[
                "check", "r = 1", "--points", "data.csv", "--plot", "no/a.svg",
            ],
            "there is no folder no",
        ),
        (
            &["check", "r = 1", "--harmonics", "3", "--points", "data.csv"],
            "--harmonics is for contours",
        ),
        (&["vectors", "r = 1", "--format", "csv"], "written as json"),
        (&["vectors", "r = 1", "--directions", "0"], "at least one"),
        (
            &["vectors", "x^2 + 1e400y^2 = 1"],
            "beyond the largest double",
        ),
    ] {
        let run = with_data("1,0\n", arguments);
        assert_eq!(run.code, 2, "{arguments:?}: {}", run.err);
        assert!(run.err.contains(expected), "{arguments:?}: {}", run.err);
        assert_eq!(run.out, "");
    }
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
    let readme = fs::read_to_string(root.join("README.md")).unwrap();
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
