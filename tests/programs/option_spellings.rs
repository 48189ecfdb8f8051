//! Spellings of the values of options that mean the same, and what the name of an output says.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;

use tempfile::TempDir;

use super::bad_input::{EGG, circle};
use crate::common::program::{Run, done, done_in, json, run_in};

/// Both give the same output.
fn assert_same(pairs: &[(&str, &str)]) {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("c.csv"), circle().join("\n")).unwrap();
    let run = |typed: &str| {
        let words = shell_words::split(typed).unwrap();
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        run_in(folder.path(), &words, "")
    };
    for (typed, usual) in pairs {
        let (run, usual) = (run(typed), run(usual));
        assert!(run.code <= 1, "{typed}: {}", run.err);
        assert_eq!((run.code, run.out), (usual.code, usual.out), "{typed}");
    }
}

/// Pairs of values of one option.
fn assert_same_values(command: &str, pairs: &[(&str, &str)]) {
    for (value, usual) in pairs {
        assert_same(&[(
            &format!("{command}={}", shell_words::quote(value)),
            &format!("{command}={}", shell_words::quote(usual)),
        )]);
    }
}

#[test]
fn angles_have_many_spellings() {
    assert_same_values(
        "sample 'x^2/4 + y^2 = 1' --positive --theta",
        &[
            ("Pi/6", "pi/6"),
            ("PI/6", "pi/6"),
            ("π/6", "pi/6"),
            ("pi*2", "2*pi"),
            ("(pi/6)", "pi/6"),
            ("np.pi/6", "pi/6"),
            ("math.pi / 6", "pi/6"),
            ("0.5rad", "0.5"),
            ("0.5 radians", "0.5"),
            ("30º", "30deg"),
            ("30˚", "30deg"),
            ("30 degree", "30deg"),
            ("-30DEG", "-30deg"),
        ],
    );
}

#[test]
fn points_may_stand_in_brackets_and_with_blanks() {
    let center = "fit c.csv -n 3 --center";
    assert_same_values(
        center,
        &[
            ("(0, 0)", "0,0"),
            ("[0,0]", "0,0"),
            ("0 0", "0,0"),
            ("0;0", "0,0"),
            ("Centroid", "centroid"),
            ("1/10,1e-1", "0.1,0.1"),
        ],
    );
    let point = "inspect 'x^2/4 + y^2 = 1' --tolerance 1 --point";
    let points = [("(1, 0)", "1,0"), ("1 0", "1,0"), ("[1;0]", "1,0")];
    assert_same_values(point, &points);
    // What is written is what was read.
    let folder = TempDir::new().unwrap();
    let run = run_in(
        folder.path(),
        &["inspect", "x", "--tolerance", "1", "--point", "(0.50, 1/3)"],
        "",
    );
    assert!(run.out.contains("\n0.50,1/3,inside,"), "{}", run.out);
}

#[test]
fn numbers_times_and_names_have_many_spellings() {
    assert_same(&[
        ("fit c.csv --tolerance 1/100", "fit c.csv --tolerance 0.01"),
        ("fit c.csv --tolerance 1e-2", "fit c.csv --tolerance 0.01"),
        (
            "inspect x --tolerance 1e-1 --point 0,0",
            "inspect x --tolerance 1/10 --point 0,0",
        ),
        ("implicitize x --format JSON", "implicitize x --format json"),
        (
            "implicitize x --format LaTeX",
            "implicitize x --format latex",
        ),
        ("implicitize x --format tex", "implicitize x --format latex"),
        (
            "implicitize x --format SymPy",
            "implicitize x --format sympy",
        ),
        (
            "implicitize 2x=1 --scale Monic",
            "implicitize 2x=1 --scale monic",
        ),
        (
            "implicitize 0.1x=y --numbers F64",
            "implicitize 0.1x=y --numbers f64",
        ),
        ("completions PowerShell", "completions powershell"),
        ("completions Bash", "completions bash"),
        ("paper --only 'eq. (19)'", "paper --only Eq19"),
        ("fit c.csv -n=3", "fit c.csv --harmonics 3"),
    ]);
    assert_same_values(
        "implicitize x --time-limit",
        &[
            ("5sec", "5"),
            ("5 minutes", "5min"),
            ("1 Hour", "60m"),
            ("500 ms", "0.5s"),
            ("1/2min", "30"),
        ],
    );
}

/// A picture or a mesh of one option, as bytes.
fn drawn(command: &[&str], option: &str, value: &str, name: &str) -> Vec<u8> {
    let folder = TempDir::new().unwrap();
    let option = format!("{option}={value}");
    let arguments = [command, &[&option, "--quiet", "-o", name]].concat();
    done_in(folder.path(), &arguments, "");
    fs::read(folder.path().join(name)).unwrap()
}

#[test]
fn pictures_and_meshes_read_angles_and_boxes_in_all_their_spellings() {
    let curve = &["plot", "x = cos(t); y = sin(2t)"][..];
    let space = &["plot", "x = cos(t); y = sin(2t); z = sin(t)"];
    let sphere = &["mesh", "x^2 + y^2 + 2z^2 = 1", "--resolution", "4"];
    let half_turn = "t=0,3.141592653589793";
    for (command, option, value, usual, name) in [
        (curve, "--range", "t=0,pi", half_turn, "p.svg"),
        (curve, "--range", "t=0,180deg", half_turn, "p.svg"),
        (curve, "--range", "t = 0..Pi", half_turn, "p.svg"),
        (
            curve,
            "--range",
            "t=-pi..2pi",
            "t=-3.141592653589793,6.283185307179586",
            "p.svg",
        ),
        (curve, "--range", "t=[-2, 2]", "t=-2,2", "p.svg"),
        (curve, "--window", "-2 2 -2 2", "-2,2,-2,2", "p.svg"),
        (curve, "--window", "[-2, 2, -2, 2]", "-2,2,-2,2", "p.svg"),
        (space, "--view", "30deg,20deg", "30,20", "p.svg"),
        (space, "--view", "(30, 20°)", "30,20", "p.svg"),
        (space, "--point", "(1, 0, 0)", "1,0,0", "p.svg"),
        (sphere, "--angle", "30deg", "30", "m.ply"),
        (sphere, "--angle", "pi/6", "30", "m.ply"),
    ] {
        let (found, usual) = (
            drawn(command, option, value, name),
            drawn(command, option, usual, name),
        );
        assert!(found == usual, "{option} {value}");
    }
}

