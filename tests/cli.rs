//! The program from end to end: what it prints, writes and returns.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde_json::Value;
use tempfile::TempDir;

const EGG: &str = "r = 1 + 1/5*cos(t) + 0.1*sin(t)";
const EGG_EQUATION: &str =
    "100x^4 + 200x^2y^2 + 100y^4 - 40x^3 - 20x^2y - 40xy^2 - 20y^3 - 96x^2 + 4xy - 99y^2 = 0\n";

/// A run of the program.
struct Run {
    code: i32,
    out: String,
    err: String,
}

fn run_in(folder: &Path, arguments: &[&str], stdin: &str) -> Run {
    let output = Command::cargo_bin("stellate")
        .unwrap()
        .current_dir(folder)
        .args(arguments)
        .write_stdin(stdin)
        .output()
        .unwrap();
    Run {
        code: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// What a successful run prints.
fn done_in(folder: &Path, arguments: &[&str], stdin: &str) -> String {
    let run = run_in(folder, arguments, stdin);
    assert_eq!(run.code, 0, "{arguments:?}: {}", run.err);
    run.out
}

fn done(arguments: &[&str]) -> String {
    done_in(Path::new("."), arguments, "")
}

fn piped(arguments: &[&str], stdin: &str) -> String {
    done_in(Path::new("."), arguments, stdin)
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn outline(name: &str) -> String {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("paper-examples");
    let path = root.join(format!("e02-{name}/{name}.csv"));
    path.to_str().unwrap().to_owned()
}

fn strings(value: &Value) -> Vec<String> {
    let entries = value.as_array().unwrap().iter();
    entries.map(|v| v.as_str().unwrap().to_owned()).collect()
}

fn rational(text: &str) -> BigRational {
    text.parse().unwrap()
}

fn rationals(value: &Value) -> Vec<BigRational> {
    strings(value).iter().map(|t| rational(t)).collect()
}

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

/// The implicit polynomial of a document: degree, and integer coefficients by exponents.
fn coefficients(document: &Value) -> BTreeMap<(u32, u32), BigInt> {
    let terms = document["terms"].as_array().unwrap().iter();
    terms
        .map(|t| {
            let e = |i: usize| u32::try_from(t["exponents"][i].as_u64().unwrap()).unwrap();
            (
                (e(0), e(1)),
                t["coefficient"].as_str().unwrap().parse().unwrap(),
            )
        })
        .collect()
}

/// The sign of f(r u, r v) for rational r and (u, v), in integers.
fn sign_at(f: &BTreeMap<(u32, u32), BigInt>, r: &BigRational, [u, v]: [&BigRational; 2]) -> Sign {
    let (x, y) = (r * u, r * v);
    let (q, s) = (x.denom(), y.denom());
    let common = q * s;
    let (a, b) = (x.numer() * s, y.numer() * q);
    let degree = f.keys().map(|(i, j)| i + j).max().unwrap();
    let powers = |base: &BigInt| -> Vec<BigInt> {
        std::iter::successors(Some(BigInt::one()), |p| Some(p * base))
            .take(degree as usize + 1)
            .collect()
    };
    let (a, b, c) = (powers(&a), powers(&b), powers(&common));
    let value: BigInt = f
        .iter()
        .map(|(&(i, j), k)| k * &a[i as usize] * &b[j as usize] * &c[(degree - i - j) as usize])
        .sum();
    value.sign()
}

/// The series at the point (u, v) of the unit circle, exactly, by the addition theorems.
fn series_at(cos: &[BigRational], sin: &[BigRational], [u, v]: [&BigRational; 2]) -> BigRational {
    // (p + iq)/d with u + iv = (p + iq)/d; coefficients over one power of two.
    let d = u.denom() * v.denom();
    let (p, q) = (u.numer() * v.denom(), v.numer() * u.denom());
    let scale = cos
        .iter()
        .chain(sin)
        .map(|c| c.denom().clone())
        .max()
        .unwrap();
    let integer = |c: &BigRational| {
        assert!(
            (&scale % c.denom()).is_zero(),
            "the coefficients of a fit are dyadic"
        );
        c.numer() * (&scale / c.denom())
    };
    let (mut re, mut im) = (BigInt::one(), BigInt::zero());
    let (mut sum, mut power) = (BigInt::zero(), BigInt::one());
    for (a, b) in cos.iter().zip(sin) {
        sum = sum * &d + integer(a) * &re + integer(b) * &im;
        (re, im) = (&re * &p - &im * &q, &re * &q + &im * &p);
        power *= &d;
    }
    // The sum runs over n = 0…N with d^(N−n); `power` is d^(N+1).
    BigRational::new(sum * d, scale * power)
}

/// The two points halfway to the neighbouring doubles.
fn midpoints(r: f64) -> [BigRational; 2] {
    let exact = |v: f64| BigRational::from_float(v).unwrap();
    [r.next_down(), r.next_up()].map(|n| (exact(n) + exact(r)) / BigInt::from(2))
}

/// Fit, polynomial of degree 80, back again, and certified samples of an outline.
fn the_main_job(name: &str) {
    let folder = TempDir::new().unwrap();
    let at = |arguments: &[&str]| done_in(folder.path(), arguments, "");
    let fit = json(&at(&[
        "fit",
        &outline(name),
        "--harmonics",
        "39",
        "--format",
        "json",
        "--quiet",
    ]));
    let (cos, sin) = (rationals(&fit["cos"]), rationals(&fit["sin"]));
    assert_eq!((cos.len(), sin.len()), (40, 40));
    at(&[
        "implicitize",
        &outline(name),
        "--harmonics",
        "39",
        "--format",
        "json",
        "-o",
        "f.json",
    ]);
    let text = fs::read_to_string(folder.path().join("f.json")).unwrap();
    let document = json(&text);
    assert_eq!(document["degree"], json("80"));
    assert_eq!(document["homogeneous_degrees"], json("[80,79,78]"));
    assert_eq!(document["center"], fit["center"]);

    let back = json(&at(&["parametrize", "f.json", "--format", "json"]));
    assert_eq!(back["center"], fit["center"]);
    let branches = back["branches"].as_array().unwrap();
    let same = |b: &&Value| b["fourier"]["cos"] == fit["cos"] && b["fourier"]["sin"] == fit["sin"];
    assert_eq!(
        branches.iter().filter(same).count(),
        1,
        "the same rationals come back"
    );

    let f = coefficients(&document);
    let rows = at(&["sample", "f.json", "--directions", "720", "--quiet"]);
    assert_eq!(rows.lines().count(), 1 + 2 * 720);
    let mut by_direction: BTreeMap<(String, String), Vec<f64>> = BTreeMap::new();
    for row in rows.lines().skip(1) {
        let fields: Vec<&str> = row.split(',').collect();
        let key = (fields[2].to_owned(), fields[3].to_owned());
        by_direction
            .entry(key)
            .or_default()
            .push(fields[4].parse().unwrap());
        assert_eq!(fields[7], "1", "{row}");
    }
    assert_eq!(by_direction.len(), 720);
    for (n, ((u, v), radii)) in by_direction.iter().enumerate() {
        assert_eq!(radii.len(), 2);
        let (u, v) = (rational(u), rational(v));
        // The roots of F are r(θ) and −r(θ + π).
        let front = series_at(&cos, &sin, [&u, &v]);
        let behind = -series_at(&cos, &sin, [&-&u, &-&v]);
        for (r, exact) in [(radii[0], front), (radii[1], behind)] {
            let [low, high] = midpoints(r);
            assert!(
                low <= exact && exact <= high,
                "{r} is not the double nearest to the root"
            );
            if n % 120 == 0 {
                let signs = [&low, &high].map(|m| sign_at(&f, m, [&u, &v]));
                assert!(
                    signs == [Sign::Minus, Sign::Plus] || signs == [Sign::Plus, Sign::Minus],
                    "F does not change sign about {r}: {signs:?}"
                );
            }
        }
    }
}

#[test]
fn the_butterfly_becomes_degree_80_and_comes_back_and_its_samples_are_the_nearest_doubles() {
    the_main_job("butterfly");
}

#[test]
fn the_jet_becomes_degree_80_and_comes_back_and_its_samples_are_the_nearest_doubles() {
    the_main_job("jet");
}

#[test]
fn an_outline_that_is_not_star_shaped_is_said_to_be_so() {
    let run = run_in(
        Path::new("."),
        &[
            "fit",
            &outline("jet"),
            "--harmonics",
            "9",
            "--format",
            "json",
        ],
        "",
    );
    assert!(run.err.contains("not star-shaped"), "{}", run.err);
    assert!(
        run.err.contains("% of the outline's length is hidden"),
        "{}",
        run.err
    );
    let fit = json(&run.out);
    assert_eq!(fit["star_shaped"], json("false"));
    assert!(fit["hidden_share"].as_f64().unwrap() > 0.1);
}

#[test]
fn a_fit_has_the_fields_of_the_contract() {
    let fit = json(&done(&[
        "fit",
        &outline("butterfly"),
        "--harmonics",
        "5",
        "--format",
        "json",
    ]));
    assert_eq!(fit["schema"], "stellate/1");
    assert_eq!(fit["kind"], "fourier");
    assert_eq!(fit["cos"].as_array().unwrap().len(), 6);
    assert_eq!(fit["sin"][0], "0");
    assert_eq!(fit["center"].as_array().unwrap().len(), 2);
    let error = |name: &str| fit[name].as_f64().unwrap();
    assert!(
        0.0 < error("rms_radial_error") && error("rms_radial_error") < error("max_radial_error")
    );
    assert_eq!(fit["star_shaped"], json("true"));
    assert!(fit["samples"].as_u64().unwrap() >= 40, "at least 8N");
}

#[test]
fn a_tolerance_takes_the_fewest_harmonics() {
    let butterfly = outline("butterfly");
    let error = |fit: &Value| fit["max_radial_error"].as_f64().unwrap();
    let fit = json(&done(&[
        "fit",
        &butterfly,
        "--tolerance",
        "150",
        "--format",
        "json",
    ]));
    assert!(error(&fit) <= 150.0);
    let n = fit["cos"].as_array().unwrap().len() - 1;
    assert!(n > 1);
    for fewer in 0..n {
        let fewer = fewer.to_string();
        let worse = json(&done(&[
            "fit",
            &butterfly,
            "--harmonics",
            &fewer,
            "--format",
            "json",
        ]));
        assert!(error(&worse) > 150.0, "N = {fewer} is enough");
    }
}

#[test]
fn center_decimals_and_samples_are_taken_as_given() {
    let butterfly = outline("butterfly");
    let fit = json(&done(&[
        "fit",
        &butterfly,
        "--harmonics",
        "4",
        "--center",
        "1000.5,1201/2",
        "--decimals",
        "2",
        "--samples",
        "64",
        "--format",
        "json",
    ]));
    assert_eq!(fit["center"], json(r#"["2001/2","1201/2"]"#));
    assert_eq!(fit["samples"], json("64"));
    for c in rationals(&fit["cos"]).iter().chain(&rationals(&fit["sin"])) {
        assert!(
            (BigInt::from(100) % c.denom()).is_zero(),
            "{c} has more than 2 decimals"
        );
    }
}

const SQUARE: &str = "x,y\n0,0\n2,0\n2,2\n0,2\n";

#[test]
fn an_outline_on_standard_input_is_a_contour_and_original_coordinates_expand_there() {
    // The mean distance of the square's boundary from its centre, by equal angles, is 1.12…
    let arguments = [
        "implicitize",
        "-",
        "--harmonics",
        "0",
        "--center",
        "1,1",
        "--decimals",
        "1",
    ];
    assert_eq!(
        piped(&arguments, SQUARE),
        "# center: 1, 1\n100x^2 + 100y^2 - 121 = 0\n"
    );
    let original = [&arguments[..], &["--coordinates", "original"]].concat();
    assert_eq!(
        piped(&original, SQUARE),
        "100x^2 + 100y^2 - 200x - 200y + 79 = 0\n"
    );
}

#[test]
fn the_centre_survives_every_document() {
    let flags = [
        "-",
        "--harmonics",
        "4",
        "--center",
        "1,3/4",
        "--decimals",
        "3",
        "--format",
    ];
    let expected = piped(&[&["implicitize"], &flags[..], &["json"]].concat(), SQUARE);
    assert_eq!(json(&expected)["center"], json(r#"["1","3/4"]"#));
    let implicitized = |text: &str| piped(&["implicitize", "-", "--format", "json"], text);
    for format in ["text", "json", "csv", "sympy", "maple"] {
        let radius = piped(&[&["fit"], &flags[..], &[format]].concat(), SQUARE);
        assert_eq!(implicitized(&radius), expected, "{format}");
    }
    for format in ["text", "json", "csv", "sympy", "maple", "singular"] {
        let implicit = piped(&["implicitize", "-", "--format", format], &expected);
        assert_eq!(implicitized(&implicit), expected, "{format}");
    }
    for format in ["text", "json", "csv", "sympy", "maple"] {
        let parametric = piped(&["parametrize", "-", "--format", format], &expected);
        assert_eq!(implicitized(&parametric), expected, "{format}");
    }
}

#[test]
fn statistics_are_one_line_of_json_on_standard_error() {
    let butterfly = outline("butterfly");
    let run = run_in(
        Path::new("."),
        &[
            "implicitize",
            &butterfly,
            "--harmonics",
            "9",
            "--stats",
            "--quiet",
        ],
        "",
    );
    assert_eq!(run.err.lines().count(), 1, "{}", run.err);
    let stats = &json(&run.err)["stats"];
    for stage in ["read", "fit", "implicitize", "write"] {
        assert!(stats[stage].as_f64().unwrap() >= 0.0, "{stage}");
    }
    if cfg!(target_os = "linux") {
        assert!(stats["peak_rss_bytes"].as_u64().unwrap() > 100_000);
    }
}

#[test]
fn quiet_silences_the_notes_and_changes_nothing_else() {
    let jet = outline("jet");
    let arguments = ["fit", jet.as_str(), "--harmonics", "9"];
    let loud = run_in(Path::new("."), &arguments, "");
    let quiet = run_in(Path::new("."), &[&arguments[..], &["--quiet"]].concat(), "");
    assert!(loud.err.starts_with("note: "));
    assert_eq!(quiet.err, "");
    assert_eq!(quiet.out, loud.out);
}

#[test]
fn the_number_of_threads_does_not_show() {
    let folder = TempDir::new().unwrap();
    let at = |arguments: &[&str]| done_in(folder.path(), arguments, "");
    at(&[
        "implicitize",
        &outline("butterfly"),
        "--harmonics",
        "20",
        "--format",
        "json",
        "-o",
        "f.json",
    ]);
    let samples = |n| at(&["sample", "f.json", "--directions", "90", "--threads", n]);
    assert_eq!(samples("1"), samples("2"));
    let figure = |n| {
        at(&["plot", "f.json", "-o", "f.svg", "--threads", n]);
        fs::read_to_string(folder.path().join("f.svg")).unwrap()
    };
    assert_eq!(figure("1"), figure("2"));
}

#[test]
fn output_goes_to_a_file_whole_and_nothing_to_the_screen() {
    let folder = TempDir::new().unwrap();
    fs::write(
        folder.path().join("f.txt"),
        "something longer that was here before".repeat(100),
    )
    .unwrap();
    let run = run_in(folder.path(), &["implicitize", EGG, "-o", "f.txt"], "");
    assert_eq!((run.code, run.out.as_str()), (0, ""));
    assert_eq!(
        fs::read_to_string(folder.path().join("f.txt")).unwrap(),
        EGG_EQUATION
    );
    assert_eq!(
        fs::read_dir(folder.path()).unwrap().count(),
        1,
        "no temporary file stays"
    );
}

#[cfg(unix)]
#[test]
fn output_through_a_link_keeps_the_link_and_to_a_pipe_keeps_the_pipe() {
    use std::os::unix::fs::FileTypeExt;
    let folder = TempDir::new().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("real.txt"), "old").unwrap();
    std::os::unix::fs::symlink("real.txt", path("link.txt")).unwrap();
    done_in(folder.path(), &["implicitize", EGG, "-o", "link.txt"], "");
    assert!(fs::symlink_metadata(path("link.txt")).unwrap().is_symlink());
    assert_eq!(fs::read_to_string(path("real.txt")).unwrap(), EGG_EQUATION);

    let made = std::process::Command::new("mkfifo")
        .arg(path("pipe"))
        .status()
        .unwrap();
    assert!(made.success());
    let pipe = path("pipe");
    let reader = std::thread::spawn(move || fs::read_to_string(pipe).unwrap());
    done_in(folder.path(), &["implicitize", EGG, "-o", "pipe"], "");
    // Looked at first: if a file had taken the pipe's place, the reader would wait for ever.
    assert!(fs::metadata(path("pipe")).unwrap().file_type().is_fifo());
    assert_eq!(reader.join().unwrap(), EGG_EQUATION);
}

#[cfg(unix)]
#[test]
fn a_result_has_the_permissions_that_the_umask_leaves() {
    use std::os::unix::fs::PermissionsExt;
    let folder = TempDir::new().unwrap();
    let program = assert_cmd::cargo::cargo_bin("stellate");
    let script = format!(
        "umask 027 && '{}' implicitize x -o f.txt",
        program.display()
    );
    let status = std::process::Command::new("sh")
        .current_dir(&folder)
        .args(["-c", &script])
        .status();
    assert!(status.unwrap().success());
    let mode = fs::metadata(folder.path().join("f.txt"))
        .unwrap()
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o640);
}

#[test]
fn a_form_may_be_a_file_with_comments_or_start_with_a_minus() {
    let folder = TempDir::new().unwrap();
    fs::write(
        folder.path().join("egg"),
        format!("# an egg\n{EGG} # round\n"),
    )
    .unwrap();
    assert_eq!(
        done_in(folder.path(), &["implicitize", "egg"], ""),
        EGG_EQUATION
    );
    assert_eq!(done(&["implicitize", "-x^2 + y"]), "x^2 - y = 0\n");
    assert_eq!(
        piped(&["implicitize", "-"], "x²+y² = 1"),
        "x^2 + y^2 - 1 = 0\n"
    );
}

#[test]
fn a_plot_overlays_outline_series_and_zero_set_with_a_legend() {
    let folder = TempDir::new().unwrap();
    let butterfly = outline("butterfly");
    let at = |arguments: &[&str]| done_in(folder.path(), arguments, "");
    at(&[
        "fit",
        &butterfly,
        "--harmonics",
        "12",
        "--format",
        "json",
        "-o",
        "r.json",
    ]);
    at(&["implicitize", "r.json", "--format", "json", "-o", "f.json"]);
    let forms = [
        "plot",
        butterfly.as_str(),
        "r.json",
        "f.json",
        "--title",
        "A butterfly",
        "-o",
    ];
    assert_eq!(at(&[&forms[..], &["f.svg"]].concat()), "");
    let svg = fs::read_to_string(folder.path().join("f.svg")).unwrap();
    for text in [
        "butterfly.csv",
        "N = 12, r.json",
        "degree 26, f.json",
        "A butterfly",
    ] {
        assert!(svg.contains(text), "the legend lacks {text}");
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    at(&[&forms[..], &["f.png"]].concat());
    let png = fs::read(folder.path().join("f.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n") && png.ends_with(b"IEND\xaeB`\x82"));
}

#[test]
fn every_verb_helps_with_an_example() {
    for verb in [
        "describe",
        "implicitize",
        "parametrize",
        "fit",
        "sample",
        "plot",
    ] {
        let help = done(&[verb, "--help"]);
        assert!(help.contains(&format!("\n  stellate {verb} ")), "{help}");
    }
    assert!(done(&["--help"]).contains("Example"));
    assert_eq!(
        done(&["--version"]),
        format!("stellate {}\n", env!("CARGO_PKG_VERSION"))
    );
}

#[test]
fn a_form_without_points_to_fit_a_window_to_is_drawn_in_a_stated_one() {
    let folder = TempDir::new().unwrap();
    for form in ["x^2 + y^2 + 1", "x*y = 0", "x^2 + y^2 = 0"] {
        let run = run_in(folder.path(), &["plot", form, "-o", "f.svg"], "");
        assert_eq!(run.code, 0, "{}", run.err);
        assert!(
            run.err.contains("it shows -1,1,-1,1; --window"),
            "{}",
            run.err
        );
    }
}

#[test]
fn roots_beyond_the_doubles_are_infinite_or_zero() {
    let radii = |form: &str| -> Vec<String> {
        let rows = done(&["sample", form, "--theta", "0"]);
        let field = |row: &str, i: usize| row.split(',').nth(i).unwrap().to_owned();
        rows.lines().skip(1).map(|row| field(row, 4)).collect()
    };
    assert_eq!(radii("x^2 + y^2 = 1e700"), ["inf", "-inf"]);
    assert_eq!(radii("x^3 = 1e1200"), ["inf"]);
    assert_eq!(radii("x^2 + y^2 = 1e600"), ["1e300", "-1e300"]);
    assert_eq!(radii("x^2 + y^2 = 2e-640"), ["1.414e-320", "-1.414e-320"]);
    assert_eq!(radii("x^2 + y^2 = 1e-700"), ["0.0", "-0.0"]);
    // r = 1e309 is beyond the doubles, y = r sin(theta) = 1e304 is not.
    let rows = done(&[
        "sample",
        "x^2 + y^2 = 1e618",
        "--theta",
        "1e-5",
        "--positive",
    ]);
    let row: Vec<&str> = rows.lines().nth(1).unwrap().split(',').collect();
    assert_eq!((row[4], row[5]), ("inf", "inf"));
    let y: f64 = row[6].parse().unwrap();
    assert!((y / 1e304 - 1.0).abs() < 1e-9, "{y}");
}
