//! Inspection on the command line: rows, verdicts, exit codes, pictures.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fmt::Write as _;
use std::path::Path;

use crate::common::program::{done, json, run_in};
use num_rational::BigRational;
use tempfile::tempdir;

const SPHERE: &str = "x^2 + y^2 + z^2 = 1";
const PIPE: &str = "x^2 + y^2 = 1";

#[test]
fn a_point_has_a_row_and_the_verdict_is_the_exit_code() {
    let here = Path::new(".");
    let run = |p: &str| {
        run_in(
            here,
            &["inspect", SPHERE, "--tolerance", "0.1", "--point", p],
            "",
        )
    };
    let touching = run("0.66,0.88,0");
    assert_eq!(touching.code, 0);
    let row = touching.out.lines().nth(1).unwrap();
    assert!(row.starts_with("0.66,0.88,0,inside,true,"), "{row}");
    assert_eq!(
        touching.out.lines().next().unwrap(),
        "x,y,z,verdict,curve,distance_low,distance_high,sign"
    );
    assert!(
        touching
            .err
            .starts_with("note: 1 point: 1 inside, 0 outside, 0 undecided")
    );
    let outside = run("0.66,0.8800000000000000000001,0");
    assert_eq!(outside.code, 1);
    // The distance is more than 1/10 by less than a double can tell; the largest double below 1/10 is a lower bound.
    let row = outside.out.lines().nth(1).unwrap();
    let fields: Vec<&str> = row.split(',').collect();
    assert_eq!(fields[3..5], ["outside", "false"], "{row}");
    let [low, high] = [fields[5], fields[6]].map(|text| text.parse::<f64>().unwrap());
    assert!(
        (0.099_999_9..0.1).contains(&low) && (0.1..0.100_000_1).contains(&high),
        "{row}"
    );
    assert_eq!(fields[7], "1");
    // The double nearest to 0.88 is a little less than 0.88.
    let double = run_in(
        here,
        &[
            "inspect",
            SPHERE,
            "--tolerance",
            "0.1",
            "--numbers",
            "f64",
            "--point",
            "0.66,0.88,0",
        ],
        "",
    );
    assert_eq!(double.code, 1 - i32::from(less_than_the_touching_point()));
}

/// Whether the point of the doubles nearest to 0.66 and 0.88 is within 1.1 of the origin, by another arithmetic.
fn less_than_the_touching_point() -> bool {
    let exact = |x: f64| BigRational::from_float(x).unwrap();
    let (x, y) = (exact(0.66), exact(0.88));
    let limit = BigRational::new(121.into(), 100.into());
    &x * &x + &y * &y <= limit
}

#[test]
fn example_12_with_its_angles() {
    let point = [
        "inspect",
        PIPE,
        "--tolerance",
        "0.1",
        "--point",
        "0.8,0.6,0",
    ];
    let text = done(&[&point[..], &["--format", "text"]].concat());
    assert!(text.starts_with("(0.8, 0.6, 0): inside; it lies on the form\n"));
    let document = json(&done(&[&point[..], &["--format", "json"]].concat()));
    assert_eq!(document["kind"], "inspection");
    assert_eq!(document["summary"]["inside"], 1);
    let ranges = document["points"][0]["ranges"].as_array().unwrap();
    let ends: Vec<f64> = ranges
        .iter()
        .flat_map(|r| [&r["from"], &r["to"]])
        .map(|end| end.as_str().unwrap().parse().unwrap())
        .collect();
    assert_eq!(ends.len(), 4);
    for (end, expected) in ends
        .iter()
        .zip([0.688_910_6, 0.720_754_9, 1.688_910_6, 1.720_754_9])
    {
        assert!(
            (end / std::f64::consts::PI - expected).abs() < 1e-7,
            "{end}"
        );
        let value = 1.6 * end.cos() + 1.2 * end.sin();
        assert!((value.abs() - 0.1).abs() < 1e-14, "{value}");
    }
    assert!(ranges[0]["closed"] == serde_json::json!([true, true]));
}

