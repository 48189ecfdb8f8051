//! `check` and `vectors` end to end: what they print, their exit codes, their files.

use std::fs;
use std::path::Path;

use serde_json::Value;
use tempfile::TempDir;

use crate::common::program::{done, json, outline, run_in, strings, with_data};

const LOPSIDED: &str =
    "r = 1 + 1/4*cos(t) + 1/8*sin(t) + 1/16*cos(2*t) - 3/32*sin(2*t) + 1/32*cos(3*t)";

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
    let flat = [
        "check",
        "x^2 + y^2 + z^2 = 9",
        "--points",
        "data.csv",
        "--format",
        "csv",
    ];
    let run = with_data("3,0,0\n", &flat);
    let rows = "line,x,y,z,r,exact_r,digits,ulps,residual,first_order\n1,3.0,0.0,0.0,3.0,3,17.00,0,0.0,0.0\n";
    assert_eq!(run.out, rows);
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
fn coefficients_of_a_surface_and_of_a_curve_about_a_center() {
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
    // About the fit's center, said or unsaid; not about another one.
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
    fs::write(
        folder.path().join("data.csv"),
        "theta,r\n0,1\n1,1.01\n2,1\n",
    )
    .unwrap();
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

/// Without a mark nothing passes or fails: what is found decides the exit code.
#[test]
fn without_a_mark_passes_is_null() {
    let folder = TempDir::new().unwrap();
    for (values, code) in [("4 2 1", 0), ("1 100 7", 1)] {
        let [a, b, c] = values.split(' ').collect::<Vec<_>>()[..] else {
            panic!("three values")
        };
        let table = format!("i,j,value\n2,0,{a}\n0,2,{b}\n0,0,{c}\n");
        fs::write(folder.path().join("data.csv"), table).unwrap();
        let check = [
            "check",
            "4x^2 + 2y^2 + 1",
            "--coefficients",
            "data.csv",
            "--format",
            "json",
        ];
        let run = run_in(folder.path(), &check, "");
        assert_eq!(run.code, code, "{}", run.err);
        let found = json(&run.out);
        assert!(found["passes"].is_null());
        assert_eq!(found["mistakes"].as_array().unwrap().is_empty(), code == 0);
        let marked = run_in(
            folder.path(),
            &[&check[..], &["--digits", "12"]].concat(),
            "",
        );
        assert_eq!(marked.code, code);
        assert_eq!(json(&marked.out)["passes"], code == 0);
    }
}
