//! The main job from end to end: contours to exact polynomials to certified points.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::{One, Zero};
use serde_json::Value;
use tempfile::TempDir;

use crate::common::program::{done, done_in, json, outline, piped, rational, rationals, run_in};

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
    let center = document["center"].as_array().unwrap();
    let [x, y] = [0, 1].map(|i| center[i].as_str().unwrap());
    let (comment, rows) = rows.split_once('\n').unwrap();
    assert_eq!(comment, format!("# center {x} {y}"));
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
    assert!(run.err.contains("% of its length is hidden"), "{}", run.err);
    let fit = json(&run.out);
    // The fitted radius is positive everywhere; the outline has parts that no radius follows.
    assert_eq!(fit["star_shaped"], json("true"));
    assert_eq!(fit["outline_star_shaped"], json("false"));
    assert!(run.err.contains("--model elliptic"), "{}", run.err);
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
    assert_eq!(fit["outline_star_shaped"], json("true"));
    let distance = |end: &str| fit["distance"][end].as_f64().unwrap();
    assert!(0.0 < distance("low") && distance("low") <= distance("high"));
    assert!(distance("high") <= 1.01 * distance("low"));
    // No point of either curve is farther from the other than along its ray.
    assert!(distance("low") <= error("max_radial_error"));
    assert!(error("mean_distance") < distance("low") && error("overlap") < 1.0);
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
    // The mean distance of the square's boundary from its center, by equal angles, is 1.12…
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
        "# center: 1, 1\n# note: radial error of the fit ≈ 3.142e-1 at most, ≈ 1.200e-1 rms\n100x^2 + 100y^2 - 121 = 0\n"
    );
    let original = [&arguments[..], &["--coordinates", "original"]].concat();
    assert_eq!(
        piped(&original, SQUARE),
        "# note: radial error of the fit ≈ 3.142e-1 at most, ≈ 1.200e-1 rms\n100x^2 + 100y^2 - 200x - 200y + 79 = 0\n"
    );
}

#[test]
fn the_center_survives_every_document() {
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
    let direct = piped(&[&["implicitize"], &flags[..], &["json"]].concat(), SQUARE);
    assert_eq!(json(&direct)["center"], json(r#"["1","3/4"]"#));
    // The polynomial does not know of the fit.
    assert_eq!(json(&direct)["outline_star_shaped"], true);
    let expected = piped(&["implicitize", "-", "--format", "json"], &direct);
    let (mut left, right) = (json(&direct), json(&expected));
    let fields = left.as_object_mut().unwrap();
    for name in ["notes", "outline_star_shaped", "hidden_share"] {
        assert!(fields.remove(name).is_some(), "{name}");
    }
    assert_eq!(left, right);
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
