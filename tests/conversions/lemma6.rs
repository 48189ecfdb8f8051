//! Curves without a closed form, from end to end: branches, their ranges, the Fourier fit.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::Path;

use stellate::exact::Rational;
use stellate::fit::FitSize;
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::parametrize::{
    BranchFit, BranchFitOptions, BranchRadius, ExactAngle, Parametrization, fit_branch, parametrize,
};
use stellate::sample::{Direction, Ray, RaySolver};
use stellate::shape::Form;

use crate::common::program::{done, json, run_in};

/// A branch all around: x^6 + y^6 + xy³ = 1 + x.
const ROUND: &str = "x^6 + y^6 + x*y^3 = 1 + x";

fn number(text: &str) -> f64 {
    let (p, q) = text.split_once('/').unwrap_or((text, "1"));
    p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap()
}

fn numbers(list: &serde_json::Value) -> Vec<f64> {
    let list = list.as_array().unwrap().iter();
    list.map(|v| number(v.as_str().unwrap())).collect()
}

#[test]
fn the_error_of_a_fit_is_what_it_is_said_to_be() {
    let document = json(&done(&[
        "parametrize",
        ROUND,
        "--harmonics",
        "8",
        "--format",
        "json",
    ]));
    assert_eq!(document["method"], "lemma-6");
    let fit = &document["fit"];
    assert_eq!(fit["branch"], 1);
    assert_eq!(fit["harmonics"], 8);
    // The fitted branch has its formulas, said to be approximate; the other one has none.
    let branches = &document["branches"];
    assert_eq!(branches[1]["sympy"], fit["sympy"]);
    assert_eq!(branches[1]["approximate"], true);
    assert!(
        branches[1].get("fourier").is_none(),
        "the radius is no series"
    );
    assert!(branches[0].get("sympy").is_none() && branches[0].get("approximate").is_none());
    assert_eq!(fit["jumps"].as_array().unwrap().len(), 0);
    let samples = fit["samples"].as_u64().unwrap();
    let bound: f64 = fit["max_error_at_samples"]
        .as_str()
        .unwrap()
        .parse()
        .unwrap();
    let between: f64 = fit["max_error_between_estimate"]
        .as_str()
        .unwrap()
        .parse()
        .unwrap();
    let (cos, sin) = (
        numbers(&fit["fourier"]["cos"]),
        numbers(&fit["fourier"]["sin"]),
    );
    // The outermost positive root in the very directions of the samples.
    let count = samples.to_string();
    let rows = done(&["sample", ROUND, "--directions", &count, "--positive"]);
    let mut largest = 0.0f64;
    let mut directions = 0;
    for row in rows.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        if cells[0] != "0" {
            continue;
        }
        directions += 1;
        let (theta, r): (f64, f64) = (cells[1].parse().unwrap(), cells[4].parse().unwrap());
        let mut angle = 0.0;
        let mut value = 0.0;
        for (a, b) in cos.iter().zip(&sin) {
            value += a * f64::cos(angle) + b * f64::sin(angle);
            angle += theta;
        }
        largest = largest.max((value - r).abs());
    }
    assert_eq!(directions, samples);
    assert!(
        largest <= bound && largest > bound * 0.99,
        "{largest} and {bound}"
    );
    assert!(
        between < 2.0 * bound && bound < 0.03,
        "{between} and {bound}"
    );
    // More harmonics, a smaller error.
    let finer = json(&done(&[
        "parametrize",
        ROUND,
        "--harmonics",
        "40",
        "--format",
        "json",
    ]));
    let finer: f64 = finer["fit"]["max_error_at_samples"]
        .as_str()
        .unwrap()
        .parse()
        .unwrap();
    assert!(finer < bound / 10.0, "{finer} and {bound}");
}

