//! Limits of the signed distance and uncertainties on the command line.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use serde_json::json;
use tempfile::TempDir;

use crate::common::program::{Run, json, run_in};

/// Points at the signed distances −2, −1, −0.02, 0, 0.05, 0.06 and 1 from the circle of radius 5.
const POINTS: &str =
    "x,y,id\n1.8,2.4,a\n2.4,3.2,b\n2.988,3.984,c\n3,4,d\n3.03,4.04,e\n3.036,4.048,f\n3.6,4.8,g\n";

pub(crate) fn inspect(folder: &Path, form: &str, more: &str) -> Run {
    fs::write(folder.join("p.csv"), POINTS).unwrap();
    let words = more.split_whitespace();
    let arguments = ["inspect", form, "--points", "p.csv"]
        .into_iter()
        .chain(words);
    run_in(folder, &arguments.collect::<Vec<_>>(), "")
}

fn verdicts(run: &Run) -> Vec<&str> {
    run.out
        .lines()
        .skip(1)
        .map(|row| row.split(',').nth(2).unwrap())
        .collect()
}

pub(crate) const FORMS: [&str; 3] = ["x^2 + y^2 = 25", "r = 5", "x = 5*cos(t); y = 5*sin(t)"];

#[test]
fn two_limits_decide_by_the_signed_distance() {
    let folder = TempDir::new().unwrap();
    for form in FORMS {
        let run = inspect(folder.path(), form, "--tolerance=-0.02,0.05");
        let [inside, outside] = ["inside", "outside"];
        assert_eq!(
            verdicts(&run),
            [outside, outside, inside, inside, inside, outside, outside]
        );
        assert_eq!(run.code, 1);
        assert!(
            run.err
                .contains("7 points: 3 inside, 4 outside, 0 undecided"),
            "{}",
            run.err
        );
        // The value may be a word of its own, and a limit may be 0.
        let run = inspect(folder.path(), form, "--tolerance -1,0");
        assert_eq!(
            verdicts(&run),
            [outside, inside, inside, inside, outside, outside, outside]
        );
        let criterion: Vec<&str> = run
            .out
            .lines()
            .skip(1)
            .map(|row| row.split(',').nth(3).unwrap())
            .collect();
        assert_eq!(
            criterion,
            ["false", "true", "true", "true", "false", "false", "false"]
        );
        let run = inspect(folder.path(), form, "--tolerance=0;1");
        assert_eq!(
            verdicts(&run)[2..],
            [outside, inside, inside, inside, inside]
        );
        let [one, two] =
            ["--tolerance 1", "--tolerance=-1,1"].map(|t| inspect(folder.path(), form, t));
        assert_eq!((one.out, one.err, one.code), (two.out, two.err, two.code));
    }
}

#[test]
fn the_document_says_what_was_asked() {
    let folder = TempDir::new().unwrap();
    let run = inspect(
        folder.path(),
        "r = 5",
        "--tolerance=-0.02,0.05 --format json",
    );
    let document = json(&run.out);
    assert_eq!(document["tolerance"], json!(["-1/50", "1/20"]));
    assert!(document.get("uncertainty").is_none());
    let histogram = &document["summary"]["histogram"];
    assert_eq!(
        (histogram["below"].clone(), histogram["above"].clone()),
        (json!(2), json!(2))
    );
    assert_eq!(histogram["within"], json!([1, 0, 1, 0, 0, 0, 0, 0, 0, 1]));
    let run = inspect(
        folder.path(),
        "r = 5",
        "--tolerance 1 --uncertainty 0.01 --format json",
    );
    let document = json(&run.out);
    assert_eq!(
        (
            document["tolerance"].clone(),
            document["uncertainty"].clone()
        ),
        (json!("1"), json!("1/100"))
    );
    assert_eq!(document["summary"]["uncertain"], 2);
    assert_eq!(document["points"][1]["verdict"], "uncertain");
}

