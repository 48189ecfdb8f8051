//! Forms from end to end: what the verbs print and write of them.

use std::fs;
use std::path::Path;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};
use serde_json::Value;
use tempfile::TempDir;

use crate::common::program::{EGG, done, done_in, json, piped, rational, run_in, strings};

const EGG_EQUATION: &str =
    "100x^4 + 200x^2y^2 + 100y^4 - 40x^3 - 20x^2y - 40xy^2 - 20y^3 - 96x^2 + 4xy - 99y^2 = 0\n";

#[test]
fn the_egg_of_the_issue_has_its_equation() {
    assert_eq!(done(&["implicitize", EGG]), EGG_EQUATION);
}

#[test]
fn monic_scale_divides_by_the_first_coefficient() {
    assert_eq!(
        done(&["implicitize", EGG, "--scale", "monic"]),
        "x^4 + 2x^2y^2 + y^4 - 2/5x^3 - 1/5x^2y - 2/5xy^2 - 1/5y^3 - 24/25x^2 + 1/25xy - 99/100y^2 = 0\n"
    );
    assert_eq!(
        done(&["implicitize", "-2x + 3/2z = 1", "--scale", "monic"]),
        "x - 3/4z + 1/2 = 0\n"
    );
}

#[test]
fn numbers_are_exact_unless_doubles_are_asked_for() {
    let double = done(&["implicitize", "x + 0.1y", "--numbers", "f64"]);
    assert_eq!(
        double, "36028797018963968x + 3602879701896397y = 0\n",
        "0.1 is 3602879701896397/2^55"
    );
    assert_eq!(done(&["implicitize", "x + 0.1y"]), "10x + y = 0\n");
}

#[test]
fn an_implicit_form_goes_through_every_format_and_comes_back() {
    let expected = done(&["implicitize", EGG, "--format", "json"]);
    let folder = TempDir::new().unwrap();
    for format in ["text", "json", "csv", "sympy", "maple", "singular"] {
        let written = done(&["implicitize", EGG, "--format", format]);
        let from_stdin = piped(&["implicitize", "-", "--format", "json"], &written);
        assert_eq!(from_stdin, expected, "{format} through a pipe");
        let file = if format == "csv" { "f.csv" } else { "f.txt" };
        fs::write(folder.path().join(file), &written).unwrap();
        let from_file = done_in(
            folder.path(),
            &["implicitize", file, "--format", "json"],
            "",
        );
        assert_eq!(from_file, expected, "{format} through a file");
    }
}

#[test]
fn the_formats_are_those_of_the_systems_they_are_named_after() {
    let line = |format| {
        done(&[
            "implicitize",
            "1/3*x^2*y - y",
            "--scale",
            "monic",
            "--format",
            format,
        ])
    };
    assert_eq!(line("text"), "x^2y - 3y = 0\n");
    assert_eq!(line("sympy"), "x**2*y - 3*y\n");
    assert_eq!(line("maple"), "x^2*y - 3*y = 0;\n");
    assert_eq!(line("latex"), "x^{2} y - 3 y = 0\n");
    assert_eq!(
        line("singular"),
        "ring R = 0, (x, y), dp;\npoly F = x^2*y - 3*y;\n"
    );
    assert_eq!(line("csv"), "i,j,coefficient\n2,1,1\n0,1,-3\n");
}

#[test]
fn a_radius_goes_through_every_format_and_comes_back() {
    for format in ["text", "json", "csv", "sympy", "maple"] {
        let written = done(&["parametrize", EGG, "--format", format]);
        assert_eq!(
            piped(&["implicitize", "-"], &written),
            EGG_EQUATION,
            "{format}"
        );
    }
}