/// Every row against the exact distance to the unit sphere, over num-rational: |p|² against (1 ± d)².
#[test]
fn rows_in_any_number_are_all_right() {
    let (mut rows, mut expected) = (String::from("# measured\nx,y,z\n"), Vec::new());
    let mut state = 7u64;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        i64::try_from(state >> 33).unwrap() % 2_400_001 - 1_200_000
    };
    let number = |k: i64| BigRational::new(k.into(), 1_000_000.into());
    let square = |q: &BigRational| q * q;
    let limits = [9, 11].map(|k| square(&BigRational::new(k.into(), 10.into())));
    for _ in 0..40_000 {
        let p = [next(), next(), next()];
        let [x, y, z] = p.map(|k| format!("{k}e-6"));
        writeln!(rows, "{x},{y},{z}").unwrap();
        let length: BigRational = p.iter().map(|k| square(&number(*k))).sum();
        expected.push(limits[0] <= length && length <= limits[1]);
    }
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("p.csv"), &rows).unwrap();
    let arguments = ["inspect", SPHERE, "--tolerance", "0.1", "--points"];
    let run = run_in(folder.path(), &[&arguments[..], &["p.csv"]].concat(), "");
    assert_eq!(run.code, 1);
    let found: Vec<&str> = run.out.lines().skip(1).collect();
    assert_eq!(found.len(), expected.len());
    for (row, inside) in found.iter().zip(&expected) {
        assert_eq!(row.contains(",inside,true,"), *inside, "{row}");
        assert_eq!(row.contains(",outside,false,"), !inside, "{row}");
    }
    // From standard input, with another number of threads: the same bytes.
    let other = [&arguments[..], &["-", "--threads", "1", "--quiet"]].concat();
    let piped = run_in(folder.path(), &other, &rows);
    assert_eq!(piped.out, run.out);
    assert_eq!(piped.err, "");
}

#[test]
fn a_bad_row_stops_it_or_is_counted() {
    let folder = tempdir().unwrap();
    let rows = "x,y,z\n1,0,0\n\n1,0\n0,1,0\n0,nan,1\n";
    let base = [
        "inspect",
        SPHERE,
        "--tolerance",
        "0.1",
        "--points",
        "-",
        "-o",
        "out.csv",
    ];
    let stopped = run_in(folder.path(), &base, rows);
    assert_eq!(stopped.code, 2);
    assert_eq!(
        stopped.err,
        "stellate: standard input, row 4: found 2 columns; each row must be x,y,z\n"
    );
    assert!(!folder.path().join("out.csv").exists());
    let skipped = run_in(folder.path(), &[&base[..], &["--skip-bad"]].concat(), rows);
    assert_eq!(skipped.code, 0, "{}", skipped.err);
    assert!(
        skipped.err.contains("2 rows were no points"),
        "{}",
        skipped.err
    );
    let written = std::fs::read_to_string(folder.path().join("out.csv")).unwrap();
    assert_eq!(written.lines().count(), 3);
}

#[test]
fn plane_curves_and_contours() {
    let circle = [
        "inspect",
        "x^2 + y^2 = 1",
        "--tolerance",
        "1/10",
        "--point",
        "0.66,0.88",
    ];
    let text = done(&[&circle[..], &["--format", "text"]].concat());
    assert!(text.contains("(0.66, 0.88): inside"), "{text}");
    // The one common point is towards the origin.
    assert!(
        text.ends_with("  at theta in [2*pi - 2*atan(2), 2*pi - 2*atan(2)]\n"),
        "{text}"
    );
    let csv = done(&circle);
    assert!(
        csv.starts_with(
            "x,y,verdict,curve,distance_low,distance_high,sign\n0.66,0.88,inside,true,"
        ),
        "{csv}"
    );
    // A Fourier radius goes through its equation; a center is taken into account.
    let radius =
        r#"{"schema":"stellate/1","kind":"fourier","cos":["2"],"sin":["0"],"center":["10","20"]}"#;
    let run = run_in(
        Path::new("."),
        &["inspect", "-", "--tolerance", "0.1", "--point", "12.05,20"],
        radius,
    );
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(
        run.out.contains("12.05,20,inside,true,0.0499999"),
        "{}",
        run.out
    );
}