#[test]
fn branches_say_which_root_they_are() {
    let document = json(&done(&[
        "parametrize",
        "x^5 - x - 1 + y^5",
        "--format",
        "json",
    ]));
    assert_eq!(document["fit"], serde_json::Value::Null);
    let equation = &document["equations"][0];
    assert_eq!(equation["discriminant"]["degree"], 20);
    assert_eq!(
        equation["sympy"],
        "(cos(theta)**5 + sin(theta)**5)*r**5 + (-cos(theta))*r + (-1)"
    );
    let branches = document["branches"].as_array().unwrap();
    assert_eq!(branches.len(), 4);
    let root = &branches[0]["roots"][1];
    assert_eq!(
        (root["root"].as_u64(), root["of"].as_u64()),
        (Some(2), Some(3))
    );
    assert_eq!(root["to"], "2.3647411485849737");
    assert!(branches[0].get("sympy").is_none(), "there is no formula");
    // (3π/4, 2.3647…]: infinite at the beginning, a fold at the end.
    assert_eq!(
        branches[2]["ranges"][0]["closed"],
        serde_json::json!([false, true])
    );
    assert_eq!(branches[2]["ranges"][0]["exact_from"], "3*pi/4");
}

#[test]
fn fits_are_written_in_every_format_that_has_formulas() {
    let run = |format: &str| {
        done(&[
            "parametrize",
            ROUND,
            "--harmonics",
            "3",
            "--decimals",
            "3",
            "--format",
            format,
        ])
    };
    let text = run("text");
    let formula = text.lines().last().unwrap();
    assert!(
        formula.starts_with("r = ") && formula.contains("cos(3*theta)"),
        "{text}"
    );
    assert!(run("csv").starts_with("n,cos,sin\n0,"));
    assert!(run("latex").contains("\\cos"));
    assert!(run("sympy").contains("*cos(3*theta)"));
    assert!(run("maple").starts_with("r = "));
    // The text is read back as the radius of the fit.
    let folder = tempfile::TempDir::new().unwrap();
    std::fs::write(folder.path().join("fit.txt"), &text).unwrap();
    let again = run_in(folder.path(), &["describe", "fit.txt"], "");
    assert!(
        again.out.contains("harmonics: 3"),
        "{}{}",
        again.out,
        again.err
    );
    std::fs::write(folder.path().join("fit.json"), run("json")).unwrap();
    let document = run_in(folder.path(), &["describe", "fit.json"], "");
    assert_eq!(document.out, again.out, "{}", document.err);
}

#[test]
fn wrong_choices_get_one_diagnosis_each() {
    let refused = |arguments: &[&str], part: &str| {
        let run = run_in(Path::new("."), arguments, "");
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}");
        assert!(run.err.contains(part), "{}", run.err);
    };
    refused(
        &["parametrize", ROUND, "--branch", "7"],
        "--branch 7: there are 2 branches, from 0 on",
    );
    refused(
        &["parametrize", ROUND, "--branch", "0"],
        "not positive in every direction",
    );
    refused(
        &["parametrize", ROUND, "--samples", "10"],
        "need at least 41 samples",
    );
    refused(
        &["parametrize", ROUND, "--distance", "1"],
        "--distance is for contours",
    );
    refused(
        &["parametrize", "x^2 + y^2 - 1", "--branch", "0"],
        "--branch is for contours and for branches without a closed form",
    );
    refused(
        &["parametrize", "x^2 + y^2 - 1", "--harmonics", "5"],
        "the radii of this form are exact",
    );
    refused(
        &["parametrize", "x^5 - x - 1 + y^5", "--format", "sympy"],
        "no formula",
    );
}

#[test]
fn too_large_a_discriminant_is_a_limit() {
    // A dense polynomial of degree 40 about a point that is not special.
    let text = "(x + 3y - 1)^40 + (2x - y + 3)^39*x + (x*y + 1)^19 - 7y^40 + 5";
    let run = run_in(Path::new("."), &["parametrize", text], "");
    assert_eq!((run.code, run.out.as_str()), (3, ""), "{}", run.err);
    assert!(run.err.contains("a discriminant of degree"), "{}", run.err);
}