#[test]
fn the_name_of_the_output_chooses_the_format() {
    let folder = TempDir::new().unwrap();
    let written = |name: &str, more: &[&str]| {
        let arguments = [&["implicitize", EGG, "-o", name], more].concat();
        assert_eq!(done_in(folder.path(), &arguments, ""), "");
        fs::read_to_string(folder.path().join(name)).unwrap()
    };
    for (name, format) in [
        ("f.json", "json"),
        ("f.JSON", "json"),
        ("f.csv", "csv"),
        ("f.tex", "latex"),
        ("f.txt", "text"),
        ("f.sing", "text"),
        ("f", "text"),
    ] {
        let usual = done(&["implicitize", EGG, "--format", format]);
        assert_eq!(written(name, &[]), usual, "{name}");
    }
    // What is said counts more than the name.
    let text = done(&["implicitize", EGG]);
    assert_eq!(written("g.json", &["--format", "text"]), text);
    let points = ["sample", EGG, "--directions", "2", "-o", "points.json"];
    done_in(folder.path(), &points, "");
    let points = fs::read_to_string(folder.path().join("points.json")).unwrap();
    assert_eq!(json(&points)["schema"], "stellate/1");
}

#[test]
fn an_angle_beyond_a_full_turn_is_remarked_on_where_it_has_no_unit() {
    let said = |theta: &str| {
        let arguments = ["sample", EGG, "--theta", theta, "--positive"];
        run_in(TempDir::new().unwrap().path(), &arguments, "").err
    };
    assert_eq!(
        said("30"),
        "note: the angle 30 is in radians; degrees are written 30deg\n"
    );
    assert_eq!(["6", "450deg", "4pi", "30rad"].map(said), [""; 4]);
}

/// Of the rows of a file those before a bad one stand on standard output, and nothing before the first good one.
#[test]
fn points_before_a_bad_row_stand_on_standard_output_only() {
    let inspect = |rows: &str, more: &[&str]| -> (Run, usize) {
        let folder = TempDir::new().unwrap();
        fs::write(folder.path().join("p.csv"), rows).unwrap();
        let arguments = [
            "inspect",
            "x^2 + y^2 = 1",
            "--tolerance",
            "1",
            "--points",
            "p.csv",
        ];
        let run = run_in(folder.path(), &[&arguments[..], more].concat(), "");
        assert_eq!(run.code, 2, "{}", run.err);
        (run, fs::read_dir(folder.path()).unwrap().count())
    };
    let (run, _) = inspect("x,y\nhello,0\n", &[]);
    assert_eq!(run.out, "");
    assert!(run.err.contains(
        "p.csv, row 2: \"hello\" is not a number; each row must be x,y; nothing is written"
    ));
    let (run, _) = inspect("x,y\n1,0\nhello,0\n2,0\n", &[]);
    assert!(run.out.starts_with("x,y,verdict,") && run.out.lines().count() == 2);
    assert!(run.err.contains("row 3") && run.err.contains("; the point before it is written"));
    let many = "1,0\n".repeat(200) + "1\n2,0\n";
    let (run, _) = inspect(&many, &[]);
    assert_eq!(run.out.lines().count(), 201);
    assert!(
        run.err.contains("row 201") && run.err.contains("; the 200 points before it are written")
    );
    let (run, files) = inspect(&many, &["-o", "v.csv"]);
    assert_eq!((run.out.as_str(), files), ("", 1));
    assert!(!run.err.contains("written"), "{}", run.err);
}

/// However many rows are skipped before it, the first point has no comma before it.
#[test]
fn skipped_rows_leave_no_gap_in_json() {
    let rows = "hello,0\n".repeat(100) + "1,0\n" + &"there,0\n".repeat(100) + "0,1\n";
    let arguments = [
        "inspect",
        "x^2 + y^2 = 1",
        "--tolerance",
        "1",
        "--points",
        "-",
    ];
    let more = ["--skip-bad", "--format", "json"];
    let run = run_in(
        TempDir::new().unwrap().path(),
        &[&arguments[..], &more].concat(),
        &rows,
    );
    assert_eq!(run.code, 0, "{}", run.err);
    let document = json(&run.out);
    assert_eq!(document["points"].as_array().unwrap().len(), 2);
    assert_eq!(document["summary"]["bad"], 200);
}

#[test]
fn the_help_is_coloured_where_it_is_asked_for() {
    let colored = |arguments: &[&str]| done(arguments).contains('\u{1b}');
    assert!(colored(&["--help", "--color", "always"]));
    assert!(colored(&["--color=Always", "describe", "--help"]));
    for plain in [
        &["--help"][..],
        &["--help", "--color", "never"],
        &["--color=auto", "--help"],
    ] {
        assert!(!colored(plain), "{plain:?}");
    }
    let run = run_in(
        TempDir::new().unwrap().path(),
        &["describe", "--color", "always"],
        "",
    );
    assert!(!run.err.contains('\u{1b}'), "{}", run.err);
}