#[test]
fn an_implicit_document_has_the_fields_of_the_contract() {
    let document = json(&done(&["implicitize", EGG, "--format", "json"]));
    assert_eq!(document["schema"], "stellate/1");
    assert_eq!(document["kind"], "implicit");
    assert_eq!(document["variables"], json(r#"["x","y"]"#));
    assert_eq!(document["degree"], json("4"));
    assert_eq!(document["homogeneous_degrees"], json("[4,3,2]"));
    let terms = document["terms"].as_array().unwrap();
    assert_eq!(terms.len(), 10);
    assert_eq!(terms[0], json(r#"{"exponents":[4,0],"coefficient":"100"}"#));
    let exponents = |t: &Value| -> (u64, Vec<u64>) {
        let e: Vec<u64> = t["exponents"]
            .as_array()
            .unwrap()
            .iter()
            .map(|e| e.as_u64().unwrap())
            .collect();
        (e.iter().sum(), e)
    };
    let order: Vec<_> = terms.iter().map(exponents).collect();
    assert!(
        order.windows(2).all(|w| w[0] > w[1]),
        "by degree, then exponents, descending"
    );
}

#[test]
fn a_parametric_document_has_the_fields_of_the_contract() {
    let document = json(&done(&[
        "parametrize",
        EGG_EQUATION.trim(),
        "--format",
        "json",
        "--digits",
        "20",
    ]));
    assert_eq!(document["schema"], "stellate/1");
    assert_eq!(document["kind"], "parametric");
    assert_eq!(document["parameters"], json(r#"["theta"]"#));
    assert_eq!(document["method"], "lemma-3");
    assert_eq!(document["step"], json("1"));
    assert_eq!(document["lines"], json("[]"));
    let branches = document["branches"].as_array().unwrap();
    assert_eq!(branches.len(), 2);
    let fourier = json(r#"{"cos":["1","1/5"],"sin":["0","1/10"]}"#);
    let branch = branches.iter().find(|b| b["fourier"] == fourier).unwrap();
    assert_eq!(
        branch["sympy"],
        "1 + Rational(1, 5)*cos(theta) + Rational(1, 10)*sin(theta)"
    );
    assert_eq!(
        branch["coordinates"]["y"],
        "(1 + Rational(1, 5)*cos(theta) + Rational(1, 10)*sin(theta))*sin(theta)"
    );
    assert_eq!(
        branch["ranges"],
        json(
            r#"[{"from":"0.00000000000000000000","to":"6.28318530717958647693","closed":[true,true],"exact_from":"0","exact_to":"2*pi"}]"#
        )
    );
    assert_eq!(branch["positive"], branch["ranges"]);
}

#[test]
fn a_description_has_the_fields_of_the_contract() {
    let document = json(&done(&["describe", EGG, "--format", "json"]));
    for (field, value) in [
        ("schema", "\"stellate/1\""),
        ("kind", "\"description\""),
        ("degree", "4"),
        ("homogeneous_degrees", "[4,3,2]"),
        ("terms", "10"),
        ("coefficient_bits", "8"),
        ("method", "\"lemma-3\""),
        ("origin_multiplicity", "2"),
        ("harmonics", "1"),
        ("star_shaped", "true"),
        ("irreducible", "true"),
    ] {
        assert_eq!(document[field], json(value), "{field}");
    }
    assert!(document["notes"].is_array());
    let of_equation = json(&done(&[
        "describe",
        EGG_EQUATION.trim(),
        "--format",
        "json",
    ]));
    assert_eq!(of_equation, document, "the equation is recognised");
}

#[test]
fn digits_are_certified_to_the_last_one_shown() {
    // r > 0 up to 2π/3.
    let document = done(&[
        "describe",
        "r = 1 + 2*cos(t)",
        "--format",
        "json",
        "--digits",
        "50",
    ]);
    let range = &json(&document)["positive"][0];
    assert_eq!(
        range["to"],
        "2.09439510239319549230842892218633525613144626625007"
    );
    assert_eq!(range["closed"], json("[true,false]"));
}

#[test]
fn a_circle_is_a_radius_without_harmonics() {
    assert_eq!(done(&["implicitize", "r = 3/2"]), "4x^2 + 4y^2 - 9 = 0\n");
    assert!(done(&["parametrize", "4x^2 + 4y^2 = 9"]).contains("\nr = 3/2\n"));
}

#[test]
fn trailing_harmonics_that_are_zero_do_not_count() {
    let document = r#"{"schema":"stellate/1","kind":"fourier","cos":["1","1/5","0","0"],"sin":["0","0.1","0","0"]}"#;
    assert_eq!(piped(&["implicitize", "-"], document), EGG_EQUATION);
    let description = json(&piped(&["describe", "-", "--format", "json"], document));
    assert_eq!(description["harmonics"], json("1"));
}

#[test]
fn a_perfect_square_is_reported_and_reduced() {
    let run = run_in(Path::new("."), &["implicitize", "r = cos(3t)"], "");
    assert_eq!(run.code, 0);
    assert!(
        run.out
            .ends_with("\nx^4 + 2x^2y^2 + y^4 - x^3 + 3xy^2 = 0\n"),
        "{}",
        run.out
    );
    assert!(run.err.contains("perfect square"), "{}", run.err);
    let back = piped(&["parametrize", "-", "--format", "json"], &run.out);
    assert_eq!(
        json(&back)["branches"][0]["fourier"]["cos"],
        json(r#"["0","0","0","1"]"#)
    );
    let description = json(&done(&["describe", "r = cos(3t)", "--format", "json"]));
    assert_eq!(description["perfect_square"], json("true"));
}

#[test]
fn a_radius_that_changes_sign_is_described_and_sampled_with_its_reflected_arc() {
    let description = json(&done(&["describe", "r = 1 + 2*cos(t)", "--format", "json"]));
    assert_eq!(description["star_shaped"], json("false"));
    let notes = strings(&description["notes"]).join("\n");
    assert!(notes.contains("reflected arc"), "{notes}");
    // Towards theta = 0 there are r(0) = 3 and −r(pi) = 1, both in front.
    let rows = done(&["sample", "r = 1 + 2*cos(t)", "--theta", "0", "--positive"]);
    let radii: Vec<&str> = rows
        .lines()
        .skip(1)
        .map(|l| l.split(',').nth(4).unwrap())
        .collect();
    assert_eq!(radii, ["3.0", "1.0"]);
}

#[test]
fn samples_count_distinct_roots_with_their_multiplicities() {
    let rows = done(&["sample", "(x^2+y^2-1)^2*(x-3)", "--theta", "0deg"]);
    assert_eq!(
        rows,
        "branch,theta,u,v,r,x,y,multiplicity\n0,0.0,1,0,3.0,3.0,0.0,1\n1,0.0,1,0,1.0,1.0,0.0,2\n2,0.0,1,0,-1.0,-1.0,0.0,2\n"
    );
    let none = done(&["sample", "x^2 + y^2 + 1", "--directions", "5"]);
    assert_eq!(none.lines().count(), 1, "no real point, no row");
}

#[test]
fn samples_as_json_are_the_samples_as_csv() {
    let arguments = [
        "sample",
        EGG,
        "--directions",
        "7",
        "--theta",
        "-1/3",
        "--format",
    ];
    let csv = done(&[&arguments[..], &["csv"]].concat());
    let document = json(&done(&[&arguments[..], &["json"]].concat()));
    let points = document["points"].as_array().unwrap();
    assert_eq!(points.len(), 16);
    for (row, point) in csv.lines().skip(1).zip(points) {
        let fields: Vec<&str> = row.split(',').collect();
        for (name, i) in [("theta", 1), ("r", 4), ("x", 5), ("y", 6)] {
            let (a, b): (f64, f64) = (fields[i].parse().unwrap(), point[name].as_f64().unwrap());
            assert_eq!(a.to_bits(), b.to_bits(), "{name}");
        }
        assert_eq!(point["u"], fields[2]);
        assert_eq!(point["v"], fields[3]);
    }
    assert!(csv.contains("\n0,-0.3333333333333333,"), "{csv}");
}

#[test]
fn directions_are_exact_unit_vectors_near_their_angle() {
    for row in done(&[
        "sample",
        "x^2 + y^2 = 1",
        "--directions",
        "12",
        "--theta",
        "219.5deg",
    ])
    .lines()
    .skip(1)
    {
        let fields: Vec<&str> = row.split(',').collect();
        let (u, v) = (rational(fields[2]), rational(fields[3]));
        assert!((&u * &u + &v * &v).is_one(), "{row}");
        let theta: f64 = fields[1].parse().unwrap();
        let near = |value: &BigRational, nominal: f64| {
            let error = value - BigRational::from_float(nominal).unwrap();
            error.abs() < BigRational::new(1.into(), BigInt::from(10).pow(15))
        };
        assert!(near(&u, theta.cos()) && near(&v, theta.sin()), "{row}");
        let r: f64 = fields[4].parse().unwrap();
        assert!(r.abs().to_bits() == 1f64.to_bits(), "{row}");
    }
}

/// A linear part of which bounded arithmetic once took the rounding error for the sign: the square has the same zero set, and
/// exact arithmetic solves it.
#[test]
fn a_form_that_nearly_vanishes_has_the_points_of_its_square() {
    let form = "9671406556917033397649408x^9 + x^2 \
        + 1545740262929933485628654903467243752277406906279780977475584x \
        - 1600660899510551534245218416770981541785682820269886452793343y";
    let square = format!("({form})^2");
    let rows = |form: &str| -> Vec<String> {
        let table = done(&["sample", form, "--theta", "44deg"]);
        // Without the multiplicity, the last column.
        let row = |row: &str| row.rsplit_once(',').unwrap().0.to_owned();
        table.lines().map(row).collect()
    };
    let found = rows(form);
    assert_eq!(found, rows(&square));
    assert_eq!(found.len(), 1 + 2, "a header and two points: {found:?}");
    assert!(found[1].contains(",0.6373928168391"), "{found:?}");
    assert!(found[2].contains(",-0.6373928168391"), "{found:?}");
}