fn parametrized(text: &str) -> Parametrization {
    let Form::Curve(curve) = parse_form(text, "<form>", Numbers::Exact).unwrap() else {
        panic!("a plane curve")
    };
    parametrize(&curve, &Limits::none()).unwrap()
}

/// The fit to a tolerance is that of the fewest harmonics: the same fit as for this number, and each smaller number has a
/// larger error.
#[test]
fn a_tolerance_has_the_fewest_harmonics() {
    for (text, tolerance) in [
        (ROUND, 0.05),
        (ROUND, 0.001),
        // The error does not decrease with every harmonic: many coefficients are 0.
        ("x^8 + y^8 + x^3*y^2 = 1", 0.01),
    ] {
        let found = parametrized(text);
        let fit = |size: FitSize| {
            let options = BranchFitOptions::default().size(size);
            fit_branch(&found, &options, &Limits::none())
                .unwrap()
                .unwrap()
        };
        let largest = |fit: &BranchFit| fit.error_at_samples.clone().max(fit.error_between.clone());
        let bound = Rational::try_from(tolerance).unwrap();
        let fewest = fit(FitSize::Tolerance(tolerance));
        assert!(largest(&fewest) <= bound, "{text}");
        let count = fewest.radius.harmonics();
        assert!(count > 3, "{text}: {count}");
        assert_eq!(fit(FitSize::Harmonics(count)).radius, fewest.radius);
        for fewer in 0..count {
            assert!(
                largest(&fit(FitSize::Harmonics(fewer))) > bound,
                "{text}: {fewer}"
            );
        }
    }
}

/// The best number of harmonics is named.
#[test]
fn a_tolerance_that_no_series_meets_is_refused() {
    let found = parametrized(ROUND);
    let refused = |tolerance: f64, samples: usize| {
        let options = BranchFitOptions::default()
            .size(FitSize::Tolerance(tolerance))
            .samples(Some(samples));
        fit_branch(&found, &options, &Limits::none())
            .unwrap_err()
            .to_string()
    };
    let message = refused(1e-9, 64);
    assert!(
        message.contains("up to 31") && message.contains("the best found is"),
        "{message}"
    );
    assert!(refused(0.0, 64).contains("greater than 0"));
}

/// At angles at which a root is infinite there are fewer roots: no branch keeps its rank there.
#[test]
fn ranks_are_those_of_all_angles_in_their_ranges() {
    for text in [
        "-x^3*y^2 + 3*x^3 + x^2*y^2 - 3*x^2 + x*y^2 + 2*x - 2*y^4 + 3*y^2 + 3 = 0",
        "x^6 - x^4 - y - 1 = 0",
        "-x^3*y^2 - 2*x^2 - x*y^2 + 3*y^4 + y^2 + 1 = 0",
        ROUND,
    ] {
        let Form::Curve(curve) = parse_form(text, "<form>", Numbers::Exact).unwrap() else {
            panic!("a plane curve")
        };
        let found = parametrize(&curve, &Limits::none()).unwrap();
        let mut asked = 0;
        for angle in ["0", "pi/2", "pi", "3*pi/2", "1", "2", "3", "4", "5", "6"] {
            let direction: Direction = angle.parse().unwrap();
            let Ray::Points(points) = RaySolver::new(curve.polynomial()).solve(&direction) else {
                continue;
            };
            let count: usize = points.iter().map(|p| p.multiplicity).sum();
            for branch in &found.branches {
                let BranchRadius::Root(root) = &branch.radius else {
                    continue;
                };
                for arc in root.arcs() {
                    let end = |a: &ExactAngle| a.to_decimal(12).parse::<f64>().unwrap();
                    let theta = direction.theta();
                    let range = end(&arc.range.from) + 1e-9..end(&arc.range.to) - 1e-9;
                    if range.contains(&theta) {
                        assert_eq!(arc.of, count, "{text} at {angle}");
                        asked += 1;
                    }
                }
            }
        }
        assert!(asked > 5, "{text}");
    }
}