/// The side of every kind of form, and a distance for every point, however far away.
#[test]
fn points_have_a_side_and_a_distance() {
    let at = |form: &str, point: &str| {
        let arguments = [
            "inspect",
            form,
            "--tolerance",
            "0.1",
            "--point",
            point,
            "--quiet",
        ];
        let run = run_in(Path::new("."), &arguments, "");
        let row = run.out.lines().nth(1).unwrap().to_owned();
        let fields: Vec<String> = row.split(',').map(str::to_owned).collect();
        let [low, high] = [3, 2].map(|k| fields[fields.len() - k].parse::<f64>().unwrap());
        (low, high, fields[fields.len() - 1].clone())
    };
    for (form, point, distance, side) in [
        ("r = 1 + 1/5*cos(3*t)", "0,0", 0.8, "-1"),
        ("r = 1 + 1/5*cos(3*t)", "100,0", 98.8, "1"),
        ("x^2 + y^2 = 1", "3,4", 4.0, "1"),
        ("1 - x^2 - y^2 = 0", "0,0.5", 0.5, "-1"),
        ("x^2 + y^2 = 1", "0.6,0.8", 0.0, "0"),
        ("x = 3*cos(t); y = 2*sin(t)", "0,1", 1.0, "-1"),
        ("x = 3*cos(t); y = 2*sin(t)", "-7,0", 4.0, "1"),
        ("x = t^2; y = t^3+t", "-1,0", 1.0, ""),
        ("x = t; y = 0; z = 0", "0,3,4", 5.0, ""),
        ("x^2 + y^2 + z^2 = 1", "0,0,50", 49.0, "1"),
        ("(x^2+y^2-1)*((x-10)^2+y^2-1)", "5,0", 4.0, "1"),
        ("superquadric 2d a=1,1 e=1/2", "3,0", 2.0, "1"),
        ("superquadric 2d a=1,1 e=0.2345", "3,0", 2.0, "1"),
        // A circle in space: its equation does not change its sign.
        ("(x^2+y^2-1)^2 + z^2 = 0", "2,0,0", 1.0, "1"),
        ("(x^2+y^2-1)^2 + 3*z^4 = 0", "0,0.5,0.5", 0.5f64.sqrt(), "1"),
        ("((x^2+y^2-1)^2 + z^2)*(x - 5) = 0", "4,0,0", 1.0, "-1"),
        ("superquadric 2d a=1,1 e=3", "0,0", 0.5, "-1"),
        ("superquadric 2d a=1,1 e=3", "2,0,9", 1.0, "1"),
        ("superquadric 3d a=3,3,3 e=2,2", "0,0,0", 3f64.sqrt(), "-1"),
        ("superquadric 3d a=1,2,3 e=0.7,2.5", "0,0,-5", 2.0, "1"),
    ] {
        let (low, high, found) = at(form, point);
        assert_eq!(found, side, "{form} {point}");
        assert!(
            low <= distance && distance <= high,
            "{form} {point}: {low} {high}"
        );
        assert!(
            high - low <= 1e-5 * (1.0 + distance),
            "{form} {point}: {low} {high}"
        );
    }
}

#[test]
fn tables_may_have_other_columns() {
    let run = |rows: &str, more: &[&str]| {
        let all = [
            &[
                "inspect",
                SPHERE,
                "--tolerance",
                "0.1",
                "--points",
                "-",
                "--quiet",
            ],
            more,
        ]
        .concat();
        run_in(Path::new("."), &all, rows)
    };
    let rows = "id,z,y,x,unit\n7,0.5,0,0,mm\n\"a, b\",0,0,2,mm\n";
    let found = run(rows, &[]);
    assert!(
        found.out.contains("0,0,0.5,inside") || found.out.contains("0,0,0.5,outside"),
        "{}",
        found.out
    );
    assert!(
        found.out.contains("\n2,0,0,outside,false,"),
        "{}",
        found.out
    );
    let kept = run(rows, &["--keep"]);
    assert!(
        kept.out
            .starts_with("x,y,z,verdict,curve,distance_low,distance_high,sign,id,unit\n")
    );
    assert!(kept.out.ends_with(",1,\"a, b\",mm\n"), "{}", kept.out);
    let document = json(&run(rows, &["--keep", "--format", "json"]).out);
    assert_eq!(document["points"][0]["kept"]["id"], "7");
    assert_eq!(document["points"][0]["sign"], -1);
    assert_eq!(document["summary"]["histogram"]["above"], 1);
    assert_eq!(document["summary"]["farthest"]["row"], 3);
    for row in ["5;0;0", "5\t0\t0", "5 0 0", "5,0;0;0\n"] {
        let found = run(row, &[]);
        assert_eq!(
            found.out.lines().count(),
            2,
            "{row}: {} {}",
            found.out,
            found.err
        );
        assert!(found.out.contains("outside"), "{row}");
    }
    for (rows, part) in [
        ("", "there are no points in it"),
        ("x,y,z\n# nothing\n", "there are no points in it"),
        (
            "1,2,3,4\n",
            "the first row names x, y and z among other columns",
        ),
        ("id,x,y,z\n1,2,3\n", "the first row names 4"),
    ] {
        let found = run(rows, &[]);
        assert!(
            found.code == 2 && found.err.contains(part),
            "{rows:?}: {}",
            found.err
        );
        assert_eq!(found.out, "");
    }
}