#[test]
fn uncertain_points_do_not_conform() {
    let folder = TempDir::new().unwrap();
    for form in FORMS {
        let run = inspect(folder.path(), form, "--tolerance 1 --uncertainty 1/20");
        assert_eq!(
            verdicts(&run),
            [
                "outside",
                "uncertain",
                "inside",
                "inside",
                "inside",
                "inside",
                "uncertain"
            ]
        );
        assert!(
            run.err
                .contains("7 points: 4 inside, 1 outside, 2 uncertain, 0 undecided"),
            "{}",
            run.err
        );
        assert_eq!(run.code, 1);
        // No point is outside, but one is not proved to be inside.
        let arguments = [
            "inspect",
            form,
            "--tolerance",
            "1",
            "--uncertainty",
            "0.1",
            "--point",
            "3.6,4.8",
        ];
        let run = run_in(folder.path(), &arguments, "");
        assert_eq!((run.code, verdicts(&run)), (1, vec!["uncertain"]));
        // The inner zone of one-sided limits begins on the outer side.
        let run = inspect(folder.path(), form, "--tolerance 0,0.06 --uncertainty 0.01");
        assert_eq!(
            verdicts(&run),
            [
                "outside",
                "outside",
                "outside",
                "uncertain",
                "inside",
                "uncertain",
                "outside"
            ]
        );
        let run = inspect(folder.path(), form, "--tolerance 1 --uncertainty 2");
        assert!(
            run.err.contains(
                "note: the uncertainty takes up the tolerance: no point can be proved to be inside"
            ),
            "{}",
            run.err
        );
        assert!(!verdicts(&run).contains(&"inside"));
        // Only the point on the form has nothing but points within the tolerance about it.
        let run = inspect(folder.path(), form, "--tolerance 1 --uncertainty 1");
        assert!(
            run.err
                .contains("that is not exactly in the middle of the zone"),
            "{}",
            run.err
        );
        let inside: Vec<bool> = verdicts(&run)
            .iter()
            .map(|verdict| *verdict == "inside")
            .collect();
        assert_eq!(inside, [false, false, false, true, false, false, false]);
    }
}

#[test]
fn reports_clouds_and_pictures_know_the_limits() {
    let folder = TempDir::new().unwrap();
    let run = inspect(
        folder.path(),
        "r = 5",
        "--tolerance=-1,0.1 --uncertainty 0.04 --report r --cloud c.ply --plot p.svg -o v.csv",
    );
    assert_eq!(run.code, 1, "{}", run.err);
    let read = |name: &str| fs::read(folder.path().join(name)).unwrap();
    let page = String::from_utf8(read("r/index.html")).unwrap();
    for text in [
        "tolerance -1 to 1/10, uncertainty 1/25",
        "<th scope=\"row\">uncertain</th><td>1</td>",
        "signed distance is from -1 to 1/10 wherever",
        "<th scope=\"row\">below −1.0</th><td class=\"number\">1</td>",
        "<th scope=\"row\">−0.01 to 0.1</th>",
        "<th scope=\"row\">above 0.1</th>",
    ] {
        assert!(page.contains(text), "{text}");
    }
    let svg = String::from_utf8(read("p.svg")).unwrap();
    for text in [
        "inside: signed distance -1 to 1/10",
        "outside: signed distance not",
        "uncertain: known within 1/25",
        "the tolerance of its side",
    ] {
        assert!(svg.contains(text), "{text}");
    }
    let cloud = read("c.ply");
    let head = b"ply\nformat binary_little_endian 1.0\ncomment stellate inspect, tolerance -1 to 1/10, uncertainty 1/25\n";
    assert!(cloud.starts_with(head));
    // The second point is uncertain, and blue: 43 bytes for each point.
    let from_end = |k: usize| &cloud[cloud.len() - 43 * (7 - k) + 40..][..3];
    assert_eq!(
        (from_end(0), from_end(1), from_end(2)),
        (&[213, 94, 0][..], &[0, 114, 178][..], &[0, 120, 90][..])
    );
}

#[test]
fn what_was_decided_can_be_verified() {
    let folder = TempDir::new().unwrap();
    for (form, options) in [
        ("r = 5", "--tolerance=-0.02,0.05"),
        ("x^2 + y^2 = 25", "--tolerance=-1,0"),
        ("x^2 + y^2 = 25", "--tolerance 1 --uncertainty 1/20"),
        ("r = 5", "--tolerance 0,0.06 --uncertainty 0.01"),
    ] {
        let run = inspect(
            folder.path(),
            form,
            &format!("{options} --proof proof.json"),
        );
        assert!(run.err.contains("note: proof: "), "{}", run.err);
        let verified = run_in(folder.path(), &["verify", "proof.json"], "");
        assert_eq!(verified.code, 0, "{}", verified.out);
    }
    // The claims are about the distances that the verdicts compare with.
    let text = fs::read_to_string(folder.path().join("proof.json")).unwrap();
    for bound in [
        "\"bound\":\"1/20\"",
        "\"bound\":\"1/100\"",
        "\"bound\":\"7/100\"",
    ] {
        assert!(text.contains(bound), "{bound}");
    }
    assert!(text.contains("\"claim\":\"side\""));
}

#[test]
fn wrong_limits_are_refused_in_plain_words() {
    let refused = |form: &str, tolerance: &str| {
        let point = ["inspect", form, "--point", "1,0", "--tolerance", tolerance];
        let run = run_in(Path::new("."), &point, "");
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{tolerance}");
        run.err
    };
    let circle = "x^2 + y^2 = 1";
    for tolerance in [
        "0.1,0.2", "-2,-1", "0;0", "0.0,0", "0.2;-0.1", "-1,2,3", "-1;;2",
    ] {
        let said = refused(circle, tolerance);
        assert!(
            said.starts_with(&format!("stellate: --tolerance {tolerance}: ")),
            "{said}"
        );
        assert!(
            said.contains(
                "two limits LOW ≤ 0 ≤ HIGH of the signed distance, not both 0, such as -0.02,0.05"
            ),
            "{said}"
        );
    }
    let said = refused(circle, "-x,1");
    assert!(said.contains("\"-x\" is not a number"), "{said}");
    // 0,1 and -0,1 are read as 0.1 in many countries.
    for tolerance in ["0,1", "-0,1"] {
        let said = refused(circle, tolerance);
        assert!(
            said.contains("decimals are written with a point: "),
            "{said}"
        );
        assert!(
            said.contains("the limits 0 to 1 are written with a semicolon: "),
            "{said}"
        );
    }
    let said = refused("x = t; y = t^2", "-0.1,0.2");
    assert!(said.contains("no inside and no outside: it takes one tolerance, such as 1/5, instead of the limits -1/10 to 1/5"), "{said}");
    for uncertainty in ["0", "-1", "x"] {
        let words = [
            "inspect",
            circle,
            "--point",
            "1,0",
            "--tolerance",
            "1",
            "--uncertainty",
            uncertainty,
        ];
        let run = run_in(Path::new("."), &words, "");
        assert_eq!(run.code, 2);
        assert!(
            run.err.contains(&format!(
                "--uncertainty {uncertainty}: expected a number greater than 0"
            )),
            "{}",
            run.err
        );
    }
}

#[test]
fn an_undecided_point_stays_undecided() {
    // The distance of the origin is 1. Without cubes it is not decided whether it is at most 0.9.
    let run = |more: &[&str]| {
        let words = [
            "inspect",
            "x^4 + y^4 + z^4 = 1",
            "--point",
            "0,0,0",
            "--budget",
            "0",
        ];
        run_in(Path::new("."), &[&words[..], more].concat(), "")
    };
    let verdict = |run: &Run| {
        run.out
            .lines()
            .nth(1)
            .unwrap()
            .split(',')
            .nth(3)
            .unwrap()
            .to_owned()
    };
    for more in [
        &["--tolerance", "0.9"][..],
        &["--tolerance=-0.9,0.5"],
        &["--tolerance", "0.9", "--uncertainty", "0.01"],
    ] {
        let run = run(more);
        assert_eq!(
            (run.code, verdict(&run).as_str()),
            (3, "undecided"),
            "{more:?}"
        );
    }
    // The side alone decides this one.
    let run = run(&["--tolerance", "0;0.5"]);
    assert_eq!((run.code, verdict(&run).as_str()), (1, "outside"));
}