#[test]
fn pictures_and_clouds() {
    let folder = tempdir().unwrap();
    let rows = "1,0,0\n0,1.05,0\n0,0,1.2\n";
    let arguments = [
        "inspect",
        SPHERE,
        "--tolerance",
        "0.1",
        "--points",
        "-",
        "--plot",
        "p.svg",
        "--cloud",
        "c.ply",
        "-o",
        "v.csv",
    ];
    let run = run_in(folder.path(), &arguments, rows);
    assert_eq!(run.code, 1, "{}", run.err);
    let svg = std::fs::read_to_string(folder.path().join("p.svg")).unwrap();
    for label in [
        "2 points inside: within 1/10",
        "1 point outside: farther than 1/10",
        "surface of degree 2",
    ] {
        assert!(svg.contains(label), "{label}");
    }
    let ply = std::fs::read(folder.path().join("c.ply")).unwrap();
    let parser = ply_rs_bw::parser::Parser::<ply_rs_bw::ply::DefaultElement>::new();
    let cloud = parser.read_ply(&mut ply.as_slice()).unwrap();
    let vertices = &cloud.payload["vertex"];
    assert_eq!(vertices.len(), 3);
    let high = |k: usize| match vertices[k]["distance_high"] {
        ply_rs_bw::ply::Property::Double(value) => value,
        _ => panic!("not a double"),
    };
    assert!(high(0) <= 0.0 && (high(1) - 0.05).abs() < 1e-7 && (high(2) - 0.2).abs() < 1e-6);
}

/// The report is a page of well-formed XML with the numbers, the worst points and the command.
#[test]
fn a_report_is_one_page() {
    let folder = tempdir().unwrap();
    let rows = "x,y,z\n1,0,0\n0,1.05,0\n0,0,1.2\n";
    let arguments = [
        "inspect",
        SPHERE,
        "--tolerance",
        "0.1",
        "--points",
        "-",
        "--report",
        "out",
        "--quiet",
    ];
    let run = run_in(folder.path(), &arguments, rows);
    assert_eq!(run.code, 1, "{}", run.err);
    let page = std::fs::read_to_string(folder.path().join("out/index.html")).unwrap();
    let body = page.split_once("<!DOCTYPE html>\n").unwrap().1;
    let document = roxmltree::Document::parse(body).unwrap();
    let titles: Vec<&str> = document
        .descendants()
        .filter(|node| node.has_tag_name("h2"))
        .filter_map(|node| node.text())
        .collect();
    assert_eq!(titles.len(), 6, "{titles:?}");
    for part in [
        "3 points compared with",
        "row 4",
        "--tolerance 0.1",
        "No point is undecided",
    ] {
        assert!(page.contains(part), "{part}");
    }
    let refused = run_in(
        folder.path(),
        &[&arguments[..7], &["out/index.html"]].concat(),
        rows,
    );
    assert!(
        refused.code == 2 && refused.err.contains("a folder is wanted"),
        "{}",
        refused.err
    );
}

#[test]
fn undecided_is_said_with_exit_code_3() {
    // Nearly touching along a whole circle, one part in 10¹⁶ off, with almost no cubes allowed.
    let torus = "(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)";
    let arguments = [
        "inspect",
        torus,
        "--tolerance",
        "0.9999999999999999",
        "--point",
        "0,0,0",
        "--budget",
        "10",
    ];
    let run = run_in(Path::new("."), &arguments, "");
    assert_eq!(run.code, 3, "{}", run.out);
    assert!(run.out.contains(",undecided,"), "{}", run.out);
    assert!(
        run.err
            .contains("limit reached: --budget 10 cubes (1 of 1 points are undecided"),
        "{}",
        run.err
    );
}
